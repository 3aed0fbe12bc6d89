"""The same as `pool.over` on the processes of a Dask cluster: those of an existing scheduler, or started here.

    for task, result in over(squares, chunked(range(1000), 32), address="tcp://10.0.0.5:8786", seconds=60):
        ...

Each process of the cluster does the work in a process beside it, as the pool does: a task that kills or hangs
never takes one of the cluster's. Where one of those is killed all the same, Dask has its tasks done elsewhere.
"""

from __future__ import annotations

import logging
import pickle
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import ExitStack, suppress
from functools import partial
from importlib.util import find_spec
from multiprocessing import process
from threading import get_ident
from typing import TYPE_CHECKING, Any, TypeVar

from tmm_report.problems import N_, Message, Problem, ProblemError, shown
from tmm_report.running.pool import Lost, Standing
from tmm_report.running.worker import Do

if TYPE_CHECKING:
    from distributed import Client, Future

T = TypeVar("T")
LOCAL = "local"
WAIT = "10s"  # for the scheduler, and for its first process
ALIVE = 200  # lists of tasks that the scheduler knows of at once


def over(
    do: Do,
    chunks: Iterable[Sequence[T]],
    *,
    address: str,
    jobs: int | None = None,
    seconds: float,
    memory: int | None = None,
) -> Iterator[tuple[T, Any]]:
    """Each task with its result or a Lost, in order of completion.

    `address`: of the scheduler, or "local": `jobs` processes are started here. Raises ProblemError where Dask is not
    installed, the scheduler not reached, or its processes cannot import `do`.
    """
    if find_spec("distributed") is None:
        right = Message(N_("pip install 'tmm-report[cluster]'"))
        raise ProblemError([_problem(N_("Dask is not installed"), right)])
    with ExitStack() as stack:
        client = _connected(stack, address, jobs)
        stack.callback(_dismiss, client)
        yield from _Run(client, pickle.dumps(do), seconds, memory).over(iter(chunks))


def _problem(text: str, right: Message | None = None, **values: object) -> Problem:
    return Problem(Message(text, values), right, path=("--cluster",))


def _connected(stack: ExitStack, address: str, jobs: int | None) -> Client:
    """A client of the scheduler that has a process at least. Raises ProblemError."""
    from distributed import Client, LocalCluster

    logging.getLogger("distributed").setLevel(logging.CRITICAL)  # what goes wrong is told here
    try:
        if address == LOCAL:
            processes = partial(
                LocalCluster, n_workers=jobs, threads_per_worker=1, processes=True, dashboard_address=":0"
            )
            address = stack.enter_context(started(processes)).scheduler_address
        _must_be_one(address)
        client = stack.enter_context(started(partial(Client, address, timeout=WAIT, set_as_default=False)))
    except (OSError, ValueError, TypeError, ImportError) as error:  # TimeoutError is an OSError
        text = N_("no Dask scheduler at %(address)s: %(reason)s")
        reason = shown(error, 120) or type(error).__name__
        raise ProblemError([_problem(text, address=shown(address), reason=reason)]) from None
    try:
        client.wait_for_workers(1, timeout=WAIT)
    except TimeoutError:
        text = N_("the Dask scheduler at %(address)s has no workers")
        raise ProblemError([_problem(text, address=shown(address))]) from None
    return client


def _must_be_one(address: str) -> None:
    """Raises ValueError for what is no address of a scheduler, before anything is started for it."""
    from distributed.comm import get_address_host_port
    from distributed.comm.addressing import parse_address
    from distributed.comm.registry import get_backend

    get_backend(parse_address(address, strict=True)[0])
    host, port = get_address_host_port(address, strict=True)
    if not host or not port:
        raise ValueError("an address is expected, for example tcp://10.0.0.5:8786")


def started(make: Callable[[], T], times: int = 3) -> T:
    """What `make` starts, with a thread of Dask's own. Dask gives that thread ten seconds to begin and then fails an
    assertion of its own: on a busy machine it takes longer, and is there the next time."""
    for _ in range(times - 1):
        with suppress(AssertionError):
            return make()
    try:
        return make()
    except AssertionError:
        raise TimeoutError("the machine is too busy") from None


class _Run:
    """The lists under way on one cluster. `again`: tasks of lists that Dask gave up, as several of its processes died
    over them: it blames all that stood in their queues, so each is tried once more by itself."""

    def __init__(self, client: Client, do: bytes, seconds: float, memory: int | None):
        self.client, self.do, self.seconds, self.memory = client, do, seconds, memory
        self.asked: dict[Future, Sequence[Any]] = {}
        self.again: list[Any] = []

    def over(self, chunks: Iterator[Sequence[T]]) -> Iterator[tuple[T, Any]]:
        from distributed import as_completed

        done = as_completed(loop=self.client.loop)
        self._ask(done, chunks)
        for future in done:
            tasks = self.asked.pop(future)
            found = self._found(future)
            del future  # a cluster keeps results as long as anybody has their future
            if found is None:
                self.again += tasks
            yield from found or ()
            self._ask(done, chunks)
        for task in self.again:
            yield from self._found(self._submit([task])) or [(task, Lost("died"))]

    def _ask(self, done: Any, chunks: Iterator[Sequence[Any]]) -> None:
        """Keep the scheduler in work."""
        while len(self.asked) < ALIVE and (tasks := next(chunks, None)) is not None:
            future = self._submit(tasks)
            self.asked[future] = tasks
            done.add(future)

    def _submit(self, tasks: Sequence[Any]) -> Future:
        return self.client.submit(_do, self.do, tasks, self.seconds, self.memory, pure=False)

    def _found(self, future: Future) -> list[tuple[Any, Any]] | None:
        """Tasks with their results; None where Dask gave them up. Raises ProblemError."""
        from distributed import KilledWorker

        error = future.exception()
        if future.cancelled():
            raise ProblemError([_problem(N_("the connection to the Dask scheduler was lost"))])
        if isinstance(error, KilledWorker):
            return None
        if error is not None:
            text = N_("the workers of the cluster cannot run the program: %(reason)s")
            right = Message(N_("install the same version of tmm-report there"))
            raise ProblemError([_problem(text, right, reason=shown(error, 120) or type(error).__name__)])
        found: list[tuple[Any, Any]] = future.result()
        return found


# ---------------------------------------------------------------- on the cluster

_standing: dict[int, tuple[tuple[Any, ...], Standing]] = {}
"""By the thread of the cluster's process: what it works on, and the process that does it."""


def _do(do: bytes, tasks: Sequence[Any], seconds: float, memory: int | None) -> list[tuple[Any, Any]]:
    """Each task of a list with its result."""
    work, thread = (do, seconds, memory), get_ident()
    if thread not in _standing or _standing[thread][0] != work:
        if thread in _standing:
            _standing.pop(thread)[1].stop()
        _standing[thread] = work, Standing(pickle.loads(do), seconds=seconds, memory=memory)
    # Dask's processes may have no children, so that none is left behind. Ours end with their parent.
    process.current_process()._config.pop("daemon", None)  # type: ignore[attr-defined]
    return _standing[thread][1].run(tasks)


def _leave() -> None:
    """Stop the processes beside a process of the cluster."""
    while _standing:
        _standing.popitem()[1][1].stop()


def _dismiss(client: Client) -> None:
    with suppress(Exception):  # a cluster that is gone has nothing to stop
        client.run(_leave)
