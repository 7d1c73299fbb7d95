# HexFeatureWB - LGPL-2.1-or-later
"""Each format read by a program that is not ours and solved by CalculiX, in both orders: a wrong node order shows in volume and
deflection, of curved 20-node elements at each node. The reference is our own .inp file. A reader that warns fails."""
import json
import re
import shutil
import subprocess

import numpy as np
import pytest

pytestmark = pytest.mark.skipif(not shutil.which("ccx"), reason="CalculiX is not installed")
VOLUME = 40 * 40 * 10 - np.pi * 64 * 10
STEEL = "*MATERIAL, NAME=STEEL\n*ELASTIC\n210000, 0.3\n*DENSITY\n7.9e-9\n*SOLID SECTION, ELSET=%s, MATERIAL=STEEL\n"
OUTPUT = "*NODE FILE\nU\n*EL PRINT, ELSET=%s, TOTALS=ONLY\nEVOL\n"

FREECAD = """
import json, os, subprocess, sys
sys.path += ["/usr/lib/freecad" + folder for folder in ("-python3/lib", "/lib", "/Mod", "/Mod/Fem", "/Ext")]
sys.path += ["/usr/share/freecad/Mod/Fem"]
path, step, folder, sys.path[:0] = sys.argv[1], sys.argv[2], sys.argv[3], [sys.argv[4]]
import FreeCAD, Part, Fem
from HexFeatureWB import analysis
from femtools.ccxtools import FemToolsCcx
document = FreeCAD.newDocument("Read")
part = document.addObject("Part::Feature", "Part")
shape = Part.Shape()
shape.read(step)
part.Shape = shape
mesh = document.addObject("Fem::FemMeshObject", "Mesh")
read = Fem.FemMesh()
read.read(path)
mesh.FemMesh = read
faces = part.Shape.Faces
ends = [1 + max(range(len(faces)), key=lambda n: sign * faces[n].CenterOfMass.x - abs(faces[n].CenterOfMass.y - 20)) for sign in (-1, 1)]
study, solver = analysis.static_analysis(document, mesh, [(part, ("Face%d" % ends[0],))], [(part, ("Face%d" % ends[1],))], 1000.0)
tools = FemToolsCcx(study, solver, test_mode=False)
tools.update_objects()
tools.setup_working_dir(folder)
tools.write_inp_file()
text = open(tools.inp_file_name).read()
open(tools.inp_file_name, "w").write(text.replace("*END STEP", "*EL PRINT, ELSET=Evolumes, TOTALS=ONLY\\nEVOL\\n*END STEP"))
groups = {read.getGroupName(g): len(read.getGroupElements(g)) for g in read.Groups}
found = {"Face%d" % n: len(read.getFacesByFace(f)) for n, f in enumerate(faces, 1)}
print(json.dumps({"deck": os.path.splitext(tools.inp_file_name)[0], "fixed": ends[0], "pulled": ends[1], "groups": groups, "found": found}))
"""

GMSH = """
import sys
import gmsh
gmsh.initialize([], False)
gmsh.option.setNumber("General.Terminal", 0)
gmsh.logger.start()
gmsh.open(sys.argv[1])
gmsh.write(sys.argv[2])
print("".join(line + "\\n" for line in gmsh.logger.get() if not line.startswith("Info")), end="")
"""


@pytest.fixture(scope="module", params=[1, 2], ids=["first order", "second order"])
def plate(request, parts):
    import hexfeature

    return hexfeature.mesh(parts / "plate.step", size=6, order=request.param)


def cells_of(mesh):
    return (mesh.hexes, mesh.quads) if mesh.order == 1 else (mesh.hexes20, mesh.quads8)


def exact_enough(mesh):
    """How far the volume may be from the CAD's: chords, or parabolas, for the hole's circle."""
    return 3e-4 if mesh.order == 2 else 2e-2


def solve(stem):
    """(volume, largest displacement) of a deck; fails on an error or a warning."""
    done = subprocess.run(["ccx", stem.name], cwd=stem.parent, capture_output=True, text=True, errors="replace")
    assert "Job finished" in done.stdout and "*WARNING" not in done.stdout, done.stdout[-2000:]
    dat = stem.with_suffix(".dat").read_text()
    volume = float(re.search(r"total volume.*\n\s*\n\s*(\S+)", dat)[1])
    block = stem.with_suffix(".frd").read_text().partition("DISP")[2].partition("\n -3")[0]
    rows = [line for line in block.splitlines() if line.startswith(" -1")]
    return volume, max(np.linalg.norm([float(line[13 + 12 * k:25 + 12 * k]) for k in range(3)]) for line in rows)


def own_deck(plate, folder, load):
    """Our own .inp file, fixed where x is least; load: what follows in the step."""
    plate.write(folder / "own.inp", element_type="C3D8" if plate.order == 1 else "C3D20")
    ends = {f: plate.points[np.unique(cells_of(plate)[1][plate.quad_face == f]), 0] for f in np.unique(plate.quad_face)}
    fixed = next(f for f, x in ends.items() if np.ptp(x) < 1e-9 and x[0] < 20)
    pulled = next(f for f, x in ends.items() if np.ptp(x) < 1e-9 and x[0] > 20)
    deck = "*INCLUDE, INPUT=own.inp\n" + STEEL % "Solid1" + "*STEP\n*STATIC\n*BOUNDARY\nFace%d, 1, 3\n" % fixed
    (folder / "run.inp").write_text(deck + load.format(pulled=pulled) + OUTPUT % "Solid1" + "*END STEP\n")
    return folder / "run"


