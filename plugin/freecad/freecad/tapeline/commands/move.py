# SPDX-License-Identifier: GPL-3.0-or-later
"""Move feature line: verdict, preview while dragging, quality, and Apply."""
from ..text import QT_TRANSLATE_NOOP
from . import selection
from .base import Command


class MoveLine(Command):
    name = "Tapeline_Move"
    icon_name = "move"
    menu_text = QT_TRANSLATE_NOOP("Tapeline_Move", "Move feature line…")
    tooltip = QT_TRANSLATE_NOOP("Tapeline_Move",
                                "Moves the line to its target and lets the surface follow: drag the control points "
                                "and watch the surface and its measures, then apply")

    def open(self):
        from ..panels.move import MovePanel

        target = selection.required("target")
        region = selection.of_kind("region")
        self.show(MovePanel(target=target, region=region if region and region.Target == target else None))

    @classmethod
    def edit(cls, obj):
        from ..panels.move import MovePanel

        cls.show(MovePanel(move=obj))
