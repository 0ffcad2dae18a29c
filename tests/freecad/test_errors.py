# SPDX-License-Identifier: GPL-3.0-or-later
"""What goes wrong is said in a sentence, the object shows its error state, and the document stays as it was."""
import signal
import subprocess
import time
import unittest
import zipfile
from unittest import mock

import FreeCAD as App
import Mesh
import numpy as np
import Part
from common import HOOD, LINE, PANEL, SLIDE, InADocument, Printed

from freecad.tapeline import api, arrays, engine, models


def strip(across=40, along=60, crease=0.3, hole=()):
    """A roof of two planes that meet in a crease, as vertices and faces, without the cells in `hole`."""
    x, y = np.meshgrid(np.linspace(-100, 100, across + 1), np.linspace(0, 300, along + 1))
    vertices = np.stack([x.ravel(), y.ravel(), -crease * np.abs(x.ravel())], axis=1)
    faces = []
    for j in range(along):
        for i in range(across):
            if (i, j) not in hole:
                a = j * (across + 1) + i
                faces += [(a, a + 1, a + across + 2), (a, a + across + 2, a + across + 1)]
    return vertices, np.array(faces)


class Errors(InADocument):
    def mesh(self, vertices, faces, name="model.obj"):
        """A styling model from arrays, by way of a file."""
        path = self.folder / name
        engine.module().Model.from_arrays(vertices, faces).write(str(path))
        return api.import_model(str(path), self.document)

    def refused(self, action, words):
        """The action raises a sentence with these words and leaves no object behind."""
        there = len(self.document.Objects)
        with self.assertRaises(engine.errors()) as raised:
            action()
        text = str(raised.exception)
        self.assertRegex(text, words)
        self.assertNotIn("Traceback", text)
        self.assertEqual(len(self.document.Objects), there)

    def test_an_open_mesh_moves_and_its_border_stays(self):
        model = self.mesh(*strip())
        move = api.move(api.target_line(model, "0@20%..80%", slide=[0, 10, 0]))
        self.assertLess(move.MeasuredLineError, 1e-9)

    def test_a_mesh_full_of_gaps_is_refused_in_a_sentence(self):
        vertices, faces = strip()
        loose = vertices[faces].reshape(-1, 3) * (1 + 1e-3 * np.arange(len(faces)).repeat(3)[:, None] / len(faces))
        model = self.mesh(loose, np.arange(len(loose)).reshape(-1, 3))
        self.refused(lambda: api.find_lines(model), "crease angle")

    def test_a_step_file_without_a_sharp_edge_is_refused_in_a_sentence(self):
        ball = Part.makeSphere(50)
        path = self.folder / "ball.step"
        ball.exportStep(str(path))
        model = api.import_model(str(path), self.document)
        self.refused(lambda: api.find_lines(model), "crease angle 10 deg")

    def test_a_region_with_a_hole_moves_and_a_slide_into_the_hole_is_refused_in_a_sentence(self):
        hole = {(i, j) for i in range(26, 30) for j in range(28, 32)}
        model = self.mesh(*strip(hole=hole))
        for slide in (-15, 15):
            target = api.target_line(model, "0@20%..80%", slide=[0, slide, 0])
            move = api.move(target, region=api.region(target, roi_distance=80))
            self.assertLess(move.MeasuredLineError, 1e-9)
            self.assertTrue(np.isfinite(arrays.rows(move, "Vertices")).all())
            self.assertEqual(api.measures(move)["flipped"], 0)
        self.refused(lambda: api.target_line(model, "0@20%..80%", slide=[0, -60, 0]), "border is 31.* slide less there")

    def test_a_curve_on_the_other_side_of_a_closed_model_is_refused_in_a_sentence(self):
        box = self.document.addObject("Mesh::Feature", "Box")
        box.Mesh = Mesh.createBox(200, 100, 50, 8)  # about the origin
        model = api.import_model(box)
        curve = self.document.addObject("Part::Feature", "Opposite")
        points = np.asarray(api.engine_model(model).feature_lines()[0].points)
        curve.Shape = Part.makePolygon(arrays.vectors(-points))
        for line in ("0", "0@20%..80%"):
            target = api.target_line(model, line, curve=curve)
            self.refused(lambda target=target: api.move(target), "no fixed rim.*choose a smaller region")

    def test_a_curve_far_off_the_model_is_refused_in_a_sentence(self):
        model = api.import_model(PANEL, self.document)
        line = models.load(models.source_of(model)).feature_lines()[0]
        far = np.asarray(line.points) + np.array([0, 0, 5000.0])
        curve = self.document.addObject("Part::Feature", "Far")
        curve.Shape = Part.makePolygon(arrays.vectors(far))
        target = api.target_line(model, curve=curve)
        self.refused(lambda: api.move(target), ".{20,}")

    def test_two_separate_curves_are_refused_as_a_target(self):
        model = api.import_model(PANEL, self.document)
        curves = self.document.addObject("Part::Feature", "Two")
        curves.Shape = Part.makeCompound([Part.makeLine((0, 0, 0), (10, 0, 0)), Part.makeLine((0, 5, 0), (10, 5, 0))])
        self.refused(lambda: api.target_line(model, curve=curves), "2 separate curves")

    def test_a_file_that_is_no_model_is_refused_in_a_sentence(self):
        path = self.folder / "no_model.step"
        path.write_text("ISO-10303-21; nothing")
        self.refused(lambda: api.import_model(str(path), self.document), ".{20,}")
        self.refused(lambda: api.import_model(str(self.folder / "missing.step"), self.document), "no file")

    def test_a_move_that_fails_later_keeps_its_old_result_and_shows_the_error(self):
        model = api.import_model(PANEL, self.document)
        move = api.move(api.target_line(model, slide=SLIDE))
        before = arrays.rows(move, "Vertices").tobytes()
        move.Line = "9"
        self.document.recompute()
        self.assertIn("Invalid", move.State)
        self.assertIn("There is no line 9", move.getStatusString())
        self.assertEqual(arrays.rows(move, "Vertices").tobytes(), before)
        move.Line = "0"
        self.document.recompute()
        self.assertNotIn("Invalid", move.State)

    def test_a_failing_object_prints_its_sentence_and_nothing_else_of_ours(self):
        model = api.import_model(PANEL, self.document)
        move = api.move(api.target_line(model, slide=SLIDE))
        move.Label, move.Line = "Roof line", "9"
        with Printed() as printed:
            self.document.recompute()
        said = printed.sentences()
        self.assertEqual(len(said), 1, printed.text)
        self.assertRegex(said[0], r"^Tapeline: Roof line: There is no line 9: .*\.$")

    def test_a_fault_of_the_program_keeps_its_traceback(self):
        model = api.import_model(PANEL, self.document)
        with mock.patch.object(models, "load", side_effect=ZeroDivisionError("a fault")), Printed() as printed:
            model.touch()
            self.document.recompute()
        self.assertIn("in compute", printed.text)
        self.assertIn("ZeroDivisionError", printed.text)
        self.assertIn("Invalid", model.State)

    def test_a_missing_module_is_said_in_a_sentence(self):
        known, engine._module = engine._module, None
        load, engine._load = engine._load, lambda: None
        try:
            self.assertFalse(engine.available())
            with self.assertRaisesRegex(engine.EngineMissing, "Preferences > Tapeline"):
                api.import_model(PANEL, self.document)
        finally:
            engine._module, engine._load = known, load

    def test_freecad_killed_in_mid_solve_leaves_the_saved_document_whole(self):
        model = api.import_model(HOOD, self.document)
        target = api.target_line(model, LINE, slide=[0, 30, 60, 30, 0])
        path, sign = self.folder / "kept.FCStd", self.folder / "solving"
        api.move(target, region=api.region(target, roi_distance=300))
        self.document.saveAs(str(path))
        saved = path.read_bytes()
        script = self.folder / "solve.py"
        script.write_text(SOLVE.format(path=str(path), sign=str(sign)))
        process = subprocess.Popen(["freecadcmd", str(script)], stdin=subprocess.DEVNULL,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        end = time.monotonic() + 60
        while not sign.exists() and process.poll() is None and time.monotonic() < end:
            time.sleep(0.02)
        self.assertTrue(sign.exists(), "the solver never began")
        process.send_signal(signal.SIGKILL)
        self.assertEqual(process.wait(), -signal.SIGKILL)
        self.assertEqual(path.read_bytes(), saved)
        self.assertIsNone(zipfile.ZipFile(path).testzip())
        self.assertTrue(App.openDocument(str(path)).FeatureLineMove.Vertices)


# Opens the document and solves again; the first report of the solver's progress leaves a sign.
SOLVE = """
import pathlib
import FreeCAD as App
from freecad.tapeline import solving
document = App.openDocument({path!r})
order = solving.order_of(document.FeatureLineMove)
def progress(fraction, stage):
    if stage.startswith("deform") or fraction > 0.4:
        pathlib.Path({sign!r}).touch()
while True:
    solving.results.clear()
    order.solve(progress)
"""

if __name__ == "__main__":
    unittest.main()
