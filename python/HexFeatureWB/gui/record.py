# HexFeatureWB - LGPL-2.1-or-later
"""What changes the document is done by lines of Python given to FreeCAD: the macro recorder sees the very lines that ran."""
import FreeCAD
import FreeCADGui

from .. import core, mesh_object


def do(line):
    """Run a line, recorded."""
    FreeCADGui.doCommand(line)


def reference(obj):
    """The object as Python source."""
    return "App.getDocument(%r).getObject(%r)" % (obj.Document.Name, obj.Name)


def active_analysis(document):
    """The active FEM analysis of this document, or None."""
    try:
        import FemGui
    except ImportError:
        return None
    analysis = FemGui.getActiveAnalysis()
    return analysis if analysis is not None and analysis.Document.Name == document.Name else None


def _keywords(options):
    """The options that are not a new mesh's own, as keyword arguments."""
    own = {spec["name"]: 2 if spec["name"] == "order" else spec["default"] for spec in core.load().option_list()}
    return ["%s=%r" % (name, value) for name, value in options.items() if value != own[name]]


def mesh(source, options, solid=0):
    """HexFeatureWB.mesh(...), into the active analysis when there is one. Returns the mesh object. Raises MeshingError."""
    arguments = [reference(source), *_keywords(options)]
    if solid:
        arguments.append("solid=%d" % solid)
    analysis = active_analysis(source.Document)
    if analysis is not None:
        arguments.append("analysis=" + reference(analysis))
    before = set(o.Name for o in source.Document.Objects)
    do("import HexFeatureWB")
    do("HexFeatureWB.mesh(%s)" % ", ".join(arguments))
    return next(o for o in source.Document.Objects if o.Name not in before and mesh_object.is_hex_mesh(o))


def refresh(mesh, options=None, solid=None):
    """HexFeatureWB.refresh(...) with the options that differ from the object's. Raises MeshingError."""
    now = mesh_object.options_of(mesh)
    changed = ["%s=%r" % (name, value) for name, value in (options or {}).items() if value != now[name]]
    if solid is not None and solid != mesh.Solid:
        do("%s.Solid = %d" % (reference(mesh), solid))
    do("import HexFeatureWB")
    do("HexFeatureWB.refresh(%s)" % ", ".join([reference(mesh), *changed]))


def set_view(obj, name, value):
    """A property of how an object is shown."""
    do("Gui.getDocument(%r).getObject(%r).%s = %r" % (obj.Document.Name, obj.Name, name, value))


def show(obj, visible):
    """Show or hide an object, unless it is so."""
    if obj.ViewObject.Visibility != visible:
        set_view(obj, "Visibility", visible)


def make_model(kind, source, options, solid=0):
    """HexFeatureWB.feature_lines(...) or .recognition_model(...). Raises MeshingError."""
    arguments = [reference(source), *_keywords(options)] + (["solid=%d" % solid] if solid else [])
    do("import HexFeatureWB")
    do("HexFeatureWB.%s(%s)" % (kind, ", ".join(arguments)))


def export(mesh, path, element_type=""):
    """HexFeatureWB.export(...). Raises MeshingError."""
    do("import HexFeatureWB")
    do("HexFeatureWB.export(%s, %r%s)" % (reference(mesh), path, ", element_type=%r" % element_type if element_type else ""))


def console(text):
    FreeCAD.Console.PrintMessage("HexFeatureWB: " + text + "\n")
