# HexFeatureWB - LGPL-2.1-or-later
"""Whole tasks: macros that repeat them, a new user's way from a STEP file to stresses, another language."""
import os
import re
import shutil
import sys
import tempfile
import unittest

import driver
import FreeCAD
import FreeCADGui
import make_parts
from driver import child, live, picture, wait_until
from gui_test import GuiTest
from PySide import QtGui

from HexFeatureWB.gui import messages, quality_panel, refresh_panel, task_panel

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


class TestMacro(GuiTest):
    """Each action leaves lines that repeat it."""

    def test_mesh_and_quality(self):
        document, part = driver.show_part(make_parts.box())

        def act():
            mesh = self.mesh(part, 5)
            FreeCADGui.Selection.addSelection(mesh)
            live(0.5)
            driver.action("Mesh quality").trigger()
            child(quality_panel.current.form, "keep").setChecked(True)
            child(quality_panel.current.form, "cut_axis").setCurrentIndex(1)
            slider = child(quality_panel.current.form, "cut_position")
            slider.setSliderDown(True)
            for value in (60, 70, 80):
                slider.setValue(value)
            slider.setSliderDown(False)
            quality_panel.current.reject()

        lines = self.recorded(act)
        mesh = document.getObject("Part_Mesh")
        count = mesh.HexCount
        document.removeObject(mesh.Name)
        exec("\n".join(lines), {"App": FreeCAD, "Gui": FreeCADGui})
        again = document.getObject("Part_Mesh")
        view = again.ViewObject
        self.assertEqual((again.HexCount, view.CutAxis, view.CutPosition, view.DisplayMode), (count, "X", 80, "Quality"))
        self.assertEqual(sum("CutPosition" in line for line in lines), 1)

    def test_refresh_models_and_export(self):
        document, part = driver.show_part(make_parts.box())
        mesh = self.mesh(part, 5)
        count = mesh.HexCount

        def refresh():
            mesh.ElementSize = 2.5
            FreeCADGui.Selection.clearSelection()
            live(0.5)
            driver.action("Refresh mesh").trigger()
            wait_until(lambda: refresh_panel.current.job is None and not FreeCADGui.Control.activeDialog())

        def models():
            FreeCADGui.Selection.addSelection(part)
            live(0.5)
            driver.action("Show feature lines").trigger()
            driver.action("Show recognition model").trigger()

        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "box.inp")
            lines = [self.recorded(act) for act in (refresh, models, lambda: self.export(path, 0))]
            self.assertEqual(mesh.HexCount, 8 * count)
            os.remove(path)
            for name in ("FeatureLines", "RecognitionModel"):
                document.removeObject(name)
            mesh.ElementSize = 10
            exec("\n".join(sum(lines, [])), {"App": FreeCAD, "Gui": FreeCADGui})
            self.assertEqual(mesh.HexCount, count // 8)
            self.assertTrue(os.path.exists(path))
            self.assertTrue(document.getObject("FeatureLines") and document.getObject("RecognitionModel"))


class TestTried(GuiTest):
    """A task as a new user does it: FreeCAD's own commands and panels, pressed one after the other (docs/freecad/tried.md)."""

    def constraint(self, command, part, face, fill=lambda dialog: None):
        """Make a constraint on a face by its panel. The part must be there to be picked."""
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.runCommand(command, 0)
        live(0.5)
        self.assertTrue(part.ViewObject.Visibility)  # FreeCAD shows the part and hides its mesh
        window = FreeCADGui.getMainWindow()
        add = next(button for button in window.findChildren(QtGui.QToolButton, "btnAdd") if button.isVisible())
        if add.isCheckable():  # what is picked after it is added
            add.click()
        FreeCADGui.Selection.addSelection(part, face)
        live(0.2)
        if not add.isCheckable():
            add.click()
        fill(window)
        live(0.2)
        driver.press_ok()
        live(0.3)

    @unittest.skipUnless(shutil.which("ccx"), "there is no CalculiX")
    def test_from_a_step_file_to_stresses(self):
        import Import
        from HexFeatureWB import analysis

        with tempfile.TemporaryDirectory() as folder:
            document = FreeCAD.newDocument("Bracket")
            document.UndoMode = 1
            Import.insert(make_parts.make("bracket", folder), document.Name)
            part = next(o for o in document.Objects if getattr(o, "Shape", None) and o.Shape.Solids)
            driver.look()
            FreeCADGui.runCommand("FEM_Analysis", 0)
            live(0.3)
            study = next(o for o in document.Objects if o.TypeId.startswith("Fem::FemAnalysis"))
            mesh = self.mesh(part, 4)
            self.assertIn(mesh, study.Group)
            centres = {"Face%d" % n: face.CenterOfMass for n, face in enumerate(part.Shape.Faces, 1)}
            end = max(centres, key=lambda name: centres[name].x)
            top = max(centres, key=lambda name: centres[name].z)
            self.constraint("FEM_ConstraintFixed", part, end)
            picture("tried-constraint")

            def pull(window):
                child(window, "spinForce").setProperty("rawValue", 500.0 if FreeCAD.Version()[0] == "0" else 500000.0)
                # 1.x keeps forces in mN

            self.constraint("FEM_ConstraintForce", part, top, pull)
            force = next(o for o in document.Objects if o.isDerivedFrom("Fem::ConstraintForce"))
            self.assertAlmostEqual(float(getattr(force.Force, "getValueAs", lambda unit: force.Force)("N")), 500, places=6)
            FreeCADGui.runCommand("FEM_MaterialSolid", 0)
            live(0.5)
            FreeCADGui.Control.closeDialog()
            steel = next(o for o in document.Objects if o.isDerivedFrom("App::MaterialObjectPython"))
            steel.Material = {"Name": "Steel", "YoungsModulus": "210000 MPa", "PoissonRatio": "0.30", "Density": "7900 kg/m^3"}
            document.recompute()
            if not any("Solver" in o.TypeId for o in study.Group):  # FreeCAD 1.1 makes none by itself
                FreeCADGui.runCommand("FEM_SolverCalculiXCcxTools", 0)
                live(0.3)
            solver = next(o for o in study.Group if "Solver" in o.TypeId)
            reaction = FreeCAD.Vector(*analysis.total_reaction(analysis.solve(study, solver, folder)))
            self.assertAlmostEqual(reaction.Length, 500, delta=0.5)
            result = next(o for o in study.Group if o.isDerivedFrom("Fem::FemResultObject"))
            stresses = result.vonMises
            shown = result.Mesh.ViewObject
            mesh.ViewObject.Visibility = False
            part.ViewObject.Visibility = False
            shown.Visibility = True
            shown.setNodeColorByScalars(list(result.NodeNumbers), list(stresses))
            driver.look()
            picture("stresses")
            self.assertGreater(max(stresses), 10 * min(stresses))


class TestZGerman(GuiTest):
    def test_every_message_of_the_core_is_found_with_what_is_put_into_it(self):
        sys.path.insert(0, os.path.join(ROOT, "packaging"))
        import translations

        known = translations.read(translations.FOLDER / "HexFeature_de.ts")
        texts = [text for text in translations.core_messages.texts(ROOT) if text in known]
        self.assertGreater(len(texts), 90)
        FreeCADGui.setLocale("German")
        try:
            for text in texts:
                words = messages.in_words("the part is damaged: " + re.sub(r"%\d", "12", text))
                self.assertNotIn(text, words)
                self.assertTrue(words.startswith("das Teil ist beschädigt: "), words)
                self.assertEqual(words.count("12"), text.count("%"), words)
            self.assertEqual(messages.in_words("a line runs from a +X face to itself"),
                             "eine Linie führt von einer +X-Fläche zu ihr selbst")
            self.assertEqual(messages.in_words("cannot write '/a/b c.inp': Permission denied"),
                             "'/a/b c.inp' lässt sich nicht schreiben: Permission denied")
            self.assertEqual(messages.in_words("what nobody knows: 12"), "what nobody knows: 12")
            self.assertEqual(messages.batch_words("result", "failed"), "fehlgeschlagen")
            self.assertEqual(messages.batch_words("why", "smooth: 3 elements stay inverted or folded"),
                             "Glätten: 3 Elemente bleiben umgestülpt oder gefaltet")
            self.assertEqual(messages.batch_words("why", "there is no such file"), "diese Datei gibt es nicht")
            self.assertEqual(messages.batch_words("min_sj", 0.5), 0.5)
        finally:
            FreeCADGui.setLocale("English")

    def test_the_panel_speaks_german(self):
        FreeCADGui.setLocale("German")
        try:
            live(0.3)
            self.assertEqual(self.menus()[-3], "Hex mesh")  # until the workbench is visited again
            FreeCADGui.activateWorkbench("PartWorkbench")
            FreeCADGui.activateWorkbench("FemWorkbench")
            live(0.3)
            self.assertEqual(self.menus()[-3], "Hexaedernetz")
            document, part = driver.show_part(make_parts.box())
            panel = task_panel.open_panel(part)
            wait_until(lambda: not panel.preview.busy)
            self.assertEqual(panel.mesh_button.text(), "Vernetzen")
            picture("panel-german")
            panel.size.set_value(1e4)
            wait_until(lambda: not panel.preview.busy)
            child(panel.form, "mesh_button").click()
            wait_until(lambda: panel.job is None)
            self.assertIn("die Elementgröße ist größer als das Teil", panel.state.text())
            self.assertIn("Länge des Teils von ", panel.state.text())
            panel.reject()
        finally:
            FreeCADGui.setLocale("English")
