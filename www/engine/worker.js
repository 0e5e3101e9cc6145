/**
 * The worker: computes figures, a step of about 15 ms at a time, and looks at its messages in between.
 *
 * @typedef {import("./protocol.js").ToWorker} ToWorker
 * @typedef {import("./protocol.js").FromWorker} FromWorker
 * @typedef {import("./protocol.js").Run} Run
 * @typedef {import("../../gear-bifurcations.js").Gear} Gear
 * @typedef {import("../../gear-bifurcations.js").FigureProgress} FigureProgress
 * @typedef {{run: Run, steps: FigureProgress | null, taken: number, posted: number}} Job
 */

import { GearError, load } from "../../gear-bifurcations.js";
import { buffersOf, giveBack } from "./protocol.js";

/** Least time between two partial pictures of one figure, ms: more often nobody sees. */
const PARTIAL_INTERVAL = 50;
/** A computation that has taken so many steps lets those go first that have not: they have their answers soon. */
const TURN = 4;

/** @type {Map<number, Job>} */
const jobs = new Map();
/** @type {Promise<Gear> | null} */
let loading = null;
let working = false;
/** The computation that the page was told of last. */
let told = 0;
/** The page is opening: a first picture of everything counts more than any picture completed. */
let firstPictures = false;

const breath = new MessageChannel();
/** @type {(() => void) | null} */
let breathed = null;
breath.port1.onmessage = () => breathed?.();

/** Lets messages that have arrived be handled before the next step. */
function breathe() {
  return new Promise((/** @type {(value?: void) => void} */ resolve) => {
    breathed = resolve;
    breath.port2.postMessage(null);
  });
}

/**
 * @param {FromWorker} message
 * @param {Transferable[]} [transfer]
 */
function post(message, transfer = []) {
  self.postMessage(message, { transfer });
}

/**
 * What comes next: what is shown before what is not, what has no picture yet before what has, what has had few steps
 * before what has had many, then by age.
 */
function next() {
  /** @type {Job | null} */
  let best = null;
  for (const job of jobs.values()) {
    if (firstPictures && job.steps !== null) continue;
    if (best === null || comesBefore(job, best)) best = job;
  }
  return best;
}

/**
 * @param {Job} one
 * @param {Job} other
 */
function comesBefore(one, other) {
  if (one.run.priority !== other.run.priority) return one.run.priority < other.run.priority;
  const started = Number(one.steps !== null) - Number(other.steps !== null);
  if (started !== 0) return started < 0;
  const turns = Math.floor(one.taken / TURN) - Math.floor(other.taken / TURN);
  return turns === 0 ? one.run.ticket < other.run.ticket : turns < 0;
}

/**
 * One step of one computation.
 *
 * @param {Gear} gear
 * @param {Job} job
 */
function step(gear, job) {
  const { ticket, id, given, part, parts } = job.run;
  if (told !== ticket) {
    told = ticket;
    post({ type: "step", ticket });
  }
  try {
    job.steps ??= gear.progress(id, given, { part, parts });
    job.taken += 1;
    const { value } = job.steps.next();
    if (value === undefined || value.done) {
      finish(job, value === undefined ? gear.figure(id, given) : value.figure);
    } else if (performance.now() - job.posted >= PARTIAL_INTERVAL) {
      job.posted = performance.now();
      post({ type: "partial", ticket, figure: value.figure }, buffersOf(value.figure));
    }
  } catch (thrown) {
    jobs.delete(ticket);
    post({ type: "failed", ticket, error: fieldsOf(thrown) });
  }
}

/**
 * @param {Job} job
 * @param {import("./protocol.js").Figure} figure
 */
function finish(job, figure) {
  jobs.delete(job.run.ticket);
  post({ type: "done", ticket: job.run.ticket, figure }, buffersOf(figure));
}

/**
 * @param {unknown} thrown
 * @returns {import("./protocol.js").GearErrorFields}
 */
function fieldsOf(thrown) {
  if (thrown instanceof GearError) return thrown.toJSON();
  const message = thrown instanceof Error ? thrown.message : String(thrown);
  return { code: "internal", parameter: null, given: null, allowed: null, message };
}

async function work() {
  if (working || loading === null) return;
  working = true;
  try {
    const gear = await loading;
    for (let job = next(); job !== null; job = next()) {
      step(gear, job);
      await breathe();
    }
  } catch (thrown) {
    // The module itself could not be started: every computation has the same answer.
    for (const ticket of jobs.keys()) post({ type: "failed", ticket, error: fieldsOf(thrown) });
    jobs.clear();
  } finally {
    working = false;
  }
}

/** @param {number} ticket */
function cancel(ticket) {
  jobs.get(ticket)?.steps?.return();
  jobs.delete(ticket);
}

self.addEventListener("message", (/** @type {MessageEvent<ToWorker>} */ { data }) => {
  switch (data.type) {
    case "start":
      // The document may have been before the page: see ahead.js.
      loading ??= load(data.module);
      loading.then(
        () => post({ type: "ready" }),
        () => {},
      );
      void work();
      break;
    case "run":
      jobs.set(data.ticket, { run: data, steps: null, taken: 0, posted: -Infinity });
      void work();
      break;
    case "cancel":
      cancel(data.ticket);
      break;
    case "pace":
      firstPictures = data.firstPictures;
      void work();
      break;
    case "ping":
      post({ type: "pong" });
      break;
    case "rest":
      if (jobs.size === 0) void loading?.then(giveBack, () => {});
      break;
    case "fail":
      throw new Error("the worker was asked to fail");
  }
});
