# SPDX-License-Identifier: GPL-3.0-or-later
"""Check surface: zebra, curvature, distances, sections and measures of a move."""
from ..text import QT_TRANSLATE_NOOP
from . import selection
from .base import Command


class CheckSurface(Command):
    name = "Tapeline_Check"
    icon_name = "check"
    menu_text = QT_TRANSLATE_NOOP("Tapeline_Check", "Check surface…")
    tooltip = QT_TRANSLATE_NOOP("Tapeline_Check",
                                "Shows zebra stripes, curvature and the distance to the surface before, sections with "
                                "curvature combs, and the table of measures")

    def open(self):
        from ..panels.check import CheckPanel

        self.show(CheckPanel(selection.required("move")))
