/** What takes the place of rest where two modes are fed at once: a closed curve in the map, two frequencies in time. */

/** @type {import("../lesson.js").Lesson} */
export const hopf = {
  id: "hopf",
  title: { word: "lesson.hopf.title" },
  summary: { word: "lesson.hopf.summary" },
  steps: [
    {
      title: { word: "lesson.hopf.two.title" },
      text: [{ word: "lesson.hopf.two.text" }, { word: "lesson.hopf.two.text2" }],
      preset: "12b",
      figures: ["T", "M"],
      question: {
        kind: "choice",
        ask: { word: "lesson.hopf.two.ask" },
        options: [
          { text: { word: "lesson.hopf.two.line" }, when: [{ figure: "M", fact: "im", from: 0, to: 1e-6 }] },
          { text: { word: "lesson.hopf.two.spiral" }, when: [{ figure: "M", fact: "im", from: 1e-3 }] },
        ],
      },
      reveal: { text: { word: "lesson.hopf.two.reveal" }, figures: ["M", "U"] },
    },
    {
      title: { word: "lesson.hopf.curve.title" },
      text: { word: "lesson.hopf.curve.text" },
      figures: ["M"],
      question: {
        kind: "choice",
        ask: { word: "lesson.hopf.curve.ask" },
        options: [
          { text: { word: "lesson.hopf.curve.points" }, when: [{ figure: "P", fact: "end", is: "orbit" }] },
          { text: { word: "lesson.hopf.curve.closed" }, when: [{ figure: "P", fact: "end", is: "wandering" }] },
          { text: { word: "lesson.hopf.curve.away" }, when: [{ figure: "P", fact: "end", is: "escaped" }] },
        ],
      },
      reveal: { text: { word: "lesson.hopf.curve.reveal" }, figures: ["P", "W"] },
    },
    {
      title: { word: "lesson.hopf.edge.title" },
      text: { word: "lesson.hopf.edge.text" },
      figures: ["P", "M"],
      open: ["Omega"],
      question: {
        kind: "point",
        ask: { word: "lesson.hopf.edge.ask" },
        goal: [
          { parameter: "Omega", from: 3.5, to: 4.2 },
          { figure: "M", fact: "spectralRadius", from: 0.99, to: 1.01 },
        ],
      },
      reveal: { text: { word: "lesson.hopf.edge.reveal" }, values: { omega: { figure: "M", fact: "spectralRadius", digits: 4 } } },
    },
    {
      title: { word: "lesson.hopf.damping.title" },
      text: { word: "lesson.hopf.damping.text" },
      preset: "12b",
      figures: ["6"],
      question: {
        kind: "choice",
        ask: { word: "lesson.hopf.damping.ask" },
        options: [
          { text: { word: "lesson.hopf.damping.narrower" } },
          { text: { word: "lesson.hopf.damping.same" } },
          { text: { word: "lesson.hopf.damping.wider" }, right: true },
        ],
      },
      reveal: { text: { word: "lesson.hopf.damping.reveal" }, figures: ["6", "T"] },
    },
  ],
};