def points_deck(points, hexes, folder):
    """Arrays as a reader has them, in VTK's and Abaqus' order, under self-weight."""
    fixed = np.flatnonzero(np.abs(points[:, 0] - points[:, 0].min()) < 1e-9)
    lines = ["*NODE, NSET=All"] + ["%d,%.15g,%.15g,%.15g" % (n, *p) for n, p in enumerate(points, 1)] + [
        "*ELEMENT, TYPE=C3D%d, ELSET=Eall" % hexes.shape[1]]
    for number, nodes in enumerate((hexes + 1).tolist(), 1):
        rows = [[number, *nodes]] if len(nodes) == 8 else [[number, *nodes[:10], ""], nodes[10:]]
        lines += [",".join(map(str, row)) for row in rows]
    lines += ["*BOUNDARY"] + ["%d,1,3" % (n + 1) for n in fixed]
    (folder / "read.inp").write_text("\n".join(lines) + "\n" + STEEL % "Eall" + "*STEP\n*STATIC\n*DLOAD\nEall, GRAV, 9810, 0, 0, -1\n"
                                     + OUTPUT % "Eall" + "*END STEP\n")
    return folder / "read"


def read_by_vtk(path):
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkCommonCore import vtkFileOutputWindow, vtkOutputWindow
    if path.suffix == ".vtk":
        from vtkmodules.vtkIOLegacy import vtkUnstructuredGridReader as Reader
    else:
        from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader as Reader
    window = vtkFileOutputWindow()
    window.SetFileName(str(path.with_suffix(".said")))
    vtkOutputWindow.SetInstance(window)
    reader = Reader()
    reader.SetFileName(str(path))
    reader.Update()
    vtkOutputWindow.SetInstance(None)
    said = path.with_suffix(".said")
    assert not said.exists() or said.read_text() == ""
    grid = reader.GetOutput()
    kinds = vtk_to_numpy(grid.GetCellTypesArray())
    kind, width = (25, 20) if 25 in kinds else (12, 8)
    starts, nodes = (vtk_to_numpy(a) for a in (grid.GetCells().GetOffsetsArray(), grid.GetCells().GetConnectivityArray()))
    return vtk_to_numpy(grid.GetPoints().GetData()), nodes[starts[:-1][kinds == kind][:, None] + np.arange(width)]


def read_by_gmsh(path):
    """Through Gmsh's own writer for Abaqus, which has its own order of nodes."""
    deck = path.with_name("gmsh.inp")
    done = subprocess.run(["/usr/bin/python3", "-c", GMSH, str(path), str(deck)], capture_output=True, text=True)
    if "No module named 'gmsh'" in done.stderr:
        pytest.skip("Gmsh is not installed")
    assert done.returncode == 0 and done.stdout + done.stderr == "", done.stdout + done.stderr
    nodes, cells, pending, keyword = {}, [], [], ""
    for line in deck.read_text().splitlines():
        if line.startswith("*"):
            keyword, pending = line.upper(), []
        elif keyword.startswith("*NODE"):
            row = line.split(",")
            nodes[int(row[0])] = [float(v) for v in row[1:4]]
        elif keyword.startswith("*ELEMENT") and "C3D" in keyword:
            pending += [int(v) for v in line.split(",") if v.strip()]
            if len(pending) == (21 if "C3D20" in keyword else 9):
                cells.append(pending[1:])
                pending = []
    number = {node: n for n, node in enumerate(nodes)}
    return np.array(list(nodes.values())), np.array([[number[n] for n in cell] for cell in cells])


@pytest.mark.parametrize("ending", ["vtk", "vtu", "msh"])
def test_what_vtk_and_gmsh_read_solves_the_same(plate, tmp_path, ending):
    if ending != "msh":
        pytest.importorskip("vtkmodules")
    path = tmp_path / f"plate.{ending}"
    plate.write(path)
    points, hexes = (read_by_gmsh if ending == "msh" else read_by_vtk)(path)
    assert len(hexes) == len(plate.hexes)
    volume, sag = solve(points_deck(points, hexes, tmp_path))
    known_volume, known_sag = solve(own_deck(plate, tmp_path, "*DLOAD\nSolid1, GRAV, 9810, 0, 0, -1\n"))
    assert volume == pytest.approx(VOLUME, rel=exact_enough(plate)) and volume == pytest.approx(known_volume, rel=1e-6)
    assert sag == pytest.approx(known_sag, rel=1e-5)


@pytest.mark.parametrize("ending", ["unv", "med"])
def test_what_freecad_reads_its_own_tools_solve_the_same(parts, plate, tmp_path, ending):
    """FreeCAD reads the file into a document with the CAD part, finds fixing and force by geometry and writes CalculiX's deck."""
    if ending == "med":
        pytest.importorskip("h5py")
    from conftest import ROOT

    plate.write(tmp_path / f"plate.{ending}")
    (tmp_path / "freecad").mkdir()
    done = subprocess.run(["/usr/bin/python3", "-c", FREECAD, str(tmp_path / f"plate.{ending}"), str(parts / "plate.step"),
                           str(tmp_path / "freecad"), str(ROOT / "python")], capture_output=True, text=True, errors="replace")
    assert done.returncode == 0, done.stderr
    assert "warning" not in (done.stdout + done.stderr).lower()
    said = json.loads(done.stdout.strip().splitlines()[-1])
    for face in np.unique(plate.quad_face):
        count = int((plate.quad_face == face).sum())
        assert said["groups"][f"Face{face}"] == said["found"][f"Face{face}"] == count
    volume, stretch = solve((tmp_path / "freecad").joinpath(said["deck"]))
    known_volume, known_stretch = solve(own_deck(plate, tmp_path, "*DSLOAD\nFace{pulled}, P, 2.5\n"))
    assert volume == pytest.approx(known_volume, rel=1e-5) and volume == pytest.approx(VOLUME, rel=exact_enough(plate))
    assert stretch == pytest.approx(known_stretch, rel=1e-4)
