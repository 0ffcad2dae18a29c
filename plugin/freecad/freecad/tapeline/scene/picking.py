# SPDX-License-Identifier: GPL-3.0-or-later
"""Clicks on a surface that is only drawn: which triangle and which vertex is under the mouse."""
import numpy as np
from PySide import QtCore

from .handles import Projection


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


class SurfacePicker(QtCore.QObject):
    """Calls `picked(face, vertex)` for a click on the surface; if that returns True the click ends there."""

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
        origin, direction = Projection(self._view, self.widget).ray((place.x(), place.y()))
        face, point = hit(origin, direction, self._vertices, self._faces)
        if face < 0:
            return False
        corners = self._faces[face]
        vertex = corners[np.argmin(np.linalg.norm(self._vertices[corners] - point, axis=1))]
        return bool(self._picked(face, int(vertex)))

    def remove(self):
        if self.widget is not None:
            self.widget.removeEventFilter(self)
            self.widget = None
