# HexFeatureWB - LGPL-2.1-or-later
"""The results as tables and log-log plots in docs/verification.md and docs/pictures/verification.png."""
import json
import os
import re
from pathlib import Path

import problems
from gates import first_error, order, over_tetrahedra, series

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs" / "verification.md"
PICTURE = ROOT / "docs" / "pictures" / "verification.png"


#: What else is measured, in words.
NAMES = {"field": "displacements, all nodes", "stress": "stresses, all integration points", "heat": "heat flow"}


def tables(rows):
    """Markdown: a summary of all problems, then one table a problem."""
    known = [p for p in problems.PROBLEMS if series(rows, p.name, "C3D10")]
    text = ["| problem | error of | C3D20R | C3D10 | one block | order C3D20R, C3D10 | C3D20R / C3D10 |", "|" + "---|" * 7]
    for p in known:
        parts = [series(rows, p.name, element) for element in ("C3D20R", "C3D10", "one block")]
        over = over_tetrahedra(rows, p.name)
        for n, what in enumerate(parts[0][0]["errors"]):
            finest = ["%.2g%%" % (100 * part[-1]["errors"][what]) if part else "" for part in parts]
            exact = what not in over
            orders = "exact" if exact else ", ".join("%.1f" % order(part, what) for part in parts[:2])
            text.append("| %s | %s | %s | %s | %s | %s | %s |" % (
                p.title if n == 0 else "", p.quantity if n == 0 else NAMES.get(what, what), *finest, orders,
                "" if exact else "%.2f" % over[what]))
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
    from PIL import Image

    known = [p for p in problems.PROBLEMS if series(rows, p.name, "C3D10") and first_error(series(rows, p.name, "C3D20R")[-1]) > 1e-6]
    figure, panels = plt.subplots(3, 3, figsize=(12, 10.5))
    for panel, p in zip(panels.flat, known):
        for element in (*p.elements, "C3D10", "one block"):
            part = series(rows, p.name, element)
            if not part:
                continue
            line = {"C3D10": "s--", "one block": "^-."}.get(element, "o-")
            panel.loglog([3 * r["nodes"] for r in part], [first_error(r) for r in part], line, label=element)
            for what, style in (("field", ":"), ("stress", "--")):
                if what in list(part[0]["errors"])[1:]:
                    panel.loglog([3 * r["nodes"] for r in part], [r["errors"][what] for r in part], line[0] + style, alpha=0.5,
                                 color=panel.lines[-1].get_color(), label="%s, %s" % (element, NAMES[what].split(",")[0]))
        panel.set_title("%s\n%s" % (p.title, p.quantity), fontsize=9)
        panel.legend(fontsize=5)
        panel.grid(True, which="both", alpha=0.2)
    for panel in panels.flat[len(known):]:
        panel.axis("off")
    for panel in panels[-1]:
        panel.set_xlabel("degrees of freedom")
    for panel in panels[:, 0]:
        panel.set_ylabel("relative error")
    figure.tight_layout()
    figure.savefig(path, dpi=75)
    Image.open(path).convert("P", palette=Image.ADAPTIVE, colors=64).save(path, optimize=True)


def loads_table(rows):
    kinds = dict.fromkeys(r["kind"] for r in rows if "force_error" in r)
    text = ["| constraint | parts | reaction's force, or heat, off by at most | its moment |", "|---|---|---|---|"]
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
    text = ["| example | compared | its own mesh | ours | fine tetrahedra | known | ours differs by |", "|" + "---|" * 7]
    for r in rows:
        if "why_not" in r:
            text.append("| %s | not run: %s | | | | | |" % (r["example"], r["why_not"]))
            continue
        for n, (what, difference) in enumerate(r["difference"].items()):
            values = ["%.5g (%d)" % (r[k][what], r[k]["nodes"]) if k in r else "" for k in ("own", "ours", "fine")]
            text.append("| %s | %s | %s | %s | %s | %s | %.2f%% |" % (
                r["example"] if n == 0 else "", what, *values, "%.5g" % r["known"] if r["known"] else "", 100 * difference))
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
