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
            _menu(window).menuAction().setVisible(False)
        return
    if bar is None:
        bar = window.addToolBar("")
        bar.setObjectName(NAME)
        bar.addActions([_action(name, bar) for name in commands.register()])
        update = QtCore.QTimer(bar)
        update.timeout.connect(lambda: bar.isVisible() and _enable(bar.actions()))
        update.start(UPDATE)
    _share_keys(window, bar)
    bar.show()
    menu = _menu(window)
    if menu is None:
        menu = QtGui.QMenu(window.menuBar())
        menu.setObjectName(NAME)
        menu.addActions(bar.actions())
        menu.aboutToShow.connect(lambda: _enable(bar.actions()))
    _put_in_place(window.menuBar(), menu)
    _speak(bar, menu)


def _menu(window):
    return window.menuBar().findChild(QtGui.QMenu, NAME)


def _put_in_place(menus, menu):
    """Before Windows and Help, where a workbench's own menus stand. FreeCAD has hidden and moved ours when it built its own."""
    menus.removeAction(menu.menuAction())
    before = next((a for a in menus.actions() if a.objectName() in ("&Windows", "&Help")), None)
    menus.insertMenu(before, menu) if before is not None else menus.addMenu(menu)
    menu.menuAction().setVisible(True)


def _action(name, parent):
    """A command as an action. FreeCAD makes its own action of a command only for the workbench that lists it."""
    action = QtGui.QAction(messages.qicon(commands.COMMANDS[name].icon), "", parent)
    action.setObjectName(NAME + "_" + name)
    action.triggered.connect(lambda *_: FreeCADGui.runCommand(name, 0))
    return action


def _speak(bar, menu):
    """All texts in FreeCAD's language of the moment."""
    title = tr("Hex mesh")
    bar.setWindowTitle(title)
    menu.setTitle(title)
    # When the language changes FreeCAD gives a menu the text of its data. One with the data of our own workbench's menu would be
    # taken for that.
    menu.menuAction().setData(title + " ")
    for action in bar.actions():
        info = commands.COMMANDS[action.objectName()[len(NAME) + 1:]]().GetResources()
        action.setText(info["MenuText"])
        action.setToolTip("<b>%s</b><br>%s" % (info["MenuText"], info["ToolTip"]))


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
