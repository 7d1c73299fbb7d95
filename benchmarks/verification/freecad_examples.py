#!/usr/bin/python3
# HexFeatureWB - LGPL-2.1-or-later
"""FreeCAD's own FEM examples with our mesh: benchmarks/verification/freecad_examples.py OUT_DIR [EXAMPLE ...]

Each example with solids is solved three times: with the mesh that comes with it, with ours (20-node hexahedra), and with Gmsh's
10-node tetrahedra of about twice as many nodes as ours, since the examples' own meshes are coarse. Compared are the largest
displacement (without rigid motions that the example leaves free), the first frequency, the buckling factor, or with heat the
displacement and the temperature. Leaves OUT_DIR/examples.json. Exit code 1 when ours differs from the known or the fine one's
by more than 2%.
"""
import importlib
import json
import os
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parents[1] / "python")]
sys.path += ["/usr/lib/freecad" + folder for folder in ("-python3/lib", "/lib", "/Mod", "/Ext")]
sys.path += [str(path) for folder in ("/usr/lib/freecad/Mod", "/usr/share/freecad/Mod") for path in sorted(Path(folder).glob("*"))]
import FreeCAD  # noqa: E402

import numpy as np  # noqa: E402

import arguments  # noqa: E402
import calculix  # noqa: E402
import meshers  # noqa: E402
import supports  # noqa: E402
from HexFeatureWB import analysis, core, fem_mesh, writer_mends  # noqa: E402

#: Timoshenko's cantilever, 8 x 1 x 1 m, 9 MN
CANTILEVER = 9e6 * 8000**3 / (3 * 210000 * 1000**4 / 12) + 1.2 * 9e6 * 8000 / (210000 / 2.6 * 1000**2)
#: Every example with solids that CalculiX solves -> its known displacement, frequency or factor, where there is one.
EXAMPLES = {
    "boxanalysis_static": None,
    "boxanalysis_frequency": None,
    "ccx_buckling_flexuralbuckling": None,
    "ccx_cantilever_ele_hexa20": CANTILEVER,
    "ccx_cantilever_ele_tetra4": CANTILEVER,
    "ccx_cantilever_faceload": CANTILEVER,
    "ccx_cantilever_nodeload": CANTILEVER,
    "ccx_cantilever_prescribeddisplacement": None,
    "constraint_centrif": None,
    "constraint_contact_solid_solid": None,
    "constraint_section_print": None,
    "constraint_selfweight_cantilever": None,
    "constraint_tie": None,
    "constraint_transform_beam_hinged": None,
    "constraint_transform_torque": None,
    "elmer_nonguitutorial01_eigenvalue_of_elastic_beam": None,
    "frequency_beamsimple": None,
    "material_multiple_bendingbeam_fiveboxes": None,
    "material_multiple_tensionrod_twoboxes": None,
    "material_nl_platewithhole": None,
    "thermomech_bimetall": None,
    "thermomech_spine": None,
}
ELEMENTS = 600  #: about so many, where the part lets a mesh be so coarse
#: Solids that share a curved face, whose meshes do not meet there: said on the page.
NOT_MESHED = ("constraint_section_print",)
LIMIT = 0.02
SIZES, MANY = 8, 5  #: of mesh_brep


def members(document, kind):
    return [o for o in document.Analysis.Group if o.isDerivedFrom(kind)]


def solve(document, folder):
    """{"nodes": of the mesh, what is compared: value} of the document's analysis as it stands."""
    mesh = members(document, "Fem::FemMeshObject")[0]
    solver = [o for o in document.Analysis.Group if "Solver" in o.TypeId][0]
    for old in members(document, "Fem::FemResultObject"):
        document.removeObject(old.Name)
    dat = analysis.solve(document.Analysis, solver, folder)
    stem = os.path.splitext(dat)[0]
    text = Path(dat).read_text() if os.path.exists(dat) else ""
    result = {"nodes": mesh.FemMesh.NodeCount}
    if solver.AnalysisType == "frequency":
        found = calculix.frequencies(text)
        result["first frequency, Hz"] = next(f for f in found if f > 1e-3 * max(found))  # a free body's first six are zero
    elif solver.AnalysisType == "buckling":
        result["buckling factor"] = calculix.buckling_factors(text)[0]
    else:
        fields = calculix.read_frd(stem + ".frd")
        u = supports.significant(stem + ".inp", fields["U"])
        result["largest displacement, mm"] = float(np.nanmax(np.linalg.norm(u, axis=1)))
        if solver.AnalysisType == "thermomech":
            result["least temperature, K"] = float(np.nanmin(fields["NT"]))
    return result


