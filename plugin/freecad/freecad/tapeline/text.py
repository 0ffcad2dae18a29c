# SPDX-License-Identifier: GPL-3.0-or-later
"""Words that people see: translation, and sentences in the report view."""
import FreeCAD as App


def translate(context, text):
    """The text in the user's language."""
    return App.Qt.translate(context, text)


def QT_TRANSLATE_NOOP(context, text):  # noqa: N802 (the name that translation tools look for)
    """Marks a text for translation where it is used later."""
    return text


def inform(sentence):
    App.Console.PrintMessage("Tapeline: " + sentence + "\n")


def warn(sentence):
    App.Console.PrintWarning("Tapeline: " + sentence + "\n")


def complain(sentence):
    App.Console.PrintError("Tapeline: " + sentence + "\n")


def sentence_of(error):
    """What an exception says, with its kind where it says nothing."""
    return str(error).strip() or type(error).__name__
