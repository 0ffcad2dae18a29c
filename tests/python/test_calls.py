# SPDX-License-Identifier: GPL-3.0-or-later
"""Arrays, threads, cancellation and errors."""

import os
import pathlib
import signal
import tempfile
import threading
import time
import unittest

import numpy as np
import shapes

import tapeline


class Arrays(unittest.TestCase):
    def test_arrays_show_the_memory_of_the_model_and_outlive_it(self):
        V, F = shapes.crease_panel()
        model = tapeline.Model.from_arrays(V, F)
        first, second = model.vertices, model.vertices
        self.assertEqual(first.ctypes.data, second.ctypes.data)
        self.assertTrue(np.shares_memory(first, second))
        self.assertEqual((first.dtype, model.faces.dtype), (np.float64, np.int32))
        del model, second
        np.testing.assert_array_equal(first, V)

    def test_shown_arrays_cannot_be_written_to(self):
        model, line = shapes.panel()
        for array in (model.vertices, model.faces, tapeline.move(model, line, slide=5).vertices):
            with self.assertRaises(ValueError):
                array[0, 0] = 1

    def test_arrays_of_other_types_and_orders_give_the_same_model(self):
        V, F = shapes.crease_panel()
        one = tapeline.Model.from_arrays(V, F)
        two = tapeline.Model.from_arrays(np.asfortranarray(V), F[:, ::1].astype(np.uint16))
        self.assertEqual(one.vertices.tobytes(), two.vertices.tobytes())
        self.assertEqual(one.faces.tobytes(), two.faces.tobytes())

    def test_units_of_arrays_become_millimetres_and_come_back(self):
        V, F = shapes.crease_panel()
        model = tapeline.Model.from_arrays(V / 1000, F, units="m")
        np.testing.assert_allclose(model.vertices, V, rtol=1e-14)
        with tempfile.TemporaryDirectory() as folder:
            model.write(folder + "/m.obj")
            np.testing.assert_allclose(tapeline.Model.read(folder + "/m.obj").vertices, V / 1000, rtol=1e-14)

    def test_arrays_that_are_no_mesh_are_refused_in_a_sentence(self):
        V, F = shapes.crease_panel()
        far = F.copy()
        far[7, 1] = len(V)
        cases = [
            (V[:, :2], F, "usage", r"shape \(n, 3\)"),
            (V, F.astype(float), "usage", "whole numbers"),
            (V, far, "rejected", f"triangle 7 names vertex {len(V)}"),
            (V * np.nan, F, "rejected", "vertex 0"),
            (V, F[:0], "rejected", "no triangles"),
        ]
        for vertices, faces, kind, sentence in cases:
            with self.assertRaisesRegex(tapeline.TapelineError, sentence) as caught:
                tapeline.Model.from_arrays(vertices, faces)
            self.assertEqual(caught.exception.kind, kind)


