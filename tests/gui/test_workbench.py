# HexFeatureWB - LGPL-2.1-or-later
"""The workbench as a user sees it: real buttons of a real FreeCAD. Run by tests/gui/run.sh."""
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

import driver
import FreeCAD
import FreeCADGui
import make_parts
from driver import child, live, picture, wait_until
from PySide import QtGui

import HexFeatureWB
from HexFeatureWB import mesh_object
from HexFeatureWB.gui import batch_dialog, commands, messages, preferences, quality_panel, record, refresh_panel, selection, settings
from HexFeatureWB.gui import task_panel, widgets

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


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
        self.assertIn("Hex mesh", [a.text().replace("&", "") for a in window.menuBar().actions()])
        enabled = {a.text(): a.isEnabled() for a in bar.actions()}
        self.assertTrue(enabled["Hex mesh from solid"])
        self.assertFalse(enabled["Mesh quality"])
        for each in bar.actions():
            self.assertFalse(each.icon().isNull(), each.text())
            self.assertGreater(len(each.toolTip()), 40)
        FreeCADGui.activateWorkbench("HexFeatureWorkbench")
        live(0.3)
        self.assertFalse(bar.isVisible())
        self.assertEqual(set(commands.COMMANDS) - set(FreeCADGui.listCommands()), set())
        picture("workbench")
        FreeCADGui.activateWorkbench("FemWorkbench")
        live(0.3)
        self.assertTrue(bar.isVisible())

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
            live(0.6)
            try:
                driver.press_keys("H", "M")
            except OSError as error:
                self.skipTest(str(error))
            live(0.5)
            self.assertIsNotNone(FreeCADGui.Control.activeDialog() or None, "visited: %s" % visited)
            task_panel.current.reject()
            FreeCAD.closeDocument(document.Name)

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


