# HexFeatureWB - LGPL-2.1-or-later
"""Two places where FreeCAD's writer for CalculiX does not do hexahedra justice, mended while FreeCAD runs.

- A heat flux on hexahedra is lost without a word in FreeCAD 0.20 and 1.0: FemMesh.getccxVolumesByFace knows tetrahedra only.
  Here the search that FreeCAD itself uses for pressures finds the element faces.
- A force on a face is shared by the areas of flat triangles between an element face's nodes (FreeCAD says so in a FIXME), over the
  CAD face's area: on a round face the sum is up to several percent short, and each node's share is not the consistent one. Here
  the shape functions of the curved 8-node face are integrated.

Other meshers' meshes are written as FreeCAD does by itself. What a FreeCAD does not have is left alone.
"""
import functools
import math


def mend(concerned):
    """Put both in place; again is no harm, the first call counts. Does nothing where FreeCAD's FEM workbench is not installed.

    concerned(mesh object) -> bool: whose meshes are written with the mends.
    """
    try:
        from femmesh import meshsetsgetter, meshtools
    except ImportError:
        return
    getter = getattr(meshsetsgetter, "MeshSetsGetter", None)
    for name, mended in (("get_constraints_heatflux_faces", _with_hexahedra), ("get_constraints_force_nodeloads", _with_curved_quads)):
        original = getattr(getter, name, None)
        if original is not None and not hasattr(original, "mended"):
            method = functools.wraps(original)(mended(original, meshtools, concerned))
            method.mended = True
            setattr(getter, name, method)


def _with_hexahedra(original, meshtools, concerned):
    def method(self):
        original(self)
        if not concerned(self.mesh_object) or not self.femmesh.HexaCount:
            return
        for constraint in self.member.cons_heatflux:
            table = constraint.get("HeatFluxFaceTable")  # FreeCAD 1.1 has another, and finds hexahedra itself
            if not table or any(found for _, found in table):
                continue
            faces = [shape.Shape.getElement(name) for shape, names in constraint["Object"].References for name in names]
            faces = [face for face in faces if face.ShapeType == "Face"]
            elements = meshtools.get_femelement_table(self.femmesh)
            of_node = meshtools.get_femnodes_ele_table(self.femmesh.Nodes, elements)
            constraint["HeatFluxFaceTable"] = [
                (name, [tuple(found) for found in meshtools.get_ccxelement_faces_from_binary_search(
                    meshtools.get_bit_pattern_dict(elements, of_node, self.femmesh.getNodesByFace(face)))])
                for (name, _), face in zip(table, faces)]

    return method


def _with_curved_quads(original, meshtools, concerned):
    def method(self):
        flat = getattr(meshtools, "get_ref_facenodes_areas", None)
        if flat is None or not concerned(self.mesh_object):
            return original(self)
        meshtools.get_ref_facenodes_areas = functools.partial(_areas, flat)
        try:
            return original(self)
        finally:
            meshtools.get_ref_facenodes_areas = flat

    return method


def _areas(flat, femnodes_mesh, face_table):
    """FreeCAD's table [(node, area), ...]: of 8-node quads by their shape functions, of other element faces by `flat`."""
    curved = [nodes for nodes in face_table.values() if len(nodes) == 8]
    others = {face: nodes for face, nodes in face_table.items() if len(nodes) != 8}
    areas = flat(femnodes_mesh, others) if others or not curved else []
    for nodes in curved:
        areas += zip(nodes, areas_of_quad8([femnodes_mesh[node] for node in nodes]))
    return areas


def areas_of_quad8(points):
    """Integrals of the eight shape functions over a curved 8-node quadrilateral, by 3 x 3 Gauss points.

    points: eight (x, y, z), corners first, then the middles of sides 1-2, 2-3, 3-4, 4-1. Their sum is the area.
    """
    result = [0.0] * 8
    for shape, along_r, along_s, weight in _RULE:
        r, s = ([sum(slope * p[k] for slope, p in zip(slopes, points)) for k in range(3)] for slopes in (along_r, along_s))
        normal = (r[1] * s[2] - r[2] * s[1], r[2] * s[0] - r[0] * s[2], r[0] * s[1] - r[1] * s[0])
        area = weight * math.sqrt(sum(c * c for c in normal))
        result = [sum_so_far + value * area for sum_so_far, value in zip(result, shape)]
    return result


def _shape(r, s):
    """Shape functions of the 8-node quadrilateral and their slopes along r and s."""
    values, along_r, along_s = [], [], []
    for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
        values.append((1 + a * r) * (1 + b * s) * (a * r + b * s - 1) / 4)
        along_r.append(a * (1 + b * s) * (2 * a * r + b * s) / 4)
        along_s.append(b * (1 + a * r) * (2 * b * s + a * r) / 4)
    for a, b in ((0, -1), (1, 0), (0, 1), (-1, 0)):
        if a == 0:
            values.append((1 - r * r) * (1 + b * s) / 2)
            along_r.append(-r * (1 + b * s))
            along_s.append(b * (1 - r * r) / 2)
        else:
            values.append((1 + a * r) * (1 - s * s) / 2)
            along_r.append(a * (1 - s * s) / 2)
            along_s.append(-s * (1 + a * r))
    return values, along_r, along_s


_LINE = ((-math.sqrt(0.6), 5 / 9), (0.0, 8 / 9), (math.sqrt(0.6), 5 / 9))
_RULE = [(*_shape(r, s), v * w) for r, v in _LINE for s, w in _LINE]
