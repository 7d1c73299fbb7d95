# HexFeatureWB - LGPL-2.1-or-later
"""The same parts meshed as one block each, by formula: what 20-node hexahedra do where the block layout is not in their way."""
import numpy as np

import model as fe
from deck import EDGES, SIDES20

#: Sides of a block in the order of deck.SIDES20: low, top, y0, outer, x0, inner of a sector (r, angle, z).
NAMES = ("low", "top", "y0", "outer", "x0", "inner")


def sector(at, counts):
    """One block of a quarter: at(u, v, w) -> points for u across the wall, v round from the x axis, w up, each 0 to 1 (arrays).

    Returns points (n, 3), cells (m, 20) and {name of NAMES: quads (k, 8)}.
    """
    nu, nv, nw = counts
    shape = (2 * nu + 1, 2 * nv + 1, 2 * nw + 1)
    number = np.arange(np.prod(shape)).reshape(shape)
    grid = np.stack(np.meshgrid(*(np.linspace(0, 1, n) for n in shape), indexing="ij"), axis=-1).reshape(-1, 3)
    corner = np.array([(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (0, 0, 2), (2, 0, 2), (2, 2, 2), (0, 2, 2)])
    local = np.vstack([corner, [corner[list(edge)].sum(axis=0) // 2 for edge in EDGES]])
    first = 2 * np.stack(np.meshgrid(*(np.arange(n) for n in counts), indexing="ij"), axis=-1).reshape(-1, 3)
    index = first[:, None, :] + local[None]
    cells = number[index[..., 0], index[..., 1], index[..., 2]]
    last = 2 * np.array(counts) - 2
    on = {"low": first[:, 2] == 0, "top": first[:, 2] == last[2], "y0": first[:, 1] == 0, "outer": first[:, 0] == last[0],
          "x0": first[:, 1] == last[1], "inner": first[:, 0] == 0}
    sides = {name: cells[on[name]][:, list(SIDES20[k])] for k, name in enumerate(NAMES)}
    used = np.unique(cells)
    new = np.zeros(len(grid), dtype=int)
    new[used] = np.arange(len(used))
    return at(*grid[used].T), new[cells], {name: new[quads] for name, quads in sides.items()}


def node_count(counts):
    """Nodes of a block of 20-node hexahedra: the grid of half steps without the middles of faces and of elements."""
    a, b, c = counts
    return (2 * a + 1) * (2 * b + 1) * (2 * c + 1) - a * b * c - (a + 1) * b * c - a * (b + 1) * c - a * b * (c + 1)


def ring(inner, outer, height):
    """at() of a quarter ring."""
    def at(u, v, w):
        r, t = inner + u * (outer - inner), v * np.pi / 2
        return np.column_stack([r * np.cos(t), r * np.sin(t), w * height])
    return at


def elliptic(inner, outer, height):
    """at() between two ellipses of half-axes (x, y)."""
    def at(u, v, w):
        a, b = (inner[k] + u * (outer[k] - inner[k]) for k in (0, 1))
        t = v * np.pi / 2
        return np.column_stack([a * np.cos(t), b * np.sin(t), w * height])
    return at


def blocks(problem, shape, nodes_wanted, path):
    """A model of the problem's part of about so many nodes, one block a solid. Leaves `path` (.inp)."""
    import shapes

    parts = problem.mapped()  # [(at, extents across, round and up, {face name of the problem: name of NAMES})]
    tries = []
    for scale in np.geomspace(0.01, 100, 800):
        counts = [tuple(max(1, round(scale * e * (nodes_wanted / 1e6) ** (1 / 3))) for e in extents) for _, extents, _ in parts]
        if problem.edges:  # a node at half the height
            counts = [(across, round_, 2 * max(1, round(up / 2))) for across, round_, up in counts]
        tries.append((abs(sum(map(node_count, counts)) / nodes_wanted - 1), counts))
    counts = min(tries)[1]
    points, cells, solids, sides, edges, offset = [], [], [], {}, {}, 0
    for solid, ((at, _, names), count) in enumerate(zip(parts, counts), 1):
        p, c, s = sector(at, count)
        for name, side in names.items():
            face = shapes.face_at(shape, problem.faces[name])
            quads = s[side]
            height = p[quads[:, :4], 2].mean(axis=1)  # a CAD face may be half of a block's side
            z = problem.faces[name][2]
            half = p[:, 2].max() / 2
            if name.endswith((" low", " high")):
                quads = quads[(height < half) == (z < half)]
            sides[face] = quads + offset
        for name, at_edge in (problem.edges or {}).items():
            nodes = np.unique(s["outer"])
            edges[shapes.edge_at(shape, at_edge)] = nodes[np.abs(p[nodes, 2] - at_edge[2]) < 1e-6] + offset
        points.append(p)
        cells.append(c + offset)
        solids.append(np.full(len(c), solid))
        offset += len(p)
    cells = np.vstack(cells)
    model = fe.Model(path, np.vstack(points), cells, sides, edges, solids=len(parts), facts={"cells": len(cells), "mesh_seconds": 0.0})
    return model, np.hstack(solids)
