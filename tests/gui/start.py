# HexFeatureWB - LGPL-2.1-or-later
"""Given to FreeCAD by run.sh: runs the tests when the window is there, and ends FreeCAD with their result."""
import os
import sys
import traceback

from PySide import QtCore

_HERE = os.environ["HEXFEATURE_GUI_TEST_DIR"]
for _folder in (_HERE, os.path.join(_HERE, os.pardir, "parts")):
    if _folder not in sys.path:
        sys.path.insert(0, _folder)


def _run():
    code = 1
    try:
        import FreeCAD
        import importlib

        module = importlib.import_module(os.environ.get("HEXFEATURE_GUI_MODULE", "gui_test"))
        print("FreeCAD", ".".join(FreeCAD.Version()[:3]), "Python", sys.version.split()[0], flush=True)
        code = module.run()
    except BaseException:
        traceback.print_exc()
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(code)


QtCore.QTimer.singleShot(1500, _run)
