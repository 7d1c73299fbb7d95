# HexFeatureWB - LGPL-2.1-or-later
"""Intermediate results as coloured pictures: one legacy VTK file a stage, its arrays on cells.

surface   triangles; cad_face
labels    triangles; label (0..5 = +X -X +Y -Y +Z -Z), chart, site, violation (condition 1..4, 0 none), cad_face, adaptation
shape     feature lines as polylines; arc, arc_axis (0..2), arc_sign, arc_dihedral (radians); feature points as vertices
polycube  the recognition model: straight feature lines between integer corners, arrays as above
lattice, fit, sheets, smooth   hexahedra and boundary quads; cad_face, chart, block
"""
import numpy as np

from hexfeature.formats import replace_file

VERTEX, LINE, POLYLINE, TRIANGLE, QUAD, HEXAHEDRON = 1, 3, 4, 5, 9, 12


def write(stage, name, path):
    """Write the dict of arrays `stage` (of Mesh.stage(name)). Raises MeshingError ("output")."""
    points, cells, arrays = _GEOMETRY.get(name, _complex)(stage)
    replace_file(path, lambda temporary: write_vtk(temporary, points, cells, arrays))


def write_vtk(path, points, cells, arrays):
    """points (n, 3); cells: list of (VTK type, list or array of node lists); arrays: name -> one value or vector a cell."""
    flat, types = [], []
    for kind, rows in cells:
        if isinstance(rows, np.ndarray):
            flat.append(np.column_stack([np.full(len(rows), rows.shape[1]), rows]).ravel())
        else:
            flat.extend(np.concatenate([[len(row)], row]) for row in rows)
        types.append(np.full(len(rows), kind))
    flat = np.concatenate(flat) if flat else np.zeros(0)
    types = np.concatenate(types) if types else np.zeros(0)
    with open(path, "wb") as out:
        out.write(b"# vtk DataFile Version 3.0\nHexFeatureWB\nBINARY\nDATASET UNSTRUCTURED_GRID\n")
        out.write(b"POINTS %d double\n" % len(points) + np.asarray(points).astype(">f8").tobytes())
        out.write(b"\nCELLS %d %d\n" % (len(types), len(flat)) + flat.astype(">i4").tobytes())
        out.write(b"\nCELL_TYPES %d\n" % len(types) + types.astype(">i4").tobytes())
        out.write(b"\nCELL_DATA %d\nFIELD FieldData %d\n" % (len(types), len(arrays)))
        for name, values in arrays.items():
            values = np.asarray(values)
            width = 1 if values.ndim == 1 else values.shape[1]
            kind, code = ("double", ">f8") if values.dtype.kind == "f" else ("int", ">i4")
            out.write(f"{name} {width} {len(values)} {kind}\n".encode() + values.astype(code).tobytes() + b"\n")


def _triangles(stage):
    arrays = {name: stage[name] for name in ("label", "chart", "site", "violation", "cad_face", "adaptation") if name in stage}
    return stage["points"], [(TRIANGLE, np.asarray(stage["triangles"]))], arrays


def _with_corners(stage, points, arcs, corners):
    """Arc polylines, then corner vertices; the arcs' arrays are -1 or 0 on the vertices."""
    count = len(corners)
    arrays = {"arc": np.concatenate([np.arange(len(arcs)), np.full(count, -1)])}
    for name, missing in (("arc_axis", -1), ("arc_sign", 0), ("arc_dihedral", 0.0)):
        arrays[name] = np.concatenate([np.asarray(stage[name], dtype=type(missing)), np.full(count, missing)])
    arrays["corner"] = np.concatenate([np.full(len(arcs), -1), np.arange(count)])
    return points, [(POLYLINE, arcs), (VERTEX, [[c] for c in corners])], arrays


def _shape(stage):
    return _with_corners(stage, stage["points"], stage["arcs"], stage["corners"])


def _polycube(stage):
    points = np.asarray(stage["corner_coordinates"], dtype=float).reshape(-1, 3)
    arcs = [[max(start, 0), max(end, 0)] for start, end in zip(stage["arc_start"], stage["arc_end"])]
    return _with_corners(stage, points, arcs, range(len(points)))


def _complex(stage):
    hexes, quads = np.asarray(stage["hexes"]), np.asarray(stage["quads"])

    def spread(on_hexes, on_quads):
        return np.concatenate([np.full(len(hexes), on_hexes) if np.isscalar(on_hexes) else on_hexes,
                               np.full(len(quads), on_quads) if np.isscalar(on_quads) or not len(on_quads) else on_quads])

    block = stage["hex_block"] if len(stage["hex_block"]) == len(hexes) else 0
    face = stage["quad_face"] if len(stage["quad_face"]) == len(quads) else 0
    chart = stage["quad_chart"] if len(stage["quad_chart"]) == len(quads) else -1
    arrays = {"cad_face": spread(0, face), "chart": spread(-1, chart), "block": spread(block, -1)}
    return stage["points"], [(HEXAHEDRON, hexes), (QUAD, quads)], arrays


_GEOMETRY = {"surface": _triangles, "labels": _triangles, "shape": _shape, "polycube": _polycube}
