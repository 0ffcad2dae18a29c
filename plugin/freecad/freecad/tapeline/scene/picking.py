# SPDX-License-Identifier: GPL-3.0-or-later
"""Clicks on a surface and lines that are only drawn: which triangle, vertex or line is under the mouse."""
import numpy as np
from PySide import QtCore

from .handles import Projection

REACH = 8.0       # pixels to a line
THICKNESS = 0.03  # of the model's diagonal: a line this far behind the surface under the mouse is not meant


def hit(origin, direction, vertices, faces):
    """The nearest triangle that a ray meets and the place, or (-1, None). Möller and Trumbore's test of all at once."""
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    e1, e2 = b - a, c - a
    p = np.cross(direction, e2)
    det = (e1 * p).sum(axis=1)
    with np.errstate(divide="ignore", invalid="ignore"):
        t0 = origin - a
        u = (t0 * p).sum(axis=1) / det
        q = np.cross(t0, e1)
        v = (q @ direction) / det
        t = (e2 * q).sum(axis=1) / det
    inside = (np.abs(det) > 0) & (u >= 0) & (v >= 0) & (u + v <= 1)
    if not inside.any():
        return -1, None
    t = np.where(inside, t, np.inf)
    face = int(np.argmin(t))
    return face, origin + direction * t[face]


def nearest_line(projection, lines, pixel, depth=np.inf):
    """Which of some polylines passes nearest to a pixel, within REACH and no farther from the eye than `depth`, or
    -1."""
    origin, direction = projection.ray(pixel)
    best, least = -1, REACH
    for number, points in enumerate(lines):
        flat = np.array([projection.pixel(point) for point in points])
        start, step = flat[:-1], np.diff(flat, axis=0)
        along = ((pixel - start) * step).sum(axis=1) / np.maximum((step**2).sum(axis=1), 1e-12)
        along = np.clip(along, 0, 1)[:, None]
        gaps = np.linalg.norm(start + along * step - pixel, axis=1)
        places = points[:-1] + along * np.diff(points, axis=0)
        gap = np.where((places - origin) @ direction <= depth, gaps, np.inf).min(initial=np.inf)
        if gap < least:
            best, least = number, gap
    return best


class SurfacePicker(QtCore.QObject):
    """Calls `picked(place)` for a press of the left button; if that returns True the click ends there. A place knows
    what is under the mouse."""

    def __init__(self, view, picked):
        super().__init__()
        self._view, self._picked = view, picked
        self._vertices = self._faces = None
        self.widget = view.graphicsView().viewport()
        self.widget.installEventFilter(self)

    def set_surface(self, vertices, faces):
        self._vertices, self._faces = np.asarray(vertices), np.asarray(faces)

    def eventFilter(self, watched, event):  # noqa: N802 (Qt's name)
        if (event.type() != QtCore.QEvent.MouseButtonPress or event.button() != QtCore.Qt.LeftButton
                or self._vertices is None):
            return False
        place = event.position() if hasattr(event, "position") else event.localPos()
        return bool(self._picked(Place(Projection(self._view, self.widget), np.array([place.x(), place.y()]),
                                       self._vertices, self._faces)))

    def remove(self):
        if self.widget is not None:
            self.widget.removeEventFilter(self)
            self.widget = None


class Place:
    """A pixel of the view, asked what is there."""

    def __init__(self, projection, pixel, vertices, faces):
        self._projection, self._pixel, self._vertices, self._faces = projection, pixel, vertices, faces

    def face_and_vertex(self):
        """The triangle and the vertex under the mouse, or (-1, -1) beside the surface."""
        face, point = hit(*self._projection.ray(self._pixel), self._vertices, self._faces)
        if face < 0:
            return -1, -1
        corners = self._faces[face]
        return face, int(corners[np.argmin(np.linalg.norm(self._vertices[corners] - point, axis=1))])

    def line(self, lines):
        """Which of some polylines is under the mouse and not behind the surface, or -1."""
        origin, direction = self._projection.ray(self._pixel)
        face, point = hit(origin, direction, self._vertices, self._faces)
        if face < 0:
            return nearest_line(self._projection, lines, self._pixel)
        slack = THICKNESS * np.linalg.norm(np.ptp(self._vertices, axis=0))
        return nearest_line(self._projection, lines, self._pixel, (point - origin) @ direction + slack)
