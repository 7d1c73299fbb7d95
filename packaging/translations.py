#!/usr/bin/python3
# HexFeatureWB - LGPL-2.1-or-later
"""Keep Resources/translations up to date: collect the window's texts into HexFeature_LANGUAGE.ts, compile them to .qm.

    /usr/bin/python3 packaging/translations.py          # every language that has a .ts file
    /usr/bin/python3 packaging/translations.py fr       # a new one

Texts are the literals in tr("...") and QT_TRANSLATE_NOOP(CONTEXT, "..."), the help of every option, and the core's messages.
Translations that are there are kept, new texts are added without one, texts that are gone are dropped. Needs lrelease
(qttools5-dev-tools).
"""
import ast
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import core_messages

ROOT = Path(__file__).resolve().parents[1]
FOLDER = ROOT / "Resources" / "translations"
CONTEXT = "HexFeature"
#: functions of texts -> index of the first argument that is one
CALLS = {"tr": 0, "QT_TRANSLATE_NOOP": 1, "_bad_input": 0}
LRELEASE = "/usr/lib/qt5/bin/lrelease"


def texts():
    """Every text of the window, sorted."""
    found = set()
    for path in sorted((ROOT / "python" / "HexFeatureWB").rglob("*.py")):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call) and getattr(node.func, "id", "") in CALLS:
                for literal in node.args[CALLS[node.func.id]:]:
                    if isinstance(literal, ast.Constant) and isinstance(literal.value, str):
                        found.add(literal.value)
    return sorted(found)


def option_texts():
    """The help of every option, which are tooltips."""
    sys.path.insert(0, str(ROOT / "python"))
    import hexfeature

    return sorted({option.help for option in hexfeature.options() if option.name != "stop_after"})


def all_texts():
    """What a language file holds, sorted."""
    return sorted({*texts(), *option_texts(), *core_messages.texts(ROOT)})


def read(path):
    """source -> translation of a .ts file; unfinished ones are left out."""
    if not path.exists():
        return {}
    return {message.findtext("source"): message.findtext("translation") for message in ElementTree.parse(path).iter("message")
            if message.findtext("translation") and message.find("translation").get("type") != "unfinished"}


def write(path, language, sources, known):
    root = ElementTree.Element("TS", version="2.1", language=language, sourcelanguage="en")
    context = ElementTree.SubElement(root, "context")
    ElementTree.SubElement(context, "name").text = CONTEXT
    for source in sources:
        message = ElementTree.SubElement(context, "message")
        ElementTree.SubElement(message, "source").text = source
        translation = ElementTree.SubElement(message, "translation")
        translation.text = known.get(source)
        if source not in known:
            translation.set("type", "unfinished")
    ElementTree.indent(root)
    path.write_text('<?xml version="1.0" encoding="utf-8"?>\n<!DOCTYPE TS>\n' + ElementTree.tostring(root, encoding="unicode") + "\n",
                    encoding="utf-8")


def main():
    FOLDER.mkdir(exist_ok=True)
    languages = sys.argv[1:] or sorted(p.stem.split("_", 1)[1] for p in FOLDER.glob("HexFeature_*.ts"))
    sources = all_texts()
    for language in languages:
        path = FOLDER / ("HexFeature_%s.ts" % language)
        known = read(path)
        write(path, language, sources, known)
        subprocess.run([LRELEASE, "-silent", str(path), "-qm", str(path.with_suffix(".qm"))], check=True)
        print("%s: %d of %d texts translated" % (language, sum(s in known for s in sources), len(sources)))


if __name__ == "__main__":
    main()
