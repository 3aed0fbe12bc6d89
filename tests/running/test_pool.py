"""The pool: every task gets one result, whatever the others do to their processes."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from collections import Counter
from collections.abc import Iterator
from itertools import count
from pathlib import Path

import chores
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tmm_report.running.pool import Lost, NotStarting, chunked, over

POSIX = pytest.mark.skipif(sys.platform == "win32", reason="signals")


def done(do, tasks, size=4, *, jobs=2, seconds=30.0, **more) -> dict:
    found = list(over(do, chunked(tasks, size), jobs=jobs, seconds=seconds, **more))
    assert len(found) == len(dict(found)), "a task has one result"
    return dict(found)


def alive(pid: int) -> bool:
    try:
        os.kill(pid, 0)
    except OSError:
        return False
    return b") Z " not in Path(f"/proc/{pid}/stat").read_bytes()


def until(condition, seconds=120.0) -> None:
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end, "it never came"
        time.sleep(0.02)


@pytest.mark.exhaustive
@pytest.mark.parametrize("jobs", [1, 3])
def test_every_task_has_its_result(jobs):
    assert done(chores.double, range(50), jobs=jobs) == {k: 2 * k for k in range(50)}


def test_results_go_by_index_not_by_order():
    assert done(chores.backwards, range(10)) == {k: 2 * k for k in range(10)}


def test_nothing_to_do_starts_no_process():
    assert done(chores.double, []) == {}


@pytest.mark.exhaustive
@pytest.mark.parametrize("how", ["die", "crash"])
def test_what_kills_its_process_is_lost_and_the_rest_goes_on(how):
    found = done(chores.obey, [1, 2, how, 3, 4, 5, 6, 7, 8])
    assert found.pop(how) == Lost("died")
    assert found == {k: 2 * k for k in range(1, 9)}


@pytest.mark.exhaustive
def test_what_hangs_is_lost_and_the_rest_goes_on():
    found = done(chores.obey, [1, "hang", 2, 3, 4], seconds=0.7)
    assert found == {1: 2, 2: 4, 3: 6, 4: 8, "hang": Lost("time")}


def test_what_raises_is_lost_with_its_trace():
    found = done(chores.obey, [1, "raise", 2, 3])
    lost = found.pop("raise")
    assert lost.reason == "error" and "ZeroDivisionError: of this task" in lost.trace
    assert found == {1: 2, 2: 4, 3: 6}


def test_what_gives_no_result_is_lost():
    found = done(chores.obey, [1, "forget", 2])
    assert found.pop("forget").reason == "error"
    assert found == {1: 2, 2: 4}


@pytest.mark.exhaustive
@POSIX
def test_what_asks_for_too_much_memory_is_lost():
    found = done(chores.obey, [1, "gorge", 2], memory=2 << 30)
    assert found == {1: 2, 2: 4, "gorge": Lost("memory")}


@pytest.mark.exhaustive
def test_a_chunk_that_dies_before_its_first_result_is_done_task_by_task():
    assert done(chores.all_or_nothing, range(20), size=20) == {k: 2 * k for k in range(20)}


def test_what_dies_once_is_done_at_the_second_try(tmp_path):
    tasks = [str(tmp_path / name) for name in ("a", "once", "b", "c")]
    found = done(chores.first_time_dies, tasks, size=6, jobs=1)
    assert {Path(task).name: result for task, result in found.items()} == {
        name: name for name in ("a", "once", "b", "c")
    }


@pytest.mark.exhaustive
@settings(max_examples=5, deadline=None)
@given(st.lists(st.sampled_from(["die", "raise", "fine"]), min_size=1, max_size=9), st.integers(1, 5))
def test_as_many_are_lost_as_are_bad(kinds, size):
    names = {"die": "die", "raise": "raise", "fine": 21}
    found = list(over(chores.obey, chunked([names[kind] for kind in kinds], size), jobs=2, seconds=30))
    told = Counter(result.reason if isinstance(result, Lost) else "fine" for _, result in found)
    right = Counter({"die": "died", "raise": "error", "fine": "fine"}[kind] for kind in kinds)
    assert told == right


def test_chunks_are_taken_as_they_are_needed():
    taken = []

    def chunks() -> Iterator[list[int]]:
        for k in count():
            taken.append(k)
            yield [k]

    running = over(chores.double, chunks(), jobs=2, seconds=30)
    assert len({next(running)[0] for _ in range(10)}) == 10
    running.close()
    assert len(taken) <= 10 + 4


@pytest.mark.exhaustive
def test_work_is_shared_between_processes():
    found = done(chores.process, range(100), size=1)
    assert len(set(found.values())) == 2 and os.getpid() not in found.values()


def test_linear_algebra_is_told_to_use_one_thread_and_the_parent_is_not():
    before = dict(os.environ)
    assert done(chores.settings, ["OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"]) == {
        "OMP_NUM_THREADS": "1",
        "OPENBLAS_NUM_THREADS": "1",
    }
    assert dict(os.environ) == before


@pytest.mark.exhaustive
def test_processes_that_never_start_are_told(monkeypatch):
    monkeypatch.setenv("CHORES_ARE_STILLBORN", "1")
    with pytest.raises(NotStarting):
        done(chores.stillborn, range(3))


def test_a_slow_reader_is_not_taken_for_a_hanging_task():
    found = {}
    for task, result in over(chores.double, chunked(range(8), 2), jobs=2, seconds=0.5):
        found[task] = result
        time.sleep(0.3)
    assert found == {k: 2 * k for k in range(8)}


@POSIX
def test_closing_stops_the_processes_at_once(tmp_path):
    running = over(chores.busy_after_one, [["fast", str(tmp_path / "pid")]], jobs=1, seconds=60)
    assert next(running) == ("fast", "fast")
    until((tmp_path / "pid").exists)
    until((tmp_path / "pid").read_text)
    pid = int((tmp_path / "pid").read_text())
    assert alive(pid)
    running.close()
    assert not alive(pid)


PARENT = """
import sys
sys.path.insert(0, sys.argv[1])
import chores
from tmm_report.running.pool import over
if __name__ == "__main__":
    for _ in over(chores.busy, [[path] for path in sys.argv[2:]], jobs=2, seconds=600):
        pass
