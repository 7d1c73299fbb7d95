# HexFeatureWB - LGPL-2.1-or-later
"""Commands, keys, icons, preferences and words."""
import os
import unittest

import driver
import FreeCAD
import FreeCADGui
import make_parts
from driver import child, live, picture, wait_until
from gui_test import GuiTest
from PySide import QtGui

from HexFeatureWB.gui import commands, fem_menu, messages, preferences, settings, task_panel, widgets

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


class TestCommands(GuiTest):
    def test_menu_and_toolbar_in_the_fem_workbench_and_in_our_own(self):
        document, part = driver.show_part(make_parts.box())
        FreeCADGui.Selection.addSelection(part)
        window = FreeCADGui.getMainWindow()
        live(1.0)
        bar = child(window, "HexFeature_InFem", QtGui.QToolBar)
        self.assertTrue(bar.isVisible())
        texts = [a.text() for a in bar.actions()]
        self.assertEqual(len(texts), 7)
        self.assertEqual(self.menus().count("Hex mesh"), 1)
        enabled = {a.text(): a.isEnabled() for a in bar.actions()}
        self.assertTrue(enabled["Hex mesh from solid"])
        self.assertFalse(enabled["Mesh quality"])
        for each in bar.actions():
            self.assertFalse(each.icon().isNull(), each.text())
            self.assertGreater(len(each.toolTip()), 40)
        FreeCADGui.activateWorkbench("HexFeatureWorkbench")
        live(0.3)
        self.assertFalse(bar.isVisible())
        self.assertEqual(self.menus().count("Hex mesh"), 1)
        self.assertEqual(set(commands.COMMANDS) - set(FreeCADGui.listCommands()), set())
        picture("workbench")
        FreeCADGui.activateWorkbench("PartWorkbench")
        live(0.3)
        self.assertNotIn("Hex mesh", self.menus())
        FreeCADGui.activateWorkbench("FemWorkbench")
        live(0.3)
        self.assertTrue(bar.isVisible())
        self.assertEqual(self.menus()[-3:], ["Hex mesh", "Windows", "Help"])

    def test_icons_are_seen_on_light_and_dark_themes(self):
        names = sorted(name[:-4] for name in os.listdir(os.path.join(ROOT, "Resources", "icons")) if name.endswith(".svg"))
        sheet = QtGui.QImage(60 * len(names), 120, QtGui.QImage.Format_RGB32)
        sheet.fill(QtGui.QColor(128, 128, 128))
        for row, background in enumerate((240, 45)):
            for column, name in enumerate(names):
                image = QtGui.QImage(24, 24, QtGui.QImage.Format_RGB32)
                image.fill(QtGui.QColor(background, background, background))
                painter = QtGui.QPainter(image)
                painter.drawPixmap(0, 0, messages.qicon(name).pixmap(24, 24))
                painter.end()
                light = [QtGui.qGray(image.pixel(x, y)) for x in range(24) for y in range(24)]
                seen = sum(abs(value - background) > 60 for value in light)
                self.assertGreater(seen, 60, (name, background))  # of 576
                painter = QtGui.QPainter(sheet)
                painter.drawImage(60 * column + 18, 60 * row + 18, image)
                painter.end()
        if driver.OUT:
            sheet.save(os.path.join(driver.OUT, "icons.png"))

    def test_the_keys_open_the_panel_in_the_fem_workbench(self):
        for visited in (False, True):  # with our own workbench's actions beside it and without
            if visited:
                FreeCADGui.activateWorkbench("HexFeatureWorkbench")
                live(0.3)
                FreeCADGui.activateWorkbench("FemWorkbench")
                live(0.3)
            document, part = driver.show_part(make_parts.box())
            FreeCADGui.Selection.addSelection(part)
            bar = child(FreeCADGui.getMainWindow(), fem_menu.NAME, QtGui.QToolBar)
            wait_until(bar.actions()[0].isEnabled)
            live(0.3)
            try:
                driver.press_keys("H", "M")
            except OSError as error:
                self.skipTest(str(error))
            wait_until(FreeCADGui.Control.activeDialog, 30)
            panel = task_panel.current
            driver.press_keys("5", "Tab", focus=False)  # the size has the keyboard
            wait_until(lambda: panel.size.value() == 5, 30)
            driver.press_keys("Control_L+Return", focus=False)
            wait_until(lambda: panel.mesh is not None and panel.job is None)
            self.assertEqual(panel.mesh.HexCount, 80)
            driver.press_keys("Escape", focus=False)
            wait_until(lambda: not FreeCADGui.Control.activeDialog(), 30)
            FreeCAD.closeDocument(document.Name)

    def test_the_users_own_keys_go_before_ours(self):
        class Window:  # where FreeCAD has no actions of its own for our commands yet
            def findChild(self, kind, name):
                return None

        own = FreeCAD.ParamGet(fem_menu.SHORTCUTS)
        window = FreeCADGui.getMainWindow()
        bar = child(window, fem_menu.NAME, QtGui.QToolBar)
        action = fem_menu._ours["HexFeature_Export"]
        menu = child(window.menuBar(), fem_menu.NAME, QtGui.QMenu)
        own.SetString("HexFeature_Export", "Ctrl+Alt+E")
        try:
            fem_menu._fill(Window(), bar, menu)
            self.assertIn(action, bar.actions())
            self.assertEqual(action.shortcut().toString(), "Ctrl+Alt+E")
        finally:
            own.RemString("HexFeature_Export")
        fem_menu._fill(Window(), bar, menu)
        self.assertEqual(action.shortcut().toString(), "H, E")
        fem_menu._fill(window, bar, menu)

    def test_preferences_are_the_defaults_of_a_new_mesh(self):
        page = preferences.PreferencesPage()
        page.loadSettings()
        order = next(o for o in page.options if o.spec["name"] == "order")
        order.set_value(1)
        page.switches["QualityAfterMeshing"].setChecked(True)
        page.saveSettings()
        page.form.resize(560, 640)
        page.form.show()
        picture("preferences", page.form)
        page.form.close()
        document, part = driver.show_part(make_parts.box())
        mesh = self.mesh(part, 5)
        self.assertEqual((mesh.Order, mesh.ViewObject.DisplayMode), (1, "Quality"))
        order.set_value(2)
        page.switches["QualityAfterMeshing"].setChecked(False)
        page.saveSettings()


class TestWords(unittest.TestCase):
    def test_every_step_and_option_has_a_name_for_people(self):
        import re

        steps = set()
        for folder, _, files in os.walk(os.path.join(ROOT, "cpp")):
            for name in files:
                with open(os.path.join(folder, name), encoding="utf-8") as f:
                    steps |= set(re.findall(r'(?:begin|progress)\("([a-z -]+)"', f.read()))
        self.assertGreater(len(steps), 8)
        self.assertEqual(steps - set(messages.step_titles()), set())
        for spec in settings.option_specs():
            self.assertTrue(widgets.has_title(spec["name"]), spec["name"])
            for choice in spec["choices"]:
                self.assertNotEqual(widgets.choice_title(spec["name"], choice), choice)

    def test_the_german_file_is_complete(self):
        with open(os.path.join(ROOT, "Resources", "translations", "HexFeature_de.ts"), encoding="utf-8") as f:
            self.assertNotIn("unfinished", f.read())
