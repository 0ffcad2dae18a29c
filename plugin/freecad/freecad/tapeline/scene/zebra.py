# SPDX-License-Identifier: GPL-3.0-or-later
"""Zebra stripes: a striped room mirrored in the surface, by environment texture coordinates."""
import numpy as np
from pivy import coin

from .. import settings

HEIGHT = 1024


def stripe_image(stripes, height=HEIGHT):
    """`stripes` black and as many white bands, softened over a few rows, as a column of grey values."""
    phase = np.arange(height) / height * stripes
    wave = np.clip((np.abs(phase % 1 - 0.5) - 0.25) * height / stripes / 2 + 0.5, 0, 1)
    return (255 * wave).astype(np.uint8)


def texture_nodes():
    column = stripe_image(settings.zebra_stripes())
    image = coin.SoTexture2()
    image.image.setValue(coin.SbVec2s(2, len(column)), 1, np.repeat(column, 2).tobytes())
    image.model = coin.SoTexture2.MODULATE
    image.wrapT = coin.SoTexture2.REPEAT
    group = coin.SoGroup()
    group.addChild(image)
    group.addChild(coin.SoTextureCoordinateEnvironment())
    return group
