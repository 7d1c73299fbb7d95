#!/usr/bin/python3
# HexFeatureWB - LGPL-2.1-or-later
"""The command line on damaged files: benchmarks/mutate_inputs.py OUT_DIR [--count 2000] [--seed 1] [--limit 5] [--jobs 2] [--direct]

Takes real part files (the project's own as STEP, IGES, BREP, STL, OBJ, PLY and FCStd; ../shared/parts when it is there), damages
each copy by a few seeded mutations, runs build/hexfeature on it with a time limit, and checks of every run: it ends by
itself and not by a signal, with an exit code that docs/command-line.md lists; soon after its limit at the latest; it leaves no
file but those asked for; an error names its step. Files that break a rule are kept in OUT_DIR/findings. Exit code 1 when there is one.
`--direct` runs without the command line's guarding process (HEXFEATURE_GUARD=0), as a program that imports the package would.
"""
import argparse
import collections
import json
import os
import random
import re
import shutil
import subprocess
import sys
import threading
import time
import zipfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
SHARED = ROOT.parent / "shared" / "parts"
EXIT_CODES = (0, 2, 3, 4, 5, 130)
SLACK = 5.0  #: seconds of grace: start-up alone can take one or two on a busy machine
LARGEST = 400_000  #: bytes of a source file

DRAW = """
import sys
sys.path[:0] = [{parts!r}]
import make_parts
import FreeCAD, Mesh, MeshPart, Part
for name in ("bracket", "round_bar", "filleted_l", "pipe_tee", "flange", "sphere"):
    shape = make_parts.PARTS[name][0]()
    shape = shape if shape.ShapeType == "Solid" else shape.Solids[0]
    stem = {out!r} + "/" + name
    shape.exportStep(stem + ".step"); shape.exportIges(stem + ".iges"); shape.exportBrep(stem + ".brep")
    mesh = MeshPart.meshFromShape(Shape=shape, LinearDeflection=0.5, AngularDeflection=0.5)
    for ending in ("stl", "obj", "ply"):
        mesh.write(stem + "." + ending)
document = FreeCAD.newDocument("bracket")
document.addObject("Part::Feature", "Bracket").Shape = make_parts.PARTS["bracket"][0]()
document.recompute()
document.saveAs({out!r} + "/document.FCStd")
"""


def sources(folder):
    """The undamaged files, drawn once."""
    if not folder.exists():
        folder.mkdir(parents=True)
        draw = DRAW.format(parts=str(ROOT / "tests" / "parts"), out=str(folder))
        subprocess.run(["/usr/bin/python3", "-c", draw], check=True, capture_output=True)
    shared = SHARED.glob("*.step") if SHARED.is_dir() else []
    return [p for p in sorted([*folder.iterdir(), *shared]) if p.stat().st_size <= LARGEST]


# ---------------------------------------------------------------- damage
NUMBERS = [b"0", b"-1", b"1", b"1e308", b"-1e-308", b"nan", b"inf", b"1e-9", b"99999999999", b"2147483647", b"-2147483648", b"0.5", b"3",
           b"1.E300", b"$", b"*", b"''", b"()"]


def _spans(data, pattern):
    return [m.span() for m in re.finditer(pattern, data)]


def _replace_number(data, rng):
    spans = _spans(data, rb"[-+]?\d+\.?\d*(?:[eE][-+]?\d+)?")
    if not spans:
        return data
    a, b = rng.choice(spans)
    return data[:a] + rng.choice(NUMBERS) + data[b:]


def _nudge_number(data, rng):
    spans = _spans(data, rb"[-+]?\d+\.\d*(?:[eE][-+]?\d+)?")
    if not spans:
        return data
    a, b = rng.choice(spans)
    try:
        return data[:a] + repr(float(data[a:b]) * rng.choice([-1, 1.001, 10, 1e-6, 1e6])).encode() + data[b:]
    except ValueError:
        return data


def _swap_reference(data, rng):
    spans = _spans(data, rb"#\d+")
    if not spans:
        return _replace_number(data, rng)
    (a, b), (c, d) = rng.choice(spans), rng.choice(spans)
    return data[:a] + data[c:d] + data[b:]


def _swap_word(data, rng):
    spans = _spans(data, rb"[A-Z_]{4,}")
    if not spans:
        return _flip_bits(data, rng)
    (a, b), (c, d) = rng.choice(spans), rng.choice(spans)
    return data[:a] + data[c:d] + data[b:]


def _swap_flag(data, rng):
    spans = _spans(data, rb"\.[TF]\.|[+-](?=\d+ \d)")
    if not spans:
        return _flip_bits(data, rng)
    a, b = rng.choice(spans)
    other = {b".T.": b".F.", b".F.": b".T.", b"+": b"-", b"-": b"+"}[data[a:b]]
    return data[:a] + other + data[b:]


def _lines(data, rng, change):
    lines = data.split(b"\n")
    i, j = rng.randrange(len(lines)), rng.randrange(len(lines))
    change(lines, i, j)
    return b"\n".join(lines)


def _drop_line(data, rng):
    return _lines(data, rng, lambda lines, i, j: lines.pop(i))


def _double_line(data, rng):
    return _lines(data, rng, lambda lines, i, j: lines.insert(j, lines[i]))


def _swap_lines(data, rng):
    def swap(lines, i, j):
        lines[i], lines[j] = lines[j], lines[i]
    return _lines(data, rng, swap)


def _flip_bits(data, rng):
    out = bytearray(data)
    for _ in range(rng.choice([1, 1, 4, 30])):
        out[rng.randrange(len(out))] ^= 1 << rng.randrange(8)
    return bytes(out)


def _cut(data, rng):
    a = rng.randrange(len(data))
    return data[:a] + data[a + rng.choice([1, 3, 20, 400, 5000]):]


