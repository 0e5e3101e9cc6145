/**
 * The workers: who computes what, and what happens when one of them dies.
 *
 * The first worker takes only what is quick, so that a slider answers at once whatever else is going on; the
 * others take the figures that are computed step by step.
 *
 * @typedef {import("./protocol.js").ToWorker} ToWorker
 * @typedef {import("./protocol.js").FromWorker} FromWorker
 * @typedef {import("./protocol.js").Drawn} Drawn
 * @typedef {import("./protocol.js").Figure} Figure
 * @typedef {import("./protocol.js").GearErrorFields} GearErrorFields
 * @typedef {import("./protocol.js").Given} Given
 */

import { faces, newWorker } from "./delivery.js";

/**
 * @typedef {object} Wanted
 * @property {string} id
 * @property {Given} given
 * @property {boolean} heavy
 * @property {number} priority
 * @property {import("./protocol.js").Wanted | null} [picture]  How it is to be drawn, where the worker is to draw it.
 * @property {boolean} [held]  Whether it stops at its first picture, until `goOn`.
 * @property {number} part  Which part of the figure, from 0; each has a worker of its own, as far as there are enough.
 * @property {number} parts  Of how many.
 */

/**
 * @typedef {object} Answers
 * @property {(figure: Figure, drawn: Drawn | null) => void} partial
 * @property {(figure: Figure, drawn: Drawn | null) => void} done
 * @property {(error: GearErrorFields) => void} failed
 * @property {() => void} restarted  The worker died; the computation begins anew in its successor.
 */

/** @typedef {{wanted: Wanted, answers: Answers, deaths: number, pictured: boolean}} Task  Deaths that it is to blame for. */
/**
 * @typedef {object} Seat
 * @property {Worker | null} worker  Null until the first computation comes, for a page with one figure needs no second one, and where workers
 *   were given up; the next computation tries once more.
 * @property {Map<number, Task>} tasks
 * @property {boolean} ready  The module runs in it.
 * @property {number} silent  Questions it has not answered.
 * @property {number} deaths  Workers that died here one after the other without ever being ready.
 * @property {number} current  The ticket of the computation that the worker turned to last; 0 for none.
 */

/** How often busy workers are asked for a sign of life, ms. */
const PULSE = 1000;
/** A busy worker that lets so many of these questions pass is dead. A step takes 15 ms. */
const PATIENCE = 8;
/** The same for one that is still starting: its script may come over a slow line. */
const PATIENCE_AT_START = 60;
/** A worker that dies so often before it was ever ready will not come up. */
const HOPELESS = 3;

/** A seat where nothing has been said yet. */
const NEW = { worker: null, ready: false, silent: 0, current: 0 };

/** @param {number} cores */
export function poolSize(cores) {
  return Math.min(4, Math.max(2, cores));
}

export class Pool {
  /** @type {Seat[]} */
  #seats;
  /** @type {Promise<WebAssembly.Module>} */
  #module;
  #draws;
  /** @type {ReturnType<typeof setInterval> | undefined} */
  #pulse;
  #tickets = 0;
  /** Until every figure has its first picture no computation goes beyond it, so that drawing has the processor. */
  #firstPictures = true;
  /** Answers that came for computations nobody waits for any more. */
  dropped = 0;
  /** Workers that were replaced. */
  replaced = 0;

  /**
   * @param {Promise<WebAssembly.Module>} module
   * @param {number} size
   * @param {boolean} draws  Whether workers will be asked for pictures.
   * @param {Worker | null} [first]  One that is up already and has its faces.
   */
  constructor(module, size, draws, first = null) {
    this.#module = module;
    this.#draws = draws;
    this.#seats = Array.from({ length: size }, () => ({ ...NEW, tasks: new Map(), deaths: 0 }));
    // What is asked first is quick, as a rule: this worker starts while the module is fetched.
    this.#open(this.#seats[0], first);
  }

  get size() {
    return this.#seats.length;
  }

  /** Whether anything is computed. */
  get busy() {
    return this.#seats.some(isBusy);
  }

  /**
   * @param {Wanted} wanted
   * @param {Answers} answers
   * @returns {number} the ticket
   */
  run(wanted, answers) {
    const ticket = ++this.#tickets;
    const seat = this.#seatFor(wanted);
    if (seat.worker === null) this.#open(seat);
    seat.tasks.set(ticket, { wanted, answers, deaths: 0, pictured: false });
    this.#ask(seat, ticket, wanted);
    this.#watch();
    return ticket;
  }

  /**
   * What was held goes on to its end.
   *
   * @param {number} ticket
   */
  goOn(ticket) {
    const seat = this.#seats.find(({ tasks }) => tasks.has(ticket));
    const task = seat?.tasks.get(ticket);
    if (seat === undefined || task?.wanted.held !== true) return;
    task.wanted = { ...task.wanted, held: false };
    this.#say(seat, { type: "go-on", ticket });
    this.#watch();
  }

  /** @param {number} ticket */
  cancel(ticket) {
    const seat = this.#seats.find(({ tasks }) => tasks.has(ticket));
    if (seat === undefined) return;
    seat.tasks.delete(ticket);
    this.#say(seat, { type: "cancel", ticket });
  }

  /**
   * For tests: makes workers die, by an error that they throw or without a word, as when the system ends them.
   *
   * @param {"error" | "silence"} manner
   */
  kill(manner) {
    for (const seat of this.#seats) {
      if (manner === "error") this.#say(seat, { type: "fail" });
      else seat.worker?.terminate();
    }
  }

