"""Tasks over processes: one that kills its process, or hangs, costs one more try of itself and never the rest.

    for task, result in over(squares, chunked([1, 2, 3]), jobs=2, seconds=60):
        ...

The work is a function of a list of tasks that yields (index in the list, result) as each is finished. Processes are
spawned, not forked: they share nothing with the parent, and end when it does, however it ends.
"""

from __future__ import annotations

import os
import signal
from collections import deque
from collections.abc import Callable, Generator, Iterable, Iterator, Sequence
from contextlib import contextmanager, suppress
from dataclasses import field
from itertools import islice
from multiprocessing import get_context
from multiprocessing.connection import Connection, wait
from multiprocessing.process import BaseProcess
from time import monotonic
from typing import Any, Literal, TypeVar

from tmm_report.records import dataclass
from tmm_report.running import worker
from tmm_report.running.worker import Do, Stopped

T = TypeVar("T")
STARTING = 120.0  # s that a process may take until it is ready: imports from a slow disk
PATIENCE = 3600.0  # s of waiting at a time: systems have a largest
STILLBORN = 3  # processes in a row that die before they are ready: the next would, too
ONE_THREAD = ("OMP", "OPENBLAS", "MKL", "NUMEXPR", "VECLIB")


@dataclass(frozen=True)
class Lost:
    """Why a task has no result though it was tried alone: its process died, it took too long, it asked for too much
    memory, or it raised what nobody had foreseen. `trace`: of such an error, the traceback."""

    reason: Literal["died", "time", "memory", "error"]
    trace: str = ""


class NotStarting(RuntimeError):
    """Processes die before they take any task: nothing that a task did."""


def over(
    do: Do, chunks: Iterable[Sequence[T]], *, jobs: int, seconds: float, memory: int | None = None
) -> Generator[tuple[T, Any], None, None]:
    """Each task with its result or a Lost, in order of completion.

    `do`: importable by name, or a partial of such. `chunks` are taken as processes come free, so they may be endless.
    `seconds`: for one task, since the last that was finished. `memory`: bytes that a process may ask for, where the
    system can hold it to that. Closing the generator, or an exception in the caller, stops the processes at once.
    Raises NotStarting.
    """
    pool = _Pool(do, iter(chunks), jobs, seconds, memory)
    try:
        while pool.give():
            yield from pool.collect()
    finally:
        pool.stop()


def chunked(tasks: Iterable[T], size: int) -> Iterator[list[T]]:
    """Consecutive tasks, `size` at a time."""
    waiting = iter(tasks)
    while chunk := list(islice(waiting, size)):
        yield chunk


class Standing:
    """One process that is kept from one list of tasks to the next."""

    def __init__(self, do: Do, *, seconds: float, memory: int | None = None):
        self._pool = _Pool(do, iter(()), 1, seconds, memory)

    def run(self, tasks: Sequence[T]) -> list[tuple[T, Any]]:
        """Each task with its result or a Lost. Raises NotStarting."""
        self._pool.chunks = iter([tasks])
        found: list[tuple[T, Any]] = []
        while self._pool.give():
            found += self._pool.collect()
        return found

    def stop(self) -> None:
        self._pool.stop()


@dataclass(eq=False)
class _Chunk:
    """Tasks that go to a process together; `left`: indices of those without a result; `alone`: tried once before."""

    tasks: Sequence[Any]
    alone: bool = False
    left: set[int] = field(init=False)

    def __post_init__(self) -> None:
        self.left = set(range(len(self.tasks)))


@dataclass(eq=False)
class _Worker:
    """A process and its two pipes; `since`: when it was last heard of; `at`: the chunk that it works on."""

    process: BaseProcess
    tasks: Connection
    reports: Connection
    since: float = field(default_factory=monotonic)
    ready: bool = False
    at: _Chunk | None = None

    def close(self) -> None:
        self.process.kill()
        self.process.join()
        self.tasks.close()
        self.reports.close()