def _truncate(data, rng):
    return data[:rng.randrange(1, len(data))]


def _noise(data, rng):
    a = rng.randrange(len(data))
    return data[:a] + rng.randbytes(rng.choice([1, 8, 100])) + data[a:]


MUTATIONS = [_replace_number, _replace_number, _nudge_number, _nudge_number, _swap_reference, _swap_reference, _swap_reference, _swap_word,
             _swap_flag, _swap_flag, _drop_line, _double_line, _swap_lines, _flip_bits, _cut, _truncate, _noise]


def damage(data, rng):
    """A few mutations, one after another; returns bytes and the mutations' names."""
    names = []
    for _ in range(rng.choice([1, 1, 1, 2, 3, 6])):
        mutation = rng.choice(MUTATIONS)
        names.append(mutation.__name__.strip("_"))
        data = mutation(data, rng) or b"\0"
    return data, names


def damaged_file(source, target, rng):
    """Write a damaged copy; of a FreeCAD document, half the time the B-rep inside is damaged and not the archive."""
    if source.suffix == ".FCStd" and rng.random() < 0.5:
        names = []
        with zipfile.ZipFile(source) as old, zipfile.ZipFile(target, "w") as new:
            for member in old.namelist():
                content = old.read(member)
                if member.endswith(".brp") and content:
                    content, names = damage(content, rng)
                new.writestr(member, content)
        return names
    data, names = damage(source.read_bytes(), rng)
    target.write_bytes(data)
    return names


# ---------------------------------------------------------------- runs
def run(number, source, out, arguments):
    """One damaged file. Returns (verdict, facts); verdict "" when every rule holds."""
    rng = random.Random(f"{arguments.seed}/{number}")
    folder = out / "work" / str(number)
    shutil.rmtree(folder, ignore_errors=True)
    (folder / "out").mkdir(parents=True)
    part = folder / f"{number}_{source.name}"
    mutations = damaged_file(source, part, rng)
    ending = rng.choice([".vtk", ".vtk", ".inp", ".unv"])
    mesh, report = folder / "out" / f"m{ending}", folder / "out" / "m.json"
    command = [str(arguments.command), "mesh", str(part), "-o", str(mesh), "--report", str(report),
               "--time-limit", str(arguments.limit)]
    environment = dict(os.environ, **({"HEXFEATURE_GUARD": "0"} if arguments.direct else {}))
    started = time.monotonic()
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, errors="replace", cwd=folder / "out",
                               env=environment)
    hung = threading.Timer(4 * arguments.limit + 30, process.kill)
    hung.start()
    error = process.stderr.read()
    process.wait()
    hung.cancel()
    seconds = time.monotonic() - started
    code, left = process.returncode, sorted(os.listdir(folder / "out"))
    told = [line for line in error.splitlines() if line.startswith("hexfeature: error in step")]
    verdict = ""
    if code < 0 or code not in EXIT_CODES:
        verdict = f"ended by signal {-code}" if code < 0 else f"exit code {code}"
    elif seconds > arguments.limit + SLACK:
        verdict = f"took {seconds:.1f} s"
    elif left != sorted([report.name] + ([mesh.name] if code == 0 else [])):
        verdict = f"left {left}"
    elif "Traceback" in error or "internal error" in error:
        verdict = "internal error"
    elif code != 0 and len(told) != 1:
        verdict = "an error that does not name its step"
    facts = {"number": number, "source": source.name, "mutations": mutations, "code": code, "seconds": round(seconds, 2),
             "error": told[0] if told else error.strip()[-300:]}
    if verdict:
        keep = out / "findings"
        keep.mkdir(exist_ok=True)
        shutil.copy(part, keep)
    shutil.rmtree(folder, ignore_errors=True)
    return verdict, facts


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", type=Path)
    parser.add_argument("--count", type=int, default=2000)
    parser.add_argument("--first", type=int, default=0, help="number of the first file, to repeat one")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--limit", type=float, default=5, help="seconds, handed to the program as its time limit")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--direct", action="store_true")
    parser.add_argument("--command", type=Path, default=ROOT / "build" / "hexfeature")
    arguments = parser.parse_args()
    out = arguments.out.resolve()
    shutil.rmtree(out / "findings", ignore_errors=True)
    files = sources(out / "sources")
    kinds = collections.defaultdict(list)
    for path in files:
        kinds[path.suffix].append(path)
    endings = sorted(kinds)

    def one(number):
        # Every format gets its share, STEP and BREP a larger one.
        pick = random.Random(f"{arguments.seed}/source/{number}")
        ending = pick.choice([*endings, ".step", ".step", ".step", ".brep"])
        return run(number, pick.choice(kinds[ending]), out, arguments)

    codes, findings, slowest = collections.Counter(), [], 0.0
    numbers = range(arguments.first, arguments.first + arguments.count)
    with ThreadPoolExecutor(arguments.jobs) as pool, open(out / "runs.jsonl", "w", encoding="utf-8") as log:
        for verdict, facts in pool.map(one, numbers):
            codes[facts["code"]] += 1
            slowest = max(slowest, facts["seconds"])
            log.write(json.dumps(dict(facts, verdict=verdict)) + "\n")
            log.flush()
            if verdict:
                findings.append(facts)
                print(f"{facts['number']:5d} {facts['source']:28s} {verdict}: {', '.join(facts['mutations'])}: {facts['error'][:140]}",
                      flush=True)
    listing = ", ".join(f"{code}: {codes[code]}" for code in sorted(codes))
    print(f"{len(numbers)} damaged files of {len(files)} sources, seed {arguments.seed}: {len(findings)} findings; exit codes {listing}; "
          f"slowest {slowest:.1f} s with a limit of {arguments.limit:g} s")
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
