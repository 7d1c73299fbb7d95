#!/usr/bin/python3
# HexFeatureWB - LGPL-2.1-or-later
"""Parts through the sanitizer build: benchmarks/sanitize.py OUT_DIR [--factor 1.5] [--only REGEX] [--methods auto,tet-split]

Meshes the project's own parts and the odd ones of the tests, and ../shared/parts when it is there, each by every method named, with the
extension of build-sanitize (make sanitize builds it); second order too. An access out of bounds, a use after free or undefined behaviour
ends a run at once and is printed with its stack; so is a crash. Sizes are those of the parts' lists times the factor: a sanitized run takes
about ten times as long. Exit code 1 when there is a finding.
"""
import argparse
import csv
import os
import re
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
PACKAGE = ROOT / "build-sanitize" / "python"
SHARED = ROOT.parent / "shared" / "parts"
FINDING = re.compile(r"runtime error:|ERROR: AddressSanitizer|AddressSanitizer:DEADLYSIGNAL|CHECK failed")
SAID = (0, 2, 3, 4)  #: a mesh, or an error that says why there is none
TIMED_OUT = 130


def environment():
    """Of a process that loads the sanitized extension: a program that is not sanitized itself must load the run-time library first."""
    libraries = [subprocess.run(["gcc", f"-print-file-name={name}"], check=True, capture_output=True, text=True).stdout.strip()
                 for name in ("libasan.so", "libstdc++.so.6")]
    # OpenCASCADE and Python keep things for the life of the process: no leak check.
    return dict(os.environ, LD_PRELOAD=" ".join(libraries), PYTHONPATH=str(PACKAGE), HEXFEATURE_GUARD="0",
                ASAN_OPTIONS="detect_leaks=0", UBSAN_OPTIONS="print_stacktrace=1:halt_on_error=1")


def parts(folder, factor):
    """(file, size) of all parts."""
    for script in ("make_parts.py", "make_odd_parts.py"):
        subprocess.run(["/usr/bin/python3", str(ROOT / "tests" / "parts" / script), str(folder)], check=True, capture_output=True)
    listed = {}
    for table in (folder / "parts.csv", SHARED / "parts.csv"):
        if table.exists():
            with open(table, newline="") as file:
                listed.update({table.parent / row["part"]: factor * float(row["size"]) for row in csv.DictReader(file)})
    # The odd parts are in no list: 0 leaves the size to the program.
    odd = {p: 0 for p in folder.iterdir() if p.suffix in (".step", ".brep", ".stl") and p not in listed}
    return sorted((listed | odd).items())


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", type=Path)
    parser.add_argument("--factor", type=float, default=1.5)
    parser.add_argument("--only", default=".", help="regular expression for the file's name")
    parser.add_argument("--methods", default="auto,tet-split")
    parser.add_argument("--limit", type=float, default=900, help="seconds a run")
    arguments = parser.parse_args()
    arguments.out.mkdir(parents=True, exist_ok=True)
    findings = unfinished = runs = 0
    for part, size in parts(arguments.out, arguments.factor):
        for method in arguments.methods.split(",") if re.search(arguments.only, part.name) else ():
            mesh = arguments.out / f"{part.stem}-{method}.vtk"
            command = [sys.executable, "-m", "hexfeature", "mesh", str(part), "-o", str(mesh), "--method", method, "--order", "2",
                       "--time-limit", str(arguments.limit)] + (["--size", str(size)] if size else [])
            started = time.monotonic()
            run = subprocess.run(command, env=environment(), capture_output=True, text=True)
            runs += 1
            lines = run.stderr.splitlines()
            bad = bool(FINDING.search(run.stderr)) or run.returncode not in (*SAID, TIMED_OUT)
            findings += bad
            unfinished += run.returncode == TIMED_OUT
            seconds = time.monotonic() - started
            verdict = "FINDING" if bad else "unfinished" if run.returncode == TIMED_OUT else "ok"
            print(f"{verdict:12s}{part.name:32s} {method:10s} exit {run.returncode}  {seconds:6.1f} s  "
                  f"{lines[-1][:90] if lines and run.returncode else ''}", flush=True)
            if bad:
                print("\n".join(lines[:60]), flush=True)
            mesh.unlink(missing_ok=True)
    print(f"{runs} runs, {findings} findings, {unfinished} not to their end in {arguments.limit:g} s")
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
