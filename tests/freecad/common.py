# SPDX-License-Identifier: GPL-3.0-or-later
"""Shared by the tests inside FreeCAD: models, folders, and the command `tapeline` as a peer."""
import os
import pathlib
import subprocess
import tempfile
import unittest

import FreeCAD as App

SOURCE = pathlib.Path(os.environ["TAPELINE_SOURCE"])
COMMAND = os.environ["TAPELINE_COMMAND"]
HOOD = SOURCE / "resources" / "models" / "hood.step"
PANEL = SOURCE / "resources" / "models" / "panel.step"
LINE = "0@10%..85%"
SLIDE = [0, 20, 0]


class InADocument(unittest.TestCase):
    """Each test has a document with undo, and a folder, of its own."""

    def setUp(self):
        self.document = App.newDocument("Test")
        self.document.UndoMode = 1
        self._folder = tempfile.TemporaryDirectory(prefix="tapeline_test_")
        self.folder = pathlib.Path(self._folder.name)

    def tearDown(self):
        for name in list(App.listDocuments()):
            App.closeDocument(name)
        self._folder.cleanup()


def run_command(*arguments):
    """Runs `tapeline` and returns what it did; fails where it cannot."""
    return subprocess.run([COMMAND, *map(str, arguments)], capture_output=True, text=True, check=False, timeout=120)
