# SPDX-License-Identifier: GPL-3.0-or-later
"""All commands, in the order of menu and toolbar, and which one a double click in the tree opens."""
import FreeCADGui as Gui

from ..objects import kind_of
from .base import guarded
from .check import CheckSurface
from .export import Export
from .find_lines import FindLines
from .import_model import ImportModel
from .load_job import LoadJob
from .move import MoveLine
from .region import MakeRegion
from .save_job import SaveJob
from .target import MakeTarget

STEPS = (ImportModel, FindLines, MakeTarget, MakeRegion, MoveLine, CheckSurface, Export)
JOBS = (SaveJob, LoadJob)
_registered = []


def register():
    """Adds the commands to FreeCAD and returns their names, with separators."""
    if not _registered:
        for command in STEPS + JOBS:
            Gui.addCommand(command.name, command())
            _registered.append(command.name)
    return names()


def names():
    return [c.name for c in STEPS] + ["Separator"] + [c.name for c in JOBS]


def edit(obj):
    """Opens the panel of an existing object; False where it has none, so that FreeCAD does what it does by default."""
    opener = {"lines": FindLines.edit, "target": MakeTarget.edit, "region": MakeRegion.edit,
              "move": MoveLine.edit}.get(kind_of(obj))
    if opener is None or Gui.Control.activeDialog():
        return False
    guarded(lambda: opener(obj))
    return True
