# SPDX-License-Identifier: GPL-3.0-or-later
"""Curves of the document as target lines, target lines as shapes, and feature lines as edges."""
import os
import tempfile

import FreeCAD as App
import numpy as np
import Part

from . import arrays, engine
from .text import translate


def bspline_edge(line):
    """The exact shape of a TargetLine."""
    knots = np.asarray(line.knots)
    distinct, counts = [], []
    for knot in knots:
        if distinct and knot == distinct[-1]:
            counts[-1] += 1
        else:
            distinct.append(float(knot))
            counts.append(1)
    points = arrays.vectors(line.control_points)
    weights = [float(w) for w in line.weights]
    curve = Part.BSplineCurve()
    curve.buildFromPolesMultsKnots(points, counts, distinct, False, int(line.degree), weights)
    return curve.toShape()


def polyline_edge(points):
    """One edge through all points: a B-spline of degree 1, so that a whole feature line is picked as one edge."""
    points = np.asarray(points, dtype=np.float64)
    steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
    keep = np.concatenate(([True], steps > 0))
    points = points[keep]
    parameters = np.concatenate(([0.0], np.cumsum(steps[keep[1:]])))
    counts = [2] + [1] * (len(points) - 2) + [2]
    curve = Part.BSplineCurve()
    curve.buildFromPolesMultsKnots(arrays.vectors(points), counts, parameters.tolist(), False, 1)
    return curve.toShape()


def edges_of(obj, names=()):
    """The edges of a Draft, Part or Sketch object, or the named ones among them."""
    shape = obj.Shape
    edges = [shape.getElement(name) for name in names if name.startswith("Edge")] or list(shape.Edges)
    if not edges:
        raise engine.UserError(translate("Tapeline", "'{}' has no curve that could be a target line.")
                               .format(obj.Label))
    return edges


def target_from_shape(obj, names=()):
    """A TargetLine along the edges of an object, which must join end to end."""
    edges = edges_of(obj, names)
    chains = Part.sortEdges(edges)
    if len(chains) != 1:
        raise engine.UserError(translate("Tapeline", "The edges of '{}' form {} separate curves; a target line is one "
                                         "connected curve: select the edges that belong to it.")
                               .format(obj.Label, len(chains)))
    wire = Part.Wire(chains[0])
    with tempfile.TemporaryDirectory(prefix="tapeline_") as folder:
        path = os.path.join(folder, "curve.brep")
        (wire if len(chains[0]) > 1 else chains[0][0]).exportBrep(path)
        return engine.module().TargetLine.read(path)


def curve_of(obj):
    """The TargetLine of a target object, or of any object with edges."""
    if getattr(getattr(obj, "Proxy", None), "kind", "") == "target":
        if not obj.Curve:
            raise engine.UserError(translate("Tapeline", "'{}' has no curve yet: recompute it first.")
                                   .format(obj.Label))
        return from_json(obj.Curve)
    return target_from_shape(obj)


def from_json(text):
    return engine.module().TargetLine.from_json(text)


def law_text(law):
    """"0, 30, 0" for a slide law, shortest digits that keep the value."""
    return ", ".join(f"{value:.12g}" for value in law)


def parse_law(text):
    """The numbers of a slide law; raises UserError with the word that is none."""
    law = []
    for word in text.replace(";", ",").replace(",", " ").split():
        try:
            law.append(float(word))
        except ValueError:
            raise engine.UserError(translate("Tapeline", "'{}' in the slide law is not a number; write distances in mm "
                                             "such as 0, 30, 0.").format(word)) from None
    return law


def placed(points, placement):
    return [placement.multVec(App.Vector(*map(float, p))) for p in points]
