# HexFeatureWB - LGPL-2.1-or-later
"""The one error type, for the Python side too."""
from hexfeature._core import MeshingError

EXIT_CODES = {"usage": 2, "bad_input": 3, "no_mesh": 4, "output": 5, "cancelled": 130}


def make_error(kind, step, reason, hint=""):
    """A MeshingError as the core raises it. `kind` is a key of EXIT_CODES."""
    error = MeshingError(f"{step}: {reason}")
    error.kind, error.step, error.reason, error.hint, error.cad_faces = kind, step, reason, hint, []
    return error


def system_error(kind, step, action, error, hint=""):
    """The same from an OSError or the like: `action` says what could not be done, as in "cannot read 'x'"."""
    return make_error(kind, step, f"{action}: {getattr(error, 'strerror', None) or error}", hint)
