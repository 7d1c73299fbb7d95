# HexFeatureWB - LGPL-2.1-or-later
"""What the window stands on, without it: freecadcmd -P tests/freecad -P tests/parts -P python -t TestHexFeatureWindowless"""
import os
import re
import tempfile
import time
import types
import unittest

import FreeCAD
import numpy as np
import Part

import HexFeatureWB
from HexFeatureWB import analysis, mesh_object

import make_parts
from hexfeature_documents import DocumentTest, new_part


class TestDocumentObject(DocumentTest):
    def test_a_changed_part_or_option_asks_for_a_refresh(self):
        document, part = new_part(make_parts.box())
        mesh = HexFeatureWB.mesh(part, size=5)
        self.assertFalse(mesh.NeedsRefresh)
        mesh.ElementSize = 10
        self.assertTrue(mesh.NeedsRefresh)
        mesh.ElementSize = 5
        self.assertFalse(mesh.NeedsRefresh)
        mesh.Threads = 1  # changes nothing of the mesh
        self.assertFalse(mesh.NeedsRefresh)
        part.Shape = Part.makeBox(50, 10, 10)
        document.recompute()
        self.assertTrue(mesh.NeedsRefresh)
        HexFeatureWB.refresh(mesh)
        self.assertFalse(mesh.NeedsRefresh)
        self.assertEqual(mesh.FemMesh.HexaCount, 40)

    def test_one_solid_of_several(self):
        other = make_parts.box()
        other.translate(FreeCAD.Vector(0, 50, 0))
        document, part = new_part(Part.makeCompound([make_parts.box(), other]))
        mesh = HexFeatureWB.mesh(part, size=5, solid=2)
        names = {mesh.FemMesh.getGroupName(g) for g in mesh.FemMesh.Groups}
        self.assertEqual({n for n in names if n.startswith(("Face", "Solid"))}, {"Face%d" % k for k in range(7, 13)} | {"Solid2"})
        with self.assertRaises(HexFeatureWB.MeshingError):
            HexFeatureWB.mesh(part, size=5, solid=3)

    def test_an_exported_mesh_is_the_one_of_the_command_line(self):
        import hexfeature

        document, part = new_part(make_parts.connecting_rod())
        with tempfile.TemporaryDirectory() as folder:
            for order in (1, 2):
                mesh = HexFeatureWB.mesh(part, size=5, order=order)
                files = [os.path.join(folder, "%s%d.inp" % (kind, order)) for kind in ("document", "core")]
                HexFeatureWB.export(mesh, files[0])
                hexfeature.mesh_brep(part.Shape.exportBrepToString(), size=5, order=order).write(files[1])
                texts = [open(path).read() for path in files]
                self.assertEqual(texts[0], texts[1])

    def test_models_are_objects(self):
        document, part = new_part(make_parts.bracket().Solids[0])
        lines = HexFeatureWB.feature_lines(part, size=5)
        self.assertGreater(len(lines.Shape.Edges), 12)
        model = HexFeatureWB.recognition_model(part, size=5)
        volume = Part.makeSolid(Part.makeShell(model.Shape.Faces)).Volume
        self.assertAlmostEqual(abs(volume) / 125, round(abs(volume) / 125), places=6)  # whole cubes
        self.assertGreater(model.Shape.BoundBox.XMin, part.Shape.BoundBox.XMax)

    def test_a_closed_document_leaves_no_shape_behind(self):
        document, part = new_part(make_parts.box())
        HexFeatureWB.mesh(part, size=5)
        self.assertTrue(mesh_object._last_measured[0].isSame(part.Shape))
        FreeCAD.closeDocument(document.Name)
        self.assertEqual(mesh_object._last_measured, (None, None))


OLDER = os.environ.get("HEXFEATURE_OLDER_DOCUMENT")


class TestOlderDocument(DocumentTest):
    """A document that save_document.py has saved, perhaps in another FreeCAD."""

    def open(self):
        if OLDER:
            return FreeCAD.openDocument(OLDER)
        import save_document

        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "older.FCStd")
            save_document.save(path)
            return FreeCAD.openDocument(path)

    def test_holds_mesh_groups_and_options_and_can_be_refreshed(self):
        document = self.open()
        mesh = document.getObject("Part_Mesh")
        fem = mesh.FemMesh
        self.assertEqual((fem.HexaCount, mesh.NeedsRefresh, mesh.Order, float(mesh.ElementSize.Value)), (mesh.HexCount, False, 2, 6))
        groups = {fem.getGroupName(g): len(fem.getGroupElements(g)) for g in fem.Groups}
        self.assertEqual(groups["Solid1"], mesh.HexCount)
        HexFeatureWB.refresh(mesh)
        again = mesh.FemMesh
        self.assertEqual(groups, {again.getGroupName(g): len(again.getGroupElements(g)) for g in again.Groups})


