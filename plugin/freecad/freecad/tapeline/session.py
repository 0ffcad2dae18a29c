# SPDX-License-Identifier: GPL-3.0-or-later
"""A move while it is being edited: previews and exact results from the engine's Editors.

An Editor must be prepared before it can follow a drag; on a CAD model that means even triangles around the line first.
`warm` begins that as soon as line and region are known, `MoveSession` goes on with it, and until it is done previews
come from a second Editor on the triangles that are there already, whose preparation is a tenth of that."""
import threading

from . import engine, solving, worker
from .memory import Memory


class Held:
    """An Editor, and whether it is prepared. One thread prepares; others wait for it."""

    def __init__(self, order):
        self.editor = engine.module().Editor(order.model(), order.feature_line(), **order.keys)
        self.ready = False
        self.pace = 0.0  # seconds that its last quick preview took
        self._lock = threading.Lock()

    def prepare(self, order, progress=None, cancel=None):
        while not self._lock.acquire(timeout=0.05):
            if cancel is not None and cancel.is_set():
                raise engine.module().Cancelled("cancelled")
        try:
            if not self.ready:
                self.editor.start(order.target(), progress=progress, cancel=cancel)
                self.ready = True
        finally:
            self._lock.release()


SLACK = 3          # times the budget that a preview may take before coarse triangles are better
FORGETTING = 0.97  # of a slow pace a preview, so that the fine triangles are tried again some time

_held = Memory(3)
_making = threading.Lock()
_warming = None


def _held_for(order):
    """The Editor for all that an order says but its curve."""
    key = order.with_curve("").digest
    with _making:
        return _held.get(key) or _held.keep(key, Held(order))


def warm(order):
    """Begins to prepare the previews of a move that is likely to come; gives way to the next order."""
    global _warming
    if _warming is not None:
        _warming.cancel()
    _warming = worker.Task(lambda progress, cancel: _held_for(order).prepare(order, progress, cancel))


def is_warm(order):
    """Whether previews of this order come from an Editor that is prepared."""
    held = _held.get(order.with_curve("").digest)
    return held is not None and held.ready


def coarse(order):
    """The order on the triangles that are there, or None where it asks for no others."""
    asked = order.keys.get("remesh", "auto")
    remeshes = asked == "on" or asked == "auto" and (order.model().has_surfaces or "max_edge" in order.keys)
    return order.with_curve(order.curve, remesh="off", max_edge=None) if remeshes else None


class MoveSession:
    """Answers orders from several threads. An Editor keeps what a drag can use again, and its previews start at what it
    solved last; another is made only where something else than the target changed."""

    def prepare(self, order, progress=None, cancel=None):
        """Makes good previews of an order possible."""
        _held_for(order).prepare(order, progress, cancel)

    def preview(self, order, budget_ms, patient=False, progress=None, cancel=None):
        """The engine's preview within a time budget, and whether it stands on the move's own triangles: not where these
        are yet to be prepared or, unless one is patient, have taken far more than the budget before."""
        held = _held_for(order)
        slow = held.ready and not patient and 1000 * held.pace > SLACK * budget_ms
        rough = coarse(order) if slow or not held.ready else None
        if slow:
            held.pace *= FORGETTING
        if rough is not None:
            held = _held_for(rough)
        held.prepare(rough or order, progress, cancel)
        preview = held.editor.preview(order.target(), budget_ms, progress=progress, cancel=cancel)
        # With patience there was time to measure too, which is not what the mouse has to wait for.
        held.pace = min(held.pace, preview.seconds) if patient else preview.seconds
        return preview, rough is None

    def solve(self, order, progress=None, cancel=None):
        """The exact result, the same as the document object computes."""
        known = solving.results.get(order.digest)
        if known is not None:
            return known
        held = _held_for(order)
        held.prepare(order, progress, cancel)
        result = held.editor.solve(order.target(), progress=progress, cancel=cancel)
        return solving.results.keep(order.digest, result)
