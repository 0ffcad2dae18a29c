# SPDX-License-Identifier: GPL-3.0-or-later
"""Target line: where a feature line shall go, fitted and shaped by its control points, or a curve of the document."""
from ..text import QT_TRANSLATE_NOOP
from . import selection
from .base import Command


class MakeTarget(Command):
    name = "Tapeline_Target"
    icon_name = "target"
    menu_text = QT_TRANSLATE_NOOP("Tapeline_Target", "Target line…")
    tooltip = QT_TRANSLATE_NOOP("Tapeline_Target",
                                "Fits a B-spline to the picked feature line and shapes it: drag its control points, "
                                "slide it by numbers, fair it, lay it on the surface; or uses the selected curve")

    def open(self):
        from ..panels.target import TargetPanel

        lines, number = selection.picked_line()
        if lines is None:
            lines = selection.of_kind("lines")
        model = lines.Model if lines is not None else selection.required("model", "move")
        self.show(TargetPanel(model=model, lines=lines, number=number or 0, curve=selection.picked_curve()))

    @classmethod
    def edit(cls, obj):
        from ..panels.target import TargetPanel

        cls.show(TargetPanel(target=obj))
