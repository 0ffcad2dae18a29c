# SPDX-License-Identifier: GPL-3.0-or-later
"""The styling model: a CAD or mesh file, kept inside the document, or another object of the document."""
import json
import os

from .. import arrays, engine, models, properties, worker
from ..text import inform, translate, warn
from .base import Proxy, create, property_if_missing

CAD_ENDINGS = (".step", ".stp", ".iges", ".igs", ".brep", ".brp")
MESH_ENDINGS = (".stl", ".obj", ".ply", ".off")


class StylingModel(Proxy):
    kind = "model"
    icon_name = "import"

    def add_properties(self, obj):
        property_if_missing(obj, "App::PropertyLink", "Base", "Model",
                            "Part or Mesh object that is the model, instead of a file")
        property_if_missing(obj, "App::PropertyFileIncluded", "Source", "Model",
                            "The model's file, a copy of which is kept in the document")
        property_if_missing(obj, "App::PropertyString", "Origin", "Model", "Where the file came from", 1)
        property_if_missing(obj, "App::PropertyString", "SourceUnit", "Model", "Length unit found in the file", 1)
        property_if_missing(obj, "App::PropertyString", "Report", "Model", "What was found and repaired", 1)
        property_if_missing(obj, "App::PropertyInteger", "VertexCount", "Model", "Vertices of the triangles", 1)
        property_if_missing(obj, "App::PropertyInteger", "TriangleCount", "Model", "Triangles", 1)
        properties.add(obj, ["import"])

    def compute(self, obj):
        source = models.source_of(obj)
        model = worker.run(lambda progress, cancel: models.load(source, progress, cancel),
                           translate("Tapeline", "Reading '{}'").format(obj.Label))
        obj.Mesh = arrays.display_mesh(model.vertices, model.faces)
        obj.VertexCount, obj.TriangleCount = len(model.vertices), len(model.faces)
        report = dict(model.report)
        obj.SourceUnit = str(report.get("units", ""))
        inform(translate("Tapeline", "{}: {} vertices, {} triangles, lengths in {}").format(
            obj.Label, obj.VertexCount, obj.TriangleCount, obj.SourceUnit or "mm"))
        obj.Report = json.dumps(report, default=str, sort_keys=True)
        for sentence in report.get("warnings", []):
            warn(f"{obj.Label}: {sentence}")


def create_model(document, source, **import_keys):
    """A styling model from a file name or from a Part or Mesh object."""
    is_path = isinstance(source, (str, os.PathLike))
    if is_path and not os.path.isfile(source):
        raise engine.UserError(translate("Tapeline", "There is no file '{}'.").format(source))
    label = os.path.splitext(os.path.basename(str(source)))[0] if is_path else translate(
        "Tapeline", "{} (styling model)").format(source.Label)
    obj = create(document, "Mesh::FeaturePython", "StylingModel", StylingModel,
                 label)
    if is_path:
        obj.Source = str(source)
        obj.Origin = os.path.abspath(str(source))
    else:
        obj.Base = source
    properties.assign(obj, import_keys)
    return obj
