/**
 * What stands inside a figure's element, and how it looks. Colours come from the page's custom properties.
 *
 * @typedef {object} Parts
 * @property {HTMLElement} stage  Canvas and static drawing, in the very same place.
 * @property {HTMLCanvasElement} canvas
 * @property {HTMLElement} layer  Over the picture: crosshair and cursors.
 * @property {HTMLElement} band  Over the picture: the rectangle that is being drawn.
 * @property {HTMLElement} printed  For paper alone.
 * @property {HTMLElement} described  For the ear: the sentence that says what the picture shows.
 * @property {HTMLElement} keys  For the ear: what keys do.
 * @property {HTMLElement} legend
 * @property {HTMLElement} readout
 * @property {HTMLElement} buttons
 * @property {HTMLElement} status  For the eye.
 * @property {HTMLElement} heard  For the ear: what a change has led to.
 * @property {HTMLElement} controls
 * @property {HTMLElement} rows  The table of a figure that is one.
 * @property {HTMLDetailsElement} data
 */

import { adopt } from "../style/adopt.js";
import { say } from "../words/say.js";

const STYLE = `
:host { display: block; container-type: inline-size; color: var(--ink, #1a1a1a); }
:host([hidden]) { display: none; }
*, ::before, ::after { box-sizing: border-box; }
.stage { position: relative; aspect-ratio: var(--aspect, 1.7); background: var(--ground, #fff); }
.stage > canvas { position: absolute; inset: 0; inline-size: 100%; block-size: 100%; display: block; }
.stage > slot { position: absolute; inset: 0; display: block; }
.stage.live > slot { display: none; }
::slotted(img) { inline-size: 100%; block-size: 100%; object-fit: contain; }
.stage > canvas { touch-action: pan-x pan-y; }
.layer { position: absolute; inset: 0; overflow: hidden; pointer-events: none; }
.layer > * { position: absolute; inset-block-start: 0; left: 0; }
.layer > [hidden] { display: none; }
.upright, .level, .linked { border: 0 solid var(--quiet, #555); border-inline-start-width: 1px; border-block-start-width: 1px; opacity: 0.55; }
.linked { border-color: var(--accent, #0072b2); opacity: 0.9; }
.dot { border: 2px solid var(--ink, #1a1a1a); border-radius: 50%; }
.band { border: 1px solid var(--accent, #0072b2); background: color-mix(in srgb, var(--accent, #0072b2) 12%, transparent); }
.legend { --rows: 1; --entry: 1.75rem; display: flex; align-content: start; gap: 0.125rem 0.25rem; overflow-x: auto; scrollbar-width: thin; margin-inline: -0.4rem;
  min-block-size: calc(var(--rows) * (var(--entry) + 0.125rem) + 0.125rem); }
.legend:empty { visibility: hidden; }
:host([controls="none"]:not([fit])) .legend { display: none; }
button.entry { display: inline-flex; flex: none; align-items: center; gap: 0.35rem; font-size: 0.875rem; text-decoration: none; padding: 0 0.4rem; min-block-size: var(--entry); }
.entry[aria-pressed="false"] { color: var(--quiet, #555); text-decoration: line-through; }
.entry[aria-pressed="false"] > svg { opacity: 0.35; }
.swatch { inline-size: 26px; block-size: 14px; flex: none; fill: none; forced-color-adjust: none; }
.swatch.growth { background: linear-gradient(to right, #ffea46, #8a8779, #00204d); }
canvas.turns { cursor: grab; }
canvas.turns.grasped { cursor: grabbing; }
canvas.plane { cursor: crosshair; }
canvas.handle { cursor: ew-resize; }
canvas.handles { cursor: move; }
.bar { display: grid; grid-template-columns: minmax(0, 1fr) auto; align-items: center; column-gap: 1rem; min-block-size: 2.75rem; margin-block-end: 0.5rem; }
.readout { grid-area: 1 / 1; margin: 0; font-size: 0.875rem; line-height: 1.25; color: var(--quiet, #555);
  font-variant-numeric: tabular-nums; max-block-size: 2.5em; overflow: hidden; }
.buttons { grid-area: 1 / 2; display: flex; flex-wrap: wrap; justify-content: end; gap: 0.25rem; margin-inline-end: -0.6rem; }
button { font: inherit; font-size: 0.9375rem; color: inherit; background: none; border: 1px solid transparent; border-radius: 3px;
  padding: 0 0.6rem; min-inline-size: 1.75rem; min-block-size: 1.75rem; cursor: pointer; text-decoration: underline;
  text-decoration-color: var(--rule, #bbb); text-underline-offset: 0.2em; }
button.arrow { text-decoration: none; padding: 0 0.2rem; }
button:hover { text-decoration-color: currentcolor; border-color: var(--rule, #bbb); }
button:disabled { color: var(--quiet, #555); cursor: default; text-decoration: none; border-color: transparent; }
:focus-visible { outline: 2px solid var(--focus, #0072b2); outline-offset: 2px; }
canvas:focus-visible { outline-offset: -2px; }
.status { grid-area: 2 / 1 / 2 / 3; margin: 0; font-size: 0.9375rem; line-height: 1.4; min-block-size: 1.4em; color: var(--quiet, #555); text-wrap: pretty; }
.status.wrong, .complaint { color: var(--wrong, #b33c00); }
.heard { position: absolute; inline-size: 1px; block-size: 1px; overflow: hidden; clip-path: inset(50%); white-space: nowrap; }
.controls { display: grid; column-gap: 2rem; grid-template-columns: minmax(0, 1fr); }
.panel-place { --control: 5.5rem; --summary: 2.25rem; min-block-size: calc(3 * var(--control) + var(--summary)); }
.control { display: grid; grid-template-columns: 2rem minmax(0, 1fr) 5.75rem; grid-template-rows: 2.25rem auto; align-items: center;
  column-gap: 0.5rem; min-block-size: var(--control, 5.5rem); align-content: start; }
.control.choice { grid-template-columns: auto minmax(0, 1fr); }
.control label { font-size: 1.125rem; }
.control sub { font-size: 0.72em; line-height: 0; }
.help, .complaint { grid-column: 1 / -1; margin: 0.125rem 0 0; font-size: 0.8125rem; line-height: 1.3; color: var(--quiet, #555); text-wrap: pretty; }
.complaint { color: var(--wrong, #b33c00); }
.complaint:empty { display: none; }
.range { white-space: nowrap; }
.control:has([aria-invalid]) .help { display: none; }
input, select { font: inherit; font-size: 1rem; color: inherit; accent-color: var(--accent, #0072b2); }
input[role="spinbutton"], select { inline-size: 100%; min-block-size: 1.875rem; padding: 0 0.4rem; background: var(--ground, #fff);
  border: 0; border-block-end: 1px solid var(--line, #767676); border-radius: 0; font-variant-numeric: tabular-nums; }
input[aria-invalid] { border-block-end: 2px solid var(--wrong, #b33c00); }
input[type="range"] { inline-size: 100%; min-block-size: 1.75rem; margin: 0; background: none; touch-action: pan-y; }
summary { cursor: pointer; font-size: 0.9375rem; min-block-size: 2.25rem; line-height: 1.45rem; padding-block: 0.4rem; inline-size: fit-content; padding-inline-end: 0.5rem; }
.panel > .more > .controls { padding-block-start: 0.5rem; }
.data > div { max-block-size: 24rem; overflow: auto; }
table { border-collapse: collapse; font-size: 0.875rem; font-variant-numeric: tabular-nums; margin-block-end: 1rem; }
caption { text-align: start; padding-block: 0.25rem; color: var(--quiet, #555); }
th, td { text-align: end; padding: 0.05rem 0.75rem 0.05rem 0; font-weight: 400; }
th { border-block-end: 1px solid var(--rule, #bbb); }
.rows:empty { display: none; }
.rows { overflow: auto; max-block-size: 44rem; margin-block: 0.5rem 1rem; }
.rows table { inline-size: 100%; margin: 0; line-height: 1.35; }
.rows th, .rows td { text-align: start; vertical-align: top; padding-block: 0.3rem; border-block-end: 1px solid var(--rule, #bbb); }
.rows thead th { position: sticky; inset-block-start: 0; background: var(--ground, #fff); font-weight: 600; }
.rows tr:focus { outline: none; background: color-mix(in srgb, var(--accent, #0072b2) 12%, transparent); }
.rows tbody th { white-space: nowrap; font-weight: 600; }
.rows .number { text-align: end; white-space: nowrap; }
.rows sub, .rows sup { font-size: 0.72em; line-height: 0; }
.data p { margin: 0 0 0.5rem; font-size: 0.9375rem; max-inline-size: 42rem; }
/* Rows of legends, reserved for what is not there yet: five figures have eight to ten entries, and those that stand three abreast little room. On
   a phone long ones are one row that is pushed along. */
@container (inline-size < 37rem) {
  :host(:is([figure="T"], [figure^="11"], [figure^="12"], [figure^="13"])) .legend { --rows: 2; flex-wrap: wrap; }
}
@container (inline-size >= 34rem) {
  .legend { flex-wrap: wrap; }
  :host(:is([figure="6"], [figure="7"], [figure="8"])) .legend { --rows: 2; }
  :host(:is([figure="3"], [figure="5"], [figure="9"], [figure="10"], [figure="B"])) .legend { --rows: 3; }
}
@container (inline-size >= 45rem) {
  :host(:is([figure="6"], [figure="7"], [figure="8"])) .legend { --rows: 1; }
  :host(:is([figure="3"], [figure="5"], [figure="9"], [figure="10"], [figure="B"])) .legend { --rows: 2; }
}
@container (inline-size < 30rem) {
  .stage { aspect-ratio: var(--narrow-aspect, var(--aspect, 1.7)); }
}
@container (inline-size < 34rem) {
  :host([fit]) .legend { display: none; }
}
@container (inline-size >= 34rem) {
  .bar > .status { grid-area: 1 / 1; align-self: center; }
  .bar > .readout:not(:empty) ~ .status { visibility: hidden; }
  .controls { grid-template-columns: repeat(2, minmax(0, 1fr)); }
  .panel-place { min-block-size: calc(2 * var(--control) + var(--summary)); }
}
@container (inline-size >= 50rem) {
  .controls { grid-template-columns: repeat(3, minmax(0, 1fr)); }
  .panel-place { min-block-size: calc(var(--control) + var(--summary)); }
}
@media (pointer: coarse) {
  button, button.entry, input[role="spinbutton"], select { min-block-size: 2.75rem; min-inline-size: 2.75rem; }
  .legend { --entry: 2.75rem; }
  input[type="range"] { min-block-size: 2.75rem; }
  .panel-place { --control: 6rem; --summary: 2.75rem; }
  .control { grid-template-rows: 2.75rem auto; }
  summary { min-block-size: 2.75rem; padding-block: 0.65rem; }
}
:host([fit]) { display: grid !important; grid-template-rows: minmax(0, 1fr) auto; position: relative; }
:host([fit]) .stage { aspect-ratio: auto; min-block-size: 0; margin-inline: var(--inset-start, 0) var(--inset-end, 0); }
:host([fit]) :is(.panel-place, .rows), :host([controls="none"]) .panel-place { display: none; }
:host([fit]) .legend { flex-wrap: nowrap; min-block-size: 0; margin-inline: 0; }
:host([fit][figure="1"]) .legend { display: none; }
:host([fit][figure="B"]) .legend { flex-wrap: wrap; align-content: start; min-block-size: 3.125rem; }
:host([fit]) .legend > .entry { min-block-size: 1.5rem; padding-block: 0; font-size: 0.8125rem; }
:host([fit]) .bar { position: absolute; inset-block-start: -1.6rem; inset-inline: 45% 0; min-block-size: 1.5rem; margin: 0; grid-template-columns: minmax(0, 1fr) auto; }
:host([fit]) .readout { text-align: end; white-space: nowrap; text-overflow: ellipsis; }
:host([fit]) .buttons { flex-wrap: nowrap; }
:host([fit]) .buttons button.reset, :host([fit]) .data:not([open]) { display: none; }
:host([fit]) .status:not(.wrong) { display: none; }
:host([fit]) .status:is(.wrong, .told) { display: block; position: absolute; inset-block-start: 100%; inset-inline: 0; background: var(--ground, #fff); z-index: 1; }
@media (forced-colors: active) {
  .upright, .level, .linked, .band { border-color: CanvasText; opacity: 1; }
  .linked { border-style: dashed; }
  .entry[aria-pressed="true"] { border-color: ButtonText; }
}
.printed { display: none; }
@media print {
  .bar, .legend, .panel-place, .data, .layer { display: none; }
  .printed { display: block; margin: 0.25rem 0 0; font-size: 0.875rem; color: var(--quiet, #333); }
  .printed:empty { display: none; }
  .stage > canvas { object-fit: contain; }
  .rows { max-block-size: none; overflow: visible; }
  .rows thead th { position: static; }
  .rows table { font-size: 0.72rem; }
  .rows th, .rows td { padding-inline: 0.25rem; overflow-wrap: anywhere; }
}
`;

