# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds the compiled module `tapeline`, which does all the geometry, and says so politely where it is missing."""
import importlib
import os
import sys

from . import SOURCE, settings
from .text import translate

_module = None


class EngineMissing(Exception):
    """The compiled module cannot be loaded; the text is a sentence with the remedy."""


def candidate_folders():
    """Where the module may lie beside Python's own folders: the preference, the environment, a build next to the
    addon (for one that is linked from a source folder), and the place where `cmake --install` puts both."""
    version = f"python{sys.version_info.major}.{sys.version_info.minor}"
    prefix = os.path.abspath(os.path.join(SOURCE, os.pardir, os.pardir, os.pardir))
    folders = [settings.module_folder(), os.environ.get("TAPELINE_MODULE_FOLDER", "")]
    folders += [os.path.join(SOURCE, "build", preset, "python") for preset in ("release", "dev")]
    for library in ("lib", "lib64"):
        folders += [os.path.join(prefix, library, *tail)
                    for tail in (("python3", "dist-packages"), (version, "site-packages"), (version, "dist-packages"))]
    return [folder for folder in folders if folder and os.path.isdir(os.path.join(folder, "tapeline"))]


def _import():
    """The module, or None where there is none. A mere folder of that name on the path, such as a source folder called
    tapeline, imports as an empty package and does not count."""
    try:
        found = importlib.import_module("tapeline")
    except ModuleNotFoundError as error:
        if error.name != "tapeline":
            raise
        return None
    if getattr(found, "__file__", None) is None:
        del sys.modules["tapeline"]
        return None
    return found


def _load():
    found = _import()
    for folder in candidate_folders():
        if found is None:
            sys.path.append(folder)
            importlib.invalidate_caches()
            found = _import()
            if found is None:
                sys.path.remove(folder)
    return found


def module():
    """The compiled module; raises EngineMissing with a sentence."""
    global _module
    if _module is None:
        try:
            _module = _load()
        except ImportError as error:
            raise EngineMissing(translate("Tapeline", "The compiled Python module 'tapeline' cannot be loaded: {}. "
                                          "Build or install it anew.").format(error)) from None
        if _module is None:
            raise EngineMissing(translate("Tapeline", "The compiled Python module 'tapeline' was not found, so nothing "
                                          "can be computed. Build it (scripts/test) or install it (cmake --install), "
                                          "or name its folder in Edit > Preferences > Tapeline."))
    return _module


def available():
    try:
        module()
    except EngineMissing:
        return False
    return True


def errors():
    """The exceptions that carry a sentence for the user."""
    known = (EngineMissing, UserError)
    return known + ((module().TapelineError,) if available() else ())


class UserError(Exception):
    """Something the user can put right; the text is a sentence with the remedy."""
