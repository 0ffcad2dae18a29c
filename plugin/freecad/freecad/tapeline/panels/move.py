# SPDX-License-Identifier: GPL-3.0-or-later
"""Panel of Move feature line: drag, watch surface and measures follow, overrule the verdict, apply."""
import time

import FreeCADGui as Gui
import numpy as np
from PySide import QtCore, QtGui

from .. import api, arrays, models, properties, session, settings, solving, worker
from ..objects import kind_of
from ..objects import move as moves
from ..objects import target as targets
from ..scene import colours
from ..scene.overlay import SurfaceOverlay
from ..session import MoveSession
from ..text import QT_TRANSLATE_NOOP, sentence_of, translate
from .base import Panel, SavedVisibility, automatic, button, buttons, choice_box, number, row, wrapped
from .curve_editing import CurveEditing, mode_box, prepared
from .strip import QualityStrip

PATIENCE = 5  # times the budget, for a preview that measures


class MovePanel(Panel):
    title = QT_TRANSLATE_NOOP("Tapeline", "Move feature line")
    icon_name = "move"

    def __init__(self, target=None, region=None, move=None):
        self.move = move
        self.target = move.Target if move is not None else target
        self.region = move.Region if move is not None else region
        super().__init__(self.target.Document)
        self.ours = solving.is_target(self.target)
        self.model = move.Model if move is not None else self.target.Model
        self.order = self._order_of_document()
        self.session = MoveSession()
        self.solver = worker.Latest(self.form)
        self.preparer = worker.Latest(self.form)
        for background in (self.solver, self.preparer):
            background.on_progress = self.show_progress
        self.result = None
        self.applied = False
        self.refusal = ""       # why the move cannot be prepared
        self.following = False  # previews have begun
        self.latency = None     # of the last preview [s]
        self._patient = False
        self.dragged = False  # since the panel opened
        self.overlay = self.decorate(SurfaceOverlay(self.view))
        self.decorate(SavedVisibility(self.model, self.target, move))
        self.editing = self.decorate(CurveEditing(self.view, self._dragged, self._released))
        self._rest = QtCore.QTimer(self.form)
        self._rest.setSingleShot(True)
        self._rest.timeout.connect(self.solve_exactly)
        self._build()
        self._open()

    def _order_of_document(self):
        if self.move is not None:
            return solving.order_of(self.move)
        return solving.order_for(self.target, self.region)

    # The form.

    def _build(self):
        keys = self.order.keys
        self.verdict = QtGui.QLabel("…")
        self.verdict.setObjectName("verdict")
        self.verdict.setWordWrap(True)
        self.rows.addRow(self.verdict)
        self.boxes = {}
        for name, label in (("placement", translate("Tapeline", "The line lies")),
                            ("compressed_side", translate("Tapeline", "Gives way")),
                            ("crease", translate("Tapeline", "Crease angle")),
                            ("method", translate("Tapeline", "Method"))):
            option = properties.option(name)
            box = choice_box(option, keys.get(name))
            box.setToolTip(properties.tooltip(option))
            box.currentIndexChanged.connect(lambda *_: self._options_changed())
            self.boxes[name] = box
            self.rows.addRow(label, box)
        self.distance = number(keys.get("roi_distance", 0), 0, 1e5, 1, " mm", 10)
        self.distance.setSpecialValueText(automatic())
        self.distance.valueChanged.connect(lambda *_: self._options_changed())
        if self.region is None:
            self.rows.addRow(translate("Tapeline", "Half-width"), self.distance)
        else:
            self.rows.addRow(translate("Tapeline", "Region"), wrapped(self.region.Label))
        if self.ours:
            self.rows.addRow(translate("Tapeline", "Drags go"), mode_box(self.editing))
        self.tint = QtGui.QCheckBox(translate("Tapeline", "tint the two sides"))
        self.tint.setToolTip(translate("Tapeline", "Blue is stretched, orange gives way"))
        self.tint.setChecked(True)
        self.tint.toggled.connect(lambda *_: self._paint())
        self.rows.addRow(self.tint)
        self.strip = QualityStrip()
        self.column.insertWidget(1, self.strip)
        self.stop = button(translate("Tapeline", "Stop"), self._stop)
        self.rows.addRow(row(button(translate("Tapeline", "Undo dragging"), self._reset), self.stop))

    def getStandardButtons(self):  # noqa: N802 (FreeCAD's name)
        return buttons(QtGui.QDialogButtonBox.Apply | QtGui.QDialogButtonBox.Cancel)

    def clicked(self, which):
        if buttons(which) == buttons(QtGui.QDialogButtonBox.Apply):
            self.accept()

    def _options(self):
        """The options as the boxes say them; None for those at their default."""
        chosen = {name: box.currentData() for name, box in self.boxes.items()}
        keys = {name: None if value == properties.option(name)["default"] else value for name, value in chosen.items()}
        if self.region is None:
            keys["roi_distance"] = self.distance.value() or None
        return keys

    def preview_order(self):
        """What a preview answers: the curve as it is dragged, which laying it on the surface changes but little."""
        curve = self.editing.curve.to_json() if self.dragged else self.order.curve
        return self.order.with_curve(curve, **self._options())

    def exact_order(self):
        """A function that makes the order of the exact result, in any thread: the curve is finished first, just as the
        target line object does it."""
        order, options = self.order, self._options()
        if not self.dragged:
            made = order.with_curve(order.curve, **options)
            return lambda *_: made
        recipe, curve = self.recipe, self.editing.curve
        return lambda *watched: order.with_curve(
            targets.finished(order.source, recipe, curve, *watched).to_json(), **options)

    # What happens.

    def _open(self):
        source = self.order.source
        self._prepare()
        if self.ours:
            self.recipe = targets.recipe_of(self.target)
            self.offsets = self.recipe.offsets
            self.say(translate("Tapeline", "Reading the model…"))
            self.compute(prepared(source, self.recipe), self._opened)
        else:
            self.offsets = None
            self.compute(lambda progress, cancel: models.load(source), lambda model: self._start())

    def _opened(self, made):
        self.editing.normals, base = made
        self.editing.start(base, self.offsets)
        self._start()

    def _start(self):
        self.say(translate("Tapeline", "Drag the yellow points; the surface follows.") if self.ours else "")
        self.following = True
        self._preview()

    def _options_changed(self):
        """Another option: the verdict and the surface come again."""
        self.solver.drop()
        self.result = None
        self._prepare()
        self._preview()

    def _prepare(self):
        """Makes good previews possible, in the background; coarse ones do until then."""
        order, maker = self.order.with_curve(self.order.curve, **self._options()), self.session
        self.refusal = ""
        if session.is_warm(order):
            self.preparer.drop()
        else:
            self.preparer.ask(lambda progress, cancel: maker.prepare(order, progress, cancel), self._prepared,
                              self._not_prepared)

    def _prepared(self, _):
        self.progress.hide()
        if self.following and self.result is None:
            self._preview()

    def _not_prepared(self, error):
        """The move would be refused; a coarse preview that is shown all the same does not hide why."""
        if not worker.cancelled(error):
            self.refusal = sentence_of(error)
        self.failed(error)

    def _show_verdict(self, placement):
        side = {"left": translate("Tapeline", "left"), "right": translate("Tapeline", "right")}.get(
            placement["compressed_side"], "")
        off = 100 * placement["off_fraction"]
        if placement["verdict"] == "on_surface":
            text = translate("Tapeline", "on the surface; the {} side gives way ({:.0f} % of the line off it)")
            self.verdict.setText(text.format(side, off))
        else:
            text = translate("Tapeline", "off the surface ({:.0f} % of the line); both sides bend")
            self.verdict.setText(text.format(off))

    def _paint(self):
        """Tints the two sides, or not."""
        if not self.tint.isChecked() or getattr(self, "faces_of_sides", None) is None or self.overlay.count == 0:
            self.overlay.plain()
            return
        classes = np.zeros(self.overlay.count, dtype=np.int32)
        for number_of_side, faces in enumerate(self.faces_of_sides, 1):
            classes[faces[faces < len(classes)]] = number_of_side
        self.overlay.colour_faces(classes, [colours.OUTSIDE, colours.TENSION, colours.COMPRESSION])

    def _dragged(self, curve):
        self.dragged = True
        self._rest.stop()
        self.solver.drop()
        self.result = None
        self.say(translate("Tapeline", "Following…"))
        self._preview()

    def _preview(self, patience=1):
        """Asks for a preview; with patience it may take longer, to lay the line on the surface and to measure, and
        gives way to the next drag."""
        order, maker, budget = self.preview_order(), self.session, patience * settings.preview_budget()
        lay = patience > 1 and self._to_be_laid()

        def work(progress, cancel):
            asked = targets.laid_quickly(order, cancel) if lay else order
            return maker.preview(asked, budget, patience > 1, progress, cancel)

        self._asked = time.monotonic()
        self.compute(work, self._previewed, interrupt=self._patient)
        self._patient = patience > 1

    def _to_be_laid(self):
        """Whether the dragged curve is yet to be laid on the surface, off which its measures would be wrong."""
        return self.dragged and self.recipe.on_surface

    def _previewed(self, made):
        preview, fine = made
        self.latency = time.monotonic() - self._asked
        self.faces_of_sides = (np.asarray(preview.tension_faces), np.asarray(preview.compression_faces))
        self.overlay.show(preview.vertices, preview.faces)
        self._paint()
        self._show_verdict(preview.placement)
        ready = fine or session.is_warm(self.preview_order())
        self.say(self.refusal or (
            translate("Tapeline", "Preview; the exact surface comes when the mouse rests.") if ready else
            translate("Tapeline", "Preparing… The preview is coarse until finer triangles are ready.")),
            bad=bool(self.refusal))
        self._rest.start(settings.rest_delay())
        measures = solving.strip_of(preview.measures)
        measured = fine and any(value is not None for value in measures.values())
        if measured and (self._patient or not self._to_be_laid()):
            self.strip.show_measures(measures)
            return
        self.strip.mark_old()
        if ready and not self._patient and not self.background.busy:
            self._preview(PATIENCE)

    def _released(self):
        self._rest.start(settings.rest_delay())

    def _exactly(self):
        """Work that returns the exact order and its result."""
        make, maker = self.exact_order(), self.session

        def work(progress, cancel):
            order = make(progress, cancel)
            return order, maker.solve(order, progress, cancel)

        return work

    def solve_exactly(self):
        """The exact result, in the background."""
        self.solver.ask(self._exactly(), self._solved, self._not_solved)

    def _solved(self, made):
        order, result = made
        self.progress.hide()
        self.result = made
        self.faces_of_sides = (np.asarray(result.tension_faces), np.asarray(result.compression_faces))
        self.overlay.show(result.vertices, result.faces)
        self._paint()
        self._show_verdict(result.stats["placement"])
        self.strip.show_measures(solving.strip_of(result.measures))
        self.say("\n".join([translate("Tapeline", "Exact.")] + list(result.warnings)))

    def _not_solved(self, error):
        self.progress.hide()
        self.strip.show_measures({})
        self.failed(error)

    def _stop(self):
        for background in (self.background, self.solver, self.preparer):
            background.drop()
        self._rest.stop()
        self.progress.hide()
        self.say(translate("Tapeline", "Stopped; drag a point or apply to compute again."))

    def _reset(self):
        if self.ours and self.editing.base is not None:
            self.editing.start(self.editing.base, self.offsets)
            self._dragged(self.editing.curve)

    # Leaving.

    def apply(self):
        self._stop()
        # Without a result yet, it is computed now, behind a dialog.
        order, result = self.result or worker.run(self._exactly(), self.heading)
        with api.transaction(self.document, self.heading):
            self._store(order, result)
        self.applied = True
        Gui.Selection.clearSelection()

    def _store(self, order, result):
        """Changes the target, makes or changes the move, and gives it the result, so that nothing is solved twice."""
        if self.dragged:
            self.target.Offsets = arrays.vectors(self.editing.offsets) if self.editing.moved_by_hand else []
            api.computed(self.target)
        if self.move is None:
            self.move = moves.create_move(self.document, self.target, self.region)
        for name, box in self.boxes.items():
            properties.assign(self.move, {name: box.currentData()})
        if self.region is None:
            properties.assign(self.move, {"roi_distance": self.distance.value()})
        own = solving.order_of(self.move)
        if own.digest == order.digest:
            moves.adopt(self.move, own, result)
        api.computed(self.move)

    def leave(self):
        self._rest.stop()
        self.solver.close()
        self.preparer.close()
        super().leave()
        if self.applied:
            for obj in [self.model, self.target] + [obj for obj in self.model.InList if kind_of(obj) == "lines"]:
                obj.ViewObject.Visibility = False
            self.move.ViewObject.Visibility = True
