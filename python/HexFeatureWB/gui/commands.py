# HexFeatureWB - LGPL-2.1-or-later
"""The workbench's commands. They hold no geometry: each opens a panel or calls the headless API by a recorded line."""
import os

import FreeCAD
import FreeCADGui
from PySide import QtGui

from .. import core
from ..translate import CONTEXT, tr
from . import messages, selection

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP


class Command:
    """What the commands share. `active` says when the command can be used; `run` does it."""

    icon = menu = tip = ""
    keys = ""

    def GetResources(self):
        resources = {"Pixmap": messages.icon(self.icon), "MenuText": tr(self.menu), "ToolTip": tr(self.tip)}
        if self.keys:
            resources["Accel"] = self.keys
        return resources

    def IsActive(self):
        return FreeCAD.ActiveDocument is not None and self.active()

    def Activated(self):
        problem = core.problem()
        if problem:
            messages.tell(problem)
            return
        from .. import meshing

        try:
            self.run()
        except meshing.MeshingError as error:
            FreeCAD.Console.PrintError(messages.failure_text(error, None, plain=True) + "\n")
            messages.tell(messages.failure_text(error, None))


class MeshSolid(Command):
    icon = "HexFeature_Mesh"
    menu = QT_TRANSLATE_NOOP(CONTEXT, "Hex mesh from solid")
    tip = QT_TRANSLATE_NOOP(CONTEXT, "Mesh the selected solid with hexahedra: choose the element size, see the feature lines, mesh")
    keys = "H, M"

    def active(self):
        return bool(selection.parts())

    def run(self):
        from . import task_panel

        part, solid = selection.parts()[0]
        task_panel.open_panel(part, solid=solid)


class MeshQuality(Command):
    icon = "HexFeature_Quality"
    menu = QT_TRANSLATE_NOOP(CONTEXT, "Mesh quality")
    tip = QT_TRANSLATE_NOOP(CONTEXT, "Colour the elements of a hex mesh by quality, show bad ones alone, cut the mesh open")
    keys = "H, Q"

    def active(self):
        return len(selection.meshes()) == 1

    def run(self):
        from . import quality_panel

        quality_panel.open_panel(selection.meshes()[0])


class ShowModel(Command):
    """Feature lines or recognition model of a part, with the size and options of its mesh where it has one."""

    kind = ""

    def active(self):
        return bool(selection.parts())

    def run(self):
        from .. import mesh_object
        from . import record, settings

        for part, solid in selection.parts():
            meshes = [m for m in part.Document.Objects if mesh_object.is_hex_mesh(m) and mesh_object.source_of(m) is part]
            if meshes:
                options, solid = mesh_object.options_of(meshes[-1]), meshes[-1].Solid
            else:
                options = {spec["name"]: settings.option_default(spec) for spec in settings.option_specs()}
            QtGui.QApplication.setOverrideCursor(QtGui.QCursor(messages.WAIT))
            try:
                record.make_model(self.kind, part, options, solid)
            finally:
                QtGui.QApplication.restoreOverrideCursor()
            for mesh in meshes:  # its own lines would hide the feature lines
                if self.kind == "feature_lines" and mesh.ViewObject.Visibility:
                    record.set_view(mesh, "Visibility", False)


class ShowFeatureLines(ShowModel):
    icon = "HexFeature_FeatureLines"
    menu = QT_TRANSLATE_NOOP(CONTEXT, "Show feature lines")
    tip = QT_TRANSLATE_NOOP(CONTEXT, "Add the lines that the selected solid's mesh starts from, the borders of its blocks, as an object")
    keys = "H, L"
    kind = "feature_lines"


class ShowRecognitionModel(ShowModel):
    icon = "HexFeature_RecognitionModel"
    menu = QT_TRANSLATE_NOOP(CONTEXT, "Show recognition model")
    tip = QT_TRANSLATE_NOOP(CONTEXT, "Add the polycube that the selected solid is straightened into, beside it, as an object")
    keys = "H, P"
    kind = "recognition_model"


class RefreshMesh(Command):
    icon = "HexFeature_Refresh"
    menu = QT_TRANSLATE_NOOP(CONTEXT, "Refresh mesh")
    tip = QT_TRANSLATE_NOOP(CONTEXT, "Mesh again with part and options as they are now: the selected meshes, or all that are out of date")
    keys = "H, R"

    def active(self):
        return bool(selection.meshes(outdated=True))

    def run(self):
        from . import refresh_panel

        refresh_panel.open_panel(selection.meshes(outdated=True))


class ExportMesh(Command):
    icon = "HexFeature_Export"
    menu = QT_TRANSLATE_NOOP(CONTEXT, "Export mesh")
    tip = QT_TRANSLATE_NOOP(CONTEXT, "Write a hex mesh with its CAD groups to a file: .inp .unv .med .msh .vtk .vtu")
    keys = "H, E"

    def active(self):
        return len(selection.meshes()) == 1

    def run(self):
        from .. import exporting
        from . import record

        mesh = selection.meshes()[0]
        kinds = {".inp": "CalculiX, Abaqus", ".unv": "I-DEAS", ".med": "SALOME, Code_Aster", ".msh": "Gmsh 2.2", ".vtk": "VTK",
                 ".vtu": "VTK XML"}
        endings = sorted(exporting.endings(), key=lambda e: list(kinds).index(e) if e in kinds else len(kinds))
        filters = ["%s (*%s)" % (kinds.get(ending, ending[1:]), ending) for ending in endings]
        folder = os.path.dirname(mesh.Document.FileName) if mesh.Document.FileName else os.path.expanduser("~")
        path, chosen = ask_file(tr("Export mesh"), os.path.join(folder, mesh.Label), filters)
        if not path:
            return
        if os.path.splitext(path)[1].lower() not in endings:
            path += endings[filters.index(chosen)] if chosen in filters else endings[0]
        record.export(mesh, path)
        record.console(tr("written: %s") % path)


def ask_file(title, start, filters):
    """(path, filter) from the user; tests put their own in its place."""
    return QtGui.QFileDialog.getSaveFileName(FreeCADGui.getMainWindow(), title, start, ";;".join(filters))[:2]


class Batch(Command):
    icon = "HexFeature_Batch"
    menu = QT_TRANSLATE_NOOP(CONTEXT, "Batch")
    tip = QT_TRANSLATE_NOOP(CONTEXT, "Mesh every solid of many CAD files or FreeCAD documents into a folder")
    keys = "H, B"

    def IsActive(self):
        return True

    def run(self):
        from . import batch_dialog

        batch_dialog.open_dialog()


COMMANDS = {
    "HexFeature_Mesh": MeshSolid, "HexFeature_Refresh": RefreshMesh, "HexFeature_Quality": MeshQuality,
    "HexFeature_FeatureLines": ShowFeatureLines, "HexFeature_RecognitionModel": ShowRecognitionModel,
    "HexFeature_Export": ExportMesh, "HexFeature_Batch": Batch,
}


def register():
    """Make the commands known to FreeCAD, once; returns their names in menu order."""
    known = set(FreeCADGui.listCommands())
    for name, command in COMMANDS.items():
        if name not in known:
            FreeCADGui.addCommand(name, command())
    return list(COMMANDS)
