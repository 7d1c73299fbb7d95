# HexFeatureWB - LGPL-2.1-or-later
"""German is complete: every text of the window has a translation with the same placeholders, and is compiled."""
import importlib.util
import json
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
    for context, texts in tool.all_texts().items():
        known = tool.read(FOLDER / "HexFeature_de.ts", context)
        missing = [text for text in texts if text not in known]
        assert not missing, "run make translations and translate, in the context %s: %s" % (context, missing)


def test_messages_with_values_are_listed():
    tool = script()
    assert json.loads(tool.TEMPLATES.read_text(encoding="utf-8")) == tool.templates(), "run make translations"


def test_messages_of_sources_in_both_languages():
    script()
    import core_messages

    cpp = r"""
      fail("no face at all: check " + path);
      context.log("sheet " + std::to_string(n) + (sharp ? " (sharp)" : " (smooth)") + ": " + why);
      reason = bad ? "a chart lies outside" : "a chart is empty";
      text << "asks for " << count << " cells";
      {"threads", &Options::threads, 1, 256, {}, true, "the help of an option"},
    """
    found = {piece for message in core_messages._of_cpp(cpp) for piece in core_messages.pieces(message)}
    assert found == {"no face at all", "check %1", "sheet %1 (sharp)", "sheet %1 (smooth)", "a chart lies outside", "a chart is empty",
                     "asks for %1 cells"}
    python = 'raise usage("size is %g but small" % size)\nmake_error("output", "write", f"cannot write {path}: no room", "free some space")'
    found = {piece for message in core_messages._of_python(python) for piece in core_messages.pieces(message)}
    assert found == {"size is %1 but small", "cannot write %1", "no room", "free some space"}


def test_placeholders_are_kept():
    tool = script()
    for source, translation in (pair for context in tool.all_texts() for pair in tool.read(FOLDER / "HexFeature_de.ts", context).items()):
        placeholders = [sorted(re.findall(r"%(?:\(\w+\))?[\d.]*[a-z]|%\d", text)) for text in (source, translation)]
        assert placeholders[0] == placeholders[1], source


def test_the_compiled_file_holds_the_translations():
    compiled = (FOLDER / "HexFeature_de.qm").read_bytes()
    tool = script()
    for translation in (words for context in tool.all_texts() for words in tool.read(FOLDER / "HexFeature_de.ts", context).values()):
        assert translation.encode("utf-16-be") in compiled, translation
