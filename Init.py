# HexFeatureWB - LGPL-2.1-or-later
"""Run by FreeCAD at start, with and without a window: makes the package under python/ importable."""
import os
import sys

# FreeCAD puts only the addon's root on sys.path and (in 0.20) defines no __file__ here.
for _root in list(sys.path):
    _python = os.path.join(_root, "python")
    if os.path.isfile(os.path.join(_python, "HexFeatureWB", "__init__.py")) and _python not in sys.path:
        sys.path.append(_python)
