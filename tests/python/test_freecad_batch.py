# HexFeatureWB - LGPL-2.1-or-later
"""The launcher build/hexfeature-batch with the real freecadcmd: files in, documents and a telling exit code out."""
import csv
import os
import shutil
import subprocess

import pytest
from conftest import ROOT

LAUNCHER = ROOT / "build" / "hexfeature-batch"
FREECADCMD = os.environ.get("FREECADCMD", "freecadcmd")

pytestmark = [
    pytest.mark.skipif(not shutil.which(FREECADCMD), reason="there is no freecadcmd: install FreeCAD to test the batch in it"),
    pytest.mark.skipif(not LAUNCHER.exists(), reason="there is no build/hexfeature-batch: run make build"),
]


def batch(*arguments, **environment):
    return subprocess.run([str(a) for a in (LAUNCHER, *arguments)], capture_output=True, text=True, timeout=120,
                          stdin=subprocess.DEVNULL, env={**os.environ, **environment})


def summary(folder):
    with open(folder / "summary.csv", newline="") as table:
        return list(csv.DictReader(table))


def test_a_good_file(parts, tmp_path):
    done = batch(parts / "box.step", "--out", tmp_path / "a folder", "--size", 5, "--order", 1)
    assert done.returncode == 0, done.stdout + done.stderr
    assert {p.name for p in (tmp_path / "a folder").iterdir()} == {"box.FCStd", "box.unv", "box.json", "summary.csv"}
    row, = summary(tmp_path / "a folder")
    assert (row["result"], row["hexes"], row["min_sj"]) == ("meshed", "64", "1.0")


def test_a_bad_file(parts, tmp_path):
    done = batch(parts / "truncated.step", tmp_path / "missing.step", "--out", tmp_path)
    assert done.returncode == 3, done.stdout + done.stderr
    assert [row["result"] for row in summary(tmp_path)] == ["unreadable"] * 2
    assert "Traceback" not in done.stderr


def test_goes_on_after_a_bad_file(parts, tmp_path):
    done = batch(parts / "empty.step", parts / "two_solids.step", "--out", tmp_path, "--size", 5)
    assert done.returncode == 4, done.stdout + done.stderr
    assert [row["result"] for row in summary(tmp_path)] == ["unreadable", "meshed", "meshed"]
    assert (tmp_path / "two_solids-Solid2.FCStd").exists()


def test_usage(tmp_path):
    done = batch("--nonsense")
    assert done.returncode == 2 and "usage: hexfeature-batch" in done.stdout + done.stderr


def test_without_freecad(parts, tmp_path):
    done = batch(parts / "box.step", "--out", tmp_path, FREECADCMD="no-such-freecadcmd")
    assert done.returncode == 127 and "install FreeCAD" in done.stderr
