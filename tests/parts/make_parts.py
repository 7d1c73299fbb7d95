#!/usr/bin/python3
"""The project's own parts: mechanical parts drawn by script with FreeCAD's Part module, written as STEP.

    /usr/bin/python3 tests/parts/make_parts.py OUT_DIR [NAME ...]

Leaves OUT_DIR/NAME.step and OUT_DIR/parts.csv (columns part, size: the element size to mesh it with).
Lengths in mm.
"""
import argparse
import csv
import math
import os
import sys

sys.path += ["/usr/lib/freecad-python3/lib", "/usr/lib/freecad/lib"]
import FreeCAD  # noqa: E402  before Part, or Part crashes outside FreeCAD
import Part  # noqa: E402

V = FreeCAD.Vector
Z = V(0, 0, 1)


def cylinder(radius, height, at=(0, 0, 0), axis=(0, 0, 1)):
    return Part.makeCylinder(radius, height, V(*at), V(*axis))


def block(dx, dy, dz, at=(0, 0, 0)):
    return Part.makeBox(dx, dy, dz, V(*at))


def box():
    """A beam: the plain case, every element a perfect brick."""
    return block(100, 10, 10)


def round_bar():
    return cylinder(10, 40)


def sphere():
    return Part.makeSphere(20)


def bracket():
    """An angle bracket: foot with two bolt holes, upright with one, ribless."""
    body = block(60, 40, 10).fuse(block(10, 40, 60)).removeSplitter()
    for y in (10, 30):
        body = body.cut(cylinder(4, 10, (40, y, 0)))
    return body.cut(cylinder(7, 10, (0, 20, 40), (1, 0, 0)))


def filleted_l():
    """An L-profile whose inner edge is rounded."""
    body = block(40, 30, 10).fuse(block(10, 30, 40)).removeSplitter()
    inner = [e for e in body.Edges if abs(e.CenterOfMass.x - 10) < 1e-6 and abs(e.CenterOfMass.z - 10) < 1e-6]
    return body.makeFillet(6, inner)


def plate_with_holes():
    """A plate with twelve round holes in a 4 x 3 pattern."""
    body = block(120, 90, 10)
    for i in range(4):
        for j in range(3):
            body = body.cut(cylinder(7, 10, (15 + 30 * i, 15 + 30 * j, 0)))
    return body


def flange():
    """A pipe flange: disc with hub, bore and six bolt holes."""
    body = cylinder(50, 12).fuse(cylinder(25, 40)).removeSplitter()
    body = body.cut(cylinder(15, 40))
    for k in range(6):
        a = math.pi / 3 * k + math.pi / 6
        body = body.cut(cylinder(5, 12, (38 * math.cos(a), 38 * math.sin(a), 0)))
    return body


def pipe_tee():
    """Two pipes of one size meeting at a right angle, bored through."""
    outer = cylinder(20, 120, (-60, 0, 0), (1, 0, 0)).fuse(cylinder(16, 60, (0, 0, 0)))
    inner = cylinder(14, 120, (-60, 0, 0), (1, 0, 0)).fuse(cylinder(11, 60, (0, 0, 0)))
    return outer.cut(inner).removeSplitter()


def shaft():
    """A turned shaft with shoulders: five diameters on one axis."""
    body, z = None, 0
    for radius, length in ((12, 30), (18, 20), (25, 15), (16, 40), (10, 25)):
        piece = cylinder(radius, length, (0, 0, z))
        body = piece if body is None else body.fuse(piece)
        z += length
    return body.removeSplitter()


def connecting_rod():
    """The paper's second example: two eyes joined by a web, of about 1,800 elements."""
    web = block(110, 18, 14, (0, -9, 3))
    body = cylinder(28, 20).fuse(cylinder(18, 20, (110, 0, 0))).fuse(web)
    body = body.cut(cylinder(18, 20)).cut(cylinder(10, 20, (110, 0, 0)))
    return body.removeSplitter()


def crank_shaft():
    """The paper's first example: two journals, two webs and a crank pin, of about 8,200 elements."""
    body = cylinder(15, 40)
    body = body.fuse(block(90, 50, 16, (-30, -25, 40)))
    body = body.fuse(cylinder(13, 30, (35, 0, 56)))
    body = body.fuse(block(90, 50, 16, (-30, -25, 86)))
    return body.fuse(cylinder(15, 40, (0, 0, 102))).removeSplitter()


#: name -> (function, element size)
PARTS = {
    "box": (box, 2.5),
    "round_bar": (round_bar, 2.0),
    "sphere": (sphere, 3.0),
    "bracket": (bracket, 3.0),
    "filleted_l": (filleted_l, 2.5),
    "plate_with_holes": (plate_with_holes, 3.3),
    "flange": (flange, 3.5),
    "pipe_tee": (pipe_tee, 3.0),
    "shaft": (shaft, 3.5),
    "connecting_rod": (connecting_rod, 3.2),
    "crank_shaft": (crank_shaft, 3.0),
}


def make(name, folder):
    """Write one part as STEP; returns the path."""
    os.makedirs(folder, exist_ok=True)
    shape = PARTS[name][0]()
    if shape.ShapeType != "Solid":
        shape = shape.Solids[0]
    if not shape.isValid():
        raise ValueError(name + " is not a valid solid")
    path = os.path.join(folder, name + ".step")
    shape.exportStep(path)
    return path


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder")
    parser.add_argument("names", nargs="*", choices=[[], *PARTS], default=[])
    arguments = parser.parse_args()
    names = arguments.names or list(PARTS)
    for name in names:
        make(name, arguments.folder)
    with open(os.path.join(arguments.folder, "parts.csv"), "w", newline="") as f:
        table = csv.writer(f)
        table.writerow(["part", "size"])
        table.writerows([name + ".step", PARTS[name][1]] for name in names)


if __name__ == "__main__":
    main()
