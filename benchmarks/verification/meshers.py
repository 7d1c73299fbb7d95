# HexFeatureWB - LGPL-2.1-or-later
"""One part, two meshers: ours, and Gmsh's quadratic tetrahedra with about as many nodes. Both give a Model and an .inp file."""
import contextlib
import os
import tempfile
import time

import numpy as np

import mapped
import model as fe
from deck import SIDES20


def hexahedra(shape, size, path, element_type):
    """Mesh a FreeCAD shape by the feature-line method; element_type says the order. Leaves `path` (.inp)."""
    import hexfeature

    started = time.process_time()
    mesh = hexfeature.mesh_brep(shape.exportBrepToString(), size, order=2 if element_type.startswith("C3D20") else 1)
    seconds = time.process_time() - started
    mesh.write(path, element_type)
    cells = np.array(mesh.hexes20 if mesh.order == 2 else mesh.hexes)
    quads = np.array(mesh.quads8 if mesh.order == 2 else mesh.quads)
    sides = {int(f): quads[mesh.quad_face == f] for f in np.unique(mesh.quad_face)}
    entity, on_edge = np.array(mesh.node_entity), np.array(mesh.node_dim) == 1
    edges = {}
    for edge in np.unique(mesh.feature_edge_cad):
        ends = np.unique(mesh.feature_edges[mesh.feature_edge_cad == edge])
        edges[int(edge)] = np.union1d(ends, np.flatnonzero(on_edge & (entity == edge)))
    quality = mesh.report["quality"]
    facts = {"cells": len(cells), "mesh_seconds": seconds, "min_sj": quality["min_scaled_jacobian"],
             "mean_sj": quality["mean_scaled_jacobian"]}
    return fe.Model(path, np.array(mesh.points), cells, sides, edges, solids=int(max(mesh.hex_solid)), facts=facts)


def tetrahedra(shape, size, path, nodes_wanted=None):
    """Mesh a FreeCAD shape by Gmsh with 10-node tetrahedra, curved and optimized. Leaves `path` (.inp).

    nodes_wanted: the size is then changed, three times at most, until the number of nodes is within 5% of it.
    """
    best = None
    for _ in range(4):
        candidate = _gmsh(shape, size)
        count = len(candidate[0])
        off = abs(count / nodes_wanted - 1) if nodes_wanted else 0
        if best is None or off < best[0]:
            best = (off, candidate)
        if off < 0.05:
            break
        size *= (count / nodes_wanted) ** (1 / 2.9)
    points, cells, cell_solid, triangles, edges, seconds = best[1]
    model = fe.Model(path, points, cells, triangles, edges, solids=int(cell_solid.max()),
                     facts={"cells": len(cells), "mesh_seconds": seconds})
    _write_inp(model, cell_solid)
    return model


def tetrahedra_file(shape, size, path, nodes_wanted):
    """Gmsh's own file of the shape with 10-node tetrahedra and 6-node triangles, within 15% of so many nodes or the third try."""
    import gmsh

    for _ in range(3):
        with _meshed(shape, size):
            count = len(gmsh.model.mesh.getNodes()[0])
            gmsh.option.setNumber("Mesh.SaveAll", 1)
            gmsh.write(path)
        if abs(count / nodes_wanted - 1) < 0.15:
            return
        size *= (count / nodes_wanted) ** (1 / 2.9)


@contextlib.contextmanager
def _meshed(shape, size):
    """Gmsh with the shape meshed; yields the seconds that took."""
    import gmsh

    gmsh.initialize([], False)
    try:
        for option, value in (("General.Terminal", 0), ("General.NumThreads", 1), ("Mesh.MeshSizeMax", size), ("Mesh.MeshSizeMin", size),
                              ("Mesh.ElementOrder", 2), ("Mesh.HighOrderOptimize", 1), ("Mesh.Optimize", 1)):
            gmsh.option.setNumber(option, value)
        with tempfile.TemporaryDirectory() as folder:
            brep = os.path.join(folder, "part.brep")
            shape.exportBrep(brep)
            gmsh.model.occ.importShapes(brep)
        gmsh.model.occ.synchronize()
        started = time.process_time()
        try:
            gmsh.model.mesh.generate(3)
        except Exception as error:  # the mesh is made, but its curved elements could not be made as good as Gmsh would like
            if "critical value" not in str(error):
                raise
        yield time.process_time() - started
    finally:
        gmsh.finalize()


