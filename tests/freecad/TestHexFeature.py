# HexFeatureWB - LGPL-2.1-or-later
"""Run by the real freecadcmd: freecadcmd -P tests/freecad -P tests/parts -P python -t TestHexFeature"""
import json
import os
import shutil
import tempfile
import unittest

import FreeCAD
import Part

import HexFeatureWB
from HexFeatureWB import analysis, batch, core, fem_mesh

import make_parts
from hexfeature_documents import DocumentTest, new_part


class TestMeshObject(DocumentTest):
    def test_groups_are_what_geometry_finds(self):
        for shape in (make_parts.box(), make_parts.bracket().Solids[0], make_parts.filleted_l().Solids[0]):
            document, part = new_part(shape)
            for order in (1, 2):
                mesh = HexFeatureWB.mesh(part, size=5, order=order)
                report = json.loads(mesh.Report)
                self.assertEqual(report["groups_not_found_by_geometry"], {})
                self.assertGreater(mesh.HexCount, 0)
                self.assertEqual(mesh.FemMesh.HexaCount, mesh.HexCount)
                names = [mesh.FemMesh.getGroupName(g) for g in mesh.FemMesh.Groups]
                for k in range(1, len(shape.Faces) + 1):
                    self.assertIn("Face%d" % k, names)

    def test_second_order_by_default(self):
        document, part = new_part(make_parts.box())
        mesh = HexFeatureWB.mesh(part, size=5)
        self.assertEqual(len(mesh.FemMesh.getElementNodes(1)), 20)

    def test_numbers_are_those_of_the_core(self):
        """SMESH gives them by itself: node i of the core's result is node i + 1, then elements, hexahedra first."""
        document, part = new_part(make_parts.box())
        result = core.load().mesh_brep(part.Shape.exportBrepToString(), {"size": 5.0, "order": 2})
        fem, ids = fem_mesh.to_fem_mesh(result)
        nodes, hexes = fem.Nodes, len(result.hexes20)
        self.assertEqual([tuple(nodes[i + 1]) for i in range(len(nodes))], [tuple(p) for p in result.points.tolist()])
        self.assertEqual(sorted(fem.Volumes), list(range(1, hexes + 1)))
        self.assertEqual(sorted(fem.Faces), list(range(hexes + 1, hexes + 1 + len(result.quads8))))
        self.assertEqual(set(fem.getElementNodes(hexes + 1)), {n + 1 for n in result.quads8[0].tolist()})
        self.assertEqual(sum(len(members) for members in ids["faces"].values()), len(result.quads8))

    def test_a_mesh_is_called_after_its_part(self):
        document, part = new_part(make_parts.box())
        part.Label = "Träger"
        mesh = HexFeatureWB.mesh(part, size=10)
        self.assertEqual((mesh.Name, mesh.Label), ("Part_Mesh", "Träger_Mesh"))

    def test_save_and_reopen_keep_mesh_options_and_groups(self):
        document, part = new_part(make_parts.box())
        mesh = HexFeatureWB.mesh(part, size=5)
        counts = mesh.FemMesh.NodeCount, mesh.FemMesh.HexaCount, mesh.FemMesh.GroupCount
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "saved.FCStd")
            document.saveAs(path)
            name = mesh.Name
            FreeCAD.closeDocument(document.Name)
            again = FreeCAD.openDocument(path).getObject(name)
            self.assertEqual((again.FemMesh.NodeCount, again.FemMesh.HexaCount, again.FemMesh.GroupCount), counts)
            self.assertEqual(float(again.ElementSize.Value), 5)
            HexFeatureWB.refresh(again)
            self.assertEqual((again.FemMesh.NodeCount, again.FemMesh.HexaCount, again.FemMesh.GroupCount), counts)

    def test_undo_and_redo(self):
        document, part = new_part(make_parts.box())
        mesh = HexFeatureWB.mesh(part, size=5)
        name, count = mesh.Name, mesh.FemMesh.HexaCount
        document.undo()
        self.assertIsNone(document.getObject(name))
        document.redo()
        self.assertEqual(document.getObject(name).FemMesh.HexaCount, count)

    def test_a_failure_leaves_the_document_as_it_was(self):
        for undo in (0, 1):
            document, part = new_part(make_parts.box())
            document.UndoMode = undo
            before = [o.Name for o in document.Objects]
            for options in ({"size": 0}, {"size": float("nan")}, {"size": 1e6}, {"labels": "none"}, {"colour": 3}):
                with self.assertRaises((HexFeatureWB.MeshingError, ValueError)):
                    HexFeatureWB.mesh(part, **options)
                self.assertEqual([o.Name for o in document.Objects], before, options)
            with self.assertRaises(HexFeatureWB.MeshingError) as caught:
                HexFeatureWB.mesh(part, size=2, cancelled=lambda: True)
            self.assertEqual(caught.exception.kind, "cancelled")
            self.assertEqual([o.Name for o in document.Objects], before)

    def test_an_object_without_a_solid(self):
        document, part = new_part(Part.makePlane(10, 10))
        with self.assertRaises(HexFeatureWB.MeshingError) as caught:
            HexFeatureWB.mesh(part, size=2)
        self.assertEqual(caught.exception.kind, "bad_input")

    def test_faces_beside_the_solid_keep_freecads_numbers(self):
        solid = make_parts.box()
        document, part = new_part(Part.makeCompound([Part.makePlane(5, 5, FreeCAD.Vector(500, 0, 0)), solid]))
        mesh = HexFeatureWB.mesh(part, size=5, order=1)
        names = {mesh.FemMesh.getGroupName(g) for g in mesh.FemMesh.Groups}
        self.assertNotIn("Face1", names)
        self.assertTrue({"Face%d" % k for k in range(2, 8)} <= names)

    def test_an_analysis_holds_one_mesh(self):
        import ObjectsFem

        document, part = new_part(make_parts.box())
        study = ObjectsFem.makeAnalysis(document, "Analysis")
        HexFeatureWB.mesh(part, size=5, analysis=study)
        second = HexFeatureWB.mesh(part, size=4, analysis=study)
        self.assertEqual([o for o in study.Group if o.isDerivedFrom("Fem::FemMeshObject")], [second])


