/** What a tongue is: speeds at which a pulse makes rest unstable. */

const DIES_OR_GROWS = [
  { text: { word: "lesson.tongue.dies" }, when: [{ figure: "M", fact: "stable", is: true }] },
  { text: { word: "lesson.tongue.grows" }, when: [{ figure: "M", fact: "stable", is: false }] },
];

/** @type {import("../lesson.js").Lesson} */
export const tongue = {
  id: "tongue",
  title: { word: "lesson.tongue.title" },
  summary: { word: "lesson.tongue.summary" },
  steps: [
    {
      title: { word: "lesson.tongue.quiet.title" },
      text: [{ word: "lesson.tongue.quiet.text" }, { word: "lesson.tongue.quiet.text2" }],
      preset: "T",
      point: { Omega: 2.2 },
      figures: ["T"],
      question: {
        kind: "choice",
        ask: { word: "lesson.tongue.push" },
        options: DIES_OR_GROWS,
      },
      reveal: {
        text: { word: "lesson.tongue.quiet.reveal" },
        figures: ["T", "U"],
        values: { size: { figure: "M", fact: "spectralRadius" } },
      },
    },
    {
      title: { word: "lesson.tongue.inside.title" },
      text: { word: "lesson.tongue.inside.text" },
      point: { Omega: 1.6 },
      figures: ["T"],
      question: {
        kind: "choice",
        ask: { word: "lesson.tongue.push" },
        options: DIES_OR_GROWS,
      },
      reveal: { text: { word: "lesson.tongue.inside.reveal" }, figures: ["T", "U"] },
    },
    {
      title: { word: "lesson.tongue.factor.title" },
      text: { word: "lesson.tongue.factor.text" },
      figures: ["M"],
      question: {
        kind: "number",
        ask: { word: "lesson.tongue.factor.ask" },
        answer: { figure: "M", fact: "spectralRadius" },
        within: 0.05,
      },
      reveal: { text: { word: "lesson.tongue.factor.reveal" } },
    },
    {
      title: { word: "lesson.tongue.third.title" },
      text: { word: "lesson.tongue.third.text" },
      figures: ["T"],
      open: ["Omega", "k0"],
      question: {
        kind: "point",
        ask: { word: "lesson.tongue.third.ask" },
        goal: [
          { parameter: "Omega", from: 4.5, to: 6.5 },
          { figure: "M", fact: "stable", is: false },
        ],
      },
      reveal: { text: { word: "lesson.tongue.third.reveal" }, figures: ["T", "M"] },
    },
    {
      title: { word: "lesson.tongue.damping.title" },
      text: { word: "lesson.tongue.damping.text" },
      preset: "T",
      figures: ["T"],
      open: ["zeta"],
      question: {
        kind: "point",
        ask: { word: "lesson.tongue.damping.ask" },
        goal: [{ figure: "M", fact: "stable", is: true }],
      },
      reveal: { text: { word: "lesson.tongue.damping.reveal" }, figures: ["T", "U"] },
    },
  ],
};
