# SPDX-License-Identifier: GPL-3.0-or-later
"""Picking feature lines that lie on a surface.

FreeCAD takes whatever is nearest to the eye, and beside a sharp line that is the surface. So a click on a model or a
move that is within a few pixels of one of its shown lines is a click on the line."""
import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
import Part
from PySide import QtCore

from ..objects.base import kind_of
from .handles import Projection

REACH = 8.0  # pixels

_observer = None


class LinePicker:
    """Observes the selection; FreeCAD calls addSelection with the place of a click."""

    def addSelection(self, document, name, sub, point):  # noqa: N802 (FreeCAD's name)
        obj = App.getDocument(document).getObject(name) if document in App.listDocuments() else None
        if kind_of(obj) not in ("model", "move") or Gui.Control.activeDialog() or not any(point):
            return
        found = nearest_line(obj, point)
        if found is not None:
            # Not in here: FreeCAD is still telling others about the selection.
            QtCore.QTimer.singleShot(0, lambda: exchange(obj, *found))


def exchange(obj, lines, edge):
    Gui.Selection.removeSelection(obj)
    Gui.Selection.addSelection(lines.Document.Name, lines.Name, edge)


def nearest_line(obj, point):
    """(lines object, "EdgeN") of the shown feature line of `obj` nearest to a point on it, or None."""
    view = Gui.getDocument(obj.Document.Name).activeView()
    if not hasattr(view, "graphicsView"):
        return None
    projection = Projection(view, view.graphicsView().viewport())
    vertex, best = Part.Vertex(*point), (REACH, None)
    for lines in obj.InList:
        if kind_of(lines) != "lines" or not lines.ViewObject.Visibility:
            continue
        for number, edge in enumerate(lines.Shape.Edges, 1):
            place = edge.distToShape(vertex)[1][0][0]
            gap = float(np.linalg.norm(projection.pixel(place) - projection.pixel(point)))
            if gap < best[0]:
                best = (gap, (lines, f"Edge{number}"))
    return best[1]


def start():
    """Begins to observe, once."""
    global _observer
    if _observer is None:
        _observer = LinePicker()
        Gui.Selection.addObserver(_observer)
