# SPDX-License-Identifier: GPL-3.0-or-later
"""From import to export in FreeCAD's window, as a new user goes, in one go: each test is the next step of the walk.

With TAPELINE_PICTURES set to a folder, each step leaves a screenshot there (docs/freecad.md shows them)."""
import os
import tempfile
import unittest

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
import window
from common import HOOD
from PySide import QtGui

from freecad.tapeline import arrays
from freecad.tapeline.panels.base import Panel


def panel_widget(kind, name):
    """A widget of the open task panel, by its object name."""
    found = [w for w in Gui.getMainWindow().findChildren(kind, name) if w.isVisible()]
    assert found, f"no visible {name}"
    return found[-1]


def run(command):
    """Runs a command, as its button does, and waits for its panel."""
    Gui.runCommand(command)
    window.wait_until(Gui.Control.activeDialog, 20, "the panel of " + command)
    window.settle(0.3)


def press(which):
    """Presses a button of the task panel's button row."""
    for box in Gui.getMainWindow().findChildren(QtGui.QDialogButtonBox):
        button = box.button(which)
        if button is not None and button.isVisible():
            button.click()
            window.settle(0.2)
            return
    raise AssertionError("no such button")


def sentence():
    return panel_widget(QtGui.QLabel, "message").text()


def wait_for_sentence(part, seconds=40):
    window.wait_until(lambda: part in sentence(), seconds, f"the sentence '{part}' (it says '{sentence()}')")


def objects(kind):
    from freecad.tapeline.objects import is_a

    return [obj for obj in App.ActiveDocument.Objects if is_a(obj, kind)]


