# HexFeatureWB - LGPL-2.1-or-later
"""What the window stands on, without it: freecadcmd -P tests/freecad -P tests/parts -P python -t TestHexFeatureWindowless"""
import os
import re
import tempfile
import unittest

import FreeCAD
import Part

import HexFeatureWB
from HexFeatureWB import analysis

import make_parts


def new_part(shape):
    document = FreeCAD.newDocument("Test")
    document.UndoMode = 1
    part = document.addObject("Part::Feature", "Part")
    part.Shape = shape
    document.recompute()
    return document, part


class DocumentTest(unittest.TestCase):
    def tearDown(self):
        for name in list(FreeCAD.listDocuments()):
            FreeCAD.closeDocument(name)


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


class TestForceOnARoundFace(DocumentTest):
    def test_the_whole_force_lands_on_a_disc_of_few_elements(self):
        document, part = new_part(make_parts.round_bar())
        mesh = HexFeatureWB.mesh(part, size=6, order=2)
        disc = next(n for n, face in enumerate(part.Shape.Faces, 1) if isinstance(face.Surface, Part.Plane))
        none = [(part, ("Face1",))]
        study, solver = analysis.static_analysis(document, mesh, none, [(part, ("Face%d" % disc,))], 1000.0)
        from femtools.ccxtools import FemToolsCcx

        with tempfile.TemporaryDirectory() as folder:
            tools = FemToolsCcx(study, solver, test_mode=False)
            tools.update_objects()
            tools.setup_working_dir(folder)
            tools.write_inp_file()
            with open(tools.inp_file_name) as f:
                rows = re.findall(r"^\d+, *[123], *(\S+)$", f.read().partition("*CLOAD")[2], re.MULTILINE)
        self.assertGreater(len(rows), 20)
        self.assertAlmostEqual(abs(sum(map(float, rows))), 1000.0, delta=1.0)


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


class TestConstraints(DocumentTest):
    """What each kind of constraint writes for CalculiX: exactly the nodes and faces on its CAD entity."""

    def setUp(self):
        import ObjectsFem

        self.document, self.part = new_part(make_parts.box())
        self.mesh = HexFeatureWB.mesh(self.part, size=5, order=1)
        none = [(self.part, ("Face1",))]
        self.study, self.solver = analysis.static_analysis(self.document, self.mesh, none, [(self.part, ("Face2",))], 100.0)
        self.make = ObjectsFem
        groups = self.mesh.FemMesh
        self.groups = {groups.getGroupName(g): set(groups.getGroupElements(g)) for g in groups.Groups}

    def written(self, constraint, references):
        """(text of the .inp, node sets by name) with one more constraint on [(part, (names...))]."""
        from femtools.ccxtools import FemToolsCcx

        constraint.References = references
        self.study.addObject(constraint)
        self.document.recompute()
        with tempfile.TemporaryDirectory() as folder:
            tools = FemToolsCcx(self.study, self.solver, test_mode=False)
            tools.update_objects()
            tools.setup_working_dir(folder)
            tools.write_inp_file()
            with open(tools.inp_file_name) as f:
                text = f.read()
        sets, current = {}, None
        for line in text.splitlines():
            if line.upper().startswith("*NSET"):
                current = sets.setdefault(line.split("NSET=")[1].split(",")[0].strip(), set())
            elif line.startswith("*"):
                current = None
            elif current is not None and not line.startswith("**"):
                current.update(int(n) for n in line.replace(",", " ").split() if n.isdigit())
        return text, sets

    def face_nodes(self, name):
        return {n for face in self.groups[name] for n in self.mesh.FemMesh.getElementNodes(face)}

    def test_fixed_on_face_edge_and_vertex(self):
        for name, expected in (("Face3", self.face_nodes("Face3")), ("Edge5", self.groups["Edge5"]), ("Vertex2", self.groups["Vertex2"])):
            constraint = self.make.makeConstraintFixed(self.document, "Held" + name)
            _, sets = self.written(constraint, [(self.part, (name,))])
            self.assertEqual(sets["Held" + name], expected)

    def test_displacement(self):
        constraint = self.make.makeConstraintDisplacement(self.document, "Moved")
        constraint.xFree = False
        constraint.xFix = True
        _, sets = self.written(constraint, [(self.part, ("Face4",))])
        self.assertEqual(sets["Moved"], self.face_nodes("Face4"))

    def test_force_loads_exactly_the_faces_nodes_with_its_sum(self):
        text, _ = self.written(self.make.makeConstraintFixed(self.document, "Other"), [(self.part, ("Face1",))])
        lines = iter(text.splitlines())
        loads = {}
        for line in lines:
            if line.upper().startswith("*CLOAD"):
                for line in lines:
                    if line.startswith("*") and not line.startswith("**"):
                        break
                    fields = [f.strip() for f in line.split(",")]
                    if len(fields) == 3 and fields[0].isdigit():
                        loads.setdefault(int(fields[0]), 0.0)
                        loads[int(fields[0])] += float(fields[2])
        self.assertEqual(set(loads), self.face_nodes("Face2"))
        self.assertAlmostEqual(abs(sum(loads.values())), 100, places=6)

    def test_pressure_loads_every_element_on_the_face_once(self):
        constraint = self.make.makeConstraintPressure(self.document, "Pressed")
        try:
            constraint.Pressure = 1.0
        except TypeError:  # FreeCAD 1.1: a quantity
            constraint.Pressure = "1 MPa"
        text, _ = self.written(constraint, [(self.part, ("Face6",))])
        elements = [line.split(",")[0] for line in text.splitlines() if ",P" in line.replace(" ", "") and line[:1].isdigit()]
        self.assertEqual(len(elements), len(self.groups["Face6"]))
        self.assertEqual(len(set(elements)), len(elements))

    def test_a_heat_flux_lies_on_every_element_of_the_face_once(self):
        constraint = self.make.makeConstraintHeatflux(self.document, "Heated")
        self.solver.AnalysisType = "thermomech"  # the only one whose writer knows heat
        steel = next(member for member in self.study.Group if member.Name.startswith("Steel"))
        steel.Material = dict(steel.Material, ThermalConductivity="50 W/m/K", ThermalExpansionCoefficient="1e-5 m/m/K",
                              SpecificHeat="500 J/kg/K")
        constraint.ConstraintType = "DFlux"
        try:
            constraint.DFlux = 1000.0
        except TypeError:  # FreeCAD 1.1: a quantity
            constraint.DFlux = "1000 W/m^2"
        text, _ = self.written(constraint, [(self.part, ("Face6",))])
        rows = [line.split(",") for line in text.splitlines() if re.match(r"\d+, *S\d,", line)]
        self.assertEqual(len({row[0] for row in rows}), len(self.groups["Face6"]))
        self.assertEqual(len(rows), len(self.groups["Face6"]))

    def test_what_geometry_finds_on_every_face_edge_and_vertex(self):
        # The writers of the other constraints ask the mesh these questions.
        fem, shape = self.mesh.FemMesh, self.part.Shape
        for number, face in enumerate(shape.Faces, 1):
            self.assertEqual(set(fem.getFacesByFace(face)), self.groups["Face%d" % number])
            self.assertEqual(set(fem.getNodesByFace(face)), self.face_nodes("Face%d" % number))
        for number, edge in enumerate(shape.Edges, 1):
            self.assertEqual(set(fem.getNodesByEdge(edge)), self.groups["Edge%d" % number])
        for number, vertex in enumerate(shape.Vertexes, 1):
            self.assertEqual(set(fem.getNodesByVertex(vertex)), self.groups["Vertex%d" % number])
