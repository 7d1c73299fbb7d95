#!/usr/bin/python3
# HexFeatureWB - LGPL-2.1-or-later
"""Loads land right: benchmarks/verification/freecad_loads.py OUT_DIR [PART ...]

Each of the project's own parts in a FreeCAD document, meshed with 20-node hexahedra, fixed on its largest plane face, and
loaded in turn by each kind of constraint; FreeCAD writes the deck and CalculiX solves it. The reaction's force and moment
(about the origin, over force times the part's diagonal) must be the load's, which is known from the CAD alone; so must the heat
that flows out at a held temperature. The reactions to a prescribed displacement must do the work on a force's displacements that
the force does on the prescribed one (Betti's theorem), which the CAD knows whatever the part's stiffness. For contact and tie a
pad lies on the part and is pressed. A mirrored and a moved copy of each part must bend as the part does. Leaves
OUT_DIR/loads.json. Exit code 1 when a figure exceeds its limit.
"""
import json
import math
import os
import re
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path[:0] = [str(HERE), str(ROOT / "python"), str(ROOT / "tests" / "parts")]
sys.path += ["/usr/lib/freecad" + folder for folder in ("-python3/lib", "/lib", "/Mod", "/Mod/Fem", "/Ext")]
import FreeCAD  # noqa: E402
import Part  # noqa: E402

import numpy as np  # noqa: E402

import arguments  # noqa: E402
import calculix  # noqa: E402
import HexFeatureWB  # noqa: E402
from deck import Deck  # noqa: E402
from HexFeatureWB import analysis  # noqa: E402
import make_parts  # noqa: E402

V = FreeCAD.Vector
DENSITY, GRAVITY, TURNS = 7900e-12, 9806.65, 50.0  # t/mm3, mm/s2, 1/s
LIMIT = 1e-3  #: of a reaction's force and moment
LIMIT_OF_COPIES = 5e-3  #: of a copy's displacement: its mesh is another one of the same size
#: coarser than for stresses: equilibrium does not depend on it
COARSER = {"flange": 1.4, "pipe_tee": 1.6, "crank_shaft": 1.6, "shaft": 1.4, "plate_with_holes": 1.4}


class Reaction:
    """nodes: node - 1 -> the support's force on it; displacements (n, 3); force and moment about the origin of all; farthest: the
    largest displacement."""

    def __init__(self, nodes, points, displacements):
        self.nodes, self.displacements = nodes, displacements
        self.force = V(*sum(nodes.values()))
        self.moment = V(*sum(np.cross(points[node], force) for node, force in nodes.items()))
        self.farthest = float(np.nanmax(np.linalg.norm(displacements, axis=1)))

    def work_on(self, displacements):
        return sum(force @ displacements[node] for node, force in self.nodes.items())


