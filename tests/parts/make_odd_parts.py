#!/usr/bin/python3
# HexFeatureWB - LGPL-2.1-or-later
"""Parts as users send them: far away, tiny, huge, in other units, inside out, hollow, with stray faces, slivers, tiny edges, narrow
chamfers, several solids.

    /usr/bin/python3 tests/parts/make_odd_parts.py OUT_DIR [NAME ...]

Leaves OUT_DIR/NAME.step or .brep. Most are one plate with a hole, 40 x 40 x 10, in another guise, so that its mesh must be the same.
"""
import math
import os
import re
import sys

sys.path += ["/usr/lib/freecad-python3/lib", "/usr/lib/freecad/lib", "/usr/lib/freecad/Mod"]
import FreeCAD  # noqa: E402  before Part, or Part crashes outside FreeCAD
import Part  # noqa: E402

V = FreeCAD.Vector
MM = "( LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.) )"


def plate():
    return Part.makeBox(40, 40, 10).cut(Part.makeCylinder(8, 10, V(20, 20, 0)))


def scaled(factor):
    """The plate drawn that much larger, not scaled as splines: its hole stays a cylinder."""
    box = Part.makeBox(40 * factor, 40 * factor, 10 * factor)
    return box.cut(Part.makeCylinder(8 * factor, 10 * factor, V(20 * factor, 20 * factor, 0)))


def far():
    shape = plate()
    shape.translate(V(1e6, -1e6, 1e6))
    return shape


def far_turned():
    """A bracket with a hole and two fillets, far away and along no axis: every coordinate of its CAD is rounded."""
    block = Part.makeBox(40, 30, 20)
    rounded = block.makeFillet(5, [e for e in block.Edges if e.BoundBox.XLength > 39 and e.BoundBox.ZMin > 19])
    shape = rounded.cut(Part.makeCylinder(6, 20, V(20, 15, 0)))
    shape.rotate(V(0, 0, 0), V(1, 2, 3), 37)
    shape.translate(V(3e5, -2e5, 1e5))
    return shape


def hollow():
    """A block with a closed void."""
    return Part.makeBox(30, 30, 30).cut(Part.makeBox(10, 10, 10, V(10, 10, 10)))


def stray():
    """The plate with two loose faces and a loose edge beside it, in one compound."""
    loose = Part.makePlane(5, 5, V(60, 0, 0))
    return Part.makeCompound([plate(), loose, Part.makePlane(5, 5, V(70, 0, 0)), Part.makeLine(V(0, 0, 50), V(1, 0, 50))])


def inside_out():
    return plate().reversed()


def shell_inside_out():
    """A solid of a shell whose faces look inward."""
    shell = plate().Shells[0]
    shell.reverse()
    return Part.Solid(shell)


def one_face_turned():
    """The shell lies: one of its faces looks the other way."""
    faces = plate().Faces
    faces[0].reverse()
    return Part.Compound(faces)


def prism(points, height):
    vectors = [V(x, y, 0) for x, y in points]
    return Part.Face(Part.makePolygon(vectors + vectors[:1])).extrude(V(0, 0, height))


def tiny_edge():
    """A corner cut off by a chamfer of a billionth of the part's length."""
    size, cut = 1e4, 1e-5
    return prism([(0, 0), (size, 0), (size, size - cut), (size - cut, size), (0, size)], size / 2)


def sliver():
    """A face a ten-thousandth as wide as the part, flush with its neighbours."""
    return prism([(0, 0), (20, 0), (20.004, 0), (40, 0), (40, 40), (0, 40)], 10)


def touching():
    """Two bores that touch each other along a line."""
    block = Part.makeBox(60, 30, 10)
    return block.cut(Part.makeCylinder(8, 10, V(22, 15, 0))).cut(Part.makeCylinder(8, 10, V(38, 15, 0)))


def loose_faces():
    """The plate's faces, not joined."""
    return Part.Compound([face.copy() for face in plate().Faces])


def torn():
    """The plate's faces, each moved a little: a gap of a hundred-thousandth."""
    faces = []
    for i, face in enumerate(plate().Faces):
        copy = face.copy()
        copy.translate(V(1, 1, 1).multiply(2e-5 * (i % 3 - 1)))
        faces.append(copy)
    return Part.Compound(faces)


def corner_cone():
    """A quarter of a flat cone on the corner of a block: its rim is a sharp edge of 28 degrees inside the top, a quarter of a circle."""
    return Part.makeBox(20, 20, 6).fuse(Part.makeCone(12, 0, 6.38, V(0, 0, 6), V(0, 0, 1), 90)).removeSplitter()


def parted_drill(radius, height, degrees, tip):
    """What a drill takes out, as many programs write it: wall and tip in two halves, parted in the direction of that angle."""
    corners = [V(0, 0, -tip), V(radius, 0, 0), V(radius, 0, height), V(0, 0, height)]
    half = Part.Face(Part.makePolygon(corners + corners[:1])).revolve(V(0, 0, 0), V(0, 0, 1), 180)
    other = half.copy()
    other.rotate(V(0, 0, 0), V(0, 0, 1), 180)
    drill = half.fuse(other)
    drill.rotate(V(0, 0, 0), V(0, 0, 1), degrees)
    return drill


