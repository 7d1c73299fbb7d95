# HexFeatureWB - LGPL-2.1-or-later
"""Mesh every solid of many files without a window; go on after a failure.

    hexfeature-batch FILE... --out DIR [--size H] [--order 2] [--OPTION VALUE ...]
    freecadcmd scripts/run_batch.py   with the arguments as JSON in HEXFEATURE_BATCH_ARGUMENTS

Each solid leaves DIR/FILE[-OBJECT][-SolidN].FCStd (part, mesh, groups), .unv (the mesh) and .json (the report); the run leaves
DIR/summary.csv and prints the same table. Exit code: 0 all meshed, 4 some not, 3 none could be read or meshed, 2 usage.
"""
import argparse
import csv
import json
import os
import re
import sys
import time
from typing import NamedTuple

import FreeCAD
import Part  # noqa: F401  makes Part::Feature known

from . import core
from .meshing import MeshingError, mesh

#: ((files, folder, options), rows): what the window has just run
_ready = None

COLUMNS = ["file", "solid", "result", "method", "hexes", "min_sj", "mean_sj", "seconds", "why"]


def solids_in(path):
    """[(name, shape)] of every solid of a CAD file or FreeCAD document. Raises on a file that cannot be read."""
    if not os.path.isfile(path):
        raise ValueError("there is no such file")
    if path.lower().endswith(".fcstd"):
        document = FreeCAD.openDocument(path, True)
        try:
            found = []
            for obj in document.Objects:
                if not hasattr(obj, "Shape") or not hasattr(obj.Shape, "Solids") or not _is_result(obj):
                    continue
                for number, solid in enumerate(obj.Shape.Solids, 1):
                    name = obj.Name if len(obj.Shape.Solids) == 1 else "%s-Solid%d" % (obj.Name, number)
                    found.append((name, solid.copy()))
            return found
        finally:
            FreeCAD.closeDocument(document.Name)
    shape = Part.Shape()
    shape.read(path)
    solids = shape.Solids
    return [("" if len(solids) == 1 else "Solid%d" % n, solid) for n, solid in enumerate(solids, 1)]


def _is_result(obj):
    """Not a step on the way to another object: features inside a body and inputs of booleans are left out."""
    return not any(hasattr(user, "Shape") and hasattr(user.Shape, "Solids") and user.Shape.Solids for user in obj.InList)


def mesh_one(shape, stem, options):
    """Mesh one solid into stem.FCStd, stem.unv, stem.json; returns the report."""
    document = FreeCAD.newDocument("HexMesh", hidden=True)
    try:
        part = document.addObject("Part::Feature", "Part")
        part.Shape = shape
        obj = mesh(part, **options)
        document.recompute()
        for ending, write in ((".FCStd", document.saveAs), (".unv", obj.FemMesh.write)):
            temporary = stem + ".writing" + ending
            write(temporary)
            os.replace(temporary, stem + ending)
        report = json.loads(obj.Report)
        with open(stem + ".json.writing", "w") as f:
            json.dump(report, f, indent=1)
        os.replace(stem + ".json.writing", stem + ".json")
        return report
    finally:
        FreeCAD.closeDocument(document.Name)


class Item(NamedTuple):
    """One solid to mesh: where it is from, the path, without ending, of what it leaves, and the file's own element size or None."""

    file: str
    name: str
    shape: object
    stem: str
    size: object = None

    def options(self, common):
        """The batch's options with this solid's own."""
        return common if self.size is None else {**common, "size": self.size}


def items(files, out):
    """Go through the files: yields an Item for each solid, and the summary's row of each file that cannot be read.

    A file is a path, or (path, element size in mm).
    """
    stems = set()
    for file in files:
        path, size = file if isinstance(file, (tuple, list)) else (file, None)
        stem = _free_stem(path, stems)
        stems.add(stem)
        stem = os.path.join(out, stem)
        try:
            solids = solids_in(path)
            if not solids:
                raise ValueError("there is no solid in it")
        except Exception as error:  # whatever FreeCAD's readers raise, the batch goes on
            yield _row(path, "", "unreadable", why=_reason(error))
            continue
        for name, shape in solids:
            yield Item(path, name, shape, stem + ("-" + name if name else ""), size)


