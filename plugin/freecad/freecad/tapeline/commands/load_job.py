# SPDX-License-Identifier: GPL-3.0-or-later
"""Load Tapeline job: a job file as document objects."""
from .. import api
from ..panels.files import ask_open_name
from ..text import QT_TRANSLATE_NOOP, translate
from .base import Command


class LoadJob(Command):
    name = "Tapeline_LoadJob"
    icon_name = "load_job"
    menu_text = QT_TRANSLATE_NOOP("Tapeline_LoadJob", "Load Tapeline job…")
    tooltip = QT_TRANSLATE_NOOP("Tapeline_LoadJob",
                                "Makes model, target line, region and move from a job file of the command \"tapeline\"")
    needs_document = False

    def open(self):
        path = ask_open_name(translate("Tapeline", "Load Tapeline job"),
                             translate("Tapeline", "Tapeline jobs (*.json)"))
        if path:
            api.load_job(path)
