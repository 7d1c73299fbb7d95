# HexFeatureWB - LGPL-2.1-or-later
"""Save a document with a part, its mesh and an analysis, for opening it in another FreeCAD.

HEXFEATURE_SAVE=older.FCStd freecadcmd -P python -P tests/parts tests/freecad/save_document.py
"""
import os

import FreeCAD

import HexFeatureWB
from HexFeatureWB import analysis

import make_parts


def save(path):
    document = FreeCAD.newDocument("Older")
    part = document.addObject("Part::Feature", "Part")
    part.Shape = make_parts.bracket().Solids[0]
    mesh = HexFeatureWB.mesh(part, size=6)
    analysis.static_analysis(document, mesh, [(part, ("Face1",))], [(part, ("Face2",))], 100.0)
    document.recompute()
    document.saveAs(path)
    FreeCAD.closeDocument(document.Name)


if __name__ == "save_document" and "HEXFEATURE_SAVE" in os.environ:  # freecadcmd imports the script that it is given
    save(os.environ["HEXFEATURE_SAVE"])
    os._exit(0)
