# SPDX-License-Identifier: GPL-3.0-or-later
"""The document objects, without a window."""
import re
import unittest

import FreeCAD as App
import numpy as np
import Part
from common import HOOD, PANEL, SLIDE, SOURCE, InADocument, run_command

from freecad.tapeline import api, arrays, engine, models, properties


class Addon(unittest.TestCase):
    def test_freecad_reads_the_addons_description(self):
        addon = App.Metadata(str(SOURCE / "package.xml"))
        self.assertEqual((addon.Name, addon.Version), ("Tapeline", engine.module().version()))
        self.assertEqual([person["name"] for person in addon.Maintainer], ["The Tapeline maintainers"])
        workbench, = addon.Content["workbench"]
        self.assertTrue((SOURCE / workbench.Subdirectory / "freecad" / "tapeline" / "init_gui.py").exists())
        self.assertTrue((SOURCE / workbench.Subdirectory / workbench.Icon).exists())


class Objects(InADocument):
    def test_a_step_file_becomes_a_model_with_its_lines_and_lengths(self):
        model = api.import_model(HOOD, self.document)
        self.assertEqual(model.SourceUnit, "mm")
        self.assertEqual(model.Mesh.CountFacets, model.TriangleCount)
        lines = api.find_lines(model)
        self.assertEqual(lines.Count, 1)
        self.assertAlmostEqual(lines.Shape.Edges[0].Length, 889.144, delta=0.01)

    def test_options_become_properties_with_units_choices_and_defaults(self):
        model = api.import_model(PANEL, self.document)
        move = api.create_move(self.document, api.target_line(model))
        for option in properties.table(["lines", "remesh", "region", "move"]):
            name = properties.property_name(option["name"])
            with self.subTest(option["name"]):
                self.assertIn(name, move.PropertiesList)
                self.assertTrue(move.getDocumentationOfProperty(name).startswith(option["help"]))
                self.assertEqual(properties.value_of(move, option), option["default"])
                if option["choices"] and option["type"] == "str":
                    self.assertEqual(move.getEnumerationsOfProperty(name), option["choices"])
        self.assertEqual(str(move.CreaseAngle.Unit), str(App.Units.Unit("deg")))
        self.assertEqual(str(move.RoiDistance.Unit), str(App.Units.Unit("mm")))

    def test_every_option_of_the_command_move_is_a_property_of_model_target_or_move(self):
        target = api.target_line(api.import_model(PANEL, self.document))
        move = api.create_move(self.document, target)
        there = set(target.Model.PropertiesList) | set(target.PropertiesList) | set(move.PropertiesList)
        text = run_command("move", "--help").stdout.partition("What is written")[0]
        flags = [flag.replace("-", "_") for flag in re.findall(r"^  --([a-z-]+)", text, re.MULTILINE)]
        self.assertGreater(len(flags), 40)
        said_by_hand = {"edit"}  # control points are dragged: the target's Offsets
        self.assertEqual([flag for flag in flags if properties.property_name(flag) not in there], sorted(said_by_hand))

    def test_a_move_puts_its_line_on_the_target_in_doubles(self):
        model = api.import_model(PANEL, self.document)
        target = api.target_line(model, slide=SLIDE)
        move = api.move(target)
        self.assertEqual(move.Verdict, "on_surface")
        self.assertLess(move.MeasuredLineError, 1e-9)
        vertices = arrays.rows(move, "Vertices")
        self.assertGreater(np.abs(vertices - vertices.astype(np.float32)).max(), 0)
        self.assertEqual(move.Mesh.CountFacets, len(move.Triangles) // 3)

    def test_the_result_is_computed_again_only_when_something_changed(self):
        model = api.import_model(PANEL, self.document)
        target = api.target_line(model, slide=SLIDE)
        move = api.move(target)
        before = arrays.digest(arrays.rows(move, "Vertices"))
        move.touch()
        self.document.recompute()
        self.assertEqual(arrays.digest(arrays.rows(move, "Vertices")), before)
        target.Slide = [0, 30, 0]
        self.document.recompute()
        changed = arrays.digest(arrays.rows(move, "Vertices"))
        self.assertNotEqual(changed, before)
        move.Method = "arap"
        self.document.recompute()
        self.assertNotEqual(arrays.digest(arrays.rows(move, "Vertices")), changed)

    def test_a_document_opens_again_with_the_same_doubles_and_goes_on(self):
        model = api.import_model(PANEL, self.document)
        move = api.move(api.target_line(model, slide=SLIDE))
        name, inputs = move.Name, move.Inputs
        vertices, triangles = arrays.rows(move, "Vertices"), list(move.Triangles)
        path = self.folder / "saved.FCStd"
        self.document.saveAs(str(path))
        App.closeDocument(self.document.Name)
        document = App.openDocument(str(path))
        move = document.getObject(name)
        self.assertEqual(arrays.rows(move, "Vertices").tobytes(), vertices.tobytes())
        self.assertEqual(list(move.Triangles), triangles)
        document.recompute(None, True)
        self.assertEqual(move.Inputs, inputs)
        move.Target.Slide = [0, 25, 0]
        document.recompute()
        self.assertNotEqual(move.Inputs, inputs)
        self.assertLess(move.MeasuredLineError, 1e-9)

    def test_undo_and_redo_take_a_move_back_and_again_in_one_step(self):
        model = api.import_model(PANEL, self.document)
        target = api.target_line(model, slide=SLIDE)
        move = api.move(target)
        name, vertices = move.Name, arrays.rows(move, "Vertices").tobytes()
        self.document.undo()
        self.assertIsNone(self.document.getObject(name))
        self.assertIsNotNone(self.document.getObject(target.Name))
        self.document.redo()
        self.assertEqual(arrays.rows(self.document.getObject(name), "Vertices").tobytes(), vertices)

    def test_undo_brings_back_the_doubles_of_a_changed_move(self):
        model = api.import_model(PANEL, self.document)
        target = api.target_line(model, slide=SLIDE)
        move = api.move(target)
        before = arrays.rows(move, "Vertices").tobytes()
        with api.transaction(self.document, "Change the slide"):
            target.Slide = [0, 30, 0]
            self.document.recompute()
        self.assertNotEqual(arrays.rows(move, "Vertices").tobytes(), before)
        self.document.undo()
        self.document.recompute()
        self.assertEqual(arrays.rows(move, "Vertices").tobytes(), before)

    def test_a_second_move_starts_from_the_first_ones_result(self):
        model = api.import_model(PANEL, self.document)
        first = api.move(api.target_line(model, slide=SLIDE))
        second = api.move(api.target_line(first, slide=[0, -15, 0]))
        self.assertLess(second.MeasuredLineError, 1e-9)
        self.assertEqual(second.Model, first)
        before = second.Inputs
        first.Target.Slide = [0, 22, 0]
        self.document.recompute()
        self.assertNotEqual(second.Inputs, before)

    def test_a_part_object_is_written_for_the_engine_once_a_shape(self):
        box = self.document.addObject("Part::Box", "Box")
        self.document.recompute()
        model = api.import_model(box)
        first = models.source_of(model)
        self.assertEqual(models.source_of(model), first)
        box.Length = 17
        self.document.recompute()
        self.assertNotEqual(models.source_of(model).digest, first.digest)
        self.assertEqual(models.source_of(model).keys, first.keys)

    def test_part_and_mesh_objects_of_the_document_become_models(self):
        box = self.document.addObject("Part::Box", "Box")
        self.document.recompute()
        model = api.import_model(box)
        self.assertEqual(api.find_lines(model).Count, 12)
        mesh = self.document.addObject("Mesh::Feature", "Mesh")
        mesh.Mesh = model.Mesh
        mesh.Placement.Base = App.Vector(0, 0, 7)
        placed = api.import_model(mesh)
        self.assertEqual(np.asarray(api.engine_model(placed).vertices)[:, 2].min(), 7)
        box.Length = 25
        self.document.recompute()
        self.assertEqual(np.asarray(api.engine_model(model).vertices)[:, 0].max(), 25)

    def test_sketches_and_draft_curves_are_target_lines_and_are_followed(self):
        import Draft
        import Sketcher  # noqa: F401 (adds its kind of object)

        model = api.import_model(PANEL, self.document)
        line = api.engine_model(model).feature_lines()[0]
        first, last = (np.asarray(line.points)[i] for i in (0, -1))
        inner = [tuple(first + part * (last - first)) for part in (0.2, 0.4, 0.6, 0.8)]
        sketch = self.document.addObject("Sketcher::SketchObject", "Sketch")
        sketch.Placement.Base.z = inner[0][2]
        sketch.addGeometry(Part.LineSegment(*(App.Vector(x, y, 0) for x, y, _ in (inner[0], inner[-1]))))
        draft = Draft.make_bspline([App.Vector(*point) for point in inner])
        self.document.recompute()
        for curve in (sketch, draft):
            target = api.target_line(model, curve=curve)
            self.assertAlmostEqual(target.Length.Value, curve.Shape.Length, delta=1e-6 * curve.Shape.Length)
        draft.Points = [*draft.Points[:-1], draft.Points[-1] + App.Vector(0, 7, 0)]
        self.document.recompute()
        self.assertAlmostEqual(target.Length.Value, draft.Shape.Length, delta=1e-6 * draft.Shape.Length)
        self.assertGreater(abs(target.Length.Value - sketch.Shape.Length), 0.01)

    def roof(self):
        """Four plane faces side by side, 50 mm wide; the middle edge is the only sharp one."""
        faces = [Part.Face(Part.makePolygon([(a, 0, -0.3 * abs(a)), (a + 50, 0, -0.3 * abs(a + 50)),
                                             (a + 50, 300, -0.3 * abs(a + 50)), (a, 300, -0.3 * abs(a)),
                                             (a, 0, -0.3 * abs(a))])) for a in (-100, -50, 0, 50)]
        roof = self.document.addObject("Part::Feature", "Roof")
        roof.Shape = Part.makeShell(faces)
        return roof

    def test_a_protected_face_stays_where_it_is(self):
        model = api.import_model(self.roof())
        self.assertEqual(api.find_lines(model).Count, 1)
        target = api.target_line(model, "0@25%..75%", slide=[0, 15, 0])
        shifts = []
        for faces in ([], [0, 3]):
            move = api.move(target, roi_distance=90, fixed_faces=faces, max_edge=8)
            result = api.result(move)
            rest = np.asarray(result.rest_vertices)
            outer = np.abs(rest[:, 0]) >= 50
            shifts.append(np.abs(np.asarray(result.vertices) - rest)[outer].max())
        self.assertGreater(shifts[0], 1e-3)
        self.assertEqual(shifts[1], 0)

    def test_protecting_a_face_at_the_line_is_refused_in_a_sentence(self):
        model = api.import_model(PANEL, self.document)
        target = api.target_line(model, "0@25%..75%", slide=SLIDE)
        with self.assertRaisesRegex(engine.UserError, "stay fixed but lies on the line"):
            api.region(target, fixed_faces=[int(api.engine_model(model).face_ids[0])])

    def test_a_failed_function_leaves_no_object_behind(self):
        model = api.import_model(PANEL, self.document)
        there = len(self.document.Objects)
        with self.assertRaises(engine.UserError):
            api.target_line(model, "7")
        self.assertEqual(len(self.document.Objects), there)


if __name__ == "__main__":
    unittest.main()
