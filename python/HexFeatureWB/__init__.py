# HexFeatureWB - LGPL-2.1-or-later
"""Hexahedral meshes of CAD solids in FreeCAD, headless API.

    import HexFeatureWB
    mesh = HexFeatureWB.mesh(doc.Body, size=4)                      # a FEM mesh object in the document
    mesh = HexFeatureWB.mesh(doc.Body, size=4, analysis=doc.Analysis)
    HexFeatureWB.refresh(mesh)                                      # after the model or an option changed
    HexFeatureWB.export(mesh, "part.inp")
    HexFeatureWB.feature_lines(doc.Body, size=4)                    # the block borders as an object of lines
    HexFeatureWB.recognition_model(doc.Body, size=4)                # the polycube as an object of faces

The geometry is done by the package ``hexfeature``, which knows no FreeCAD; this package carries shapes there and
meshes back. What has a window is in HexFeatureWB.gui.
"""
_HOMES = {
    "MeshingError": "meshing", "check_groups": "group_check", "mesh": "meshing", "refresh": "meshing",
    "export": "exporting", "feature_lines": "models", "recognition_model": "models",
}
__all__ = sorted(_HOMES)


def __getattr__(name):
    # Loaded when asked for: the workbench has to appear, and to say what to do, where the extension is missing.
    import importlib

    if name in _HOMES:
        module = importlib.import_module("." + _HOMES[name], __name__)
        globals()[name] = value = getattr(module, name)
        return value
    raise AttributeError("HexFeatureWB has no %r" % name)
