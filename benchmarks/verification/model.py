# HexFeatureWB - LGPL-2.1-or-later
"""A finite-element model that does not know which mesher made it: nodes, elements, and the CAD faces and edges by number.

Both meshers' .inp files use the same names (NSET FaceN, EdgeN; SURFACE FaceN; ELSET SolidN, Nodes), so that one deck solves both.
"""
from dataclasses import dataclass, field

import numpy as np

#: Local corners and mid-sides of an element's faces S1, S2, ... as CalculiX numbers them: what a load on a face needs.
TET10_SIDES = np.array([[0, 1, 2, 4, 5, 6], [0, 3, 1, 7, 8, 4], [1, 3, 2, 8, 9, 5], [2, 3, 0, 9, 7, 6]])


@dataclass
class Model:
    """points (n, 3); cells (m, 8 | 20 | 10); sides: CAD face number -> (k, 4 | 8 | 6) node indices of its element faces,
    corners first; edges: CAD edge number -> node indices; path: the .inp file; names: the problem's name -> CAD number."""

    path: str
    points: np.ndarray
    cells: np.ndarray
    sides: dict
    edges: dict
    faces_by_name: dict = field(default_factory=dict)
    edges_by_name: dict = field(default_factory=dict)
    solids: int = 1
    facts: dict = field(default_factory=dict)

    def face(self, name):
        """The set's and surface's name in the .inp file."""
        return "Face%d" % self.faces_by_name[name]

    def edge(self, name):
        return "Edge%d" % self.edges_by_name[name]

    def nodes(self, name):
        """Sorted node indices on a CAD face."""
        return np.unique(self.sides[self.faces_by_name[name]])

    def solid_nodes(self):
        """Number of nodes that elements use; the degrees of freedom are three times that."""
        return len(np.unique(self.cells))

    def traction_forces(self, name, traction):
        """Consistent nodal forces of a traction on a CAD face.

        traction: function of points (k, 3) -> (k, 3), force per area. Returns (n, 3): the integral of shape function times
        traction over the element faces, by Gauss points on the isoparametric face.
        """
        sides = self.sides[self.faces_by_name[name]]
        forces = np.zeros_like(self.points)
        for shape, slope_r, slope_s, weight in face_rule(sides.shape[1]):
            x = np.einsum("n,fnc->fc", shape, self.points[sides])
            tangent_r = np.einsum("n,fnc->fc", slope_r, self.points[sides])
            tangent_s = np.einsum("n,fnc->fc", slope_s, self.points[sides])
            area = np.linalg.norm(np.cross(tangent_r, tangent_s), axis=1) * weight
            for n, value in enumerate(shape):
                np.add.at(forces, sides[:, n], value * area[:, None] * traction(x))
        return forces


def face_rule(count):
    """[(shape functions, slopes along r, along s, weight)] at the integration points of a face of 4, 8 or 6 nodes."""
    if count == 6:
        points = [(1 / 6, 1 / 6), (2 / 3, 1 / 6), (1 / 6, 2 / 3)]  # of degree 2, enough for a shape function times a constant
        a, b = 0.091576213509771, 0.445948490915965
        points = [(a, a), (1 - 2 * a, a), (a, 1 - 2 * a), (b, b), (1 - 2 * b, b), (b, 1 - 2 * b)]
        weights = [0.054975871827661] * 3 + [0.1116907948390057] * 3
        return [(*_triangle6(r, s), w) for (r, s), w in zip(points, weights)]
    g = np.sqrt(0.6)
    line = [(-g, 5 / 9), (0.0, 8 / 9), (g, 5 / 9)]
    shape = _quad4 if count == 4 else _quad8
    return [(*shape(r, s), v * w) for r, v in line for s, w in line]


def _triangle6(r, s):
    t = 1 - r - s
    shape = [t * (2 * t - 1), r * (2 * r - 1), s * (2 * s - 1), 4 * t * r, 4 * r * s, 4 * s * t]
    slope_r = [1 - 4 * t, 4 * r - 1, 0, 4 * (t - r), 4 * s, -4 * s]
    slope_s = [1 - 4 * t, 0, 4 * s - 1, -4 * r, 4 * r, 4 * (t - s)]
    return np.array(shape), np.array(slope_r), np.array(slope_s)


def _quad4(r, s):
    a, b = np.array([-1, 1, 1, -1.0]), np.array([-1, -1, 1, 1.0])
    return (1 + a * r) * (1 + b * s) / 4, a * (1 + b * s) / 4, b * (1 + a * r) / 4


def _quad8(r, s):
    a, b = np.array([-1, 1, 1, -1.0]), np.array([-1, -1, 1, 1.0])
    corner = (1 + a * r) * (1 + b * s) * (a * r + b * s - 1) / 4
    corner_r, corner_s = a * (1 + b * s) * (2 * a * r + b * s) / 4, b * (1 + a * r) * (2 * b * s + a * r) / 4
    middle = np.array([(1 - r * r) * (1 - s), (1 + r) * (1 - s * s), (1 - r * r) * (1 + s), (1 - r) * (1 - s * s)]) / 2
    middle_r = np.array([-2 * r * (1 - s), 1 - s * s, -2 * r * (1 + s), -(1 - s * s)]) / 2
    middle_s = np.array([-(1 - r * r), -2 * s * (1 + r), 1 - r * r, -2 * s * (1 - r)]) / 2
    return np.r_[corner, middle], np.r_[corner_r, middle_r], np.r_[corner_s, middle_s]
