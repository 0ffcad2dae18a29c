# SPDX-License-Identifier: GPL-3.0-or-later
"""The move of a feature line: a parametric object whose shape is the moved surface, in doubles."""
import json

import numpy as np

from .. import arrays, engine, properties, solving, worker
from ..text import QT_TRANSLATE_NOOP, translate, warn
from .base import Proxy, create, property_if_missing

# Measure of the quality strip -> (type, what it is); filled after each solve, for people and spreadsheets.
MEASURES = {
    "Bulge": ("App::PropertyDistance",
              QT_TRANSLATE_NOOP("App::Property", "Largest distance of the compressed side to its old surface")),
    "Inflections": ("App::PropertyInteger",
                    QT_TRANSLATE_NOOP("App::Property", "New inflections in sections of the compressed side")),
    "CreaseAngle": ("App::PropertyAngle",
                    QT_TRANSLATE_NOOP("App::Property", "Largest change of the crease angle along the line")),
    "LineError": ("App::PropertyFloat",
                  QT_TRANSLATE_NOOP("App::Property", "Largest distance of the moved line to its target [mm]")),
}


def measure_property(name):
    """CreaseAngle is an option already, the angle by which lines are found."""
    return "Measured" + name


class FeatureLineMove(Proxy):
    kind = "move"
    icon_name = "move"

    def add_properties(self, obj):
        property_if_missing(obj, "App::PropertyLink", "Model", "Move", "Styling model, or the result of a move")
        property_if_missing(obj, "App::PropertyLink", "Target", "Move", "Target line, or any object with a curve")
        property_if_missing(obj, "App::PropertyLink", "Region", "Move", "Region; without one, the options here count")
        property_if_missing(obj, "App::PropertyString", "Line", "Move",
                            "Which line moves: its number, or a part as in 0@10%..85% or 0@120..900 (mm)")
        for name, (kind, text) in MEASURES.items():
            property_if_missing(obj, kind, measure_property(name), "Result", text, 1)
        property_if_missing(obj, "App::PropertyString", "Verdict", "Result", "Whether the line stays on the surface", 1)
        property_if_missing(obj, "App::PropertyString", "SideThatGaveWay", "Result", "The compressed side", 1)
        self._add_storage(obj)
        properties.add(obj, ["lines", "remesh", "region", "move"])
        properties.add(obj, ["target"], only=("correspondence",))

    @staticmethod
    def _add_storage(obj):
        for kind, name, text in (
                ("App::PropertyFloatList", "Vertices", "Positions, in doubles: x, y, z of each vertex [mm]"),
                ("App::PropertyIntegerList", "Triangles", "Vertices of each triangle"),
                ("App::PropertyIntegerList", "LineVertices", "Vertices of the moved line, in order"),
                ("App::PropertyString", "Statistics", "All that was done and measured, as JSON"),
                ("App::PropertyString", "Inputs", "Digest of what the result was computed from")):
            property_if_missing(obj, kind, name, "Result", text, hidden=True)

    def compute(self, obj):
        order = solving.order_of(obj)
        if obj.Vertices and obj.Inputs == order.digest:
            refresh_display(obj)
            return
        title = translate("Tapeline", "Moving the feature line of '{}'").format(obj.Label)
        adopt(obj, order, worker.run(order.solve, title))


def adopt(obj, order, result):
    """Takes over a solved result; a recompute then finds nothing to do."""
    arrays.store(obj, "Vertices", result.vertices)
    obj.Triangles = np.asarray(result.faces).ravel().tolist()
    obj.LineVertices = np.asarray(result.line_vertices).tolist()
    obj.Statistics = json.dumps(result.stats)
    for name, value in solving.strip_of(result.measures).items():
        setattr(obj, measure_property(name), int(value or 0) if name == "Inflections" else float(value or 0))
    placement = result.stats.get("placement", {})
    obj.Verdict = str(placement.get("verdict", ""))
    obj.SideThatGaveWay = str(placement.get("compressed_side", ""))
    obj.Inputs = order.digest
    solving.results.keep(order.digest, result)
    for sentence in result.warnings:
        warn(f"{obj.Label}: {sentence}")
    refresh_display(obj)


def refresh_display(obj):
    """Makes the single-precision mesh for the eye anew."""
    obj.Mesh = arrays.display_mesh(arrays.rows(obj, "Vertices"), arrays.rows(obj, "Triangles", np.int32))


def create_move(document, target, region=None, model=None, line=None, **keys):
    """A move of a line to a target. Model, line and the keys by which lines are found come from the target line where
    it is one of ours; for other curves `model` and `line` must be given."""
    ours = getattr(getattr(target, "Proxy", None), "kind", "") == "target"
    if not ours and model is None:
        raise engine.UserError(translate("Tapeline", "'{}' is no target line of a model: name the model and the line.")
                               .format(target.Label))
    obj = create(document, "Mesh::FeaturePython", "FeatureLineMove", FeatureLineMove,
                 translate("Tapeline", "Move of line {}").format(getattr(target, "Line", "0") if line is None else line))
    obj.Target, obj.Region = target, region
    obj.Model = model if model is not None else target.Model
    obj.Line = str(line) if line is not None else (target.Line if ours else "0")
    if ours:
        properties.assign(obj, properties.keys(target, ["lines"]))
    properties.assign(obj, keys)
    return obj
