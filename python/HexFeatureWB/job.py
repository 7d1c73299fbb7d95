# HexFeatureWB - LGPL-2.1-or-later
"""Meshing in a thread of its own: started, asked how far it is, cancelled. Knows neither document nor window."""
import threading
import time

from . import core


SIGHT = 0.15  #: s that a first look is given to get on the screen


class Job(threading.Thread):
    """One run of the core on a B-rep text; the interpreter is free meanwhile.

    After `is_alive()` has become False exactly one of these is set: `result` (hexfeature._core.Result) or
    `error` (MeshingError, whose kind is "cancelled" after `cancel()`; or another exception: a bug).
    """

    def __init__(self, brep, options, wants_looks=False, after=None):
        super().__init__(name="HexFeatureWB", daemon=True)
        self.brep, self.options = brep, dict(options)
        #: a Job that is waited for, if it reads the same part: it leaves that with the core
        self._after = after if after is not None and after.brep == brep else None
        self.result = self.error = None
        self._wants_looks = wants_looks
        #: if wanted: number of a solid -> (Result with the stages labels and shape, whether they are final), the newest; grows
        self.looks = {}
        self.seen = threading.Event()  #: to be set when a look that is not final is on the screen
        self.step, self.fraction = "", 0.0
        self.lines = []  #: of the log, in order; other threads may read it while it grows
        self.started_at = self.ended_at = None
        self._cancelled = threading.Event()

    def start(self):
        self.started_at = time.monotonic()
        super().start()
        return self

    def run(self):
        after, self._after = self._after, None
        try:
            while after is not None and after.is_alive() and not self.was_cancelled:
                after.join(0.01)
            self.result = core.load().mesh_brep(
                self.brep, self.options, self._progress, self._log, self._cancelled.is_set,
                self._take_look if self._wants_looks else None
            )
        except BaseException as error:  # handed to whoever started the job
            self.error = error
        self.ended_at = time.monotonic()

    def cancel(self):
        """Ask it to stop; it ends within 0.2 s."""
        self._cancelled.set()
        self.seen.set()

    @property
    def was_cancelled(self):
        return self._cancelled.is_set()

    @property
    def seconds(self):
        """Since the start, or from start to end."""
        return (self.ended_at or time.monotonic()) - self.started_at if self.started_at else 0.0

    def _progress(self, step, fraction):
        if step != self.step:
            self.lines.append("%6.2f s  %s" % (self.seconds, step))
        self.step, self.fraction = step, fraction

    def _take_look(self, result, solid, final):
        self.seen.clear()
        self.looks[solid] = result, final
        if not final:  # drawing needs the processors that the core's threads would take
            self.seen.wait(SIGHT)

    def _log(self, line):
        self.lines.append("%6.2f s  %s" % (self.seconds, line))
