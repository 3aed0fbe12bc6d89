"""Cases in processes of their own: forked warm from this one, so many cases each, and ended where one does not end."""

from __future__ import annotations

import json
import os
import resource
import select
import signal
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import asdict

from benchmarks.fuzz.judge import SECONDS, Outcome

CHUNK = 40  # cases of a process
ADDRESS_SPACE = 3 << 30  # bytes: beyond it the machine itself would suffer
PATIENCE = 20  # times the limit of time, as others work on the machine too

Case = Callable[[int], Outcome]


def outcomes(numbers: Sequence[int], case: Case) -> Iterator[tuple[int, Outcome]]:
    """Of every case, in order; of one that ended its process what is known."""
    left = list(numbers)
    while left:
        done = 0
        for number, outcome in _process(left[:CHUNK], case):
            done += 1
            yield number, outcome
        left = left[max(done, 1) :]


def _process(numbers: Sequence[int], case: Case) -> Iterator[tuple[int, Outcome]]:
    """The cases of one process, up to the one that ends it."""
    ours, theirs = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(ours)
        _work(numbers, case, theirs)
    os.close(theirs)
    done, rest, status = 0, b"", None
    try:
        while done < len(numbers):
            line, rest = _line(ours, rest, child)
            if line is None:
                break
            done += 1
            found = json.loads(line)
            yield numbers[done - 1], Outcome(**{**found, "words": tuple(found["words"])})
    finally:
        os.close(ours)
        status = _ended(child)
    if done < len(numbers):
        yield numbers[done], Outcome("Killed", _cpu(status), 0.0, place=f"signal {status[0] & 127}")


def _work(numbers: Sequence[int], case: Case, pipe: int) -> None:
    """In the child: an outcome a line. It never returns."""
    try:
        resource.setrlimit(resource.RLIMIT_AS, (ADDRESS_SPACE, ADDRESS_SPACE))
        for number in numbers:
            os.write(pipe, json.dumps(asdict(case(number))).encode() + b"\n")
    finally:
        os._exit(0)


def _line(pipe: int, rest: bytes, child: int) -> tuple[bytes | None, bytes]:
    """The next line of the child and what follows it; none at its end. A child that is silent too long is killed."""
    while b"\n" not in rest:
        ready, _, _ = select.select([pipe], [], [], PATIENCE * SECONDS)
        if not ready:
            os.kill(child, signal.SIGKILL)
            return None, rest
        piece = os.read(pipe, 65536)
        if not piece:
            return None, rest
        rest += piece
    line, _, rest = rest.partition(b"\n")
    return line, rest


def _ended(child: int) -> tuple[int, resource.struct_rusage]:
    began = time.monotonic()
    while True:
        pid, status, usage = os.wait4(child, os.WNOHANG)
        if pid:
            return status, usage
        if time.monotonic() - began > 5:
            os.kill(child, signal.SIGKILL)
        time.sleep(0.002)


def _cpu(ended: tuple[int, resource.struct_rusage]) -> float:
    return ended[1].ru_utime + ended[1].ru_stime
