# SPDX-License-Identifier: GPL-3.0-or-later
"""What the answers mean: invariances, previews, options, targets."""

import ast
import inspect
import pathlib
import pickle
import time
import unittest

import numpy as np
import shapes

import tapeline


def rotation():
    """A rotation about a slanted axis, exact enough to be one."""
    q, _ = np.linalg.qr(np.array([[2.0, 1, 0], [-1, 3, 1], [0.5, -1, 2]]))
    return q * np.sign(np.linalg.det(q))


class Invariance(unittest.TestCase):
    def test_a_model_turned_and_shifted_as_arrays_moves_in_the_turned_way(self):
        # Irregular: on an even grid the region's distance ties, and rounding decides.
        V, F = shapes.crease_panel(jitter=0.2)
        R, shift = rotation(), np.array([120.0, -45.0, 900.0])
        plain = tapeline.Model.from_arrays(V, F)
        turned = tapeline.Model.from_arrays(V @ R.T + shift, F)
        results = []
        for model in (plain, turned):
            line = model.feature_lines()[0].part("20%", "80%")
            results.append(tapeline.move(model, line, slide=shapes.LAW))
        np.testing.assert_array_equal(results[0].line_vertices, results[1].line_vertices)
        difference = results[0].vertices @ R.T + shift - results[1].vertices
        self.assertLess(np.linalg.norm(difference, axis=1).max(), 2e-3)

    def test_everything_outside_the_region_stays_to_the_bit(self):
        model, line = shapes.panel()
        result = tapeline.move(model, line, slide=shapes.LAW, roi_distance=150)
        outside = np.ones(len(result.vertices), bool)
        outside[result.faces[result.region_faces].ravel()] = False
        self.assertGreater(outside.sum(), 100)
        self.assertEqual(result.vertices[outside].tobytes(), result.rest_vertices[outside].tobytes())


class Previews(unittest.TestCase):
    def test_a_preview_has_its_line_on_the_target_and_its_compressed_side_on_the_old_surface(self):
        model, line = shapes.panel()
        target = model.fit_target(line, slide=shapes.LAW)
        preview = tapeline.Editor(model, line).preview(target, 1e6)
        moved = preview.vertices[preview.line_vertices]
        feet, _ = target.foot(moved)
        self.assertLess(np.abs(feet - moved).max(), 1e-9)
        side = preview.vertices[np.unique(preview.faces[preview.compression_faces])]
        surface = np.where(side[:, 1] > 0, -np.tan(np.radians(12)) * side[:, 1], 0)
        self.assertLess(np.abs(side[:, 2] - surface).max(), 1e-9)
        self.assertEqual(preview.measures["flipped"], 0)
        self.assertLess(preview.measures["line_error_max_mm"], 1e-9)

    def test_previews_tend_to_the_exact_result_as_the_drag_nears_it(self):
        model, line = shapes.panel()
        editor = tapeline.Editor(model, line)
        fitted = model.fit_target(line)
        base, target = (fitted.slide(model, line, [0, s, 0]) for s in (20, 21))
        exact = tapeline.move(model, line, target)
        far = np.abs(editor.preview(target, 1).vertices - exact.vertices).max()
        editor.solve(base)
        near = np.abs(editor.preview(target, 1).vertices - exact.vertices).max()
        self.assertLess(near, 0.3 * far)
        self.assertLess(near, 0.3)

    def test_a_preview_of_the_solved_target_is_the_exact_result(self):
        model, line = shapes.panel()
        editor = tapeline.Editor(model, line)
        target = model.fit_target(line, slide=10)
        self.assertFalse(editor.preview(target).exact)
        result = editor.solve(target)
        preview = editor.preview(target)
        self.assertTrue(preview.exact)
        self.assertEqual(preview.vertices.tobytes(), result.vertices.tobytes())

    def test_a_target_beyond_the_rim_is_told(self):
        model, line = shapes.panel()
        editor = tapeline.Editor(model, line, roi_distance=60)
        fitted = model.fit_target(line)
        editor.start(fitted)
        self.assertFalse(editor.preview(fitted.slide(model, line, [0, 20, 0])).leaves_region)
        self.assertTrue(editor.preview(fitted.slide(model, line, [0, 120, 0])).leaves_region)

    def test_a_preview_of_a_region_of_ten_thousand_vertices_is_timed(self):
        model, line = shapes.panel(128, 96)
        editor = tapeline.Editor(model, line, roi_distance=230)
        fitted = model.fit_target(line)
        targets = [fitted.slide(model, line, [0, s, 0]) for s in (5, 10, 15, 20)]
        begin = time.perf_counter()
        editor.start(targets[0])
        print(f"\nprepared in {1e3 * (time.perf_counter() - begin):.0f} ms")
        for budget in (1, 1e6):
            for target in targets:
                cpu = time.process_time()
                preview = editor.preview(target, budget)
                print(
                    f"budget {budget:g} ms: {1e3 * preview.seconds:.0f} ms, processor "
                    f"{1e3 * (time.process_time() - cpu):.0f} ms, {len(preview.vertices)} vertices"
                )
        self.assertGreater(len(np.unique(preview.faces[preview.tension_faces])), 3000)