class TestGroupCheck(DocumentTest):
    """On a bar one element thick inner quads' nodes all lie on the cylinder too; the boxes touch."""

    touching = Part.makeCompound([Part.makeBox(20, 10, 10), Part.makeBox(20, 10, 10, FreeCAD.Vector(20, 0, 0))])

    def test_says_what_freecads_search_finds(self):
        from HexFeatureWB import core, fem_mesh, group_check

        turned, differ = self.touching.rotated(FreeCAD.Vector(), FreeCAD.Vector(1, 2, 3), 40), 0
        for shape, size in ((Part.makeCylinder(3, 20), 6.0), (make_parts.connecting_rod(), 6.4), (make_parts.box(), 5.0),
                            (self.touching, 5.0), (turned, 5.0)):
            for order in (1, 2):
                result = core.load().mesh_brep(shape.exportBrepToString(), {"size": size, "order": order})
                check = group_check.GroupCheck(result, shape)
                self.assertTrue(check.work(60))
                fem, ids = fem_mesh.to_fem_mesh(result)
                self.assertEqual(check.different, group_check.check_groups(fem, shape, ids))
                differ += bool(check.different)
        self.assertEqual(differ, 6)

    def test_finds_nodes_that_are_on_no_entity_of_the_face(self):
        """As in a mesh that lost edges, where a face's elements have nodes on others' edges."""
        from HexFeatureWB import core, fem_mesh, group_check

        shape = make_parts.box()
        result = core.load().mesh_brep(shape.exportBrepToString(), {"size": 5.0, "order": 2})
        fem, ids = fem_mesh.to_fem_mesh(result)
        places = np.array(result.node_dim)
        lost = types.SimpleNamespace(
            points=result.points, quads=result.quads, quads8=result.quads8, hexes20=result.hexes20, report=result.report,
            quad_face=np.array(result.quad_face), node_dim=places, node_entity=result.node_entity)
        places[np.flatnonzero((places == 2) & (np.asarray(result.node_entity) == 1))[:3]] = 3  # on Face1 by geometry alone
        moved = int(np.flatnonzero(lost.quad_face == 3)[0])
        lost.quad_face[moved] = 2  # an element that lies on another face
        for number in (2, 3):
            ids["faces"][number] = (np.flatnonzero(lost.quad_face == number) + 1 + fem.HexaCount).tolist()
        check, count = group_check.GroupCheck(lost, shape), 0
        while not check.work(0):
            count += 1
        self.assertGreater(count, len(shape.Faces))  # the window is alive between faces, and between elements of one
        self.assertEqual(sorted(check.different), [2, 3])
        self.assertEqual(check.different, group_check.check_groups(fem, shape, ids))

    def test_measures_few_nodes(self):
        """Each costs milliseconds on a face with many holes."""
        from HexFeatureWB import core, group_check

        plate = make_parts.box()
        result = core.load().mesh_brep(plate.exportBrepToString(), {"size": 1.0, "order": 1})
        measured, real = [], group_check._Measured

        class Counting(real):
            def holds(self, node):
                measured.append(node)
                return super().holds(node)

        group_check._Measured = Counting
        try:
            self.assertTrue(group_check.GroupCheck(result, plate).work(60))
            self.assertEqual(measured, [])
            one = types.SimpleNamespace(
                points=result.points, quads=result.quads, hexes20=[], report=result.report, node_dim=result.node_dim,
                node_entity=result.node_entity, quad_face=np.array(result.quad_face))
            one.quad_face[np.flatnonzero(one.quad_face == 3)[:2]] = 2
            self.assertTrue(group_check.GroupCheck(one, plate).work(60))
            self.assertTrue(measured)
            ours = np.flatnonzero(np.asarray(result.quad_face) == 3)[:2]
            self.assertLessEqual(set(measured), set(np.asarray(result.quads)[ours].ravel()))
        finally:
            group_check._Measured = real


