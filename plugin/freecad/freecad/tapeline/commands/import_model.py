# SPDX-License-Identifier: GPL-3.0-or-later
"""Import styling model: a CAD or mesh file through our own tessellation, or an object of the document."""
from ..text import QT_TRANSLATE_NOOP
from . import selection
from .base import Command


class ImportModel(Command):
    name = "Tapeline_ImportModel"
    icon_name = "import"
    menu_text = QT_TRANSLATE_NOOP("Tapeline_ImportModel", "Import styling model…")
    tooltip = QT_TRANSLATE_NOOP("Tapeline_ImportModel",
                                "Reads a STEP, IGES, BREP, STL, OBJ, PLY or OFF file, or takes the selected Part or "
                                "Mesh object, as the model whose lines are moved")
    needs_document = False

    def open(self):
        from ..panels.import_model import ImportPanel

        self.show(ImportPanel(selection.foreign_model()))
