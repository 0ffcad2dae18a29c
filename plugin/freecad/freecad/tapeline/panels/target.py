# SPDX-License-Identifier: GPL-3.0-or-later
"""Panel of Target line: line and part, fit or curve, slide, handles, fairing, laying on the surface."""
import FreeCADGui as Gui
from PySide import QtGui

from .. import api, arrays, curves, models, properties, session, solving
from ..objects import target as targets
from ..text import QT_TRANSLATE_NOOP, translate
from .base import Panel, SavedVisibility, automatic, button, combo, number, row, whole
from .curve_editing import CurveEditing, mode_box, prepared


HANDY = 20  # control points that a hand can do something with


class TargetPanel(Panel):
    title = QT_TRANSLATE_NOOP("Tapeline", "Target line")
    icon_name = "target"

    def __init__(self, model=None, lines=None, number=0, curve=None, target=None):
        self.target = target
        self.model = target.Model if target is not None else model
        super().__init__(self.model.Document)
        self.source = models.source_of(self.model)
        self.line_keys = properties.keys(target or lines, ["lines"]) if (target or lines) else {}
        self.linked = curve
        if target is not None and target.Origin == targets.LINKED:
            self.linked = target.LinkedCurve
        self.editing = self.decorate(CurveEditing(self.view, self._dragged, self._finish))
        if target is not None:
            self.decorate(SavedVisibility(target))
        self._build(number)
        self.offsets = arrays.from_vectors(target.Offsets) if target is not None and target.Offsets else None
        self.update()

    def _build(self, line_number):
        now, recipe = self.target, None
        if now is not None:
            recipe = targets.recipe_of(now)
        selector = recipe.line if recipe else str(line_number)
        self.line = QtGui.QLineEdit(selector)
        self.line.setObjectName("line")
        self.line.setToolTip(translate("Tapeline", "The feature line's number, or a part of it: 0@10%..85%, or "
                                       "0@120..900 in mm"))
        self.line.editingFinished.connect(self.update)
        self.rows.addRow(translate("Tapeline", "Feature line"), self.line)
        origins = [(targets.FITTED, translate("Tapeline", "fitted"))]
        if self.linked is not None:
            origins.append((targets.LINKED, translate("Tapeline", "curve of {}").format(self.linked[0].Label)))
        if now is not None and now.Stored:
            origins.append((targets.STORED, translate("Tapeline", "stored curve")))
        self.origin = combo(origins, now.Origin if now is not None else
                            (targets.LINKED if self.linked is not None else targets.FITTED))
        self.origin.currentIndexChanged.connect(lambda *_: self.update())
        self.rows.addRow(translate("Tapeline", "Starts as"), self.origin)
        keys = recipe.fit_keys if recipe else {}
        slid = bool(recipe and any(recipe.slide))
        self.fit_count = keys.get("control_points", 0) if slid else 0  # a job's, beneath the slide
        self.count = whole(keys.get("surface_points" if slid else "control_points", 0), 0, 1000, automatic())
        self.count.setObjectName("count")
        self.count.setToolTip(translate("Tapeline", "How many control points the line has; few are easier to drag"))
        self.count.valueChanged.connect(lambda *_: self.update())
        self.rows.addRow(translate("Tapeline", "Control points"), self.count)
        self.tolerance = number(keys.get("tolerance", 0), 0, 1e4, 4, " mm")
        self.tolerance.setObjectName("tolerance")
        self.tolerance.setToolTip(properties.tooltip(properties.option("tolerance")))
        self.tolerance.setSpecialValueText(automatic())
        self.tolerance.valueChanged.connect(lambda *_: self.update())
        self.rows.addRow(translate("Tapeline", "Tolerance"), self.tolerance)
        self._build_shaping(recipe)

    def _build_shaping(self, recipe):
        self.law = QtGui.QLineEdit(curves.law_text(recipe.slide) if recipe else "")
        self.law.setObjectName("law")
        self.law.setPlaceholderText(translate("Tapeline", "e.g. 20 or 0, 30, 60, 30, 0"))
        self.law.setToolTip(translate("Tapeline", "Slides the line along the surface, to its left where positive: one "
                                      "distance, or several spread evenly over its length"))
        self.law.editingFinished.connect(self.update)
        self.law.setCursorPosition(0)
        self.rows.addRow(QtGui.QLabel(translate("Tapeline", "Slide to the left (mm)")))
        self.rows.addRow(self.law)
        self.rows.addRow(translate("Tapeline", "Drags go"), mode_box(self.editing))
        self.fair = QtGui.QCheckBox(translate("Tapeline", "fair, by at most"))
        self.fair.setChecked(bool(recipe and recipe.fair))
        self.fair_limit = number(recipe.fair_limit if recipe else 0, 0, 1e4, 4, " mm")
        self.fair_limit.setSpecialValueText(automatic())
        self.rows.addRow(row(self.fair, self.fair_limit))
        self.on_surface = QtGui.QCheckBox(translate("Tapeline", "lay on the surface"))
        self.on_surface.setObjectName("on_surface")
        self.on_surface.setChecked(bool(recipe and recipe.on_surface))
        self.rows.addRow(self.on_surface)
        for signal in (self.fair.toggled, self.on_surface.toggled, self.fair_limit.valueChanged):
            signal.connect(lambda *_: self._finish())
        self.rows.addRow(row(button(translate("Tapeline", "Undo dragging"), self._reset,
                                    translate("Tapeline", "Puts the control points back"))))

    def recipe(self):
        """What the panel's fields say; may raise a sentence about the slide law or the curve."""
        recipe = targets.Recipe(line=self.line.text().strip(), line_keys=self.line_keys,
                                slide=curves.parse_law(self.law.text()), fair=self.fair.isChecked(),
                                fair_limit=self.fair_limit.value(), on_surface=self.on_surface.isChecked())
        origin = self.origin.currentData()
        if origin == targets.LINKED:
            recipe.start = curves.target_from_shape(*self.linked).to_json()
        elif origin == targets.STORED:
            recipe.start = self.target.Stored
        else:
            keys = {**self._counts(recipe.slide), "tolerance": self.tolerance.value()}
            recipe.fit_keys = {name: value for name, value in keys.items() if value}
        return recipe

    def _counts(self, law):
        """The number of control points, which the engine has one option for where a line is fitted and another where it
        is slid on."""
        slid = any(law)
        return {"control_points": self.fit_count if slid else self.count.value(),
                "surface_points": self.count.value() if slid else 0}

    def update(self):
        """Makes the curve to start from anew; moves by hand stay where the number of control points does."""
        from .. import engine

        try:
            work = prepared(self.source, self.recipe())
        except engine.errors() as error:
            self.say(str(error), bad=True)
            return
        if self.editing.moved_by_hand:
            self.offsets = self.editing.offsets
        self.compute(work, self._started)

    def _started(self, made):
        self.editing.normals, base = made
        if not self.editing.start(base, self.offsets):
            self.say(translate("Tapeline", "The number of control points changed, so their moves by hand are gone."))
        self.offsets = None
        self._finish()

    def _dragged(self, curve):
        self._describe(curve)

    def _finish(self):
        """After a drag or a change: fairing and laying on the surface, in the background."""
        if self.editing.base is None:
            return
        recipe, source, curve = self.recipe(), self.source, self.editing.curve
        if recipe.fair or recipe.on_surface:
            self.compute(lambda progress, cancel: targets.finished(source, recipe, curve, progress, cancel),
                         self._finished)
        else:
            self._finished(curve)

    def _finished(self, curve):
        import numpy as np

        handles = self.editing.handles
        handles.show(handles.points, np.asarray(curve.sample(240)))
        self._describe(curve)

    def _describe(self, curve):
        count = len(self.editing.base.control_points)
        text = translate("Tapeline", "{} control points, {:.1f} mm long. Drag the yellow points in the 3D view.")
        text = text.format(count, curve.length_mm)
        if count > HANDY:
            text += " " + translate("Tapeline", "For fewer of them, say how many; laid on the surface, the line lies "
                                    "on it all the same.")
        self.say(text)

    def _reset(self):
        self.editing.reset()
        self._finish()

    def apply(self):
        recipe = self.recipe()
        values = {"slide": recipe.slide, "fair": recipe.fair, "fair_limit": recipe.fair_limit,
                  "on_surface": recipe.on_surface, "tolerance": self.tolerance.value(), **self._counts(recipe.slide),
                  **self.line_keys}
        with api.transaction(self.document, self.heading):
            if self.target is None:
                self.target = targets.create_target(self.document, self.model, recipe.line)
            self.target.Line = recipe.line
            if self.linked is not None:
                self.target.LinkedCurve = self.linked
            self.target.Origin = self.origin.currentData()
            properties.assign(self.target, values)
            self.target.Offsets = arrays.vectors(self.editing.offsets) if self.editing.moved_by_hand else []
            api.computed(self.target)
        session.warm(solving.order_for(self.target))
        Gui.Selection.clearSelection()
