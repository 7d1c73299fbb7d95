# HexFeatureWB - LGPL-2.1-or-later
"""What will come, drawn on the part while the user chooses: labels as colours, feature lines. Computed in a worker thread."""
import numpy as np
from PySide import QtCore

import FreeCADGui

from ..job import Job
from ..models import AXIS_COLOURS, LABEL_COLOURS
from . import messages, scene

POLL, PATIENCE = 10, 250  #: ms: looking for the result; waiting for the user to end turning a knob

MESH_COLOUR = (1.0, 0.7, 0.0)  #: as FreeCAD's own meshes


class Preview(QtCore.QObject):
    """Draws on the active 3D view of a document; `remove()` takes everything away again.

    `parent`, a widget, ends it when it dies.

    said(text): called with a line for the user about what is shown; ready(job): called when a preview is drawn or failed. Where the
    labels have to be repaired, which may take seconds, it is drawn twice: `final` is False after the first time.
    """

    def __init__(self, document, said, ready=None, parent=None):
        super().__init__(parent)
        self._said, self._ready = said, ready or (lambda job: None)
        view = FreeCADGui.getDocument(document.Name).ActiveView
        self._graph = view.getSceneGraph() if hasattr(view, "getSceneGraph") else None
        self._root = scene.unpickable()
        if self._graph:
            self._graph.addChild(self._root)
        self._job = self._next = None
        self.stage, self.seconds, self.final = None, None, False
        self._wait, self._poll = QtCore.QTimer(self), QtCore.QTimer(self)
        self._wait.setSingleShot(True)
        self._wait.timeout.connect(self._start)
        self._poll.timeout.connect(self._look)
        self.lines, self.labels = True, True

    def show(self, brep, options):
        """Compute for these options, at once or, while a knob is being turned, when it has come to rest; an older computation is given
        up."""
        turning = self.busy
        self.pause()
        self._next = brep, dict(options, stop_after="shape")
        self._wait.start(PATIENCE if turning else 0)

    def show_mesh(self, points, quads):
        """Draw the surface of a mesh instead, until the next show() or clear(): FreeCAD takes seconds to make its own picture."""
        self.clear()
        if self._graph:
            points, quads = scene.compact(points, quads)
            self._root.addChild(scene.faces(points, quads, np.zeros(len(quads), dtype=int), [MESH_COLOUR]))
            self._root.addChild(scene.lines(points, scene.sides(quads), 1.0))

    def remove(self):
        """Take away what is drawn and give up what is computed."""
        self._wait.stop()
        self._poll.stop()
        if self._job:
            self._job.cancel()
        self._job = None
        if self._graph:
            self._graph.removeChild(self._root)
        self._graph = None

    def pause(self):
        """What is drawn stays; what is computed is given up."""
        self._wait.stop()
        self._poll.stop()
        if self._job:
            self._job.cancel()
            self._job = None

    def clear(self):
        """Nothing is drawn until the next show()."""
        self.pause()
        self.stage = None
        self._wipe()

    def _wipe(self):
        while self._root.getNumChildren() > 1:
            self._root.removeChild(1)

    @property
    def busy(self):
        return self._wait.isActive() or self._job is not None

    def set_parts(self, lines, labels):
        self.lines, self.labels = lines, labels
        self._draw()

    def _start(self):
        self._job, self._first_drawn = Job(*self._next, wants_first_look=True).start(), False
        self._poll.start(POLL)

    def _look(self):
        job = self._job
        if job is None:
            return
        if job.is_alive():
            if job.first_look is not None and not self._first_drawn:
                self._first_drawn = True
                self._show_result(job.first_look, final=False)
                self._ready(job)
            return
        self._poll.stop()
        self._job = None
        if job.error is not None:
            self.stage = None
            self._draw()
            self._said(messages.in_words(getattr(job.error, "reason", str(job.error))))
        else:
            self.seconds = job.seconds
            self._show_result(job.result, final=True)
        self._ready(job)

    def _show_result(self, result, final):
        self.stage, self.final = result.stage("shape"), final
        self.stage["label"] = result.stage("labels")["label"]
        self._draw()

    def _draw(self):
        self._wipe()
        if self.stage is None or not self._graph:
            return
        points = np.asarray(self.stage["points"])
        if self.labels:
            self._root.addChild(scene.faces(points, self.stage["triangles"], self.stage["label"], LABEL_COLOURS, flat=False))
        if self.lines:
            axis = [a if 0 <= a < 3 else 3 for a in self.stage["arc_axis"]]
            dark = [tuple(0.55 * c for c in colour) for colour in AXIS_COLOURS] + [(0.1, 0.1, 0.1)]
            self._root.addChild(scene.lines(points, self.stage["arcs"], 4.0, axis, dark))
