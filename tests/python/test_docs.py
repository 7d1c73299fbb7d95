# HexFeatureWB - LGPL-2.1-or-later
"""The documentation says what is so: the option table, links, the changelog's licence."""
import importlib.util
import os
import re
import shutil
import subprocess
import sys
import textwrap
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PAGES = [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]


def test_the_option_table_is_the_programs():
    spec = importlib.util.spec_from_file_location("make_option_table", ROOT / "docs" / "make_option_table.py")
    script = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(script)
    assert script.table() in script.PAGE.read_text(encoding="utf-8"), "run /usr/bin/python3 docs/make_option_table.py"


@pytest.mark.parametrize("page", PAGES, ids=lambda p: p.name)
def test_links_lead_somewhere(page):
    for target in re.findall(r"\]\(([^)#]+)[^)]*\)", page.read_text(encoding="utf-8")):
        assert target.startswith("http") or (page.parent / target).exists(), target


def test_make_targets_of_the_readme_exist():
    targets = set(re.findall(r"^([a-z-]+):", (ROOT / "Makefile").read_text(encoding="utf-8"), re.MULTILINE))
    for page in PAGES:
        for line in re.findall(r"^    make ([a-z -]+?)(?:\s+#.*)?$", page.read_text(encoding="utf-8"), re.MULTILINE):
            assert set(line.split()) <= targets, (page.name, line)


BLOCKS = [(p.name, code) for p in PAGES for code in re.findall(r"^```python\n(.*?)^```", p.read_text(encoding="utf-8"), re.S | re.M)]
PLAIN = [(name, code) for name, code in BLOCKS if "HexFeatureWB" not in code]
IN_FREECAD = [(name, code) for name, code in BLOCKS if "HexFeatureWB" in code and "App." not in code]


@pytest.fixture
def folder(parts, tmp_path):
    """An empty folder with part.step."""
    shutil.copy(parts / "plate.step", tmp_path / "part.step")
    return tmp_path


@pytest.mark.parametrize("name, code", PLAIN, ids=[f"{name}-{k}" for k, (name, _) in enumerate(PLAIN)])
def test_python_blocks_run(name, code, folder):
    done = subprocess.run([sys.executable, "-c", code], cwd=folder, capture_output=True, text=True, timeout=60,
                          env={**os.environ, "PYTHONPATH": str(ROOT / "python")})
    assert done.returncode == 0, done.stderr


@pytest.mark.skipif(not shutil.which("freecadcmd"), reason="there is no freecadcmd")
@pytest.mark.parametrize("name, code", IN_FREECAD, ids=[f"{name}-{k}" for k, (name, _) in enumerate(IN_FREECAD)])
def test_freecad_blocks_run(name, code, folder):
    end = "\nexcept BaseException:\n    import traceback\n    traceback.print_exc()\n    os._exit(1)\nos._exit(0)\n"
    (folder / "macro.py").write_text("import os\ntry:\n" + textwrap.indent(code, "    ") + end)
    done = subprocess.run(["freecadcmd", "-P", str(ROOT / "python"), "macro.py"], cwd=folder, capture_output=True, text=True, timeout=120,
                          stdin=subprocess.DEVNULL, env={**os.environ, "QT_QPA_PLATFORM": "offscreen"})
    assert done.returncode == 0, done.stderr


def test_pictures_are_small_and_shown():
    pictures = sorted((ROOT / "docs" / "pictures").iterdir())
    image = re.compile(r"!\[[^]]*\]\(([^)]+)\)")
    shown = {(page.parent / target).resolve() for page in PAGES for target in image.findall(page.read_text(encoding="utf-8"))}
    assert set(pictures) == {p for p in shown if p.parent == ROOT / "docs" / "pictures"}
    assert max(p.stat().st_size for p in pictures) < 200_000
    assert sum(p.stat().st_size for p in pictures) < 3_000_000


def test_the_index_leads_to_every_page():
    index = (ROOT / "docs" / "index.md").read_text(encoding="utf-8")
    for page in (ROOT / "docs").rglob("*.md"):
        assert page.name == "index.md" or f"]({page.relative_to(ROOT / 'docs')})" in index, page.name
