<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
<context>
    <name>data</name>
    <message>
        <source>A branch of the portal vein bleeds</source>
        <translation>Ein Ast der Pfortader blutet</translation>
    </message>
    <message>
        <source>Cut a branch of 3 mm with the scalpel; blood wells up, runs and pools</source>
        <translation>Einen Ast von 3 mm mit dem Skalpell durchtrennen; Blut quillt hervor, rinnt und sammelt sich</translation>
    </message>
    <message>
        <source>A raw surface is coagulated</source>
        <translation>Eine Wundfläche wird koaguliert</translation>
    </message>
    <message>
        <source>Small arteries bleed where the aspirator took tissue away; seal them with the pencil</source>
        <translation>Wo der Aspirator Gewebe entfernt hat, bluten kleine Arterien: mit dem HF-Handgriff versiegeln</translation>
    </message>
    <message>
        <source>Cut across the dome (120 particles, as in the thesis)</source>
        <translation>Schnitt über die Kuppel (120 Partikel, wie in der Diplomarbeit)</translation>
    </message>
    <message>
        <source>Draw a groove over the dome with the scalpel, from the far side towards you</source>
        <translation>Mit dem Skalpell eine Furche über die Kuppel ziehen, vom fernen Rand zu sich hin</translation>
    </message>
    <message>
        <source>Cut across the dome (950 particles, as in the thesis)</source>
        <translation>Schnitt über die Kuppel (950 Partikel, wie in der Diplomarbeit)</translation>
    </message>
    <message>
        <source>Cut across the dome</source>
        <translation>Schnitt über die Kuppel</translation>
    </message>
    <message>
        <source>Hollow out the dome (120 particles, as in the thesis)</source>
        <translation>Die Kuppel wird ausgehöhlt (120 Partikel, wie in der Diplomarbeit)</translation>
    </message>
    <message>
        <source>Rake the dome away with the hook, pass by pass</source>
        <translation>Mit dem Haken die Kuppel abtragen, Zug um Zug</translation>
    </message>
    <message>
        <source>Hollow out the dome (950 particles, as in the thesis)</source>
        <translation>Die Kuppel wird ausgehöhlt (950 Partikel, wie in der Diplomarbeit)</translation>
    </message>
    <message>
        <source>Hollow out the dome</source>
        <translation>Die Kuppel wird ausgehöhlt</translation>
    </message>
    <message>
        <source>The liver is dropped on the table</source>
        <translation>Die Leber fällt auf den Tisch</translation>
    </message>
    <message>
        <source>From 12 cm; it flattens, and comes to rest</source>
        <translation>Aus 12 cm; sie flacht ab und kommt zur Ruhe</translation>
    </message>
    <message>
        <source>Forceps lift the left lobe</source>
        <translation>Die Pinzette hebt den linken Lappen</translation>
    </message>
    <message>
        <source>Seize the liver near its margin, lift it, lay it down and let go</source>
        <translation>Die Leber nahe am Rand fassen, heben, ablegen und loslassen</translation>
    </message>
    <message>
        <source>The liver hangs from its dome</source>
        <translation>Die Leber hängt an ihrer Kuppel</translation>
    </message>
    <message>
        <source>Pinned at the top, it sags and swings under its weight</source>
        <translation>Oben befestigt, sackt sie durch und schwingt unter ihrem Gewicht</translation>
    </message>
    <message>
        <source>An incision under traction</source>
        <translation>Ein Schnitt unter Zug</translation>
    </message>
    <message>
        <source>Pull with the hook and cut across the pull with the scalpel; the wound opens</source>
        <translation>Mit dem Haken ziehen und mit dem Skalpell quer zum Zug schneiden; die Wunde klafft</translation>
    </message>
    <message>
        <source>An incision over the dome</source>
        <translation>Ein Schnitt über die Kuppel</translation>
    </message>
    <message>
        <source>Draw the scalpel over the dome, towards you; the wound bleeds</source>
        <translation>Das Skalpell über die Kuppel ziehen, zu sich hin; die Wunde blutet</translation>
    </message>
    <message>
        <source>The hook lifts the margin of the liver</source>
        <translation>Der Haken hebt den Leberrand</translation>
    </message>
    <message>
        <source>Catch the lobe with the hook, pull and hold it; pulled too far, it slips</source>
        <translation>Den Lappen mit dem Haken fassen, ziehen und halten; zu weit gezogen, gleitet er ab</translation>
    </message>
    <message>
        <source>The gallbladder is lifted, and the liver follows</source>
        <translation>Die Gallenblase wird gehoben, und die Leber folgt</translation>
    </message>
    <message>
        <source>Hold the gallbladder up by its fundus with the hook, lay it down and let go</source>
        <translation>Die Gallenblase mit dem Haken am Fundus hochhalten, ablegen und loslassen</translation>
    </message>
    <message>
        <source>Three holes through the liver (120 particles, as in the thesis)</source>
        <translation>Drei Löcher durch die Leber (120 Partikel, wie in der Diplomarbeit)</translation>
    </message>
    <message>
        <source>Drive the baton from the dome to the table, three times</source>
        <translation>Den Stab von der Kuppel bis zum Tisch stoßen, dreimal</translation>
    </message>
    <message>
        <source>Three holes through the liver (950 particles, as in the thesis)</source>
        <translation>Drei Löcher durch die Leber (950 Partikel, wie in der Diplomarbeit)</translation>
    </message>
    <message>
        <source>Three holes through the liver</source>
        <translation>Drei Löcher durch die Leber</translation>
    </message>
    <message>
        <source>The baton presses on a soft liver</source>
        <translation>Der Stab drückt auf eine weiche Leber</translation>
    </message>
    <message>
        <source>Press the liver with the baton, twice</source>
        <translation>Die Leber mit dem Stab drücken, zweimal</translation>
    </message>
    <message>
        <source>The inflow is clamped</source>
        <translation>Der Zufluss wird abgeklemmt</translation>
    </message>
    <message>
        <source>A cut bleeds; clamp the portal pedicle, which stops what flows in until the clamp is opened</source>
        <translation>Ein Schnitt blutet: den Pfortaderstiel abklemmen; das hält den Zufluss auf, bis die Klemme geöffnet wird</translation>
    </message>
    <message>
        <source>A piece of a soft liver taken off</source>
        <translation>Ein Stück einer weichen Leber wird abgetrennt</translation>
    </message>
    <message>
        <source>Draw the left lobe taut with the hook, cut it off with the scalpel, and lift the piece away</source>
        <translation>Den linken Lappen mit dem Haken straffen, mit dem Skalpell abtrennen und wegheben</translation>
    </message>
    <message>
        <source>Left lateral part of the liver taken off</source>
        <translation>Der linke laterale Teil der Leber wird abgetrennt</translation>
    </message>
    <message>
        <source>Divide the liver completely with the scalpel, in three strokes</source>
        <translation>Die Leber mit dem Skalpell in drei Zügen ganz durchtrennen</translation>
    </message>
    <message>
        <source>Scissors cut into the left lobe</source>
        <translation>Die Schere schneidet in den linken Lappen</translation>
    </message>
    <message>
        <source>Cut with the scissors, snip by snip, from the front; no tissue is lost, but blood</source>
        <translation>Mit der Schere von vorn schneiden, Schnitt um Schnitt; kein Gewebe geht verloren, nur Blut</translation>
    </message>
    <message>
        <source>Bleeding is brought down</source>
        <translation>Eine Blutung wird gestillt</translation>
    </message>
    <message>
        <source>Part of a left lateral sectionectomy</source>
        <translation>Teil einer linkslateralen Sektionektomie</translation>
    </message>
    <message>
        <source>Clamp the inflow, bare the vessels with the aspirator, clip and divide them, coagulate what bleeds</source>
        <translation>Den Zufluss abklemmen, mit dem Aspirator die Gefäße freilegen, sie mit Clips verschließen und durchtrennen, koagulieren, was blutet</translation>
    </message>
    <message>
        <source>Clip and divide</source>
        <translation>Clippen und durchtrennen</translation>
    </message>
    <message>
        <source>A branch of a hepatic vein is clipped twice and cut between the clips</source>
        <translation>Ein Ast einer Lebervene wird zweimal geclippt und zwischen den Clips durchtrennt</translation>
    </message>
    <message>
        <source>Clip and divide: a vessel is closed on both sides before it is cut between the clips.</source>
        <translation>Clippen und durchtrennen: ein Gefäß wird auf beiden Seiten verschlossen, bevor es zwischen den Clips durchtrennt wird.</translation>
    </message>
    <message>
        <source>Find the vein, and close it with a clip on the side of the heart.</source>
        <translation>Suchen Sie die Vene und verschließen Sie sie mit einem Clip auf der Herzseite.</translation>
    </message>
    <message>
        <source>Close it with a second clip a centimetre away.</source>
        <translation>Verschließen Sie sie einen Zentimeter weiter mit einem zweiten Clip.</translation>
    </message>
    <message>
        <source>Cut between the two clips.</source>
        <translation>Schneiden Sie zwischen den beiden Clips.</translation>
    </message>
    <message>
        <source>Control of a bleeding vessel</source>
        <translation>Kontrolle eines blutenden Gefäßes</translation>
    </message>
    <message>
        <source>The liver has a wound in which a branch of the portal vein bleeds; it is to be stopped</source>
        <translation>Die Leber hat eine Wunde, in der ein Ast der Pfortader blutet; er ist zu stillen</translation>
    </message>
    <message>
        <source>Control of a bleeding vessel: clear the wound, close the vessel, then what is left.</source>
        <translation>Kontrolle eines blutenden Gefäßes: die Wunde frei räumen, das Gefäß verschließen, dann das Übrige.</translation>
    </message>
    <message>
        <source>Seal what still bleeds with the bipolar forceps.</source>
        <translation>Versiegeln Sie mit der bipolaren Pinzette, was noch blutet.</translation>
    </message>
    <message>
        <source>Left lateral sectionectomy</source>
        <translation>Linkslaterale Sektionektomie</translation>
    </message>
    <message>
        <source>The left lateral section is parted along a plane and lifted away</source>
        <translation>Die linke laterale Sektion wird entlang einer Ebene abgetrennt und weggehoben</translation>
    </message>
    <message>
        <source>Left lateral sectionectomy: to keep a plane through the whole organ. The inflow counts as closed: it does not bleed.</source>
        <translation>Linkslaterale Sektionektomie: eine Ebene durch das ganze Organ einhalten. Der Zufluss gilt als gesperrt: es blutet nicht.</translation>
    </message>
    <message>
        <source>Mark the plane left of the ligament.</source>
        <translation>Markieren Sie die Ebene links vom Ligament.</translation>
    </message>
    <message>
        <source>Cut from the upper margin to the lower one.</source>
        <translation>Schneiden Sie vom oberen Rand zum unteren.</translation>
    </message>
    <message>
        <source>Pull the section aside with the hook, cut the strands that are left, and lift it away.</source>
        <translation>Ziehen Sie die Sektion mit dem Haken zur Seite, schneiden Sie die letzten Stränge durch und heben Sie sie weg.</translation>
    </message>
    <message>
        <source>Touch and hold</source>
        <translation>Berühren und halten</translation>
    </message>
    <message>
        <source>Four targets on the liver are touched one after the other and held</source>
        <translation>Vier Zielpunkte auf der Leber werden nacheinander berührt und gehalten</translation>
    </message>
    <message>
        <source>Camera and depth: to find a place in space, touch it gently, and rest there.</source>
        <translation>Kamera und Tiefe: eine Stelle im Raum finden, sie sanft berühren und dort ruhen.</translation>
    </message>
    <message>
        <source>Bring the tip over the first target.</source>
        <translation>Bringen Sie die Spitze über den ersten Zielpunkt.</translation>
    </message>
    <message>
        <source>Touch it, and stay for a second.</source>
        <translation>Berühren Sie ihn und bleiben Sie eine Sekunde.</translation>
    </message>
    <message>
        <source>Go on to the next one, in order; where one lies behind the liver, turn the view (Ctrl + 3: from the top).</source>
        <translation>Weiter zum nächsten, der Reihe nach; liegt einer hinter der Leber, drehen Sie die Ansicht (Strg + 3: von oben).</translation>
    </message>
    <message>
        <source>Two hands</source>
        <translation>Zwei Hände</translation>
    </message>
    <message>
        <source>The hook holds the left lobe, the scalpel follows a line over it</source>
        <translation>Der Haken hält den linken Lappen, das Skalpell folgt einer Linie darüber</translation>
    </message>
    <message>
        <source>Two hands: one holds tissue under tension, the other follows a line.</source>
        <translation>Zwei Hände: die eine hält das Gewebe unter Spannung, die andere folgt einer Linie.</translation>
    </message>
    <message>
        <source>Catch the lobe beside the line with the hook, and pull a little.</source>
        <translation>Fassen Sie den Lappen neben der Linie mit dem Haken und ziehen Sie ein wenig.</translation>
    </message>
    <message>
        <source>Draw the scalpel along the line while the hook holds.</source>
        <translation>Ziehen Sie das Skalpell die Linie entlang, während der Haken hält.</translation>
    </message>
    <message>
        <source>Wedge resection of a tumour</source>
        <translation>Keilresektion eines Tumors</translation>
    </message>
    <message>
        <source>A marked tumour is taken out of the left lobe with a margin</source>
        <translation>Ein markierter Tumor wird mit einem Rand aus dem linken Lappen entfernt</translation>
    </message>
    <message>
        <source>Wedge resection: a tumour is taken out in one piece with a margin on all sides.</source>
        <translation>Keilresektion: ein Tumor wird in einem Stück mit einem Rand auf allen Seiten entfernt.</translation>
    </message>
    <message>
        <source>Mark a margin of a centimetre round the tumour.</source>
        <translation>Markieren Sie einen Rand von einem Zentimeter um den Tumor.</translation>
    </message>
    <message>
        <source>Cut one side of the wedge, then the other.</source>
        <translation>Schneiden Sie die eine Seite des Keils, dann die andere.</translation>
    </message>
    <message>
        <source>Take the specimen off and look at its margin.</source>
        <translation>Nehmen Sie das Präparat ab und sehen Sie sich seinen Rand an.</translation>
    </message>
    <message>
        <source>Ultrasonic aspirator</source>
        <translation>Ultraschallaspirator</translation>
    </message>
    <message>
        <source>Ultrasonic aspirator; breaks up and draws off parenchyma and leaves vessels standing</source>
        <translation>Ultraschallaspirator; zertrümmert Parenchym, saugt es ab und lässt Gefäße stehen</translation>
    </message>
    <message>
        <source>Aspirator</source>
        <translation>Aspirator</translation>
    </message>
    <message>
        <source>Baton</source>
        <translation>Stab</translation>
    </message>
    <message>
        <source>Tapered square bar of the original simulator; pushes tissue with its tip</source>
        <translation>Sich verjüngender Vierkantstab des ursprünglichen Simulators; schiebt Gewebe mit der Spitze</translation>
    </message>
    <message>
        <source>Bipolar forceps</source>
        <translation>Bipolare Pinzette</translation>
    </message>
    <message>
        <source>Insulated forceps; coagulate what lies between their bare tips</source>
        <translation>Isolierte Pinzette; koaguliert, was zwischen ihren blanken Spitzen liegt</translation>
    </message>
    <message>
        <source>Bipolar</source>
        <translation>Bipolar</translation>
    </message>
    <message>
        <source>Clip applier</source>
        <translation>Clip-Applikator</translation>
    </message>
    <message>
        <source>Clip applier with a polymer clip; closes a vessel that lies between its jaws</source>
        <translation>Clip-Applikator mit Kunststoffclip; verschließt ein Gefäß, das zwischen seinen Backen liegt</translation>
    </message>
    <message>
        <source>Tissue forceps</source>
        <translation>Chirurgische Pinzette</translation>
    </message>
    <message>
        <source>Tweezers with toothed tips; hold what is between them, and pull it</source>
        <translation>Pinzette mit gezähnten Spitzen; hält und zieht, was zwischen ihnen ist</translation>
    </message>
    <message>
        <source>Forceps</source>
        <translation>Pinzette</translation>
    </message>
    <message>
        <source>Gauze swab</source>
        <translation>Tupfer</translation>
    </message>
    <message>
        <source>Folded gauze swab in ring forceps; dabs up blood and presses on a bleeding surface</source>
        <translation>Gefalteter Gazetupfer in einer Kornzange; tupft Blut auf und drückt auf eine blutende Fläche</translation>
    </message>
    <message>
        <source>Gauze</source>
        <translation>Tupfer</translation>
    </message>
    <message>
        <source>Hook</source>
        <translation>Haken</translation>
    </message>
    <message>
        <source>Blunt hook with a bend of 10 mm radius; catches and pulls tissue</source>
        <translation>Stumpfer Haken mit 10 mm Radius; fasst und zieht Gewebe</translation>
    </message>
    <message>
        <source>Inflow clamp</source>
        <translation>Pringle-Klemme</translation>
    </message>
    <message>
        <source>Vascular clamp with soft jaws; shuts off the inflow of the liver at its hilum</source>
        <translation>Gefäßklemme mit weichen Backen; sperrt den Zufluss der Leber am Hilus</translation>
    </message>
    <message>
        <source>Electrosurgical pencil</source>
        <translation>HF-Handgriff</translation>
    </message>
    <message>
        <source>Monopolar pencil with a blade electrode; cuts and coagulates with its edge</source>
        <translation>Monopolarer HF-Handgriff mit Messerelektrode; schneidet und koaguliert mit der Kante</translation>
    </message>
    <message>
        <source>Pencil</source>
        <translation>HF-Handgriff</translation>
    </message>
    <message>
        <source>Scalpel</source>
        <translation>Skalpell</translation>
    </message>
    <message>
        <source>No. 22 blade on a No. 4 handle; cuts with the belly of the blade</source>
        <translation>Klinge Nr. 22 auf Griff Nr. 4; schneidet mit dem Bauch der Klinge</translation>
    </message>
    <message>
        <source>Scissors</source>
        <translation>Schere</translation>
    </message>
    <message>
        <source>Dissecting scissors; part what is between the blades as they close</source>
        <translation>Präparierschere; durchtrennt beim Schließen, was zwischen den Blättern ist</translation>
    </message>
    <message>
        <source>Suction tube</source>
        <translation>Sauger</translation>
    </message>
    <message>
        <source>Tube with a rounded head and side holes; draws off the blood at its mouth</source>
        <translation>Rohr mit rundem Kopf und seitlichen Löchern; saugt das Blut an seiner Öffnung ab</translation>
    </message>
    <message>
        <source>Suction</source>
        <translation>Sauger</translation>
    </message>
    <message>
        <source>liver</source>
        <translation>Leber</translation>
    </message>
    <message>
        <source>gallbladder</source>
        <translation>Gallenblase</translation>
    </message>
    <message>
        <source>tumour</source>
        <translation>Tumor</translation>
    </message>
    <message>
        <source>cyst</source>
        <translation>Zyste</translation>
    </message>
    <message>
        <source>cavity</source>
        <translation>Hohlraum</translation>
    </message>
    <message>
        <source>A vein is bared, clipped and divided</source>
        <translation>Eine Vene wird freigelegt, geclippt und durchtrennt</translation>
    </message>
    <message>
        <source>Free a hepatic vein of 3 mm with the aspirator, close it with two clips, and cut it between them</source>
        <translation>Legen Sie eine Lebervene von 3 mm mit dem Aspirator frei, verschließen Sie sie mit zwei Clips, und durchtrennen Sie sie dazwischen</translation>
    </message>
    <message>
        <source>Suck the blood away, or press a swab on it, where it hides the wound.</source>
        <translation>Saugen Sie das Blut ab, wo es die Wunde verdeckt, oder drücken Sie ein Tuch darauf.</translation>
    </message>
    <message>
        <source>Cut a branch of the portal vein; clear the wound with suction, close the vessel with a clip, seal the rest with bipolar forceps</source>
        <translation>Schneiden Sie einen Ast der Pfortader an; saugen Sie die Wunde frei, verschließen Sie das Gefäß mit einem Clip, den Rest mit der bipolaren Pinzette</translation>
    </message>
    <message>
        <source>Close the vessel at the largest ring with a clip: point at the ring until it is white.</source>
        <translation>Schließen Sie das Gefäß am größten Ring mit einem Clip: zeigen Sie darauf, bis der Ring weiß ist.</translation>
    </message>