class TestTaskPanel(GuiTest):
    def test_from_the_selection_to_the_mesh(self):
        document, part = driver.show_part(make_parts.connecting_rod(), "ConnectingRod")
        panel = self.open_panel(part)
        wait_until(lambda: not panel.preview.busy)
        self.assertGreater(len(panel.preview.stage["arcs"]), 20)
        self.assertFalse(part.ViewObject.Visibility)  # its coloured picture stands there
        driver.say("preview of the connecting rod: %.2f s" % panel.preview.seconds)
        picture("panel-preview")
        before = panel.estimate.text()
        child(panel.form, "size_slider").setValue(panel.slider.value() + 25)
        self.assertNotEqual(panel.estimate.text(), before)
        size = panel.size.value()
        wait_until(lambda: not panel.preview.busy)
        child(panel.form, "mesh_button").click()
        self.assertFalse(panel.mesh_button.isEnabled())
        wait_until(lambda: panel.job is None)
        mesh = panel.mesh
        self.assertEqual(mesh.FemMesh.HexaCount, mesh.HexCount)
        self.assertAlmostEqual(float(mesh.ElementSize.Value), size)
        self.assertIn(messages.number(mesh.HexCount), panel.state.text())
        self.assertLess(abs(mesh.HexCount - panel.estimated_count()) / mesh.HexCount, 0.5)
        self.assertTrue(panel.log.toPlainText())
        picture("panel-meshed")
        panel.reject()
        self.assertFalse(FreeCADGui.Control.activeDialog())
        self.assertFalse(part.ViewObject.Visibility)
        self.assertTrue(mesh.ViewObject.Visibility)

    def test_the_preview_shows_first_labels_while_they_are_repaired(self):
        document, part = driver.show_part(make_parts.pipe_tee())
        panel = self.open_panel(part)
        panel.preview.pause()
        shown = []
        ready = panel.preview._ready
        panel.preview._ready = lambda job: (ready(job), shown.append((panel.preview.final, list(panel.preview.stage["label"]))))
        panel.size.set_value(3.0)
        panel.preview._poll.setInterval(1)
        wait_until(lambda: not panel.preview.busy)
        self.assertTrue(shown[-1][0])
        if len(shown) > 1:  # on a fast machine the repair may be over before anyone has looked
            self.assertFalse(shown[0][0])
            self.assertNotEqual(shown[0][1], shown[1][1])

    def test_cancel_at_any_step(self):
        document, part = driver.show_part(make_parts.crank_shaft())
        panel = self.open_panel(part)
        panel.size.set_value(2.0)
        wait_until(lambda: not panel.preview.busy)
        names = [o.Name for o in document.Objects]
        cancelled_in, longest = set(), 0
        for patience in (0.02, 0.3, 0.8, 1.5, 3.0):
            child(panel.form, "mesh_button").click()
            live(patience)
            job = panel.job
            if job is None:
                break
            if patience == 3.0:
                picture("panel-running")
            cancelled_in.add(job.step)
            child(panel.form, "cancel_button").click()
            longest = max(longest, wait_until(lambda: panel.job is None))
            self.assertEqual(job.error.kind, "cancelled")
            self.assertEqual([o.Name for o in document.Objects], names)
            self.assertTrue(panel.mesh_button.isEnabled())
            wait_until(lambda: not panel.preview.busy)
        driver.say("cancelled in %s; longest answer %.2f s" % (sorted(cancelled_in), longest))
        self.assertGreater(len(cancelled_in), 1)
        picture("panel-cancelled")

    def test_closing_the_panel_leaves_nothing_behind(self):
        document, part = driver.show_part(make_parts.box())
        graph = FreeCADGui.ActiveDocument.ActiveView.getSceneGraph()
        children = graph.getNumChildren()
        panel = self.open_panel(part)
        wait_until(lambda: not panel.preview.busy)
        child(panel.form, "mesh_button").click()
        panel.reject()
        live(0.3)
        self.assertEqual(graph.getNumChildren(), children)
        self.assertEqual(len(document.Objects), 1)
        self.assertTrue(part.ViewObject.Visibility)

    def test_a_failure_says_why_and_shows_the_faces(self):
        document, part = driver.show_part(make_parts.bracket())
        panel = self.open_panel(part)
        wait_until(lambda: not panel.preview.busy)
        panel.size.set_value(1e4)
        wait_until(lambda: not panel.preview.busy)
        self.assertIn("larger than the part", panel.preview_text.text())
        child(panel.form, "mesh_button").click()
        wait_until(lambda: panel.job is None)
        self.assertIn("larger than the part", panel.state.text())
        self.assertIn("Try:", panel.state.text())
        error = HexFeatureWB.MeshingError("labels: made for the test")
        error.kind, error.step, error.cad_faces = "no_mesh", "labels", [3, 7]
        error.reason, error.hint = "the faces meet at a knife edge", "thicken the part there or leave the edge out"
        panel._failed(error)
        selected = FreeCADGui.Selection.getSelectionEx()[0].SubElementNames
        self.assertEqual(sorted(selected), ["Face3", "Face7"])
        self.assertTrue(part.ViewObject.Visibility)
        picture("panel-failed")

    def test_a_mesh_that_freecad_cannot_take_is_a_failure(self):
        from HexFeatureWB import fem_mesh
        from HexFeatureWB.gui import run

        class NoRoom(fem_mesh.FemMeshBuilder):
            def __init__(self, result):
                raise RuntimeError("no room")

        class HalfRoom(fem_mesh.FemMeshBuilder):
            CHUNK = 50

            def _chunks(self, *arrays):
                yield next(super()._chunks(*arrays))
                raise MemoryError

        document, part = driver.show_part(make_parts.box())
        panel = self.open_panel(part)
        panel.size.set_value(5.0)
        wait_until(lambda: not panel.preview.busy)
        try:
            for builder, said in ((NoRoom, "no room"), (HalfRoom, "MemoryError")):
                run.FemMeshBuilder = builder
                child(panel.form, "mesh_button").click()
                job = panel.job
                wait_until(lambda: panel.job is None, 30)
                self.assertEqual((job.result, job.error.kind, job.error.step), (None, "no_mesh", "build"))
                self.assertIn(said, panel.state.text())
                self.assertEqual(document.Objects, [part])
        finally:
            run.FemMeshBuilder = fem_mesh.FemMeshBuilder
        child(panel.form, "mesh_button").click()
        wait_until(lambda: panel.job is None)
        self.assertEqual(panel.mesh.FemMesh.VolumeCount, 80)

    def test_a_body_a_link_and_one_solid_of_a_compound(self):
        import Part

        document = FreeCAD.newDocument("Kinds")
        body = document.addObject("PartDesign::Body", "Body")
        box = document.addObject("PartDesign::AdditiveBox", "Box")
        body.addObject(box)
        link = document.addObject("App::Link", "Link")
        link.LinkedObject = body
        pair = document.addObject("Part::Feature", "Pair")
        other = make_parts.box()
        other.translate(FreeCAD.Vector(0, 50, 0))
        pair.Shape = Part.makeCompound([make_parts.box(), other])
        document.recompute()
        for obj in (body, link):
            self.assertGreater(self.mesh(obj, 5).HexCount, 7)
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(document.Name, pair.Name, "Face8")
        live(0.5)
        driver.action("Hex mesh from solid").trigger()
        panel = task_panel.current
        self.assertEqual(panel.solid.currentIndex(), 2)
        panel.size.set_value(5)
        child(panel.form, "mesh_button").click()
        wait_until(lambda: panel.job is None)
        mesh = panel.mesh
        names = {mesh.FemMesh.getGroupName(g) for g in mesh.FemMesh.Groups}
        self.assertTrue({"Face7", "Face12", "Solid2"} <= names)
        self.assertFalse({"Face1", "Solid1"} & names)

    def test_what_a_selected_container_stands_for(self):
        document = FreeCAD.newDocument("Container")
        container = document.addObject("App::Part", "Assembly")
        box = document.addObject("Part::Box", "Box")
        container.addObject(box)
        document.recompute()
        FreeCADGui.Selection.addSelection(container)
        live()
        self.assertEqual(selection.parts(), [(box, 0)])
        self.assertGreater(self.mesh(container, 5).HexCount, 7)

    def test_double_click_edits(self):
        document, part = driver.show_part(make_parts.box())
        mesh = self.mesh(part, 5)
        count = mesh.HexCount
        FreeCADGui.ActiveDocument.setEdit(mesh, 0)
        live()
        panel = task_panel.current
        self.assertIs(panel.mesh, mesh)
        panel.size.set_value(2.5)
        child(panel.form, "mesh_button").click()
        wait_until(lambda: panel.job is None)
        self.assertEqual(mesh.HexCount, 8 * count)
        self.assertFalse(mesh.NeedsRefresh)
        self.assertEqual(len([o for o in document.Objects if mesh_object.is_hex_mesh(o)]), 1)


