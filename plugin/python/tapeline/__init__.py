# SPDX-License-Identifier: GPL-3.0-or-later
"""Moves feature lines of styled surfaces without a bulge. Lengths in mm, angles in degrees."""

from ._tapeline import (
    Cancelled,
    Comparison,
    Editor,
    FeatureLine,
    MethodRun,
    Model,
    MoveResult,
    Preview,
    Region,
    TapelineError,
    TargetLine,
    check,
    compare,
    move,
    options,
    run_job,
    version,
)

__version__ = version()


def placement(model, line, target=None, **keys):
    """What a move would do before anything is solved: `Model.region(...).placement`."""
    return model.region(line, target, **keys).placement
