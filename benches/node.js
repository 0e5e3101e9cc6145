// Measures the jobs named on the command line in Node. `cargo xtask bench` calls it after a build.

import { load } from "../dist/gear-bifurcations.js";
import { measure } from "./bench.js";

console.log(measure(await load(), process.argv.slice(2)));
