# HexFeatureWB - LGPL-2.1-or-later
"""What the supports of a CalculiX deck leave free: rigid motions, whose size in a solution is rounding alone."""
import numpy as np


def significant(path, displacements):
    """Displacements (n, 3) without the rigid motions that the deck's supports leave free; NaN on bodies that are not held.

    A body is what elements, ties and contacts join. Nodes count by number - 1. In a deck with local systems (*TRANSFORM) a
    support is taken to hold its nodes in every direction: nothing is taken out.
    """
    points, elements, held, joined = _read(path)
    result = np.array(displacements, dtype=float)
    for body in _bodies(len(points), elements, joined):
        rows = [_rigid(points[node])[dof] for node, dof in held if body[node]]
        used = np.flatnonzero(body & np.isfinite(result).all(axis=1))
        scale = np.ptp(points[used], axis=0).max()
        modes = np.array(rows).reshape(-1, 6) * [1, 1, 1, 1 / scale, 1 / scale, 1 / scale]
        _, sizes, right = np.linalg.svd(modes, full_matrices=True)
        free = right[int((sizes > 1e-9 * max(sizes, default=0)).sum()):]
        if len(free) == 6:
            result[used] = np.nan
        elif len(free):
            motion = np.vstack([_rigid(p) for p in points[used]]) * [1, 1, 1, 1 / scale, 1 / scale, 1 / scale] @ free.T
            amount = np.linalg.lstsq(motion, result[used].ravel(), rcond=None)[0]
            result[used] -= (motion @ amount).reshape(-1, 3)
    return result


def _rigid(p):
    """(3, 6): displacement of a point in three translations and three small rotations."""
    x, y, z = p
    return np.array([[1, 0, 0, 0, z, -y], [0, 1, 0, -z, 0, x], [0, 0, 1, y, -x, 0.0]])


def _bodies(count, elements, joined):
    """Boolean masks over the nodes."""
    label = np.arange(count)
    members = np.zeros(count, dtype=bool)
    for nodes in elements:
        members[nodes.ravel()] = True
    changed = True
    while changed:  # the least label of each element's nodes, until none changes
        before = label.copy()
        for nodes in elements:
            np.minimum.at(label, nodes.ravel(), np.repeat(label[nodes].min(axis=1), nodes.shape[1]))
        label = label[label]
        changed = not np.array_equal(before, label)
    if joined:
        label[:] = 0
    return [members & (label == body) for body in np.unique(label[members])]


def _read(path):
    """points (n, 3), [node indices (m, k) per element type], [(node, axis)] held, whether bodies are tied or in contact."""
    nodes, blocks, sets, held, joined, turned, keyword, pending, name = {}, {}, {}, [], False, False, "", [], ""
    for line in open(path):
        line = line.strip()
        if not line or line.startswith("**"):
            continue
        if line.startswith("*"):
            keyword = line.upper().replace(" ", "")
            joined |= keyword.startswith(("*TIE", "*CONTACTPAIR"))
            turned |= keyword.startswith("*TRANSFORM")
            name = line.split("NSET=")[1].split(",")[0].strip() if keyword.startswith("*NSET,") else ""
            pending = []
            continue
        row = [word.strip() for word in line.split(",") if word.strip()]
        if keyword.startswith("*NODE,"):
            nodes[int(row[0])] = [float(word) for word in row[1:4]]
        elif keyword.startswith("*ELEMENT,TYPE=C3D"):
            length = 1 + int("".join(c for c in keyword.split("TYPE=C3D")[1].split(",")[0] if c.isdigit()))
            pending += [int(word) for word in row]
            if len(pending) >= length:
                blocks.setdefault(length, []).append(pending[1:])
                pending = []
        elif name:
            sets.setdefault(name, []).extend(int(word) for word in row if word.isdigit())
        elif keyword.startswith("*BOUNDARY"):
            first, last = int(row[1]), int(row[2]) if len(row) > 2 else int(row[1])
            members = [int(row[0])] if row[0].isdigit() else sets.get(row[0], [])
            held += [(node - 1, axis) for node in members for axis in range(3) if turned or first - 1 <= axis < last]
    points = np.zeros((max(nodes), 3))
    points[np.array(list(nodes)) - 1] = list(nodes.values())
    return points, [np.array(block) - 1 for block in blocks.values()], held, joined
