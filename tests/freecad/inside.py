# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs inside FreeCAD: the tests of the file that launch.py names, then leaves a verdict and ends the program."""
import importlib.util
import os
import pathlib
import sys
import traceback
import unittest

import FreeCAD as App


def suite(path, names):
    sys.path.insert(0, str(path.parent))
    specification = importlib.util.spec_from_file_location(path.stem, path)
    module = importlib.util.module_from_spec(specification)
    sys.modules[path.stem] = module
    specification.loader.exec_module(module)
    if names:
        return unittest.defaultTestLoader.loadTestsFromNames(names, module)
    return unittest.defaultTestLoader.loadTestsFromModule(module)


def run():
    status = 1
    try:
        tests = suite(pathlib.Path(os.environ["TAPELINE_TESTS"]), os.environ["TAPELINE_TEST_NAMES"].split())
        steps = os.environ["TAPELINE_TESTS"].endswith("_walk.py")  # each of which needs the one before
        outcome = unittest.TextTestRunner(stream=sys.__stdout__, verbosity=2, failfast=steps).run(tests)
        status = 0 if outcome.wasSuccessful() and outcome.testsRun > 0 else 1
    except BaseException:
        traceback.print_exc(file=sys.__stdout__)
    sys.__stdout__.flush()
    pathlib.Path(os.environ["TAPELINE_WORK"], "verdict").write_text(str(status))
    os._exit(status)


if App.GuiUp:
    from PySide import QtCore

    QtCore.QTimer.singleShot(500, run)  # once the window stands
else:
    run()
