# SPDX-License-Identifier: GPL-3.0-or-later
"""Commands in FreeCAD's window away from the straight path: nothing to work on, Cancel, curves, pins, jobs."""
import unittest
from unittest import mock

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
import Part
import window
from common import PANEL, SLIDE
from panel_case import PanelCase
from PySide import QtGui

from freecad.tapeline import api, arrays, engine, settings
from freecad.tapeline.panels import files
from freecad.tapeline.panels.base import Panel
from freecad.tapeline.scene.handles import Projection
from freecad.tapeline.session import MoveSession


def run(command):
    Gui.runCommand(command)
    window.settle(0.2)


def idle():
    window.wait_until(lambda: not Panel.open_panel.background.busy, 40, "the background's end")


class Commands(PanelCase):
    def with_target(self, **keys):
        model = api.import_model(PANEL, self.document)
        target = api.target_line(model, **keys)
        window.view().viewTop()
        Gui.SendMsgToActiveView("ViewFit")
        window.settle(0.2)
        return model, target

    def test_a_command_without_what_it_needs_says_so_in_a_box(self):
        run("Tapeline_Move")
        box = Gui.getMainWindow().findChild(QtGui.QMessageBox, "TapelineSentence")
        self.assertIn("target line", box.text())
        self.assertFalse(Gui.Control.activeDialog())
        box.close()

    def test_cancel_leaves_the_document_as_it_was(self):
        _, target = self.with_target(slide=SLIDE)
        names, offsets = [obj.Name for obj in self.document.Objects], list(target.Offsets)
        for command in ("FindLines", "Target", "Region", "Move"):
            with self.subTest(command):
                run("Tapeline_" + command)
                self.assertTrue(Gui.Control.activeDialog())
                window.settle(0.3)
                Panel.open_panel.reject()
                window.settle(0.1)
                self.assertEqual([obj.Name for obj in self.document.Objects], names)
                self.assertTrue(self.document.StylingModel.ViewObject.Visibility)
        self.assertEqual(list(target.Offsets), offsets)

    def test_a_selected_curve_of_the_document_becomes_the_target(self):
        model, _ = self.with_target()
        line = api.engine_model(model).feature_lines()[0]
        first, last = np.asarray(line.points)[0], np.asarray(line.points)[-1]
        along = np.linspace(0.1, 0.9, 9)[:, None]
        points = first + along * (last - first) + np.sin(np.pi * along) * np.array([0, 8.0, 0])
        curve = self.document.addObject("Part::Feature", "Curve")
        spline = Part.BSplineCurve()
        spline.interpolate(arrays.vectors(points))
        curve.Shape = spline.toShape()
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(curve)
        run("Tapeline_Target")
        idle()
        self.assertTrue(Panel.open_panel.accept())
        made = [obj for obj in self.document.Objects if obj.Name.startswith("TargetLine")][-1]
        self.assertEqual(made.LinkedCurve[0], curve)
        self.assertAlmostEqual(made.Shape.Length, curve.Shape.Length, delta=1e-6 * curve.Shape.Length)

    def test_vertices_are_pinned_by_clicking_and_stay(self):
        _, target = self.with_target(slide=SLIDE)
        run("Tapeline_Region")
        idle()
        panel = Panel.open_panel
        vertex = int(np.argmin(np.linalg.norm(np.asarray(panel.engine_model.vertices)
                                              - np.array([0.0, 60.0, 0.0]), axis=1)))
        panel.mode.setCurrentIndex(panel.mode.findData("pin"))
        window.click(Projection(window.view(), window.viewport()).pixel(panel.engine_model.vertices[vertex]))
        idle()
        self.assertEqual(panel.fixed, {vertex})
        self.assertTrue(panel.accept())
        region = self.document.MoveRegion
        self.assertEqual(list(region.FixedVertices), [vertex])

    def test_a_point_dragged_along_the_surface_stays_in_its_tangent_plane(self):
        _, target = self.with_target()
        run("Tapeline_Target")
        idle()
        handles = Panel.open_panel.editing.handles
        index = len(handles.points) // 2
        place, normal = handles.points[index].copy(), Panel.open_panel.editing.normals.at(handles.points[index])
        start = handles.pixel_of(index)
        window.drag(start, start + np.array([0.0, 40.0]))
        moved = handles.points[index] - place
        self.assertGreater(np.linalg.norm(moved), 1)
        self.assertLess(abs(moved @ normal), 1e-3 * np.linalg.norm(moved))
        np.testing.assert_allclose(handles.pixel_of(index), start + np.array([0.0, 40.0]), atol=1.0)

    def test_the_verdict_can_be_overruled(self):
        self.with_target(slide=SLIDE)
        run("Tapeline_Move")
        panel = Panel.open_panel
        window.wait_until(lambda: "left side" in panel.verdict.text(), 40, "the verdict")
        box = panel.boxes["placement"]
        box.setCurrentIndex(box.findData("off-surface"))
        window.wait_until(lambda: panel.verdict.text().startswith("off the surface"), 40, "the other verdict")
        window.wait_until(lambda: panel.result is not None, 40, "the exact result")
        self.assertTrue(panel.accept())
        self.assertEqual(self.document.FeatureLineMove.LinePlacement, "off-surface")
        self.assertEqual(self.document.FeatureLineMove.Verdict, "off_surface")

    def test_a_double_click_opens_a_move_again_and_apply_changes_it_in_one_step(self):
        _, target = self.with_target(slide=SLIDE)
        move = api.move(target)
        before = arrays.rows(move, "Vertices").tobytes()
        move.ViewObject.Proxy.doubleClicked(move.ViewObject)
        window.settle(0.2)
        panel = Panel.open_panel
        box = panel.boxes["method"]
        box.setCurrentIndex(box.findData("arap"))
        window.wait_until(lambda: panel.result is not None and panel.result[0].keys.get("method") == "arap", 60,
                          "the other method's result")
        self.assertTrue(panel.accept())
        self.assertEqual(move.Method, "arap")
        self.assertNotEqual(arrays.rows(move, "Vertices").tobytes(), before)
        self.document.undo()
        self.assertNotEqual(move.Method, "arap")
        self.assertEqual(arrays.rows(move, "Vertices").tobytes(), before)

    def test_a_panel_whose_document_is_closed_can_still_be_left(self):
        def preview_until_cancelled(session, order, budget_ms, patient=False, progress=None, cancel=None):
            cancel.wait(60)
            raise engine.module().Cancelled("cancelled")

        self.with_target(slide=SLIDE)
        with mock.patch.object(MoveSession, "preview", preview_until_cancelled):
            run("Tapeline_Move")
            window.wait_until(lambda: Panel.open_panel.background.busy, 40, "the background's start")
            App.closeDocument(self.document.Name)
            window.settle(0.5)
            if Panel.open_panel is not None:
                Panel.open_panel.reject()
            window.settle(0.5)
        self.assertFalse(Gui.Control.activeDialog())

    def test_a_recompute_can_be_cancelled_behind_its_dialog(self):
        from PySide import QtCore

        _, target = self.with_target(slide=SLIDE)
        move = api.move(target)
        before = arrays.rows(move, "Vertices").tobytes()
        seen = []

        def cancel():
            for dialog in QtGui.QApplication.topLevelWidgets():
                if isinstance(dialog, QtGui.QProgressDialog):
                    seen.append(dialog)
                    dialog.cancel()

        timer = QtCore.QTimer()
        timer.timeout.connect(cancel)
        timer.start(50)
        target.Slide = [0, 35, 0]
        self.document.recompute()
        timer.stop()
        self.assertTrue(seen)
        self.assertTrue({"Invalid", "Touched"} & set(move.State) or "Invalid" in target.State)
        self.assertEqual(arrays.rows(move, "Vertices").tobytes(), before)
        self.document.recompute()
        self.assertNotEqual(arrays.rows(move, "Vertices").tobytes(), before)

    def test_solving_can_be_stopped_and_the_window_stays_alive(self):
        self.with_target(slide=SLIDE)
        solve = MoveSession.solve

        def solve_when_stopped(session, order, progress=None, cancel=None):
            cancel.wait(60)  # on a quick machine the solver would be done before Stop is pressed
            return solve(session, order, progress, cancel)

        with mock.patch.object(MoveSession, "solve", solve_when_stopped):
            run("Tapeline_Move")
            window.wait_until(lambda: Panel.open_panel.solver.busy, 40, "the solver's start")
            heart = window.Heart()
            window.settle(0.2)
            Panel.open_panel.stop.click()
            window.wait_until(lambda: not Panel.open_panel.solver.busy, 20, "the solver's end")
            self.assertIsNone(Panel.open_panel.result)
            self.assertLess(heart.stop(), 1.0)

    def test_a_job_saved_by_the_command_loads_by_the_command(self):
        _, target = self.with_target(slide=SLIDE)
        move = api.move(target)
        job = self.folder / "job.json"
        with mock.patch.object(files.QtGui.QFileDialog, "getSaveFileName", return_value=(str(job), "")):
            run("Tapeline_SaveJob")
        self.assertTrue(job.exists())
        with mock.patch.object(files.QtGui.QFileDialog, "getOpenFileName", return_value=(str(job), "")):
            run("Tapeline_LoadJob")
        window.wait_until(lambda: self.document.getObject("FeatureLineMove001") is not None, 40, "the loaded move")
        again = self.document.FeatureLineMove001
        self.assertEqual(arrays.rows(again, "Vertices").tobytes(), arrays.rows(move, "Vertices").tobytes())

    def test_sections_with_combs_are_drawn(self):
        _, target = self.with_target(slide=SLIDE)
        api.move(target)
        run("Tapeline_Check")
        idle()
        panel = Panel.open_panel
        panel.overlay_box.setCurrentIndex(panel.overlay_box.findData("plain"))
        without = window.view_pixels()
        panel.sections_box.setChecked(True)
        self.assertGreater(window.changed_share(without, window.view_pixels()), 2e-3)
        window.keep("14_sections")

    def test_limits_of_the_preferences_colour_the_strip(self):
        group = App.ParamGet(settings.GROUP)
        self.assertEqual([settings.grade("Bulge", v) for v in (0.01, -0.07, 0.2, None)], ["green", "amber", "red", ""])
        group.SetFloat("BulgeAmber", 0.001)
        try:
            self.assertEqual(settings.grade("Bulge", 0.01), "amber")
        finally:
            group.RemFloat("BulgeAmber")

    def test_the_preferences_page_opens_in_freecads_dialog(self):
        from PySide import QtCore

        seen = []

        def look():
            for dialog in QtGui.QApplication.topLevelWidgets():
                if dialog.isVisible() and dialog.metaObject().className().endswith("DlgPreferencesImp"):
                    seen.extend(w.objectName() for w in dialog.findChildren(QtGui.QDoubleSpinBox, "BulgeAmber"))
                    window.keep("15_preferences", dialog.grab().toImage())
                    dialog.reject()

        QtCore.QTimer.singleShot(1500, look)
        Gui.showPreferences("Tapeline", 0)
        self.assertEqual(seen, ["BulgeAmber"])


if __name__ == "__main__":
    unittest.main()