"""


@POSIX
@pytest.mark.parametrize("how", [signal.SIGKILL, signal.SIGINT, signal.SIGTERM])
def test_processes_end_with_their_parent_while_they_are_busy(tmp_path, how):
    script = tmp_path / "parent.py"
    script.write_text(PARENT)
    marks = [tmp_path / "one", tmp_path / "two"]
    parent = subprocess.Popen(
        [sys.executable, str(script), str(Path(chores.__file__).parent), *map(str, marks)],
        stderr=subprocess.PIPE,
    )
    until(lambda: all(mark.exists() and mark.read_text() for mark in marks))
    workers = [int(mark.read_text()) for mark in marks]
    assert all(map(alive, workers))
    parent.send_signal(how)
    assert parent.wait(120) != 0
    until(lambda: not any(map(alive, workers)))


@POSIX
def test_ctrl_c_of_the_whole_terminal_is_the_parents(tmp_path):
    """The terminal sends it to every process of the group; the workers say nothing of it."""
    script = tmp_path / "parent.py"
    script.write_text(PARENT)
    mark = tmp_path / "one"
    parent = subprocess.Popen(
        [sys.executable, str(script), str(Path(chores.__file__).parent), str(mark)],
        stderr=subprocess.PIPE,
        start_new_session=True,
    )
    until(lambda: mark.exists() and mark.read_text())
    os.killpg(parent.pid, signal.SIGINT)
    said = parent.communicate(timeout=120)[1].decode()
    assert said.count("Traceback") == 1 and said.rstrip().endswith("KeyboardInterrupt")
    until(lambda: not alive(int(mark.read_text())))