@unittest.skipUnless(shutil.which("ccx"), "there is no CalculiX")
class TestCalculiX(DocumentTest):
    def solve(self, shape, size, fixed, loaded, newtons, direction=None, **options):
        document, part = new_part(shape)
        mesh = HexFeatureWB.mesh(part, size=size, **options)
        study, solver = analysis.static_analysis(
            document, mesh, [(part, (fixed,))], [(part, (loaded,))], newtons, direction and (part, (direction,))
        )
        with tempfile.TemporaryDirectory() as folder:
            reaction = analysis.total_reaction(analysis.solve(study, solver, folder))
        result = [o for o in study.Group if o.isDerivedFrom("Fem::FemResultObject")][0]
        return result, FreeCAD.Vector(*reaction)

    def test_cantilever_agrees_with_beam_theory(self):
        # 100 x 10 x 10 mm, 1 kN at the end: bending 1.905 mm, shear 0.015. First order locks a little even at four elements across.
        theory = 1.920
        for order, size, tolerance in ((1, 2.5, 0.05), (2, 5, 0.01)):
            result, reaction = self.solve(make_parts.box(), size, "Face1", "Face2", 1000.0, "Face6", order=order)
            found = max(v.Length for v in result.DisplacementVectors)
            self.assertAlmostEqual(found, theory, delta=tolerance * theory)
            self.assertAlmostEqual(reaction.Length, 1000, delta=1)

    def test_reaction_of_a_bracket_equals_its_load(self):
        with tempfile.TemporaryDirectory() as folder:
            shape = Part.Shape()
            shape.read(make_parts.make("bracket", folder))
        solid = shape.Solids[0]
        centres = [face.CenterOfMass for face in solid.Faces]
        faces = {("top" if c.z > 59 else "end" if c.x > 59 else ""): "Face%d" % n for n, c in enumerate(centres, 1)}
        for order in (1, 2):
            result, reaction = self.solve(solid, 4, faces["end"], faces["top"], 500.0, order=order)
            self.assertAlmostEqual(reaction.Length, 500, delta=0.5)
            self.assertGreater(max(v.Length for v in result.DisplacementVectors), 0)


