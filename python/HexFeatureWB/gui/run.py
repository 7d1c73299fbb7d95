# HexFeatureWB - LGPL-2.1-or-later
"""One run of a panel: the core in a worker thread, then, in slices between the window's events, FreeCAD's mesh built and groups checked."""
import time

from PySide import QtCore

from .. import meshing
from ..fem_mesh import FemMeshBuilder
from ..group_check import GroupCheck
from ..job import Job
from ..source import brep_of, names_of, shape_to_mesh

POLL = 50  #: ms between two looks at the worker
POLL_CANCELLED = 5  #: ms, once it has been cancelled
PATIENCE = 0.1  #: s that a cancelled worker is waited for; a later one is left to end by itself
SLICE = 0.1  #: s of building or checking between two looks at the window
BUILDING, CHECKING = "build", "groups"  #: the steps' names


class Run(QtCore.QObject):
    """Starts a Job, looks at it, ends with what `meshing.mesh` and `refresh` take over without delay.

    parent: a widget; the run ends when it dies. looked(job): called while it goes on. ended(job, error): called once, with `self.job`
    None again; error: None when `job.result` is there.
    """

    def __init__(self, parent, looked, ended):
        super().__init__(parent)
        self._looked, self._ended = looked, ended
        self.job = self._builder = self._check = None
        self._timer = QtCore.QTimer(self)
        self._timer.timeout.connect(self._look)
        self.destroyed.connect(lambda *_: self.job and self.job.cancel())

    def start(self, source, solid, options, reading=None):
        """Mesh a document object's solid. Raises MeshingError when it has none. reading: a worker that reads the part at the moment."""
        self._shape = shape_to_mesh(source, solid)
        self._names = names_of(source, self._shape)
        self._builder = self._check = None
        self.job = Job(brep_of(self._shape), options, after=reading).start()
        self._timer.start(POLL)

    def cancel(self):
        """Ask it to end; `ended` is called within PATIENCE."""
        if self.job is not None and not self.job.was_cancelled:
            self.job.cancel()
            self._give_up_at = time.monotonic() + PATIENCE
            self._timer.setInterval(POLL_CANCELLED)

    def give_up(self):
        """End at once, `ended` is not called; the worker stops by itself."""
        self._timer.stop()
        self.cancel()
        self.job = self._builder = self._check = None

    def _look(self):
        job = self.job
        if job is None:
            return
        alive = job.is_alive()
        if job.was_cancelled:
            if alive and time.monotonic() < self._give_up_at:
                return
        elif alive or job.error is None and not self._built(job):
            self._looked(job)
            return
        self._timer.stop()
        builder, check = self._builder, self._check
        self.job = self._builder = self._check = None
        error = meshing.cancelled_error(job.step) if job.was_cancelled else job.error
        if error is None:
            meshing.offer(job.brep, job.options, job.result, builder, check)
        self._ended(job, error)

    def _built(self, job):
        """Go on building, then checking. True when that is over, by an error too."""
        try:
            if self._builder is None:
                job.step, job.fraction = BUILDING, 0.0
                self._builder = FemMeshBuilder(job.result, self._names)
                self._timer.start(0)
            if self._check is None and self._builder.work(SLICE):
                job.step = CHECKING
                self._check = GroupCheck(job.result, self._shape)
                return False
            work = self._check or self._builder
            done = self._check is not None and self._check.work(SLICE)
        except Exception as error:  # memory that is short, whatever SMESH raises
            job.result, job.error = None, meshing.building_error(job.step, error)
            return True
        job.fraction = work.fraction
        return done
