#!/usr/bin/python3
# HexFeatureWB - LGPL-2.1-or-later
"""The page docs/labellers.md: the paper's labeller beside the default, on the project's own parts and the first machined blocks.

    PYTHONPATH=python:docs xvfb-run -a /usr/bin/python3 docs/make_comparison.py [PARTS.csv]

With a table of other parts (columns part, size) it prints their table instead and leaves page and pictures alone.
"""
import csv
import subprocess
import sys
import tempfile
from pathlib import Path

import hexfeature

DOCS = Path(__file__).resolve().parent
BLOCKS = 20  #: of benchmarks/machined_blocks.py
DRAWN = ("flange", "pipe_tee")  #: parts with pictures, and the first MORE that only the default fills
MORE = 4
PAGE = """# The paper's labeller beside the default

Made by `docs/make_comparison.py` from the project's own parts and the first 20 machined blocks
([benchmarks](benchmarks.md)). *Valid* is a feature shape that keeps V1 to V4
([shape](steps/shape.md)); *filled* is one whose lattice fills too (V5, V6, [lattice](steps/lattice.md)), which is what a mesh can be
made of. What the two do is told in [labels](steps/labels.md).

{table}
{sum}
{pictures}"""


def label(part, size, labels):
    """The labels stage of one labeller, and what a table says of it: charts, outcome."""
    mesh = hexfeature.mesh(part, size=size, labels=labels, method="feature-line", stop_after="labels")
    report = mesh.report["labels"]
    broken = sorted({v["condition"] for v in report["violations"]})
    if broken:
        return mesh.stage("labels"), report["charts"], "breaks " + ", ".join(f"V{c}" for c in broken)
    try:
        hexfeature.mesh(part, size=size, labels=labels, method="feature-line", stop_after="polycube")
        return mesh.stage("labels"), report["charts"], "filled"
    except hexfeature.MeshingError:
        return mesh.stage("labels"), report["charts"], "valid, does not fill"


def compare(table):
    """Yield name, and per labeller (paper, default) stage, charts and outcome."""
    with open(table, newline="") as rows:
        for row in csv.DictReader(rows):
            part = Path(table).parent / row["part"]
            yield part.stem, [label(str(part), float(row["size"]), labels) for labels in ("paper", "regions")]


def table_of(rows):
    """Markdown."""
    lines = ["| part | paper: charts | outcome | default: charts | outcome |", "|---|---|---|---|---|"]
    lines += [f"| {name} | {paper[1]} | {paper[2]} | {ours[1]} | {ours[2]} |" for name, (paper, ours) in rows]
    return "\n".join(lines) + "\n"


def sum_of(rows):
    """One sentence."""
    paper, ours = (sum(both[k][2] == "filled" for _, both in rows) for k in (0, 1))
    return f"Of {len(rows)} parts {paper} fill with the paper's labels, {ours} with the default's.\n"


def draw(name, stage, labels):
    """One picture of a labels stage; returns its Markdown."""
    import make_pictures
    import numpy as np
    import render

    path = make_pictures.PICTURES / f"labels-{labels}-{name}.png"
    surface = make_pictures.triangles(stage, edges=False, label=np.asarray(stage["label"]))
    render.save([surface], path, size=make_pictures.SMALL, colours=make_pictures.COLOURS)
    return f"![{name}, {labels}](pictures/{path.name})"


def main(table=None):
    """Write the page, or print the table of other parts."""
    if table:
        rows = list(compare(table))
        print(table_of(rows) + "\n" + sum_of(rows))
        return
    rows, root = [], DOCS.parent
    for script, more in (("tests/parts/make_parts.py", ()), ("benchmarks/machined_blocks.py", ("--count", str(BLOCKS)))):
        with tempfile.TemporaryDirectory() as scratch:
            subprocess.run(["/usr/bin/python3", str(root / script), scratch, *more], check=True, capture_output=True)
            rows += compare(Path(scratch) / "parts.csv")
    ours_alone = [name for name, (paper, ours) in rows if paper[2] != "filled" and ours[2] == "filled"]
    pictures = ""
    for name, (paper, ours) in rows:
        if name in DRAWN or name in ours_alone[:MORE]:
            pictures += f"\n{name}: the paper's labels, and the default's\n\n"
            pictures += f"{draw(name, paper[0], 'paper')} {draw(name, ours[0], 'default')}\n"
    (DOCS / "labellers.md").write_text(PAGE.format(table=table_of(rows), sum=sum_of(rows), pictures=pictures), encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:2])
