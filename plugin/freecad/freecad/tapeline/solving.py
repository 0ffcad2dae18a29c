# SPDX-License-Identifier: GPL-3.0-or-later
"""One move as an order: plain data taken from the document, which any thread can then solve."""
import json
from dataclasses import dataclass, field, replace

from . import arrays, curves, engine, models, properties
from .memory import Memory
from .text import translate

results = Memory(4)


@dataclass
class Order:
    """A move to compute. `curve` is the target line as JSON, `keys` the options that differ from their defaults."""

    source: models.Source
    line: str
    curve: str
    line_keys: dict = field(default_factory=dict)
    keys: dict = field(default_factory=dict)

    @property
    def digest(self):
        """Names the result: the same digest gives the same bytes."""
        said = json.dumps([self.line_keys, self.keys], sort_keys=True)
        return arrays.digest(self.source.digest, self.line, self.curve, said, engine.module().version())

    def model(self):
        return models.load(self.source)

    def feature_line(self):
        return models.line_of(self.model(), self.line, self.line_keys)

    def target(self):
        return curves.from_json(self.curve)

    def with_curve(self, curve, **keys):
        """The same order to another target line, with some keys changed (None takes one out)."""
        changed = {key: value for key, value in {**self.keys, **keys}.items() if value is not None}
        return replace(self, curve=curve, keys=changed)

    def solve(self, progress=None, cancel=None):
        """The engine's result; one that was just computed is not computed again."""
        known = results.get(self.digest)
        if known is not None:
            return known
        result = engine.module().move(self.model(), self.feature_line(), self.target(), progress=progress,
                                      cancel=cancel, **self.keys)
        return results.keep(self.digest, result)

    def place(self, progress=None, cancel=None):
        """What would move, before anything is solved: the engine's region with verdict and sides."""
        return self.model().region(self.feature_line(), self.target(), progress=progress, cancel=cancel,
                                   **self.keys)


def order_of(obj):
    """The order that a move's properties say."""
    for name in ("Model", "Target"):
        if getattr(obj, name) is None:
            raise engine.UserError(translate("Tapeline", "'{0}' has no {1}: choose an object for its property {1}.")
                                   .format(obj.Label, name))
    keys = properties.keys(obj, ["target", "remesh", "move"])
    holder = obj.Region if obj.Region is not None else obj
    keys.update(properties.keys(holder, ["region"]))
    return Order(models.source_of(obj.Model), obj.Line, curves.curve_of(obj.Target).to_json(),
                 properties.keys(obj, ["lines"]), keys)


def is_target(obj):
    """Whether an object is one of our target lines, whose control points can be dragged."""
    return getattr(getattr(obj, "Proxy", None), "kind", "") == "target"


def order_for(target, region=None):
    """The order of a move that is not in the document yet, with all options at their defaults."""
    keys = properties.keys(region, ["region"]) if region is not None else {}
    return Order(models.source_of(target.Model), target.Line, curves.curve_of(target).to_json(),
                 properties.keys(target, ["lines"]), keys)


def measure(measures, *path):
    """A measure by its path in the measures' dictionary, or None where it was not taken."""
    for name in path:
        measures = measures.get(name) if isinstance(measures, dict) else None
    return measures if isinstance(measures, (int, float)) else None


def strip_of(measures):
    """The four numbers of the quality strip, from the measures of a move or a preview."""
    before = measure(measures, "sections", "compressed", "inflections_before")
    after = measure(measures, "sections", "compressed", "inflections_after")
    return {
        "Bulge": measure(measures, "bulge", "max_mm"),
        "Inflections": None if before is None or after is None else max(0, after - before),
        "CreaseAngle": measure(measures, "crease", "max_difference"),
        "LineError": measure(measures, "line_error_max_mm"),
    }
