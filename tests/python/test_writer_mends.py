# HexFeatureWB - LGPL-2.1-or-later
"""The mends of FreeCAD's writer beside a FreeCAD that lacks, or has otherwise, what they mend."""
import sys
from types import ModuleType, SimpleNamespace

import numpy as np
import pytest

from HexFeatureWB import writer_mends

SQUARE = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0.5, 0, 0), (1, 0.5, 0), (0.5, 1, 0), (0, 0.5, 0)]


@pytest.fixture
def fem(monkeypatch):
    """FreeCAD's package femmesh with empty modules."""
    package = ModuleType("femmesh")
    package.meshsetsgetter, package.meshtools = ModuleType("meshsetsgetter"), ModuleType("meshtools")
    monkeypatch.setitem(sys.modules, "femmesh", package)
    return package


def getter_of(**methods):
    return type("MeshSetsGetter", (), methods)


def test_a_freecad_without_the_mended_places_is_left_alone(fem):
    writer_mends.mend(lambda mesh: True)
    fem.meshsetsgetter.MeshSetsGetter = getter_of()
    writer_mends.mend(lambda mesh: True)
    fem.meshsetsgetter.MeshSetsGetter = getter_of(get_constraints_force_nodeloads=lambda self: "as ever")
    writer_mends.mend(lambda mesh: True)
    writer = fem.meshsetsgetter.MeshSetsGetter()
    writer.mesh_object = None
    assert writer.get_constraints_force_nodeloads() == "as ever"


def test_only_the_meshes_concerned_are_shared_by_curved_quads(fem):
    nodes = dict(enumerate(SQUARE))
    fem.meshtools.get_ref_facenodes_areas = flat = lambda nodes, faces: [(node, 1 / 8) for face in faces.values() for node in face]
    fem.meshsetsgetter.MeshSetsGetter = getter_of(
        get_constraints_force_nodeloads=lambda self: dict(fem.meshtools.get_ref_facenodes_areas(nodes, {1: tuple(range(8))})))
    for _ in range(2):
        writer_mends.mend(lambda mesh: mesh == "ours")
    writer = fem.meshsetsgetter.MeshSetsGetter()
    writer.mesh_object = "ours"
    assert list(writer.get_constraints_force_nodeloads().values()) == pytest.approx([-1 / 12] * 4 + [1 / 3] * 4)
    assert fem.meshtools.get_ref_facenodes_areas is flat
    writer.mesh_object = "another"
    assert set(writer.get_constraints_force_nodeloads().values()) == {1 / 8}


@pytest.mark.parametrize(
    "constraint", [{"HeatFluxFaces": [1]}, {"HeatFluxFaceTable": []}, {"HeatFluxFaceTable": [("Part:Face1", [(1, 1)])]}])
def test_a_heat_flux_that_freecad_has_written_stays(fem, constraint):
    fem.meshsetsgetter.MeshSetsGetter = getter_of(get_constraints_heatflux_faces=lambda self: None)
    writer_mends.mend(lambda mesh: True)
    writer = fem.meshsetsgetter.MeshSetsGetter()
    writer.mesh_object, writer.femmesh = "ours", SimpleNamespace(HexaCount=1)
    writer.member, before = SimpleNamespace(cons_heatflux=[constraint]), dict(constraint)
    writer.get_constraints_heatflux_faces()
    assert constraint == before


def test_the_area_of_a_curved_quad_is_the_rings():
    def at(r, t):
        return r * np.cos(t), r * np.sin(t), 0.0

    ring = [at(1, 0), at(2, 0), at(2, 0.4), at(1, 0.4), at(1.5, 0), at(2, 0.2), at(1.5, 0.4), at(1, 0.2)]
    assert sum(writer_mends.areas_of_quad8(ring)) == pytest.approx(0.5 * 0.4 * 3, rel=1e-4)
    assert writer_mends.areas_of_quad8(SQUARE) == pytest.approx([-1 / 12] * 4 + [1 / 3] * 4)
