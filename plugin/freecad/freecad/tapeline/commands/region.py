# SPDX-License-Identifier: GPL-3.0-or-later
"""Region: what may follow a move, tinted in the 3D view."""
from ..text import QT_TRANSLATE_NOOP
from . import selection
from .base import Command


class MakeRegion(Command):
    name = "Tapeline_Region"
    icon_name = "region"
    menu_text = QT_TRANSLATE_NOOP("Tapeline_Region", "Region…")
    tooltip = QT_TRANSLATE_NOOP("Tapeline_Region",
                                "Chooses what may follow the line: a band, bounding lines or CAD faces, with vertices "
                                "and faces that stay where they are")

    def open(self):
        from ..panels.region import RegionPanel

        self.show(RegionPanel(target=selection.required("target")))

    @classmethod
    def edit(cls, obj):
        from ..panels.region import RegionPanel

        cls.show(RegionPanel(region=obj))
