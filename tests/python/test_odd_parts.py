# HexFeatureWB - LGPL-2.1-or-later
"""Parts as users send them (tests/parts/make_odd_parts.py): a mesh, or an error that says what is wrong; never a wrong mesh."""
import subprocess
from pathlib import Path

import numpy as np
import pytest

import hexfeature

DRAW = Path(__file__).resolve().parents[1] / "parts" / "make_odd_parts.py"
VOLUME = 40 * 40 * 10 - np.pi * 64 * 10


@pytest.fixture(scope="session")
def odd(tmp_path_factory):
    folder = tmp_path_factory.mktemp("odd")
    subprocess.run(["/usr/bin/python3", str(DRAW), str(folder)], check=True, capture_output=True)
    return folder


@pytest.fixture(scope="session")
def plain(odd):
    return hexfeature.mesh(odd / "plate.step", size=4)


def worst(mesh):
    return mesh.report["quality"]["min_scaled_jacobian"]


@pytest.mark.parametrize("name, size, factor", [
    ("far.step", 4, 1), ("tiny.step", 1e-4, 2.5e-5), ("huge.step", 1e4, 2500), ("metre.step", 4000, 1000), ("inch.step", 4 * 25.4, 25.4),
    ("stray.step", 4, 1), ("inside_out.brep", 4, 1), ("shell_inside_out.brep", 4, 1), ("one_face_turned.brep", 4, 1),
    ("loose_faces.brep", 4, 1)])
def test_the_same_plate_in_another_guise_has_the_same_mesh(odd, plain, name, size, factor):
    mesh = hexfeature.mesh(odd / name, size=size)
    assert mesh.certified
    assert len(mesh.hexes) == len(plain.hexes)
    assert worst(mesh) == pytest.approx(worst(plain), abs=0.01)
    assert mesh.report["part"]["volume"] == pytest.approx(VOLUME * factor**3, rel=1e-6)
    assert mesh.report["quality"]["volume_error"] == pytest.approx(plain.report["quality"]["volume_error"], abs=2e-4)
    assert set(mesh.quad_face) == set(plain.quad_face)
    assert not mesh.report["faithfulness"]["sharp_edges_not_followed"]


def test_coordinates_are_the_parts_own(odd):
    mesh = hexfeature.mesh(odd / "far.step", size=4)
    assert mesh.points.min(axis=0) == pytest.approx([1e6, -1e6, 1e6], abs=1e-5)
    assert mesh.points.max(axis=0) == pytest.approx([1e6 + 40, -1e6 + 40, 1e6 + 10], abs=1e-5)


@pytest.mark.parametrize("name, word", [("stray.step", "stray"), ("loose_faces.brep", "sewn"), ("one_face_turned.brep", "sewn")])
def test_what_was_left_out_or_mended_is_said(odd, name, word):
    mesh = hexfeature.mesh(odd / name, size=4, stop_after="read")
    assert any(word in warning for warning in mesh.report["warnings"]), mesh.report["warnings"]


def test_mid_side_nodes_far_away_are_on_the_cad(odd):
    """There a projection is as exact as the coordinates, which is less than in proportion to an edge's length."""
    second = hexfeature.mesh(odd / "far_turned.step", size=3, order=2).report["second_order"]
    assert second["straightened_nodes"] == second["straightened_faces"] == []
    assert second["largest_mid_side_deviation"] < 1e-9


def test_a_closed_void(odd):
    mesh = hexfeature.mesh(odd / "hollow.step", size=5)
    assert len(mesh.hexes) == 6**3 - 2**3
    assert set(mesh.quad_face) == set(range(1, 13))


@pytest.mark.parametrize("name, size", [("tiny_edge.step", 1000), ("sliver.step", 4), ("touching.step", 3), ("torn.brep", 4)])
def test_a_mesh_or_a_reason(odd, name, size):
    try:
        mesh = hexfeature.mesh(odd / name, size=size, time_limit=600)
    except hexfeature.MeshingError as error:
        assert error.kind in ("bad_input", "no_mesh") and error.reason and error.hint
    else:
        assert mesh.certified and mesh.report["quality"]["volume_error"] < 0.03


def test_solids_keep_their_names(odd, tmp_path):
    mesh = hexfeature.mesh(odd / "named_solids.step", size=5)
    assert mesh.report["part"]["solid_names"] == ["left plate", "right block"]
    assert mesh.solid_groups == {"left_plate": [1], "right_block": [2]}
    assert any("do not share nodes" in warning for warning in mesh.report["warnings"])
    mesh.write(tmp_path / "m.inp")
    assert "*ELSET, ELSET=right_block\nSolid2\n" in (tmp_path / "m.inp").read_text()


@pytest.mark.parametrize("size", [1, 2])
def test_a_curved_sharp_edge_inside_a_chart(odd, size):
    """A quarter of a circle becomes two sides of a square, and a sheet takes the flat corner between them away."""
    mesh = hexfeature.mesh(odd / "corner_cone.step", size=size, method="feature-line")
    assert mesh.report["faithfulness"]["sharp_edges_not_followed"] == []
    assert worst(mesh) > 0.6


def test_holes_in_two_halves(odd):
    """The halves' borders may be anywhere: nodes stand where they end, and stand evenly enough round the rims."""
    mesh = hexfeature.mesh(odd / "parted_holes.step", size=4, method="feature-line")
    assert mesh.report["faithfulness"]["sharp_edges_not_followed"] == []
    assert worst(mesh) > 0.6
    quads = {face: mesh.quads[mesh.quad_face == face] for face in np.unique(mesh.quad_face)}
    tips = [len(q) for q in quads.values() if 0 < mesh.points[q][..., 2].min() and mesh.points[q][..., 2].max() < 9 + 1e-6]
    assert len(tips) == 6 and tips[0::2] == tips[1::2]


@pytest.mark.parametrize("name, size", [("chamfered", 3.2), ("hub", 4.6)])
def test_what_the_first_mesh_loses_is_brought_back(odd, name, size):
    """Corner triangles and strips narrower than an element need lattice lines of their own; where a fillet ends between bolt holes, points
    are bound to its border after smoothing."""
    mesh = hexfeature.mesh(odd / f"{name}.step", size=size, method="feature-line")
    kept = mesh.report["faithfulness"]
    assert kept["faces_without_quads"] == kept["sharp_edges_not_followed"] == []
    assert set(mesh.quad_face) == set(range(1, mesh.report["part"]["cad_faces"] + 1))
    assert worst(mesh) > 0.4
    assert hexfeature.mesh(odd / f"{name}.step", size=size).method == "feature-line"
    stopped = hexfeature.mesh(odd / f"{name}.step", size=size, stop_after="smooth")
    assert len(stopped.stage("smooth")["hexes"]) == len(mesh.hexes)


@pytest.mark.parametrize("name, size, step", [("thread", 2, "labels"), ("spring", 5, "lattice")])
def test_what_winds_has_no_polycube_and_the_reason_is_told(odd, name, size, step):
    """A screw's flanks lie each above the one before all the way round; a wire's borders cross each other once they are flat."""
    with pytest.raises(hexfeature.MeshingError) as caught:
        hexfeature.mesh(odd / f"{name}.step", size=size, method="feature-line", time_limit=300)
    assert (caught.value.kind, caught.value.step) == ("no_mesh", step)
    assert caught.value.reason and caught.value.hint and caught.value.cad_faces
