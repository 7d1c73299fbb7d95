# HexFeatureWB - LGPL-2.1-or-later
"""The command line's guard: a worker's crash, a signal and a time limit end with a typed error and leave no file."""
import os
import signal
import threading
import time

import pytest

from hexfeature import guard
from hexfeature.errors import MeshingError

pytestmark = pytest.mark.skipif(not guard.available(), reason="this system cannot fork")


def crash_in(step):
    def work(board):
        board.put(step)
        os.kill(os.getpid(), signal.SIGSEGV)
        time.sleep(10)
    return work


def test_the_exit_code_is_the_workers():
    assert guard.run(lambda board: 4) == 4


@pytest.mark.parametrize("step, kind", [("read", "bad_input"), ("smooth", "no_mesh")])
def test_a_crash_is_an_error_that_names_the_step(step, kind):
    with pytest.raises(MeshingError) as caught:
        guard.run(crash_in(step))
    assert (caught.value.kind, caught.value.step) == (kind, step)
    assert "SIGSEGV" in caught.value.reason and caught.value.hint


def test_a_worker_that_the_system_kills():
    with pytest.raises(MeshingError) as caught:
        guard.run(lambda board: os.kill(os.getpid(), signal.SIGKILL))
    assert caught.value.kind == "no_mesh" and "memory" in caught.value.reason


@pytest.mark.parametrize("how", ["time limit", "signal"])
def test_a_busy_worker_is_ended_and_its_temporary_file_removed(tmp_path, how):
    target = tmp_path / "m.vtk"

    def work(board):
        board.put("write")
        (tmp_path / f"m.{os.getpid()}.part0.vtk").write_text("half")
        (tmp_path / "other.part").write_text("not the worker's")
        while True:
            pass

    if how == "signal":
        threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGTERM)).start()
    with pytest.raises(MeshingError) as caught:
        guard.run(work, 0.5 if how == "time limit" else 0, [str(target)])
    assert (caught.value.kind, caught.value.step) == ("cancelled", "write")
    assert os.listdir(tmp_path) == ["other.part"]


def test_a_worker_that_tells_its_own_error_is_not_talked_over(capfd):
    def work(board):
        board.put("smooth")
        board.tell()
        time.sleep(0.6)
        os.write(2, b"the worker's own")
        return 130

    assert guard.run(work, time_limit=0.2) == 130
    assert capfd.readouterr().err == "the worker's own"


def test_a_signal_does_not_wait_for_a_worker_that_tells():
    def work(board):
        board.tell()
        os.kill(os.getppid(), signal.SIGINT)
        time.sleep(2)  # less than a telling worker gets at the time limit
        return 0

    with pytest.raises(MeshingError) as caught:
        guard.run(work)
    assert caught.value.kind == "cancelled"


def test_a_run_that_has_written_its_mesh_may_end(monkeypatch):
    monkeypatch.setattr(guard, "_GRACE", 2.0)

    def work(board):
        board.put(guard.WRITTEN)
        time.sleep(2.5)  # past the limit and the grace for the core
        return 0

    assert guard.run(work, 0.05) == 0
