# SPDX-License-Identifier: GPL-3.0-or-later
"""Python, command and job files are three doors of one house."""

import json
import pathlib
import tempfile
import unittest

import numpy as np
import shapes

import tapeline


class SameBytes(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def bytes_of(self, name):
        return (self.folder / name).read_bytes()

    def test_a_cad_model_moved_by_python_and_by_the_command_gives_the_same_bytes(self):
        step = shapes.SOURCE / "resources/models/panel.step"
        model = tapeline.Model.read(step)
        line = model.feature_lines()[0].part("20%", "80%")
        keys = dict(slide=shapes.LAW, max_edge=25, roi_distance=220)
        tapeline.move(model, line, **keys).write(
            self.folder / "python.obj", rest=self.folder / "python_rest.obj", save_target=self.folder / "python.json"
        )
        shapes.run_command(
            "move", step, "--line", "0@20%..80%", "--slide", ",".join(map(str, shapes.LAW)), "--max-edge", 25,
            "--roi-distance", 220, "-o", self.folder / "command.obj", "--rest", self.folder / "command_rest.obj",
            "--save-target", self.folder / "command.json",
        )
        for ending in (".obj", "_rest.obj", ".json"):
            self.assertEqual(self.bytes_of("python" + ending), self.bytes_of("command" + ending), ending)

    def test_a_mesh_and_a_target_in_memory_give_the_bytes_of_the_files_they_were_written_to(self):
        model, line = shapes.panel()
        target = model.fit_target(line, slide=shapes.LAW)
        model.write(self.folder / "model.obj")
        target.write(self.folder / "target.json")
        tapeline.move(model, line, target).write(self.folder / "python.obj")
        shapes.run_command(
            "move", self.folder / "model.obj", "--line", line.selector, "--target", self.folder / "target.json", "-o",
            self.folder / "command.obj",
        )
        self.assertEqual(self.bytes_of("python.obj"), self.bytes_of("command.obj"))

    def test_a_fitted_and_slid_target_is_the_one_that_the_command_writes(self):
        step = shapes.SOURCE / "resources/models/panel.step"
        model = tapeline.Model.read(step)
        line = model.feature_lines()[0].part("20%", "80%")
        model.fit_target(line, slide=shapes.LAW, max_edge=25).write(self.folder / "python.json")
        shapes.run_command(
            "target", step, "--line", line.selector, "--slide", ",".join(map(str, shapes.LAW)), "--max-edge",
            25, "-o", self.folder / "command.json",
        )
        self.assertEqual(self.bytes_of("python.json"), self.bytes_of("command.json"))

    def test_a_saved_job_runs_to_the_same_bytes(self):
        model, line = shapes.panel()
        target = model.fit_target(line, slide=shapes.LAW)
        keys = dict(method="asan-fl", roi_distance=240, clamp_rings=2)
        editor = tapeline.Editor(model, line, **keys)
        editor.solve(target).write(self.folder / "python.obj")
        editor.save_job(self.folder / "job.json", target)
        shapes.run_command("run", self.folder / "job.json")
        self.assertEqual(self.bytes_of("python.obj"), self.bytes_of("job.obj"))
        job = json.loads(self.bytes_of("job.json"))
        self.assertEqual(job["move"], {"method": "asan-fl", "clamp_rings": 2})
        self.assertEqual(job["target"], {"target": "job.target.json"})

    def test_a_saved_job_of_a_chain_of_vertices_runs_to_the_same_bytes(self):
        model, line = shapes.panel()
        chain = model.line_through(line.vertices)
        result = tapeline.move(model, chain, model.fit_target(chain, slide=15))
        result.write(self.folder / "python.obj")
        result.save_job(self.folder / "job.json", target_path=self.folder / "goal.step")
        self.assertTrue((self.folder / "goal.step").exists())
        statistics = tapeline.run_job(self.folder / "job.json")
        self.assertEqual(statistics["line"]["vertices"], result.line_vertices.tolist())
        # The target went through STEP, which writes 17 digits.
        self.assertEqual(self.bytes_of("python.obj"), self.bytes_of("job.obj"))

    def test_a_part_of_a_straight_cad_edge_is_the_part_that_the_command_takes(self):
        step = shapes.SOURCE / "resources/models/bracket.step"
        model = tapeline.Model.read(step)
        whole = model.feature_lines()[5]
        part = whole.part("20%", "80%")
        self.assertAlmostEqual(part.length_mm, 0.6 * whole.length_mm, delta=whole.length_mm / 60)
        self.assertGreater(len(part.points), 30)
        self.assertGreaterEqual(part.vertices[1], len(model.vertices))
        model.fit_target(part, control_points=9).write(self.folder / "python.json")
        shapes.run_command(
            "target", step, "--line", part.selector, "--control-points", 9, "-o", self.folder / "command.json"
        )
        self.assertEqual(self.bytes_of("python.json"), self.bytes_of("command.json"))
        self.assertTrue(model.region(part, slide=[0, 1, 0], roi_distance=6).placement["compressed_side"])
        # A mesh is remeshed, and its line split up, only where a size is asked for.
        V, F = shapes.crease_panel(4, 4)
        coarse = tapeline.Model.from_arrays(V, F).feature_lines()[0]
        self.assertEqual(len(coarse.part("25%", "75%").points), 3)
        self.assertEqual(len(coarse.part("25%", "75%", max_edge=50).points), 9)

    def test_a_saved_job_keeps_the_unit_of_the_arrays_and_runs_to_the_same_bytes(self):
        V, F = shapes.crease_panel(jitter=0.3)
        for units, length in (("m", 1000), ("in", 25.4), ("ft", 304.8), ("cm", 10)):
            model = tapeline.Model.from_arrays(V / length, F, units=units)
            # A result is a model in that unit too.
            for name in ("first", "second"):
                line = model.feature_lines()[0].part("20%", "80%")
                result = tapeline.move(model, line, slide=[0, 12.5, 0])
                result.write(self.folder / "python.obj")
                result.save_job(self.folder / f"{name}.json")
                tapeline.run_job(self.folder / f"{name}.json")
                self.assertEqual(self.bytes_of("python.obj"), self.bytes_of(f"{name}.obj"), units)
                self.assertEqual(json.loads(self.bytes_of(f"{name}.json"))["import"]["units"], units)
                model = result.moved
                again = tapeline.Model.read(self.folder / "python.obj", units=units)
                self.assertEqual(model.vertices.tobytes(), again.vertices.tobytes())

    def test_a_model_that_its_unit_cannot_hold_is_refused_and_nothing_is_written(self):
        V, F = shapes.crease_panel(jitter=0.3)
        model = tapeline.Model.from_arrays(V / 1000, F, units="m")
        line = model.feature_lines()[0].part("20%", "80%")
        # Remeshing puts vertices where multiples of a metre cannot be.
        finer = model.region(line, slide=[0, 10, 0], max_edge=12).model
        result = tapeline.move(finer, finer.feature_lines()[0].part("20%", "80%"), slide=[0, 10, 0])
        with self.assertRaisesRegex(tapeline.TapelineError, "no exact value in m"):
            result.save_job(self.folder / "job.json")
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_an_editor_solves_to_the_bytes_of_a_move_after_any_drag(self):
        model = tapeline.Model.read(shapes.SOURCE / "resources/models/panel.step")
        line = model.feature_lines()[0].part("20%", "80%")
        keys = dict(roi_distance=220, max_edge=25)
        editor = tapeline.Editor(model, line, **keys)
        fitted = model.fit_target(line)
        for shift in (10, -20):
            target = fitted.slide(model, line, [0, shift, 0], max_edge=25)
            editor.preview(target)
            solved = editor.solve(target)
            moved = tapeline.move(model, line, target, **keys)
            self.assertEqual(solved.vertices.tobytes(), moved.vertices.tobytes())
            self.assertEqual(solved.faces.tobytes(), moved.faces.tobytes())

    def test_a_result_moves_on_as_the_mesh_written_from_it_does(self):
        model, line = shapes.panel()
        first = tapeline.move(model, line, slide=[0, 15, 0])
        first.write(self.folder / "first.obj")
        again = tapeline.Model.read(self.folder / "first.obj")
        self.assertEqual(again.vertices.tobytes(), first.moved.vertices.tobytes())
        lines = [m.feature_lines() for m in (first.moved, again)]
        self.assertEqual([x.vertices.tolist() for x in lines[0]], [x.vertices.tolist() for x in lines[1]])

    def test_a_job_as_a_dict_is_the_job_as_a_file(self):
        model, line = shapes.panel()
        model.write(self.folder / "model.obj")
        out = self.folder / "moved.obj"
        tapeline.run_job(
            {
                "input": self.folder / "model.obj",
                "lines": {"line": line.selector},
                "target": {"slide": shapes.LAW},
                "outputs": {"out": [out]},
            }
        )
        tapeline.move(model, line, slide=shapes.LAW).write(self.folder / "python.obj")
        self.assertEqual(out.read_bytes(), self.bytes_of("python.obj"))


if __name__ == "__main__":
    unittest.main()
