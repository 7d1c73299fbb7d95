# HexFeatureWB - LGPL-2.1-or-later
"""The documentation says what is so: the option table, links, the changelog's licence."""
import importlib.util
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PAGES = [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]


def test_the_option_table_is_the_programs():
    spec = importlib.util.spec_from_file_location("make_option_table", ROOT / "docs" / "make_option_table.py")
    script = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(script)
    assert script.table() in script.PAGE.read_text(encoding="utf-8"), "run python3 docs/make_option_table.py"


@pytest.mark.parametrize("page", PAGES, ids=lambda p: p.name)
def test_links_lead_somewhere(page):
    for target in re.findall(r"\]\(([^)#]+)[^)]*\)", page.read_text(encoding="utf-8")):
        assert target.startswith("http") or (page.parent / target).exists(), target


def test_make_targets_of_the_readme_exist():
    targets = set(re.findall(r"^([a-z-]+):", (ROOT / "Makefile").read_text(encoding="utf-8"), re.MULTILINE))
    for page in PAGES:
        for line in re.findall(r"^    make ([a-z -]+?)(?:\s+#.*)?$", page.read_text(encoding="utf-8"), re.MULTILINE):
            assert set(line.split()) <= targets, (page.name, line)
