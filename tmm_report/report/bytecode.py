"""Compiled templates kept between runs, in the user's own cache folder.

Byte code is run, so it is read only from a folder that nobody else can write to or put another in the place of: it
and all above it belong to the user or to the system, and only their owner may write there. Where there is no such
folder, nothing is kept and nothing is said.
"""

from __future__ import annotations

import os
import pickle
import stat
import sys
from contextlib import suppress
from hashlib import sha256
from pathlib import Path

from jinja2 import FileSystemBytecodeCache
from jinja2.bccache import Bucket

SHARED = stat.S_IWGRP | stat.S_IWOTH  # written to by others than the owner


class _Cache(FileSystemBytecodeCache):
    """A cache that is never in the way: what cannot be read is compiled again, what cannot be written is not."""

    def load_bytecode(self, bucket: Bucket) -> None:
        try:
            super().load_bytecode(bucket)
        except (OSError, EOFError, ValueError, TypeError, pickle.UnpicklingError):
            bucket.reset()

    def dump_bytecode(self, bucket: Bucket) -> None:
        with suppress(OSError):
            super().dump_bytecode(bucket)


def bytecode_cache(options: str) -> FileSystemBytecodeCache | None:
    """The cache of templates compiled with these `options`, for jinja does not tell them apart; None: none can be."""
    folder = user_folder()
    if folder is None:
        return None
    folder = folder / "tmm-report" / f"templates-{sha256(options.encode()).hexdigest()[:12]}"
    try:
        folder.mkdir(mode=0o700, parents=True, exist_ok=True)
        folder = folder.resolve(strict=True)
        return _Cache(str(folder), "%s.cache") if _private(folder) else None
    except OSError:
        return None


def user_folder() -> Path | None:
    """The platform's folder for what a program may lose, or None where the user has none."""
    stated = Path(os.environ.get("LOCALAPPDATA" if sys.platform == "win32" else "XDG_CACHE_HOME", ""))
    if stated.is_absolute():
        return stated
    with suppress(RuntimeError):
        return Path.home() / {"win32": "AppData/Local", "darwin": "Library/Caches"}.get(
            sys.platform, ".cache"
        )
    return None


def _private(folder: Path) -> bool:
    """Whether nobody but the user and the system can change what stands in the folder or under its name."""
    if not hasattr(os, "geteuid"):
        return True  # Windows: a profile is its user's by its access list
    own = folder.stat()
    kept = own.st_uid == os.geteuid() and not own.st_mode & SHARED
    return kept and all(map(_guarded, folder.parents))


def _guarded(folder: Path) -> bool:
    """Owned by the user or by root and written to by its owner alone; where others write too, as in /tmp, they
    cannot rename what is ours if it is sticky."""
    found = folder.stat()
    alone = not found.st_mode & SHARED or bool(found.st_mode & stat.S_ISVTX)
    return alone and found.st_uid in (0, os.geteuid())
