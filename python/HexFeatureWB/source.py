# HexFeatureWB - LGPL-2.1-or-later
"""From a document object to the shape that is meshed, and back from the core's numbers to FreeCAD's names."""
import re

from . import core


def solids_of(obj):
    """The solids of a document object; empty when it has none (or is None)."""
    shape = getattr(obj, "Shape", None)
    if shape is None or not hasattr(shape, "Solids"):
        return []
    return shape.Solids


def shape_to_mesh(obj, solid=0):
    """The shape that is meshed: solid number `solid` (from 1), or with 0 the only solid, or the whole shape of several.

    Raises MeshingError ("bad_input").
    """
    solids = solids_of(obj)
    if not solids:
        raise _bad_input("the object has no solid", "choose an object with a solid; make one of a shell with Part > Convert to solid")
    if not 0 <= solid <= len(solids):
        raise _bad_input("the object has no Solid%d" % solid, "it has %d; 0 meshes all of them" % len(solids))
    if solid:
        return solids[solid - 1]
    return solids[0] if len(solids) == 1 else obj.Shape


def brep_of(shape):
    """The shape as a text for the core, the same one as long as the shape is the same: OpenCASCADE notes on each sub-shape whether it was
    checked, and forgets it when FreeCAD draws the part. That note is left out, or a finished mesh would be taken for another part's."""
    return re.sub(r"(?m)^([01]{2})1([01]{4})$", r"\g<1>0\g<2>", shape.exportBrepToString())


def names_of(obj, part):
    """kind ("faces", "edges", "vertices", "solids") -> function from the core's number to FreeCAD's name in obj.Shape ("Face7"),
    or None. They differ where the object has more than the part that is meshed."""
    whole = obj.Shape
    return {
        "faces": _namer("Face", part.Faces, whole.Faces),
        "edges": _namer("Edge", part.Edges, whole.Edges),
        "vertices": _namer("Vertex", part.Vertexes, whole.Vertexes),
        "solids": _namer("Solid", part.Solids, whole.Solids),
    }


def _namer(prefix, own, whole):
    if len(own) == len(whole):
        return lambda number: "%s%d" % (prefix, number)
    by_hash = {}
    for number, item in enumerate(whole, 1):
        by_hash.setdefault(item.hashCode(), []).append((number, item))
    table = {}
    for number, item in enumerate(own, 1):
        for other, candidate in by_hash.get(item.hashCode(), []):
            if candidate.isSame(item):
                table[number] = other
    return lambda number: "%s%d" % (prefix, table[number]) if number in table else None


def _bad_input(reason, hint):
    error = core.load().MeshingError("read: " + reason)
    error.kind, error.step, error.reason, error.hint, error.cad_faces = "bad_input", "read", reason, hint, []
    return error
