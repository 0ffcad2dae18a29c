# SPDX-License-Identifier: GPL-3.0-or-later
"""The feature lines of a model, numbered, each one edge to pick."""
import Part

from .. import curves, engine, models, properties, worker
from ..text import translate
from .base import Proxy, create, property_if_missing


class FeatureLines(Proxy):
    kind = "lines"
    icon_name = "lines"

    def add_properties(self, obj):
        property_if_missing(obj, "App::PropertyLink", "Model", "Lines", "Styling model, or the result of a move")
        property_if_missing(obj, "App::PropertyStringList", "Table", "Lines",
                            "Number, length and crease angle of each line", 1)
        property_if_missing(obj, "App::PropertyInteger", "Count", "Lines", "Number of lines found", 1)
        properties.add(obj, ["lines"])

    def compute(self, obj):
        if obj.Model is None:
            raise engine.UserError(translate("Tapeline", "'{}' has no model: choose one for its property Model.")
                                   .format(obj.Label))
        source, keys = models.source_of(obj.Model), line_keys(obj)
        show(obj, worker.run(lambda progress, cancel: find(models.load(source, progress, cancel), keys),
                             translate("Tapeline", "Finding the lines of '{}'").format(obj.Model.Label)))


def show(obj, lines):
    """Puts found lines into the object: edge i + 1 is line i."""
    obj.Shape = Part.makeCompound([curves.polyline_edge(closed_points(line)) for line in lines])
    obj.Count = len(lines)
    obj.Table = [describe(line) for line in lines]
    if not lines:
        raise engine.UserError(translate("Tapeline", "The model has no edge as sharp as the crease angle {:g} deg: "
                                         "lower it, or choose another model.").format(obj.CreaseAngle.Value))


def closed_points(line):
    """The line's points, with the first one again at the end of a closed line."""
    points = list(line.points)
    return points + [points[0]] if line.closed and (points[0] != points[-1]).any() else points


def describe(line):
    return translate("Tapeline", "Line {}: {:.1f} mm long, crease {:.1f} deg (from {:.1f} to {:.1f})").format(
        line.id, line.length_mm, line.crease_angle_mean, line.crease_angle_min, line.crease_angle_max)


def line_keys(obj):
    """The keys by which lines are found, so that a number means the same line again."""
    return properties.keys(obj, ["lines"])


def find(model, keys):
    return model.feature_lines(**keys)


def number_of_edge(name):
    """Which line an edge's name means: 0 for "Edge1"."""
    return int(name[4:]) - 1 if name.startswith("Edge") and name[4:].isdigit() else None


def create_lines(document, model, **keys):
    obj = create(document, "Part::FeaturePython", "FeatureLines", FeatureLines,
                 translate("Tapeline", "Feature lines of {}").format(model.Label))
    obj.Model = model
    properties.assign(obj, keys)
    return obj
