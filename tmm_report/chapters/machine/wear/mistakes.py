"""What no law of wear can answer, in sentences that explain why."""

from __future__ import annotations

import math

from tmm_report.mechanics.pairs.wear import Grid
from tmm_report.problems import N_, Message, ProblemError, mistake

LEAST = 3  # points of the guide under the slider: one in the middle, one for each half
DEEPEST = 0.1  # of the length of a slider, of the diameter of a journal

Path = tuple[str | int, ...]


def long_enough(grid: Grid, length: float, path: Path) -> None:
    """Raises ProblemError where the slider of `length` has no points in its halves."""
    if grid.covered >= LEAST:
        return
    text = N_(
        "the slider is shorter than two of the equal parts of the guide: no law of pressure stands on it"
    )
    right = Message(
        N_("parts: %(parts)s or more, or a longer slider"),
        {"parts": str(math.ceil((LEAST - 1) * grid.parts * grid.step / length))},
    )
    raise ProblemError([mistake(text, (*path, "length"), right)])


def believable(depth: float, size: float, path: Path) -> None:
    """Raises ProblemError where the greatest wear is nothing, or a great part of the size of the pair."""
    where = (*path, "coefficient")
    if not depth > 0:
        text = N_("nothing wears: the coefficients are zero, or nothing presses where it slides")
        raise ProblemError([mistake(text, where, Message(N_("a coefficient above zero")))])
    if depth > DEEPEST * size:
        text = N_(
            "the wear would be %(depth)s mm deep: no pair works so long, and its pressures would be others by then"
        )
        right = Message(N_("wear coefficients are 1e-17 … 1e-12 1/Pa; or fewer cycles, or larger faces"))
        raise ProblemError([mistake(text, where, right, depth=f"{1e3 * depth:.3g}")])