/**
 * Puts the parts into an element's shadow root.
 *
 * @param {ShadowRoot} root
 * @returns {Parts}
 */
export function furnish(root) {
  adopt(STYLE, root);

  const canvas = document.createElement("canvas");
  canvas.setAttribute("role", "img");
  const layer = part("div", "layer");
  layer.setAttribute("aria-hidden", "true");
  const band = part("div", "band");
  band.hidden = true;
  layer.append(band);
  const described = part("p", "heard");
  described.id = "described";
  const keys = part("p", "heard");
  keys.id = "keys";
  // They are heard with the chart that they describe, not a second time by themselves.
  described.hidden = keys.hidden = true;
  const legend = part("div", "legend");
  const stage = part("div", "stage");
  stage.append(document.createElement("slot"), canvas, layer);
  const readout = part("p", "readout");
  const buttons = part("div", "buttons");
  const bar = part("div", "bar");
  const status = part("p", "status");
  bar.append(readout, buttons, status);
  const heard = part("p", "heard");
  heard.setAttribute("aria-live", "polite");
  const controls = part("div", "panel-place");
  const data = document.createElement("details");
  data.className = "data";
  const summary = document.createElement("summary");
  summary.textContent = say("figure.in-words");
  data.append(summary);
  const rows = part("div", "rows");
  const printed = part("p", "printed");
  root.append(stage, printed, described, keys, legend, bar, heard, controls, rows, data);
  return { stage, printed, canvas, layer, band, described, keys, legend, readout, buttons, status, heard, controls, rows, data };
}

/**
 * @param {string} words
 * @param {string} label  What a screen reader says.
 * @param {() => void} press
 */
export function button(words, label, press) {
  const made = document.createElement("button");
  made.type = "button";
  made.textContent = words;
  if (label !== words) made.setAttribute("aria-label", label);
  made.addEventListener("click", press);
  return made;
}

/**
 * @param {string} name
 * @param {string} className
 */
function part(name, className) {
  const made = document.createElement(name);
  made.className = className;
  return made;
}
