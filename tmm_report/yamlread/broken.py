"""A text that is not YAML, as the parser complains of it, and what is told of it."""

from __future__ import annotations

from functools import cached_property
from typing import NamedTuple

from tmm_report.problems import Message
from tmm_report.records import dataclass

Place = tuple[int, int]


class Slip(NamedTuple):
    """Where the slip is, counted from 1, what is wrong and what would be right."""

    place: Place
    wrong: Message
    right: Message | None


@dataclass(frozen=True, eq=False)
class Broken:
    """A parser's complaint: what, where (line, column from 1), and where what it was reading began."""

    text: str
    problem: str
    place: Place
    context: str
    begun: Place | None

    @cached_property
    def lines(self) -> list[str]:
        return self.text.split("\n")

    def line(self, number: int) -> str:
        return self.lines[number - 1] if 0 < number <= len(self.lines) else ""

    @property
    def here(self) -> str:
        """The line where the parser stopped."""
        return self.line(self.place[0])

    @property
    def before(self) -> str:
        """What stands in it before that place."""
        return self.here[: self.place[1] - 1]

    @property
    def char(self) -> str:
        return self.here[self.place[1] - 1 : self.place[1]]

    @cached_property
    def above(self) -> int:
        """The number of the line with something in it before that one; 0 if there is none."""
        return next((n for n in range(self.place[0] - 1, 0, -1) if content(self.line(n))), 0)


def content(line: str) -> str:
    """The line without what is no content."""
    bare = line.strip()
    return "" if bare.startswith("#") else bare


def indent(line: str) -> int:
    return len(line) - len(line.lstrip(" "))
