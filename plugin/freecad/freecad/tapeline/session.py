# SPDX-License-Identifier: GPL-3.0-or-later
"""A move while it is being edited: previews and exact results from one engine Editor, for one thread at a time."""
import threading

from . import engine, solving


class MoveSession:
    """Answers for one order at a time; the engine's Editor, which keeps what a drag can use again, is made anew only
    where something else than the target changed."""

    def __init__(self):
        self._lock = threading.Lock()
        self._editor = None
        self._made_for = None

    def _ready(self, order):
        base = order.with_curve("").digest
        if self._made_for != base:
            self._editor = engine.module().Editor(order.model(), order.feature_line(), **order.all_keys())
            self._made_for = base
        return self._editor

    def preview(self, order, budget_ms):
        """The engine's preview within a time budget."""
        if not hasattr(engine.module(), "Editor"):
            return None
        with self._lock:
            return self._ready(order).preview(order.target(), budget_ms=budget_ms)

    def solve(self, order, progress=None, cancel=None):
        """The exact result, the same as the document object computes."""
        known = solving.recall(order.digest)
        if known is not None:
            return known
        if not hasattr(engine.module(), "Editor"):
            return order.solve(progress, cancel)
        with self._lock:
            result = self._ready(order).solve(order.target(), progress=progress, cancel=cancel)
        solving.remember(order.digest, result)
        return result
