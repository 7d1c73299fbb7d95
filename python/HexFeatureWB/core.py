# HexFeatureWB - LGPL-2.1-or-later
"""The way to the core: one place that imports the extension and says what to do when it is missing."""


def load():
    """Return the extension module ``hexfeature._core``. Raises ImportError with advice."""
    try:
        from hexfeature import _core
    except ImportError as error:
        raise ImportError(
            "HexFeatureWB: the extension hexfeature._core cannot be loaded (%s). Build it with 'make build' in the "
            "workbench's folder, or install the package 'hexfeature' for FreeCAD's Python." % error
        ) from error
    return _core
