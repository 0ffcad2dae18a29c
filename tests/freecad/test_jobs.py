# SPDX-License-Identifier: GPL-3.0-or-later
"""Jobs out and in, and exports: the command makes the same bytes from what the workbench writes."""
import json
import unittest

import numpy as np
from common import HOOD, LINE, PANEL, SLIDE, SOURCE, InADocument, run_command

from freecad.tapeline import api, arrays, engine


class Jobs(InADocument):
    def ran(self, job):
        """Runs a job by the command; returns the bytes of the moved OBJ."""
        done = run_command("run", job, "--quiet")
        self.assertEqual(done.returncode, 0, done.stderr)
        return (self.folder / (job.stem + "_moved.obj")).read_bytes()

    def exported(self, move):
        path = self.folder / "from_the_document.obj"
        api.export(move, str(path))
        return path.read_bytes()

    def test_the_command_repeats_a_move_of_a_cad_model_to_the_same_bytes(self):
        model = api.import_model(HOOD, self.document, angular_deflection=8)
        target = api.target_line(model, LINE, slide=[0, 30, 60, 30, 0], tolerance=0.1)
        move = api.move(target, region=api.region(target, roi_distance=300))
        job = self.folder / "hood.json"
        api.save_job(move, str(job))
        self.assertEqual(self.ran(job), self.exported(move))

    def test_the_command_repeats_the_second_of_two_moves_to_the_same_bytes(self):
        model = api.import_model(PANEL, self.document)
        first = api.move(api.target_line(model, slide=SLIDE))
        second = api.move(api.target_line(first, slide=[0, -15, 0]))
        job = self.folder / "second.json"
        api.save_job(second, str(job))
        self.assertEqual(self.ran(job), self.exported(second))

    def test_a_job_comes_back_as_objects_that_give_the_same_doubles(self):
        model = api.import_model(PANEL, self.document)
        target = api.target_line(model, slide=SLIDE)
        move = api.move(target, region=api.region(target, roi_distance=120, fixed_vertices=[3]), method="plate-fl")
        job = self.folder / "there.json"
        api.save_job(move, str(job))
        again = api.load_job(str(job), self.document)
        self.assertEqual(again.Method, "plate-fl")
        self.assertEqual(again.Region.RoiDistance.Value, 120)
        self.assertEqual(list(again.Region.FixedVertices), [3])
        self.assertEqual(arrays.rows(again, "Vertices").tobytes(), arrays.rows(move, "Vertices").tobytes())

    def test_our_own_job_files_load(self):
        for name in ("panel", "hood_pull"):
            with self.subTest(name):
                move = api.load_job(str(SOURCE / "resources" / "jobs" / (name + ".json")), self.document)
                self.assertLess(move.MeasuredLineError, 1e-9)

    def test_an_unknown_key_is_refused_in_a_sentence_and_leaves_no_object(self):
        job = self.folder / "odd.json"
        job.write_text(json.dumps({"input": str(PANEL), "move": {"metod": "arap"}}))
        with self.assertRaisesRegex(engine.UserError, "move.metod"):
            api.load_job(str(job), self.document)
        self.assertEqual(self.document.Objects, [])

    def test_exports_hold_every_digit(self):
        model = api.import_model(PANEL, self.document)
        move = api.move(api.target_line(model, slide=SLIDE))
        vertices = arrays.rows(move, "Vertices")
        for ending in (".obj", ".ply", ".off"):
            path = self.folder / ("out" + ending)
            api.export(move, str(path))
            read = engine.module().Model.read(str(path))
            self.assertEqual(np.asarray(read.vertices).tobytes(), vertices.tobytes(), ending)

    def test_the_report_page_names_the_measures(self):
        model = api.import_model(PANEL, self.document)
        move = api.move(api.target_line(model, slide=SLIDE))
        page = self.folder / "report.html"
        api.export(move, "", str(page))
        self.assertIn("bulge", page.read_text(encoding="utf-8"))


if __name__ == "__main__":
    unittest.main()
