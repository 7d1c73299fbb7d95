# HexFeatureWB - LGPL-2.1-or-later
"""The Python interface: a part and an element size in, a mesh out."""
import os
from typing import Any, NamedTuple

from hexfeature import _core
from hexfeature.errors import MeshingError, make_error

__all__ = ["Mesh", "MeshingError", "Option", "mesh", "mesh_brep", "options"]


class Option(NamedTuple):
    """One thing that a user may choose; also a keyword of `mesh`."""

    name: str
    type: str  #: "float", "int", "bool" or "str"
    default: Any
    minimum: Any  #: inclusive; None: unbounded
    maximum: Any
    choices: list  #: of a text; empty: any
    advanced: bool  #: folded away in user interfaces
    help: str


def options():
    """Every option in display order, as a list of `Option`. The command line and FreeCAD's properties are made from it."""
    return [Option(**spec) for spec in _core.option_list()]


class Mesh:
    """An all-hexahedral mesh that knows its CAD, and how it came about.

    Arrays are numpy arrays, read-only views without a copy, zero-based; n points, m hexahedra, q boundary quads.
    The mesh is certified (every element proved positive everywhere, conforming, closed boundary) unless the run was
    stopped early with `stop_after`.
    """

    def __init__(self, result):
        self._result = result
        self._report = None

    points = property(lambda self: self._result.points, doc="(n, 3) float: coordinates in the part's unit")
    hexes = property(lambda self: self._result.hexes, doc="(m, 8) int: corners in VTK order")
    hexes20 = property(lambda self: self._result.hexes20, doc="(m, 20) int: with order=2, VTK order; else (0, 20)")
    hex_solid = property(lambda self: self._result.hex_solid, doc="(m,) int: CAD solid, from 1")
    solid_groups = property(lambda self: self._result.solid_groups, doc="dict: a name that the part's file gives -> its CAD solids, from 1")
    quads = property(lambda self: self._result.quads, doc="(q, 4) int: the boundary, counter-clockwise from outside")
    quads8 = property(lambda self: self._result.quads8, doc="(q, 8) int: with order=2, VTK order; else (0, 8)")
    quad_face = property(lambda self: self._result.quad_face, doc="(q,) int: CAD face, from 1")
    node_dim = property(lambda self: self._result.node_dim, doc="(n,) int: on a CAD vertex 0, edge 1, face 2, inside 3")
    node_entity = property(lambda self: self._result.node_entity, doc="(n,) int: number of that vertex, edge or face; 0 inside")
    feature_edges = property(lambda self: self._result.feature_edges, doc="(k, 2) int: mesh edges on CAD edges")
    feature_edge_cad = property(lambda self: self._result.feature_edge_cad, doc="(k,) int: CAD edge of each, from 1")
    method = property(lambda self: self._result.method, doc="the method that made the mesh; empty when stopped early")
    certified = property(lambda self: self._result.certified, doc="True unless stopped early")

    @property
    def order(self):
        """1 or 2."""
        return 2 if len(self._result.hexes20) else 1

    @property
    def report(self):
        """A dict: method, attempts and why each gave up, seconds per step, quality, faithfulness to the CAD, options."""
        if self._report is None:
            self._report = self._result.report()
        return self._report

    def stage(self, name):
        """An intermediate result as a dict of arrays: "surface", "labels", "shape", "polycube", "lattice", "fit",
        "sheets" or "smooth" (the last four: the mesh as it was when the run stopped)."""
        return self._result.stage(name)

    def write(self, path, element_type=""):
        """Write by the ending: .vtk .vtu .inp .unv .med .msh. `element_type` is for .inp: C3D8 (default), C3D8R, C3D8I;
        second order C3D20R (default), C3D20. Raises MeshingError of kind "output"; there is never a half-written file."""
        from hexfeature import formats

        formats.write(self, os.fspath(path), element_type)

    def write_stage(self, name, path):
        """Write an intermediate result as a legacy VTK file with its arrays, for colouring."""
        from hexfeature import stages

        stages.write(self.stage(name), name, os.fspath(path))

    def __repr__(self):
        if not self.certified:
            return "<hexfeature.Mesh, stopped early>"
        quality = self.report["quality"]
        return (f"<hexfeature.Mesh: {quality['hexes']} hexahedra, {quality['points']} points, by {self.method}, "
                f"scaled Jacobian {quality['min_scaled_jacobian']:.3f} to {quality['mean_scaled_jacobian']:.3f} (mean)>")


def mesh(part, size=None, *, object_name=None, progress=None, log=None, cancelled=None, **choices):
    """Mesh a part file.

    part: path of a .step .stp .iges .igs .brep .brp .stl .obj .ply or .FCStd file; of the last, `object_name` says which
        object (name or label) when there is more than one solid in it.
    size: element size in the part's unit; None chooses one from the part's volume.
    progress: called as progress(step, fraction) now and then; log: called with a line of text.
    cancelled: called often; when it returns True the run ends with a MeshingError of kind "cancelled" within 0.2 s.
    Other keywords are the options of `options()`, as order=2.

    Returns a `Mesh`. Raises `MeshingError`, with the attributes kind ("usage", "bad_input", "no_mesh", "output",
    "cancelled"), step, reason, hint and cad_faces (the CAD faces to blame). Other threads run meanwhile.
    """
    path = os.fspath(part)
    chosen = _chosen(size, choices)
    if path.lower().endswith(".fcstd"):
        from hexfeature import fcstd

        return mesh_brep(fcstd.read_brep(path, object_name), progress=progress, log=log, cancelled=cancelled, **chosen)
    if object_name:
        raise make_error("usage", "options", "an object can be named in a .FCStd file only", "leave the object out")
    return Mesh(_core.mesh_file(os.fsencode(path), chosen, progress, log, cancelled))


def mesh_brep(text, size=None, *, progress=None, log=None, cancelled=None, **choices):
    """Mesh a B-rep given as text, as FreeCAD's `shape.exportBrepToString()` gives it. The rest is as for `mesh`."""
    return Mesh(_core.mesh_brep(text, _chosen(size, choices), progress, log, cancelled))


def _chosen(size, choices):
    """The core's option dict. There 0 means "choose a size"; a user who says 0 has made a mistake."""
    if size is None:
        return choices
    if not isinstance(size, bool) and isinstance(size, (int, float)) and size <= 0:
        raise make_error("usage", "options", f"size is {size:g} but must be greater than 0",
                         "give the length of an element's side in the part's unit, or no size to have one chosen")
    return {"size": size, **choices}
