# HexFeatureWB - LGPL-2.1-or-later
"""Mesh a document object's solids and put the mesh, with its groups, into the document."""
import json

import FreeCAD

from . import core, fem_mesh, mesh_object
from .group_check import GroupCheck
from .source import brep_of, names_of, shape_to_mesh
from .translate import tr

MeshingError = core.load().MeshingError

#: (B-rep text, options, result, FemMeshBuilder, GroupCheck): what a panel has just made, for the next call that asks for the same.
_ready = None


def mesh(obj, size=None, analysis=None, name=None, progress=None, cancelled=None, solid=0, **options):
    """Make a hexahedral FEM mesh object of a solid.

    obj: a document object with a Shape (Part feature, PartDesign body, link, ...).
    size: element size in mm; None lets the core choose one.
    analysis: a FEM analysis that takes the mesh (it replaces the analysis' old one).
    name: name of the new object; default that of the part with _Mesh, and so its label: FreeCAD shows the part and hides the mesh
        when a constraint is made, if the mesh has this name.
    progress(step, fraction), cancelled() -> bool: called while meshing.
    solid: of a part with several solids the number of one, from 1; 0 meshes all of them.
    options: as on the command line (order=2 by default, labels, capture, ...).
    Returns the mesh object; its groups are named after FreeCAD's FaceN, EdgeN, VertexN, SolidN.
    Raises MeshingError (kind, step, reason, hint, cad_faces); the document is then as it was.
    """
    shape_to_mesh(obj, solid)
    if size is not None:
        if isinstance(size, bool) or not isinstance(size, (int, float, FreeCAD.Units.Quantity)):
            raise usage("size is %r but must be a length in mm" % (size,))
        size = float(getattr(size, "Value", size))
        if not 0 < size < float("inf"):
            raise usage("size is %g but must be a length greater than 0" % size)
    document = obj.Document
    document.openTransaction(tr("Hex mesh"))
    try:
        result_object = mesh_object.create(document, obj, name or obj.Name + "_Mesh")
        if name is None and obj.Label != obj.Name:
            result_object.Label = obj.Label + "_Mesh"
        result_object.Solid = solid
        if size is not None:
            options["size"] = size
        set_options(result_object, options)
        _fill(result_object, progress, cancelled)
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


def refresh(mesh_obj, progress=None, cancelled=None, **options):
    """Mesh again with the object's present options, changed by the ones given; the old mesh stays when this fails.

    Returns the core's result. Raises MeshingError.
    """
    document = mesh_obj.Document
    document.openTransaction(tr("Refresh mesh"))
    try:
        set_options(mesh_obj, options)
        result = _fill(mesh_obj, progress, cancelled)
    except BaseException:
        document.abortTransaction()
        raise
    document.commitTransaction()
    return result


def set_options(mesh_obj, options):
    """Set options by their name on the command line. Raises MeshingError ("usage")."""
    known = {spec["name"] for spec in mesh_object.options_shown()}
    for option, value in options.items():
        if option not in known:
            raise usage("there is no option '%s'" % option)
        try:
            setattr(mesh_obj, mesh_object.property_name(option), value)
        except (TypeError, ValueError):  # of FreeCAD's property
            raise usage("option '%s' cannot be %r" % (option, value)) from None


def offer(brep, options, result, builder=None, check=None):
    """Lend a finished result, and its Fem.FemMesh and check of groups when they are done, to the next mesh() or refresh() of the same part
    and options: the line that the macro recorder sees is then the very line that put the mesh into the document, though a worker made
    it."""
    global _ready
    _ready = (brep, dict(options), result, builder, check)


def _compute(shape, names, options, progress, cancelled):
    """(result, FemMeshBuilder, GroupCheck), both done"""
    global _ready
    ready, _ready = _ready, None
    brep = brep_of(shape)
    if ready and ready[:2] == (brep, options):
        result, builder, check = ready[2:]
    else:
        # The options are checked by the core; a text is the way that is free of FreeCAD's OpenCASCADE version.
        result, builder, check = core.load().mesh_brep(brep, options, progress, None, cancelled), None, None
    builder, check = builder or fem_mesh.FemMeshBuilder(result, names), check or GroupCheck(result, shape)
    for each in builder, check:
        while not each.work(3600):
            pass
    return result, builder, check


def _fill(mesh_obj, progress, cancelled):
    """Mesh, and set the object's mesh and figures."""
    source = mesh_object.source_of(mesh_obj)
    shape = shape_to_mesh(source, mesh_obj.Solid)
    names = names_of(source, shape)
    result, builder, check = _compute(shape, names, mesh_object.options_of(mesh_obj), progress, cancelled)
    fem, ids = builder.mesh, builder.ids
    report = result.report()
    report["groups_not_found_by_geometry"] = check.different
    # Seams and the vertices where closed curves begin have no nodes of their own: a constraint put there finds nothing.
    report["entities_without_nodes"] = [
        name for kind, items in (("edges", shape.Edges), ("vertices", shape.Vertexes))
        for name in (names[kind](number) for number in range(1, len(items) + 1) if number not in ids[kind]) if name
    ]
    mesh_obj.FeatureLineNodes = fem_mesh.feature_line_nodes(result)
    if FreeCAD.GuiUp and mesh_obj.ViewObject is not None and mesh_obj.ViewObject.Proxy:
        mesh_obj.ViewObject.Proxy.expect(result)
    mesh_obj.FemMesh = fem
    mesh_obj.MethodUsed = report["method"]
    mesh_obj.HexCount = report["quality"]["hexes"]
    mesh_obj.MinScaledJacobian = report["quality"]["min_scaled_jacobian"]
    mesh_obj.MeanScaledJacobian = report["quality"]["mean_scaled_jacobian"]
    mesh_obj.LargestDeviation = report["faithfulness"]["largest_node_deviation"]
    mesh_obj.Seconds = report["seconds"]
    mesh_obj.Report = json.dumps(report, indent=1)
    mesh_obj.MadeOf = mesh_object.made_of(mesh_obj)
    mesh_obj.NeedsRefresh = False
    mesh_obj.purgeTouched()
    for face, (found, ours) in report["groups_not_found_by_geometry"].items():
        FreeCAD.Console.PrintWarning("HexFeatureWB: " + tr(
            "FreeCAD finds %(found)d of the %(all)d elements on %(face)s by geometry; a load put there may miss some."
        ) % {"found": found, "all": ours, "face": names["faces"](face)} + "\n")
    return result


def cancelled_error(step):
    """The MeshingError of a run that was given up outside the core."""
    return _failure("cancelled", step, "cancelled", "")


def building_error(step, caught):
    """The MeshingError of a mesh that the core has made and FreeCAD could not take; `caught`: what was raised."""
    return _failure("no_mesh", step, "FreeCAD's mesh cannot be built: %s" % (str(caught) or type(caught).__name__),
                    "close what needs memory, or take a larger element size" if isinstance(caught, MemoryError) else "")


def usage(reason):
    """A MeshingError about an option."""
    return _failure("usage", "options", reason, "hexfeature mesh --help lists the options")


def _failure(kind, step, reason, hint):
    error = MeshingError("%s: %s" % (step, reason))
    error.kind, error.step, error.reason, error.hint, error.cad_faces = kind, step, reason, hint, []
    return error
