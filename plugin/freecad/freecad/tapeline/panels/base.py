# SPDX-License-Identifier: GPL-3.0-or-later
"""What all panels have in common: a form, a line for sentences, a background computation and 3D decorations."""
import contextlib

import FreeCADGui as Gui
from PySide import QtGui

from .. import engine, icon, worker
from ..text import QT_TRANSLATE_NOOP, complain, sentence_of, translate


class Panel:
    """A task panel. Subclasses fill `self.rows` and override `apply`, which may raise a sentence. `title` is marked for
    translation, `heading` is translated."""

    title = ""
    icon_name = "tapeline"
    open_panel = None  # the panel that is open, of any kind

    def __init__(self, document):
        Panel.open_panel = self
        self.document = document
        self.form = QtGui.QWidget()
        self.heading = translate("Tapeline", self.title)
        self.form.setWindowTitle(self.heading)
        self.form.setWindowIcon(QtGui.QIcon(icon(self.icon_name)))
        column = QtGui.QVBoxLayout(self.form)
        self.rows = QtGui.QFormLayout()
        self.rows.setRowWrapPolicy(QtGui.QFormLayout.WrapLongRows)
        self.rows.setFieldGrowthPolicy(QtGui.QFormLayout.AllNonFixedFieldsGrow)
        column.addLayout(self.rows)
        self.message = QtGui.QLabel()
        self.message.setObjectName("message")
        self.message.setWordWrap(True)
        column.addWidget(self.message)
        self.progress = QtGui.QProgressBar()
        self.progress.setRange(0, 1000)
        self.progress.setTextVisible(True)
        self.progress.hide()
        column.addWidget(self.progress)
        self.column = column
        self.background = worker.Latest(self.form)
        self.background.on_progress = self.show_progress
        self._decorations = []

    # What FreeCAD calls.

    def getStandardButtons(self):  # noqa: N802 (FreeCAD's name)
        return buttons(QtGui.QDialogButtonBox.Ok | QtGui.QDialogButtonBox.Cancel)

    def accept(self):
        try:
            self.apply()
        except engine.errors() as error:
            self.say(sentence_of(error), bad=True)
            return False
        self.leave()
        return True

    def reject(self):
        self.cancelled()
        self.leave()
        return True

    # What subclasses override.

    def apply(self):
        """Changes the document."""

    def cancelled(self):
        """Undoes what was only shown."""

    # What subclasses use.

    def leave(self):
        """Removes everything that was drawn, stops computing and closes the panel."""
        self.background.close()
        for decoration in self._decorations:
            with contextlib.suppress(ReferenceError, RuntimeError):  # the document was closed under the panel
                decoration.remove()
        self._decorations.clear()
        Panel.open_panel = None
        Gui.Control.closeDialog()

    def decorate(self, decoration):
        """Remembers something drawn, to remove it when the panel closes."""
        self._decorations.append(decoration)
        return decoration

    @property
    def view(self):
        return Gui.getDocument(self.document.Name).activeView()

    def say(self, sentence, bad=False):
        self.message.setText(sentence)
        self.message.setStyleSheet("color: #b32020;" if bad else "")

    def failed(self, error):
        """A computation in the background failed."""
        self.progress.hide()
        if worker.cancelled(error):
            return
        if not isinstance(error, engine.errors()):
            complain(repr(error))
        self.say(sentence_of(error), bad=True)

    def show_progress(self, fraction, stage):
        self.progress.show()
        self.progress.setValue(int(1000 * fraction))
        self.progress.setFormat(stage or "…")

    def compute(self, work, done, interrupt=True):
        """Runs `work` in the background; only the newest request reports back."""
        def finished(result):
            self.progress.hide()
            done(result)

        self.background.ask(work, finished, self.failed, interrupt)


def buttons(flags):
    """Standard buttons as the number that FreeCAD wants; Qt 5's flags are numbers, Qt 6's have one."""
    return flags.value if hasattr(flags, "value") else int(flags)


