"""What is done already, one line of JSON a task, so that a run that was stopped goes on where it was.

Lines are only ever added. A line that is not whole (the process was killed while it wrote, the power failed) counts as
never written. Of two lines with one key the later holds.

    with Journal(path) as journal:
        place = journal.add({"key": digest(content, options), "status": "done"})
        journal.at(place)
"""

from __future__ import annotations

import hashlib
import json
import os
import sys
from collections.abc import Iterable, Iterator
from pathlib import Path
from time import monotonic
from types import TracebackType
from typing import Any, Self

import numpy as np

SYNCED = 1.0  # s at least between two waits for the disk
Record = dict[str, Any]


def digest(*parts: str | bytes) -> str:
    """A key: SHA-256 of the parts, each with its length, so that no two lists of parts run into one."""
    found = hashlib.sha256()
    for part in parts:
        content = part.encode() if isinstance(part, str) else part
        found.update(b"%d:" % len(content))
        found.update(content)
    return found.hexdigest()


def line(record: Record) -> bytes:
    """A record as it stands in the file."""
    return (json.dumps(record, ensure_ascii=False, separators=(",", ":")) + "\n").encode("utf-8", "replace")


def read(path: Path) -> Iterator[tuple[int, Record]]:
    """Each whole record with the place of its line in the file. Raises OSError."""
    with path.open("rb") as stream:
        place = 0
        for text in stream:
            record = _record(text)
            if record is not None:
                yield place, record
            place += len(text)


def _record(text: bytes) -> Record | None:
    """A line's record; None of one that is not whole."""
    if not text.endswith(b"\n"):
        return None
    try:
        record = json.loads(text)
    except (ValueError, RecursionError):
        return None
    return record if isinstance(record, dict) and isinstance(record.get("key"), str) else None


class Index:
    """Where the last record of each key stands: 16 bytes a record, however long its line.

    A key goes by its first 16 hexadecimal digits here; who reads the record compares the whole.
    """

    def __init__(self, path: Path):
        pairs = ((_short(record["key"]), place) for place, record in _existing(path))
        found = np.fromiter(pairs, dtype=[("key", np.uint64), ("place", np.int64)])
        order = np.argsort(found["key"], kind="stable")
        self._short, self._places = found["key"][order], found["place"][order]

    def __len__(self) -> int:
        return len(self._short)

    def find(self, key: str) -> int | None:
        short = np.uint64(_short(key))
        last = int(np.searchsorted(self._short, short, side="right")) - 1
        return int(self._places[last]) if last >= 0 and self._short[last] == short else None


def _existing(path: Path) -> Iterator[tuple[int, Record]]:
    return read(path) if path.exists() else iter(())


def _short(key: str) -> int:
    try:
        return int(key[:16], 16) & 0xFFFF_FFFF_FFFF_FFFF
    except ValueError:  # a line that somebody else wrote
        return 0


class Journal:
    """The file, to add to. A torn end is cut off when it is opened.

    Raises OSError; BlockingIOError where another process adds to it.
    """

    def __init__(self, path: Path):
        self._file = path.open("r+b" if path.exists() else "x+b")
        try:
            _lock(self._file.fileno())
            self._end, self._synced = _whole(path), monotonic()
            self._file.truncate(self._end)
        except OSError:
            self._file.close()
            raise

    def add(self, record: Record) -> int:
        """Write a record and hand it to the system; the place of its line."""
        text, place = line(record), self._end
        self._file.seek(place)
        self._file.write(text)
        self._file.flush()
        self._end += len(text)
        if monotonic() - self._synced >= SYNCED:
            self._sync()
        return place

    def at(self, place: int) -> Record:
        """The record whose line begins at a place."""
        return json.loads(self.text_at(place))

    def text_at(self, place: int) -> bytes:
        """The line that begins at a place."""
        self._file.seek(place)
        return self._file.readline()

    def _sync(self) -> None:
        os.fsync(self._file.fileno())
        self._synced = monotonic()

    def close(self) -> None:
        if not self._file.closed:
            self._sync()
            self._file.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: object, trace: TracebackType | None) -> None:
        self.close()


def _lock(file: int) -> None:
    """Keep others out until the file is closed, or the process has ended, however it ends; where the system can."""
    if sys.platform == "win32":
        return
    import fcntl

    fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)


def _whole(path: Path) -> int:
    """Where the last line that ends stands: what follows was torn off."""
    size = path.stat().st_size
    with path.open("rb") as stream:
        while size:
            start = max(0, size - 65536)
            stream.seek(start)
            found = stream.read(size - start).rfind(b"\n")
            if found >= 0:
                return start + found + 1
            size = start
    return 0


def rewrite(path: Path, places: Iterable[int]) -> None:
    """The file with the lines at these places alone, in their order; whole or as it was. Raises OSError."""
    part = path.with_name(f".{path.name}.part")
    part.unlink(missing_ok=True)  # a link that somebody put there leads elsewhere
    with path.open("rb") as old, part.open("xb") as new:
        for place in places:
            old.seek(place)
            new.write(old.readline())
        new.flush()
        os.fsync(new.fileno())
    os.replace(part, path)
