# HexFeatureWB - LGPL-2.1-or-later
"""The user's preferences, kept by FreeCAD under BaseApp/Preferences/Mod/HexFeature."""
import FreeCAD

from .. import mesh_object
from ..translate import CONTEXT

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

PATH = "User parameter:BaseApp/Preferences/Mod/HexFeature"

#: name -> (default, text): what the window does
SWITCHES = {
    "PreviewLines": (True, QT_TRANSLATE_NOOP(CONTEXT, "Show feature lines while the panel is open")),
    "PreviewLabels": (True, QT_TRANSLATE_NOOP(CONTEXT, "Colour the part by label while the panel is open")),
    "QualityAfterMeshing": (False, QT_TRANSLATE_NOOP(CONTEXT, "Colour a new mesh by element quality")),
    "HidePart": (True, QT_TRANSLATE_NOOP(CONTEXT, "Hide the part when its mesh is there")),
    "InFemWorkbench": (True, QT_TRANSLATE_NOOP(CONTEXT, "Show the hex mesh toolbar and menu in the FEM workbench too")),
}


def group():
    return FreeCAD.ParamGet(PATH)


def switch(name):
    """Whether one of SWITCHES is on."""
    return group().GetBool(name, SWITCHES[name][0])


def set_switch(name, on):
    group().SetBool(name, bool(on))


def option_default(spec):
    """The user's default of an option: as stored, or that of a new mesh object."""
    default = 2 if spec["name"] == "order" else spec["default"]
    stored = group().GetString("Option_" + spec["name"], "")
    if not stored:
        return default
    try:
        value = {"float": float, "int": int, "str": str, "bool": lambda text: text == "True"}[spec["type"]](stored)
    except ValueError:
        return default
    if spec["choices"] and value not in spec["choices"]:
        return default
    return value


def set_option_default(spec, value):
    """Store a default; one that is the program's own is forgotten, so that a later version may change it."""
    own = 2 if spec["name"] == "order" else spec["default"]
    if value == own:
        group().RemString("Option_" + spec["name"])
    else:
        group().SetString("Option_" + spec["name"], str(value))


def option_specs():
    """The options that a window shows: all but the size, which depends on the part."""
    return [spec for spec in mesh_object.options_shown() if spec["name"] != "size"]
