# HexFeatureWB - LGPL-2.1-or-later
"""Write .med, the format of SALOME and Code_Aster, by h5py.

Layout: MED 4.1 file format, without time steps: ENS_MAA holds nodes and elements with a family number each, FAS the
families; a family is a set of groups, positive for nodes, negative for elements. Coordinates and connectivity are stored
component by component. A MED hexahedron's first quad looks out of it, VTK's into it.
"""
import h5py
import numpy as np

STEP = "-0000000000000000001-0000000000000000001"
HEX_ORDER = [0, 3, 2, 1, 4, 7, 6, 5, 11, 10, 9, 8, 15, 14, 13, 12, 16, 19, 18, 17]
TYPES = {8: ("HE8", 308), 20: ("H20", 320)}, {4: ("QU4", 204), 8: ("QU8", 208)}


def write(mesh, path, name):
    """`mesh` is an api.Mesh; `name` is the mesh's in the file: FreeCAD looks for one named as the file is.
    Groups: SolidN of hexahedra and again by the solid's name, FaceN of quads, EdgeN and VertexN of nodes."""
    name = name[:64]  # MED allows no more
    second = mesh.order == 2
    hexes = np.asarray(mesh.hexes20 if second else mesh.hexes)
    quads = np.asarray(mesh.quads8 if second else mesh.quads)
    hexes = hexes[:, HEX_ORDER[:hexes.shape[1]]]
    node_families, node_groups = _node_families(mesh)
    face, solid = np.asarray(mesh.quad_face), np.asarray(mesh.hex_solid)
    last_face = int(face.max(initial=0))
    element_groups = {-int(f): [f"Face{f}"] for f in np.unique(face) if f > 0}
    named = mesh.solid_groups
    element_groups.update({-(last_face + int(s)): [f"Solid{s}"] + [name for name in named if s in named[name]] for s in np.unique(solid)})

    with h5py.File(path, "w") as file:
        _attributes(file.create_group("INFOS_GENERALES"), MAJ=4, MIN=1, REL=0)
        step = _mesh_group(file, name)
        nodes = step.create_group("NOE")
        _attributes(nodes, CGT=1, CGS=1, PFL=b"MED_NO_PROFILE_INTERNAL")
        _data(nodes, "COO", np.asarray(mesh.points).T.ravel(), len(mesh.points))
        _data(nodes, "FAM", node_families, len(mesh.points))
        elements = step.create_group("MAI")
        _attributes(elements, CGT=1)
        _elements(elements, TYPES[0][hexes.shape[1]], hexes, -(last_face + solid))
        _elements(elements, TYPES[1][quads.shape[1]], quads, -face)
        families = file.create_group(f"FAS/{name}")
        _attributes(families.create_group("FAMILLE_ZERO"), NUM=0)
        # MED visits families in the order of their creation, so the group must keep it.
        _families(families.create_group("NOEUD", track_order=True), node_groups)
        _families(families.create_group("ELEME", track_order=True), element_groups)


def _node_families(mesh):
    """Family number per node (0: none) and number -> group names."""
    names = {}
    for (a, b), edge in zip(np.asarray(mesh.feature_edges).tolist(), np.asarray(mesh.feature_edge_cad).tolist()):
        names.setdefault(a, set()).add(f"Edge{edge}")
        names.setdefault(b, set()).add(f"Edge{edge}")
    dim, entity = np.asarray(mesh.node_dim), np.asarray(mesh.node_entity)
    for node in np.flatnonzero((dim < 2) & (entity > 0)).tolist():
        names.setdefault(node, set()).add(f"{'Edge' if dim[node] else 'Vertex'}{entity[node]}")
    numbers, families = {}, np.zeros(len(mesh.points), dtype=np.int32)
    for node in sorted(names):
        families[node] = numbers.setdefault(tuple(sorted(names[node])), len(numbers) + 1)
    return families, {number: groups for groups, number in numbers.items()}


def _mesh_group(file, name):
    group = file.create_group(f"ENS_MAA/{name}")
    _attributes(group, DIM=3, ESP=3, REP=0, SRT=0, TYP=0, NXI=-1, NXT=-1, DES=b"HexFeatureWB", NOM=b"", UNI=b"", UNT=b"")
    step = group.create_group(STEP)
    _attributes(step, CGT=1, NDT=-1, NOR=-1, NXI=-1, NXT=-1, PVI=-1, PVT=-1, PDT=-1.0)
    return step


def _elements(parent, kind, cells, families):
    name, geometry = kind
    group = parent.create_group(name)
    _attributes(group, CGT=1, CGS=1, GEO=geometry, PFL=b"MED_NO_PROFILE_INTERNAL")
    _data(group, "NOD", (cells.T.ravel() + 1).astype(np.int32), len(cells))
    _data(group, "FAM", families.astype(np.int32), len(cells))


def _families(parent, groups):
    for number, names in groups.items():
        family = parent.create_group(f"FAM_{number}_{'_'.join(names)}"[:64])
        _attributes(family, NUM=number)
        group = family.create_group("GRO")
        _attributes(group, NBR=len(names))
        texts = group.create_dataset("NOM", (len(names),), dtype="80int8")
        for i, text in enumerate(names):
            texts[i] = np.frombuffer(text.encode()[:80].ljust(80, b"\0"), dtype=np.int8)


def _data(group, name, values, count):
    _attributes(group.create_dataset(name, data=values), CGT=1, NBR=count)


def _attributes(item, **values):
    for name, value in values.items():
        item.attrs[name] = np.int32(value) if isinstance(value, int) else np.bytes_(value or b"\0") if isinstance(value, bytes) else value
