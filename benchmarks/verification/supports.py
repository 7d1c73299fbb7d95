# HexFeatureWB - LGPL-2.1-or-later
"""What the supports of a CalculiX deck leave free: rigid motions, whose size in a solution is rounding alone."""
import numpy as np


def significant(path, displacements):
    """Displacements (n, 3) without the rigid motions that the deck's supports leave free; NaN on bodies that are not held.

    A body is what elements, ties and contacts join. Nodes count by number - 1. Supports in local systems (*TRANSFORM) hold their
    nodes along the local axes.
    """
    points, elements, held, joined = _read(path)
    result = np.array(displacements, dtype=float)
    for body in _bodies(len(points), elements, joined):
        rows = [direction @ _rigid(points[node]) for node, direction in held if body[node]]
        used = np.flatnonzero(body & np.isfinite(result).all(axis=1))
        scale = np.ptp(points[used], axis=0).max()
        modes = np.array(rows).reshape(-1, 6) * [1, 1, 1, 1 / scale, 1 / scale, 1 / scale]
        _, sizes, right = np.linalg.svd(np.linalg.qr(modes, mode="r"), full_matrices=True)  # of 6 rows, however many are held
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


def _axes(kind, a, b, p):
    """The local axes of a *TRANSFORM at a point, as rows. R: a lies on the x' axis, b in the x'y' plane; C: a and b lie on the
    axis, and the axes are the radial, the tangential and the axial one. Source: CalculiX CrunchiX manual, "*TRANSFORM"."""
    if kind == "R":
        first, third = a, np.cross(a, b)
    else:
        third = b - a
        first = (p - a) - (p - a) @ third / (third @ third) * third
        if np.linalg.norm(first) < 1e-10:  # on the axis no direction is the radial one: any
            first = np.cross(third, np.eye(3)[np.abs(third).argmin()])
    first, third = first / np.linalg.norm(first), third / np.linalg.norm(third)
    return np.array([first, np.cross(third, first), third])


def _read(path):
    """points (n, 3), [node indices (m, k) per element type], [(node, direction)] held, whether bodies are tied or in contact."""
    nodes, blocks, sets, held, transforms = {}, {}, {}, [], {}
    joined, keyword, given, pending = False, "", {}, []
    for line in open(path):
        line = line.strip().upper()  # CalculiX tells no capitals
        if not line or line.startswith("**"):
            continue
        row = [word.strip() for word in line.split(",") if word.strip()]
        if line.startswith("*"):
            keyword, pending = row[0], []
            given = {name.strip(): value.strip() for name, _, value in (word.partition("=") for word in row[1:])}
            joined |= keyword in ("*TIE", "*CONTACT PAIR")
        elif keyword == "*NODE":
            nodes[int(row[0])] = [float(word) for word in row[1:4]]
        elif keyword == "*ELEMENT" and given["TYPE"].startswith("C3D"):
            pending += [int(word) for word in row]
            if len(pending) > int("".join(c for c in given["TYPE"][3:] if c.isdigit())):
                blocks.setdefault(len(pending), []).append(pending[1:])
                pending = []
        elif keyword == "*NSET":
            members = sets.setdefault(given["NSET"], [])
            for word in row:
                members += [int(word)] if word.isdigit() else sets[word]
        elif keyword == "*TRANSFORM":
            a, b = np.array(row, dtype=float).reshape(2, 3)
            transforms.update((node, (given.get("TYPE", "R"), a, b)) for node in sets[given["NSET"]])
        elif keyword == "*BOUNDARY":
            first, last = int(row[1]), int(row[2]) if len(row) > 2 else int(row[1])
            members = [int(row[0])] if row[0].isdigit() else sets[row[0]]
            held += [(node, axis) for node in members for axis in range(first - 1, min(last, 3))]
    points = np.zeros((max(nodes), 3))
    points[np.array(list(nodes)) - 1] = list(nodes.values())
    directions = [(_axes(*transforms[node], points[node - 1]) if node in transforms else np.eye(3))[axis] for node, axis in held]
    elements = [np.array(block) - 1 for block in blocks.values()]
    return points, elements, [(node - 1, direction) for (node, _), direction in zip(held, directions)], joined
