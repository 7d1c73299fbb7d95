<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
  <context>
    <name>App::Property</name>
    <message>
      <source>1: 8-node hexahedra, 2: 20-node hexahedra</source>
      <translation>1: Hexaeder mit 8 Knoten, 2: mit 20 Knoten</translation>
    </message>
    <message>
      <source>Beta</source>
      <translation>Beta</translation>
    </message>
    <message>
      <source>CAD edges that mesh edges follow: sharp ones, or all</source>
      <translation>CAD-Kanten, denen Netzkanten folgen: scharfe oder alle</translation>
    </message>
    <message>
      <source>Capture</source>
      <translation>Kanten im Netz</translation>
    </message>
    <message>
      <source>Colour Bar</source>
      <translation>Farbskala</translation>
    </message>
    <message>
      <source>Crease Angle</source>
      <translation>Knickwinkel</translation>
    </message>
    <message>
      <source>Cut Axis</source>
      <translation>Schnittachse</translation>
    </message>
    <message>
      <source>Cut Flip</source>
      <translation>Andere Schnittseite</translation>
    </message>
    <message>
      <source>Cut Position</source>
      <translation>Schnittlage</translation>
    </message>
    <message>
      <source>Element Size</source>
      <translation>Elementgröße</translation>
    </message>
    <message>
      <source>Feature Line Nodes</source>
      <translation>Knoten der Merkmalslinien</translation>
    </message>
    <message>
      <source>Feature Lines</source>
      <translation>Merkmalslinien</translation>
    </message>
    <message>
      <source>Hex Count</source>
      <translation>Anzahl Hexaeder</translation>
    </message>
    <message>
      <source>Hex mesh</source>
      <translation>Hexaedernetz</translation>
    </message>
    <message>
      <source>Hex mesh result</source>
      <translation>Hexaedernetz, Ergebnis</translation>
    </message>
    <message>
      <source>Labels</source>
      <translation>Richtungen</translation>
    </message>
    <message>
      <source>Largest Deviation</source>
      <translation>Größter Abstand</translation>
    </message>
    <message>
      <source>Made Of</source>
      <translation>Gemacht aus</translation>
    </message>
    <message>
      <source>Mean Scaled Jacobian</source>
      <translation>Mittlere skalierte Jacobi-Det.</translation>
    </message>
    <message>
      <source>Memory Limit</source>
      <translation>Speichergrenze</translation>
    </message>
    <message>
      <source>Method</source>
      <translation>Verfahren</translation>
    </message>
    <message>
      <source>Method Used</source>
      <translation>Benutztes Verfahren</translation>
    </message>
    <message>
      <source>Min Scaled Jacobian</source>
      <translation>Kleinste skalierte Jacobi-Det.</translation>
    </message>
    <message>
      <source>Minimum Layers</source>
      <translation>Schichten mindestens</translation>
    </message>
    <message>
      <source>Needs Refresh</source>
      <translation>Muss erneuert werden</translation>
    </message>
    <message>
      <source>Order</source>
      <translation>Elementordnung</translation>
    </message>
    <message>
      <source>Part</source>
      <translation>Teil</translation>
    </message>
    <message>
      <source>Report</source>
      <translation>Bericht</translation>
    </message>
    <message>
      <source>Seconds</source>
      <translation>Sekunden</translation>
    </message>
    <message>
      <source>Sheets</source>
      <translation>O-Gitter-Schichten</translation>
    </message>
    <message>
      <source>Show Below</source>
      <translation>Zeigen unter</translation>
    </message>
    <message>
      <source>Smoothing Rounds</source>
      <translation>Glättungsrunden</translation>
    </message>
    <message>
      <source>Solid</source>
      <translation>Körper</translation>
    </message>
    <message>
      <source>Threads</source>
      <translation>Threads</translation>
    </message>
    <message>
      <source>Time Limit</source>
      <translation>Zeitgrenze</translation>
    </message>
    <message>
      <source>at most so many rounds of the paper's step 3-7b</source>
      <translation>höchstens so viele Runden von Schritt 3-7b der Veröffentlichung</translation>
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
      <source>in Quality: cut the mesh open across this axis</source>
      <translation>in Quality: das Netz quer zu dieser Achse aufschneiden</translation>
    </message>
    <message>
      <source>in Quality: draw the colour scale</source>
      <translation>in Quality: die Farbskala zeichnen</translation>
    </message>
    <message>
      <source>in Quality: draw the feature lines on the mesh</source>
      <translation>in Quality: die Merkmalslinien auf das Netz zeichnen</translation>
    </message>
    <message>
      <source>in Quality: show only elements of a scaled Jacobian below this; 1: all</source>
      <translation>in Quality: nur Elemente mit kleinerer skalierter Jacobi-Determinante zeigen; 1: alle</translation>
    </message>
    <message>
      <source>in Quality: show the other side of the cut</source>
      <translation>in Quality: die andere Seite des Schnitts zeigen</translation>
    </message>
    <message>
      <source>in Quality: where the cut is, of the mesh's extent</source>
      <translation>in Quality: wo der Schnitt liegt, in Prozent der Ausdehnung des Netzes</translation>
    </message>
    <message>
      <source>insert O-grid sheets where block borders lie on smooth surface</source>
      <translation>O-Gitter-Schichten einfügen, wo Blockränder auf glatter Oberfläche liegen</translation>
    </message>
    <message>
      <source>labeller: on CAD regions, or the paper's on triangles</source>
      <translation>Richtungen: auf CAD-Gebieten oder, wie in der Veröffentlichung, auf Dreiecken</translation>
    </message>
    <message>
      <source>largest distance of a boundary node from its CAD face, edge or vertex</source>
      <translation>größter Abstand eines Randknotens von seiner CAD-Fläche, -Kante oder -Ecke</translation>
    </message>
    <message>
      <source>least number of elements along every block edge</source>
      <translation>kleinste Zahl von Elementen längs jeder Blockkante</translation>
    </message>
    <message>
      <source>mean scaled Jacobian</source>
      <translation>mittlere skalierte Jacobi-Determinante</translation>
    </message>
    <message>
      <source>megabytes of memory for the whole run; 0 sets no limit</source>
      <translation>Megabyte Speicher für den ganzen Lauf; 0: keine Grenze</translation>
    </message>
    <message>
      <source>meshing method; auto tries them in order</source>
      <translation>Verfahren; auto versucht sie der Reihe nach</translation>
    </message>
    <message>
      <source>method that made the mesh</source>
      <translation>Verfahren, mit dem das Netz gemacht wurde</translation>
    </message>
    <message>
      <source>nodes of the mesh edges on feature lines, two an edge</source>
      <translation>Knoten der Netzkanten auf Merkmalslinien, zwei je Kante</translation>
    </message>
    <message>
      <source>number of hexahedra</source>
      <translation>Anzahl der Hexaeder</translation>
    </message>
    <message>
      <source>of a part with several solids, the one to mesh; 0: all of them</source>
      <translation>bei einem Teil mit mehreren Körpern der, der vernetzt wird; 0: alle</translation>
    </message>
    <message>
      <source>part and options that the mesh was made of</source>
      <translation>Teil und Optionen, aus denen das Netz gemacht wurde</translation>
    </message>
    <message>
      <source>scaled Jacobian of the worst element, 1 is best</source>
      <translation>skalierte Jacobi-Determinante des schlechtesten Elements, 1 ist am besten</translation>
    </message>
    <message>
      <source>seconds for the whole run; 0 sets no limit</source>
      <translation>Sekunden für den ganzen Lauf; 0 setzt keine Grenze</translation>
    </message>
    <message>
      <source>speed of the paper's smoothing of degrees of adaptation, equation (1)</source>
      <translation>Rate, mit der die Veröffentlichung die Anpassungsgrade glättet, Gleichung (1)</translation>
    </message>
    <message>
      <source>the part or an option has changed since the mesh was made</source>
      <translation>das Teil oder eine Option hat sich seit dem Vernetzen geändert</translation>
    </message>
    <message>
      <source>the part that is meshed</source>
      <translation>das Teil, das vernetzt wird</translation>
    </message>
    <message>
      <source>the whole report as JSON</source>
      <translation>der ganze Bericht als JSON</translation>
    </message>
    <message>
      <source>time that meshing took</source>
      <translation>Zeit, die das Vernetzen brauchte</translation>
    </message>
    <message>
      <source>worker threads; the mesh does not depend on it</source>
      <translation>Arbeits-Threads; das Netz hängt nicht davon ab</translation>
    </message>
  </context>
  <context>
    <name>HexFeature</name>
    <message>
      <source>%(count)s hexahedra in %(seconds)s s (%(method)s)
