# HexFeatureWB - LGPL-2.1-or-later
"""Hexahedral meshes of CAD solids in FreeCAD, headless API.

    import HexFeatureWB
    mesh = HexFeatureWB.mesh(doc.Body, size=4)                      # a FEM mesh object in the document
    mesh = HexFeatureWB.mesh(doc.Body, size=4, analysis=doc.Analysis)
    HexFeatureWB.refresh(mesh)                                      # after the model or an option changed

The geometry is done by the package ``hexfeature``, which knows no FreeCAD; this package carries shapes there and
meshes back.
"""
from .meshing import MeshingError, check_groups, mesh, refresh

__all__ = ["MeshingError", "check_groups", "mesh", "refresh"]
