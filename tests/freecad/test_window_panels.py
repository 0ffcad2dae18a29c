# SPDX-License-Identifier: GPL-3.0-or-later
"""What the panels do while the engine is still at work, what clicks in the 3D view choose, and where errors show."""
import subprocess
import unittest
from unittest import mock

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
import window
from common import HOOD, LINE, PANEL, SLIDE, zigzag_roof
from panel_case import PanelCase
from PySide import QtGui

from freecad.tapeline import api, engine, session
from freecad.tapeline.objects import line_set
from freecad.tapeline.panels.base import Panel
from freecad.tapeline.scene.handles import Projection


def open_panel(command):
    Gui.Selection.clearSelection()
    Gui.runCommand(command)
    window.settle(0.1)
    return Panel.open_panel


def idle(panel):
    window.wait_until(lambda: not panel.background.busy, 40, "the background's end")


def choose(box, value):
    box.setCurrentIndex(box.findData(value))


def click_at(point):
    window.click(Projection(window.view(), window.viewport()).pixel(point))


class Panels(PanelCase):
    def setUp(self):
        super().setUp()
        session._held.clear()

    def hood(self):
        model = api.import_model(HOOD, self.document)
        target = api.target_line(model, LINE, slide=[0, 30, 60, 30, 0], tolerance=2, on_surface=True)
        window.view().viewIsometric()
        window.view().fitAll()
        window.settle(0.2)
        return target

    def test_a_drag_right_after_opening_is_followed_at_once_and_then_finely(self):
        self.hood()
        begun = mock.Mock()
        real = session.MoveSession.prepare

        def prepare_when_seen(maker, order, progress=None, cancel=None):
            cancel.wait(1.0)  # as on a larger model
            return real(maker, order, progress, cancel)

        with mock.patch.object(session.MoveSession, "prepare", prepare_when_seen):
            panel = open_panel("Tapeline_Move")
            seen, shown = [], panel._previewed
            panel._previewed = lambda made: (shown(made), seen.append((made[1], panel.latency)),
                                             begun(panel.message.text()))
            window.wait_until(lambda: panel.editing.base is not None, 20, "the control points")
            start = panel.editing.handles.pixel_of(2)
            window.drag(start, start + np.array([20.0, 15.0]), steps=10)
            window.wait_until(lambda: seen, 5, "the first preview")
            self.assertFalse(seen[0][0])
            self.assertIn("Preparing", begun.call_args_list[0].args[0])
            window.wait_until(lambda: session.is_warm(panel.order), 40, "the preparation")
            start = panel.editing.handles.pixel_of(2)
            window.drag(start, start + np.array([10.0, 5.0]), steps=5)
            window.wait_until(lambda: seen[-1][0], 20, "a fine preview")
        fine = next(latency for is_fine, latency in seen if is_fine)
        triangles = sum(map(len, panel.faces_of_sides))
        print(f"first update, coarse: {seen[0][1]:.3f} s; fine: {fine:.3f} s for {triangles} triangles")
        self.assertLess(seen[0][1], 0.5)

    def test_a_surface_too_slow_for_the_budget_is_followed_on_coarse_triangles_while_the_mouse_moves(self):
        self.hood()
        panel = open_panel("Tapeline_Move")
        window.wait_until(lambda: session.is_warm(panel.order) and not panel.background.busy, 40, "a fine preview")
        session._held_for(panel.order).pace = 0.4  # too slow for a budget of 100 ms, good enough for five times that
        seen, shown = [], panel._previewed
        panel._previewed = lambda made: (seen.append((panel._patient, made[1])), shown(made))
        start = panel.editing.handles.pixel_of(2)
        window.drag(start, start + np.array([15.0, 10.0]), steps=6)
        window.wait_until(lambda: (True, True) in seen, 20, "a fine preview when the mouse stands still")
        self.assertEqual(seen[0], (False, False))

    def test_a_target_that_was_just_made_is_prepared_before_its_move_is_opened(self):
        self.hood()
        panel = open_panel("Tapeline_Region")
        window.wait_until(lambda: panel.shown is not None, 30, "the region")
        self.assertTrue(panel.accept())
        order = session.solving.order_for(self.document.TargetLine, self.document.MoveRegion)
        window.wait_until(lambda: session.is_warm(order), 30, "the preparation")
        panel = open_panel("Tapeline_Move")
        window.wait_until(lambda: panel.latency is not None, 20, "the first preview")
        self.assertIn("exact surface comes", panel.message.text())

    def test_a_move_that_is_refused_says_why_though_a_coarse_preview_is_shown(self):
        self.hood()
        refuse = engine.UserError("The region is refused.")
        with mock.patch.object(session.MoveSession, "prepare", side_effect=refuse):
            panel = open_panel("Tapeline_Move")
            window.wait_until(lambda: panel.latency is not None, 20, "the coarse preview")
            self.assertEqual(panel.message.text(), "The region is refused.")

    def roof_with_target(self):
        path = str(self.folder / "roof.obj")
        engine.module().Model.from_arrays(*zigzag_roof()).write(path)
        model = api.import_model(path, self.document)
        lines = {round(float(np.asarray(line.points)[0, 0])): line for line in api.engine_model(model).feature_lines()}
        target = api.target_line(model, f"{lines[20].id}@25%..75%", slide=[0, 5, 0])
        window.view().viewTop()
        window.view().fitAll()
        window.settle(0.2)
        return lines, target

    def test_a_line_that_is_clicked_while_lines_are_found_is_chosen(self):
        lines, _ = self.roof_with_target()
        panel = open_panel("Tapeline_FindLines")
        window.wait_until(lambda: panel.found, 30, "the lines")
        click_at(np.asarray(lines[60].points).mean(axis=0))
        self.assertEqual(panel.table.currentRow(), lines[60].id)
        self.assertTrue(panel.accept())
        picked, = Gui.Selection.getSelectionEx()
        self.assertEqual(picked.SubElementNames, (f"Edge{lines[60].id + 1}",))

    def test_lines_of_a_region_are_chosen_by_clicks(self):
        lines, _ = self.roof_with_target()
        panel = open_panel("Tapeline_Region")
        window.wait_until(lambda: panel.shown is not None, 30, "the region")
        middle = {x: np.asarray(line_set.closed_points(line)).mean(axis=0) for x, line in lines.items()}
        for mode, key, x in (("keep", "keep", -20), ("hold", "hold", 60), ("bound", "roi_lines", -60)):
            choose(panel.mode, mode)
            click_at(middle[x])
            idle(panel)
            self.assertEqual(panel.fields[key].text(), str(lines[x].id), key)
        window.keep("16_region_lines")
        click_at(middle[-60])  # takes it back
        idle(panel)
        self.assertEqual(panel.fields["roi_lines"].text(), "")
        self.assertTrue(panel.accept())
        region = self.document.MoveRegion
        self.assertEqual((list(region.Keep), list(region.Hold)), ([str(lines[-20].id)], [str(lines[60].id)]))

    def test_a_face_that_is_clicked_to_stay_but_lies_at_the_line_is_refused_and_a_second_click_lets_it_go(self):
        model = api.import_model(PANEL, self.document)
        api.target_line(model, slide=SLIDE)
        window.view().viewTop()
        window.view().fitAll()
        panel = open_panel("Tapeline_Region")
        window.wait_until(lambda: panel.shown is not None, 30, "the region")
        place = np.asarray(panel.engine_model.vertices)[np.asarray(panel.engine_model.faces[0])].mean(axis=0)
        choose(panel.mode, "protect")
        click_at(place)
        idle(panel)
        self.assertEqual(panel.protected, {int(panel.engine_model.face_ids[0])})
        self.assertIn("stay fixed but lies on the line", panel.message.text())
        click_at(place)
        idle(panel)
        self.assertEqual(panel.protected, set())
        self.assertIn("may move", panel.message.text())

    def test_a_region_field_that_is_no_number_is_said_in_the_panel(self):
        self.roof_with_target()
        panel = open_panel("Tapeline_Region")
        panel.fields["roi_faces"].setText("four")
        self.assertFalse(panel.accept())
        self.assertIn("'four' are no numbers", panel.message.text())

    def test_a_failed_recompute_shows_one_sentence_in_the_report_view_and_a_mark_in_the_tree(self):
        model = api.import_model(PANEL, self.document)
        move = api.move(api.target_line(model, slide=SLIDE))
        view = Gui.getMainWindow().findChild(QtGui.QTextEdit, "Report view")
        view.clear()
        move.Line = "9"
        self.document.recompute()
        window.settle(0.3)
        text = view.toPlainText()
        self.assertEqual(text.count("There is no line 9"), 1, text)
        self.assertNotIn("Traceback", text)
        self.assertNotIn("File \"", text)
        self.assertIn("Invalid", move.State)
        self.assertEqual(move.getStatusString().count("There is no line 9"), 1)

    def test_the_number_of_control_points_counts_for_a_fitted_and_for_a_slid_line(self):
        model = api.import_model(PANEL, self.document)
        api.find_lines(model)
        panel = open_panel("Tapeline_Target")
        idle(panel)
        for law, count in (("", 6), ("0, 20, 30, 20, 0", 8)):
            panel.law.setText(law)
            panel.count.setValue(count)
            panel.law.editingFinished.emit()
            idle(panel)
            self.assertEqual(len(panel.editing.base.control_points), count)
        self.assertTrue(panel.accept())
        target = self.document.TargetLine
        self.assertEqual((target.SurfacePoints, target.ControlPoints), (8, 0))
        target.ViewObject.Proxy.doubleClicked(target.ViewObject)
        self.assertEqual(Panel.open_panel.count.value(), 8)

    def test_a_missing_module_is_said_in_a_box_when_a_command_is_chosen(self):
        sentence = "The compiled Python module 'tapeline' was not found"
        with mock.patch.object(engine, "_module", None), mock.patch.object(engine, "_load", lambda: None):
            Gui.runCommand("Tapeline_ImportModel")
            window.settle(0.2)
            box = Gui.getMainWindow().findChild(QtGui.QMessageBox, "TapelineSentence")
            self.assertIn(sentence, box.text())
            self.assertIn("Preferences > Tapeline", box.text())
            box.close()
        self.assertFalse(Gui.Control.activeDialog())

    def test_freecad_that_is_closed_in_mid_solve_ends_without_a_crash(self):
        script = str(self.folder / "leave.py")
        with open(script, "w", encoding="utf-8") as file:
            file.write(LEAVE.format(path=str(HOOD), line=LINE))
        done = subprocess.run(["freecad", script], stdin=subprocess.DEVNULL, capture_output=True, text=True,
                              check=False, timeout=60)
        self.assertIn("leaving while 2 solve", done.stdout + done.stderr)
        self.assertEqual(done.returncode, 0, done.stderr[-400:])

    def test_choices_are_shown_in_words_and_stored_as_the_engine_names_them(self):
        api.target_line(api.import_model(PANEL, self.document), slide=SLIDE)
        panel = open_panel("Tapeline_Move")
        box = panel.boxes["crease"]
        choose(box, "keep")
        self.assertEqual(box.currentText(), "kept")
        window.wait_until(lambda: panel.result is not None, 40, "the exact result")
        self.assertTrue(panel.accept())
        self.assertEqual(self.document.FeatureLineMove.Crease, "keep")


# Solves again and again in two threads, and closes FreeCAD's window meanwhile.
LEAVE = """
import sys
from PySide import QtCore
import FreeCAD as App, FreeCADGui as Gui

def begin():
    from freecad.tapeline import api, solving, worker

    document = App.newDocument("Leave")
    target = api.target_line(api.import_model({path!r}, document), {line!r}, slide=[0, 30, 60, 30, 0])
    order = solving.order_for(target)

    def work(progress, cancel):
        while not cancel.is_set():
            solving.results.clear()
            order.solve(progress, cancel)

    tasks = [worker.Task(work) for _ in range(2)]

    def leave():
        print("leaving while", sum(task.running for task in tasks), "solve", file=sys.__stdout__, flush=True)
        App.closeDocument(document.Name)
        Gui.getMainWindow().close()

    QtCore.QTimer.singleShot(600, leave)

QtCore.QTimer.singleShot(500, begin)
"""

if __name__ == "__main__":
    unittest.main()
