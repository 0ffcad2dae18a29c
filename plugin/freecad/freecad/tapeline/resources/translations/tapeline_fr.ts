<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<TS version="2.1" language="fr">
  <context>
    <name>App::Property</name>
    <message>
      <location filename="../../objects/target.py" />
      <source>Draft, Part or Sketch object whose edges are the target line</source>
      <translation>Objet Draft, Part ou esquisse dont les arêtes sont la ligne cible</translation>
    </message>
    <message>
      <location filename="../../objects/move.py" />
      <source>Largest change of the crease angle along the line</source>
      <translation>Plus grand changement de l'angle de pli le long de la ligne</translation>
    </message>
    <message>
      <location filename="../../objects/move.py" />
      <source>Largest distance of the compressed side to its old surface</source>
      <translation>Plus grande distance du côté comprimé à son ancienne surface</translation>
    </message>
    <message>
      <location filename="../../objects/move.py" />
      <source>Largest distance of the moved line to its target [mm]</source>
      <translation>Plus grande distance de la ligne déplacée à sa cible [mm]</translation>
    </message>
    <message>
      <location filename="../../objects/target.py" />
      <source>Length of the target line</source>
      <translation>Longueur de la ligne cible</translation>
    </message>
    <message>
      <location filename="../../objects/model.py" />
      <source>Length unit found in the file</source>
      <translation>Unité de longueur trouvée dans le fichier</translation>
    </message>
    <message>
      <location filename="../../objects/target.py" />
      <source>Moves of the control points, made by dragging them</source>
      <translation>Déplacements des points de contrôle, faits à la souris</translation>
    </message>
    <message>
      <location filename="../../objects/move.py" />
      <source>New inflections in sections of the compressed side</source>
      <translation>Nouveaux points d'inflexion dans les coupes du côté comprimé</translation>
    </message>
    <message>
      <location filename="../../objects/line_set.py" />
      <source>Number of lines found</source>
      <translation>Nombre de lignes trouvées</translation>
    </message>
    <message>
      <location filename="../../objects/line_set.py" />
      <source>Number, length and crease angle of each line</source>
      <translation>Numéro, longueur et angle de pli de chaque ligne</translation>
    </message>
    <message>
      <location filename="../../objects/model.py" />
      <source>Part or Mesh object that is the model, instead of a file</source>
      <translation>Objet Part ou Mesh qui est le modèle, au lieu d'un fichier</translation>
    </message>
    <message>
      <location filename="../../objects/move.py" />
      <source>Region; without one, the options here count</source>
      <translation>Zone ; sans elle, les options données ici comptent</translation>
    </message>
    <message>
      <location filename="../../objects/line_set.py" />
      <location filename="../../objects/move.py" />
      <location filename="../../objects/target.py" />
      <source>Styling model, or the result of a move</source>
      <translation>Modèle de style, ou résultat d'un déplacement</translation>
    </message>
    <message>
      <location filename="../../objects/move.py" />
      <source>Target line, or any object with a curve</source>
      <translation>Ligne cible, ou tout objet qui a une courbe</translation>
    </message>
    <message>
      <location filename="../../objects/region.py" />
      <source>Target line, which also says model and line</source>
      <translation>Ligne cible, qui désigne aussi le modèle et la ligne</translation>
    </message>
    <message>
      <location filename="../../objects/move.py" />
      <source>The compressed side</source>
      <translation>Le côté comprimé</translation>
    </message>
    <message>
      <location filename="../../objects/model.py" />
      <source>The model's file, a copy of which is kept in the document</source>
      <translation>Le fichier du modèle, dont une copie est gardée dans le document</translation>
    </message>
    <message>
      <location filename="../../objects/target.py" />
      <source>The stored curve as JSON</source>
      <translation>La courbe enregistrée, en JSON</translation>
    </message>
    <message>
      <location filename="../../objects/target.py" />
      <source>The target line as JSON</source>
      <translation>La ligne cible, en JSON</translation>
    </message>
    <message>
      <location filename="../../objects/model.py" />
      <source>Triangles</source>
      <translation>Triangles</translation>
    </message>
    <message>
      <location filename="../../objects/region.py" />
      <source>Triangles in the region</source>
      <translation>Triangles dans la zone</translation>
    </message>
    <message>
      <location filename="../../objects/region.py" />
      <source>Vertices in the region</source>
      <translation>Sommets dans la zone</translation>
    </message>
    <message>
      <location filename="../../objects/model.py" />
      <source>Vertices of the triangles</source>
      <translation>Sommets des triangles</translation>
    </message>
    <message>
      <location filename="../../objects/target.py" />
      <source>What the target line starts from</source>
      <translation>Ce dont part la ligne cible</translation>
    </message>
    <message>
      <location filename="../../objects/model.py" />
      <source>What was found and repaired</source>
      <translation>Ce qui a été trouvé et réparé</translation>
    </message>
    <message>
      <location filename="../../objects/model.py" />
      <source>Where the file came from</source>
      <translation>D'où vient le fichier</translation>
    </message>
    <message>
      <location filename="../../objects/move.py" />
      <source>Whether the line stays on the surface</source>
      <translation>Si la ligne reste sur la surface</translation>
    </message>
    <message>
      <location filename="../../objects/move.py" />
      <location filename="../../objects/target.py" />
      <source>Which line moves: its number, or a part as in 0@10%..85% or 0@120..900 (mm)</source>
      <translation>Quelle ligne se déplace : son numéro, ou une partie comme 0@10%..85% ou 0@120..900 (mm)</translation>
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
      <translation>« {0} » n'a pas de {1} : choisissez un objet pour sa propriété {1}.</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>'{}' are no numbers of CAD faces; write them as in 4, 7.</source>
      <translation>« {} » ne sont pas des numéros de faces CAO ; écrivez-les comme 4, 7.</translation>
    </message>
    <message>
      <location filename="../../api.py" />
      <source>'{}' could not be computed.</source>
      <translation>« {} » n'a pas pu être calculé.</translation>
    </message>
    <message>
      <location filename="../../models.py" />
      <source>'{}' has neither a shape nor a mesh: choose a styling model, a Part or a Mesh object.</source>
      <translation>« {} » n'a ni forme ni maillage : choisissez un modèle de style, un objet Part ou un objet Mesh.</translation>
    </message>
    <message>
      <location filename="../../curves.py" />
      <source>'{}' has no curve that could be a target line.</source>
      <translation>« {} » n'a pas de courbe qui puisse être une ligne cible.</translation>
    </message>
    <message>
      <location filename="../../curves.py" />
      <source>'{}' has no curve yet: recompute it first.</source>
      <translation>« {} » n'a pas encore de courbe : recalculez-le d'abord.</translation>
    </message>
    <message>
      <location filename="../../objects/target.py" />
      <source>'{}' has no curve: choose one for its property LinkedCurve.</source>
      <translation>« {} » n'a pas de courbe : choisissez-en une pour sa propriété LinkedCurve.</translation>
    </message>
    <message>
      <location filename="../../models.py" />
      <source>'{}' has no model file: choose one for its property Source.</source>
      <translation>« {} » n'a pas de fichier de modèle : choisissez-en un pour sa propriété Source.</translation>
    </message>
    <message>
      <location filename="../../objects/line_set.py" />
      <location filename="../../objects/target.py" />
      <source>'{}' has no model: choose one for its property Model.</source>
      <translation>« {} » n'a pas de modèle : choisissez-en un pour sa propriété Model.</translation>
    </message>
    <message>
      <location filename="../../models.py" />
      <source>'{}' has no result yet: recompute it first.</source>
      <translation>« {} » n'a pas encore de résultat : recalculez-le d'abord.</translation>
    </message>
    <message>
      <location filename="../../objects/region.py" />
      <source>'{}' has no target line: choose one for its property Target.</source>
      <translation>« {} » n'a pas de ligne cible : choisissez-en une pour sa propriété Target.</translation>
    </message>
    <message>
      <location filename="../../curves.py" />
      <source>'{}' in the slide law is not a number; write distances in mm such as 0, 30, 0.</source>
      <translation>« {} » dans la loi de glissement n'est pas un nombre ; écrivez des distances en mm comme 0, 30, 0.</translation>
    </message>
    <message>
      <location filename="../../jobs.py" />
      <source>'{}' is no Tapeline job: it names no input.</source>
      <translation>« {} » n'est pas une tâche Tapeline : elle ne nomme aucune entrée (input).</translation>
    </message>
    <message>
      <location filename="../../api.py" />
      <source>'{}' is no move: only moves are exported.</source>
      <translation>« {} » n'est pas un déplacement : seuls les déplacements sont exportés.</translation>
    </message>
    <message>
      <location filename="../../objects/move.py" />
      <source>'{}' is no target line of a model: name the model and the line.</source>
      <translation>« {} » n'est pas une ligne cible d'un modèle : nommez le modèle et la ligne.</translation>
    </message>
    <message>
      <location filename="../../models.py" />
      <source>'{}' names no line and is no file of vertex indices: {}.</source>
      <translation>« {} » ne désigne pas de ligne et n'est pas un fichier de numéros de sommets : {}.</translation>
    </message>
    <message>
      <location filename="../../models.py" />
      <source>'{}' names no line: write 0, 0@10%..85% or 0@120..900.</source>
      <translation>« {} » ne désigne pas de ligne : écrivez 0, 0@10%..85% ou 0@120..900.</translation>
    </message>
    <message>
      <location filename="../../jobs.py" />
      <source>'{}': '{}' is no section of a job.</source>
      <translation>« {} » : « {} » n'est pas une section d'une tâche.</translation>
    </message>
    <message>
      <location filename="../../jobs.py" />
      <source>'{}': there is no option '{}.{}'.</source>
      <translation>« {} » : il n'y a pas d'option « {}.{} ».</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>A box along the axes that holds the region, instead of a distance: smallest x, y, z, then largest x, y, z in mm</source>
      <translation>Une boîte le long des axes qui contient la zone, au lieu d'une distance : plus petits x, y, z, puis plus grands x, y, z en mm</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>A click</source>
      <translation>Un clic</translation>
    </message>
    <message>
      <location filename="../../objects/target.py" />
      <source>A target line has no option '{}'.</source>
      <translation>Une ligne cible n'a pas d'option « {} ».</translation>
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <source>Blue is stretched, orange gives way</source>
      <translation>Le bleu est étiré, l'orange cède</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>CAD faces that make up the region, instead of a distance</source>
      <translation>Faces CAO qui forment la zone, au lieu d'une distance</translation>
    </message>
    <message>
      <location filename="../../panels/import_model.py" />
      <source>CAD files carry their own unit; lengths are mm in the document. The deviation and the angle say how fine a CAD model is divided into triangles.</source>
      <translation>Les fichiers CAO portent leur propre unité ; les longueurs sont en mm dans le document. L'écart et l'angle disent avec quelle finesse un modèle CAO est divisé en triangles.</translation>
    </message>
    <message>
      <location filename="../../worker.py" />
      <source>Cancel</source>
      <translation>Annuler</translation>
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>Check surface</source>
      <translation>Contrôler la surface</translation>
    </message>
    <message>
      <location filename="../../panels/export.py" />
      <location filename="../../panels/import_model.py" />
      <source>Choose a file</source>
      <translation>Choisir un fichier</translation>
    </message>
    <message>
      <location filename="../../panels/import_model.py" />
      <source>Choose a model file first.</source>
      <translation>Choisissez d'abord un fichier de modèle.</translation>
    </message>
    <message>
      <location filename="../../objects/region.py" />
      <source>Choosing '{}'</source>
      <translation>Choix de « {} »</translation>
    </message>
    <message>
      <location filename="../../panels/import_model.py" />
      <source>Close gaps up to</source>
      <translation>Fermer jusqu'à</translation>
    </message>
    <message>
      <location filename="../../worker.py" />
      <source>Computing</source>
      <translation>Calcul</translation>
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>Control points</source>
      <translation>Points de contrôle</translation>
    </message>
    <message>
      <location filename="../../panels/lines.py" />
      <location filename="../../panels/move.py" />
      <source>Crease angle</source>
      <translation>Angle de pli</translation>
    </message>
    <message>
      <location filename="../../panels/lines.py" />
      <source>Cut at turns of</source>
      <translation>Couper au virage</translation>
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <source>Drag the yellow points; the surface follows.</source>
      <translation>Tirez les points jaunes ; la surface suit.</translation>
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <location filename="../../panels/target.py" />
      <source>Drags go</source>
      <translation>La souris va</translation>
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <source>Exact.</source>
      <translation>Exact.</translation>
    </message>
    <message>
      <location filename="../../panels/export.py" />
      <source>Export</source>
      <translation>Exporter</translation>
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>Feature line</source>
      <translation>Ligne</translation>
    </message>
    <message>
      <location filename="../../objects/line_set.py" />
      <source>Feature lines of {}</source>
      <translation>Lignes de caractère de {}</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>Feature lines that bound the region, instead of a distance</source>
      <translation>Lignes de caractère qui bordent la zone, au lieu d'une distance</translation>
    </message>
    <message>
      <location filename="../../panels/import_model.py" />
      <source>File</source>
      <translation>Fichier</translation>
    </message>
    <message>
      <location filename="../../api.py" />
      <location filename="../../panels/lines.py" />
      <source>Find feature lines</source>
      <translation>Trouver les lignes de caractère</translation>
    </message>
    <message>
      <location filename="../../objects/line_set.py" />
      <source>Finding the lines of '{}'</source>
      <translation>Recherche des lignes de « {} »</translation>
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <source>Following…</source>
      <translation>Suit…</translation>
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>For fewer of them, say how many; laid on the surface, the line lies on it all the same.</source>
      <translation>Pour en avoir moins, dites combien ; posée sur la surface, la ligne y reste tout de même.</translation>
    </message>
    <message>
      <location filename="../../panels/lines.py" />
      <source>Found: {}. Pick one in the list or by a click on it.</source>
      <translation>Trouvées : {}. Choisissez-en une dans la liste ou d'un clic sur elle.</translation>
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>Gaussian sign</source>
      <translation>signe de Gauss</translation>
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <source>Gives way</source>
      <translation>Cède</translation>
    </message>
    <message>
      <location filename="../../panels/lines.py" />
      <source>Goes on along</source>
      <translation>Continue dès</translation>
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <location filename="../../panels/region.py" />
      <source>Half-width</source>
      <translation>Demi-largeur</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>Hold lines</source>
      <translation>Tenir</translation>
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>How many control points the line has; few are easier to drag</source>
      <translation>Combien de points de contrôle a la ligne ; peu se tirent plus facilement</translation>
    </message>
    <message>
      <location filename="../../panels/curve_editing.py" />
      <source>How the mouse moves a control point: along the surface, in the plane of the view, or along the surface's normal</source>
      <translation>Comment la souris bouge un point de contrôle : le long de la surface, dans le plan de la vue, ou le long de la normale</translation>
    </message>
    <message>
      <location filename="../../api.py" />
      <location filename="../../panels/import_model.py" />
      <source>Import styling model</source>
      <translation>Importer un modèle de style</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>Keep lines</source>
      <translation>Garder</translation>
    </message>
    <message>
      <location filename="../../panels/import_model.py" />
      <source>Largest angle</source>
      <translation>Angle maximal</translation>
    </message>
    <message>
      <location filename="../../panels/import_model.py" />
      <source>Largest deviation</source>
      <translation>Écart maximal</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>Let go</source>
      <translation>Libérer</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>Lets all pinned vertices and protected faces move again</source>
      <translation>Laisse de nouveau bouger tous les sommets fixés et toutes les faces protégées</translation>
    </message>
    <message>
      <location filename="../../objects/line_set.py" />
      <source>Line {}: {:.1f} mm long, crease {:.1f} deg (from {:.1f} to {:.1f})</source>
      <translation>Ligne {} : {:.1f} mm de long, pli {:.1f} deg (de {:.1f} à {:.1f})</translation>
    </message>
    <message>
      <location filename="../../api.py" />
      <location filename="../../commands/load_job.py" />
      <source>Load Tapeline job</source>
      <translation>Charger une tâche Tapeline</translation>
    </message>
    <message>
      <location filename="../../objects/target.py" />
      <source>Making '{}'</source>
      <translation>Création de « {} »</translation>
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>Measure</source>
      <translation>Mesure</translation>
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>Measuring…</source>
      <translation>Mesure…</translation>
    </message>
    <message>
      <location filename="../../panels/export.py" />
      <source>Meshes (*.obj *.stl *.ply *.off)</source>
      <translation>Maillages (*.obj *.stl *.ply *.off)</translation>
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <source>Method</source>
      <translation>Méthode</translation>
    </message>
    <message>
      <location filename="../../panels/import_model.py" />
      <source>Models ({})</source>
      <translation>Modèles ({})</translation>
    </message>
    <message>
      <location filename="../../init_gui.py" />
      <source>Move character lines across styled surfaces</source>
      <translation>Déplacer les lignes de caractère sur des surfaces de style</translation>
    </message>
    <message>
      <location filename="../../api.py" />
      <location filename="../../panels/move.py" />
      <source>Move feature line</source>
      <translation>Déplacer la ligne de caractère</translation>
    </message>
    <message>
      <location filename="../../objects/move.py" />
      <source>Move of line {}</source>
      <translation>Déplacement de la ligne {}</translation>
    </message>
    <message>
      <location filename="../../objects/move.py" />
      <source>Moving the feature line of '{}'</source>
      <translation>Déplacement de la ligne de « {} »</translation>
    </message>
    <message>
      <location filename="../../panels/export.py" />
      <source>Name a file for the surface, for the report, or both.</source>
      <translation>Nommez un fichier pour la surface, pour le rapport, ou pour les deux.</translation>
    </message>
    <message>
      <location filename="../../panels/lines.py" />
      <source>No edge is as sharp as this: lower the crease angle.</source>
      <translation>Aucune arête n'est aussi vive : réduisez l'angle de pli.</translation>
    </message>
    <message>
      <location filename="../../panels/import_model.py" />
      <source>Object</source>
      <translation>Objet</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>Or by a box</source>
      <translation>Ou par boîte</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>Or by faces</source>
      <translation>Ou par faces</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>Or by lines</source>
      <translation>Ou par lignes</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>Other lines that stay lines where the surface makes room: their vertices slide along them</source>
      <translation>Autres lignes qui restent des lignes là où la surface fait place : leurs sommets glissent sur elles</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>Other lines whose vertices stay where they are</source>
      <translation>Autres lignes dont les sommets restent où ils sont</translation>
    </message>
    <message>
      <location filename="../../panels/export.py" />
      <source>Pages (*.html)</source>
      <translation>Pages (*.html)</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>Pinned: {}, protected: {}</source>
      <translation>Fixés : {}, protégées : {}</translation>
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <source>Preparing… The preview is coarse until finer triangles are ready.</source>
      <translation>Préparation… L'aperçu est grossier jusqu'à ce que des triangles plus fins soient prêts.</translation>
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <source>Preview; the exact surface comes when the mouse rests.</source>
      <translation>Aperçu ; la surface exacte vient quand la souris se repose.</translation>
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>Puts the control points back</source>
      <translation>Remet les points de contrôle en place</translation>
    </message>
    <message>
      <location filename="../../objects/model.py" />
      <source>Reading '{}'</source>
      <translation>Lecture de « {} »</translation>
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <source>Reading the model…</source>
      <translation>Lecture du modèle…</translation>
    </message>
    <message>
      <location filename="../../api.py" />
      <location filename="../../panels/move.py" />
      <location filename="../../panels/region.py" />
      <source>Region</source>
      <translation>Zone</translation>
    </message>
    <message>
      <location filename="../../objects/region.py" />
      <source>Region of line {}</source>
      <translation>Zone de la ligne {}</translation>
    </message>
    <message>
      <location filename="../../panels/export.py" />
      <source>Report page</source>
      <translation>Rapport</translation>
    </message>
    <message>
      <location filename="../../panels/import_model.py" />
      <source>STEP, IGES, BREP, STL, OBJ, PLY or OFF</source>
      <translation>STEP, IGES, BREP, STL, OBJ, PLY ou OFF</translation>
    </message>
    <message>
      <location filename="../../panels/export.py" />
      <source>STL and PLY as text</source>
      <translation>STL et PLY en texte</translation>
    </message>
    <message>
      <location filename="../../commands/save_job.py" />
      <source>Save Tapeline job</source>
      <translation>Enregistrer la tâche Tapeline</translation>
    </message>
    <message>
      <location filename="../../panels/lines.py" />
      <source>Shortest line</source>
      <translation>Ligne minimale</translation>
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>Show</source>
      <translation>Montrer</translation>
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>Slide to the left (mm)</source>
      <translation>Glisser vers la gauche (mm)</translation>
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>Slides the line along the surface, to its left where positive: one distance, or several spread evenly over its length</source>
      <translation>Fait glisser la ligne le long de la surface, vers sa gauche si positif : une distance, ou plusieurs réparties sur sa longueur</translation>
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>Starts as</source>
      <translation>Part de</translation>
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <source>Stop</source>
      <translation>Arrêter</translation>
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <source>Stopped; drag a point or apply to compute again.</source>
      <translation>Arrêté ; tirez un point ou appliquez pour recalculer.</translation>
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <location filename="../../panels/export.py" />
      <source>Surface</source>
      <translation>Surface</translation>
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
      <translation>Tâches Tapeline (*.json)</translation>
    </message>
    <message>
      <location filename="../../api.py" />
      <location filename="../../panels/target.py" />
      <source>Target line</source>
      <translation>Ligne cible</translation>
    </message>
    <message>
      <location filename="../../objects/target.py" />
      <source>Target of line {}</source>
      <translation>Cible de la ligne {}</translation>
    </message>
    <message>
      <location filename="../../engine.py" />
      <source>The compiled Python module 'tapeline' cannot be loaded: {}. Build or install it anew.</source>
      <translation>Le module Python compilé « tapeline » ne se charge pas : {}. Compilez-le ou installez-le de nouveau.</translation>
    </message>
    <message>
      <location filename="../../engine.py" />
      <source>The compiled Python module 'tapeline' was not found, so nothing can be computed. Build it (scripts/test) or install it (cmake --install), or name its folder in Edit &gt; Preferences &gt; Tapeline.</source>
      <translation>Le module Python compilé « tapeline » est introuvable, rien ne peut donc être calculé. Compilez-le (scripts/test), installez-le (cmake --install), ou nommez son dossier dans Édition &gt; Préférences &gt; Tapeline.</translation>
    </message>
    <message>
      <location filename="../../objects/base.py" />
      <source>The computation was cancelled; recompute to do it after all.</source>
      <translation>Le calcul a été annulé ; recalculez pour le faire tout de même.</translation>
    </message>
    <message>
      <location filename="../../curves.py" />
      <source>The edges of '{}' form {} separate curves; a target line is one connected curve: select the edges that belong to it.</source>
      <translation>Les arêtes de « {} » forment {} courbes séparées ; une ligne cible est une seule courbe continue : choisissez les arêtes qui en font partie.</translation>
    </message>
    <message>
      <location filename="../../panels/export.py" />
      <source>The ending says the format: .obj, .stl, .ply or .off. OBJ and PLY keep every digit; STL holds single precision when it is binary. Leave a field empty to skip it.</source>
      <translation>L'extension dit le format : .obj, .stl, .ply ou .off. OBJ et PLY gardent chaque chiffre ; un STL binaire est en simple précision. Un champ vide est ignoré.</translation>
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>The feature line's number, or a part of it: 0@10%..85%, or 0@120..900 in mm</source>
      <translation>Le numéro de la ligne de caractère, ou une partie : 0@10%..85%, ou 0@120..900 en mm</translation>
    </message>
    <message>
      <location filename="../../jobs.py" />
      <source>The job '{}' cannot be written: {}.</source>
      <translation>La tâche « {} » ne peut pas être écrite : {}.</translation>
    </message>
    <message>
      <location filename="../../jobs.py" />
      <source>The job file '{}' cannot be read: {}.</source>
      <translation>Le fichier de tâche « {} » ne peut pas être lu : {}.</translation>
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <source>The line lies</source>
      <translation>La ligne est</translation>
    </message>
    <message>
      <location filename="../../objects/line_set.py" />
      <source>The model has no edge as sharp as the crease angle {:g} deg: lower it, or choose another model.</source>
      <translation>Le modèle n'a pas d'arête aussi vive que l'angle de pli {:g} deg : réduisez-le, ou choisissez un autre modèle.</translation>
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>The number of control points changed, so their moves by hand are gone.</source>
      <translation>Le nombre de points de contrôle a changé, leurs déplacements à la main sont donc perdus.</translation>
    </message>
    <message>
      <location filename="../../objects/model.py" />
      <source>There is no file '{}'.</source>
      <translation>Il n'y a pas de fichier « {} ».</translation>
    </message>
    <message>
      <location filename="../../panels/export.py" />
      <source>There is no folder '{}'.</source>
      <translation>Il n'y a pas de dossier « {} ».</translation>
    </message>
    <message>
      <location filename="../../models.py" />
      <source>There is no line {}: at these crease angles the model has {} of them, counted from 0.</source>
      <translation>Il n'y a pas de ligne {} : à ces angles de pli, le modèle en a {}, comptées à partir de 0.</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>This model has no CAD faces; pin vertices instead.</source>
      <translation>Ce modèle n'a pas de faces CAO ; fixez plutôt des sommets.</translation>
    </message>
    <message>
      <location filename="../../commands/selection.py" />
      <source>This needs {}; select one, or make one first.</source>
      <translation>Il faut {} ; sélectionnez-en, ou créez-en d'abord.</translation>
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>Tolerance</source>
      <translation>Tolérance</translation>
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <location filename="../../panels/target.py" />
      <source>Undo dragging</source>
      <translation>Annuler le tirage</translation>
    </message>
    <message>
      <location filename="../../panels/import_model.py" />
      <source>Unit of mesh files</source>
      <translation>Unité des maillages</translation>
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>Value</source>
      <translation>Valeur</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>What a click in the 3D view does; a second click on the same thing takes it back</source>
      <translation>Ce que fait un clic dans la vue 3D ; un second clic au même endroit l'annule</translation>
    </message>
    <message>
      <location filename="../../panels/export.py" />
      <source>Writing the report</source>
      <translation>Écriture du rapport</translation>
    </message>
    <message>
      <location filename="../../commands/selection.py" />
      <source>a move (Tapeline &gt; Move feature line)</source>
      <translation>un déplacement (Tapeline &gt; Déplacer la ligne de caractère)</translation>
    </message>
    <message>
      <location filename="../../commands/selection.py" />
      <source>a region (Tapeline &gt; Region)</source>
      <translation>une zone (Tapeline &gt; Zone)</translation>
    </message>
    <message>
      <location filename="../../commands/selection.py" />
      <source>a styling model (Tapeline &gt; Import styling model)</source>
      <translation>un modèle de style (Tapeline &gt; Importer un modèle de style)</translation>
    </message>
    <message>
      <location filename="../../commands/selection.py" />
      <source>a target line (Tapeline &gt; Target line)</source>
      <translation>une ligne cible (Tapeline &gt; Ligne cible)</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>adds a face</source>
      <translation>ajoute une face</translation>
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>after the move</source>
      <translation>après le déplacement</translation>
    </message>
    <message>
      <location filename="../../panels/curve_editing.py" />
      <source>along normal</source>
      <translation>selon normale</translation>
    </message>
    <message>
      <location filename="../../panels/curve_editing.py" />
      <source>along surface</source>
      <translation>sur la surface</translation>
    </message>
    <message>
      <location filename="../../panels/base.py" />
      <source>automatic</source>
      <translation>automatique</translation>
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>before the move</source>
      <translation>avant le déplacement</translation>
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>blue (below) to red (above): {:.4g} mm</source>
      <translation>bleu (dessous) à rouge (dessus) : {:.4g} mm</translation>
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>blue to red: -{0:.2g} to {0:.2g} per mm</source>
      <translation>bleu à rouge : -{0:.2g} à {0:.2g} par mm</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>bounds by a line</source>
      <translation>borne à une ligne</translation>
    </message>
    <message>
      <location filename="../../panels/strip.py" />
      <source>bulge</source>
      <translation>bosse</translation>
    </message>
    <message>
      <location filename="../../panels/strip.py" />
      <source>crease change</source>
      <translation>écart du pli</translation>
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>curve of {}</source>
      <translation>courbe de {}</translation>
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>displacement</source>
      <translation>déplacement</translation>
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>distance to before</source>
      <translation>écart à l'ancienne</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>e.g. 1, 3</source>
      <translation>p. ex. 1, 3</translation>
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>e.g. 20 or 0, 30, 60, 30, 0</source>
      <translation>p. ex. 20 ou 0, 30, 60, 30, 0</translation>
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>fair, by at most</source>
      <translation>lisser, max.</translation>
    </message>
    <message>
      <location filename="../../commands/selection.py" />
      <source>feature lines (Tapeline &gt; Find feature lines)</source>
      <translation>des lignes de caractère (Tapeline &gt; Trouver les lignes de caractère)</translation>
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>fitted</source>
      <translation>ajustée</translation>
    </message>
    <message>
      <location filename="../../panels/base.py" />
      <source>free</source>
      <translation>libre</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>holds a line</source>
      <translation>tient une ligne</translation>
    </message>
    <message>
      <location filename="../../panels/curve_editing.py" />
      <source>in view plane</source>
      <translation>plan de vue</translation>
    </message>
    <message>
      <location filename="../../panels/strip.py" />
      <source>inflections</source>
      <translation>inflexions</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>keeps a line</source>
      <translation>garde une ligne</translation>
    </message>
    <message>
      <location filename="../../panels/base.py" />
      <source>kept</source>
      <translation>gardé</translation>
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>lay on the surface</source>
      <translation>poser sur la surface</translation>
    </message>
    <message>
      <location filename="../../panels/base.py" />
      <location filename="../../panels/move.py" />
      <source>left</source>
      <translation>gauche</translation>
    </message>
    <message>
      <location filename="../../panels/strip.py" />
      <source>line error</source>
      <translation>erreur de ligne</translation>
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>mean curvature</source>
      <translation>courbure moyenne</translation>
    </message>
    <message>
      <location filename="../../panels/base.py" />
      <source>off the surface</source>
      <translation>hors surface</translation>
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <source>off the surface ({:.0f} % of the line); both sides bend</source>
      <translation>hors de la surface ({:.0f} % de la ligne) ; les deux côtés plient</translation>
    </message>
    <message>
      <location filename="../../panels/base.py" />
      <source>on the surface</source>
      <translation>sur la surface</translation>
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <source>on the surface; the {} side gives way ({:.0f} % of the line off it)</source>
      <translation>sur la surface ; le côté à {} cède ({:.0f} % de la ligne en est hors)</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>open borders may move</source>
      <translation>bords ouverts libres</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>pins a vertex</source>
      <translation>fixe un sommet</translation>
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>plain</source>
      <translation>simple</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>protects a face</source>
      <translation>protège une face</translation>
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>red: dome or bowl (both curvatures of one sign), blue: saddle, grey: flat within the reading's precision</source>
      <translation>rouge : bosse ou creux (deux courbures de même signe), bleu : selle, gris : plat dans la précision de la mesure</translation>
    </message>
    <message>
      <location filename="../../panels/base.py" />
      <location filename="../../panels/move.py" />
      <source>right</source>
      <translation>droite</translation>
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>sections with curvature combs</source>
      <translation>coupes avec peignes</translation>
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>stored curve</source>
      <translation>courbe enregistrée</translation>
    </message>
    <message>
      <location filename="../../panels/move.py" />
      <source>tint the two sides</source>
      <translation>teinter les deux côtés</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>turns the view</source>
      <translation>tourne la vue</translation>
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>up to {:.4g} mm</source>
      <translation>jusqu'à {:.4g} mm</translation>
    </message>
    <message>
      <location filename="../../commands/save_job.py" />
      <location filename="../../panels/export.py" />
      <source>wrote {}</source>
      <translation>{} écrit</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>x, y, z from; x, y, z to (mm)</source>
      <translation>x, y, z de ; x, y, z à (mm)</translation>
    </message>
    <message>
      <location filename="../../panels/check.py" />
      <source>zebra stripes</source>
      <translation>rayures zébrées</translation>
    </message>
    <message>
      <location filename="../../objects/model.py" />
      <source>{} (styling model)</source>
      <translation>{} (modèle de style)</translation>
    </message>
    <message>
      <location filename="../../panels/target.py" />
      <source>{} control points, {:.1f} mm long. Drag the yellow points in the 3D view.</source>
      <translation>{} points de contrôle, {:.1f} mm de long. Tirez les points jaunes dans la vue 3D.</translation>
    </message>
    <message>
      <location filename="../../panels/region.py" />
      <source>{} vertices and {} triangles may move (green); red triangles touch what stays.</source>
      <translation>{} sommets et {} triangles peuvent bouger (vert) ; les triangles rouges touchent ce qui reste.</translation>
    </message>
    <message>
      <location filename="../../objects/target.py" />
      <source>{}: the number of control points changed, so their moves by hand are gone.</source>
      <translation>{} : le nombre de points de contrôle a changé, leurs déplacements à la main sont donc perdus.</translation>
    </message>
    <message>
      <location filename="../../objects/model.py" />
      <source>{}: {} vertices, {} triangles, lengths in {}</source>
      <translation>{} : {} sommets, {} triangles, longueurs en {}</translation>
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
      <translation>Bosse du côté comprimé</translation>
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source>Change of the crease angle</source>
      <translation>Changement de l'angle de pli</translation>
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source>Compiled module</source>
      <translation>Module compilé</translation>
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source>Distance of the line to its target, as 10 to the power</source>
      <translation>Distance de la ligne à sa cible, en puissance de 10</translation>
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source>Exact result after the mouse rests for</source>
      <translation>Résultat exact après un repos de la souris de</translation>
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source>Folder of the Python module</source>
      <translation>Dossier du module Python</translation>
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source>Limits of the quality strip</source>
      <translation>Limites de l'indicateur de qualité</translation>
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source>New inflections in a section</source>
      <translation>Nouvelles inflexions dans une coupe</translation>
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source>Preview and display</source>
      <translation>Aperçu et affichage</translation>
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source>Scale of curvature combs</source>
      <translation>Échelle des peignes de courbure</translation>
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source>Size of control points</source>
      <translation>Taille des points de contrôle</translation>
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source>Tapeline</source>
      <translation>Tapeline</translation>
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source>The folder that holds the folder tapeline with the compiled module; empty to look where it is built or installed</source>
      <translation>Le dossier qui contient le dossier tapeline avec le module compilé ; vide pour le chercher où il est compilé ou installé</translation>
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source>Time for a preview while dragging</source>
      <translation>Temps pour un aperçu pendant le tirage</translation>
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source>Zebra stripes</source>
      <translation>Rayures zébrées</translation>
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source>amber above</source>
      <translation>orange au-dessus de</translation>
    </message>
    <message>
      <location filename="../../resources/ui/preferences.ui" />
      <source>red above</source>
      <translation>rouge au-dessus de</translation>
    </message>
  </context>
  <context>
    <name>Tapeline_Check</name>
    <message>
      <location filename="../../commands/check.py" />
      <source>Check surface…</source>
      <translation>Contrôler la surface…</translation>
    </message>
    <message>
      <location filename="../../commands/check.py" />
      <source>Shows zebra stripes, curvature and the distance to the surface before, sections with curvature combs, and the table of measures</source>
      <translation>Montre les rayures zébrées, la courbure et la distance à la surface d'avant, des coupes avec peignes de courbure et le tableau des mesures</translation>
    </message>
  </context>
  <context>
    <name>Tapeline_Export</name>
    <message>
      <location filename="../../commands/export.py" />
      <source>Export…</source>
      <translation>Exporter…</translation>
    </message>
    <message>
      <location filename="../../commands/export.py" />
      <source>Writes the moved surface as STL, OBJ, PLY or OFF in full precision, and a page with its measures and pictures</source>
      <translation>Écrit la surface déplacée en STL, OBJ, PLY ou OFF en pleine précision, et une page avec ses mesures et ses images</translation>
    </message>
  </context>
  <context>
    <name>Tapeline_FindLines</name>
    <message>
      <location filename="../../commands/find_lines.py" />
      <source>Find feature lines…</source>
      <translation>Trouver les lignes de caractère…</translation>
    </message>
    <message>
      <location filename="../../commands/find_lines.py" />
      <source>Finds the sharp lines of the styling model; the crease angle is set with a slider</source>
      <translation>Trouve les lignes vives du modèle de style ; l'angle de pli se règle avec un curseur</translation>
    </message>
  </context>
  <context>
    <name>Tapeline_ImportModel</name>
    <message>
      <location filename="../../commands/import_model.py" />
      <source>Import styling model…</source>
      <translation>Importer un modèle de style…</translation>
    </message>
    <message>
      <location filename="../../commands/import_model.py" />
      <source>Reads a STEP, IGES, BREP, STL, OBJ, PLY or OFF file, or takes the selected Part or Mesh object, as the model whose lines are moved</source>
      <translation>Lit un fichier STEP, IGES, BREP, STL, OBJ, PLY ou OFF, ou prend l'objet Part ou Mesh sélectionné, comme modèle dont les lignes sont déplacées</translation>
    </message>
  </context>
  <context>
    <name>Tapeline_LoadJob</name>
    <message>
      <location filename="../../commands/load_job.py" />
      <source>Load Tapeline job…</source>
      <translation>Charger une tâche Tapeline…</translation>
    </message>
    <message>
      <location filename="../../commands/load_job.py" />
      <source>Makes model, target line, region and move from a job file of the command "tapeline"</source>
      <translation>Crée modèle, ligne cible, zone et déplacement à partir d'un fichier de tâche de la commande « tapeline »</translation>
    </message>
  </context>
  <context>
    <name>Tapeline_Move</name>
    <message>
      <location filename="../../commands/move.py" />
      <source>Move feature line…</source>
      <translation>Déplacer la ligne de caractère…</translation>
    </message>
    <message>
      <location filename="../../commands/move.py" />
      <source>Moves the line to its target and lets the surface follow: drag the control points and watch the surface and its measures, then apply</source>
      <translation>Déplace la ligne vers sa cible et laisse suivre la surface : tirez les points de contrôle, observez la surface et ses mesures, puis appliquez</translation>
    </message>
  </context>
  <context>
    <name>Tapeline_Region</name>
    <message>
      <location filename="../../commands/region.py" />
      <source>Chooses what may follow the line: a band, bounding lines or CAD faces, with vertices and faces that stay where they are</source>
      <translation>Choisit ce qui peut suivre la ligne : une bande, des lignes ou des faces CAO qui la bornent, avec des sommets et des faces qui restent où ils sont</translation>
    </message>
    <message>
      <location filename="../../commands/region.py" />
      <source>Region…</source>
      <translation>Zone…</translation>
    </message>
  </context>
  <context>
    <name>Tapeline_SaveJob</name>
    <message>
      <location filename="../../commands/save_job.py" />
      <source>Save Tapeline job…</source>
      <translation>Enregistrer la tâche Tapeline…</translation>
    </message>
    <message>
      <location filename="../../commands/save_job.py" />
      <source>Writes the move as a job file with its model and target line; the command "tapeline run" makes the same surface from it, to the last bit</source>
      <translation>Écrit le déplacement en fichier de tâche avec son modèle et sa ligne cible ; la commande « tapeline run » en refait la même surface, au dernier bit près</translation>
    </message>
  </context>
  <context>
    <name>Tapeline_Target</name>
    <message>
      <location filename="../../commands/target.py" />
      <source>Fits a B-spline to the picked feature line and shapes it: drag its control points, slide it by numbers, fair it, lay it on the surface; or uses the selected curve</source>
      <translation>Ajuste une B-spline à la ligne choisie et la forme : tirer ses points de contrôle, la faire glisser, la lisser, la poser sur la surface ; ou prend la courbe sélectionnée</translation>
    </message>
    <message>
      <location filename="../../commands/target.py" />
      <source>Target line…</source>
      <translation>Ligne cible…</translation>
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
