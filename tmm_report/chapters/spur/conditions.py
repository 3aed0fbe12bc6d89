"""The conditions of a sound spur pair, with what is in hand for each."""

from __future__ import annotations

import math
from collections.abc import Iterator

from tmm_report.mechanics import teeth
from tmm_report.mechanics.conditions import Condition
from tmm_report.mechanics.spur import Pair

CONTACT = 1.05  # least contact ratio
POINTING = 0.3  # least thickness of the tips, modules


def involute_starts(pair: Pair) -> tuple[float, float]:
    """Radii of curvature where the involutes begin, m: above the fillet, or where an undercut has eaten them.

    ∞ where the undercut reaches the tip. A ring is taken as a rack would cut it.
    """
    return _start(pair, 0), _start(pair, 1)


def _start(pair: Pair, i: int) -> float:
    lower = float(pair.rho_l[i])
    if pair.signs[i] < 0 or lower >= 0:
        return lower
    z, x = int((pair.z1, pair.z2)[i]), float((pair.x1, pair.x2)[i])
    try:
        cut = teeth.flank(z, float(pair.m_t), x * math.cos(pair.beta), pair.t, tip=float(pair.d_a[i]) / 2)
    except ValueError:
        return math.inf
    return math.sqrt(max(cut.junction**2 - cut.base**2, 0.0))


def conditions_of(
    pair: Pair, names: tuple[str, str], starts: tuple[float, float], sliding: float
) -> Iterator[Condition]:
    """In the order of the note; `starts`: radii of curvature where the involutes begin, m; `sliding`: the largest
    specific sliding allowed."""
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
        yield Condition("sliding", names[i], abs(float(pair.root_sliding[i])), sliding, least=False)
