# HexFeatureWB - LGPL-2.1-or-later
"""For tests inside a FreeCAD with a window: let it live, wait, press, take pictures."""
import ctypes
import os
import time

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

OUT = os.environ.get("HEXFEATURE_GUI_OUT", "")
SIZE = 1360, 840


def prepare_window():
    """A window of a known size, with a task panel wide enough for every version's widgets."""
    window = FreeCADGui.getMainWindow()
    for dock in window.findChildren(QtGui.QDockWidget):
        if dock.objectName() in ("Python console", "Report view"):
            dock.hide()
    window.showNormal()
    window.setGeometry(0, 0, *SIZE)
    live(0.3)
    docks = [d for d in window.findChildren(QtGui.QDockWidget) if d.isVisible()]
    docks = [d for d in docks if window.dockWidgetArea(d) == QtCore.Qt.LeftDockWidgetArea]
    window.resizeDocks(docks, [330] * len(docks), QtCore.Qt.Horizontal)
    live(0.2)


def say(text):
    """A line for whoever runs the tests, past FreeCAD's own output window."""
    os.write(1, (text + "\n").encode())


def live(seconds=0.05):
    """Let FreeCAD handle its events for so long."""
    end = time.monotonic() + seconds
    while True:
        QtGui.QApplication.processEvents()
        if time.monotonic() >= end:
            return
        time.sleep(0.005)


def wait_until(condition, seconds=120):
    """Let FreeCAD live until the condition holds; returns the seconds waited. Raises TimeoutError."""
    start = time.monotonic()
    while not condition():
        if time.monotonic() - start > seconds:
            raise TimeoutError("waited %d s in vain" % seconds)
        live(0.01)
    return time.monotonic() - start


def picture(name, widget=None):
    """The window (or one widget) as it is on the screen, to OUT/name.png, when pictures are wanted."""
    if not OUT:
        return
    live(0.4)
    window = widget or FreeCADGui.getMainWindow()
    corner = window.mapToGlobal(QtCore.QPoint(0, 0))
    screen = QtGui.QApplication.primaryScreen()
    image = screen.grabWindow(0, corner.x(), corner.y(), window.width(), window.height())
    os.makedirs(OUT, exist_ok=True)
    if not image.save(os.path.join(OUT, name + ".png")):
        raise OSError("cannot write the picture " + name)


def child(parent, name, kind=None):
    """A widget by its object name. Raises LookupError."""
    found = parent.findChild(kind or QtGui.QWidget, name)
    if found is None:
        raise LookupError("there is no " + name)
    return found


def action(menu_text):
    """An action of the main window by its text, enabled or not. Raises LookupError."""
    for candidate in FreeCADGui.getMainWindow().findChildren(QtGui.QAction):
        if candidate.text().replace("&", "") == menu_text and not candidate.menu():
            return candidate
    raise LookupError("there is no menu entry " + menu_text)


def press_ok():
    """The OK button of the open task. Raises LookupError."""
    for box in FreeCADGui.getMainWindow().findChildren(QtGui.QDialogButtonBox):
        button = box.button(QtGui.QDialogButtonBox.Ok)
        if button is not None and button.isVisible():
            button.click()
            return
    raise LookupError("there is no OK")


def press_keys(*names, focus=True):
    """Press keys ("H", "Return", "Control_L+Return") on the screen's keyboard, by X's XTEST extension. Raises OSError where its
    library is missing."""
    x11, xtest = ctypes.CDLL("libX11.so.6"), ctypes.CDLL("libXtst.so.6")
    x11.XOpenDisplay.restype = ctypes.c_void_p
    x11.XStringToKeysym.restype = ctypes.c_ulong
    display = ctypes.c_void_p(x11.XOpenDisplay(None))
    window = FreeCADGui.getMainWindow()
    window.activateWindow()
    if focus:
        window.setFocus()
    live(0.3)
    for name in names:
        codes = [x11.XKeysymToKeycode(display, ctypes.c_ulong(x11.XStringToKeysym(key.encode()))) for key in name.split("+")]
        for down, some in ((1, codes), (0, codes[::-1])):
            for code in some:
                xtest.XTestFakeKeyEvent(display, code, down, ctypes.c_ulong(0))
        x11.XFlush(display)
        live(0.2)
    x11.XCloseDisplay(display)


def show_part(shape, name="Part"):
    """A new document with the shape as an object, seen from the side; returns both."""
    document = FreeCAD.newDocument("Test")
    document.UndoMode = 1
    part = document.addObject("Part::Feature", name)
    part.Shape = shape
    document.recompute()
    part.purgeTouched()
    look()
    return document, part


def look():
    view = FreeCADGui.ActiveDocument.ActiveView
    view.viewIsometric()
    view.fitAll()
    live(0.1)


def colours_of_view():
    """How many pixels of the 3D view are clearly red, orange to yellow, and blue as the quality colours are."""
    import tempfile

    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "view.png")
        FreeCADGui.ActiveDocument.ActiveView.saveImage(path, 300, 200, "White")
        image = QtGui.QImage(path)
    counts = {"blue": 0, "other": 0, "white": 0}
    for x in range(0, image.width(), 2):
        for y in range(0, image.height(), 2):
            colour = QtGui.QColor(image.pixel(x, y))
            r, g, b = colour.red(), colour.green(), colour.blue()
            counts["white" if min(r, g, b) > 245 else "blue" if b > r + 40 else "other"] += 1
    return counts
