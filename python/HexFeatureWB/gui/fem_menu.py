# HexFeatureWB - LGPL-2.1-or-later
"""Our commands while FreeCAD's FEM workbench is active: a menu and a toolbar of their own, in every version since 0.20.

FreeCAD rebuilds menus and toolbars when a workbench is activated and says so by a signal; ours are added after that.
"""
import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from ..translate import tr
from . import commands, messages, settings

FEM = "FemWorkbench"
NAME = "HexFeature_InFem"
SHORTCUTS = "User parameter:BaseApp/Preferences/Shortcut"  #: where FreeCAD keeps the user's own keys, by command
UPDATE = 400  #: ms between two looks at which commands can be used


def install():
    """Listen to the main window. Called once, when FreeCAD starts."""
    FreeCADGui.getMainWindow().workbenchActivated.connect(_activated)
    try:
        _activated(FreeCADGui.activeWorkbench().name())
    except AssertionError:  # there is none yet
        pass


def _activated(workbench):
    window = FreeCADGui.getMainWindow()
    wanted = workbench == FEM and settings.switch("InFemWorkbench")
    bar = window.findChild(QtGui.QToolBar, NAME)
    if not wanted:
        if bar is not None:
            bar.hide()
        return
    if bar is None:
        bar = window.addToolBar(tr("Hex mesh"))
        bar.setObjectName(NAME)
        bar.addActions([_action(name, bar) for name in commands.register()])
        update = QtCore.QTimer(bar)
        update.timeout.connect(lambda: bar.isVisible() and _enable(bar.actions()))
        update.start(UPDATE)
    _share_keys(window, bar)
    bar.show()
    menus = window.menuBar()
    if menus.findChild(QtGui.QMenu, NAME) is None:
        menu = QtGui.QMenu(tr("Hex mesh"), menus)
        menu.setObjectName(NAME)
        menu.addActions(bar.actions())
        menu.aboutToShow.connect(lambda: _enable(bar.actions()))
        # before Windows and Help, where a workbench's own menus stand
        last = [a for a in menus.actions() if a.isVisible()][-2:]
        menus.insertMenu(last[0], menu) if len(last) == 2 else menus.addMenu(menu)


def _action(name, parent):
    """A command as an action. FreeCAD makes its own action of a command only for the workbench that lists it."""
    info = commands.COMMANDS[name]().GetResources()
    action = QtGui.QAction(messages.qicon(commands.COMMANDS[name].icon), info["MenuText"], parent)
    action.setObjectName(NAME + "_" + name)
    action.setToolTip("<b>%s</b><br>%s" % (info["MenuText"], info["ToolTip"]))
    action.triggered.connect(lambda *_: FreeCADGui.runCommand(name, 0))
    return action


def _share_keys(window, bar):
    """Our actions have the commands' keys until FreeCAD has actions of its own for them, once our workbench has been visited: the
    same keys on two actions would do nothing. A user's own keys (Tools > Customize) go before ours."""
    for action in bar.actions():
        name = action.objectName()[len(NAME) + 1:]
        freecads = window.findChild(QtGui.QAction, name)
        keys = FreeCAD.ParamGet(SHORTCUTS).GetString(name, commands.COMMANDS[name].keys)
        action.setShortcut("" if freecads is not None else keys)


def _enable(actions):
    for action in actions:
        action.setEnabled(FreeCADGui.isCommandActive(action.objectName()[len(NAME) + 1:]))
