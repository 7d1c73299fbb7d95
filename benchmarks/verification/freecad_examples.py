#!/usr/bin/python3
# HexFeatureWB - LGPL-2.1-or-later
"""FreeCAD's own FEM examples with our mesh: benchmarks/verification/freecad_examples.py OUT_DIR [EXAMPLE ...]

Sets up each example that has one solid, solves it with the mesh that comes with it, replaces the mesh by ours (20-node
hexahedra), solves again, and compares displacement, von Mises stress or frequencies; where the example has a known
solution, with that. Leaves OUT_DIR/examples.json. Exit code 1 when a displacement or frequency differs by more than 3%.
"""
import importlib
import json
import os
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parents[1] / "python")]
sys.path += ["/usr/lib/freecad" + folder for folder in ("-python3/lib", "/lib", "/Mod", "/Ext")]
sys.path += [str(path) for folder in ("/usr/lib/freecad/Mod", "/usr/share/freecad/Mod") for path in sorted(Path(folder).glob("*"))]
import FreeCAD  # noqa: E402

import numpy as np  # noqa: E402

import calculix  # noqa: E402
from HexFeatureWB import analysis, core, fem_mesh  # noqa: E402

#: example -> known displacement: Timoshenko's cantilever, 8 x 1 x 1 m, 9 MN; None: that of the example's own mesh
CANTILEVER = 9e6 * 8000**3 / (3 * 210000 * 1000**4 / 12) + 1.2 * 9e6 * 8000 / (210000 / 2.6 * 1000**2)
EXAMPLES = {
    "boxanalysis_static": None,
    "boxanalysis_frequency": None,
    "ccx_cantilever_faceload": CANTILEVER,
    "ccx_cantilever_nodeload": CANTILEVER,
    "ccx_cantilever_ele_hexa20": CANTILEVER,
    "ccx_cantilever_prescribeddisplacement": None,
    "constraint_selfweight_cantilever": None,
    "constraint_section_print": None,
    "constraint_transform_beam_hinged": None,
    "constraint_transform_torque": None,
    "constraint_centrif": None,
    "ccx_buckling_flexuralbuckling": None,
    "constraint_contact_solid_solid": None,
    "constraint_tie": None,
}
ELEMENTS = 600  #: about so many


def members(document, kind):
    return [o for o in document.Analysis.Group if o.isDerivedFrom(kind)]


def solve(document, folder):
    """{"nodes", "displacement", "stress", "frequencies"} of the document's analysis as it stands."""
    mesh = members(document, "Fem::FemMeshObject")[0]
    solver = [o for o in document.Analysis.Group if "Solver" in o.TypeId][0]
    dat = analysis.solve(document.Analysis, solver, folder)
    stem = os.path.splitext(dat)[0]
    fields = calculix.read_frd(stem + ".frd")
    u, s = fields["U"], fields.get("S")
    result = {"nodes": mesh.FemMesh.NodeCount, "displacement": float(np.nanmax(np.linalg.norm(u, axis=1)))}
    if s is not None:
        xx, yy, zz, xy, yz, zx = s.T
        mises = np.sqrt(((xx - yy)**2 + (yy - zz)**2 + (zz - xx)**2) / 2 + 3 * (xy**2 + yz**2 + zx**2))
        result["stress"] = float(np.nanmax(mises))
    found = calculix.frequencies(Path(dat).read_text() if os.path.exists(dat) else "")
    result["frequencies"] = [f for f in found if f > 1e-3 * max(found)][:4]  # a free body's first six are zero
    return result


def run(name, folder):
    """The example as it comes and with our mesh: a row."""
    document = importlib.import_module("femexamples." + name).setup(solvertype="ccxtools")
    try:
        document.recompute()
        mesh = members(document, "Fem::FemMeshObject")[0]
        shape = (getattr(mesh, "Part", None) or mesh.Shape).Shape
        own = solve(document, os.path.join(folder, name, "own"))
        result = core.load().mesh_brep(shape.exportBrepToString(), {"order": 2, "size": (shape.Volume / ELEMENTS) ** (1 / 3)})
        fem, _ = fem_mesh.to_fem_mesh(result)
        mesh.FemMesh = fem
        for old in members(document, "Fem::FemResultObject"):
            document.removeObject(old.Name)
        ours = solve(document, os.path.join(folder, name, "hexahedra"))
        return {"example": name, "hexahedra": fem.HexaCount, "own": own, "ours": ours}
    finally:
        FreeCAD.closeDocument(document.Name)


def main(out, names):
    os.makedirs(out, exist_ok=True)
    rows, failed = [], 0
    for name in names or EXAMPLES:
        try:
            row = run(name, os.path.join(out, "examples"))
        except Exception as error:
            rows.append({"example": name, "why_not": str(error).strip().splitlines()[0][:200] if str(error).strip() else repr(error)})
            print("%-40s %s" % (name, rows[-1]["why_not"]), flush=True)
            continue
        own, ours = row["own"], row["ours"]
        what = "frequencies" if own["frequencies"] else "displacement"
        a, b = (own[what][0], ours[what][0]) if what == "frequencies" else (own[what], ours[what])
        known = EXAMPLES[name]
        row["known"] = known
        row["own_error"], row["difference"] = (abs(a / known - 1) if known else None), abs(b / (known or a) - 1)
        failed |= row["difference"] > 0.03
        rows.append(row)
        print("%-40s %-12s %12.6g with %6d nodes of its own, %12.6g with %6d of ours: %.2f%%" % (
            name, what, a, own["nodes"], b, ours["nodes"], 100 * row["difference"]), flush=True)
        Path(out, "examples.json").write_text(json.dumps(rows, indent=1))
    return int(failed)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1] if len(sys.argv) > 1 else "out/verification", sys.argv[2:]))
