# SPDX-License-Identifier: GPL-3.0-or-later
"""The target line: where a feature line shall go, as an exact B-spline that can be made in several ways."""
import json
from dataclasses import dataclass, field

import numpy as np

from .. import arrays, curves, engine, models, properties, worker
from ..memory import Memory
from ..text import QT_TRANSLATE_NOOP, translate, warn
from .base import Proxy, create, property_if_missing

FITTED, LINKED, STORED = "Fitted to the line", "Linked curve", "Stored curve"


class TargetLine(Proxy):
    kind = "target"
    icon_name = "target"

    def add_properties(self, obj):
        property_if_missing(obj, "App::PropertyLink", "Model", "Feature line", "Styling model, or the result of a move")
        property_if_missing(obj, "App::PropertyString", "Line", "Feature line",
                            "Which line moves: its number, or a part as in 0@10%..85% or 0@120..900 (mm)")
        if "Origin" not in obj.PropertiesList:
            obj.addProperty("App::PropertyEnumeration", "Origin", "Target",
                            QT_TRANSLATE_NOOP("App::Property", "What the target line starts from"))
            obj.Origin = [FITTED, LINKED, STORED]
        property_if_missing(obj, "App::PropertyLinkSub", "LinkedCurve", "Target",
                            "Draft, Part or Sketch object whose edges are the target line")
        property_if_missing(obj, "App::PropertyVectorList", "Offsets", "Target",
                            "Moves of the control points, made by dragging them", hidden=True)
        property_if_missing(obj, "App::PropertyString", "Stored", "Target", "The stored curve as JSON", hidden=True)
        property_if_missing(obj, "App::PropertyString", "Curve", "Target", "The target line as JSON", hidden=True)
        property_if_missing(obj, "App::PropertyLength", "Length", "Target", "Length of the target line", 1)
        properties.add(obj, ["lines"])
        properties.add(obj, ["target"], only=TARGET_KEYS)

    def compute(self, obj):
        recipe, source = recipe_of(obj), models.source_of(obj.Model)
        line = worker.run(lambda progress, cancel: build(source, recipe, progress, cancel),
                          translate("Tapeline", "Making '{}'").format(obj.Label))
        if recipe.dropped_offsets:
            warn(translate("Tapeline", "{}: the number of control points changed, so their moves by hand are gone.")
                 .format(obj.Label))
            obj.Offsets = []
        put(obj, line)


TARGET_KEYS = ("control_points", "tolerance", "surface_points", "slide", "fair", "fair_limit", "on_surface")


@dataclass
class Recipe:
    """All that makes a target line, as plain data."""

    line: str = "0"
    line_keys: dict = field(default_factory=dict)
    fit_keys: dict = field(default_factory=dict)
    slide: list = field(default_factory=list)
    offsets: np.ndarray = None
    fair: bool = False
    fair_limit: float = 0.0
    on_surface: bool = False
    start: str = ""  # JSON of a stored curve, or empty to fit the line
    dropped_offsets: bool = False


def recipe_of(obj):
    """The recipe in a document object's properties."""
    if obj.Model is None:
        raise engine.UserError(translate("Tapeline", "'{}' has no model: choose one for its property Model.")
                               .format(obj.Label))
    recipe = Recipe(line=obj.Line, line_keys=properties.keys(obj, ["lines"]), slide=list(obj.Slide),
                    fair=obj.Fair, fair_limit=obj.FairLimit.Value, on_surface=obj.OnSurface)
    recipe.fit_keys = {key: value for key, value in properties.keys(obj, ["target"]).items()
                       if key in ("control_points", "tolerance", "surface_points")}
    if obj.Offsets:
        recipe.offsets = arrays.from_vectors(obj.Offsets)
    if obj.Origin == LINKED:
        if obj.LinkedCurve is None:
            raise engine.UserError(translate("Tapeline", "'{}' has no curve: choose one for its property LinkedCurve.")
                                   .format(obj.Label))
        curve, names = obj.LinkedCurve
        recipe.start = curves.target_from_shape(curve, names).to_json()
    elif obj.Origin == STORED:
        recipe.start = obj.Stored
    return recipe


