# SPDX-License-Identifier: GPL-3.0-or-later
"""Doubles in and out of document properties, and meshes for display.

FreeCAD's mesh kernel holds single precision, so meshes are for the eye only. The doubles stay in list properties, which
FreeCAD saves as binary doubles (a test holds that they come back bit for bit)."""
import functools
import hashlib
import io
import os

import FreeCAD as App
import Mesh
import numpy as np


def store(obj, name, array):
    """Puts an array, row by row, into a list property."""
    setattr(obj, name, np.ascontiguousarray(array).ravel().tolist())


def rows(obj, name, dtype=np.float64, columns=3):
    """A list property as an n x columns array."""
    return np.array(getattr(obj, name), dtype=dtype).reshape(-1, columns)


def digest(*parts):
    """SHA-256 over arrays, bytes and texts, as hexadecimal digits."""
    total = hashlib.sha256()
    for part in parts:
        if isinstance(part, np.ndarray):
            part = str(part.dtype).encode() + np.ascontiguousarray(part).tobytes()
        elif isinstance(part, str):
            part = part.encode()
        total.update(str(len(part)).encode() + b":" + part)
    return total.hexdigest()


def file_digest(path):
    """SHA-256 of a file, read again only where its size or its date says that it changed."""
    state = os.stat(path)
    return _file_digest(os.path.abspath(path), state.st_size, state.st_mtime_ns)


@functools.lru_cache(64)
def _file_digest(path, *_):
    with open(path, "rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest() if hasattr(hashlib, "file_digest") else (
            hashlib.sha256(file.read()).hexdigest())


def display_mesh(vertices, faces):
    """A Mesh of single precision. It goes through a binary PLY in memory, the one way into the kernel that is fast
    (0.02 s for 79k triangles); lists of points and triangles are slow and crash some versions."""
    header = ("ply\nformat binary_little_endian 1.0\n"
              f"element vertex {len(vertices)}\nproperty float x\nproperty float y\nproperty float z\n"
              f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n")
    record = np.empty(len(faces), dtype=[("count", "u1"), ("indices", "<i4", 3)])
    record["count"] = 3
    record["indices"] = faces
    mesh = Mesh.Mesh()
    mesh.read(Stream=io.BytesIO(header.encode() + np.asarray(vertices, "<f4").tobytes() + record.tobytes()),
              Format="PLY")
    return mesh


def mesh_arrays(mesh):
    """Vertices (n x 3, where the mesh is placed) and faces (m x 3) of a Mesh."""
    points, facets = mesh.Topology
    return np.array([tuple(point) for point in points], dtype=np.float64), np.array(facets, dtype=np.int32)


def vectors(points):
    return [App.Vector(*map(float, point)) for point in points]


def from_vectors(points):
    return np.array([tuple(point) for point in points], dtype=np.float64).reshape(-1, 3)
