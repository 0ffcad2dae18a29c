# SPDX-License-Identifier: GPL-3.0-or-later
"""Panel of Region: what may follow, tinted as it changes; lines, faces and vertices are chosen by clicks or numbers."""
import FreeCADGui as Gui
import numpy as np
from PySide import QtCore, QtGui

from .. import api, curves, engine, models, properties, session, settings, solving
from ..objects import kind_of, line_set
from ..objects import region as regions
from ..scene import colours
from ..scene.line_preview import LinePreview
from ..scene.overlay import SurfaceOverlay
from ..scene.picking import SurfacePicker
from ..text import QT_TRANSLATE_NOOP, translate
from .base import Panel, SavedVisibility, automatic, button, combo, number

PIN, PROTECT, BOUND, INSIDE, KEEP, HOLD = "pin", "protect", "bound", "inside", "keep", "hold"
LINE_ROLES = {"roi_lines": colours.BOUNDING, "keep": colours.KEPT, "hold": colours.HELD}
ROLE_OF_MODE = {BOUND: "roi_lines", KEEP: "keep", HOLD: "hold"}


class RegionPanel(Panel):
    title = QT_TRANSLATE_NOOP("Tapeline", "Region")
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
        self.drawn_lines = self.decorate(LinePreview(self.view))
        self.decorate(SavedVisibility(self.target.Model, *[obj for obj in self.target.Model.InList
                                                           if kind_of(obj) == "lines"]))
        self.shown = None  # the region shown, whose even triangles serve for quick answers
        self.lines = []    # the model's feature lines
        self._rest = QtCore.QTimer(self.form)
        self._rest.setSingleShot(True)
        self._rest.timeout.connect(self.update)
        self.picker = self.decorate(SurfacePicker(self.view, self._picked))
        self.update()

    # The form.

    def _build(self, now):
        self.distance = number(now.get("roi_distance", 0), 0, 1e5, 1, " mm", 10)
        self.distance.setSpecialValueText(automatic())
        self.slider = QtGui.QSlider(QtCore.Qt.Horizontal)
        self.slider.setObjectName("distance")
        self.slider.setRange(0, 1000)
        self.slider.setValue(int(self.distance.value()))
        self.slider.valueChanged.connect(lambda position: self.distance.setValue(float(position)))
        self.rows.addRow(translate("Tapeline", "Half-width"), self.distance)
        self.rows.addRow("", self.slider)
        numbers = translate("Tapeline", "e.g. 1, 3")
        self.fields = {}
        for key, text, hint, tip in (
                ("roi_lines", translate("Tapeline", "Or by lines"), numbers,
                 translate("Tapeline", "Feature lines that bound the region, instead of a distance")),
                ("roi_faces", translate("Tapeline", "Or by faces"), numbers,
                 translate("Tapeline", "CAD faces that make up the region, instead of a distance")),
                ("roi_box", translate("Tapeline", "Or by a box"),
                 translate("Tapeline", "x, y, z from; x, y, z to (mm)"),
                 translate("Tapeline", "A box along the axes that holds the region, instead of a distance: smallest x, "
                           "y, z, then largest x, y, z in mm")),
                ("keep", translate("Tapeline", "Keep lines"), numbers,
                 translate("Tapeline", "Other lines that stay lines where the surface makes room: their vertices slide "
                           "along them")),
                ("hold", translate("Tapeline", "Hold lines"), numbers,
                 translate("Tapeline", "Other lines whose vertices stay where they are"))):
            self._add_field(key, text, hint, tip, now.get(key, []))
        self._said = [field.text() for field in self.fields.values()]
        self.borders = QtGui.QCheckBox(translate("Tapeline", "open borders may move"))
        self.borders.setChecked(bool(now.get("free_borders", False)))
        self.rows.addRow(self.borders)
        self._build_clicks()
        self.distance.valueChanged.connect(lambda *_: self._distance_changed())
        self.borders.toggled.connect(lambda *_: self.update())

    def _add_field(self, key, text, hint, tip, values):
        field = QtGui.QLineEdit(", ".join(f"{v:.12g}" if isinstance(v, float) else str(v) for v in values))
        field.setObjectName(key)
        field.setPlaceholderText(hint)
        field.setToolTip(tip)
        field.editingFinished.connect(self._field_changed)
        label = QtGui.QLabel((colours.swatch(LINE_ROLES[key]) if key in LINE_ROLES else "") + text)
        label.setToolTip(tip)
        self.rows.addRow(label, field)
        self.fields[key] = field

    def _build_clicks(self):
        self.mode = combo([("", translate("Tapeline", "turns the view")),
                           (PIN, translate("Tapeline", "pins a vertex")),
                           (PROTECT, translate("Tapeline", "protects a face")),
                           (INSIDE, translate("Tapeline", "adds a face")),
                           (BOUND, translate("Tapeline", "bounds by a line")),
                           (KEEP, translate("Tapeline", "keeps a line")),
                           (HOLD, translate("Tapeline", "holds a line"))])
        self.mode.setObjectName("mode")
        self.mode.setToolTip(translate("Tapeline", "What a click in the 3D view does; a second click on the same thing "
                                       "takes it back"))
        self.rows.addRow(translate("Tapeline", "A click"), self.mode)
        self.stays = QtGui.QLabel()
        self.stays.setWordWrap(True)
        self.rows.addRow(self.stays, button(translate("Tapeline", "Let go"), self._release,
                                            translate("Tapeline", "Lets all pinned vertices and protected faces move "
                                                      "again")))
        self._describe_stays()

    def _describe_stays(self):
        self.stays.setText(translate("Tapeline", "Pinned: {}, protected: {}")
                           .format(len(self.fixed), len(self.protected)))

    # The fields' values.

    def _words(self, key):
        return [word.strip() for word in self.fields[key].text().replace(";", ",").split(",") if word.strip()]

    def _numbers(self, key):
        try:
            return [int(word) for word in self._words(key)]
        except ValueError:
            raise engine.UserError(translate("Tapeline", "'{}' are no numbers of CAD faces; write them as in 4, 7.")
                                   .format(self.fields[key].text())) from None

    def everything(self):
        """All fields as region keys; raises a sentence about what is no number."""
        return {"roi_distance": self.distance.value(), "roi_lines": self._words("roi_lines"),
                "roi_faces": self._numbers("roi_faces"),
                "roi_box": curves.parse_law(self.fields["roi_box"].text()),
                "free_borders": self.borders.isChecked(), "fixed_vertices": sorted(self.fixed),
                "fixed_faces": sorted(self.protected), "keep": self._words("keep"), "hold": self._words("hold")}

    def order(self):
        """What would be moved; raises a sentence about a field."""
        keys = {key: value for key, value in self.everything().items() if value}
        return solving.Order(self.source, self.target.Line, curves.curve_of(self.target).to_json(),
                             properties.keys(self.target, ["lines"]), keys)

    # What happens.

    def _distance_changed(self):
        self.slider.blockSignals(True)
        self.slider.setValue(int(self.distance.value()))
        self.slider.blockSignals(False)
        self._update_quickly()

    def _field_changed(self):
        """A field that merely loses the focus is no reason to compute."""
        said = [field.text() for field in self.fields.values()]
        if said != self._said:
            self._said = said
            self.update()

    def update(self):
        """The region as a move would choose it, on triangles made even for it."""
        try:
            order = self.order()
        except engine.errors() as error:
            self.say(str(error), bad=True)
            return

        def work(progress, cancel):
            model = order.model()
            return order.place(progress, cancel), model, model.feature_lines(**order.line_keys)

        self.compute(work, self._show)

    def _update_quickly(self):
        """While the slider moves: the band on the triangles that are there; the exact one follows. Vertices and lines
        go by the numbers of the model before these triangles, so with them only the exact one comes."""
        self._rest.start(settings.rest_delay())
        if self.shown is None or self.fixed or any(self._words(key) for key in LINE_ROLES):
            return
        try:
            shown, order = self.shown, self.order()
        except engine.errors() as error:
            self.say(str(error), bad=True)
            return
        self.compute(lambda progress, cancel: shown.model.region(shown.line, order.target(), remesh="off",
                                                                 **order.keys), self._tint)

    def _show(self, made):
        self.shown, self.engine_model, self.lines = made
        self.picker.set_surface(self.engine_model.vertices, self.engine_model.faces)
        self.drawn_lines.show([(str(line.id), line_set.closed_points(line)) for line in self.lines])
        self._paint_lines()
        self._tint(self.shown)

    def _paint_lines(self):
        self.drawn_lines.paint({int(word): colour for key, colour in LINE_ROLES.items() for word in self._words(key)
                                if word.isdigit()})

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
        self.say("\n".join([text.format(len(region.vertices), len(region.faces))] + list(region.warnings)))

    # Clicks.

    def _picked(self, place):
        mode = self.mode.currentData()
        if mode in ROLE_OF_MODE:
            return self._picked_line(place, ROLE_OF_MODE[mode])
        return bool(mode) and self._picked_surface(place, mode)

    def _picked_line(self, place, role):
        moving = self.target.Line.partition("@")[0].strip()
        others = [line for line in self.lines if str(line.id) != moving]
        index = place.line([np.asarray(line_set.closed_points(line)) for line in others])
        if index < 0:
            return False
        self._toggle(role, str(others[index].id))
        self._paint_lines()
        self.update()
        return True

    def _picked_surface(self, place, mode):
        face, vertex = place.face_and_vertex()
        if face < 0:
            return False
        number_of_face = int(self.engine_model.face_ids[face])
        if mode == PIN:
            self.fixed ^= {vertex}
        elif number_of_face < 0:
            self.say(translate("Tapeline", "This model has no CAD faces; pin vertices instead."), bad=True)
            return True
        elif mode == PROTECT:
            self.protected ^= {number_of_face}
        else:
            self._toggle("roi_faces", str(number_of_face))
        self._describe_stays()
        self.update()
        return True

    def _toggle(self, key, word):
        words = self._words(key)
        words = [w for w in words if w != word] if word in words else words + [word]
        self.fields[key].setText(", ".join(words))
        self._said = [field.text() for field in self.fields.values()]

    def _release(self):
        self.fixed.clear()
        self.protected.clear()
        self._describe_stays()
        self.update()

    # Leaving.

    def leave(self):
        self._rest.stop()
        super().leave()

    def apply(self):
        everything = self.everything()
        with api.transaction(self.document, self.heading):
            if self.region is None:
                self.region = regions.create_region(self.document, self.target)
            properties.assign(self.region, everything)
            api.computed(self.region)
        session.warm(solving.order_for(self.target, self.region))
        Gui.Selection.clearSelection()