class Walk(unittest.TestCase):
    """unittest runs these in the order of their names."""

    @classmethod
    def setUpClass(cls):
        Gui.activateWorkbench("TapelineWorkbench")
        App.newDocument("Hood").UndoMode = 1
        window.settle(0.5)
        cls.folder = tempfile.TemporaryDirectory(prefix="tapeline_walk_")

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_01_the_workbench_is_there_with_its_commands(self):
        self.assertEqual(Gui.activeWorkbench().name(), "TapelineWorkbench")
        commands = [name for name in Gui.listCommands() if name.startswith("Tapeline_")]
        self.assertEqual(len(commands), 9)
        for bar in Gui.getMainWindow().findChildren(QtGui.QToolBar, "Tapeline"):
            self.assertFalse(any(action.icon().isNull() for action in bar.actions() if not action.isSeparator()))

    def test_02_import(self):
        run("Tapeline_ImportModel")
        panel_widget(QtGui.QLineEdit, "path").setText(str(HOOD))
        window.keep("01_import")
        press(QtGui.QDialogButtonBox.Ok)
        window.wait_until(lambda: objects("model"), 30, "the model")
        Gui.Selection.clearSelection()
        self.assertFalse(window.is_blank(window.view_pixels()))
        window.keep("02_model")

    def test_03_lines_follow_the_slider_and_are_numbered(self):
        run("Tapeline_FindLines")
        wait_for_sentence("Found: 1")
        with_line = window.view_pixels()
        panel_widget(QtGui.QSlider, "crease").setValue(400)
        wait_for_sentence("lower the crease angle")
        without = window.view_pixels()
        self.assertGreater(window.changed_share(without, with_line), 5e-4)
        panel_widget(QtGui.QSlider, "crease").setValue(100)
        wait_for_sentence("Found: 1")
        window.keep("03_lines")
        press(QtGui.QDialogButtonBox.Ok)
        self.assertEqual(objects("lines")[0].Count, 1)

    def test_04_a_line_is_picked_in_the_3d_view(self):
        from freecad.tapeline.scene.handles import Projection

        Gui.Selection.clearSelection()
        edge = objects("lines")[0].Shape.Edges[0]
        point = edge.valueAt(0.5 * (edge.FirstParameter + edge.LastParameter))
        window.click(Projection(window.view(), window.viewport()).pixel(point))
        picked = Gui.Selection.getSelectionEx()
        self.assertEqual([(item.Object.Name, item.SubElementNames) for item in picked],
                         [(objects("lines")[0].Name, ("Edge1",))])
        window.keep("04_picked")

    def test_05_target_line_and_a_dragged_control_point(self):
        run("Tapeline_Target")
        wait_for_sentence("control points")
        line = panel_widget(QtGui.QLineEdit, "line")
        line.setText("0@10%..85%")
        line.editingFinished.emit()
        window.settle(0.3)
        wait_for_sentence("control points")
        panel_widget(QtGui.QDoubleSpinBox, "tolerance").setValue(2)
        panel_widget(QtGui.QCheckBox, "on_surface").setChecked(True)
        law = panel_widget(QtGui.QLineEdit, "law")
        law.setText("0, 9, 30, 51, 60, 51, 30, 9, 0")
        law.editingFinished.emit()
        window.settle(0.5)
        window.wait_until(lambda: not Panel.open_panel.background.busy, 30, "the target line")
        self.assertIn("5 control points", sentence())
        handles, before = Panel.open_panel.editing.handles, window.view_pixels()
        start = handles.pixel_of(2)
        window.drag(start, start + np.array([12.0, 9.0]))
        window.wait_until(lambda: not Panel.open_panel.background.busy, 30, "the target line")
        self.assertGreater(window.changed_share(before, window.view_pixels()), 5e-4)
        window.keep("05_target")
        press(QtGui.QDialogButtonBox.Ok)
        target = objects("target")[0]
        self.assertTrue(target.Shape.Edges)
        self.assertEqual(list(target.Slide)[4], 60)
        self.assertEqual(sum(offset.Length > 0 for offset in target.Offsets), 1)
        type(self).offsets = list(target.Offsets)

    def test_06_region(self):
        Gui.Selection.clearSelection()
        run("Tapeline_Region")
        wait_for_sentence("triangles may move")
        narrow = window.greenish(window.view_pixels())
        panel_widget(QtGui.QSlider, "distance").setValue(400)
        window.wait_until(lambda: window.greenish(window.view_pixels()) > 1.3 * narrow, 30, "a wider band")
        window.settle(1)
        window.wait_until(lambda: not Panel.open_panel.background.busy, 30, "the exact band")
        window.keep("06_region")
        press(QtGui.QDialogButtonBox.Ok)
        self.assertEqual(objects("region")[0].RoiDistance.Value, 400)

    def test_07_move_with_preview_and_apply(self):
        Gui.Selection.clearSelection()
        heart = window.Heart()
        run("Tapeline_Move")
        window.wait_until(lambda: "gives way" in panel_widget(QtGui.QLabel, "verdict").text(), 30, "the verdict")
        window.keep("07_verdict")
        wait_for_sentence("Exact")
        window.keep("08_moved")
        panel = Panel.open_panel
        handles, previews = panel.editing.handles, []
        shown, panel._previewed = panel._previewed, lambda preview: (previews.append(preview), shown(preview))
        start = handles.pixel_of(2)
        before = window.view_pixels()
        window.drag(start, start + np.array([25.0, 20.0]), steps=20, held=lambda: window.keep("09_dragging"))
        self.assertGreater(len(previews), 1, "previews while dragging")
        wait_for_sentence("Exact")
        self.assertGreater(window.changed_share(before, window.view_pixels()), 1e-3)
        window.keep("10_dragged")
        print("previews:", len(previews), "the last after", round(panel.latency, 3),
              "s; longest pause of the window:", round(heart.stop(), 3), "s")
        self.assertLess(heart.longest, 1.5)
        self.assertEqual(set(panel.strip.grades.values()) - {"green", "amber", "red"}, set())
        order = panel.result[0]
        press(QtGui.QDialogButtonBox.Apply)
        window.wait_until(lambda: objects("move") and objects("move")[0].Vertices, 40, "the move")
        self.assertFalse(Gui.Control.activeDialog())
        self.assertEqual(objects("move")[0].Inputs, order.digest, "the panel's exact result was taken over")
        window.keep("11_applied")

    def test_08_undo_takes_the_move_and_the_drag_back(self):
        vertices = arrays.rows(objects("move")[0], "Vertices").tobytes()
        self.assertNotEqual(list(objects("target")[0].Offsets), self.offsets)
        App.ActiveDocument.undo()
        self.assertFalse(objects("move"))
        self.assertEqual(list(objects("target")[0].Offsets), self.offsets)
        App.ActiveDocument.redo()
        self.assertEqual(arrays.rows(objects("move")[0], "Vertices").tobytes(), vertices)

    def test_09_check(self):
        Gui.Selection.clearSelection()
        run("Tapeline_Check")
        window.wait_until(lambda: panel_widget(QtGui.QTableWidget, "measures").rowCount() > 5, 40, "the measures")
        pictures = {}
        box = panel_widget(QtGui.QComboBox, "overlay")
        for index in range(box.count()):
            box.setCurrentIndex(index)
            window.settle(0.5)
            pictures[box.itemData(index)] = window.view_pixels()
            window.keep("12_check_" + box.itemData(index))
        for kind, pixels in pictures.items():
            if kind != "plain":
                self.assertGreater(window.changed_share(pictures["plain"], pixels), 0.003, kind)
        press(QtGui.QDialogButtonBox.Close)

    def test_10_sections(self):
        Gui.Selection.clearSelection()
        run("Tapeline_Check")
        window.wait_until(lambda: panel_widget(QtGui.QTableWidget, "measures").rowCount() > 5, 40, "the measures")
        panel = Panel.open_panel
        panel.overlay_box.setCurrentIndex(panel.overlay_box.findData("plain"))
        without = window.view_pixels()
        panel.sections_box.setChecked(True)
        self.assertGreater(window.changed_share(without, window.view_pixels()), 2e-3)
        window.keep("13_sections")
        press(QtGui.QDialogButtonBox.Close)

    def test_11_export(self):
        run("Tapeline_Export")
        out = os.path.join(self.folder.name, "hood_moved.obj")
        panel_widget(QtGui.QLineEdit, "path").setText(out)
        window.keep("14_export")
        press(QtGui.QDialogButtonBox.Ok)
        vertices = arrays.rows(objects("move")[0], "Vertices")
        with open(out, encoding="utf-8") as file:
            written = np.array([[float(w) for w in line.split()[1:4]] for line in file if line.startswith("v ")])
        self.assertEqual(written.tobytes(), vertices.tobytes())



    def test_12_the_saved_document_opens_again_with_its_looks(self):
        path = os.path.join(self.folder.name, "hood.FCStd")
        vertices = arrays.rows(objects("move")[0], "Vertices").tobytes()
        App.ActiveDocument.saveAs(path)
        App.closeDocument(App.ActiveDocument.Name)
        App.openDocument(path)
        window.settle(0.5)
        move, lines = objects("move")[0], objects("lines")[0]
        self.assertEqual(arrays.rows(move, "Vertices").tobytes(), vertices)
        self.assertEqual(type(lines.ViewObject.Proxy).__name__, "LinesView")
        self.assertEqual(move.ViewObject.Proxy.claimChildren(), [move.Target, move.Region])
        self.assertFalse(window.is_blank(window.view_pixels()))
        window.keep("15_opened_again")
