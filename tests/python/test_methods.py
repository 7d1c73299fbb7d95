# HexFeatureWB - LGPL-2.1-or-later
"""The driver: methods in order, the best mesh is kept, and the report tells why."""
import filecmp
import json
import math
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import hexfeature


def test_tet_split_alone(parts):
    mesh = hexfeature.mesh(parts / "plate.step", size=4, method="tet-split")
    assert mesh.method == "tet-split" and mesh.certified
    report = mesh.report
    assert report["quality"]["min_scaled_jacobian"] > 0.1
    assert report["quality"]["volume_error"] < 0.03
    assert report["faithfulness"]["faces_without_quads"] == []
    assert report["faithfulness"]["sharp_edges_not_followed"] == []
    assert report["faithfulness"]["largest_node_deviation"] < 1e-8
    assert [a["method"] for a in report["attempts"]] == ["tet-split"]


def test_auto_ends_with_the_first_method_that_suffices(parts):
    mesh = hexfeature.mesh(parts / "plate.step", size=4)
    assert mesh.method == "feature-line"
    assert {a["method"] for a in mesh.report["attempts"]} == {"feature-line"}
    assert sum(a["made_the_mesh"] for a in mesh.report["attempts"]) == 1


@pytest.mark.parametrize("part", ["plate.step", "turned_plate.step"])
@pytest.mark.parametrize("method", ["tet-split", "auto"])
def test_the_same_file_whatever_the_threads(parts, tmp_path, method, part):
    for threads in (1, 2):
        hexfeature.mesh(parts / part, size=5, method=method, threads=threads).write(tmp_path / f"{threads}.vtk")
    assert filecmp.cmp(tmp_path / "1.vtk", tmp_path / "2.vtk", shallow=False)


@pytest.mark.parametrize("limit", [0.02, 0.2])
@pytest.mark.parametrize("method", ["feature-line", "tet-split", "auto"])
def test_the_time_limit_of_the_run_is_told_as_that(parts, method, limit):
    with pytest.raises(hexfeature.MeshingError) as caught:
        hexfeature.mesh(parts / "plate.step", size=0.4, method=method, time_limit=limit)
    assert (caught.value.kind, caught.value.reason) == ("cancelled", "time limit reached")


@pytest.mark.skipif(sys.platform != "linux", reason="elsewhere a process is not told its size")
@pytest.mark.parametrize("method", ["tet-split", "auto"])
def test_the_memory_limit_ends_every_method_with_an_error(parts, tmp_path, method):
    # A process of its own: this one may hold memory that earlier tests have freed.
    run = subprocess.run([sys.executable, "-m", "hexfeature", "mesh", str(parts / "plate.step"), "-o", str(tmp_path / "m.vtk"),
                          "--size", "0.8", "--method", method, "--memory-limit", "15"],
                         capture_output=True, text=True, env=dict(os.environ, PYTHONPATH=str(Path(hexfeature.__file__).parents[1])))
    assert run.returncode == 4
    assert "memory limit reached" in run.stderr and "allow more memory" in run.stderr
    assert list(tmp_path.iterdir()) == []


def test_limits_of_the_part_stand_beside_the_result(parts, tmp_path):
    limits = hexfeature.mesh(parts / "plate.step", size=5).report["limits"]
    json.dumps(limits)
    assert limits["bound"] == pytest.approx(1)
    assert limits["face_tips"] == []
    edges = limits["sharp_edges"]
    assert len(edges) == 14  # twelve of the block, two rims of the hole
    for e in edges:
        assert e["angle_degrees"] == pytest.approx(90)
        assert e["bound"] == pytest.approx(1) and e["bound_for_elements"] == 1
        assert 0 < e["min_scaled_jacobian"] <= e["bound"] + 1e-9
        assert e["most_elements"] >= 1


def test_the_bound_of_a_sharp_edge(tmp_path):
    wedge = tmp_path / "wedge.step"
    subprocess.run(["/usr/bin/python3", "-c", """
import sys
sys.path += ["/usr/lib/freecad-python3/lib", "/usr/lib/freecad/lib"]
import FreeCAD, Part
from FreeCAD import Vector as V
Part.Face(Part.makePolygon([V(0, 0, 0), V(20, 0, 0), V(0, 0, 20), V(0, 0, 0)])).extrude(V(0, 10, 0)).exportStep(sys.argv[1])
""", str(wedge)], check=True, capture_output=True)
    limits = hexfeature.mesh(wedge, size=3).report["limits"]
    assert limits["bound"] == pytest.approx(math.sin(math.radians(45)))
    assert sorted(round(e["angle_degrees"]) for e in limits["sharp_edges"])[:2] == [45, 45]


@pytest.mark.parametrize("size", [3.9, 3.1, 2.6])
def test_a_circle_of_several_cad_edges_is_followed_all_round(parts, size):
    """Where no point stands on the vertex between two of them, the mesh edge across it belongs to the circle like the others."""
    fit = hexfeature.mesh(parts / "boss_with_foot_in_pieces.step", size=size, stop_after="fit").stage("fit")
    followed = {tuple(e) for e in np.sort(fit["feature_edges"], axis=1)}
    quads, points = fit["quads"], fit["points"]
    edges = {tuple(sorted(pair)) for q in quads for pair in zip(q, np.roll(q, -1))}
    on_foot = np.isclose(np.hypot(points[:, 0], points[:, 1]), 12) & np.isclose(points[:, 2], 8)
    foot = {e for e in edges if on_foot[e[0]] and on_foot[e[1]]}
    assert len(foot) == on_foot.sum() > 12
    assert foot <= followed
