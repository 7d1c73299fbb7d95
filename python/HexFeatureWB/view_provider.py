# HexFeatureWB - LGPL-2.1-or-later
"""How a mesh object shows itself in the tree and the 3D view. Module, class and property names are file format."""
import os

import FreeCAD

ICONS = os.path.join(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))), "Resources", "icons")
GROUP = "Hex mesh"
QUALITY = "Quality"  #: name of the display mode


class HexMeshView:
    def __init__(self, view):
        view.Proxy = self
        self.prepare(view)

    @staticmethod
    def prepare(view):
        """For a new view, or one of a document that an older version has saved."""
        # Below so many faces FreeCAD compares each with each, to leave out double ones: seconds for 20,000. Ours are there once.
        if hasattr(view, "MaxFacesShowInner") and view.MaxFacesShowInner != 0:
            view.MaxFacesShowInner = 0
        for kind, name, text, value in (
            ("App::PropertyFloatConstraint", "ShowBelow", "in Quality: show only elements of a scaled Jacobian below this; 1: all",
             (1.0, 0.0, 1.0, 0.05)),
            ("App::PropertyEnumeration", "CutAxis", "in Quality: cut the mesh open across this axis", ["None", "X", "Y", "Z"]),
            ("App::PropertyPercent", "CutPosition", "in Quality: where the cut is, of the mesh's extent", 50),
            ("App::PropertyBool", "CutFlip", "in Quality: show the other side of the cut", False),
            ("App::PropertyBool", "FeatureLines", "in Quality: draw the feature lines on the mesh", False),
            ("App::PropertyBool", "ColourBar", "in Quality: draw the colour scale", True),
        ):
            if not hasattr(view, name):
                view.addProperty(kind, name, GROUP, text)
                setattr(view, name, value)

    def attach(self, view):
        from .gui.quality_view import QualityNode

        self.Object = view.Object
        self.quality = QualityNode()
        view.addDisplayMode(self.quality.root, QUALITY)

    def getDisplayModes(self, view):
        return [QUALITY]

    def setDisplayMode(self, mode):
        return mode

    def getIcon(self):
        outdated = getattr(getattr(self, "Object", None), "NeedsRefresh", False)
        return os.path.join(ICONS, "HexFeature_MeshOutdated.svg" if outdated else "HexFeature_Mesh.svg")

    def updateData(self, obj, name):
        if name == "NeedsRefresh":
            obj.ViewObject.signalChangeIcon()
        elif name == "FemMesh":
            self._draw(obj.ViewObject, forget=True)

    def expect(self, result):
        """The core's result of the mesh that the object gets next."""
        node = getattr(self, "quality", None)
        if node is not None:
            node.expect(result)

    def onChanged(self, view, name):
        if name in ("DisplayMode", "ShowBelow", "CutAxis", "CutPosition", "CutFlip", "FeatureLines", "ColourBar"):
            self._draw(view)

    def _draw(self, view, forget=False):
        """The node is made only while it is looked at: it costs time and memory."""
        node = getattr(self, "quality", None)
        # ShowBelow is the last one to be read from a document.
        if node is None or not hasattr(view, "ShowBelow"):
            return
        if forget:
            node.forget()
        if view.DisplayMode == QUALITY:
            node.update(view.Object, view)
        else:
            node.root.removeAllChildren()

    def doubleClicked(self, view):
        return self.setEdit(view, 0)

    def setEdit(self, view, mode):
        from .gui import task_panel

        if mode != 0:
            return None
        task_panel.edit(view.Object)
        return True

    def unsetEdit(self, view, mode):
        import FreeCADGui

        FreeCADGui.Control.closeDialog()
        return True

    def dumps(self):
        return None

    def loads(self, state):
        return None

    __getstate__ = dumps
    __setstate__ = loads


def revive(obj):
    """After a document was read: give a mesh its view, and draw it. One saved without a window has neither, and is hidden."""
    from PySide import QtCore

    view = obj.ViewObject
    if view is None:
        return
    headless = not isinstance(view.Proxy, HexMeshView)
    if headless:
        HexMeshView(view)
    else:
        HexMeshView.prepare(view)

    def draw():  # when the whole document, views too, has been read; it may have been closed meanwhile
        document = FreeCAD.listDocuments().get(document_name)
        mesh = document and document.getObject(name)
        if not mesh or mesh.ViewObject is None:
            return
        view = mesh.ViewObject
        if headless:
            # Saved without a window, the document holds no picture of the mesh: setting it again makes one.
            mesh.FemMesh = mesh.FemMesh
            mesh.purgeTouched()
            view.Visibility = True
        if view.Proxy:
            view.Proxy._draw(view, forget=True)

    document_name, name = obj.Document.Name, obj.Name
    QtCore.QTimer.singleShot(0, draw)
