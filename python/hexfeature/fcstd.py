# HexFeatureWB - LGPL-2.1-or-later
"""Read a shape out of a FreeCAD document without FreeCAD: the file is a zip with Document.xml and one .brp a shape."""
import lzma
import zipfile
import zlib
from typing import NamedTuple
from xml.etree import ElementTree

from hexfeature.errors import MeshingError, make_error, system_error


class ShapeObject(NamedTuple):
    """An object of the document that has a shape."""

    name: str
    label: str
    type: str
    member: str  #: of the zip, the B-rep
    links: frozenset  #: names of the objects that it depends on


def read_brep(path, object_name=None):
    """The B-rep text of the object with that name or label; without one, of the document's only solid.

    A solid that another solid is made from (a pad inside a body, the operands of a cut) does not count.
    Raises MeshingError: "bad_input" when the file is not a document with solids, "usage" when the object must be named.
    """
    try:
        with zipfile.ZipFile(path) as archive:
            return _read(archive, path, object_name)
    except MeshingError:
        raise
    except (zipfile.BadZipFile, zlib.error, lzma.LZMAError, ElementTree.ParseError, LookupError, ValueError, EOFError, NotImplementedError,
            RuntimeError, AttributeError) as error:  # RuntimeError: encrypted; the others: damaged in one way or another
        raise make_error("bad_input", "read", f"'{path}' is not a readable FreeCAD document ({error})",
                         "open it in FreeCAD and save it again") from None
    except OSError as error:
        raise system_error("bad_input", "read", f"cannot read '{path}'", error, "check the file name") from None


def _read(archive, path, object_name):
    shapes = _shape_objects(ElementTree.fromstring(archive.read("Document.xml")))
    if object_name:
        found = [s for s in shapes if object_name == s.name] or [s for s in shapes if object_name == s.label]
        if len(found) == 1:
            return _brep(archive, found[0])
        names = _listing(shapes) or "none"
        problem = "more than one object is labelled" if found else "there is no object with a shape called"
        raise make_error("usage", "read", f"{problem} '{object_name}' in '{path}'", f"objects: {names}")

    breps = {s.name: _brep(archive, s) for s in shapes}
    solids = [s for s in shapes if _has_solid(breps[s.name])]
    # The features of a PartDesign body link back to it: the body stands for them.
    features = set().union(*(s.links for s in solids if s.type == "PartDesign::Body"))
    whole = [s for s in solids if s.name not in features] or solids
    used = set().union(*(s.links for s in whole))
    final = [s for s in whole if s.name not in used] or whole
    if not final:
        raise make_error("bad_input", "read", f"there is no solid in '{path}'", "recompute and save the document in FreeCAD")
    if len(final) > 1:
        raise make_error("usage", "read", f"there are {len(final)} solids in '{path}'", f"name one of them: {_listing(final)}")
    return breps[final[0].name]


def _shape_objects(document):
    types = {o.get("name"): o.get("type", "") for o in document.iterfind("./Objects/Object")}
    links = {d.get("Name"): frozenset(e.get("Name") for e in d.iterfind("Dep")) for d in document.iterfind("./Objects/ObjectDeps")}
    shapes = []
    for item in document.iterfind("./ObjectData/Object"):
        properties = {p.get("name"): p for p in item.iterfind("./Properties/Property")}
        part = properties["Shape"].find("Part") if "Shape" in properties else None
        if part is None or not part.get("file"):
            continue
        label = properties["Label"].find("String") if "Label" in properties else None
        name = item.get("name")
        shapes.append(ShapeObject(name, "" if label is None else label.get("value", ""), types.get(name, ""), part.get("file"),
                                  links.get(name, frozenset())))
    return shapes


def _brep(archive, shape):
    content = archive.read(shape.member)
    if not shape.member.endswith(".brp") or b"CASCADE Topology" not in content[:200]:
        if not content.strip():
            return ""
        raise make_error("bad_input", "read", f"the shape of '{shape.label or shape.name}' is stored in binary form",
                         "save the document with text B-reps, or export the part as STEP")
    return content.decode("utf-8", "replace")


def _has_solid(brep):
    return "\nSo\n" in brep.replace("\r", "")


def _listing(shapes):
    return ", ".join(s.name if s.label in ("", s.name) else f"{s.name} ({s.label})" for s in shapes)
