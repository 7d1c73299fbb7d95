# HexFeatureWB - LGPL-2.1-or-later
"""The way to the core: one place that imports the extension and says what to do when it is missing."""
import sys


def load():
    """Return the extension module ``hexfeature._core``. Raises ImportError with advice."""
    try:
        from hexfeature import _core
    except ImportError as error:
        raise ImportError(advice(error)) from error
    return _core


def problem():
    """None, or why meshing is impossible here and what to do about it, as a text for the user."""
    try:
        load()
    except ImportError as error:
        return str(error)
    return None


def advice(error):
    """What a user can do about a missing or unloadable extension; names this FreeCAD's own Python version."""
    try:
        from .translate import tr
    except ImportError:  # a Python without FreeCAD may ask, too
        tr = str
    return "HexFeatureWB: " + tr(
        "the meshing program (hexfeature._core) cannot be loaded: %(error)s.\n"
        "FreeCAD runs Python %(python)s. Either run 'make build' in the workbench's folder with that Python, or install the package "
        "'hexfeature' for it: python%(python)s -m pip install hexfeature"
    ) % {"error": error, "python": "%d.%d" % sys.version_info[:2]}
