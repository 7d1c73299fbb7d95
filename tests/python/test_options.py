# HexFeatureWB - LGPL-2.1-or-later
"""The one list of options, and the API's errors."""
import pytest

import hexfeature
from hexfeature.cli import _parser

OPTIONS = hexfeature.options()


def test_every_option_is_complete():
    assert len({o.name for o in OPTIONS}) == len(OPTIONS)
    for o in OPTIONS:
        assert o.help and o.type in ("float", "int", "bool", "str")
        assert isinstance(o.default, {"float": float, "int": int, "bool": bool, "str": str}[o.type])
        if o.choices:
            assert o.default in o.choices
        if o.minimum is not None:
            assert o.minimum <= o.default <= o.maximum


@pytest.mark.parametrize("option", OPTIONS, ids=lambda o: o.name)
def test_the_command_line_has_every_option(option):
    value = {"float": 2.5, "int": 2, "bool": False, "str": option.choices[-1] if option.choices else "x"}[option.type]
    flag = option.name.replace("_", "-")
    arguments = [f"--no-{flag}"] if option.type == "bool" else [f"--{flag}", str(value)]
    choice = _parser().parse_args(["mesh", "part.step", "-o", "m.vtk"] + arguments)
    assert getattr(choice, option.name) == value


@pytest.mark.parametrize("bad", [
    {"size": 0}, {"size": -2}, {"size": float("nan")}, {"size": "4"}, {"size": True}, {"order": 3}, {"order": 1.5},
    {"method": "magic"}, {"sheets": 1}, {"no_such_option": 1}, {"threads": 0}, {"labels": None}])
def test_impossible_options_are_usage_errors(parts, bad):
    with pytest.raises(hexfeature.MeshingError) as caught:
        hexfeature.mesh(parts / "box.step", **bad)
    error = caught.value
    assert (error.kind, error.step) == ("usage", "options")
    assert error.reason and error.hint and error.cad_faces == []


def test_defaults_are_the_cores(box_mesh):
    options = dict(box_mesh.report["options"])
    assert options.pop("size") == 5
    assert options == {o.name: o.default for o in OPTIONS if o.name != "size"}
