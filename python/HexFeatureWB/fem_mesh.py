# HexFeatureWB - LGPL-2.1-or-later
"""Arrays to FreeCAD's Fem.FemMesh and its groups. The only place that knows SMESH's node order."""
import collections
import itertools
import re
import time

import numpy as np

#: VTK / Abaqus order -> SMESH order: SMESH's first quadrilateral has its normal pointing out of the element.
HEX8 = [0, 3, 2, 1, 4, 7, 6, 5]
HEX20 = HEX8 + [11, 10, 9, 8, 15, 14, 13, 12, 16, 19, 18, 17]


def to_fem_mesh(result):
    """Build a Fem.FemMesh of a core result in one go. Returns (mesh, ids) as of FemMeshBuilder."""
    builder = FemMeshBuilder(result)
    while not builder.work(3600):
        pass
    return builder.mesh, builder.ids


class FemMeshBuilder:
    """Builds a Fem.FemMesh of a core result by and by, so that a window stays alive meanwhile: call `work` until it is True.

    result: hexfeature._core.Result, certified.
    names: those of groups, one for each CAD face, edge, vertex and solid (see `_groups`); None for a mesh without groups.
    mesh: node i of the result has id i + 1, then hexahedron i, and behind the hexahedra quad i.
    ids: ["faces"][CAD face number], ["edges"][...], ["vertices"][...] are sorted lists of face-element ids (faces) and node ids
    (edges, vertices); ["solids"][n] are volume ids.
    """

    CHUNK = 2000  # entities between two looks at the clock

    def __init__(self, result, names=None):
        import Fem

        self.mesh = Fem.FemMesh()
        second_order = len(result.hexes20) > 0
        hexes = np.asarray(result.hexes20 if second_order else result.hexes)[:, HEX20 if second_order else HEX8] + 1
        quads = np.asarray(result.quads8 if second_order else result.quads) + 1
        points = np.asarray(result.points)
        self.ids = _group_ids(result, len(hexes) + 1)
        self._done, self._all = 0, len(points) + len(hexes) + len(quads)
        self._parts = self._chunks(points, hexes, quads)
        if names is not None:
            self._all += sum(len(members) for of_kind in self.ids.values() for members in of_kind.values())
            self._parts = itertools.chain(self._parts, self._groups(names))

    def _chunks(self, points, hexes, quads):
        # SMESH numbers nodes and elements by itself in the order they come. Given numbers cost as much again: addNode fails first to
        # read its arguments without one.
        for add, rows, first, columns in (
            (self.mesh.addNode, points, 1, True), (self.mesh.addVolume, hexes, 1, False), (self.mesh.addFace, quads, len(hexes) + 1, False)
        ):
            for at in range(0, len(rows), self.CHUNK):
                some = rows[at:at + self.CHUNK]
                last = collections.deque(map(add, *(some.T.tolist() if columns else [some.tolist()])), maxlen=1)[0]
                if last != first + at + len(some) - 1:
                    raise RuntimeError("SMESH gave the number %d where %d was next" % (last, first + at + len(some) - 1))
                self._done += len(some)
                yield

    def _groups(self, names):
        """names: dict kind -> function from the core's number to the FreeCAD name ("Face7"), or None to leave it out."""
        kinds = {"faces": "Face", "edges": "Node", "vertices": "Node", "solids": "Volume"}
        for kind, element_type in kinds.items():
            for number, members in sorted(self.ids[kind].items()):
                name = names[kind](number)
                if name:
                    group = self.mesh.addGroup(name, element_type)
                    for at in range(0, len(members), self.CHUNK):
                        self.mesh.addGroupElements(group, members[at:at + self.CHUNK])
                        yield
                self._done += len(members)

    @property
    def fraction(self):
        return self._done / max(1, self._all)

    def work(self, seconds):
        """Go on for about so long; True when the mesh is complete, which it never is after an exception from here."""
        end = time.monotonic() + seconds
        for _ in self._parts:
            if time.monotonic() > end:
                break
        return self._done == self._all


def _group_ids(result, first_quad):
    ids = {"faces": {}, "edges": {}, "vertices": {}, "solids": {}}
    quad_face = np.asarray(result.quad_face)
    for face in np.unique(quad_face[quad_face > 0]).tolist():
        ids["faces"][face] = (np.flatnonzero(quad_face == face) + first_quad).tolist()
    dim, entity = np.asarray(result.node_dim), np.asarray(result.node_entity)
    for vertex in np.unique(entity[dim == 0]).tolist():
        ids["vertices"][vertex] = (np.flatnonzero((dim == 0) & (entity == vertex)) + 1).tolist()
    on_edge = {}
    for pair, edge in zip(np.asarray(result.feature_edges).tolist(), np.asarray(result.feature_edge_cad).tolist()):
        on_edge.setdefault(edge, set()).update(pair)
    middles = np.flatnonzero((dim == 1) & (np.arange(len(dim)) >= first_middle(result)))
    for node in middles.tolist():
        on_edge.setdefault(int(entity[node]), set()).add(node)
    ids["edges"] = {edge: sorted(n + 1 for n in nodes) for edge, nodes in sorted(on_edge.items())}
    solids = np.asarray(result.hex_solid)
    for solid in np.unique(solids).tolist():
        ids["solids"][solid] = (np.flatnonzero(solids == solid) + 1).tolist()
    return ids


