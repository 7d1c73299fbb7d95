# HexFeatureWB - LGPL-2.1-or-later
"""The report: what a run did, as JSON for programs and as a few lines for people."""
import json

from hexfeature import _core
from hexfeature.formats import replace_file


def of_mesh(mesh, part, wall_seconds):
    """The core's report with the program's version, the part's path and the seconds of the whole command."""
    return {"hexfeature": _core.__version__, "part_file": part, **mesh.report, "wall_seconds": wall_seconds}


def of_error(error, part, wall_seconds):
    """A run that failed leaves a report too; `method` is empty."""
    return {"hexfeature": _core.__version__, "part_file": part, "method": "", "certified": False, "wall_seconds": wall_seconds,
            "error": {name: getattr(error, name) for name in ("kind", "step", "reason", "hint", "cad_faces")}}


def write(report, path):
    """Write as JSON. Raises MeshingError ("output")."""

    def write_to(temporary):
        with open(temporary, "w", encoding="utf-8") as out:
            json.dump(report, out, indent=1)
            out.write("\n")

    replace_file(path, write_to)


def summary(report):
    """Two or three lines of text."""
    if report.get("stopped_after"):
        return f"stopped after step {report['stopped_after']}, {report['seconds']:.2f} s"
    quality, cad = report["quality"], report["faithfulness"]
    lines = [f"{quality['hexes']} hexahedra, {quality['points']} points, by {report['method']} in {report['seconds']:.2f} s; size "
             f"{report['options']['size']:.4g}",
             f"scaled Jacobian min {quality['min_scaled_jacobian']:.3f}, mean {quality['mean_scaled_jacobian']:.3f}; below 0.2: "
             f"{100 * quality['below_0.2']:.2g}%; volume off by {100 * quality['volume_error']:.2g}%"]
    for what, numbers in (("CAD faces without quads", cad["faces_without_quads"]),
                          ("sharp CAD edges not followed", cad["sharp_edges_not_followed"])):
        if numbers:
            lines.append(f"{what}: {', '.join(map(str, numbers[:20]))}{' ...' if len(numbers) > 20 else ''}")
    return "\n".join(lines)
