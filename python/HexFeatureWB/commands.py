# HexFeatureWB - LGPL-2.1-or-later
"""FreeCAD commands. They hold no geometry: each calls the headless API."""
import os

import FreeCAD
import FreeCADGui

from .view_provider import ICONS


class MeshSolid:
    """Mesh the selected solid with the default element size; the new object's properties change it."""

    def GetResources(self):
        return {
            "Pixmap": os.path.join(ICONS, "HexFeature_Mesh.svg"),
            "MenuText": "Hex mesh from solid",
            "ToolTip": "Mesh the selected solid with hexahedra",
        }

    def IsActive(self):
        return any(hasattr(o, "Shape") and getattr(o.Shape, "Solids", None) for o in FreeCADGui.Selection.getSelection())

    def Activated(self):
        from . import meshing

        for obj in FreeCADGui.Selection.getSelection():
            if not getattr(getattr(obj, "Shape", None), "Solids", None):
                continue
            try:
                meshing.mesh(obj)
            except meshing.MeshingError as error:
                FreeCAD.Console.PrintError("HexFeatureWB: %s: %s. %s\n" % (error.step, error.reason, error.hint))
        FreeCAD.ActiveDocument.recompute()


class RefreshMesh:
    """Mesh the selected mesh object's part again, after the part or an option changed."""

    def GetResources(self):
        return {
            "Pixmap": os.path.join(ICONS, "HexFeature_Refresh.svg"),
            "MenuText": "Refresh hex mesh",
            "ToolTip": "Mesh again with the part and the options as they are now",
        }

    def IsActive(self):
        return any(o.isDerivedFrom("Fem::FemMeshObject") and hasattr(o, "ElementSize") for o in FreeCADGui.Selection.getSelection())

    def Activated(self):
        from . import meshing

        for obj in FreeCADGui.Selection.getSelection():
            if not hasattr(obj, "ElementSize"):
                continue
            obj.Document.openTransaction("Refresh hex mesh")
            try:
                meshing.refresh(obj)
                obj.Document.commitTransaction()
            except meshing.MeshingError as error:
                obj.Document.abortTransaction()
                FreeCAD.Console.PrintError("HexFeatureWB: %s: %s. %s\n" % (error.step, error.reason, error.hint))
        FreeCAD.ActiveDocument.recompute()


def register():
    """Make the commands known to FreeCAD; returns their names in menu order."""
    commands = {"HexFeature_Mesh": MeshSolid(), "HexFeature_Refresh": RefreshMesh()}
    for name, command in commands.items():
        FreeCADGui.addCommand(name, command)
    return list(commands)
