# SPDX-License-Identifier: GPL-3.0-or-later
"""Colours of maps and tints."""
import numpy as np

TENSION = (0.42, 0.62, 0.90)
COMPRESSION = (0.95, 0.62, 0.32)
REGION = (0.45, 0.75, 0.48)
FIXED = (0.80, 0.15, 0.15)
OUTSIDE = (0.80, 0.82, 0.86)
BOUNDING = (0.10, 0.10, 0.10)
KEPT = (0.95, 0.75, 0.05)
HELD = (0.80, 0.05, 0.45)

GRADES = {"green": "#2e9e44", "amber": "#e0a100", "red": "#cc2b2b", "": "#8a8a8a"}

_DIVERGING = np.array([[0.13, 0.27, 0.66], [0.55, 0.70, 0.90], [0.93, 0.93, 0.93], [0.95, 0.62, 0.45],
                       [0.70, 0.09, 0.13]])
_RISING = np.array([[0.93, 0.93, 0.93], [0.99, 0.85, 0.46], [0.95, 0.55, 0.24], [0.80, 0.20, 0.15],
                    [0.45, 0.03, 0.16]])


def swatch(rgb):
    """A coloured square, for labels."""
    return '<span style="color: #{:02x}{:02x}{:02x}">■</span> '.format(*(round(255 * part) for part in rgb))


def _mix(table, t):
    """Colours between those of a table; grey where there is no value."""
    known = np.isfinite(t)
    t = np.clip(np.where(known, t, 0), 0, 1) * (len(table) - 1)
    low = np.minimum(t.astype(int), len(table) - 2)
    part = (t - low)[:, None]
    return np.where(known[:, None], table[low] * (1 - part) + table[low + 1] * part, OUTSIDE)


def scale_of(values, percent=98.0):
    """A size that all but a few values stay below, so that one bad vertex does not bleach the map."""
    sizes = np.abs(np.asarray(values)[np.isfinite(values)])
    if not len(sizes):
        return 1.0
    scale = float(np.percentile(sizes, percent))
    return scale if scale > 0 else float(sizes.max()) or 1.0


def diverging(values, scale=None):
    """Blue below zero, red above."""
    scale = scale or scale_of(values)
    return _mix(_DIVERGING, 0.5 + 0.5 * np.asarray(values) / scale)


def rising(values, scale=None):
    """Grey at zero to dark red."""
    scale = scale or scale_of(values)
    return _mix(_RISING, np.asarray(values) / scale)


def signs(values, dead_band=0.0):
    """Blue for negative, red for positive, grey within the dead band."""
    values = np.asarray(values)
    chosen = _DIVERGING[np.where(values > dead_band, 4, np.where(values < -dead_band, 0, 2))]
    return np.where(np.isfinite(values)[:, None], chosen, OUTSIDE)