class Face(unittest.TestCase):
    def test_options_are_those_of_the_commands(self):
        names = {(option["section"], option["name"]): option for option in tapeline.options()}
        self.assertEqual(names["region", "roi_distance"]["unit"], "mm")
        self.assertIn("plate-fl", names["move", "method"]["choices"])
        help_page = shapes.run_command("move", "--help")
        for (section, name), option in names.items():
            if "move" in option["commands"] and section not in ("", "command"):
                self.assertIn("--" + name.replace("_", "-"), help_page)

    def test_stubs_and_module_name_the_same_things_and_all_are_documented(self):
        stub = ast.parse(pathlib.Path(tapeline._tapeline.__file__).with_name("_tapeline.pyi").read_text())
        told = {}
        for node in stub.body:
            if isinstance(node, ast.ClassDef) and not node.name.startswith("_"):
                told[node.name] = {f.name for f in node.body if isinstance(f, ast.FunctionDef)}
            elif isinstance(node, ast.FunctionDef):
                told[node.name] = set()
        module = tapeline._tapeline
        real = {name: getattr(module, name) for name in vars(module) if not name.startswith("_")}
        self.assertEqual(set(told), set(real))
        for name, thing in real.items():
            self.assertTrue(inspect.getdoc(thing), name)
            if inspect.isclass(thing) and not issubclass(thing, Exception):
                members = {member for member in vars(thing) if not member.startswith("_")}
                special = {member for member in told[name] if member.startswith("__")}
                self.assertEqual(told[name] - special, members, name)
                self.assertLessEqual(special, set(dir(thing)), name)
                for member in members:
                    self.assertTrue(inspect.getdoc(getattr(thing, member)), f"{name}.{member}")

    def test_a_target_survives_json_and_pickle_to_the_bit(self):
        model, line = shapes.panel()
        target = model.fit_target(line, slide=shapes.LAW)
        for copy in (tapeline.TargetLine.from_json(target.to_json()), pickle.loads(pickle.dumps(target))):
            self.assertEqual(copy.control_points.tobytes(), target.control_points.tobytes())
            self.assertEqual(copy.knots.tobytes(), target.knots.tobytes())

    def test_targets_are_evaluated_in_closed_form(self):
        points = np.array([[0, 0, 0], [1, 0, 0], [2, 0, 0], [3, 0, 0]], float)
        straight = tapeline.TargetLine(points, [0, 0, 0, 0, 1, 1, 1, 1])
        np.testing.assert_allclose(straight.sample(4), points, atol=1e-12)
        feet, fractions = straight.foot([[1.5, 2, 0], [-1, 0, 5]])
        np.testing.assert_allclose(feet, [[1.5, 0, 0], [0, 0, 0]], atol=1e-9)
        np.testing.assert_allclose(fractions, [0.5, 0], atol=1e-9)
        # Moving one of four cubic Bezier points moves the middle by 3/8 of it.
        bent = straight.move_control_point(1, [0, 0, 8], relative=True)
        middle = bent.with_control_points(bent.control_points).foot([[1.5, 0, 3]])[0][0]
        np.testing.assert_allclose(middle[2], 3, atol=0.2)

    def test_the_placement_is_known_before_anything_is_solved(self):
        model, line = shapes.panel()
        placed = tapeline.placement(model, line, slide=[0, 20, 0])
        result = tapeline.move(model, line, slide=[0, 20, 0])
        self.assertEqual(placed["verdict"], "on_surface")
        self.assertEqual(placed["compressed_side"], result.stats["placement"]["compressed_side"])
        other = tapeline.placement(model, line, slide=[0, 20, 0], placement="off-surface")
        self.assertEqual(other["verdict"], "off_surface")
        self.assertEqual(len(other["compression_faces"]), 0)

    def test_maps_belong_to_the_vertices_of_the_result(self):
        model, line = shapes.panel()
        result = tapeline.move(model, line, slide=shapes.LAW)
        maps = result.maps
        moved = np.linalg.norm(result.vertices - result.rest_vertices, axis=1)
        np.testing.assert_array_equal(maps["displacement"], moved)
        for values in maps.values():
            self.assertEqual(values.shape, moved.shape)


if __name__ == "__main__":
    unittest.main()
