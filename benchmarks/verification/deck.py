# HexFeatureWB - LGPL-2.1-or-later
"""The loads of a CalculiX deck as nodal forces, integrated here: what CalculiX leaves out of the reaction at a held node."""
import numpy as np

import model as fe

SIDES = [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]
EDGES = [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)]
MIDDLE = {frozenset(edge): 8 + k for k, edge in enumerate(EDGES)}
SIDES20 = [side + tuple(MIDDLE[frozenset((side[k], side[(k + 1) % 4]))] for k in range(4)) for side in SIDES]
CORNERS = np.array([(-1, -1, -1), (1, -1, -1), (1, 1, -1), (-1, 1, -1), (-1, -1, 1), (1, -1, 1), (1, 1, 1), (-1, 1, 1)], float)
NODES = np.vstack([CORNERS, [CORNERS[list(edge)].mean(axis=0) for edge in EDGES]])


class Deck:
    """points (n, 3) by node number - 1, cells (m, 20); external (n, 3): nodal forces of *CLOAD and *DLOAD (P, GRAV, CENTRIF);
    heat (n,): nodal heat flows of *DFLUX (S); sets: name of an *NSET -> node numbers."""

    def __init__(self, path, density):
        nodes, elements, loads, keyword = [], [], [], ""
        pending, self.sets, members = [], {}, []
        for line in open(path):
            line = line.strip()
            if line.startswith("**") or not line:
                continue
            if line.startswith("*"):
                keyword = line.upper().replace(" ", "")
                if keyword.startswith("*NSET,NSET="):
                    members = self.sets.setdefault(line.split("=")[1].strip(), [])
                continue
            row = [word.strip() for word in line.split(",")]
            if keyword.startswith("*NODE,"):
                nodes.append([float(word) for word in row[:4]])
            elif keyword.startswith("*ELEMENT,TYPE=C3D20"):
                pending += [int(word) for word in row if word]
                if len(pending) == 21:
                    elements.append(pending)
                    pending = []
            elif keyword.startswith("*NSET,NSET="):
                members += [int(word) for word in row if word.isdigit()]
            elif keyword.startswith(("*CLOAD", "*DLOAD", "*DFLUX")):
                loads.append((keyword[:6], row))
        numbers = np.array(nodes)
        self.points = np.zeros((int(numbers[:, 0].max()), 3))
        self.points[numbers[:, 0].astype(int) - 1] = numbers[:, 1:]
        self.cells = np.array(elements)[:, 1:] - 1
        self.row = {element[0]: k for k, element in enumerate(elements)}
        self.external = np.zeros_like(self.points)
        self.heat = np.zeros(len(self.points))
        self._add(loads, density)

    def _add(self, loads, density):
        sides = {}  # (kind, size) -> nodes of the element faces
        for kind, row in loads:
            if kind == "*CLOAD":
                self.external[int(row[0]) - 1, int(row[1]) - 1] += float(row[2])
            elif row[1].upper() == "GRAV":
                direction = np.array(row[3:6], float)
                self._add_body(lambda x: float(row[2]) * density * direction)
            elif row[1].upper() == "CENTRIF":
                at, axis = np.array(row[3:6], float), np.array(row[6:9], float)
                self._add_body(lambda x: density * float(row[2]) * ((x - at) - np.outer((x - at) @ axis, axis)))
            else:
                face = self.cells[self.row[int(row[0])]][list(SIDES20[int(row[1][1:]) - 1])]
                sides.setdefault((kind, float(row[2])), []).append(face)
        for (kind, value), faces in sides.items():
            faces = np.array(faces)
            for shape, slope_r, slope_s, weight in fe.face_rule(8):
                area = weight * np.cross(*(np.einsum("n,fnc->fc", slope, self.points[faces]) for slope in (slope_r, slope_s)))
                for n, share in enumerate(shape):
                    if kind == "*DFLUX":
                        np.add.at(self.heat, faces[:, n], value * share * np.linalg.norm(area, axis=1))
                    else:
                        np.add.at(self.external, faces[:, n], -value * share * area)

    def _add_body(self, density):
        """Forces of a force per volume, density(points (k, 3)), by 27 integration points."""
        g = np.sqrt(0.6)
        line = [(-g, 5 / 9), (0.0, 8 / 9), (g, 5 / 9)]
        corners = self.points[self.cells]
        for r, wr in line:
            for s, ws in line:
                for t, wt in line:
                    shape, slopes = _hex20(np.array([r, s, t]))
                    jacobian = np.linalg.det(np.einsum("nd,mnc->mdc", slopes, corners)) * wr * ws * wt
                    force = density(np.einsum("n,mnc->mc", shape, corners)) * jacobian[:, None]
                    for n, value in enumerate(shape):
                        np.add.at(self.external, self.cells[:, n], value * force)


def _hex20(x):
    """Shape functions (20,) and their slopes (20, 3) of the serendipity hexahedron."""
    def shape(x):
        factor = np.where(NODES == 0, 1 - x**2, 1 + NODES * x).prod(axis=1)
        return np.where(np.arange(20) < 8, factor * (NODES @ x - 2) / 8, factor / 4)

    step = 1e-20j  # complex step: exact slopes of a polynomial
    slopes = np.column_stack([(shape(x + step * np.eye(3)[d]) / 1e-20).imag for d in range(3)])
    return shape(x), slopes
