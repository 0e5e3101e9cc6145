/**
 * What the figures are given by the page: the one place where they learn of engine and state.
 *
 * @typedef {import("../engine/gear-bifurcations.js").Figure} Figure
 * @typedef {import("../engine/gear-bifurcations.js").FigureInfo} FigureInfo
 * @typedef {import("../engine/gear-bifurcations.js").ParameterInfo} ParameterInfo
 * @typedef {import("../engine/gear-bifurcations.js").FrameMap} FrameMap
 * @typedef {import("../engine/gear-bifurcations.js").DrawOptions} DrawOptions
 * @typedef {import("../engine/gear-bifurcations.js").GearErrorFields} GearErrorFields
 * @typedef {import("../engine/gear-bifurcations.js").SeriesLook} SeriesLook
 * @typedef {import("../state.js").Given} Given
 * @typedef {import("../state.js").Window} Window
 * @typedef {import("../state.js").FigureState} FigureState
 * @typedef {import("../state.js").State} State
 */

/**
 * @typedef {object} ComputeOptions
 * @property {AbortSignal} signal
 * @property {number} priority
 * @property {(figure: Figure) => void} partial
 * @property {() => void} restarted
 * @property {(Required<Pick<DrawOptions, "theme" | "density" | "view">> & {width: number, height: number}) | null} picture  How it will be drawn
 *   first, on a backing store of so many pixels: then it may come drawn; null where that is not known.
 * @property {Promise<void> | null} held  Until this is over it stops at its first picture.
 */

/**
 * What computes and draws.
 *
 * @typedef {object} Engine
 * @property {ReadonlyMap<string, FigureInfo>} figures
 * @property {ReadonlyMap<string, ParameterInfo>} vocabulary
 * @property {(id: string, given: Given, options: ComputeOptions) => Promise<Figure>} compute
 * @property {(id: string) => boolean} glances  Whether a glance at this figure is worth a try; asked once for each.
 * @property {(id: string, given: Given) => {figure: Figure, done: boolean} | null} glance  What comes of it here in a moment; null for nothing.
 * @property {(id: string, given: Given, time: number) => {figure: Figure, done: boolean} | null} within  What can be computed here in so many ms.
 * @property {boolean} draws  Whether figures can come with their first picture.
 * @property {(figure: Figure, canvas: HTMLCanvasElement, options: DrawOptions) => {frames: FrameMap[], looks: SeriesLook[]}} draw
 */

/**
 * The part of the page's state that a figure reads and writes.
 *
 * @typedef {object} Store
 * @property {State} state
 * @property {(key: string, state?: State) => Given} given  Parameters that differ from the figure's own, at present or in a state.
 * @property {(key: string, given: Given) => void} give  An action of the reader.
 * @property {(key: string, given: Given) => void} start  What counts where nothing was given.
 * @property {(key: string) => void} forget
 * @property {(key: string, state?: State) => Readonly<FigureState>} shown  All that the reader has changed about the figure.
 * @property {(key: string, change: Partial<FigureState>, action: string, merge?: string) => void} show  An action of the reader.
 * @property {(key: string, start: Given) => void} reset
 * @property {() => void} hold  What is done until `release` is one action.
 * @property {() => void} release
 * @property {(subscriber: (state: State, before: State) => void) => () => void} subscribe
 */

/**
 * @typedef {object} Portrait  A complete figure, and how it is seen.
 * @property {string} key  Its name in the page's state.
 * @property {Figure} figure  As it was computed.
 * @property {Figure} shown  In the language of the page.
 * @property {Given} given  Parameters that were given, by name.
 * @property {Readonly<FigureState>} state
 * @property {import("../engine/gear-bifurcations.js").ViewOptions} view
 * @property {import("../engine/gear-bifurcations.js").ThemeName} theme
 * @property {number} width  Of its picture, CSS pixels.
 * @property {number} height
 */

/**
 * @typedef {object} Services
 * @property {Engine} engine
 * @property {Store} store
 * @property {{shown: number, hidden: number}} priority
 * @property {(fields: GearErrorFields) => Error & GearErrorFields} error  Makes the error that `data()` rejects with.
 * @property {(piece: () => Promise<unknown>) => () => void} [leisure]  Does what nobody waits for when nobody does anything; what it returns calls that off.
 * @property {(work: () => void) => void} later  Does what can wait until figures are drawn.
 * @property {(figure: import("./gear-figure.js").GearFigure, button: HTMLElement) => void} [exports]  Opens the menu by which a figure is taken away.
 * @property {(element: HTMLElement) => void} painted  Called when a figure's first live drawing is on its canvas.
 */

/** @type {(services: Services | PromiseLike<Services>) => void} */
let provide = () => {};

/** @type {Promise<Services>} */
export const services = new Promise((resolve) => {
  provide = resolve;
});

export { provide };
