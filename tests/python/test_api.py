# HexFeatureWB - LGPL-2.1-or-later
"""The Python interface: arrays, callbacks, cancel, threads."""
import subprocess
import sys
import threading
import time
from pathlib import Path

import numpy as np
import pytest

import hexfeature


def test_arrays_of_a_box(box_mesh):
    m = box_mesh
    assert m.certified and m.order == 1 and m.method == "feature-line"
    assert m.points.shape == (9 * 5 * 3, 3) and m.hexes.shape == (64, 8)
    assert m.quads.shape == (2 * (8 * 4 + 8 * 2 + 4 * 2), 4)
    assert m.hexes20.shape == (0, 20) and m.quads8.shape == (0, 8)
    assert set(m.quad_face) == {1, 2, 3, 4, 5, 6} and set(m.hex_solid) == {1}
    assert np.ptp(m.points, axis=0) == pytest.approx([40, 20, 10])
    assert np.bincount(m.node_dim, minlength=4).tolist() == [8, 4 * (7 + 3 + 1), 2 * (7 * 3 + 7 + 3), 7 * 3]
    assert len(m.feature_edges) == 4 * (8 + 4 + 2) and set(m.feature_edge_cad) == set(range(1, 13))


def test_arrays_cannot_be_written_to_and_outlive_the_mesh(parts):
    points = hexfeature.mesh(parts / "box.step", size=10).points
    with pytest.raises(ValueError):
        points[0, 0] = 1
    assert np.isfinite(points).all()


def test_second_order_midpoints(box_mesh2):
    m = box_mesh2
    assert m.order == 2 and m.hexes20.shape == (64, 20) and m.quads8.shape[1] == 8
    assert (m.hexes20[:, :8] == m.hexes).all()
    bottom = m.hexes20[:, [0, 1]]
    assert m.points[m.hexes20[:, 8]] == pytest.approx(m.points[bottom].mean(axis=1))
    assert len(m.node_dim) == len(m.points)


def test_brep_text_gives_the_same_mesh(parts, box_mesh):
    m = hexfeature.mesh_brep((parts / "box.brep").read_text(), size=5)
    assert len(m.hexes) == len(box_mesh.hexes)
    with pytest.raises(hexfeature.MeshingError) as caught:
        hexfeature.mesh_brep("garbage", size=5)
    assert caught.value.kind == "bad_input"


def test_a_part_that_is_kept_for_the_next_run_gives_the_same_mesh_as_one_just_read(parts, tmp_path):
    brep = (parts / "turned_plate.brep").read_text()

    def bytes_of(mesh):
        return mesh.points.tobytes(), mesh.hexes.tobytes()

    first = bytes_of(hexfeature.mesh_brep(brep, size=5))
    hexfeature.mesh_brep((parts / "box.brep").read_text(), size=5)
    fresh = bytes_of(hexfeature.mesh_brep(brep, size=5))  # another part was read between
    hexfeature.mesh_brep(brep, size=4, stop_after="labels")
    with pytest.raises(hexfeature.MeshingError):
        hexfeature.mesh_brep(brep, size=1000)
    assert first == fresh == bytes_of(hexfeature.mesh_brep(brep, size=5)) == bytes_of(hexfeature.mesh_brep(brep, size=5))
    # It is still there after a run that was cancelled, and gone after one of another part.
    log = []
    with pytest.raises(hexfeature.MeshingError):
        hexfeature.mesh_brep(brep, size=2, cancelled=lambda: True)
    hexfeature.mesh_brep(brep, size=5, stop_after="read", log=log.append)
    assert sum("from the run before" in line for line in log) == 1
    hexfeature.mesh_brep((parts / "box.brep").read_text(), size=5, stop_after="read", log=log.append)
    hexfeature.mesh_brep(brep, size=5, stop_after="read", log=log.append)
    assert sum("from the run before" in line for line in log) == 1
    # A part that is kept must not bother the interpreter's end.
    code = "import sys; sys.path.insert(0, sys.argv[2]); import hexfeature; hexfeature.mesh_brep(open(sys.argv[1]).read(), size=5)"
    package = str(Path(hexfeature.__file__).parents[1])
    assert subprocess.run([sys.executable, "-c", code, str(parts / "turned_plate.brep"), package]).returncode == 0


@pytest.mark.parametrize("ending", ["iges", "stl", "brep"])
def test_other_part_formats(parts, ending):
    m = hexfeature.mesh(parts / f"box.{ending}", size=5)
    assert len(m.hexes) == 64


@pytest.mark.parametrize("part, order", [("plate.step", 2), ("turned_plate.stl", 1)])
def test_the_same_file_every_time_and_with_any_number_of_threads(parts, tmp_path, part, order):
    texts = []
    for threads in (1, 2, 2):
        hexfeature.mesh(parts / part, size=3, order=order, threads=threads).write(tmp_path / "m.vtk")
        texts.append((tmp_path / "m.vtk").read_bytes())
    assert texts[0] == texts[1] == texts[2]


