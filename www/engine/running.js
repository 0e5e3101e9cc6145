/**
 * The page's engine, started as early as can be: the document loads this script before and beside the page's own, so
 * that workers and module are on their way while the rest still arrives.
 */

import { GearError, PRIORITY, startEngine } from "./client.js";

export { GearError, PRIORITY };

export const engine = startEngine();
// Each figure says itself what failed.
engine.catch(() => {});
