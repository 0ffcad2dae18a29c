# SPDX-License-Identifier: GPL-3.0-or-later
"""Export: the moved surface with all its digits, and the report page."""
from ..text import QT_TRANSLATE_NOOP
from . import selection
from .base import Command


class Export(Command):
    name = "Tapeline_Export"
    icon_name = "export"
    menu_text = QT_TRANSLATE_NOOP("Tapeline_Export", "Export…")
    tooltip = QT_TRANSLATE_NOOP("Tapeline_Export",
                                "Writes the moved surface as STL, OBJ, PLY or OFF in full precision, and a page with "
                                "its measures and pictures")

    def open(self):
        from ..panels.export import ExportPanel

        self.show(ExportPanel(selection.required("move")))
