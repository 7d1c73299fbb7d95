<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
  <context>
    <name>HexFeature</name>
    <message>
      <source>%(count)s hexahedra in %(seconds).1f s (%(method)s)
scaled Jacobian: worst %(worst).3f, mean %(mean).3f</source>
      <translation>%(count)s Hexaeder in %(seconds).1f s (%(method)s)
skalierte Jacobi-Zahl: schlechteste %(worst).3f, mittlere %(mean).3f</translation>
    </message>
    <message>
      <source>%(mesh)s (%(number)d of %(count)d): %(step)s, %(seconds).1f s</source>
      <translation>%(mesh)s (%(number)d von %(count)d): %(step)s, %(seconds).1f s</translation>
    </message>
    <message>
      <source>%(meshed)d of %(all)d meshed; summary.csv is in %(folder)s</source>
      <translation>%(meshed)d von %(all)d vernetzt; summary.csv liegt in %(folder)s</translation>
    </message>
    <message>
      <source>%(some)s of %(all)s elements</source>
      <translation>%(some)s von %(all)s Elementen</translation>
    </message>
    <message>
      <source>%(step)s, %(seconds).1f s</source>
      <translation>%(step)s, %(seconds).1f s</translation>
    </message>
    <message>
      <source>%1 and %2 share a border</source>
      <translation>%1 und %2 haben eine gemeinsame Grenze</translation>
    </message>
    <message>
      <source>%1 elements stay inverted</source>
      <translation>%1 Elemente bleiben umgestülpt</translation>
    </message>
    <message>
      <source>%1 elements stay inverted or folded</source>
      <translation>%1 Elemente bleiben umgestülpt oder gefaltet</translation>
    </message>
    <message>
      <source>%1 must be a number, a text, true or false</source>
      <translation>%1 muss eine Zahl, ein Text, wahr oder falsch sein</translation>
    </message>
    <message>
      <source>%d regions, %d feature lines</source>
      <translation>%d Gebiete, %d Merkmalslinien</translation>
    </message>
    <message>
      <source>%d regions, %d feature lines so far, being repaired ...</source>
      <translation>bisher %d Gebiete, %d Merkmalslinien, werden noch repariert ...</translation>
    </message>
    <message>
      <source>'%1' cannot be opened</source>
      <translation>'%1' lässt sich nicht öffnen</translation>
    </message>
    <message>
      <source>'%1' is a directory</source>
      <translation>'%1' ist ein Ordner</translation>
    </message>
    <message>
      <source>'%1' is empty</source>
      <translation>'%1' ist leer</translation>
    </message>
    <message>
      <source>'%1' is no CAD file that can be read</source>
      <translation>'%1' ist keine lesbare CAD-Datei</translation>
    </message>
    <message>
      <source>0: each part gets a size of its own, for about 3,000 elements</source>
      <translation>0: jedes Teil bekommt seine eigene Größe, für etwa 3000 Elemente</translation>
    </message>
    <message>
      <source>1 is best</source>
      <translation>1 ist am besten</translation>
    </message>
    <message>
      <source>1: 8-node hexahedra, 2: 20-node hexahedra</source>
      <translation>1: Hexaeder mit 8 Knoten, 2: mit 20 Knoten</translation>
    </message>
    <message>
      <source>Add files ...</source>
      <translation>Dateien hinzufügen ...</translation>
    </message>
    <message>
      <source>Add the lines that the selected solid's mesh starts from, the borders of its blocks, as an object</source>
      <translation>Die Linien, von denen das Netz des gewählten Körpers ausgeht (die Ränder seiner Blöcke), als Objekt hinzufügen</translation>
    </message>
    <message>
      <source>Add the polycube that the selected solid is straightened into, beside it, as an object</source>
      <translation>Den Polycube, zu dem der gewählte Körper begradigt wird, daneben als Objekt hinzufügen</translation>
    </message>
    <message>
      <source>All-hexahedral meshes of CAD solids</source>
      <translation>Reine Hexaedernetze von CAD-Körpern</translation>
    </message>
    <message>
      <source>Another task is open: close it first.</source>
      <translation>Eine andere Aufgabe ist offen: bitte erst schließen.</translation>
    </message>
    <message>
      <source>Batch</source>
      <translation>Stapel</translation>
    </message>
    <message>
      <source>Batch of hex meshes</source>
      <translation>Stapel von Hexaedernetzen</translation>
    </message>
    <message>
      <source>CAD edges that mesh edges follow: sharp ones, or all</source>
      <translation>CAD-Kanten, denen Netzkanten folgen: scharfe oder alle</translation>
    </message>
    <message>
      <source>CAD files</source>
      <translation>CAD-Dateien</translation>
    </message>
    <message>
      <source>Cancel</source>
      <translation>Abbrechen</translation>
    </message>
    <message>
      <source>Cannot make the folder: %s</source>
      <translation>Der Ordner lässt sich nicht anlegen: %s</translation>
    </message>
    <message>
      <source>Cannot write summary.csv: %s</source>
      <translation>summary.csv lässt sich nicht schreiben: %s</translation>
    </message>
    <message>
      <source>Choose ...</source>
      <translation>Wählen ...</translation>
    </message>
    <message>
      <source>Close</source>
      <translation>Schließen</translation>
    </message>
    <message>
      <source>Colour a new mesh by element quality</source>
      <translation>Ein neues Netz nach Elementqualität färben</translation>
    </message>
    <message>
      <source>Colour scale</source>
      <translation>Farbskala</translation>
    </message>
    <message>
      <source>Colour the elements of a hex mesh by quality, show bad ones alone, cut the mesh open</source>
      <translation>Die Elemente eines Hexaedernetzes nach Qualität färben, schlechte allein zeigen, das Netz aufschneiden</translation>
    </message>
    <message>
      <source>Colour the part by label while the panel is open</source>
      <translation>Das Teil nach Richtungen färben, solange das Fenster offen ist</translation>
    </message>
    <message>
      <source>Crease angle of triangle surfaces (degrees)</source>
      <translation>Knickwinkel von Dreiecksflächen (Grad)</translation>
    </message>
    <message>
      <source>Cut open</source>
      <translation>Aufschneiden</translation>
    </message>
    <message>
      <source>Defaults of a new mesh</source>
      <translation>Vorgaben für ein neues Netz</translation>
    </message>
    <message>
      <source>Each solid leaves a FreeCAD document with its mesh, a .unv file and a report.</source>
      <translation>Jeder Körper ergibt ein FreeCAD-Dokument mit seinem Netz, eine .unv-Datei und einen Bericht.</translation>
    </message>
    <message>
      <source>Edges to follow</source>
      <translation>Kanten im Netz</translation>
    </message>
    <message>
      <source>Element order</source>
      <translation>Elementordnung</translation>
    </message>
    <message>
      <source>Element size</source>
      <translation>Elementgröße</translation>
    </message>
    <message>
      <source>Element size, 0: chosen for each</source>
      <translation>Elementgröße, 0: für jedes Teil gewählt</translation>
    </message>
    <message>
      <source>Elements below 0.2</source>
      <translation>Elemente unter 0,2</translation>
    </message>
    <message>
      <source>Elements by scaled Jacobian, from 0 (left) to 1; heights are square roots of counts</source>
      <translation>Elemente nach skalierter Jacobi-Determinante, von 0 (links) bis 1; die Höhe ist die Wurzel der Anzahl</translation>
    </message>
    <message>
      <source>Export mesh</source>
      <translation>Netz exportieren</translation>
    </message>
    <message>
      <source>Faces to look at (selected in the view): %s</source>
      <translation>Zu prüfende Flächen (in der Ansicht ausgewählt): %s</translation>
    </message>
    <message>
      <source>Farthest from the CAD</source>
      <translation>Größter Abstand vom CAD</translation>
    </message>
    <message>
      <source>Feature lines</source>
      <translation>Merkmalslinien</translation>
    </message>
    <message>
      <source>File</source>
      <translation>Datei</translation>
    </message>
    <message>
      <source>Files</source>
      <translation>Dateien</translation>
    </message>
    <message>
      <source>Fine elements on the left, coarse ones on the right</source>
      <translation>Links feine Elemente, rechts grobe</translation>
    </message>
    <message>
      <source>Give files and a folder.</source>
      <translation>Bitte Dateien und einen Ordner angeben.</translation>
    </message>
    <message>
      <source>Hex mesh</source>
      <translation>Hexaedernetz</translation>
    </message>
    <message>
      <source>Hex mesh from solid</source>
      <translation>Hexaedernetz aus Körper</translation>
    </message>
    <message>
      <source>Hexahedra</source>
      <translation>Hexaeder</translation>
    </message>
    <message>
      <source>Hide the part when its mesh is there</source>
      <translation>Das Teil ausblenden, wenn sein Netz da ist</translation>
    </message>
    <message>
      <source>Into the folder</source>
      <translation>In den Ordner</translation>
    </message>
    <message>
      <source>Keep this view when closed</source>
      <translation>Diese Ansicht nach dem Schließen behalten</translation>
    </message>
    <message>
      <source>Labels</source>
      <translation>Richtungen</translation>
    </message>
    <message>
      <source>Layers, at least</source>
      <translation>Schichten, mindestens</translation>
    </message>
    <message>
      <source>Log</source>
      <translation>Protokoll</translation>
    </message>
    <message>
      <source>Mean SJ</source>
      <translation>Mittlere SJ</translation>
    </message>
    <message>
      <source>Memory limit (MB), 0: none</source>
      <translation>Speichergrenze (MB), 0: keine</translation>
    </message>
    <message>
      <source>Mesh</source>
      <translation>Vernetzen</translation>
    </message>
    <message>
      <source>Mesh again</source>
      <translation>Neu vernetzen</translation>
    </message>
    <message>
      <source>Mesh again with part and options as they are now: the selected meshes, or all that are out of date</source>
      <translation>Mit Teil und Optionen, wie sie jetzt sind, neu vernetzen: die gewählten Netze oder alle veralteten</translation>
    </message>
    <message>
      <source>Mesh every solid of many CAD files or FreeCAD documents into a folder</source>
      <translation>Jeden Körper vieler CAD-Dateien oder FreeCAD-Dokumente in einen Ordner vernetzen</translation>
    </message>
    <message>
      <source>Mesh quality</source>
      <translation>Netzqualität</translation>
    </message>
    <message>
      <source>Mesh the selected solid with hexahedra: choose the element size, see the feature lines, mesh</source>
      <translation>Den gewählten Körper mit Hexaedern vernetzen: Elementgröße wählen, Merkmalslinien sehen, vernetzen</translation>
    </message>
    <message>
      <source>Mesh with these options (Ctrl+Return)</source>
      <translation>Mit diesen Optionen vernetzen (Strg+Eingabe)</translation>
    </message>
    <message>
      <source>Method</source>
      <translation>Verfahren</translation>
    </message>
    <message>
      <source>More options</source>
      <translation>Weitere Optionen</translation>
    </message>
    <message>
      <source>No mesh. Step: %s</source>
      <translation>Kein Netz. Schritt: %s</translation>
    </message>
    <message>
      <source>Nodes</source>
      <translation>Knoten</translation>
    </message>
    <message>
      <source>Not a length: %s</source>
      <translation>Keine Länge: %s</translation>
    </message>
    <message>
      <source>O-grid sheets</source>
      <translation>O-Gitter-Schichten</translation>
    </message>
    <message>
      <source>Only elements below</source>
      <translation>Nur Elemente unter</translation>
    </message>
    <message>
      <source>Part</source>
      <translation>Teil</translation>
    </message>
    <message>
      <source>Preview</source>
      <translation>Vorschau</translation>
    </message>
    <message>
      <source>Recognition model</source>
      <translation>Erkennungsmodell</translation>
    </message>
    <message>
      <source>Refresh mesh</source>
      <translation>Netz erneuern</translation>
    </message>
    <message>
      <source>Result</source>
      <translation>Ergebnis</translation>
    </message>
    <message>
      <source>Scaled Jacobian, mean</source>
      <translation>Skalierte Jacobi-Det., Mittel</translation>
    </message>
    <message>
      <source>Scaled Jacobian, worst</source>
      <translation>Skalierte Jacobi-Det., schlechteste</translation>
    </message>
    <message>
      <source>Seconds</source>
      <translation>Sekunden</translation>
    </message>
    <message>
      <source>Show feature lines</source>
      <translation>Merkmalslinien zeigen</translation>
    </message>
    <message>
      <source>Show feature lines while the panel is open</source>
      <translation>Merkmalslinien zeigen, solange das Fenster offen ist</translation>
    </message>
    <message>
      <source>Show only elements of a scaled Jacobian below this; 1 shows all</source>
      <translation>Nur Elemente mit kleinerer skalierter Jacobi-Determinante zeigen; 1 zeigt alle</translation>
    </message>
    <message>
      <source>Show recognition model</source>
      <translation>Erkennungsmodell zeigen</translation>
    </message>
    <message>
      <source>Show the hex mesh toolbar and menu in the FEM workbench too</source>
      <translation>Werkzeugleiste und Menü Hexaedernetz auch im Arbeitsbereich FEM zeigen</translation>
    </message>
    <message>
      <source>Smoothing rounds of the paper's labels</source>
      <translation>Glättungsrunden der Richtungen nach der Veröffentlichung</translation>
    </message>
    <message>
      <source>Smoothing speed of the paper's labels</source>
      <translation>Glättungsrate der Richtungen nach der Veröffentlichung</translation>
    </message>
    <message>
      <source>Solid</source>
      <translation>Körper</translation>
    </message>
    <message>
      <source>Start</source>
      <translation>Start</translation>
    </message>
    <message>
      <source>The mesh has lost its part: link one in its property Shape.</source>
      <translation>Das Netz hat sein Teil verloren: bitte in der Eigenschaft Shape eines verknüpfen.</translation>
    </message>
    <message>
      <source>The ten worst</source>
      <translation>Die zehn schlechtesten</translation>
    </message>
    <message>
      <source>Threads</source>
      <translation>Threads</translation>
    </message>
    <message>
      <source>Time</source>
      <translation>Zeit</translation>
    </message>
    <message>
      <source>Time limit (s), 0: none</source>
      <translation>Zeitgrenze (s), 0: keine</translation>
    </message>
    <message>
      <source>Try: %s</source>
      <translation>Versuchen: %s</translation>
    </message>
    <message>
      <source>Volume off by</source>
      <translation>Volumenfehler</translation>
    </message>
    <message>
      <source>Why not</source>
      <translation>Warum nicht</translation>
    </message>
    <message>
      <source>Window</source>
      <translation>Fenster</translation>
    </message>
    <message>
      <source>Worst SJ</source>
      <translation>Schlechteste SJ</translation>
    </message>
    <message>
      <source>Write a hex mesh with its CAD groups to a file: .inp .unv .med .msh .vtk .vtu</source>
      <translation>Ein Hexaedernetz mit seinen CAD-Gruppen in eine Datei schreiben: .inp .unv .med .msh .vtk .vtu</translation>
    </message>
    <message>
      <source>a border loop of a %1 face turns %2 quarters</source>
      <translation>ein Rand einer %1-Fläche macht %2 Vierteldrehungen</translation>
    </message>
    <message>
      <source>a chart's outline is not simple</source>
      <translation>der Umriss eines Bereichs ist nicht einfach</translation>
    </message>
    <message>
      <source>a closed border between two faces has no corner</source>
      <translation>eine geschlossene Grenze zwischen zwei Flächen hat keine Ecke</translation>
    </message>
    <message>
      <source>a corner of the feature shape has no lattice node</source>
      <translation>eine Ecke der Merkmalsform hat keinen Gitterknoten</translation>
    </message>
    <message>
      <source>a face has no surface</source>
      <translation>eine Fläche ist ohne Geometrie</translation>
    </message>
    <message>
      <source>a face's surface is not finite</source>
      <translation>die Geometrie einer Fläche ist nicht endlich</translation>
    </message>
    <message>
      <source>a face's tolerance is not finite</source>
      <translation>die Toleranz einer Fläche ist nicht endlich</translation>
    </message>
    <message>
      <source>a feature line has no corners or no direction</source>
      <translation>eine Merkmalslinie hat keine Ecken oder keine Richtung</translation>
    </message>
    <message>
      <source>a feature line is not followed by the lattice</source>
      <translation>das Gitter folgt einer Merkmalslinie nicht</translation>
    </message>
    <message>
      <source>a feature line lacks lattice nodes</source>
      <translation>einer Merkmalslinie fehlen Gitterknoten</translation>
    </message>
    <message>
      <source>a line runs from a %1 face to itself</source>
      <translation>eine Linie führt von einer %1-Fläche zu ihr selbst</translation>
    </message>
    <message>
      <source>a shell has one direction only</source>
      <translation>eine Hülle hat nur eine Richtung</translation>
    </message>
    <message>
      <source>a triangle edge belongs to more than two triangles</source>
      <translation>eine Dreieckskante gehört zu mehr als zwei Dreiecken</translation>
    </message>
    <message>
      <source>a vertex is not finite</source>
      <translation>ein Eckpunkt ist nicht endlich</translation>
    </message>
    <message>
      <source>about %s elements</source>
      <translation>etwa %s Elemente</translation>
    </message>
    <message>
      <source>across X</source>
      <translation>quer zu X</translation>
    </message>
    <message>
      <source>across Y</source>
      <translation>quer zu Y</translation>
    </message>
    <message>
      <source>across Z</source>
      <translation>quer zu Z</translation>
    </message>
    <message>
      <source>all CAD edges</source>
      <translation>alle CAD-Kanten</translation>
    </message>
    <message>
      <source>all solids</source>
      <translation>alle Körper</translation>
    </message>
    <message>
      <source>an earlier proposal has these very labels</source>
      <translation>ein früherer Vorschlag hat genau diese Richtungen</translation>
    </message>
    <message>
      <source>an edge has no length in its parameter</source>
      <translation>eine Kante hat im Parameter keine Länge</translation>
    </message>
    <message>
      <source>an edge lies beyond the end of its curve</source>
      <translation>eine Kante liegt jenseits des Endes ihrer Kurve</translation>
    </message>
    <message>
      <source>an edge's curve has no period</source>
      <translation>die Kurve einer Kante hat keine Periode</translation>
    </message>
    <message>
      <source>an edge's curve is not finite</source>
      <translation>die Kurve einer Kante ist nicht endlich</translation>
    </message>
    <message>
      <source>an edge's curve on the face is far out of the surface's period</source>
      <translation>die Kurve einer Kante liegt auf der Fläche weit außerhalb der Periode</translation>
    </message>
    <message>
      <source>an edge's curve on the face is not finite</source>
      <translation>die Kurve einer Kante auf der Fläche ist nicht endlich</translation>
    </message>
    <message>
      <source>an edge's parameters are far out of their period</source>
      <translation>die Parameter einer Kante liegen weit außerhalb der Periode</translation>
    </message>
    <message>
      <source>an edge's parameters are not finite</source>
      <translation>die Parameter einer Kante sind nicht endlich</translation>
    </message>
    <message>
      <source>an edge's tolerance is not finite</source>
      <translation>die Toleranz einer Kante ist nicht endlich</translation>
    </message>
    <message>
      <source>an element refers to a point that does not exist</source>
      <translation>ein Element nennt einen Punkt, den es nicht gibt</translation>
    </message>
    <message>
      <source>at most so many rounds of the paper's step 3-7b</source>
      <translation>höchstens so viele Runden von Schritt 3-7b der Veröffentlichung</translation>
    </message>
    <message>
      <source>automatic</source>
      <translation>automatisch</translation>
    </message>
    <message>
      <source>build with Netgen's library (Debian: libnglib-dev)</source>
      <translation>mit der Bibliothek von Netgen bauen (Debian: libnglib-dev)</translation>
    </message>
    <message>
      <source>building FreeCAD's mesh</source>
      <translation>FreeCADs Netz aufbauen</translation>
    </message>
    <message>
      <source>cancelled; the document is as it was</source>
      <translation>abgebrochen; das Dokument ist, wie es war</translation>
    </message>
    <message>
      <source>cancelled; the old mesh stays</source>
      <translation>abgebrochen; das alte Netz bleibt</translation>
    </message>
    <message>
      <source>cancelling ...</source>
      <translation>wird abgebrochen ...</translation>
    </message>
    <message>
      <source>cannot write '%1'</source>
      <translation>'%1' lässt sich nicht schreiben</translation>
    </message>
    <message>
      <source>check its geometry</source>
      <translation>die Geometrie prüfen</translation>
    </message>
    <message>
      <source>check its permissions</source>
      <translation>die Rechte der Datei prüfen</translation>
    </message>
    <message>
      <source>check the part's solids</source>
      <translation>die Festkörper des Teils prüfen</translation>
    </message>
    <message>
      <source>check the path</source>
      <translation>den Pfad prüfen</translation>
    </message>
    <message>
      <source>choose a larger element size</source>
      <translation>eine größere Elementgröße wählen</translation>
    </message>
    <message>
      <source>choose an object with a solid; make one of a shell with Part &gt; Convert to solid</source>
      <translation>ein Objekt mit einem Festkörper wählen; aus einer Hülle wird einer mit Part &gt; In Festkörper umwandeln</translation>
    </message>
    <message>
      <source>close the open shell or export a solid</source>
      <translation>die offene Hülle schließen oder einen Festkörper exportieren</translation>
    </message>
    <message>
      <source>condition V%1 fails</source>
      <translation>Bedingung V%1 ist verletzt</translation>
    </message>
    <message>
      <source>degrees; STL, OBJ and PLY surfaces are cut into faces at sharper creases</source>
      <translation>Grad; STL-, OBJ- und PLY-Oberflächen werden an schärferen Knicken in Flächen zerlegt</translation>
    </message>
    <message>
      <source>element size in the part's unit; 0 chooses one from the part's volume</source>
      <translation>Elementgröße in der Einheit des Teils; 0 wählt eine nach dem Volumen</translation>
    </message>
    <message>
      <source>element type '%1' does not fit the order of the mesh</source>
      <translation>der Elementtyp '%1' passt nicht zur Ordnung des Netzes</translation>
    </message>
    <message>
      <source>export a solid</source>
      <translation>einen Festkörper exportieren</translation>
    </message>
    <message>
      <source>export a solid, not a sketch or wire</source>
      <translation>einen Festkörper exportieren, keine Skizze und keinen Linienzug</translation>
    </message>
    <message>
      <source>export the part again</source>
      <translation>das Teil erneut exportieren</translation>
    </message>
    <message>
      <source>export the part again, or repair it</source>
      <translation>das Teil erneut exportieren oder reparieren</translation>
    </message>
    <message>
      <source>export the part again; from FreeCAD</source>
      <translation>das Teil erneut exportieren; in FreeCAD</translation>
    </message>
    <message>
      <source>faces on one axis lie each above the one before, round in a circle (%1 faces)</source>
      <translation>Flächen auf einer Achse liegen reihum jede über der vorigen (%1 Flächen)</translation>
    </message>
    <message>
      <source>failed</source>
      <translation>fehlgeschlagen</translation>
    </message>
    <message>
      <source>feature lines</source>
      <translation>Merkmalslinien</translation>
    </message>
    <message>
      <source>finding directions</source>
      <translation>Richtungen finden</translation>
    </message>
    <message>
      <source>first (8 nodes)</source>
      <translation>erste (8 Knoten)</translation>
    </message>
    <message>
      <source>fitting to the part</source>
      <translation>Anpassen an das Teil</translation>
    </message>
    <message>
      <source>free some space, or write to another disk</source>
      <translation>Platz schaffen oder auf einen anderen Datenträger schreiben</translation>
    </message>
    <message>
      <source>from tetrahedra</source>
      <translation>aus Tetraedern</translation>
    </message>
    <message>
      <source>from tetrahedra, of low quality</source>
      <translation>aus Tetraedern, von geringer Qualität</translation>
    </message>
    <message>
      <source>give a file name, not a folder</source>
      <translation>einen Dateinamen angeben, keinen Ordner</translation>
    </message>
    <message>
      <source>give a larger size</source>
      <translation>eine größere Elementgröße angeben</translation>
    </message>
    <message>
      <source>give a size above 0</source>
      <translation>bitte eine Größe über 0 angeben</translation>
    </message>
    <message>
      <source>give a size well below the part's length of %1</source>
      <translation>eine Elementgröße deutlich unter der Länge des Teils von %1 angeben</translation>
    </message>
    <message>
      <source>give the part's file</source>
      <translation>die Datei des Teils angeben</translation>
    </message>
    <message>
      <source>insert O-grid sheets where block borders lie on smooth surface</source>
      <translation>O-Gitter-Schichten einfügen, wo Blockränder auf glatter Oberfläche liegen</translation>
    </message>
    <message>
      <source>its share of the time limit is used up</source>
      <translation>der Anteil an der Zeitgrenze ist verbraucht</translation>
    </message>
    <message>
      <source>its surface alone would need more than 20 million triangles</source>
      <translation>allein seine Oberfläche bräuchte mehr als 20 Millionen Dreiecke</translation>
    </message>
    <message>
      <source>labeller: on CAD regions, or the paper's on triangles</source>
      <translation>Richtungen: auf CAD-Gebieten oder, wie in der Veröffentlichung, auf Dreiecken</translation>
    </message>
    <message>
      <source>labels</source>
      <translation>Richtungen</translation>
    </message>
    <message>
      <source>larger than the part</source>
      <translation>größer als das Teil</translation>
    </message>
    <message>
      <source>layers under smooth borders</source>
      <translation>Schichten unter glatten Rändern</translation>
    </message>
    <message>
      <source>least number of elements along every block edge</source>
      <translation>kleinste Zahl von Elementen längs jeder Blockkante</translation>
    </message>
    <message>
      <source>looking at the part ...</source>
      <translation>das Teil wird betrachtet ...</translation>
    </message>
    <message>
      <source>make the folder first</source>
      <translation>erst den Ordner anlegen</translation>
    </message>
    <message>
      <source>measuring</source>
      <translation>Messen</translation>
    </message>
    <message>
      <source>megabytes of memory for the whole run; 0 sets no limit</source>
      <translation>Megabyte Speicher für den ganzen Lauf; 0: keine Grenze</translation>
    </message>
    <message>
      <source>memory limit reached</source>
      <translation>Speichergrenze erreicht</translation>
    </message>
    <message>
      <source>meshed</source>
      <translation>vernetzt</translation>
    </message>
    <message>
      <source>meshing method; auto tries them in order</source>
      <translation>Verfahren; auto versucht sie der Reihe nach</translation>
    </message>
    <message>
      <source>mid-side nodes</source>
      <translation>Mittelknoten</translation>
    </message>
    <message>
      <source>neighbouring triangles are oriented against each other</source>
      <translation>benachbarte Dreiecke sind gegeneinander orientiert</translation>
    </message>
    <message>
      <source>no cut</source>
      <translation>kein Schnitt</translation>
    </message>
    <message>
      <source>no node for an end</source>
      <translation>kein Knoten für ein Ende</translation>
    </message>
    <message>
      <source>no path without a flat corner</source>
      <translation>kein Weg ohne flache Ecke</translation>
    </message>
    <message>
      <source>no solid in the file, and its faces do not form one</source>
      <translation>kein Festkörper in der Datei, und ihre Flächen bilden keinen</translation>
    </message>
    <message>
      <source>no valid recognition model was found</source>
      <translation>kein gültiges Erkennungsmodell gefunden</translation>
    </message>
    <message>
      <source>on CAD regions</source>
      <translation>auf CAD-Gebieten</translation>
    </message>
    <message>
      <source>one file a line: STEP, IGES, BREP or FreeCAD documents; with a size of its own: part.step; 4 mm</source>
      <translation>eine Datei je Zeile: STEP, IGES, BREP oder FreeCAD-Dokumente; mit eigener Größe: teil.step; 4 mm</translation>
    </message>
    <message>
      <source>options</source>
      <translation>Optionen</translation>
    </message>
    <message>
      <source>other side</source>
      <translation>andere Seite</translation>
    </message>
    <message>
      <source>out of memory</source>
      <translation>nicht genug Speicher</translation>
    </message>
    <message>
      <source>polycube</source>
      <translation>Polycube</translation>
    </message>
    <message>
      <source>proving every element</source>
      <translation>jedes Element prüfen</translation>
    </message>
    <message>
      <source>raise the element size</source>
      <translation>die Elementgröße erhöhen</translation>
    </message>
    <message>
      <source>raise the time limit</source>
      <translation>die Zeitgrenze erhöhen</translation>
    </message>
    <message>
      <source>raise the time limit or the element size</source>
      <translation>die Zeitgrenze oder die Elementgröße erhöhen</translation>
    </message>
    <message>
      <source>reading the part</source>
      <translation>Teil lesen</translation>
    </message>
    <message>
      <source>scaled Jacobian</source>
      <translation>skalierte Jacobi-Det.</translation>
    </message>
    <message>
      <source>second (20 nodes)</source>
      <translation>zweite (20 Knoten)</translation>
    </message>
    <message>
      <source>seconds for the whole run; 0 sets no limit</source>
      <translation>Sekunden für den ganzen Lauf; 0 setzt keine Grenze</translation>
    </message>
    <message>
      <source>see hexfeature mesh --help</source>
      <translation>siehe hexfeature mesh --help</translation>
    </message>
    <message>
      <source>sharp CAD edges</source>
      <translation>scharfe CAD-Kanten</translation>
    </message>
    <message>
      <source>smoothing</source>
      <translation>Glätten</translation>
    </message>
    <message>
      <source>solid %1 has no faces</source>
      <translation>Festkörper %1 hat keine Flächen</translation>
    </message>
    <message>
      <source>speed of the paper's smoothing of degrees of adaptation, equation (1)</source>
      <translation>Rate, mit der die Veröffentlichung die Anpassungsgrade glättet, Gleichung (1)</translation>
    </message>
    <message>
      <source>starting</source>
      <translation>Beginn</translation>
    </message>
    <message>
      <source>surface triangles</source>
      <translation>Oberflächendreiecke</translation>
    </message>
    <message>
      <source>tetrahedra</source>
      <translation>Tetraeder</translation>
    </message>
    <message>
      <source>the B-rep holds no shape</source>
      <translation>die B-Rep enthält keine Form</translation>
    </message>
    <message>
      <source>the B-rep is truncated or no B-rep at all</source>
      <translation>die B-Rep ist abgeschnitten oder gar keine</translation>
    </message>
    <message>
      <source>the axes disagree</source>
      <translation>die Achsen widersprechen sich</translation>
    </message>
    <message>
      <source>the element size is larger than the part</source>
      <translation>die Elementgröße ist größer als das Teil</translation>
    </message>
    <message>
      <source>the element size is too small for this part</source>
      <translation>die Elementgröße ist zu klein für dieses Teil</translation>
    </message>
    <message>
      <source>the element size must be a positive number</source>
      <translation>die Elementgröße muss eine positive Zahl sein</translation>
    </message>
    <message>
      <source>the element size must be greater than zero</source>
      <translation>die Elementgröße muss größer als null sein</translation>
    </message>
    <message>
      <source>the element size must be positive</source>
      <translation>die Elementgröße muss positiv sein</translation>
    </message>
    <message>
      <source>the feature shape has no corners</source>
      <translation>die Merkmalsform hat keine Ecken</translation>
    </message>
    <message>
      <source>the file holds no face</source>
      <translation>die Datei enthält keine Fläche</translation>
    </message>
    <message>
      <source>the file holds no shape</source>
      <translation>die Datei enthält keine Form</translation>
    </message>
    <message>
      <source>the filled solid's Euler number is not the part's</source>
      <translation>die Eulerzahl des gefüllten Körpers ist nicht die des Teils</translation>
    </message>
    <message>
      <source>the inside leaks</source>
      <translation>das Innere ist undicht</translation>
    </message>
    <message>
      <source>the lattice would have more than 40 million cells</source>
      <translation>das Gitter hätte mehr als 40 Millionen Zellen</translation>
    </message>
    <message>
      <source>the mesh does not know which CAD entity its points lie on</source>
      <translation>das Netz weiß nicht, auf welchen CAD-Elementen seine Punkte liegen</translation>
    </message>
    <message>
      <source>the mesh of another labelling is better</source>
      <translation>das Netz mit anderen Richtungen ist besser</translation>
    </message>
    <message>
      <source>the mesh of another method is better</source>
      <translation>das Netz eines anderen Verfahrens ist besser</translation>
    </message>
    <message>
      <source>the object has no solid</source>
      <translation>das Objekt hat keinen Festkörper</translation>
    </message>
    <message>
      <source>the paper's, on triangles</source>
      <translation>wie veröffentlicht, auf Dreiecken</translation>
    </message>
    <message>
      <source>the part has no extent</source>
      <translation>das Teil hat keine Ausdehnung</translation>
    </message>
    <message>
      <source>the part is damaged</source>
      <translation>das Teil ist beschädigt</translation>
    </message>
    <message>
      <source>the part is not closed</source>
      <translation>das Teil ist nicht geschlossen</translation>
    </message>
    <message>
      <source>the part must be a closed solid with sound faces; try Part &gt; Check geometry or a shape healing</source>
      <translation>das Teil muss ein geschlossener Festkörper mit heilen Flächen sein; Part &gt; Geometrie überprüfen oder eine Reparatur der Form hilft vielleicht</translation>
    </message>
    <message>
      <source>the part must be a closed solid; try repairing it</source>
      <translation>das Teil muss ein geschlossener Festkörper sein; vielleicht lässt es sich reparieren</translation>
    </message>
    <message>
      <source>the part touches itself</source>
      <translation>das Teil berührt sich selbst</translation>
    </message>
    <message>
      <source>the path meets itself</source>
      <translation>der Weg trifft sich selbst</translation>
    </message>
    <message>
      <source>the path would skip a part of it</source>
      <translation>der Weg ließe ein Stück davon aus</translation>
    </message>
    <message>
      <source>the surface does not close at %1 face(s)</source>
      <translation>die Oberfläche schließt sich an %1 Fläche(n) nicht</translation>
    </message>
    <message>
      <source>the surface has a hole (a triangle edge with one side)</source>
      <translation>die Oberfläche hat ein Loch (eine Dreieckskante mit nur einer Seite)</translation>
    </message>
    <message>
      <source>the surface touches itself in a point</source>
      <translation>die Oberfläche berührt sich selbst in einem Punkt</translation>
    </message>
    <message>
      <source>the tetrahedra do not fill the surface</source>
      <translation>die Tetraeder füllen die Oberfläche nicht aus</translation>
    </message>
    <message>
      <source>the tetrahedra overlap</source>
      <translation>die Tetraeder überlappen sich</translation>
    </message>
    <message>
      <source>the tetrahedral mesher cannot be started</source>
      <translation>der Tetraeder-Vernetzer lässt sich nicht starten</translation>
    </message>
    <message>
      <source>the tetrahedral mesher crashed or ran out of memory</source>
      <translation>der Tetraeder-Vernetzer ist abgestürzt oder hatte nicht genug Speicher</translation>
    </message>
    <message>
      <source>the tetrahedral mesher ended too early</source>
      <translation>der Tetraeder-Vernetzer endete zu früh</translation>
    </message>
    <message>
      <source>the tetrahedral mesher gave up</source>
      <translation>der Tetraeder-Vernetzer hat aufgegeben</translation>
    </message>
    <message>
      <source>the tetrahedral mesher returned an inverted element</source>
      <translation>der Tetraeder-Vernetzer lieferte ein umgestülptes Element</translation>
    </message>
    <message>
      <source>the tetrahedral mesher returned no elements</source>
      <translation>der Tetraeder-Vernetzer lieferte keine Elemente</translation>
    </message>
    <message>
      <source>the tetrahedral mesher returned nonsense</source>
      <translation>der Tetraeder-Vernetzer lieferte Unsinn</translation>
    </message>
    <message>
      <source>there is no file '%1'</source>
      <translation>es gibt keine Datei '%1'</translation>
    </message>
    <message>
      <source>there is no mesh format with the ending '%1'</source>
      <translation>es gibt kein Netzformat mit der Endung '%1'</translation>
    </message>
    <message>
      <source>there is no option '%1'</source>
      <translation>es gibt keine Option '%1'</translation>
    </message>
    <message>
      <source>there is no solid in it</source>
      <translation>darin ist kein Körper</translation>
    </message>
    <message>
      <source>there is no such file</source>
      <translation>diese Datei gibt es nicht</translation>
    </message>
    <message>
      <source>time limit reached</source>
      <translation>Zeitgrenze erreicht</translation>
    </message>
    <message>
      <source>too far, %1</source>
      <translation>zu weit, %1</translation>
    </message>
    <message>
      <source>try a smaller element size</source>
      <translation>eine kleinere Elementgröße versuchen</translation>
    </message>
    <message>
      <source>try a smaller element size, or simplify the faces named</source>
      <translation>eine kleinere Elementgröße versuchen oder die genannten Flächen vereinfachen</translation>
    </message>
    <message>
      <source>try a smaller element size, or split the part</source>
      <translation>eine kleinere Elementgröße versuchen oder das Teil teilen</translation>
    </message>
    <message>
      <source>try another element size</source>
      <translation>eine andere Elementgröße versuchen</translation>
    </message>
    <message>
      <source>try another element size, or repair the part (it may intersect itself)</source>
      <translation>eine andere Elementgröße versuchen oder das Teil reparieren (vielleicht durchdringt es sich selbst)</translation>
    </message>
    <message>
      <source>try another element size, or simplify the faces named</source>
      <translation>eine andere Elementgröße versuchen oder die genannten Flächen vereinfachen</translation>
    </message>
    <message>
      <source>two mesh points would stand on CAD vertex %1</source>
      <translation>zwei Netzpunkte stünden auf dem CAD-Eckpunkt %1</translation>
    </message>
    <message>
      <source>unit cubes</source>
      <translation>Einheitswürfel</translation>
    </message>
    <message>
      <source>unreadable</source>
      <translation>nicht lesbar</translation>
    </message>
    <message>
      <source>use .step, .iges or .brep</source>
      <translation>.step, .iges oder .brep verwenden</translation>
    </message>
    <message>
      <source>use .vtk, .inp or .unv</source>
      <translation>.vtk, .inp oder .unv verwenden</translation>
    </message>
    <message>
      <source>use a larger size</source>
      <translation>eine größere Elementgröße verwenden</translation>
    </message>
    <message>
      <source>use a larger size, or allow more memory</source>
      <translation>eine größere Elementgröße verwenden oder mehr Speicher erlauben</translation>
    </message>
    <message>
      <source>use one of %1</source>
      <translation>eines von %1 verwenden</translation>
    </message>
    <message>
      <source>worker threads; the mesh does not depend on it</source>
      <translation>Arbeits-Threads; das Netz hängt nicht davon ab</translation>
    </message>
    <message>
      <source>write to a folder where you may create files</source>
      <translation>in einen Ordner schreiben, in dem Dateien angelegt werden dürfen</translation>
    </message>
    <message>
      <source>writing</source>
      <translation>schreiben</translation>
    </message>
    <message>
      <source>writing the mesh into the document ...</source>
      <translation>das Netz wird in das Dokument geschrieben ...</translation>
    </message>
    <message>
      <source>written: %s</source>
      <translation>geschrieben: %s</translation>
    </message>
  </context>
</TS>