def parted_holes():
    """A block with two holes right through and three blind ones, the halves of most parted near the diagonals."""
    body = Part.makeBox(150, 30, 24)
    for x, radius, bottom, degrees, tip in ((15, 5.4, 0, 30, 0), (45, 4, 9, 30, 2.4), (75, 5.4, 9, 37, 3.2), (105, 2.4, 0, 0, 0),
                                            (135, 2.4, 9, 16, 1.4)):
        drill = parted_drill(radius, 24 - bottom, degrees, tip)
        drill.translate(V(x, 15, bottom))
        body = body.cut(drill)
    return body


def chamfered():
    """A block with narrow chamfers along all its edges: eight corner triangles, narrow strips between them."""
    block = Part.makeBox(80, 50, 20)
    return block.makeChamfer(2, block.Edges)


def hub():
    """A flange whose hub has a fillet that runs out between the bolt holes."""
    shape = Part.makeCylinder(40, 10).fuse(Part.makeCylinder(15, 35)).removeSplitter()
    foot = [e for e in shape.Edges if e.Curve.TypeId == "Part::GeomCircle" and abs(e.Curve.Radius - 15) < 1e-6
            and abs(e.CenterOfMass.z - 10) < 1e-6]
    shape = shape.makeFillet(4, foot).cut(Part.makeCylinder(8, 35))
    for k in range(4):
        turn = k * math.pi / 2 + 0.3
        shape = shape.cut(Part.makeCylinder(4, 10, V(28 * math.cos(turn), 28 * math.sin(turn), 0)))
    return shape


def thread():
    """A rod with a screw thread of five turns."""
    helix = Part.Wire(Part.makeHelix(3, 15, 5.8).Edges)
    profile = Part.makePolygon([V(5.5, 0, 0), V(7, 0, 0.9), V(7, 0, 1.1), V(5.5, 0, 2), V(5.5, 0, 0)])
    ridge = helix.makePipeShell([profile], True, True)
    ridge.translate(V(0, 0, 5))
    return Part.makeCylinder(6, 30).fuse(ridge).Solids[0]


def spring():
    """A round wire wound three times."""
    circle = Part.Wire([Part.Edge(Part.Circle(V(15, 0, 0), V(0, 1, 0.127), 3))])
    return Part.Wire(Part.makeHelix(12, 36, 15).Edges).makePipeShell([circle], True, True)


#: name -> (function, ending)
SHAPES = {
    "plate": (plate, "step"), "far": (far, "step"), "far_turned": (far_turned, "step"),
    "tiny": (lambda: scaled(2.5e-5), "step"),
    "huge": (lambda: scaled(2500), "step"),
    "hollow": (hollow, "step"), "stray": (stray, "step"), "inside_out": (inside_out, "brep"),
    "shell_inside_out": (shell_inside_out, "brep"),
    "one_face_turned": (one_face_turned, "brep"), "tiny_edge": (tiny_edge, "step"), "sliver": (sliver, "step"),
    "touching": (touching, "step"), "loose_faces": (loose_faces, "brep"), "torn": (torn, "brep"),
    "corner_cone": (corner_cone, "step"), "parted_holes": (parted_holes, "step"), "chamfered": (chamfered, "step"),
    "hub": (hub, "step"), "thread": (thread, "step"), "spring": (spring, "step"),
}


def named_solids(path):
    """Two parts of an assembly, with names, as FreeCAD's STEP export writes them."""
    import Import

    document = FreeCAD.newDocument("assembly")
    for name, at in (("left plate", 0), ("right block", 60)):
        item = document.addObject("Part::Feature", name.replace(" ", "_"))
        item.Label = name
        item.Shape = Part.makeBox(20, 20, 10, V(at, 0, 0))
    Import.export(document.Objects, path)


def in_unit(text, unit):
    """The same numbers, said to be in another unit."""
    assert MM in text, "the STEP writer has changed"
    if unit == "metre":
        return text.replace(MM, "( LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT($,.METRE.) )")
    last = max(int(number) for number in re.findall(r"^#(\d+)\s*=", text, re.MULTILINE))
    a, b, c = last + 1, last + 2, last + 3
    inch = (f"( CONVERSION_BASED_UNIT('INCH',#{a}) LENGTH_UNIT() NAMED_UNIT(#{c}) )")
    extra = (f"#{a} = LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),#{b});\n#{b} = {MM};\n"
             f"#{c} = DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.);\n")
    head, tail = text.replace(MM, inch).rsplit("ENDSEC;", 1)
    return head + extra + "ENDSEC;" + tail


def make(folder, names=()):
    os.makedirs(folder, exist_ok=True)
    for name, (draw, ending) in SHAPES.items():
        if names and name not in names:
            continue
        path = os.path.join(folder, f"{name}.{ending}")
        shape = draw()
        if ending == "step":
            shape.exportStep(path)
        else:
            shape.exportBrep(path)
    if not names:
        with open(os.path.join(folder, "plate.step"), encoding="utf-8") as file:
            text = file.read()
        for unit in ("metre", "inch"):
            with open(os.path.join(folder, unit + ".step"), "w", encoding="utf-8") as out:
                out.write(in_unit(text, unit))
        named_solids(os.path.join(folder, "named_solids.step"))


if __name__ == "__main__":
    make(sys.argv[1], sys.argv[2:])
