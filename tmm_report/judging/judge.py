"""A student's column held against the solution: the course's difference, its limit, and what a plan can be read to.

    delta = 200 (g - a)/(g + a) %
    right = |delta| <= limit  or  |g - a| <= floor

The second is the fiducial error of metrology: near zero a plan read to a millimetre cannot keep a relative limit.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from tmm_report.judging.model import Asked, Judged, Rule

Array = Any

PLAN = 50.0  # mm: the longest vector of a plan as plans are drawn
READ = 1.0  # mm: to what lengths of a plan are read
SLACK = 1 + 1e-9  # so that rounding of the last digit decides nothing
NOTHING = (
    1e-9  # in the unit asked, and of a column's greatest number: what the solution has there is rounding of 0
)

_RULES = tuple(Rule)
_LIMIT, _FLOOR, _ZERO, _EXACT, _OFF, _SIGN, _NO_ANSWER, _NOT_ASKED = (
    _RULES.index(rule)
    for rule in (
        *(Rule.LIMIT, Rule.FLOOR, Rule.ZERO, Rule.EXACT),
        *(Rule.OFF, Rule.SIGN, Rule.NO_ANSWER, Rule.NOT_ASKED),
    )
)


def judge(
    asked: Asked,
    values: Array,
    given: Array,
    *,
    limit: float = 5.0,
    floor: float | None = None,
    magnitudes: bool = False,
) -> Judged:
    """Every cell of a column judged by its rule.

    `values`, `given`: (P,), as in Answered. `limit`: per cent. `floor`: in the unit asked, `default_floor` where None.
    `magnitudes`: both sides are taken without their signs. Angles are compared on the circle.
    """
    floor = default_floor(asked) if floor is None else floor
    right, mine = sides(asked, np.asarray(values, dtype=float), magnitudes)
    with np.errstate(invalid="ignore", over="ignore", divide="ignore"):
        delta = difference(right, mine)
        codes = _whole(right, mine) if asked.whole else _codes(right, mine, delta, limit, floor)
    codes[~(np.asarray(given, dtype=bool) & np.isfinite(mine))] = _NO_ANSWER
    codes[~np.isfinite(right)] = _NOT_ASKED
    delta[(codes == _NO_ANSWER) | (codes == _NOT_ASKED)] = np.nan
    return Judged(delta, tuple(_RULES[code] for code in codes.tolist()), magnitudes)


def default_floor(asked: Asked, k: float = READ) -> float:
    """The difference that cannot be read off a plan whose longest vector is `PLAN` mm long, read to `k` mm.

    Of what no plan gives, single values and tables of things, it is what the solution's own rounding leaves of a 0.
    """
    read = k / PLAN if asked.by_position and len(asked.values) > 1 else 0.0
    return max(max(read, NOTHING) * asked.largest, NOTHING)


def takes_magnitudes(asked: Asked, values: Array) -> bool:
    """Whether a student's column (P,) is one of magnitudes: nothing in it is negative where the solution is.

    So are plan values read off without their senses.
    """
    if asked.angle or asked.whole:
        return False
    floor = default_floor(asked)
    values = np.asarray(values, dtype=float)
    unsigned = bool(((asked.values < -floor) & (values > 0)).any())
    return unsigned and not (values < -floor).any()


def sides(asked: Asked, values: Array, magnitudes: bool = False) -> tuple[Array, Array]:
    """The solution's numbers and the student's as they are compared, both (P,)."""
    right = np.asarray(asked.values, dtype=float)
    if asked.angle:
        return right, nearest(right, values, full_turn(asked.unit))
    return (np.abs(right), np.abs(values)) if magnitudes else (right, values)


def full_turn(unit: str) -> float:
    """A full turn in the unit of an angle."""
    return 360.0 if unit == "deg" else 2 * np.pi


def nearest(right: Array, values: Array, turn: Array | float) -> Array:
    """The same angles, each by full turns as near as can be to the one that it is compared with."""
    with np.errstate(invalid="ignore"):
        return values - turn * np.round((values - right) / turn)


def difference(right: Array, mine: Array) -> Array:
    """The course's difference, %: positive where the student's number is the greater in magnitude.

    It is nan where the signs are opposite, 0 where both are 0.
    """
    a, g = right / 2, mine / 2  # halves, so that no sum of numbers overflows
    delta = np.asarray(200 * ((g - a) / (g + a)))
    delta[right == mine] = 0.0
    delta[_opposite(right, mine)] = np.nan
    return delta


def deviation(right: Array, mine: Array, limit: float, floor: Array | float) -> Array:
    """How far apart numbers are, in parts of what is allowed: up to 1 they agree. Shapes are broadcast.

    The same rule as `judge`'s in one number; nan where one is missing.
    """
    size, apart = np.abs(mine) + np.abs(right), np.abs(mine - right)
    allowed = np.maximum(limit / 200 * size, floor) * SLACK
    nothing = (np.abs(mine) <= floor * SLACK) & (np.abs(right) <= floor * SLACK)
    parts = np.where(apart == 0, 0.0, apart / np.where(allowed > 0, allowed, np.nan))
    return np.where(nothing, np.minimum(parts, 1.0), parts)


def _codes(right: Array, mine: Array, delta: Array, limit: float, floor: float) -> Array:
    """The rule of each cell, by its place in Rule, where both sides are numbers."""
    floor = floor * SLACK
    codes = np.full(right.shape, _OFF)
    codes[_opposite(right, mine)] = _SIGN
    codes[np.abs(mine - right) <= floor] = _FLOOR
    codes[np.maximum(np.abs(mine), np.abs(right)) <= floor] = _ZERO
    codes[(np.abs(delta) <= limit * SLACK) & (mine != 0)] = _LIMIT
    return codes


def _whole(right: Array, mine: Array) -> Array:
    return np.where(np.abs(mine - np.round(right)) <= 1e-9 * np.maximum(np.abs(right), 1.0), _EXACT, _OFF)


def _opposite(right: Array, mine: Array) -> Array:
    return np.sign(right) * np.sign(mine) < 0