def row_of(item, start, report=None, error=None):
    """The summary's row of an item that was begun at time.time() `start`: meshed with this report, or failed with this error."""
    seconds = round(time.time() - start, 2)
    if error is not None:
        why = "%s: %s" % (error.step, error.reason) if isinstance(error, MeshingError) else _reason(error)
        return _row(item.file, item.name, "failed", seconds=seconds, why=why)
    quality = report["quality"]
    return _row(item.file, item.name, "meshed", report["method"], quality["hexes"], round(quality["min_scaled_jacobian"], 3),
                round(quality["mean_scaled_jacobian"], 3), seconds)


def write_summary(rows, out):
    """Write out/summary.csv; returns the exit code."""
    with open(os.path.join(out, "summary.csv"), "w", newline="") as f:
        table = csv.DictWriter(f, COLUMNS)
        table.writeheader()
        table.writerows(rows)
    meshed = sum(row["result"] == "meshed" for row in rows)
    return 0 if meshed == len(rows) else 4 if meshed else 3


def run(files, out, options):
    """Mesh every solid of `files` into the folder `out`; returns (rows of the summary, exit code).

    files: paths, or (path, element size in mm) for a size of its own; options: as of `HexFeatureWB.mesh`.
    """
    global _ready
    ready, _ready = _ready, None
    if ready and ready[0] == (files, out, options):
        return ready[1], write_summary(ready[1], out)
    os.makedirs(out, exist_ok=True)
    rows = []
    for item in items(files, out):
        if not isinstance(item, Item):
            rows.append(item)
            continue
        start = time.time()
        try:
            rows.append(row_of(item, start, report=mesh_one(item.shape, item.stem, item.options(options))))
        except Exception as error:  # one part must not end the batch
            rows.append(row_of(item, start, error=error))
    return rows, write_summary(rows, out)


def offer(files, out, options, rows):
    """Lend the rows of a batch that the window has just run to the next run() of the same: the recorded line is then the one that
    ended the batch, and repeats all of it in a macro."""
    global _ready
    _ready = ((files, out, options), rows)


def _free_stem(path, taken):
    """The file's name without its ending; numbered when another file of the same name came before it."""
    stem = re.sub(r"\W+", "_", os.path.splitext(os.path.basename(path))[0])
    return next(name for name in (stem, *("%s_%d" % (stem, n) for n in range(2, len(taken) + 3))) if name not in taken)


def _reason(error):
    """What an exception says; FreeCAD's own carry a dict."""
    told = error.args[0] if error.args else ""
    return str(told.get("sErrMsg", told) if isinstance(told, dict) else error)


def _row(file, solid, result, method="", hexes="", min_sj="", mean_sj="", seconds="", why=""):
    return dict(zip(COLUMNS, (file, solid, result, method, hexes, min_sj, mean_sj, seconds, why)))


def main(arguments=None):
    parser = argparse.ArgumentParser(prog="hexfeature-batch", description="Mesh every solid of CAD files and FreeCAD documents.")
    parser.add_argument("files", nargs="+", metavar="FILE")
    parser.add_argument("--out", required=True, help="folder for the results")
    kinds = {"float": float, "int": int, "str": str}
    for spec in core.load().option_list():
        if spec["name"] == "stop_after":
            continue
        flag = "--" + spec["name"].replace("_", "-")
        if spec["type"] == "bool":
            parser.add_argument(flag, action=argparse.BooleanOptionalAction, default=None, help=spec["help"])
        else:
            parser.add_argument(flag, type=kinds[spec["type"]], choices=spec["choices"] or None, help=spec["help"])
    values = vars(parser.parse_args(arguments))
    files, out = values.pop("files"), values.pop("out")
    if values["size"] is not None and not 0 < values["size"] < float("inf"):
        parser.error("size is %g but must be a length greater than 0" % values["size"])
    try:
        os.makedirs(out, exist_ok=True)
    except OSError as error:
        parser.error("cannot make the folder '%s': %s" % (out, error.strerror))
    rows, code = run(files, out, {key: value for key, value in values.items() if value is not None})
    print()  # FreeCAD leaves its progress without an end of line
    widths = {c: max(len(c), *(len(str(r[c])) for r in rows)) for c in COLUMNS}
    for row in [dict(zip(COLUMNS, COLUMNS)), *rows]:
        print("  ".join(str(row[c]).ljust(widths[c]) for c in COLUMNS).rstrip())
    return code


if __name__ == "__main__":
    sys.exit(main())