def mesh_brep(shape, size):
    """The core's mesh of 20-node hexahedra at the first size, each three quarters of the last, that takes about as many as it should.

    A face much narrower than the size, in a plane with its neighbours, gets no elements of a feature-line mesh; the mesher then
    takes the tet-split, whose elements are as small as the face: many times as many as asked for. A user makes the size smaller.
    """
    for finer in range(SIZES):
        now = size * 0.75**finer
        result = core.load().mesh_brep(shape.exportBrepToString(), {"order": 2, "size": now})
        if len(result.hexes) <= MANY * shape.Volume / now**3:
            return result
    raise RuntimeError("at sizes %.3g to %.3g there are more than %g times as many elements as asked for" % (size, now, MANY))


def our_mesh(shape, size):
    """A Fem.FemMesh of 20-node hexahedra. Solids that share faces are meshed one by one and joined node by node.

    Raises RuntimeError when on a shared face a node of one has none of the other within a fiftieth of the size.
    """
    import Fem

    if len(shape.Solids) == 1 or len(shape.Faces) == sum(len(s.Faces) for s in shape.Solids):
        return fem_mesh.to_fem_mesh(mesh_brep(shape, size))[0]
    points, hexes, quads, on_face, offset = [], [], [], {}, 0
    for solid in shape.Solids:
        result = mesh_brep(solid, size)
        outer = np.array(result.quads8) + offset
        for number, face in enumerate(solid.Faces, 1):
            key = next(n for n, f in enumerate(shape.Faces) if f.isSame(face))
            on_face.setdefault(key, []).append(np.unique(outer[np.array(result.quad_face) == number]))
        points.append(np.array(result.points))
        hexes.append(np.array(result.hexes20) + offset)
        quads.append(outer)
        offset += len(result.points)
    points, hexes, quads = np.vstack(points), np.vstack(hexes), np.vstack(quads)
    same = np.arange(len(points))
    for nodes in on_face.values():
        if len(nodes) > 1:
            distance = np.linalg.norm(points[nodes[0]][:, None] - points[nodes[1]], axis=2)
            if len(nodes[0]) != len(nodes[1]) or max(distance.min(axis=0).max(), distance.min(axis=1).max()) > 0.02 * size:
                raise RuntimeError("the meshes of two solids do not meet on the face that they share")
            same[nodes[1]] = np.minimum(same[nodes[1]], same[nodes[0][distance.argmin(axis=0)]])
    while not np.array_equal(same, same[same]):
        same = same[same]
    quads = same[quads]
    quads = quads[np.unique(np.sort(quads, axis=1), axis=0, return_index=True)[1]]
    mesh = Fem.FemMesh()
    for node in np.unique(same).tolist():
        mesh.addNode(*points[node].tolist(), node + 1)
    for number, nodes in enumerate((same[hexes][:, fem_mesh.HEX20] + 1).tolist(), 1):
        mesh.addVolume(nodes, number)
    for number, nodes in enumerate((quads + 1).tolist(), len(hexes) + 1):
        mesh.addFace(nodes, number)
    return mesh


def fine_tetrahedra(shape, nodes, folder):
    """A Fem.FemMesh of about so many nodes, as FreeCAD itself has it from Gmsh: through a .unv file."""
    import Fem

    path = os.path.join(folder, "fine.unv")
    meshers.tetrahedra_file(shape, (shape.Volume / nodes * 7) ** (1 / 3), path, nodes)
    mesh = Fem.FemMesh()
    mesh.read(path)
    return mesh


