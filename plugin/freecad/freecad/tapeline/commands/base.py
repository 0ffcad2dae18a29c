# SPDX-License-Identifier: GPL-3.0-or-later
"""What all commands have in common."""
import FreeCAD as App
import FreeCADGui as Gui

from .. import engine, icon
from ..text import complain, sentence_of


def show_sentence(sentence, title=""):
    """A sentence for the user: in the report view, and in a box that does not stop the program's tests."""
    from PySide import QtCore, QtGui

    complain(sentence)
    box = QtGui.QMessageBox(QtGui.QMessageBox.Warning, title or "Tapeline", sentence, QtGui.QMessageBox.Ok,
                            Gui.getMainWindow())
    box.setObjectName("TapelineSentence")
    box.setAttribute(QtCore.Qt.WA_DeleteOnClose)
    box.setModal(True)
    box.show()
    return box


def guarded(action):
    """Runs an action of the window; errors that carry a sentence are shown, never a traceback."""
    try:
        return action()
    except engine.errors() as error:
        show_sentence(sentence_of(error))
        return None


class Command:
    """A command of the workbench. FreeCAD translates its texts, with the command's name as their context, again when
    the language changes. `needs_document` greys it out without one; `open` does the work and may raise."""

    name = ""
    icon_name = ""
    menu_text = ""
    tooltip = ""
    shortcut = ""
    needs_document = True

    def GetResources(self):  # noqa: N802 (FreeCAD's names)
        resources = {"Pixmap": icon(self.icon_name), "MenuText": self.menu_text, "ToolTip": self.tooltip}
        if self.shortcut:
            resources["Accel"] = self.shortcut
        return resources

    def IsActive(self):  # noqa: N802
        return not Gui.Control.activeDialog() and (not self.needs_document or App.ActiveDocument is not None)

    def Activated(self, index=0):  # noqa: N802
        def action():
            engine.module()
            self.open()

        guarded(action)

    def open(self):
        raise NotImplementedError

    @staticmethod
    def show(panel):
        """Opens a panel; what was selected is not, so that its highlight does not hide the surface's colours."""
        Gui.Selection.clearSelection()
        Gui.Control.showDialog(panel)
        return panel