class TestJob(unittest.TestCase):
    def test_a_job_ends_with_a_result_an_error_or_cancelled(self):
        from HexFeatureWB.job import Job

        brep = make_parts.crank_shaft().exportBrepToString()
        good = Job(make_parts.box().exportBrepToString(), {"size": 5.0}).start()
        bad = Job(brep, {"size": 1e6}).start()
        given_up = Job(brep, {"size": 1.0}).start()
        given_up.cancel()
        for job in (good, bad, given_up):
            job.join(60)
            self.assertFalse(job.is_alive())
        self.assertEqual(good.result.report()["quality"]["hexes"], 80)
        self.assertTrue(good.lines)
        self.assertEqual((bad.result, bad.error.kind), (None, "usage"))
        self.assertEqual((given_up.result, given_up.error.kind), (None, "cancelled"))

    def test_looks_at_first_and_final_labels_of_each_solid(self):
        import Part
        from HexFeatureWB.job import Job

        class Recorded(Job):
            def _take_look(self, result, solid, final):
                super()._take_look(result, solid, final)
                seen.append((solid, final, list(result.stage("labels")["label"]), len(result.stage("shape")["arcs"])))

        def looks(shape, size, wanted=True):
            seen.clear()
            job = Recorded(shape.exportBrepToString(), {"size": size, "stop_after": "shape"}, wants_looks=wanted).start()
            job.join(60)
            self.assertEqual(job.result.stopped_after, "shape")
            return list(seen), job

        seen = []
        (first, final), job = looks(make_parts.pipe_tee(), 3.0)
        self.assertEqual((first[:2], final[:2]), ((1, False), (1, True)))
        self.assertNotEqual(first[2], final[2])  # they had to be repaired
        self.assertEqual(final[2], list(job.result.stage("labels")["label"]))
        self.assertGreater(first[3], 12)
        self.assertEqual(looks(make_parts.pipe_tee(), 3.0, wanted=False)[0], [])
        other = make_parts.box()
        other.translate(FreeCAD.Vector(0, 50, 0))
        two, job = looks(Part.makeCompound([make_parts.box(), other]), 5.0)
        self.assertEqual([look[:2] for look in two], [(1, False), (1, True), (2, False), (2, True)])
        self.assertTrue(job.looks[1][1] and job.looks[2][1])

    def test_a_first_look_is_given_time_to_get_on_the_screen(self):
        from HexFeatureWB import job as of_job

        def wait(job, condition):
            while job.is_alive() and not condition():
                time.sleep(0.01)
            self.assertTrue(condition(), job.error)

        real, of_job.SIGHT = of_job.SIGHT, 60
        try:
            shape = Part.makeCompound([make_parts.box(), make_parts.pipe_tee()])
            job = of_job.Job(shape.exportBrepToString(), {"size": 5.0, "stop_after": "shape"}, wants_looks=True).start()
            for solid in (1, 2):
                wait(job, lambda: solid in job.looks)
                job.join(0.3)
                self.assertEqual((len(job.looks), job.looks[solid][1]), (solid, False))
                job.seen.set()
                if solid == 1:
                    wait(job, lambda: job.looks[1][1])
            job.join(60)
            self.assertTrue(job.looks[2][1])
            job = of_job.Job(shape.exportBrepToString(), {"size": 5.0, "stop_after": "shape"}, wants_looks=True).start()
            wait(job, lambda: 1 in job.looks)
            job.cancel()
            job.join(30)
            self.assertEqual(job.error.kind, "cancelled")
        finally:
            of_job.SIGHT = real


class TestForceOnARoundFace(DocumentTest):
    def force_written(self, mesh):
        """What lands on a disc of 1000 N, from the deck with this mesh object."""
        from femtools.ccxtools import FemToolsCcx

        disc = next(n for n, face in enumerate(self.part.Shape.Faces, 1) if isinstance(face.Surface, Part.Plane))
        none = [(self.part, ("Face1",))]
        study, solver = analysis.static_analysis(self.document, mesh, none, [(self.part, ("Face%d" % disc,))], np.float64(1000))
        with tempfile.TemporaryDirectory() as folder:
            tools = FemToolsCcx(study, solver, test_mode=False)
            tools.update_objects()
            tools.setup_working_dir(folder)
            tools.write_inp_file()
            with open(tools.inp_file_name) as f:
                rows = re.findall(r"^\d+, *[123], *(\S+)$", f.read().partition("*CLOAD")[2], re.MULTILINE)
        self.assertGreater(len(rows), 20)
        return abs(sum(map(float, rows)))

    def test_the_whole_force_lands_on_a_disc_of_few_elements_of_ours_alone(self):
        self.document, self.part = new_part(make_parts.round_bar())
        ours = HexFeatureWB.mesh(self.part, size=6, order=2)
        self.assertAlmostEqual(self.force_written(ours), 1000.0, delta=1.0)
        another = self.document.addObject("Fem::FemMeshObject", "Another")
        another.FemMesh = ours.FemMesh
        self.assertLess(self.force_written(another), 995.0)


class TestMissingExtension(unittest.TestCase):
    def test_says_what_to_do(self):
        import subprocess
        import sys

        root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
        code = ("import sys; sys.path[:0] = [%r]; sys.modules['hexfeature._core'] = None\n"
                "from HexFeatureWB import core\nprint(core.problem())" % os.path.join(root, "python"))
        said = subprocess.run(["/usr/bin/python3", "-c", code], capture_output=True, text=True, timeout=60).stdout
        self.assertIn("make build", said)
        self.assertIn("pip install hexfeature", said)
        self.assertIn("Python %d.%d" % sys.version_info[:2], said)
