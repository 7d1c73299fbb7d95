# HexFeatureWB - LGPL-2.1-or-later
"""FreeCAD 0.20 and 1.0 look for a heat flux's element faces by a function that knows only tetrahedra: on hexahedra they write no
heat flux and say nothing. Here they are found as a pressure's are. FreeCAD 1.1 does so itself."""
import types


def mend():
    """Mend FreeCAD's heat flux for meshes where it finds nothing; for all others it stays as it is. Done once, and again without harm."""
    try:
        from femmesh import meshsetsgetter, meshtools
    except ImportError:  # a FreeCAD without its FEM workbench
        return
    getter = meshsetsgetter.MeshSetsGetter
    original = getter.get_constraints_heatflux_faces
    if "getccxVolumesByFace" not in original.__code__.co_names:  # mended already, or FreeCAD 1.1
        return

    def get_constraints_heatflux_faces(self):
        original(self)
        for femobj in self.member.cons_heatflux:
            if any(len(faces) for _, faces in femobj["HeatFluxFaceTable"]):
                continue
            femobj["HeatFluxFaceTable"] = [
                ("%s:%s" % (part.Name, name), _faces(self, meshtools, femobj["Object"], part, name))
                for part, names in femobj["Object"].References
                for name in names
                if part.Shape.getElement(name).ShapeType == "Face"
            ]

    getter.get_constraints_heatflux_faces = get_constraints_heatflux_faces


def _faces(getter, meshtools, constraint, part, name):
    """[[element, CalculiX' number of its face]] on one CAD face."""
    if not getter.femnodes_mesh:
        getter.femnodes_mesh = getter.femmesh.Nodes
    if not getter.femelement_table:
        getter.femelement_table = meshtools.get_femelement_table(getter.femmesh)
    if not getter.femnodes_ele_table:
        getter.femnodes_ele_table = meshtools.get_femnodes_ele_table(getter.femnodes_mesh, getter.femelement_table)
    one = types.SimpleNamespace(Name=constraint.Name, References=[(part, (name,))])
    return meshtools.get_pressure_obj_faces(getter.femmesh, getter.femelement_table, getter.femnodes_ele_table, {"Object": one})