_bases = Memory(8)
_finished = Memory(8)


def slid(source, recipe, progress=None, cancel=None):
    """The curve that handles start from: fitted, linked or stored, and slid."""
    key = json.dumps([source.digest, recipe.line, recipe.line_keys, recipe.fit_keys, recipe.slide, recipe.start])
    return _bases.get(key) or _bases.keep(key, _make_base(models.load(source), recipe, progress, cancel))


def _make_base(model, recipe, progress, cancel):
    line = models.line_of(model, recipe.line, recipe.line_keys)
    if not recipe.start:
        slide = {"slide": recipe.slide} if any(recipe.slide) else {}
        return model.fit_target(line, progress=progress, cancel=cancel, **recipe.fit_keys, **slide)
    start = curves.from_json(recipe.start)
    if not any(recipe.slide):
        return start
    return start.slide(model, line, recipe.slide, progress=progress, cancel=cancel)


def finished(source, recipe, target, progress=None, cancel=None):
    """Fairing and laying on the surface, as asked for."""
    keys = finish_keys(recipe)
    if not keys:
        return target
    key = json.dumps([source.digest, recipe.line, recipe.line_keys, keys, target.to_json()])
    known = _finished.get(key)
    if known is not None:
        return known
    if recipe.fair:
        target = target.fair(recipe.fair_limit)
    if recipe.on_surface:
        model = models.load(source)
        target = target.on_surface(model, models.line_of(model, recipe.line, recipe.line_keys), progress=progress,
                                   cancel=cancel)
    return _finished.keep(key, target)


def laid_quickly(order, cancel=None):
    """An order whose curve is laid on the surface without even triangles first: a fraction of a second, near enough for
    a preview."""
    curve = order.target().on_surface(order.model(), order.feature_line(), remesh="off", cancel=cancel)
    return order.with_curve(curve.to_json())


def finish_keys(recipe):
    """The finishing steps that are asked for, as options of the command."""
    keys = {"fair": recipe.fair, "fair_limit": recipe.fair_limit if recipe.fair else 0, "on_surface": recipe.on_surface}
    return {key: value for key, value in keys.items() if value}


def build(source, recipe, progress=None, cancel=None):
    """The target line of a recipe: start, slide, moves by hand, fairing, laying on the surface, in this order."""
    line = slid(source, recipe, progress, cancel)
    if recipe.offsets is not None:
        points = np.asarray(line.control_points)
        if len(points) == len(recipe.offsets):
            line = line.with_control_points(points + recipe.offsets)
        else:
            recipe.dropped_offsets = True
    return finished(source, recipe, line, progress, cancel)


def put(obj, line):
    """Stores a finished curve in the object."""
    obj.Curve = line.to_json()
    obj.Shape = curves.bspline_edge(line)
    obj.Length = obj.Shape.Length


def create_target(document, model, line="0", curve=None, stored=None, **keys):
    """A target line for a line of a model: fitted, or along `curve` (an object, or (object, [edge names])), or a
    `stored` TargetLine. Further keys are those of `tapeline target`."""
    obj = create(document, "Part::FeaturePython", "TargetLine", TargetLine,
                 translate("Tapeline", "Target of line {}").format(line))
    obj.Model, obj.Line = model, str(line)
    if curve is not None:
        obj.Origin = LINKED
        obj.LinkedCurve = curve if isinstance(curve, tuple) else (curve, [])
    elif stored is not None:
        obj.Origin, obj.Stored = STORED, stored.to_json()
    left = properties.assign(obj, keys)
    if left:
        raise engine.UserError(translate("Tapeline", "A target line has no option '{}'.").format(sorted(left)[0]))
    return obj


__all__ = ["FITTED", "LINKED", "STORED", "Recipe", "TargetLine", "build", "create_target", "finished",
           "put", "recipe_of", "slid"]
