"""The conditions of a sound spur pair, with what is in hand for each: the rows that are printed of `pair_limits`."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

from tmm_report.mechanics.gears.limits.condition import Condition
from tmm_report.mechanics.gears.limits.pair import Limit, limits_of
from tmm_report.mechanics.gears.meshing import Pair

CONTACT = 1.05  # least contact ratio
POINTING = 0.3  # least thickness of the tips, modules
BY_ASSEMBLY = (
    "radial",
    "feed",
)  # their cure is another way of putting together or cutting, not other numbers

Row = tuple[Any, Any, str, bool]  # value, limit, unit of print, whether the value is to be no less


def limits(pair: Pair, sliding: float) -> tuple[Limit, ...]:
    """All by which a pair is judged; `sliding`: the largest specific sliding allowed."""
    return limits_of(pair, POINTING, CONTACT, sliding)


def conditions_of(pair: Pair, names: tuple[str, str], sliding: float) -> Iterator[Condition]:
    """In the order of the note: those of the limits that are printed, and the ways of putting together."""
    rows = {(limit.kind, limit.wheel) for limit in limits(pair, sliding)}
    rows |= {("interference", 1), ("interference", 2)} | {("radial", 0)} if pair.internal else set()
    rows |= {("feed", i + 1) for i in (0, 1) if pair.cutting[i]}
    for kind, shown in ROWS.items():
        for wheel in sorted(wheel for key, wheel in rows if key == kind):
            value, limit, unit, least = shown(pair, wheel - 1)
            bound = sliding if kind == "root sliding" else float(limit)
            key = KEYS.get(kind, kind)
            yield Condition(key, names[wheel - 1] if wheel else "", float(value), bound, unit, least)


KEYS = {"root sliding": "sliding"}
ROWS: dict[str, Callable[[Pair, int], Row]] = {
    "undercut": lambda p, i: ((p.x1, p.x2)[i], p.x_min[i], "", True),
    "pointing": lambda p, i: (p.s_na[i], POINTING * p.m, "mm", True),
    "contact": lambda p, i: (p.eps, CONTACT, "", True),
    "interference": lambda p, i: (p.rho_m[i], p.starts[i], "mm", bool(p.signs[i] > 0)),
    "space": lambda p, i: (p.spaces[i], 0.0, "mm", True),
    "fouling": lambda p, i: (p.fouling, 0.0, "deg", True),
    "radial": lambda p, i: (p.radial, 0.0, "deg", True),
    "trimming": lambda p, i: (p.cut_ring(i).trimming, 0.0, "mm", True),
    "cutter fouling": lambda p, i: (p.cut_ring(i).fouling, 0.0, "deg", True),
    "feed": lambda p, i: (p.cut_ring(i).radial, 0.0, "deg", True),
    "root sliding": lambda p, i: (abs(p.root_sliding[i]), 0.0, "", False),
}
