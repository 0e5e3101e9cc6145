/** Warum etwas nicht geht. */

/** @type {import("../../engine.js").Patterns} */
export const errors = [
  [
    "at time {1} a step of {2} would be needed, which double precision cannot resolve",
    "zur Zeit {1} wäre ein Schritt von {2} nötig, den doppelte Genauigkeit nicht auflöst",
  ],
  ["{1} steps reached only time {2}", "{1} Schritte kamen nur bis zur Zeit {2}"],
  ["the motion is no finite number any more at time {1}", "die Bewegung ist zur Zeit {1} keine endliche Zahl mehr"],
  ["the motion escapes at time {1}", "die Bewegung entkommt zur Zeit {1}"],
  [
    "no convergence after {1} iterations: the residual is {2}, asked for was {3}",
    "keine Konvergenz nach {1} Schritten: Der Rest ist {2}, verlangt war {3}",
  ],
  ["no convergence: the residual is {1}", "keine Konvergenz: Der Rest ist {1}"],
  ["a matrix that must be inverted is singular", "eine Matrix, die umgekehrt werden muss, ist singulär"],
  ["no change of sign between {1} and {2}", "kein Vorzeichenwechsel zwischen {1} und {2}"],
  ['there is no parameter named "{1}"', "es gibt keinen Parameter namens „{1}“"],
  ["{1} must be a number from {2} to {3}, but {4} was given", "{1} muss eine Zahl von {2} bis {3} sein, angegeben war {4}"],
  ["{1} must be from {2} to {3}, but {4} was given", "{1} muss von {2} bis {3} liegen, angegeben war {4}"],
  ['{1} must be one of {2}, but "{3}" was given', "{1} muss eines von {2} sein, angegeben war „{3}“"],
  [
    "the homogeneous regime takes no load, but {1} is {2}; choose contact or backlash",
    "das Regime homogeneous trägt keine Last, doch {1} ist {2}; wählen Sie contact oder backlash",
  ],
  [
    "the paper's formulas need equal supports, but {1} is {2} and {3} is {4}",
    "die Formeln des Aufsatzes brauchen gleiche Lager, doch {1} ist {2} und {3} ist {4}",
  ],
  [
    "{1} has no common period with {2}: {3}",
    "{1} hat keine gemeinsame Periode mit {2}: {3}",
  ],
  ["{1} is needed and was not given", "{1} wird gebraucht und war nicht angegeben"],
  [
    "T_g = {1} N m does not balance the pinion's torque: T_p r_g / r_p is {2} N m",
    "T_g = {1} N m hält dem Drehmoment des Ritzels nicht das Gleichgewicht: T_p r_g / r_p ist {2} N m",
  ],
  ["equation {1} has no meaning where {2} is zero", "Gleichung {1} hat keine Bedeutung, wo {2} null ist"],
  ["the option {1} must be a number from {2} to {3}, but {4} was given", "die Option {1} muss eine Zahl von {2} bis {3} sein, angegeben war {4}"],
  ["the option {1} must be {2}, but {3} was given", "die Option {1} muss {2} sein, angegeben war {3}"],
  ["there is no {1} to be found here: {2}", "hier lässt sich nichts finden, was gesucht war ({1}): {2}"],
  ["the drawing failed: {1}", "das Zeichnen misslang: {1}"],
  [
    "a picture of {1} by {2} pixels cannot be drawn: each side must be from 120 to 8192 pixels",
    "ein Bild von {1} mal {2} Pixeln lässt sich nicht zeichnen: Jede Seite muss 120 bis 8192 Pixel haben",
  ],
  ['"{1}" holds a value that is no finite number', "„{1}“ enthält einen Wert, der keine endliche Zahl ist"],
  ['"{1}" cannot be drawn: {2}', "„{1}“ lässt sich nicht zeichnen: {2}"],
  ['there is no figure "{1}"', "es gibt keine Abbildung „{1}“"],
  ["there is no figure {1}: there are {2}", "es gibt keine Abbildung {1}: Es gibt {2}"],
  ["There is no figure “{1}”; there are {2}.", "Es gibt keine Abbildung „{1}“; es gibt {2}."],
  ["There is no parameter “{1}”; it was left out.", "Es gibt keinen Parameter „{1}“; er wurde ausgelassen."],
  [
    "The worker that computes this figure died twice; change a value to try again.",
    "Der Arbeiter, der diese Abbildung berechnet, fiel zweimal aus; ändern Sie einen Wert, um es wieder zu versuchen.",
  ],
  [
    "No worker comes up here, as where a policy of the page forbids them, so the figure stands still.",
    "Hier startet kein Arbeiter, etwa weil eine Vorschrift der Seite es verbietet; deshalb steht die Abbildung still.",
  ],
  ["torus", "Torus"],
  ["isolated torus", "einzelner Torus"],
  ["the motion escapes", "die Bewegung entkommt"],
  ["the motion does not settle on a closed curve", "die Bewegung beruhigt sich nicht auf einer geschlossenen Kurve"],
  ["without damping quasi-periodic motions come in families", "ohne Dämpfung treten quasiperiodische Bewegungen in Familien auf"],
  ["isolated state of rest", "einzelner Ruhezustand"],
  [
    "without load the pair rests at every u from -1 to 1; give a load or a state to start from",
    "ohne Last ruht das Paar bei jedem u von −1 bis 1; geben Sie eine Last oder einen Anfangszustand an",
  ],
  ["isolated orbit to start from", "einzelne Bahn, um von ihr auszugehen"],
  [
    "one with a multiplier of 1, as of teeth that never touch, where u drifts freely",
    "eine mit einem Multiplikator von 1, wie von Zähnen, die sich nie berühren, wo u frei treibt",
  ],
  ["orbit that can be followed", "Bahn, der sich folgen lässt"],
  [
    "motions near the one found are {1} times as far from it a period later",
    "Bewegungen nahe der gefundenen sind eine Periode später {1}-mal so weit von ihr entfernt",
  ],
  ["orbit of this period", "Bahn dieser Periode"],
  ["the search came to one of period {1} and not {2}", "die Suche kam zu einer der Periode {1} und nicht {2}"],
];
