"""What marking speaks of beside `judging.model`: a marked work, and what is kept of it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from typing import Any

from tmm_report.judging.model import (
    KINDS,
    OF_WHOLE,
    RIGHT,
    Answered,
    Answers,
    Asked,
    Cause,
    Expected,
    Judged,
    Name,
    Rule,
)
from tmm_report.records import dataclass

__all__ = [
    "ABSENT", "HELD", "KINDS", "OF_WHOLE", "RIGHT", "UNREAD", "Answered", "Answers", "Asked", "Cause", "Digest",
    "Expected", "Judged", "Marked", "MarkedColumn", "Name", "Override", "Rule",
]  # fmt: skip

Array = Any


@dataclass(frozen=True, eq=False)
class MarkedColumn:
    """One column with its points. `answered` is None where the student left the whole column out.

    `rules`: (P,) after carried values were looked for. `carried`: (P,) the key of the quantity from whose wrong value
    a cell follows rightly, "" elsewhere. `points`, `worth`: (P,).
    """

    asked: Asked
    answered: Answered | None
    judged: Judged
    rules: tuple[Rule, ...]
    carried: tuple[str, ...]
    points: Array
    worth: Array


@dataclass(frozen=True, eq=False)
class Marked:
    """One student's work, marked. `points` of `worth`; `would`: the points without each of `causes`."""

    id: str
    title: Mapping[str, str]  # of the variant: student, group, variant, …
    language: str
    answers: Answers
    columns: Mapping[Name, MarkedColumn]
    causes: tuple[Cause, ...]
    would: tuple[float, ...]
    points: float
    worth: float


@dataclass(frozen=True)
class Override:
    """A mark that the teacher set by hand, and why."""

    points: float
    reason: str = ""


ABSENT, UNREAD, HELD = "absent", "unread", "held"
"""Why a work has no mark: nothing was handed in; what was could not be read; the mark set by hand is none."""


@dataclass(frozen=True)
class Digest:
    """What is kept of one marked work for gradebook and statistics; it is small, and goes from process to process.

    `cells`: (table, key, row label) -> (the student's number in the quantity's unit, the rule that decided); nan where
    there is none. `right`: the same cells -> the solution's numbers. `causes`: (kind, detail, keys of the columns).
    `failed`: why the work could not be marked, fit to be shown; then all else is empty but what would have been right.
    `state`: ABSENT, UNREAD, HELD, "" of others. `columns`: (table, key) -> (points, worth). `override`: its mark, where
    it is not `points`. `attempt` of `attempts` counts. `missed`: files of a marked work that could not be read.
    `unwritten`: why its feedback could not be written.
    """

    id: str
    student: str = ""
    group: str = ""
    variant: str = ""
    points: float = 0.0
    worth: float = 0.0
    cells: Mapping[tuple[str, str, str], tuple[float, str]] = field(default_factory=dict)
    right: Mapping[tuple[str, str, str], float] = field(default_factory=dict)
    causes: tuple[tuple[str, str, tuple[str, ...]], ...] = ()
    failed: tuple[str, ...] = ()
    columns: Mapping[tuple[str, str], tuple[float, float]] = field(default_factory=dict)
    state: str = ""
    override: Override | None = None
    attempt: int = 1
    attempts: int = 1
    missed: tuple[str, ...] = ()
    unwritten: str = ""

    @property
    def judged(self) -> bool:
        """Whether the work itself was marked."""
        return not (self.failed or self.state)

    @property
    def marked(self) -> bool:
        """Whether it has a mark, be it one set by hand."""
        return self.override is not None or self.judged

    @property
    def mark(self) -> float:
        return self.points if self.override is None else self.override.points
