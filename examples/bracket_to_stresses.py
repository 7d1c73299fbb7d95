#!/usr/bin/python3
# HexFeatureWB - LGPL-2.1-or-later
"""From a STEP file to stresses, without a window: the demo of the README.

    /usr/bin/python3 examples/bracket_to_stresses.py OUT_DIR

Reads bracket.step (made by tests/parts/make_parts.py when it is not there), meshes it with 20-node hexahedra, fixes the
end face of its foot, presses on the top of its upright, solves with CalculiX, and leaves in OUT_DIR: bracket.FCStd (part, mesh,
solved analysis), bracket.vtk (the mesh), bracket.json (the report). Prints the figures. Needs PYTHONPATH to hold FreeCAD's
library folder and this project's python folder (`make demo` sets it).
"""
import json
import os
import sys

import FreeCAD
import Part

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.append(os.path.join(HERE, os.pardir, "tests", "parts"))

import HexFeatureWB  # noqa: E402
from HexFeatureWB import analysis  # noqa: E402

SIZE, LOAD = 3.0, 500.0  # mm, N


def main(out):
    os.makedirs(out, exist_ok=True)
    step = os.path.join(out, "bracket.step")
    if not os.path.exists(step):
        import make_parts

        make_parts.make("bracket", out)
    document = FreeCAD.newDocument("bracket")
    part = document.addObject("Part::Feature", "Bracket")
    part.Shape = Part.read(step)
    faces = list(enumerate(part.Shape.Faces, 1))
    foot_end = "Face%d" % max(faces, key=lambda f: f[1].CenterOfMass.x)[0]
    top = "Face%d" % max(faces, key=lambda f: f[1].CenterOfMass.z)[0]

    mesh = HexFeatureWB.mesh(part, size=SIZE)
    study, solver = analysis.static_analysis(document, mesh, [(part, (foot_end,))], [(part, (top,))], LOAD)
    reaction = FreeCAD.Vector(*analysis.total_reaction(analysis.solve(study, solver, os.path.join(out, "ccx"))))
    result = [o for o in study.Group if o.isDerivedFrom("Fem::FemResultObject")][0]
    document.saveAs(os.path.join(out, "bracket.FCStd"))
    report = json.loads(mesh.Report)
    report["reaction_N"] = list(reaction)
    with open(os.path.join(out, "bracket.json"), "w") as f:
        json.dump(report, f, indent=1)

    import hexfeature

    hexfeature.mesh(step, size=SIZE).write(os.path.join(out, "bracket.vtk"))
    quality = report["quality"]
    print("hexahedra        %d (20-node), %.2f s, method %s" % (quality["hexes"], report["seconds"], report["method"]))
    print("scaled Jacobian  min %.3f, mean %.3f" % (quality["min_scaled_jacobian"], quality["mean_scaled_jacobian"]))
    print("load             %.3f N on %s, held by %s" % (LOAD, top, foot_end))
    print("reaction         %.3f N (off by %.4f%%)" % (reaction.Length, 100 * abs(reaction.Length - LOAD) / LOAD))
    farthest = max(v.Length for v in result.DisplacementVectors)
    print("displacement     %.5f mm, von Mises %.2f MPa at most" % (farthest, max(result.vonMises)))
    return 0 if abs(reaction.Length - LOAD) <= 1e-3 * LOAD else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1] if len(sys.argv) > 1 else "out/demo"))