def combo(choices, current=None):
    """A list to choose from: (value, text) pairs or plain values."""
    box = QtGui.QComboBox()
    box.setSizeAdjustPolicy(QtGui.QComboBox.AdjustToMinimumContentsLengthWithIcon)
    box.setMinimumContentsLength(6)
    box.setSizePolicy(QtGui.QSizePolicy.Ignored, QtGui.QSizePolicy.Fixed)
    for choice in choices:
        value, text = choice if isinstance(choice, tuple) else (choice, choice)
        box.addItem(text, value)
    if current is not None:
        box.setCurrentIndex(max(0, box.findData(current)))
    return box


def number(value, low, high, decimals=3, suffix="", step=None):
    box = QtGui.QDoubleSpinBox()
    box.setMinimumWidth(60)
    box.setDecimals(decimals)
    box.setRange(low, high)
    box.setSuffix(suffix)
    box.setKeyboardTracking(False)
    box.setValue(value)
    if step:
        box.setSingleStep(step)
    return box


def whole(value, low, high, special=""):
    box = QtGui.QSpinBox()
    box.setRange(low, high)
    box.setKeyboardTracking(False)
    if special:
        box.setSpecialValueText(special)
    box.setValue(value)
    return box


def button(text, action, tip=""):
    push = QtGui.QPushButton(text)
    push.setMinimumWidth(40)
    push.clicked.connect(lambda *_: action())
    push.setToolTip(tip)
    return push


def slim(push):
    """A button no wider than it must be, beside a field."""
    push.setMaximumWidth(30)
    push.setMinimumWidth(30)
    return push


def row(*widgets):
    """Widgets side by side."""
    holder = QtGui.QWidget()
    line = QtGui.QHBoxLayout(holder)
    line.setContentsMargins(0, 0, 0, 0)
    for widget in widgets:
        line.addWidget(widget)
    return holder


def wrapped(text):
    """A text that takes several lines where the panel is narrow."""
    label = QtGui.QLabel(text)
    label.setWordWrap(True)
    return label


class SavedVisibility:
    """Hides objects while a panel draws them in its own way, and brings them back."""

    def __init__(self, *objects):
        self._states = [(obj, obj.ViewObject.Visibility) for obj in objects if obj is not None]
        for obj, _ in self._states:
            obj.ViewObject.Visibility = False

    def remove(self):
        for obj, visible in self._states:
            try:
                obj.ViewObject.Visibility = visible
            except (ReferenceError, RuntimeError):
                pass  # the object is gone
        self._states = []


def default_name(obj, ending):
    """A file name from an object's label."""
    return "".join(c if c.isalnum() or c in "-_ " else "_" for c in obj.Label).strip() + ending


def automatic():
    """What a box shows for the value that lets the engine choose."""
    return translate("Tapeline", "automatic")


# Choices of options that have a plainer name than the engine's word for them.
_CHOICES = {
    "auto": QT_TRANSLATE_NOOP("Tapeline", "automatic"),
    "on-surface": QT_TRANSLATE_NOOP("Tapeline", "on the surface"),
    "off-surface": QT_TRANSLATE_NOOP("Tapeline", "off the surface"),
    "left": QT_TRANSLATE_NOOP("Tapeline", "left"),
    "right": QT_TRANSLATE_NOOP("Tapeline", "right"),
    "free": QT_TRANSLATE_NOOP("Tapeline", "free"),
    "keep": QT_TRANSLATE_NOOP("Tapeline", "kept"),
}


def choice_box(option, value=None):
    """A list of an option's choices, in words."""
    words = [(choice, translate("Tapeline", _CHOICES[choice]) if choice in _CHOICES else choice)
             for choice in option["choices"]]
    box = combo(words, value if value is not None else option["default"])
    box.setObjectName(option["name"])
    return box
