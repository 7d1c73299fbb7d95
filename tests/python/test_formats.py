# HexFeatureWB - LGPL-2.1-or-later
"""Every format, read back by a program that is not ours: vtk, meshio, FreeCAD's SMESH, CalculiX."""
import json
import shutil
import subprocess
import warnings

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
    assert "warning" not in (done.stdout + done.stderr).lower(), done.stdout + done.stderr
    return json.loads(done.stdout.strip().splitlines()[-1])


@pytest.fixture
def read_by_meshio(capfd):
    """meshio.read, which fails when meshio or what it uses says anything: its warnings go to the terminal only."""
    def read(path):
        capfd.readouterr()
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            back = meshio.read(path, "gmsh" if path.suffix == ".msh" else None)  # or .msh is taken for Ansys' first, and it says so
        said = capfd.readouterr()
        assert said.out + said.err == ""
        return back

    return read


@pytest.fixture(params=[1, 2], ids=["first order", "second order"])
def mesh(request, box_mesh, box_mesh2):
    return box_mesh if request.param == 1 else box_mesh2


def cells_of(mesh):
    return (mesh.hexes, mesh.quads) if mesh.order == 1 else (mesh.hexes20, mesh.quads8)


def nodes_on_face(mesh, face):
    return set(np.unique(cells_of(mesh)[1][mesh.quad_face == face]))


@pytest.mark.parametrize("ending", ["vtk", "vtu", "msh"])
def test_points_cells_and_faces_come_back(mesh, tmp_path, ending, read_by_meshio):
    path = tmp_path / f"box.{ending}"
    mesh.write(path)
    back = read_by_meshio(path)
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


def test_inp_sets(mesh, tmp_path, read_by_meshio):
    mesh.write(tmp_path / "box.inp")
    back = read_by_meshio(tmp_path / "box.inp")
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


GMSH_READ = """
import json, sys
import gmsh
gmsh.initialize([], False)
gmsh.option.setNumber("General.Terminal", 0)
gmsh.logger.start()
gmsh.open(sys.argv[1])
groups = {gmsh.model.getPhysicalName(*g): len(gmsh.model.mesh.getNodesForPhysicalGroup(*g)[0]) for g in gmsh.model.getPhysicalGroups()}
counts = {}
for dimension in (2, 3):
    for kind, elements, nodes in zip(*gmsh.model.mesh.getElements(dimension)):
        name = gmsh.model.mesh.getElementProperties(kind)[0]
        counts[name] = counts.get(name, 0) + len(elements)
volume, least = 0, 1e9
kind = gmsh.model.mesh.getElementTypes(3)[0]
points, weights = gmsh.model.mesh.getIntegrationPoints(kind, "Gauss6")
_, determinants, _ = gmsh.model.mesh.getJacobians(kind, points)
for k, determinant in enumerate(determinants):
    volume += determinant * weights[k % len(weights)]
print(json.dumps({"groups": groups, "counts": counts, "volume": volume, "least": min(determinants),
                  "said": [line for line in gmsh.logger.get() if not line.startswith("Info")]}))
gmsh.finalize()
"""


def test_gmsh_reads_it_without_a_warning(mesh, tmp_path):
    """Node order proved by the volume and by a positive determinant everywhere, as Gmsh computes them."""
    mesh.write(tmp_path / "box.msh")
    done = subprocess.run(["/usr/bin/python3", "-c", GMSH_READ, str(tmp_path / "box.msh")], capture_output=True, text=True)
    if "No module named 'gmsh'" in done.stderr:
        pytest.skip("Gmsh is not installed")
    back = json.loads(done.stdout.strip().splitlines()[-1])
    assert back["said"] == [] and done.stderr == ""
    names = ("Hexahedron 8", "Quadrilateral 4") if mesh.order == 1 else ("Hexahedron 20", "Quadrilateral 8")
    assert back["counts"] == dict(zip(names, (len(mesh.hexes), len(mesh.quads))))
    assert back["volume"] == pytest.approx(40 * 20 * 10) and back["least"] > 0
    for face in range(1, 7):
        assert back["groups"][f"Face{face}"] == len(nodes_on_face(mesh, face))
    assert back["groups"]["Solid1"] == len(mesh.points)


