# HexFeatureWB - LGPL-2.1-or-later
"""Whether FreeCAD's constraints, which look for elements by geometry, find on every CAD face just the ones of its group."""
import numpy as np

#: FreeCAD takes what is nearer to a face than the face's own tolerance, which is not below 1e-7.
NEAR = 9e-8


def differing_groups(result, fem, shape, ids):
    """{face number: (found, ours)} for the faces where FreeCAD finds others than ours; empty when all is well.

    result: the core's; the rest as of `check_groups`. For one solid whose nodes lie on their CAD entities an element is found on
    a face when each of its nodes is known to lie on that face, its edges or its vertices: that takes no search. FreeCAD's own,
    seconds for 100,000 elements, is made only on faces where this says that something differs.
    """
    report = result.report()
    # Mid-side nodes farther off have no place on the CAD, so their elements are found on no face here.
    if len(shape.Solids) != 1 or not report["faithfulness"]["largest_node_deviation"] < NEAR:
        return check_groups(fem, shape, ids)
    quads = np.asarray(result.quads8 if len(result.hexes20) else result.quads)
    found = elements_on_faces(quads, np.asarray(result.node_dim), np.asarray(result.node_entity), faces_of_places(shape))
    ours = np.asarray(result.quad_face)
    none = np.zeros(0, dtype=int)
    doubtful = [k for k in range(1, len(shape.Faces) + 1) if not np.array_equal(found.get(k, none), np.flatnonzero(ours == k))]
    return check_groups(fem, shape, ids, doubtful)


def elements_on_faces(quads, dim, entity, faces_of):
    """{face number: indices of the quads all of whose nodes lie on it, sorted}.

    quads (n, 4 or 8); dim, entity (nodes,): 0 vertex, 1 edge, 2 face, 3 none, and its number; faces_of as by `faces_of_places`.
    """
    nodes = quads.ravel()
    quad = np.repeat(np.arange(len(quads)), quads.shape[1])
    most = 1 + max(int(faces.max(initial=0)) for _, faces in faces_of)
    pairs = []  # one number a (quad, face), as often as nodes of the quad lie on the face
    for d, (start, faces) in enumerate(faces_of):
        at = np.flatnonzero(dim[nodes] == d)
        number = entity[nodes[at]]
        count = start[number + 1] - start[number]
        within = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count)
        pairs.append(np.repeat(quad[at], count) * most + faces[np.repeat(start[number], count) + within])
    pairs, times = np.unique(np.concatenate(pairs), return_counts=True)
    pairs = pairs[times == quads.shape[1]]
    return {face: pairs[pairs % most == face] // most for face in np.unique(pairs % most).tolist()}


def faces_of_places(shape):
    """For vertices, edges and faces (start, faces): the faces of number n are faces[start[n]:start[n + 1]]."""
    tables = []
    for items, of_face in ((shape.Vertexes, "Vertexes"), (shape.Edges, "Edges")):
        numbers = {}
        for number, item in enumerate(items, 1):
            numbers.setdefault(item.hashCode(), []).append((number, item))
        faces = [set() for _ in range(len(items) + 1)]
        for k, face in enumerate(shape.Faces, 1):
            for item in getattr(face, of_face):
                faces[next(n for n, same in numbers[item.hashCode()] if same.isSame(item))].add(k)
        tables.append(_flat(faces))
    tables.append(_flat([set()] + [{k} for k in range(1, len(shape.Faces) + 1)]))
    return tables


def _flat(sets):
    start = np.concatenate([[0], np.cumsum([len(s) for s in sets])])
    return start, np.array([k for s in sets for k in sorted(s)], dtype=int)


def check_groups(fem, shape, ids, faces=None):
    """Compare faces' groups with what FreeCAD's own search (getFacesByFace) finds.

    fem: Fem.FemMesh with ids by `fem_mesh.to_fem_mesh`; shape: the one that was meshed; faces: numbers, None for all.
    Returns {face number: (found, ours)} for the faces that differ; empty when all is well.
    """
    different = {}
    for number in range(1, len(shape.Faces) + 1) if faces is None else faces:
        ours = ids["faces"].get(number, [])
        found = fem.getFacesByFace(shape.Faces[number - 1])
        if sorted(found) != ours:
            different[number] = (len(set(found) & set(ours)), len(ours))
    return different
