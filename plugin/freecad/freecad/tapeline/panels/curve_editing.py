# SPDX-License-Identifier: GPL-3.0-or-later
"""Shaping a target line by its control points in the 3D view; shared by the panels of target line and move."""
import numpy as np

from .. import models
from ..objects import target as targets
from ..scene import handles
from ..text import translate
from .base import combo

SAMPLES = 240


class Normals:
    """The surface's normal near a point, for the direction in which control points are dragged."""

    def __init__(self, model):
        self._points = np.asarray(model.vertices)
        faces = np.asarray(model.faces)
        corners = self._points[faces]
        across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        self._normals = np.zeros_like(self._points)
        for corner in range(3):
            np.add.at(self._normals, faces[:, corner], across)
        lengths = np.linalg.norm(self._normals, axis=1)
        self._normals /= np.where(lengths > 0, lengths, 1)[:, None]

    def at(self, point):
        nearest = int(np.argmin(((self._points - point) ** 2).sum(axis=1)))
        return self._normals[nearest]


class CurveEditing:
    """Handles on a curve. `changed(curve)` is called at each step of a drag, `rested()` when the mouse lets go."""

    def __init__(self, view, changed, rested):
        self._changed = changed
        self.normals = None
        self.base = None    # the curve that offsets count from
        self.curve = None   # the curve with its control points as they are now
        self.offsets = None
        self.handles = handles.Handles(view, self._moved, rested, self._normal)

    def _normal(self, point):
        return self.normals.at(point) if self.normals is not None else np.array([0.0, 0.0, 1.0])

    def start(self, base, offsets=None):
        """Shows a curve, with control points moved by offsets where these fit; returns whether they did."""
        self.base = base
        points = np.asarray(base.control_points)
        fit = offsets is not None and len(offsets) == len(points)
        self.offsets = np.array(offsets) if fit else np.zeros_like(points)
        self._update()
        return fit or offsets is None

    @property
    def moved_by_hand(self):
        return self.offsets is not None and bool(np.any(self.offsets))

    def reset(self):
        if self.base is not None:
            self.start(self.base)

    def set_points(self, points):
        """Puts the control points at given places."""
        self.offsets = np.asarray(points, dtype=float) - np.asarray(self.base.control_points)
        self._update()

    def _update(self):
        points = np.asarray(self.base.control_points) + self.offsets
        self.curve = self.base.with_control_points(points) if self.moved_by_hand else self.base
        self.handles.show(points, np.asarray(self.curve.sample(SAMPLES)))

    def _moved(self, index, points):
        if self.base is None:
            return
        self.set_points(points)
        self._changed(self.curve)

    def remove(self):
        self.handles.remove()


def mode_box(editing):
    """The choice of how a drag moves a control point."""
    box = combo([(handles.SURFACE, translate("Tapeline", "along surface")),
                 (handles.VIEW, translate("Tapeline", "in view plane")),
                 (handles.NORMAL, translate("Tapeline", "along normal"))])
    box.setToolTip(translate("Tapeline", "How the mouse moves a control point: along the surface, in the "
                             "plane of the view, or along the surface's normal"))
    box.currentIndexChanged.connect(lambda *_: setattr(editing.handles, "mode", box.currentData()))
    return box


def prepared(source, recipe):
    """Background work of a panel that opens or whose recipe changed: normals and the curve to start from."""
    return lambda progress, cancel: (Normals(models.load(source, progress, cancel)),
                                     targets.slid(source, recipe, progress, cancel))
