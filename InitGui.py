# HexFeatureWB - LGPL-2.1-or-later
"""Registers the workbench. Names defined at the top of this file do not reach the class' methods."""
import FreeCADGui


class HexFeatureWorkbench(FreeCADGui.Workbench):
    MenuText = "Hex mesh"
    ToolTip = "All-hexahedral meshes of CAD solids"

    def __init__(self):
        from HexFeatureWB.gui import start

        self.__class__.Icon = start.icon("HexFeatureWB")
        self.__class__.MenuText, self.__class__.ToolTip = start.titles()

    def Initialize(self):
        from HexFeatureWB.gui import commands

        names = commands.register()
        self.appendToolbar("Hex mesh", names)
        self.appendMenu("Hex mesh", names)

    def GetClassName(self):
        return "Gui::PythonWorkbench"


def _start():
    from HexFeatureWB.gui import start

    start.start()


FreeCADGui.addWorkbench(HexFeatureWorkbench())
_start()
