# SPDX-License-Identifier: GPL-3.0-or-later
"""Job files in and out: what the command `tapeline run` reads, to the same bytes as in the document."""
import json
import os
import shutil

from . import engine, models, properties, solving
from .objects.model import create_model
from .objects.move import create_move
from .objects.region import create_region
from .objects.target import TARGET_KEYS, create_target
from .text import translate


def save_job(move, path, description=""):
    """Writes a move as a job file, with its model and target line beside it: NAME.json, NAME_target.json and
    NAME_model.*. Running it writes NAME_moved.obj, NAME_moved.stl and NAME_stats.json. Nothing is written where the
    move is incomplete. Returns the names of the files."""
    order = solving.order_of(move)
    try:
        return _save_order(order, path, description or move.Label)
    except OSError as error:
        raise engine.UserError(translate("Tapeline", "The job '{}' cannot be written: {}.").format(path, error)) \
            from None


def _save_order(order, path, description):
    folder, stem = os.path.dirname(os.path.abspath(path)), os.path.splitext(os.path.basename(path))[0]
    model_name = _write_model(order.source, folder, stem)
    target_name = stem + "_target.json"
    order.target().write(os.path.join(folder, target_name))
    job = properties.sections_of({**order.source.keys, **order.line_keys, **order.keys})
    job.setdefault("lines", {})["line"] = order.line
    job.setdefault("target", {})["target"] = target_name
    job.update(input=model_name, description=description,
               outputs={"out": [stem + "_moved.obj", stem + "_moved.stl"], "stats": stem + "_stats.json"})
    with open(path, "w", encoding="utf-8") as file:
        json.dump(job, file, indent=2, ensure_ascii=False)
        file.write("\n")
    return [path, os.path.join(folder, target_name), os.path.join(folder, model_name)]


def _write_model(source, folder, stem):
    """Puts the model beside the job and returns its name."""
    if not source.is_file:
        name = stem + "_model.obj"
        source.write_mesh(os.path.join(folder, name))
        return name
    name = stem + "_model" + os.path.splitext(source.path)[1]
    copy = os.path.join(folder, name)
    if os.path.abspath(source.path) != copy:
        shutil.copyfile(source.path, copy)
    return name


def read_job(path):
    """The job file's contents, with file names made absolute."""
    try:
        with open(path, encoding="utf-8") as file:
            job = json.load(file)
    except (OSError, ValueError) as error:
        raise engine.UserError(translate("Tapeline", "The job file '{}' cannot be read: {}.").format(path, error)) \
            from None
    if not isinstance(job, dict) or "input" not in job:
        raise engine.UserError(translate("Tapeline", "'{}' is no Tapeline job: it names no input.").format(path))
    folder = os.path.dirname(os.path.abspath(path))
    job["input"] = os.path.normpath(os.path.join(folder, job["input"]))
    target = job.setdefault("target", {})
    for key in ("target", "edit"):
        if key in target:
            target[key] = os.path.normpath(os.path.join(folder, target[key]))
    lines = job.setdefault("lines", {})
    if not str(lines.get("line", "0"))[:1].isdigit():
        lines["line"] = os.path.normpath(os.path.join(folder, lines["line"]))
    return job


def load_job(document, path):
    """Makes the document objects of a job: model, target line, region and move, not yet computed. Returns the move."""
    job = read_job(path)
    _check_keys(job, path)
    model = create_model(document, job["input"], **job.get("import", {}))
    lines = dict(job["lines"])
    line = str(lines.pop("line", "0"))
    target = _load_target(document, model, line, lines, dict(job["target"]))
    region_keys = job.get("region", {})
    region = create_region(document, target, **region_keys) if region_keys else None
    keys = {**job.get("remesh", {}), **job.get("move", {})}
    if "correspondence" in job["target"]:
        keys["correspondence"] = job["target"]["correspondence"]
    move = create_move(document, target, region, **keys)
    if job.get("description"):
        move.Label = job["description"]
    return move


def _load_target(document, model, line, lines, keys):
    """A target read from a file is stored in the document; otherwise the recipe comes as properties. Edits by a file
    are applied at once, since the document says moves by hand in another way."""
    keys.pop("correspondence", None)
    path, edit = keys.pop("target", None), keys.pop("edit", None)
    tapeline = engine.module()
    if path is not None:
        stored = tapeline.TargetLine.read(path)
        return create_target(document, model, line, stored=stored, **lines)
    if edit is not None:
        engine_model = models.load(models.source_of(model))
        stored = engine_model.fit_target(models.line_of(engine_model, line, lines), edit=edit, **keys)
        return create_target(document, model, line, stored=stored, **lines)
    return create_target(document, model, line, **lines, **{k: v for k, v in keys.items() if k in TARGET_KEYS})


def _check_keys(job, path):
    """Lets no key pass that the option table does not know."""
    known = {(option["section"], option["name"]) for option in engine.module().options()}
    for section, values in job.items():
        if section in ("$schema", "description", "input"):
            continue
        if not isinstance(values, dict):
            raise engine.UserError(translate("Tapeline", "'{}': '{}' is no section of a job.").format(path, section))
        for key in values:
            if (section, key) not in known:
                raise engine.UserError(translate("Tapeline", "'{}': there is no option '{}.{}'.")
                                       .format(path, section, key))


def write_result(move, path, ascii=False):
    """Writes a move's surface as STL, OBJ, PLY or OFF with all its digits."""
    source = models.source_of(move)
    engine.module().Model.from_arrays(source.vertices, source.faces).write(path, ascii=ascii)


__all__ = ["load_job", "read_job", "save_job", "write_result"]