class TestDocument(GuiTest):
    def test_undo_redo_copy_save_reopen(self):
        document, part = driver.show_part(make_parts.box())
        mesh = self.mesh(part, 5)
        name, count = mesh.Name, mesh.FemMesh.HexaCount
        FreeCADGui.runCommand("Std_Undo", 0)
        live()
        self.assertIsNone(document.getObject(name))
        FreeCADGui.runCommand("Std_Redo", 0)
        live()
        mesh = document.getObject(name)
        self.assertEqual(mesh.FemMesh.HexaCount, count)
        copy = document.copyObject(mesh)
        self.assertEqual((copy.FemMesh.HexaCount, copy.MadeOf), (count, mesh.MadeOf))
        record.set_view(mesh, "DisplayMode", "Quality")
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "saved.FCStd")
            document.saveAs(path)
            FreeCAD.closeDocument(document.Name)
            live()
            document = FreeCAD.openDocument(path)
            live(0.3)
            mesh = document.getObject(name)
            self.assertEqual((mesh.FemMesh.HexaCount, mesh.NeedsRefresh), (count, False))
            self.assertEqual(mesh.ViewObject.DisplayMode, "Quality")
            driver.look()
            self.assertGreater(driver.colours_of_view()["blue"], 30)

    def test_a_document_saved_without_a_window_shows_its_mesh(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "headless.FCStd")
            macro = os.path.join(folder, "make.py")
            with open(macro, "w") as f:
                f.write(
                    "import os, FreeCAD, Part, HexFeatureWB\n"
                    "d = FreeCAD.newDocument('H')\np = d.addObject('Part::Feature', 'P')\np.Shape = Part.makeBox(40, 10, 10)\n"
                    "HexFeatureWB.mesh(p, size=2.5)\nd.saveAs(%r)\nos._exit(0)\n" % path
                )
            subprocess.run(["freecadcmd", "-P", os.path.join(ROOT, "python"), macro], stdin=subprocess.DEVNULL,
                           stdout=subprocess.DEVNULL, timeout=120, env={**os.environ, "QT_QPA_PLATFORM": "offscreen"})
            document = FreeCAD.openDocument(path)
            live(0.5)
            mesh = document.getObject("P_Mesh")
            self.assertTrue(mesh.ViewObject.Visibility)
            driver.look()
            colours = driver.colours_of_view()
            self.assertGreater(colours["other"] + colours["blue"], 500)
            self.assertEqual(mesh.NeedsRefresh, False)

    @unittest.skipUnless(os.environ.get("HEXFEATURE_OLDER_DOCUMENT"), "no document of another FreeCAD")
    def test_a_document_of_an_older_freecad_shows_its_mesh(self):
        document = FreeCAD.openDocument(os.environ["HEXFEATURE_OLDER_DOCUMENT"])
        live(0.5)
        mesh = document.getObject("Part_Mesh")
        self.assertEqual((mesh.FemMesh.HexaCount, mesh.NeedsRefresh), (mesh.HexCount, False))
        driver.look()
        self.assertGreater(driver.colours_of_view()["other"] + driver.colours_of_view()["blue"], 500)
        mesh.ViewObject.DisplayMode = "Quality"
        driver.look()
        self.assertGreater(driver.colours_of_view()["blue"], 500)
        FreeCADGui.ActiveDocument.setEdit(mesh, 0)
        live()
        panel = task_panel.current
        child(panel.form, "mesh_button").click()
        wait_until(lambda: panel.job is None)
        self.assertFalse(mesh.NeedsRefresh)

    def test_a_changed_part_asks_for_a_refresh_and_gets_it(self):
        document = FreeCAD.newDocument("Body")
        document.UndoMode = 1
        body = document.addObject("PartDesign::Body", "Body")
        box = document.addObject("PartDesign::AdditiveBox", "Box")
        body.addObject(box)
        box.Length, box.Width, box.Height = 40, 20, 10
        document.recompute()
        driver.look()
        mesh = self.mesh(body, 5)
        self.assertFalse(mesh.NeedsRefresh)
        box.Length = 60
        document.recompute()
        self.assertTrue(mesh.NeedsRefresh)
        picture("needs-refresh")
        FreeCADGui.Selection.clearSelection()
        live(0.5)
        driver.action("Refresh mesh").trigger()
        wait_until(lambda: refresh_panel.current.job is None and not FreeCADGui.Control.activeDialog())
        self.assertFalse(mesh.NeedsRefresh)
        self.assertAlmostEqual(mesh.FemMesh.BoundBox.XLength, 60, places=6)
        mesh.ElementSize = 10
        self.assertTrue(mesh.NeedsRefresh)

    def test_the_mesh_lands_in_the_active_analysis(self):
        import FemGui
        import ObjectsFem

        document, part = driver.show_part(make_parts.box())
        study = ObjectsFem.makeAnalysis(document, "Analysis")
        FemGui.setActiveAnalysis(study)
        first = self.mesh(part, 5)
        self.assertIn(first, study.Group)
        second = self.mesh(part, 10)
        self.assertEqual([o for o in study.Group if o.isDerivedFrom("Fem::FemMeshObject")], [second])


