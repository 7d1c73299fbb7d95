# HexFeatureWB - LGPL-2.1-or-later
"""The program's messages as texts to translate: reasons and hints of errors, and lines of the log, from its C++ and Python sources.

A message is cut at ": ", for what follows is a message of its own, and what the program puts into it is %1, %2, ...
`HexFeatureWB.gui.program_words` takes a message apart in the same way.
"""
import ast
import itertools
import re
from pathlib import Path

#: Rooms and sources whose messages a user of the window can meet: FreeCAD reads files by itself.
SHOWN = ("base", "brep/analyse.cpp", "brep/base_mesh.cpp", "brep/cad_model.cpp", "brep/read.cpp", "brep/sound.cpp", "fit",
         "label", "lattice", "mesh", "pipeline", "polycube", "quadratic", "quality", "shape", "sheet", "smooth", "surface/triangulate.cpp",
         "tetsplit", "write/output_file.cpp", "write/write.cpp", "write/write_inp.cpp")
#: sources in Python, and the functions whose texts are reasons and hints
SHOWN_PYTHON = ("HexFeatureWB/exporting.py", "HexFeatureWB/fem_mesh.py", "HexFeatureWB/meshing.py", "HexFeatureWB/source.py",
                "hexfeature/errors.py", "hexfeature/formats.py")
REASONS = ("usage", "_bad_input", "make_error", "system_error", "ValueError", "RuntimeError", "_failure")

TOKEN = re.compile(r'(?P<text>"(?:[^"\\\n]|\\.)*")|(?P<comment>//[^\n]*|/\*.*?\*/)|(?P<line>^[ \t]*#[^\n]*)'
                   r"|(?P<char>'(?:[^'\\\n]|\\.)*')|(?P<other>\w+|::|<<|\+\+|->|[^\s\w])", re.DOTALL | re.MULTILINE)
WORDS = re.compile(r"[a-z]\S* .*[a-z]|[a-z].* \S*[a-z]", re.IGNORECASE)
PIECES = re.compile(r": (?![^(]*\))")
OPEN, CLOSE = "([{", ")]}"
VALUE = "\0"


def texts(root):
    """Every piece of a message of the sources under root, sorted."""
    found = set()
    for shown in SHOWN:
        place = Path(root) / "cpp" / shown
        for path in sorted(place.rglob("*.[ch]*")) if place.is_dir() else [place]:
            for message in _of_cpp(path.read_text(encoding="utf-8")):
                found |= set(pieces(message))
    for shown in SHOWN_PYTHON:
        for message in _of_python((Path(root) / "python" / shown).read_text(encoding="utf-8")):
            found |= set(pieces(message))
    return sorted(found)


def pieces(message):
    """Of a message with VALUE for what is put into it: the pieces with words in them."""
    for piece in PIECES.split(message):
        count = iter(range(1, 10))
        piece = re.sub(VALUE, lambda _: "%%%d" % next(count), piece.strip(" "))
        bare = re.sub(r"%[\d*]\w*", "", piece).strip(" ,;()")
        if " " in bare or "%" in piece and len(bare) > 4:
            yield piece


# ---- C++

def _of_cpp(source):
    """The messages of a C++ source: every sum of texts and values in which a text has two words, or that is logged."""
    tokens = [m for m in TOKEN.finditer(source) if m.lastgroup in ("text", "other", "char")]
    kinds, words = [m.lastgroup for m in tokens], [m[0] for m in tokens]
    done = -1
    for at, kind in enumerate(kinds):
        if at <= done or kind != "text":
            continue
        start, end = _borders(words, at)
        if not WORDS.search(words[at][1:-1]) and words[start - 2:start] != ["log", "("]:
            continue
        done = end - 1
        if start > 1 and words[start - 1] == "," and words[start - 2] in ("true", "false"):
            continue  # an option's help, which is collected elsewhere
        yield from (m for m in _alternatives(words[start:end], kinds[start:end]) if "\n" not in m)


def _borders(words, at):
    """The sum that token `at` belongs to, as [start, end)."""
    def ends(word):
        return word in (",", ";", "=", "?", ":", "return", "{", "}")

    start, depth = at, 0
    while start > 0:
        word = words[start - 1]
        depth += (word in CLOSE) - (word in OPEN)
        if depth < 0 or depth == 0 and ends(word):
            break
        start -= 1
    end, depth = at, 0
    while end < len(words):
        depth += (words[end] in OPEN) - (words[end] in CLOSE)
        if depth < 0 or depth == 0 and ends(words[end]):
            break
        end += 1
    return start, end


def _alternatives(words, kinds):
    """The messages that a sum can be: it may hold texts that are chosen by a condition."""
    terms = _split(words, kinds, ("+", "<<"))
    if "<<" in words and terms and "text" not in terms[0][1]:
        terms = terms[1:]  # the stream
    yield from map("".join, itertools.product(*[_term(*term) for term in terms]))


def _term(words, kinds):
    if kinds and set(kinds) == {"text"}:
        return ["".join(ast.literal_eval(word) for word in words)]
    if words[:3] == ["std", "::", "string"]:
        words, kinds = words[3:], kinds[3:]
    if words[:1] == ["("] and words[-1] == ")" and "text" in kinds:
        parts = _split(words[1:-1], kinds[1:-1], ("?", ":"))
        if len(parts) == 1:
            return list(_alternatives(*parts[0]))
        if all("text" in part[1] for part in parts[1:]):
            return [message for part in parts[1:] for message in _alternatives(*part)]
    return [VALUE]


def _split(words, kinds, separators):
    """[(words, kinds)] between separators outside brackets."""
    parts, depth, start = [], 0, 0
    for at, word in enumerate(words):
        depth += (word in OPEN) - (word in CLOSE)
        if depth == 0 and word in separators and kinds[at] == "other":
            parts.append((words[start:at], kinds[start:at]))
            start = at + 1
    return [*parts, (words[start:], kinds[start:])]


# ---- Python

def _of_python(source):
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Call) and getattr(node.func, "id", getattr(node.func, "attr", "")) in REASONS:
            for argument in node.args:
                message = _python_text(argument.body if isinstance(argument, ast.IfExp) else argument)
                if message and WORDS.search(message):
                    yield message


def _python_text(node):
    """The text of a literal, a formatted one, or one with a value behind it; else an empty one."""
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        return node.value
    if isinstance(node, ast.JoinedStr):
        return "".join(part.value if isinstance(part, ast.Constant) else VALUE for part in node.values)
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Mod):
        return re.sub(r"%[\d.]*[a-z]", VALUE, _python_text(node.left))
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add):
        return (_python_text(node.left) or VALUE) + (_python_text(node.right) or VALUE)
    return ""
