#!/usr/bin/python3
# HexFeatureWB - LGPL-2.1-or-later
"""Keep Resources/translations up to date: collect the window's texts into HexFeature_LANGUAGE.ts, compile them to .qm.

    /usr/bin/python3 packaging/translations.py          # every language that has a .ts file
    /usr/bin/python3 packaging/translations.py fr       # a new one

Texts are the literals in tr("...") and QT_TRANSLATE_NOOP(CONTEXT, "..."), the help of every option, and the program's messages; and, in
FreeCAD's own context for them, names and descriptions of the objects' properties. Translations that are there are kept, new texts are
added without one, texts that are gone are dropped. messages.json lists the messages with values in them, which the window has to find
again. Needs lrelease (qttools5-dev-tools).
"""
import ast
import json
import re
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import core_messages

ROOT = Path(__file__).resolve().parents[1]
FOLDER = ROOT / "Resources" / "translations"
CONTEXT = "HexFeature"
PROPERTIES = "App::Property"  #: FreeCAD's property editor asks for names and descriptions there
TEMPLATES = FOLDER / "messages.json"
#: functions of texts -> index of the first argument that is one
CALLS = {"tr": 0, "QT_TRANSLATE_NOOP": 1}
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
    return sorted({option.help for option in _options()})


def _options():
    sys.path.insert(0, str(ROOT / "python"))
    import hexfeature

    return [option for option in hexfeature.options() if option.name != "stop_after"]


def property_texts():
    """Names, as the property editor writes them, descriptions and groups of the properties of mesh and view."""
    found = {("Element Size" if option.name == "size" else option.name.replace("_", " ").title(), option.help) for option in _options()}
    for source in ("mesh_object.py", "view_provider.py"):
        for node in ast.walk(ast.parse((ROOT / "python" / "HexFeatureWB" / source).read_text(encoding="utf-8"))):
            row = node.elts if isinstance(node, ast.Tuple) else node.args if isinstance(node, ast.Call) else []
            literals = [part.value for part in row if isinstance(part, ast.Constant) and isinstance(part.value, str)]
            if len(literals) > 2 and literals[0].startswith(PROPERTIES):
                found.add((re.sub(r"(?<=[a-z])(?=[A-Z])", " ", literals[1]), literals[2]))
            if isinstance(node, ast.Assign) and getattr(node.targets[0], "id", "") in ("GROUP", "RESULTS"):
                found.add((node.value.value,))
    return sorted({text for pair in found for text in pair})


def all_texts():
    """What a language file holds: context -> its texts, sorted."""
    return {PROPERTIES: property_texts(), CONTEXT: sorted({*texts(), *option_texts(), *core_messages.texts(ROOT)})}


def templates():
    """What messages.json holds: the messages that have values in them."""
    return [text for text in core_messages.texts(ROOT) if re.search(r"%\d", text)]


def read(path, context=CONTEXT):
    """source -> translation of a context of a .ts file; unfinished ones are left out."""
    if not path.exists():
        return {}
    return {message.findtext("source"): message.findtext("translation") for each in ElementTree.parse(path).iter("context")
            if each.findtext("name") == context for message in each.iter("message")
            if message.findtext("translation") and message.find("translation").get("type") != "unfinished"}


def write(path, language, sources, known):
    """sources and known: by context."""
    root = ElementTree.Element("TS", version="2.1", language=language, sourcelanguage="en")
    for name in sources:
        context = ElementTree.SubElement(root, "context")
        ElementTree.SubElement(context, "name").text = name
        for source in sources[name]:
            message = ElementTree.SubElement(context, "message")
            ElementTree.SubElement(message, "source").text = source
            translation = ElementTree.SubElement(message, "translation")
            translation.text = known[name].get(source)
            if source not in known[name]:
                translation.set("type", "unfinished")
    ElementTree.indent(root)
    path.write_text('<?xml version="1.0" encoding="utf-8"?>\n<!DOCTYPE TS>\n' + ElementTree.tostring(root, encoding="unicode") + "\n",
                    encoding="utf-8")


def main():
    FOLDER.mkdir(exist_ok=True)
    languages = sys.argv[1:] or sorted(p.stem.split("_", 1)[1] for p in FOLDER.glob("HexFeature_*.ts"))
    sources = all_texts()
    TEMPLATES.write_text(json.dumps(templates(), indent=0) + "\n", encoding="utf-8")
    for language in languages:
        path = FOLDER / ("HexFeature_%s.ts" % language)
        known = {context: read(path, context) for context in sources}
        write(path, language, sources, known)
        subprocess.run([LRELEASE, "-silent", str(path), "-qm", str(path.with_suffix(".qm"))], check=True)
        print("%s: %d of %d texts translated" % (
            language, sum(text in known[context] for context in sources for text in sources[context]), sum(map(len, sources.values()))))


if __name__ == "__main__":
    main()
