# SPDX-License-Identifier: GPL-3.0-or-later
"""A surface drawn over the document: previews, tints, colour maps and zebra stripes."""
import numpy as np
from pivy import coin

from . import nodes, zebra

CREASE_ANGLE = 0.14  # [rad] edges sharper than this are drawn sharp
BASE = (0.80, 0.82, 0.86)


class SurfaceOverlay:
    """Triangles with colours. `root` is in the scene of `view` from start until `remove`."""

    def __init__(self, view):
        self._graph = view.getSceneGraph()
        self.root = coin.SoSeparator()
        self._switch = coin.SoSwitch()
        self._switch.whichChild = coin.SO_SWITCH_NONE
        self._zebra = coin.SoSwitch()
        self._zebra.addChild(zebra.texture_nodes())
        self._zebra.whichChild = coin.SO_SWITCH_NONE
        self._material = coin.SoMaterial()
        self._binding = coin.SoMaterialBinding()
        self._points = coin.SoCoordinate3()
        self._faces = coin.SoIndexedFaceSet()
        body = nodes.group(nodes.unpickable(), self._hints(), self._zebra, self._material, self._binding,
                           self._points, self._faces)
        self._switch.addChild(body)
        self.root.addChild(self._switch)
        self._graph.addChild(self.root)
        self._shape = None
        self.plain()

    @staticmethod
    def _hints():
        hints = coin.SoShapeHints()
        hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
        hints.shapeType = coin.SoShapeHints.UNKNOWN_SHAPE_TYPE
        hints.faceType = coin.SoShapeHints.CONVEX
        hints.creaseAngle = CREASE_ANGLE
        return hints

    def show(self, vertices, faces):
        """Draws these triangles; where only positions changed, only positions are sent."""
        faces = np.asarray(faces)
        nodes.set_points(self._points, vertices)
        if self._shape is None or self._shape.shape != faces.shape or not np.array_equal(self._shape, faces):
            nodes.set_faces(self._faces, faces)
            self._shape = faces.copy()
        self._switch.whichChild = coin.SO_SWITCH_ALL

    def hide(self):
        self._switch.whichChild = coin.SO_SWITCH_NONE

    @property
    def visible(self):
        return self._switch.whichChild.getValue() == coin.SO_SWITCH_ALL

    @property
    def count(self):
        """How many triangles are shown."""
        return 0 if self._shape is None else len(self._shape)

    def plain(self, rgb=BASE):
        self._binding.value = coin.SoMaterialBinding.OVERALL
        self._material.diffuseColor.setNum(1)
        self._material.diffuseColor.setValue(*rgb)
        self._faces.materialIndex.setNum(0)

    def colour_vertices(self, colours):
        """One colour a vertex (n x 3, 0 to 1), blended over the triangles."""
        colours = nodes.floats(colours)
        self._material.diffuseColor.setNum(len(colours))
        self._material.diffuseColor.setValues(0, len(colours), colours)
        self._faces.materialIndex.setNum(0)
        self._binding.value = coin.SoMaterialBinding.PER_VERTEX_INDEXED

    def colour_faces(self, classes, palette):
        """One colour of the palette a triangle, by its class number."""
        palette = nodes.floats(palette)
        self._material.diffuseColor.setNum(len(palette))
        self._material.diffuseColor.setValues(0, len(palette), palette)
        indices = np.asarray(classes, dtype=np.int32)
        self._faces.materialIndex.setNum(len(indices))
        self._faces.materialIndex.setValues(0, len(indices), indices)
        self._binding.value = coin.SoMaterialBinding.PER_FACE_INDEXED

    def stripes(self, on):
        """Zebra stripes as mirrored in the surface, or not."""
        self._zebra.whichChild = coin.SO_SWITCH_ALL if on else coin.SO_SWITCH_NONE
        if on:
            self.plain((1.0, 1.0, 1.0))

    def remove(self):
        if self._graph is not None:
            self._graph.removeChild(self.root)
            self._graph = None