class Case:
    """One part, fixed on one face, with its mesh; solves for one constraint after another."""

    def __init__(self, shape, size, folder):
        self.folder = folder
        self.document = FreeCAD.newDocument("Loads")
        self.part = self.document.addObject("Part::Feature", "Part")
        self.part.Shape = shape
        self.shape = self.part.Shape
        self.faces = self.shape.Faces
        plane = [n for n, f in enumerate(self.faces) if isinstance(f.Surface, Part.Plane)]
        self.fixed = max(plane, key=lambda n: self.faces[n].Area)
        self.curved = sorted((n for n in range(len(self.faces)) if n not in plane), key=lambda n: -self.faces[n].Area)
        self.mesh = HexFeatureWB.mesh(self.part, size=size, order=2)

    def far_face(self):
        """The plane face whose centre is farthest from the fixed one, and is not in its plane."""
        centre = self.faces[self.fixed].CenterOfMass
        others = [n for n, f in enumerate(self.faces) if n != self.fixed and isinstance(f.Surface, Part.Plane)]
        return max(others, key=lambda n: (self.faces[n].CenterOfMass - centre).Length)

    def face_apart(self):
        """The largest plane face that does not touch the far one: at a held node CalculiX's reaction lacks a tie's force."""
        far = self.faces[self.far_face()]
        apart = [n for n, f in enumerate(self.faces) if isinstance(f.Surface, Part.Plane) and f.distToShape(far)[0] > 1e-6]
        return max(apart or [self.fixed], key=lambda n: self.faces[n].Area)

    def solve(self, tag, *constraints, heat=False):
        """A Reaction; of heat: what flows out."""
        document = self.document
        study, solver = analysis.static_analysis(document, self.mesh, [(self.part, ("Face%d" % (self.fixed + 1),))],
                                                 [(self.part, ("Face%d" % (self.far_face() + 1),))], 1.0)
        for member in list(study.Group):  # no load but the one in question
            if member.Name.startswith("Force"):
                study.removeObject(member)
        for constraint in constraints:
            study.addObject(constraint)
        if heat:
            steel = next(member for member in study.Group if member.Name.startswith("Steel"))
            steel.Material = dict(steel.Material, ThermalConductivity="50 W/m/K", ThermalExpansionCoefficient="1.2e-5 m/m/K",
                                  SpecificHeat="500 J/kg/K")
            solver.AnalysisType, solver.ThermoMechSteadyState = "thermomech", True
        document.recompute()
        try:
            stem = self._run(study, solver, os.path.join(self.folder, tag))
            return self._read_heat(stem) if heat else self._read(stem)
        finally:
            for member in [m for m in study.Group if m.Name != self.mesh.Name]:
                document.removeObject(member.Name)
            study.Group = []
            document.removeObject(study.Name)

    def _run(self, study, solver, folder):
        from femtools.ccxtools import FemToolsCcx

        os.makedirs(folder, exist_ok=True)
        tools = FemToolsCcx(study, solver, test_mode=False)
        tools.update_objects()
        tools.setup_working_dir(folder)
        tools.setup_ccx()
        problem = tools.check_prerequisites()
        if problem:
            raise RuntimeError(problem)
        tools.write_inp_file()
        path = tools.inp_file_name
        text = Path(path).read_text()
        text = text.replace("TOTALS=ONLY", "TOTALS=YES")  # every node's reaction, for the moment
        if solver.AnalysisType == "thermomech":
            text = text.replace("*END STEP", "*NODE PRINT, NSET=Temperature, TOTALS=YES\nRFL\n*END STEP")
        Path(path).write_text(text)
        done = subprocess.run(["ccx", os.path.splitext(os.path.basename(path))[0]], cwd=os.path.dirname(path), capture_output=True,
                              text=True, errors="replace")
        if "Job finished" not in done.stdout:
            raise RuntimeError(done.stdout[-800:])
        return os.path.splitext(path)[0]

    def _read_heat(self, stem):
        """As with forces, CalculiX leaves the heat put on a held node out."""
        found = Deck(stem + ".inp", DENSITY)
        total, inside = 0.0, False
        for line in Path(stem + ".dat").read_text().splitlines():
            row = line.split()
            if "set TEMPERATURE" in line or "set Temperature" in line:
                inside = "heat" in line and "total" not in line
            elif inside and len(row) == 2 and row[0].isdigit():
                total += float(row[1]) - found.heat[int(row[0]) - 1]
        return total

    def _read(self, stem):
        """CalculiX's reaction at a held node lacks the load put on that very node, so this is added from the deck."""
        found = Deck(stem + ".inp", DENSITY)
        inside, at_nodes = False, {}
        for line in Path(stem + ".dat").read_text().splitlines():
            if "force" in line:
                inside = line.strip().startswith("forces")
            row = line.split()
            if inside and len(row) == 4 and row[0].isdigit():
                node = int(row[0]) - 1
                at_nodes[node] = np.array(row[1:], dtype=float) - found.external[node]
        if not at_nodes:
            raise RuntimeError("no reaction forces in " + stem + ".dat")
        return Reaction(at_nodes, found.points, calculix.read_frd(stem + ".frd")["U"])

    def close(self):
        FreeCAD.closeDocument(self.document.Name)


def pressure_of(face):
    """Force and moment of a unit pressure on a face: the vector area depends on the border only, so triangles do."""
    points, triangles = face.tessellate(0.002)
    force, moment = V(), V()
    for a, b, c in triangles:
        a, b, c = points[a], points[b], points[c]
        area = (b - a).cross(c - a) * 0.5
        force -= area
        moment -= (a + b + c).multiply(1 / 3).cross(area)
    return force, moment


def quantity(obj, name, value, unit):
    """A plain number on 0.20, a quantity on 1.1."""
    try:
        setattr(obj, name, value)
    except TypeError:
        setattr(obj, name, "%r %s" % (value, unit))


