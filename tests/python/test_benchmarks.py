# HexFeatureWB - LGPL-2.1-or-later
"""The benchmarks' family of parts is the same every time, and the label benchmark tells what fails."""
import csv
import subprocess
from pathlib import Path

BENCHMARKS = Path(__file__).resolve().parents[2] / "benchmarks"


def run(script, *words):
    """One of the benchmarks as a command."""
    return subprocess.run(["/usr/bin/python3", str(BENCHMARKS / script), *map(str, words)], capture_output=True, text=True, timeout=300)


def test_machined_blocks_label_and_are_the_same_every_time(tmp_path):
    for folder in ("once", "again"):
        done = run("machined_blocks.py", tmp_path / folder, "--count", 3)
        assert done.returncode == 0, done.stderr
    once, again = ((tmp_path / folder / "parts.csv").read_text() for folder in ("once", "again"))
    assert once == again and len(once.splitlines()) == 4

    done = run("labels.py", tmp_path / "once" / "parts.csv", "--turns", 1, "--out", tmp_path / "out")
    assert done.returncode == 0, done.stdout + done.stderr
    with open(tmp_path / "out" / "labels.csv", newline="") as table:
        rows = list(csv.DictReader(table))
    assert [row["outcome"] for row in rows] == ["valid"] * 3
    assert all(int(row["charts"]) >= 6 for row in rows)


def test_a_part_that_does_not_label_is_counted_with_its_cause(parts, tmp_path):
    table = tmp_path / "parts.csv"
    table.write_text(f"part,size\n{parts / 'plate.step'},1e-4\n")
    done = run("labels.py", table, "--out", tmp_path)
    assert done.returncode == 1
    assert "valid 0" in done.stdout
