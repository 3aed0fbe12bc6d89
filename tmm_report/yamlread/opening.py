"""Regular files opened and read under a limit: links, devices, pipes and folders are refused, never waited on."""

from __future__ import annotations

import errno
import os
import stat
from dataclasses import replace
from typing import BinaryIO

from tmm_report.problems import N_, Message, Problem, ProblemError, mistake, shown


def file_label(path: str | os.PathLike[str]) -> str:
    """The file's name as it may be printed: undecodable bytes and control characters are replaced."""
    return shown(os.fsencode(path).decode("utf-8", "backslashreplace"), 1000)


def opened(path: str | os.PathLike[str], file: str, limit: int) -> bytes:
    """The content of a regular file of at most `limit` bytes; `file` is how messages name it.

    Links, devices, pipes and folders are refused, never waited on. Raises ProblemError.
    """
    with stream(path, file) as source:
        try:
            content = source.read(limit + 1)
        except OSError as error:
            raise ProblemError([replace(_unopened(error), file=file)]) from None
    if len(content) > limit:
        raise ProblemError([replace(larger(limit), file=file)])
    return content


def stream(path: str | os.PathLike[str], file: str) -> BinaryIO:
    """A regular file opened as `opened` does it, for those who read only parts of it. Raises ProblemError."""
    flags = os.O_RDONLY
    for name in ("O_NOFOLLOW", "O_NONBLOCK", "O_CLOEXEC", "O_BINARY"):  # not every system has each
        flags |= getattr(os, name, 0)
    try:
        if not hasattr(os, "O_NOFOLLOW") and os.path.islink(path):
            raise OSError(errno.ELOOP, "link")
        descriptor = os.open(path, flags)
    except (OSError, ValueError) as error:  # ValueError: a NUL in the name
        raise ProblemError([replace(_unopened(error), file=file)]) from None
    return _regular(descriptor, file)


def _regular(descriptor: int, file: str) -> BinaryIO:
    if stat.S_ISREG(os.fstat(descriptor).st_mode):
        return os.fdopen(descriptor, "rb")
    os.close(descriptor)
    raise ProblemError([replace(mistake(N_("this is not a regular file")), file=file)])


def larger(limit: int) -> Problem:
    return mistake(N_("the file is larger than %(limit)s kB"), limit=limit // 1024)


def _unopened(error: OSError | ValueError) -> Problem:
    code = getattr(error, "errno", None)
    if code == errno.ENOENT:
        return mistake(N_("there is no such file"))
    if code == errno.ELOOP:
        return mistake(N_("the file is a link"), right=Message(N_("name the file itself")))
    return mistake(N_("the file cannot be opened: %(reason)s"), reason=os.strerror(code) if code else "?")
