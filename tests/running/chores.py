"""Work for the pool's tests, importable by the processes that do it."""

from __future__ import annotations

import os
import signal
import sys
import time
from collections.abc import Iterator, Sequence
from pathlib import Path


def double(tasks: Sequence[int]) -> Iterator[tuple[int, int]]:
    for index, task in enumerate(tasks):
        yield index, 2 * task


def backwards(tasks: Sequence[int]) -> Iterator[tuple[int, int]]:
    for index in reversed(range(len(tasks))):
        yield index, 2 * tasks[index]


def obey(tasks: Sequence[object]) -> Iterator[tuple[int, object]]:
    """Tasks that say what is to go wrong; numbers are doubled."""
    for index, task in enumerate(tasks):
        if task == "die":
            os._exit(3)
        if task == "crash":
            os.kill(os.getpid(), signal.SIGKILL if sys.platform != "win32" else signal.SIGTERM)
        if task == "hang":
            time.sleep(3600)
        if task == "raise":
            raise ZeroDivisionError("of this task")
        if task == "gorge":
            bytearray(1 << 40)
        if task != "forget":
            yield index, task * 2


def first_time_dies(tasks: Sequence[str]) -> Iterator[tuple[int, str]]:
    """Dies in the middle of a list the first time only: the file that a task names is there the next time."""
    for index, task in enumerate(tasks):
        mark = Path(task)
        if mark.name.startswith("once") and not mark.exists():
            mark.touch()
            os._exit(1)
        yield index, mark.name


def settings(tasks: Sequence[str]) -> Iterator[tuple[int, str | None]]:
    for index, task in enumerate(tasks):
        yield index, os.environ.get(task)


def process(tasks: Sequence[int]) -> Iterator[tuple[int, int]]:
    for index, _ in enumerate(tasks):
        time.sleep(0.01)
        yield index, os.getpid()


def busy(tasks: Sequence[str]) -> Iterator[tuple[int, str]]:
    """Tells its process in a file, then works for a minute without a pause."""
    for index, task in enumerate(tasks):
        Path(task).write_text(str(os.getpid()))
        end = time.monotonic() + 60
        while time.monotonic() < end:
            pass
        yield index, task


def busy_after_one(tasks: Sequence[str]) -> Iterator[tuple[int, str]]:
    yield 0, tasks[0]
    yield from busy(tasks[1:])


def all_or_nothing(tasks: Sequence[int]) -> Iterator[tuple[int, int]]:
    """Works on a whole list before the first result."""
    if len(tasks) > 1 and 13 in tasks:
        os._exit(1)
    yield from double(tasks)


def spin(tasks: Sequence[float]) -> Iterator[tuple[int, float]]:
    """Each task keeps the processor busy for so many seconds of its own time."""
    for index, task in enumerate(tasks):
        end = time.process_time() + task
        while time.process_time() < end:
            pass
        yield index, task


def stillborn(tasks: Sequence[int]) -> Iterator[tuple[int, int]]:
    yield from double(tasks)


if os.environ.get("CHORES_ARE_STILLBORN"):
    os._exit(1)
