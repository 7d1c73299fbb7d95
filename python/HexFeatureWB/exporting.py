# HexFeatureWB - LGPL-2.1-or-later
"""Write a document's mesh to a file, in any format of the command line, with its CAD groups."""
from . import core, fem_mesh


def endings():
    """Every ending that can be written, with the dot."""
    core.load()
    from hexfeature import formats

    return formats.endings()


def export(mesh_obj, path, element_type=""):
    """Write the mesh of a FEM mesh object by the ending of `path`; coordinates keep double precision.

    element_type: of .inp, C3D8 (default), C3D8R, C3D8I; second order C3D20R (default), C3D20.
    Raises MeshingError ("usage", "output", "bad_input").
    """
    core.load()
    from hexfeature import api, errors

    try:
        arrays = fem_mesh.arrays_of(mesh_obj.FemMesh)
    except ValueError as error:
        raise errors.make_error("bad_input", "export", str(error), "choose a mesh made by Hex mesh from solid") from None
    for name in ("node_id", "hex_id"):
        del arrays[name]
    api.Mesh(core.load().result_from_arrays(**arrays)).write(path, element_type)