class TestBatch(DocumentTest):
    def test_files_of_one_name_do_not_overwrite_each_other(self):
        with tempfile.TemporaryDirectory() as folder:
            paths = [os.path.join(folder, sub, "box.step") for sub in ("a", "b")]
            for path in paths:
                os.mkdir(os.path.dirname(path))
                make_parts.box().exportStep(path)
            rows, code = batch.run(paths, os.path.join(folder, "out"), {"size": 10.0, "order": 1})
            self.assertEqual((code, len(rows)), (0, 2))
            self.assertIn("box_2.unv", os.listdir(os.path.join(folder, "out")))

    def test_goes_on_after_a_bad_file_and_says_so(self):
        with tempfile.TemporaryDirectory() as folder:
            good = make_parts.make("box", folder)
            bad = os.path.join(folder, "bad.step")
            with open(bad, "w") as f:
                f.write("not a step file")
            document, part = new_part(make_parts.box())
            saved = os.path.join(folder, "document.FCStd")
            document.saveAs(saved)
            FreeCAD.closeDocument(document.Name)
            out = os.path.join(folder, "out")
            rows, code = batch.run([bad, good, saved, os.path.join(folder, "missing.step")], out, {"size": 5.0, "order": 1})
            self.assertEqual(code, 4)
            self.assertEqual([r["result"] for r in rows], ["unreadable", "meshed", "meshed", "unreadable"])
            left = sorted(os.listdir(out))
            self.assertEqual(
                left, sorted(["summary.csv"] + [s + e for s in ("box", "document-Part") for e in (".FCStd", ".json", ".unv")])
            )
            mesh = FreeCAD.openDocument(os.path.join(out, "box.FCStd")).getObject("Part_Mesh")
            self.assertEqual(mesh.FemMesh.HexaCount, rows[1]["hexes"])


class TestBadInput(DocumentTest):
    def test_every_mistake_is_a_meshing_error_and_leaves_the_document_alone(self):
        document, part = new_part(make_parts.box())
        shell = document.addObject("Part::Feature", "Shell")
        shell.Shape = Part.makeShell(part.Shape.Faces[:5])
        before = len(document.Objects)
        mistakes = [(part, {"size": size}) for size in (0, -1, float("nan"), float("inf"), 1e6, 1e-6, "abc", True)]
        for name, value in (("labels", "none"), ("order", "x"), ("order", 3), ("nonsense", 1)):
            mistakes.append((part, {"size": 5, name: value}))
        mistakes += [(shell, {"size": 5}), (None, {"size": 5})]
        for obj, options in mistakes:
            with self.subTest(options=options), self.assertRaises(HexFeatureWB.MeshingError) as caught:
                HexFeatureWB.mesh(obj, **options)
            self.assertIn(caught.exception.kind, ("usage", "bad_input"))
            self.assertTrue(caught.exception.hint)
            self.assertEqual(len(document.Objects), before)


class TestSecondOrder(DocumentTest):
    def test_freecad_finds_every_quad_of_curved_faces(self):
        for name, size in (("flange", 3.5), ("connecting_rod", 3.2)):
            document, part = new_part(getattr(make_parts, name)())
            report = json.loads(HexFeatureWB.mesh(part, size=size, order=2).Report)
            self.assertEqual(report["groups_not_found_by_geometry"], {})
            self.assertEqual(report["faithfulness"]["straightened_mid_nodes"], 0)


class TestAddon(unittest.TestCase):
    def test_package_xml(self):
        root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
        metadata = FreeCAD.Metadata(os.path.join(root, "package.xml"))
        self.assertEqual(metadata.Name, "HexFeatureWB")
        self.assertTrue(os.path.isfile(os.path.join(root, metadata.Icon)))
        self.assertIn("workbench", metadata.Content)


class TestAnyDirection(unittest.TestCase):
    def test_a_turned_part_meshes_as_well(self):
        from HexFeatureWB import core

        turn = FreeCAD.Placement(FreeCAD.Vector(7, -3, 11), FreeCAD.Rotation(17, 31, 8))
        for name in ("bracket", "connecting_rod", "shaft", "plate_with_holes"):
            make, size = make_parts.PARTS[name]
            shape = make().Solids[0]
            turned = shape.copy()
            turned.Placement = turn.multiply(turned.Placement)
            straight, tilted = (
                core.load().mesh_brep(s.exportBrepToString(), {"size": size}).report() for s in (shape, turned)
            )
            self.assertEqual(tilted["faithfulness"]["sharp_edges_not_followed"], [], name)
            self.assertEqual(tilted["faithfulness"]["faces_without_quads"], [], name)
            self.assertAlmostEqual(tilted["quality"]["hexes"], straight["quality"]["hexes"], delta=0.1 * straight["quality"]["hexes"])
            self.assertGreater(tilted["quality"]["min_scaled_jacobian"], straight["quality"]["min_scaled_jacobian"] - 0.05, name)
