# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbered lines drawn while their thresholds are being chosen."""
import numpy as np
from pivy import coin

from . import nodes
from .labels import LabelGroup

LINE = (0.0, 0.25, 0.75)
MARKED = (0.95, 0.45, 0.0)


class LinePreview:
    def __init__(self, view):
        self._graph = view.getSceneGraph()
        self.root = coin.SoSeparator()
        self._lines = coin.SoSeparator()
        self._labels = LabelGroup()
        for node in (nodes.unpickable(), nodes.unlit(), nodes.in_front(), self._lines, self._labels.root):
            self.root.addChild(node)
        self._graph.addChild(self.root)
        self._colours = []

    def show(self, lines):
        """Draws (text, points) pairs."""
        self._lines.removeAllChildren()
        self._colours = []
        labels = []
        for text, points in lines:
            points = np.asarray(points)
            colour = nodes.flat_colour(LINE)
            self._colours.append(colour)
            self._lines.addChild(nodes.group(colour, nodes.style(5), nodes.coordinates(points),
                                             nodes.line_node([len(points)])))
            labels.append((text, points[len(points) // 2]))
        self._labels.show(labels)

    def mark(self, index):
        """Draws one line in another colour."""
        self.paint({index: MARKED})

    def paint(self, colours):
        """Draws lines in colours of their own, by their place in the list; the others as at first."""
        for i, colour in enumerate(self._colours):
            colour.rgb = colours.get(i, LINE)

    def remove(self):
        if self._graph is not None:
            self._graph.removeChild(self.root)
            self._graph = None
