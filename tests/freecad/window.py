# SPDX-License-Identifier: GPL-3.0-or-later
"""Driving FreeCAD's window as a person does: waiting, mouse events on the 3D view, screenshots and what is on them."""
import os
import pathlib
import time

import FreeCADGui as Gui
import numpy as np
from PySide import QtCore, QtGui


def settle(seconds=0.05):
    """Lets the window work for a while."""
    end = time.monotonic() + seconds
    while True:
        QtGui.QApplication.processEvents()
        if time.monotonic() >= end:
            return
        time.sleep(0.005)


def wait_until(condition, seconds=30, what="the condition"):
    """Lets the window work until something holds; AssertionError where it does not come."""
    end = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > end:
            raise AssertionError(f"{what} did not come within {seconds} s")
        settle(0.02)


class Heart:
    """Beats in the window's thread; the longest pause says how long the window was frozen."""

    def __init__(self):
        self.longest = 0.0
        self._last = time.monotonic()
        self._timer = QtCore.QTimer()
        self._timer.timeout.connect(self._beat)
        self._timer.start(5)

    def _beat(self):
        now = time.monotonic()
        self.longest = max(self.longest, now - self._last)
        self._last = now

    def stop(self):
        self._timer.stop()
        return self.longest


def view():
    return Gui.ActiveDocument.ActiveView


def viewport():
    return view().graphicsView().viewport()


def mouse(kind, pixel, button=QtCore.Qt.LeftButton):
    """Posts one mouse event to the 3D view, as the window system would."""
    held = QtCore.Qt.NoButton if kind == QtCore.QEvent.MouseButtonRelease else button
    own = QtCore.Qt.NoButton if kind == QtCore.QEvent.MouseMove else button
    place = QtCore.QPointF(float(pixel[0]), float(pixel[1]))
    widget = viewport()
    screen = QtCore.QPointF(widget.mapToGlobal(place.toPoint()))
    event = QtGui.QMouseEvent(kind, place, screen, own, held, QtCore.Qt.NoModifier)
    QtGui.QApplication.sendEvent(widget, event)


def drag(start, end, steps=12, pause=0.03, held=None):
    """Presses at `start`, moves to `end`, calls `held` where it is given, and lets go."""
    start, end = np.asarray(start, float), np.asarray(end, float)
    mouse(QtCore.QEvent.MouseButtonPress, start)
    for step in range(1, steps + 1):
        mouse(QtCore.QEvent.MouseMove, start + (end - start) * step / steps)
        settle(pause)
    if held:
        held()
    mouse(QtCore.QEvent.MouseButtonRelease, end)


def click(pixel):
    mouse(QtCore.QEvent.MouseMove, pixel, QtCore.Qt.NoButton)
    settle(0.1)
    mouse(QtCore.QEvent.MouseButtonPress, pixel)
    settle(0.05)
    mouse(QtCore.QEvent.MouseButtonRelease, pixel)
    settle(0.1)


def keep(name, image=None):
    """Saves a screenshot of the whole window where TAPELINE_PICTURES names a folder."""
    folder = os.environ.get("TAPELINE_PICTURES")
    if folder:
        pathlib.Path(folder).mkdir(parents=True, exist_ok=True)
        settle(0.2)
        whole = image if image is not None else window_image()
        whole.save(str(pathlib.Path(folder) / (name + ".png")))


def window_image():
    """What stands on the screen."""
    settle(0.1)
    screen = QtGui.QApplication.primaryScreen() if hasattr(QtGui.QApplication, "primaryScreen") else None
    main = Gui.getMainWindow()
    grabbed = screen.grabWindow(int(main.winId())) if screen is not None else main.grab()
    return grabbed.toImage()


def view_pixels():
    """The 3D view, as it stands on the screen, as a height x width x 3 array of 0 to 255."""
    widget = viewport()
    corner = widget.mapTo(Gui.getMainWindow(), QtCore.QPoint(0, 0))
    image = window_image().copy(QtCore.QRect(corner, widget.size())).convertToFormat(QtGui.QImage.Format_RGBA8888)
    flat = np.frombuffer(image.constBits(), dtype=np.uint8, count=image.bytesPerLine() * image.height())
    return flat.reshape(image.height(), image.bytesPerLine() // 4, 4)[:, : image.width(), :3].astype(int)


def share_near(pixels, colour, reach=60):
    """Share of pixels near a colour (0 to 255)."""
    return float((np.abs(pixels - np.asarray(colour)).max(axis=2) < reach).mean())


def changed_share(before, after, reach=24):
    return float((np.abs(before - after).max(axis=2) > reach).mean())


def is_blank(pixels):
    """Whether nothing but the background stands there: its gradient has hardly any edges."""
    steps = np.abs(np.diff(pixels.sum(axis=2), axis=1))
    return float((steps > 40).mean()) < 1e-4


def greenish(pixels):
    """Share of pixels that are clearly green."""
    red, green, blue = (pixels[:, :, k] for k in range(3))
    return float(((green - red > 20) & (green - blue > 20)).mean())
