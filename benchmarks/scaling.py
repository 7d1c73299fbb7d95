#!/usr/bin/python3
# HexFeatureWB - LGPL-2.1-or-later
"""How cost grows with the number of elements: benchmarks/scaling.py OUT_DIR [--to N] [PART ...]

Meshes own parts (bracket and plate_with_holes unless named) by the whole command, at sizes for about 1,000, 10,000, 100,000 and
1,000,000 hexahedra, as far as --to (default 100000). Prints a row each: hexahedra, wall and processor seconds, peak memory,
worst element, and the seconds of every step that takes 0.05 s or more. Exit code 1 when one got no mesh.
"""
import argparse
import csv
import json
import os
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]


def run(part, size):
    """Mesh once; (seconds, processor seconds, peak MB, report, or None without a mesh)."""
    report = part.with_suffix(".scaling.json")
    command = [str(ROOT / "build" / "hexfeature"), "mesh", str(part), "-o", str(part.with_suffix(".scaling.vtk")), "--size", str(size),
               "--report", str(report), "--quiet"]
    started = time.monotonic()
    child = subprocess.Popen(command)
    _, status, usage = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    seconds = time.monotonic() - started
    read = json.loads(report.read_text()) if child.returncode == 0 else None
    return seconds, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024, read


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", type=Path)
    parser.add_argument("parts", nargs="*", default=["bracket", "plate_with_holes"])
    parser.add_argument("--to", type=int, default=100000)
    a = parser.parse_args()
    a.out.mkdir(parents=True, exist_ok=True)
    if not (a.out / "parts.csv").exists():
        subprocess.run(["/usr/bin/python3", str(ROOT / "tests" / "parts" / "make_parts.py"), str(a.out)], check=True, capture_output=True)
    with open(a.out / "parts.csv", newline="") as table:
        sizes = {Path(r["part"]).stem: (r["part"], float(r["size"])) for r in csv.DictReader(table)}
    print(f"{'part':20s} {'size':>7s} {'hexes':>8s} {'wall s':>7s} {'cpu s':>7s} {'MB':>6s} {'min SJ':>7s}  steps")
    failed = 0
    for name in a.parts:
        file, size = sizes[name]
        known = None
        for goal in (1000, 10000, 100000, 1000000):
            if goal > a.to:
                break
            if known:  # the same part at another size tells how many there will be
                size = known[1] * (known[0] / goal) ** (1 / 3)
            seconds, processor, memory, report = run(a.out / file, round(size, 4))
            if report is None:
                failed += 1
                print(f"{name:20s} {size:7.3f} {'no mesh':>8s} {seconds:7.2f} {processor:7.2f} {memory:6.0f}", flush=True)
                continue
            quality = report["quality"]
            known = (quality["hexes"], size)
            steps = ", ".join(f"{step} {s:.2f}" for step, s in report["step_seconds"].items() if s >= 0.05)
            print(f"{name:20s} {size:7.3f} {quality['hexes']:8d} {seconds:7.2f} {processor:7.2f} {memory:6.0f} "
                  f"{quality['min_scaled_jacobian']:7.3f}  {steps}", flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
