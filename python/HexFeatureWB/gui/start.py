# HexFeatureWB - LGPL-2.1-or-later
"""What happens once when FreeCAD starts with its window: translations, preferences page, our commands in the FEM workbench."""
import os

import FreeCADGui

from ..translate import tr
from ..view_provider import ICONS

TRANSLATIONS = os.path.join(os.path.dirname(ICONS), "translations")


def icon(name):
    return os.path.join(ICONS, name + ".svg")


def titles():
    """The workbench's name and tooltip."""
    return tr("Hex mesh"), tr("All-hexahedral meshes of CAD solids")


def start():
    from PySide import QtCore

    from . import fem_menu, parts_shown, preferences

    FreeCADGui.addLanguagePath(TRANSLATIONS)
    FreeCADGui.updateLocale()
    FreeCADGui.addIconPath(ICONS)
    FreeCADGui.addPreferencePage(preferences.PreferencesPage, "FEM")
    parts_shown.watch()
    QtCore.QTimer.singleShot(0, fem_menu.install)
