// The jobs of benches/speed.rs in wasm: the same number of samples, the same rule for their length, the median.
// Knows neither Node nor a page: benches/node.js and benches/browser.js bring it to both.

const SAMPLES = 15;
const FEW_SAMPLES = 3;
const LONG_MILLISECONDS = 300;
const LEAST_MILLISECONDS = 20;

/** @typedef {(job: string, repetitions: number) => number} Bench does a job, answers a number that depends on all of it */

/**
 * @param {object} gear the loaded module; its hidden `bench` is no part of the contract
 * @param {readonly string[]} jobs
 * @returns {string} a line for each job: its name, a tab, microseconds
 */
export function measure(gear, jobs) {
  const { bench } = /** @type {{bench: Bench}} */ (gear);
  return jobs.map((job) => `${job}\t${medianMicroseconds(bench, job).toFixed(4)}`).join("\n");
}

/**
 * How long the very first call takes in an instance where nothing has run yet, microseconds.
 *
 * @param {object} gear
 * @param {string} job
 */
export function firstCall(gear, job) {
  const { bench } = /** @type {{bench: Bench}} */ (gear);
  return time(bench, job, 1) * 1000;
}

/**
 * @param {Bench} bench
 * @param {string} job
 */
function medianMicroseconds(bench, job) {
  // Finding how often fills a sample also warms the engine up.
  let repetitions = 1;
  let once = time(bench, job, repetitions);
  while (once < LEAST_MILLISECONDS) {
    repetitions *= 2;
    once = time(bench, job, repetitions);
  }
  const count = once > LONG_MILLISECONDS ? FEW_SAMPLES : SAMPLES;
  const samples = Array.from({ length: count }, () => (time(bench, job, repetitions) * 1000) / repetitions);
  return samples.sort((a, b) => a - b)[(count - 1) / 2];
}

/**
 * @param {Bench} bench
 * @param {string} job
 * @param {number} repetitions
 */
function time(bench, job, repetitions) {
  const start = performance.now();
  const answer = bench(job, repetitions);
  const took = performance.now() - start;
  if (!Number.isFinite(answer)) throw new Error(`${job} answers ${answer}`);
  return took;
}
