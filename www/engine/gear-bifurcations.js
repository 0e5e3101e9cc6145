import { createBindings } from "./bindings.js";

/**
 * The module's hand-written side: it loads the WebAssembly, turns whatever goes wrong into a `GearError`, and
 * puts a fresh instance in the place of one that trapped. The build puts the binding generator's output in the
 * place of the first line. The contract stands in `gear-bifurcations.d.ts` and `docs/api.md`.
 *
 * @typedef {import("./gear-bifurcations.js").Gear} Gear
 * @typedef {import("./gear-bifurcations.js").GearErrorFields} GearErrorFields
 * @typedef {import("./gear-bifurcations.js").LoadSource} LoadSource
 * @typedef {import("./gear-bifurcations.js").FigureProgress} FigureProgress
 * @typedef {import("./gear-bifurcations.js").ProgressStep} ProgressStep
 * @typedef {import("./bindings.js").Bindings} Bindings
 * @typedef {import("./bindings.js").RawProgress} RawProgress
 */

const WASM_FILE = "gear-bifurcations_bg.wasm";

/** The calls that take parameters and options and are handed on as they are. */
const STUDIES = /** @type {const} */ ([
  "tongueEdges",
  "tongueBoundary",
  "stabilityChart",
  "branch",
  "diagram",
  "torus",
  "sweep",
  "lyapunov",
  "basin",
  "contactMargin",
  "leastLoad",
  "spectrum",
]);

/** The one error that every call throws. */
export class GearError extends Error {
  /** @param {GearErrorFields} fields */
  constructor({ code, parameter, given, allowed, message }) {
    super(message);
    this.name = "GearError";
    this.code = code;
    this.parameter = parameter;
    this.given = given;
    this.allowed = allowed;
  }

  /** The fields as a plain object: an Error loses them when it is posted or written as JSON. */
  toJSON() {
    const { code, parameter, allowed, message } = this;
    // JSON has no NaN and no Infinity, and would say null.
    const given = typeof this.given === "number" && !Number.isFinite(this.given) ? String(this.given) : this.given;
    return { code, parameter, given, allowed, message };
  }
}

/**
 * @param {import("./gear-bifurcations.js").GearErrorCode} code
 * @param {string} message
 * @returns {GearError}
 */
function ownError(code, message) {
  return new GearError({ code, parameter: null, given: null, allowed: null, message });
}

/** @param {unknown} thrown */
function words(thrown) {
  try {
    return thrown instanceof Error ? thrown.message : String(thrown);
  } catch {
    return "something without words";
  }
}

/**
 * Loads the module: from beside this file, or from bytes, a response or a compiled module.
 *
 * @param {LoadSource | PromiseLike<LoadSource>} [source]
 * @returns {Promise<Gear>}
 */
export async function load(source) {
  let module;
  try {
    module = await compile(await source);
  } catch (thrown) {
    throw ownError("load", `the module could not be loaded: ${words(thrown)}`);
  }
  // It is started with the first call; by then it is too late to say that it is another.
  if (!WebAssembly.Module.exports(module).some(({ name }) => name === "figures")) {
    throw ownError("load", "the module could not be started: it is not that of gear-bifurcations");
  }
  return createGear(module);
}

/**
 * @param {LoadSource | undefined} source
 * @returns {Promise<WebAssembly.Module>}
 */
async function compile(source) {
  if (source === undefined) {
    const beside = new URL(`./${WASM_FILE}`, import.meta.url);
    return isNode() && beside.protocol === "file:" ? compileFile(beside) : compileResponse(await fetch(beside));
  }
  // By tag and not by instanceof: the value may come from another frame.
  const tag = Object.prototype.toString.call(source);
  if (tag === "[object WebAssembly.Module]") return /** @type {WebAssembly.Module} */ (source);
  if (tag === "[object Response]") return compileResponse(/** @type {Response} */ (source));
  if (tag === "[object ArrayBuffer]") return WebAssembly.compile(/** @type {ArrayBuffer} */ (source));
  if (ArrayBuffer.isView(source)) {
    // Not every engine takes a DataView.
    const { buffer, byteOffset, byteLength } = source;
    return WebAssembly.compile(new Uint8Array(/** @type {ArrayBuffer} */ (buffer), byteOffset, byteLength));
  }
  throw new TypeError("load takes nothing, bytes, a Response or a WebAssembly.Module");
}

function isNode() {
  return typeof process === "object" && typeof process.versions?.node === "string";
}

/** @param {URL} file */
async function compileFile(file) {
  // A name in a variable: bundlers for the browser must not follow it.
  const name = "node:fs/promises";
  const { readFile } = await import(/* @vite-ignore */ name);
  return WebAssembly.compile(await readFile(file));
}

/** @param {Response} response */
async function compileResponse(response) {
  if (!response.ok) throw new Error(`${response.url || WASM_FILE}: status ${response.status}`);
  const type = response.headers.get("Content-Type") ?? "";
  // Streaming insists on the MIME type, which not every server knows.
  if (type.startsWith("application/wasm")) return WebAssembly.compileStreaming(response);
  return WebAssembly.compile(await response.arrayBuffer());
}

/**
 * Whether this is what `src/web/errors.rs` throws: everything else is a trap or a broken promise of the glue.
 *
 * @param {unknown} thrown
 * @returns {thrown is GearErrorFields}
 */
