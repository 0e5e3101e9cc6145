/**
 * The page's engine, started as early as can be: this script needs four files, the page thirty, so that workers and
 * module are on their way while the rest still arrives.
 */

import { startEngine } from "./client.js";

export const engine = startEngine();
// Each figure says itself what failed.
engine.catch(() => {});
