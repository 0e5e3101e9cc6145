/** Die Texte der Erzählung, die englisch in index.html stehen, und die Worte ihrer Zeichen und Knöpfe. */

/** @type {import("../say.js").Words} */
export const words = {
  "story.lead":
    "Zwei Zahnräder im Eingriff reichen ihre Last von Zahn zu Zahn weiter. Jede Übergabe macht die Berührung ein wenig steifer oder weicher, und bei bestimmten Drehzahlen nährt dieser Puls eine Schwingung, die nach der linearen Theorie ohne Ende wächst. In wirklichen Getrieben hört sie auf zu wachsen. Diese Seite zeigt, warum.",
  "figure.1": "<0>Abbildung 1.</0> Ritzel und Rad auf ihren Lagern",
  "figure.1.caption":
    "Eine berechnete Antwort des ganzen Modells, die sich mit dem Punkt auf der Karte ändert; solange die Zähne sich berühren, verbindet die pulsierende Steifigkeit <0/>(<1/>) die Körper. Die Verschiebungen sind um den angegebenen Faktor übertrieben.",
  "figure.1.alt": "Skizze zweier Zahnräder im Eingriff, jedes auf einer Feder und einem Dämpfer.",
  "figure.T": "<0>Abbildung T.</0> Zungen der Instabilität",
  "figure.T.caption":
    "Über der Drehzahl <0/> und der Tiefe <1/> des Pulses: Wo die Karte farbig ist, ist die Ruhe instabil. Ziehen Sie den Ring in eine Zunge, und sehen Sie auf die Räder.",
  "figure.T.alt": "Karte dreier großer und mehrerer kleiner Zungen über Eingriffsfrequenz und Tiefe des Pulses.",
  "story.opening.1":
    "Die Seite folgt einem Aufsatz, <0/> (<1/>), und berechnet alle vierzehn seiner Abbildungen, während Sie lesen, aus den Zahlen, die daneben stehen; sieben weitere, mit Buchstaben, gehen über ihn hinaus. Nummern von Gleichungen in runden Klammern sind die des Aufsatzes, die in eckigen unsere eigenen; jede führt zu der Stelle im Programm, an der die Formel berechnet wird. Wo der Aufsatz irrt, sagt eine Notiz am Rand, was gedruckt ist und was richtig ist, und die Abbildung zeichnet beides.",
  "story.contents": "Inhalt",
  "story.key": "Wie die Abbildungen zu lesen sind",
  "story.key.exact-stable": "exakt, stabil",
  "story.key.exact-unstable": "exakt, instabil",
  "story.key.paper": "Formel des Aufsatzes, wie gedruckt",
  "story.key.corrected": "berichtigt, oder mit Dämpfung",
  "story.key.supercritical": "superkritische Verzweigung",
  "story.key.subcritical": "subkritische Verzweigung",
  "story.key.quasi-periodic": "exakt, quasiperiodisch",
  "story.key.fold": "Falte",
  "story.key.torus": "Torusverzweigung",
  "story.key.across": "Verzweigung quer zur Mannigfaltigkeit",
  "story.key.1":
    "Durchgezogen heißt stabil, gestrichelt instabil, in jeder Farbe. Unter jeder Abbildung stehen ihre Parameter: Bewegen Sie einen Regler, oder schreiben Sie eine genaue Zahl in das Feld. Räumliche Ansichten drehen sich, wenn man an ihnen zieht, oder mit den Pfeiltasten.",

  "story.model": "Ein Paar Zahnräder",
  "note.12":
    "<0/> druckt die gleichwertige Masse mit zwei vertauschten Produkten. Aus (3) und (4) folgt 1/<1/> = <2/><3/>/<4/> + <5/><6/>/<7/>; jede Drehzahl und jedes Drehmoment in physikalischen Einheiten hängt davon ab. <8>In Abbildung E nachgemessen</8>.",
  "note.8-9": "<0/> drucken den Dämpfer im Eingriff mit einem Weg; ein Dämpfer antwortet auf eine Geschwindigkeit, wie in (11). <1>In Abbildung E</1>.",
  "note.before-11":
    "<0>Vor (11)</0> zieht der Text (9) von (8) ab, so wie sie dastehen. Jede muss zuvor mit dem eigenen Radius durch die eigene Trägheit malgenommen werden. <1>In Abbildung E</1>.",
  "story.model.1":
    "Ritzel und Rad sind zwei starre Scheiben. Jede dreht sich um ihre Achse, und jede kann ein wenig auf der Linie gleiten, auf der die Zähne drücken, der <0>Eingriffslinie</0>. Gehalten wird sie von einem <1>Lager</1>: einem Dämpfer und einer Feder, deren Kraft neben dem linearen auch einen kubischen Anteil hat. Macht der kubische Anteil die Feder steifer, heißt das Lager <2>verhärtend</2>, <3/> über null; macht er sie nachgiebiger, <4>erweichend</4>. Die Zähne verbinden die Scheiben mit einer eigenen Steifigkeit.",
  "story.model.2":
    "Drei Längen beschreiben alles: die Verschiebungen <0/> und <1/> der beiden Körper und der <2>Übertragungsfehler</2> <3/>, um den die Zähne ineinandergedrückt werden. Misst man die Zeit an der Eigenfrequenz des Eingriffs und Längen in halben <4>Spielen</4>, und sind die Lager gleich <5/>, so gehorchen sie",
  "story.model.3":
    "Die ersten beiden Zeilen sind Newtons Gesetz für je einen Körper entlang der Eingriffslinie; die dritte ist das für die Drehung, beide Scheiben in einem. Ein Punkt bedeutet die Ableitung nach der Zeit. Die Zähne drücken mit der Steifigkeit des Eingriffs mal",
  "note.16": "<0/> lässt <1/>, <2/>, <3/> und <4/> ihre Namen. Sie sind Längen wie die anderen und werden ebenfalls durch <5/> geteilt. <6>In Abbildung E</6>.",
  "note.after-22": "<0>Nach (22)</0> heißt das System konservativ. Es ist gedämpft und angetrieben; gemeint sind die Gleichungen (17)–(19). <1>In Abbildung E</1>.",
  "story.model.4":
    "Die Zähne berühren sich, solange <0/> über 1 liegt, sind im <1>toten Bereich</1> zwischen −1 und 1 getrennt und schlagen unter −1 mit ihren Rückseiten an. Der Aufsatz behandelt Räder unter so viel Last, dass die Zähne sich nie trennen. Dann kann der tote Bereich wegbleiben, und was übrig ist, ist glatt <2/>. Ganz ohne Last gehorcht die Abweichung von der Ruhe demselben System mit leerer rechter Seite, und dieses ist es, von dem die Verzweigungen handeln. Die Seite kennt alle drei als Zustände eines Modells: mit Spiel (<3>backlash</3>), in Berührung (<4>contact</4>) und homogen (<5>homogeneous</5>).",

  "story.pulse": "Eine Steifigkeit, die pulsiert",
  "story.pulse.1":
    "Während die Räder sich drehen, trägt bald ein Zahnpaar die Last, bald tragen sie zwei. Zwei sind steifer als eines, und so springt die Steifigkeit des Eingriffs auf und ab, einmal für jeden Zahn, der vorbeikommt. Das Modell behält von diesen Stufen ihr Mittel und ihre Grundschwingung:",
  "story.pulse.drawing": "Steifigkeit des Eingriffs über der Zeit: Stufen zwischen einem und zwei Zahnpaaren, und der Kosinus, den das Modell davon behält.",
  "story.pulse.caption": "Dünn: die Steifigkeit eines Eingriffs, in dem bald ein Zahnpaar die Last trägt, bald zwei. Fett: was das Modell davon behält.",
  "story.pulse.one": "ein Paar",
  "story.pulse.two": "zwei Paare",
  "story.pulse.mean": "Mittel",
  "note.15": "<0/> hat einen Sinus, wo in (10) und (17) der Kosinus steht. <1>In Abbildung E</1>.",
  "story.pulse.2":
    "<0/> ist die <1>Eingriffsfrequenz</1>: wie rasch ein Zahn auf den anderen folgt, geteilt durch die Eigenfrequenz des Eingriffs. <2/> sagt, wie tief der Puls ist. Niemand schiebt; ein Koeffizient atmet. Ein Kind auf der Schaukel tut dasselbe: Indem es sich bei jedem Schwung zweimal hebt und senkt, lässt es eine kleine Bewegung wachsen, kann aber aus völliger Ruhe keine beginnen. Das ist <3>Parameterresonanz</3>.",
  "note.35-57": "<0/> haben in einem Eintrag das falsche Vorzeichen: Er lautet +<1/><2/><3/><4/> + 1. Nur so sind die Matrizen bei den Frequenzen von (36) singulär. <5>In Abbildung E nachgemessen</5>.",
  "note.41-text": "<0/> soll die Moden bei <1/>\u00a0=\u00a01 voneinander befreien. Der Puls koppelt sie auch dort; die Kombinationszunge bleibt offen. <2>In Abbildung E nachgemessen</2>.",
  "story.pulse.3":
    "Bei gleichen Lagern hat das Paar drei <0>Moden</0>, in denen es schwingen kann. In einer bewegen sich beide Körper gemeinsam, und der Eingriff merkt nichts davon. Die beiden anderen drücken die Zähne, und sie sind es, die ein Puls nähren kann. Ihre Frequenzen sind",
  "story.pulse.4":
    "wobei <0/> = <1/> und <2/> = <3/> sagen, wie stark jede Mode die Zähne drückt <4/>. Für Körper mit <5/>\u00a0=\u00a01 auf Lagern mit <6/>\u00a0=\u00a05 ergibt das <7/>\u00a0=\u00a00,8267 und <8/>\u00a0=\u00a02,7049.",

  "story.tongues": "Zungen",
  "story.tongues.1":
    "Was in einer Eingriffsperiode aus einer kleinen Abweichung von der Ruhe wird, sagen sechs Zahlen: die <0>Multiplikatoren</0>, die Faktoren, um die ihre Anteile wachsen oder schrumpfen. Sind alle dem Betrag nach kleiner als eins, so ist die Ruhe stabil. Ein Puls der richtigen Frequenz treibt einen von ihnen hinaus. Ein Multiplikator <1/> gehört zum Exponenten <2/> durch",
  "figure.M": "<0>Abbildung M.</0> Multiplikatoren am Einheitskreis",
  "figure.M.caption":
    "Links: die sechs Multiplikatoren der Ruhe beim gegenwärtigen <0/> (Ringe) und ihre Wege, wenn <1/> sich um 15 Prozent ändert. Rechts: ihre Beträge über ganz <2/>; über eins wächst eine Abweichung. Die Ringe lassen sich ziehen.",
  "figure.M.alt": "Sechs Multiplikatoren am Einheitskreis und ihre Beträge über der Eingriffsfrequenz.",
  "story.tongues.2":
    "Ein Puls nährt eine Mode am besten, wenn er zweimal in jeder ihrer Schwingungen kommt, und zwei Moden zugleich, wenn er mit der Summe ihrer Frequenzen kommt. Vor drei Drehzahlen muss man sich also hüten:",
  "story.tongues.3":
    "Je tiefer der Puls, desto breiter das Band von Drehzahlen, in dem die Ruhe verloren ist. Über <0/> und <1/> gezeichnet sind die Bänder Keile, die auf diesen drei Punkten stehen; sie heißen <2>Zungen</2>. <3>Abbildung T</3> zeichnet sie: in Farbe die Rate, mit der eine Abweichung wächst; blau die exakten Grenzen, glatt, wo ein Multiplikator durch −1 geht, mit kleinen Kreisen, wo ein Paar den Einheitskreis verlässt; grau die erste Ordnung nach dem Aufsatz, grün die erste Ordnung mit Dämpfung. In erster Ordnung sind ihre Ränder gerade, und quer zu ihnen misst man am natürlichsten mit der <4>Verstimmung</4>",
  "note.105":
    "<0/> gibt der Kombinationszunge hier die halbe Breite 0,4013. Mittelt man mit der eigenen Zeitskala jeder Mode, kommt 0,3564 heraus, und so auch im exakten System, wenn <1/> gegen null geht. <2>In Abbildung E nachgemessen</2>.",
  "story.tongues.4":
    "in der eine Zunge von −<0/> bis <1/> reicht. Die beiden einzelnen Moden haben die halben Breiten <2/>, <3/>, und die Kombination beider hat deren geometrisches Mittel <4/>:",
  "story.tongues.5":
    "Dämpfung hebt die Spitzen von der Achse, denn ein flacher Puls ersetzt nicht mehr, was verloren geht. Mit der <0>Abklingrate</0> <1/> einer Mode ist ihre Zunge",
  "story.tongues.6":
    "Mit der Kombinationszunge <0/> geschieht etwas Seltsameres: Ein wenig Dämpfung macht sie um die Hälfte breiter, denn sie erlaubt den beiden Moden, verschieden stark anzuwachsen. In einem linearen System ist die Geschichte damit zu Ende: In einer Zunge wächst die Bewegung für immer. Die kubischen Lager ändern den Schluss. Während die Bewegung wächst, verschiebt sich ihre Frequenz, bis sie nicht mehr zu dem Puls passt, der sie nährt.",

  "story.pitchfork": "Eine Gabel am Weg",
  "story.pitchfork.1":
    "Nahe ihrer Zunge schwingt die zweite Mode mit der halben Eingriffsfrequenz, und Amplitude und Phase ändern sich langsam. Diese beiden Zahlen gehorchen einem <0>langsamen Fluss</0> <1/>–<2/>, und wo er ruht, schwingen die Räder gleichmäßig. Fünf solche Stellen gibt es: den Ursprung, an dem sich nichts bewegt, und zwei Paare <3/>, <4/>, jedes auf einer Seite eines Randes. Mit Dämpfung sind ihre Amplituden",
  "note.33": "<0/> druckt die Kuben der ganzen Lösung. In dieser Ordnung gehören die ihres ersten Teils hin. <1>In Abbildung E</1>.",
  "note.3-3-figs-7-9":
    "<0>Abb. 3, 5, 7, 9, 10:</0> Der Text lässt den stabilen Ast am zweiten Rand enden. Er geht darüber hinaus weiter; was dort geboren wird, ist der instabile. Zwischen beiden liegt Hysterese. <1>In Abbildung E nachgemessen</1>.",
  "story.pitchfork.2":
    "An einem Rand der Zunge verliert der Ursprung seine Stabilität, und ein Paar gleichmäßiger Schwingungen wird geboren, anfangs klein: eine <0>superkritische</0> <1>Gabelverzweigung</1>. Das neue Paar ist stabil und übernimmt, und das Wachstum, das die lineare Theorie vorhersagt, hört dort auf. Das ist es, was die Verzweigung rettet. Am anderen, dem <2>subkritischen</2> Rand wird der Ursprung wieder stabil, und geboren wird ein instabiles Paar, das die Bewegungen, die zur Ruhe kommen, von denen scheidet, die es nicht tun.",
  "figure.3": "<0>Abbildung 3.</0> Gabelverzweigungen in der Zunge der zweiten Mode",
  "figure.3.caption":
    "Amplitude <0/> über der Verstimmung für verhärtende (+<1/>) und erweichende (−<2/>) Lager, in der Ebene und im Raum. Grau: (62)–(64) des Aufsatzes, ohne Dämpfung. Grün: mit Dämpfung. Der grüne Stern ist eine superkritische Gabelverzweigung, der gelbe eine subkritische. Eine räumliche Ansicht dreht sich, wenn man an ihr zieht.",
  "figure.3.alt": "Diagramme der Gabelverzweigungen für verhärtende und erweichende Lager, in der Ebene und im Raum.",
  "story.pitchfork.3":
    "Verhärtende Lager biegen die Gabel zu höheren Drehzahlen, erweichende zu niedrigeren. Die beiden, die geboren werden, liegen „um <0/> auseinander“: zwei Schwingungen, gleich bis auf das Vorzeichen. Sieht man nur einmal in jeder Eingriffsperiode hin, so sind sie zwei Punkte, zwischen denen eine einzige Bewegung von doppelter Periode hin- und herspringt. Welche der fünf stabil ist, sagt eine Determinante:",
  "note.after-67":
    "<0>Nach (67)</0> soll eine verschwindende Determinante eine Gabelverzweigung bedeuten. Im Allgemeinen bedeutet sie eine Falte. Hier ist es eine Gabel, weil die Gleichungen dieselben bleiben, wenn man die Schwingung umkehrt. <1>In Abbildung E</1>.",
  "figure.2": "<0>Abbildung 2.</0> Determinanten in der Zunge der zweiten Mode",
  "figure.2.caption":
    "Determinante der Jacobi-Matrix des langsamen Flusses, wo er ruht, (68)–(70): über null ein Zentrum, unter null ein Sattel. An den Sternen, <0/> und <1/>, treffen sich zwei der Kurven auf der Achse und tauschen ihr Vorzeichen.",
  "figure.2.alt": "Drei Kurven der Determinante über der Verstimmung, mit zwei Sternen, wo sie sich auf der Achse treffen.",

  "story.third": "Dieselbe Gabel in der dritten Mode",
  "note.90-91": "<0/> haben <1/> mit dem falschen Vorzeichen: Eine Jacobi-Matrix muss die Ableitung von (83) und (84) sein. (92)–(94), die gezeichnet sind, stimmen. <2>In Abbildung E</2>.",
  "story.third.1":
    "Beim Doppelten der dritten Frequenz geschieht alles noch einmal, mit anderen Zahlen <0/>–<1/>. Diese Mode ist dreimal so schnell, und darum ist ihre Zunge die breitere, wenn auch im Verhältnis zur Drehzahl nur halb so breit. Zudem ist sie siebenmal so stark gedämpft. Bei <2/>\u00a0=\u00a00,02 nimmt die Dämpfung der Zunge bei <3/>\u00a0=\u00a00,5 ein Fünftel ihrer Breite, während die der zweiten Mode sich kaum ändert.",
  "figure.5": "<0>Abbildung 5.</0> Gabelverzweigungen in der Zunge der dritten Mode",
  "figure.5.caption": "Wie Abbildung 3, für die dritte Mode. Grau: (87)–(89), ohne Dämpfung; grün: mit Dämpfung, die diese Zunge sichtbar schmäler macht.",
  "figure.5.alt": "Diagramme der Gabelverzweigungen der dritten Mode für verhärtende und erweichende Lager, in der Ebene und im Raum.",
  "figure.4": "<0>Abbildung 4.</0> Determinanten in der Zunge der dritten Mode",
  "figure.4.caption": "Wie Abbildung 2, für die dritte Mode: (92)–(94).",
  "figure.4.alt": "Drei Kurven der Determinante über der Verstimmung, mit zwei Sternen, wo sie sich auf der Achse treffen.",

  "story.hopf": "Zwei Moden zugleich",
  "story.hopf.1":
    "Schlägt der Eingriff mit der Summe zweier Frequenzen, so nährt er beide Moden zusammen. Keine hält eine feste Phase zum Eingriff; nur die Summe ihrer Phasen tut es. Darum wird der Ursprung nicht auf einer Linie verlassen, sondern in einer Spirale, und was am Rand geboren wird, ist kein Paar von Punkten, sondern eine geschlossene Kurve: eine <0>Hopf-Verzweigung</0> und ihr <1>Grenzzyklus</1>. Die Räder bewegen sich dann in zwei Frequenzen ohne gemeinsame Periode, auf einem <2>Torus</2>.",
  "note.110":
    "<0/> nimmt die Eigenwerte einer unskalierten Matrix für Wachstumsraten. Die beiden Zeilen jeder Mode müssen erst mit deren eigener Rate malgenommen werden; dann ist das Wachstum in der Mitte 0,1782 mal <1/>, nicht 0,4013. <2>In Abbildung E nachgemessen</2>.",
  "note.106-109":
    "<0/> sollen keine Lösung außer null haben. Sie haben welche, und diese verlassen den Ursprung bei ±0,4209, was weder (105) ist noch die Wahrheit. Abbildung 7 zeichnet sie grau. <1>In Abbildung E nachgemessen</1>.",
  "figure.7": "<0>Abbildung 7.</0> Hopf-Verzweigungen in der Kombinationszunge",
  "figure.7.caption":
    "Radien <0/> und <1/> der Grenzzyklen, und die Zyklen im Raum. Am superkritischen Rand (grüner Stern) wird ein stabiler Zyklus geboren und geht über den anderen Rand hinaus weiter, an dem ein instabiler geboren wird (gelber Stern).",
  "figure.7.alt": "Radien von Grenzzyklen über der Verstimmung für verhärtende und erweichende Lager, und die Zyklen im Raum.",
  "story.hopf.2":
    "Ohne Dämpfung gäbe es nicht den einen Zyklus: Eine Größe bleibt erhalten, und Zyklen füllen eine ganze Schar. Dämpfung, und sei sie noch so klein, wählt einen davon aus <0/> und legt damit fest, wie die beiden Moden sich die Bewegung teilen,",
  "note.113": "<0/> nennt den Ursprung in der ganzen Zunge einen instabilen Strudel. Genau in ihrer Mitte dreht sich nichts: Dort ist der Imaginärteil von (111) null. <1>In Abbildung E</1>.",
  "note.111-112": "<0/> drucken <1/><2/> statt <3/> und eine Differenz von Quadraten statt ihrer Summe. Nur mit der Summe verschwindet (112) bei (105). <4>In Abbildung E</4>.",
  "story.hopf.3":
    "mit <0/> dafür, wie stark jede Mode von der anderen getrieben wird, und <1/> = <2/>/2, <3/>/2. Was die Gabel für eine Mode tut, tut dieser Zyklus für zwei: Er übernimmt, was die Ruhe verloren hat.",
  "figure.6": "<0>Abbildung 6.</0> Eigenwerte am Ursprung in der Kombinationszunge",
  "figure.6.caption":
    "Real- und Imaginärteile der vier Eigenwerte des langsamen Flusses am Ursprung. Grau: (111) wie gedruckt. Dünn grün: mit der Zeitskala jeder Mode. Fett grün: dazu mit Dämpfung. Sterne bezeichnen die Hopf-Punkte.",
  "figure.6.alt": "Real- und Imaginärteile von vier Eigenwerten über der Verstimmung.",

  "story.origin": "Was aus der Ruhe wird",
  "story.origin.1":
    "Nun steige die Drehzahl langsam durch alle drei Zungen, und wir sehen nur auf den Ursprung. In der Zunge der zweiten Mode weisen zwei reelle Exponenten hinaus und hinein: ein <0>Sattel</0>. Außerhalb der Zungen liegen alle Exponenten auf der imaginären Achse oder, mit Dämpfung, ein wenig links davon. In der Kombinationszunge verlassen zwei komplexe Paare die Achse: ein instabiler <1>Strudel</1>. Dann wieder ein Sattel.",
  "figure.8": "<0>Abbildung 8.</0> Eigenwerte des Ursprungs quer durch drei Zungen",
  "figure.8.caption":
    "(a), (b) Charakteristische Exponenten des Ursprungs, während <0/> von Zunge zu Zunge läuft, gesehen in einem Bezugssystem, das sich mit <1/>/2 dreht: die exakten blau und zinnoberrot, der langsame Fluss jeder Zunge grün. Die Ringe stehen beim gegenwärtigen <2/>. (c) Was für ein Punkt der Ursprung entlang <3/> ist; ziehen Sie den Griff, oder nehmen Sie den Regler.",
  "figure.8.alt": "Charakteristische Exponenten in der komplexen Ebene bei steigender Eingriffsfrequenz, und eine Skala, die sagt, was für ein Punkt der Ursprung ist.",
  "story.origin.2":
    "Die exakten Exponenten verbinden, was die drei einzelnen Näherungen nicht verbinden können: Sie kommen aus dem ganzen periodischen System, über eine Periode integriert.",

  "story.overall": "Das ganze Diagramm",
  "story.overall.1":
    "Nebeneinandergestellt geben die drei Verzweigungen ein Bild davon, was die Räder bei jeder Drehzahl tun. Verhärtende und erweichende Lager geben Spiegelbilder: Die Äste neigen sich zur anderen Seite, und der sanfte und der jähe Rand tauschen die Plätze.",
  "figure.9": "<0>Abbildung 9.</0> Das ganze Diagramm, verhärtende Lager",
  "figure.9.caption":
    "Alle Äste erster Ordnung über <0/> für verhärtende Lager: die Gabeln der zweiten und dritten Mode, dazwischen die Grenzzyklen. Grau: wie gedruckt, ungedämpft. Grün: berichtigt, mit Dämpfung.",
  "figure.9.alt": "Amplituden aller Äste über der Eingriffsfrequenz, nach rechts geneigt.",
  "figure.10": "<0>Abbildung 10.</0> Das ganze Diagramm, erweichende Lager",
  "figure.10.caption": "Wie Abbildung 9, für erweichende Lager: Jeder Ast neigt sich zu kleinerem <0/>, und der superkritische Rand jeder Zunge ist der rechte.",
  "figure.10.alt": "Amplituden aller Äste über der Eingriffsfrequenz, nach links geneigt.",
  "story.overall.2":
    "Man liest ein solches Diagramm wie ein Reisender. Wer von der Seite des grünen Sterns kommt, folgt dem Ast, der aus dem Nichts wächst. Wer von der anderen kommt, bleibt bis zum Rand in Ruhe und muss dann weit springen; auf dem Rückweg kommt der Sprung später. Das ist <0>Hysterese</0>.",

  "story.maps": "Einmal in jeder Periode",
  "note.4-1": "<0/> gibt den Schnitt als <1/> = <2/>/2<3/> an, was keine Zeit ist. Hier wird er alle <4/>\u00a0=\u00a02<5/>/<6/> genommen, wo cos <7/><8/>\u00a0=\u00a01 ist. <9>In Abbildung E nachgemessen</9>.",
  "note.figs-12-13": "<0>Abb. 12, 13:</0> Die Bildunterschriften fehlen in der vorliegenden Kopie. Die Werte sind unsere und geben wieder, was der Text über die Abbildungen sagt. <1>In Abbildung E</1>.",
  "story.maps.1":
    "Bisher war alles Theorie erster Ordnung. Die nächsten Abbildungen fragen die Gleichungen selbst. Ein Lichtblitz einmal in jeder Eingriffsperiode zeigt die Räder an einem Punkt der Ebene, in der sie sich bewegen, und die Punkte vieler Blitze ergeben eine <0>stroboskopische Abbildung</0>. Eine Bewegung von der Periode des Eingriffs ist darin ein Punkt, eine von doppelter Periode zwei, und eine auf einem Torus füllt eine geschlossene Kurve. Die Lager erweichen, <1/>\u00a0=\u00a0−0,2, und der Puls ist tief, <2/>\u00a0=\u00a00,5.",
  "figure.11": "<0>Abbildung 11.</0> Stroboskopische Abbildungen in der Zunge der zweiten Mode",
  "figure.11.caption":
    "Was nahe dem Sattel (rot) beginnt, verlässt ihn in seiner instabilen Richtung und endet in den beiden Knoten, die eine Bewegung der Periode 2<0/> sind. Steigt <1/> zum Rand der Zunge, so rücken sie zum Ursprung. Dünne Linien verbinden jeden zweiten Punkt.",
  "figure.11a.alt": "Abbildung mit einem Sattel im Ursprung und zwei Knoten.",
  "figure.11b.alt": "Abbildung mit einem Sattel im Ursprung und zwei Knoten, näher an ihm.",
  "figure.11c.alt": "Abbildung mit einem Sattel im Ursprung und zwei Knoten, noch näher.",
  "figure.12": "<0>Abbildung 12.</0> Stroboskopische Abbildungen in der Kombinationszunge",
  "figure.12.caption":
    "Der Ursprung ist ein instabiler Strudel (orange). Was ihn verlässt (hell), windet sich auf eine geschlossene Kurve (dunkel): eine Bewegung von zwei Frequenzen, auf einem Torus. Sie schrumpft, wenn <0/> sich dem rechten Rand der Zunge nähert.",
  "figure.12a.alt": "Abbildung mit einem instabilen Strudel im Ursprung und einer geschlossenen Kurve um ihn.",
  "figure.12b.alt": "Abbildung mit einem instabilen Strudel im Ursprung und einer kleineren geschlossenen Kurve.",
  "figure.12c.alt": "Abbildung mit einem instabilen Strudel im Ursprung und der kleinsten geschlossenen Kurve.",
  "figure.13": "<0>Abbildung 13.</0> Stroboskopische Abbildungen in der Zunge der dritten Mode",
  "figure.13.caption": "Wie Abbildung 11, in der Zunge der dritten Mode.",
  "figure.13a.alt": "Abbildung mit einem Sattel im Ursprung und zwei Knoten.",
  "figure.13b.alt": "Abbildung mit einem Sattel im Ursprung und zwei Knoten, näher an ihm.",
  "figure.13c.alt": "Abbildung mit einem Sattel im Ursprung und zwei Knoten, noch näher.",
  "story.maps.2":
    "Die Gestalten sind die der Theorie; die Größen sind es nicht ganz. Ohne Dämpfung reicht die Zunge der zweiten Mode bei <0/>\u00a0=\u00a00,5 von 1,4565 bis 1,6936, während die erste Ordnung 1,5188 bis 1,7878 sagt.",

  "story.exact": "Jenseits der ersten Ordnung",
  "story.exact.1":
    "Wie weit kann man einer Theorie trauen, die den Puls für klein nimmt? Hier ist ihr Richter. Von der Ruhe ausgehend verfolgt die Seite durch <0>Fortsetzung</0> jede periodische Bewegung, zu der eine Verzweigung führt, liest an ihren Multiplikatoren ab, ob sie stabil ist, und biegt ab, wo die nächste geboren wird.",
  "figure.B": "<0>Abbildung B.</0> Alle Äste, exakt",
  "figure.B.caption":
    "Jede periodische Bewegung bis zur Periode 4<0/>, zu der Verzweigungen aus der Ruhe führen, als größtes |<1/>| über <2/>, und die Tori der Kombinationszunge (kleine Kreise). Blau ist stabil, zinnoberrot instabil; grün ist die Theorie. Sterne, Dreiecke, Rauten und Kreuze sind Verzweigungen.",
  "figure.B.alt": "Amplituden aller exakten Äste über der Eingriffsfrequenz, mit jeder Verzweigung bezeichnet.",
  "note.5-text": "<0>5, Text:</0> Nur in drei Zungen sollen Bewegungen unbeschränkt wachsen. Es gibt weitere, etwa um <1/> und <2/>; schwache Dämpfung schließt die meisten. <3>In Abbildung E nachgemessen</3>.",
  "story.exact.2":
    "In der Zunge der dritten Mode ist die Theorie kaum von der Wahrheit zu unterscheiden, und die stabile Bewegung lebt bis hinab zu <0/>\u00a0=\u00a04,6122, weit außerhalb der Zunge. In der der zweiten ist sie zweimal zu groß, und die stabile Bewegung ist bald verloren: unter 1,6197, an einer Torusverzweigung, die keine Theorie einer einzelnen Mode kennt. Die Gabel rettet die Räder also nur in einem Teil der Zunge.",
  "figure.S": "<0>Abbildung S.</0> Hinauf und hinab",
  "figure.S.caption":
    "Keine Theorie, nur Geduld: <0/> wird in kleinen Schritten erhöht, bei jedem mit Zeit, sich einzuschwingen, und wieder gesenkt. Wo die Punkte in Blau (hinauf) und Dunkel (hinab) sich unterscheiden, hängt das, was das Paar tut, davon ab, woher es kommt.",
  "figure.S.alt": "Stroboskopische Lagen, während die Eingriffsfrequenz erhöht und gesenkt wird; neben den Zungen unterscheiden sie sich.",
  "story.exact.3":
    "Und wo zweierlei möglich ist, entscheidet der Anfang. Erweichende Lager haben eine Schwelle: Wer darüber gestoßen wird, kommt nicht zurück. Die Seite nennt das ein Entkommen und sagt, wann es geschieht.",
  "figure.A": "<0>Abbildung A.</0> Welcher Anfang wohin führt",
  "figure.A.caption":
    "Jeder Punkt ist ein Anfang: Ritzel und Rad entgegengesetzt, der Übertragungsfehler in Ruhe. Seine Farbe sagt, an welchem Punkt der Bewegung von Periode 2<0/> man das Paar am Ende beim Blitz findet; graue Anfänge entkommen über die Schwelle der Erweichung. Alle Anfänge einer Farbe zusammen sind ein <1>Einzugsgebiet</1>.",
  "figure.A.alt": "Ebene der Anfänge in zwei verschränkten Farben, umgeben von Anfängen, die entkommen.",

  "story.load": "Die Last, die die Zähne beisammenhält",
  "note.fig-14-a":
    "<0>Abb. 14 a</0> heißt unbeschränkt. Das ist sie nur, solange die Zähne sich nicht trennen dürfen. Mit dem toten Bereich von (23) kommt die Bewegung zwischen <1/>\u00a0=\u00a0−0,4539 und 4,9618 zur Ruhe, und die Zähne trennen und treffen sich immer wieder. <2>In Abbildung E nachgemessen</2>.",
  "story.load.1":
    "Zuletzt tun die Räder ihre Arbeit: Eine stetige Last <0/>\u00a0=\u00a01,5 drückt die Zähne zusammen, bei einer Drehzahl in der Zunge der zweiten Mode. Mit linearen Lagern wächst die Schwingung, bis sie in den toten Bereich gerät, und von da an ist die ständige Berührung eine Annahme, die versagt hat. Mit erweichenden Lagern schwingt sie sich ein, fern vom toten Bereich, und die Annahme hält. Die ganze Zeit muss gelten",
  "figure.14a": "<0>Abbildung 14 a.</0> Zeitverlauf, lineare Lager",
  "figure.14a.caption":
    "Übertragungsfehler <0/> aus der Ruhe bei (0, 0, 1), ohne kubischen Anteil. Gestrichelt: dauernder Kontakt (25), wie im Aufsatz. Blau: mit dem toten Bereich von (23), hellrot.",
  "figure.14a.alt": "Übertragungsfehler über der Zeit, wachsend, bis er in den toten Bereich gerät.",
  "figure.14b": "<0>Abbildung 14 b.</0> Zeitverlauf, erweichende Lager",
  "figure.14b.caption": "Dasselbe mit <0/>\u00a0=\u00a0−1,3. Die Bewegung bleibt zwischen 2,2497 und 2,8431, sodass beide Annahmen dasselbe ergeben.",
  "figure.14b.alt": "Übertragungsfehler über der Zeit, beschränkt und über dem toten Bereich.",
  "story.load.2":
    "Wie viel Last ist genug? Wer Getriebe entwirft, fragt umgekehrt: Was ist bei gegebener Drehzahl die kleinste mittlere Last, mit der die gleichmäßige Bewegung stabil ist und die Zähne sich nie trennen?",
  "figure.L": "<0>Abbildung L.</0> Die kleinste Last, die die Zähne beisammenhält",
  "figure.L.caption":
    "Links: die kleinste mittlere Last <0/>, unter der die stationäre Antwort stabil ist und die Zähne sich nie trennen, über <1/>. Rechts: eine Periode der Antwort am Ring, mit ihrem kleinsten <2/>. Die Lager erweichen, und die Zähne haben einen Profilfehler <3/>\u00a0=\u00a00,1.",
  "figure.L.alt": "Kleinste Last über der Eingriffsfrequenz, hoch in den Zungen, und eine Periode des Übertragungsfehlers.",
  "story.load.3":
    "Zwischen den Zungen genügt eine kleine Last; in ihnen braucht die gleichmäßige Bewegung weit mehr, um überhaupt stabil zu sein. Und das ist die Antwort. Eine Zunge bedeutet nicht, dass ein Getriebe bricht; sie bedeutet, dass Ruhe nicht mehr in Frage kommt. Was an ihre Stelle tritt, eine Gabel oder ein Zyklus, wird so groß, wie die Lager es zulassen, und mit den richtigen Lagern und genug Last bleibt es so klein, dass die Zähne sich nie trennen.",

  "story.errata": "Was gedruckt ist und was stimmt",
  "story.errata.1":
    "Die Notizen am Rand, gesammelt und nachgemessen. Jede Zeile sagt, wo etwas steht, was gedruckt ist, was es heißen muss und was das exakte System sagt; die Zahlen werden auf Ihrem Gerät berechnet, während diese Seite lädt.",
  "figure.E": "<0>Abbildung E.</0> Was der Aufsatz druckt und was stimmt",
  "figure.E.caption": "Wie weit die gedruckten Zahlen (grau) und die berichtigten (grün) neben den exakten liegen, und alle Zeilen als Tabelle.",
  "figure.E.alt": "Abweichungen gedruckter und berichtigter Zahlen von den exakten, in Prozent.",
  "story.errata.2":
    "Nichts davon schmälert den Gedanken des Aufsatzes, und der ist richtig: Die Verzweigungen gibt es, es sind die beiden Arten, die er nennt, und sie entscheiden, ob eine Zunge gefährlich ist.",

  "story.glossary": "Glossar",
  "story.glossary.1": "In der Reihenfolge, in der die Wörter vorkommen.",
  "term.line-of-action": "Eingriffslinie",
  "term.line-of-action.meaning": "Die gerade Linie, auf der die Zähne von Evolventenrädern aufeinander drücken. Sie berührt beide Grundkreise, und alles im Modell geschieht auf ihr.",
  "term.support": "Lager",
  "term.support.meaning": "Was einen Körper an seinem Platz hält: Welle und Lager, zusammengefasst zu einer Feder und einem Dämpfer.",
  "term.hardening": "verhärtend",
  "term.hardening.meaning": "Heißt eine Feder, die steifer wird, je weiter sie ausgelenkt ist.",
  "term.softening": "erweichend",
  "term.softening.meaning": "Heißt eine Feder, die nachgiebiger wird, je weiter sie ausgelenkt ist.",
  "term.transmission-error": "Übertragungsfehler",
  "term.transmission-error.meaning":
    "Der Unterschied, auf der Eingriffslinie, zwischen dem Ort, an dem die Räder sind, und dem, an den vollkommene, starre Zähne sie brächten: So weit sind die Zähne zusammengedrückt oder auseinander.",
  "term.backlash": "Spiel",
  "term.backlash.meaning": "Wie weit sich ein Rad drehen lässt, während das andere festgehalten wird.",
  "term.dead-zone": "toter Bereich",
  "term.dead-zone.meaning": "Der Teil des Spiels, in dem sich keine Zähne berühren und der Eingriff keine Kraft ausübt als die seines Dämpfers.",
  "term.mesh-frequency": "Eingriffsfrequenz",
  "term.mesh-frequency.meaning": "Die Zahl der Zähne, die in einer Sekunde vorbeikommen, als Kreisfrequenz; hier geteilt durch die Eigenfrequenz des Eingriffs.",
  "term.parametric-resonance": "Parameterresonanz",
  "term.parametric-resonance.meaning": "Das Anwachsen einer Schwingung, die niemand anstößt, deren Steifigkeit sich aber in ihrem Takt ändert.",
  "term.mode": "Mode",
  "term.mode.meaning": "Eine Schwingung, in der sich alle Teile mit einer Frequenz bewegen und das Verhältnis ihrer Amplituden behalten.",
  "term.multiplier": "Multiplikator",
  "term.multiplier.meaning":
    "Ein Faktor, um den sich eine kleine Abweichung von einer periodischen Bewegung nach einer Periode geändert hat. Sind alle dem Betrag nach kleiner als eins, ist die Bewegung stabil. Benannt nach Gaston Floquet (1883).",
  "term.tongue": "Zunge",
  "term.tongue.meaning": "Ein Gebiet der Karte von Drehzahl und Tiefe des Pulses, in dem die Ruhe instabil ist. Es steht mit seiner Spitze auf einer Resonanz.",
  "term.detuning": "Verstimmung",
  "term.detuning.meaning": "Der Abstand der gegenwärtigen Drehzahl von der, auf der eine Zunge steht, geteilt durch die Tiefe des Pulses.",
  "term.decay-rate": "Abklingrate",
  "term.decay-rate.meaning": "Wie rasch eine Schwingung von selbst vergeht: In der Zeit von eins durch diese Rate fällt ihre Amplitude auf den e-ten Teil.",
  "term.slow-flow": "langsamer Fluss",
  "term.slow-flow.meaning": "Gleichungen für Amplitude und Phase allein, wenn diese sich während einer Schwingung kaum ändern.",
  "term.supercritical": "superkritisch",
  "term.supercritical.meaning": "Heißt eine Verzweigung, deren neue Bewegungen stabil sind und klein beginnen: die sanfte Art.",
  "term.pitchfork": "Gabelverzweigung",
  "term.pitchfork.meaning": "Ein Zustand verliert seine Stabilität, und zwei neue, Spiegelbilder voneinander, gehen von ihm aus.",
  "term.subcritical": "subkritisch",
  "term.subcritical.meaning": "Heißt eine Verzweigung, deren neue Bewegungen instabil sind: Wer sie überschreitet, springt zu etwas weit Entferntem.",
  "term.hopf": "Hopf-Verzweigung",
  "term.hopf.meaning": "Ein Zustand verliert seine Stabilität durch anwachsende Schwingungen, und ein Grenzzyklus geht von ihm aus. In einer Abbildung heißt sie nach Neimark und Sacker.",
  "term.limit-cycle": "Grenzzyklus",
  "term.limit-cycle.meaning": "Eine geschlossene Kurve von Bewegungen, der benachbarte Bewegungen sich nähern oder die sie verlassen.",
  "term.torus": "Torus",
  "term.torus.meaning": "Die Fläche, wie die eines Rings, die eine Bewegung aus zwei unverwandten Frequenzen am Ende füllt.",
  "term.saddle": "Sattel",
  "term.saddle.meaning": "Ein Zustand, dem man sich aus manchen Richtungen nähert und den man in anderen verlässt.",
  "term.spiral": "Strudel",
  "term.spiral.meaning": "Ein Zustand, dem man sich in Windungen nähert oder den man in Windungen verlässt.",
  "term.hysteresis": "Hysterese",
  "term.hysteresis.meaning": "Was die Räder tun, hängt davon ab, woher sie kommen: Hinweg und Rückweg sind verschieden.",
  "term.stroboscopic-map": "stroboskopische Abbildung",
  "term.stroboscopic-map.meaning": "Was man von einer Bewegung sieht, wenn man einmal in jeder Periode hinsieht. Benannt nach Henri Poincaré.",
  "term.continuation": "Fortsetzung",
  "term.continuation.meaning": "Einer Lösung Schritt für Schritt folgen, während ein Parameter sich ändert, auch um Falten herum.",
  "term.basin": "Einzugsgebiet",
  "term.basin.meaning": "Alle Anfänge, von denen am Ende dieselbe Bewegung erreicht wird.",

  "story.cite": "Wie zu zitieren ist",
  "story.cite.1":
    "Wenn Sie verwenden, was hier berechnet wird, zitieren Sie bitte den Aufsatz, um dessen Ergebnisse es geht, und diese Seite. Der Eintrag des Aufsatzes ist ohne seinen Verfasser, den die vorliegende Kopie nicht nennt; die Kennung führt zu ihm.",
  "story.cite.file.bib": "BibTeX als Datei",
  "story.cite.file.ris": "RIS als Datei",
  "cite.copy": "{name} kopieren",
  "cite.copied": "Kopiert.",
  "cite.marked": "Markiert, zum Kopieren von Hand.",

  "term.title": "{term}:",
  "symbol.meaning": "{meaning}",
  "symbol.value": "{meaning}; gegenwärtig {value}",
  "symbol.m": "Masse jedes Radkörpers, geteilt durch die gleichwertige Masse beider in ihrer Drehung",
  "symbol.k": "Steifigkeit jedes Lagers, geteilt durch die mittlere Steifigkeit des Eingriffs",
  "symbol.alpha": "kubische Steifigkeit jedes Lagers: über null verhärtend, unter null erweichend",
  "symbol.zeta": "Dämpfungsgrad des Eingriffs",
  "symbol.zeta_s": "Dämpfungsgrad jedes Lagers",
  "symbol.k0": "Tiefe des Pulses der Eingriffssteifigkeit, das ε des Aufsatzes",
  "symbol.Omega": "Eingriffsfrequenz, geteilt durch die Eigenfrequenz des Eingriffs",
  "symbol.F": "mittlere Kraft durch die Zähne",
  "symbol.E": "Amplitude des statischen Übertragungsfehlers, in halben Spielen",
  "symbol.u_p": "Verschiebung des Ritzels auf der Eingriffslinie, in halben Spielen",
  "symbol.u_g": "Verschiebung des Rads auf der Eingriffslinie, in halben Spielen",
  "symbol.u": "dynamischer Übertragungsfehler, in halben Spielen; die Zähne berühren sich, wo er über 1 liegt",
  "symbol.f(u)": "wie weit die Zähne zusammengedrückt sind; null, wo sie getrennt sind",
  "symbol.k(t)": "Steifigkeit des Eingriffs, geteilt durch ihr Mittel",
  "symbol.T": "Eingriffsperiode, von einem Zahn zum nächsten",
  "symbol.a": "Anteil der Zähne an der zweiten Mode (38)",
  "symbol.b": "Anteil der Zähne an der dritten Mode (39)",
  "symbol.c_j": "Anteil der Zähne an der Mode j: a bei der zweiten, b bei der dritten",
  "symbol.omega_j": "Eigenfrequenz der zweiten und der dritten Mode",
  "symbol.omega_2": "Eigenfrequenz der zweiten Mode",
  "symbol.omega_3": "Eigenfrequenz der dritten Mode",
  "symbol.mu": "Multiplikator: wie sich eine Abweichung in einer Periode ändert",
  "symbol.Omega_0": "Eingriffsfrequenz, auf der eine Zunge steht: zweite Mode, beide, dritte Mode",
  "symbol.Omega_1": "Verstimmung: Abstand von dort, wo eine Zunge steht, geteilt durch die Tiefe des Pulses",
  "symbol.W_j": "halbe Breite der Zunge der zweiten und der dritten Mode, geteilt durch die Tiefe des Pulses",
  "symbol.W_2": "halbe Breite der Zunge der zweiten Mode, geteilt durch die Tiefe des Pulses",
  "symbol.W_3": "halbe Breite der Zunge der dritten Mode, geteilt durch die Tiefe des Pulses",
  "symbol.W_c": "halbe Breite der Kombinationszunge, geteilt durch die Tiefe des Pulses",
  "symbol.d_j": "Abklingrate der zweiten und der dritten Mode",
  "symbol.d_2": "Abklingrate der zweiten Mode",
  "symbol.d_3": "Abklingrate der dritten Mode",
  "symbol.R": "Amplitude einer Mode; das Lager bewegt sich bis zum Doppelten davon",
  "about.how":
    "Alles auf dieser Seite rechnet Ihr Browser, mit einem einzigen WebAssembly-Modul, <0/>, das auch in eigenen Seiten und Programmen läuft. Exakte Bewegungen werden mit Taylorreihen integriert, auf 10<1/> genau. Nichts von dem, was Sie hier tun, verlässt Ihren Rechner.",
  "about.licence": "Lizenz: MIT oder Apache 2.0. Die Schrift ist STIX Two, unter der <0/>.",
  "about.summary": "Über diese Kopie",
  "about.version": "Fassung",
  "about.commit": "Commit",
  "about.made": "Gemacht mit",
};
