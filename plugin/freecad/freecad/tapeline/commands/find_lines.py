# SPDX-License-Identifier: GPL-3.0-or-later
"""Find feature lines: sharp lines of a model, drawn with their numbers, each to be picked."""
from ..text import QT_TRANSLATE_NOOP
from . import selection
from .base import Command


class FindLines(Command):
    name = "Tapeline_FindLines"
    icon_name = "lines"
    menu_text = QT_TRANSLATE_NOOP("Tapeline_FindLines", "Find feature lines…")
    tooltip = QT_TRANSLATE_NOOP("Tapeline_FindLines",
                                "Finds the sharp lines of the styling model; the crease angle is set with a slider")

    def open(self):
        from ..panels.lines import LinesPanel

        self.show(LinesPanel(model=selection.required("model", "move")))

    @classmethod
    def edit(cls, obj):
        from ..panels.lines import LinesPanel

        cls.show(LinesPanel(lines=obj))
