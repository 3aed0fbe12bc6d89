"""Standard streams that may be closed, cut off or full: what is said is then lost, never the work."""

from __future__ import annotations

import errno
import os
from typing import Any, TextIO

CUT = (errno.EPIPE, errno.EINVAL)  # nobody reads on: `| head`; EINVAL is Windows' word for it


class Careful:
    """A text stream that never fails. `error`: why something could not be written, where somebody wanted it."""

    def __init__(self, stream: TextIO):
        self._stream = stream
        self.error: OSError | None = None
        self._lost = False

    def write(self, text: str) -> int:
        if not self._lost:
            try:
                self._stream.write(text)
            except OSError as error:
                self._lose(error)
        return len(text)

    def flush(self) -> None:
        if not self._lost:
            try:
                self._stream.flush()
            except OSError as error:
                self._lose(error)

    def _lose(self, error: OSError) -> None:
        self._lost = True
        self.error = None if error.errno in CUT else error
        # what waits in the stream's own memory is tried again when it is closed, and must not fail again
        os.dup2(_nowhere(), self._stream.fileno())

    def __getattr__(self, name: str) -> Any:
        return getattr(self._stream, name)


def see_open() -> None:
    """Put the system's null device in place of closed standard streams: else the next file takes their number."""
    for number in range(3):
        try:
            os.fstat(number)
        except OSError:
            while _nowhere() < number:
                pass


def careful(stream: TextIO | None, number: int) -> Careful:
    """Such a stream over a standard one; None: it was closed when Python began."""
    if stream is None:
        stream = open(number, "w", encoding="utf-8", closefd=False)  # noqa: SIM115
    # a name that the terminal cannot show must not stop the run
    stream.reconfigure(errors="backslashreplace")  # type: ignore[attr-defined]
    return Careful(stream)


def _nowhere() -> int:
    return os.open(os.devnull, os.O_RDWR)
