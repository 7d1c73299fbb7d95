# HexFeatureWB - LGPL-2.1-or-later
"""What every test of the window stands on, and their runner."""
import importlib
import os
import unittest

import driver
import FreeCAD
import FreeCADGui
from driver import child, live, wait_until

from HexFeatureWB.gui import commands, settings, task_panel


class GuiTest(unittest.TestCase):
    def setUp(self):
        settings.group().Clear() if hasattr(settings.group(), "Clear") else None
        FreeCADGui.activateWorkbench("FemWorkbench")
        driver.prepare_window()  # workbenches bring their docks back

    def tearDown(self):
        FreeCADGui.Control.closeDialog()
        live()
        for name in list(FreeCAD.listDocuments()):
            FreeCAD.closeDocument(name)
        live()

    @staticmethod
    def menus():
        """Titles of the menus that are seen, in order."""
        actions = FreeCADGui.getMainWindow().menuBar().actions()
        return [a.text().replace("&", "").strip() for a in actions if a.isVisible() and not a.isSeparator()]

    @staticmethod
    def recorded(action):
        """The lines that the macro recorder gets while `action` is done."""
        lines, real = [], FreeCADGui.doCommand

        def recorded(line):
            lines.append(line)
            return real(line)

        FreeCADGui.doCommand = recorded
        try:
            action()
        finally:
            FreeCADGui.doCommand = real
        return lines

    def open_panel(self, part):
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(part)
        live(0.5)
        driver.action("Hex mesh from solid").trigger()
        live()
        return task_panel.current

    def mesh(self, part, size):
        panel = self.open_panel(part)
        panel.size.set_value(size)
        wait_until(lambda: not panel.preview.busy)
        child(panel.form, "mesh_button").click()
        wait_until(lambda: panel.job is None)
        self.assertIsNotNone(panel.mesh, panel.state.text())
        panel.reject()
        live()
        return panel.mesh

    @staticmethod
    def export(path, kind):
        """Press *Export mesh* with nothing selected; the file dialog answers `path` and the kind of that index."""
        asked, commands.ask_file = commands.ask_file, lambda title, start, filters: (path, filters[kind])
        try:
            FreeCADGui.Selection.clearSelection()
            live(0.5)
            driver.action("Export mesh").trigger()
        finally:
            commands.ask_file = asked


#: in this order; the German one last
MODULES = ("test_workbench", "test_panel", "test_document", "test_tasks")


def run():
    """All tests, or those that HEXFEATURE_GUI_TESTS names (TestClass[.test] ...). Returns the exit code."""
    os.environ["HEXFEATURE_NO_BOXES"] = "1"
    driver.prepare_window()
    loader = unittest.TestLoader()
    modules = [importlib.import_module(name) for name in MODULES]
    suite = unittest.TestSuite()
    wanted = os.environ.get("HEXFEATURE_GUI_TESTS", "").split()
    for name in wanted:
        suite.addTest(loader.loadTestsFromName(name, next(m for m in modules if hasattr(m, name.partition(".")[0]))))
    for module in [] if wanted else modules:
        suite.addTest(loader.loadTestsFromModule(module))
    # Not FreeCAD's own output, which it shows in a window that opens by itself.
    stream = os.fdopen(os.dup(1), "w", buffering=1)
    result = unittest.TextTestRunner(stream=stream, verbosity=2).run(suite)
    return 0 if result.wasSuccessful() and result.testsRun else 1
