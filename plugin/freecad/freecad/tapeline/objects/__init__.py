# SPDX-License-Identifier: GPL-3.0-or-later
"""Document objects: StylingModel, FeatureLines, TargetLine, MoveRegion and FeatureLineMove. None of them needs a
window; `views` gives them one where there is one."""
from .base import is_a, kind_of
from .line_set import FeatureLines
from .model import StylingModel
from .move import FeatureLineMove
from .region import MoveRegion
from .target import TargetLine

__all__ = ["FeatureLineMove", "FeatureLines", "MoveRegion", "StylingModel", "TargetLine", "is_a", "kind_of"]
