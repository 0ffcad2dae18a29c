# SPDX-License-Identifier: GPL-3.0-or-later
"""Panel of Export."""
import os

from PySide import QtGui

from .. import engine, jobs, solving, worker
from ..text import QT_TRANSLATE_NOOP, inform, translate
from .base import Panel, button, default_name, row, slim
from .files import ask_save_name


class ExportPanel(Panel):
    title = QT_TRANSLATE_NOOP("Tapeline", "Export")
    icon_name = "export"

    def __init__(self, move):
        super().__init__(move.Document)
        self.move = move
        self.path = self._file(translate("Tapeline", "Surface"), default_name(move, ".obj"),
                               translate("Tapeline", "Meshes (*.obj *.stl *.ply *.off)"), ".obj")
        self.path.setObjectName("path")
        self.report = self._file(translate("Tapeline", "Report page"), default_name(move, ".html"),
                                 translate("Tapeline", "Pages (*.html)"), ".html")
        self.report.setObjectName("report")
        self.text = QtGui.QCheckBox(translate("Tapeline", "STL and PLY as text"))
        self.rows.addRow(self.text)
        self.say(translate("Tapeline", "The ending says the format: .obj, .stl, .ply or .off. OBJ and PLY keep every "
                           "digit; STL holds single precision when it is binary. Leave a field empty to skip it."))

    def _file(self, label, name, pattern, ending):
        line = QtGui.QLineEdit()

        def browse():
            path = ask_save_name(self.heading, name, pattern, ending)
            if path:
                line.setText(path)

        self.rows.addRow(QtGui.QLabel(label))
        self.rows.addRow(row(line, slim(button("…", browse, translate("Tapeline", "Choose a file")))))
        return line

    def apply(self):
        path, report = self.path.text().strip(), self.report.text().strip()
        if not path and not report:
            raise engine.UserError(translate("Tapeline", "Name a file for the surface, for the report, or both."))
        for name in filter(None, (path, report)):
            folder = os.path.dirname(os.path.abspath(name))
            if not os.path.isdir(folder):
                raise engine.UserError(translate("Tapeline", "There is no folder '{}'.").format(folder))
        if path:
            jobs.write_result(self.move, path, self.text.isChecked())
            inform(translate("Tapeline", "wrote {}").format(path))
        if report:
            order = solving.order_of(self.move)

            def work(progress, cancel):
                order.solve(progress, cancel).write(report=report, progress=progress, cancel=cancel)

            worker.run(work, translate("Tapeline", "Writing the report"))
            inform(translate("Tapeline", "wrote {}").format(report))
