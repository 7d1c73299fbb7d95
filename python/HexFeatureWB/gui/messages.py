# HexFeatureWB - LGPL-2.1-or-later
"""What the window says: failures with their reason and what to try, results, names of steps."""
import html
import os
import re

import FreeCADGui
from PySide import QtCore, QtGui

from ..translate import tr
from ..view_provider import ICONS
from .widgets import choice_title, number

WAIT = QtCore.Qt.WaitCursor


def icon(name):
    """Path of one of our icons."""
    return os.path.join(ICONS, name + ".svg")


def qicon(name):
    """One of our icons as a QIcon. FreeCAD draws the SVG itself: Qt may lack its plugin for it."""
    return FreeCADGui.getIcon(icon(name)) if hasattr(FreeCADGui, "getIcon") else QtGui.QIcon(icon(name))


def number_of(flag):
    """A Qt enum as the int that FreeCAD and Qt's painter take, in Qt 5 and 6."""
    return int(getattr(flag, "value", flag))


def tell(text, details=""):
    """A message box that needs no answer. Tests read the last text in `tell.last` and see no box."""
    tell.last = text
    if os.environ.get("HEXFEATURE_NO_BOXES"):
        return
    box = QtGui.QMessageBox(FreeCADGui.getMainWindow())
    box.setWindowTitle(tr("Hex mesh"))
    box.setText(text)
    box.setDetailedText(details)
    box.setIcon(QtGui.QMessageBox.Information)
    (getattr(box, "exec", None) or box.exec_)()


tell.last = ""


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
        "options": tr("options"),
        "": tr("starting"),
    }


def step_title(step):
    """One step in the user's words; a new one by its name."""
    return step_titles().get(step, step)


#: what the core puts into its messages: numbers and labels, or else names in quotes
VALUES = (r"[+-][XYZ]\b|\d[\d.]*(?:e[+-]?\d+)?", r"(?<=')[^']*(?=')")


def in_words(message):
    """A reason or hint of the core in the user's language, or as it is. Takes it apart as packaging/core_messages.py does."""
    return ": ".join(_piece_in_words(piece) for piece in re.split(r": (?![^(]*\))", message))


def _piece_in_words(piece):
    words = tr(piece)
    if words != piece or not piece:
        return words
    for values in VALUES:
        found = re.findall(values, piece)
        count = iter(range(1, len(found) + 1))
        template = re.sub(values, lambda _: "%%%d" % next(count), piece)
        words = tr(template)
        if words != template:
            return re.sub(r"%(\d)", lambda place: found[int(place[1]) - 1], words)
    return piece


def batch_words(column, value):
    """A cell of a batch's summary in the user's language."""
    if column == "result":
        return {"meshed": tr("meshed"), "failed": tr("failed"), "unreadable": tr("unreadable")}.get(value, value)
    if column != "why":
        return value
    step, colon, reason = value.partition(": ")
    if colon and step in step_titles():
        return "%s: %s" % (step_title(step), in_words(reason))
    of_files = {"there is no such file": tr("there is no such file"), "there is no solid in it": tr("there is no solid in it")}
    return of_files.get(value, value)


def faces_to_blame(error, names):
    """FreeCAD names of the CAD faces that an error names, the first twenty."""
    found = [names["faces"](number) for number in getattr(error, "cad_faces", [])]
    return [name for name in found if name][:20]


def given_up(error):
    """Whether the user has cancelled; a time limit that is reached is a failure of the same kind."""
    return getattr(error, "kind", "") == "cancelled" and error.reason == "cancelled"


def failure_text(error, faces, plain=False):
    """Step, reason, faces and hint of an error, as rich or plain text."""
    reason = getattr(error, "reason", None)
    reason = in_words(reason) if reason is not None else "%s: %s" % (type(error).__name__, error)  # the latter is a bug
    where = tr("No mesh. Step: %s") % step_title(getattr(error, "step", ""))
    blame = tr("Faces to look at (selected in the view): %s") % ", ".join(faces) if faces else ""
    hint = in_words(getattr(error, "hint", ""))
    if plain:
        return "HexFeatureWB: " + ". ".join(part for part in (where, reason, blame, hint) if part)
    lines = ["<b>%s</b>" % html.escape(where), html.escape(reason)]
    if blame:
        lines.append(html.escape(blame))
    if hint:
        lines.append("<i>%s</i>" % html.escape(tr("Try: %s") % hint))
    return "<br>".join(lines)


def success_text(mesh):
    """The figures of a mesh in two lines."""
    return tr("%(count)s hexahedra in %(seconds).1f s (%(method)s)\nscaled Jacobian: worst %(worst).3f, mean %(mean).3f") % {
        "count": number(mesh.HexCount), "seconds": mesh.Seconds, "method": choice_title("method", mesh.MethodUsed),
        "worst": mesh.MinScaledJacobian, "mean": mesh.MeanScaledJacobian}
