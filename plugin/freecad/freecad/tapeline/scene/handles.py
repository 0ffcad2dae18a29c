# SPDX-License-Identifier: GPL-3.0-or-later
"""Control points to drag with the mouse, drawn before everything else.

The mouse is followed at the viewport's widget, so that dragging works with every navigation style; what misses a
handle goes on to FreeCAD."""
import numpy as np
from pivy import coin
from PySide import QtCore

from .. import settings
from . import nodes

POLYGON = (0.35, 0.35, 0.35)
POINT = (1.0, 0.78, 0.10)
ACTIVE = (0.90, 0.10, 0.10)
LINE = (0.85, 0.10, 0.10)
REACH = 1.5  # of a handle's radius; a mouse this near takes it

SURFACE, VIEW, NORMAL = "surface", "view", "normal"


class Projection:
    """Between model coordinates and pixels of the viewport, from the camera as it is now."""

    def __init__(self, view, widget):
        camera = view.getCameraNode()
        self.size = np.array([max(widget.width(), 1), max(widget.height(), 1)], dtype=float)
        ratio = self.size[0] / self.size[1]
        self._volume = camera.getViewVolume(ratio)
        if ratio < 1:
            self._volume.scale(1 / ratio)

    def pixel(self, point):
        """Pixel of a point, from the widget's top left."""
        spot = self._volume.projectToScreen(coin.SbVec3f(*map(float, point)))
        return np.array([spot[0] * self.size[0], (1 - spot[1]) * self.size[1]])

    def ray(self, pixel):
        """Origin and direction of the line of sight through a pixel."""
        near, far = (np.array(end.getValue()) for end in self._volume.projectPointToLine(
            coin.SbVec2f(pixel[0] / self.size[0], 1 - pixel[1] / self.size[1])))
        return near, (far - near) / np.linalg.norm(far - near)


def on_plane(origin, direction, point, normal):
    """Where a ray meets a plane, or None where it hardly does."""
    slope = direction @ normal
    if abs(slope) < 0.05:
        return None
    return origin + direction * (((point - origin) @ normal) / slope)


def on_axis(origin, direction, point, axis):
    """The point of an axis nearest to a ray, or None where they are nearly parallel."""
    cross = direction @ axis
    det = 1 - cross * cross
    if det < 0.01:
        return None
    gap = point - origin
    return point + axis * ((cross * (gap @ direction) - gap @ axis) / det)


class Handles(QtCore.QObject):
    """Draggable control points. `moved(index, points)` is called while dragging, `released()` afterwards; `normal_at`
    gives the surface's normal near a point, for moves along the surface and along its normal."""

    def __init__(self, view, moved, released, normal_at):
        super().__init__()
        self._view, self._moved, self._released, self._normal_at = view, moved, released, normal_at
        self.points = np.zeros((0, 3))
        self.mode = SURFACE
        self.active = -1
        self._start = None
        self._build()
        self._graph = view.getSceneGraph()
        self._graph.addChild(self.root)
        self.widget = view.graphicsView().viewport()
        self.widget.installEventFilter(self)

    def _build(self):
        self.root = coin.SoAnnotation()
        self._coordinates = coin.SoCoordinate3()
        self._polygon = coin.SoLineSet()
        self._colours = coin.SoMaterial()
        self._curve_points = coin.SoCoordinate3()
        self._curve = coin.SoLineSet()
        binding = coin.SoMaterialBinding()
        binding.value = coin.SoMaterialBinding.PER_VERTEX
        for node in (nodes.unpickable(), nodes.unlit(),
                     nodes.group(nodes.flat_colour(LINE), nodes.style(3), self._curve_points, self._curve),
                     self._coordinates,
                     nodes.group(nodes.flat_colour(POLYGON), nodes.style(1.2), self._polygon),
                     nodes.group(nodes.style(point_size=settings.handle_pixels()), self._colours, binding,
                                 coin.SoPointSet())):
            self.root.addChild(node)

    def show(self, points, curve):
        """Shows control points (k x 3) and the sampled curve."""
        self.points = np.array(points, dtype=float)
        nodes.set_points(self._coordinates, self.points)
        self._polygon.numVertices.setValues(0, 1, [len(self.points)])
        nodes.set_points(self._curve_points, curve)
        self._curve.numVertices.setValues(0, 1, [len(curve)])
        self._paint()

    def _paint(self):
        colours = np.tile(np.array(POINT), (len(self.points), 1))
        if 0 <= self.active < len(colours):
            colours[self.active] = ACTIVE
        self._colours.diffuseColor.setNum(len(colours))
        if len(colours):
            self._colours.diffuseColor.setValues(0, len(colours), nodes.floats(colours))

    def eventFilter(self, watched, event):  # noqa: N802 (Qt's name)
        kind = event.type()
        if kind == QtCore.QEvent.MouseButtonPress and event.button() == QtCore.Qt.LeftButton:
            return self._press(self._pixel(event))
        if kind == QtCore.QEvent.MouseMove and self._start is not None:
            return self._drag(self._pixel(event))
        if kind == QtCore.QEvent.MouseButtonRelease and self._start is not None:
            self._start = None
            self._released()
            return True
        return False

    @staticmethod
    def _pixel(event):
        place = event.position() if hasattr(event, "position") else event.localPos()
        return np.array([place.x(), place.y()])

    def nearest(self, pixel):
        """The handle under a pixel, or -1."""
        if not len(self.points):
            return -1
        projection = Projection(self._view, self.widget)
        gaps = [np.linalg.norm(projection.pixel(point) - pixel) for point in self.points]
        best = int(np.argmin(gaps))
        return best if gaps[best] <= REACH * settings.handle_pixels() else -1

    def pixel_of(self, index):
        """Where a handle is on the viewport."""
        return Projection(self._view, self.widget).pixel(self.points[index])

    def _press(self, pixel):
        index = self.nearest(pixel)
        if index < 0:
            return False
        self.active = index
        self._start = self.points[index].copy()
        self._paint()
        return True

    def _drag(self, pixel):
        place = self._place(pixel)
        if place is not None:
            points = self.points.copy()
            points[self.active] = place
            self._moved(self.active, points)
        return True

    def _place(self, pixel):
        """Where the dragged point goes: in the surface's tangent plane, in the plane of the view or along the
        surface's normal; a tangent plane that is seen from its edge gives way to the view's plane."""
        origin, direction = Projection(self._view, self.widget).ray(pixel)
        normal = np.asarray(self._normal_at(self._start), dtype=float)
        if self.mode == NORMAL:
            return on_axis(origin, direction, self._start, normal)
        place = on_plane(origin, direction, self._start, normal) if self.mode == SURFACE else None
        return place if place is not None else on_plane(origin, direction, self._start, direction)

    def remove(self):
        if self._graph is not None:
            self.widget.removeEventFilter(self)
            self._graph.removeChild(self.root)
            self._graph = None

