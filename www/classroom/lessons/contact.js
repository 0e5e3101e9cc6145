/** Whether the teeth stay together: the assumption on which the theory rests. */

const KEPT_OR_LOST = [
  { text: { word: "lesson.contact.kept" }, when: [{ figure: "U", fact: "margin", from: 0 }] },
  { text: { word: "lesson.contact.lost" }, when: [{ figure: "U", fact: "contact", is: "lost" }] },
];

/** @type {import("../lesson.js").Lesson} */
export const contact = {
  id: "contact",
  title: { word: "lesson.contact.title" },
  summary: { word: "lesson.contact.summary" },
  steps: [
    {
      title: { word: "lesson.contact.soft.title" },
      text: [{ word: "lesson.contact.soft.text" }, { word: "lesson.contact.soft.text2" }],
      preset: "14b",
      figures: ["1"],
      question: {
        kind: "choice",
        ask: { word: "lesson.contact.ask" },
        options: KEPT_OR_LOST,
      },
      reveal: {
        text: { word: "lesson.contact.soft.reveal" },
        figures: ["U"],
        values: { lowest: { figure: "U", fact: "lowest", digits: 5 }, highest: { figure: "U", fact: "highest", digits: 5 } },
      },
    },
    {
      title: { word: "lesson.contact.linear.title" },
      text: { word: "lesson.contact.linear.text" },
      preset: "14a",
      figures: ["1"],
      question: {
        kind: "choice",
        ask: { word: "lesson.contact.ask" },
        options: KEPT_OR_LOST,
      },
      reveal: {
        text: { word: "lesson.contact.linear.reveal" },
        figures: ["U"],
        values: { time: { figure: "U", fact: "lostAt" } },
      },
    },
    {
      title: { word: "lesson.contact.back.title" },
      text: { word: "lesson.contact.back.text" },
      preset: "14a",
      point: { regime: "backlash" },
      figures: ["1"],
      question: {
        kind: "choice",
        ask: { word: "lesson.contact.back.ask" },
        options: [
          { text: { word: "lesson.contact.back.endless" }, when: [{ figure: "P", fact: "end", is: "escaped" }] },
          { text: { word: "lesson.contact.back.settles" }, when: [{ figure: "P", fact: "end", is: "orbit" }] },
          { text: { word: "lesson.contact.back.wanders" }, when: [{ figure: "P", fact: "end", is: "wandering" }] },
        ],
      },
      reveal: {
        text: { word: "lesson.contact.back.reveal" },
        figures: ["U", "P"],
        values: { lowest: { figure: "U", fact: "lowest", digits: 4 }, highest: { figure: "U", fact: "highest", digits: 4 } },
      },
    },
    {
      title: { word: "lesson.contact.load.title" },
      text: { word: "lesson.contact.load.text" },
      preset: "L",
      point: { regime: "backlash", F: 0.05 },
      figures: ["U"],
      open: ["F"],
      question: {
        kind: "point",
        ask: { word: "lesson.contact.load.ask" },
        goal: [
          { figure: "U", fact: "margin", from: 0 },
          { parameter: "F", from: 0, to: 2 },
        ],
      },
      reveal: { text: { word: "lesson.contact.load.reveal" }, figures: ["U", "L"] },
    },
  ],
};
