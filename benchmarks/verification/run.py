#!/usr/bin/python3
# HexFeatureWB - LGPL-2.1-or-later
"""The verification set: benchmarks/verification/run.py OUT_DIR [NAME ...]

Meshes each problem's part by the feature-line method and by Gmsh (10-node tetrahedra of about as many nodes), at four sizes,
solves with CalculiX, and compares with the known solution; where the part is a bent block, also a block of 20-node hexahedra by
formula. Leaves the decks and results.json in OUT_DIR. Exit code 1 when a problem could not be solved, when C3D20R exceeds its
limit at the finest size or falls short of its order of convergence, or when at equal degrees of freedom it is less accurate than
the tetrahedra, or than the ratio to them that gates.EXPLAINED has.
"""
import json
import os
import sys
import traceback
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parents[1] / "python")]

import shapes  # noqa: E402  FreeCAD first
import arguments  # noqa: E402
import calculix  # noqa: E402
import gates  # noqa: E402
import meshers  # noqa: E402
import problems  # noqa: E402


def solve(problem, shape, mesh, folder, tag):
    """Solve one model; returns a row of the results."""
    mesh.faces_by_name = {name: shapes.face_at(shape, at) for name, at in problem.faces.items()}
    mesh.edges_by_name = {name: shapes.edge_at(shape, at) for name, at in (problem.edges or {}).items()}
    deck = os.path.join(folder, tag + ".inp")
    with open(deck, "w") as out:
        out.write("*INCLUDE, INPUT=%s\n%s" % (os.path.basename(mesh.path), problem.deck(mesh)))
    solution = calculix.run(deck)
    errors = {name: float(value) for name, value in problem.errors(mesh, solution).items()}
    return {"nodes": mesh.solid_nodes(), "errors": errors, "solver_seconds": solution.seconds, **mesh.facts}


def verify(problem, folder):
    """All sizes and elements of one problem: rows with size, element, nodes, cells, errors, seconds."""
    os.makedirs(folder, exist_ok=True)
    shape, rows = problem.shape(), []
    for number, size in enumerate(problem.sizes):
        for element in (*problem.elements, "C3D10", *(["one block"] if problem.mapped() else [])):
            tag = "%s_%d" % (element.replace(" ", "_"), number)
            path = os.path.join(folder, tag + "_mesh.inp")
            if element == "C3D10":
                mesh = meshers.tetrahedra(shape, 1.2 * size, path, rows[-1]["nodes"])
            elif element == "one block":
                mesh = meshers.one_block(problem, shape, path, rows[-2]["nodes"])
            else:
                mesh = meshers.hexahedra(shape, size, path, element)
            row = {"problem": problem.name, "size": size, "element": element, **solve(problem, shape, mesh, folder, tag)}
            rows.append(row)
            worst = ", ".join("%s %.2e" % item for item in row["errors"].items())
            print("%-10s %-7g %-9s %6d elements %7d nodes  %s  ccx %.1f s" %
                  (problem.name, size, element, row["cells"], row["nodes"], worst, row["solver_seconds"]), flush=True)
    return rows


def main(out, names):
    """Run the set, or the problems named; returns the exit code."""
    results, failed = [], 0
    for problem in problems.PROBLEMS:
        if names and problem.name not in names:
            continue
        try:
            rows = verify(problem, os.path.join(out, problem.name))
        except Exception:
            traceback.print_exc()
            failed = 1
            continue
        results += rows
        for said, met in gates.judge(problem.name, rows):
            print("%-10s %s%s" % (problem.name, said, "" if met else ": not met"), flush=True)
            failed |= not met
    with open(os.path.join(out, "results.json"), "w") as file:
        json.dump(results, file, indent=1)
    return int(failed)


if __name__ == "__main__":
    asked = arguments.parse(__doc__, "NAME")
    sys.exit(main(asked.out, asked.names))