def _gmsh(shape, size):
    """(points, cells in Abaqus order, solid of each cell, {face: triangles}, {edge: nodes}, seconds) with the shape's own numbers."""
    import gmsh

    with _meshed(shape, size) as seconds:
        tags, coordinates, _ = gmsh.model.mesh.getNodes()
        index = np.zeros(int(tags.max()) + 1, dtype=int)
        index[tags] = np.arange(len(tags))
        cells, cell_solid = [], []
        numbers = _own_numbers(gmsh, 3, shape.Solids)
        for _, tag in gmsh.model.getEntities(3):
            _, _, nodes = gmsh.model.mesh.getElements(3, tag)
            block = index[nodes[0]].reshape(-1, 10)[:, [0, 1, 2, 3, 4, 5, 6, 7, 9, 8]]  # Gmsh exchanges the last two
            cells.append(block)
            cell_solid.append(np.full(len(block), numbers[tag]))
        triangles = {}
        for tag, number in _own_numbers(gmsh, 2, shape.Faces).items():
            triangles[number] = index[gmsh.model.mesh.getElements(2, tag)[2][0]].reshape(-1, 6)
        edges = {}
        for tag, number in _own_numbers(gmsh, 1, shape.Edges).items():
            nodes = gmsh.model.mesh.getElements(1, tag)[2]
            if nodes:
                edges[number] = np.unique(index[nodes[0]])
        return coordinates.reshape(-1, 3), np.vstack(cells), np.hstack(cell_solid), triangles, edges, seconds


def _own_numbers(gmsh, dimension, entities):
    """Gmsh's tag -> the shape's number, by centre of mass and content."""
    measure = {1: "Length", 2: "Area", 3: "Volume"}[dimension]
    own = np.array([[*e.CenterOfMass, getattr(e, measure) ** (1 / dimension)] for e in entities])
    result = {}
    for _, tag in gmsh.model.getEntities(dimension):
        try:
            key = [*gmsh.model.occ.getCenterOfMass(dimension, tag), gmsh.model.occ.getMass(dimension, tag) ** (1 / dimension)]
        except Exception:  # an edge of no length, at a sphere's pole
            continue
        result[tag] = int(np.argmin(np.linalg.norm(own - key, axis=1))) + 1
    if dimension > 1 and len(set(result.values())) != len(entities):
        raise RuntimeError("Gmsh's faces are not the part's")
    return result


def one_block(problem, shape, path, nodes_wanted):
    """20-node hexahedra by formula, a block a solid. Leaves `path` (.inp)."""
    model, cell_solid = mapped.blocks(problem, shape, nodes_wanted, path)
    _write_inp(model, cell_solid, "C3D20R", np.array(SIDES20))
    return model


def _write_inp(model, cell_solid, element="C3D10", local_sides=fe.TET10_SIDES):
    """The elements with the same names as ours; CalculiX writes a 20-node element in two lines."""
    corners = 4 if element == "C3D20R" else 3
    with open(model.path, "w") as out:
        out.write("*NODE, NSET=Nodes\n")
        out.writelines("%d,%.13g,%.13g,%.13g\n" % (n, *p) for n, p in enumerate(model.points.tolist(), 1))
        for solid in np.unique(cell_solid):
            out.write("*ELEMENT, TYPE=%s, ELSET=Solid%d\n" % (element, solid))
            for cell in np.flatnonzero(cell_solid == solid).tolist():
                row = [str(n) for n in (cell + 1, *(model.cells[cell] + 1))]
                out.write(",".join(row[:11]) + ",\n" * (len(row) > 11) + ",".join(row[11:]) + "\n")
        for kind, sets in (("Face", model.sides), ("Edge", model.edges)):
            for number, nodes in sorted(sets.items()):
                out.write("*NSET, NSET=%s%d\n" % (kind, number))
                out.writelines("%d,\n" % (n + 1) for n in np.unique(nodes))
        side_of = {}
        for side, nodes in enumerate(local_sides[:, :corners], 1):
            for cell, key in enumerate(np.sort(model.cells[:, nodes], axis=1).tolist(), 1):
                side_of[tuple(key)] = (cell, side)
        for number, faces in sorted(model.sides.items()):
            out.write("*SURFACE, NAME=Face%d, TYPE=ELEMENT\n" % number)
            for key in np.sort(faces[:, :corners], axis=1).tolist():
                out.write("%d,S%d\n" % side_of[tuple(key)])
