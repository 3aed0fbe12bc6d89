"""Spur stage of a drive: teeth, shifts, dimensions and quality of one pair of wheels, with every condition's margin.

From the centre distance, the module and the ratio to the shifts, or from the shifts to the centre distance; external
and internal pairs, straight and helical teeth. Artobolevsky, Theory of mechanisms and machines, ch. 22.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, Literal

import numpy as np

from tmm_report.chapters.spur.mistakes import check, check_pair, check_teeth, involute_start
from tmm_report.mechanics import shifts, spur, trains
from tmm_report.mechanics.spur import Pair, Rack

Array = Any
Rule = Literal["rule", "limit", "equal sliding"]
EQUAL: Rule = "equal sliding"
STANDARD = Rack()

CONTACT = 1.05  # least contact ratio
POINTING = 0.3  # least thickness of the tips, modules
SLIDING = 6.0  # largest specific sliding: 3 for fast drives, up to 6 for slow ones
SPARE = 2.0  # the sum of teeth may be this much below its bound
EXACT = 1e-9  # relative: a margin of rounding is none
ROUNDED = 1.5e-3  # shifts written with three decimals fill the distance


@dataclass(frozen=True, eq=False)
class Given:
    """What a spur stage states; lengths in m, `helix` in rad.

    `ratio`: ω1/ω2, negative for an external pair. `teeth` None: found from the centre distance; that None: found from
    the shifts. `shift`: how the sum of shifts is divided, or both. `wheels`: their numbers in the drive, the driving
    one first.
    """

    ratio: float
    module: float
    centre_distance: float | None = None
    teeth: tuple[int, int] | None = None
    wheels: tuple[str, str] = ("1", "2")
    rack: Rack = STANDARD
    helix: float = 0.0
    width: float | None = None
    shift: Rule | tuple[float, float] = "rule"
    shortened: bool = True
    efficiency: float = 0.98
    name: str = ""

    @property
    def internal(self) -> bool:
        return self.ratio > 0


@dataclass(frozen=True)
class Teeth:
    """Numbers of teeth. `bound`: of their sum (internal: difference), 2 a_w cos β/m; `share`: the part of the smaller
    wheel before rounding. None without a given centre distance."""

    z: tuple[int, int]
    bound: float | None = None
    share: float | None = None

    @property
    def small(self) -> int:
        """Which wheel is the smaller: 0 or 1."""
        return int(self.z[1] < self.z[0])


@dataclass(frozen=True)
class Condition:
    """A condition of a sound pair: `value` must be no less than `limit`, or no greater where not `least`.

    `key`: undercut, pointing, contact, interference, fouling, sliding; `wheel`: its number, "" for the pair. Shifts and
    ratios are pure numbers, lengths m, angles rad.
    """

    key: str
    wheel: str
    value: float
    limit: float
    unit: str = ""
    least: bool = True

    @property
    def margin(self) -> float:
        """What is in hand; negative where the condition fails."""
        return self.value - self.limit if self.least else self.limit - self.value

    @property
    def met(self) -> bool:
        return self.margin >= -EXACT * max(abs(self.limit), 1e-3)


@dataclass(frozen=True, eq=False)
class Found:
    """Found by `solve`. `pair`: all dimensions; `conditions`: in the order of the note."""

    given: Given
    teeth: Teeth
    pair: Pair
    conditions: tuple[Condition, ...]

    fixed: tuple[str, ...] = ()  # members that stand still, and a second input: none in this stage
    second: None = None

    @property
    def name(self) -> str:
        return self.given.name or "-".join(self.given.wheels)

    @property
    def input(self) -> str:
        return self.given.wheels[0]

    @property
    def output(self) -> str:
        return self.given.wheels[1]

    @property
    def wanted(self) -> float:
        """The ratio that the assignment asks for."""
        return self.given.ratio

    @property
    def ratio(self) -> float:
        """ω_in/ω_out with the chosen teeth."""
        return float(self.pair.ratio)

    @property
    def efficiency(self) -> float:
        return self.given.efficiency

    @property
    def members(self) -> tuple[trains.Member, ...]:
        radii, places = self.pair.d_w, (0.0, float(self.pair.a_w))
        return tuple(
            trains.Member(name, "wheel" if sign > 0 else "ring", z, float(d) / 2, place)
            for name, sign, z, d, place in zip(
                self.given.wheels, self.pair.signs, self.teeth.z, radii, places, strict=True
            )
        )

    @property
    def meshes(self) -> tuple[trains.Mesh, ...]:
        return (
            trains.Mesh(*self.given.wheels, internal=self.given.internal, efficiency=self.given.efficiency),
        )

    @property
    def failed(self) -> tuple[Condition, ...]:
        return tuple(condition for condition in self.conditions if not condition.met)

    @cached_property
    def rule_shifts(self) -> tuple[float, float]:
        """Least shifts by the course's rule (17 − z)/17."""
        return tuple(float(shifts.rule_shift(z, self.pair.rack, self.pair.beta)) for z in self.teeth.z)  # type: ignore[return-value]

    @cached_property
    def points(self) -> dict[str, float]:
        """Radii of curvature of wheel 1, m, at the points of the line of action in the order of their passing.

        A, B: ends of the active part; D, C: one base pitch from them; P: the pitch point. Between A and C, D and B two
        pairs of teeth are in mesh, where the contact ratio is over 1.
        """
        p = self.pair
        begin, end, way = float(p.rho_p[0]), float(p.rho_a[0]), float(p.p_b) * float(p.signs[0])
        places = {"A": begin, "C": end - way, "P": float(p.rho_w[0]), "D": begin + way, "B": end}
        return {name: places[name] for name in "ACPDB"}

    def sliding(self, count: int = 121) -> spur.Sliding:
        """Specific sliding at `count` places over the whole active part of the line of action."""
        return self.pair.sliding(np.linspace(self.points["A"], self.points["B"], count))

    @cached_property
    def involute_starts(self) -> tuple[float, float]:
        """Radii of curvature where the involutes begin, m: above the fillet, or where an undercut has eaten them."""
        starts = [involute_start(self.pair, i) for i in (0, 1)]
        return tuple(math.inf if start is None else start for start in starts)  # type: ignore[return-value]


