# HexFeatureWB - LGPL-2.1-or-later
"""One run of a panel: the core in a worker thread, then FreeCAD's mesh built in slices between the window's events."""
import time

from PySide import QtCore

from .. import meshing
from ..fem_mesh import FemMeshBuilder
from ..job import Job

POLL = 50  #: ms between two looks at the worker
POLL_CANCELLED = 5  #: ms, once it has been cancelled
PATIENCE = 0.1  #: s that a cancelled worker is waited for; a later one is left to end by itself
SLICE = 0.1  #: s of building between two looks at the window
BUILDING = "build"  #: the step's name


class Run(QtCore.QObject):
    """Starts a Job, looks at it, ends with what `meshing.mesh` and `refresh` take over without delay.

    parent: a widget; the run ends when it dies. looked(job): called while it goes on. ended(job, error): called once, with `self.job`
    None again; error: None when `job.result` is there.
    """

    def __init__(self, parent, looked, ended):
        super().__init__(parent)
        self._looked, self._ended = looked, ended
        self.job = self._builder = None
        self._timer = QtCore.QTimer(self)
        self._timer.timeout.connect(self._look)
        self.destroyed.connect(lambda *_: self.job and self.job.cancel())

    def start(self, brep, options):
        self._builder = None
        self.job = Job(brep, options).start()
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
        self.job = self._builder = None

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
        self.job, builder, self._builder = None, self._builder, None
        error = meshing.cancelled_error(job.step) if job.was_cancelled else job.error
        if error is None:
            meshing.offer(job.brep, job.options, job.result, builder)
        self._ended(job, error)

    def _built(self, job):
        """Go on building. True when that is over, by an error too."""
        try:
            if self._builder is None:
                job.step, job.fraction = BUILDING, 0.0
                self._builder = FemMeshBuilder(job.result)
                self._timer.start(0)
            done = self._builder.work(SLICE)
        except Exception as error:  # memory that is short, whatever SMESH raises
            job.result, job.error = None, meshing.building_error(BUILDING, error)
            return True
        job.fraction = self._builder.fraction
        return done