class TestQuality(GuiTest):
    def test_colours_bad_elements_cut_and_feature_lines(self):
        document, part = driver.show_part(make_parts.flange(), "Flange")
        mesh = self.mesh(part, 5)
        FreeCADGui.Selection.clearSelection()
        live(0.5)
        driver.action("Mesh quality").trigger()
        panel = quality_panel.current
        view = mesh.ViewObject
        self.assertEqual(view.DisplayMode, "Quality")
        driver.look()
        self.assertGreater(driver.colours_of_view()["blue"], 500)
        picture("quality")
        node = view.Proxy.quality
        elements = node.elements(mesh)
        self.assertAlmostEqual(elements.quality.min(), mesh.MinScaledJacobian, places=9)
        self.assertAlmostEqual(elements.quality.mean(), mesh.MeanScaledJacobian, places=9)
        self.assertEqual(len(elements.skin(elements.visible())[0]), mesh.FemMesh.FaceCount)
        child(panel.form, "cut_axis").setCurrentIndex(2)
        child(panel.form, "cut_position").setValue(50)
        child(panel.form, "feature_lines").setChecked(True)
        self.assertEqual((view.CutAxis, view.FeatureLines), ("Y", True))
        picture("quality-cut")
        child(panel.form, "cut_flip").setChecked(True)
        child(panel.form, "cut_axis").setCurrentIndex(0)
        child(panel.form, "worst").click()
        shown = int(elements.visible(view.ShowBelow).sum())
        self.assertTrue(10 <= shown < len(elements.hexes))
        picture("quality-worst")
        panel.reject()
        self.assertNotEqual(view.DisplayMode, "Quality")


