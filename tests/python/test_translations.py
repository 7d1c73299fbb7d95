# HexFeatureWB - LGPL-2.1-or-later
"""German is complete: every text of the window has a translation with the same placeholders, and is compiled."""
import importlib.util
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FOLDER = ROOT / "Resources" / "translations"


def script():
    sys.path.insert(0, str(ROOT / "packaging"))
    spec = importlib.util.spec_from_file_location("translations", ROOT / "packaging" / "translations.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_german_is_complete():
    tool = script()
    known = tool.read(FOLDER / "HexFeature_de.ts")
    # Not the core's messages: a new one is shown in English until it is translated.
    missing = [text for text in tool.texts() + tool.option_texts() if text not in known]
    assert not missing, "run packaging/translations.py and translate %s" % missing


def test_placeholders_are_kept():
    for source, translation in script().read(FOLDER / "HexFeature_de.ts").items():
        placeholders = [sorted(re.findall(r"%(?:\(\w+\))?[\d.]*[a-z]|%\d", text)) for text in (source, translation)]
        assert placeholders[0] == placeholders[1], source


def test_the_compiled_file_holds_the_translations():
    compiled = (FOLDER / "HexFeature_de.qm").read_bytes()
    for translation in script().read(FOLDER / "HexFeature_de.ts").values():
        assert translation.encode("utf-16-be") in compiled, translation
