# HexFeatureWB - LGPL-2.1-or-later
"""What the meshing program says, reasons, hints and lines of its log, in the user's language."""
import functools
import json
import os
import re

from ..translate import tr
from ..view_provider import ICONS
from . import widgets

#: every message that has values in it, %1, %2, ...: made by packaging/translations.py
TEMPLATES = os.path.join(os.path.dirname(ICONS), "translations", "messages.json")
PIECES = re.compile(r": (?![^(]*\))")
VALUE = r"(?:[+-][XYZ]|[+-]?\d[\d.]*(?:e[+-]?\d+)?|inf|-?nan)"  #: a label or a number
VALUES = re.compile(r"%s(?:,? %s)*" % (VALUE, VALUE))
#: what the program puts round a message: numbers or labels behind it, brackets behind it, a count before it
LONGER = [re.compile(pattern, re.DOTALL) for pattern in (r"()(.*?\S)((?: %s)+)" % VALUE, r"()(.*\S)( \([^()]*\))", r"(\d+ )(\D.*)()")]


def step_titles():
    """Step of the program -> the same in the user's words."""
    return {
        "read": tr("reading the part"),
        "frame": tr("finding directions"),
        "surface": tr("surface triangles"),
        "label": tr("labels"),
        "labels": tr("labels"),
        "shape": tr("feature lines"),
        "polycube": tr("polycube"),
        "lattice": tr("unit cubes"),
        "fit": tr("fitting to the part"),
        "sheet": tr("layers under smooth borders"),
        "sheets": tr("layers under smooth borders"),
        "smooth": tr("smoothing"),
        "quality": tr("measuring"),
        "certificate": tr("proving every element"),
        "second order": tr("mid-side nodes"),
        "tet-split": tr("from tetrahedra"),
        "tetrahedra": tr("tetrahedra"),
        "write": tr("writing"),
        "build": tr("building FreeCAD's mesh"),
        "groups": tr("checking groups"),
        "options": tr("options"),
        "export": tr("writing"),
        "": tr("starting"),
    }


def step_title(step):
    """One step in the user's words; a new one by its name."""
    return step_titles().get(step, step)


def in_words(message):
    """A message of the program in the user's language, or as it is. Takes it apart as packaging/core_messages.py does."""
    for template in _templates():
        if ":" in template[0]:
            words = _filled(template, message)
            if words is not None:
                return words
    return ": ".join(_piece(piece) for piece in PIECES.split(message))


def log_in_words(line):
    """A line of a Job's log: its time, then a step or a message."""
    time, text = re.fullmatch(r"(\s*[\d.]+ s  )?(.*)", line, re.DOTALL).groups()
    return (time or "") + in_words(text)


def _piece(piece):
    """A message without ': ' in it."""
    bare = piece.strip(" ")
    if bare != piece:
        return piece[:len(piece) - len(piece.lstrip(" "))] + _piece(bare) + piece[len(piece.rstrip(" ")):] if bare else piece
    if not piece or VALUES.fullmatch(piece):
        return piece
    if piece in step_titles():
        return step_title(piece)
    words = tr("none") if piece == "none" else tr(piece)
    if words != piece:
        return words
    return next((words for words in (_filled(template, piece) for template in _templates()) if words is not None), None) or _tail(piece)


def _filled(template, piece):
    """The message in the user's words if it is one of this template, else None."""
    text, pattern, quoted = template
    found = pattern.fullmatch(piece)
    if not found:
        return None
    values = [value if raw else _piece(value) for value, raw in zip(found.groups(), quoted)]
    return re.sub(r"%(\d)", lambda place: values[int(place[1]) - 1], tr(text))


def _tail(piece):
    """A message that the program has made longer: by numbers or labels, or by what stands in brackets; or one about an option."""
    option, space, rest = piece.partition(" ")
    if space and widgets.has_title(option):
        return widgets.title_of(option) + " " + _piece(rest)
    for pattern in LONGER:
        longer = pattern.fullmatch(piece)
        words = longer and _piece(longer[2])
        if longer and words != longer[2]:
            return longer[1] + words + longer[3]
    return piece


@functools.lru_cache(maxsize=None)
def _templates():
    """[(template, its pattern, which values stand in quotes: names, not words)], the longest first."""
    with open(TEMPLATES, encoding="utf-8") as f:
        templates = json.load(f)
    return [(template, re.compile(re.sub(r"%\d", "(.+?)", re.escape(template).replace(r"\%", "%")), re.DOTALL),
             [template[m.start() - 1:m.start()] == "'" for m in re.finditer(r"%\d", template)])
            for template in sorted(templates, key=lambda text: (-len(re.sub(r"%\d", "", text)), text))]
