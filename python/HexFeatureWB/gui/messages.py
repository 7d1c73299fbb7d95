# HexFeatureWB - LGPL-2.1-or-later
"""What the window says: failures with their reason and what to try, results."""
import html
import json
import os

import FreeCADGui
from PySide import QtCore, QtGui

from ..translate import tr
from ..view_provider import ICONS
from .program_words import in_words, log_in_words, step_title, step_titles  # noqa: F401
from .widgets import choice_title, decimal, number

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
    """The figures of a mesh in two lines, and what a user has to know before a load is put on it."""
    text = tr("%(count)s hexahedra in %(seconds)s s (%(method)s)\nscaled Jacobian: worst %(worst)s, mean %(mean)s") % {
        "count": number(mesh.HexCount), "seconds": decimal(mesh.Seconds, 1), "method": choice_title("method", mesh.MethodUsed),
        "worst": decimal(mesh.MinScaledJacobian, 3), "mean": decimal(mesh.MeanScaledJacobian, 3)}
    short = len(json.loads(mesh.Report).get("groups_not_found_by_geometry", {}))
    if short:
        text += "\n" + tr("FreeCAD misses elements on %d faces: a load there may be short (see the report view)") % short
    return text
