"""The cluster: a process of it may be killed at any time, and every task has its result."""

from __future__ import annotations

import os
import signal
import socket
import sys
from functools import partial

import chores
import pytest

from tmm_report.problems import ProblemError
from tmm_report.running import cluster
from tmm_report.running.pool import Lost, chunked

distributed = pytest.importorskip("distributed")
POSIX = pytest.mark.skipif(sys.platform == "win32", reason="signals")


@pytest.fixture(scope="module")
def scheduler():
    """Two processes on this machine, each with a nanny that starts it again."""
    paths = os.pathsep.join(sys.path)
    before, os.environ["PYTHONPATH"] = os.environ.get("PYTHONPATH"), paths
    local = partial(
        distributed.LocalCluster, n_workers=2, threads_per_worker=1, processes=True, dashboard_address=":0"
    )
    with cluster.started(local) as local:
        if before is None:
            del os.environ["PYTHONPATH"]
        else:
            os.environ["PYTHONPATH"] = before
        yield local


@pytest.mark.exhaustive
def test_a_killed_process_loses_nothing(scheduler):
    """One of the cluster's own processes, in the middle of its work."""
    running = cluster.over(
        chores.process, chunked(range(200), 5), address=scheduler.scheduler_address, seconds=60
    )
    found = dict([next(running)])
    victim = next(iter(scheduler.scheduler_info["workers"].values()))["id"]
    pid = scheduler.workers[victim].pid
    os.kill(pid, signal.SIGKILL if sys.platform != "win32" else signal.SIGTERM)
    found |= dict(running)
    assert found.keys() == set(range(200))
    assert not {pid, os.getpid()} & set(found.values()), "each works in a process beside it"


@pytest.mark.exhaustive
def test_results_are_those_of_the_tasks(scheduler):
    found = dict(
        cluster.over(chores.backwards, chunked(range(50), 7), address=scheduler.scheduler_address, seconds=60)
    )
    assert found == {k: 2 * k for k in range(50)}


@pytest.mark.exhaustive
def test_what_raises_is_lost_with_its_trace_and_the_rest_goes_on(scheduler):
    tasks = [1, "raise", 2, 3]
    found = dict(
        cluster.over(chores.obey, chunked(tasks, 4), address=scheduler.scheduler_address, seconds=60)
    )
    lost = found.pop("raise")
    assert lost.reason == "error" and "of this task" in lost.trace
    assert found == {1: 2, 2: 4, 3: 6}


@POSIX
@pytest.mark.exhaustive
def test_what_kills_its_process_is_lost_and_the_rest_goes_on(scheduler):
    tasks = [1, "crash", 2]
    found = dict(
        cluster.over(chores.obey, chunked(tasks, 3), address=scheduler.scheduler_address, seconds=60)
    )
    assert found == {1: 2, 2: 4, "crash": Lost("died")}


@pytest.mark.exhaustive
def test_what_hangs_is_lost_and_the_rest_goes_on(scheduler):
    tasks = [1, "hang", 2]
    found = dict(
        cluster.over(chores.obey, chunked(tasks, 3), address=scheduler.scheduler_address, seconds=0.5)
    )
    assert found == {1: 2, 2: 4, "hang": Lost("time")}


@pytest.mark.exhaustive
def test_a_cluster_of_our_own_is_started_and_ended():
    found = dict(cluster.over(chores.double, chunked(range(9), 3), address="local", jobs=1, seconds=60))
    assert found == {k: 2 * k for k in range(9)}


@pytest.mark.exhaustive
def test_lists_are_taken_as_they_are_needed(scheduler, monkeypatch):
    monkeypatch.setattr(cluster, "ALIVE", 4)
    taken = []

    def chunks():
        for k in range(1000):
            taken.append(k)
            yield [k]

    running = cluster.over(chores.double, chunks(), address=scheduler.scheduler_address, seconds=60)
    for _ in range(5):
        next(running)
    assert len(taken) <= 5 + 4
    running.close()


def test_no_scheduler_is_told(monkeypatch):
    monkeypatch.setattr(cluster, "WAIT", "1s")
    with socket.socket() as taken:  # bound, but nobody listens
        taken.bind(("127.0.0.1", 0))
        address = f"tcp://127.0.0.1:{taken.getsockname()[1]}"
        with pytest.raises(ProblemError, match=f"^--cluster: no Dask scheduler at {address}: "):
            next(cluster.over(chores.double, [[1]], address=address, seconds=1))


@pytest.mark.parametrize("address", ["", "nonsense", "tcp://", "ftp://127.0.0.1:1", "tcp://127.0.0.1:port"])
def test_an_address_that_is_none_is_told(address, monkeypatch):
    monkeypatch.setattr(cluster, "WAIT", "1s")
    with pytest.raises(ProblemError, match="no Dask scheduler"):
        next(cluster.over(chores.double, [[1]], address=address, seconds=1))


def test_a_thread_of_dask_that_begins_late_is_waited_for():
    """Dask gives it ten seconds, and fails an assertion."""
    late = iter([AssertionError, AssertionError, None])

    def start() -> str:
        if (error := next(late)) is not None:
            raise error
        return "started"

    assert cluster.started(start) == "started"


def test_what_never_begins_is_told_as_a_machine_too_busy():
    def start() -> None:
        raise AssertionError

    with pytest.raises(TimeoutError, match="too busy"):
        cluster.started(start)


@pytest.mark.exhaustive
def test_without_dask_its_installation_is_told(monkeypatch):
    monkeypatch.setattr(cluster, "find_spec", lambda name: None)
    with pytest.raises(ProblemError, match="Dask is not installed; pip install"):
        next(cluster.over(chores.double, [[1]], address="local", seconds=1))
