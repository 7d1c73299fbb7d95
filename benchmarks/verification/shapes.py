# HexFeatureWB - LGPL-2.1-or-later
"""The problems' parts, drawn with FreeCAD; mm."""
import math
import sys

sys.path += ["/usr/lib/freecad-python3/lib", "/usr/lib/freecad/lib"]
import FreeCAD  # noqa: E402  before Part, or Part crashes outside FreeCAD
import Part  # noqa: E402

V = FreeCAD.Vector


def solid(shape):
    """The one solid of a boolean's result."""
    return shape.Solids[0]


def face_at(shape, point):
    """Number of the face that a point lies on."""
    return _at(shape.Faces, point)


def edge_at(shape, point):
    """Number of the edge that a point lies on."""
    return _at(shape.Edges, point)


def _at(entities, point):
    vertex = Part.Vertex(V(*point))
    distances = [entity.distToShape(vertex)[0] for entity in entities]
    if min(distances) > 1e-4:
        raise ValueError("no face or edge at %r" % (point,))
    return 1 + distances.index(min(distances))


def beam(length, width, height):
    return Part.makeBox(length, width, height)


def quarter_ring(inner, outer, height):
    body = Part.makeCylinder(outer, height, V(), V(0, 0, 1), 90)
    return solid(body.cut(Part.makeCylinder(inner, height)))


def quarter_plate(side, hole, thickness):
    return solid(Part.makeBox(side, side, thickness).cut(Part.makeCylinder(hole, thickness)))


def octant_shell(inner, outer):
    return solid(Part.makeSphere(outer, V(), V(0, 0, 1), 0, 90, 90).cut(Part.makeSphere(inner)))


def quarter_elliptic_plate(inner, outer, thickness):
    """Between two ellipses of half-axes (x, y); a CAD edge runs round at half the thickness."""

    def half(z):
        arcs = [Part.ArcOfEllipse(Part.Ellipse(V(0, 0, z), *axes), 0, math.pi / 2).toShape() for axes in (inner, outer)]
        lines = [Part.makeLine(V(inner[0], 0, z), V(outer[0], 0, z)), Part.makeLine(V(0, inner[1], z), V(0, outer[1], z))]
        wire = Part.Wire(Part.__sortEdges__([arcs[0], lines[1], arcs[1], lines[0]]))
        return Part.Face(wire).extrude(V(0, 0, thickness / 2))

    return solid(half(0).fuse(half(thickness / 2)))
