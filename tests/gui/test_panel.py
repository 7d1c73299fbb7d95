# HexFeatureWB - LGPL-2.1-or-later
"""The task panel: preview, meshing, Cancel, failures, what can be selected."""
import json
import threading
import types

import driver
import FreeCAD
import FreeCADGui
import make_parts
from driver import child, live, picture, wait_until
from gui_test import GuiTest
from pivy import coin
from PySide import QtCore

import HexFeatureWB
from HexFeatureWB import core, fem_mesh, group_check, mesh_object, meshing
from HexFeatureWB.gui import messages, run, selection, task_panel, widgets
from HexFeatureWB.job import Job


class TestTaskPanel(GuiTest):
    def test_from_the_selection_to_the_mesh(self):
        document, part = driver.show_part(make_parts.connecting_rod(), "ConnectingRod")
        panel = self.open_panel(part)
        wait_until(lambda: not panel.preview.busy)
        self.assertGreater(len(panel.preview.stages[0]["arcs"]), 20)
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
        wait_until(lambda: not panel.state._later.isActive())  # scrolled to
        self.assertFalse(panel.state.visibleRegion().isEmpty())
        self.assertEqual(panel.size.value(), size)
        child(panel.form, "mesh_button").click()
        wait_until(lambda: panel.job is None)
        self.assertEqual(document.Objects, [part, mesh])
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
        panel.preview._ready = lambda job: (ready(job), shown.append((panel.preview.final, list(panel.preview.stages[0]["label"]))))
        panel.size.set_value(3.0)
        panel.preview._poll.setInterval(1)
        wait_until(lambda: not panel.preview.busy)
        self.assertTrue(shown[-1][0])
        if len(shown) > 1:  # on a fast machine the repair may be over before anyone has looked
            self.assertFalse(shown[0][0])
            self.assertNotEqual(shown[0][1], shown[1][1])

    def test_a_method_without_labels_has_no_preview(self):
        document, part = driver.show_part(make_parts.box())
        panel = self.open_panel(part)
        wait_until(lambda: not panel.preview.busy)
        self.assertTrue(panel.preview.stages)
        panel.options["method"].set_value("tet-split")
        live(0.5)
        self.assertFalse(panel.preview.busy or panel.preview.stages)
        self.assertTrue(part.ViewObject.Visibility)
        self.assertIn("neither labels", panel.preview_text.text())
        panel.options["method"].set_value("auto")
        wait_until(lambda: not panel.preview.busy)
        self.assertTrue(panel.preview.stages)

    def test_the_preview_shows_every_solid(self):
        import Part

        near, far = make_parts.box(), make_parts.bracket()
        far.translate(FreeCAD.Vector(0, 100, 0))
        document, part = driver.show_part(Part.makeCompound([near, far.Solids[0]]))
        panel = self.open_panel(part)
        wait_until(lambda: not panel.preview.busy)
        both = panel.preview.stages
        ends = [(stage["points"][:, 1].min(), stage["points"][:, 1].max()) for stage in both]
        self.assertEqual(len(both), 2)
        self.assertGreater(ends[1][0], ends[0][1])
        self.assertIn("%d regions" % sum(len(stage["chart_label"]) for stage in both), panel.preview_text.text())
        self.assertFalse(part.ViewObject.Visibility)
        driver.look()
        picture("panel-preview-solids")
        panel.solid.setCurrentIndex(2)
        wait_until(lambda: not panel.preview.busy)
        self.assertEqual(len(panel.preview.stages), 1)
        self.assertGreater(panel.preview.stages[0]["points"][:, 1].min(), ends[0][1])
        self.assertEqual(panel.preview._root.getNumChildren(), 2)  # how it is picked, one solid

    def test_an_error_in_one_solid_leaves_the_final_labels_of_the_others(self):
        import Part

        listen, why = Job.run, "no polycube has a corner of +X -Y +Z"

        def failing(job):
            listen(job)
            if job.options.get("stop_after") == "shape":  # as if the repair of the last solid's labels had failed
                job.looks[2] = job.looks[2][0], False
                job.result, job.error = None, RuntimeError(why)

        far = make_parts.box()
        far.translate(FreeCAD.Vector(0, 100, 0))
        document, part = driver.show_part(Part.makeCompound([make_parts.box(), far]))
        Job.run = failing
        try:
            panel = self.open_panel(part)
            wait_until(lambda: not panel.preview.busy)
        finally:
            Job.run = listen
        self.assertEqual(list(panel.preview.solids), [1])
        self.assertEqual(panel.preview._root.getNumChildren(), 2)  # how it is picked, one solid
        self.assertIn(why, panel.preview_text.text())
        panel.size.set_value(5)
        panel._changed()
        wait_until(lambda: not panel.preview.busy)
        self.assertEqual(sorted(panel.preview.solids), [1, 2])
        self.assertIn("regions", panel.preview_text.text())

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
            self.assertIn("cancelled", panel.state.text())
            self.assertEqual([o.Name for o in document.Objects], names)
            self.assertTrue(panel.mesh_button.isEnabled())
            wait_until(lambda: not panel.preview.busy)
        driver.say("cancelled in %s; longest answer %.2f s" % (sorted(cancelled_in), longest))
        self.assertGreater(len(cancelled_in), 1)
        picture("panel-cancelled")

    def test_cancel_does_not_wait_for_a_worker_that_does_not_listen(self):
        document, part = driver.show_part(make_parts.box())
        panel = self.open_panel(part)
        panel.size.set_value(5.0)
        wait_until(lambda: not panel.preview.busy)
        go_on, listen = threading.Event(), Job.run
        Job.run = lambda job: (go_on.wait(120), listen(job))
        try:
            child(panel.form, "mesh_button").click()
            job = panel.job
            child(panel.form, "cancel_button").click()
            wait_until(lambda: panel.job is None, 60)
            self.assertTrue(job.is_alive())
            self.assertIn("cancelled", panel.state.text())
        finally:
            Job.run = listen
        child(panel.form, "mesh_button").click()  # beside the old worker, which ends without a word
        go_on.set()
        wait_until(lambda: panel.job is None and not job.is_alive())
        self.assertEqual(job.error.kind, "cancelled")
        self.assertEqual(panel.mesh.HexCount, 80)

    def test_the_part_is_read_once_and_not_when_the_panel_is_closed(self):
        go_on, listen = threading.Event(), Job.run

        def slow(job):
            if job.options.get("stop_after") == "read":
                go_on.wait(60)
            listen(job)

        document, part = driver.show_part(make_parts.box())
        Job.run = slow
        try:
            panel = self.open_panel(part)
            for size in (4, 5):
                panel.size.set_value(size)
                panel._changed()
                live(1)
                self.assertEqual((panel.preview._job.is_alive(), panel.preview._job.step), (True, ""))
            child(panel.form, "mesh_button").click()
            live(1)
            self.assertEqual((panel.job.is_alive(), panel.job.step), (True, ""))
            go_on.set()
            wait_until(lambda: panel.job is None)
            self.assertIsNotNone(panel.mesh, panel.state.text())
            panel.reject()
            go_on.clear()
            panel = self.open_panel(part)
            reading = panel._reading
            self.assertFalse(reading.was_cancelled)
            panel.reject()
            self.assertTrue(reading.was_cancelled)
        finally:
            Job.run = listen
            go_on.set()

    def test_a_time_limit_is_a_failure_with_a_hint(self):
        document, part = driver.show_part(make_parts.crank_shaft())
        panel = self.open_panel(part)
        panel.size.set_value(2.0)
        wait_until(lambda: not panel.preview.busy)
        panel.options["time_limit"].set_value(0.1)
        child(panel.form, "mesh_button").click()
        wait_until(lambda: panel.job is None)
        self.assertIn("time limit reached", panel.state.text())
        self.assertIn("Try:", panel.state.text())

    def test_the_mesh_is_seen_while_freecad_takes_it(self):
        document, part = driver.show_part(make_parts.box())
        panel = self.open_panel(part)
        panel.size.set_value(5.0)
        wait_until(lambda: not panel.preview.busy)
        shown, show_mesh = [], panel.preview.show_mesh
        panel.preview.show_mesh = lambda points, quads: (show_mesh(points, quads), shown.append(panel.preview._root.getNumChildren()))

        class OneByOne(fem_mesh.FemMeshBuilder):
            def work(self, seconds):
                return super().work(0)

        run.FemMeshBuilder = OneByOne
        try:
            child(panel.form, "mesh_button").click()
            wait_until(lambda: panel.job is None)
        finally:
            run.FemMeshBuilder = fem_mesh.FemMeshBuilder
        self.assertEqual(shown, [2])  # how it is picked, the mesh
        self.assertEqual(panel.preview._root.getNumChildren(), 1)
        self.assertTrue(panel.mesh.ViewObject.Visibility)

    def test_the_window_is_alive_while_groups_are_checked(self):
        """A check takes as long as nodes lie on no entity of their face; slices of it, not one call of FreeCAD's search."""
        document, part = driver.show_part(make_parts.box())
        panel = self.open_panel(part)
        panel.size.set_value(5.0)
        wait_until(lambda: not panel.preview.busy)
        handled, slices, steps = [], [], set()

        class OneByOne(group_check.GroupCheck):
            def work(self, seconds):
                steps.add(panel.job.step if panel.job else "document")
                slices.append(len(handled))
                QtCore.QTimer.singleShot(0, lambda: handled.append(1))
                return super().work(0)

        run.GroupCheck = meshing.GroupCheck = OneByOne
        try:
            child(panel.form, "mesh_button").click()
            wait_until(lambda: panel.job is None)
        finally:
            run.GroupCheck = meshing.GroupCheck = group_check.GroupCheck
        self.assertGreater(len(slices), len(part.Shape.Faces))
        self.assertGreater(slices[-2], len(part.Shape.Faces) - 2)  # events between them
        self.assertIn("groups", steps)
        self.assertEqual(json.loads(panel.mesh.Report)["groups_not_found_by_geometry"], {})

    def test_the_estimate_says_where_layers_add_to_it(self):
        document, part = driver.show_part(make_parts.box())
        panel = self.open_panel(part)
        panel.size.set_value(5.0)
        self.assertEqual(panel.estimate.text(), "about 80 elements")
        panel.options["minimum_layers"].set_value(3)
        self.assertEqual(panel.estimate.text(), "about 80 elements, more where it is thinner than %s" % widgets.length(15))
        self.assertIn("15", widgets.length(15))

    def test_faces_are_drawn_without_a_search_for_double_ones(self):
        document, part = driver.show_part(make_parts.box())
        mesh = self.mesh(part, 5)

        def drawn():
            search = coin.SoSearchAction()
            search.setType(coin.SoIndexedFaceSet.getClassTypeId())
            search.setInterest(coin.SoSearchAction.ALL)
            search.setSearchingAll(True)
            search.apply(mesh.ViewObject.RootNode)
            paths = search.getPaths()
            return [paths[k].getTail().coordIndex.getNum() for k in range(paths.getLength())]

        self.assertEqual(mesh.ViewObject.MaxFacesShowInner, 0)
        without = drawn()
        mesh.ViewObject.MaxFacesShowInner = 50000  # as FreeCAD has it
        mesh.FemMesh = mesh.FemMesh
        self.assertEqual(drawn(), without)
        self.assertGreater(max(without), 100)

    def test_a_mesh_is_taken_though_the_part_was_drawn_anew(self):
        document, part = driver.show_part(make_parts.bracket().Solids[0])
        part.Shape.isValid()  # OpenCASCADE notes that it was checked
        panel = self.open_panel(part)
        panel.size.set_value(8.0)
        wait_until(lambda: not panel.preview.busy)
        load = meshing.core.load

        class Core:
            def __getattr__(self, name):
                if name == "mesh_brep":
                    raise AssertionError("meshed in the main thread")
                return getattr(load(), name)

        meshing.core = types.SimpleNamespace(load=Core)
        try:
            child(panel.form, "mesh_button").click()
            part.ViewObject.Visibility = True
            part.ViewObject.Deviation = 0.05  # and forgets it when it is drawn
            wait_until(lambda: panel.job is None)
        finally:
            meshing.core = core
        self.assertEqual(panel.mesh.HexCount, panel.mesh.FemMesh.VolumeCount)

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
        marks = panel.preview._root.getChild(1)  # their borders are drawn over everything
        search = coin.SoSearchAction()
        search.setType(coin.SoAnnotation.getClassTypeId())
        search.apply(marks)
        self.assertIsNotNone(search.getPath())
        search.setType(coin.SoCoordinate3.getClassTypeId())
        search.apply(marks)
        drawn = [tuple(point) for point in search.getPath().getTail().point.getValues()]
        borders = [edge for number in (3, 7) for edge in part.Shape.Faces[number - 1].Edges]
        self.assertEqual(len(drawn), sum(len(edge.discretize(24)) for edge in borders))
        self.assertTrue(part.ViewObject.Visibility)
        wait_until(lambda: not panel.state._later.isActive())  # scrolled to
        picture("panel-failed")
        panel.size.set_value(9e3)
        wait_until(lambda: not panel.preview.busy)
        self.assertEqual(panel.preview._root.getNumChildren(), 1)

    def test_a_mesh_that_freecad_cannot_take_is_a_failure(self):
        class NoRoom(fem_mesh.FemMeshBuilder):
            def __init__(self, *_):
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
