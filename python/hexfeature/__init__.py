# HexFeatureWB - LGPL-2.1-or-later
"""Fully automatic all-hexahedral meshes of CAD parts, by feature-line extraction.

    import hexfeature
    mesh = hexfeature.mesh("part.step", size=4)
    mesh.write("part.inp")
    print(mesh.report["quality"]["min_scaled_jacobian"])

Lengths are in the part's own unit. CAD faces, edges, vertices and solids are numbered from 1 as OpenCASCADE's
TopExp::MapShapes counts them, which is FreeCAD's Face1, Edge1, Vertex1. Everything that goes wrong is a `MeshingError`.
"""
from hexfeature._core import __version__
from hexfeature.api import Mesh, MeshingError, Option, mesh, mesh_brep, options

__all__ = ["Mesh", "MeshingError", "Option", "__version__", "mesh", "mesh_brep", "options"]
