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
    """FreeCAD calls these. What is shown or hidden after a step, as a part once its mesh is made, is not undone or redone with it."""

    def __init__(self):
        self._came = set()  # (document, object): names of what was made since the document's last step, undo or redo

    def slotDeletedObject(self, obj):
        if not mesh_object.is_hex_mesh(obj) or not obj.HexCount or not settings.switch("HidePart"):
            return
        source = mesh_object.source_of(obj)
        if obj.ViewObject and obj.ViewObject.Visibility and source is not None and source.ViewObject and not meshes_of(source, obj):
            source.ViewObject.Visibility = True

    def slotCreatedObject(self, obj):
        self._came.add((obj.Document.Name, obj.Name))

    def slotCommitTransaction(self, document):
        self._take(document)

    def slotFinishRestoreDocument(self, document):
        self._take(document)

    def slotDeletedDocument(self, document):
        self._take(document)

    def slotUndoDocument(self, document):
        self._take(document)  # a mesh that was deleted comes back with its part as it was: that was changed in the same step

    def slotRedoDocument(self, document):
        """A mesh that is made again hides its part again."""
        for mesh in filter(mesh_object.is_hex_mesh, map(document.getObject, self._take(document))):
            source = mesh_object.source_of(mesh)
            if settings.switch("HidePart") and source is not None and source.ViewObject and mesh.ViewObject.Visibility:
                source.ViewObject.Visibility = False

    def _take(self, document):
        """Names of a document's objects that came, which are forgotten."""
        names = {name for of, name in self._came if of == document.Name}
        self._came -= {(document.Name, name) for name in names}
        return names


def watch():
    FreeCAD.addDocumentObserver(_observer)


_observer = Observer()