  /** Every figure has its first picture: from now on computations run to their ends. */
  complete() {
    this.#firstPictures = false;
    for (const seat of this.#seats) this.#say(seat, { type: "pace", firstPictures: false });
  }

  /** Has workers give their memory back once they have nothing to do. */
  rest() {
    for (const seat of this.#seats) this.#say(seat, { type: "rest" });
  }

  /** @param {Wanted} wanted */
  #seatFor({ heavy, part, parts }) {
    if (parts > 1) return this.#seats[part % this.#seats.length];
    const [quick, ...others] = this.#seats;
    if (!heavy || others.length === 0) return quick;
    const least = others.reduce((best, seat) => (seat.tasks.size < best.tasks.size ? seat : best));
    // Where workers draw there is one figure, as a rule: to start another worker for it takes as long as to compute it.
    return this.#draws && least.worker === null && quick.tasks.size === 0 ? quick : least;
  }

  /**
   * @param {Seat} seat
   * @param {Worker | null} [up]
   */
  #open(seat, up = null) {
    const worker = up ?? newWorker();
    Object.assign(seat, { ...NEW, worker });
    worker.onmessage = ({ data }) => {
      if (seat.worker === worker) this.#hear(seat, data);
    };
    worker.onerror = (event) => {
      // Reported in the figure; the console stays clean.
      event.preventDefault();
      if (seat.worker === worker) this.#replace(seat);
    };
    worker.onmessageerror = () => {
      if (seat.worker === worker) this.#replace(seat);
    };
    // They come while the module is still compiled.
    if (this.#draws && up === null) worker.postMessage({ type: "faces", faces: faces() });
    this.#module.then(
      (module) => {
        if (seat.worker !== worker) return;
        worker.postMessage({ type: "pace", firstPictures: this.#firstPictures });
        worker.postMessage({ type: "start", module });
      },
      () => {}, // Whoever asked for the engine is told by its own promise.
    );
  }

  /**
   * @param {Seat} seat
   * @param {ToWorker} message
   */
  #say(seat, message) {
    seat.worker?.postMessage(message);
  }

  /**
   * @param {Seat} seat
   * @param {number} ticket
   * @param {Wanted} wanted
   */
  #ask(seat, ticket, { id, given, priority, part, parts, picture = null, held = false }) {
    this.#say(seat, { type: "run", ticket, id, given, priority, part, parts, picture, held });
  }

  /**
   * @param {Seat} seat
   * @param {FromWorker} message
   */
  #hear(seat, message) {
    seat.silent = 0;
    if (message.type === "ready") {
      seat.ready = true;
      seat.deaths = 0;
    }
    if (message.type === "ready" || message.type === "fetched" || message.type === "pong") return;
    if (message.type === "step") {
      seat.current = message.ticket;
      return;
    }
    const task = seat.tasks.get(message.ticket);
    if (task === undefined) {
      this.dropped += 1;
      return;
    }
    if (message.type === "partial") {
      task.pictured = true;
      task.answers.partial(message.figure, message.drawn);
      return;
    }
    seat.tasks.delete(message.ticket);
    if (message.type === "done") task.answers.done(message.figure, message.drawn);
    else task.answers.failed(message.error);
  }

  #watch() {
    this.#pulse ??= setInterval(() => this.#check(), PULSE);
  }

  /** Asks busy workers for a sign of life; counts questions, not seconds, because a sleeping page asks rarely. */
  #check() {
    let busy = false;
    for (const seat of this.#seats) {
      if (!isBusy(seat)) continue;
      busy = true;
      seat.silent += 1;
      if (seat.silent > (seat.ready ? PATIENCE : PATIENCE_AT_START)) this.#replace(seat);
      else if (seat.ready) this.#say(seat, { type: "ping" });
    }
    if (!busy) {
      clearInterval(this.#pulse);
      this.#pulse = undefined;
    }
  }

  /** @param {Seat} seat */
  #replace(seat) {
    seat.worker?.terminate();
    seat.deaths += 1;
    this.replaced += 1;
    const hopeless = seat.deaths >= HOPELESS;
    // Whatever it was at is to blame; if that is not known, everything it had.
    const blamed = seat.tasks.has(seat.current) ? seat.current : 0;
    for (const [ticket, task] of [...seat.tasks]) {
      if (blamed === 0 || ticket === blamed) task.deaths += 1;
      // What killed two workers will kill a third.
      if (!hopeless && task.deaths < 2) continue;
      seat.tasks.delete(ticket);
      task.answers.failed(seat.ready ? deathNotice() : barredNotice());
    }
    if (hopeless) {
      seat.worker = null;
      return;
    }
    this.#open(seat);
    for (const [ticket, task] of seat.tasks) {
      task.pictured = false;
      this.#ask(seat, ticket, task.wanted);
      task.answers.restarted();
    }
  }
}

/** What is held at its first picture is no work. @param {Seat} seat */
function isBusy({ tasks }) {
  return [...tasks.values()].some(({ wanted, pictured }) => !(wanted.held && pictured));
}

/** @returns {GearErrorFields} */
function deathNotice() {
  const message = "The worker that computes this figure died twice; change a value to try again.";
  return { code: "internal", parameter: null, given: null, allowed: null, message };
}

/** @returns {GearErrorFields} */
function barredNotice() {
  const message = "No worker comes up here, as where a policy of the page forbids them, so the figure stands still.";
  return { code: "load", parameter: null, given: null, allowed: null, message };
}
