"""What is made once a test run, whichever worker of xdist asks first: `@once` is functools.cache for all of them."""

from __future__ import annotations

import os
import pickle
import time
from collections.abc import Callable
from contextlib import suppress
from functools import cache, wraps
from hashlib import sha256
from pathlib import Path
from typing import ParamSpec, TypeVar

P = ParamSpec("P")
T = TypeVar("T")

# workers are as many as cores: a second thread of BLAS in each would only wait for the first (before numpy is loaded)
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

PATIENCE = 180  # s, longer than anything made here takes: whoever began has died
folder: Path | None = None  # of this run, stated by conftest where there are several workers


def once(make: Callable[P, T]) -> Callable[P, T]:
    """A function of texts and numbers whose result can be pickled; one that fails is tried again by whoever asks."""

    @cache
    @wraps(make)
    def made(*key, **named):
        if folder is None:
            return make(*key, **named)
        name = sha256(repr((make.__module__, make.__qualname__, key, sorted(named.items()))).encode())
        return kept(folder / name.hexdigest(), lambda: make(*key, **named))

    return made


def kept(file: Path, make: Callable[[], T]) -> T:
    """What the file holds; or made and put there, while the other workers wait."""
    lock = file.with_suffix(".lock")
    while not file.exists():
        if claimed(lock):
            try:
                return written(file, make())
            finally:
                lock.unlink(missing_ok=True)
        time.sleep(0.02)
    return pickle.loads(file.read_bytes())


def claimed(lock: Path) -> bool:
    """Whether the lock is now ours; one that has been held for too long is taken away."""
    try:
        lock.touch(exist_ok=False)
        return True
    except FileExistsError:
        with suppress(FileNotFoundError):  # just now given up
            if time.time() - lock.stat().st_mtime > PATIENCE:
                lock.unlink()
        return False


def written(file: Path, value: T) -> T:
    """The value, now in the file: whole, or not at all."""
    part = file.with_suffix(f".{os.getpid()}")
    part.write_bytes(pickle.dumps(value))
    part.replace(file)
    return value
