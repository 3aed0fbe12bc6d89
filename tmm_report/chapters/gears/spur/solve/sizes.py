"""Numbers of teeth and shifts of a spur stage: those given, or those that the ratio and the distance ask for."""

from __future__ import annotations

import math
from dataclasses import replace

from tmm_report.chapters.gears.spur.given import EQUAL, Given
from tmm_report.mechanics.gears import meshing, shift_sharing
from tmm_report.mechanics.gears.limits.condition import EXACT
from tmm_report.mechanics.gears.meshing import Pair
from tmm_report.records import dataclass

SPARE = 2.0  # the sum of teeth may be this much below its bound
ROUNDED = 1.5e-3  # shifts written with three decimals fill the distance


@dataclass(frozen=True)
class Choice:
    """How numbers of teeth are found from the centre distance. `u`: wanted ratio of the larger number to the smaller.

    `bound`: of their sum (internal: difference), 2 a_w cos β/m; `share`: the part of the smaller wheel before rounding;
    `larger`: u times its number, before rounding; `spare`: what the numbers taken leave of the bound.
    """

    u: float
    bound: float
    share: float
    larger: float
    spare: float


@dataclass(frozen=True)
class Teeth:
    """Numbers of teeth; `choice` None: they were given."""

    z: tuple[int, int]
    choice: Choice | None = None

    @property
    def small(self) -> int:
        """Which wheel is the smaller: 0 or 1."""
        return int(self.z[1] < self.z[0])


def bound_of(given: Given) -> float:
    """2 a_w cos β/m: the sum (internal: difference) of teeth that unshifted wheels would have at the distance."""
    return 2 * (given.centre_distance or 0.0) * math.cos(given.helix) / given.module


def choose_teeth(given: Given) -> Teeth:
    """The given teeth; else the smaller wheel's share of the bound rounded down, the larger by the ratio.

    The larger is changed, and the ratio with it, as far as is needed for the sum to be less than 2 under its bound.
    """
    if given.teeth is not None or given.centre_distance is None:
        return Teeth(given.teeth or (0, 0))
    large = max(abs(given.ratio), 1 / abs(given.ratio))  # ratio of the larger to the smaller
    bound, sign = bound_of(given), -1 if given.internal else 1
    share = bound / (large + sign)
    small = math.floor(share * (1 + EXACT))
    most = math.floor(bound * (1 + EXACT) - sign * small)
    least = math.ceil(bound * (1 - EXACT) - SPARE - sign * small)
    big = min(max(round(large * small), least), most)
    choice = Choice(large, bound, share, large * small, bound - sign * small - big)
    return Teeth((small, big) if abs(given.ratio) >= 1 else (big, small), choice)


def choose_shifts(given: Given, chosen: Teeth) -> Pair:
    """The pair with the given shifts, or with those that its distance and the rule of division ask for."""
    stated = given.shift if isinstance(given.shift, tuple) else None
    left = 1 - given.rests[0] if given.rests else chosen.small  # whose shift comes first
    x1, x2 = stated or _own_shifts(given, chosen)
    settings = (*chosen.z, given.module, given.rack, given.helix)
    cut = given.tip_shortening and given.tip_diameters is None
    made = (given.internal, cut, cut, given.cutter)
    if given.centre_distance is None:
        pair = replace(meshing.meshed(*settings, x1, x2, *made), tips=given.tip_diameters)
        return (
            shift_sharing.with_first_shift(pair, shift_sharing.equal_sliding(pair))
            if given.shift == EQUAL
            else pair
        )
    needed = meshing.shift_sum(*settings, given.centre_distance, given.internal)
    pair = Pair(*settings, x1, x2, given.centre_distance, *made, given.tip_diameters)
    if stated and not given.rests:
        # shifts written with a few digits are meant to fill the distance
        return shift_sharing.filling(pair, 0, x1, needed) if abs(pair.x_sum - needed) <= ROUNDED else pair
    pair = shift_sharing.filling(pair, left, (x1, x2)[left], needed)
    return (
        shift_sharing.with_first_shift(pair, shift_sharing.equal_sliding(pair))
        if given.shift == EQUAL
        else pair
    )


def _own_shifts(given: Given, chosen: Teeth) -> tuple[float, float]:
    """What each external wheel needs of its own; a ring is shifted as its pinion."""
    own = tuple(_least(given, z) for z in chosen.z)
    return (own[chosen.small], own[chosen.small]) if given.internal else (own[0], own[1])


def _least(given: Given, z: int) -> float:
    if given.shift == "limit":
        return max(float(_exact_least(given, z)), 0.0)
    return float(shift_sharing.rule_shift(z, given.rack, given.helix))


def _exact_least(given: Given, z: int) -> float:
    """Least shift without undercut of an external wheel, by the tool that cuts it."""
    blank = meshing.meshed(z, z, given.module, given.rack, given.helix, cutter=given.cutter)
    return float(blank.x_min[0] if not given.internal else meshing.least_shift(z, given.rack, given.helix))
