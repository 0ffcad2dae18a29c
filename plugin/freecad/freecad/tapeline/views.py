# SPDX-License-Identifier: GPL-3.0-or-later
"""How our document objects look in the tree and the 3D view."""
import FreeCAD as App

from . import icon
from .objects.base import Unsaved, kind_of


class View(Unsaved):
    """View provider shared by all: icon, children in the tree, double click opens the panel."""

    def __init__(self, view):
        view.Proxy = self

    def attach(self, view):
        self.Object = view.Object

    def getIcon(self):  # noqa: N802 (FreeCAD's names from here on)
        return icon(getattr(self.Object.Proxy, "icon_name", "tapeline"))

    def claimChildren(self):  # noqa: N802
        return []

    def doubleClicked(self, view):  # noqa: N802
        from .commands.registry import edit

        return edit(view.Object)

    def setEdit(self, view, mode=0):  # noqa: N802
        return False if mode else None

    def updateData(self, obj, name):  # noqa: N802
        pass

    def onChanged(self, view, name):  # noqa: N802
        pass


class LinesView(View):
    """Feature lines: thick, each with its number beside it."""

    def attach(self, view):
        from .scene.labels import LabelGroup

        super().attach(view)
        self._labels = LabelGroup()
        view.RootNode.addChild(self._labels.root)
        self._relabel(view.Object)
        self._labels.visible(view.Visibility)

    def onChanged(self, view, name):  # noqa: N802
        if name == "Visibility" and hasattr(self, "_labels"):
            self._labels.visible(view.Visibility)

    def updateData(self, obj, name):  # noqa: N802
        if name == "Shape":
            self._relabel(obj)

    def _relabel(self, obj):
        if hasattr(self, "_labels"):
            self._labels.show([(str(i), edge.valueAt((edge.FirstParameter + edge.LastParameter) / 2))
                               for i, edge in enumerate(obj.Shape.Edges)])


class MoveView(View):
    """A move hides the model that it moved, as Part's features hide theirs."""

    def claimChildren(self):  # noqa: N802
        return [child for child in (self.Object.Target, self.Object.Region) if child is not None]


CLASSES = {"lines": LinesView, "move": MoveView}
COLOURS = {"lines": (0.0, 0.25, 0.75), "target": (0.85, 0.1, 0.1)}
SURFACE_COLOUR = (0.80, 0.82, 0.86)


def _colour_surface(view, colour):
    """FreeCAD 1.0 has materials in place of the one colour."""
    if hasattr(view, "ShapeColor"):
        view.ShapeColor = colour
    else:
        material = App.Material()
        material.DiffuseColor = (*colour, 1.0)
        view.ShapeAppearance = (material,)


def attach(obj):
    """Gives a new object its look."""
    view, kind = obj.ViewObject, kind_of(obj)
    CLASSES.get(kind, View)(view)
    if kind in COLOURS:
        view.LineColor = COLOURS[kind]
        view.LineWidth = 3.0
        view.PointSize = 1.0
        view.DrawStyle = "Solid"
    elif kind in ("model", "move"):
        _colour_surface(view, SURFACE_COLOUR)
        view.Lighting = "Two side"
        view.DisplayMode = "Shaded"
