/**
 * The page's engine, started as early as can be: the document loads this script before and beside the page's own, so
 * that workers and module are on their way while the rest still arrives.
 */

import { GearError, PRIORITY, startEngine } from "./client.js";

export { GearError, PRIORITY };

/** What the page opens with, for its figures may still be on their way; an address may say otherwise. */
const { firstFigure = null } = document.documentElement.dataset;

export const engine = startEngine({ first: location.hash === "" ? firstFigure : null });
// Each figure says itself what failed.
engine.catch(() => {});
