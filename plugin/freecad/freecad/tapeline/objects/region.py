# SPDX-License-Identifier: GPL-3.0-or-later
"""The region that follows a move: a band, bounding lines, CAD faces or a box, with vertices and faces that stay."""
from .. import engine, properties, solving, worker
from ..text import translate
from .base import Proxy, create, property_if_missing


class MoveRegion(Proxy):
    kind = "region"
    icon_name = "region"

    def add_properties(self, obj):
        property_if_missing(obj, "App::PropertyLink", "Target", "Region", "Target line, which also says model and line")
        property_if_missing(obj, "App::PropertyInteger", "VertexCount", "Region", "Vertices in the region", 1)
        property_if_missing(obj, "App::PropertyInteger", "TriangleCount", "Region", "Triangles in the region", 1)
        properties.add(obj, ["region"])

    def compute(self, obj):
        if obj.Target is None:
            raise engine.UserError(translate("Tapeline", "'{}' has no target line: choose one for its property Target.")
                                   .format(obj.Label))
        region = worker.run(solving.order_for(obj.Target, obj).place,
                            translate("Tapeline", "Choosing '{}'").format(obj.Label))
        obj.VertexCount, obj.TriangleCount = len(region.vertices), len(region.faces)


def create_region(document, target, **keys):
    obj = create(document, "App::FeaturePython", "MoveRegion", MoveRegion,
                 translate("Tapeline", "Region of line {}").format(getattr(target, "Line", target.Label)))
    obj.Target = target
    properties.assign(obj, keys)
    return obj
