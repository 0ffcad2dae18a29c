# SPDX-License-Identifier: GPL-3.0-or-later
"""The quality strip: four numbers, each green, amber or red by the limits of the preferences."""
from PySide import QtGui

from .. import settings
from ..scene.colours import GRADES
from ..text import translate

FORMATS = {"Bulge": "{:.4f} mm", "Inflections": "{:.0f}", "CreaseAngle": "{:.2f}°", "LineError": "{:.1e} mm"}


class QualityStrip(QtGui.QWidget):
    def __init__(self):
        super().__init__()
        names = {"Bulge": translate("Tapeline", "bulge"), "Inflections": translate("Tapeline", "inflections"),
                 "CreaseAngle": translate("Tapeline", "crease change"),
                 "LineError": translate("Tapeline", "line error")}
        self.setObjectName("strip")
        grid = QtGui.QGridLayout(self)
        grid.setContentsMargins(0, 4, 0, 4)
        self._values = {}
        self.grades = {}
        for place, (name, text) in enumerate(names.items()):
            line, column = divmod(place, 2)
            grid.addWidget(QtGui.QLabel(text), 2 * line, column)
            value = QtGui.QLabel("–")
            value.setObjectName(name)
            grid.addWidget(value, 2 * line + 1, column)
            self._values[name] = value
        self.show_measures({})

    def show_measures(self, measures):
        """Measures by name; None or nothing where one was not taken."""
        for name, label in self._values.items():
            value = measures.get(name)
            grade = settings.grade(name, value)
            self.grades[name] = grade
            label.setText("–" if value is None else FORMATS[name].format(value))
            label.setStyleSheet(f"background: {GRADES[grade]}; color: white; padding: 3px; border-radius: 3px;")

    def mark_old(self):
        """The numbers belong to an earlier place of the line: what is shown now was not measured."""
        for label in self._values.values():
            if label.text() not in ("–", "") and not label.text().endswith(" …"):
                label.setText(label.text() + " …")
