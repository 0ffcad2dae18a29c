# SPDX-License-Identifier: GPL-3.0-or-later
"""Panel of Find feature lines: thresholds with sliders, the lines found, numbered in the 3D view as they change."""
import FreeCADGui as Gui
import numpy as np
from PySide import QtCore, QtGui

from .. import api, models, properties
from ..objects import line_set
from ..scene.line_preview import LinePreview
from ..scene.picking import SurfacePicker
from ..text import QT_TRANSLATE_NOOP, translate
from .base import Panel, SavedVisibility, number

STEPS = 10  # slider positions a degree


class LinesPanel(Panel):
    title = QT_TRANSLATE_NOOP("Tapeline", "Find feature lines")
    icon_name = "lines"

    def __init__(self, model=None, lines=None):
        self.lines_object = lines
        self.model = lines.Model if lines is not None else model
        super().__init__(self.model.Document)
        self.source = models.source_of(self.model)
        self.found = []
        now = properties.keys(lines, ["lines"]) if lines is not None else {}
        self._build(now)
        self.preview = self.decorate(LinePreview(self.view))
        self.picker = self.decorate(SurfacePicker(self.view, self._picked))
        if lines is not None:
            self.decorate(SavedVisibility(lines))
        self.update()

    def _build(self, now):
        self.boxes = {}
        labels = {"crease_angle": translate("Tapeline", "Crease angle"),
                  "crease_angle_low": translate("Tapeline", "Goes on along"),
                  "max_turn": translate("Tapeline", "Cut at turns of"),
                  "min_length": translate("Tapeline", "Shortest line")}
        for option in properties.table(["lines"]):
            suffix = " °" if option["unit"] == "deg" else " mm"
            box = number(now.get(option["name"], option["default"]), option["minimum"] or 0,
                         option.get("maximum") or 1e6, 2, suffix)
            box.setToolTip(properties.tooltip(option))
            box.valueChanged.connect(lambda *_: self.update())
            self.boxes[option["name"]] = box
            self.rows.addRow(labels.get(option["name"], option["name"]), box)
            if option["name"] == "crease_angle":
                self._add_slider(box)
        self.table = QtGui.QListWidget()
        self.table.setObjectName("lines")
        self.table.setWordWrap(True)
        self.table.setHorizontalScrollBarPolicy(QtCore.Qt.ScrollBarAlwaysOff)
        self.table.currentRowChanged.connect(self._mark)
        self.column.insertWidget(1, self.table)

    def _add_slider(self, box):
        self.slider = QtGui.QSlider(QtCore.Qt.Horizontal)
        self.slider.setObjectName("crease")
        self.slider.setRange(1, 60 * STEPS)
        self.slider.setValue(int(box.value() * STEPS))
        self.slider.valueChanged.connect(lambda position: box.setValue(position / STEPS))
        box.valueChanged.connect(self._follow)
        self.rows.addRow("", self.slider)

    def _follow(self, angle):
        self.slider.blockSignals(True)
        self.slider.setValue(int(angle * STEPS))
        self.slider.blockSignals(False)

    def keys(self):
        return {name: box.value() for name, box in self.boxes.items()}

    def update(self):
        source, keys = self.source, self.keys()

        def work(progress, cancel):
            model = models.load(source, progress, cancel)
            return model, line_set.find(model, keys)

        self.compute(work, self._show)

    def _show(self, made):
        model, found = made
        self.found = found
        self.picker.set_surface(model.vertices, model.faces)
        self.table.clear()
        for line in found:
            self.table.addItem(line_set.describe(line))
        self.preview.show([(str(line.id), line_set.closed_points(line)) for line in found])
        self.say(translate("Tapeline", "Found: {}. Pick one in the list or by a click on it.")
                 .format(len(found)) if found else
                 translate("Tapeline", "No edge is as sharp as this: lower the crease angle."), bad=not found)

    def _picked(self, place):
        """A click on a line, which is a click on its entry of the list."""
        index = place.line([np.asarray(line_set.closed_points(line)) for line in self.found])
        if index >= 0:
            self.table.setCurrentRow(index)
        return index >= 0

    def _mark(self, index):
        self.preview.mark(index)

    def apply(self):
        keys = self.keys()
        if self.lines_object is None:
            self.lines_object = api.find_lines(self.model, **keys)
        else:
            with api.transaction(self.document, self.heading):
                properties.assign(self.lines_object, keys)
                api.computed(self.lines_object)
        Gui.Selection.clearSelection()
        chosen = max(self.table.currentRow(), 0)
        Gui.Selection.addSelection(self.document.Name, self.lines_object.Name, f"Edge{chosen + 1}")
