# HexFeatureWB - LGPL-2.1-or-later
"""The command line as its users and the judge call it: files, exit codes, messages; never a traceback."""
import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
ENVIRONMENT = dict(os.environ, PYTHONPATH=str(ROOT / "python"))
COMMAND = [sys.executable, "-m", "hexfeature"]


def run(*arguments, **keywords):
    done = subprocess.run(COMMAND + [str(a) for a in arguments], capture_output=True, text=True, env=ENVIRONMENT, timeout=120, **keywords)
    assert "Traceback" not in done.stderr
    return done


def failed(done, code):
    """The message's three parts."""
    assert done.returncode == code, done.stderr
    lines = done.stderr.strip().splitlines()
    errors = [line for line in lines if line.startswith("hexfeature: error in step ")]
    assert len(errors) == 1 and any(line.startswith("  hint: ") for line in lines), done.stderr
    assert done.stdout == ""
    return done.stderr


def test_mesh_and_report(parts, tmp_path):
    done = run("mesh", parts / "box.step", "-o", tmp_path / "box.vtk", "--size", 5, "--report", tmp_path / "box.json")
    assert done.returncode == 0, done.stderr
    assert done.stdout == ""
    report = json.loads((tmp_path / "box.json").read_text())
    assert report["method"] == "feature-line" and report["certified"]
    assert report["quality"]["hexes"] == 8 * 4 * 2
    assert report["quality"]["min_scaled_jacobian"] == pytest.approx(1, abs=1e-6)
    assert report["options"]["size"] == 5
    assert sorted(os.listdir(tmp_path)) == ["box.json", "box.vtk"]


def test_quiet_prints_nothing(parts, tmp_path):
    done = run("mesh", parts / "box.step", "-o", tmp_path / "box.vtk", "--size", 5, "--quiet")
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")


def test_verbose_names_the_steps(parts, tmp_path):
    done = run("mesh", parts / "box.step", "-o", tmp_path / "box.vtk", "--size", 5, "--verbose")
    assert done.returncode == 0 and "step labels" in done.stderr and "step smooth" in done.stderr


def test_config_file_and_its_overruling(parts, tmp_path):
    (tmp_path / "c.json").write_text('{"size": 10, "order": 2, "sheets": false}')
    done = run("mesh", parts / "box.step", "-o", tmp_path / "a.vtk", "--config", tmp_path / "c.json", "--size", 5,
               "--report", tmp_path / "a.json")
    assert done.returncode == 0, done.stderr
    options = json.loads((tmp_path / "a.json").read_text())["options"]
    assert (options["size"], options["order"], options["sheets"]) == (5, 2, False)


@pytest.mark.parametrize("part, objects, elements", [
    ("one.FCStd", [], None), ("body.FCStd", [], 64), ("two.FCStd", ["--object", "Second"], None),
    ("two.FCStd", ["--object", "first box"], 8), ("one.FCStd", ["--object", "Base"], None)])
def test_freecad_documents(parts, tmp_path, part, objects, elements):
    done = run("mesh", parts / part, *objects, "-o", tmp_path / "m.vtk", "--size", 5, "--report", tmp_path / "m.json")
    assert done.returncode == 0, done.stderr
    hexes = json.loads((tmp_path / "m.json").read_text())["quality"]["hexes"]
    assert hexes == elements if elements else hexes > 0


def test_info(parts):
    done = run("info", parts / "plate.step")
    assert done.returncode == 0, done.stderr
    facts = json.loads(done.stdout)
    assert (facts["solids"], facts["cad_faces"]) == (1, 7)
    assert facts["volume"] == pytest.approx(16000 - 640 * 3.14159265, rel=1e-6)


def test_version_and_help():
    assert run("version").stdout.strip() == __import__("hexfeature").__version__
    text = run("mesh", "--help")
    assert text.returncode == 0 and "--size" in text.stdout and "--no-sheets" in text.stdout


@pytest.mark.parametrize("part", [
    "missing.step", "empty.step", "no_solid.step", "noise.step", "truncated.step", "open_shell.step", "hole.stl", "box.xyz",
    "not_a_document.FCStd", "empty.FCStd", "missing.FCStd", "."])
def test_bad_input(parts, tmp_path, part):
    message = failed(run("mesh", parts / part, "-o", tmp_path / "m.vtk", "--size", 5, "--report", tmp_path / "m.json"), 3)
    assert "internal error" not in message
    assert os.listdir(tmp_path) == ["m.json"]
    assert json.loads((tmp_path / "m.json").read_text())["error"]["kind"] == "bad_input"


@pytest.mark.parametrize("size, word", [
    ("0", "greater than 0"), ("-1", "greater than 0"), ("nan", "finite"), ("inf", "finite"), ("1e6", "larger than the part"),
    ("1e-6", "elements"), ("abc", "size")])
