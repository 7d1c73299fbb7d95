#!/usr/bin/python3
# HexFeatureWB - LGPL-2.1-or-later
"""Labels and quantization on many parts: benchmarks/labels.py PARTS.csv [--turns N] [--mesh] [--out DIR] [--only REGEX]

PARTS.csv has the columns part (a file beside it) and size. Runs the feature-line method as far as the filled polycube, each part in
a process of its own, and prints which condition fails where: V1-V4 of the feature shape, V5 and V6 of the lattice, and the seconds that
labels and quantization take. --turns N does so N times for each part: turned by 77.7 degrees about (1, 2, 3), then by chance.
--mesh goes on to the certified mesh, and counts those. With --out, DIR/labels.csv has a line a part, and pictures of failed labels
stay in DIR.
benchmarks/machined_blocks.py draws a family of parts to run it on. Exit code 1 when a part has no valid polycube.
"""
import argparse
import collections
import csv
import json
import math
import random
import re
import resource
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
COLUMNS = ("part", "outcome", "charts", "defects", "expand", "labels_s", "quantize_s", "cpu_s", "min_sj", "reason")
TURN_SEED = 7
LIMIT = 120  # seconds for one part


def turned(part, folder, turn):
    """The part as STEP, turned: `turn` 0 by 77.7 degrees about (1, 2, 3), others by chance (uniformly over all rotations)."""
    sys.path += ["/usr/lib/freecad-python3/lib", "/usr/lib/freecad/lib"]
    import FreeCAD
    import Part

    shape = Part.read(str(part))
    if turn == 0:
        rotation = FreeCAD.Rotation(FreeCAD.Vector(1, 2, 3), 77.7)
    else:
        chance = random.Random(f"{TURN_SEED} {turn}")
        u, a, b = chance.random(), 2 * math.pi * chance.random(), 2 * math.pi * chance.random()
        rotation = FreeCAD.Rotation(math.sqrt(1 - u) * math.sin(a), math.sqrt(1 - u) * math.cos(a), math.sqrt(u) * math.sin(b),
                                    math.sqrt(u) * math.cos(b))
    out = folder / f"{part.stem}-turn{turn}.step"
    moved = shape.copy()
    moved.Placement = FreeCAD.Placement(FreeCAD.Vector(), rotation).multiply(moved.Placement)
    moved.exportStep(str(out))
    return out


def run(part, size, out, words):
    """One run of the program; returns its report, or what stands for one."""
    report = Path(out).with_suffix(".json")
    report.unlink(missing_ok=True)
    command = [ROOT / "build" / "hexfeature", "mesh", part, "-o", out, "--size", size, "--method", "feature-line", "--report", report,
               "--quiet", *words]
    try:
        done = subprocess.run([str(word) for word in command], capture_output=True, text=True, timeout=LIMIT)
    except subprocess.TimeoutExpired:
        return {"error": {"step": "time", "reason": f"no answer in {LIMIT} s", "cad_faces": []}}
    try:
        return json.loads(report.read_text())
    except (OSError, ValueError):
        return {"error": {"step": "crash", "reason": done.stderr.strip()[-200:], "cad_faces": []}}


def judge(part, size, folder, choice):
    """Label, quantize and fill one part; returns its row."""
    words = ["--labels", choice.labels]
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    report = run(part, size, folder / f"{part.stem}.vtk", words + ([] if choice.mesh else ["--stop-after", "polycube"]))
    row = dict.fromkeys(COLUMNS, "")
    row["part"], row["outcome"] = part.stem, "valid"
    row["cpu_s"] = f"{resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before:.2f}"
    error = report.get("error")
    if error:
        row["outcome"], row["reason"] = error["step"], error["reason"] + " @" + " ".join(map(str, error["cad_faces"][:8]))
        if error["step"] == "labels":
            row["outcome"] = "labels " + re.search(r"V\d", error["reason"]).group(0)
            run(part, size, folder / f"{part.stem}.labels.vtk", words + ["--stop-after", "labels"])  # its picture
        return row
    seconds, labels = report["step_seconds"], report["labels"]
    row.update(charts=labels["charts"], defects=f"{labels['defects']:.2f}", expand=labels["expansions"],
               labels_s=f"{seconds.get('labels', 0):.2f}", quantize_s=f"{seconds.get('lattice', 0):.2f}")
    if choice.mesh:
        row["min_sj"] = f"{report['quality']['min_scaled_jacobian']:.3f}"
    return row


def main(choice):
    """Run the table; returns the exit code."""
    folder = Path(choice.out or tempfile.mkdtemp(prefix="labels-"))
    folder.mkdir(parents=True, exist_ok=True)
    parts = Path(choice.parts)
    with open(parts, newline="") as table:
        wanted = [r for r in csv.DictReader(table) if re.search(choice.only, r["part"])]
    rows = []
    line = "{:32s} {:10s} {:>6} {:>7} {:>6} {:>8} {:>10} {:>6} {:>6} {}"
    print(line.format(*COLUMNS))
    for entry in wanted:
        for turn in range(choice.turns or 1):
            part = parts.parent / entry["part"]
            if choice.turns:
                part = turned(part, folder, turn)
            row = judge(part, entry["size"], folder, choice)
            rows.append(row)
            print(line.format(*(row[column] for column in COLUMNS)), flush=True)
    with open(folder / "labels.csv", "w", newline="") as table:
        writer = csv.DictWriter(table, COLUMNS)
        writer.writeheader()
        writer.writerows(rows)
    good = [r for r in rows if r["outcome"] == "valid"]
    times = sorted(float(r["labels_s"]) + float(r["quantize_s"]) for r in good) or [0]
    print(f"\n{len(rows)} parts, valid {len(good)} ({100 * len(good) / max(1, len(rows)):.1f}%); labels + quantization: median "
          f"{statistics.median(times):.2f} s, worst {times[-1]:.2f} s")
    for cause, count in collections.Counter(r["outcome"] for r in rows if r["outcome"] != "valid").most_common():
        print(f"  {count:4d} {cause}")
    return 0 if len(good) == len(rows) else 1


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("parts")
    parser.add_argument("--out", default="")
    parser.add_argument("--turns", type=int, default=0)
    parser.add_argument("--mesh", action="store_true")
    parser.add_argument("--only", default="")
    parser.add_argument("--labels", default="regions", choices=("regions", "paper"))
    sys.exit(main(parser.parse_args()))
