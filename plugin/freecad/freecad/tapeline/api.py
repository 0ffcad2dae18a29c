# SPDX-License-Identifier: GPL-3.0-or-later
"""Functions for macros and scripts: everything that the workbench's commands do, without a window.

    from freecad.tapeline import api
    model = api.import_model("hood.step")
    lines = api.find_lines(model, crease_angle=10)
    target = api.target_line(model, "0@10%..85%", slide=[0, 30, 60, 30, 0])
    move = api.move(target, region=api.region(target, roi_distance=400))
    api.export(move, "hood_moved.obj")

Keyword arguments are the options of the command `tapeline`; lengths are mm, angles degrees. Each function that makes
an object is one step of undo. A function that fails raises an exception whose text is a sentence."""
import contextlib

import FreeCAD as App

from . import engine, jobs, models, solving
from .objects import kind_of
from .objects.line_set import create_lines
from .objects.model import create_model
from .objects.move import create_move
from .objects.region import create_region
from .objects.target import create_target
from .text import sentence_of, translate


@contextlib.contextmanager
def transaction(document, name):
    """One step of undo; whatever fails inside leaves the document as it was."""
    document.openTransaction(name)
    try:
        yield
    except BaseException:
        document.abortTransaction()
        raise
    document.commitTransaction()


def document_for(document=None):
    return document or App.ActiveDocument or App.newDocument("Styling")


def computed(obj):
    """Recomputes an object and what it needs; raises with the object's sentence where it fails."""
    obj.Document.recompute([obj])
    if "Invalid" in obj.State:
        raise engine.UserError(sentence_of(failure_of(obj)))
    return obj


def failure_of(obj):
    """Why an object could not be computed."""
    status = obj.getStatusString()
    return status if status not in ("Valid", "Touched", "") else translate(
        "Tapeline", "'{}' could not be computed.").format(obj.Label)


def import_model(source, document=None, **import_keys):
    """A styling model from a file name, or from a Part or Mesh object."""
    document = document_for(document)
    with transaction(document, translate("Tapeline", "Import styling model")):
        return computed(create_model(document, source, **import_keys))


def find_lines(model, **line_keys):
    """The numbered feature lines of a model or of a move's result."""
    with transaction(model.Document, translate("Tapeline", "Find feature lines")):
        return computed(create_lines(model.Document, model, **line_keys))


def target_line(model, line="0", curve=None, **keys):
    """A target line: fitted to a line, or along a curve of the document."""
    with transaction(model.Document, translate("Tapeline", "Target line")):
        return computed(create_target(model.Document, model, line, curve, **keys))


def region(target, **region_keys):
    """A region around a target line."""
    with transaction(target.Document, translate("Tapeline", "Region")):
        return computed(create_region(target.Document, target, **region_keys))


def move(target, region=None, model=None, line=None, **keys):
    """The parametric move of a line to its target, solved."""
    with transaction(target.Document, translate("Tapeline", "Move feature line")):
        return computed(create_move(target.Document, target, region, model, line, **keys))


def engine_model(obj):
    """The engine's model (tapeline.Model) of a styling model, a move, or a Part or Mesh object."""
    return models.load(models.source_of(obj))


def result(move_object):
    """The engine's result of a move: maps, measures and statistics; solved again after a document was opened."""
    from . import worker

    return worker.run(solving.order_of(move_object).solve)


def measures(move_object):
    """The quality measures of a move as a dictionary."""
    return dict(result(move_object).measures)


def export(move_object, path, report="", ascii=False):
    """Writes the moved surface with all its digits (.stl, .obj, .ply or .off), and a report page if asked for."""
    if kind_of(move_object) != "move":
        raise engine.UserError(translate("Tapeline", "'{}' is no move: only moves are exported.")
                               .format(move_object.Label))
    if path:
        jobs.write_result(move_object, path, ascii)
    if report:
        result(move_object).write(report=report)


def save_job(move_object, path):
    """Writes a move as a job that `tapeline run` reproduces to the same bytes; returns the files' names."""
    return jobs.save_job(move_object, path)


def load_job(path, document=None, compute=True):
    """The document objects of a job file; returns the move."""
    document = document_for(document)
    with transaction(document, translate("Tapeline", "Load Tapeline job")):
        loaded = jobs.load_job(document, path)
        return computed(loaded) if compute else loaded
