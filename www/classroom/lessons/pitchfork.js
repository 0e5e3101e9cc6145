/** What takes the place of rest in a primary tongue: a fork with two points, which are one motion. */

/** @type {import("../lesson.js").Lesson} */
export const pitchfork = {
  id: "pitchfork",
  title: { word: "lesson.pitchfork.title" },
  summary: { word: "lesson.pitchfork.summary" },
  steps: [
    {
      title: { word: "lesson.pitchfork.fate.title" },
      text: [{ word: "lesson.pitchfork.fate.text" }, { word: "lesson.pitchfork.fate.text2" }],
      preset: "11c",
      figures: ["T"],
      question: {
        kind: "choice",
        ask: { word: "lesson.pitchfork.fate.ask" },
        options: [
          { text: { word: "lesson.pitchfork.fate.escapes" }, when: [{ figure: "P", fact: "end", is: "escaped" }] },
          {
            text: { word: "lesson.pitchfork.fate.once" },
            when: [
              { figure: "P", fact: "end", is: "orbit" },
              { figure: "P", fact: "period", is: 1 },
            ],
          },
          {
            text: { word: "lesson.pitchfork.fate.twice" },
            when: [
              { figure: "P", fact: "end", is: "orbit" },
              { figure: "P", fact: "period", is: 2 },
            ],
          },
        ],
      },
      reveal: {
        text: { word: "lesson.pitchfork.fate.reveal" },
        figures: ["P", "U"],
        values: { size: { figure: "P", fact: "maxU_p" } },
      },
    },
    {
      title: { word: "lesson.pitchfork.pair.title" },
      text: { word: "lesson.pitchfork.pair.text" },
      figures: ["P"],
      question: {
        kind: "choice",
        ask: { word: "lesson.pitchfork.pair.ask" },
        options: [
          { text: { word: "lesson.pitchfork.pair.two" } },
          { text: { word: "lesson.pitchfork.pair.one" }, right: true },
          { text: { word: "lesson.pitchfork.pair.none" } },
        ],
      },
      reveal: { text: { word: "lesson.pitchfork.pair.reveal" }, figures: ["P", "1"] },
    },
    {
      title: { word: "lesson.pitchfork.size.title" },
      text: { word: "lesson.pitchfork.size.text" },
      figures: ["B"],
      question: {
        kind: "number",
        ask: { word: "lesson.pitchfork.size.ask" },
        answer: { figure: "P", fact: "maxU_p" },
        within: 0.08,
      },
      reveal: { text: { word: "lesson.pitchfork.size.reveal" }, figures: ["B", "P"] },
    },
    {
      title: { word: "lesson.pitchfork.grow.title" },
      text: { word: "lesson.pitchfork.grow.text" },
      figures: ["B", "P"],
      open: ["Omega"],
      question: {
        kind: "point",
        ask: { word: "lesson.pitchfork.grow.ask" },
        goal: [
          { figure: "P", fact: "period", is: 2 },
          { figure: "P", fact: "maxU_p", from: 2 },
        ],
      },
      reveal: { text: { word: "lesson.pitchfork.grow.reveal" } },
    },
    {
      title: { word: "lesson.pitchfork.hard.title" },
      text: { word: "lesson.pitchfork.hard.text" },
      preset: "11c",
      figures: ["10"],
      question: {
        kind: "choice",
        ask: { word: "lesson.pitchfork.hard.ask" },
        options: [
          { text: { word: "lesson.pitchfork.hard.lower" } },
          { text: { word: "lesson.pitchfork.hard.higher" }, right: true },
          { text: { word: "lesson.pitchfork.hard.same" } },
        ],
      },
      reveal: { text: { word: "lesson.pitchfork.hard.reveal" }, figures: ["9"] },
    },
  ],
};
