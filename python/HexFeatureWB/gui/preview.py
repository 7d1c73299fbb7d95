# HexFeatureWB - LGPL-2.1-or-later
"""What will come, drawn on the part while the user chooses: labels as colours, feature lines. Computed in a worker thread."""
import numpy as np
from PySide import QtCore

import FreeCADGui

from ..job import Job
from ..models import AXIS_COLOURS, LABEL_COLOURS
from . import messages, scene

POLL, PATIENCE = 10, 250  #: ms: looking for the result; waiting for the user to end turning a knob

PAINTING = 20  #: ms after which the 3D view has begun to paint what is new

MESH = 0  #: stands for the mesh, or for marks, where others have the number of a solid
MARK_COLOUR = (0.9, 0.1, 0.1)
MESH_COLOUR = (1.0, 0.7, 0.0)  #: as FreeCAD's own meshes


def reading_job(brep, size):
    """A worker that only reads the part; any size that fits it will do."""
    return Job(brep, {"size": size, "stop_after": "read"}, wants_looks=True)


class Shown:
    """Labels and feature lines of one solid."""

    def __init__(self, look):
        self.look = look
        result, self.final = look
        self.stage = result.stage("shape")
        self.stage["label"] = result.stage("labels")["label"]

    def nodes(self, lines, labels):
        points = np.asarray(self.stage["points"])
        if labels:
            yield scene.patches(points, np.asarray(self.stage["triangles"]), np.asarray(self.stage["label"]), LABEL_COLOURS)
        if lines:
            axis = [a if 0 <= a < 3 else 3 for a in self.stage["arc_axis"]]
            dark = [tuple(0.55 * c for c in colour) for colour in AXIS_COLOURS] + [(0.1, 0.1, 0.1)]
            yield scene.lines(*scene.compact_lines(points, self.stage["arcs"]), 4.0, axis, dark)


class Preview(QtCore.QObject):
    """Draws on the active 3D view of a document; `remove()` takes everything away again.

    `parent`, a widget, ends it when it dies.

    said(text): called with a line for the user about what is shown; ready(job): called when something is drawn or failed. Each solid is
    drawn as soon as it has labels, and again when they are final, which may take seconds where they have to be repaired.
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
        self.solids = {}  #: number of a solid -> Shown
        self._groups = {}  # number of a solid, or MESH -> its node
        self.seconds, self.final = None, False
        self.failed = False  #: whether the last computation ended with an error
        self._wait, self._poll = QtCore.QTimer(self), QtCore.QTimer(self)
        self._wait.setSingleShot(True)
        self._wait.timeout.connect(self._start)
        self._poll.timeout.connect(self._look)
        self.lines, self.labels = True, True

    def show(self, brep, options, reading=None):
        """Compute for these options, at once or, while a knob is being turned, when it has come to rest; an older computation is given
        up. reading: a worker that reads this part at the moment, to be waited for."""
        turning = self.busy
        self.pause()
        self._next = Job(brep, dict(options, stop_after="shape"), wants_looks=True, after=reading)
        self._wait.start(PATIENCE if turning else 0)

    def show_mesh(self, points, quads):
        """Draw the surface of a mesh instead, until the next show() or clear(): FreeCAD takes seconds to make its own picture."""
        self.clear()
        if self._graph:
            points, quads = scene.compact(points, quads)
            group = self._group(MESH)
            group.addChild(scene.faces(points, quads, np.zeros(len(quads), dtype=int), [MESH_COLOUR]))
            group.addChild(scene.lines(points, scene.sides(quads), 1.0))

    def mark(self, faces):
        """Draw the borders of CAD faces instead, through the part too: they may be on its back."""
        self.clear()
        borders = [edge.discretize(24) for face in faces for edge in face.Edges if not edge.Degenerated]
        if self._graph and borders:
            points = np.array([tuple(point) for border in borders for point in border])
            ends = np.cumsum([len(border) for border in borders])
            polylines = [list(range(end - len(border), end)) for border, end in zip(borders, ends)]
            self._group(MESH).addChild(scene.in_front(scene.lines(points, polylines, 3.0, None, [MARK_COLOUR])))

    def remove(self):
        """Take away what is drawn and give up what is computed."""
        self.pause()
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
        self._forget()

    def _forget(self):
        self.solids, self._groups = {}, {}
        while self._root.getNumChildren() > 1:
            self._root.removeChild(1)

    @property
    def busy(self):
        return self._wait.isActive() or self._job is not None

    @property
    def stages(self):
        """The stage "shape", with the labels, of each solid that is drawn."""
        return [self.solids[solid].stage for solid in sorted(self.solids)]

    def set_parts(self, lines, labels):
        self.lines, self.labels = lines, labels
        for solid in self.solids:
            self._draw(solid)

    def _start(self):
        self._job = self._next.start()
        self.failed = False
        self._poll.start(POLL)

    def _look(self):
        job = self._job
        if job is None:
            return
        alive = job.is_alive()
        looks = {solid: look for solid, look in list(job.looks.items()) if solid not in self.solids or self.solids[solid].look is not look}
        if not alive:
            self._poll.stop()
            self._job = None
        for solid, look in looks.items():
            self.solids[solid] = Shown(look)
            self._draw(solid)
        if alive and not looks:
            return
        if not alive:  # what is drawn of an earlier run stays until there is something in its place
            self.failed = job.error is not None
            for solid in list(self.solids):
                if solid not in job.looks or self.failed and not self.solids[solid].final:
                    self._take_away(solid)
            if not self.solids:
                self._forget()
        self.seconds, self.final = job.seconds, not alive
        if self.failed:
            self._said(messages.in_words(getattr(job.error, "reason", str(job.error))))
        self._ready(job)
        if looks and alive:
            QtCore.QTimer.singleShot(PAINTING, job.seen.set)

    def _take_away(self, solid):
        self.solids.pop(solid, None)
        group = self._groups.pop(solid, None)
        if group is not None:
            self._root.removeChild(group)

    def _group(self, solid):
        if solid not in self._groups:
            self._groups[solid] = scene.group()
            self._root.addChild(self._groups[solid])
        return self._groups[solid]

    def _draw(self, solid):
        if not self._graph:
            return
        self._take_away(MESH)
        group = self._group(solid)
        group.removeAllChildren()
        for node in self.solids[solid].nodes(self.lines, self.labels):
            group.addChild(node)
