# SPDX-License-Identifier: GPL-3.0-or-later
"""A test in FreeCAD's window: the workbench on, a document and a folder of its own, every panel and document gone after."""
import pathlib
import tempfile
import unittest

import FreeCAD as App
import FreeCADGui as Gui
import window

from freecad.tapeline.panels.base import Panel


class PanelCase(unittest.TestCase):
    def setUp(self):
        Gui.activateWorkbench("TapelineWorkbench")
        self.document = App.newDocument("Panel")
        self.document.UndoMode = 1
        self._folder = tempfile.TemporaryDirectory(prefix="tapeline_test_")
        self.folder = pathlib.Path(self._folder.name)
        window.settle(0.2)

    def tearDown(self):
        if Gui.Control.activeDialog() and Panel.open_panel:
            Panel.open_panel.reject()
        for name in list(App.listDocuments()):
            App.closeDocument(name)
        self._folder.cleanup()
