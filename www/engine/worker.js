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
import { drawn, loadFaces } from "./drawing.js";
import { buffersOf, giveBack } from "./protocol.js";

/** Least time between two partial pictures of one figure, ms: more often nobody sees. */
const PARTIAL_INTERVAL = 50;
/** So long may a computation take to be complete before what there is of it is shown, ms: half a step. */
const MOMENT = 8;
/** The same for what is drawn here too, ms: two drawings, and for the page two pictures to show, would take longer than that. */
const LONG_MOMENT = 100;
/** So long a first picture waits for the faces of the drawings, ms. */
const LATE = 150;
/** A computation that has taken so many steps lets those go first that have not: they have their answers soon. */
const TURN = 4;

/** @type {Map<number, Job>} */
const jobs = new Map();
/** @type {Promise<Gear> | null} */
let loading = null;
/** Over when the drawings' faces are there, or will not come. */
let lettering = Promise.resolve();
let working = false;
/** The computation that the page was told of last. */
let told = 0;
/** Nobody looks at the page: when nothing is left to compute, memory is given back. */
let resting = false;
/** The page is opening: a first picture of everything counts more than any picture completed. */
let firstPictures = false;

const breath = new MessageChannel();
/** @type {(() => void) | null} */
let breathed = null;
breath.port1.onmessage = () => breathed?.();

/** For faces that are late, the page draws in the worker's stead. */
function patience() {
  return new Promise((/** @type {(value?: void) => void} */ resolve) => setTimeout(resolve, LATE));
}

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
    if ((firstPictures || job.run.held) && isPictured(job)) continue;
    if (best === null || comesBefore(job, best)) best = job;
  }
  return best;
}

/** @param {Job} job */
function isPictured({ posted }) {
  return posted !== -Infinity;
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
  const { ticket, id, given, part, parts, picture } = job.run;
  if (told !== ticket) {
    told = ticket;
    post({ type: "step", ticket });
  }
  try {
    const begin = performance.now();
    const first = job.steps === null;
    job.steps ??= gear.progress(id, given, { part, parts });
    job.taken += 1;
    let { value } = job.steps.next();
    // What is complete in a moment is drawn once, and not first in part.
    while (first && value?.done === false && performance.now() - begin < (picture === null ? MOMENT : LONG_MOMENT)) ({ value } = job.steps.next());
    if (value === undefined || value.done) {
      jobs.delete(ticket);
      show(gear, job, "done", value === undefined ? gear.figure(id, given) : value.figure);
    } else if (performance.now() - job.posted >= PARTIAL_INTERVAL) {
      show(gear, job, "partial", value.figure);
      job.posted = performance.now();
    }
  } catch (thrown) {
    jobs.delete(ticket);
    post({ type: "failed", ticket, error: fieldsOf(thrown) });
  }
}

/**
 * @param {Gear} gear
 * @param {Job} job
 * @param {"partial" | "done"} type
 * @param {import("./protocol.js").Figure} figure
 */
function show(gear, job, type, figure) {
  const { ticket, picture } = job.run;
  // What changes from one step to the next the page draws as often as it likes.
  const first = !isPictured(job);
  const made = picture !== null && (first || type === "done") ? drawn(gear, figure, picture) : null;
  post({ type, ticket, figure, drawn: made }, made === null ? buffersOf(figure) : [...buffersOf(figure), made.bitmap]);
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
      if (job.steps === null && job.run.picture !== null) await Promise.race([lettering, patience()]);
      // It may have been cancelled meanwhile.
      if (jobs.has(job.run.ticket)) step(gear, job);
      await breathe();
    }
    if (resting) {
      for (const job of jobs.values()) leaveOff(job);
      giveBack(gear);
    }
  } catch (thrown) {
    // The module itself could not be started: every computation has the same answer.
    for (const ticket of jobs.keys()) post({ type: "failed", ticket, error: fieldsOf(thrown) });
    jobs.clear();
  } finally {
    working = false;
  }
}

/** Gives back what it holds of the module's memory; if it goes on it begins anew. @param {Job} job */
function leaveOff(job) {
  job.steps?.return();
  job.steps = null;
}

/** @param {number} ticket */
function cancel(ticket) {
  const job = jobs.get(ticket);
  if (job !== undefined) leaveOff(job);
  jobs.delete(ticket);
}

/** @param {number} ticket */
function goOn(ticket) {
  const job = jobs.get(ticket);
  if (job === undefined) return;
  resting = false;
  job.run.held = false;
  void work();
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
    case "fetch":
      loading ??= load();
      loading
        .then((gear) => post({ type: "fetched", fetched: { module: gear.module, figures: gear.figures(), defaults: gear.defaults() } }))
        .catch(() => {
          loading = null;
          post({ type: "fetched", fetched: null });
        });
      break;
    case "faces":
      lettering = loadFaces(data.faces);
      break;
    case "run":
      resting = false;
      jobs.set(data.ticket, { run: data, steps: null, taken: 0, posted: -Infinity });
      void work();
      break;
    case "go-on":
      goOn(data.ticket);
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
      resting = true;
      void work();
      break;
    case "fail":
      throw new Error("the worker was asked to fail");
  }
});
