# SPDX-License-Identifier: GPL-3.0-or-later
"""Panel of Check surface: overlays on the moved surface, sections with combs, the measures' table."""
import contextlib

import numpy as np
from PySide import QtCore, QtGui

from .. import settings, solving
from ..objects import kind_of
from ..scene import colours
from ..scene.overlay import SurfaceOverlay
from ..scene.sections import SectionCombs
from ..text import QT_TRANSLATE_NOOP, translate
from .base import Panel, SavedVisibility, buttons, combo

PLAIN, ZEBRA, GAUSS, MEAN, DISTANCE, MOVED = "plain", "zebra", "gauss", "mean", "distance", "displacement"


class CheckPanel(Panel):
    title = QT_TRANSLATE_NOOP("Tapeline", "Check surface")
    icon_name = "check"

    def __init__(self, move):
        super().__init__(move.Document)
        self.move = move
        self.result = None
        self.order = solving.order_of(move)
        self._build()
        self.overlay = self.decorate(SurfaceOverlay(self.view))
        self.combs = self.decorate(SectionCombs(self.view))
        self.decorate(SavedVisibility(*[obj for obj in self.document.Objects if kind_of(obj)]))
        order = self.order
        self.say(translate("Tapeline", "Measuring…"))

        def work(progress, cancel):
            result = order.solve(progress, cancel)
            return result, dict(result.maps), [dict(s) for s in result.sections()]

        self.compute(work, self._ready)

    def _build(self):
        self.overlay_box = combo([(ZEBRA, translate("Tapeline", "zebra stripes")),
                                  (GAUSS, translate("Tapeline", "Gaussian sign")),
                                  (MEAN, translate("Tapeline", "mean curvature")),
                                  (DISTANCE, translate("Tapeline", "distance to before")),
                                  (MOVED, translate("Tapeline", "displacement")),
                                  (PLAIN, translate("Tapeline", "plain"))])
        self.overlay_box.setObjectName("overlay")
        self.state_box = combo([("after", translate("Tapeline", "after the move")),
                                ("before", translate("Tapeline", "before the move"))])
        self.state_box.setObjectName("state")
        self.sections_box = QtGui.QCheckBox(translate("Tapeline", "sections with curvature combs"))
        for box in (self.overlay_box, self.state_box):
            box.currentIndexChanged.connect(lambda *_: self.paint())
        self.sections_box.toggled.connect(lambda *_: self.paint())
        self.rows.addRow(translate("Tapeline", "Show"), self.overlay_box)
        self.rows.addRow(translate("Tapeline", "Surface"), self.state_box)
        self.rows.addRow(self.sections_box)
        self.legend = QtGui.QLabel()
        self.legend.setWordWrap(True)
        self.rows.addRow(self.legend)
        self.table = QtGui.QTableWidget(0, 2)
        self.table.setObjectName("measures")
        self.table.setHorizontalHeaderLabels([translate("Tapeline", "Measure"), translate("Tapeline", "Value")])
        self.table.horizontalHeader().setSectionResizeMode(QtGui.QHeaderView.Stretch)
        self.table.verticalHeader().hide()
        self.table.setEditTriggers(QtGui.QAbstractItemView.NoEditTriggers)
        self.table.verticalHeader().setSectionResizeMode(QtGui.QHeaderView.ResizeToContents)
        self.table.setVerticalScrollBarPolicy(QtCore.Qt.ScrollBarAlwaysOff)
        self.column.insertWidget(1, self.table)

    def getStandardButtons(self):  # noqa: N802 (FreeCAD's name)
        return buttons(QtGui.QDialogButtonBox.Close)

    def _ready(self, made):
        self.result, self.maps, self.sections = made
        self._fill(self.result.table)
        self.say("\n".join(self.result.warnings))
        self.paint()

    def _fill(self, text):
        """The engine's table of measures, row by row."""
        rows = [line.rsplit("  ", 1) for line in text.splitlines() if "  " in line]
        rows = [row for row in rows if not row[0].startswith("seconds")]
        self.table.setRowCount(len(rows))
        for i, cells in enumerate(rows):
            for j, cell in enumerate(cells):
                self.table.setItem(i, j, QtGui.QTableWidgetItem(cell.strip()))
        QtCore.QTimer.singleShot(0, self._fit_table)

    def _fit_table(self):
        """As tall as its rows, once these know their height: the panel scrolls, the table in it need not."""
        with contextlib.suppress(RuntimeError):  # the panel is closed
            self._set_table_height()

    def _set_table_height(self):
        height = self.table.horizontalHeader().height() + self.table.verticalHeader().length()
        self.table.setFixedHeight(height + 2 * self.table.frameWidth())

    def paint(self):
        """Draws what the boxes say."""
        if self.result is None:
            return
        before = self.state_box.currentData() == "before"
        self.overlay.show(self.result.rest_vertices if before else self.result.vertices, self.result.faces)
        kind = self.overlay_box.currentData()
        self.overlay.stripes(kind == ZEBRA)
        legend = ""
        if kind == PLAIN:
            self.overlay.plain()
        elif kind != ZEBRA:
            values, shown, legend = self._map(kind, "before" if before else "after")
            self.overlay.colour_vertices(shown(values))
        self.legend.setText(legend)
        self.combs.show(self.sections if self.sections_box.isChecked() else [], before, settings.comb_scale())

    def _map(self, kind, state):
        """Values of a map, how they are coloured, and a sentence on the scale."""
        if kind == GAUSS:
            return (np.asarray(self.maps["gaussian_" + state]), colours.signs,
                    translate("Tapeline", "red: dome or bowl (both curvatures of one sign), blue: saddle, grey: flat "
                              "within the reading's precision"))
        if kind == MEAN:
            values = np.asarray(self.maps["mean_" + state])
            scale = colours.scale_of(np.concatenate([np.asarray(self.maps["mean_" + s]) for s in ("before", "after")]),
                                     95)
            return (values, lambda v: colours.diverging(v, scale),
                    translate("Tapeline", "blue to red: -{0:.2g} to {0:.2g} per mm").format(scale))
        if kind == DISTANCE:
            values = np.asarray(self.maps["distance_to_original"])
            scale = colours.scale_of(values, 100)
            return (values, lambda v: colours.diverging(v, scale),
                    translate("Tapeline", "blue (below) to red (above): {:.4g} mm").format(scale))
        values = np.asarray(self.maps["displacement"])
        scale = colours.scale_of(values, 100)
        return values, lambda v: colours.rising(v, scale), translate("Tapeline", "up to {:.4g} mm").format(scale)
