# HexFeatureWB - LGPL-2.1-or-later
"""Every format, read back by a program that is not ours: vtk, meshio, FreeCAD's SMESH, CalculiX."""
import json
import shutil
import subprocess

import numpy as np
import pytest

from hexfeature.errors import MeshingError

meshio = pytest.importorskip("meshio")

FREECAD_READ = """
import json, sys
sys.path += ["/usr/lib/freecad-python3/lib", "/usr/lib/freecad/lib"]
import FreeCAD, Fem
mesh = Fem.FemMesh()
mesh.read(sys.argv[1])
groups = {mesh.getGroupName(g): [mesh.getGroupElementType(g), len(mesh.getGroupElements(g))] for g in mesh.Groups}
nodes = mesh.Nodes
points = [list(nodes[n]) for n in sorted(nodes)]
print(json.dumps({"nodes": mesh.NodeCount, "hexes": mesh.HexaCount, "quads": mesh.QuadrangleCount, "groups": groups, "points": points,
                  "first": mesh.getElementNodes(mesh.Volumes[0])}))
"""
# SMESH's order of a hexahedron's nodes, from VTK's.
SMESH_ORDER = [0, 3, 2, 1, 4, 7, 6, 5, 11, 10, 9, 8, 15, 14, 13, 12, 16, 19, 18, 17]


def read_by_freecad(path):
    done = subprocess.run(["/usr/bin/python3", "-c", FREECAD_READ, str(path)], capture_output=True, text=True, errors="replace")
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout.strip().splitlines()[-1])


@pytest.fixture(params=[1, 2], ids=["first order", "second order"])
def mesh(request, box_mesh, box_mesh2):
    return box_mesh if request.param == 1 else box_mesh2


def cells_of(mesh):
    return (mesh.hexes, mesh.quads) if mesh.order == 1 else (mesh.hexes20, mesh.quads8)


def nodes_on_face(mesh, face):
    return set(np.unique(cells_of(mesh)[1][mesh.quad_face == face]))


@pytest.mark.parametrize("ending", ["vtk", "vtu", "msh"])
def test_points_cells_and_faces_come_back(mesh, tmp_path, ending):
    path = tmp_path / f"box.{ending}"
    mesh.write(path)
    back = meshio.read(path)
    hexes, quads = cells_of(mesh)
    assert np.array_equal(back.points, mesh.points)
    kinds = {"hexahedron": hexes, "quad": quads} if mesh.order == 1 else {"hexahedron20": hexes, "quad8": quads}
    for block in back.cells:
        assert np.array_equal(block.data, kinds.pop(block.type))
    assert not kinds
    data = back.cell_data["gmsh:physical" if ending == "msh" else "cad_face"]
    assert np.array_equal(data[1], mesh.quad_face)
    if ending == "msh":
        assert back.field_data["Face3"].tolist() == [3, 2] and back.field_data["Solid1"].tolist() == [1, 3]
    else:
        assert set(data[0]) == {0}
        assert set(back.cell_data["cad_solid"][0]) == set(back.cell_data["cad_solid"][1]) == {1}
        assert np.array_equal(back.point_data["cad_dim"].ravel(), mesh.node_dim)


@pytest.mark.parametrize("ending", ["vtk", "vtu"])
def test_vtk_reads_it(mesh, tmp_path, ending):
    pytest.importorskip("vtkmodules")
    from vtkmodules.util.numpy_support import vtk_to_numpy
    if ending == "vtk":
        from vtkmodules.vtkIOLegacy import vtkUnstructuredGridReader as Reader
    else:
        from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader as Reader
    mesh.write(tmp_path / f"box.{ending}")
    reader = Reader()
    reader.SetFileName(str(tmp_path / f"box.{ending}"))
    reader.Update()
    grid = reader.GetOutput()
    assert grid.GetNumberOfPoints() == len(mesh.points)
    kinds = vtk_to_numpy(grid.GetCellTypesArray())
    assert np.bincount(kinds)[[12, 9] if mesh.order == 1 else [25, 23]].tolist() == [len(mesh.hexes), len(mesh.quads)]