@pytest.mark.parametrize("ending", ["step", "stl"])
def test_a_part_turned_by_any_angle_meshes_as_well(parts, ending):
    straight = hexfeature.mesh(parts / f"plate.{ending}", size=4)
    turned = hexfeature.mesh(parts / f"turned_plate.{ending}", size=4)
    assert len(turned.hexes) == len(straight.hexes)
    qualities = [m.report["quality"]["min_scaled_jacobian"] for m in (straight, turned)]
    assert min(qualities) > 0.6 and qualities[1] > qualities[0] - 0.1
    again = hexfeature.mesh(parts / f"turned_plate.{ending}", size=4, stop_after="fit").stage("fit")["points"]
    assert np.abs(again.mean(axis=0) - turned.points.mean(axis=0)).max() < 1, "a stage is in the part's own coordinates"


def test_a_size_is_chosen(parts):
    m = hexfeature.mesh(parts / "box.step")
    assert 1000 < len(m.hexes) < 9000


def test_two_solids(parts):
    m = hexfeature.mesh(parts / "two_solids.step", size=5)
    assert set(m.hex_solid) == {1, 2} and (m.hex_solid == 2).sum() == 1
    assert set(m.quad_face) == set(range(1, 13))


def test_progress_is_told_and_monotone_in_every_step(parts):
    seen = []
    hexfeature.mesh(parts / "box.step", size=5, progress=lambda step, fraction: seen.append((step, fraction)))
    steps = list(dict.fromkeys(step for step, _ in seen))
    assert steps[0] == "read" and {"surface", "labels", "fit", "smooth"} <= set(steps)
    for step in steps:
        fractions = [f for s, f in seen if s == step]
        assert all(0 <= f <= 1 for f in fractions)


def test_cancel_is_answered_quickly_and_other_threads_run(parts):
    cancelled, ticks = threading.Event(), []
    errors = []

    def work():
        try:
            hexfeature.mesh(parts / "plate.step", size=0.4, cancelled=cancelled.is_set)
        except hexfeature.MeshingError as error:
            errors.append((error.kind, time.monotonic()))

    thread = threading.Thread(target=work)
    thread.start()
    for _ in range(20):
        time.sleep(0.01)
        ticks.append(time.monotonic())
    cancelled.set()
    asked = time.monotonic()
    thread.join(20)
    assert [kind for kind, _ in errors] == ["cancelled"]
    assert errors[0][1] - asked < 0.5
    assert ticks[-1] - ticks[0] < 2


def test_an_error_in_a_callback_comes_back(parts):
    def progress(step, fraction):
        raise KeyError("from the callback")

    with pytest.raises(KeyError):
        hexfeature.mesh(parts / "box.step", size=5, progress=progress)


def test_the_same_mesh_every_time(parts):
    a, b = (hexfeature.mesh(parts / "plate.step", size=4, threads=n) for n in (1, 2))
    assert np.array_equal(a.points, b.points) and np.array_equal(a.hexes, b.hexes)


def test_stages_are_arrays(parts):
    m = hexfeature.mesh(parts / "plate.step", size=5)
    labels = m.stage("labels")
    assert len(labels["label"]) == len(labels["triangles"]) == len(labels["chart"])
    assert set(np.unique(labels["label"])) == set(range(6))
    shape = m.stage("shape")
    assert len(shape["arcs"]) == len(shape["arc_axis"]) and len(shape["corners"]) == 16
    polycube = m.stage("polycube")
    assert np.asarray(polycube["corner_coordinates"]).shape == (16, 3)
    with pytest.raises(hexfeature.MeshingError):
        m.stage("no such stage")


def test_repr(box_mesh):
    assert "64 hexahedra" in repr(box_mesh)


def test_one_attempt_made_the_mesh(tmp_path):
    """Without sheets this part's first mesh is poor, so that a second labelling is tried; one of the two is returned."""
    draw = Path(__file__).resolve().parents[1] / "parts" / "make_parts.py"
    subprocess.run(["/usr/bin/python3", str(draw), str(tmp_path), "pipe_tee"], check=True, capture_output=True)
    attempts = hexfeature.mesh(tmp_path / "pipe_tee.step", size=4.5, sheets=False).report["attempts"]
    assert len(attempts) > 1
    assert sum(a["made_the_mesh"] for a in attempts) == 1
    assert all(a["made_the_mesh"] or a["reason"] for a in attempts)


@pytest.mark.parametrize("factor", [0.8, 1, 1.25])
def test_turned_shaft_near_the_optimum(tmp_path, factor):
    """Squares of cylinders on one axis, and the sheets along them, fit whatever the sizes; 0.866 is the best there is."""
    draw = Path(__file__).resolve().parents[1] / "parts" / "make_parts.py"
    subprocess.run(["/usr/bin/python3", str(draw), str(tmp_path), "shaft"], check=True, capture_output=True)
    report = hexfeature.mesh(tmp_path / "shaft.step", size=3.5 * factor).report
    assert report["method"] == "feature-line"
    assert report["quality"]["min_scaled_jacobian"] > 0.84
    assert report["sheets"]["refused"] == 0


@pytest.mark.parametrize("asked", [1, 2, 3])
def test_what_the_callers_question_throws_comes_back(parts, asked):
    """Also from OpenCASCADE's own threads, which must not throw."""
    count = 0

    def cancelled():
        nonlocal count
        count += 1
        if count >= asked:
            raise LookupError(f"asked {asked} times")
        return False

    with pytest.raises(LookupError, match="asked"):
        hexfeature.mesh(parts / "plate.step", size=1.5, threads=2, cancelled=cancelled)
