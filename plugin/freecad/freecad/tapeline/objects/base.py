# SPDX-License-Identifier: GPL-3.0-or-later
"""What all document objects have in common."""
import sys

import FreeCAD as App

from .. import engine, worker
from ..text import sentence_of, translate


class _Named(type):
    """Lets a class say who speaks where FreeCAD prints the type of an exception."""

    def __str__(cls):
        return cls.speaker


class Complaint(RuntimeError, metaclass=_Named):
    """What `execute` raises for its one sentence. FreeCAD marks the object in the tree, takes the sentence as its
    status, and prints traceback, type and text of whatever was raised. Here these are nothing, "Tapeline: LABEL" and
    the sentence: a traceback is no help where nothing is wrong with the program. Exceptions that are faults of the program
    are left as they are, with their traceback."""

    speaker = "Tapeline"

    def __init__(self, label, sentence):
        super().__init__(sentence)
        type(self).speaker = "Tapeline: " + label
        self._limit = getattr(sys, "tracebacklimit", None)
        sys.tracebacklimit = 0  # until FreeCAD has printed this exception and lets it go

    def __del__(self):
        if self._limit is not None:
            sys.tracebacklimit = self._limit
        else:
            vars(sys).pop("tracebacklimit", None)


class Unsaved:
    """Nothing of the Python side is saved; FreeCAD 0.20 asks for the first pair, 0.21 and later for the second."""

    def __getstate__(self):
        return None

    def __setstate__(self, state):
        return None

    def dumps(self):
        return None

    def loads(self, state):
        return None


class Proxy(Unsaved):
    """Python side of a document object. Keeps nothing of its own: all that matters is in properties."""

    kind = ""
    icon_name = "tapeline"

    def __init__(self, obj):
        obj.Proxy = self
        self.add_properties(obj)

    def add_properties(self, obj):
        """Adds what the object does not have yet; also run after loading, for documents of older versions."""

    def onDocumentRestored(self, obj):  # noqa: N802 (FreeCAD's name)
        if engine.available():
            self.add_properties(obj)

    def execute(self, obj):
        """FreeCAD's recompute. An error becomes one sentence in the report view and the object's error state."""
        try:
            self.compute(obj)
        except engine.errors() as error:
            sentence = sentence_of(error)
            if worker.cancelled(error):
                sentence = translate("Tapeline", "The computation was cancelled; recompute to do it after all.")
            raise Complaint(obj.Label, sentence) from None

    def compute(self, obj):
        """The object's own work."""


def property_if_missing(obj, kind, name, group, text, mode=0, hidden=False):
    """Adds a property once. `mode` is FreeCAD's: 1 = read-only, 4 = hidden in older versions."""
    if name not in obj.PropertiesList:
        obj.addProperty(kind, name, group, text, mode, mode & 1 != 0, hidden)


def create(document, type_name, name, proxy, label=""):
    """A new document object with its Python side, and with its look where there is a window."""
    obj = document.addObject(type_name, name)
    proxy(obj)
    if label:
        obj.Label = label
    if App.GuiUp:
        from .. import views

        views.attach(obj)
    return obj


def kind_of(obj):
    """Which of our objects this is: "model", "lines", "target", "region", "move", or "" for others."""
    return getattr(getattr(obj, "Proxy", None), "kind", "") if obj is not None else ""


def is_a(obj, *kinds):
    return kind_of(obj) in kinds
