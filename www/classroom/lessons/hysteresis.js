/** Two motions at one speed: what the pair does depends on where it comes from; and some starts never come back. */

/** @type {import("../lesson.js").Lesson} */
export const hysteresis = {
  id: "hysteresis",
  title: { word: "lesson.hysteresis.title" },
  summary: { word: "lesson.hysteresis.summary" },
  steps: [
    {
      title: { word: "lesson.hysteresis.small.title" },
      text: { word: "lesson.hysteresis.small.text" },
      preset: "13b",
      point: { Omega: 5 },
      figures: ["T"],
      question: {
        kind: "choice",
        ask: { word: "lesson.hysteresis.small.ask" },
        options: [
          { text: { word: "lesson.hysteresis.rests" }, when: [{ figure: "M", fact: "stable", is: true }] },
          { text: { word: "lesson.hysteresis.swings" }, when: [{ figure: "M", fact: "stable", is: false }] },
        ],
      },
      reveal: { text: { word: "lesson.hysteresis.small.reveal" }, figures: ["U"] },
    },
    {
      title: { word: "lesson.hysteresis.large.title" },
      text: { word: "lesson.hysteresis.large.text" },
      preset: "13b",
      point: { Omega: 5, u_p0: -1.5, u_g0: 1.5, u0: 3 },
      figures: ["B"],
      question: {
        kind: "choice",
        ask: { word: "lesson.hysteresis.large.ask" },
        options: [
          {
            text: { word: "lesson.hysteresis.rests" },
            when: [
              { figure: "P", fact: "end", is: "orbit" },
              { figure: "P", fact: "period", is: 1 },
            ],
          },
          {
            text: { word: "lesson.hysteresis.swings" },
            when: [
              { figure: "P", fact: "end", is: "orbit" },
              { figure: "P", fact: "period", is: 2 },
            ],
          },
          { text: { word: "lesson.hysteresis.escapes" }, when: [{ figure: "P", fact: "end", is: "escaped" }] },
        ],
      },
      reveal: {
        text: { word: "lesson.hysteresis.large.reveal" },
        figures: ["P", "U"],
        values: { size: { figure: "P", fact: "maxU_p" } },
      },
    },
    {
      title: { word: "lesson.hysteresis.sweep.title" },
      text: { word: "lesson.hysteresis.sweep.text" },
      preset: "13b",
      figures: ["B"],
      question: {
        kind: "choice",
        ask: { word: "lesson.hysteresis.sweep.ask" },
        options: [
          { text: { word: "lesson.hysteresis.sweep.same" } },
          { text: { word: "lesson.hysteresis.sweep.later" }, right: true },
        ],
      },
      reveal: { text: { word: "lesson.hysteresis.sweep.reveal" }, figures: ["S"] },
    },
    {
      title: { word: "lesson.hysteresis.escape.title" },
      text: { word: "lesson.hysteresis.escape.text" },
      preset: "13b",
      point: { Omega: 5, u_p0: -7, u_g0: 7, u0: 0 },
      figures: ["P"],
      open: ["u_p0", "u_g0"],
      question: {
        kind: "point",
        ask: { word: "lesson.hysteresis.escape.ask" },
        goal: [{ figure: "P", fact: "end", is: "orbit" }],
      },
      reveal: { text: { word: "lesson.hysteresis.escape.reveal" }, figures: ["P", "A"] },
    },
  ],
};