</context>
<context>
    <name>sentences</name>
    <message>
        <source>Target %1 was not begun.</source>
        <translation>Zielpunkt %1 wurde nicht begonnen.</translation>
    </message>
    <message>
        <source>Target %1 was held for %2 s at most.</source>
        <translation>Zielpunkt %1 wurde höchstens %2 s gehalten.</translation>
    </message>
    <message>
        <source>The tip came no nearer than %1 mm to target %2; %3 mm is near enough.</source>
        <translation>Die Spitze kam nicht näher als %1 mm an Zielpunkt %2; %3 mm sind nah genug.</translation>
    </message>
    <message>
        <source>Target %1 was not touched.</source>
        <translation>Zielpunkt %1 wurde nicht berührt.</translation>
    </message>
    <message>
        <source>All %1 targets were touched and held.</source>
        <translation>Alle %1 Zielpunkte wurden berührt und gehalten.</translation>
    </message>
    <message>
        <source>%1 of %2 targets were touched and held for %3 s.</source>
        <translation>%1 von %2 Zielpunkten wurden %3 s lang berührt und gehalten.</translation>
    </message>
    <message>
        <source>The %1 did not come out in one piece: %2 of %3 ml were left behind.</source>
        <translation>Die Struktur (%1) kam nicht in einem Stück heraus: %2 von %3 ml blieben zurück.</translation>
    </message>
    <message>
        <source>The %1 came out in one piece of %2 ml; the smallest margin is %3 mm, wanted are %4 mm.</source>
        <translation>Die Struktur (%1) kam in einem Stück von %2 ml heraus; der kleinste Rand ist %3 mm, gewünscht sind %4 mm.</translation>
    </message>
    <message>
        <source>Nothing bled, so nothing was stopped.</source>
        <translation>Nichts blutete, also wurde nichts gestillt.</translation>
    </message>
    <message>
        <source>It bled at %1 ml/min at most; a bleeding of %2 ml/min or more was to be stopped.</source>
        <translation>Es blutete höchstens mit %1 ml/min; zu stillen war eine Blutung von mindestens %2 ml/min.</translation>
    </message>
    <message>
        <source>The bleeding was stopped %1 s after it began; %2 ml were lost.</source>
        <translation>Die Blutung war %1 s nach ihrem Beginn gestillt; %2 ml gingen verloren.</translation>
    </message>
    <message>
        <source>The bleeding was below %1 ml/min for the last %2 s only; %3 s are wanted.</source>
        <translation>Die Blutung lag nur in den letzten %2 s unter %1 ml/min; gewünscht sind %3 s.</translation>
    </message>
    <message>
        <source>It still bled at %1 ml/min at the end (grade %2 of 4); less than %3 ml/min for %4 s is wanted.</source>
        <translation>Am Ende blutete es noch mit %1 ml/min (Grad %2 von 4); gewünscht sind weniger als %3 ml/min für %4 s.</translation>
    </message>
    <message>
        <source>The %1 was not divided.</source>
        <translation>Das Gefäß (%1) wurde nicht durchtrennt.</translation>
    </message>
    <message>
        <source>the far side</source>
        <translation>auf der fernen Seite</translation>
    </message>
    <message>
        <source>the side of the heart</source>
        <translation>auf der Herzseite</translation>
    </message>
    <message>
        <source>The %1 of %2 mm was divided between two clips.</source>
        <translation>Das Gefäß (%1) von %2 mm wurde zwischen zwei Clips durchtrennt.</translation>
    </message>
    <message>
        <source>The %1 of %2 mm was cut without a clip on %3.</source>
        <translation>Das Gefäß (%1) von %2 mm wurde ohne Clip %3 durchtrennt.</translation>
    </message>
    <message>
        <source>either side</source>
        <translation>auf beiden Seiten</translation>
    </message>
    <message>
        <source>No part came off.</source>
        <translation>Kein Teil löste sich.</translation>
    </message>
    <message>
        <source>A part of %1 ml came off; the cut strayed from the plane by at most %2 mm, allowed are %3 mm.</source>
        <translation>Ein Teil von %1 ml löste sich; der Schnitt wich höchstens %2 mm von der Ebene ab, erlaubt sind %3 mm.</translation>
    </message>
    <message>
        <source>Touch %1 targets in turn, and hold each for %2 s within %3 mm.</source>
        <translation>Berühren Sie nacheinander %1 Zielpunkte und halten Sie jeden %2 s lang innerhalb von %3 mm.</translation>
    </message>
    <message>
        <source>Cut along the line, %1.</source>
        <translation>Schneiden Sie entlang der Linie, %1.</translation>
    </message>
    <message>
        <source>Cut along the line, %1, while the other hand holds the tissue.</source>
        <translation>Schneiden Sie entlang der Linie, %1, während die andere Hand das Gewebe hält.</translation>
    </message>
    <message>
        <source>Take out the %1 in one piece, with a margin of %2 mm on all sides.</source>
        <translation>Entfernen Sie die Struktur (%1) in einem Stück, mit einem Rand von %2 mm auf allen Seiten.</translation>
    </message>
    <message>
        <source>Stop a bleeding of %1 ml/min or more: bring it below %2 ml/min, for %3 s.</source>
        <translation>Stillen Sie eine Blutung von mindestens %1 ml/min: bringen Sie sie für %3 s unter %2 ml/min.</translation>
    </message>
    <message>
        <source>Divide the %1 between two clips.</source>
        <translation>Durchtrennen Sie das Gefäß (%1) zwischen zwei Clips.</translation>
    </message>
    <message>
        <source>Part the organ along the plane, no farther than %1 mm from it.</source>
        <translation>Durchtrennen Sie das Organ entlang der Ebene, nicht weiter als %1 mm von ihr.</translation>
    </message>
    <message>
        <source>no farther than %1 mm from it</source>
        <translation>nicht weiter als %1 mm von ihr</translation>
    </message>
    <message>
        <source>%1 % of it within %2 mm and nowhere farther than %3 mm from it</source>
        <translation>%1 % davon innerhalb von %2 mm und nirgends weiter als %3 mm von ihr</translation>
    </message>
    <message>
        <source>The line was not cut at all.</source>
        <translation>Die Linie wurde gar nicht geschnitten.</translation>
    </message>
    <message>
        <source>%1 % of the line was followed within %2 mm%3.</source>
        <translation>%1 % der Linie wurden innerhalb von %2 mm verfolgt%3.</translation>
    </message>
    <message>
        <source>; %1 % is wanted</source>
        <translation>; gewünscht sind %1 %</translation>
    </message>
    <message>
        <source>Not followed: %1 from its beginning.</source>
        <translation>Nicht verfolgt: %1 von ihrem Anfang.</translation>
    </message>
    <message>
        <source>The instrument went %1 mm from the line; %2 mm is allowed.</source>
        <translation>Das Instrument war %1 mm von der Linie entfernt; erlaubt sind %2 mm.</translation>
    </message>
    <message>
        <source>Play the attempt back on the timeline, find where the hand waited or searched, and plan that step before you begin again.</source>
        <translation>Spielen Sie den Versuch auf der Zeitleiste ab, suchen Sie, wo die Hand wartete oder suchte, und planen Sie diesen Schritt, bevor Sie neu beginnen.</translation>
    </message>
    <message>
        <source>How could the vessel have been seen before it was cut?</source>
        <translation>Woran hätte man das Gefäß vor dem Schnitt erkannt?</translation>
    </message>
    <message>
        <source>Look for the vessel first, close it, and cut it then.</source>
        <translation>Suchen Sie zuerst das Gefäß, verschließen Sie es, und durchtrennen Sie es dann.</translation>
    </message>
    <message>
        <source>What shows that a vessel still bleeds?</source>
        <translation>Woran erkennt man, dass ein Gefäß noch blutet?</translation>
    </message>
    <message>
        <source>Look at the wound for a while before you leave it.</source>
        <translation>Sehen Sie die Wunde eine Weile an, bevor Sie sie verlassen.</translation>
    </message>
    <message>
        <source>What was in the way of closing the vessel earlier?</source>
        <translation>Was stand einem früheren Verschluss des Gefäßes im Weg?</translation>
    </message>
    <message>
        <source>Press on it or suck it dry, see where it bleeds, and close that at once.</source>
        <translation>Drücken oder saugen Sie, sehen Sie, wo es blutet, und verschließen Sie das sofort.</translation>
    </message>
    <message>
        <source>Where does this blood come from?</source>
        <translation>Woher kommt dieses Blut?</translation>
    </message>
    <message>
        <source>Clear the wound and look for the last source.</source>
        <translation>Räumen Sie die Wunde frei und suchen Sie die letzte Quelle.</translation>
    </message>
    <message>
        <source>Which step took longest between the cut and the closed vessel?</source>
        <translation>Welcher Schritt zwischen Schnitt und verschlossenem Gefäß dauerte am längsten?</translation>
    </message>
    <message>
        <source>Have the clip ready before the wound is cleared.</source>
        <translation>Halten Sie den Clip bereit, bevor die Wunde frei ist.</translation>
    </message>
    <message>
        <source>What was done between the cut and the clip?</source>
        <translation>Was geschah zwischen Schnitt und Clip?</translation>
    </message>
    <message>
        <source>Close a vessel before the next step.</source>
        <translation>Verschließen Sie ein Gefäß vor dem nächsten Schritt.</translation>
    </message>
    <message>
        <source>How could this structure have been seen, or held out of the way?</source>
        <translation>Wie hätte man diese Struktur sehen oder aus dem Weg halten können?</translation>
    </message>
    <message>
        <source>Find what lies near before you cut, and keep it in sight.</source>
        <translation>Finden Sie vor dem Schnitt, was in der Nähe liegt, und behalten Sie es im Blick.</translation>
    </message>
    <message>
        <source>How was the distance from the target judged while cutting?</source>
        <translation>Wie wurde der Abstand vom Ziel beim Schneiden beurteilt?</translation>
    </message>
    <message>
        <source>Mark the margin on the surface before the first cut.</source>
        <translation>Markieren Sie den Rand vor dem ersten Schnitt auf der Oberfläche.</translation>
    </message>
    <message>
        <source>Where was the target expected?</source>
        <translation>Wo wurde das Ziel erwartet?</translation>
    </message>
    <message>
        <source>Begin farther out, and turn in only below the target.</source>
        <translation>Beginnen Sie weiter außen und biegen Sie erst unter dem Ziel ein.</translation>
    </message>
    <message>
        <source>What did you look at to keep the plane?</source>
        <translation>Woran haben Sie sich gehalten, um in der Ebene zu bleiben?</translation>
    </message>
    <message>
        <source>Set a mark at both ends of the plane and cut from one to the other.</source>
        <translation>Setzen Sie an beiden Enden der Ebene eine Marke und schneiden Sie von der einen zur anderen.</translation>
    </message>
    <message>
        <source>What happened there?</source>
        <translation>Was geschah dort?</translation>
    </message>
    <message>
        <source>Slow down where the line turns.</source>
        <translation>Werden Sie langsamer, wo die Linie abbiegt.</translation>
    </message>
    <message>
        <source>Where did the eyes rest while cutting?</source>
        <translation>Wohin blickten Sie beim Schneiden?</translation>
    </message>
    <message>
        <source>Look a centimetre ahead of the blade.</source>
        <translation>Blicken Sie der Klinge einen Zentimeter voraus.</translation>
    </message>
    <message>
        <source>Where was the line hard to reach?</source>
        <translation>Wo war die Linie schwer zu erreichen?</translation>
    </message>
    <message>
        <source>Go over the whole line in the air once before cutting.</source>
        <translation>Fahren Sie vor dem Schneiden die ganze Linie einmal in der Luft ab.</translation>
    </message>
    <message>
        <source>What would have kept the tissue under tension?</source>
        <translation>Was hätte das Gewebe unter Spannung gehalten?</translation>
    </message>
    <message>
        <source>Take hold first, pull a little, and only then cut.</source>
        <translation>Fassen Sie zuerst, ziehen Sie ein wenig, und schneiden Sie erst dann.</translation>
    </message>
    <message>
        <source>What did the tissue look like at that moment?</source>
        <translation>Wie sah das Gewebe in diesem Moment aus?</translation>
    </message>
    <message>
        <source>Watch how far the tissue gives way, and stop when it whitens or tents.</source>
        <translation>Achten Sie darauf, wie weit das Gewebe nachgibt, und halten Sie ein, wenn es weiß wird oder sich aufwölbt.</translation>
    </message>
    <message>
        <source>What did the tissue look like at these moments?</source>
        <translation>Wie sah das Gewebe in diesen Momenten aus?</translation>
    </message>
    <message>
        <source>What pulled the tissue apart?</source>
        <translation>Was hat das Gewebe auseinandergezogen?</translation>
    </message>
    <message>
        <source>Cut what is under tension, do not tear it.</source>
        <translation>Schneiden Sie, was unter Spannung steht, zerreißen Sie es nicht.</translation>
    </message>
    <message>
        <source>Which tissue need not have been touched?</source>
        <translation>Welches Gewebe hätte nicht berührt werden müssen?</translation>
    </message>
    <message>
        <source>Plan the way in before the first cut.</source>
        <translation>Planen Sie den Zugang vor dem ersten Schnitt.</translation>
    </message>
    <message>
        <source>What moved while the target was held?</source>
        <translation>Was bewegte sich, während das Ziel gehalten wurde?</translation>
    </message>
    <message>
        <source>Rest the hand before you hold.</source>
        <translation>Lassen Sie die Hand ruhen, bevor Sie halten.</translation>
    </message>
    <message>
        <source>How was the depth of the target judged?</source>
        <translation>Wie wurde die Tiefe des Ziels beurteilt?</translation>
    </message>
    <message>
        <source>Come from the side in which depth can be seen.</source>
        <translation>Kommen Sie von der Seite, von der die Tiefe zu sehen ist.</translation>
    </message>
    <message>
        <source>When was the hand not steady?</source>
        <translation>Wann war die Hand unruhig?</translation>
    </message>
    <message>
        <source>Move in one go, and rest the hand between.</source>
        <translation>Bewegen Sie in einem Zug und lassen Sie die Hand dazwischen ruhen.</translation>
    </message>
    <message>
        <source>Which way was not needed?</source>
        <translation>Welcher Weg war unnötig?</translation>
    </message>
    <message>
        <source>Bring the tip in on one straight way.</source>
        <translation>Führen Sie die Spitze auf einem geraden Weg heran.</translation>
    </message>
    <message>
        <source>movements</source>
        <translation>Bewegungen</translation>
    </message>
    <message>
        <source>Which movements were searches?</source>
        <translation>Welche Bewegungen waren Suche?</translation>
    </message>
    <message>
        <source>Look where to go before you move.</source>
        <translation>Sehen Sie hin, bevor Sie sich bewegen.</translation>
    </message>
    <message>
        <source>What was the instrument doing while nobody saw it?</source>
        <translation>Was tat das Instrument, während niemand es sah?</translation>
    </message>
    <message>
        <source>Bring the tip into the picture before you move it, and turn the view with it.</source>
        <translation>Bringen Sie die Spitze ins Bild, bevor Sie sie bewegen, und drehen Sie die Ansicht mit.</translation>
    </message>
    <message>
        <source>What were you waiting for?</source>
        <translation>Worauf haben Sie gewartet?</translation>
    </message>
    <message>
        <source>Say the next step aloud before the last one ends.</source>
        <translation>Sagen Sie den nächsten Schritt laut, bevor der letzte endet.</translation>
    </message>
    <message>
        <source>Which step took longest?</source>
        <translation>Welcher Schritt dauerte am längsten?</translation>
    </message>
    <message>
        <source>%1: %2%3, wanted %4.</source>
        <translation>%1: %2%3, gewünscht %4.</translation>
    </message>
    <message>
        <source>The largest force was %1 N on the %2.</source>
        <translation>Die größte Kraft war %1 N (%2).</translation>
    </message>
    <message>
        <source>%1, %2 ml, came from the %3 that %4.</source>
        <translation>%1, %2 ml, kam aus: %3 (%4).</translation>
    </message>
    <message>
        <source>Most of the blood</source>
        <translation>Das meiste Blut</translation>
    </message>
    <message>
        <source>The largest share of one vessel</source>
        <translation>Der größte Anteil eines Gefäßes</translation>
    </message>
    <message>
        <source>was cut from the start</source>
        <translation>von Anfang an offen</translation>
    </message>
    <message>
        <source>was cut at %1</source>
        <translation>durchtrennt bei %1</translation>
    </message>
    <message>
        <source>For %1 s from %2 on no instrument touched the organ, while it bled at %3 ml/min.</source>
        <translation>Ab %2 berührte %1 s lang kein Instrument das Organ, während es mit %3 ml/min blutete.</translation>
    </message>
    <message>
        <source>For %1 s from %2 on no instrument touched the organ.</source>
        <translation>Ab %2 berührte %1 s lang kein Instrument das Organ.</translation>
    </message>
    <message>
        <source>The %1 was hurt.</source>
        <translation>Verletzt wurde: %1.</translation>
    </message>
    <message>
        <source>What led to this?</source>
        <translation>Was führte dazu?</translation>
    </message>
    <message>
        <source>Watch this figure in the next attempt.</source>
        <translation>Achten Sie beim nächsten Versuch auf diesen Wert.</translation>
    </message>
    <message>
        <source>closed %1 s later</source>
        <translation>nach %1 s verschlossen</translation>
    </message>
    <message>
        <source>still open at the end</source>
        <translation>am Ende noch offen</translation>
    </message>
    <message>
        <source>%1 cut unclipped, %2 ml lost, %3.</source>
        <translation>%1 ohne Clip durchtrennt, %2 ml verloren, %3.</translation>
    </message>
    <message>
        <source>Turn the view until the depth of the target can be seen, then bring the tip in.</source>
        <translation>Drehen Sie die Ansicht, bis die Tiefe des Ziels zu sehen ist, und führen Sie dann die Spitze heran.</translation>
    </message>
    <message>
        <source>Do the task&apos;s steps one after the other.</source>
        <translation>Führen Sie die Schritte der Aufgabe nacheinander aus.</translation>
    </message>
    <message>
        <source>What would have been the next step?</source>
        <translation>Was wäre der nächste Schritt gewesen?</translation>
    </message>
    <message>
        <source>Nothing was taken back.</source>
        <translation>Nichts wurde zurückgenommen.</translation>
    </message>
    <message>
        <source>never</source>
        <translation>nie</translation>
    </message>
    <message>
        <source>The %1 was taken, which this task does not allow.</source>
        <translation>Ein Instrument wurde genommen, das diese Aufgabe nicht erlaubt: %1.</translation>
    </message>
    <message>
        <source>What was it to do that the allowed instruments could not?</source>
        <translation>Was sollte es tun, was die erlaubten Instrumente nicht konnten?</translation>
    </message>
    <message>
        <source>Do the step with the instruments of the task.</source>
        <translation>Führen Sie den Schritt mit den Instrumenten der Aufgabe aus.</translation>
    </message>
    <message>
        <source>Work was taken back %1 times, which this task forbids.</source>
        <translation>%1-mal wurde etwas zurückgenommen, was diese Aufgabe verbietet.</translation>
    </message>
    <message>
        <source>What would have been done next with a real patient?</source>
        <translation>Was hätte man bei einem echten Patienten als Nächstes getan?</translation>
    </message>
    <message>
        <source>Go on from a slip instead of taking it back.</source>
        <translation>Arbeiten Sie nach einem Ausrutscher weiter, statt ihn zurückzunehmen.</translation>
    </message>
    <message>
        <source>The time of %1 s was up.</source>
        <translation>Die Zeit von %1 s war um.</translation>
    </message>
    <message>
        <source>Besides, not as wanted: %1.</source>
        <translation>Außerdem nicht wie gewünscht: %1.</translation>
    </message>
    <message>
        <source>The goal was reached, but not as wanted: %1.</source>
        <translation>Das Ziel wurde erreicht, aber nicht wie gewünscht: %1.</translation>
    </message>
    <message>
        <source>Hold the tip there for %1 s.</source>
        <translation>Halten Sie die Spitze dort %1 s lang.</translation>
    </message>
    <message>
        <source>Touch target %1 of %2.</source>
        <translation>Berühren Sie Zielpunkt %1 von %2.</translation>
    </message>
    <message>
        <source>Hold the tissue with the %1, and leave it holding.</source>
        <translation>Halten Sie das Gewebe (%1) und lassen Sie das Instrument dort halten.</translation>
    </message>
    <message>
        <source>The cut went too far from the line, which cannot be mended: finish, and begin again.</source>
        <translation>Der Schnitt kam zu weit von der Linie ab, was sich nicht mehr ändern lässt: beenden Sie, und beginnen Sie neu.</translation>
    </message>
    <message>
        <source>Go on along the line: %1 % done; missing: %2.</source>
        <translation>Weiter die Linie entlang: %1 % fertig; es fehlen: %2.</translation>
    </message>
    <message>
        <source>Cut along the line, from one end to the other.</source>
        <translation>Schneiden Sie die Linie entlang, von einem Ende zum anderen.</translation>
    </message>
    <message>
        <source>Cut round the %1, at least %2 mm away from it.</source>
        <translation>Schneiden Sie um die Struktur (%1), mindestens %2 mm von ihr entfernt.</translation>
    </message>
    <message>
        <source>Go on until the piece with the %1 comes off.</source>
        <translation>Machen Sie weiter, bis sich das Stück mit der Struktur (%1) löst.</translation>
    </message>
    <message>
        <source>Nothing bleeds yet.</source>
        <translation>Noch blutet nichts.</translation>
    </message>
    <message>
        <source>It does not bleed enough yet: %1 of %2 ml/min. %3</source>
        <translation>Es blutet noch nicht genug: %1 von %2 ml/min. %3</translation>
    </message>
    <message>
        <source>Cut deeper.</source>
        <translation>Schneiden Sie tiefer.</translation>
    </message>
    <message>
        <source>Below %1 ml/min: watch it for %2 s.</source>
        <translation>Unter %1 ml/min: beobachten Sie es %2 s lang.</translation>
    </message>
    <message>
        <source>Stop the bleeding of %1 ml/min.</source>
        <translation>Stillen Sie die Blutung von %1 ml/min.</translation>
    </message>
    <message>
        <source>Place a clip on the vessel, on the side of the heart.</source>
        <translation>Setzen Sie einen Clip auf das Gefäß, auf der Herzseite.</translation>
    </message>
    <message>
        <source>Place the second clip, on the far side.</source>
        <translation>Setzen Sie den zweiten Clip, auf der fernen Seite.</translation>
    </message>
    <message>
        <source>Cut the vessel between the clips.</source>
        <translation>Durchtrennen Sie das Gefäß zwischen den Clips.</translation>
    </message>
    <message>
        <source>Cut along the plane.</source>
        <translation>Schneiden Sie entlang der Ebene.</translation>
    </message>
    <message>
        <source>Go on along the plane until the part comes off.</source>
        <translation>Weiter die Ebene entlang, bis sich der Teil löst.</translation>
    </message>
    <message>
        <source>The goal is reached: let the instruments rest, and the exercise ends.</source>
        <translation>Das Ziel ist erreicht: lassen Sie die Instrumente ruhen, dann endet die Übung.</translation>
    </message>
    <message>
        <source>time from the first contact</source>
        <translation>Zeit ab der ersten Berührung</translation>
    </message>
    <message>
        <source>time in all</source>
        <translation>Zeit insgesamt</translation>
    </message>
    <message>
        <source>path length</source>
        <translation>Weglänge</translation>
    </message>
    <message>
        <source>path inefficiency</source>
        <translation>Umweg</translation>
    </message>
    <message>
        <source>total rotation</source>
        <translation>gesamte Drehung</translation>
    </message>
    <message>
        <source>rotational actions</source>
        <translation>Drehbewegungen</translation>
    </message>
    <message>
        <source>movement in depth</source>
        <translation>Bewegung in der Tiefe</translation>
    </message>
    <message>
        <source>idle time</source>
        <translation>Zeit ohne Bewegung</translation>
    </message>
    <message>
        <source>time with the tip out of view</source>
        <translation>Zeit mit der Spitze außer Sicht</translation>
    </message>
    <message>
        <source>smoothness (SPARC)</source>
        <translation>Ruhe der Hand (SPARC)</translation>
    </message>
    <message>
        <source>smoothness (LDLJ)</source>
        <translation>Ruhe der Hand (LDLJ)</translation>
    </message>
    <message>
        <source>95 % frequency</source>
        <translation>95-%-Frequenz</translation>
    </message>
    <message>
        <source>correlation of the hands&apos; speeds</source>
        <translation>Korrelation der Geschwindigkeiten beider Hände</translation>
    </message>
    <message>
        <source>largest force</source>
        <translation>größte Kraft</translation>
    </message>
    <message>
        <source>force, 95th percentile</source>
        <translation>Kraft, 95. Perzentil</translation>
    </message>
    <message>
        <source>mean force in contact</source>
        <translation>mittlere Kraft bei Berührung</translation>
    </message>
    <message>
        <source>spread of the force</source>
        <translation>Streuung der Kraft</translation>
    </message>
    <message>
        <source>times above the force limit</source>
        <translation>Überschreitungen der Kraftgrenze</translation>
    </message>
    <message>
        <source>time above the force limit</source>
        <translation>Zeit über der Kraftgrenze</translation>
    </message>
    <message>
        <source>blood lost</source>
        <translation>Blutverlust</translation>
    </message>
    <message>
        <source>bleeding at the end</source>
        <translation>Blutung am Ende</translation>
    </message>
    <message>
        <source>grade of bleeding at the end (VIBe)</source>
        <translation>Grad der Blutung am Ende (VIBe)</translation>
    </message>
    <message>
        <source>time until the bleeding was stopped</source>
        <translation>Zeit bis zur Blutstillung</translation>
    </message>
    <message>
        <source>vessels of 2 mm and more cut</source>
        <translation>durchtrennte Gefäße ab 2 mm</translation>
    </message>
    <message>
        <source>vessels of 2 mm and more cut before they were closed</source>
        <translation>Gefäße ab 2 mm, vor dem Verschluss durchtrennt</translation>
    </message>
    <message>
        <source>vessels of 2 mm and more still open at the end</source>
        <translation>am Ende noch offene Gefäße ab 2 mm</translation>
    </message>
    <message>
        <source>longest time until a vessel of 2 mm or more was closed</source>
        <translation>längste Zeit bis zum Verschluss eines Gefäßes ab 2 mm</translation>
    </message>
    <message>
        <source>clips placed</source>
        <translation>gesetzte Clips</translation>
    </message>
    <message>
        <source>inflow occluded</source>
        <translation>Zufluss gesperrt</translation>
    </message>
    <message>
        <source>times the inflow was occluded</source>
        <translation>Sperrungen des Zuflusses</translation>
    </message>
    <message>
        <source>specimen</source>
        <translation>Präparat</translation>
    </message>
    <message>
        <source>tissue destroyed</source>
        <translation>zerstörtes Gewebe</translation>
    </message>
    <message>
        <source>bonds torn</source>
        <translation>zerrissene Bindungen</translation>
    </message>
    <message>
        <source>area cut</source>
        <translation>Schnittfläche</translation>
    </message>
    <message>
        <source>area cut per minute</source>
        <translation>Schnittfläche je Minute</translation>
    </message>
    <message>
        <source>blood lost per area cut</source>
        <translation>Blutverlust je Schnittfläche</translation>
    </message>
    <message>
        <source>smallest margin</source>
        <translation>kleinster Rand</translation>
    </message>
    <message>
        <source>target left behind</source>
        <translation>zurückgebliebener Teil des Ziels</translation>
    </message>
    <message>
        <source>other structures hurt</source>
        <translation>andere verletzte Strukturen</translation>
    </message>
    <message>
        <source>targets touched and held</source>
        <translation>berührte und gehaltene Zielpunkte</translation>
    </message>
    <message>
        <source>largest distance from a target while holding</source>
        <translation>größter Abstand vom Zielpunkt beim Halten</translation>
    </message>
    <message>
        <source>share of the line followed</source>
        <translation>verfolgter Anteil der Linie</translation>
    </message>
    <message>
        <source>mean distance from the line</source>
        <translation>mittlerer Abstand von der Linie</translation>
    </message>
    <message>
        <source>largest distance from the line</source>
        <translation>größter Abstand von der Linie</translation>
    </message>
    <message>
        <source>share of the cutting with the tissue held</source>
        <translation>Anteil des Schneidens mit gehaltenem Gewebe</translation>
    </message>
    <message>
        <source>mean distance from the plane</source>
        <translation>mittlerer Abstand von der Ebene</translation>
    </message>
    <message>
        <source>largest distance from the plane</source>
        <translation>größter Abstand von der Ebene</translation>
    </message>
    <message>
        <source>times work was taken back</source>
        <translation>Zurücknahmen</translation>
    </message>
    <message>
        <source>easy</source>
        <translation>leicht</translation>
    </message>
    <message>
        <source>medium</source>
        <translation>mittel</translation>
    </message>
    <message>
        <source>hard</source>
        <translation>schwer</translation>
    </message>
    <message>
        <source>portal-vein</source>
        <translation>Pfortader</translation>
    </message>
    <message>
        <source>hepatic-vein</source>
        <translation>Lebervene</translation>
    </message>
    <message>
        <source>hepatic-artery</source>
        <translation>Leberarterie</translation>
    </message>
    <message>
        <source>bile-duct</source>
        <translation>Gallengang</translation>
    </message>
    <message>
        <source>portal vein</source>
        <translation>Pfortader</translation>
    </message>
    <message>
        <source>hepatic vein</source>
        <translation>Lebervene</translation>
    </message>
    <message>
        <source>hepatic artery</source>
        <translation>Leberarterie</translation>
    </message>
    <message>
        <source>bile duct</source>
        <translation>Gallengang</translation>
    </message>
    <message>
        <source>right posterior portal vein</source>
        <translation>rechte posteriore Pfortader</translation>
    </message>
    <message>
        <source>right posterior hepatic artery</source>
        <translation>rechte posteriore Leberarterie</translation>
    </message>
    <message>
        <source>right posterior hepatic duct</source>
        <translation>rechter posteriorer Gallengang</translation>
    </message>
    <message>
        <source>right anterior portal vein</source>
        <translation>rechte anteriore Pfortader</translation>
    </message>
    <message>
        <source>right anterior hepatic artery</source>
        <translation>rechte anteriore Leberarterie</translation>
    </message>
    <message>
        <source>right anterior hepatic duct</source>
        <translation>rechter anteriorer Gallengang</translation>
    </message>
    <message>
        <source>left lateral portal vein</source>
        <translation>linke laterale Pfortader</translation>
    </message>
    <message>
        <source>left lateral hepatic artery</source>
        <translation>linke laterale Leberarterie</translation>
    </message>
    <message>
        <source>left lateral hepatic duct</source>
        <translation>linker lateraler Gallengang</translation>
    </message>
    <message>
        <source>right portal vein</source>
        <translation>rechte Pfortader</translation>
    </message>
    <message>
        <source>right hepatic artery</source>
        <translation>rechte Leberarterie</translation>
    </message>
    <message>
        <source>right hepatic duct</source>
        <translation>rechter Gallengang</translation>
    </message>
    <message>
        <source>left portal vein</source>
        <translation>linke Pfortader</translation>
    </message>
    <message>
        <source>left hepatic artery</source>
        <translation>linke Leberarterie</translation>
    </message>
    <message>
        <source>left hepatic duct</source>
        <translation>linker Gallengang</translation>
    </message>
    <message>
        <source>common hepatic duct</source>
        <translation>Ductus hepaticus communis</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechte</translation>
    </message>
    <message>
        <source>middle</source>
        <translation>mittlere</translation>
    </message>
    <message>
        <source>left</source>
        <translation>linke</translation>
    </message>
    <message>
        <source>%1 hepatic vein</source>
        <translation>%1 Lebervene</translation>
    </message>
    <message>
        <source>portal branch of segment %1</source>
        <translation>Pfortaderast von Segment %1</translation>
    </message>
    <message>
        <source>artery of segment %1</source>
        <translation>Arterie von Segment %1</translation>
    </message>
    <message>
        <source>bile duct of segment %1</source>
        <translation>Gallengang von Segment %1</translation>
    </message>
    <message>
        <source>the pose of tool &quot;%1&quot; is not a number; it stays where it was: check the tool&apos;s motion</source>
        <translation>die Lage des Instruments &quot;%1&quot; ist keine Zahl; es bleibt, wo es war: prüfen Sie seine Bewegung</translation>
    </message>
    <message>
        <source>iso level %1 is outside %2 to %3; the level stays as it was</source>
        <translation>Iso-Schwelle %1 liegt außerhalb von %2 bis %3; sie bleibt, wie sie war</translation>
    </message>
    <message>
        <source>each frame will take about %1 s, for its %2 substeps; for fewer give softer tissue (young, poisson), denser tissue, larger cells (spacing) or more frames a second (frame_rate)</source>
        <translation>jedes Bild wird etwa %1 s dauern, denn es braucht %2 Teilschritte; für weniger nehmen Sie weicheres Gewebe (young, poisson), dichteres Gewebe, größere Zellen (spacing) oder mehr Bilder je Sekunde (frame_rate)</translation>
    </message>
    <message>
        <source>the disk is too slow for the recording, which ends here</source>
        <translation>die Festplatte ist zu langsam für die Aufzeichnung, die hier endet</translation>
    </message>
    <message>
        <source>%1: cannot be made: %2; choose another folder for the attempts</source>
        <translation>%1: lässt sich nicht anlegen: %2; wählen Sie einen anderen Ordner für die Versuche</translation>
    </message>
    <message>
        <source>The attempt could not be scored.</source>
        <translation>Der Versuch konnte nicht bewertet werden.</translation>
    </message>
    <message>
        <source>%1: has no task, so it is no exercise; choose a file with a table [task]</source>
        <translation>%1: hat keine Aufgabe, ist also keine Übung; wählen Sie eine Datei mit einer Tabelle [task]</translation>
    </message>
    <message>
        <source>There is no motion to play; open a scenario that has one.</source>
        <translation>Es gibt keine Bewegung, die abgespielt werden könnte; öffnen Sie ein Szenario, das eine hat.</translation>
    </message>
    <message>
        <source>Finished.</source>
        <translation>Beendet.</translation>
    </message>
    <message>
        <source>%1: has no task any more</source>
        <translation>%1: hat keine Aufgabe mehr</translation>
    </message>
    <message>
        <source>The goal is reached.</source>
        <translation>Das Ziel ist erreicht.</translation>
    </message>
    <message>
        <source>The time is up.</source>
        <translation>Die Zeit ist um.</translation>
    </message>
    <message>
        <source>This attempt could not be recorded, so it cannot be scored. Begin it again.</source>
        <translation>Dieser Versuch konnte nicht aufgezeichnet werden und lässt sich daher nicht bewerten. Beginnen Sie ihn neu.</translation>
    </message>
    <message>
        <source>what was dropped did not arrive; drop it again, or open it by the File menu</source>
        <translation>was ins Fenster gezogen wurde, kam nicht an; ziehen Sie es noch einmal oder öffnen Sie es über das Menü Datei</translation>
    </message>
    <message>
        <source>A film needs the program ffmpeg, which is not installed: install the package ffmpeg, then press Ctrl+R again. Ctrl+P saves a single picture, `resect run --frames` writes many.</source>
        <translation>Ein Film braucht das Programm ffmpeg, das nicht installiert ist: installieren Sie das Paket ffmpeg und drücken Sie dann wieder Strg+R. Strg+P speichert ein einzelnes Bild, `resect run --frames` schreibt viele.</translation>
    </message>
    <message>
        <source>The video ends here: the picture has another size now.</source>
        <translation>Das Video endet hier: das Bild hat jetzt eine andere Größe.</translation>
    </message>
    <message>
        <source>An exercise is made from a scenario; open one first, for this operation comes from a recording.</source>
        <translation>Eine Übung wird aus einem Szenario gemacht; öffnen Sie zuerst eines, denn diese Operation stammt aus einer Aufzeichnung.</translation>
    </message>
    <message>
        <source>No vessel of 2 mm or more lies within 3 cm of this place; click elsewhere.</source>
        <translation>Innerhalb von 3 cm um diese Stelle liegt kein Gefäß von 2 mm oder mehr; klicken Sie woandershin.</translation>
    </message>
    <message>
        <source>This operation is not being recorded and cannot be saved. Switch recording on in File &gt; Recorded operations, then begin again.</source>
        <translation>Diese Operation wird nicht aufgezeichnet und lässt sich nicht speichern. Schalten Sie die Aufzeichnung unter Datei &gt; Aufgezeichnete Operationen ein und beginnen Sie neu.</translation>
    </message>
    <message>
        <source>%1; the operation goes on unrecorded</source>
        <translation>%1; die Operation geht unaufgezeichnet weiter</translation>
    </message>
    <message>
        <source>%1: no browser could be started; open this file in one</source>
        <translation>%1: kein Browser ließ sich starten; öffnen Sie diese Datei in einem</translation>
    </message>
    <message>
        <source>the file&apos;s reader ended without a word; try another file</source>
        <translation>der Leser der Datei endete ohne ein Wort; versuchen Sie eine andere Datei</translation>
    </message>
    <message>
        <source>%1: 1 hole was closed</source>
        <translation>%1: 1 Loch wurde geschlossen</translation>
    </message>
    <message>
        <source>%1: %2 holes were closed</source>
        <translation>%1: %2 Löcher wurden geschlossen</translation>
    </message>
    <message>
        <source>open, %1 boundary edge</source>
        <translation>offen, %1 Randkante</translation>
    </message>
    <message>
        <source>open, %1 boundary edges</source>
        <translation>offen, %1 Randkanten</translation>
    </message>
    <message>
        <source>label %1</source>
        <translation>Label %1</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>höchstens %1</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>mindestens %1</translation>
    </message>
    <message>
        <source>%1 to %2 mm and %3 to %4 mm</source>
        <translation>%1 bis %2 mm und %3 bis %4 mm</translation>
    </message>
    <message>
        <source>%1 to %2 mm and %3 to %4 mm and %5 to %6 mm</source>
        <translation>%1 bis %2 mm und %3 bis %4 mm und %5 bis %6 mm</translation>
    </message>
    <message>
        <source>%1 of %2 mm</source>
        <translation>%1 von %2 mm</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>%1, from %2</source>
        <translation>%1, ab %2</translation>
    </message>
    <message>
        <source>0, from the start</source>
        <translation>0, ab dem Beginn</translation>
    </message>
    <message>
        <source>portal branch of segments %1</source>
        <translation>Pfortaderast der Segmente %1</translation>
    </message>
    <message>
        <source>artery of segments %1</source>
        <translation>Arterie der Segmente %1</translation>
    </message>
    <message>
        <source>bile duct of segments %1</source>
        <translation>Gallengang der Segmente %1</translation>
    </message>