scaled Jacobian: worst %(worst)s, mean %(mean)s</source>
      <translation>%(count)s Hexaeder in %(seconds)s s (%(method)s)
skalierte Jacobi-Zahl: schlechteste %(worst)s, mittlere %(mean)s</translation>
    </message>
    <message>
      <source>%(mesh)s (%(number)d of %(count)d): %(step)s, %(seconds)s s</source>
      <translation>%(mesh)s (%(number)d von %(count)d): %(step)s, %(seconds)s s</translation>
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
      <source>%(step)s, %(seconds)s s</source>
      <translation>%(step)s, %(seconds)s s</translation>
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
      <source>%1 hexahedra</source>
      <translation>%1 Hexaeder</translation>
    </message>
    <message>
      <source>%1 points drawn to gaps</source>
      <translation>%1 Punkte zu Lücken gezogen</translation>
    </message>
    <message>
      <source>%1 points taken off CAD edges, inverted %2</source>
      <translation>%1 Punkte von CAD-Kanten gelöst, umgestülpt %2</translation>
    </message>
    <message>
      <source>%1 quads cover another CAD face better</source>
      <translation>%1 Vierecke decken eine andere CAD-Fläche besser ab</translation>
    </message>
    <message>
      <source>%1 refused</source>
      <translation>%1 abgelehnt</translation>
    </message>
    <message>
      <source>%1 runs of points bound to CAD edges</source>
      <translation>%1 Punktfolgen an CAD-Kanten gebunden</translation>
    </message>
    <message>
      <source>%1 sharp CAD edges have no mesh edges</source>
      <translation>%1 scharfe CAD-Kanten haben keine Netzkanten</translation>
    </message>
    <message>
      <source>%1 sites, %2 expansions, %3 label sets scored, %4 filled</source>
      <translation>%1 Gebiete, %2 Schritte, %3 Belegungen bewertet, %4 gefüllt</translation>
    </message>
    <message>
      <source>%1 stray face(s) beside the solid are left out</source>
      <translation>%1 lose Fläche(n) neben dem Festkörper bleiben weg</translation>
    </message>
    <message>
      <source>%1 tips cut</source>
      <translation>%1 Spitzen abgeschnitten</translation>
    </message>
    <message>
      <source>%1 triangles, %2 tetrahedra, worst %3, inverted %4</source>
      <translation>%1 Dreiecke, %2 Tetraeder, schlechtestes %3, umgestülpt %4</translation>
    </message>
    <message>
      <source>%1, charts %2</source>
      <translation>%1, Bereiche %2</translation>
    </message>
    <message>
      <source>%d regions, %d feature lines</source>
      <translation>%d Gebiete, %d Merkmalslinien</translation>
    </message>
    <message>
      <source>%d regions, %d feature lines so far, being tried ...</source>
      <translation>bisher %d Gebiete, %d Merkmalslinien, werden noch erprobt ...</translation>
    </message>
    <message>
      <source>'%1' cannot be opened</source>
      <translation>'%1' lässt sich nicht öffnen</translation>
    </message>
    <message>
      <source>'%1' cannot be read</source>
      <translation>'%1' lässt sich nicht lesen</translation>
    </message>
    <message>
      <source>'%1' has no known ending</source>
      <translation>'%1' hat keine bekannte Endung</translation>
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
      <source>CAD edge %1 (sharp) has no mesh edges of its own</source>
      <translation>der CAD-Kante %1 (scharf) folgen keine Netzkanten</translation>
    </message>
    <message>
      <source>CAD edge %1 (tangent) has no mesh edges of its own</source>
      <translation>der CAD-Kante %1 (tangential) folgen keine Netzkanten</translation>
    </message>
    <message>
      <source>CAD edges that mesh edges follow: sharp ones, or all</source>
      <translation>CAD-Kanten, denen Netzkanten folgen: scharfe oder alle</translation>
    </message>
    <message>
      <source>CAD faces without quads:%1; not covered:%2 (largest gap %3); sharp edges not followed:%4; corners lost:%5</source>
      <translation>CAD-Flächen ohne Vierecke:%1; nicht bedeckt:%2 (größte Lücke %3); scharfe Kanten ohne Netzkanten:%4; verlorene Ecken:%5</translation>
    </message>
    <message>
      <source>CAD files</source>
      <translation>CAD-Dateien</translation>
    </message>
    <message>
      <source>CAD places and the boundary disagree</source>
      <translation>CAD-Zuordnung und Rand widersprechen sich</translation>
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
      <translation>Abstand vom CAD</translation>
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
      <source>FreeCAD finds %(found)d of the %(all)d elements on %(face)s by geometry; a load put there may miss some.</source>
      <translation>FreeCAD findet nach der Geometrie %(found)d der %(all)d Elemente auf %(face)s; eine Last dort verfehlt vielleicht einige.</translation>
    </message>
    <message>
      <source>FreeCAD misses elements on %d faces: a load there may be short (see the report view)</source>
      <translation>FreeCAD findet auf %d Flächen nicht alle Elemente: eine Last dort kann zu klein ausfallen (siehe Ausgabefenster)</translation>
    </message>
    <message>
      <source>FreeCAD's mesh cannot be built</source>
      <translation>FreeCADs Netz lässt sich nicht aufbauen</translation>
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
      <translation>Ansicht behalten</translation>
    </message>
    <message>
      <source>Labels</source>
      <translation>Richtungen</translation>
    </message>
    <message>
      <source>Layers, at least</source>
      <translation>Schichten, mind.</translation>
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
      <source>SMESH gave the number %1 where %2 was next</source>
      <translation>SMESH vergab die Nummer %1, wo %2 an der Reihe war</translation>
    </message>
    <message>
      <source>Scaled Jacobian, mean</source>
      <translation>Skal. Jacobi, Mittel</translation>
    </message>
    <message>
      <source>Scaled Jacobian, worst</source>
      <translation>Skal. Jacobi, schlechteste</translation>
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
      <source>a block must both shrink and stay</source>
      <translation>ein Block müsste zugleich schrumpfen und bleiben</translation>
    </message>
    <message>
      <source>a border loop of a %1 face turns %2 quarters</source>
      <translation>ein Rand einer %1-Fläche macht %2 Vierteldrehungen</translation>
    </message>
    <message>
      <source>a chart faces the wrong way</source>
      <translation>ein Bereich zeigt in die falsche Richtung</translation>
    </message>
    <message>
      <source>a chart's outline crosses itself</source>
      <translation>der Umriss eines Bereichs kreuzt sich selbst</translation>
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
      <source>a closed shell was taken as a solid</source>
      <translation>eine geschlossene Hülle wurde als Festkörper genommen</translation>
    </message>
    <message>
      <source>a corner of the feature shape has no lattice node</source>
      <translation>eine Ecke der Merkmalsform hat keinen Gitterknoten</translation>
    </message>
    <message>
      <source>a face cannot be triangulated</source>
      <translation>eine Fläche lässt sich nicht in Dreiecke zerlegen</translation>
    </message>
    <message>
      <source>a face has no edges</source>
      <translation>eine Fläche hat keine Kanten</translation>
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
      <source>a feature edge that is no boundary edge</source>
      <translation>eine Merkmalskante, die keine Randkante ist</translation>
    </message>
    <message>
      <source>a feature line has no corners or no direction</source>
      <translation>eine Merkmalslinie hat keine Ecken oder keine Richtung</translation>
    </message>
    <message>
      <source>a feature line has no direction</source>
      <translation>eine Merkmalslinie hat keine Richtung</translation>
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
      <source>a feature line leaves the solid</source>
      <translation>eine Merkmalslinie verlässt den Körper</translation>
    </message>
    <message>
      <source>a hexahedron with a node that does not exist</source>
      <translation>ein Hexaeder mit einem Knoten, den es nicht gibt</translation>
    </message>
    <message>
      <source>a hexahedron with a repeated node</source>
      <translation>ein Hexaeder mit einem doppelten Knoten</translation>
    </message>
    <message>
      <source>a line runs from a %1 face to itself</source>
      <translation>eine Linie führt von einer %1-Fläche zu ihr selbst</translation>
    </message>
    <message>
      <source>a node without a hexahedron</source>
      <translation>ein Knoten ohne Hexaeder</translation>
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
      <source>about %(count)s elements, more where it is thinner than %(thickness)s</source>
      <translation>etwa %(count)s Elemente, mehr wo es dünner ist als %(thickness)s</translation>
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
      <source>an edge has no curve</source>
      <translation>eine Kante hat keine Kurve</translation>
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
      <source>blocks must both shrink and stay, whatever charts join the group</source>
      <translation>Blöcke müssten zugleich schrumpfen und bleiben, welche Bereiche auch dazukommen</translation>
    </message>
    <message>
      <source>boundary edges that do not have exactly two quads</source>
      <translation>Randkanten ohne genau zwei Vierecke</translation>
    </message>
    <message>
      <source>boundary faces without a quad</source>
      <translation>Randflächen ohne Viereck</translation>
    </message>
    <message>
      <source>boundary points off their CAD face, edge or vertex</source>
      <translation>Randpunkte neben ihrer CAD-Fläche, -Kante oder -Ecke</translation>
    </message>
    <message>
      <source>boundary points where the surface touches itself</source>
      <translation>Randpunkte, an denen sich die Oberfläche selbst berührt</translation>
    </message>
    <message>
      <source>boundary quads that are not outward faces of exactly one element</source>
      <translation>Randvierecke, die nicht die Außenfläche genau eines Elements sind</translation>
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
      <source>check the folder and the free space</source>
      <translation>den Ordner und den freien Platz prüfen</translation>
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
      <source>checking groups</source>
      <translation>Gruppen werden geprüft</translation>
    </message>
    <message>
      <source>choose a larger element size</source>
      <translation>eine größere Elementgröße wählen</translation>
    </message>
    <message>
      <source>choose a mesh made by Hex mesh from solid</source>
      <translation>ein Netz wählen, das mit Hexaedernetz aus Körper gemacht wurde</translation>
    </message>
    <message>
      <source>choose an object with a solid; make one of a shell with Part &gt; Convert to solid</source>
      <translation>ein Objekt mit einem Festkörper wählen; aus einer Hülle wird einer mit Part &gt; In Festkörper umwandeln</translation>
    </message>
    <message>
      <source>choose another folder</source>
      <translation>einen anderen Ordner wählen</translation>
    </message>
    <message>
      <source>close the open shell or export a solid</source>
      <translation>die offene Hülle schließen oder einen Festkörper exportieren</translation>
    </message>
    <message>
      <source>close what needs memory, or take a larger element size</source>
      <translation>schließen, was Speicher braucht, oder eine größere Elementgröße nehmen</translation>
    </message>
    <message>
      <source>condition V%1 fails</source>
      <translation>Bedingung V%1 ist verletzt</translation>
    </message>
    <message>
      <source>consecutive feature lines run in opposite directions</source>
      <translation>aufeinander folgende Merkmalslinien laufen gegeneinander</translation>
    </message>
    <message>
      <source>cut off in step %1</source>
      <translation>abgebrochen im Schritt %1</translation>
    </message>
    <message>
      <source>degrees; STL, OBJ and PLY surfaces are cut into faces at sharper creases</source>
      <translation>Grad; STL-, OBJ- und PLY-Oberflächen werden an schärferen Knicken in Flächen zerlegt</translation>
    </message>
    <message>
      <source>does not fill after %1 rounds</source>
      <translation>füllt sich nach %1 Runden nicht</translation>
    </message>
    <message>
      <source>element faces that are not shared by exactly two elements from opposite sides</source>
      <translation>Elementflächen, die nicht genau zwei Elemente von beiden Seiten haben</translation>
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
      <source>elements not proved positive (inverted or folded)</source>
      <translation>Elemente, deren Gültigkeit nicht bewiesen ist (umgestülpt oder gefaltet)</translation>
    </message>
    <message>
      <source>elements or quads with nodes that do not exist or are repeated</source>
      <translation>Elemente oder Vierecke mit fehlenden oder doppelten Knoten</translation>
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
      <source>face numbers are those of the mended solid</source>
      <translation>die Flächennummern sind die des ausgebesserten Körpers</translation>
    </message>
    <message>
      <source>face numbers are those of the sewn solid</source>
      <translation>die Flächennummern sind die des zusammengenähten Körpers</translation>
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
      <source>feature edges out of order</source>
      <translation>Merkmalskanten in falscher Reihenfolge</translation>
    </message>
    <message>
      <source>feature edges without a CAD edge entry</source>
      <translation>Merkmalskanten ohne CAD-Kante</translation>
    </message>
    <message>
      <source>feature lines</source>
      <translation>Merkmalslinien</translation>
    </message>
    <message>
      <source>feature-line, proposal %1 gave up in step %2</source>
      <translation>Merkmalslinien, Vorschlag %1 gab auf im Schritt %2</translation>
    </message>
    <message>
      <source>finding directions</source>
      <translation>Richtungen finden</translation>
    </message>
    <message>
      <source>first (8 nodes)</source>
      <translation>erste, 8 Knoten</translation>
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
      <source>give a file name</source>
      <translation>einen Dateinamen angeben</translation>
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
      <source>hexahedra do not share a face in pairs, from opposite sides</source>
      <translation>Hexaeder teilen ihre Flächen nicht paarweise von beiden Seiten</translation>
    </message>
    <message>
      <source>hexahedra that belong together must both shrink and stay</source>
      <translation>zusammengehörige Hexaeder müssten zugleich schrumpfen und bleiben</translation>
    </message>
    <message>
      <source>hexahedra without a block or solid entry</source>
      <translation>Hexaeder ohne Block oder Körper</translation>
    </message>
    <message>
      <source>hexfeature mesh --help lists the options</source>
      <translation>hexfeature mesh --help nennt die Optionen</translation>
    </message>
    <message>
      <source>insert O-grid sheets where block borders lie on smooth surface</source>
      <translation>O-Gitter-Schichten einfügen, wo Blockränder auf glatter Oberfläche liegen</translation>
    </message>
    <message>
      <source>install %1, or write .vtk, .inp or .unv</source>
      <translation>%1 installieren oder .vtk, .inp oder .unv schreiben</translation>
    </message>
    <message>
      <source>is %1 but must lie between %2 and %3</source>
      <translation>ist %1, muss aber zwischen %2 und %3 liegen</translation>
    </message>
    <message>
      <source>is '%1' but must be one of %2</source>
      <translation>ist '%1', muss aber eines von %2 sein</translation>
    </message>
    <message>
      <source>it has %1; 0 meshes all of them</source>
      <translation>es hat %1; 0 vernetzt alle</translation>
    </message>
    <message>
      <source>it is a folder</source>
      <translation>es ist ein Ordner</translation>
    </message>
    <message>
      <source>it is no regular file</source>
      <translation>es ist keine gewöhnliche Datei</translation>
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
      <source>its tetrahedra were made ahead</source>
      <translation>seine Tetraeder wurden im Voraus gemacht</translation>
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
      <source>loose faces were sewn into a solid</source>
      <translation>lose Flächen wurden zu einem Körper zusammengenäht</translation>
    </message>
    <message>
      <source>make the folder first</source>
      <translation>erst den Ordner anlegen</translation>
    </message>
    <message>
      <source>mean SJ %1 -&gt; %2, %3 points held</source>
      <translation>mittlere SJ %1 -&gt; %2, %3 Punkte gehalten</translation>
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
      <source>min SJ %1, inverted %2 of %3</source>
      <translation>kleinste SJ %1, umgestülpt %2 von %3</translation>
    </message>
    <message>
      <source>more lines between %1 pairs of charts, %2 -&gt; %3 hexahedra</source>
      <translation>mehr Linien zwischen %1 Paaren von Karten, %2 -&gt; %3 Hexaeder</translation>
    </message>
    <message>
      <source>must be a finite number</source>
      <translation>muss eine endliche Zahl sein</translation>
    </message>
    <message>
      <source>must be a number</source>
      <translation>muss eine Zahl sein</translation>
    </message>
    <message>
      <source>must be a text</source>
      <translation>muss ein Text sein</translation>
    </message>
    <message>
      <source>must be a whole number</source>
      <translation>muss eine ganze Zahl sein</translation>
    </message>
    <message>
      <source>must be true or false</source>
      <translation>muss wahr oder falsch sein</translation>
    </message>
    <message>
      <source>neighbouring feature surfaces lie on one axis</source>
      <translation>benachbarte Merkmalsflächen liegen auf einer Achse</translation>
    </message>
    <message>
      <source>neighbouring triangles are oriented against each other</source>
      <translation>benachbarte Dreiecke sind gegeneinander orientiert</translation>
    </message>
    <message>
      <source>no block needs to shrink</source>
      <translation>kein Block muss schrumpfen</translation>
    </message>
    <message>
      <source>no cut</source>
      <translation>kein Schnitt</translation>
    </message>
    <message>
      <source>no feature line of a feature surface runs in direction</source>
      <translation>keine Merkmalslinie einer Merkmalsfläche läuft in Richtung</translation>
    </message>
    <message>
      <source>no feature surface has direction</source>
      <translation>keine Merkmalsfläche hat die Richtung</translation>
    </message>
    <message>
      <source>no free loop of nodes</source>
      <translation>kein freier Ring von Knoten</translation>
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
      <source>no polycube has a corner of</source>
      <translation>kein Polycube hat eine Ecke aus</translation>
    </message>
    <message>
      <source>no right to create files in '%1'</source>
      <translation>keine Berechtigung, in '%1' Dateien anzulegen</translation>
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
      <source>nodes without a CAD place entry</source>
      <translation>Knoten ohne CAD-Zuordnung</translation>
    </message>
    <message>
      <source>none</source>
      <translation>keine</translation>
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
      <source>option '%1' cannot be %2</source>
      <translation>die Option '%1' kann nicht %2 sein</translation>
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
      <source>pairs of points at the same place</source>
      <translation>Paare von Punkten am selben Ort</translation>
    </message>
    <message>
      <source>part and lattice would be cut differently</source>
      <translation>Teil und Gitter würden verschieden zerschnitten</translation>
    </message>
    <message>
      <source>please report the part</source>
      <translation>bitte das Teil melden</translation>
    </message>
    <message>
      <source>points are flat</source>
      <translation>die Punkte liegen flach</translation>
    </message>
    <message>
      <source>points that belong to no element</source>
      <translation>Punkte, die zu keinem Element gehören</translation>
    </message>
    <message>
      <source>points with coordinates that are not numbers</source>
      <translation>Punkte, deren Koordinaten keine Zahlen sind</translation>
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
      <source>quads without a chart or CAD face entry</source>
      <translation>Vierecke ohne Bereich oder CAD-Fläche</translation>
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
      <translation>zweite, 20 Knoten</translation>
    </message>
    <message>
      <source>second look gave up in step %1</source>
      <translation>zweiter Blick gab auf im Schritt %1</translation>
    </message>
    <message>
      <source>second order</source>
      <translation>zweite Ordnung</translation>
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
      <source>shape places and the boundary disagree</source>
      <translation>Formzuordnung und Rand widersprechen sich</translation>
    </message>
    <message>
      <source>sharp CAD edges</source>
      <translation>scharfe CAD-Kanten</translation>
    </message>
    <message>
      <source>sheet along charts</source>
      <translation>Schicht längs der Bereiche</translation>
    </message>
    <message>
      <source>sheet under the floor of chart</source>
      <translation>Schicht unter dem Boden des Bereichs</translation>
    </message>
    <message>
      <source>size is %1 but must be a length greater than 0</source>
      <translation>die Elementgröße ist %1, muss aber eine Länge über 0 sein</translation>
    </message>
    <message>
      <source>size is %1 but must be a length in mm</source>
      <translation>die Elementgröße ist %1, muss aber eine Länge in mm sein</translation>
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
      <source>tet-split gave up in step %1</source>
      <translation>das Verfahren aus Tetraedern gab auf im Schritt %1</translation>
    </message>
    <message>
      <source>tet-split, attempt %1</source>
      <translation>aus Tetraedern, Versuch %1</translation>
    </message>
    <message>
      <source>tet-split, attempt %1 gave up in step %2</source>
      <translation>aus Tetraedern, Versuch %1 gab auf im Schritt %2</translation>
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
      <source>the B-rep text cannot be read</source>
      <translation>der B-Rep-Text lässt sich nicht lesen</translation>
    </message>
    <message>
      <source>the Python package %1 is missing</source>
      <translation>das Python-Paket %1 fehlt</translation>
    </message>
    <message>
      <source>the axes disagree</source>
      <translation>die Achsen widersprechen sich</translation>
    </message>
    <message>
      <source>the boundary is not a manifold at a node</source>
      <translation>der Rand ist an einem Knoten keine Mannigfaltigkeit</translation>
    </message>
    <message>
      <source>the boundary is not an oriented manifold</source>
      <translation>der Rand ist keine orientierte Mannigfaltigkeit</translation>
    </message>
    <message>
      <source>the boundary quads are not the complex's boundary</source>
      <translation>die Randvierecke sind nicht der Rand des Netzes</translation>
    </message>
    <message>
      <source>the charts at a corner leave one of its coordinates open</source>
      <translation>die Bereiche an einer Ecke lassen eine ihrer Koordinaten offen</translation>
    </message>
    <message>
      <source>the element size asks for about %1 elements</source>
      <translation>die Elementgröße verlangt etwa %1 Elemente</translation>
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
      <source>the feature lines along the</source>
      <translation>die Merkmalslinien längs der</translation>
    </message>
    <message>
      <source>the feature lines along the %1 axis run in a circle</source>
      <translation>die Merkmalslinien längs der %1-Achse laufen im Kreis</translation>
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
      <source>the hexahedral complex is damaged; please report this part</source>
      <translation>das Hexaedernetz ist beschädigt; bitte dieses Teil melden</translation>
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
      <source>the lines contradict each other at a corner of</source>
      <translation>die Linien widersprechen sich an einer Ecke aus</translation>
    </message>
    <message>
      <source>the map of chart %1 keeps %2 folded triangles</source>
      <translation>die Abbildung des Bereichs %1 behält %2 gefaltete Dreiecke</translation>
    </message>
    <message>
      <source>the maps on its sides would fold</source>
      <translation>die Abbildungen auf ihren Seiten würden sich falten</translation>
    </message>
    <message>
      <source>the mesh does not know which CAD entity its points lie on</source>
      <translation>das Netz weiß nicht, auf welchen CAD-Elementen seine Punkte liegen</translation>
    </message>
    <message>
      <source>the mesh has no elements</source>
      <translation>das Netz hat keine Elemente</translation>
    </message>
    <message>
      <source>the mesh has no hexahedra, or other volumes besides</source>
      <translation>das Netz hat keine Hexaeder oder daneben andere Volumenelemente</translation>
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
      <source>the meshing program (hexfeature._core) cannot be loaded: %(error)s.
