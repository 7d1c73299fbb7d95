# HexFeatureWB - LGPL-2.1-or-later
"""Mesh a document object's solids and put the mesh, with its groups, into the document."""
import json

import FreeCAD

from . import core, fem_mesh, mesh_object

MeshingError = core.load().MeshingError


def mesh(obj, size=None, analysis=None, name=None, progress=None, cancelled=None, **options):
    """Make a hexahedral FEM mesh object of a solid.

    obj: a document object with a Shape (Part feature, PartDesign body, ...).
    size: element size in mm; None lets the core choose one.
    analysis: a FEM analysis that takes the mesh (it replaces the analysis' old one).
    name: name of the new object; default HexMesh.
    progress(step, fraction), cancelled() -> bool: called while meshing.
    options: as on the command line (order=2 by default, labels, capture, ...).
    Returns the mesh object; its groups are named after FreeCAD's FaceN, EdgeN, VertexN, SolidN.
    Raises MeshingError (kind, step, reason, hint, cad_faces); the document is then as it was.
    """
    _solids_of(obj)
    if size is not None:
        if isinstance(size, bool) or not isinstance(size, (int, float, FreeCAD.Units.Quantity)):
            raise _usage("size is %r but must be a length in mm" % (size,))
        size = float(getattr(size, "Value", size))
        if not 0 < size < float("inf"):
            raise _usage("size is %g but must be a length greater than 0" % size)
    document = obj.Document
    document.openTransaction("Hex mesh")
    try:
        result_object = mesh_object.create(document, obj, name or "HexMesh")
        if size is not None:
            options["size"] = size
        known = {spec["name"] for spec in mesh_object.options_shown()}
        for option, value in options.items():
            if option not in known:
                raise _usage("there is no option '%s'" % option)
            try:
                setattr(result_object, mesh_object.property_name(option), value)
            except (TypeError, ValueError):  # of FreeCAD's property
                raise _usage("%s cannot be %r" % (option, value)) from None
        refresh(result_object, progress, cancelled)
        if analysis is not None:
            for old in [m for m in analysis.Group if m.isDerivedFrom("Fem::FemMeshObject")]:
                analysis.removeObject(old)
            analysis.addObject(result_object)
    except BaseException:
        document.abortTransaction()
        if not document.UndoMode and "result_object" in locals():
            document.removeObject(result_object.Name)
        raise
    document.commitTransaction()
    return result_object


def refresh(mesh_obj, progress=None, cancelled=None):
    """Mesh again with the object's present options; the old mesh stays when this fails. Returns the core's result."""
    source = mesh_object.source_of(mesh_obj)
    shape, names = _solids_of(source)
    # The options are checked by the core; a text is the way that is free of FreeCAD's OpenCASCADE version.
    result = core.load().mesh_brep(shape.exportBrepToString(), mesh_object.options_of(mesh_obj), progress, None, cancelled)
    fem, ids = fem_mesh.to_fem_mesh(result)
    fem_mesh.add_groups(fem, ids, names)
    mesh_obj.FemMesh = fem
    report = result.report()
    report["groups_not_found_by_geometry"] = check_groups(fem, shape, ids)
    mesh_obj.MethodUsed = report["method"]
    mesh_obj.HexCount = report["quality"]["hexes"]
    mesh_obj.MinScaledJacobian = report["quality"]["min_scaled_jacobian"]
    mesh_obj.MeanScaledJacobian = report["quality"]["mean_scaled_jacobian"]
    mesh_obj.Seconds = report["seconds"]
    mesh_obj.Report = json.dumps(report, indent=1)
    for face, (found, ours) in report["groups_not_found_by_geometry"].items():
        FreeCAD.Console.PrintWarning(
            "HexFeatureWB: FreeCAD finds %d of the %d elements on %s by geometry; a load put there may miss some.\n"
            % (found, ours, names["faces"](face))
        )
    return result


def check_groups(fem, shape, ids):
    """Compare every face's group with what FreeCAD's constraints will find by geometry (getFacesByFace).

    Returns {face number: (found, ours)} for the faces that differ; empty when all is well.
    """
    different = {}
    for number, face in enumerate(shape.Faces, 1):
        ours = ids["faces"].get(number, [])
        found = fem.getFacesByFace(face)
        if sorted(found) != ours:
            different[number] = (len(set(found) & set(ours)), len(ours))
    return different


def _usage(reason):
    error = MeshingError("options: " + reason)
    error.kind, error.step, error.reason, error.cad_faces = "usage", "options", reason, []
    error.hint = "hexfeature mesh --help lists the options"
    return error


def _solids_of(obj):
    """(shape to mesh, names): the one solid of an object's shape, or the whole shape when it has several.

    names maps the core's numbers to those of the object's own shape, which differ when it has faces beside its solid.
    """
    shape = getattr(obj, "Shape", None)
    if shape is None or not hasattr(shape, "Solids") or not shape.Solids:
        error = _usage("the object has no solid")
        error.kind, error.step = "bad_input", "read"
        error.hint = "choose an object with a solid; make one of a shell with Part > Convert to solid"
        raise error
    part = shape.Solids[0] if len(shape.Solids) == 1 else shape
    names = {}
    for kind, prefix, own, whole in (
        ("faces", "Face", part.Faces, shape.Faces),
        ("edges", "Edge", part.Edges, shape.Edges),
        ("vertices", "Vertex", part.Vertexes, shape.Vertexes),
        ("solids", "Solid", part.Solids, shape.Solids),
    ):
        names[kind] = _namer(prefix, own, whole)
    return part, names


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
