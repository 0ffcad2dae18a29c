# SPDX-License-Identifier: GPL-3.0-or-later
"""compare and check: the numbers and files of the command."""

import json
import pathlib
import tempfile
import threading
import unittest

import numpy as np
import shapes

import tapeline

METHODS = ["plate-fl", "asan-fl", "arap"]


def without_times(entry):
    """A JSON value without the seconds in it, which differ from run to run."""
    if isinstance(entry, dict):
        return {key: without_times(value) for key, value in entry.items() if key not in ("seconds", "threads_per_method")}
    return [without_times(value) for value in entry] if isinstance(entry, list) else entry


class Folder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)


class Comparing(Folder):
    def job(self):
        model, line = shapes.panel()
        model.write(self.folder / "model.obj")
        job = self.folder / "job.json"
        job.write_text(json.dumps({
            "input": "model.obj", "lines": {"line": line.selector}, "target": {"slide": shapes.LAW},
            "gate": {"max_flipped": 0},
        }))
        return job

    def test_a_job_compared_by_python_and_by_the_command_gives_the_same_files_and_numbers(self):
        job = self.job()
        mine = tapeline.compare(job, methods=METHODS, output=self.folder / "python", check_unique=True)
        shapes.run_command(
            "compare", job, "--methods", ",".join(METHODS), "--check-unique", "-o", self.folder / "command"
        )
        for folder in ("python", "command"):
            self.assertIn("<html", (self.folder / folder / "compare.html").read_text())
            self.assertTrue(any((self.folder / folder / "pictures").iterdir()))
        for method in METHODS:
            files = [(self.folder / folder / f"{method}.obj").read_bytes() for folder in ("python", "command")]
            self.assertEqual(files[0], files[1], method)
            written = tapeline.Model.read(self.folder / "python" / f"{method}.obj")
            np.testing.assert_array_equal(written.vertices, mine[method].vertices)
        stats = [json.loads((self.folder / folder / "compare.json").read_text()) for folder in ("python", "command")]
        self.assertEqual(without_times(stats[0]), without_times(stats[1]))
        self.assertEqual(without_times(mine.stats), without_times(stats[1]))
        self.assertIsNotNone(mine["asan-fl"].stats["uniqueness"]["distance_mm"])

    def test_a_model_in_memory_is_compared_as_its_job_is_and_each_method_as_its_move_is(self):
        model, line = shapes.panel()
        compared = tapeline.compare(model, line, methods=METHODS, slide=shapes.LAW, max_flipped=0)
        self.assertEqual(list(compared), METHODS)
        self.assertEqual(compared.winner, compared.ranking[0])
        self.assertIn(compared.winner, compared.headline)
        by_job = tapeline.compare(self.job(), methods=METHODS)
        for method in compared:
            run = compared[method]
            moved = tapeline.move(model, line, slide=shapes.LAW, method=method)
            self.assertEqual(run.vertices.tobytes(), moved.vertices.tobytes())
            self.assertEqual(run.faces.tobytes(), moved.faces.tobytes())
            self.assertEqual(run.measures, moved.measures)
            self.assertEqual(run.measures, by_job[method].measures)
            self.assertEqual(run.rank, compared.ranking.index(method) + 1)
            self.assertTrue(run.gates[0]["passed"])

    def test_a_method_that_fails_stands_there_with_its_reason(self):
        model, line = shapes.panel()
        compared = tapeline.compare(
            model, line, slide=[0, 40, 0], methods=["asan-fl", "lri"], max_iterations=1, output=self.folder / "out"
        )
        failed = compared["asan-fl"]
        self.assertEqual((failed.state, failed.rank), ("not_converged", None))
        self.assertIn("did not converge", failed.reason)
        self.assertEqual((compared.ranking, compared.winner), (["lri"], "lri"))
        self.assertIn("model in memory", (self.folder / "out/compare.html").read_text())

    def test_wrong_wishes_are_refused_before_any_work(self):
        model, line = shapes.panel()
        (self.folder / "file").write_text("")
        cases = [
            (dict(methods=["arap", "arap"]), "names arap twice"),
            (dict(methods="plate-f"), "did you mean 'plate-fl'"),
            (dict(methods=[], output=self.folder / "file"), "is no folder"),
            (dict(threads=-1), "threads"),
        ]
        for keys, sentence in cases:
            with self.assertRaisesRegex(tapeline.TapelineError, sentence) as caught:
                tapeline.compare(model, line, slide=5, progress=lambda *_: self.fail("work was done"), **keys)
            self.assertEqual(caught.exception.kind, "usage")
        with self.assertRaises(KeyError):
            tapeline.compare(model, line, slide=5, methods="arap")["asan"]

    def test_a_comparison_is_cancelled_without_a_file(self):
        event = threading.Event()
        with self.assertRaises(tapeline.Cancelled):
            tapeline.compare(
                self.job(), output=self.folder / "out", cancel=event,
                progress=lambda fraction, stage: event.set() if stage == "methods" else None,
            )
        self.assertFalse((self.folder / "out").exists())


class Checking(Folder):
    def moved(self):
        model, line = shapes.panel()
        return tapeline.move(model, line, slide=shapes.LAW)

    def test_a_result_checked_in_memory_gives_the_numbers_of_the_command_on_its_files(self):
        result = self.moved()
        names = dict(rest=self.folder / "before.obj", stats=self.folder / "stats.json", save_target=self.folder / "t.json")
        result.write(self.folder / "after.obj", **names)
        command = json.loads(shapes.run_command(
            "check", self.folder / "after.obj", "--against", self.folder / "before.obj", "--stats", names["stats"],
            "--target", names["save_target"], "--max-bulge", 0.1, "--json", "-",
        ))
        target = tapeline.TargetLine.read(names["save_target"])
        for stats in (result.stats, names["stats"]):
            mine = tapeline.check(result.rest, result.moved, stats=stats, target=target, max_bulge=0.1)
            self.assertEqual(mine, command)
        moved = result.measures
        for key in ("crease", "line_error_max_mm", "squash", "flipped"):
            self.assertEqual(mine["measures"][key], moved[key], key)

    def test_a_line_of_the_model_before_is_the_flag_line_and_one_of_the_model_after_its_vertices(self):
        result = self.moved()
        result.write(self.folder / "after.obj", rest=self.folder / "before.obj")
        before, after = (tapeline.Model.read(self.folder / name) for name in ("before.obj", "after.obj"))
        whole = before.feature_lines()[0]
        command = json.loads(shapes.run_command(
            "check", self.folder / "after.obj", "--against", self.folder / "before.obj", "--line", whole.selector,
            "--json", "-",
        ))
        self.assertEqual(tapeline.check(before, after, whole), command)
        own = tapeline.check(before, after, after.line_through(result.line_vertices))
        self.assertEqual(own["line"]["vertices"], result.line_vertices.tolist())

    def test_what_cannot_be_checked_is_refused_in_a_sentence(self):
        result = self.moved()
        _, strange = shapes.panel()
        for keys, sentence in (
            (dict(line=strange), "third model"),
            (dict(stats={"line": 3}), "not a statistics file"),
            (dict(method="arap"), "'method' is unknown here"),
        ):
            with self.assertRaisesRegex(tapeline.TapelineError, sentence):
                tapeline.check(result.rest, result.moved, **keys)


if __name__ == "__main__":
    unittest.main()
