/** How the classroom looks. Colours come from the page's custom properties. */

export const STYLE = `
.classroom { max-inline-size: var(--wide); margin-inline: auto; padding-block: 1rem 4rem; }
.classroom .top { display: flex; flex-wrap: wrap; justify-content: space-between; align-items: baseline; gap: 0.5rem 2rem; }
.classroom h1 { margin-block: 0.5rem; }
.classroom h2 { margin-block: 0.25rem 0.75rem; max-inline-size: none; }
.classroom h2:focus { outline: none; }
.classroom h3 { font-size: 1rem; font-weight: 400; margin: 0 0 0.25rem; color: var(--quiet); max-inline-size: none; }
.classroom .lessons { list-style: none; margin: 1.5rem 0; padding: 0; display: grid; gap: 1.25rem 3rem; grid-template-columns: repeat(auto-fill, minmax(min(100%, 24rem), 1fr)); }
.classroom .lessons li { border-block-start: 1px solid var(--rule); padding-block-start: 0.5rem; }
.classroom .lessons p { margin: 0.25rem 0 0; }
.classroom button, .classroom .file { font: inherit; color: inherit; background: none; border: 1px solid var(--line); border-radius: 3px; min-block-size: 2.75rem; padding: 0.3rem 0.9rem; cursor: pointer; }
.classroom .begin { border: 0; padding: 0.25rem 0; font-size: 1.25rem; text-align: start; text-decoration: underline; text-decoration-color: var(--line); text-underline-offset: 0.2em; }
.classroom .primary { border-color: var(--ink); box-shadow: inset 0 -3px 0 var(--accent); }
.classroom button:disabled { opacity: 0.45; cursor: default; }
.classroom :focus-visible { outline: 2px solid var(--focus); outline-offset: 2px; }
.classroom .file { display: inline-flex; align-items: center; position: relative; }
.classroom .file input { position: absolute; inset: 0; opacity: 0; inline-size: 100%; cursor: pointer; }
.classroom .file:focus-within { outline: 2px solid var(--focus); outline-offset: 2px; }
.classroom .buttons { display: flex; flex-wrap: wrap; gap: 0.75rem; margin-block: 1rem; }
.classroom .top .buttons { margin-block: 0; }
.classroom .message:empty { display: none; }
.classroom .message { border-inline-start: 3px solid var(--accent); padding-inline-start: 0.75rem; overflow-wrap: anywhere; }
.classroom .progress, .classroom .help, .classroom .count, .classroom .locked { color: var(--quiet); font-size: 1rem; margin: 0; }
.classroom .lesson { display: grid; gap: 1.5rem 3rem; grid-template-columns: minmax(0, 1fr); align-items: start; }
.classroom .lesson .words { max-inline-size: var(--text); }
.classroom .charts { display: grid; gap: 1.5rem; }
.classroom .chart { min-inline-size: 0; }
.classroom .question { margin-block: 1.5rem; }
.classroom fieldset { border: 0; border-inline-start: 3px solid var(--accent); margin: 0; padding: 0 0 0 0.9rem; display: grid; gap: 0.25rem; min-inline-size: 0; }
.classroom legend { padding: 0; font-weight: 700; margin-block-end: 0.5rem; float: inline-start; inline-size: 100%; }
.classroom fieldset label { display: flex; gap: 0.6rem; align-items: baseline; min-block-size: 2.25rem; cursor: pointer; }
.classroom fieldset input[type="radio"] { inline-size: 1.25rem; block-size: 1.25rem; flex: none; accent-color: var(--accent); translate: 0 0.2em; margin: 0; }
.classroom fieldset input[type="text"] { font: inherit; font-size: 1.25rem; color: inherit; background: var(--ground); inline-size: 10rem; min-block-size: 2.75rem; border: 0; border-block-end: 1px solid var(--line); padding-inline: 0.4rem; }
.classroom .complaint { color: var(--wrong); margin-block: 0.5rem 0; }
.classroom .complaint:empty { display: none; }
.classroom .verdict { border-block: 1px solid var(--rule); padding-block: 0.5rem; }
.classroom .open { display: grid; gap: 0.5rem 2rem; grid-template-columns: repeat(auto-fill, minmax(min(100%, 17rem), 1fr)); margin-block-start: 1rem; }
.classroom .control { display: grid; grid-template-columns: 2.75rem minmax(0, 1fr) 5.75rem; align-items: center; column-gap: 0.5rem; align-content: start; }
.classroom .control.choice { grid-template-columns: auto minmax(0, 1fr); }
.classroom .control input, .classroom .control select { font: inherit; color: inherit; background: var(--ground); min-block-size: 2.25rem; accent-color: var(--accent); min-inline-size: 0; }
.classroom .control input[role="spinbutton"] { border: 0; border-block-end: 1px solid var(--line); padding-inline: 0.4rem; font-variant-numeric: tabular-nums; }
.classroom .control :is(.help, .complaint) { grid-column: 1 / -1; font-size: 0.875rem; line-height: 1.3; }
@media (min-width: 62rem) {
  .classroom .lesson { grid-template-columns: minmax(0, 2fr) minmax(0, 3fr); }
  .classroom .side { position: sticky; inset-block-start: 1rem; }
}
@media (pointer: coarse) { .classroom .control input, .classroom fieldset label { min-block-size: 2.75rem; } }
@media print { .classroom :is(.buttons, .open, form .buttons) { display: none; } }
`;
