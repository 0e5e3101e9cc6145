// Measures the jobs named on the command line in Node; after "--first", the first call of one job in a fresh process.
// `cargo xtask bench` calls it after a build.

import { load } from "../dist/gear-bifurcations.js";
import { firstCall, measure } from "./bench.js";

const jobs = process.argv.slice(2);
const gear = await load();
if (jobs[0] === "--first") console.log(`${jobs[1]}\t${firstCall(gear, jobs[1]).toFixed(0)}`);
else console.log(measure(gear, jobs));
