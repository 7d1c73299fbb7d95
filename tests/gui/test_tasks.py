# HexFeatureWB - LGPL-2.1-or-later
"""Whole tasks: macros that repeat them, a new user's way from a STEP file to stresses, another language."""
import os
import re
import shutil
import sys
import tempfile
import time
import unittest

import driver
import FreeCAD
import FreeCADGui
import make_parts
from driver import child, live, picture, wait_until
from gui_test import GuiTest
from PySide import QtCore, QtGui

import HexFeatureWB
from HexFeatureWB.gui import messages, quality_panel, refresh_panel, task_panel, widgets
from HexFeatureWB.job import Job

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


COLUMN = 245  #: pixels of FreeCAD's task column as it is at first; what is wider is cut off


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
        part.ViewObject.Visibility = True
        exec("\n".join(lines), {"App": FreeCAD, "Gui": FreeCADGui})
        again = document.getObject("Part_Mesh")
        view = again.ViewObject
        self.assertEqual((view.Visibility, part.ViewObject.Visibility), (True, False))
        self.assertEqual((again.HexCount, view.CutAxis, view.CutPosition, view.DisplayMode), (count, "X", 80, "Quality"))
        self.assertEqual(sum("CutPosition" in line for line in lines), 1)

    def test_mesh_again_with_other_options(self):
        document, part = driver.show_part(make_parts.box())
        mesh = self.mesh(part, 5)

        def again():
            FreeCADGui.ActiveDocument.setEdit(mesh, 0)
            live()
            panel = task_panel.current
            panel.size.set_value(2.5)
            panel.options["order"].set_value(1)
            child(panel.form, "mesh_button").click()
            wait_until(lambda: panel.job is None)
            panel.reject()

        lines = self.recorded(again)
        made = mesh.HexCount, mesh.FemMesh.NodeCount
        HexFeatureWB.refresh(mesh, size=5, order=2)
        self.assertNotEqual((mesh.HexCount, mesh.FemMesh.NodeCount), made)
        exec("\n".join(lines), {"App": FreeCAD, "Gui": FreeCADGui})
        self.assertEqual((mesh.HexCount, mesh.FemMesh.NodeCount), made)

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
            self.assertEqual(messages.in_words("order is 5 but must lie between 1 and 2"),
                             "Elementordnung ist 5, muss aber zwischen 1 und 2 liegen")
            self.assertEqual(messages.in_words("there is no option 'labels'"), "es gibt keine Option 'labels'")
            self.assertEqual(messages.in_words("3 boundary faces without a quad"), "3 Randflächen ohne Viereck")
            self.assertEqual(messages.in_words("no polycube has a corner of +X -Y +Z"), "kein Polycube hat eine Ecke aus +X -Y +Z")
            self.assertEqual(messages.in_words("the part cannot be analysed (Standard_Failure)"),
                             "das Teil lässt sich nicht untersuchen (Standard_Failure)")
            self.assertEqual(messages.log_in_words("  1.25 s  sheet along charts 1 23 refused: the sheet would be empty"),
                             "  1.25 s  Schicht längs der Bereiche 1 23 abgelehnt: die Schicht wäre leer")
        finally:
            FreeCADGui.setLocale("English")

    def test_every_line_of_the_log_is_german(self):
        runs = (("flange", 4.0, {}), ("pipe_tee", 4.0, {}), ("crank_shaft", 5.0, {}), ("bracket", 4.0, {"method": "tet-split"}))
        lines = []
        for name, size, options in runs:
            job = Job(make_parts.PARTS[name][0]().Solids[0].exportBrepToString(), {"size": size, "order": 2, **options}).start()
            wait_until(lambda: not job.is_alive())
            self.assertIsNone(job.error)
            lines += job.lines
        self.assertGreater(len(lines), 60)

        def long_lines(count):
            many = " ".join(map(str, range(101, 101 + count)))
            return ["  9.00 s  labels: does not fill after 3 rounds: the inside leaks: the axes disagree, charts " + many,
                    "  9.00 s  CAD faces without quads: {0}; not covered: {0} (largest gap 0.1); sharp edges not followed: {0}; "
                    "corners lost: none".format(many),
                    "what nobody knows " + many, "%s nobody knows %s" % (many, many)]

        def seconds(count):
            """Of this thread, the least of some tries."""
            tries = []
            for _ in range(7):
                start = time.thread_time()
                for line in long_lines(count):
                    messages.log_in_words(line)
                tries.append(time.thread_time() - start)
            return min(tries)

        lines += long_lines(300)[:2]
        FreeCADGui.setLocale("German")
        try:
            # The window stands still meanwhile: with the square of the length at most (4; the cube: 8), which is 0.1 s for a long line.
            self.assertLess(seconds(600) / seconds(300), 6)
            for line in lines:
                words = messages.log_in_words(line)
                self.assertNotEqual(words, line)
                self.assertEqual(re.findall(r"\d+", words), re.findall(r"\d+", line))
                self.assertFalse(re.findall(r"\b(?:the|of|with|step|edges|none|sheets|charts)\b", words), words)
        finally:
            FreeCADGui.setLocale("English")

    def test_the_property_editor_speaks_german(self):
        document, part = driver.show_part(make_parts.box())
        mesh = HexFeatureWB.mesh(part, size=5)
        FreeCADGui.setLocale("German")
        try:
            for name in mesh.PropertiesList:
                if mesh.getGroupOfProperty(name).startswith("Hex mesh"):
                    for text in (re.sub(r"(?<=[a-z])(?=[A-Z])", " ", name), mesh.getDocumentationOfProperty(name),
                                 mesh.getGroupOfProperty(name)):
                        self.assertTrue(text in ("Beta", "Threads") or FreeCAD.Qt.translate("App::Property", text) != text, text)
        finally:
            FreeCADGui.setLocale("English")

    def test_numbers_are_as_the_language_has_them(self):
        system = QtCore.QLocale()
        try:
            for language, lengths, count, share in (
                    ("English", "en_US", "12,345", "0.838"), ("German", "de_DE", "12.345", "0,838"),
                    ("German", "C", "12\N{NO-BREAK SPACE}345", "0,838"), ("English", "de_DE", "12\N{NO-BREAK SPACE}345", "0.838")):
                FreeCADGui.setLocale(language)
                QtCore.QLocale.setDefault(QtCore.QLocale(lengths))  # what FreeCAD writes the size with, beside the count
                self.assertEqual((widgets.number(12345), widgets.number(345), widgets.decimal(0.8376, 3)), (count, "345", share))
        finally:
            QtCore.QLocale.setDefault(system)
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
            self.assertLess(panel.form.minimumSizeHint().width(), COLUMN)
            picture("panel-german")
            panel.size.set_value(1e4)
            wait_until(lambda: not panel.preview.busy)
            child(panel.form, "mesh_button").click()
            wait_until(lambda: panel.job is None)
            self.assertIn("die Elementgröße ist größer als das Teil", panel.state.text())
            self.assertIn("Länge des Teils von ", panel.state.text())
            panel.reject()
            quality = quality_panel.open_panel(HexFeatureWB.mesh(part, size=5))
            live()
            self.assertLess(quality.form.minimumSizeHint().width(), COLUMN)
            picture("quality-german")
            quality.reject()
        finally:
            FreeCADGui.setLocale("English")