def constraints_of(case):
    """(name, constraints, force, moment or None): what each puts on the part, by the CAD."""
    import ObjectsFem

    document, part, shape = case.document, case.part, case.shape
    far = case.far_face()
    loaded = [("force on a plane face", far)] + ([("force on a curved face", case.curved[0])] if case.curved else [])
    for name, face in loaded:
        c = ObjectsFem.makeConstraintForce(document, "Load")
        c.References = [(part, ("Face%d" % (face + 1),))]
        quantity(c, "Force", 1000.0, "N")
        c.Direction = (part, ("Face%d" % (far + 1),))
        document.recompute()
        force = V(c.DirectionVector) * 1000.0
        yield name, [c], force, case.faces[face].CenterOfMass.cross(force)
    centre = case.faces[case.fixed].CenterOfMass
    # Not a cylinder's seam, which is no edge of the part: no mesh edge follows it, and FreeCAD would find no node there.
    straight = [n for n, e in enumerate(shape.Edges) if isinstance(e.Curve, (Part.Line, Part.LineSegment))
                and not any(e.isSeam(f) for f in shape.ancestorsOfType(e, Part.Face))]
    if straight:
        edge = max(straight, key=lambda n: (shape.Edges[n].CenterOfMass - centre).Length)
        c = ObjectsFem.makeConstraintForce(document, "Load")
        c.References = [(part, ("Edge%d" % (edge + 1),))]
        quantity(c, "Force", 1000.0, "N")
        c.Direction = (part, ("Face%d" % (far + 1),))
        document.recompute()
        force = V(c.DirectionVector) * 1000.0
        yield "force on an edge", [c], force, shape.Edges[edge].CenterOfMass.cross(force)
    sets = [("pressure on a plane face", [far])]
    if case.curved:
        sets.append(("pressure on a curved face", case.curved[:1]))
    sets.append(("pressure on all faces but the fixed", [n for n in range(len(case.faces)) if n != case.fixed]))
    for name, faces in sets:
        c = ObjectsFem.makeConstraintPressure(document, "Load")
        c.References = [(part, tuple("Face%d" % (n + 1) for n in faces))]
        quantity(c, "Pressure", 10.0, "MPa")
        force, moment = V(), V()
        for n in faces:
            f, m = pressure_of(case.faces[n])
            force, moment = force + f * 10, moment + m * 10
        # a closed bore's pressure has no resultant: the figure is over the pressure's own size
        yield name, [c], force, moment
    c = ObjectsFem.makeConstraintSelfWeight(document, "Load")
    c.Gravity_x, c.Gravity_y, c.Gravity_z = 0.6, 0.0, -0.8
    force = V(0.6, 0, -0.8) * (DENSITY * GRAVITY * shape.Volume)
    yield "self-weight", [c], force, shape.CenterOfMass.cross(force)
    if hasattr(ObjectsFem, "makeConstraintCentrif"):
        at = shape.BoundBox.Center + V(3 * shape.BoundBox.DiagonalLength, 0, 0)
        axis = document.addObject("Part::Feature", "Axis")
        axis.Shape = Part.makeLine(at, at + V(0, 0, 10))
        c = ObjectsFem.makeConstraintCentrif(document, "Load")
        c.RotationFrequency = "%r Hz" % TURNS
        c.RotationAxis = [(axis, "Edge1")]
        arm = shape.CenterOfMass - at
        yield "centrifugal", [c], V(arm.x, arm.y, 0) * (DENSITY * shape.Volume * (2 * math.pi * TURNS) ** 2), None


OVERLAP = 1e-3  #: mm of a pad and its part: faces in one place are one to FreeCAD, which finds the nodes by place
COMPARED = "pressure on a plane face"  #: the load under which copies are compared
FLUX = 2e5  #: W/m2, 0.2 mW/mm2 in FreeCAD's units for CalculiX


def heat_of(case):
    """(kind, constraints, heat into the part): a flux on a face, against a temperature held on the fixed face."""
    import ObjectsFem

    document, part = case.document, case.part
    for kind, face in [("heat flux on a plane face", case.far_face())] + (
            [("heat flux on a curved face", case.curved[0])] if case.curved else []):
        first = ObjectsFem.makeConstraintInitialTemperature(document, "Before")
        quantity(first, "initialTemperature", 300.0, "K")
        held = ObjectsFem.makeConstraintTemperature(document, "Temperature")
        held.References = [(part, ("Face%d" % (case.fixed + 1),))]
        quantity(held, "Temperature", 300.0, "K")
        flux = ObjectsFem.makeConstraintHeatflux(document, "Flux")
        flux.ConstraintType = "DFlux"
        quantity(flux, "DFlux", FLUX, "W/m^2")
        flux.References = [(part, ("Face%d" % (face + 1),))]
        yield kind, [first, held, flux], FLUX * 1e-3 * case.faces[face].Area


