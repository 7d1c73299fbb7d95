# HexFeatureWB - LGPL-2.1-or-later
"""Registers the workbench. Names defined at the top of this file do not reach the class' methods."""
import FreeCADGui


class HexFeatureWorkbench(FreeCADGui.Workbench):
    MenuText = "Hex mesh"
    ToolTip = "All-hexahedral meshes of CAD solids"

    def __init__(self):
        import os

        import HexFeatureWB

        root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(HexFeatureWB.__file__))))
        self.__class__.Icon = os.path.join(root, "Resources", "icons", "HexFeatureWB.svg")

    def Initialize(self):
        from HexFeatureWB import commands

        names = commands.register()
        self.appendToolbar("Hex mesh", names)
        self.appendMenu("Hex mesh", names)

    def GetClassName(self):
        return "Gui::PythonWorkbench"


FreeCADGui.addWorkbench(HexFeatureWorkbench())
