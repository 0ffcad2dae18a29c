<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<TS version="2.1" language="de">
  <context>
    <name>App::Property</name>
    <message>
      <location filename="../../objects/target.py" />
      <source>Draft, Part or Sketch object whose edges are the target line</source>
      <translation>Draft-, Part- oder Skizzenobjekt, dessen Kanten die Ziellinie sind</translation>
    </message>
    <message>
      <location filename="../../objects/move.py" />
      <source>Largest change of the crease angle along the line</source>
      <translation>Größte Änderung des Knickwinkels entlang der Linie</translation>
    </message>
    <message>
      <location filename="../../objects/move.py" />
      <source>Largest distance of the compressed side to its old surface</source>
      <translation>Größter Abstand der gestauchten Seite von ihrer alten Fläche</translation>
    </message>
    <message>
      <location filename="../../objects/move.py" />
      <source>Largest distance of the moved line to its target [mm]</source>
      <translation>Größter Abstand der verschobenen Linie von ihrem Ziel [mm]</translation>
    </message>
    <message>
      <location filename="../../objects/target.py" />
      <source>Length of the target line</source>
      <translation>Länge der Ziellinie</translation>
    </message>
    <message>
      <location filename="../../objects/model.py" />
      <source>Length unit found in the file</source>
      <translation>Längeneinheit, die in der Datei steht</translation>
    </message>
    <message>
      <location filename="../../objects/target.py" />
      <source>Moves of the control points, made by dragging them</source>
      <translation>Verschiebungen der Kontrollpunkte, durch Ziehen entstanden</translation>
    </message>
    <message>
      <location filename="../../objects/move.py" />
      <source>New inflections in sections of the compressed side</source>
      <translation>Neue Wendepunkte in Schnitten der gestauchten Seite</translation>
    </message>
    <message>
      <location filename="../../objects/line_set.py" />
      <source>Number of lines found</source>
      <translation>Anzahl der gefundenen Linien</translation>
    </message>
    <message>
      <location filename="../../objects/line_set.py" />
      <source>Number, length and crease angle of each line</source>
      <translation>Nummer, Länge und Knickwinkel jeder Linie</translation>
    </message>
    <message>
      <location filename="../../objects/model.py" />
      <source>Part or Mesh object that is the model, instead of a file</source>
      <translation>Part- oder Mesh-Objekt, das statt einer Datei das Modell ist</translation>
    </message>
    <message>
      <location filename="../../objects/move.py" />
      <source>Region; without one, the options here count</source>
      <translation>Bereich; ohne einen gelten die Optionen hier</translation>
    </message>
    <message>
      <location filename="../../objects/line_set.py" />
      <location filename="../../objects/move.py" />
      <location filename="../../objects/target.py" />
      <source>Styling model, or the result of a move</source>
      <translation>Designmodell oder das Ergebnis einer Verschiebung</translation>
    </message>
    <message>
      <location filename="../../objects/move.py" />
      <source>Target line, or any object with a curve</source>
      <translation>Ziellinie oder ein anderes Objekt mit einer Kurve</translation>
    </message>
    <message>
      <location filename="../../objects/region.py" />
      <source>Target line, which also says model and line</source>
      <translation>Ziellinie, die auch Modell und Linie bestimmt</translation>
    </message>
    <message>
      <location filename="../../objects/move.py" />
      <source>The compressed side</source>
      <translation>Die gestauchte Seite</translation>
    </message>
    <message>
      <location filename="../../objects/model.py" />
      <source>The model's file, a copy of which is kept in the document</source>
      <translation>Die Datei des Modells, von der das Dokument eine Kopie enthält</translation>
    </message>
    <message>
      <location filename="../../objects/target.py" />
      <source>The stored curve as JSON</source>
      <translation>Die gespeicherte Kurve als JSON</translation>
    </message>
    <message>
      <location filename="../../objects/target.py" />
      <source>The target line as JSON</source>
      <translation>Die Ziellinie als JSON</translation>
    </message>
    <message>
      <location filename="../../objects/model.py" />
      <source>Triangles</source>
      <translation>Dreiecke</translation>
    </message>
    <message>
      <location filename="../../objects/region.py" />
      <source>Triangles in the region</source>
      <translation>Dreiecke im Bereich</translation>
    </message>
    <message>
      <location filename="../../objects/region.py" />
      <source>Vertices in the region</source>
      <translation>Punkte im Bereich</translation>
    </message>
    <message>
      <location filename="../../objects/model.py" />
      <source>Vertices of the triangles</source>
      <translation>Punkte der Dreiecke</translation>
    </message>
    <message>
      <location filename="../../objects/target.py" />
      <source>What the target line starts from</source>
      <translation>Womit die Ziellinie anfängt</translation>
    </message>
    <message>
      <location filename="../../objects/model.py" />
      <source>What was found and repaired</source>
      <translation>Was gefunden und repariert wurde</translation>
    </message>
    <message>
      <location filename="../../objects/model.py" />
      <source>Where the file came from</source>
      <translation>Woher die Datei kam</translation>
    </message>
    <message>
      <location filename="../../objects/move.py" />
      <source>Whether the line stays on the surface</source>
      <translation>Ob die Linie auf der Fläche bleibt</translation>
    </message>
    <message>
      <location filename="../../objects/move.py" />
      <location filename="../../objects/target.py" />
      <source>Which line moves: its number, or a part as in 0@10%..85% or 0@120..900 (mm)</source>
      <translation>Welche Linie verschoben wird: ihre Nummer oder ein Teil wie 0@10%..85% oder 0@120..900 (mm)</translation>
    </message>
  </context>
  <context>
    <name>QObject</name>
    <message>
      <location filename="../../init_gui.py" />
      <source>Tapeline</source>
      <translation>Tapeline</translation>
    </message>
  </context>
  <context>
    <name>Tapeline</name>
    <message>
      <location filename="../../solving.py" />
      <source>'{0}' has no {1}: choose an object for its property {1}.</source>
      <translation>„{0}“ hat kein {1}: Wählen Sie ein Objekt für die Eigenschaft {1}.</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>'{}' are no numbers of CAD faces; write them as in 4, 7.</source>
      <translation>„{}“ sind keine Nummern von CAD-Flächen; schreiben Sie sie wie 4, 7.</translation>
    </message>
    <message>
      <location filename="../../api.py" />
      <source>'{}' could not be computed.</source>
      <translation>„{}“ konnte nicht berechnet werden.</translation>
    </message>
    <message>
      <location filename="../../models.py" />
      <source>'{}' has neither a shape nor a mesh: choose a styling model, a Part or a Mesh object.</source>
      <translation>„{}“ hat weder eine Form noch ein Netz: Wählen Sie ein Designmodell, ein Part- oder ein Mesh-Objekt.</translation>
    </message>
    <message>
      <location filename="../../curves.py" />
      <source>'{}' has no curve that could be a target line.</source>
      <translation>„{}“ hat keine Kurve, die eine Ziellinie sein könnte.</translation>
    </message>
    <message>
      <location filename="../../curves.py" />
      <source>'{}' has no curve yet: recompute it first.</source>
      <translation>„{}“ hat noch keine Kurve: Berechnen Sie das Objekt zuerst.</translation>
    </message>
    <message>
      <location filename="../../objects/target.py" />
      <source>'{}' has no curve: choose one for its property LinkedCurve.</source>
      <translation>„{}“ hat keine Kurve: Wählen Sie eine für die Eigenschaft LinkedCurve.</translation>
    </message>
    <message>
      <location filename="../../models.py" />
      <source>'{}' has no model file: choose one for its property Source.</source>
      <translation>„{}“ hat keine Modelldatei: Wählen Sie eine für die Eigenschaft Source.</translation>
    </message>
    <message>
      <location filename="../../objects/line_set.py" />
      <location filename="../../objects/target.py" />
      <source>'{}' has no model: choose one for its property Model.</source>
      <translation>„{}“ hat kein Modell: Wählen Sie eins für die Eigenschaft Model.</translation>
    </message>
    <message>
      <location filename="../../models.py" />
      <source>'{}' has no result yet: recompute it first.</source>
      <translation>„{}“ hat noch kein Ergebnis: Berechnen Sie das Objekt zuerst.</translation>
    </message>
    <message>
      <location filename="../../objects/region.py" />
      <source>'{}' has no target line: choose one for its property Target.</source>
      <translation>„{}“ hat keine Ziellinie: Wählen Sie eine für die Eigenschaft Target.</translation>
    </message>
    <message>
      <location filename="../../curves.py" />
      <source>'{}' in the slide law is not a number; write distances in mm such as 0, 30, 0.</source>
      <translation>„{}“ im Verschiebeweg ist keine Zahl; schreiben Sie Abstände in mm wie 0, 30, 0.</translation>
    </message>
    <message>
      <location filename="../../jobs.py" />
      <source>'{}' is no Tapeline job: it names no input.</source>
      <translation>„{}“ ist kein Tapeline-Auftrag: Er nennt keine Eingabe (input).</translation>
    </message>
    <message>
      <location filename="../../api.py" />
      <source>'{}' is no move: only moves are exported.</source>
      <translation>„{}“ ist keine Verschiebung: Nur Verschiebungen werden exportiert.</translation>
    </message>
    <message>
      <location filename="../../objects/move.py" />
      <source>'{}' is no target line of a model: name the model and the line.</source>
      <translation>„{}“ ist keine Ziellinie eines Modells: Nennen Sie das Modell und die Linie.</translation>
    </message>
    <message>
      <location filename="../../models.py" />
      <source>'{}' names no line and is no file of vertex indices: {}.</source>
      <translation>„{}“ bezeichnet keine Linie und ist keine Datei mit Punktnummern: {}.</translation>
    </message>
    <message>
      <location filename="../../models.py" />
      <source>'{}' names no line: write 0, 0@10%..85% or 0@120..900.</source>
      <translation>„{}“ bezeichnet keine Linie: Schreiben Sie 0, 0@10%..85% oder 0@120..900.</translation>
    </message>
    <message>
      <location filename="../../jobs.py" />
      <source>'{}': '{}' is no section of a job.</source>
      <translation>„{}“: „{}“ ist kein Abschnitt eines Auftrags.</translation>
    </message>
    <message>
      <location filename="../../jobs.py" />
      <source>'{}': there is no option '{}.{}'.</source>
      <translation>„{}“: Es gibt keine Option „{}.{}“.</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>A box along the axes that holds the region, instead of a distance: smallest x, y, z, then largest x, y, z in mm</source>
      <translation>Ein Quader längs der Achsen, in dem der Bereich liegt, statt eines Abstands: kleinstes x, y, z, dann größtes x, y, z in mm</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>A click</source>
      <translation>Ein Klick</translation>
    </message>
    <message>
      <location filename="../../objects/target.py" />
      <source>A target line has no option '{}'.</source>
      <translation>Eine Ziellinie hat keine Option „{}“.</translation>
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <source>Blue is stretched, orange gives way</source>
      <translation>Blau wird gestreckt, Orange weicht aus</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>CAD faces that make up the region, instead of a distance</source>
      <translation>CAD-Flächen, aus denen der Bereich besteht, statt eines Abstands</translation>
    </message>
    <message>
      <location filename="../../panels/import_model.py" />
      <source>CAD files carry their own unit; lengths are mm in the document. The deviation and the angle say how fine a CAD model is divided into triangles.</source>
      <translation>CAD-Dateien bringen ihre Einheit mit; im Dokument sind Längen in mm. Abweichung und Winkel sagen, wie fein ein CAD-Modell in Dreiecke geteilt wird.</translation>
    </message>
    <message>
      <location filename="../../worker.py" />
      <source>Cancel</source>
      <translation>Abbrechen</translation>
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>Check surface</source>
      <translation>Fläche prüfen</translation>
    </message>
    <message>
      <location filename="../../panels/export.py" />
      <location filename="../../panels/import_model.py" />
      <source>Choose a file</source>
      <translation>Datei wählen</translation>
    </message>
    <message>
      <location filename="../../panels/import_model.py" />
      <source>Choose a model file first.</source>
      <translation>Wählen Sie zuerst eine Modelldatei.</translation>
    </message>
    <message>
      <location filename="../../objects/region.py" />
      <source>Choosing '{}'</source>
      <translation>„{}“ wird ausgewählt</translation>
    </message>
    <message>
      <location filename="../../panels/import_model.py" />
      <source>Close gaps up to</source>
      <translation>Lücken schließen bis</translation>
    </message>
    <message>
      <location filename="../../worker.py" />
      <source>Computing</source>
      <translation>Berechnung</translation>
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>Control points</source>
      <translation>Kontrollpunkte</translation>
    </message>
    <message>
      <location filename="../../panels/lines.py" />
      <location filename="../../panels/move.py" />
      <source>Crease angle</source>
      <translation>Knickwinkel</translation>
    </message>
    <message>
      <location filename="../../panels/lines.py" />
      <source>Cut at turns of</source>
      <translation>Trennen ab Wende</translation>
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <source>Drag the yellow points; the surface follows.</source>
      <translation>Ziehen Sie an den gelben Punkten; die Fläche folgt.</translation>
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <location filename="../../panels/target.py" />
      <source>Drags go</source>
      <translation>Ziehen geht</translation>
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <source>Exact.</source>
      <translation>Genau.</translation>
    </message>
    <message>
      <location filename="../../panels/export.py" />
      <source>Export</source>
      <translation>Exportieren</translation>
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>Feature line</source>
      <translation>Charakterlinie</translation>
    </message>
    <message>
      <location filename="../../objects/line_set.py" />
      <source>Feature lines of {}</source>
      <translation>Charakterlinien von {}</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>Feature lines that bound the region, instead of a distance</source>
      <translation>Charakterlinien, die den Bereich begrenzen, statt eines Abstands</translation>
    </message>
    <message>
      <location filename="../../panels/import_model.py" />
      <source>File</source>
      <translation>Datei</translation>
    </message>
    <message>
      <location filename="../../api.py" />
      <location filename="../../panels/lines.py" />
      <source>Find feature lines</source>
      <translation>Charakterlinien finden</translation>
    </message>
    <message>
      <location filename="../../objects/line_set.py" />
      <source>Finding the lines of '{}'</source>
      <translation>Die Linien von „{}“ werden gesucht</translation>
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <source>Following…</source>
      <translation>Folgt…</translation>
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>For fewer of them, say how many; laid on the surface, the line lies on it all the same.</source>
      <translation>Für weniger geben Sie ihre Anzahl an; auf die Fläche gelegt, liegt die Linie trotzdem auf ihr.</translation>
    </message>
    <message>
      <location filename="../../panels/lines.py" />
      <source>Found: {}. Pick one in the list or by a click on it.</source>
      <translation>Gefunden: {}. Wählen Sie eine in der Liste oder durch einen Klick auf sie.</translation>
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>Gaussian sign</source>
      <translation>Gauß-Vorzeichen</translation>
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <source>Gives way</source>
      <translation>Es weicht aus</translation>
    </message>
    <message>
      <location filename="../../panels/lines.py" />
      <source>Goes on along</source>
      <translation>Setzt sich fort ab</translation>
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <location filename="../../panels/region.py" />
      <source>Half-width</source>
      <translation>Halbe Breite</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>Hold lines</source>
      <translation>Festhalten</translation>
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>How many control points the line has; few are easier to drag</source>
      <translation>Wie viele Kontrollpunkte die Linie hat; wenige lassen sich leichter ziehen</translation>
    </message>
    <message>
      <location filename="../../panels/curve_editing.py" />
      <source>How the mouse moves a control point: along the surface, in the plane of the view, or along the surface's normal</source>
      <translation>Wie die Maus einen Kontrollpunkt bewegt: längs der Fläche, in der Ebene der Ansicht oder längs der Flächennormalen</translation>
    </message>
    <message>
      <location filename="../../api.py" />
      <location filename="../../panels/import_model.py" />
      <source>Import styling model</source>
      <translation>Designmodell einlesen</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>Keep lines</source>
      <translation>Erhalten</translation>
    </message>
    <message>
      <location filename="../../panels/import_model.py" />
      <source>Largest angle</source>
      <translation>Größter Winkel</translation>
    </message>
    <message>
      <location filename="../../panels/import_model.py" />
      <source>Largest deviation</source>
      <translation>Abweichung bis</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>Let go</source>
      <translation>Freigeben</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>Lets all pinned vertices and protected faces move again</source>
      <translation>Alle fixierten Punkte und geschützten Flächen dürfen sich wieder bewegen</translation>
    </message>
    <message>
      <location filename="../../objects/line_set.py" />
      <source>Line {}: {:.1f} mm long, crease {:.1f} deg (from {:.1f} to {:.1f})</source>
      <translation>Linie {}: {:.1f} mm lang, Knick {:.1f} Grad (von {:.1f} bis {:.1f})</translation>
    </message>
    <message>
      <location filename="../../api.py" />
      <location filename="../../commands/load_job.py" />
      <source>Load Tapeline job</source>
      <translation>Tapeline-Auftrag laden</translation>
    </message>
    <message>
      <location filename="../../objects/target.py" />
      <source>Making '{}'</source>
      <translation>„{}“ wird gemacht</translation>
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>Measure</source>
      <translation>Maß</translation>
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>Measuring…</source>
      <translation>Wird gemessen…</translation>
    </message>
    <message>
      <location filename="../../panels/export.py" />
      <source>Meshes (*.obj *.stl *.ply *.off)</source>
      <translation>Netze (*.obj *.stl *.ply *.off)</translation>
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <source>Method</source>
      <translation>Verfahren</translation>
    </message>
    <message>
      <location filename="../../panels/import_model.py" />
      <source>Models ({})</source>
      <translation>Modelle ({})</translation>
    </message>
    <message>
      <location filename="../../init_gui.py" />
      <source>Move character lines across styled surfaces</source>
      <translation>Charakterlinien über gestaltete Flächen verschieben</translation>
    </message>
    <message>
      <location filename="../../api.py" />
      <location filename="../../panels/move.py" />
      <source>Move feature line</source>
      <translation>Charakterlinie verschieben</translation>
    </message>
    <message>
      <location filename="../../objects/move.py" />
      <source>Move of line {}</source>
      <translation>Verschiebung der Linie {}</translation>
    </message>
    <message>
      <location filename="../../objects/move.py" />
      <source>Moving the feature line of '{}'</source>
      <translation>Die Charakterlinie von „{}“ wird verschoben</translation>
    </message>
    <message>
      <location filename="../../panels/export.py" />
      <source>Name a file for the surface, for the report, or both.</source>
      <translation>Nennen Sie eine Datei für die Fläche, für den Bericht oder für beide.</translation>
    </message>
    <message>
      <location filename="../../panels/lines.py" />
      <source>No edge is as sharp as this: lower the crease angle.</source>
      <translation>Keine Kante ist so scharf: Verringern Sie den Knickwinkel.</translation>
    </message>
    <message>
      <location filename="../../panels/import_model.py" />
      <source>Object</source>
      <translation>Objekt</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>Or by a box</source>
      <translation>Oder Quader</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>Or by faces</source>
      <translation>Oder Flächen</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>Or by lines</source>
      <translation>Oder Linien</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>Other lines that stay lines where the surface makes room: their vertices slide along them</source>
      <translation>Andere Linien, die Linien bleiben, wo die Fläche Platz macht: Ihre Punkte gleiten auf ihnen</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>Other lines whose vertices stay where they are</source>
      <translation>Andere Linien, deren Punkte bleiben, wo sie sind</translation>
    </message>
    <message>
      <location filename="../../panels/export.py" />
      <source>Pages (*.html)</source>
      <translation>Seiten (*.html)</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>Pinned: {}, protected: {}</source>
      <translation>Fixiert: {}, geschützt: {}</translation>
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <source>Preparing… The preview is coarse until finer triangles are ready.</source>
      <translation>Vorbereitung… Die Vorschau ist grob, bis feinere Dreiecke bereit sind.</translation>
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <source>Preview; the exact surface comes when the mouse rests.</source>
      <translation>Vorschau; die genaue Fläche kommt, wenn die Maus ruht.</translation>
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>Puts the control points back</source>
      <translation>Setzt die Kontrollpunkte zurück</translation>
    </message>
    <message>
      <location filename="../../objects/model.py" />
      <source>Reading '{}'</source>
      <translation>„{}“ wird gelesen</translation>
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <source>Reading the model…</source>
      <translation>Das Modell wird gelesen…</translation>
    </message>
    <message>
      <location filename="../../api.py" />
      <location filename="../../panels/move.py" />
      <location filename="../../panels/region.py" />
      <source>Region</source>
      <translation>Bereich</translation>
    </message>
    <message>
      <location filename="../../objects/region.py" />
      <source>Region of line {}</source>
      <translation>Bereich der Linie {}</translation>
    </message>
    <message>
      <location filename="../../panels/export.py" />
      <source>Report page</source>
      <translation>Bericht</translation>
    </message>
    <message>
      <location filename="../../panels/import_model.py" />
      <source>STEP, IGES, BREP, STL, OBJ, PLY or OFF</source>
      <translation>STEP, IGES, BREP, STL, OBJ, PLY oder OFF</translation>
    </message>
    <message>
      <location filename="../../panels/export.py" />
      <source>STL and PLY as text</source>
      <translation>STL und PLY als Text</translation>
    </message>
    <message>
      <location filename="../../commands/save_job.py" />
      <source>Save Tapeline job</source>
      <translation>Tapeline-Auftrag speichern</translation>
    </message>
    <message>
      <location filename="../../panels/lines.py" />
      <source>Shortest line</source>
      <translation>Kürzeste Linie</translation>
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>Show</source>
      <translation>Zeigen</translation>
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>Slide to the left (mm)</source>
      <translation>Verschieben nach links (mm)</translation>
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>Slides the line along the surface, to its left where positive: one distance, or several spread evenly over its length</source>
      <translation>Verschiebt die Linie längs der Fläche, positiv nach links: ein Abstand, oder mehrere gleichmäßig über die Länge verteilt</translation>
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>Starts as</source>
      <translation>Beginnt als</translation>
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <source>Stop</source>
      <translation>Anhalten</translation>
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <source>Stopped; drag a point or apply to compute again.</source>
      <translation>Angehalten; ziehen Sie einen Punkt oder wenden Sie an, um neu zu rechnen.</translation>
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <location filename="../../panels/export.py" />
      <source>Surface</source>
      <translation>Fläche</translation>
    </message>
    <message>
      <location filename="../../init_gui.py" />
      <source>Tapeline</source>
      <translation>Tapeline</translation>
    </message>
    <message>
      <location filename="../../commands/load_job.py" />
      <location filename="../../commands/save_job.py" />
      <source>Tapeline jobs (*.json)</source>
      <translation>Tapeline-Aufträge (*.json)</translation>
    </message>
    <message>
      <location filename="../../api.py" />
      <location filename="../../panels/target.py" />
      <source>Target line</source>
      <translation>Ziellinie</translation>
    </message>
    <message>
      <location filename="../../objects/target.py" />
      <source>Target of line {}</source>
      <translation>Ziel der Linie {}</translation>
    </message>
    <message>
      <location filename="../../engine.py" />
      <source>The compiled Python module 'tapeline' cannot be loaded: {}. Build or install it anew.</source>
      <translation>Das übersetzte Python-Modul „tapeline“ lässt sich nicht laden: {}. Übersetzen oder installieren Sie es neu.</translation>
    </message>
    <message>
      <location filename="../../engine.py" />
      <source>The compiled Python module 'tapeline' was not found, so nothing can be computed. Build it (scripts/test) or install it (cmake --install), or name its folder in Edit &gt; Preferences &gt; Tapeline.</source>
      <translation>Das übersetzte Python-Modul „tapeline“ wurde nicht gefunden, daher kann nichts berechnet werden. Übersetzen Sie es (scripts/test), installieren Sie es (cmake --install), oder nennen Sie seinen Ordner unter Bearbeiten &gt; Einstellungen &gt; Tapeline.</translation>
    </message>
    <message>
      <location filename="../../objects/base.py" />
      <source>The computation was cancelled; recompute to do it after all.</source>
      <translation>Die Berechnung wurde abgebrochen; berechnen Sie neu, um sie doch auszuführen.</translation>
    </message>
    <message>
      <location filename="../../curves.py" />
      <source>The edges of '{}' form {} separate curves; a target line is one connected curve: select the edges that belong to it.</source>
      <translation>Die Kanten von „{}“ bilden {} getrennte Kurven; eine Ziellinie ist eine zusammenhängende Kurve: Wählen Sie die Kanten, die zu ihr gehören.</translation>
    </message>
    <message>
      <location filename="../../panels/export.py" />
      <source>The ending says the format: .obj, .stl, .ply or .off. OBJ and PLY keep every digit; STL holds single precision when it is binary. Leave a field empty to skip it.</source>
      <translation>Die Endung bestimmt das Format: .obj, .stl, .ply oder .off. OBJ und PLY behalten jede Ziffer; binäres STL hält nur einfache Genauigkeit. Ein leeres Feld wird ausgelassen.</translation>
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>The feature line's number, or a part of it: 0@10%..85%, or 0@120..900 in mm</source>
      <translation>Die Nummer der Charakterlinie oder ein Teil von ihr: 0@10%..85%, oder 0@120..900 in mm</translation>
    </message>
    <message>
      <location filename="../../jobs.py" />
      <source>The job '{}' cannot be written: {}.</source>
      <translation>Der Auftrag „{}“ lässt sich nicht schreiben: {}.</translation>
    </message>
    <message>
      <location filename="../../jobs.py" />
      <source>The job file '{}' cannot be read: {}.</source>
      <translation>Die Auftragsdatei „{}“ lässt sich nicht lesen: {}.</translation>
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <source>The line lies</source>
      <translation>Die Linie liegt</translation>
    </message>
    <message>
      <location filename="../../objects/line_set.py" />
      <source>The model has no edge as sharp as the crease angle {:g} deg: lower it, or choose another model.</source>
      <translation>Das Modell hat keine Kante, die so scharf ist wie der Knickwinkel {:g} Grad: Verringern Sie ihn, oder wählen Sie ein anderes Modell.</translation>
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>The number of control points changed, so their moves by hand are gone.</source>
      <translation>Die Anzahl der Kontrollpunkte hat sich geändert, daher sind ihre Verschiebungen von Hand fort.</translation>
    </message>
    <message>
      <location filename="../../objects/model.py" />
      <source>There is no file '{}'.</source>
      <translation>Es gibt keine Datei „{}“.</translation>
    </message>
    <message>
      <location filename="../../panels/export.py" />
      <source>There is no folder '{}'.</source>
      <translation>Es gibt keinen Ordner „{}“.</translation>
    </message>
    <message>
      <location filename="../../models.py" />
      <source>There is no line {}: at these crease angles the model has {} of them, counted from 0.</source>
      <translation>Es gibt keine Linie {}: Bei diesen Knickwinkeln hat das Modell {} davon, gezählt ab 0.</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>This model has no CAD faces; pin vertices instead.</source>
      <translation>Dieses Modell hat keine CAD-Flächen; fixieren Sie stattdessen Punkte.</translation>
    </message>
    <message>
      <location filename="../../commands/selection.py" />
      <source>This needs {}; select one, or make one first.</source>
      <translation>Dazu braucht es {}; wählen Sie das aus, oder legen Sie es zuerst an.</translation>
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>Tolerance</source>
      <translation>Toleranz</translation>
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <location filename="../../panels/target.py" />
      <source>Undo dragging</source>
      <translation>Ziehen rückgängig</translation>
    </message>
    <message>
      <location filename="../../panels/import_model.py" />
      <source>Unit of mesh files</source>
      <translation>Einheit von Netzen</translation>
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>Value</source>
      <translation>Wert</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>What a click in the 3D view does; a second click on the same thing takes it back</source>
      <translation>Was ein Klick in der 3D-Ansicht tut; ein zweiter Klick auf dasselbe nimmt es zurück</translation>
    </message>
    <message>
      <location filename="../../panels/export.py" />
      <source>Writing the report</source>
      <translation>Der Bericht wird geschrieben</translation>
    </message>
    <message>
      <location filename="../../commands/selection.py" />
      <source>a move (Tapeline &gt; Move feature line)</source>
      <translation>eine Verschiebung (Tapeline &gt; Charakterlinie verschieben)</translation>
    </message>
    <message>
      <location filename="../../commands/selection.py" />
      <source>a region (Tapeline &gt; Region)</source>
      <translation>einen Bereich (Tapeline &gt; Bereich)</translation>
    </message>
    <message>
      <location filename="../../commands/selection.py" />
      <source>a styling model (Tapeline &gt; Import styling model)</source>
      <translation>ein Designmodell (Tapeline &gt; Designmodell einlesen)</translation>
    </message>
    <message>
      <location filename="../../commands/selection.py" />
      <source>a target line (Tapeline &gt; Target line)</source>
      <translation>eine Ziellinie (Tapeline &gt; Ziellinie)</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>adds a face</source>
      <translation>nimmt Fläche hinzu</translation>
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>after the move</source>
      <translation>nach der Verschiebung</translation>
    </message>
    <message>
      <location filename="../../panels/curve_editing.py" />
      <source>along normal</source>
      <translation>längs Normale</translation>
    </message>
    <message>
      <location filename="../../panels/curve_editing.py" />
      <source>along surface</source>
      <translation>längs Fläche</translation>
    </message>
    <message>
      <location filename="../../panels/base.py" />
      <source>automatic</source>
      <translation>automatisch</translation>
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>before the move</source>
      <translation>vor der Verschiebung</translation>
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>blue (below) to red (above): {:.4g} mm</source>
      <translation>blau (darunter) bis rot (darüber): {:.4g} mm</translation>
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>blue to red: -{0:.2g} to {0:.2g} per mm</source>
      <translation>blau bis rot: -{0:.2g} bis {0:.2g} je mm</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>bounds by a line</source>
      <translation>begrenzt an Linie</translation>
    </message>
    <message>
      <location filename="../../panels/strip.py" />
      <source>bulge</source>
      <translation>Beule</translation>
    </message>
    <message>
      <location filename="../../panels/strip.py" />
      <source>crease change</source>
      <translation>Knickänderung</translation>
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>curve of {}</source>
      <translation>Kurve von {}</translation>
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>displacement</source>
      <translation>Verschiebung</translation>
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>distance to before</source>
      <translation>Abstand zu vorher</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>e.g. 1, 3</source>
      <translation>z. B. 1, 3</translation>
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>e.g. 20 or 0, 30, 60, 30, 0</source>
      <translation>z. B. 20 oder 0, 30, 60, 30, 0</translation>
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>fair, by at most</source>
      <translation>glätten, bis</translation>
    </message>
    <message>
      <location filename="../../commands/selection.py" />
      <source>feature lines (Tapeline &gt; Find feature lines)</source>
      <translation>Charakterlinien (Tapeline &gt; Charakterlinien finden)</translation>
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>fitted</source>
      <translation>angepasst</translation>
    </message>
    <message>
      <location filename="../../panels/base.py" />
      <source>free</source>
      <translation>frei</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>holds a line</source>
      <translation>hält Linie fest</translation>
    </message>
    <message>
      <location filename="../../panels/curve_editing.py" />
      <source>in view plane</source>
      <translation>in Bildebene</translation>
    </message>
    <message>
      <location filename="../../panels/strip.py" />
      <source>inflections</source>
      <translation>Wendepunkte</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>keeps a line</source>
      <translation>erhält Linie</translation>
    </message>
    <message>
      <location filename="../../panels/base.py" />
      <source>kept</source>
      <translation>erhalten</translation>
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>lay on the surface</source>
      <translation>auf die Fläche legen</translation>
    </message>
    <message>
      <location filename="../../panels/base.py" />
      <location filename="../../panels/move.py" />
      <source>left</source>
      <translation>links</translation>
    </message>
    <message>
      <location filename="../../panels/strip.py" />
      <source>line error</source>
      <translation>Linienfehler</translation>
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>mean curvature</source>
      <translation>mittlere Krümmung</translation>
    </message>
    <message>
      <location filename="../../panels/base.py" />
      <source>off the surface</source>
      <translation>neben der Fläche</translation>
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <source>off the surface ({:.0f} % of the line); both sides bend</source>
      <translation>neben der Fläche ({:.0f} % der Linie); beide Seiten biegen sich</translation>
    </message>
    <message>
      <location filename="../../panels/base.py" />
      <source>on the surface</source>
      <translation>auf der Fläche</translation>
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <source>on the surface; the {} side gives way ({:.0f} % of the line off it)</source>
      <translation>auf der Fläche; die Seite {} weicht aus ({:.0f} % der Linie liegen daneben)</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>open borders may move</source>
      <translation>offene Ränder frei</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>pins a vertex</source>
      <translation>fixiert einen Punkt</translation>
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>plain</source>
      <translation>schlicht</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>protects a face</source>
      <translation>schützt eine Fläche</translation>
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>red: dome or bowl (both curvatures of one sign), blue: saddle, grey: flat within the reading's precision</source>
      <translation>rot: Kuppe oder Mulde (beide Krümmungen mit gleichem Vorzeichen), blau: Sattel, grau: flach im Rahmen der Messgenauigkeit</translation>
    </message>
    <message>
      <location filename="../../panels/base.py" />
      <location filename="../../panels/move.py" />
      <source>right</source>
      <translation>rechts</translation>
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>sections with curvature combs</source>
      <translation>Schnitte mit Krümmungskämmen</translation>
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>stored curve</source>
      <translation>gespeicherte Kurve</translation>
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <source>tint the two sides</source>
      <translation>beide Seiten färben</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>turns the view</source>
      <translation>dreht Ansicht</translation>
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>up to {:.4g} mm</source>
      <translation>bis {:.4g} mm</translation>
    </message>
    <message>
      <location filename="../../commands/save_job.py" />
      <location filename="../../panels/export.py" />
      <source>wrote {}</source>
      <translation>{} geschrieben</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>x, y, z from; x, y, z to (mm)</source>
      <translation>x, y, z von; x, y, z bis (mm)</translation>
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>zebra stripes</source>
      <translation>Zebrastreifen</translation>
    </message>
    <message>
      <location filename="../../objects/model.py" />
      <source>{} (styling model)</source>
      <translation>{} (Designmodell)</translation>
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>{} control points, {:.1f} mm long. Drag the yellow points in the 3D view.</source>
      <translation>{} Kontrollpunkte, {:.1f} mm lang. Ziehen Sie an den gelben Punkten in der 3D-Ansicht.</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>{} vertices and {} triangles may move (green); red triangles touch what stays.</source>
      <translation>{} Punkte und {} Dreiecke dürfen sich bewegen (grün); rote Dreiecke grenzen an das, was bleibt.</translation>
    </message>
    <message>
      <location filename="../../objects/target.py" />
      <source>{}: the number of control points changed, so their moves by hand are gone.</source>
      <translation>{}: Die Anzahl der Kontrollpunkte hat sich geändert, daher sind ihre Verschiebungen von Hand fort.</translation>
    </message>
    <message>
      <location filename="../../objects/model.py" />
      <source>{}: {} vertices, {} triangles, lengths in {}</source>
      <translation>{}: {} Punkte, {} Dreiecke, Längen in {}</translation>
    </message>
  </context>
  <context>
    <name>TapelinePreferences</name>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source> (mm)</source>
      <translation> (mm)</translation>
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source> mm</source>
      <translation> mm</translation>
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source> ms</source>
      <translation> ms</translation>
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source> px</source>
      <translation> px</translation>
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source> °</source>
      <translation> °</translation>
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source>Bulge of the compressed side</source>
      <translation>Beule der gestauchten Seite</translation>
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source>Change of the crease angle</source>
      <translation>Änderung des Knickwinkels</translation>
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source>Compiled module</source>
      <translation>Übersetztes Modul</translation>
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source>Distance of the line to its target, as 10 to the power</source>
      <translation>Abstand der Linie von ihrem Ziel, als Zehnerpotenz</translation>
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source>Exact result after the mouse rests for</source>
      <translation>Genaues Ergebnis, wenn die Maus ruht seit</translation>
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source>Folder of the Python module</source>
      <translation>Ordner des Python-Moduls</translation>
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source>Limits of the quality strip</source>
      <translation>Grenzen der Qualitätsanzeige</translation>
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source>New inflections in a section</source>
      <translation>Neue Wendepunkte in einem Schnitt</translation>
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source>Preview and display</source>
      <translation>Vorschau und Anzeige</translation>
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source>Scale of curvature combs</source>
      <translation>Maßstab der Krümmungskämme</translation>
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source>Size of control points</source>
      <translation>Größe der Kontrollpunkte</translation>
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source>Tapeline</source>
      <translation>Tapeline</translation>
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source>The folder that holds the folder tapeline with the compiled module; empty to look where it is built or installed</source>
      <translation>Der Ordner, in dem der Ordner tapeline mit dem übersetzten Modul liegt; leer: dort suchen, wo es übersetzt oder installiert wird</translation>
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source>Time for a preview while dragging</source>
      <translation>Zeit für eine Vorschau beim Ziehen</translation>
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source>Zebra stripes</source>
      <translation>Zebrastreifen</translation>
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source>amber above</source>
      <translation>gelb über</translation>
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source>red above</source>
      <translation>rot über</translation>
    </message>
  </context>
  <context>
    <name>Tapeline_Check</name>
    <message>
      <location filename="../../commands/check.py" />
      <source>Check surface…</source>
      <translation>Fläche prüfen…</translation>
    </message>
    <message>
      <location filename="../../commands/check.py" />
      <source>Shows zebra stripes, curvature and the distance to the surface before, sections with curvature combs, and the table of measures</source>
      <translation>Zeigt Zebrastreifen, Krümmung und den Abstand zur Fläche davor, Schnitte mit Krümmungskämmen und die Tabelle der Maße</translation>
    </message>
  </context>
  <context>
    <name>Tapeline_Export</name>
    <message>
      <location filename="../../commands/export.py" />
      <source>Export…</source>
      <translation>Exportieren…</translation>
    </message>
    <message>
      <location filename="../../commands/export.py" />
      <source>Writes the moved surface as STL, OBJ, PLY or OFF in full precision, and a page with its measures and pictures</source>
      <translation>Schreibt die verschobene Fläche als STL, OBJ, PLY oder OFF mit allen Stellen und eine Seite mit ihren Maßen und Bildern</translation>
    </message>
  </context>
  <context>
    <name>Tapeline_FindLines</name>
    <message>
      <location filename="../../commands/find_lines.py" />
      <source>Find feature lines…</source>
      <translation>Charakterlinien finden…</translation>
    </message>
    <message>
      <location filename="../../commands/find_lines.py" />
      <source>Finds the sharp lines of the styling model; the crease angle is set with a slider</source>
      <translation>Findet die scharfen Linien des Designmodells; der Knickwinkel wird mit einem Schieber eingestellt</translation>
    </message>
  </context>
  <context>
    <name>Tapeline_ImportModel</name>
    <message>
      <location filename="../../commands/import_model.py" />
      <source>Import styling model…</source>
      <translation>Designmodell einlesen…</translation>
    </message>
    <message>
      <location filename="../../commands/import_model.py" />
      <source>Reads a STEP, IGES, BREP, STL, OBJ, PLY or OFF file, or takes the selected Part or Mesh object, as the model whose lines are moved</source>
      <translation>Liest eine STEP-, IGES-, BREP-, STL-, OBJ-, PLY- oder OFF-Datei oder nimmt das gewählte Part- oder Mesh-Objekt als das Modell, dessen Linien verschoben werden</translation>
    </message>
  </context>
  <context>
    <name>Tapeline_LoadJob</name>
    <message>
      <location filename="../../commands/load_job.py" />
      <source>Load Tapeline job…</source>
      <translation>Tapeline-Auftrag laden…</translation>
    </message>
    <message>
      <location filename="../../commands/load_job.py" />
      <source>Makes model, target line, region and move from a job file of the command "tapeline"</source>
      <translation>Macht Modell, Ziellinie, Bereich und Verschiebung aus einer Auftragsdatei des Befehls „tapeline“</translation>
    </message>
  </context>
  <context>
    <name>Tapeline_Move</name>
    <message>
      <location filename="../../commands/move.py" />
      <source>Move feature line…</source>
      <translation>Charakterlinie verschieben…</translation>
    </message>
    <message>
      <location filename="../../commands/move.py" />
      <source>Moves the line to its target and lets the surface follow: drag the control points and watch the surface and its measures, then apply</source>
      <translation>Verschiebt die Linie zu ihrem Ziel und lässt die Fläche folgen: Kontrollpunkte ziehen, Fläche und Maße beobachten, dann anwenden</translation>
    </message>
  </context>
  <context>
    <name>Tapeline_Region</name>
    <message>
      <location filename="../../commands/region.py" />
      <source>Chooses what may follow the line: a band, bounding lines or CAD faces, with vertices and faces that stay where they are</source>
      <translation>Bestimmt, was der Linie folgen darf: ein Band, begrenzende Linien oder CAD-Flächen, mit Punkten und Flächen, die bleiben, wo sie sind</translation>
    </message>
    <message>
      <location filename="../../commands/region.py" />
      <source>Region…</source>
      <translation>Bereich…</translation>
    </message>
  </context>
  <context>
    <name>Tapeline_SaveJob</name>
    <message>
      <location filename="../../commands/save_job.py" />
      <source>Save Tapeline job…</source>
      <translation>Tapeline-Auftrag speichern…</translation>
    </message>
    <message>
      <location filename="../../commands/save_job.py" />
      <source>Writes the move as a job file with its model and target line; the command "tapeline run" makes the same surface from it, to the last bit</source>
      <translation>Schreibt die Verschiebung als Auftragsdatei mit ihrem Modell und ihrer Ziellinie; der Befehl „tapeline run“ macht daraus dieselbe Fläche, bis zum letzten Bit</translation>
    </message>
  </context>
  <context>
    <name>Tapeline_Target</name>
    <message>
      <location filename="../../commands/target.py" />
      <source>Fits a B-spline to the picked feature line and shapes it: drag its control points, slide it by numbers, fair it, lay it on the surface; or uses the selected curve</source>
      <translation>Passt eine B-Spline an die gewählte Charakterlinie an und formt sie: Kontrollpunkte ziehen, um Abstände verschieben, glätten, auf die Fläche legen; oder nimmt die gewählte Kurve</translation>
    </message>
    <message>
      <location filename="../../commands/target.py" />
      <source>Target line…</source>
      <translation>Ziellinie…</translation>
    </message>
  </context>
  <context>
    <name>Workbench</name>
    <message>
      <location filename="../../init_gui.py" />
      <source>&amp;Tapeline</source>
      <translation>&amp;Tapeline</translation>
    </message>
    <message>
      <location filename="../../init_gui.py" />
      <source>Tapeline</source>
      <translation>Tapeline</translation>
    </message>
  </context>
</TS>