def padded(case):
    """The part with a pad lying on its far face: (compound, the pad's outer face's number, the pair's numbers, outward normal)."""
    far = case.far_face()
    face = case.faces[far].copy()
    normal = face.normalAt(0, 0)
    pad = face.extrude(normal * (0.1 * case.shape.BoundBox.DiagonalLength))
    pad.translate(normal * -OVERLAP)
    both = Part.makeCompound([case.shape.copy(), pad])
    count = len(case.faces)
    new = both.Faces[count:]
    plane = [n for n, f in enumerate(new) if isinstance(f.Surface, Part.Plane) and abs(f.Area / face.Area - 1) < 1e-6
             and abs(abs(f.normalAt(0, 0).dot(normal)) - 1) < 1e-6]
    on, off = sorted(plane, key=lambda n: (new[n].CenterOfMass - face.CenterOfMass).dot(normal))
    return both, count + off, (far, count + on), normal


def pressed_pads(case, size, folder):
    """(kind, force, found, moment, turned) of a pad tied to the part, and of one in contact with it, under pressure."""
    import ObjectsFem

    shape, outer, pair, normal = padded(case)
    both = Case(shape, size, folder)
    both.fixed = case.face_apart()
    force, moment = (vector * 10.0 for vector in pressure_of(both.faces[outer]))
    for kind, make in (("tie", "makeConstraintTie"), ("contact", "makeConstraintContact")):
        document = both.document
        joint = getattr(ObjectsFem, make)(document, "Joint")
        joint.References = [(both.part, ("Face%d" % (pair[1] + 1),)), (both.part, ("Face%d" % (pair[0] + 1),))]
        press = ObjectsFem.makeConstraintPressure(document, "Press")
        press.References = [(both.part, ("Face%d" % (outer + 1),))]
        quantity(press, "Pressure", 10.0, "MPa")
        constraints = [joint, press]
        if kind == "tie":
            quantity(joint, "Tolerance", 0.1, "mm")
        else:
            quantity(joint, "Slope", 1e6, "N/mm^3" if hasattr(joint.Slope, "Unit") else "")
            guide = ObjectsFem.makeConstraintDisplacement(document, "Guide")  # without friction the pad would slip away
            guide.References = [(both.part, ("Face%d" % (outer + 1),))]
            for axis, component in zip("xyz", normal):
                setattr(guide, axis + "Free", abs(component) > 0.5)
                setattr(guide, axis + "Fix", abs(component) <= 0.5)
            constraints.append(guide)
        found = both.solve(kind, *constraints)
        yield kind, force, found.force, moment, found.moment
    both.close()


def check(name, out):
    """Rows of one own part: (part, kind, force, error of force, error of moment)."""
    make, size = make_parts.PARTS[name]
    shape = make()
    shape = shape.Solids[0] if shape.ShapeType != "Solid" else shape
    size_used = COARSER.get(name, 1.2) * size
    rows, case = [], Case(shape, size_used, os.path.join(out, name))
    diagonal = shape.BoundBox.DiagonalLength
    for kind, constraints, force, moment in constraints_of(case):
        found = case.solve(re.sub(r"\W", "_", kind), *constraints)
        size_of_load = max(force.Length, 10.0 * max(f.Area for f in case.faces) * 1e-2 if "pressure" in kind else 0.0)
        row = {"part": name, "kind": kind, "load": force.Length, "force_error": (found.force + force).Length / size_of_load,
               "moment_error": None if moment is None else (found.moment + moment).Length / (size_of_load * diagonal),
               "displacement": found.farthest}
        rows.append(row)
        print("%-18s %-36s %10.3f  force off by %.1e  moment %s" % (
            name, kind, force.Length, row["force_error"], "-" if moment is None else "%.1e" % row["moment_error"]), flush=True)
    rows.append({"part": name, "kind": "prescribed displacement", **prescribed(case)})
    print("%-18s %-36s            reaction's work off by %.1e" % (name, rows[-1]["kind"], rows[-1]["force_error"]), flush=True)
    for kind, constraints, heat in heat_of(case):
        found = case.solve(re.sub(r"\W", "_", kind), *constraints, heat=True)
        rows.append({"part": name, "kind": kind, "load": heat, "force_error": abs(abs(found) / heat - 1), "moment_error": None})
        print("%-18s %-36s %10.3f  heat off by %.1e" % (name, kind, heat, rows[-1]["force_error"]), flush=True)
    if max(abs(c) for c in case.faces[case.far_face()].normalAt(0, 0)) > 1 - 1e-9:  # or a pad in contact cannot be guided
        for kind, force, found, moment, turned in pressed_pads(case, size_used, os.path.join(out, name)):
            rows.append({"part": name, "kind": kind, "load": force.Length, "force_error": (found + force).Length / force.Length,
                         "moment_error": (turned + moment).Length / (force.Length * diagonal) if kind == "tie" else None})
            print("%-18s %-36s %10.3f  force off by %.1e  moment %s" % (
                name, kind, force.Length, rows[-1]["force_error"], rows[-1]["moment_error"]), flush=True)
    case.close()
    first = next(row["displacement"] for row in rows if row["kind"] == COMPARED)
    mirrored = shape.mirror(V(), V(1, 0, 0))
    moved = shape.copy()
    moved.Placement = FreeCAD.Placement(V(7, -3, 11), FreeCAD.Rotation(17, 31, 8)).multiply(moved.Placement)
    for kind, copy in (("mirrored", mirrored), ("moved", moved)):
        copy = copy.Solids[0] if copy.ShapeType != "Solid" else copy
        case = Case(copy, size_used, os.path.join(out, name))
        constraints = next(loads[1] for loads in constraints_of(case) if loads[0] == COMPARED)
        farthest = case.solve(kind, *constraints).farthest
        rows.append({"part": name, "kind": kind, "displacement_change": abs(farthest / first - 1)})
        print("%-18s %-36s displacement differs by %.1e" % (name, kind, rows[-1]["displacement_change"]), flush=True)
        case.close()
    return rows


