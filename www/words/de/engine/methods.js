/** Wie gerechnet wurde. */

/** @type {import("../../engine.js").Patterns} */
export const methods = [
  ["{1}; exact: {2}", "{1}; exakt: {2}"],
  ["field: {1}; boundaries: {2}", "Feld: {1}; Ränder: {2}"],
  ["contact: {1}; backlash: {2}", "Kontakt: {1}; Spiel: {2}"],
  ["exact: {1}; slow flow: {2}", "exakt: {1}; langsamer Fluss: {2}"],
  ["exact: {1}; theory: {2}", "exakt: {1}; Theorie: {2}"],
  [
    "Taylor series from period to period to {1}; multipliers and orbits by the variational equations",
    "Taylorreihen von Periode zu Periode auf {1}; Multiplikatoren und Bahnen aus den Variationsgleichungen",
  ],
  [
    "Taylor series from period to period; orbits by Newton's method, decided in a neighbourhood that the map contracts",
    "Taylorreihen von Periode zu Periode; Bahnen nach dem Newton-Verfahren, entschieden in einer Umgebung, die die Abbildung zusammenzieht",
  ],
  ["Taylor series of order {1}, {2} steps", "Taylorreihe der Ordnung {1}, {2} Schritte"],
  ["Taylor series of order {1} on half a period, QR", "Taylorreihe der Ordnung {1} auf einer halben Periode, QR"],
  [
    "Taylor series; {1} mesh periods left out at each of {2} frequencies, then {3} points, the state carried over",
    "Taylorreihen; {1} Eingriffsperioden ausgelassen bei jeder von {2} Frequenzen, dann {3} Punkte, der Zustand mitgenommen",
  ],
  ["closed formulas (110), (111); [T4], [T6] with averaging", "geschlossene Formeln (110), (111); [T4], [T6] mit Mittelung"],
  [
    "closed formulas (63), (64), (88), (89) and (106)-(109) as printed; with damping [T5]-[T8]",
    "geschlossene Formeln (63), (64), (88), (89) und (106)–(109) wie gedruckt; mit Dämpfung [T5]–[T8]",
  ],
  ["closed formulas {1} as printed; with damping [T5], [T7]", "geschlossene Formeln {1} wie gedruckt; mit Dämpfung [T5], [T7]"],
  ["closed formulas [T5], [T6]", "geschlossene Formeln [T5], [T6]"],
  [
    "closed formulas {1}; exact edges: zeros of the characteristic polynomial's conditions, to {2}",
    "geschlossene Formeln {1}; exakte Ränder: Nullstellen der Bedingungen des charakteristischen Polynoms, auf {2}",
  ],
  ["formulas as printed and corrected", "Formeln wie gedruckt und berichtigt"],
  ["Floquet theory, periodic orbits and integration to {1}", "Floquet-Theorie, periodische Bahnen und Integration auf {1}"],
  ["nontrivial solutions of (106)-(109) as printed; with damping [T6], [T8]", "nichttriviale Lösungen von (106)–(109) wie gedruckt; mit Dämpfung [T6], [T8]"],
  [
    "tori by collocation of the stroboscopic map, radii as square root of twice the mean square of each modal coordinate",
    "Tori durch Kollokation der stroboskopischen Abbildung, Radien als Wurzel aus dem doppelten mittleren Quadrat jeder Modalkoordinate",
  ],
  [
    "continuation of the stroboscopic map, amplitude of the mode at half the mesh frequency",
    "Fortsetzung der stroboskopischen Abbildung, Amplitude der Mode bei der halben Eingriffsfrequenz",
  ],
  [
    "continuation of the stroboscopic map, tori by collocation, drawn as half of the greatest |u_p|",
    "Fortsetzung der stroboskopischen Abbildung, Tori durch Kollokation, gezeichnet als Hälfte des größten |u_p|",
  ],
  [
    "weighted Birkhoff averages along a long motion, the circle by its Fourier series",
    "gewichtete Birkhoff-Mittel entlang einer langen Bewegung, der Kreis durch seine Fourierreihe",
  ],
  [
    "ln(multiplier)/T of the variational flow, in the frame in which each mode turns",
    "ln(Multiplikator)/T des Variationsflusses, im Bezugssystem, in dem jede Mode sich dreht",
  ],
  ["Newton's method on the stroboscopic map, variational Taylor series", "Newton-Verfahren an der stroboskopischen Abbildung, Taylorreihen der Variationsgleichungen"],
  ["multiple shooting in {1} parts, variational Taylor series", "Mehrfachschießen in {1} Teilen, Taylorreihen der Variationsgleichungen"],
  [
    "collocation of {1} Fourier nodes on the stroboscopic map, variational Taylor series",
    "Kollokation von {1} Fourier-Knoten auf der stroboskopischen Abbildung, Taylorreihen der Variationsgleichungen",
  ],
  [
    "pseudo-arclength continuation of the stroboscopic map, switching at bifurcations, tori by collocation",
    "Bogenlängenfortsetzung der stroboskopischen Abbildung, Umschalten an Verzweigungen, Tori durch Kollokation",
  ],
  ["[T7], [T8] with damping", "[T7], [T8] mit Dämpfung"],
  [
    "Chebyshev interpolation of the characteristic polynomial, Taylor series of order {1} on half a period",
    "Tschebyscheff-Interpolation des charakteristischen Polynoms, Taylorreihe der Ordnung {1} auf einer halben Periode",
  ],
  [
    "characteristic polynomial at every point, Taylor series of order {1} on half a period",
    "charakteristisches Polynom an jedem Punkt, Taylorreihe der Ordnung {1} auf einer halben Periode",
  ],
  [
    "field: periodic response by Newton's method from its neighbours, variational Taylor series; between them the characteristic polynomial's coefficients interpolated along k0",
    "Feld: periodische Antwort nach dem Newton-Verfahren von den Nachbarn aus, Taylorreihen der Variationsgleichungen; dazwischen die Koeffizienten des charakteristischen Polynoms längs k0 interpoliert",
  ],
  ["pseudo-arclength continuation to {1}", "Bogenlängenfortsetzung auf {1}"],
  [
    "periodic response in permanent contact, followed from a large mean load; least u on the Taylor polynomials",
    "periodische Antwort in dauerndem Kontakt, von einer großen mittleren Last aus verfolgt; kleinstes u auf den Taylorpolynomen",
  ],
  ["periodic response in permanent contact, followed from a large load", "periodische Antwort in dauerndem Kontakt, von einer großen Last aus verfolgt"],
  ["[T5], [T6]", "[T5], [T6]"],
  [
    "periodic response in permanent contact, grown with the load; least u on the Taylor polynomials",
    "periodische Antwort in dauerndem Kontakt, mit der Last gewachsen; kleinstes u auf den Taylorpolynomen",
  ],
  [
    "periodic response in permanent contact, from the state given; least u on the Taylor polynomials",
    "periodische Antwort in dauerndem Kontakt, vom gegebenen Zustand aus; kleinstes u auf den Taylorpolynomen",
  ],
];