class TestModels(GuiTest):
    def test_feature_lines_and_recognition_model(self):
        document, part = driver.show_part(make_parts.bracket().Solids[0], "Bracket")
        FreeCADGui.Selection.addSelection(part)
        live(0.5)
        driver.action("Show feature lines").trigger()
        lines = document.getObject("FeatureLines")
        self.assertGreater(len(lines.Shape.Edges), 12)
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(part)
        driver.action("Show recognition model").trigger()
        model = document.getObject("RecognitionModel")
        self.assertGreater(len(model.Shape.Faces), 6)
        for face in model.Shape.Faces:
            normal = face.normalAt(0, 0)
            self.assertAlmostEqual(max(abs(normal.x), abs(normal.y), abs(normal.z)), 1, places=6)
        FreeCADGui.Selection.clearSelection()
        driver.look()
        picture("models")


class TestExportAndBatch(GuiTest):
    def test_export_by_the_file_dialog(self):
        document, part = driver.show_part(make_parts.box())
        self.mesh(part, 5)
        with tempfile.TemporaryDirectory() as folder:
            asked = commands.ask_file
            commands.ask_file = lambda title, start, filters: (os.path.join(folder, "box"), filters[1])
            try:
                FreeCADGui.Selection.clearSelection()
                live(0.5)
                driver.action("Export mesh").trigger()
            finally:
                commands.ask_file = asked
            self.assertEqual(os.listdir(folder), ["box.unv"])

    def test_batch(self):
        """Ten parts, each with a size of its own, and a file that cannot be read."""
        names = [name for name in make_parts.PARTS if name != "crank_shaft"]
        with tempfile.TemporaryDirectory() as folder:
            lines = ["%s; %g mm" % (make_parts.make(name, folder), 3 * make_parts.PARTS[name][1]) for name in names]
            bad = os.path.join(folder, "bad.step")
            with open(bad, "w") as f:
                f.write("nothing")
            out = os.path.join(folder, "out")
            driver.action("Batch").trigger()
            dialog = batch_dialog.current
            dialog.files.setPlainText("part.step; 4 kg")
            child(dialog, "start_button").click()
            self.assertIn("4 kg", dialog.state.text())
            dialog.files.setPlainText("\n".join([*lines, bad]))
            dialog.folder.setText(out)
            recorded = self.recorded(lambda: (child(dialog, "start_button").click(), wait_until(lambda: dialog.start_button.isEnabled())))
            picture("batch", dialog)
            self.assertEqual([r["result"] for r in dialog.rows], ["meshed"] * 10 + ["unreadable"])
            self.assertTrue({"box.FCStd", "box.unv", "box.json", "summary.csv"} <= set(os.listdir(out)))
            self.assertLess(dialog.rows[0]["hexes"], 80)
            before = os.path.getmtime(os.path.join(out, "box.FCStd"))
            exec("\n".join(recorded))
            self.assertGreater(os.path.getmtime(os.path.join(out, "box.FCStd")), before)
            self.assertEqual(FreeCAD.listDocuments(), {})
            child(dialog, "close_button").click()

    def test_a_batch_given_up_a_path_with_semicolons_and_a_summary_that_cannot_be_written(self):
        with tempfile.TemporaryDirectory() as folder:
            odd = os.path.join(folder, "a;b")
            os.mkdir(odd)
            box = make_parts.make("box", odd)
            shaft = make_parts.make("crank_shaft", folder)
            out = os.path.join(folder, "out")
            driver.action("Batch").trigger()
            dialog = batch_dialog.current
            dialog.folder.setText(out)

            def give_up():
                child(dialog, "start_button").click()
                live(0.2)
                child(dialog, "cancel_button").click()
                wait_until(lambda: dialog.start_button.isEnabled())

            dialog.files.setPlainText("%s; 1 mm\n%s" % (shaft, box))
            recorded = self.recorded(give_up)
            self.assertFalse([line for line in recorded if "batch.run" in line])
            self.assertEqual([row["result"] for row in dialog.rows], ["failed"])
            self.assertTrue(os.path.isfile(os.path.join(out, "summary.csv")))

            os.remove(os.path.join(out, "summary.csv"))
            os.mkdir(os.path.join(out, "summary.csv"))
            dialog.files.setPlainText("%s\n%s; 5 mm" % (box, box))
            child(dialog, "start_button").click()
            wait_until(lambda: dialog.start_button.isEnabled())
            self.assertEqual([row["result"] for row in dialog.rows], ["meshed", "meshed"])
            self.assertEqual(dialog.rows[1]["hexes"], 80)
            self.assertIn("summary.csv:", dialog.state.text())
            child(dialog, "close_button").click()


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
            quality_panel.current.reject()

        lines = self.recorded(act)
        mesh = document.getObject("Part_Mesh")
        count = mesh.HexCount
        document.removeObject(mesh.Name)
        exec("\n".join(lines), {"App": FreeCAD, "Gui": FreeCADGui})
        again = document.getObject("Part_Mesh")
        self.assertEqual((again.HexCount, again.ViewObject.CutAxis, again.ViewObject.DisplayMode), (count, "X", "Quality"))

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

            def export():
                asked, commands.ask_file = commands.ask_file, lambda title, start, filters: (path, filters[0])
                try:
                    FreeCADGui.Selection.clearSelection()
                    live(0.5)
                    driver.action("Export mesh").trigger()
                finally:
                    commands.ask_file = asked

            lines = [self.recorded(act) for act in (refresh, models, export)]
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
    def test_the_panel_speaks_german(self):
        FreeCADGui.setLocale("German")
        try:
            document, part = driver.show_part(make_parts.box())
            panel = task_panel.open_panel(part)
            wait_until(lambda: not panel.preview.busy)
            self.assertEqual(panel.mesh_button.text(), "Vernetzen")
            picture("panel-german")
            panel.reject()
        finally:
            FreeCADGui.setLocale("English")


def run():
    os.environ["HEXFEATURE_NO_BOXES"] = "1"
    driver.prepare_window()
    loader = unittest.TestLoader()
    names = [n for n in os.environ.get("HEXFEATURE_GUI_TESTS", "").split() if n]
    module = sys.modules[__name__]
    suite = loader.loadTestsFromNames(names, module) if names else loader.loadTestsFromModule(module)
    # Not FreeCAD's own output, which it shows in a window that opens by itself.
    stream = os.fdopen(os.dup(1), "w", buffering=1)
    result = unittest.TextTestRunner(stream=stream, verbosity=2).run(suite)
    return 0 if result.wasSuccessful() and result.testsRun else 1
