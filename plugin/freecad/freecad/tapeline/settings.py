# SPDX-License-Identifier: GPL-3.0-or-later
"""The user's preferences, as the preferences page stores them, with their defaults."""
import FreeCAD as App

GROUP = "User parameter:BaseApp/Preferences/Mod/Tapeline"

# Name -> (default for amber, default for red): a measure beyond amber is amber, beyond red is red.
LIMITS = {
    "Bulge": (0.05, 0.1),
    "Inflections": (0.5, 1.5),
    "CreaseAngle": (3.0, 6.0),
    "LineError": (1e-9, 1e-6),
}


def _group():
    return App.ParamGet(GROUP)


def module_folder():
    return _group().GetString("ModuleFolder", "")


def preview_budget():
    """Milliseconds that a preview may take while the mouse moves."""
    return _group().GetInt("PreviewBudget", 100)


def rest_delay():
    """Milliseconds without movement after which the exact result is computed."""
    return _group().GetInt("RestDelay", 400)


def handle_pixels():
    """Diameter of a control point's handle, in pixels."""
    return _group().GetInt("HandleSize", 11)


def limits(measure):
    """Amber and red limit of a measure, in its unit."""
    amber, red = LIMITS[measure]
    group = _group()
    # The page has spin boxes only for lengths that a hand can type, so the line error's limits are exponents of ten.
    if measure == "LineError":
        return 10.0 ** group.GetInt("LineErrorAmberExponent", -9), 10.0 ** group.GetInt("LineErrorRedExponent", -6)
    return group.GetFloat(measure + "Amber", amber), group.GetFloat(measure + "Red", red)


def grade(measure, value):
    """"green", "amber" or "red" for the value of a measure; "" where there is no value."""
    if value is None:
        return ""
    amber, red = limits(measure)
    size = abs(value)
    if size > red:
        return "red"
    return "amber" if size > amber else "green"


def zebra_stripes():
    return _group().GetInt("ZebraStripes", 24)


def comb_scale():
    """Length of a curvature comb's tooth relative to the automatic one."""
    return _group().GetFloat("CombScale", 1.0)
