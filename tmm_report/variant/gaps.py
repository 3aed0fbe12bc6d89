"""Tables over a cycle that say nothing of a long part of it."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import pairwise

from tmm_report.problems import N_, Message, Problem, mistake
from tmm_report.yamlread import Path

NEAR = 1e-9  # of the period
NOT_ALL_ROUND = {
    "deg": (
        N_("nothing is stated from %(last)s to %(next)s deg, where the next cycle begins"),
        N_("state the value at %(next)s deg too; two values at one angle are a jump"),
    ),
    "s": (
        N_("nothing is stated from %(last)s to %(next)s s, where the next cycle begins"),
        N_("state the value at %(next)s s too; two values at one time are a jump"),
    ),
}


def not_all_round(
    pairs: Sequence[tuple[float, float]] | None, path: Path, period: float, unit: str = "deg"
) -> Iterator[Problem]:
    """Pairs (angle turned, value), rad, or (time, value), s, as the `unit` says, that repeat each `period`: a straight
    line from the last to the first of the next cycle is taken as meant where it is no longer than the longest between
    two points and shorter than half of the cycle, or where it is nought or all the table is one value."""
    if not pairs or len(pairs) < 2:
        return
    (first, begins), (last, ends) = pairs[0], pairs[-1]
    widest = max(b - a for (a, _), (b, _) in pairwise(pairs))
    lacks = first + period - last
    usual = lacks <= widest + NEAR * period and lacks < (0.5 - NEAR) * period
    constant = len({value for _, value in pairs}) == 1
    if usual or constant or begins == ends == 0:
        return
    text, right = NOT_ALL_ROUND[unit]
    size = math.radians(1) if unit == "deg" else 1.0
    told = {"last": f"{last / size:.6g}", "next": f"{(first + period) / size:.6g}"}
    yield mistake(text, path, Message(right, told), **told)


def not_to_the_end(
    pairs: Sequence[tuple[float, float]] | None, path: Path, end: float, unit: float = 1.0
) -> Iterator[Problem]:
    """Pairs over a way from nought to `end` that does not repeat: the value at an end of the table is not taken to hold
    farther than the longest line between two points or a quarter of the way, unless it is nought. `unit`: that they are
    told in."""
    if not pairs or len(pairs) < 2:
        return
    (first, begins), (last, ends) = pairs[0], pairs[-1]
    widest = min(max(b - a for (a, _), (b, _) in pairwise(pairs)), end / 4) + NEAR * end
    for lacks, value, low, high in ((first, begins, 0.0, first), (end - last, ends, last, end)):
        if lacks > widest and value:
            text = N_("nothing is stated from %(last)s to %(next)s")
            right = N_("state the values at %(last)s and at %(next)s; two values at one place are a jump")
            told = {"last": f"{low / unit:.6g}", "next": f"{high / unit:.6g}"}
            yield mistake(text, path, Message(right, told), **told)
