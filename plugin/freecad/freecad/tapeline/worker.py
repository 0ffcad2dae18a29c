# SPDX-License-Identifier: GPL-3.0-or-later
"""Long computations off the window's thread: cancellable, and only the newest request counts."""
import atexit
import threading
import time
import weakref

import FreeCAD as App

from . import engine
from .text import translate

POLL_MILLISECONDS = 15

_running = weakref.WeakSet()


class Task:
    """One computation in a thread of its own. `work(progress, cancel)` gets a progress function (fraction, stage) and
    a threading.Event; what it returns or raises is kept."""

    def __init__(self, work):
        self.cancelled = threading.Event()
        self.fraction = 0.0
        self.stage = ""
        self.result = None
        self.error = None
        self._work = work
        self._thread = threading.Thread(target=self._run, daemon=True)
        _running.add(self)
        self._thread.start()

    def _progress(self, fraction, stage=""):
        self.fraction, self.stage = fraction, stage
        return not self.cancelled.is_set()

    def _run(self):
        try:
            self.result = self._work(self._progress, self.cancelled)
        except BaseException as error:  # kept for the thread that asked
            self.error = error

    def cancel(self):
        self.cancelled.set()

    def join(self, seconds):
        self._thread.join(seconds)

    @property
    def running(self):
        return self._thread.is_alive()


@atexit.register
def stop_all(seconds=3.0):
    """No computation outlives the program: the engine would find its memory gone."""
    for task in list(_running):
        task.cancel()
    for task in list(_running):
        task.join(seconds)


class Latest:
    """Runs the newest request only: while one runs, a later one replaces whatever waits, and cancels what runs if
    asked to. Results come back in the window's thread, stale ones never."""

    def __init__(self, parent=None):
        from PySide import QtCore

        self._task = None
        self._current = None
        self._waiting = None
        self._timer = QtCore.QTimer(parent)
        self._timer.setInterval(POLL_MILLISECONDS)
        self._timer.timeout.connect(self._poll)
        self.on_progress = None

    def ask(self, work, done, failed, interrupt=True):
        """Requests `work(progress, cancel)`; afterwards `done(result)` or `failed(error)` is called, unless a newer
        request came in between. With `interrupt` the running one is cancelled at once."""
        self._waiting = (work, done, failed)
        if self._task is None:
            self._start()
        elif interrupt:
            self._task.cancel()

    def drop(self):
        """Cancels all that runs or waits."""
        self._waiting = None
        self._current = None
        if self._task is not None:
            self._task.cancel()

    def close(self):
        """As drop, for good; a thread that goes on until it notices holds nobody up."""
        self.drop()
        self._task = None
        self._timer.stop()

    @property
    def busy(self):
        return self._task is not None or self._waiting is not None

    def _start(self):
        self._current = self._waiting
        self._waiting = None
        self._task = Task(self._current[0])
        self._timer.start()

    def _poll(self):
        task = self._task
        if task is None:
            self._timer.stop()
            return
        if task.running:
            if self.on_progress and self._current is not None:
                self.on_progress(task.fraction, task.stage)
            return
        self._task = None
        current, self._current = self._current, None
        superseded = self._waiting is not None and task.cancelled.is_set()
        if self._waiting is not None:
            self._start()
        else:
            self._timer.stop()
        if current is None or superseded:
            return
        if task.error is None:
            current[1](task.result)
        else:
            current[2](task.error)


def run(work, title=""):
    """Runs `work(progress, cancel)` and returns its result, or raises what it raised. In the window it runs in a
    thread, the window stays alive behind a dialog with progress and Cancel; without a window it runs at once."""
    if not App.GuiUp:
        return work(lambda fraction, stage="": None, threading.Event())
    return _run_behind_dialog(work, title)


def _run_behind_dialog(work, title):
    import FreeCADGui as Gui
    from PySide import QtCore, QtGui

    dialog = QtGui.QProgressDialog(title or translate("Tapeline", "Computing"), translate("Tapeline", "Cancel"), 0,
                                   1000, Gui.getMainWindow())
    dialog.setWindowModality(QtCore.Qt.ApplicationModal)
    dialog.setMinimumDuration(400)
    dialog.setAutoClose(False)
    dialog.setAutoReset(False)
    task = Task(work)
    try:
        while task.running:
            dialog.setValue(int(1000 * task.fraction))
            if task.stage:
                dialog.setLabelText((title + "\n" if title else "") + task.stage)
            QtGui.QApplication.processEvents(QtCore.QEventLoop.AllEvents, 20)
            if dialog.wasCanceled():
                task.cancel()
            time.sleep(0.005)
    finally:
        dialog.close()
        dialog.deleteLater()
    if task.error is not None:
        raise task.error
    return task.result


def cancelled(error):
    """Whether an error only says that the user cancelled."""
    return engine.available() and isinstance(error, engine.module().Cancelled)


__all__ = ["Latest", "Task", "cancelled", "run"]
