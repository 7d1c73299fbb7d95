# HexFeatureWB - LGPL-2.1-or-later
"""Arrays to FreeCAD's Fem.FemMesh and its groups. The only place that knows SMESH's node order."""
import numpy as np

#: VTK / Abaqus order -> SMESH order: SMESH's first quadrilateral has its normal pointing out of the element.
HEX8 = [0, 3, 2, 1, 4, 7, 6, 5]
HEX20 = HEX8 + [11, 10, 9, 8, 15, 14, 13, 12, 16, 19, 18, 17]


def to_fem_mesh(result):
    """Build a Fem.FemMesh of a core result.

    result: hexfeature._core.Result, certified.
    Returns (mesh, ids): ids["faces"][CAD face number], ids["edges"][...], ids["vertices"][...] are sorted lists of
    face-element ids (faces) and node ids (edges, vertices); ids["solids"][n] are volume ids. Node i of the result
    has id i + 1.
    """
    import Fem

    second_order = len(result.hexes20) > 0
    hexes = np.asarray(result.hexes20 if second_order else result.hexes)[:, HEX20 if second_order else HEX8] + 1
    quads = np.asarray(result.quads8 if second_order else result.quads) + 1
    mesh = Fem.FemMesh()
    for number, (x, y, z) in enumerate(np.asarray(result.points).tolist(), 1):
        mesh.addNode(x, y, z, number)
    for number, nodes in enumerate(hexes.tolist(), 1):
        mesh.addVolume(nodes, number)
    first_quad = len(hexes) + 1
    for number, nodes in enumerate(quads.tolist(), first_quad):
        mesh.addFace(nodes, number)

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
    return mesh, ids


def first_middle(result):
    """Index of the first mid-side node (the number of points for a first-order mesh)."""
    if len(result.hexes20) == 0:
        return len(result.points)
    return int(np.asarray(result.hexes20)[:, 8:].min())


def add_groups(mesh, ids, names):
    """Add one group per CAD face, edge, vertex and solid.

    names: dict kind -> function from the core's number to the FreeCAD name ("Face7"), or None to leave it out.
    """
    kinds = {"faces": "Face", "edges": "Node", "vertices": "Node", "solids": "Volume"}
    for kind, element_type in kinds.items():
        for number, members in sorted(ids[kind].items()):
            name = names[kind](number)
            if name:
                mesh.addGroupElements(mesh.addGroup(name, element_type), members)
