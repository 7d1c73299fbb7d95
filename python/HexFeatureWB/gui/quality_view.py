# HexFeatureWB - LGPL-2.1-or-later
"""The display mode Quality of a mesh: elements coloured by scaled Jacobian, bad ones alone, cut open, feature lines on it."""
import numpy as np
from pivy import coin

from .. import core, fem_mesh
from ..translate import tr
from . import scene

#: VTK order, outward
HEX_FACES = np.array([[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]])


class Elements:
    """What is needed to draw any part of a mesh fast: quality of each element and, for each element face, the one behind it.

    hexes (m, 8), points (n, 3), quality (m,), twin (m, 6): element on the other side, -1 outside; centres (m, 3);
    feature_lines (k, 2): indices of points.
    """

    def __init__(self, points, hexes, feature_lines):
        self.points, self.hexes, self.feature_lines = points, hexes, feature_lines
        self.quality = core.load().scaled_jacobians(points, hexes)
        self.centres = points[hexes].mean(axis=1)
        self.twin = self._twins()

    @classmethod
    def of_fem_mesh(cls, fem, feature_line_nodes=()):
        """feature_line_nodes: node ids, two an edge. Raises ValueError when there are no hexahedra, or other volumes besides."""
        arrays = fem_mesh.arrays_of(fem)
        ids = np.asarray(feature_line_nodes, dtype=np.int64).reshape(-1, 2)
        index = np.zeros(int(arrays["node_id"].max(initial=0)) + 1, dtype=np.int64)
        index[arrays["node_id"]] = np.arange(len(arrays["node_id"]))
        known = len(ids) and ids.max() < len(index)
        return cls(arrays["points"], arrays["hexes"][:, :8], index[ids] if known else arrays["feature_edges"])

    def _twins(self):
        corners = np.sort(self.hexes[:, HEX_FACES].reshape(-1, 4), axis=1).astype(np.int64)
        # Three corners tell faces of a conforming mesh apart; one number sorts faster than columns.
        base = int(corners.max(initial=0)) + 1
        if base < 2_000_000:
            key = (corners[:, 0] * base + corners[:, 1]) * base + corners[:, 2]
            order = np.argsort(key, kind="stable")
            same = key[order][1:] == key[order][:-1]
        else:
            order = np.lexsort((corners[:, 2], corners[:, 1], corners[:, 0]))
            same = (corners[order][1:, :3] == corners[order][:-1, :3]).all(axis=1)
        twin = np.full(len(corners), -1, dtype=np.int64)
        first, second = order[:-1][same], order[1:][same]
        twin[first], twin[second] = second // 6, first // 6
        return twin.reshape(-1, 6)

    def visible(self, below=1.0, axis=None, position=0.5, flip=False):
        """(m,) bool: elements of a scaled Jacobian below `below` (1: all) on one side of a plane across axis 0, 1 or 2 at
        `position` (0..1 of the mesh's extent). Elements are shown whole."""
        shown = np.ones(len(self.hexes), dtype=bool) if below >= 1 else self.quality < below
        if axis is not None and len(self.points):
            low, high = self.points[:, axis].min(), self.points[:, axis].max()
            at = low + position * (high - low)
            behind = self.centres[:, axis] <= at
            shown &= ~behind if flip else behind
        return shown

    def skin(self, shown):
        """(quads (k, 4) outward, element of each) around the shown elements."""
        outside = np.where(self.twin >= 0, ~shown[self.twin], True) & shown[:, None]
        element, face = np.nonzero(outside)
        return self.hexes[element[:, None], HEX_FACES[face]], element


class QualityNode:
    """The Coin node of the display mode; `update` draws it anew."""

    def __init__(self):
        self.root = coin.SoSeparator()
        self._elements = self._expected = self._arrays = None

    def expect(self, result):
        """The core's result of the very mesh that the object gets next: its arrays need not be asked of FreeCAD, node by node."""
        self._expected = np.array(result.points)[:fem_mesh.first_middle(result)], np.array(result.hexes, dtype=np.int64)

    def elements(self, obj):
        """The Elements of the object's mesh, kept until the mesh changes. Raises ValueError without one."""
        if self._elements is None:
            (points, hexes), self._arrays = self._arrays or ((), ()), None
            if len(hexes) and len(hexes) == obj.FemMesh.VolumeCount:
                # Node i of the result has the number i + 1.
                self._elements = Elements(points, hexes, np.array(obj.FeatureLineNodes, dtype=np.int64).reshape(-1, 2) - 1)
            else:
                self._elements = Elements.of_fem_mesh(obj.FemMesh, obj.FeatureLineNodes)
        return self._elements

    def forget(self):
        """The object has another mesh."""
        self._elements, self._arrays, self._expected = None, self._expected, None

    def update(self, obj, view):
        self.root.removeAllChildren()
        try:
            elements = self.elements(obj)
        except ValueError:  # no mesh yet
            return
        axis = {"X": 0, "Y": 1, "Z": 2}.get(view.CutAxis)
        shown = elements.visible(view.ShowBelow, axis, view.CutPosition / 100.0, view.CutFlip)
        quads, element = elements.skin(shown)
        points, quads = scene.compact(elements.points, quads)
        self.root.addChild(scene.faces(points, quads, scene.quality_levels(elements.quality[element]), scene.quality_colours()))
        self.root.addChild(scene.unpickable(scene.lines(points, scene.sides(quads), 1.0)))
        if view.FeatureLines:
            self.root.addChild(scene.unpickable(scene.lines(elements.points, elements.feature_lines, 3.0)))
        if view.ColourBar:
            self.root.addChild(scene.colour_bar(tr("scaled Jacobian") + "\n" + tr("1 is best")))