def group_materials(document):
    """A group of volumes for each material in the document's mesh, by the solid that an element's middle is in.

    FreeCAD's Gmsh task makes such groups where it is asked to, and the writer finds a material's elements by them. Without, it
    looks for each node in each solid, which takes it longer than the solver needs.
    """
    from femtools.geomtools import get_element

    materials, mesh = members(document, "App::MaterialObject"), members(document, "Fem::FemMeshObject")[0]
    if len(materials) < 2:
        return
    fem = mesh.FemMesh.copy()
    nodes, shape = fem.Nodes, (getattr(mesh, "Part", None) or mesh.Shape).Shape

    def inside(solid, p):  # where but one solid's box holds the point, the slow question is not asked
        return solid.BoundBox.isInside(p) and (sum(s.BoundBox.isInside(p) for s in shape.Solids) == 1 or solid.isInside(p, 1e-6, True))

    left = {v: sum((nodes[n] for n in fem.getElementNodes(v)), FreeCAD.Vector()) / len(fem.getElementNodes(v)) for v in fem.Volumes}
    for material in sorted(materials, key=lambda m: not m.References):  # one without references is that of the rest
        solids = [get_element(part, name) for part, names in material.References for name in names]
        found = [v for v, p in left.items() if not solids or any(inside(s, p) for s in solids)]
        fem.addGroupElements(fem.addGroup(material.Name + "_Elements", "Volume"), found)
        for v in found:
            del left[v]
    if left:
        raise RuntimeError("%d elements are in no material's solid" % len(left))
    mesh.FemMesh = fem


def run(name, folder):
    """The example as it comes, with our mesh and with fine tetrahedra: a row."""
    document = importlib.import_module("femexamples." + name).setup(solvertype="ccxtools")
    folder = os.path.join(folder, name)
    row = {"example": name}
    try:
        document.recompute()
        mesh = members(document, "Fem::FemMeshObject")[0]
        shape = (getattr(mesh, "Part", None) or mesh.Shape).Shape
        if mesh.FemMesh.VolumeCount:
            row["own"] = solve(document, os.path.join(folder, "own"))
        mesh.FemMesh = our_mesh(shape, (shape.Volume / ELEMENTS) ** (1 / 3))
        group_materials(document)
        row["ours"] = solve(document, os.path.join(folder, "hexahedra"))
        mesh.FemMesh = fine_tetrahedra(shape, 2 * row["ours"]["nodes"], folder)
        group_materials(document)
        row["fine"] = solve(document, os.path.join(folder, "fine"))
        return row
    finally:
        FreeCAD.closeDocument(document.Name)


def main(out, names):
    os.makedirs(out, exist_ok=True)
    rows, failed = [], 0
    writer_mends.mend(lambda mesh: True)  # as our mesh objects are written: here our meshes stand in FreeCAD's
    for name in names or EXAMPLES:
        try:
            row = run(name, os.path.join(out, "examples"))
        except Exception as error:
            said = str(error).strip().splitlines() or [repr(error)]
            rows.append({"example": name, "why_not": said[0][:200]})
            print("%-40s %s" % (name, rows[-1]["why_not"]), flush=True)
            failed |= name not in NOT_MESHED
            continue
        row["known"] = EXAMPLES[name]
        row["difference"] = {what: abs(value / (row["known"] or row["fine"][what]) - 1)
                             for what, value in row["ours"].items() if what != "nodes"}
        failed |= not all(difference <= LIMIT for difference in row["difference"].values())
        rows.append(row)
        for what, difference in row["difference"].items():
            print("%-40s %-25s %s: %.2f%%" % (name, what, ", ".join("%.6g with %d nodes %s" % (row[k][what], row[k]["nodes"], k)
                  for k in ("own", "ours", "fine") if k in row), 100 * difference), flush=True)
        Path(out, "examples.json").write_text(json.dumps(rows, indent=1))
    Path(out, "examples.json").write_text(json.dumps(rows, indent=1))
    return int(failed)


if __name__ == "__main__":
    asked = arguments.parse(__doc__, "NAME")
    sys.exit(main(asked.out, asked.names))