@pytest.fixture(scope="module")
def curved_mesh(parts):
    """A drilled plate of 20-node hexahedra: mid-side nodes off the chords, so that their order matters to the volume."""
    import hexfeature

    return hexfeature.mesh(parts / "plate.step", size=6, order=2)


@pytest.mark.parametrize("ending", ["vtk", "vtu"])
def test_vtk_measures_the_volume_of_curved_elements(curved_mesh, tmp_path, ending):
    pytest.importorskip("vtkmodules")
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkFiltersVerdict import vtkCellSizeFilter
    if ending == "vtk":
        from vtkmodules.vtkIOLegacy import vtkUnstructuredGridReader as Reader
    else:
        from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader as Reader
    curved_mesh.write(tmp_path / f"plate.{ending}")
    reader = Reader()
    reader.SetFileName(str(tmp_path / f"plate.{ending}"))
    sizes = vtkCellSizeFilter()
    sizes.SetInputConnection(reader.GetOutputPort())
    sizes.Update()
    volume = vtk_to_numpy(sizes.GetOutput().GetCellData().GetArray("Volume")).sum()
    # VTK cuts each element into tetrahedra through its mid-side nodes: a little less than the true volume.
    assert volume == pytest.approx(40 * 40 * 10 - np.pi * 64 * 10, rel=5e-3)


@pytest.mark.skipif(not shutil.which("ccx"), reason="CalculiX is not installed")
@pytest.mark.parametrize("kind", ["C3D8", "C3D8I", "C3D8R", "C3D20", "C3D20R"])
def test_calculix_solves_every_element_type_without_a_warning(parts, curved_mesh, tmp_path, kind):
    """The file on its own command's option; self-weight on one face: the reaction is the CAD's weight, with no warning."""
    import hexfeature

    mesh = curved_mesh if kind.startswith("C3D20") else hexfeature.mesh(parts / "plate.step", size=6)
    mesh.write(tmp_path / "plate.inp", element_type=kind)
    assert f"TYPE={kind}," in (tmp_path / "plate.inp").read_text()
    x = mesh.points[:, 0]
    fixed = next(f for f in range(1, 8) if np.ptp(x[sorted(nodes_on_face(mesh, f))]) < 1e-9)
    (tmp_path / "run.inp").write_text(f"""*INCLUDE, INPUT=plate.inp
*MATERIAL, NAME=STEEL
*ELASTIC
210000, 0.3
*DENSITY
1
*SOLID SECTION, ELSET=Solid1, MATERIAL=STEEL
*BOUNDARY
Face{fixed}, 1, 3
*STEP
*STATIC
*DLOAD
Solid1, GRAV, 1, 0, 0, -1
*EL PRINT, ELSET=Solid1, TOTALS=ONLY
EVOL
*END STEP
""")
    done = subprocess.run(["ccx", "run"], cwd=tmp_path, capture_output=True, text=True)
    assert "Job finished" in done.stdout and "*WARNING" not in done.stdout and "*ERROR" not in done.stdout, done.stdout[-2000:]
    volume = float((tmp_path / "run.dat").read_text().split()[-1])
    assert volume == pytest.approx(40 * 40 * 10 - np.pi * 64 * 10, rel=3e-4 if mesh.order == 2 else 2e-2)


def test_mid_side_nodes_lie_on_the_cad(curved_mesh):
    second = curved_mesh.report["second_order"]
    assert second["largest_mid_side_deviation"] < 1e-8 and second["straightened_nodes"] == second["straightened_faces"] == []
    assert 0 < second["least_jacobian"] <= 1
    on_hole = curved_mesh.quads8[[f for f, face in enumerate(curved_mesh.quad_face) if face == hole_of(curved_mesh)]]
    p = curved_mesh.points[np.unique(on_hole)]
    assert np.abs(np.hypot(p[:, 0] - 20, p[:, 1] - 20) - 8).max() < 1e-8


def hole_of(mesh):
    """The face whose nodes are all 8 from the plate's axis."""
    for face in range(1, 8):
        p = mesh.points[sorted(nodes_on_face(mesh, face))]
        if np.abs(np.hypot(p[:, 0] - 20, p[:, 1] - 20) - 8).max() < 0.5:
            return face
    raise AssertionError("no hole")