function isGearErrorFields(thrown) {
  return (
    typeof thrown === "object" &&
    thrown !== null &&
    !(thrown instanceof Error) &&
    "code" in thrown &&
    "message" in thrown
  );
}

/**
 * @param {WebAssembly.Module} module
 * @returns {Gear}
 */
function createGear(module) {
  /** Null before the first call, and while the module rests. @type {Bindings | null} */
  let bindings = null;
  let bytes = () => 0;
  /** Computations that are under way in the instance. */
  let running = 0;

  /** @returns {Bindings} */
  function instantiate() {
    try {
      const fresh = createBindings();
      const { memory } = fresh.initSync({ module });
      bytes = () => memory.buffer.byteLength;
      running = 0;
      return fresh;
    } catch (thrown) {
      throw ownError("load", `the module could not be started: ${words(thrown)}`);
    }
  }

  /**
   * Runs one call; after a trap the instance's memory is not to be trusted, so the next call gets a fresh one.
   *
   * @param {(raw: Bindings) => unknown} run
   * @returns {any}
   */
  function call(run) {
    const used = (bindings ??= instantiate());
    try {
      return run(used);
    } catch (thrown) {
      if (isGearErrorFields(thrown)) throw new GearError(thrown);
      if (bindings === used) bindings = instantiate();
      throw ownError("internal", `an error inside the module, which was started anew: ${words(thrown)}`);
    }
  }

  /**
   * @param {unknown} id
   * @param {unknown} p
   * @param {unknown} options
   * @returns {FigureProgress}
   */
  function progress(id, p, options) {
    /** @type {RawProgress | null} */
    let job = call((raw) => raw.progress(id, p, options));
    const divided = call(() => job?.divided() ?? false);
    const home = bindings;
    running += 1;

    function stop() {
      const ended = job;
      job = null;
      // Memory of an instance that trapped is gone with it.
      if (!ended || home !== bindings) return;
      running -= 1;
      call(() => ended.free());
    }

    /** @type {FigureProgress} */
    const steps = {
      divided,
      next() {
        const current = job;
        if (!current) return { value: undefined, done: true };
        if (home !== bindings) {
          job = null;
          throw ownError("internal", "the computation was lost when the module was started anew");
        }
        let completed = false;
        try {
          /** @type {ProgressStep} */
          const value = call(() => {
            completed = current.advance();
            return { figure: current.figure(), done: completed };
          });
          if (completed) stop();
          return { value, done: false };
        } catch (thrown) {
          stop();
          throw thrown;
        }
      },
      return() {
        stop();
        return { value: undefined, done: true };
      },
      [Symbol.iterator]: () => steps,
    };
    return steps;
  }

  const gear = {
    module,
    defaults: () => call((raw) => raw.defaults()),
    fromPhysical: (/** @type {unknown} */ si) => call((raw) => raw.fromPhysical(si)),
    toPhysical: (/** @type {unknown} */ p, /** @type {unknown} */ scales) =>
      call((raw) => raw.toPhysical(p, scales)),
    modes: (/** @type {unknown} */ p, /** @type {unknown} */ options = undefined) => call((raw) => raw.modes(p, options)),
    tongues: (/** @type {unknown} */ p, /** @type {unknown} */ options = undefined) =>
      call((raw) => raw.tongues(p, options)),
    multipliers: (/** @type {unknown} */ p, /** @type {unknown} */ options) =>
      call((raw) => raw.multipliers(p, options)),
    timeResponse: (/** @type {unknown} */ p, /** @type {unknown} */ options) =>
      call((raw) => raw.timeResponse(p, options)),
    poincare: (/** @type {unknown} */ p, /** @type {unknown} */ options) =>
      call((raw) => raw.poincare(p, options)),
    periodicOrbit: (/** @type {unknown} */ p, /** @type {unknown} */ options) =>
      call((raw) => raw.periodicOrbit(p, options)),
    ...Object.fromEntries(
      STUDIES.map((name) => [
        name,
        (/** @type {unknown} */ p, /** @type {unknown} */ options) => call((raw) => raw[name](p, options)),
      ]),
    ),
    figures: () => call((raw) => raw.figures()),
    figure: (/** @type {unknown} */ id, /** @type {unknown} */ p) => call((raw) => raw.figure(id, p)),
    progress,
    svg: (/** @type {unknown} */ idOrFigure, /** @type {unknown} */ p, /** @type {unknown} */ options) =>
      call((raw) => raw.svg(idOrFigure, p, options)),
    draw: (
      /** @type {unknown} */ idOrFigure,
      /** @type {unknown} */ p,
      /** @type {unknown} */ canvas,
      /** @type {unknown} */ options,
    ) => call((raw) => raw.draw(idOrFigure, p, canvas, options)),
  };
  // For measurements, and for pages that nobody looks at; no part of the contract.
  Object.defineProperties(gear, {
    bench: {
      value: (/** @type {unknown} */ job, /** @type {unknown} */ repetitions) =>
        call((raw) => raw.bench(job, repetitions)),
    },
    /**
     * Gives the memory back, which never shrinks by itself; the next call starts the module anew. Nothing happens while a
     * computation is under way. Returns the bytes that were given back.
     */
    rest: {
      value: () => {
        if (bindings === null || running > 0) return 0;
        const given = bytes();
        // Nothing may hold it any more.
        bindings = null;
        bytes = () => 0;
        return given;
      },
    },
  });
  return /** @type {Gear} */ (/** @type {unknown} */ (Object.freeze(gear)));
}