def first_middle(result):
    """Index of the first mid-side node (the number of points for a first-order mesh)."""
    if len(result.hexes20) == 0:
        return len(result.points)
    return int(np.asarray(result.hexes20)[:, 8:].min())


def feature_line_nodes(result):
    """Node ids (two an edge, flat) of the boundary edges between quads of different charts: the feature lines on the mesh.
    A mesh made without charts has its CAD edges there."""
    quads, chart = np.asarray(result.quads), np.asarray(result.quad_chart)
    edges = np.asarray(result.feature_edges)
    if len(chart) == len(quads) and len(quads) and chart.max() > 0:
        edge_of = np.sort(np.stack([quads, np.roll(quads, -1, axis=1)], axis=2).reshape(-1, 2), axis=1)
        charts = np.repeat(chart, 4)
        order = np.lexsort((charts, edge_of[:, 1], edge_of[:, 0]))
        edge_of, charts = edge_of[order], charts[order]
        border = (edge_of[1:] == edge_of[:-1]).all(axis=1) & (charts[1:] != charts[:-1])
        edges = edge_of[1:][border]
    return (edges.ravel() + 1).tolist()


def arrays_of(fem):
    """The arrays of a Fem.FemMesh of hexahedra and quads with our groups, as a dict of the keywords of the core's
    `result_from_arrays`; also node ids and element ids ("node_id", "hex_id") in the arrays' order.

    Raises ValueError when it holds no hexahedra, or other volumes besides.
    """
    nodes = fem.Nodes
    node_id = np.fromiter(nodes.keys(), dtype=np.int64, count=len(nodes))
    points = np.array([tuple(p) for p in nodes.values()], dtype=float).reshape(-1, 3)
    index = np.zeros(int(node_id.max(initial=0)) + 1, dtype=np.int64)
    index[node_id] = np.arange(len(node_id))
    hex_id = np.array(fem.Volumes, dtype=np.int64)
    volumes = [fem.getElementNodes(int(v)) for v in hex_id]
    width = len(volumes[0]) if volumes else 0
    if width not in (8, 20) or any(len(v) != width for v in volumes):
        raise ValueError("the mesh has no hexahedra, or other volumes besides")
    back = np.argsort(HEX20 if width == 20 else HEX8)
    hexes = index[np.array(volumes)][:, back]
    quad_id = [f for f in fem.Faces if len(fem.getElementNodes(f)) == (8 if width == 20 else 4)]
    quads = index[np.array([fem.getElementNodes(f) for f in quad_id], dtype=np.int64).reshape(len(quad_id), -1)]
    return {"points": points, "hexes": hexes, "quads": quads, "node_id": node_id, "hex_id": hex_id,
            **_cad_of_groups(fem, len(points), index, hexes, hex_id, quads, np.array(quad_id, dtype=np.int64))}


def _cad_of_groups(fem, point_count, index, hexes, hex_id, quads, quad_id):
    """CAD numbers from the groups FaceN, EdgeN, VertexN, SolidN."""
    members = {"Face": {}, "Edge": {}, "Vertex": {}, "Solid": {}}
    for group in fem.Groups:
        match = re.fullmatch(r"(Face|Edge|Vertex|Solid)(\d+)", fem.getGroupName(group))
        if match:
            members[match[1]][int(match[2])] = np.array(fem.getGroupElements(group), dtype=np.int64)
    quad_face, hex_solid = np.zeros(len(quads), dtype=int), np.ones(len(hexes), dtype=int)
    dim, entity = np.full(point_count, 3), np.zeros(point_count, dtype=int)
    for number, ids in members["Face"].items():
        quad_face[np.isin(quad_id, ids)] = number
    on_face = np.repeat(quad_face, quads.shape[1])
    dim[quads.ravel()], entity[quads.ravel()] = 2, on_face
    for number, ids in members["Solid"].items():
        hex_solid[np.isin(hex_id, ids)] = number
    corners = quads[:, :4]
    sides = np.unique(np.sort(np.stack([corners, np.roll(corners, -1, axis=1)], axis=2).reshape(-1, 2), axis=1), axis=0)
    feature_edges, feature_edge_cad = [np.zeros((0, 2), dtype=int)], []
    for number, ids in sorted(members["Edge"].items()):
        on = np.zeros(point_count, dtype=bool)
        on[index[ids]] = True
        dim[on], entity[on] = 1, number
        along = sides[on[sides].all(axis=1)]
        feature_edges.append(along)
        feature_edge_cad += [number] * len(along)
    for number, ids in members["Vertex"].items():
        dim[index[ids]], entity[index[ids]] = 0, number
    return {"quad_face": quad_face, "hex_solid": hex_solid, "node_dim": dim, "node_entity": entity,
            "feature_edges": np.concatenate(feature_edges), "feature_edge_cad": np.array(feature_edge_cad, dtype=int)}
