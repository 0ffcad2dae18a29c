# SPDX-License-Identifier: GPL-3.0-or-later
"""Save Tapeline job: the edit as a file that the command `tapeline run` repeats to the same bytes."""
from .. import jobs
from ..panels.files import ask_save_name
from ..text import QT_TRANSLATE_NOOP, inform, translate
from . import selection
from .base import Command


class SaveJob(Command):
    name = "Tapeline_SaveJob"
    icon_name = "save_job"
    menu_text = QT_TRANSLATE_NOOP("Tapeline_SaveJob", "Save Tapeline job…")
    tooltip = QT_TRANSLATE_NOOP("Tapeline_SaveJob",
                                "Writes the move as a job file with its model and target line; the command \"tapeline "
                                "run\" makes the same surface from it, to the last bit")

    def open(self):
        move = selection.required("move")
        path = ask_save_name(translate("Tapeline", "Save Tapeline job"), move.Label + ".json",
                             translate("Tapeline", "Tapeline jobs (*.json)"), ".json")
        if path:
            for name in jobs.save_job(move, path):
                inform(translate("Tapeline", "wrote {}").format(name))
