# HexFeatureWB - LGPL-2.1-or-later
"""The FEM mesh object in the document: its properties come from the core's one list of options.

Module, class and property names are file format: a saved document finds them again by name.
"""
import FreeCAD

from . import core

GROUP = "Hex mesh"
RESULTS = "Hex mesh result"


def property_name(option):
    """FreeCAD property of an option: element size is ElementSize, the others in camel case."""
    if option == "size":
        return "ElementSize"
    return "".join(part.capitalize() for part in option.split("_"))


def _property_type(spec):
    if spec["name"] == "size":
        return "App::PropertyLength"
    if spec["type"] == "str":
        return "App::PropertyEnumeration" if spec["choices"] else "App::PropertyString"
    return {"float": "App::PropertyFloat", "int": "App::PropertyInteger", "bool": "App::PropertyBool"}[spec["type"]]


def options_shown():
    """The options that are properties: all but the one for looking at intermediate results."""
    return [spec for spec in core.load().option_list() if spec["name"] != "stop_after"]


class HexMesh:
    """Proxy of the mesh object. Meshing is not done in execute(): recomputing a document stays cheap."""

    Type = "Fem::FemMeshHexFeature"

    def __init__(self, obj):
        obj.Proxy = self
        self.add_properties(obj)

    def add_properties(self, obj):
        """Add the properties that are missing (a new object, or a document of an older version)."""
        if not hasattr(obj, "Shape") and not hasattr(obj, "Part"):
            obj.addProperty("App::PropertyLink", "Part", GROUP, "the part that is meshed")
        for spec in options_shown():
            name = property_name(spec["name"])
            if hasattr(obj, name):
                continue
            obj.addProperty(_property_type(spec), name, GROUP, spec["help"])
            if spec["choices"]:
                setattr(obj, name, spec["choices"])
            # Stresses want second order: 8-node bricks lock in bending.
            setattr(obj, name, 2 if spec["name"] == "order" else spec["default"])
        for kind, name, text in (
            ("App::PropertyString", "MethodUsed", "method that made the mesh"),
            ("App::PropertyInteger", "HexCount", "number of hexahedra"),
            ("App::PropertyFloat", "MinScaledJacobian", "scaled Jacobian of the worst element, 1 is best"),
            ("App::PropertyFloat", "MeanScaledJacobian", "mean scaled Jacobian"),
            ("App::PropertyFloat", "Seconds", "time that meshing took"),
            ("App::PropertyString", "Report", "the whole report as JSON"),
        ):
            if not hasattr(obj, name):
                obj.addProperty(kind, name, RESULTS, text)
                obj.setEditorMode(name, 1)

    def execute(self, obj):
        return False

    def onDocumentRestored(self, obj):
        self.add_properties(obj)

    def dumps(self):
        return None

    def loads(self, state):
        return None

    __getstate__ = dumps
    __setstate__ = loads


def source_of(obj):
    """The part that a mesh object is linked to."""
    source = getattr(obj, "Shape", None)
    if source is None or not hasattr(source, "Name"):
        source = getattr(obj, "Part", None)
    return source


def options_of(obj):
    """The options as the core takes them, from the object's properties."""
    values = {}
    for spec in options_shown():
        value = getattr(obj, property_name(spec["name"]))
        if spec["name"] == "size":
            value = float(getattr(value, "Value", value))
        values[spec["name"]] = value
    return values


def create(document, source, name):
    """Add an empty mesh object linked to `source` (FreeCAD 0.20 and 1.x types)."""
    kinds = document.supportedTypes()
    kind = "Fem::FemMeshShapeBaseObjectPython"
    if kind not in kinds:
        kind = "Fem::FemMeshObjectPython"
    obj = document.addObject(kind, name)
    HexMesh(obj)
    if hasattr(obj, "Shape"):
        obj.Shape = source
    else:
        obj.Part = source
    if FreeCAD.GuiUp:
        from .view_provider import HexMeshView

        HexMeshView(obj.ViewObject)
    return obj
