# SPDX-License-Identifier: GPL-3.0-or-later
"""File dialogs."""
import os

import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtGui

from .. import settings


def _remembered():
    return App.ParamGet(settings.GROUP).GetString("LastFolder", os.path.expanduser("~"))


def _remember(path):
    App.ParamGet(settings.GROUP).SetString("LastFolder", os.path.dirname(path))
    return path


def ask_open_name(title, pattern):
    path = QtGui.QFileDialog.getOpenFileName(Gui.getMainWindow(), title, _remembered(), pattern)[0]
    return _remember(path) if path else ""


def ask_save_name(title, name, pattern, ending):
    """Asks where to write; the ending is added where none was typed."""
    path = QtGui.QFileDialog.getSaveFileName(Gui.getMainWindow(), title, os.path.join(_remembered(), name), pattern)[0]
    if not path:
        return ""
    return _remember(path if os.path.splitext(path)[1] else path + ending)
