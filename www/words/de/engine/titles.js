/** Titel und Bildunterschriften der Abbildungen, Bedeutungen der Parameter. */

/** @type {import("../../engine.js").Patterns} */
export const titles = [
  ["Pinion and gear on their supports", "Ritzel und Rad auf ihren Lagern"],
  ["Determinants in the tongue of the second mode", "Determinanten in der Zunge der zweiten Mode"],
  ["Pitchforks in the tongue of the second mode", "Gabelverzweigungen in der Zunge der zweiten Mode"],
  ["Determinants in the tongue of the third mode", "Determinanten in der Zunge der dritten Mode"],
  ["Pitchforks in the tongue of the third mode", "Gabelverzweigungen in der Zunge der dritten Mode"],
  ["Eigenvalues at the origin in the combination tongue", "Eigenwerte am Ursprung in der Kombinationszunge"],
  ["Hopf bifurcations in the combination tongue", "Hopf-Verzweigungen in der Kombinationszunge"],
  ["Eigenvalues of the origin across three tongues", "Eigenwerte des Ursprungs quer durch drei Zungen"],
  ["The whole diagram, hardening supports", "Das ganze Diagramm, verhärtende Lager"],
  ["The whole diagram, softening supports", "Das ganze Diagramm, erweichende Lager"],
  ["Stroboscopic map, second mode's tongue, Ω = {1}", "Stroboskopische Abbildung, Zunge der zweiten Mode, Ω = {1}"],
  ["Stroboscopic map, combination tongue, Ω = {1}", "Stroboskopische Abbildung, Kombinationszunge, Ω = {1}"],
  ["Stroboscopic map, third mode's tongue, Ω = {1}", "Stroboskopische Abbildung, Zunge der dritten Mode, Ω = {1}"],
  ["Time response, linear supports", "Verlauf in der Zeit, lineare Lager"],
  ["Time response, softening supports", "Verlauf in der Zeit, erweichende Lager"],
  ["Tongues of instability", "Zungen der Instabilität"],
  ["All branches, exact", "Alle Zweige, exakt"],
  ["Multipliers beside the unit circle", "Multiplikatoren beim Einheitskreis"],
  ["Raised and lowered", "Gehoben und gesenkt"],
  ["The least load that keeps the teeth together", "Die kleinste Last, die die Zähne beisammen hält"],
  ["Which start goes where", "Welcher Anfang wohin führt"],
  ["What the paper prints, and what is so", "Was der Aufsatz druckt, und was ist"],
  [
    "Both bodies slide along the line of action on a spring, cubic as well as linear, and a damper; the teeth join them by the pulsating stiffness *k*(*t*), while they touch. The bodies move with a computed response of the full model with its dead zone; displacements are exaggerated by the factor shown.",
    "Beide Körper gleiten entlang der Eingriffslinie, jeder auf einer Feder mit linearem und kubischem Teil und einem Dämpfer; solange die Zähne sich berühren, verbindet sie die pulsierende Steifigkeit *k*(*t*). Die Bewegung ist eine berechnete Antwort des vollen Modells mit seinem toten Bereich; die Verschiebungen sind um den angegebenen Faktor übertrieben.",
  ],
  [
    "Determinant of the slow flow's Jacobian at its equilibria, (68)–(70): above zero a centre, below zero a saddle. The stars at *Ω*_{L} and *Ω*_{R} mark the pitchforks, where two of the curves meet on the axis; the blue dots are the exact edges, with damping and without.",
    "Determinante der Jacobi-Matrix des langsamen Flusses an seinen Ruhepunkten, (68)–(70): über null ein Zentrum, unter null ein Sattel. Die Sterne bei *Ω*_{L} und *Ω*_{R} sind die Gabelverzweigungen, wo zwei der Kurven auf der Achse zusammentreffen; die blauen Punkte sind die exakten Ränder, mit Dämpfung und ohne.",
  ],
  [
    "Amplitude *R*_{B} of the second mode over the detuning *Ω*_{1} = (*Ω* − *Ω*_{0})/*k*_{0}, for hardening (+*α*) and softening (−*α*) supports, as a plane diagram and in space. Grey: the paper's (62)–(64), without damping; green: with damping; blue and vermilion: exact. Solid is stable, dashed unstable; the green star is a supercritical pitchfork, the yellow star a subcritical one.",
    "Amplitude *R*_{B} der zweiten Mode über der Verstimmung *Ω*_{1} = (*Ω* − *Ω*_{0})/*k*_{0}, für verhärtende (+*α*) und erweichende (−*α*) Lager, eben und im Raum. Grau: (62)–(64) des Aufsatzes, ohne Dämpfung; grün: mit Dämpfung; blau und zinnober: exakt. Durchgezogen ist stabil, gestrichelt instabil; der grüne Stern ist eine superkritische Gabelverzweigung, der gelbe eine subkritische.",
  ],
  [
    "The same as figure 2 for the third mode, (92)–(94): the Jacobian's determinant at the equilibria over *Ω*_{1}, with the pitchforks at *Ω*_{L} and *Ω*_{R}.",
    "Wie Abbildung 2, für die dritte Mode, (92)–(94): die Determinante der Jacobi-Matrix an den Ruhepunkten über *Ω*_{1}, mit den Gabelverzweigungen bei *Ω*_{L} und *Ω*_{R}.",
  ],
  [
    "The same as figure 3 for the third mode: amplitude *R*_{C} over *Ω*_{1} for hardening and softening supports. Grey: the paper's (87)–(89), without damping; green: with damping, which narrows this tongue by much more; blue and vermilion: exact.",
    "Wie Abbildung 3, für die dritte Mode: Amplitude *R*_{C} über *Ω*_{1} für verhärtende und erweichende Lager. Grau: (87)–(89) des Aufsatzes, ohne Dämpfung; grün: mit Dämpfung, die diese Zunge viel stärker verengt; blau und zinnober: exakt.",
  ],
  [
    "Real and imaginary parts of the slow flow's four eigenvalues at the origin over *Ω*_{1}. Grey: (111) as printed, on the paper's scale; thin green: with the time scale of each mode, so that they are growth rates; bold green: with damping as well. Stars mark the Hopf points of each. Blue and vermilion: exact, from the multipliers; diamonds: the exact edges.",
    "Real- und Imaginärteile der vier Eigenwerte des langsamen Flusses am Ursprung über *Ω*_{1}. Grau: (111) wie gedruckt, auf der Skala des Aufsatzes; dünn grün: mit der Zeitskala jeder Mode, so dass sie Wachstumsraten sind; fett grün: dazu mit Dämpfung. Sterne sind jeweils die Hopf-Punkte. Blau und zinnober: exakt, aus den Multiplikatoren; Rauten: die exakten Ränder.",
  ],
  [
    "Radii *R*_{B} and *R*_{C} of the limit cycles over *Ω*_{1}, for hardening and softening supports, and the cycles in space. With damping (green) a stable cycle is born at the supercritical edge and goes on beyond the other edge, where an unstable one is born. Grey: the nontrivial solutions of (106)–(109) as printed; blue: exact tori.",
    "Radien *R*_{B} und *R*_{C} der Grenzzyklen über *Ω*_{1}, für verhärtende und erweichende Lager, und die Zyklen im Raum. Mit Dämpfung (grün) entsteht am superkritischen Rand ein stabiler Zyklus und geht über den anderen Rand hinaus, an dem ein instabiler entsteht. Grau: die nichttrivialen Lösungen von (106)–(109) wie gedruckt; blau: exakte Tori.",
  ],
  [
    "(a), (b) Characteristic exponents of the origin as *Ω* runs from the second mode's tongue through the combination tongue to the third mode's, seen in a frame that turns with *Ω*/2. Blue and vermilion: exact, ln(multiplier)/*T*; green: slow flow of each tongue. The ring marks the present *Ω*. (c) What kind of point the origin is along *Ω*.",
    "(a), (b) Charakteristische Exponenten des Ursprungs, während *Ω* von der Zunge der zweiten Mode durch die Kombinationszunge zu der der dritten läuft, gesehen in einem Bezugssystem, das sich mit *Ω*/2 dreht. Blau und zinnober: exakt, ln(Multiplikator)/*T*; grün: langsamer Fluss jeder Zunge. Der Ring steht beim gegenwärtigen *Ω*. (c) Was für ein Punkt der Ursprung entlang *Ω* ist.",
  ],
  [
    "All first-order branches over *Ω*, hardening supports (+*α*): the pitchforks of the second and third modes and the limit cycles between them. Grey: as printed, undamped; green: corrected, with damping; blue and vermilion: exact, as half of the greatest |*u*_{p}|, which for a torus is both radii together.",
    "Alle Zweige erster Ordnung über *Ω*, verhärtende Lager (+*α*): die Gabeln der zweiten und der dritten Mode und dazwischen die Grenzzyklen. Grau: wie gedruckt, ungedämpft; grün: berichtigt, mit Dämpfung; blau und zinnober: exakt, als Hälfte des größten |*u*_{p}|, die bei einem Torus beide Radien zusammen sind.",
  ],
  [
    "The same as figure 9 for softening supports (−*α*): every branch leans to lower *Ω*, and the supercritical edge of each tongue is the right one.",
    "Wie Abbildung 9, für erweichende Lager (−*α*): Jeder Zweig neigt sich zu kleinerem *Ω*, und der superkritische Rand jeder Zunge ist der rechte.",
  ],
  [
    "The motion looked at once every mesh period, *T* = 2π/*Ω*, at cos *Ωt* = 1. Starts near the origin leave it along its unstable direction, change sides with every period, and end in the two nodes, which are the two points of one motion of period 2*T*. Thin lines join every second point.",
    "Die Bewegung, einmal in jeder Eingriffsperiode *T* = 2π/*Ω* angesehen, bei cos *Ωt* = 1. Was nahe am Ursprung beginnt, verlässt ihn in seiner instabilen Richtung, wechselt mit jeder Periode die Seite und endet in den beiden Knoten, den zwei Punkten einer Bewegung der Periode 2*T*. Dünne Linien verbinden jeden zweiten Punkt.",
  ],
  [
    "The motion looked at once every mesh period, *T* = 2π/*Ω*. The origin is an unstable spiral; what leaves it (light) winds onto a closed curve (dark): a motion of two frequencies, the limit cycle of the slow flow, whose size shrinks as *Ω* nears the tongue's right edge.",
    "Die Bewegung, einmal in jeder Eingriffsperiode *T* = 2π/*Ω* angesehen. Der Ursprung ist ein instabiler Strudel; was ihn verlässt (hell), windet sich auf eine geschlossene Kurve (dunkel): eine Bewegung mit zwei Frequenzen, der Grenzzyklus des langsamen Flusses, der kleiner wird, je näher *Ω* dem rechten Rand der Zunge kommt.",
  ],
  [
    "Transmission error *u* from rest at (0, 0, 1), in the second mode's tongue, supports without cubic part. Dashed: permanent contact (25), as in the paper, which grows without bound; blue: with the dead zone of (23), which settles on a bounded motion that loses contact. Light red: the dead zone.",
    "Übertragungsfehler *u* aus der Ruhe bei (0, 0, 1), in der Zunge der zweiten Mode, Lager ohne kubischen Teil. Gestrichelt: dauernder Kontakt (25) wie im Aufsatz, unbegrenzt wachsend; blau: mit dem toten Bereich von (23), auf einer beschränkten Bewegung, die den Kontakt verliert. Hellrot: der tote Bereich.",
  ],
  [
    "The same as figure 14 a with softening supports: the motion stays bounded and clear of the dead zone, so that both regimes agree.",
    "Wie Abbildung 14 a mit erweichenden Lagern: Die Bewegung bleibt beschränkt und außerhalb des toten Bereichs, so dass beide Regime übereinstimmen.",
  ],
  [
    "Where rest is unstable, over mesh frequency and depth of the pulsation. Colour: the exact growth rate; white: stable. Blue: exact boundaries, where a multiplier passes −1 (plain) or a pair leaves the unit circle (small circles). Grey: the paper’s first order; green: first order with damping. The ring is the present *Ω* and *k*_{0}: drag it. Of a loaded pair with cubic supports it is the response to the load whose growth is shown.",
    "Wo die Ruhe instabil ist, über Eingriffsfrequenz und Tiefe des Pulses. Farbe: die exakte Wachstumsrate; weiß: stabil. Blau: exakte Ränder, an denen ein Multiplikator durch −1 geht (einfach) oder ein Paar den Einheitskreis verlässt (kleine Kreise). Grau: erste Ordnung des Aufsatzes; grün: erste Ordnung mit Dämpfung. Der Ring ist das gegenwärtige *Ω* und *k*_{0}: Ziehen Sie ihn. Bei einem belasteten Paar mit kubischen Lagern ist es die Antwort auf die Last, deren Wachstum gezeigt wird.",
  ],
  [
    "Every periodic motion that can be reached from rest by bifurcations, up to period 4*T*, followed without a guess, as greatest |*u*_{p}| over *Ω*; and the tori of the combination tongue (small circles). Blue is stable, vermilion dashed unstable. Green: the theory. Each bifurcation has its mark and its name.",
    "Jede periodische Bewegung, zu der Verzweigungen von der Ruhe aus führen, bis zur Periode 4*T*, ohne Vermutung verfolgt, als größtes |*u*_{p}| über *Ω*; und die Tori der Kombinationszunge (kleine Kreise). Blau ist stabil, zinnober gestrichelt instabil. Grün: die Theorie. Jede Verzweigung hat ihr Zeichen und ihren Namen.",
  ],
  [
    "By what factors small deviations change in one mesh period: the six Floquet multipliers at the present *Ω* (rings), the way they take as *Ω* changes by 15 per cent to either side, and their magnitudes over all of *Ω*. Outside of the unit circle, or above one, a deviation grows: through −1 at the edges of the primary tongues, as a pair at those of the combination tongue.",
    "Um welche Faktoren sich kleine Abweichungen in einer Eingriffsperiode ändern: die sechs Floquet-Multiplikatoren beim gegenwärtigen *Ω* (Ringe), ihr Weg, wenn *Ω* sich um 15 Prozent nach beiden Seiten ändert, und ihre Beträge über dem ganzen *Ω*. Außerhalb des Einheitskreises, oder über eins, wächst eine Abweichung: durch −1 an den Rändern der Hauptzungen, als Paar an denen der Kombinationszunge.",
  ],
  [
    "No theory, only patience: *Ω* is raised in small steps and the pair is given time to settle at each, then lowered again. Dots are its positions once a mesh period. Where blue and dark dots differ, what the pair does depends on where it comes from.",
    "Keine Theorie, nur Geduld: *Ω* wird in kleinen Schritten gehoben, und bei jedem hat das Paar Zeit, sich zu beruhigen; dann wird es wieder gesenkt. Punkte sind seine Lagen, einmal in jeder Eingriffsperiode. Wo blaue und dunkle Punkte sich unterscheiden, hängt das, was das Paar tut, davon ab, woher es kommt.",
  ],
  [
    "Left: the smallest mean load *F* under which the steady response is stable and its teeth never part, over *Ω*; in the bands no load helps. Right: one period of the response at the ring, with its least *u*. Drag the ring to change *Ω* and *F*.",
    "Links: die kleinste mittlere Last *F*, unter der die stationäre Antwort stabil ist und ihre Zähne sich nie trennen, über *Ω*; in den Bändern hilft keine Last. Rechts: eine Periode der Antwort am Ring, mit ihrem kleinsten *u*. Ziehen Sie den Ring, um *Ω* und *F* zu ändern.",
  ],
  [
    "Each point is a start, pinion and gear opposed, the transmission error at rest. Its colour says where the motion ends: at which point of which attractor it is at the flash, or that it escapes (grey). The picture grows finer as it is computed.",
    "Jeder Punkt ist ein Anfang, Ritzel und Rad einander entgegen, der Übertragungsfehler in Ruhe. Seine Farbe sagt, wo die Bewegung endet: an welchem Punkt welches Attraktors sie beim Blitz ist, oder dass sie entkommt (grau). Das Bild wird feiner, während es berechnet wird.",
  ],
  [
    "Line by line: where it stands, what is printed, what it should be, and what the exact system says, computed as the page loads. The drawing shows the numbers among them: how far the printed one (grey) and the corrected one (green) are off the exact one.",
    "Zeile für Zeile: wo es steht, was gedruckt ist, was es sein sollte, und was das exakte System sagt, berechnet, während die Seite lädt. Die Zeichnung zeigt die Zahlen darunter: wie weit die gedruckte (grau) und die berichtigte (grün) von der exakten entfernt sind.",
  ],
  ["mass of each gear body over the equivalent mass", "Masse jedes Körpers über der gleichwertigen Masse"],
  ["stiffness of each support over the mean mesh stiffness", "Steifigkeit jedes Lagers über der mittleren Eingriffssteifigkeit"],
  ["cubic stiffness of each support: above zero hardening, below zero softening", "kubische Steifigkeit jedes Lagers: über null verhärtend, unter null erweichend"],
  ["damping ratio of each support; without a value of its own, that of the mesh", "Dämpfungsgrad jedes Lagers; ohne eigenen Wert der des Eingriffs"],
  ["mass of the pinion's body over the equivalent mass", "Masse des Ritzels über der gleichwertigen Masse"],
  ["mass of the gear's body over the equivalent mass", "Masse des Rads über der gleichwertigen Masse"],
  ["stiffness of the pinion's support over the mean mesh stiffness", "Steifigkeit des Ritzellagers über der mittleren Eingriffssteifigkeit"],
  ["stiffness of the gear's support over the mean mesh stiffness", "Steifigkeit des Radlagers über der mittleren Eingriffssteifigkeit"],
  ["cubic stiffness of the pinion's support: above zero hardening, below zero softening", "kubische Steifigkeit des Ritzellagers: über null verhärtend, unter null erweichend"],
  ["cubic stiffness of the gear's support: above zero hardening, below zero softening", "kubische Steifigkeit des Radlagers: über null verhärtend, unter null erweichend"],
  ["damping ratio of the mesh", "Dämpfungsgrad des Eingriffs"],
  ["damping ratio of the pinion's support", "Dämpfungsgrad des Ritzellagers"],
  ["damping ratio of the gear's support", "Dämpfungsgrad des Radlagers"],
  ["depth of the mesh stiffness's pulsation, the paper's epsilon", "Tiefe des Pulses der Eingriffssteifigkeit, das Epsilon des Aufsatzes"],
  ["mesh frequency over the natural frequency of the mesh", "Eingriffsfrequenz über der Eigenfrequenz des Eingriffs"],
  ["mean force transmitted through the teeth", "mittlere Kraft durch die Zähne"],
  ["amplitude of the pinion's torque fluctuation, as a force", "Amplitude der Drehmomentschwankung am Ritzel, als Kraft"],
  ["amplitude of the gear's torque fluctuation, as a force", "Amplitude der Drehmomentschwankung am Rad, als Kraft"],
  ["amplitude of the static transmission error over half the backlash", "Amplitude des statischen Übertragungsfehlers über dem halben Spiel"],
  ["frequency of the pinion's torque fluctuation", "Frequenz der Drehmomentschwankung am Ritzel"],
  ["frequency of the gear's torque fluctuation", "Frequenz der Drehmomentschwankung am Rad"],
  [
    "what the tooth force follows: the deviation alone (homogeneous), the teeth always in contact (contact), or contact and separation (backlash)",
    "wem die Zahnkraft folgt: der Abweichung allein (homogeneous), den Zähnen in dauerndem Kontakt (contact), oder Kontakt und Trennung (backlash)",
  ],
];
