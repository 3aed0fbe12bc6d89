"""The conditions of a sound spur pair, with what is in hand for each."""

from __future__ import annotations

import math
from collections.abc import Iterator

from tmm_report.chapters.spur.mistakes import involute_start
from tmm_report.mechanics.conditions import Condition
from tmm_report.mechanics.spur import Pair

CONTACT = 1.05  # least contact ratio
POINTING = 0.3  # least thickness of the tips, modules
SLIDING = 6.0  # largest specific sliding: 3 for fast drives, up to 6 for slow ones


def involute_starts(pair: Pair) -> tuple[float, float]:
    """Radii of curvature where the involutes begin, m: above the fillet, or where an undercut has eaten them."""
    starts = [involute_start(pair, i) for i in (0, 1)]
    return tuple(math.inf if start is None else start for start in starts)  # type: ignore[return-value]


def conditions_of(pair: Pair, names: tuple[str, str], starts: tuple[float, float]) -> Iterator[Condition]:
    """In the order of the note; `starts`: radii of curvature where the involutes begin, m."""
    for i in (0, 1):
        if pair.signs[i] > 0:
            yield Condition("undercut", names[i], float([pair.x1, pair.x2][i]), float(pair.x_min[i]))
    for i in (0, 1):
        yield Condition("pointing", names[i], float(pair.s_na[i]), POINTING * pair.m, "mm")
    yield Condition("contact", "", float(pair.eps), CONTACT)
    for i in (0, 1):
        outer = bool(pair.signs[i] > 0)
        yield Condition("interference", names[i], float(pair.rho_p[i]), starts[i], "mm", least=outer)
    if pair.internal:
        yield Condition("fouling", "", float(pair.fouling), 0.0, "deg")
    for i in (0, 1):
        yield Condition("sliding", names[i], abs(float(pair.root_sliding[i])), SLIDING, least=False)
