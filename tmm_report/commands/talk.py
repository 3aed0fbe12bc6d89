"""What a command may say to its user while it works. The command line prints it; a test may collect it."""

from __future__ import annotations

from pathlib import Path
from typing import Protocol

from tmm_report.problems import N_, Message, Problem, ProblemError, mistake


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


def written(*places: Path | str) -> Message:
    """The line that a command ends with."""
    return Message(N_("written: %(files)s"), {"files": ", ".join(map(str, places))})


def unwritable(folder: Path, error: OSError) -> ProblemError:
    """What stops a command that cannot write into its folder."""
    text = N_("cannot write into %(folder)s: %(reason)s")
    return ProblemError([mistake(text, folder=folder, reason=error.strerror)])


def failure(text: str, **values: object) -> ProblemError:
    """A mistake of the command line that stops a command; `text` is a message id."""
    return ProblemError([Problem(Message(text, values))])
