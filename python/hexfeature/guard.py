# HexFeatureWB - LGPL-2.1-or-later
"""The command line's guard: the work runs in a process of its own, and this one only waits for it.

OpenCASCADE's readers can crash on a damaged file, cannot be interrupted everywhere, and a system short of memory kills without
asking. So the command line forks before it reads a part. Whatever becomes of the worker, its guard is still there: it answers
Ctrl-C at once and the time limit when the core has not, removes what was half written, and turns a crash into an error that names the step.
A program that imports the package has no such guard: there the core's own checks have to do.

HEXFEATURE_GUARD=0 runs the work in this process, for debuggers.
"""
import mmap
import os
import signal
import sys
import time

from hexfeature.errors import EXIT_CODES, make_error

_STOP = {signal.SIGINT, signal.SIGTERM} | ({signal.SIGHUP} if hasattr(signal, "SIGHUP") else set())
WRITTEN = "written"  #: the step after the mesh file has its name
_GRACE = 0.15  #: seconds for what comes after that, and for the core's own look at the time, which can say more
_GRACE_TO_TELL = 5  #: seconds for a worker that has stopped by itself and is telling its error
_PARENT_DEATH = 1  #: Linux's PR_SET_PDEATHSIG


class Board:
    """What the worker tells its guard: the step that it is in. Shared memory, for it must survive a crash."""

    _SIZE = 64

    def __init__(self):
        self._map = mmap.mmap(-1, self._SIZE + 1)

    def put(self, step):
        text = step.encode()[:self._SIZE - 1]
        self._map[:len(text) + 1] = text + b"\0"

    def tell(self):
        """The worker has stopped and tells why: its guard has nothing to add."""
        self._map[self._SIZE] = 1

    def telling(self):
        return self._map[self._SIZE] == 1

    def step(self):
        return self._map[:self._SIZE].split(b"\0", 1)[0].decode("utf-8", "replace") or "start"


def available():
    """Whether the system can fork and the user did not say no."""
    return hasattr(os, "fork") and hasattr(signal, "sigtimedwait") and os.environ.get("HEXFEATURE_GUARD") != "0"


def run(work, time_limit=0, outputs=()):
    """Run `work(board)`, which returns an exit code and tells its own errors, in a worker; returns its exit code.

    time_limit: seconds, 0 for none. outputs: paths that the worker may write; what it leaves of them under temporary names is
    removed when it is stopped or crashes. Raises MeshingError: "cancelled" for a signal or the time limit, "bad_input" for a
    crash while the part is read, "no_mesh" for one later or for a worker that the system killed.
    """
    board = Board()
    sys.stdout.flush()
    sys.stderr.flush()
    # Blocked here they are waited for; the worker ignores them, for its guard ends it.
    watched = _STOP | {signal.SIGCHLD}
    before = signal.pthread_sigmask(signal.SIG_BLOCK, watched)
    chld = signal.signal(signal.SIGCHLD, lambda *_: None)  # a signal that is ignored cannot be waited for
    try:
        guard = os.getpid()
        worker = os.fork()
        if worker == 0:
            _work(work, board, guard, before, chld)
        return _wait(worker, board, time_limit, outputs)
    finally:
        signal.signal(signal.SIGCHLD, chld)
        # A second Ctrl-C that came meanwhile has had its answer.
        for pending in signal.sigpending() & _STOP:
            signal.sigtimedwait({pending}, 0)
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _work(work, board, guard, mask, chld):
    """The worker's whole life."""
    code = 1
    try:
        for number in _STOP:
            signal.signal(number, signal.SIG_IGN)
        signal.signal(signal.SIGCHLD, chld)
        signal.pthread_sigmask(signal.SIG_SETMASK, mask)
        _die_with(guard)
        code = work(board)
        sys.stdout.flush()
        sys.stderr.flush()
    except BrokenPipeError:
        code = EXIT_CODES["output"]
    finally:
        os._exit(code)


def _die_with(guard):
    """No worker may outlive a guard that was killed."""
    try:
        import ctypes

        ctypes.CDLL(None).prctl(_PARENT_DEATH, signal.SIGKILL, 0, 0, 0)
    except (ImportError, AttributeError, OSError):
        return  # another system; the worker then ends when its work does
    if os.getppid() != guard:
        os._exit(1)


def _wait(worker, board, time_limit, outputs):
    deadline = time.monotonic() + time_limit + _GRACE if time_limit > 0 else None
    why = None
    while True:
        ended, status = os.waitpid(worker, os.WNOHANG)
        if ended:
            why = None
            break
        left = 3600 if deadline is None else deadline - time.monotonic()
        got = signal.sigtimedwait(_STOP | {signal.SIGCHLD}, max(left, 0))
        if got is None and deadline is not None and time.monotonic() >= deadline:
            why = ("time limit reached", "raise the time limit or the element size")
        elif got is not None and got.si_signo in _STOP:
            why = ("cancelled", "")
        if why:
            if board.step() == WRITTEN and _ends_within(worker, _GRACE):
                continue  # the mesh is there: let the run be what it was
            if board.telling() and _ends_within(worker, _GRACE if got else _GRACE_TO_TELL):
                continue  # it has stopped by itself: one error is enough
            os.kill(worker, signal.SIGKILL)
            os.waitpid(worker, 0)
            break
    if why is None and os.WIFEXITED(status):
        return os.WEXITSTATUS(status)
    _remove_temporaries(worker, outputs)
    if sys.stderr.isatty():
        sys.stderr.write("\r\033[K")
    step = board.step()
    if why:
        raise make_error("cancelled", step, *why)
    number = os.WTERMSIG(status)
    if number == signal.SIGKILL:
        raise make_error("no_mesh", step, "the system killed the run, probably for want of memory", "use a larger size, or a memory limit")
    name = signal.Signals(number).name
    if step in ("start", "read"):
        raise make_error("bad_input", "read", f"the file is damaged: its reader crashed ({name})",
                         "export the part again, or repair it with the program that made it")
    raise make_error("no_mesh", step, f"internal error: the step crashed ({name})", "try another size, and report it with the part")


def _ends_within(worker, seconds):
    """Whether the worker has ended by itself by then; it is not yet waited for."""
    until = time.monotonic() + seconds
    while time.monotonic() < until:
        if os.waitid(os.P_PID, worker, os.WEXITED | os.WNOHANG | os.WNOWAIT):
            return True
        time.sleep(0.002)
    return False


def _remove_temporaries(worker, outputs):
    """Temporary files are named STEM.PID.part... and lie in their file's folder."""
    for path in outputs:
        path = os.path.realpath(path)
        folder, name = os.path.split(path)
        start = f"{os.path.splitext(name)[0]}.{worker}.part"
        try:
            for entry in os.listdir(folder):
                if entry.startswith(start):
                    os.remove(os.path.join(folder, entry))
        except OSError:
            continue
