# HexFeatureWB - LGPL-2.1-or-later
"""The core's messages as texts to translate: what its C++ sources give as reason and hint of an error.

A message is cut at ": ", for what follows is a message of its own, and what the program puts into it is %1, %2, ...
`HexFeatureWB.gui.messages.in_words` takes a message apart in the same way.
"""
import re
from pathlib import Path

#: Rooms and sources whose messages a user of the window can meet: FreeCAD reads files by itself.
SHOWN = ("base", "bindings/core.cpp", "brep/base_mesh.cpp", "brep/read.cpp", "brep/sound.cpp", "fit", "lattice", "mesh", "pipeline",
         "polycube", "shape", "smooth", "surface/triangulate.cpp", "tetsplit", "write")
CALL = re.compile(r"\b(?:MeshingError|bad_input|refuse|fail|give_up|out_of_memory)\s*\(")
ASSIGNED = re.compile(r'\breason\s*=\s*([^;]*);|\breturn ("[^"]* [^"]*");')
LITERAL = re.compile(r'"((?:[^"\\]|\\.)*)"')
PIECES = re.compile(r": (?![^(]*\))")


def texts(root):
    """Every piece of a message under root/cpp, sorted."""
    found = set()
    for shown in SHOWN:
        place = Path(root) / "cpp" / shown
        for path in sorted(place.rglob("*.[ch]*")) if place.is_dir() else [place]:
            source = path.read_text(encoding="utf-8")
            arguments = [a for call in CALL.finditer(source) for a in _split(source, call.end(), ",")]
            arguments += [a or b for a, b in ASSIGNED.findall(source)]
            for argument in arguments:
                found |= set(_pieces(argument))
    return sorted(found)


def _pieces(expression):
    """Of a C++ expression of literals and values that are added: the pieces with words in them."""
    if '"' not in expression:
        return
    message = ""
    for term in _split(expression, 0, "+"):
        literals = LITERAL.findall(term)
        message += "".join(literals) if literals and not LITERAL.sub("", term).strip() else "\0"
    for piece in PIECES.split(message):
        count = iter(range(1, 10))
        piece = re.sub("\0", lambda _: "%%%d" % next(count), piece)
        if " " in re.sub(r"%\d", "", piece).strip():
            yield piece


def _split(source, at, separator):
    """What stands between separators, up to the bracket that closes the expression which begins at `at`."""
    parts, depth, start = [], 0, at
    while at < len(source):
        literal = LITERAL.match(source, at)
        if literal:
            at = literal.end()
            continue
        here = source[at]
        depth += (here in "([{") - (here in ")]}")
        if depth < 0:
            break
        if here == separator and depth == 0:
            parts.append(source[start:at])
            start = at + 1
        at += 1
    return parts + [source[start:at]]
