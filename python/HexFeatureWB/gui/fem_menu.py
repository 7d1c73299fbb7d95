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

#: command -> an action of ours. Kept here: clearing a toolbar or menu gives actions back to Python, which would forget them.
_ours = {}


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
    bar = bar or _make(window)
    _fill(window, bar, _menu(window))
    _put_in_place(window.menuBar(), _menu(window))
    _speak(bar, _menu(window))
    bar.show()


def _make(window):
    """The toolbar, with an action of ours for each command, and the menu."""
    bar = window.addToolBar("")
    bar.setObjectName(NAME)
    for name in commands.register():
        _ours[name] = _action(name, bar)
    update = QtCore.QTimer(bar)
    update.timeout.connect(lambda: bar.isVisible() and _enable())
    update.start(UPDATE)
    menu = QtGui.QMenu(window.menuBar())
    menu.setObjectName(NAME)
    menu.aboutToShow.connect(_enable)
    return bar


def _menu(window):
    return window.menuBar().findChild(QtGui.QMenu, NAME)


def _action(name, bar):
    """A command as an action."""
    action = QtGui.QAction(messages.qicon(commands.COMMANDS[name].icon), "", bar)
    action.setObjectName(NAME + "_" + name)
    action.triggered.connect(lambda *_: FreeCADGui.runCommand(name, 0))
    return action


def _fill(window, bar, menu):
    """Put the actions into toolbar and menu: FreeCAD's own, which it makes when our workbench is visited first, until then ours.

    Never both: the same keys on two actions do nothing, and in FreeCAD 1.1 keys of an action that is nowhere seen do nothing.
    A user's own keys (Tools > Customize) go before ours.
    """
    bar.clear()
    menu.clear()
    for name, ours in _ours.items():
        freecads = window.findChild(QtGui.QAction, name)
        keys = FreeCAD.ParamGet(SHORTCUTS).GetString(name, commands.COMMANDS[name].keys)
        ours.setShortcut("" if freecads is not None else keys)
        for holder in (bar, menu):
            holder.addAction(ours if freecads is None else freecads)


def _put_in_place(menus, menu):
    """Before Windows and Help, where a workbench's own menus stand. FreeCAD has hidden and moved ours when it built its own."""
    menus.removeAction(menu.menuAction())
    before = next((a for a in menus.actions() if a.objectName() in ("&Windows", "&Help")), None)
    menus.insertMenu(before, menu) if before is not None else menus.addMenu(menu)
    menu.menuAction().setVisible(True)


def _speak(bar, menu):
    """All texts in FreeCAD's language of the moment."""
    title = tr("Hex mesh")
    bar.setWindowTitle(title)
    menu.setTitle(title)
    # When the language changes FreeCAD gives a menu the text of its data. One with the data of our own workbench's menu would be
    # taken for that.
    menu.menuAction().setData(title + " ")
    for name, action in _ours.items():
        info = commands.COMMANDS[name]().GetResources()
        action.setText(info["MenuText"])
        action.setToolTip("<b>%s</b><br>%s" % (info["MenuText"], info["ToolTip"]))


def _enable():
    for name, action in _ours.items():
        action.setEnabled(FreeCADGui.isCommandActive(name))
