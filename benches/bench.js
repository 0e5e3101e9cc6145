// The jobs of benches/speed.rs in wasm: the same number of samples, the same rule for their length, the median.
// Knows neither Node nor a page: benches/node.js and benches/browser.js bring it to both.

const SAMPLES = 15;
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
 * @param {Bench} bench
 * @param {string} job
 */
function medianMicroseconds(bench, job) {
  // Finding how often fills a sample also warms the engine up.
  let repetitions = 1;
  while (time(bench, job, repetitions) < LEAST_MILLISECONDS) repetitions *= 2;
  const samples = Array.from({ length: SAMPLES }, () => (time(bench, job, repetitions) * 1000) / repetitions);
  return samples.sort((a, b) => a - b)[(SAMPLES - 1) / 2];
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