</context>
<context>
    <name>window</name>
    <message>
        <source>%1: %2 of %3 %4</source>
        <translation>%1: %2 von %3 %4</translation>
    </message>
    <message>
        <source>Title of the exercise</source>
        <translation>Titel der Übung</translation>
    </message>
    <message>
        <source>Goal</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>Nächster Schritt</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Blood</source>
        <translation>Blut</translation>
    </message>
    <message>
        <source>Time of bleeding</source>
        <translation>Dauer der Blutung</translation>
    </message>
    <message>
        <source>Largest force</source>
        <translation>Größte Kraft</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>End of the exercise</source>
        <translation>Ende der Übung</translation>
    </message>
    <message>
        <source>Guidance</source>
        <translation>Führung</translation>
    </message>
    <message>
        <source>Marks of the goal in the picture, and the next step</source>
        <translation>Zeichen des Ziels im Bild und der nächste Schritt</translation>
    </message>
    <message>
        <source>Ghost of the reference</source>
        <translation>Vorführung als Schattenbild</translation>
    </message>
    <message>
        <source>What a good operator does, again and again</source>
        <translation>Was ein Geübter tut, immer wieder</translation>
    </message>
    <message>
        <source>The recording is played and scored</source>
        <translation>Die Aufzeichnung wird abgespielt und bewertet</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>Ends the attempt; it is recorded and scored</source>
        <translation>Beendet den Versuch; er wird aufgezeichnet und bewertet</translation>
    </message>
    <message>
        <source>Open the report</source>
        <translation>Bericht öffnen</translation>
    </message>
    <message>
        <source>The whole debrief, in the browser</source>
        <translation>Die ganze Nachbesprechung, im Browser</translation>
    </message>
    <message>
        <source>Again</source>
        <translation>Noch einmal</translation>
    </message>
    <message>
        <source>The same exercise from its start</source>
        <translation>Dieselbe Übung von vorn</translation>
    </message>
    <message>
        <source>All exercises</source>
        <translation>Alle Übungen</translation>
    </message>
    <message>
        <source>The list of exercises; this one waits</source>
        <translation>Die Liste der Übungen; diese wartet</translation>
    </message>
    <message>
        <source>Back to the maker</source>
        <translation>Zur Werkstatt</translation>
    </message>
    <message>
        <source>Next exercise</source>
        <translation>Nächste Übung</translation>
    </message>
    <message>
        <source>Changes and saves this exercise</source>
        <translation>Ändert und speichert diese Übung</translation>
    </message>
    <message>
        <source>The one after this, at the same level</source>
        <translation>Die folgende, auf derselben Stufe</translation>
    </message>
    <message>
        <source>Read the goal, then take an instrument.</source>
        <translation>Lesen Sie das Ziel und nehmen Sie dann ein Instrument.</translation>
    </message>
    <message>
        <source>From the line: %1 mm</source>
        <translation>Von der Linie: %1 mm</translation>
    </message>
    <message>
        <source>From the plane: %1 mm</source>
        <translation>Von der Ebene: %1 mm</translation>
    </message>
    <message>
        <source>From the structure: %1 mm</source>
        <translation>Von der Struktur: %1 mm</translation>
    </message>
    <message>
        <source>From the target: %1 mm</source>
        <translation>Vom Zielpunkt: %1 mm</translation>
    </message>
    <message>
        <source>Blood lost</source>
        <translation>Blutverlust</translation>
    </message>
    <message>
        <source>Bleeding for</source>
        <translation>Blutung seit</translation>
    </message>
    <message>
        <source>%1 The attempt is being scored ...</source>
        <translation>%1 Der Versuch wird bewertet ...</translation>
    </message>
    <message>
        <source>Shows this moment again</source>
        <translation>Zeigt diesen Moment noch einmal</translation>
    </message>
    <message>
        <source>Passed, %1 %</source>
        <translation>Bestanden, %1 %</translation>
    </message>
    <message>
        <source>Not passed, %1 %</source>
        <translation>Nicht bestanden, %1 %</translation>
    </message>
    <message>
        <source>Your first attempt is for practice and does not count. It reached %1 %, and would have passed.</source>
        <translation>Ihr erster Versuch dient der Übung und zählt nicht. Er erreichte %1 % und wäre bestanden.</translation>
    </message>
    <message>
        <source>Your first attempt is for practice and does not count. It reached %1 %, and would not have passed.</source>
        <translation>Ihr erster Versuch dient der Übung und zählt nicht. Er erreichte %1 % und wäre nicht bestanden.</translation>
    </message>
    <message>
        <source>What to change</source>
        <translation>Was zu ändern ist</translation>
    </message>
    <message>
        <source>What was good</source>
        <translation>Was gut war</translation>
    </message>
    <message>
        <source>Not tried yet</source>
        <translation>Noch nicht versucht</translation>
    </message>
    <message>
        <source>%1 attempt</source>
        <translation>%1 Versuch</translation>
    </message>
    <message>
        <source>%1 attempts</source>
        <translation>%1 Versuche</translation>
    </message>
    <message>
        <source>Best: passed, %1 %, %2; %3</source>
        <translation>Bestes: bestanden, %1 %, %2; %3</translation>
    </message>
    <message>
        <source>Best: not passed, %1 %, %2; %3</source>
        <translation>Bestes: nicht bestanden, %1 %, %2; %3</translation>
    </message>
    <message>
        <source>Exercises</source>
        <translation>Übungen</translation>
    </message>
    <message>
        <source>Learner</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>A name or a pseudonym: attempts and results are kept under it</source>
        <translation>Name oder Deckname: unter ihm werden Versuche und Ergebnisse aufbewahrt</translation>
    </message>
    <message>
        <source>As a test</source>
        <translation>Als Prüfung</translation>
    </message>
    <message>
        <source>Graded from the first attempt on, without guidance, and no work is taken back</source>
        <translation>Zählt vom ersten Versuch an, ohne Führung, und nichts wird zurückgenommen</translation>
    </message>
    <message>
        <source>Class table</source>
        <translation>Klassenliste</translation>
    </message>
    <message>
        <source>Who passed what, and learning curves: a page for the teacher</source>
        <translation>Wer was bestanden hat, und Lernkurven: eine Seite für die Lehrenden</translation>
    </message>
    <message>
        <source>With pseudonyms</source>
        <translation>Mit Decknamen</translation>
    </message>
    <message>
        <source>With the learners&apos; names</source>
        <translation>Mit den Namen</translation>
    </message>
    <message>
        <source>Add ...</source>
        <translation>Hinzufügen ...</translation>
    </message>
    <message>
        <source>An exercise that somebody else has made (.toml)</source>
        <translation>Eine Übung, die jemand anderes gemacht hat (.toml)</translation>
    </message>
    <message>
        <source>Make one</source>
        <translation>Selbst machen</translation>
    </message>
    <message>
        <source>An exercise from what is on the screen: mark places on the organ</source>
        <translation>Eine Übung aus dem, was zu sehen ist: Sie markieren Stellen auf dem Organ</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Back to the organ</source>
        <translation>Zurück zum Organ</translation>
    </message>
    <message>
        <source>Change folder ...</source>
        <translation>Ordner ändern ...</translation>
    </message>
    <message>
        <source>Where attempts are kept, such as a folder that a class shares</source>
        <translation>Wo Versuche aufbewahrt werden, etwa in einem Ordner der ganzen Klasse</translation>
    </message>
    <message>
        <source>Picture of %1</source>
        <translation>Bild von %1</translation>
    </message>
    <message>
        <source>Level of %1</source>
        <translation>Stufe von %1</translation>
    </message>
    <message>
        <source>Easy, medium: guidance is shown; hard: none. Limits differ by level</source>
        <translation>Leicht, mittel: mit Führung; schwer: ohne. Die Grenzen hängen von der Stufe ab</translation>
    </message>
    <message>
        <source>About</source>
        <translation>Mehr</translation>
    </message>
    <message>
        <source>About %1</source>
        <translation>Mehr über %1</translation>
    </message>
    <message>
        <source>What this exercise teaches, its limits, and what studies have measured: a page</source>
        <translation>Was diese Übung lehrt, ihre Grenzwerte und was Studien gemessen haben: eine Seite</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Beginnen</translation>
    </message>
    <message>
        <source>Start %1</source>
        <translation>%1 beginnen</translation>
    </message>
    <message>
        <source>Attempts are kept in %1</source>
        <translation>Versuche liegen in %1</translation>
    </message>
    <message>
        <source>Touch targets</source>
        <translation>Punkte berühren</translation>
    </message>
    <message>
        <source>Click each target on the organ, in order.</source>
        <translation>Klicken Sie die Zielpunkte auf dem Organ der Reihe nach an.</translation>
    </message>
    <message>
        <source>Cut along a line</source>
        <translation>Linie schneiden</translation>
    </message>
    <message>
        <source>Click the corners of the line, from one end to the other.</source>
        <translation>Klicken Sie die Ecken der Linie an, von einem Ende zum anderen.</translation>
    </message>
    <message>
        <source>Take out a structure</source>
        <translation>Struktur entfernen</translation>
    </message>
    <message>
        <source>Click on the organ above the middle of the tumour.</source>
        <translation>Klicken Sie auf das Organ über der Mitte des Tumors.</translation>
    </message>
    <message>
        <source>Stop a bleeding</source>
        <translation>Blutung stillen</translation>
    </message>
    <message>
        <source>There is nothing to mark: the learner makes the cut.</source>
        <translation>Es ist nichts zu markieren: den Schnitt macht, wer übt.</translation>
    </message>
    <message>
        <source>Divide a vessel</source>
        <translation>Gefäß durchtrennen</translation>
    </message>
    <message>
        <source>Click on the organ above the vessel.</source>
        <translation>Klicken Sie auf das Organ über dem Gefäß.</translation>
    </message>
    <message>
        <source>Cut along a plane</source>
        <translation>Ebene schneiden</translation>
    </message>
    <message>
        <source>Turn the view so that you look along the plane; then click two points that it goes through.</source>
        <translation>Drehen Sie das Bild so, dass Sie entlang der Ebene blicken; klicken Sie dann zwei Punkte an, durch die sie geht.</translation>
    </message>
    <message>
        <source>a new tumour</source>
        <translation>ein neuer Tumor</translation>
    </message>
    <message>
        <source>any</source>
        <translation>egal</translation>
    </message>
    <message>
        <source>%1, at the level %2, in %3; 0: any</source>
        <translation>%1, auf der Stufe %2, in %3; 0: egal</translation>
    </message>
    <message>
        <source>My exercise</source>
        <translation>Meine Übung</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>What the learner is to learn.</source>
        <translation>Was hier gelernt werden soll.</translation>
    </message>
    <message>
        <source>Teaches</source>
        <translation>Lehrt</translation>
    </message>
    <message>
        <source>How it is done, a step a line</source>
        <translation>Wie es gemacht wird, ein Schritt je Zeile</translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>Struktur</translation>
    </message>
    <message>
        <source>Mark places</source>
        <translation>Markieren</translation>
    </message>
    <message>
        <source>While this is pressed, a click on the organ marks a place</source>
        <translation>Solange dies gedrückt ist, markiert ein Klick auf das Organ eine Stelle</translation>
    </message>
    <message>
        <source>Remove last</source>
        <translation>Letzte löschen</translation>
    </message>
    <message>
        <source>Takes the mark away that was made last</source>
        <translation>Nimmt die zuletzt gesetzte Marke weg</translation>
    </message>
    <message>
        <source>Within</source>
        <translation>Innerhalb</translation>
    </message>
    <message>
        <source>How near is near enough</source>
        <translation>Welcher Abstand nah genug ist</translation>
    </message>
    <message>
        <source>Hold for</source>
        <translation>Halten</translation>
    </message>
    <message>
        <source>So long each target is held, or nothing bleeds</source>
        <translation>So lange wird jeder Zielpunkt gehalten, oder so lange blutet nichts</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Of the tumour</source>
        <translation>Des Tumors</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>Of the tumour&apos;s middle under the surface</source>
        <translation>Der Tumormitte unter der Oberfläche</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Rand</translation>
    </message>
    <message>
        <source>Least distance of the cuts from the tumour</source>
        <translation>Kleinster Abstand der Schnitte vom Tumor</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>Höchstens</translation>
    </message>
    <message>
        <source>Most time in all</source>
        <translation>Längste Zeit insgesamt</translation>
    </message>
    <message>
        <source>Most blood lost</source>
        <translation>Größter Blutverlust</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Largest force on the tissue</source>
        <translation>Größte Kraft auf das Gewebe</translation>
    </message>
    <message>
        <source>Guidance in the picture</source>
        <translation>Führung im Bild</translation>
    </message>
    <message>
        <source>Work may be taken back</source>
        <translation>Zurücknehmen ist erlaubt</translation>
    </message>
    <message>
        <source>Instruments</source>
        <translation>Instrumente</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Vorbild</translation>
    </message>
    <message>
        <source>Tries</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>A pass must come near to them</source>
        <translation>Bestehen nur nahe daran</translation>
    </message>
    <message>
        <source>Time, path, movements, force and blood at most two standard deviations above the mean of the checked tries, three or more</source>
        <translation>Zeit, Weg, Bewegungen, Kraft und Blut höchstens zwei Standardabweichungen über dem Mittel der angekreuzten Versuche, mindestens drei</translation>
    </message>
    <message>
        <source>Try it</source>
        <translation>Testen</translation>
    </message>
    <message>
        <source>Begins the exercise as a learner would</source>
        <translation>Beginnt die Übung, wie sie beim Lernen beginnt</translation>
    </message>
    <message>
        <source>Save ...</source>
        <translation>Sichern ...</translation>
    </message>
    <message>
        <source>As a file to be sent (.toml)</source>
        <translation>Als Datei zum Weitergeben (.toml)</translation>
    </message>
    <message>
        <source>Gives up what has not been saved</source>
        <translation>Verwirft, was nicht gespeichert ist</translation>
    </message>
    <message>
        <source>Close the maker</source>
        <translation>Werkstatt schließen</translation>
    </message>
    <message>
        <source>This organ has no vessels: open one that has them first.</source>
        <translation>Dieses Organ hat keine Gefäße: öffnen Sie zuerst eines, das welche hat.</translation>
    </message>
    <message>
        <source>%1 Marked: %2.</source>
        <translation>%1 Markiert: %2.</translation>
    </message>
    <message>
        <source>Try it yourself: learners then see your try as a ghost.</source>
        <translation>Versuchen Sie es selbst: andere sehen Ihren Versuch dann als Schattenbild.</translation>
    </message>
    <message>
        <source>Learners see the last checked try as a ghost.</source>
        <translation>Andere sehen den letzten angekreuzten Versuch als Schattenbild.</translation>
    </message>
    <message>
        <source>Lan&amp;guage</source>
        <translation>S&amp;prache (Language)</translation>
    </message>
    <message>
        <source>The window&apos;s language from the next start on</source>
        <translation>Die Sprache des Fensters vom nächsten Start an</translation>
    </message>
    <message>
        <source>The window has this language from the next start on</source>
        <translation>Das Fenster hat diese Sprache vom nächsten Start an</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>%L1 triangle</source>
        <translation>%L1 Dreieck</translation>
    </message>
    <message>
        <source>%L1 triangles</source>
        <translation>%L1 Dreiecke</translation>
    </message>
    <message>
        <source>%L1 component</source>
        <translation>%L1 Teil</translation>
    </message>
    <message>
        <source>%L1 components</source>
        <translation>%L1 Teile</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>geschlossen</translation>
    </message>
    <message>
        <source>open: %L1 boundary edge</source>
        <translation>offen: %L1 Randkante</translation>
    </message>
    <message>
        <source>open: %L1 boundary edges</source>
        <translation>offen: %L1 Randkanten</translation>
    </message>
    <message>
        <source>not wound one way</source>
        <translation>nicht einheitlich orientiert</translation>
    </message>
    <message>
        <source>inside out (will be turned)</source>
        <translation>Innen und Außen vertauscht (wird gewendet)</translation>
    </message>
    <message>
        <source>%L1 edge of more than two triangles</source>
        <translation>%L1 Kante an mehr als zwei Dreiecken</translation>
    </message>
    <message>
        <source>%L1 edges of more than two triangles</source>
        <translation>%L1 Kanten an mehr als zwei Dreiecken</translation>
    </message>
    <message>
        <source>%L1 inner shell faces inwards: a cavity without tissue</source>
        <translation>%L1 innere Schale zeigt nach innen: ein Hohlraum ohne Gewebe</translation>
    </message>
    <message>
        <source>%L1 inner shells face inwards: a cavity without tissue</source>
        <translation>%L1 innere Schalen zeigen nach innen: Hohlräume ohne Gewebe</translation>
    </message>
    <message>
        <source>%L1 inner shell faces outwards, so that what it encloses is tissue;</source>
        <translation>%L1 innere Schale zeigt nach außen, was sie umschließt, ist also Gewebe;</translation>
    </message>
    <message>
        <source>%L1 inner shells face outwards, so that what it encloses is tissue;</source>
        <translation>%L1 innere Schalen zeigen nach außen, was sie umschließen, ist also Gewebe;</translation>
    </message>
    <message>
        <source>if it is a cavity or a tumour, say so in the table</source>
        <translation>wenn es ein Hohlraum oder ein Tumor ist, geben Sie das in der Tabelle an</translation>
    </message>
    <message>
        <source>if it is a cavity, turn its faces inwards in the program that made it</source>
        <translation>wenn es ein Hohlraum ist, wenden Sie seine Flächen in dem Programm, aus dem er stammt</translation>
    </message>
    <message>
        <source>about %L1 particles</source>
        <translation>etwa %L1 Partikel</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>E&amp;xercises ...</source>
        <translation>Ü&amp;bungen ...</translation>
    </message>
    <message>
        <source>Exercises with a goal and a result, and what this learner has reached</source>
        <translation>Übungen mit Ziel und Ergebnis, und was damit schon erreicht ist</translation>
    </message>
    <message>
        <source>&amp;Open organ, scene, scenario or operation ...</source>
        <translation>&amp;Organ, Szene, Szenario oder Operation öffnen ...</translation>
    </message>
    <message>
        <source>A mesh, particles, a saved scene or a scenario; a file can also be dropped on the window</source>
        <translation>Ein Netz, Partikel, eine gespeicherte Szene oder ein Szenario; eine Datei kann auch ins Fenster gezogen werden</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>All that can be opened (*.iv *.wrl *.obj *.stl *.ply *.off *.glb *.gltf *.3mf *.vtk *.dis *.resect-cells *.toml *.resect *.nii *.nrrd *.nhdr *.mha *.mhd *.dcm *.gz);;All files (*)</source>
        <translation>Alles, was sich öffnen lässt (*.iv *.wrl *.obj *.stl *.ply *.off *.glb *.gltf *.3mf *.vtk *.dis *.resect-cells *.toml *.resect *.nii *.nrrd *.nhdr *.mha *.mhd *.dcm *.gz);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Open folder of &amp;labels ...</source>
        <translation>Ordner mit &amp;Labels öffnen ...</translation>
    </message>
    <message>
        <source>The labels of a scan with a file for each structure, as TotalSegmentator writes them</source>
        <translation>Die Labels einer Aufnahme mit einer Datei je Struktur, wie TotalSegmentator sie schreibt</translation>
    </message>
    <message>
        <source>Open folder of labels</source>
        <translation>Ordner mit Labels öffnen</translation>
    </message>
    <message>
        <source>Built-in &amp;%1</source>
        <translation>Mitgeliefert: &amp;%1</translation>
    </message>
    <message>
        <source>The %1 that comes with Resect, whole</source>
        <translation>Das mitgelieferte Organ (%1), unversehrt</translation>
    </message>
    <message>
        <source>&amp;Recent files</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Recorded op&amp;erations</source>
        <translation>Aufgezeichnete O&amp;perationen</translation>
    </message>
    <message>
        <source>What the window has recorded by itself; opened, an operation goes on</source>
        <translation>Was das Fenster von selbst aufgezeichnet hat; geöffnet geht eine Operation weiter</translation>
    </message>
    <message>
        <source>&amp;Record operations</source>
        <translation>Operationen &amp;aufzeichnen</translation>
    </message>
    <message>
        <source>Whether the next operations are recorded</source>
        <translation>Ob die nächsten Operationen aufgezeichnet werden</translation>
    </message>
    <message>
        <source>From the next operation on, all is recorded</source>
        <translation>Von der nächsten Operation an wird alles aufgezeichnet</translation>
    </message>
    <message>
        <source>From the next operation on, nothing is recorded</source>
        <translation>Von der nächsten Operation an wird nichts aufgezeichnet</translation>
    </message>
    <message>
        <source>Begin the operation &amp;again</source>
        <translation>Operation &amp;neu beginnen</translation>
    </message>
    <message>
        <source>The same organ, whole, with the settings of the laboratory&apos;s panel; the view stays, and what was done so far stays in its recording</source>
        <translation>Dasselbe Organ, unversehrt, mit den Einstellungen des Labors; die Ansicht bleibt, und was bisher getan wurde, bleibt in der Aufzeichnung</translation>
    </message>
    <message>
        <source>&amp;Save operation</source>
        <translation>Operation &amp;speichern</translation>
    </message>
    <message>
        <source>All that was done, as one file: opened, the operation goes on where it was</source>
        <translation>Alles, was getan wurde, in einer Datei: geöffnet geht die Operation dort weiter, wo sie war</translation>
    </message>
    <message>
        <source>Save operation &amp;as ...</source>
        <translation>Operation speichern &amp;unter ...</translation>
    </message>
    <message>
        <source>The same under another name</source>
        <translation>Dasselbe unter anderem Namen</translation>
    </message>
    <message>
        <source>Save s&amp;urface ...</source>
        <translation>Ober&amp;fläche speichern ...</translation>
    </message>
    <message>
        <source>The organ as it is now, as a closed mesh</source>
        <translation>Das Organ, wie es jetzt ist, als geschlossenes Netz</translation>
    </message>
    <message>
        <source>Save s&amp;cene ...</source>
        <translation>S&amp;zene speichern ...</translation>
    </message>
    <message>
        <source>The whole room as an Inventor file, for this program and others</source>
        <translation>Der ganze Raum als Inventor-Datei, für dieses Programm und andere</translation>
    </message>
    <message>
        <source>Save &amp;picture ...</source>
        <translation>B&amp;ild speichern ...</translation>
    </message>
    <message>
        <source>The picture as it is seen, with smooth edges</source>
        <translation>Das Bild, wie es zu sehen ist, mit glatten Kanten</translation>
    </message>
    <message>
        <source>Record a &amp;film: start or stop</source>
        <translation>Fil&amp;m aufnehmen: beginnen oder beenden</translation>
    </message>
    <message>
        <source>A film of what is seen, until this is chosen again; needs ffmpeg</source>
        <translation>Ein Film von dem, was zu sehen ist, bis dies erneut gewählt wird; braucht ffmpeg</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Ende</translation>
    </message>
    <message>
        <source>Ends the operation</source>
        <translation>Beendet die Operation</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Undo stroke</source>
        <translation>Letzte Bewegung &amp;rückgängig</translation>
    </message>
    <message>
        <source>Takes back the last stroke: from the first touch until the hand let go</source>
        <translation>Nimmt die letzte Bewegung zurück: von der ersten Berührung bis zum Loslassen</translation>
    </message>
    <message>
        <source>&amp;Redo stroke</source>
        <translation>Bewegung &amp;wiederholen</translation>
    </message>
    <message>
        <source>Does again the stroke that was taken back last</source>
        <translation>Führt die zuletzt zurückgenommene Bewegung wieder aus</translation>
    </message>
    <message>
        <source>&amp;Instruments</source>
        <translation>&amp;Instrumente</translation>
    </message>
    <message>
        <source>Along the &amp;surface</source>
        <translation>An der &amp;Oberfläche</translation>
    </message>
    <message>
        <source>The instrument follows the organ&apos;s surface under the pointer</source>
        <translation>Das Instrument folgt der Oberfläche des Organs unter dem Zeiger</translation>
    </message>
    <message>
        <source>&amp;Direct</source>
        <translation>&amp;Direkt</translation>
    </message>
    <message>
        <source>Dragging moves it across the view</source>
        <translation>Ziehen bewegt es quer zum Blick</translation>
    </message>
    <message>
        <source>Handle &amp;box: move</source>
        <translation>&amp;Kasten: verschieben</translation>
    </message>
    <message>
        <source>Moves it along one axis or face</source>
        <translation>Verschiebt es entlang einer Achse oder Fläche</translation>
    </message>
    <message>
        <source>&amp;Trackball: turn</source>
        <translation>&amp;Trackball: drehen</translation>
    </message>
    <message>
        <source>Turns it about its tip</source>
        <translation>Dreht es um seine Spitze</translation>
    </message>
    <message>
        <source>&amp;Let go</source>
        <translation>&amp;Loslassen</translation>
    </message>
    <message>
        <source>It stays where it is</source>
        <translation>Es bleibt, wo es ist</translation>
    </message>
    <message>
        <source>L&amp;eave at work</source>
        <translation>&amp;Arbeiten lassen</translation>
    </message>
    <message>
        <source>While it presses: it goes on holding or pressing there, and the hand is free (key F)</source>
        <translation>Während es drückt: es hält oder drückt dort weiter, und die Hand ist frei (Taste F)</translation>
    </message>
    <message>
        <source>&amp;Play the scenario&apos;s motions</source>
        <translation>Bewegungen des Szenarios a&amp;bspielen</translation>
    </message>
    <message>
        <source>Until they end, or an instrument is taken</source>
        <translation>Bis sie enden oder ein Instrument genommen wird</translation>
    </message>
    <message>
        <source>In an exercise the ghost shows how it is done</source>
        <translation>In einer Übung zeigt das Schattenbild, wie es gemacht wird</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;Controls</source>
        <translation>&amp;Bedienung</translation>
    </message>
    <message>
        <source>What mouse and keys do</source>
        <translation>Was Maus und Tasten tun</translation>
    </message>
    <message>
        <source>&amp;About</source>
        <translation>Ü&amp;ber Resect</translation>
    </message>
    <message>
        <source>What this is</source>
        <translation>Was dies ist</translation>
    </message>
    <message>
        <source>About Resect</source>
        <translation>Über Resect</translation>
    </message>
    <message>
        <source>&lt;b&gt;Resect&lt;/b&gt;&lt;p&gt;Virtual surgery on organ models, in real time.&lt;p&gt;Not for diagnosis or treatment. Apache License 2.0.</source>
        <translation>&lt;b&gt;Resect&lt;/b&gt;&lt;p&gt;Virtuelle Chirurgie an Organmodellen, in Echtzeit.&lt;p&gt;Nicht für Diagnose oder Behandlung. Apache-Lizenz 2.0.</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Surgeon</source>
        <translation>&amp;Chirurg</translation>
    </message>
    <message>
        <source>&amp;Assistant</source>
        <translation>&amp;Assistenz</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>&amp;Von oben</translation>
    </message>
    <message>
        <source>&amp;Laparoscope</source>
        <translation>&amp;Laparoskop</translation>
    </message>
    <message>
        <source>Looks from there</source>
        <translation>Blickt von dort</translation>
    </message>
    <message>
        <source>&amp;Home</source>
        <translation>An&amp;fang</translation>
    </message>
    <message>
        <source>The surgeon&apos;s view, as at the start</source>
        <translation>Die Ansicht des Chirurgen, wie zu Beginn</translation>
    </message>
    <message>
        <source>&amp;View all</source>
        <translation>All&amp;es zeigen</translation>
    </message>
    <message>
        <source>Organ and instruments, from this side</source>
        <translation>Organ und Instrumente, von dieser Seite</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>Ver&amp;größern</translation>
    </message>
    <message>
        <source>Nearer to the middle of the picture; the wheel zooms to the pointer</source>
        <translation>Näher zur Mitte des Bildes; das Mausrad vergrößert zum Zeiger hin</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>Ver&amp;kleinern</translation>
    </message>
    <message>
        <source>Farther away</source>
        <translation>Weiter weg</translation>
    </message>
    <message>
        <source>Look at a &amp;point: click it</source>
        <translation>Auf einen Punkt &amp;blicken: anklicken</translation>
    </message>
    <message>
        <source>The camera turns round the point that is clicked next</source>
        <translation>Die Kamera dreht sich um den Punkt, der als Nächstes angeklickt wird</translation>
    </message>
    <message>
        <source>Click what you want to look at</source>
        <translation>Klicken Sie an, was Sie sehen wollen</translation>
    </message>
    <message>
        <source>&amp;Bring back view and instruments</source>
        <translation>Ansicht und Instrumente &amp;zurückholen</translation>
    </message>
    <message>
        <source>The view as at the start, and all instruments into the tray; the organ stays as it is</source>
        <translation>Die Ansicht wie zu Beginn und alle Instrumente in die Ablage; das Organ bleibt, wie es ist</translation>
    </message>
    <message>
        <source>La&amp;boratory</source>
        <translation>&amp;Labor</translation>
    </message>
    <message>
        <source>Cells, surface and timing: panels for those who develop, and the scale of the iso level</source>
        <translation>Zellen, Oberfläche und Zeiten: Bedienfelder für die Entwicklung, und die Skala der Iso-Schwelle</translation>
    </message>
    <message>
        <source>S&amp;cale of the iso level</source>
        <translation>&amp;Skala der Iso-Schwelle</translation>
    </message>
    <message>
        <source>Its arrow sets how much of each cell counts as tissue</source>
        <translation>Ihr Pfeil bestimmt, wie viel jeder Zelle als Gewebe gilt</translation>
    </message>
    <message>
        <source>Mark what b&amp;leeds</source>
        <translation>Blutungen &amp;markieren</translation>
    </message>
    <message>
        <source>While an instrument is in hand that stops bleeding: rings round the ends of vessels that bleed, to which it is guided</source>
        <translation>Solange ein blutstillendes Instrument in der Hand ist: Ringe um blutende Gefäßenden, zu denen es geführt wird</translation>
    </message>
    <message>
        <source>Op&amp;ened abdomen</source>
        <translation>Ge&amp;öffneter Bauch</translation>
    </message>
    <message>
        <source>What stands round the organ: an opened abdomen, or the operating table</source>
        <translation>Was das Organ umgibt: ein geöffneter Bauch oder der Operationstisch</translation>
    </message>
    <message>
        <source>Thesis &amp;mode</source>
        <translation>Modus der &amp;Diplomarbeit</translation>
    </message>
    <message>
        <source>As the original system: still tissue, and each instrument takes out what it touches. The operation begins again</source>
        <translation>Wie das ursprüngliche System: das Gewebe ruht, und jedes Instrument entfernt, was es berührt. Die Operation beginnt neu</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>Bedien&amp;felder</translation>
    </message>
    <message>
        <source>Shows or hides this panel</source>
        <translation>Zeigt dieses Bedienfeld oder blendet es aus</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>D&amp;unkel</translation>
    </message>
    <message>
        <source>Dark colours; kept for the next start</source>
        <translation>Dunkle Farben; auch beim nächsten Start</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>Voll&amp;bild</translation>
    </message>
    <message>
        <source>And back again</source>
        <translation>Und wieder zurück</translation>
    </message>
    <message>
        <source>S&amp;cenario</source>
        <translation>S&amp;zenario</translation>
    </message>
    <message>
        <source>As in the &amp;thesis</source>
        <translation>Wie in der &amp;Diplomarbeit</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufnahme</translation>
    </message>
    <message>
        <source>A film is being recorded: Ctrl+R ends it and writes it</source>
        <translation>Ein Film wird aufgenommen: Strg+R beendet und schreibt ihn</translation>
    </message>
    <message>
        <source>Not recorded</source>
        <translation>Nicht aufgezeichnet</translation>
    </message>
    <message>
        <source>This operation is kept in no file: File &gt; Recorded operations</source>
        <translation>Diese Operation wird in keiner Datei aufbewahrt: Datei &gt; Aufgezeichnete Operationen</translation>
    </message>
    <message>
        <source>How much of it has been made</source>
        <translation>Wie viel davon fertig ist</translation>
    </message>
    <message>
        <source>Gives up what is coming; what is there stays as it is</source>
        <translation>Verzichtet auf das, was kommt; was da ist, bleibt</translation>
    </message>
    <message>
        <source>Add an exercise</source>
        <translation>Übung hinzufügen</translation>
    </message>
    <message>
        <source>Exercises (*.toml)</source>
        <translation>Übungen (*.toml)</translation>
    </message>
    <message>
        <source>One moment: an operation is being prepared. The one that is shown ends as soon as it is ready.</source>
        <translation>Einen Augenblick: eine Operation wird vorbereitet. Die gezeigte endet, sobald sie bereit ist.</translation>
    </message>
    <message>
        <source>The exercise is over: what is done now does not count</source>
        <translation>Die Übung ist beendet: was jetzt getan wird, zählt nicht</translation>
    </message>
    <message>
        <source>In this exercise no work is taken back</source>
        <translation>In dieser Übung wird nichts zurückgenommen</translation>
    </message>
    <message>
        <source>The attempt is kept, but could not be scored.</source>
        <translation>Der Versuch ist aufbewahrt, konnte aber nicht bewertet werden.</translation>
    </message>
    <message>
        <source>Folder for attempts</source>
        <translation>Ordner für Versuche</translation>
    </message>
    <message>
        <source>The class is being scored ...</source>
        <translation>Die Klasse wird bewertet ...</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Geschrieben: %1</translation>
    </message>
    <message>
        <source>Save surface</source>
        <translation>Oberfläche speichern</translation>
    </message>
    <message>
        <source>Meshes (*.stl *.obj *.ply *.vtk *.iv)</source>
        <translation>Netze (*.stl *.obj *.ply *.vtk *.iv)</translation>
    </message>
    <message>
        <source>Save scene</source>
        <translation>Szene speichern</translation>
    </message>
    <message>
        <source>Open Inventor (*.iv)</source>
        <translation>Open Inventor (*.iv)</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>PNG (*.png)</source>
        <translation>PNG (*.png)</translation>
    </message>
    <message>
        <source>The video is written</source>
        <translation>Das Video ist geschrieben</translation>
    </message>
    <message>
        <source>Record film</source>
        <translation>Film aufnehmen</translation>
    </message>
    <message>
        <source>MPEG-4 (*.mp4)</source>
        <translation>MPEG-4 (*.mp4)</translation>
    </message>
    <message>
        <source>Recording %1; Ctrl+R ends it</source>
        <translation>%1 wird aufgenommen; Strg+R beendet die Aufnahme</translation>
    </message>
    <message>
        <source>Nothing was taken back that could be done again</source>
        <translation>Es wurde nichts zurückgenommen, was sich wiederholen ließe</translation>
    </message>
    <message>
        <source>There is no stroke to take back</source>
        <translation>Es gibt keine Bewegung, die zurückgenommen werden könnte</translation>
    </message>
    <message>
        <source>Stroke %1 is done again</source>
        <translation>Bewegung %1 wird wiederholt</translation>
    </message>
    <message>
        <source>Stroke %1 is taken back</source>
        <translation>Bewegung %1 wird zurückgenommen</translation>
    </message>
    <message>
        <source>Click on the organ</source>
        <translation>Klicken Sie auf das Organ</translation>
    </message>
    <message>
        <source>Try %1: passed</source>
        <translation>Versuch %1: bestanden</translation>
    </message>
    <message>
        <source>Try %1: not passed</source>
        <translation>Versuch %1: nicht bestanden</translation>
    </message>
    <message>
        <source>, way %1 m</source>
        <translation>, Weg %1 m</translation>
    </message>
    <message>
        <source>Save exercise</source>
        <translation>Übung speichern</translation>
    </message>
    <message>
        <source>Preparing: %1</source>
        <translation>In Vorbereitung: %1</translation>
    </message>
    <message>
        <source>Beginning again ...</source>
        <translation>Beginnt neu ...</translation>
    </message>
    <message>
        <source>Opening the operation ...</source>
        <translation>Operation wird geöffnet ...</translation>
    </message>
    <message>
        <source>Cancelled; nothing has changed</source>
        <translation>Abgebrochen; nichts hat sich geändert</translation>
    </message>
    <message>
        <source>Begun again; what was done before is in File &gt; Recorded operations</source>
        <translation>Neu begonnen; was vorher getan wurde, ist in Datei &gt; Aufgezeichnete Operationen</translation>
    </message>
    <message>
        <source>Begun again</source>
        <translation>Neu begonnen</translation>
    </message>
    <message>
        <source>This operation is not recorded: what was done will be lost. Leave it?</source>
        <translation>Diese Operation wird nicht aufgezeichnet: was getan wurde, geht verloren. Wirklich verlassen?</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Gespeichert: %1</translation>
    </message>
    <message>
        <source>Save operation</source>
        <translation>Operation speichern</translation>
    </message>
    <message>
        <source>Operations (*.resect)</source>
        <translation>Operationen (*.resect)</translation>
    </message>
    <message>
        <source>%1, %2, %3 stroke</source>
        <translation>%1, %2, %3 Bewegung</translation>
    </message>
    <message>
        <source>%1, %2, %3 strokes</source>
        <translation>%1, %2, %3 Bewegungen</translation>
    </message>
    <message>
        <source>%1  (this one)</source>
        <translation>%1  (diese)</translation>
    </message>
    <message>
        <source>The last %1 are kept; together %2</source>
        <translation>Die letzten %1 werden aufbewahrt; zusammen %2</translation>
    </message>
    <message>
        <source>press the left button and draw: it cuts</source>
        <translation>linke Taste drücken und ziehen: es schneidet</translation>
    </message>
    <message>
        <source>press the left button and draw: it catches and pulls</source>
        <translation>linke Taste drücken und ziehen: er fasst und zieht</translation>
    </message>
    <message>
        <source>hold the left button down: it pushes</source>
        <translation>linke Taste halten: er schiebt</translation>
    </message>
    <message>
        <source>hold the left button down: they close</source>
        <translation>linke Taste halten: sie schließt sich</translation>
    </message>
    <message>
        <source>point at blood or a yellow ring, which marks what bleeds; hold the left button down</source>
        <translation>auf Blut zeigen oder auf einen gelben Ring, der eine Blutung anzeigt; linke Taste halten</translation>
    </message>
    <message>
        <source>point at a yellow ring, which marks what bleeds; press the left button: it clips</source>
        <translation>auf einen gelben Ring zeigen, der eine Blutung anzeigt; linke Taste drücken: er setzt einen Clip</translation>
    </message>
    <message>
        <source>point at a yellow ring, which marks what bleeds; hold the left button down 2 s: they seal</source>
        <translation>auf einen gelben Ring zeigen, der eine Blutung anzeigt; linke Taste 2 s halten: sie versiegelt</translation>
    </message>
    <message>
        <source>point at a yellow ring or a wound; hold the left button down: it presses, and soaks up</source>
        <translation>auf einen gelben Ring oder eine Wunde zeigen; linke Taste halten: er drückt und saugt auf</translation>
    </message>
    <message>
        <source>press the left button and draw: it cuts, and seals what it cuts slowly; P coagulates only</source>
        <translation>linke Taste drücken und ziehen: er schneidet und versiegelt, was er langsam schneidet; P koaguliert nur</translation>
    </message>
    <message>
        <source>press the left button and draw: it takes tissue and leaves vessels</source>
        <translation>linke Taste drücken und ziehen: er entfernt Gewebe und schont Gefäße</translation>
    </message>
    <message>
        <source>press the left button and draw: they grasp and pull</source>
        <translation>linke Taste drücken und ziehen: sie fasst und zieht</translation>
    </message>
    <message>
        <source>hold the left button down: it works</source>
        <translation>linke Taste halten: es arbeitet</translation>
    </message>
    <message>
        <source>Air drawn in</source>
        <translation>Angesaugte Luft</translation>
    </message>
    <message>
        <source>Air that open hepatic veins have drawn in; 200 to 300 ml kill</source>
        <translation>Luft, die offene Lebervenen angesaugt haben; 200 bis 300 ml sind tödlich</translation>
    </message>
    <message>
        <source>drew in air</source>
        <translation>saugte Luft an</translation>
    </message>
    <message>
        <source>bled %1 ml/min</source>
        <translation>blutete mit %1 ml/min</translation>
    </message>
    <message>
        <source>One moment ...</source>
        <translation>Einen Moment ...</translation>
    </message>
    <message>
        <source>Exercise</source>
        <translation>Übung</translation>
    </message>
    <message>
        <source>Maker</source>
        <translation>Werkstatt</translation>
    </message>
    <message>
        <source>Operation</source>
        <translation>Operation</translation>
    </message>
    <message>
        <source>Organ</source>
        <translation>Organ</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Verläufe</translation>
    </message>
    <message>
        <source>Timing</source>
        <translation>Zeiten</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Zeitleiste</translation>
    </message>
    <message>
        <source>Click on the organ to mark a place; right drag turns the view.</source>
        <translation>Klicken Sie auf das Organ, um eine Stelle zu markieren; Ziehen mit der rechten Taste dreht die Ansicht.</translation>
    </message>
    <message>
        <source>The exercise is over: click a point in the list to see that moment again.</source>
        <translation>Die Übung ist beendet: klicken Sie einen Punkt der Liste an, um den Moment noch einmal zu sehen.</translation>
    </message>
    <message>
        <source>The scenario shows how; take an instrument to do it yourself.</source>
        <translation>Das Szenario zeigt, wie es geht; nehmen Sie ein Instrument, um es selbst zu tun.</translation>
    </message>
    <message>
        <source>This is an earlier moment: work on from here, or press End to go back.</source>
        <translation>Dies ist ein früherer Moment: arbeiten Sie von hier aus weiter oder kehren Sie mit Ende zurück.</translation>
    </message>
    <message>
        <source>at the white ring</source>
        <translation>am weißen Ring</translation>
    </message>
    <message>
        <source>, %1 mm long</source>
        <translation>, %1 mm lang</translation>
    </message>
    <message>
        <source>, last stroke %1 mm long</source>
        <translation>, letzter Schnitt %1 mm lang</translation>
    </message>
    <message>
        <source>%1 mm deep (wheel)</source>
        <translation>%1 mm tief (Mausrad)</translation>
    </message>
    <message>
        <source>Take an instrument: press its number, or click it in the list. F1 shows all controls.</source>
        <translation>Nehmen Sie ein Instrument: drücken Sie seine Nummer oder klicken Sie es in der Liste an. F1 zeigt die ganze Bedienung.</translation>
    </message>
    <message>
        <source>%1: drag moves it, the wheel brings it nearer, Shift turns it; Escape puts it back.</source>
        <translation>%1: Ziehen bewegt es, das Mausrad holt es näher, Umschalt dreht es; Esc legt es zurück.</translation>
    </message>
    <message>
        <source>%1 in a handle box: drag it to move it; middle click to turn it.</source>
        <translation>%1 im Kasten: ziehen, um es zu verschieben; mittlere Taste, um es zu drehen.</translation>
    </message>
    <message>
        <source>%1 in a trackball: drag it to turn it; middle click to move it.</source>
        <translation>%1 im Trackball: ziehen, um es zu drehen; mittlere Taste, um es zu verschieben.</translation>
    </message>
    <message>
        <source>, closed for %1 s of about 2</source>
        <translation>, geschlossen seit %1 s von etwa 2</translation>
    </message>
    <message>
        <source>No clip was placed: there is no open vessel within %1 mm of the jaws; point at a yellow ring, or change the depth with the wheel</source>
        <translation>Kein Clip wurde gesetzt: innerhalb von %1 mm um die Backen ist kein offenes Gefäß; zeigen Sie auf einen gelben Ring oder ändern Sie die Tiefe mit dem Mausrad</translation>
    </message>
    <message>
        <source>&amp;Timeline</source>
        <translation>&amp;Zeitleiste</translation>
    </message>
    <message>
        <source>One frame &amp;back</source>
        <translation>Ein Bild &amp;zurück</translation>
    </message>
    <message>
        <source>Shows the frame before</source>
        <translation>Zeigt das Bild davor</translation>
    </message>
    <message>
        <source>One frame &amp;on</source>
        <translation>Ein Bild &amp;weiter</translation>
    </message>
    <message>
        <source>Shows the frame after</source>
        <translation>Zeigt das Bild danach</translation>
    </message>
    <message>
        <source>One second b&amp;ack</source>
        <translation>Eine Sekunde z&amp;urück</translation>
    </message>
    <message>
        <source>Shows what was a second before</source>
        <translation>Zeigt, was eine Sekunde vorher war</translation>
    </message>
    <message>
        <source>One second o&amp;n</source>
        <translation>Eine Sekunde wei&amp;ter</translation>
    </message>
    <message>
        <source>Shows what was a second after</source>
        <translation>Zeigt, was eine Sekunde später war</translation>
    </message>
    <message>
        <source>To the &amp;start</source>
        <translation>Zum &amp;Anfang</translation>
    </message>
    <message>
        <source>Shows the start of the operation</source>
        <translation>Zeigt den Anfang der Operation</translation>
    </message>
    <message>
        <source>To the &amp;end</source>
        <translation>Zum &amp;Ende</translation>
    </message>
    <message>
        <source>Shows the end of the branch</source>
        <translation>Zeigt das Ende des Zweigs</translation>
    </message>
    <message>
        <source>&amp;Play or stop</source>
        <translation>&amp;Abspielen oder anhalten</translation>
    </message>
    <message>
        <source>Plays again what happened after this moment</source>
        <translation>Spielt noch einmal ab, was nach diesem Moment geschah</translation>
    </message>
    <message>
        <source>&amp;Go on from here</source>
        <translation>Von &amp;hier an weiter</translation>
    </message>
    <message>
        <source>Operates from the moment that is shown; what came after it stays as a branch</source>
        <translation>Operiert von dem gezeigten Moment an weiter; was danach kam, bleibt als Zweig</translation>
    </message>
    <message>
        <source>&amp;Compare branches ...</source>
        <translation>Zweige &amp;vergleichen ...</translation>
    </message>
    <message>
        <source>All branches side by side</source>
        <translation>Alle Zweige nebeneinander</translation>
    </message>
    <message>
        <source>A 3D mouse moves and turns what is in hand, or the view.</source>
        <translation>Eine 3D-Maus bewegt und dreht, was in der Hand ist, oder die Ansicht.</translation>
    </message>
    <message>
        <source>No 3D mouse: spacenavd does not run.</source>
        <translation>Keine 3D-Maus: spacenavd läuft nicht.</translation>
    </message>
    <message>
        <source>Branches</source>
        <translation>Zweige</translation>
    </message>
    <message>
        <source>Branch</source>
        <translation>Zweig</translation>
    </message>
    <message>
        <source>Begins at</source>
        <translation>Beginnt bei</translation>
    </message>
    <message>
        <source>Ends at</source>
        <translation>Endet bei</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>Bewegungen</translation>
    </message>
    <message>
        <source>Removed, ml</source>
        <translation>Entfernt, ml</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Stücke</translation>
    </message>
    <message>
        <source>In pieces, ml</source>
        <translation>In Stücken, ml</translation>
    </message>
    <message>
        <source>Cut, cm²</source>
        <translation>Schnitt, cm²</translation>
    </message>
    <message>
        <source>Bared, cm²</source>
        <translation>Freigelegt, cm²</translation>
    </message>
    <message>
        <source>Largest force, N</source>
        <translation>Größte Kraft, N</translation>
    </message>
    <message>
        <source>Double click a name to change it</source>
        <translation>Doppelklick auf einen Namen, um ihn zu ändern</translation>
    </message>
    <message>
        <source>Show the end of this branch</source>
        <translation>Ende dieses Zweigs zeigen</translation>
    </message>
    <message>
        <source>An instrument&apos;s number</source>
        <translation>Nummer eines Instruments</translation>
    </message>
    <message>
        <source>takes it; so does a click on it, or in the list</source>
        <translation>nimmt es; ebenso ein Klick darauf oder in der Liste</translation>
    </message>
    <message>
        <source>Move the mouse</source>
        <translation>Maus bewegen</translation>
    </message>
    <message>
        <source>it hovers over the organ; the arrow is the way its edge faces</source>
        <translation>es schwebt über dem Organ; der Pfeil zeigt, wohin die Schneide weist</translation>
    </message>
    <message>
        <source>Press and draw</source>
        <translation>Drücken und ziehen</translation>
    </message>
    <message>
        <source>it cuts, pulls or pushes until the button is released</source>
        <translation>es schneidet, zieht oder schiebt, bis die Taste losgelassen wird</translation>
    </message>
    <message>
        <source>Wheel, page keys</source>
        <translation>Mausrad, Bild auf / ab</translation>
    </message>
    <message>
        <source>deeper or shallower; Shift + wheel: turn its edge</source>
        <translation>tiefer oder flacher; Umschalt + Mausrad: dreht die Schneide</translation>
    </message>
    <message>
        <source>F while pressing</source>
        <translation>F beim Drücken</translation>
    </message>
    <message>
        <source>leaves it at work there; take another one meanwhile</source>
        <translation>lässt es dort arbeiten; nehmen Sie solange ein anderes</translation>
    </message>
    <message>
        <source>Escape</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>puts it back into the tool box</source>
        <translation>legt es zurück</translation>
    </message>
    <message>
        <source>D, B, T; S</source>
        <translation>D, B, T; S</translation>
    </message>
    <message>
        <source>move it freely, by handle box, trackball; along the surface again</source>
        <translation>frei bewegen, im Kasten, im Trackball; wieder an der Oberfläche</translation>
    </message>
    <message>
        <source>P, the pencil in hand</source>
        <translation>P mit dem HF-Handgriff</translation>
    </message>
    <message>
        <source>hold it down to press the pedal: it coagulates and does not cut</source>
        <translation>gehalten tritt es das Pedal: er koaguliert und schneidet nicht</translation>
    </message>
    <message>
        <source>Drag an instrument</source>
        <translation>Ein Instrument ziehen</translation>
    </message>
    <message>
        <source>move it across the view</source>
        <translation>bewegt es quer zum Blick</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Mausrad</translation>
    </message>
    <message>
        <source>move it in depth; Shift: roll it</source>
        <translation>bewegt es in der Tiefe; Umschalt: rollt es</translation>
    </message>
    <message>
        <source>Shift + drag</source>
        <translation>Umschalt + ziehen</translation>
    </message>
    <message>
        <source>turn it about its tip</source>
        <translation>dreht es um seine Spitze</translation>
    </message>
    <message>
        <source>takes it</source>
        <translation>nimmt es</translation>
    </message>
    <message>
        <source>C</source>
        <translation>C</translation>
    </message>
    <message>
        <source>hold it down to close the scissors</source>
        <translation>gehalten schließt es die Schere</translation>
    </message>
    <message>
        <source>Arrow keys, page keys</source>
        <translation>Pfeiltasten, Bild auf / ab</translation>
    </message>
    <message>
        <source>move in steps; with Shift: turn</source>
        <translation>in Schritten bewegen; mit Umschalt: drehen</translation>
    </message>
    <message>
        <source>Click an instrument</source>
        <translation>Ein Instrument anklicken</translation>
    </message>
    <message>
        <source>handle box, the precise way; middle click: trackball</source>
        <translation>Kasten, die genaue Art; mittlere Taste: Trackball</translation>
    </message>
    <message>
        <source>Click elsewhere / Escape</source>
        <translation>Daneben klicken / Esc</translation>
    </message>
    <message>
        <source>let go / back into the tool box</source>
        <translation>loslassen / zurücklegen</translation>
    </message>
    <message>
        <source>Right drag, Ctrl + wheel</source>
        <translation>Rechts ziehen, Strg + Mausrad</translation>
    </message>
    <message>
        <source>look round, zoom to the pointer; L, then a click: look there</source>
        <translation>umherblicken, zum Zeiger vergrößern; L, dann ein Klick: dorthin blicken</translation>
    </message>
    <message>
        <source>Ctrl + 1 2 3 4</source>
        <translation>Strg + 1 2 3 4</translation>
    </message>
    <message>
        <source>surgeon, assistant, top, laparoscope</source>
        <translation>Chirurg, Assistenz, von oben, Laparoskop</translation>
    </message>
    <message>
        <source>Ctrl + Z</source>
        <translation>Strg + Z</translation>
    </message>
    <message>
        <source>takes the last stroke back; with Shift does it again</source>
        <translation>nimmt die letzte Bewegung zurück; mit Umschalt wiederholt es ihn</translation>
    </message>
    <message>
        <source>Drag in the timeline</source>
        <translation>In der Zeitleiste ziehen</translation>
    </message>
    <message>
        <source>shows any earlier moment; End: back to the end</source>
        <translation>zeigt jeden früheren Moment; Ende: zurück ans Ende</translation>
    </message>
    <message>
        <source>Ctrl + S, Ctrl + O</source>
        <translation>Strg + S, Strg + O</translation>
    </message>
    <message>
        <source>save the operation; open one and go on</source>
        <translation>Operation speichern; eine öffnen und fortsetzen</translation>
    </message>
    <message>
        <source>Ctrl + T</source>
        <translation>Strg + T</translation>
    </message>
    <message>
        <source>exercises with a goal, guidance and a result</source>
        <translation>Übungen mit Ziel, Führung und Ergebnis</translation>
    </message>
    <message>
        <source>P, Ctrl + N</source>
        <translation>P, Strg + N</translation>
    </message>
    <message>
        <source>play the scenario&apos;s motions; begin again</source>
        <translation>Bewegungen des Szenarios abspielen; neu beginnen</translation>
    </message>
    <message>
        <source>Space, A</source>
        <translation>Leertaste, A</translation>
    </message>
    <message>
        <source>bring back view and instruments; show all there is</source>
        <translation>Ansicht und Instrumente zurückholen; alles zeigen</translation>
    </message>
    <message>
        <source>F2</source>
        <translation>F2</translation>
    </message>
    <message>
        <source>the laboratory: cells, surface, timing</source>
        <translation>das Labor: Zellen, Oberfläche, Zeiten</translation>
    </message>
    <message>
        <source>Controls</source>
        <translation>Bedienung</translation>
    </message>
    <message>
        <source>Take an instrument and work on the organ</source>
        <translation>Nehmen Sie ein Instrument und arbeiten Sie am Organ</translation>
    </message>
    <message>
        <source>Click to begin. F1 shows this again.</source>
        <translation>Klicken Sie, um zu beginnen. F1 zeigt dies noch einmal.</translation>
    </message>
    <message>
        <source>Exercises with a goal and a result (Ctrl+T)</source>
        <translation>Übungen mit Ziel und Ergebnis (Strg+T)</translation>
    </message>
    <message>
        <source>What to do next</source>
        <translation>Was als Nächstes zu tun ist</translation>
    </message>
    <message>
        <source>The simulation is slower than real time. Larger cells are faster; the operation begins again, and what was done stays in File &gt; Recorded operations</source>
        <translation>Die Simulation ist langsamer als die Wirklichkeit. Größere Zellen sind schneller; die Operation beginnt neu, und was getan wurde, bleibt in Datei &gt; Aufgezeichnete Operationen</translation>
    </message>
    <message>
        <source>Make it smooth: cells of %1 mm</source>
        <translation>Flüssig machen: Zellen von %1 mm</translation>
    </message>
    <message>
        <source>Key %1 takes it in hand; Escape puts it back.</source>
        <translation>Taste %1 nimmt es in die Hand; Esc legt es zurück.</translation>
    </message>
    <message>
        <source>%1   (at work)</source>
        <translation>%1   (aktiv)</translation>
    </message>
    <message>
        <source>Open organ</source>
        <translation>Organ öffnen</translation>
    </message>
    <message>
        <source>Reading ...</source>
        <translation>Wird gelesen ...</translation>
    </message>
    <message>
        <source>From below, from the front and from the left; the patient&apos;s right is on the left</source>
        <translation>Von unten, von vorn und von links; die rechte Seite des Patienten ist links</translation>
    </message>
    <message>
        <source>metre</source>
        <translation>Meter</translation>
    </message>
    <message>
        <source>centimetre</source>
        <translation>Zentimeter</translation>
    </message>
    <message>
        <source>millimetre</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>micrometre</source>
        <translation>Mikrometer</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>What the file&apos;s numbers count; the guess is the one that gives an organ&apos;s size</source>
        <translation>Was die Zahlen der Datei bedeuten; vermutet wird, womit das Organ eine übliche Größe hat</translation>
    </message>
    <message>
        <source>Of what is opened, in that unit</source>
        <translation>Von dem, was geöffnet wird, in dieser Einheit</translation>
    </message>
    <message>
        <source>One unit of the file is a</source>
        <translation>Eine Einheit der Datei ist ein</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>all parts together</source>
        <translation>alle Teile zusammen</translation>
    </message>
    <message>
        <source>One named part of the file, or all of them as one body</source>
        <translation>Ein benannter Teil der Datei, oder alle als ein Körper</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>Close holes</source>
        <translation>Löcher schließen</translation>
    </message>
    <message>
        <source>An open surface has no inside; its holes can be closed</source>
        <translation>Eine offene Oberfläche hat kein Inneres; ihre Löcher lassen sich schließen</translation>
    </message>
    <message>
        <source>Side of the cells: smaller shows and cuts finer, and costs more</source>
        <translation>Seite der Zellen: kleinere zeigen und schneiden feiner und kosten mehr</translation>
    </message>
    <message>
        <source>Particles that the organ will have; more of them cost more time</source>
        <translation>Partikel, die das Organ haben wird; mehr davon kosten mehr Zeit</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Zellgröße</translation>
    </message>
    <message>
        <source>x left, y front, z feet: as the room</source>
        <translation>x links, y vorn, z Füße: wie der Raum</translation>
    </message>
    <message>
        <source>x left, y back, z head: LPS, as DICOM</source>
        <translation>x links, y hinten, z Kopf: LPS, wie DICOM</translation>
    </message>
    <message>
        <source>x right, y front, z head: RAS, as 3D Slicer</source>
        <translation>x rechts, y vorn, z Kopf: RAS, wie 3D Slicer</translation>
    </message>
    <message>
        <source>x left, y head, z front: as glTF</source>
        <translation>x links, y Kopf, z vorn: wie glTF</translation>
    </message>
    <message>
        <source>Where the file&apos;s axes point in the patient, who lies on the back</source>
        <translation>Wohin die Achsen der Datei im Patienten zeigen, der auf dem Rücken liegt</translation>
    </message>
    <message>
        <source>Axes of the file</source>
        <translation>Achsen der Datei</translation>
    </message>
    <message>
        <source>Turn about X, Y, Z</source>
        <translation>Drehung um X, Y, Z</translation>
    </message>
    <message>
        <source>Makes the organ; what is operated on now is replaced when it is ready</source>
        <translation>Macht das Organ; was jetzt operiert wird, wird ersetzt, sobald es fertig ist</translation>
    </message>
    <message>
        <source>Nothing changes</source>
        <translation>Nichts ändert sich</translation>
    </message>
    <message>
        <source>the patient&apos;s left</source>
        <translation>nach links vom Patienten</translation>
    </message>
    <message>
        <source>up</source>
        <translation>nach oben</translation>
    </message>
    <message>
        <source>the patient&apos;s feet</source>
        <translation>zu den Füßen des Patienten</translation>
    </message>
    <message>
        <source>Turns the organ about the axis that points to %1</source>
        <translation>Dreht das Organ um die Achse %1</translation>
    </message>
    <message>
        <source>%1 mm long, skin %2 cm²</source>
        <translation>%1 mm lang, Haut %2 cm²</translation>
    </message>
    <message>
        <source> with its cavities</source>
        <translation> mit seinen Hohlräumen</translation>
    </message>
    <message>
        <source>; no organ is so large</source>
        <translation>; kein Organ ist so groß</translation>
    </message>
    <message>
        <source>; no organ is so small</source>
        <translation>; kein Organ ist so klein</translation>
    </message>
    <message>
        <source>the report cannot be read</source>
        <translation>der Bericht lässt sich nicht lesen</translation>
    </message>
    <message>
        <source>Which one file is the organ? Say it in the table; then it can be opened.</source>
        <translation>Welche eine Datei ist das Organ? Geben Sie es in der Tabelle an; dann lässt es sich öffnen.</translation>
    </message>
    <message>
        <source>Which label is the organ? Say it in the table; then it can be opened.</source>
        <translation>Welches Label ist das Organ? Geben Sie es in der Tabelle an; dann lässt es sich öffnen.</translation>
    </message>
    <message>
        <source>%1 label images</source>
        <translation>%1 Labelbilder</translation>
    </message>
    <message>
        <source>metre, converted from the file&apos;s own unit</source>
        <translation>Meter, umgerechnet aus der Einheit der Datei</translation>
    </message>
    <message>
        <source>by their roles</source>
        <translation>nach ihren Rollen</translation>
    </message>
    <message>
        <source>Title of the operation</source>
        <translation>Titel der Operation</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Aufgabe</translation>
    </message>
    <message>
        <source>Since the operation began</source>
        <translation>Seit Beginn der Operation</translation>
    </message>
    <message>
        <source>Bleeding</source>
        <translation>Blutung</translation>
    </message>
    <message>
        <source>Blood that leaves the vessels at present</source>
        <translation>Blut, das die Gefäße zurzeit verlässt</translation>
    </message>
    <message>
        <source>Severity</source>
        <translation>Schwere</translation>
    </message>
    <message>
        <source>Grade of the present bleeding on the VIBe scale, by its rate</source>
        <translation>Grad der gegenwärtigen Blutung auf der VIBe-Skala, nach ihrer Rate</translation>
    </message>
    <message>
        <source>Removed</source>
        <translation>Entfernt</translation>
    </message>
    <message>
        <source>Tissue taken out</source>
        <translation>Herausgenommenes Gewebe</translation>
    </message>
    <message>
        <source>Cut off</source>
        <translation>Abgetrennt</translation>
    </message>
    <message>
        <source>Pieces that hang together with the organ no more</source>
        <translation>Stücke, die nicht mehr mit dem Organ zusammenhängen</translation>
    </message>
    <message>
        <source>Cut area</source>
        <translation>Schnittfläche</translation>
    </message>
    <message>
        <source>Area of all cuts</source>
        <translation>Fläche aller Schnitte</translation>
    </message>
    <message>
        <source>Least distance of a structure from a cut</source>
        <translation>Kleinster Abstand einer Struktur von einem Schnitt</translation>
    </message>
    <message>
        <source>What the hand feels on the instrument</source>
        <translation>Was die Hand am Instrument spürt</translation>
    </message>
    <message>
        <source>The largest force so far, and the instrument that met it</source>
        <translation>Die größte Kraft bisher, und das Instrument, an dem sie auftrat</translation>
    </message>
    <message>
        <source>%1 ml/min</source>
        <translation>%1 ml/min</translation>
    </message>
    <message>
        <source>%1 (%2 of 4)</source>
        <translation>%1 (%2 von 4)</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>mild</source>
        <translation>leicht</translation>
    </message>
    <message>
        <source>moderate</source>
        <translation>mäßig</translation>
    </message>
    <message>
        <source>severe</source>
        <translation>stark</translation>
    </message>
    <message>
        <source>life-threatening</source>
        <translation>lebensbedrohlich</translation>
    </message>
    <message>
        <source>%1 piece, %2</source>
        <translation>%1 Stück, %2</translation>
    </message>
    <message>
        <source>%1 pieces, %2</source>
        <translation>%1 Stücke, %2</translation>
    </message>
    <message>
        <source>%1 piece of %2 ml</source>
        <translation>%1 Stück von %2 ml</translation>
    </message>
    <message>
        <source>%1 pieces of %2 ml</source>
        <translation>%1 Stücke von %2 ml</translation>
    </message>
    <message>
        <source>debris %1 ml</source>
        <translation>Reste %1 ml</translation>
    </message>
    <message>
        <source>cut %1 cm²</source>
        <translation>Schnitt %1 cm²</translation>
    </message>
    <message>
        <source>bared %1 cm²</source>
        <translation>freigelegt %1 cm²</translation>
    </message>
    <message>
        <source>margin of %1 %2 mm</source>
        <translation>Rand (%1) %2 mm</translation>
    </message>
    <message>
        <source>Built-in %1</source>
        <translation>Mitgeliefert: %1</translation>
    </message>
    <message>
        <source>Particles, triangles of the surface, and the volume that is left</source>
        <translation>Partikel, Dreiecke der Oberfläche und das verbleibende Volumen</translation>
    </message>
    <message>
        <source>Colour value at which the surface is drawn: lower swells it, higher shrinks it</source>
        <translation>Farbwert, bei dem die Oberfläche gezeichnet wird: ein kleinerer bläht sie, ein größerer schrumpft sie</translation>
    </message>
    <message>
        <source>Iso %1</source>
        <translation>Iso %1</translation>
    </message>
    <message>
        <source>Nodes of the surface&apos;s grid per cell: 2 shows the skin well</source>
        <translation>Knoten des Oberflächengitters je Zelle: 2 zeigt die Haut gut</translation>
    </message>
    <message>
        <source>Refinement</source>
        <translation>Verfeinerung</translation>
    </message>
    <message>
        <source>Elastic tissue</source>
        <translation>Elastisches Gewebe</translation>
    </message>
    <message>
        <source>Tissue gives way, is pulled and opens; without it, it stands still and what is touched goes</source>
        <translation>Gewebe gibt nach, lässt sich ziehen und klafft; sonst ruht es, und was berührt wird, verschwindet</translation>
    </message>
    <message>
        <source>The organ whole again, with this spacing, refinement and kind of tissue</source>
        <translation>Das Organ wieder unversehrt, mit dieser Zellgröße, Verfeinerung und Art des Gewebes</translation>
    </message>
    <message>
        <source>Begin again to apply</source>
        <translation>Neu beginnen und anwenden</translation>
    </message>
    <message>
        <source>Begin again</source>
        <translation>Neu beginnen</translation>
    </message>
    <message>
        <source>What is operated on: %1</source>
        <translation>Was operiert wird: %1</translation>
    </message>
    <message>
        <source>%L1 particles
