# HexFeatureWB - LGPL-2.1-or-later
"""The house holds: each room knows only the rooms before it, and geometry, Python and FreeCAD keep apart."""
import ast
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
OCCT_ROOMS = {"brep", "surface"}


def declared_rooms():
    """room -> rooms that it may include, from CMakeLists.txt; a room declared later can never be used by one before it."""
    allowed = {}
    for room, uses in re.findall(r"hexfeature_room\((\w+)([\w ]*)\)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")):
        allowed[room] = {room}.union(*(allowed[u] for u in uses.split()))
    allowed["bindings"] = set(allowed) | {"bindings"}
    return allowed


ROOMS = declared_rooms()


def sources(folder):
    return sorted(p for p in folder.rglob("*") if p.suffix in (".h", ".cpp"))


def includes(path):
    return re.findall(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', path.read_text(encoding="utf-8"), re.MULTILINE)


def test_every_folder_is_a_declared_room():
    assert {p.name for p in (ROOT / "cpp").iterdir() if p.is_dir()} <= set(ROOMS)


@pytest.mark.parametrize("room", ROOMS)
def test_room_includes_only_rooms_before_it(room):
    for path in sources(ROOT / "cpp" / room):
        foreign = {i.split("/")[0] for i in includes(path) if i.split("/")[0] in ROOMS} - ROOMS[room]
        assert not foreign, f"{path.relative_to(ROOT)} includes {foreign}"


@pytest.mark.parametrize("room", sorted(set(ROOMS) - OCCT_ROOMS))
def test_only_brep_and_surface_know_opencascade(room):
    for path in sources(ROOT / "cpp" / room):
        assert not [i for i in includes(path) if i.endswith(".hxx")], path


def imported_modules(path):
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            yield from (a.name.split(".")[0] for a in node.names)
        elif isinstance(node, ast.ImportFrom) and node.module and not node.level:
            yield node.module.split(".")[0]


def test_the_package_knows_no_freecad():
    foreign = {"FreeCAD", "FreeCADGui", "App", "Gui", "Part", "Fem", "PySide", "HexFeatureWB", "OCC"}
    for path in sorted((ROOT / "python" / "hexfeature").glob("*.py")):
        assert not foreign & set(imported_modules(path)), path.name


def test_every_source_says_its_licence():
    for path in sources(ROOT / "cpp") + sources(ROOT / "tests" / "cpp"):
        assert path.read_text(encoding="utf-8").startswith("// HexFeatureWB - LGPL-2.1-or-later\n"), path
    for path in sorted((ROOT / "python").rglob("*.py")):
        assert "# HexFeatureWB - LGPL-2.1-or-later\n" in path.read_text(encoding="utf-8").split("\n", 2)[0] + "\n", path
