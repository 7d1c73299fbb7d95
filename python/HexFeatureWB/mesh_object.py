# HexFeatureWB - LGPL-2.1-or-later
"""The FEM mesh object in the document: its properties come from the core's one list of options.

Module, class and property names are file format: a saved document finds them again by name.
"""
import json

import FreeCAD

from . import core, writer_mends

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
        writer_mends.mend(is_hex_mesh)
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
        if not hasattr(obj, "Solid"):
            obj.addProperty("App::PropertyInteger", "Solid", GROUP, "of a part with several solids, the one to mesh; 0: all of them")
        for kind, name, text in (
            ("App::PropertyBool", "NeedsRefresh", "the part or an option has changed since the mesh was made"),
            ("App::PropertyString", "MethodUsed", "method that made the mesh"),
            ("App::PropertyInteger", "HexCount", "number of hexahedra"),
            ("App::PropertyFloat", "MinScaledJacobian", "scaled Jacobian of the worst element, 1 is best"),
            ("App::PropertyFloat", "MeanScaledJacobian", "mean scaled Jacobian"),
            ("App::PropertyLength", "LargestDeviation", "largest distance of a boundary node from its CAD face, edge or vertex"),
            ("App::PropertyFloat", "Seconds", "time that meshing took"),
            ("App::PropertyString", "Report", "the whole report as JSON"),
            ("App::PropertyIntegerList", "FeatureLineNodes", "nodes of the mesh edges on feature lines, two an edge"),
            ("App::PropertyString", "MadeOf", "part and options that the mesh was made of"),
        ):
            if not hasattr(obj, name):
                obj.addProperty(kind, name, RESULTS, text)
                obj.setEditorMode(name, 2 if name in ("FeatureLineNodes", "MadeOf", "Report") else 1)

    def execute(self, obj):
        update_needs_refresh(obj)
        return False

    def onChanged(self, obj, name):
        # While a document is read, properties come one by one: then onDocumentRestored looks at all of them.
        if name in _option_names() and "Restore" not in obj.State and hasattr(obj, "MadeOf"):
            update_needs_refresh(obj)

    def onDocumentRestored(self, obj):
        self.add_properties(obj)
        if FreeCAD.GuiUp:
            from .view_provider import revive

            revive(obj)

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


def _option_names():
    return {property_name(spec["name"]) for spec in options_shown()} | {"Solid", "Shape", "Part"}


def made_of(obj):
    """The part and the options as they are now, as one text: what is compared with MadeOf. Empty without a part."""
    source = source_of(obj)
    shape = getattr(source, "Shape", None)
    if shape is None or shape.isNull():
        return ""
    part = _measured(shape)
    chosen = {name: value for name, value in options_of(obj).items() if name not in ("threads", "time_limit")}
    return json.dumps([source.Name, obj.Solid, part, chosen])


#: (shape, its numbers): the last that was measured
_last_measured = None, None


def _measured(shape):
    """Numbers of the geometry: the same after saving and reading, unlike the B-rep's text. Integrals over a part of a hundred faces take a
    tenth of a second, so they are kept until another part is asked for."""
    global _last_measured
    last, part = _last_measured
    if last is None or not last.isSame(shape):
        centre = shape.CenterOfGravity if hasattr(shape, "CenterOfGravity") else shape.BoundBox.Center
        part = [len(shape.Solids), len(shape.Faces), len(shape.Edges)] + [
            "%.7g" % value for value in (shape.Volume, shape.Area, *(round(c, 6) + 0.0 for c in centre))
        ]
        _last_measured = shape, part
    return part


class _Forget:
    """FreeCAD calls it: the last shape may be large, and would outlive its document."""

    def slotDeletedDocument(self, document):
        global _last_measured
        _last_measured = None, None


_forget = _Forget()
FreeCAD.addDocumentObserver(_forget)


def update_needs_refresh(obj):
    """Set NeedsRefresh by what the mesh was made of."""
    if not hasattr(obj, "MadeOf") or not obj.MadeOf:
        return
    needed = made_of(obj) != obj.MadeOf
    if obj.NeedsRefresh != needed:
        obj.NeedsRefresh = needed


def is_hex_mesh(obj):
    """Whether a document object is one of ours."""
    return obj is not None and obj.isDerivedFrom("Fem::FemMeshObject") and hasattr(obj, "MadeOf") and hasattr(obj, "ElementSize")


def create(document, source, name):
    """Add an empty mesh object linked to `source` (FreeCAD 0.20 and 1.x types)."""
    import Fem  # noqa: F401  makes the types known

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
