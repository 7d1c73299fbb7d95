#!/usr/bin/python3
# HexFeatureWB - LGPL-2.1-or-later
"""How soon a run stops: benchmarks/cancel.py OUT_DIR [--interrupts 20] [--seed 1] [PART:SIZE[:METHOD[:ORDER]] ...]

Two measurements of every part (the project's own at about 100,000 hexahedra when none is given).
1. In the package: the longest time between two looks at `cancelled`, for each step: the worst that a Cancel can take. In CPU time
   with one thread, which a busy machine does not change.
2. On the command line: Ctrl-C at random moments of the run, from the part's reading to the mesh's writing; seconds until the process has
   ended, and whether it left a file. Wall time: measure on an idle machine.
Exit code 1 when a limit is passed (0.15 s and 0.2 s) or a file is left.
"""
import argparse
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
GAP_LIMIT, STOP_LIMIT = 0.15, 0.2
PARTS = ["crank_shaft:1.3:auto:2", "plate_with_holes:1.0:auto:1", "flange:1.1:auto:1", "crank_shaft:1.2:tet-split:2"]

sys.path.insert(0, str(ROOT / "python"))


def gaps(part, size, method, order):
    """Step -> longest CPU time between two polls; and the run's wall time and number of hexahedra."""
    import hexfeature

    worst, state = {}, {"step": "read", "last": time.process_time()}

    def poll():
        now = time.process_time()
        step = state["step"]
        worst[step] = max(worst.get(step, 0), now - state["last"])
        state["last"] = now
        return False

    def progress(step, _fraction):
        poll()
        state["step"] = step

    started = time.monotonic()
    try:
        hexes = len(hexfeature.mesh(part, size, method=method, order=order, threads=1, cancelled=poll, progress=progress).hexes)
    except hexfeature.MeshingError as error:
        print(f"  no mesh: {error}")
        hexes = 0
    poll()
    return worst, time.monotonic() - started, hexes


def interrupt(part, size, method, after, ending):
    """Seconds from SIGINT to the end, the exit code, the step, what was left; None when the run was over before."""
    with tempfile.TemporaryDirectory() as folder:
        command = [sys.executable, "-m", "hexfeature", "mesh", str(part), "-o", f"{folder}/m{ending}", "--size", str(size),
                   "--method", method]
        process = subprocess.Popen(command, stderr=subprocess.PIPE, text=True, env=dict(os.environ, PYTHONPATH=str(ROOT / "python")))
        time.sleep(after)
        if process.poll() is not None:
            return None
        process.send_signal(signal.SIGINT)
        sent = time.monotonic()
        code = process.wait()
        seconds = time.monotonic() - sent
        return seconds, code, process.stderr.read().strip().splitlines()[:1], os.listdir(folder)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", type=Path)
    parser.add_argument("parts", nargs="*", help="FILE:SIZE[:METHOD[:ORDER]]")
    parser.add_argument("--interrupts", type=int, default=20)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    parts = arguments.parts
    if not parts:
        draw = ROOT / "tests" / "parts" / "make_parts.py"
        subprocess.run(["/usr/bin/python3", str(draw), str(arguments.out)], check=True, capture_output=True)
        parts = [f"{arguments.out}/{p.replace(':', '.step:', 1)}" for p in PARTS]
    rng, failed = random.Random(arguments.seed), False
    for asked in parts:
        part, size, method, order = (asked.split(":") + ["auto", "1"][asked.count(":") - 1:])
        part, size = Path(part), float(size)
        worst, seconds, hexes = gaps(part, size, method, int(order))
        print(f"{part.name}, size {size:g}, {method}, order {order}: {hexes} hexahedra in {seconds:.1f} s; "
              "longest time between two looks at `cancelled`:")
        for step, gap in worst.items():
            print(f"  {step:14s} {gap:6.3f} s{'  too long' if gap > GAP_LIMIT else ''}")
        failed |= max(worst.values()) > GAP_LIMIT
        ends = []
        for _ in range(arguments.interrupts):
            done = interrupt(part, size, method, rng.uniform(0.2, seconds + 1), rng.choice([".vtk", ".inp", ".med"]))
            if done is None:
                continue
            ends.append(done[0])
            if done[1] != 130 or done[3] or done[0] > STOP_LIMIT:
                print(f"  Ctrl-C: {done[0]:.3f} s, exit {done[1]}, {done[2]}, left {done[3]}")
                failed |= bool(done[3]) or done[1] not in (0, 130) or done[0] > STOP_LIMIT
        if ends:
            print(f"  {len(ends)} times Ctrl-C: ended after {sorted(ends)[len(ends) // 2]:.3f} s (median), {max(ends):.3f} s (worst)",
                  flush=True)
    shutil.rmtree(arguments.out / "work", ignore_errors=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
