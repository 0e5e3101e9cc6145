/** What is drawn in a chart but says nothing in numbers. @type {ReadonlySet<string>} */
export const FURNITURE = new Set(["body-first", "body-second", "link", "dead-zone", "reference"]);
