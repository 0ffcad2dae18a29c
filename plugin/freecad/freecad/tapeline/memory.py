# SPDX-License-Identifier: GPL-3.0-or-later
"""Keeps the last few answers of a computation, from any thread."""
import threading
from collections import OrderedDict


class Memory:
    """Answers by key; the least used one is dropped when there are more than `kept`."""

    def __init__(self, kept):
        self._kept = kept
        self._answers = OrderedDict()
        self._lock = threading.Lock()

    def get(self, key):
        """The answer, or None."""
        with self._lock:
            if key in self._answers:
                self._answers.move_to_end(key)
            return self._answers.get(key)

    def keep(self, key, answer):
        """Keeps an answer and returns it."""
        with self._lock:
            self._answers[key] = answer
            self._answers.move_to_end(key)
            while len(self._answers) > self._kept:
                self._answers.popitem(last=False)
        return answer

    def clear(self):
        with self._lock:
            self._answers.clear()
