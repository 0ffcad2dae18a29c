# SPDX-License-Identifier: GPL-3.0-or-later
"""Tapeline in FreeCAD: move a character line across a styled surface, and the surface follows without a bulge.

`api` holds the functions for macros, `objects` the document objects, `commands`, `panels` and `scene` the window. All
geometry is done by the compiled module `tapeline`, which `engine` finds.
"""
import os

FOLDER = os.path.dirname(os.path.abspath(__file__))
ICONS = os.path.join(FOLDER, "resources", "icons")
SOURCE = os.path.abspath(os.path.join(os.path.realpath(FOLDER), *[os.pardir] * 4))  # or where it is installed
PREFERENCES_PAGE = os.path.join(FOLDER, "resources", "ui", "preferences.ui")


def translation_folders():
    """Where compiled translations (*.qm) may lie: in an installed addon, or in a build of the source folder."""
    module = os.environ.get("TAPELINE_MODULE_FOLDER", "")
    builds = [os.path.join(os.path.dirname(module), "translations")] if module else []
    builds += [os.path.join(SOURCE, "build", preset, "translations") for preset in ("release", "dev")]
    return [folder for folder in [os.path.join(FOLDER, "resources", "translations")] + builds if os.path.isdir(folder)]


def icon(name):
    """The path of one of our icons."""
    return os.path.join(ICONS, name + ".svg")
