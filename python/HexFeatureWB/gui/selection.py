# HexFeatureWB - LGPL-2.1-or-later
"""What the user has selected, as the commands need it."""
import FreeCAD
import FreeCADGui

from .. import mesh_object
from ..source import solids_of


def _chosen():
    """[(object, names of its selected sub-elements)] of the active document; a body's feature stands for the body."""
    found = []
    for item in FreeCADGui.Selection.getSelectionEx("", 1):  # 1: the object that has the sub-elements, not the outermost group
        obj = item.Object
        if obj.TypeId == "App::Part":  # a container stands for what is seen of it
            found += [(child, []) for child in obj.Group if _is_part(child)]
            continue
        body = next((b for b in obj.InList if b.TypeId == "PartDesign::Body"), None)
        found.append((body or obj, [] if body else [name.split(".")[-1] for name in item.SubElementNames]))
    return found


def parts():
    """[(object with a solid, number of the solid that was picked or 0)], of the selection; else of the document's only part."""
    found = {}
    for obj, names in _chosen():
        if mesh_object.is_hex_mesh(obj):
            obj, names = mesh_object.source_of(obj), []
        if solids_of(obj) and obj.Name not in found:
            found[obj.Name] = obj, _solid_of(obj, names)
    if not found and not _chosen() and FreeCAD.ActiveDocument:
        meshed = {mesh_object.source_of(m) for m in FreeCAD.ActiveDocument.Objects if mesh_object.is_hex_mesh(m)}
        found = [o for o in FreeCAD.ActiveDocument.Objects if _is_part(o) or o in meshed]
        return [(found[0], 0)] if len(found) == 1 else []
    return list(found.values())


def _is_part(obj):
    """A visible object with a solid that is no step on the way to another one."""
    if not solids_of(obj) or obj.ViewObject is None or not obj.ViewObject.Visibility:
        return False
    return not any(solids_of(user) for user in obj.InList if user.TypeId != "App::Part")


def _solid_of(obj, names):
    """Of several solids the one that holds a picked face, edge or vertex; 0 when nothing or the whole was picked."""
    solids = solids_of(obj)
    if len(solids) < 2:
        return 0
    for name in names:
        if name.startswith("Solid") and name[5:].isdigit():
            return int(name[5:])
        element = obj.Shape.getElement(name) if name else None
        for number, solid in enumerate(solids, 1):
            if element is not None and any(element.isSame(e) for e in (*solid.Faces, *solid.Edges, *solid.Vertexes)):
                return number
    return 0


def meshes(outdated=False):
    """Our mesh objects: the selected ones, or those of selected parts, or the document's only one.

    outdated: with nothing selected, all that need a refresh instead.
    """
    document = FreeCAD.ActiveDocument
    if document is None:
        return []
    all_ = [o for o in document.Objects if mesh_object.is_hex_mesh(o)]
    chosen = [obj for obj, _ in _chosen()]
    found = [m for m in all_ if m in chosen or mesh_object.source_of(m) in chosen]
    if found or chosen:
        return found
    if outdated:
        stale = [m for m in all_ if m.NeedsRefresh]
        if stale:
            return stale
    return all_ if len(all_) == 1 else []
