# SPDX-License-Identifier: GPL-3.0-or-later
"""Panel of Import styling model."""
import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtGui

from .. import api, engine, properties
from ..objects.model import CAD_ENDINGS, MESH_ENDINGS
from ..text import QT_TRANSLATE_NOOP, translate
from .base import Panel, automatic, button, combo, number, row, slim, wrapped
from .files import ask_open_name


def _option(name):
    return next(option for option in properties.table(["import"]) if option["name"] == name)


class ImportPanel(Panel):
    title = QT_TRANSLATE_NOOP("Tapeline", "Import styling model")
    icon_name = "import"

    def __init__(self, source=None):
        super().__init__(App.ActiveDocument)
        self.source = source
        self.path = QtGui.QLineEdit()
        self.path.setObjectName("path")
        self.path.setPlaceholderText(translate("Tapeline", "STEP, IGES, BREP, STL, OBJ, PLY or OFF"))
        if source is None:
            self.rows.addRow(QtGui.QLabel(translate("Tapeline", "File")))
            self.rows.addRow(row(self.path, slim(button("…", self._browse, translate("Tapeline", "Choose a file")))))
        else:
            self.rows.addRow(translate("Tapeline", "Object"), wrapped(source.Label))
        units = _option("units")
        self.units = combo(units["choices"], units["default"])
        self.units.setToolTip(units["help"])
        self.rows.addRow(translate("Tapeline", "Unit of mesh files"), self.units)
        self.deflection = self._number("linear_deflection", translate("Tapeline", "Largest deviation"), " mm")
        self.angle = self._number("angular_deflection", translate("Tapeline", "Largest angle"), " °")
        self.sewing = self._number("sew_tolerance", translate("Tapeline", "Close gaps up to"), " mm")
        self.say(translate("Tapeline", "CAD files carry their own unit; lengths are mm in the document. The deviation "
                           "and the angle say how fine a CAD model is divided into triangles."))

    def _number(self, name, label, suffix):
        option = _option(name)
        box = number(option["default"], option["minimum"], option.get("maximum") or 1e6, 4, suffix)
        if option.get("zero"):
            box.setSpecialValueText(automatic())
        box.setToolTip(properties.tooltip(option))
        self.rows.addRow(label, box)
        return box

    def _browse(self):
        endings = " ".join("*" + ending + " *" + ending.upper() for ending in CAD_ENDINGS + MESH_ENDINGS)
        path = ask_open_name(self.heading, translate("Tapeline", "Models ({})").format(endings))
        if path:
            self.path.setText(path)

    def apply(self):
        source = self.source if self.source is not None else self.path.text().strip()
        if not source:
            raise engine.UserError(translate("Tapeline", "Choose a model file first."))
        keys = {"units": self.units.currentData(), "linear_deflection": self.deflection.value(),
                "angular_deflection": self.angle.value(), "sew_tolerance": self.sewing.value()}
        self.model = api.import_model(source, self.document, **keys)
        if self.source is not None:
            self.source.ViewObject.Visibility = False
        Gui.Selection.clearSelection()
        view = Gui.getDocument(self.model.Document.Name).activeView()
        view.viewIsometric()
        view.fitAll()
