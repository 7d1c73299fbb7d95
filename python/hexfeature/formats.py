# HexFeatureWB - LGPL-2.1-or-later
"""Write a mesh: .vtk, .inp and .unv by the core; .vtu and .msh by meshio, .med by h5py, which are loaded only then."""
import os

from hexfeature import _core
from hexfeature.errors import MeshingError, make_error, system_error

_MESHIO = {".vtu": "vtu", ".msh": "gmsh22"}


def endings():
    """Every ending that `write` knows, with the dot."""
    return [*_core.writable_endings, *_MESHIO, ".med"]


def check_output(path, known=None):
    """Fail now rather than after the work: an unknown ending, no such folder, a folder or device in the file's place."""
    ending = os.path.splitext(path)[1].lower()
    known = endings() if known is None else known
    if known and ending not in known:
        raise make_error("usage", "options", f"'{path}' has no known ending", "use one of " + " ".join(known))
    folder = os.path.dirname(os.path.abspath(path))
    if not os.path.isdir(folder):
        raise make_error("output", "write", f"cannot write '{path}': there is no folder '{folder}'", "make the folder first")
    if os.path.isdir(path):
        raise make_error("output", "write", f"cannot write '{path}': it is a folder", "give a file name, not a folder")
    if os.path.exists(path) and not os.path.isfile(path):  # renaming onto a device or a pipe would replace it
        raise make_error("output", "write", f"cannot write '{path}': it is no regular file", "give a file name")
    if not os.access(folder, os.W_OK | os.X_OK):
        raise make_error("output", "write", f"cannot write '{path}': no right to create files in '{folder}'", "choose another folder")


def write(mesh, path, element_type=""):
    """Write `mesh` (api.Mesh) by the ending of `path`. Raises MeshingError ("usage", "output")."""
    check_output(path)
    ending = os.path.splitext(path)[1].lower()
    if ending in _core.writable_endings:
        return mesh._result.write(os.fsencode(path), element_type)
    try:
        if ending == ".med":
            from hexfeature import med

            name = os.path.splitext(os.path.basename(path))[0]
            write_to = lambda temporary: med.write(mesh, temporary, name)
        else:
            write_to = _meshio_writer(mesh, _MESHIO[ending])
    except ImportError as error:
        raise make_error("output", "write", f"cannot write '{path}': the Python package {error.name} is missing",
                         f"install {error.name}, or write .vtk, .inp or .unv") from None
    replace_file(path, write_to)


def replace_file(path, write_to):
    """Call write_to(temporary path in the same folder), then rename: no half-written file, ever. The temporary's name, STEM.PID.part...,
    is one that the command line's guard knows. Raises MeshingError ("output")."""
    target = os.path.realpath(path)
    base, ending = os.path.splitext(target)
    temporary = f"{base}.{os.getpid()}.part{ending}"
    try:
        write_to(temporary)
        os.replace(temporary, target)
    except MeshingError:
        raise
    except (OSError, RuntimeError) as error:  # h5py has a RuntimeError where HDF5 cannot flush
        raise system_error("output", "write", f"cannot write '{path}'", error, "check the folder and the free space") from None
    finally:
        if os.path.exists(temporary):
            os.remove(temporary)


def _meshio_writer(mesh, file_format):
    """Hexahedra and boundary quads; the CAD faces and solids as cell data (.vtu) or physical groups FaceN, SolidN (.msh)."""
    import meshio
    import numpy as np

    second = mesh.order == 2
    cells = [("hexahedron20" if second else "hexahedron", np.array(mesh.hexes20 if second else mesh.hexes)),
             ("quad8" if second else "quad", np.array(mesh.quads8 if second else mesh.quads))]
    solid, face = np.array(mesh.hex_solid), np.array(mesh.quad_face)
    points = np.array(mesh.points)
    if file_format == "gmsh22":
        # Gmsh keeps one numbering a dimension, so face 1 and solid 1 do not collide.
        names = {f"Face{f}": np.array([f, 2]) for f in np.unique(face) if f > 0}
        names.update({f"Solid{s}": np.array([s, 3]) for s in np.unique(solid)})
        tags = [solid.astype(np.int32), face.astype(np.int32)]
        data = meshio.Mesh(points, cells, cell_data={"gmsh:physical": tags, "gmsh:geometrical": tags}, field_data=names)
        return lambda path: meshio.write(path, data, file_format="gmsh22", binary=True)
    data = meshio.Mesh(points, cells, cell_data={"cad_face": [np.zeros_like(solid), face], "cad_solid": [solid, _quad_solid(mesh)]},
                       point_data={"cad_dim": np.array(mesh.node_dim), "cad_entity": np.array(mesh.node_entity)})
    return lambda path: meshio.write(path, data, file_format=file_format)


def _quad_solid(mesh):
    """The solid of each quad: that of its first point (solids do not share points)."""
    import numpy as np

    solid_of_point = np.ones(len(mesh.points), dtype=np.int32)
    solid_of_point[np.asarray(mesh.hexes)] = np.asarray(mesh.hex_solid, dtype=np.int32)[:, None]
    return solid_of_point[np.asarray(mesh.quads)[:, 0]]
