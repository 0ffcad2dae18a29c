# SPDX-License-Identifier: GPL-3.0-or-later
"""The window in other languages, switched as FreeCAD's preferences switch it."""
import os
import pathlib
import unittest

import FreeCAD as App
import FreeCADGui as Gui
import window
from common import PANEL, SLIDE
from PySide import QtCore, QtGui

from freecad.tapeline import api, translation_folders
from freecad.tapeline.panels.base import Panel

COMPILED = [name for folder in translation_folders() for name in os.listdir(folder) if name.endswith(".qm")]


@unittest.skipUnless(COMPILED, "no translation is compiled: lrelease was not found (scripts/setup --with-freecad)")
class Languages(unittest.TestCase):
    def setUp(self):
        Gui.activateWorkbench("TapelineWorkbench")
        self.document = App.newDocument("Language")
        window.settle(0.2)

    def tearDown(self):
        if Gui.Control.activeDialog() and Panel.open_panel:
            Panel.open_panel.reject()
        Gui.setLocale("English")
        window.settle(0.2)
        App.closeDocument(self.document.Name)

    def action(self, command):
        return next(action for action in Gui.getMainWindow().findChildren(QtGui.QAction)
                    if action.objectName() == command)

    def test_the_menu_speaks_german_and_french_and_english_again(self):
        for language, text in (("German", "Charakterlinie verschieben…"), ("French", "Déplacer la ligne de caractère…"),
                               ("English", "Move feature line…")):
            Gui.setLocale(language)
            window.settle(0.3)
            self.assertEqual(self.action("Tapeline_Move").text(), text)

    def test_panels_sentences_and_descriptions_speak_german(self):
        api.target_line(api.import_model(PANEL, self.document), slide=SLIDE)
        Gui.setLocale("German")
        for command, title in (("Tapeline_Region", "Bereich"), ("Tapeline_Target", "Ziellinie"),
                               ("Tapeline_Move", "Charakterlinie verschieben")):
            Gui.Selection.clearSelection()
            Gui.runCommand(command)
            panel = Panel.open_panel
            self.assertEqual(panel.form.windowTitle(), title)
            window.wait_until(lambda: not panel.background.busy, 30, "the panel")
            window.settle(0.3)
            window.keep("17_german_" + command)
            if command != "Tapeline_Move":
                panel.reject()
        self.assertIn("weicht aus", panel.verdict.text())
        panel.reject()
        with self.assertRaisesRegex(Exception, "Es gibt keine Linie 9: "):
            api.target_line(self.document.StylingModel, "9")
        described = self.document.TargetLine.getDocumentationOfProperty("Length")
        self.assertEqual(App.Qt.translate("App::Property", described), "Länge der Ziellinie")

    def test_the_preferences_page_speaks_german(self):
        Gui.setLocale("German")
        words = []

        def look():
            for dialog in QtGui.QApplication.topLevelWidgets():
                if dialog.isVisible() and dialog.metaObject().className().endswith("DlgPreferencesImp"):
                    words.extend(label.text() for label in dialog.findChildren(QtGui.QLabel))
                    window.keep("18_german_preferences", dialog.grab().toImage())
                    dialog.reject()

        QtCore.QTimer.singleShot(1500, look)
        Gui.showPreferences("Tapeline", 0)
        self.assertIn("Zeit für eine Vorschau beim Ziehen", words)
        self.assertNotIn("Time for a preview while dragging", words)

    def test_each_language_is_compiled(self):
        folder = pathlib.Path(api.__file__).parent / "resources" / "translations"
        languages = {path.stem for path in folder.glob("tapeline_*.ts")}
        self.assertGreaterEqual(languages, {"tapeline_de", "tapeline_fr"})
        self.assertLessEqual(languages, {name[:-3] for name in COMPILED})


if __name__ == "__main__":
    unittest.main()
