# HexFeatureWB - LGPL-2.1-or-later
"""The results as tables and log-log plots in docs/verification.md and docs/pictures/verification.png."""
import json
import os
import re
from pathlib import Path

import numpy as np

import problems

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs" / "verification.md"
PICTURE = ROOT / "docs" / "pictures" / "verification.png"


def series(rows, problem, element):
    """Rows of one problem and element, coarse to fine."""
    return [r for r in rows if r["problem"] == problem and r["element"] == element]


def first_error(row):
    return next(iter(row["errors"].values()))


def order(rows, quantity):
    """Slope of log error over log mean element size (the number of nodes to the power -1/3), all sizes."""
    x = np.log([r["nodes"] ** (-1 / 3) for r in rows])
    return float(np.polyfit(x, np.log([r["errors"][quantity] for r in rows]), 1)[0])


def tables(rows):
    """Markdown: a summary of all problems, then one table a problem."""
    known = [p for p in problems.PROBLEMS if series(rows, p.name, "C3D10")]
    text = ["| problem | error of | C3D20R, finest | C3D10, finest | field: C3D20R | field: C3D10 | order of C3D20R, C3D10 |",
            "|" + "---|" * 7]
    for p in known:
        hexes, tets = series(rows, p.name, "C3D20R"), series(rows, p.name, "C3D10")
        fields = ["%.1e" % r[-1]["errors"]["field"] if "field" in r[-1]["errors"] else "" for r in (hexes, tets)]
        quantity = "field" if fields[0] else next(iter(hexes[0]["errors"]))
        orders = ", ".join("%.1f" % order(r, quantity) for r in (hexes, tets)) if first_error(hexes[-1]) > 1e-6 else "exact"
        text.append("| %s | %s | %.2g%% | %.2g%% | %s | %s | %s |" % (
            p.title, p.quantity, 100 * first_error(hexes[-1]), 100 * first_error(tets[-1]), *fields, orders))
    for p in known:
        text += ["", "**%s.** Error of: %s. Known from: %s." % (p.title, p.quantity, p.theory), "",
                 "| size | element | elements | nodes | error | others | solver s |", "|" + "---|" * 7]
        for r in (r for r in rows if r["problem"] == p.name):
            others = ", ".join("%s %.1e" % item for item in list(r["errors"].items())[1:])
            text.append("| %g | %s | %d | %d | %.3g%% | %s | %.1f |" % (
                r["size"], r["element"], r["cells"], r["nodes"], 100 * first_error(r), others, r["solver_seconds"]))
    return "\n".join(text) + "\n"


def plot(rows, path):
    """Error over degrees of freedom, a panel a problem."""
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    known = [p for p in problems.PROBLEMS if series(rows, p.name, "C3D10") and first_error(series(rows, p.name, "C3D20R")[-1]) > 1e-6]
    figure, panels = plt.subplots(3, 3, figsize=(12, 10.5))
    for panel, p in zip(panels.flat, known):
        for element in (*p.elements, "C3D10"):
            part = series(rows, p.name, element)
            line = "s--" if element == "C3D10" else "o-"
            panel.loglog([3 * r["nodes"] for r in part], [first_error(r) for r in part], line, label=element)
            if "field" in part[0]["errors"] and list(part[0]["errors"])[0] != "field":
                panel.loglog([3 * r["nodes"] for r in part], [r["errors"]["field"] for r in part],
                             "s:" if element == "C3D10" else "o:", alpha=0.6, label=element + ", displacements")
        panel.set_title("%s\n%s" % (p.title, p.quantity), fontsize=9)
        panel.legend(fontsize=7)
        panel.grid(True, which="both", alpha=0.2)
    for panel in panels.flat[len(known):]:
        panel.axis("off")
    for panel in panels[-1]:
        panel.set_xlabel("degrees of freedom")
    for panel in panels[:, 0]:
        panel.set_ylabel("relative error")
    figure.tight_layout()
    figure.savefig(path, dpi=75)


def loads_table(rows):
    kinds = dict.fromkeys(r["kind"] for r in rows if "force_error" in r)
    text = ["| constraint | parts | reaction's force off by at most | its moment |", "|---|---|---|---|"]
    for kind in kinds:
        part = [r for r in rows if r["kind"] == kind]
        moments = [r["moment_error"] for r in part if r["moment_error"] is not None]
        text.append("| %s | %d | %.3g%% | %s |" % (
            kind, len(part), 100 * max(r["force_error"] for r in part), "%.3g%%" % (100 * max(moments)) if moments else "-"))
    for kind in ("mirrored", "moved"):
        changes = [r["displacement_change"] for r in rows if r["kind"] == kind]
        if changes:
            text.append("| %s part: largest displacement | %d | %.3g%% | |" % (kind, len(changes), 100 * max(changes)))
    return "\n".join(text) + "\n"


def examples_table(rows):
    text = ["| example | compared | with its own mesh | with ours | differs by | known |", "|" + "---|" * 6]
    for r in rows:
        if "why_not" in r:
            text.append("| %s | not run: %s | | | | |" % (r["example"], r["why_not"]))
            continue
        what = "frequencies" if r["own"]["frequencies"] else "displacement"
        own, ours = ((r[k][what][0] if what == "frequencies" else r[k][what]) for k in ("own", "ours"))
        text.append("| %s | %s | %.5g (%d nodes) | %.5g (%d nodes) | %.2f%% | %s |" % (
            r["example"], "first frequency, Hz" if what == "frequencies" else "largest displacement, mm", own, r["own"]["nodes"], ours,
            r["ours"]["nodes"], 100 * r["difference"], "%.5g" % r["known"] if r["known"] else ""))
    return "\n".join(text) + "\n"


def write(out):
    """Put what OUT_DIR holds into the page: results.json, loads.json, examples.json."""
    text = PAGE.read_text(encoding="utf-8")
    for name, make in (("results", tables), ("loads", loads_table), ("examples", examples_table)):
        path = os.path.join(out, name + ".json")
        if not os.path.exists(path):
            continue
        rows = json.loads(Path(path).read_text())
        between = re.compile(r"(<!-- %s -->\n).*?(<!-- end of %s -->)" % (name, name), re.DOTALL)
        text = between.sub(lambda m: m.group(1) + make(rows) + m.group(2), text)
        if name == "results":
            plot(rows, PICTURE)
    PAGE.write_text(text, encoding="utf-8")
