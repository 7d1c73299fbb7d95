# HexFeatureWB - LGPL-2.1-or-later
"""Small parts for the tests, drawn by FreeCAD once a session."""
import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, os.environ.get("HEXFEATURE_PACKAGE", str(ROOT / "python")))  # another build's: tests/sanitize.sh

DRAW = """
import math
import sys
sys.path += ["/usr/lib/freecad-python3/lib", "/usr/lib/freecad/lib", "/usr/lib/freecad/Mod"]
import FreeCAD, Part, Sketcher, _PartDesign
from FreeCAD import Vector as V
folder = sys.argv[1] + "/"
box = Part.makeBox(40, 20, 10)
plate = Part.makeBox(40, 40, 10).cut(Part.makeCylinder(8, 10, V(20, 20, 0)))
box.exportStep(folder + "box.step")
boss = Part.makeBox(50, 50, 8, V(-25, -25, 0)).fuse(Part.makeCylinder(12, 20, V(0, 0, 8)))
on_foot = [Part.Vertex(V(12 * math.cos(a), 12 * math.sin(a), 8)) for a in (1.0, 2.9)]
boss.generalFuse(on_foot)[0].Solids[0].exportStep(folder + "boss_with_foot_in_pieces.step")
box.exportBrep(folder + "box.brep")
box.exportIges(folder + "box.iges")
box.exportStl(folder + "box.stl")
plate.exportStep(folder + "plate.step")
plate.exportStl(folder + "plate.stl")
turned = plate.copy()
turned.Placement = FreeCAD.Placement(V(30, -70, 5), FreeCAD.Rotation(V(0.3, -0.7, 0.5), 137))
turned.exportStep(folder + "turned_plate.step")
turned.exportStl(folder + "turned_plate.stl")
turned.exportBrep(folder + "turned_plate.brep")
Part.makeShell(box.Faces[:5]).exportStep(folder + "open_shell.step")
Part.makeCompound([box, Part.makeBox(5, 5, 5, V(60, 0, 0))]).exportStep(folder + "two_solids.step")

def document(name, add):
    doc = FreeCAD.newDocument(name)
    add(doc)
    doc.recompute()
    doc.saveAs(folder + name + ".FCStd")
    FreeCAD.closeDocument(name)

def one(doc):
    a, b = doc.addObject("Part::Box", "Base"), doc.addObject("Part::Cylinder", "Drill")
    a.Length, a.Width, a.Height = 40, 40, 10
    b.Radius, b.Placement.Base = 8, V(20, 20, 0)
    cut = doc.addObject("Part::Cut", "Cut")
    cut.Base, cut.Tool = a, b
    cut.Label = "drilled plate"

def body(doc):
    body = doc.addObject("PartDesign::Body", "Body")
    sketch = body.newObject("Sketcher::SketchObject", "Sketch")
    sketch.Support = (doc.getObject("XY_Plane"), [""])
    sketch.MapMode = "FlatFace"
    points = [V(0, 0), V(40, 0), V(40, 20), V(0, 20)]
    for k in range(4):
        sketch.addGeometry(Part.LineSegment(points[k], points[(k + 1) % 4]), False)
    pad = body.newObject("PartDesign::Pad", "Pad")
    pad.Profile = sketch
    pad.Length = 10

def two(doc):
    doc.addObject("Part::Box", "First").Label = "first box"
    other = doc.addObject("Part::Box", "Second")
    other.Length = 30

document("one", one)
document("body", body)
document("two", two)
document("empty", lambda doc: None)
"""


@pytest.fixture(scope="session")
def parts(tmp_path_factory):
    """Folder with box.step/.brep/.iges/.stl, plate and turned_plate .step/.stl, open_shell.step, two_solids.step, and FreeCAD documents."""
    folder = tmp_path_factory.mktemp("parts")
    subprocess.run(["/usr/bin/python3", "-c", DRAW, str(folder)], check=True, capture_output=True)
    step = (folder / "box.step").read_text()
    (folder / "truncated.step").write_text(step[: len(step) // 2])
    (folder / "empty.step").write_text("")
    (folder / "no_solid.step").write_text(step[: step.index("DATA;")] + "DATA;\nENDSEC;\nEND-ISO-10303-21;\n")
    (folder / "noise.step").write_bytes(bytes(range(256)) * 64)
    (folder / "box.xyz").write_text("no such format")
    (folder / "not_a_document.FCStd").write_text("this is no zip")
    facets = (folder / "box.stl").read_text().split("facet normal")
    (folder / "hole.stl").write_text("facet normal".join(facets[:-1]) + "endsolid\n")
    return folder


@pytest.fixture(scope="session")
def box_mesh(parts):
    """The box as first-order elements."""
    import hexfeature

    return hexfeature.mesh(parts / "box.step", size=5)


@pytest.fixture(scope="session")
def box_mesh2(parts):
    """The box as second-order elements."""
    import hexfeature

    return hexfeature.mesh(parts / "box.step", size=5, order=2)
