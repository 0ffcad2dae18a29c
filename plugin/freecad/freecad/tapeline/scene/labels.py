# SPDX-License-Identifier: GPL-3.0-or-later
"""Texts at points of the 3D view, always upright and of one size."""
from pivy import coin

from . import nodes

COLOUR = (0.0, 0.1, 0.35)
SIZE = 20


class LabelGroup:
    """A set of short texts; `root` is the node to add to a scene."""

    def __init__(self):
        self.root = coin.SoSwitch()
        self._words = coin.SoAnnotation()  # in front, or the surface would swallow half of a text
        self.root.addChild(self._words)
        self.visible(True)

    def visible(self, on):
        self.root.whichChild = coin.SO_SWITCH_ALL if on else coin.SO_SWITCH_NONE

    def show(self, labels):
        """Shows (text, point) pairs instead of what was there."""
        self._words.removeAllChildren()
        font = coin.SoFont()
        font.name = "Sans:Bold"
        font.size = SIZE
        for node in (nodes.unpickable(), nodes.unlit(), nodes.flat_colour(COLOUR), font):
            self._words.addChild(node)
        for text, point in labels:
            place = coin.SoTranslation()
            place.translation = tuple(point)
            word = coin.SoText2()
            word.string = " " + text
            self._words.addChild(nodes.group(place, word))
