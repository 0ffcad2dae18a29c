# SPDX-License-Identifier: GPL-3.0-or-later
"""Shared by the tests inside FreeCAD: models, folders, and the command `tapeline` as a peer."""
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

import FreeCAD as App
import numpy as np

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


class Printed:
    """What FreeCAD prints meanwhile: its console writes past Python's streams. `text` holds it afterwards."""

    def __enter__(self):
        self._file = tempfile.TemporaryFile()
        self._kept = [os.dup(number) for number in (1, 2)]
        for number in (1, 2):
            os.dup2(self._file.fileno(), number)
        return self

    def __exit__(self, *_):
        for number, kept in zip((1, 2), self._kept):
            os.dup2(kept, number)
            os.close(kept)
        self._file.seek(0)
        self.text = self._file.read().decode()
        self._file.close()

    def sentences(self):
        """The lines without FreeCAD's own about recomputing and its percentages."""
        lines = re.sub(r"\(\s*\d+ %\)", "", self.text).replace("\r", "\n").splitlines()
        return [line.strip() for line in lines if line.strip() and "Recompute" not in line]


def zigzag_roof(creases=(-60, -20, 20, 60), slope=0.35, cell=5.0, length=200.0):
    """Vertices and faces of planes that meet in sharp straight lines along y, one at each of `creases`."""
    edges = np.array([creases[0] - 40, *creases, creases[-1] + 40], dtype=float)
    slopes = np.where(np.arange(len(edges) - 1) % 2, slope, -slope)
    heights = np.concatenate(([0.0], np.cumsum(np.diff(edges) * slopes)))
    x, y = np.arange(edges[0], edges[-1] + cell / 2, cell), np.arange(0, length + cell / 2, cell)
    grid_x, grid_y = np.meshgrid(x, y)
    vertices = np.stack([grid_x.ravel(), grid_y.ravel(), np.interp(grid_x.ravel(), edges, heights)], axis=1)
    corner = (np.arange(len(y) - 1)[:, None] * len(x) + np.arange(len(x) - 1)).ravel()
    return vertices, np.concatenate([np.stack([corner, corner + 1, corner + len(x) + 1], axis=1),
                                     np.stack([corner, corner + len(x) + 1, corner + len(x)], axis=1)])


def run_command(*arguments):
    """Runs `tapeline` and returns what it did; fails where it cannot."""
    return subprocess.run([COMMAND, *map(str, arguments)], capture_output=True, text=True, check=False, timeout=120)