class _Pool:
    """The processes, and the chunks that are to be tried again."""

    def __init__(
        self, do: Do, chunks: Iterator[Sequence[Any]], jobs: int, seconds: float, memory: int | None
    ):
        self.do, self.chunks, self.jobs, self.seconds, self.memory = do, chunks, jobs, seconds, memory
        self.workers: list[_Worker] = []
        self.again: deque[_Chunk] = deque()
        self.stillborn = 0

    def give(self) -> bool:
        """Give every free process a chunk, and start processes while there are chunks; whether any is under way."""
        for one in self.workers:
            if one.at is None and (chunk := self._next()) is not None:
                one.at, one.since = chunk, monotonic()
                if one.ready:
                    _send(one)
        while len(self.workers) < self.jobs and (chunk := self._next()) is not None:
            self.workers.append(_start(self.do, self.memory))
            self.workers[-1].at = chunk
        return any(one.at is not None for one in self.workers)

    def _next(self) -> _Chunk | None:
        if self.again:
            return self.again.popleft()
        tasks = next(self.chunks, None)
        return None if tasks is None else _Chunk(tasks)

    def collect(self) -> list[tuple[Any, Any]]:
        """What the processes report until the nearest deadline; those beyond theirs are ended."""
        nearest = min(self._deadline(one) for one in self.workers)
        patience = min(max(0.0, nearest - monotonic()), PATIENCE)
        heard = wait([one.reports for one in self.workers], patience)
        found: list[tuple[Any, Any]] = []
        for one in [*self.workers]:
            if one.reports in heard:
                found += self._read(one)
            elif monotonic() > self._deadline(one):
                found += self._end(one, "time")
        return found

    def _deadline(self, one: _Worker) -> float:
        if not one.ready:
            return one.since + STARTING
        return one.since + self.seconds if one.at is not None else float("inf")

    def _read(self, one: _Worker) -> list[tuple[Any, Any]]:
        """All that stands in a process's pipe; it may have died since."""
        found: list[tuple[Any, Any]] = []
        try:
            while one.reports.poll():
                report = one.reports.recv()
                one.since = monotonic()
                if isinstance(report, Stopped):
                    return found + self._stopped(one, report)
                found += self._heard(one, report)
        except (EOFError, OSError):  # OSError: the pipe ends in the middle of a report
            return found + self._end(one, "died")
        return found

    def _heard(self, one: _Worker, report: Any) -> list[tuple[Any, Any]]:
        """A result; or None, when the process is ready or its chunk is done."""
        if report is None and not one.ready:
            one.ready, self.stillborn = True, 0
            _send(one)
        elif report is None:
            chunk, one.at = one.at, None
            if chunk is not None and chunk.left:
                return self._failed(chunk, Lost("error", "the work ended without a result"))
        elif one.at is not None:
            index, result = report
            one.at.left.discard(index)
            return [(one.at.tasks[index], result)]
        return []

    def _stopped(self, one: _Worker, report: Stopped) -> list[tuple[Any, Any]]:
        """The work raised an exception. After a lack of memory nobody knows what the process is in want of."""
        if report.reason == "memory":
            return self._end(one, "memory")
        chunk, one.at = one.at, None
        return self._failed(chunk, Lost(report.reason, report.trace))

    def _end(self, one: _Worker, reason: Literal["died", "time", "memory"]) -> list[tuple[Any, Any]]:
        """Take a process out, and see what becomes of its chunk. Raises NotStarting."""
        self.workers.remove(one)
        one.close()
        if one.ready:
            return self._failed(one.at, Lost(reason))
        self.stillborn += 1
        if self.stillborn >= STILLBORN:
            raise NotStarting(f"{STILLBORN} processes in a row ended before they were ready")
        if one.at is not None:
            self.again.appendleft(one.at)
        return []

    def _failed(self, chunk: _Chunk | None, lost: Lost) -> list[tuple[Any, Any]]:
        """Tasks without a result are tried again, each alone; one that was alone is lost."""
        if chunk is None:
            return []
        left = [chunk.tasks[index] for index in sorted(chunk.left)]
        if chunk.alone:
            return [(task, lost) for task in left]
        self.again.extend(_Chunk([task], alone=True) for task in left)
        return []

    def stop(self) -> None:
        """End all processes at once."""
        for one in self.workers:
            one.process.kill()
        for one in self.workers:
            one.close()
        self.workers = []


def _send(one: _Worker) -> None:
    """Give a process its chunk; if it died meanwhile, its other pipe tells."""
    if one.at is not None:
        with suppress(BrokenPipeError, ConnectionError):
            one.tasks.send(one.at.tasks)


def _start(do: Callable[..., Any], memory: int | None) -> _Worker:
    context = get_context("spawn")
    tasks_in, tasks_out = context.Pipe(duplex=False)
    reports_in, reports_out = context.Pipe(duplex=False)
    process = context.Process(target=worker.serve, args=(tasks_in, reports_out, do, memory), daemon=True)
    with _one_thread(), _interrupts_held():
        process.start()
    tasks_in.close()  # the process has its own: when it ends, the pipe must end
    reports_out.close()
    return _Worker(process, tasks_out, reports_in)


@contextmanager
def _one_thread() -> Iterator[None]:
    """What is started here does its linear algebra in one thread: the processes are the parallelism."""
    names = [f"{library}_NUM_THREADS" for library in ONE_THREAD]
    before = {name: os.environ.get(name) for name in names}
    os.environ.update(dict.fromkeys(names, "1"))
    try:
        yield
    finally:
        for name, value in before.items():
            if value is None:
                del os.environ[name]
            else:
                os.environ[name] = value


@contextmanager
def _interrupts_held() -> Iterator[None]:
    """What is started here never sees Ctrl-C, which is the parent's; the parent sees it a moment later.

    Windows has no such mask; there a process turns a deaf ear as soon as it runs.
    """
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)
