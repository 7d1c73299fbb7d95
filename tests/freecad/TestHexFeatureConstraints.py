# HexFeatureWB - LGPL-2.1-or-later
"""What FreeCAD's constraints write for CalculiX: exactly the nodes and element faces of their CAD entity.

freecadcmd -P tests/freecad -P tests/parts -P python -t TestHexFeatureConstraints
"""
import json
import re
import tempfile

import FreeCAD

import HexFeatureWB
from HexFeatureWB import analysis

import make_parts
from hexfeature_documents import DocumentTest, new_part

#: corners of CalculiX' element faces 1 to 6, by its node order
CCX_FACES = ((0, 1, 2, 3), (4, 7, 6, 5), (0, 4, 5, 1), (1, 5, 6, 2), (2, 6, 7, 3), (3, 7, 4, 0))


class Input:
    """An .inp file: `sets` node set -> nodes; `hexes` id -> corner nodes; `loads` keyword -> [fields], `surfaces` name -> [fields]."""

    def __init__(self, path):
        self.sets, self.hexes, self.loads, self.surfaces = {}, {}, {}, {}
        with open(path) as f:
            self.text = f.read()
        into, row, width = None, [], 0
        for line in self.text.splitlines():
            if line.startswith("**") or not line.strip():
                continue
            fields = [field.strip() for field in line.rstrip().rstrip(",").split(",")]
            if line.startswith("*"):
                keyword = fields[0].upper().lstrip("*")
                given = dict(re.findall(r"(\w+)\s*=\s*([^,\s]+)", line))
                kind, width = None, 0
                if keyword == "NSET":
                    kind, into = "set", self.sets.setdefault(given["NSET"], set())
                elif keyword == "ELEMENT" and given["TYPE"] in ("C3D8", "C3D8I", "C3D8R", "C3D20", "C3D20R"):
                    kind, into, width = "element", self.hexes, 21 if "20" in given["TYPE"] else 9
                elif keyword == "SURFACE":
                    kind, into = "rows", self.surfaces.setdefault(given["NAME"], [])
                elif keyword in ("CLOAD", "DLOAD", "FILM", "DFLUX", "BOUNDARY", "CFLUX"):
                    kind, into = "rows", self.loads.setdefault(keyword, [])
                reading = kind
            elif reading == "set":
                into.update(int(field) for field in fields if field.isdigit())
            elif reading == "element":
                row += [int(field) for field in fields]
                if len(row) >= width:
                    into[row[0]], row = row[1:9], []
            elif reading == "rows":
                into.append(fields)

    def faces(self, rows):
        """[frozenset of corner nodes] of the element faces of rows like 12,P3,...; or element set names."""
        found = []
        for element, face, *_ in rows:
            corners = self.hexes[int(element)]
            found.append(frozenset(corners[k] for k in CCX_FACES[int(face[1:]) - 1]))
        return found


