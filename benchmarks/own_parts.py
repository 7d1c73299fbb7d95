#!/usr/bin/python3
# HexFeatureWB - LGPL-2.1-or-later
"""Time and quality of the whole command on the project's own parts: benchmarks/own_parts.py OUT_DIR [--page] [NAME ...]

Draws the parts (tests/parts/make_parts.py) when they are not there, meshes each with build/hexfeature at the size that its
table gives, and prints a table. Wall time is that of the whole command, start-up and writing included.
Leaves OUT_DIR/NAME.vtk and OUT_DIR/NAME.json; with --page also writes the table into docs/benchmarks.md.
Exit code 1 when a part got no mesh.
"""
import csv
import json
import os
import platform
import re
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
PAGE = ROOT / "docs" / "benchmarks.md"
BETWEEN = re.compile(r"(<!-- table -->\n).*?(<!-- end of table -->)", re.DOTALL)


def processor():
    """What this machine says of its processor."""
    try:
        return re.search(r"model name\s*: (.*)", Path("/proc/cpuinfo").read_text()).group(1)
    except (OSError, AttributeError):
        return platform.machine()


def write_page(rows, load):
    """The table as Markdown into the page."""
    table = f"{processor()}, {os.cpu_count()} processors, load {load:.1f} from elsewhere at the start.\n\n"
    table += "| part | size | hexahedra | seconds | min SJ | mean SJ | slowest steps |\n|---|---|---|---|---|---|---|\n"
    table += "".join(f"| {' | '.join(row)} |\n" for row in rows)
    PAGE.write_text(BETWEEN.sub(lambda m: m.group(1) + table + m.group(2), PAGE.read_text(encoding="utf-8")), encoding="utf-8")


def main(out, names, page=False):
    """Mesh every part of the table, or those named; returns the exit code."""
    out = Path(out)
    out.mkdir(parents=True, exist_ok=True)
    if not (out / "parts.csv").exists():
        subprocess.run(["/usr/bin/python3", str(ROOT / "tests" / "parts" / "make_parts.py"), str(out)], check=True, capture_output=True)
    with open(out / "parts.csv", newline="") as table:
        rows = [r for r in csv.DictReader(table) if not names or Path(r["part"]).stem in names]
    print(f"{'part':20s} {'hexes':>7s} {'wall s':>7s} {'min SJ':>7s} {'mean SJ':>8s}  slowest steps")
    failed, table, load = 0, [], os.getloadavg()[0]
    for row in rows:
        part = out / row["part"]
        started = time.monotonic()
        command = [ROOT / "build" / "hexfeature", "mesh", part, "-o", part.with_suffix(".vtk"), "--size", row["size"],
                   "--report", part.with_suffix(".json"), "--quiet"]
        done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
        seconds = time.monotonic() - started
        if done.returncode:
            failed += 1
            table.append([part.stem, row["size"], "-", f"{seconds:.2f}", "-", "-", done.stderr.strip().splitlines()[0]])
            print(f"{part.stem:20s} {'-':>7s} {seconds:7.2f} {'-':>7s} {'-':>8s}  {done.stderr.strip().splitlines()[0]}", flush=True)
            continue
        report = json.loads(part.with_suffix(".json").read_text())
        quality = report["quality"]
        slowest = sorted(report["step_seconds"].items(), key=lambda item: -item[1])[:3]
        least, mean = quality["min_scaled_jacobian"], quality["mean_scaled_jacobian"]
        where = ", ".join(f"{step} {s:.2f}" for step, s in slowest)
        print(f"{part.stem:20s} {quality['hexes']:7d} {seconds:7.2f} {least:7.3f} {mean:8.3f}  {where}", flush=True)
        table.append([part.stem, row["size"], str(quality["hexes"]), f"{seconds:.2f}", f"{least:.3f}", f"{mean:.3f}", where])
    if page:
        write_page(table, load)
    return 1 if failed else 0


if __name__ == "__main__":
    words = [word for word in sys.argv[1:] if word != "--page"]
    sys.exit(main(words[0] if words else "out/parts", words[1:], "--page" in sys.argv))
