# SPDX-License-Identifier: GPL-3.0-or-later
"""Registers the workbench with FreeCAD's window; everything heavy is imported when it is first used."""
import FreeCADGui as Gui

from . import ICONS, PREFERENCES_PAGE, icon, translation_folders
from .text import QT_TRANSLATE_NOOP, complain, translate

for folder in translation_folders():
    Gui.addLanguagePath(folder)
Gui.updateLocale()


class TapelineWorkbench(Gui.Workbench):
    """The workbench in FreeCAD's list."""

    MenuText = translate("Tapeline", "Tapeline")
    ToolTip = translate("Tapeline", "Move character lines across styled surfaces")
    Icon = icon("tapeline")

    def Initialize(self):  # noqa: N802 (FreeCAD's names)
        from .commands import registry

        names = registry.register()
        self.appendToolbar(QT_TRANSLATE_NOOP("Workbench", "Tapeline"), names)
        self.appendMenu(QT_TRANSLATE_NOOP("Workbench", "&Tapeline"), names)

    def Activated(self):  # noqa: N802
        from . import engine
        from .scene import line_pick

        line_pick.start()
        if not engine.available():
            try:
                engine.module()
            except engine.EngineMissing as error:
                complain(str(error))

    def ContextMenu(self, recipient):  # noqa: N802
        from .commands import registry

        if recipient in ("View", "Tree"):
            self.appendContextMenu(translate("Tapeline", "Tapeline"), registry.names())

    def GetClassName(self):  # noqa: N802
        return "Gui::PythonWorkbench"


Gui.addIconPath(ICONS)
Gui.addPreferencePage(PREFERENCES_PAGE, QT_TRANSLATE_NOOP("QObject", "Tapeline"))
Gui.addWorkbench(TapelineWorkbench())
