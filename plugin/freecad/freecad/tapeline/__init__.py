# SPDX-License-Identifier: GPL-3.0-or-later
"""Tapeline in FreeCAD: move a character line across a styled surface, and the surface follows without a bulge.

`api` holds the functions for macros, `objects` the document objects, `commands`, `panels` and `scene` the window. All
geometry is done by the compiled module `tapeline`, which `engine` finds.
"""
import os

FOLDER = os.path.dirname(os.path.abspath(__file__))
ICONS = os.path.join(FOLDER, "resources", "icons")
TRANSLATIONS = os.path.join(FOLDER, "resources", "translations")
PREFERENCES_PAGE = os.path.join(FOLDER, "resources", "ui", "preferences.ui")


def icon(name):
    """The path of one of our icons."""
    return os.path.join(ICONS, name + ".svg")
