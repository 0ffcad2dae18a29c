# SPDX-License-Identifier: GPL-3.0-or-later
"""Document properties made from the engine's option table: names, types, units, ranges, choices and help come from
there, so that the property sheet, the command line and job files speak of the same things."""
from . import engine

# Options that a document object says by links or that only matter for files.
LINKED = {"description", "input", "target", "edit", "line"}


# Names that FreeCAD's own objects have already.
RENAMED = {"placement": "LinePlacement"}


def table(sections):
    """The options of these sections of a job, in the table's order."""
    wanted = [option for option in engine.module().options() if option["section"] in sections]
    return [option for option in wanted if option["name"] not in LINKED]


def option(name):
    """One option of a job by its key."""
    return next(option for option in engine.module().options()
                if option["name"] == name and option["section"] != "command")


def property_name(key):
    """RoiDistance for roi_distance."""
    if key in RENAMED:
        return RENAMED[key]
    return "".join(part.capitalize() for part in key.split("_"))


def group_name(section):
    return section.capitalize()


def property_type(option):
    """The FreeCAD property type that fits an option."""
    kind, unit, least = option["type"], option.get("unit") or "", option.get("minimum")
    if option.get("choices") and kind == "str":
        return "App::PropertyEnumeration"
    if kind == "float":
        if unit == "mm":
            return "App::PropertyLength" if least is not None and least >= 0 else "App::PropertyDistance"
        return "App::PropertyAngle" if unit == "deg" else "App::PropertyFloat"
    return {
        "bool": "App::PropertyBool",
        "int": "App::PropertyInteger",
        "str": "App::PropertyString",
        "path": "App::PropertyFile",
        "list[float]": "App::PropertyFloatList",
        "list[int]": "App::PropertyIntegerList",
        "list[str]": "App::PropertyStringList",
        "list[line]": "App::PropertyStringList",
    }.get(kind, "App::PropertyString")


def tooltip(option):
    """Help, unit, range and default as one text."""
    text = option["help"]
    low, high = option.get("minimum"), option.get("maximum")
    unit = (" " + option["unit"]) if option.get("unit") else ""
    if low is not None and high is not None:
        text += f" {low:g} to {high:g}{unit}."
    elif low is not None:
        text += f" At least {low:g}{unit}."
    if option.get("zero"):
        text += f" 0 or empty: {option['zero']}."
    return text


def add(obj, sections, only=None):
    """Adds the options of some sections of the table as properties that the object does not have yet."""
    for option in table(sections):
        if only is not None and option["name"] not in only:
            continue
        name = property_name(option["name"])
        if name in obj.PropertiesList:
            continue
        kind = property_type(option)
        obj.addProperty(kind, name, group_name(option["section"]), tooltip(option))
        if kind == "App::PropertyEnumeration":
            setattr(obj, name, list(option["choices"]))
        if option.get("default") is not None:
            setattr(obj, name, option["default"])


def value_of(obj, option):
    """An option's value as the engine takes it."""
    value = getattr(obj, property_name(option["name"]))
    if hasattr(value, "Value"):  # a quantity
        value = value.Value
    return list(value) if isinstance(value, (tuple, list)) else value


def keys(obj, sections):
    """The options of some sections that differ from their defaults, as keyword arguments for the engine."""
    chosen = {}
    for option in table(sections):
        if property_name(option["name"]) not in obj.PropertiesList:
            continue
        value, default = value_of(obj, option), option.get("default")
        if value != (default if default is not None else type(value)()):
            chosen[option["name"]] = value
    return chosen


def assign(obj, values):
    """Sets properties from keyword arguments; keys that the object has no property for are returned."""
    left = {}
    for key, value in values.items():
        name = property_name(key)
        if name in obj.PropertiesList:
            setattr(obj, name, value)
        else:
            left[key] = value
    return left


def sections_of(values):
    """Keyword arguments sorted into the sections of a job file."""
    by_name = {option["name"]: option["section"] for option in engine.module().options()
               if option["section"] != "command"}
    job = {}
    for key, value in values.items():
        section = by_name[key]
        if section:
            job.setdefault(section, {})[key] = value
        else:
            job[key] = value
    return job
