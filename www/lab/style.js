/** How the laboratory looks. Colours come from the page's custom properties. */

export const STYLE = `
[data-view="lab"] .lab { --gap: 0.75rem; display: grid; gap: var(--gap); max-inline-size: 100rem; margin-inline: auto; font-size: 0.9375rem;
  line-height: 1.35; }
.lab .unseen { position: absolute; inline-size: 1px; block-size: 1px; margin: 0; overflow: hidden; clip-path: inset(50%); }
.lab p { font-size: inherit; margin: 0; max-inline-size: none; }
.lab h2 { font-size: 0.9375rem; font-weight: 400; margin: 0; max-inline-size: none; color: var(--quiet); line-height: 1.3; }
.lab button, .lab select, .lab input { font: inherit; color: inherit; accent-color: var(--accent); }
.lab button, .lab select { background: none; border: 1px solid var(--rule); border-radius: 3px; min-block-size: 1.75rem; padding: 0 0.5rem; cursor: pointer; }
.lab select { background: var(--ground); }
.lab button:hover, .lab select:hover { border-color: var(--line); }
.lab button[aria-pressed="true"], .lab button[aria-expanded="true"] { border-color: var(--ink); box-shadow: inset 0 -2px 0 var(--accent); }
.lab :focus-visible { outline: 2px solid var(--focus); outline-offset: 2px; }
.lab .toolbar, .lab .toolbar .group, .lab .tabs, .lab .entries, .lab .further { display: flex; flex-wrap: wrap; align-items: center; gap: 0.3rem; }
.lab .toolbar { column-gap: 1.5rem; }
.lab .toolbar input { inline-size: 6rem; }
.lab .toolbar .label { color: var(--quiet); }
.lab .left, .lab .right { display: grid; gap: 0.35rem var(--gap); min-inline-size: 0; }
.lab .left { position: relative; grid-auto-rows: minmax(19rem, 1fr); }
.lab .chart { display: grid; grid-template-rows: 1.5rem minmax(0, 1fr); min-inline-size: 0; }
.lab .chart gear-figure { min-block-size: 0; min-inline-size: 0; }
.lab .right { grid-template-columns: repeat(2, minmax(0, 1fr)); }
.lab .right .chart { min-block-size: 17rem; }
.lab .chart-1, .lab .chart-U { grid-column: 1 / -1; }
.lab .over { position: absolute; inset: 0; inline-size: 100%; block-size: 100%; pointer-events: none; }
.lab .over .here { fill: var(--ground); stroke: var(--ink); stroke-width: 2.5; }
.lab .over .trail { fill: none; stroke: var(--ink); stroke-width: 1.5; stroke-dasharray: 1 3; stroke-linecap: round; }
.lab .cursor { position: absolute; inset-block: 1.6rem 0; inset-inline-start: 0; inline-size: 0; border-inline-start: 1px solid var(--ink); opacity: 0.75; pointer-events: none; }
.lab .knob { position: absolute; inset-block-end: -1rem; inset-inline-start: -0.5px; translate: -50% 0; inline-size: 1.75rem; min-block-size: 1.75rem !important; padding: 0 !important;
  border-radius: 50% !important; background: var(--ground) !important; border: 1.5px solid var(--ink) !important; cursor: ew-resize !important; pointer-events: auto;
  touch-action: none; }
.lab .knob::before { content: "↔"; }
.lab .pin-flag { position: absolute; inset: 0 auto auto 0; inline-size: 1.3rem; block-size: 1.3rem; margin: -1.6rem 0 0 0.4rem; display: grid; place-items: center; font-size: 0.8125rem;
  font-weight: 700; line-height: 1; background: var(--ground); border: 1.5px solid var(--ink); pointer-events: none; }
.lab .numbers { position: relative; border-block: 1px solid var(--rule); padding-block: 0.3rem; }
.lab .entry { border-color: transparent; font-variant-numeric: tabular-nums; }
.lab .entry .symbol { margin-inline-end: 0.2rem; }
.lab .entry .value { text-decoration: underline; text-decoration-color: var(--rule); text-underline-offset: 0.2em; }
.lab .entry sub, .lab .control sub { font-size: 0.72em; line-height: 0; }
.lab .further[hidden] { display: none; }
.lab .drawer { display: grid; gap: 0.25rem 2rem; grid-template-columns: repeat(auto-fill, minmax(min(100%, 17rem), 1fr)); padding-block: 0.5rem; }
.lab .drawer[hidden], .lab .pair[hidden], .lab .compare[hidden] { display: none; }
.lab .drawer .foot { align-self: end; display: flex; flex-wrap: wrap; gap: 0.5rem; align-items: center; }
.lab .control { display: grid; grid-template-columns: 2.75rem minmax(0, 1fr) 5.75rem; align-items: center; column-gap: 0.5rem; align-content: start; }
.lab .control.choice { grid-template-columns: auto minmax(0, 1fr); }
.lab .control label { font-size: 1.0625rem; white-space: nowrap; }
.lab .help, .lab .complaint { grid-column: 1 / -1; font-size: 0.8125rem; line-height: 1.3; color: var(--quiet); text-wrap: pretty; }
.lab .complaint { color: var(--wrong); }
.lab .complaint:empty { display: none; }
.lab .control:has([aria-invalid]) .help { display: none; }
.lab input[role="spinbutton"], .lab .pair input { inline-size: 100%; min-block-size: 1.75rem; padding: 0 0.4rem; background: var(--ground); border: 0; border-block-end: 1px solid var(--line);
  border-radius: 0; font-variant-numeric: tabular-nums; }
.lab input[aria-invalid] { border-block-end: 2px solid var(--wrong); }
.lab input[type="range"] { inline-size: 100%; min-block-size: 1.75rem; margin: 0; }
.lab .thumb { display: none; }
.lab .state { display: grid; grid-template-columns: auto minmax(0, 1fr); gap: 0.15rem 1.5rem; align-items: baseline; min-block-size: 2.75rem; position: sticky; inset-block-end: 0;
  background: var(--ground); padding-block: 0.4rem; z-index: 2; }
.lab .sentence { text-wrap: pretty; min-block-size: 2.7em; }
.lab .sentence.wrong { color: var(--wrong); }
.lab .flag { max-inline-size: 18rem; min-inline-size: 12rem; font-variant-numeric: tabular-nums; }
.lab .flag .sign { display: inline-block; inline-size: 1.4em; text-align: center; font-weight: 700; border: 1.5px solid currentcolor; border-radius: 3px; line-height: 1.25; }
.lab .flag[data-contact="lost"] { color: var(--unstable-ink, var(--wrong)); font-weight: 700; }
.lab .pair form { display: grid; gap: 0.5rem 1.5rem; grid-template-columns: repeat(auto-fill, minmax(min(100%, 19rem), 1fr)); margin-block: 0.5rem; }
.lab .pair fieldset { border: 0; border-block-start: 1px solid var(--rule); padding: 0.25rem 0 0; margin: 0; min-inline-size: 0; }
.lab .pair legend { padding: 0 0.5rem 0 0; font-weight: 700; }
.lab .quantity { display: grid; grid-template-columns: minmax(0, 1fr) 7rem 3.5rem; gap: 0.5rem; align-items: center; }
.lab .quantity .unit { color: var(--quiet); white-space: nowrap; }
.lab .buttons { display: flex; flex-wrap: wrap; gap: 0.5rem; align-self: end; }
.lab table { border-collapse: collapse; font-variant-numeric: tabular-nums; margin-block: 0.25rem; }
.lab caption { text-align: start; color: var(--quiet); }
.lab th, .lab td { text-align: start; font-weight: 400; vertical-align: top; padding: 0.15rem 1.25rem 0.15rem 0; border-block-end: 1px solid var(--rule); }
.lab thead th { font-weight: 700; }
.lab .compare { overflow-x: auto; }
.lab .compare table { inline-size: 100%; min-inline-size: 34rem; table-layout: fixed; }
.lab .compare tr > :first-child { inline-size: 22%; color: var(--quiet); }
.lab .compare canvas { display: block; inline-size: 100%; block-size: 11rem; }
@media (min-width: 1100px) {
  [data-view="lab"] .lab { grid-template-columns: minmax(0, 1.28fr) minmax(0, 1fr); }
  .lab > * { grid-column: 1 / -1; }
  .lab .left { grid-column: 1; block-size: clamp(36rem, calc(100dvh - 15rem), 72rem); grid-auto-rows: minmax(0, 1fr); }
  .lab .right { grid-column: 2; block-size: clamp(36rem, calc(100dvh - 15rem), 72rem); grid-template-columns: repeat(24, minmax(0, 1fr)); grid-template-rows: 1fr 0.95fr 1.25fr; }
  .lab .right .chart { min-block-size: 0; }
  .lab .chart-1 { grid-area: 1 / 1 / 2 / -1; }
  .lab .chart-U { grid-area: 2 / 1 / 3 / 16; }
  .lab .chart-W { grid-area: 2 / 16 / 3 / 25; }
  .lab .chart-P { grid-area: 3 / 1 / 4 / 10; }
  .lab .chart-M { grid-area: 3 / 10 / 4 / 25; }
  .lab .tabs { display: none; }
}
@media (max-width: 1099.98px) {
  .lab .tabs { display: none; }
  .lab .state { border-block-start: 1px solid var(--rule); order: 9; }
  .lab .pair, .lab .compare { order: 8; }
}
@media (max-width: 699.98px) {
  .lab .tabs { display: flex; }
  .lab .toolbar { order: 2; }
  .lab .numbers { order: 3; }
  .lab .knob { display: none; }
  .lab .chart { display: none; }
  .lab[data-chart="T"] .chart-T, .lab[data-chart="B"] .chart-B, .lab[data-chart="1"] .chart-1, .lab[data-chart="U"] .chart-U, .lab[data-chart="P"] .chart-P,
  .lab[data-chart="M"] .chart-M, .lab[data-chart="W"] .chart-W { display: grid; grid-column: 1 / -1; block-size: clamp(14rem, calc(100dvh - 29rem), 26rem); min-block-size: 0 !important; }
  .lab .left { grid-auto-rows: auto; }
  .lab:not([data-chart="T"], [data-chart="B"]) .left, .lab:is([data-chart="T"], [data-chart="B"]) .right { display: none; }
  .lab .thumb { display: grid; gap: 0.1rem; position: sticky; inset-block-end: var(--state, 6.5rem); background: var(--ground); z-index: 2; order: 9; padding-block: 0.3rem;
    border-block-start: 1px solid var(--rule); }
  .lab .thumb label { display: grid; grid-template-columns: 1.6rem minmax(0, 1fr) 3.75rem; align-items: center; gap: 0.5rem; }
  .lab .thumb output { text-align: end; font-variant-numeric: tabular-nums; }
  .lab .thumb input { min-block-size: 2.75rem !important; }
  .lab .state { grid-template-columns: minmax(0, 1fr); border: 0; min-block-size: 6.5rem; padding-block: 0 0.4rem; align-content: start; }
  .lab .flag { max-inline-size: none; }
}
@media (pointer: coarse) {
  .lab button, .lab select, .lab input { min-block-size: 2.75rem; }
  .lab .knob { inline-size: 2.75rem; min-block-size: 2.75rem !important; }
}
@media print {
  .lab :is(.toolbar, .tabs, .thumb, .knob, .over, .cursor, .pin-flag) { display: none; }
  .lab .state { position: static; }
}
`;