%L2 triangles
%3 ml</source>
        <translation>%L1 Partikel
%L2 Dreiecke
%3 ml</translation>
    </message>
    <message>
        <source>Tissue taken out since the organ was whole, and how it came about</source>
        <translation>Gewebe, das entfernt wurde, seit das Organ unversehrt war, und wie es dazu kam</translation>
    </message>
    <message>
        <source>Blood lost %1 ml, now %2 ml/min%3</source>
        <translation>Blutverlust %1 ml, jetzt %2 ml/min%3</translation>
    </message>
    <message>
        <source>%L1 particle, %2 %</source>
        <translation>%L1 Partikel, %2 %</translation>
    </message>
    <message>
        <source>%L1 particles, %2 %</source>
        <translation>%L1 Partikel, %2 %</translation>
    </message>
    <message>
        <source>What the hand would feel, over the last ten seconds; the most so far, and the instrument that met it</source>
        <translation>Was die Hand spüren würde, in den letzten zehn Sekunden; das Größte bisher, und das Instrument dazu</translation>
    </message>
    <message>
        <source>at most %1 N</source>
        <translation>höchstens %1 N</translation>
    </message>
    <message>
        <source>Median time of each stage of a step over the last second</source>
        <translation>Mittlere Zeit jeder Stufe eines Schritts in der letzten Sekunde</translation>
    </message>
    <message>
        <source>Slower than real time: &quot;%1&quot; takes most. A larger spacing helps.</source>
        <translation>Langsamer als die Wirklichkeit: &quot;%1&quot; braucht am meisten. Größere Zellen helfen.</translation>
    </message>
    <message>
        <source>Drawing is slow here: a smaller window or a graphics card helps.</source>
        <translation>Das Zeichnen ist hier langsam: ein kleineres Fenster oder eine Grafikkarte hilft.</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>at rest</source>
        <translation>in Ruhe</translation>
    </message>
    <message>
        <source>Real time</source>
        <translation>Echtzeit</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>What it is</source>
        <translation>Was es ist</translation>
    </message>
    <message>
        <source>Vessels bleed when they are cut; tumours and cysts are tissue of their own; a cavity holds no tissue</source>
        <translation>Gefäße bluten, wenn sie durchtrennt werden; Tumoren und Zysten sind eigenes Gewebe; ein Hohlraum enthält kein Gewebe</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>weggelassen</translation>
    </message>
    <message>
        <source>the organ&apos;s surface</source>
        <translation>die Oberfläche des Organs</translation>
    </message>
    <message>
        <source>What is opened; drag to turn it. L, R: the patient&apos;s left and right; A, P: front and back; H, F: head and feet</source>
        <translation>Was geöffnet wird; ziehen, um es zu drehen. L, R: links und rechts vom Patienten; A, P: vorn und hinten; H, F: Kopf und Füße</translation>
    </message>
    <message>
        <source>Branch %1 begins here</source>
        <translation>Zweig %1 beginnt hier</translation>
    </message>
    <message>
        <source>Stroke %1</source>
        <translation>Bewegung %1</translation>
    </message>
    <message>
        <source>, %L1 particle removed</source>
        <translation>, %L1 Partikel entfernt</translation>
    </message>
    <message>
        <source>, %L1 particles removed</source>
        <translation>, %L1 Partikel entfernt</translation>
    </message>
    <message>
        <source>, %L1 bonds cut</source>
        <translation>, %L1 Bindungen zerschnitten</translation>
    </message>
    <message>
        <source>, %L1 bonds torn</source>
        <translation>, %L1 Bindungen zerrissen</translation>
    </message>
    <message>
        <source>To the start of the operation</source>
        <translation>Zum Anfang der Operation</translation>
    </message>
    <message>
        <source>One frame back (comma)</source>
        <translation>Ein Bild zurück (Komma)</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Plays again what happened after this moment (Ctrl+Space)</source>
        <translation>Spielt noch einmal ab, was nach diesem Moment geschah (Strg+Leertaste)</translation>
    </message>
    <message>
        <source>One frame on (point)</source>
        <translation>Ein Bild weiter (Punkt)</translation>
    </message>
    <message>
        <source>To the end of this branch (End)</source>
        <translation>Zum Ende dieses Zweigs (Ende)</translation>
    </message>
    <message>
        <source>Speed of playing</source>
        <translation>Geschwindigkeit des Abspielens</translation>
    </message>
    <message>
        <source>The moment that is shown, and the end of this branch</source>
        <translation>Der gezeigte Moment und das Ende dieses Zweigs</translation>
    </message>
    <message>
        <source>Branches: one begins wherever somebody went back and worked on from there</source>
        <translation>Zweige: einer beginnt überall, wo jemand zurückging und von dort weiterarbeitete</translation>
    </message>
    <message>
        <source>Compare ...</source>
        <translation>Vergleichen ...</translation>
    </message>
    <message>
        <source>All branches side by side (Ctrl+B)</source>
        <translation>Alle Zweige nebeneinander (Strg+B)</translation>
    </message>
    <message>
        <source>Go on from here</source>
        <translation>Von hier an weiter</translation>
    </message>
    <message>
        <source>Operates from this moment; the rest stays as a branch (Ctrl+Return)</source>
        <translation>Operiert von diesem Moment an weiter; der Rest bleibt als Zweig (Strg+Eingabe)</translation>
    </message>
    <message>
        <source>Memory for the states from which any moment is shown. When it is full, old moments take longer to reach (option --history)</source>
        <translation>Speicher für die Zustände, aus denen jeder Moment gezeigt wird. Ist er voll, dauert der Weg zu alten Momenten länger (Option --history)</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>going there ...</source>
        <translation>geht dorthin ...</translation>
    </message>
    <message>
        <source>Paused: take an instrument to go on</source>
        <translation>Angehalten: nehmen Sie ein Instrument, um fortzufahren</translation>
    </message>
    <message>
        <source>Branch %1</source>
        <translation>Zweig %1</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>B&amp;reathing</source>
        <translation>At&amp;mung</translation>
    </message>
    <message>
        <source>Whether the patient breathes; switched off, the breath is held when it has ended</source>
        <translation>Ob der Patient atmet; ausgeschaltet wird der Atem angehalten, sobald ausgeatmet ist</translation>
    </message>
    <message>
        <source>Sou&amp;nd</source>
        <translation>&amp;Ton</translation>
    </message>
    <message>
        <source>Suction, energy devices, and the monitor&apos;s beep at each beat of the heart</source>
        <translation>Sauger, Hochfrequenzgeräte und der Piepton des Monitors bei jedem Herzschlag</translation>
    </message>
    <message>
        <source>This computer has no device for sound</source>
        <translation>Dieser Computer hat kein Gerät für die Tonausgabe</translation>
    </message>
    <message>
        <source>S&amp;urgical lamp</source>
        <translation>OP-La&amp;mpe</translation>
    </message>
    <message>
        <source>At the patient&apos;s &amp;right</source>
        <translation>&amp;Rechts vom Patienten</translation>
    </message>
    <message>
        <source>At the patient&apos;s &amp;left</source>
        <translation>&amp;Links vom Patienten</translation>
    </message>
    <message>
        <source>Over the &amp;surgeon&apos;s shoulder</source>
        <translation>Über der Schulter des &amp;Chirurgen</translation>
    </message>
    <message>
        <source>Straight &amp;above</source>
        <translation>Senkrecht &amp;darüber</translation>
    </message>
    <message>
        <source>Moves the main lamp there; in a laparoscope&apos;s view it does not shine</source>
        <translation>Bringt die Hauptlampe dorthin; in der Sicht eines Laparoskops leuchtet sie nicht</translation>
    </message>
    <message>
        <source>%1 ml/min from vessels</source>
        <translation>%1 ml/min aus Gefäßen</translation>
    </message>
    <message>
        <source>%1 of %2 mm %3</source>
        <translation>%1, %2 mm; das Gefäß %3</translation>
    </message>
    <message>
        <source>A clip was placed: the %1</source>
        <translation>Ein Clip wurde gesetzt: %1</translation>
    </message>
    <message>
        <source>Sealed: the %1</source>
        <translation>Versiegelt: %1</translation>
    </message>
    <message>
        <source>Clips</source>
        <translation>Clips</translation>
    </message>
    <message>
        <source>Clips on vessels</source>
        <translation>Clips auf Gefäßen</translation>
    </message>
    <message>
        <source>bled %1 ml/min, and %2 now</source>
        <translation>blutete mit %1 ml/min, jetzt mit %2</translation>
    </message>
    <message>
        <source>The jaws did not close: hold the button down for half a second</source>
        <translation>Das Maul hat sich nicht geschlossen: die Taste eine halbe Sekunde lang halten</translation>
    </message>
    <message>
        <source>Take an instrument: press its number, or click it in the list. P shows how the scenario does it, F1 all controls.</source>
        <translation>Nehmen Sie ein Instrument: seine Nummer drücken oder es in der Liste anklicken. P zeigt, wie das Szenario es macht, F1 alle Bedienungen.</translation>
    </message>
    <message>
        <source>The patient has lost %1 ml, %2 % of the blood: haemorrhage of class %3 of 4</source>
        <translation>Der Patient hat %1 ml verloren, %2 % des Blutes: Blutverlust der Klasse %3 von 4</translation>
    </message>
    <message>
        <source>The scenario has ended. </source>
        <translation>Das Szenario ist zu Ende. </translation>
    </message>
    <message>
        <source>Take an instrument to go on, or drag the mark in the timeline to look back.</source>
        <translation>Nehmen Sie ein Instrument, um weiterzumachen, oder ziehen Sie die Marke in der Zeitleiste, um zurückzuschauen.</translation>
    </message>
    <message>
        <source>%1 (%2 %)</source>
        <translation>%1 (%2 %)</translation>
    </message>
    <message>
        <source>All blood that has left the vessels, and its share of all blood of the patient</source>
        <translation>Alles Blut, das die Gefäße verlassen hat, und sein Anteil am Blut des Patienten</translation>
    </message>
    <message>
        <source>No clip was placed: this organ has no vessels</source>
        <translation>Kein Clip wurde gesetzt: dieses Organ hat keine Gefäße</translation>
    </message>
    <message>
        <source>there is nothing for it to close, since this organ has no vessels</source>
        <translation>hier gibt es nichts zu verschließen, da dieses Organ keine Gefäße hat</translation>
    </message>
    <message>
        <source>A clip was placed on the %1 of %2 mm, which did not bleed</source>
        <translation>Ein Clip wurde gesetzt: %1 von %2 mm; das Gefäß blutete nicht</translation>
    </message>
    <message>
        <source>Report being written ...</source>
        <translation>Bericht wird geschrieben ...</translation>
    </message>
    <message>
        <source>The debrief with its pictures takes about as long as the attempt</source>
        <translation>Die Auswertung mit ihren Bildern dauert etwa so lange wie der Versuch</translation>
    </message>
    <message>
        <source>Practised; the next attempt counts</source>
        <translation>Geübt; der nächste Versuch zählt</translation>
    </message>
    <message>
        <source>point at a vessel; hold the left button down half a second: it clips</source>
        <translation>auf ein Gefäß zeigen; linke Taste eine halbe Sekunde halten: der Clip wird gesetzt</translation>
    </message>
    <message>
        <source>point at a vessel or a raw surface; hold the left button down 2 s: they seal</source>
        <translation>auf ein Gefäß oder eine Wundfläche zeigen; linke Taste 2 s halten: sie verschließt</translation>
    </message>
    <message>
        <source>The scenario has ended: %1 ml of blood lost; bleeding now: %2 ml/min, %3. </source>
        <translation>Das Szenario ist zu Ende: %1 ml Blut verloren; Blutung jetzt: %2 ml/min, %3. </translation>
    </message>
    <message>
        <source>Inflow</source>
        <translation>Zufluss</translation>
    </message>
    <message>
        <source>Whether the clamp closes the inflow of the liver, and for how long it has in all</source>
        <translation>Ob die Klemme den Zufluss der Leber verschließt, und wie lange insgesamt</translation>
    </message>
    <message>
        <source>closed, %1 s</source>
        <translation>verschlossen, %1 s</translation>
    </message>
    <message>
        <source>open (was closed %1 s)</source>
        <translation>offen (war %1 s verschlossen)</translation>
    </message>
    <message>
        <source>The inflow of the liver is closed</source>
        <translation>Der Zufluss der Leber ist verschlossen</translation>
    </message>
    <message>
        <source>The inflow of the liver is open again</source>
        <translation>Der Zufluss der Leber ist wieder offen</translation>
    </message>
    <message>
        <source>hold the left button down beside the liver: it closes the inflow, or opens it again</source>
        <translation>linke Taste neben der Leber halten: sie verschließt den Zufluss oder öffnet ihn wieder</translation>
    </message>
    <message>
        <source>%1 mm deep, the least for cells of this size (wheel)</source>
        <translation>%1 mm tief, das Mindeste bei Zellen dieser Größe (Mausrad)</translation>
    </message>
    <message>
        <source>%1 mm deep, the most for this instrument (wheel)</source>
        <translation>%1 mm tief, das Meiste für dieses Instrument (Mausrad)</translation>
    </message>
    <message>
        <source>%1   (touches nothing)</source>
        <translation>%1   (berührt nichts)</translation>
    </message>
    <message>
        <source>%1 of debris</source>
        <translation>%1 Reste</translation>
    </message>
    <message>
        <source>Surgeon&apos;s hands</source>
        <translation>Hände des Chirurgen</translation>
    </message>
    <message>
        <source>Gloved hands hold the instruments in the opened abdomen; they hide what is below them</source>
        <translation>Behandschuhte Hände halten die Instrumente im geöffneten Bauch; sie verdecken, was unter ihnen liegt</translation>
    </message>
    <message>
        <source>%1 holds nothing: it slipped off, or met no tissue. Take it again.</source>
        <translation>%1 hält nichts: abgerutscht, oder kein Gewebe getroffen. Noch einmal nehmen.</translation>
    </message>
    <message>
        <source>A browser should show it now; the file is %1</source>
        <translation>Ein Browser sollte sie jetzt zeigen; die Datei ist %1</translation>
    </message>
    <message>
        <source>%1 at work%2; F leaves it there.</source>
        <translation>%1 arbeitet%2; F lässt es dort.</translation>
    </message>
    <message>
        <source>%1: %2%3.</source>
        <translation>%1: %2%3.</translation>
    </message>
    <message>
        <source>Looking back (End: to the end)</source>
        <translation>Rückblick (Ende: zum Ende)</translation>
    </message>
</context>
</TS>
