# HexFeatureWB - LGPL-2.1-or-later
"""What the verification measures with: the rigid motions it takes out, the blocks by formula, curved faces' areas."""
import sys
from pathlib import Path

import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "benchmarks" / "verification"))

import mapped  # noqa: E402
import supports  # noqa: E402

CUBE = np.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)], float)
STRETCH = CUBE * [0, 0, 1e-3]


def deck(path, held):
    """Two cubes apart; the nodes in `held` are fixed."""
    points = np.vstack([CUBE, CUBE + [5, 0, 0]])
    lines = ["*NODE, NSET=Nall"] + ["%d, %r, %r, %r" % (n, *p) for n, p in enumerate(points.tolist(), 1)]
    lines += ["*ELEMENT, TYPE=C3D8, ELSET=Evolumes", "1,1,2,3,4,5,6,7,8", "2,9,10,11,12,13,14,15,16"]
    lines += ["*NSET,NSET=Held"] + ["%d," % n for n in held] + ["*BOUNDARY"] + ["Held,%d" % axis for axis in (1, 2, 3)]
    path.write_text("\n".join(lines) + "\n")
    return path


def test_a_turn_about_a_held_line_is_taken_out_and_a_body_that_is_not_held_left_out(tmp_path):
    path = deck(tmp_path / "held.inp", [1, 2])  # the first cube turns about the x axis
    turn = 1e3 * np.column_stack([np.zeros(8), -CUBE[:, 2], CUBE[:, 1]])
    found = supports.significant(path, np.vstack([STRETCH + turn, STRETCH + 1e6]))
    assert np.isnan(found[8:]).all()
    still = supports.significant(path, np.vstack([STRETCH, STRETCH]))[:8]
    assert found[:8] == pytest.approx(still, abs=1e-9) and np.abs(still).max() > 1e-4


def test_nothing_is_taken_out_of_a_held_body(tmp_path):
    path = deck(tmp_path / "held.inp", [1, 2, 3, 9, 10, 12])
    moved = np.vstack([STRETCH, STRETCH + 0.5])
    assert supports.significant(path, moved) == pytest.approx(moved)


def test_a_block_by_formula_has_its_nodes_and_faces():
    counts = (2, 3, 4)
    points, cells, sides = mapped.sector(mapped.ring(10, 20, 5), counts)
    assert len(points) == mapped.node_count(counts) == len(np.unique(cells)) and len(cells) == 24
    assert {name: len(quads) for name, quads in sides.items()} == {"low": 6, "top": 6, "y0": 8, "x0": 8, "inner": 12, "outer": 12}
    assert np.hypot(*points[sides["inner"].ravel(), :2].T) == pytest.approx(10)
    assert points[sides["x0"].ravel(), 0] == pytest.approx(0, abs=1e-12)