@pytest.mark.parametrize("ending", ["unv", "med"])
def test_freecad_reads_it_with_groups(mesh, tmp_path, ending):
    if ending == "med":
        pytest.importorskip("h5py")
    path = tmp_path / f"box.{ending}"
    mesh.write(path)
    back = read_by_freecad(path)
    hexes, quads = cells_of(mesh)
    assert (back["nodes"], back["hexes"], back["quads"]) == (len(mesh.points), len(hexes), len(quads))
    assert np.array_equal(np.array(back["points"]), mesh.points)
    assert back["first"] == [int(hexes[0][k]) + 1 for k in SMESH_ORDER[:hexes.shape[1]]]
    for face in range(1, 7):
        assert back["groups"][f"Face{face}"] == ["Face", int((mesh.quad_face == face).sum())]
    assert back["groups"]["Solid1"] == ["Volume", len(hexes)]
    for vertex in range(1, 9):
        assert back["groups"][f"Vertex{vertex}"] == ["Node", 1]
    for edge in range(1, 13):
        steps = int((mesh.feature_edge_cad == edge).sum())
        assert back["groups"][f"Edge{edge}"] == ["Node", mesh.order * steps + 1]


def test_inp_sets(mesh, tmp_path):
    mesh.write(tmp_path / "box.inp")
    back = meshio.read(tmp_path / "box.inp")
    assert np.allclose(back.points, mesh.points, rtol=1e-12, atol=0)
    assert np.array_equal(back.cells[0].data, cells_of(mesh)[0])
    for face in range(1, 7):
        assert set(back.point_sets[f"Face{face}"]) == nodes_on_face(mesh, face)
    assert len(back.point_sets["Vertex8"]) == 1


@pytest.mark.skipif(not shutil.which("ccx"), reason="CalculiX is not installed")
@pytest.mark.parametrize("kind", ["first", "C3D8I", "second", "C3D20"])
def test_calculix_pulls_a_bar(box_mesh, box_mesh2, tmp_path, kind):
    """Fixed on one CAD face's nodes, pulled by a pressure on the opposite CAD face's surface: p L / E of lengthening."""
    mesh = box_mesh if kind in ("first", "C3D8I") else box_mesh2
    mesh.write(tmp_path / "box.inp", element_type=kind if kind.startswith("C3D") else "")
    x = mesh.points[:, 0]
    ends = [f for f in range(1, 7) if np.ptp(x[sorted(nodes_on_face(mesh, f))]) < 1e-9]
    fixed, pulled = sorted(ends, key=lambda f: x[min(nodes_on_face(mesh, f))])
    (tmp_path / "run.inp").write_text(f"""*INCLUDE, INPUT=box.inp
*MATERIAL, NAME=STEEL
*ELASTIC
200000, 0
*SOLID SECTION, ELSET=Solid1, MATERIAL=STEEL
*STEP
*STATIC
*BOUNDARY
Face{fixed}, 1, 3
*DSLOAD
Face{pulled}, P, -100
*NODE PRINT, NSET=Face{pulled}
U
*END STEP
""")
    done = subprocess.run(["ccx", "run"], cwd=tmp_path, capture_output=True, text=True)
    assert (tmp_path / "run.dat").exists(), done.stdout[-2000:]
    rows = [line.split() for line in (tmp_path / "run.dat").read_text().splitlines()]
    stretch = [float(r[1]) for r in rows if len(r) == 4 and r[0].isdigit()]
    assert len(stretch) == len(nodes_on_face(mesh, pulled))
    assert stretch == pytest.approx([100 * 40 / 200000] * len(stretch), rel=1e-6)


def test_element_type_must_fit(box_mesh, tmp_path):
    with pytest.raises(MeshingError) as caught:
        box_mesh.write(tmp_path / "box.inp", element_type="C3D20")
    assert caught.value.kind == "usage"


def test_a_missing_package_is_said(box_mesh, tmp_path, monkeypatch):
    monkeypatch.setitem(__import__("sys").modules, "meshio", None)
    with pytest.raises(MeshingError) as caught:
        box_mesh.write(tmp_path / "box.vtu")
    assert caught.value.kind == "output" and "meshio" in caught.value.reason and not list(tmp_path.iterdir())
