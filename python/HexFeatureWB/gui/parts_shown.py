# HexFeatureWB - LGPL-2.1-or-later
"""A mesh stands in the place of its part: when it goes, by undo or by deleting, the part is shown again, or nothing would be seen."""
import FreeCAD

from .. import mesh_object
from . import settings


def meshes_of(source, but=None):
    """Our visible meshes of a part; with `but` those that stand in its place, without itself: meshes of other solids stand elsewhere."""
    return [o for o in source.Document.Objects if o is not but and mesh_object.is_hex_mesh(o) and o.ViewObject and o.ViewObject.Visibility
            and mesh_object.source_of(o) is source and (but is None or o.Solid == but.Solid or 0 in (o.Solid, but.Solid))]


class Observer:
    """FreeCAD calls these. Transactions do not hold what is visible."""

    def __init__(self):
        self._came = []  # names of objects since the last redo

    def slotDeletedObject(self, obj):
        if not mesh_object.is_hex_mesh(obj) or not obj.HexCount or not settings.switch("HidePart"):
            return
        source = mesh_object.source_of(obj)
        if obj.ViewObject and obj.ViewObject.Visibility and source is not None and source.ViewObject and not meshes_of(source, obj):
            source.ViewObject.Visibility = True

    def slotCreatedObject(self, obj):
        self._came.append(obj.Name)

    def slotCommitTransaction(self, document):
        self._came.clear()

    def slotRedoDocument(self, document):
        names, self._came = self._came, []
        for mesh in filter(mesh_object.is_hex_mesh, filter(None, map(document.getObject, names))):
            source = mesh_object.source_of(mesh)
            if settings.switch("HidePart") and source is not None and source.ViewObject and mesh.ViewObject.Visibility:
                source.ViewObject.Visibility = False


def watch():
    FreeCAD.addDocumentObserver(_observer)


_observer = Observer()
