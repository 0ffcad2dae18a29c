# SPDX-License-Identifier: GPL-3.0-or-later
"""Sections across the moved line with curvature combs."""
import numpy as np
from pivy import coin

from . import nodes

SIDES = {"compressed": (0.80, 0.35, 0.05), "tension": (0.05, 0.30, 0.75)}
TEETH = 25    # drawn of a section, so that they stay teeth
TOOTH = 0.12  # length of the longest tooth, as a share of the longest section


class SectionCombs:
    def __init__(self, view):
        self._graph = view.getSceneGraph()
        self.root = coin.SoSeparator()
        self._graph.addChild(self.root)

    def show(self, sections, before, scale):
        """Draws the sections that the engine made: polylines, and teeth as long as the curvature."""
        self.root.removeAllChildren()
        if not sections:
            return
        state = "before" if before else "after"
        for node in (nodes.unpickable(), nodes.unlit(), nodes.in_front()):
            self.root.addChild(node)
        length = scale * self._tooth_length(sections)
        for side, colour in SIDES.items():
            for section in sections:
                points = np.asarray(section[f"{side}_{state}"]["points"])
                teeth = -np.asarray(section[f"{side}_{state}"]["curvature"]) * length
                if len(points) > 1:
                    self.root.addChild(self._comb(points, teeth, colour))

    @staticmethod
    def _tooth_length(sections):
        """Millimetres a unit of curvature, one for all sections, so that combs can be compared."""
        largest, longest = 0.0, 0.0
        for section in sections:
            for part in section.values():
                points, curvature = np.asarray(part["points"]), np.asarray(part["curvature"])
                if len(points) > 1:
                    sizes = np.linalg.norm(curvature, axis=1)
                    largest = max(largest, float(np.percentile(sizes, 95)))
                    longest = max(longest, float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum()))
        return TOOTH * longest / largest if largest > 0 else 0.0

    @staticmethod
    def _comb(points, teeth, colour):
        ends = points + teeth
        some = np.unique(np.linspace(0, len(points) - 1, TEETH).astype(int))
        stripes = np.stack([points[some], ends[some]], axis=1).reshape(-1, 3)
        return nodes.group(nodes.flat_colour(colour), nodes.style(2.5),
                           nodes.group(nodes.coordinates(points), nodes.line_node([len(points)])), nodes.style(1),
                           nodes.group(nodes.coordinates(ends), nodes.line_node([len(ends)])),
                           nodes.group(nodes.coordinates(stripes), nodes.line_node([2] * len(some))))

    def remove(self):
        if self._graph is not None:
            self._graph.removeChild(self.root)
            self._graph = None
