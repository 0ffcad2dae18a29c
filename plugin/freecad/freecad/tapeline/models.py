# SPDX-License-Identifier: GPL-3.0-or-later
"""From document objects to the engine's models. A `Source` is plain data, taken from the document in the window's
thread; reading it may then happen in any thread."""
import atexit
import functools
import os
import shutil
import tempfile
import threading
from dataclasses import dataclass, field

import numpy as np

from . import arrays, engine, properties
from .memory import Memory
from .text import translate

_read = Memory(6)
_reading = threading.Lock()  # or two threads that need one model would both read it


@dataclass
class Source:
    """Where a model comes from: a file, or arrays that are written to one. `digest` names the content: equal digests
    are equal models."""

    digest: str
    path: str = ""
    keys: dict = field(default_factory=dict)
    vertices: np.ndarray = None
    faces: np.ndarray = None

    @property
    def is_file(self):
        return self.vertices is None

    def write_mesh(self, path):
        """Writes the arrays with all their digits."""
        model = engine.module().Model.from_arrays(self.vertices, self.faces)
        model.write(path)


@functools.lru_cache(1)
def _shapes_folder():
    """Where shapes of Part objects are written for the engine; gone when FreeCAD ends."""
    folder = tempfile.mkdtemp(prefix="tapeline_")
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    return folder


def _shape_source(base):
    """The exact shape of a Part object, as the BREP text that FreeCAD writes; one file for one shape."""
    written = os.path.join(_shapes_folder(), "new.brep")
    base.Shape.exportBrep(written)
    digest = arrays.file_digest(written)
    path = os.path.join(_shapes_folder(), digest + ".brep")
    os.replace(written, path)
    return path, digest


def source_of(obj):
    """The source of a styling model, of a move's result, or of any Part or Mesh object."""
    kind = getattr(getattr(obj, "Proxy", None), "kind", "")
    if kind == "move":
        if not obj.Vertices:
            raise engine.UserError(translate("Tapeline", "'{}' has no result yet: recompute it first.")
                                   .format(obj.Label))
        vertices, faces = arrays.rows(obj, "Vertices"), arrays.rows(obj, "Triangles", np.int32)
        return Source(arrays.digest(vertices, faces), vertices=vertices, faces=faces)
    keys = properties.keys(obj, ["import"]) if kind == "model" else {}
    base = obj.Base if kind == "model" else obj
    if base is None:
        if not obj.Source or not os.path.isfile(obj.Source):
            raise engine.UserError(translate("Tapeline", "'{}' has no model file: choose one for its property Source.")
                                   .format(obj.Label))
        return Source(arrays.digest(arrays.file_digest(obj.Source), repr(sorted(keys.items()))), obj.Source, keys)
    return _source_of_object(base, keys)


def _source_of_object(base, keys):
    if getattr(getattr(base, "Proxy", None), "kind", "") in ("model", "move"):
        return source_of(base)
    if hasattr(base, "Shape") and not base.Shape.isNull():
        path, digest = _shape_source(base)
        return Source(arrays.digest(digest, repr(sorted(keys.items()))), path, keys)
    if hasattr(base, "Mesh") and base.Mesh.CountFacets:
        vertices, faces = arrays.mesh_arrays(base.Mesh)
        return Source(arrays.digest(vertices, faces), vertices=vertices, faces=faces)
    raise engine.UserError(translate("Tapeline", "'{}' has neither a shape nor a mesh: choose a styling model, a Part "
                                     "or a Mesh object.").format(base.Label))


def load(source, progress=None, cancel=None):
    """The engine's model of a source; the last few are kept. Arrays pass through a file, so that a job file on such a
    file gives the same bytes."""
    with _reading:
        known = _read.get(source.digest)
        return known if known is not None else _read.keep(source.digest, _read_anew(source, progress, cancel))


def _read_anew(source, progress, cancel):
    tapeline = engine.module()
    if source.is_file:
        return tapeline.Model.read(source.path, progress=progress, cancel=cancel, **source.keys)
    with tempfile.TemporaryDirectory(prefix="tapeline_") as folder:
        path = os.path.join(folder, "model.obj")
        source.write_mesh(path)
        return tapeline.Model.read(path, progress=progress, cancel=cancel)


def line_of(model, selector, line_keys):
    """The engine's feature line for a selector: "0", a part as "0@10%..85%" or "0@120..900" (mm), or the name of a file
    of vertex indices."""
    number, _, part = selector.strip().partition("@")
    if not number.isdigit():
        return model.line_through(_vertices_in(selector), **line_keys)
    lines = model.feature_lines(**line_keys)
    if int(number) >= len(lines):
        raise engine.UserError(translate("Tapeline", "There is no line {}: at these crease angles the "
                                         "model has {} of them, counted from 0.").format(number, len(lines)))
    line = lines[int(number)]
    if not part:
        return line
    start, dots, end = part.partition("..")
    if not dots or not start or not end:
        raise engine.UserError(translate("Tapeline", "'{}' names no line: write 0, 0@10%..85% or 0@120..900.")
                               .format(selector))
    return line.part(_bound(start, selector), _bound(end, selector))


def _bound(text, selector):
    text = text.strip()
    try:
        value = float(text.rstrip("%"))
    except ValueError:
        raise engine.UserError(translate("Tapeline", "'{}' names no line: write 0, 0@10%..85% or 0@120..900.")
                               .format(selector)) from None
    return text if text.endswith("%") else value


def _vertices_in(path):
    try:
        with open(path, encoding="utf-8") as file:
            return [int(word) for word in file.read().replace("[", " ").replace("]", " ").replace(",", " ").split()]
    except (OSError, ValueError) as error:
        raise engine.UserError(translate("Tapeline", "'{}' names no line and is no file of vertex indices: {}.")
                               .format(path, error)) from None
