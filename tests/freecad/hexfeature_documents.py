# HexFeatureWB - LGPL-2.1-or-later
"""What the tests under freecadcmd share: a document with a part, closed after each test."""
import unittest

import FreeCAD


def new_part(shape):
    document = FreeCAD.newDocument("Test")
    document.UndoMode = 1
    part = document.addObject("Part::Feature", "Part")
    part.Shape = shape
    document.recompute()
    return document, part


class DocumentTest(unittest.TestCase):
    def tearDown(self):
        for name in list(FreeCAD.listDocuments()):
            FreeCAD.closeDocument(name)
