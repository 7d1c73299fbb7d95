# HexFeatureWB - LGPL-2.1-or-later
"""The method's intermediate models as document objects: feature lines on the part, and the recognition model (the polycube)."""
import FreeCAD
import numpy as np
import Part

from . import core
from .source import brep_of, shape_to_mesh
from .translate import tr

#: red, green, blue of the axes X, Y, Z of the working frame; of labels +X -X +Y -Y +Z -Z
AXIS_COLOURS = ((0.85, 0.20, 0.15), (0.15, 0.62, 0.25), (0.16, 0.38, 0.85))
LABEL_COLOURS = ((0.91, 0.35, 0.30), (0.97, 0.68, 0.62), (0.30, 0.72, 0.40), (0.66, 0.88, 0.68), (0.30, 0.52, 0.93), (0.66, 0.79, 0.98))


def feature_lines(obj, size=None, name=None, solid=0, **options):
    """Add an object of the feature lines (block borders) that meshing `obj` with these options starts from.

    One edge a line, a polygon on the part's surface; coloured by the line's axis. Arguments as of `HexFeatureWB.mesh`.
    Returns the object. Raises MeshingError.
    """
    stage, _ = _stage("shape", obj, size, solid, options)
    points = np.asarray(stage["points"])
    lines, axes = [], []
    for arc, axis in zip(stage["arcs"], stage["arc_axis"]):
        line = _polygon(points[arc])
        if line is not None:
            lines.append(line)
            axes += [axis] * len(line.Edges)
    return _add(obj, name or "FeatureLines", tr("Feature lines"), Part.makeCompound(lines),
                {"LineColorArray": [AXIS_COLOURS[a] if 0 <= a < 3 else (0.1, 0.1, 0.1) for a in axes], "LineWidth": 6.0})


def recognition_model(obj, size=None, name=None, solid=0, beside=True, **options):
    """Add an object of the recognition model, the polycube with integer edges that the part is straightened into.

    One face a chart, coloured by its label; a unit is one element size. It stands beside the part, or with beside=False in its
    place. Arguments as of `HexFeatureWB.mesh`. Returns the object. Raises MeshingError.
    """
    stage, size = _stage("polycube", obj, size, solid, options)
    corners = np.asarray(stage["corner_coordinates"], dtype=float).reshape(-1, 3) * size
    corners -= (corners.min(axis=0) + corners.max(axis=0)) / 2
    corners = corners @ np.array(stage["rotation"]).reshape(3, 3).T + np.array(stage["centre"])
    start, end = stage["arc_start"], stage["arc_end"]
    faces, colours = [], []
    for loops, label in zip(stage["chart_loops"], stage["chart_label"]):
        wires = [_polygon(corners[[(start if dart % 2 == 0 else end)[dart // 2] for dart in loop]], closed=True) for loop in loops]
        made = _faces([w for w in wires if w is not None])
        faces += made
        colours += [LABEL_COLOURS[label]] * len(made)
    model = _add(obj, name or "RecognitionModel", tr("Recognition model"), Part.makeCompound(faces),
                 {"DiffuseColor": colours, "LineWidth": 2.0})
    if beside:
        part, box = obj.Shape.BoundBox, model.Shape.BoundBox
        model.Placement.Base = FreeCAD.Vector(part.XMax - box.XMin + 0.15 * part.DiagonalLength, 0, 0)
    return model


def _stage(name, obj, size, solid, options):
    """(the stage's arrays, element size as used)."""
    shape = shape_to_mesh(obj, solid)
    if size is not None:
        options["size"] = float(getattr(size, "Value", size))
    options["stop_after"] = name
    result = core.load().mesh_brep(brep_of(shape), options)
    return result.stage(name), result.report()["options"]["size"]


def _polygon(points, closed=False):
    """A wire through points (n, 3), a straight piece as one edge; None where it would have no length."""
    kept = [FreeCAD.Vector(*points[0])] if len(points) else []
    for p in points[1:]:
        v = FreeCAD.Vector(*p)
        if v.distanceToPoint(kept[-1]) <= 1e-9:
            continue
        if len(kept) > 1:
            before, after = kept[-1] - kept[-2], v - kept[-1]
            if before.dot(after) > 0 and before.cross(after).Length < 1e-9 * (before.Length + after.Length):
                kept.pop()
        kept.append(v)
    if closed and len(kept) > 2:
        if kept[0].distanceToPoint(kept[-1]) > 1e-9:
            kept.append(kept[0])
    return Part.makePolygon(kept) if len(kept) > 1 else None


def _faces(wires):
    """The plane faces that outline and holes bound."""
    if not wires:
        return []
    try:
        return Part.Face(wires).Faces if len(wires) == 1 else Part.makeFace(wires, "Part::FaceMakerBullseye").Faces
    except Part.OCCError:  # an outline that touches itself has no plane face: its lines are shown
        return []


def _add(obj, name, label, shape, looks):
    document = obj.Document
    document.openTransaction(label)
    added = document.addObject("Part::Feature", name)
    added.Shape = shape
    added.Label = "%s: %s" % (label, obj.Label)
    if FreeCAD.GuiUp:
        view = added.ViewObject
        for key, value in looks.items():
            setattr(view, key, value)
    document.commitTransaction()
    return added
