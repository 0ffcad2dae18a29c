#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs a script of tests inside the real FreeCAD and ends with an honest exit status.

    launch.py headless|gui TESTS.py [TEST ...]

FreeCAD's own status is 0 even when a script throws, so `inside.py` writes a verdict that is read here; no verdict, a
crash or a hang is a failure. 77 says that something needed is not installed (CTest shows the test as skipped). FreeCAD
gets empty settings of its own, and the addon from this source folder, as a user's link would give it."""
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
SOURCE = HERE.parent.parent
SKIPPED = 77


def missing(gui):
    """A sentence on what is not there, or nothing."""
    programs = ["freecad", "xvfb-run"] if gui else ["freecadcmd"]
    absent = [program for program in programs if shutil.which(program) is None]
    if absent:
        return "not installed: " + ", ".join(absent) + " (scripts/setup --with-freecad)"
    if os.environ.get("TAPELINE_FREECAD_NEEDS_MODULE", "1") == "1":
        folder = pathlib.Path(os.environ.get("TAPELINE_MODULE_FOLDER", SOURCE / "build" / "dev" / "python"))
        if not (folder / "tapeline").is_dir():
            return f"the compiled Python module is not built: {folder}/tapeline"
    return ""


def command(gui):
    inside = str(HERE / "inside.py")
    return ["xvfb-run", "-a", "-s", "-screen 0 1600x1000x24", "freecad", inside] if gui else ["freecadcmd", inside]


def environment(work, tests, names):
    own = dict(os.environ)
    for variable in ("FREECAD_USER_HOME", "FREECAD_USER_DATA", "FREECAD_USER_TEMP"):
        folder = work / variable.lower()
        folder.mkdir()
        own[variable] = str(folder)
    addons = work / "freecad_user_data" / "Mod"
    addons.mkdir()
    (addons / "tapeline").symlink_to(SOURCE)
    own.update(QTWEBENGINE_DISABLE_SANDBOX="1", LC_ALL="C.UTF-8", LIBGL_ALWAYS_SOFTWARE="1",
               TAPELINE_TESTS=str(tests), TAPELINE_TEST_NAMES=" ".join(names), TAPELINE_WORK=str(work),
               TAPELINE_SOURCE=str(SOURCE), PYTHONDONTWRITEBYTECODE="1")
    own.setdefault("TAPELINE_MODULE_FOLDER", str(SOURCE / "build" / "dev" / "python"))
    own.setdefault("TAPELINE_COMMAND", str(SOURCE / "build" / "dev" / "bin" / "tapeline"))
    return own


def run(gui, tests, names, seconds):
    with tempfile.TemporaryDirectory(prefix="tapeline_freecad_") as folder:
        work = pathlib.Path(folder)
        process = subprocess.Popen(command(gui), env=environment(work, tests, names), start_new_session=True,
                                   stdin=subprocess.DEVNULL)
        try:
            process.wait(seconds)
        except subprocess.TimeoutExpired:
            print(f"FreeCAD did not end within {seconds} s", file=sys.stderr)
        finally:
            try:
                os.killpg(process.pid, signal.SIGKILL)  # the group is ours: the session was started above
            except ProcessLookupError:
                pass
            process.wait()
        verdict = work / "verdict"
        if not verdict.exists():
            print(f"FreeCAD ended without a verdict, exit status {process.returncode}", file=sys.stderr)
            return 1
        return int(verdict.read_text())


def main(arguments):
    gui = arguments[0] == "gui"
    sentence = missing(gui)
    if sentence:
        print("skipped: " + sentence)
        return SKIPPED
    seconds = float(os.environ.get("TAPELINE_FREECAD_SECONDS", "240"))
    return run(gui, pathlib.Path(arguments[1]).resolve(), arguments[2:], seconds)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
