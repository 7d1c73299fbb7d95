# HexFeatureWB - LGPL-2.1-or-later
"""Texts in the user's language. One context for all; the files are made by packaging/translations.py."""
import FreeCAD

CONTEXT = "HexFeature"


def tr(text):
    """The text in FreeCAD's language, or as it is."""
    return FreeCAD.Qt.translate(CONTEXT, text)
