/** What a figure's own file fetches when a figure is to be taken away: each of the three is joined with what it lives with. */

import { startExports } from "../exports/room.js";
import { figureFile } from "./save-figure.js";

export { figureFile, startExports };
