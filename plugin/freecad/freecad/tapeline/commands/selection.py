# SPDX-License-Identifier: GPL-3.0-or-later
"""What the user means: the selection in tree and 3D view, or the only thing there is."""
import FreeCAD as App
import FreeCADGui as Gui

from .. import engine
from ..objects import is_a, kind_of
from ..objects.line_set import number_of_edge
from ..text import QT_TRANSLATE_NOOP, translate

WORDS = {
    "model": QT_TRANSLATE_NOOP("Tapeline", "a styling model (Tapeline > Import styling model)"),
    "lines": QT_TRANSLATE_NOOP("Tapeline", "feature lines (Tapeline > Find feature lines)"),
    "target": QT_TRANSLATE_NOOP("Tapeline", "a target line (Tapeline > Target line)"),
    "region": QT_TRANSLATE_NOOP("Tapeline", "a region (Tapeline > Region)"),
    "move": QT_TRANSLATE_NOOP("Tapeline", "a move (Tapeline > Move feature line)"),
}


def selected():
    return [item.Object for item in Gui.Selection.getSelectionEx()]


def of_kind(*kinds):
    """The first selected object of these kinds, or the newest one in the document; None where there is none."""
    for obj in selected():
        if is_a(obj, *kinds):
            return obj
    there = [obj for obj in App.ActiveDocument.Objects if is_a(obj, *kinds)] if App.ActiveDocument else []
    return there[-1] if there else None


def required(*kinds):
    """As of_kind, but raises a sentence that says what to make first."""
    found = of_kind(*kinds)
    if found is None:
        raise engine.UserError(translate("Tapeline", "This needs {}; select one, or make one first.")
                               .format(translate("Tapeline", WORDS[kinds[0]])))
    return found


def picked_line():
    """(lines object, number) of the first selected edge of feature lines, or (None, None)."""
    for item in Gui.Selection.getSelectionEx():
        if kind_of(item.Object) == "lines":
            for name in item.SubElementNames:
                number = number_of_edge(name)
                if number is not None:
                    return item.Object, number
            return item.Object, None
    return None, None


def picked_curve():
    """(object, [edge names]) of a selected curve that is none of ours, or None."""
    for item in Gui.Selection.getSelectionEx():
        obj = item.Object
        if not kind_of(obj) and hasattr(obj, "Shape") and obj.Shape.Edges:
            edges = [name for name in item.SubElementNames if name.startswith("Edge")]
            if edges or not obj.Shape.Faces:
                return obj, edges
    return None


def foreign_model():
    """A selected Part or Mesh object that could become a styling model, or None."""
    for obj in selected():
        if kind_of(obj):
            continue
        if getattr(obj, "Shape", None) is not None and obj.Shape.Faces:
            return obj
        if getattr(obj, "Mesh", None) is not None and obj.Mesh.CountFacets:
            return obj
    return None