class Threads(unittest.TestCase):
    def test_a_second_thread_counts_while_a_move_runs(self):
        model, line = shapes.panel(64, 48)
        seen = []
        done = threading.Event()

        def count():
            while not done.is_set():
                seen.append(None)
                done.wait(0.001)

        counter = threading.Thread(target=count)
        counter.start()
        before = len(seen)
        # No callback: the call itself must let go.
        tapeline.move(model, line, slide=[0, 40, 0])
        after = len(seen)
        done.set()
        counter.join()
        self.assertGreater(after - before, 20)

    def test_moves_of_one_model_in_several_threads_give_the_same_bytes(self):
        model, line = shapes.panel()
        results = [None] * 3

        def run(k):
            results[k] = tapeline.move(model, line, slide=[0, 20, 0]).vertices.tobytes()

        threads = [threading.Thread(target=run, args=(k,)) for k in range(3)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(len(set(results)), 1)

    def test_progress_never_falls_and_comes_from_the_calling_thread(self):
        model, line = shapes.panel()
        reports = []
        tapeline.move(
            model, line, slide=10, progress=lambda fraction, stage: reports.append((fraction, stage, threading.get_ident()))
        )
        fractions = [fraction for fraction, _, _ in reports]
        self.assertEqual(fractions, sorted(fractions))
        self.assertTrue(all(0 <= fraction <= 1 for fraction in fractions))
        self.assertIn("region", [stage for _, stage, _ in reports])
        self.assertEqual({thread for _, _, thread in reports}, {threading.get_ident()})


    def test_any_number_of_threads_gives_the_same_bytes_in_every_call(self):
        def everything(threads):
            model = tapeline.Model.read(shapes.SOURCE / "resources/models/panel.step", threads=threads)
            line = model.feature_lines()[0].part("20%", "80%")
            keys = dict(max_edge=25, roi_distance=220)
            target = model.fit_target(line, slide=shapes.LAW, max_edge=25, threads=threads)
            editor = tapeline.Editor(model, line, threads=threads, **keys)
            compared = tapeline.compare(model, line, target, methods=["plate-fl", "asan-fl"], threads=threads, **keys)
            moved = tapeline.move(model, line, target, threads=threads, **keys)
            return [model.vertices.tobytes(), target.to_json(), moved.vertices.tobytes(),
                    editor.preview(target).vertices.tobytes(), editor.solve(target).vertices.tobytes(),
                    *(run.vertices.tobytes() for run in map(compared.__getitem__, compared)),
                    str(tapeline.check(moved.rest, moved.moved, threads=threads))]

        self.assertEqual(everything(1), everything(0))

    def test_one_thread_uses_one_processor_only(self):
        model, line = shapes.panel(64, 48)
        wall, own = time.perf_counter(), time.process_time()
        tapeline.compare(model, line, slide=[0, 40, 0], methods=["arap", "asan-fl"], threads=1)
        wall, own = time.perf_counter() - wall, time.process_time() - own
        self.assertLess(own, 1.1 * wall)

    def test_a_number_of_threads_is_checked_as_the_flag_is(self):
        model, line = shapes.panel()
        for threads in (-1, 1025, 1.5, "two"):
            for call in (tapeline.move, tapeline.Editor, tapeline.compare):
                with self.assertRaisesRegex(tapeline.TapelineError, "'threads'") as caught:
                    call(model, line, slide=5, threads=threads)
                self.assertEqual(caught.exception.kind, "usage")


class Cancelling(unittest.TestCase):
    def test_an_event_cancels_and_nothing_is_left(self):
        model, line = shapes.panel()
        event = threading.Event()
        stages = []

        def progress(_, stage):
            stages.append(stage)
            if stage == "region":
                event.set()

        with self.assertRaises(tapeline.Cancelled) as caught:
            tapeline.move(model, line, slide=20, progress=progress, cancel=event)
        self.assertEqual(caught.exception.kind, "cancelled")
        self.assertEqual(stages[-1], "region")
        # The same call goes through afterwards.
        event.clear()
        tapeline.move(model, line, slide=20, cancel=event)

    def test_a_job_cancelled_while_it_runs_writes_no_file(self):
        model, line = shapes.panel()
        with tempfile.TemporaryDirectory() as folder:
            job = pathlib.Path(folder) / "job.json"
            tapeline.move(model, line, slide=20).save_job(job)
            before = sorted(os.listdir(folder))
            with self.assertRaises(tapeline.Cancelled):
                tapeline.run_job(job, progress=lambda fraction, stage: stage != "quality")
            self.assertEqual(sorted(os.listdir(folder)), before)

    def test_an_exception_of_the_callback_ends_the_call_and_goes_through(self):
        model, line = shapes.panel()
        with self.assertRaises(ZeroDivisionError):
            tapeline.move(model, line, slide=20, progress=lambda fraction, stage: 1 / 0)

    def test_control_c_interrupts_a_move(self):
        model, line = shapes.panel(64, 48)
        timer = threading.Timer(0.05, os.kill, (os.getpid(), signal.SIGINT))
        with self.assertRaises(KeyboardInterrupt):
            timer.start()
            for _ in range(200):
                tapeline.move(model, line, slide=[0, 40, 0])


class Errors(unittest.TestCase):
    def assertFails(self, kind, sentence, call):
        with self.assertRaisesRegex(tapeline.TapelineError, sentence) as caught:
            call()
        self.assertEqual(caught.exception.kind, kind)

    def test_each_kind_of_failure_has_its_name(self):
        model, line = shapes.panel()
        self.assertFails("unreadable", "no such file", lambda: tapeline.Model.read("/nowhere.step"))
        self.assertFails("usage", "no goal is given", lambda: tapeline.move(model, line))
        self.assertFails("rejected", "", lambda: tapeline.move(model, line, slide=20, roi_distance=5))
        self.assertFails(
            "not_converged", "did not converge",
            lambda: tapeline.move(model, line, slide=[0, 40, 0], method="asan-fl", max_iterations=1),
        )

    def test_an_unknown_keyword_names_the_nearest_known_one(self):
        model, line = shapes.panel()
        self.assertFails("usage", "did you mean 'roi_distance'", lambda: tapeline.move(model, line, roi_distanse=3))
        self.assertFails("usage", "'crease_angle'", lambda: model.feature_lines(creaseangle=3))

    def test_a_keyword_is_checked_as_the_flag_of_the_same_name_is(self):
        model, line = shapes.panel()
        self.assertFails("usage", "did you mean 'plate-fl'", lambda: tapeline.move(model, line, method="plate-f"))
        self.assertFails("usage", "1 to 1000000", lambda: tapeline.move(model, line, stiffness_ratio=0.5))
        self.assertFails("usage", "must be a number", lambda: tapeline.move(model, line, roi_distance="wide"))
        self.assertFails("usage", "means nothing", lambda: tapeline.move(model, line, roi_distance=object()))

    def test_a_line_of_another_model_is_refused(self):
        model, _ = shapes.panel()
        _, line = shapes.panel()
        self.assertFails("usage", "belongs to another model", lambda: tapeline.move(model, line, slide=5))


if __name__ == "__main__":
    unittest.main()