def solve(given: Given) -> Found:
    """Raises ProblemError with every mistake and what would work."""
    check(given)
    chosen = choose_teeth(given)
    check_teeth(given, chosen)
    pair = _pair(given, chosen)
    check_pair(given, pair)
    found = Found(given, chosen, pair, ())
    return replace(found, conditions=tuple(_conditions(found)))


# ---------------------------------------------------------------- teeth


def bound_of(given: Given) -> float:
    """2 a_w cos β/m: the sum (internal: difference) of teeth that unshifted wheels would have at the distance."""
    return 2 * (given.centre_distance or 0.0) * math.cos(given.helix) / given.module


def choose_teeth(given: Given) -> Teeth:
    """The given teeth; else the smaller wheel's share of the bound rounded down, the larger by the ratio.

    The larger is changed, and the ratio with it, as far as is needed for the sum to be less than 2 under its bound.
    """
    large = max(abs(given.ratio), 1 / abs(given.ratio))  # ratio of the larger to the smaller
    if given.centre_distance is None:
        return Teeth(given.teeth or (0, 0))
    bound = bound_of(given)
    share = bound / (large - 1 if given.internal else large + 1)
    if given.teeth is not None:
        return Teeth(given.teeth, bound, share)
    small = math.floor(share * (1 + EXACT))
    sign = -1 if given.internal else 1
    most = math.floor(bound * (1 + EXACT) - sign * small)
    least = math.ceil(bound * (1 - EXACT) - SPARE - sign * small)
    big = min(max(round(large * small), least), most)
    return Teeth((small, big) if abs(given.ratio) >= 1 else (big, small), bound, share)


# ---------------------------------------------------------------- shifts


def _pair(given: Given, chosen: Teeth) -> Pair:
    stated = given.shift if isinstance(given.shift, tuple) else None
    x1, x2 = stated or _own_shifts(given, chosen)
    settings = (*chosen.z, given.module, given.rack, given.helix)
    if given.centre_distance is None:
        pair = spur.meshed(*settings, x1, x2, given.internal, given.shortened)
        return shifts.with_first_shift(pair, shifts.equal_sliding(pair)) if given.shift == EQUAL else pair
    needed = spur.shift_sum(*settings, given.centre_distance, given.internal)
    pair = Pair(*settings, x1, x2, given.centre_distance, given.internal, given.shortened)
    if stated:
        # shifts written with a few digits are meant to fill the distance
        return shifts.filling(pair, 0, x1, needed) if abs(pair.x_sum - needed) <= ROUNDED else pair
    pair = shifts.filling(pair, chosen.small, (x1, x2)[chosen.small], needed)
    return shifts.with_first_shift(pair, shifts.equal_sliding(pair)) if given.shift == EQUAL else pair


def _own_shifts(given: Given, chosen: Teeth) -> tuple[float, float]:
    """What each external wheel needs of its own; a ring is shifted as its pinion."""
    own = tuple(_least(given, z) for z in chosen.z)
    return (own[chosen.small], own[chosen.small]) if given.internal else (own[0], own[1])


def _least(given: Given, z: int) -> float:
    if given.shift == "limit":
        return max(float(spur.least_shift(z, given.rack, given.helix)), 0.0)
    return float(shifts.rule_shift(z, given.rack, given.helix))


# ---------------------------------------------------------------- conditions


def _conditions(found: Found) -> Iterator[Condition]:
    pair, names = found.pair, found.given.wheels
    wheels = [i for i in (0, 1) if pair.signs[i] > 0]
    for i in wheels:
        yield Condition("undercut", names[i], float([pair.x1, pair.x2][i]), float(pair.x_min[i]))
    for i in (0, 1):
        yield Condition("pointing", names[i], float(pair.s_na[i]), POINTING * pair.m, "mm")
    yield Condition("contact", "", float(pair.eps), CONTACT)
    for i in (0, 1):
        start = found.involute_starts[i]
        yield Condition(
            "interference", names[i], float(pair.rho_p[i]), start, "mm", least=bool(pair.signs[i] > 0)
        )
    if pair.internal:
        yield Condition("fouling", "", float(pair.fouling), 0.0, "deg")
    for i in (0, 1):
        yield Condition("sliding", names[i], abs(float(pair.root_sliding[i])), SLIDING, least=False)