FreeCAD runs Python %(python)s. Either run 'make build' in the workbench's folder with that Python, or install the package 'hexfeature' for it: python%(python)s -m pip install hexfeature</source>
      <translation>das Vernetzungsprogramm (hexfeature._core) lässt sich nicht laden: %(error)s.
FreeCAD läuft mit Python %(python)s. Entweder im Ordner des Arbeitsbereichs mit diesem Python 'make build' ausführen oder dafür das Paket 'hexfeature' installieren: python%(python)s -m pip install hexfeature</translation>
    </message>
    <message>
      <source>the object has no Solid%1</source>
      <translation>das Objekt hat kein Solid%1</translation>
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
      <source>the part cannot be analysed</source>
      <translation>das Teil lässt sich nicht untersuchen</translation>
    </message>
    <message>
      <source>the part cannot be mended</source>
      <translation>das Teil lässt sich nicht ausbessern</translation>
    </message>
    <message>
      <source>the part cannot be read</source>
      <translation>das Teil lässt sich nicht lesen</translation>
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
      <source>the part is still there from the run before</source>
      <translation>das Teil ist noch vom vorigen Lauf da</translation>
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
      <source>the part's geometry is defective near the named faces; try repairing it</source>
      <translation>die Geometrie des Teils ist bei den genannten Flächen fehlerhaft; vielleicht lässt sie sich reparieren</translation>
    </message>
    <message>
      <source>the part's volume cannot be measured</source>
      <translation>das Volumen des Teils lässt sich nicht messen</translation>
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
      <source>the sheet would be empty</source>
      <translation>die Schicht wäre leer</translation>
    </message>
    <message>
      <source>the sheet would cut a corner off the part</source>
      <translation>die Schicht schnitte eine Ecke des Teils ab</translation>
    </message>
    <message>
      <source>the sheet would leave along CAD edge %1 and turn off it within one quad</source>
      <translation>die Schicht träte längs der CAD-Kante %1 aus und böge im selben Viereck ab</translation>
    </message>
    <message>
      <source>the solid had faults and was healed</source>
      <translation>der Körper hatte Fehler und wurde geheilt</translation>
    </message>
    <message>
      <source>the solids are meshed one by one</source>
      <translation>die Körper werden einzeln vernetzt</translation>
    </message>
    <message>
      <source>the surface cannot be triangulated</source>
      <translation>die Oberfläche lässt sich nicht in Dreiecke zerlegen</translation>
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
      <source>there is no folder '%1'</source>
      <translation>es gibt keinen Ordner '%1'</translation>
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
      <source>this is a fault of the program</source>
      <translation>das ist ein Fehler des Programms</translation>
    </message>
    <message>
      <source>this method has neither labels nor feature lines</source>
      <translation>dieses Verfahren hat weder Richtungen noch Merkmalslinien</translation>
    </message>
    <message>
      <source>time limit reached</source>
      <translation>Zeitgrenze erreicht</translation>
    </message>
    <message>
      <source>tiny edges and faces were removed</source>
      <translation>winzige Kanten und Flächen wurden entfernt</translation>
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
      <source>try a smaller element size, or simplify the named faces</source>
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
      <source>two charts lie on the same cells</source>
      <translation>zwei Bereiche liegen auf denselben Zellen</translation>
    </message>
    <message>
      <source>two charts that face the same way follow each other</source>
      <translation>zwei gleich gerichtete Bereiche folgen aufeinander</translation>
    </message>
    <message>
      <source>two feature lines meet where they should not</source>
      <translation>zwei Merkmalslinien treffen sich, wo sie es nicht sollten</translation>
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
      <source>use a larger size, or allow more memory</source>
      <translation>eine größere Elementgröße verwenden oder mehr Speicher erlauben</translation>
    </message>
    <message>
      <source>use one of %1</source>
      <translation>eines von %1 verwenden</translation>
    </message>
    <message>
      <source>where they touch, their meshes do not share nodes</source>
      <translation>wo sie sich berühren, haben ihre Netze keine gemeinsamen Knoten</translation>
    </message>
    <message>
      <source>with %1 sheets</source>
      <translation>mit %1 Schichten</translation>
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
