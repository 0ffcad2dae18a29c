# SPDX-License-Identifier: GPL-3.0-or-later
"""Small builders of Coin nodes from numpy arrays."""
import numpy as np
from pivy import coin


def floats(array):
    """Rows as Coin takes them: single precision."""
    return np.ascontiguousarray(array, dtype=np.float32)


def coordinates(points):
    node = coin.SoCoordinate3()
    set_points(node, points)
    return node


def set_points(node, points):
    points = floats(points)
    node.point.setNum(len(points))
    if len(points):
        node.point.setValues(0, len(points), points.tolist())


def faces_node(faces):
    node = coin.SoIndexedFaceSet()
    set_faces(node, faces)
    return node


def set_faces(node, faces):
    faces = np.asarray(faces, dtype=np.int32)
    indices = np.full((len(faces), 4), -1, dtype=np.int32)
    indices[:, :3] = faces
    node.coordIndex.setNum(indices.size)
    if indices.size:
        node.coordIndex.setValues(0, indices.size, indices.ravel().tolist())


def line_node(counts):
    node = coin.SoLineSet()
    node.numVertices.setValues(0, len(counts), list(map(int, counts)))
    return node


def colour(rgb, transparency=0.0):
    node = coin.SoMaterial()
    node.diffuseColor = rgb
    node.transparency = transparency
    return node


def flat_colour(rgb):
    """A colour that lighting does not change."""
    node = coin.SoBaseColor()
    node.rgb = rgb
    return node


def style(line_width=1.0, point_size=1.0):
    node = coin.SoDrawStyle()
    node.lineWidth = line_width
    node.pointSize = point_size
    return node


def unpickable():
    node = coin.SoPickStyle()
    node.style = coin.SoPickStyle.UNPICKABLE
    return node


def unlit():
    node = coin.SoLightModel()
    node.model = coin.SoLightModel.BASE_COLOR
    return node


def in_front():
    """Draws what follows a little nearer than it is, so that lines are not swallowed by the surface they lie on."""
    node = coin.SoPolygonOffset()
    node.factor = -2.0
    node.units = -2.0
    node.styles = coin.SoPolygonOffset.FILLED | coin.SoPolygonOffset.LINES | coin.SoPolygonOffset.POINTS
    return node


def group(*children):
    node = coin.SoSeparator()
    for child in children:
        node.addChild(child)
    return node
