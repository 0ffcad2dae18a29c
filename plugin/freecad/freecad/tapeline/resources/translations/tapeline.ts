<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<TS version="2.1">
  <context>
    <name>App::Property</name>
    <message>
      <location filename="../../objects/target.py" />
      <source>Draft, Part or Sketch object whose edges are the target line</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../objects/move.py" />
      <source>Largest change of the crease angle along the line</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../objects/move.py" />
      <source>Largest distance of the compressed side to its old surface</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../objects/move.py" />
      <source>Largest distance of the moved line to its target [mm]</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../objects/target.py" />
      <source>Length of the target line</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../objects/model.py" />
      <source>Length unit found in the file</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../objects/target.py" />
      <source>Moves of the control points, made by dragging them</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../objects/move.py" />
      <source>New inflections in sections of the compressed side</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../objects/line_set.py" />
      <source>Number of lines found</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../objects/line_set.py" />
      <source>Number, length and crease angle of each line</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../objects/model.py" />
      <source>Part or Mesh object that is the model, instead of a file</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../objects/move.py" />
      <source>Region; without one, the options here count</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../objects/line_set.py" />
      <location filename="../../objects/move.py" />
      <location filename="../../objects/target.py" />
      <source>Styling model, or the result of a move</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../objects/move.py" />
      <source>Target line, or any object with a curve</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../objects/region.py" />
      <source>Target line, which also says model and line</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../objects/move.py" />
      <source>The compressed side</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../objects/model.py" />
      <source>The model's file, a copy of which is kept in the document</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../objects/target.py" />
      <source>The stored curve as JSON</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../objects/target.py" />
      <source>The target line as JSON</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../objects/model.py" />
      <source>Triangles</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../objects/region.py" />
      <source>Triangles in the region</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../objects/region.py" />
      <source>Vertices in the region</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../objects/model.py" />
      <source>Vertices of the triangles</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../objects/target.py" />
      <source>What the target line starts from</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../objects/model.py" />
      <source>What was found and repaired</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../objects/model.py" />
      <source>Where the file came from</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../objects/move.py" />
      <source>Whether the line stays on the surface</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../objects/move.py" />
      <location filename="../../objects/target.py" />
      <source>Which line moves: its number, or a part as in 0@10%..85% or 0@120..900 (mm)</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>QObject</name>
    <message>
      <location filename="../../init_gui.py" />
      <source>Tapeline</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>Tapeline</name>
    <message>
      <location filename="../../solving.py" />
      <source>'{0}' has no {1}: choose an object for its property {1}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>'{}' are no numbers of CAD faces; write them as in 4, 7.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../api.py" />
      <source>'{}' could not be computed.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../models.py" />
      <source>'{}' has neither a shape nor a mesh: choose a styling model, a Part or a Mesh object.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../curves.py" />
      <source>'{}' has no curve that could be a target line.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../curves.py" />
      <source>'{}' has no curve yet: recompute it first.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../objects/target.py" />
      <source>'{}' has no curve: choose one for its property LinkedCurve.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../models.py" />
      <source>'{}' has no model file: choose one for its property Source.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../objects/line_set.py" />
      <location filename="../../objects/target.py" />
      <source>'{}' has no model: choose one for its property Model.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../models.py" />
      <source>'{}' has no result yet: recompute it first.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../objects/region.py" />
      <source>'{}' has no target line: choose one for its property Target.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../curves.py" />
      <source>'{}' in the slide law is not a number; write distances in mm such as 0, 30, 0.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../jobs.py" />
      <source>'{}' is no Tapeline job: it names no input.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../api.py" />
      <source>'{}' is no move: only moves are exported.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../objects/move.py" />
      <source>'{}' is no target line of a model: name the model and the line.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../models.py" />
      <source>'{}' names no line and is no file of vertex indices: {}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../models.py" />
      <source>'{}' names no line: write 0, 0@10%..85% or 0@120..900.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../jobs.py" />
      <source>'{}': '{}' is no section of a job.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../jobs.py" />
      <source>'{}': there is no option '{}.{}'.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>A box along the axes that holds the region, instead of a distance: smallest x, y, z, then largest x, y, z in mm</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>A click</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../objects/target.py" />
      <source>A target line has no option '{}'.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <source>Blue is stretched, orange gives way</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>CAD faces that make up the region, instead of a distance</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/import_model.py" />
      <source>CAD files carry their own unit; lengths are mm in the document. The deviation and the angle say how fine a CAD model is divided into triangles.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../worker.py" />
      <source>Cancel</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>Check surface</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/export.py" />
      <location filename="../../panels/import_model.py" />
      <source>Choose a file</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/import_model.py" />
      <source>Choose a model file first.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../objects/region.py" />
      <source>Choosing '{}'</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/import_model.py" />
      <source>Close gaps up to</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../worker.py" />
      <source>Computing</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>Control points</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/lines.py" />
      <location filename="../../panels/move.py" />
      <source>Crease angle</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/lines.py" />
      <source>Cut at turns of</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <source>Drag the yellow points; the surface follows.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <location filename="../../panels/target.py" />
      <source>Drags go</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <source>Exact.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/export.py" />
      <source>Export</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>Feature line</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../objects/line_set.py" />
      <source>Feature lines of {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>Feature lines that bound the region, instead of a distance</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/import_model.py" />
      <source>File</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../api.py" />
      <location filename="../../panels/lines.py" />
      <source>Find feature lines</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../objects/line_set.py" />
      <source>Finding the lines of '{}'</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <source>Following…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>For fewer of them, say how many; laid on the surface, the line lies on it all the same.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/lines.py" />
      <source>Found: {}. Pick one in the list or by a click on it.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>Gaussian sign</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <source>Gives way</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/lines.py" />
      <source>Goes on along</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <location filename="../../panels/region.py" />
      <source>Half-width</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>Hold lines</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>How many control points the line has; few are easier to drag</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/curve_editing.py" />
      <source>How the mouse moves a control point: along the surface, in the plane of the view, or along the surface's normal</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../api.py" />
      <location filename="../../panels/import_model.py" />
      <source>Import styling model</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>Keep lines</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/import_model.py" />
      <source>Largest angle</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/import_model.py" />
      <source>Largest deviation</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>Let go</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>Lets all pinned vertices and protected faces move again</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../objects/line_set.py" />
      <source>Line {}: {:.1f} mm long, crease {:.1f} deg (from {:.1f} to {:.1f})</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../api.py" />
      <location filename="../../commands/load_job.py" />
      <source>Load Tapeline job</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../objects/target.py" />
      <source>Making '{}'</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>Measure</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>Measuring…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/export.py" />
      <source>Meshes (*.obj *.stl *.ply *.off)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <source>Method</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/import_model.py" />
      <source>Models ({})</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../init_gui.py" />
      <source>Move character lines across styled surfaces</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../api.py" />
      <location filename="../../panels/move.py" />
      <source>Move feature line</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../objects/move.py" />
      <source>Move of line {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../objects/move.py" />
      <source>Moving the feature line of '{}'</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/export.py" />
      <source>Name a file for the surface, for the report, or both.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/lines.py" />
      <source>No edge is as sharp as this: lower the crease angle.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/import_model.py" />
      <source>Object</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>Or by a box</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>Or by faces</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>Or by lines</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>Other lines that stay lines where the surface makes room: their vertices slide along them</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>Other lines whose vertices stay where they are</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/export.py" />
      <source>Pages (*.html)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>Pinned: {}, protected: {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <source>Preparing… The preview is coarse until finer triangles are ready.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <source>Preview; the exact surface comes when the mouse rests.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>Puts the control points back</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../objects/model.py" />
      <source>Reading '{}'</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <source>Reading the model…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../api.py" />
      <location filename="../../panels/move.py" />
      <location filename="../../panels/region.py" />
      <source>Region</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../objects/region.py" />
      <source>Region of line {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/export.py" />
      <source>Report page</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/import_model.py" />
      <source>STEP, IGES, BREP, STL, OBJ, PLY or OFF</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/export.py" />
      <source>STL and PLY as text</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../commands/save_job.py" />
      <source>Save Tapeline job</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/lines.py" />
      <source>Shortest line</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>Show</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>Slide to the left (mm)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>Slides the line along the surface, to its left where positive: one distance, or several spread evenly over its length</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>Starts as</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <source>Stop</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <source>Stopped; drag a point or apply to compute again.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <location filename="../../panels/export.py" />
      <source>Surface</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../init_gui.py" />
      <source>Tapeline</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../commands/load_job.py" />
      <location filename="../../commands/save_job.py" />
      <source>Tapeline jobs (*.json)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../api.py" />
      <location filename="../../panels/target.py" />
      <source>Target line</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../objects/target.py" />
      <source>Target of line {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../engine.py" />
      <source>The compiled Python module 'tapeline' cannot be loaded: {}. Build or install it anew.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../engine.py" />
      <source>The compiled Python module 'tapeline' was not found, so nothing can be computed. Build it (scripts/test) or install it (cmake --install), or name its folder in Edit &gt; Preferences &gt; Tapeline.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../objects/base.py" />
      <source>The computation was cancelled; recompute to do it after all.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../curves.py" />
      <source>The edges of '{}' form {} separate curves; a target line is one connected curve: select the edges that belong to it.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/export.py" />
      <source>The ending says the format: .obj, .stl, .ply or .off. OBJ and PLY keep every digit; STL holds single precision when it is binary. Leave a field empty to skip it.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>The feature line's number, or a part of it: 0@10%..85%, or 0@120..900 in mm</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../jobs.py" />
      <source>The job '{}' cannot be written: {}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../jobs.py" />
      <source>The job file '{}' cannot be read: {}.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <source>The line lies</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../objects/line_set.py" />
      <source>The model has no edge as sharp as the crease angle {:g} deg: lower it, or choose another model.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>The number of control points changed, so their moves by hand are gone.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../objects/model.py" />
      <source>There is no file '{}'.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/export.py" />
      <source>There is no folder '{}'.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../models.py" />
      <source>There is no line {}: at these crease angles the model has {} of them, counted from 0.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>This model has no CAD faces; pin vertices instead.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../commands/selection.py" />
      <source>This needs {}; select one, or make one first.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>Tolerance</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <location filename="../../panels/target.py" />
      <source>Undo dragging</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/import_model.py" />
      <source>Unit of mesh files</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>Value</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>What a click in the 3D view does; a second click on the same thing takes it back</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/export.py" />
      <source>Writing the report</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../commands/selection.py" />
      <source>a move (Tapeline &gt; Move feature line)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../commands/selection.py" />
      <source>a region (Tapeline &gt; Region)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../commands/selection.py" />
      <source>a styling model (Tapeline &gt; Import styling model)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../commands/selection.py" />
      <source>a target line (Tapeline &gt; Target line)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>adds a face</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>after the move</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/curve_editing.py" />
      <source>along normal</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/curve_editing.py" />
      <source>along surface</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/base.py" />
      <source>automatic</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>before the move</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>blue (below) to red (above): {:.4g} mm</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>blue to red: -{0:.2g} to {0:.2g} per mm</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>bounds by a line</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/strip.py" />
      <source>bulge</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/strip.py" />
      <source>crease change</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>curve of {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>displacement</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>distance to before</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>e.g. 1, 3</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>e.g. 20 or 0, 30, 60, 30, 0</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>fair, by at most</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../commands/selection.py" />
      <source>feature lines (Tapeline &gt; Find feature lines)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>fitted</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/base.py" />
      <source>free</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>holds a line</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/curve_editing.py" />
      <source>in view plane</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/strip.py" />
      <source>inflections</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>keeps a line</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/base.py" />
      <source>kept</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>lay on the surface</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/base.py" />
      <location filename="../../panels/move.py" />
      <source>left</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/strip.py" />
      <source>line error</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>mean curvature</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/base.py" />
      <source>off the surface</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <source>off the surface ({:.0f} % of the line); both sides bend</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/base.py" />
      <source>on the surface</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <source>on the surface; the {} side gives way ({:.0f} % of the line off it)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>open borders may move</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>pins a vertex</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>plain</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>protects a face</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>red: dome or bowl (both curvatures of one sign), blue: saddle, grey: flat within the reading's precision</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/base.py" />
      <location filename="../../panels/move.py" />
      <source>right</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>sections with curvature combs</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>stored curve</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <source>tint the two sides</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>turns the view</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>up to {:.4g} mm</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../commands/save_job.py" />
      <location filename="../../panels/export.py" />
      <source>wrote {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>x, y, z from; x, y, z to (mm)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>zebra stripes</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../objects/model.py" />
      <source>{} (styling model)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>{} control points, {:.1f} mm long. Drag the yellow points in the 3D view.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>{} vertices and {} triangles may move (green); red triangles touch what stays.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../objects/target.py" />
      <source>{}: the number of control points changed, so their moves by hand are gone.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../objects/model.py" />
      <source>{}: {} vertices, {} triangles, lengths in {}</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>TapelinePreferences</name>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source> (mm)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source> mm</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source> ms</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source> px</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source> °</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source>Bulge of the compressed side</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source>Change of the crease angle</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source>Compiled module</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source>Distance of the line to its target, as 10 to the power</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source>Exact result after the mouse rests for</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source>Folder of the Python module</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source>Limits of the quality strip</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source>New inflections in a section</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source>Preview and display</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source>Scale of curvature combs</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source>Size of control points</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source>Tapeline</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source>The folder that holds the folder tapeline with the compiled module; empty to look where it is built or installed</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source>Time for a preview while dragging</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source>Zebra stripes</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source>amber above</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source>red above</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>Tapeline_Check</name>
    <message>
      <location filename="../../commands/check.py" />
      <source>Check surface…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../commands/check.py" />
      <source>Shows zebra stripes, curvature and the distance to the surface before, sections with curvature combs, and the table of measures</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>Tapeline_Export</name>
    <message>
      <location filename="../../commands/export.py" />
      <source>Export…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../commands/export.py" />
      <source>Writes the moved surface as STL, OBJ, PLY or OFF in full precision, and a page with its measures and pictures</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>Tapeline_FindLines</name>
    <message>
      <location filename="../../commands/find_lines.py" />
      <source>Find feature lines…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../commands/find_lines.py" />
      <source>Finds the sharp lines of the styling model; the crease angle is set with a slider</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>Tapeline_ImportModel</name>
    <message>
      <location filename="../../commands/import_model.py" />
      <source>Import styling model…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../commands/import_model.py" />
      <source>Reads a STEP, IGES, BREP, STL, OBJ, PLY or OFF file, or takes the selected Part or Mesh object, as the model whose lines are moved</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>Tapeline_LoadJob</name>
    <message>
      <location filename="../../commands/load_job.py" />
      <source>Load Tapeline job…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../commands/load_job.py" />
      <source>Makes model, target line, region and move from a job file of the command "tapeline"</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>Tapeline_Move</name>
    <message>
      <location filename="../../commands/move.py" />
      <source>Move feature line…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../commands/move.py" />
      <source>Moves the line to its target and lets the surface follow: drag the control points and watch the surface and its measures, then apply</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>Tapeline_Region</name>
    <message>
      <location filename="../../commands/region.py" />
      <source>Chooses what may follow the line: a band, bounding lines or CAD faces, with vertices and faces that stay where they are</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../commands/region.py" />
      <source>Region…</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>Tapeline_SaveJob</name>
    <message>
      <location filename="../../commands/save_job.py" />
      <source>Save Tapeline job…</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../commands/save_job.py" />
      <source>Writes the move as a job file with its model and target line; the command "tapeline run" makes the same surface from it, to the last bit</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>Tapeline_Target</name>
    <message>
      <location filename="../../commands/target.py" />
      <source>Fits a B-spline to the picked feature line and shapes it: drag its control points, slide it by numbers, fair it, lay it on the surface; or uses the selected curve</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../commands/target.py" />
      <source>Target line…</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>Workbench</name>
    <message>
      <location filename="../../init_gui.py" />
      <source>&amp;Tapeline</source>
      <translation type="unfinished" />
    </message>
    <message>
      <location filename="../../init_gui.py" />
      <source>Tapeline</source>
      <translation type="unfinished" />
    </message>
  </context>
</TS>
