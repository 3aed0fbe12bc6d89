"""What a command may say to its user while it works. The command line prints it; a test may collect it."""

from __future__ import annotations

import errno
import os
from collections.abc import Sequence
from pathlib import Path
from typing import Protocol

from tmm_report.problems import N_, Message, Problem, ProblemError, mistake, shown


class Talk(Protocol):
    """The user's end of a command: a language, a line that says what is being done, and lines that stay.

    A str is said as it is, a Message in the user's language.
    """

    def speak(self, language: str) -> None:
        """Say what follows in another language."""

    def stage(self, doing: Message) -> None:
        """What is being done now."""

    def tell(self, line: Message | str) -> None:
        """A line of what was found."""

    def warn(self, line: Message | Problem | str) -> None:
        """A line of what went wrong."""


class Row(str):
    """A line of a table, with its cells at their widths: a terminal may colour them."""

    cells: Sequence[str]

    def __new__(cls, cells: Sequence[str], widths: Sequence[int]) -> Row:
        wide = [cell.ljust(width) for cell, width in zip(cells, widths, strict=True)]
        row = super().__new__(cls, " ".join(wide).rstrip())
        row.cells = wide
        return row


def in_columns(rows: Sequence[Sequence[str]]) -> list[Row]:
    """The lines of a table."""
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    return [Row(row, widths) for row in rows]


def written(*places: Path | str) -> Message:
    """The line that a command ends with."""
    return Message(N_("written: %(files)s"), {"files": ", ".join(map(str, places))})


UNWRITABLE = N_("cannot write into %(folder)s: %(reason)s")


class Linked(OSError):
    """A link stands where a file or a folder of the output is to be: what it leads to is somebody's own."""


def unlinked(*places: Path) -> None:
    """See that none of the places is a link. Raises Linked."""
    for place in places:
        if place.is_symlink():
            raise Linked(errno.ELOOP, os.strerror(errno.ELOOP), str(place))


def unwritable(folder: Path, error: OSError) -> ProblemError:
    """What stops a command that cannot write into its folder; what is in the way is named."""
    if isinstance(error, BlockingIOError):
        return ProblemError([mistake(N_("another run is writing into %(folder)s"), folder=folder)])
    if isinstance(error, Linked):
        place = Path(shown(os.fsdecode(error.filename), 1000))
        right = Message(N_("remove the link, or name another folder for the output"))
        return ProblemError(
            [mistake(N_("%(place)s is a link: nothing is written through it"), (), right, place=place)]
        )
    text, place = UNWRITABLE, error.filename2 or error.filename
    if isinstance(error, NotADirectoryError | IsADirectoryError) and place is not None:
        folder = Path(shown(os.fsdecode(place), 1000))
    return ProblemError([mistake(text, folder=folder, reason=reason(error))])


def outside(error: OSError) -> Problem:
    """What the system refused, in a line."""
    if error.filename is None:
        return mistake("%(reason)s", reason=reason(error))
    return mistake(
        "%(file)s: %(reason)s", file=shown(os.fsdecode(error.filename), 1000), reason=reason(error)
    )


def reason(error: OSError) -> str:
    """What the system says of it; some errors have it as their text alone."""
    return shown(error.strerror or error or type(error).__name__, 300)


def failure(text: str, **values: object) -> ProblemError:
    """A mistake of the command line that stops a command; `text` is a message id."""
    return ProblemError([Problem(Message(text, values))])