def prescribed(case):
    """The errors of a displacement prescribed on the far face.

    By Betti's theorem its reactions' work on the displacements under a force on that face is the force's work on the prescribed
    displacement, which the CAD knows. The reactions at both ends must also cancel. The part is held apart from that face: on a
    common edge nodes would be under both constraints.
    """
    import ObjectsFem

    document, far, fixed = case.document, case.far_face(), case.fixed
    value = case.faces[far].normalAt(0, 0) * 0.01
    held = ObjectsFem.makeConstraintDisplacement(document, "Held")
    held.References = [(case.part, ("Face%d" % (far + 1),))]
    for axis, component in zip("xyz", value):
        setattr(held, axis + "Free", False)
        setattr(held, axis + "Fix", False)
        quantity(held, axis + "Displacement", component, "mm")
    case.fixed = case.face_apart()
    try:
        kind, constraints, force, _ = next(constraints_of(case))
        under_force = case.solve("reciprocal", *constraints)
        found = case.solve("prescribed", held)
    finally:
        case.fixed = fixed
    one_end = V(*sum(f for node, f in found.nodes.items() if np.linalg.norm(found.displacements[node]) > 0.5 * value.Length))
    return {"load": force.Length, "force_error": max(abs(found.work_on(under_force.displacements) / force.dot(value) - 1),
                                                     found.force.Length / one_end.Length),
            "moment_error": found.moment.Length / (one_end.Length * case.shape.BoundBox.DiagonalLength)}


def main(out, names):
    """All own parts with a plane face, or those named; returns the exit code."""
    os.makedirs(out, exist_ok=True)
    rows = []
    for name in names or [n for n in make_parts.PARTS if n != "sphere"]:  # a sphere's one face cannot be fixed and loaded
        rows += check(name, os.path.join(out, "loads"))
        Path(out, "loads.json").write_text(json.dumps(rows, indent=1))
    worst = {kind: max(max(r["force_error"], r["moment_error"] or 0) for r in rows if r["kind"] == kind)
             for kind in dict.fromkeys(r["kind"] for r in rows if "force_error" in r)}
    for kind, error in worst.items():
        print("%-36s reaction and moment off by %.1e at most" % (kind, error))
    change = max(r.get("displacement_change", 0) for r in rows)
    print("a mirrored or moved part's displacement differs by %.1e at most" % change)
    errors = [error for r in rows if "force_error" in r for error in (r["force_error"], r["moment_error"] or 0)]
    changes = [r.get("displacement_change", 0) for r in rows]
    return int(not (all(e <= LIMIT for e in errors) and all(c <= LIMIT_OF_COPIES for c in changes)))  # not a number: neither


if __name__ == "__main__":
    asked = arguments.parse(__doc__, "NAME")
    sys.exit(main(asked.out, asked.names))