def test_impossible_sizes(parts, tmp_path, size, word):
    message = failed(run("mesh", parts / "box.step", "-o", tmp_path / "m.vtk", "--size", size), 2)
    assert word in message
    assert os.listdir(tmp_path) == []


@pytest.mark.parametrize("line", [
    "", "fly", "mesh", "mesh box.step --size 5", "mesh box.step -o m.xyz", "mesh box.step -o m.vtk --nonsense",
    "mesh box.step -o m.vtk --order 3", "mesh box.step -o m.vtk --method magic", "mesh box.step -o m.vtk --config missing.json",
    "mesh box.step -o m.inp --stop-after labels", "mesh box.step -o m.inp --element-type C3D20 --size 5",
    "mesh box.step -o m.vtk --object Box", "mesh two.FCStd -o m.vtk", "mesh two.FCStd -o m.vtk --object Third"])
def test_usage(parts, line):
    failed(run(*line.split(), cwd=parts), 2)


def test_config_that_is_no_json(parts, tmp_path):
    for text in ('{"size": ', "[1]", '{"sise": 4}', '{"size": "big"}', '{"order": null}', '{"size": NaN}'):
        (tmp_path / "c.json").write_text(text)
        failed(run("mesh", parts / "box.step", "-o", tmp_path / "m.vtk", "--config", tmp_path / "c.json"), 2)


def test_output_that_cannot_be_written(parts, tmp_path):
    (tmp_path / "file").write_text("")
    (tmp_path / "folder.vtk").mkdir()
    for name in ("missing/m.vtk", "file/m.vtk", "folder.vtk"):
        failed(run("mesh", parts / "box.step", "-o", tmp_path / name, "--size", 5), 5)
    failed(run("mesh", parts / "box.step", "-o", tmp_path / "m.vtk", "--size", 5, "--report", tmp_path / "missing" / "m.json"), 5)


def test_disk_full(parts, tmp_path):
    """A limit on file size stands in for a full disk: a message, exit 5, and no half-written file."""
    def limit():
        import resource
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000))

    for name in ("m.vtk", "m.unv", "m.inp", "m.vtu", "m.msh"):
        failed(run("mesh", parts / "box.step", "-o", tmp_path / name, "--size", 2, preexec_fn=limit), 5)
        assert os.listdir(tmp_path) == []


def test_interrupt(parts, tmp_path):
    """Ctrl-C during the work: exit 130 at once, and no file."""
    process = subprocess.Popen(COMMAND + ["mesh", str(parts / "plate.step"), "-o", str(tmp_path / "m.vtk"), "--size", "0.4", "--verbose"],
                               stderr=subprocess.PIPE, text=True, env=ENVIRONMENT)
    for line in process.stderr:
        if line.startswith("step surface"):
            break
    time.sleep(0.2)
    process.send_signal(signal.SIGINT)
    sent = time.monotonic()
    rest = process.stderr.read()
    assert process.wait(timeout=20) == 130, rest
    assert time.monotonic() - sent < 2
    assert "cancelled" in rest and "Traceback" not in rest
    assert os.listdir(tmp_path) == []


@pytest.mark.parametrize("stage, array", [
    ("surface", "cad_face"), ("labels", "label"), ("shape", "arc_axis"), ("polycube", "arc_sign"), ("lattice", "chart"),
    ("fit", "cad_face"), ("sheets", "block"), ("smooth", "block")])
def test_stop_after_leaves_a_coloured_picture(parts, tmp_path, stage, array):
    reader_module = pytest.importorskip("vtkmodules.vtkIOLegacy")
    done = run("mesh", parts / "plate.step", "-o", tmp_path / "s.vtk", "--size", 5, "--stop-after", stage)
    assert done.returncode == 0, done.stderr
    assert f"stopped after step {stage}" in done.stderr
    reader = reader_module.vtkUnstructuredGridReader()
    reader.SetFileName(str(tmp_path / "s.vtk"))
    reader.ReadAllFieldsOn()
    reader.Update()
    picture = reader.GetOutput()
    assert picture.GetNumberOfCells() > 0
    assert picture.GetCellData().GetArray(array).GetNumberOfTuples() == picture.GetNumberOfCells()


def test_starts_quickly():
    """Half a second for a small part leaves nothing for slow imports: numpy, meshio and zipfile are not loaded by the start."""
    code = "import sys, hexfeature.cli; print(*{'numpy', 'meshio', 'zipfile', 'xml', 'json', 'vtk'} & set(sys.modules))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, env=ENVIRONMENT)
    assert done.stdout.strip() == "", done.stderr