class Constraints:
    """On a block with a bolt hole: Face7 is the hole's cylinder."""

    order = None
    HOLE = "Face7"

    def setUp(self):
        import ObjectsFem

        hole = make_parts.cylinder(5, 10, (10, 10, 0))
        self.document, self.part = new_part(make_parts.block(30, 20, 10).cut(hole))
        self.assertEqual(self.part.Shape.getElement(self.HOLE).Surface.TypeId, "Part::GeomCylinder")
        self.mesh = HexFeatureWB.mesh(self.part, size=4, order=self.order)
        self.study, self.solver = analysis.static_analysis(
            self.document, self.mesh, [(self.part, ("Face1",))], [(self.part, ("Face2",))], 100.0)
        self.make = ObjectsFem
        fem = self.mesh.FemMesh
        self.groups = {fem.getGroupName(g): set(fem.getGroupElements(g)) for g in fem.Groups}

    def written(self, constraint, *names):
        """The Input with this constraint on the named entities."""
        from femtools.ccxtools import FemToolsCcx

        constraint.References = [(self.part, name) for name in names]
        self.study.addObject(constraint)
        self.document.recompute()
        with tempfile.TemporaryDirectory() as folder:
            tools = FemToolsCcx(self.study, self.solver, test_mode=False)
            tools.update_objects()
            tools.setup_working_dir(folder)
            tools.write_inp_file()
            found = Input(tools.inp_file_name)
        self.study.removeObject(constraint)
        self.document.removeObject(constraint.Name)
        return found

    def quads(self, name):
        """{corner nodes} of our quads on a face."""
        return {frozenset(self.mesh.FemMesh.getElementNodes(q)[:4]) for q in self.groups[name]}

    def nodes(self, name):
        if not name.startswith("Face"):
            return self.groups[name]
        return {n for quad in self.groups[name] for n in self.mesh.FemMesh.getElementNodes(quad)}

    def same_faces(self, found, *names):
        expected = set().union(*(self.quads(name) for name in names))
        self.assertEqual(len(found), len(expected))  # each once
        self.assertEqual(set(found), expected)

    def is_arbitrary(self, item):
        """Where the hole's cylinder and circles begin: its seam, and the circles' only vertices. No node has to lie there."""
        hole = self.part.Shape.getElement(self.HOLE)
        if item.ShapeType == "Vertex":
            return any(item.isSame(v) for v in hole.Vertexes)
        return item.ShapeType == "Edge" and item.isSeam(hole)

    def set_value(self, constraint, name, value, unit):
        try:
            setattr(constraint, name, "%r %s" % (value, unit))
        except TypeError:  # FreeCAD 0.20: a number
            setattr(constraint, name, value)

    def test_every_entity_has_its_group(self):
        shape = self.part.Shape
        for kind, items in (("Face", shape.Faces), ("Edge", shape.Edges), ("Vertex", shape.Vertexes)):
            for number, item in enumerate(items, 1):
                if self.is_arbitrary(item):
                    self.assertNotIn(kind + str(number), self.groups)
                    continue
                self.assertTrue(self.groups[kind + str(number)], kind + str(number))
        self.assertEqual(len(self.groups["Solid1"]), self.mesh.HexCount)
        bare = json.loads(self.mesh.Report)["entities_without_nodes"]
        self.assertEqual(sorted(name[:4] for name in bare), ["Edge", "Vert", "Vert"])
        self.assertFalse(set(bare) & set(self.groups))

    def test_what_geometry_finds(self):
        fem, shape = self.mesh.FemMesh, self.part.Shape
        for number, face in enumerate(shape.Faces, 1):
            self.assertEqual(set(fem.getFacesByFace(face)), self.groups["Face%d" % number])
            self.assertEqual(set(fem.getNodesByFace(face)), self.nodes("Face%d" % number))
        for number, edge in enumerate(shape.Edges, 1):
            if not self.is_arbitrary(edge):
                self.assertEqual(set(fem.getNodesByEdge(edge)), self.groups["Edge%d" % number])
        for number, vertex in enumerate(shape.Vertexes, 1):
            if not self.is_arbitrary(vertex):
                self.assertEqual(set(fem.getNodesByVertex(vertex)), self.groups["Vertex%d" % number])

    def test_fixed(self):
        for name in (self.HOLE, "Face3", "Edge5", "Vertex2"):
            found = self.written(self.make.makeConstraintFixed(self.document, "Held"), name)
            self.assertEqual(found.sets["Held"], self.nodes(name), name)

    def test_displacement(self):
        for name in (self.HOLE, "Edge3", "Vertex4"):
            constraint = self.make.makeConstraintDisplacement(self.document, "Moved")
            constraint.xFree = False
            if hasattr(constraint, "xFix"):  # FreeCAD 0.20
                constraint.xFix = True
            found = self.written(constraint, name)
            self.assertEqual(found.sets["Moved"], self.nodes(name), name)
            self.assertIn(["Moved", "1"], [row[:2] for row in found.loads["BOUNDARY"]])

    def test_force_on_face_edge_and_vertex(self):
        self.study.removeObject(self.document.getObject("Force"))
        for name in (self.HOLE, "Face4", "Edge2", "Vertex3"):
            constraint = self.make.makeConstraintForce(self.document, "Pull")
            self.set_value(constraint, "Force", 100.0, "N")
            constraint.Direction = (self.part, ("Edge1",))
            found = self.written(constraint, name)
            loads = [row for row in found.loads["CLOAD"] if row[0].isdigit()]
            self.assertLessEqual({int(node) for node, _, _ in loads}, self.nodes(name), name)
            if self.order == 1 or not name.startswith("Face"):  # a corner node's share of an even load may be 0 on an 8-node quad
                self.assertEqual({int(node) for node, _, _ in loads}, self.nodes(name), name)
            total = [sum(float(value) for _, axis, value in loads if axis == str(k)) for k in (1, 2, 3)]
            total = FreeCAD.Vector(*total).Length
            if name == self.HOLE:  # the elements' areas over the CAD face's: flat at first order, with our curved quads at second
                self.assertAlmostEqual(total, 100, delta=4 if self.order == 1 else 0.1)
            else:
                self.assertAlmostEqual(total, 100, places=4, msg=name)

    def test_pressure(self):
        for names in ((self.HOLE,), ("Face6",), ("Face3", "Face5")):
            constraint = self.make.makeConstraintPressure(self.document, "Pressed")
            self.set_value(constraint, "Pressure", 1.0, "MPa")
            found = self.written(constraint, *names)
            self.same_faces(found.faces(found.loads["DLOAD"]), *names)

    def test_contact(self):
        found = self.written(self.make.makeConstraintContact(self.document, "Touch"), "Face3", self.HOLE)
        sides = [found.faces(found.surfaces[side + "Touch"]) for side in ("DEP", "IND")]
        for side, names in zip(sides, (("Face3", self.HOLE), (self.HOLE, "Face3"))):
            self.assertIn(set(side), [self.quads(name) for name in names])
        self.same_faces(sides[0] + sides[1], "Face3", self.HOLE)

    def test_tie(self):
        found = self.written(self.make.makeConstraintTie(self.document, "Glued"), "Face3", "Face4")
        sides = [found.faces(rows) for _, rows in sorted(found.surfaces.items())]
        self.same_faces(sides[0] + sides[1], "Face3", "Face4")

    def heat(self):
        self.solver.AnalysisType = "thermomech"
        steel = self.document.getObject("Steel")
        card = steel.Material
        card.update(ThermalConductivity="43 W/m/K", SpecificHeat="590 J/kg/K", ThermalExpansionCoefficient="1.2e-5 m/m/K")
        steel.Material = card
        start = self.make.makeConstraintInitialTemperature(self.document, "Start")
        self.study.addObject(start)

    def test_heat_flux_and_convection(self):
        self.heat()
        for kind, keyword in (("DFlux", "DFLUX"), ("Convection", "FILM")):
            for name in (self.HOLE, "Face6"):
                constraint = self.make.makeConstraintHeatflux(self.document, "Heated")
                constraint.ConstraintType = kind
                found = self.written(constraint, name)
                self.same_faces(found.faces(found.loads[keyword]), name)

    def test_temperature(self):
        self.heat()
        for name in (self.HOLE, "Edge4", "Vertex1"):
            found = self.written(self.make.makeConstraintTemperature(self.document, "Warm"), name)
            self.assertEqual(found.sets["Warm"], self.nodes(name), name)
            self.assertIn(["Warm", "11"], [row[:2] for row in found.loads["BOUNDARY"]])

    def test_a_spring_is_not_written_by_freecad(self):
        # No version of FreeCAD writes springs for CalculiX. What any writer would ask is in test_what_geometry_finds.
        found = self.written(self.make.makeConstraintSpring(self.document, "Bedded"), self.HOLE)
        self.assertNotIn("*SPRING", found.text.upper())
        self.assertNotIn("Bedded", found.sets)


class TestFirstOrder(Constraints, DocumentTest):
    order = 1


class TestSecondOrder(Constraints, DocumentTest):
    order = 2
