# HexFeatureWB - LGPL-2.1-or-later
"""How a mesh object shows itself in the tree and the 3D view."""
import os

ICONS = os.path.join(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))), "Resources", "icons")


class HexMeshView:
    def __init__(self, view):
        view.Proxy = self

    def attach(self, view):
        self.ViewObject = view
        self.Object = view.Object
        # A document saved without a window keeps no picture of its mesh: setting it again makes one.
        if self.Object.FemMesh.NodeCount:
            self.Object.FemMesh = self.Object.FemMesh

    def getIcon(self):
        return os.path.join(ICONS, "HexFeature_Mesh.svg")

    def updateData(self, obj, name):
        pass

    def onChanged(self, view, name):
        pass

    def dumps(self):
        return None

    def loads(self, state):
        return None

    __getstate__ = dumps
    __setstate__ = loads
