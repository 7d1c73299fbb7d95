# HexFeatureWB - LGPL-2.1-or-later
"""Whether FreeCAD's constraints, which look for elements by geometry, find on every CAD face just the ones of its group."""
import time

import numpy as np

#: FreeCAD takes what is nearer to a face than the face's own tolerance, which is not below 1e-7.
NEAR = 9e-8


class GroupCheck:
    """Finds the faces where FreeCAD would find other elements than ours, by and by, so that a window stays alive: call `work` until it is
    True.

    FreeCAD's search measures every node near a face, and one call of it takes many seconds on a face with many holes. Here an element is
    on a face, without measuring, when each of its nodes is known to lie on that face, its edges or its vertices. Measured as FreeCAD does
    are only nodes that are not known to: those of the elements of ours that are missing so far; and, where several solids may touch, those
    of every element in the face's box.

    result: the core's; shape: the one that was meshed.
    different: {face number: (found, ours)}; empty when all is well.
    """

    def __init__(self, result, shape):
        self.different = {}
        self._shape, self._done = shape, 0
        self._points = np.asarray(result.points)
        self._quads = np.asarray(result.quads8 if len(result.hexes20) else result.quads)
        self._ours = np.asarray(result.quad_face)
        self._dim, self._entity = np.asarray(result.node_dim), np.asarray(result.node_entity)
        # Nodes that are off their places are known to be nowhere. (Mid-side nodes farther off have no place.)
        if not result.report()["faithfulness"]["largest_node_deviation"] < NEAR:
            self._dim = np.full(len(self._dim), 3)
        self._everywhere = len(shape.Solids) != 1
        self._parts = self._look()

    @property
    def fraction(self):
        return self._done / max(1, len(self._shape.Faces))

    def work(self, seconds):
        """Go on for about so long; True when every face has been looked at."""
        end = time.monotonic() + seconds
        for _ in self._parts:
            if time.monotonic() > end:
                return False
        return True

    def _look(self):
        faces_of = faces_of_places(self._shape)
        yield
        known = elements_on_faces(self._quads, self._dim, self._entity, faces_of)
        none = np.zeros(0, dtype=int)
        for number, face in enumerate(self._shape.Faces, 1):
            ours, found = np.flatnonzero(self._ours == number), known.get(number, none)
            if self._everywhere or not np.array_equal(found, ours):
                there = self._near(face) if self._everywhere else ours
                there = np.setdiff1d(there, found)
                if len(there):
                    measured = _Measured(face, self._points, self._on(number, faces_of))
                    more = []
                    for quad in there.tolist():
                        if all(map(measured.holds, self._quads[quad].tolist())):
                            more.append(quad)
                        yield
                    found = np.union1d(found, np.array(more, dtype=int))
                if not np.array_equal(found, ours):
                    self.different[number] = len(np.intersect1d(found, ours)), len(ours)
            self._done = number
            yield

    def _on(self, number, faces_of):
        """Which nodes are known to lie on a face."""
        on = np.zeros(len(self._dim), dtype=bool)
        for dim, (start, faces) in enumerate(faces_of):
            places = np.repeat(np.arange(len(start) - 1), np.diff(start))[faces == number] if len(faces) else []
            on |= (self._dim == dim) & np.isin(self._entity, places)
        return on

    def _near(self, face):
        """The elements all of whose nodes are in a face's box and, if it is plane, in its plane."""
        box, within = face.BoundBox, max(face.Tolerance, NEAR)
        low, high = (np.array([getattr(box, axis + end) for axis in "XYZ"]) for end in ("Min", "Max"))
        near = ((self._points > low - within) & (self._points < high + within)).all(axis=1)
        if hasattr(face.Surface, "Axis") and face.Surface.TypeId == "Part::GeomPlane":
            near &= np.abs((self._points - np.array(face.Surface.Position)) @ np.array(face.Surface.Axis)) < 2 * within
        return np.flatnonzero(near[self._quads].all(axis=1))


class _Measured:
    """Whether nodes lie on a face as FreeCAD's search has it; each is measured once, those `known` to never."""

    def __init__(self, face, points, known):
        self._face, self._points, self._known, self._holds = face, points, known, {}

    def holds(self, node):
        if self._known[node]:
            return True
        if node not in self._holds:
            import Part

            self._holds[node] = Part.Vertex(*self._points[node].tolist()).distToShape(self._face)[0] < self._face.Tolerance
        return self._holds[node]


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


def check_groups(fem, shape, ids):
    """The same by FreeCAD's own search (getFacesByFace): tells that GroupCheck is right, but may take minutes.

    fem: Fem.FemMesh with ids by `fem_mesh.to_fem_mesh`; shape: the one that was meshed.
    Returns {face number: (found, ours)} for the faces that differ; empty when all is well.
    """
    different = {}
    for number, face in enumerate(shape.Faces, 1):
        ours, found = ids["faces"].get(number, []), fem.getFacesByFace(face)
        if sorted(found) != ours:
            different[number] = (len(set(found) & set(ours)), len(ours))
    return different
