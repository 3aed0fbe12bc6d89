"""The other end of the pool: a process that takes lists of tasks and reports each result as it is found."""

from __future__ import annotations

import gc
import os
import signal
import sys
import traceback
from collections.abc import Callable, Iterable, Sequence
from functools import partial
from multiprocessing.connection import Connection
from queue import SimpleQueue
from threading import Thread
from typing import Any, Literal

from tmm_report.records import dataclass

Do = Callable[[Sequence[Any]], Iterable[tuple[int, Any]]]
"""The work: of a list of tasks it yields (index in the list, result) as each is finished."""


@dataclass(frozen=True)
class Stopped:
    """The work raised an exception: there will be no more results of this list."""

    reason: Literal["memory", "error"]
    trace: str = ""


def serve(tasks: Connection, reports: Connection, do: Do, memory: int | None) -> None:
    """Work until the parent is gone; report None when ready, and after each list."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    gc.set_threshold(100_000)  # many short lived objects, few rings
    _limit(memory)
    given: SimpleQueue[Sequence[Any]] = SimpleQueue()
    Thread(target=_take, args=(tasks, given), daemon=True).start()
    report: Any = None
    while True:
        _send(reports, report)
        report = outcome(do, given.get(), partial(_send, reports))


def outcome(do: Do, tasks: Sequence[Any], keep: Callable[[tuple[int, Any]], None]) -> Stopped | None:
    """Do the tasks, pass each result on, and say what stopped the work."""
    try:
        for report in do(tasks):
            keep(report)
    except MemoryError:
        return Stopped("memory")
    except Exception:
        return Stopped("error", traceback.format_exc())
    return None


def _take(tasks: Connection, given: SimpleQueue[Sequence[Any]]) -> None:
    """Pass lists on. The end of the pipe is the end of the parent: leave at once, in the middle of the work too."""
    while True:
        try:
            given.put(tasks.recv())
        except (EOFError, OSError):
            os._exit(0)


def _send(reports: Connection, report: Any) -> None:
    try:
        reports.send(report)
    except (BrokenPipeError, ConnectionError):  # nobody is there to be told
        os._exit(0)


def _limit(memory: int | None) -> None:
    """Hold the process to `memory` bytes of addresses, where the system can."""
    if memory is None or sys.platform == "win32":
        return
    import resource

    hard = resource.getrlimit(resource.RLIMIT_AS)[1]
    least = memory if hard == resource.RLIM_INFINITY else min(memory, hard)
    resource.setrlimit(resource.RLIMIT_AS, (least, hard))
