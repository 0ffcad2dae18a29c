# SPDX-License-Identifier: GPL-3.0-or-later
"""A move while it is being edited: previews and exact results from one engine Editor."""
import threading

from . import engine, solving
from .memory import Memory


class MoveSession:
    """Answers orders from several threads. The engine's Editor keeps what a drag can use again, and its previews start
    at what it solved last; it is made anew only where something else than the target changed."""

    def __init__(self):
        self._making = threading.Lock()
        self._editors = Memory(1)

    def _editor_for(self, order):
        base = order.with_curve("").digest
        with self._making:
            editor = self._editors.get(base)
            if editor is None:
                editor = engine.module().Editor(order.model(), order.feature_line(), **order.keys)
                self._editors.keep(base, editor)
            return editor

    def preview(self, order, budget_ms, progress=None, cancel=None):
        """The engine's preview within a time budget; the first one prepares and takes longer."""
        return self._editor_for(order).preview(order.target(), budget_ms, progress=progress, cancel=cancel)

    def solve(self, order, progress=None, cancel=None):
        """The exact result, the same as the document object computes."""
        known = solving.results.get(order.digest)
        if known is not None:
            return known
        result = self._editor_for(order).solve(order.target(), progress=progress, cancel=cancel)
        return solving.results.keep(order.digest, result)
