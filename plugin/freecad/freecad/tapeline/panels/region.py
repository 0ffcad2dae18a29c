# SPDX-License-Identifier: GPL-3.0-or-later
"""Panel of Region: what may follow, tinted as it changes; pinned vertices and protected faces by picking."""
import FreeCADGui as Gui
import numpy as np
from PySide import QtCore, QtGui

from .. import api, curves, engine, models, properties, settings, solving
from ..objects import region as regions
from ..scene import colours
from ..scene.overlay import SurfaceOverlay
from ..scene.picking import SurfacePicker
from ..text import translate
from .base import AUTOMATIC, Panel, SavedVisibility, button, number, row


class RegionPanel(Panel):
    title = translate("Tapeline", "Region")
    icon_name = "region"

    def __init__(self, target=None, region=None):
        self.region = region
        self.target = region.Target if region is not None else target
        super().__init__(self.target.Document)
        self.source = models.source_of(self.target.Model)
        self.fixed = set(region.FixedVertices) if region is not None else set()
        self.protected = set(region.FixedFaces) if region is not None else set()
        self._build(properties.keys(region, ["region"]) if region is not None else {})
        self.overlay = self.decorate(SurfaceOverlay(self.view))
        self.decorate(SavedVisibility(self.target.Model))
        self.shown = None  # the region shown, whose even triangles serve for quick answers
        self._rest = QtCore.QTimer(self.form)
        self._rest.setSingleShot(True)
        self._rest.timeout.connect(self.update)
        self.picker = self.decorate(SurfacePicker(self.view, self._picked))
        self.update()

    def _build(self, now):
        self.distance = number(now.get("roi_distance", 0), 0, 1e5, 1, " mm", 10)
        self.distance.setSpecialValueText(AUTOMATIC)
        self.slider = QtGui.QSlider(QtCore.Qt.Horizontal)
        self.slider.setObjectName("distance")
        self.slider.setRange(0, 1000)
        self.slider.setValue(int(self.distance.value()))
        self.slider.valueChanged.connect(lambda position: self.distance.setValue(float(position)))
        self.rows.addRow(translate("Tapeline", "Half-width"), self.distance)
        self.rows.addRow("", self.slider)
        self.lines = QtGui.QLineEdit(", ".join(now.get("roi_lines", [])))
        self.lines.setPlaceholderText(translate("Tapeline", "numbers, e.g. 1, 3"))
        self.lines.setToolTip(translate("Tapeline", "Feature lines that bound the region, instead of a distance"))
        self.rows.addRow(translate("Tapeline", "Or by lines"), self.lines)
        self.faces = QtGui.QLineEdit(", ".join(map(str, now.get("roi_faces", []))))
        self.faces.setPlaceholderText(translate("Tapeline", "numbers, e.g. 4"))
        self.faces.setToolTip(translate("Tapeline", "CAD faces that make up the region, instead of a distance"))
        self.rows.addRow(translate("Tapeline", "Or by faces"), self.faces)
        self.borders = QtGui.QCheckBox(translate("Tapeline", "open borders may move"))
        self.borders.setChecked(bool(now.get("free_borders", False)))
        self.rows.addRow(self.borders)
        self.pin = QtGui.QPushButton(translate("Tapeline", "Pin"))
        self.protect = QtGui.QPushButton(translate("Tapeline", "Protect"))
        for push, tip in ((self.pin, translate("Tapeline", "Click vertices in the 3D view that shall stay")),
                          (self.protect, translate("Tapeline", "Click CAD faces in the 3D view that shall stay"))):
            push.setCheckable(True)
            push.setMinimumWidth(40)
            push.setToolTip(tip)
        self.pin.toggled.connect(lambda on: self.protect.setChecked(False) if on else None)
        self.protect.toggled.connect(lambda on: self.pin.setChecked(False) if on else None)
        self.rows.addRow(row(self.pin, self.protect, button(translate("Tapeline", "None"), self._release,
                                                            translate("Tapeline", "Lets all of them go again"))))
        self.distance.valueChanged.connect(lambda *_: self._distance_changed())
        for signal in (self.lines.editingFinished, self.faces.editingFinished):
            signal.connect(self.update)
        self.borders.toggled.connect(lambda *_: self.update())

    def _distance_changed(self):
        self.slider.blockSignals(True)
        self.slider.setValue(int(self.distance.value()))
        self.slider.blockSignals(False)
        self._update_quickly()

    def keys(self):
        """The fields as region keys; raises a sentence about what is no number."""
        words = [word.strip() for word in self.lines.text().split(",") if word.strip()]
        keys = {"roi_distance": self.distance.value(), "roi_lines": words,
                "roi_faces": [int(n) for n in curves.parse_law(self.faces.text())],
                "free_borders": self.borders.isChecked(), "fixed_vertices": sorted(self.fixed),
                "fixed_faces": sorted(self.protected)}
        return {key: value for key, value in keys.items() if value}

    def order(self):
        """What would be moved; raises a sentence about a field."""
        return solving.Order(self.source, self.target.Line, curves.curve_of(self.target).to_json(),
                             properties.keys(self.target, ["lines"]), self.keys())

    def update(self):
        """The region as a move would choose it, on triangles made even for it."""
        try:
            order = self.order()
        except engine.errors() as error:
            self.say(str(error), bad=True)
            return
        self.compute(lambda progress, cancel: (order.place(progress, cancel), order.model()), self._show)

    def _update_quickly(self):
        """While the slider moves: the band on the triangles that are there; the exact one follows."""
        self._rest.start(settings.rest_delay())
        if self.shown is None or self.fixed:
            return
        shown, curve, keys = self.shown, curves.curve_of(self.target), self.keys()
        self.compute(lambda progress, cancel: shown.model.region(shown.line, curve, remesh="off", **keys),
                     self._tint)

    def _show(self, made):
        self.shown, self.engine_model = made
        self.picker.set_surface(self.engine_model.vertices, self.engine_model.faces)
        self._tint(self.shown)

    def _tint(self, region):
        faces = np.asarray(region.model.faces)
        classes = np.zeros(len(faces), dtype=np.int32)
        classes[np.asarray(region.faces)] = 1
        fixed = np.zeros(len(region.model.vertices), dtype=bool)
        fixed[np.asarray(region.fixed)] = True
        classes[(classes == 1) & fixed[faces].any(axis=1)] = 2
        self.overlay.show(region.model.vertices, faces)
        self.overlay.colour_faces(classes, [colours.OUTSIDE, colours.REGION, colours.FIXED])
        text = translate("Tapeline", "{} vertices and {} triangles may move (green); red triangles touch what stays.")
        self.say(text.format(len(region.vertices), len(region.faces)))

    def _picked(self, face, vertex):
        """A click on the surface: pins the vertex, or protects the CAD face, or lets it go again."""
        if self.pin.isChecked():
            self.fixed ^= {int(vertex)}
        elif self.protect.isChecked():
            number_of_face = int(self.engine_model.face_ids[face])
            if number_of_face < 0:
                self.say(translate("Tapeline", "This model has no CAD faces; pin vertices instead."), bad=True)
                return True
            self.protected ^= {number_of_face}
        else:
            return False
        self.update()
        return True

    def _release(self):
        self.fixed.clear()
        self.protected.clear()
        self.update()

    def leave(self):
        self._rest.stop()
        super().leave()

    def apply(self):
        keys = self.keys()
        everything = {"roi_distance": 0, "roi_lines": [], "roi_faces": [], "free_borders": False,
                      "fixed_vertices": [], "fixed_faces": [], **keys}
        with api.transaction(self.document, self.title):
            if self.region is None:
                self.region = regions.create_region(self.document, self.target)
            properties.assign(self.region, everything)
            api.computed(self.region)
        Gui.Selection.clearSelection()
