# SPDX-License-Identifier: GPL-3.0-or-later
from typing import Any

from ._tapeline import (
    Cancelled as Cancelled,
    Comparison as Comparison,
    Editor as Editor,
    FeatureLine as FeatureLine,
    MethodRun as MethodRun,
    Model as Model,
    MoveResult as MoveResult,
    Preview as Preview,
    Region as Region,
    TapelineError as TapelineError,
    TargetLine as TargetLine,
    check as check,
    compare as compare,
    move as move,
    options as options,
    run_job as run_job,
    version as version,
)

__version__: str

def placement(model: Model, line: FeatureLine, target: TargetLine | None = None, **keys: Any) -> dict[str, Any]: ...
