"""Quality of the mesh over the division of the shifts at one centre distance, and over the centre distance."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import cached_property
from typing import Any

import numpy as np

from tmm_report.chapters.gears.spur.given import Given, Quality
from tmm_report.chapters.gears.spur.solve.conditions import limits
from tmm_report.chapters.gears.spur.solve.motion import WIDEST
from tmm_report.chapters.gears.spur.solve.sizes import Teeth, choose_shifts
from tmm_report.mechanics.gears.limits.pair import unknown
from tmm_report.mechanics.gears.meshing import Pair
from tmm_report.mechanics.gears.quality import Allowed, allowed, specific_pressure
from tmm_report.mechanics.gears.shift_sharing import equal_sliding, with_first_shift
from tmm_report.problems import N_, Message, Problem, mistake
from tmm_report.records import dataclass

Array = Any
Both = tuple[Array, Array]

FEWEST = 5  # shifts of a table that chooses them itself
STEPS = (0.1, 0.05, 0.02, 0.01, 0.005, 0.002, 0.001)
DRAWN = 61  # points of the curves
FARTHEST = np.linspace(0.9, 1.3, 401)  # of the reference centre distance: where pairs are looked for


@dataclass(frozen=True, eq=False)
class Course:
    """Pairs in a row (P,), as one `pair` whose shifts, and centre distance, are arrays. `by`: how specific sliding is
    counted."""

    pair: Pair
    by: str

    def _counted(self, sliding: Array) -> Array:
        """What has no bound, and what no pair has, is nan."""
        own = np.where(np.isfinite(sliding), sliding, np.nan)
        with unknown():
            return {"own": own, "mate": own / (1 - own), "size": np.abs(own)}[self.by]

    @cached_property
    def root_sliding(self) -> Both:
        """At the lower points of the active profiles."""
        one, other = (self._counted(sliding) for sliding in self.pair.root_sliding)
        return one, other

    @cached_property
    def tip_sliding(self) -> Both:
        one, other = (self._counted(sliding) for sliding in self.pair.tip_sliding)
        return one, other

    @cached_property
    def tips(self) -> Both:
        """Thicknesses of the tips, modules; of helical teeth across them."""
        return self.pair.s_na[0] / self.pair.m, self.pair.s_na[1] / self.pair.m

    @cached_property
    def pressures(self) -> tuple[Array, Array, Array]:
        """γ at the pitch point, at the lower point and at the tip of wheel 1; nan where a profile has no radius."""
        p = self.pair
        found = [specific_pressure(p, rho[0]) for rho in (p.rho_w, p.rho_p, p.rho_u)]
        pole, low, high = (np.where(np.isfinite(x), x, np.nan) + 0 * p.x1 for x in found)
        return pole, low, high


@dataclass(frozen=True, eq=False)
class Found:
    """`stated`, `drawn`: over the shift of wheel 1, as it is tabulated and as curves; `alone`: what each limit allows
    of it; `ends`: what all of them allow, nothing where there is none; `equal`: the shift of equal sliding and its
    value, nan where there is none; `play`: the least distance of the active profiles from the fillets within the ends,
    m; `stated_over`, `drawn_over`: over the centre distance."""

    stated: Course
    drawn: Course
    alone: tuple[Allowed, ...]
    ends: tuple[float, float] | None
    at_ends: Course | None
    equal: float
    equal_sliding: float
    play: float
    stated_over: Course | None = None
    drawn_over: Course | None = None


def quality_of(given: Given, teeth: Teeth, pair: Pair) -> Found | None:
    """None where nothing is asked."""
    if (asked := given.quality) is None:
        return None
    pair = _usual_tips(given, pair)
    alone, ends = allowed(pair, asked.least_tip, asked.least_contact)
    stated = np.array(asked.x1 or _round(ends, float(pair.x1)))

    def course(x1: Array) -> Course:
        return Course(with_first_shift(pair, x1), asked.sliding)

    x_equal = equal_sliding(pair)
    equal = course(np.array([x_equal])).root_sliding[0][0] if math.isfinite(x_equal) else math.nan
    over = np.array(asked.centre_distances or ())
    return Found(
        course(stated),
        course(np.linspace(stated[0], stated[-1], DRAWN)),
        alone,
        ends,
        course(np.array(ends)) if ends else None,
        x_equal,
        float(equal),
        _play(pair, ends),
        *(Course(_over(given, teeth, a), asked.sliding) for a in (over, _between(over)) if over.size),
    )


def _usual_tips(given: Given, pair: Pair) -> Pair:
    """The pair with tips that follow from its shifts, where others are stated: those of one shift suit no other."""
    if pair.tips is None:
        return pair
    return replace(pair, tips=None, shortened=given.tip_shortening, trimmed=given.tip_shortening)


def _between(numbers: Array) -> Array:
    return np.linspace(numbers[0], numbers[-1], DRAWN) if numbers.size else numbers


def _round(ends: tuple[float, float] | None, chosen: float) -> list[float]:
    """Round shifts within the ends; where there are none, about the chosen one."""
    low, high = ends or (chosen - 0.25, chosen + 0.25)
    low, high = max(low, chosen - 2), min(high, chosen + 2)
    step = next((s for s in STEPS if math.floor(high / s) - math.ceil(low / s) >= FEWEST - 1), STEPS[-1])
    found = [round(k * step, 4) for k in range(math.ceil(low / step), math.floor(high / step) + 1)]
    return found if len(found) > 1 else [low, high]


def _play(pair: Pair, ends: tuple[float, float] | None) -> float:
    """The least distance along the line of action between the active profiles and where the involutes begin."""
    if ends is None:
        return math.nan
    low, high = (float(np.clip(end, -5, 5)) for end in ends)
    trial = with_first_shift(pair, np.linspace(low, high, DRAWN))
    return float(min(np.min(side) for side in trial.interference))


def _over(given: Given, teeth: Teeth, distances: Array) -> Pair:
    """The pairs at other centre distances: their shifts divided as those of the stage are; where both are stated, the
    first one is kept."""
    shift = (given.shift[0], math.nan) if isinstance(given.shift, tuple) and not given.rests else given.shift
    made = [
        choose_shifts(
            replace(given, centre_distance=float(a), teeth=teeth.z, shift=shift, tip_diameters=None), teeth
        )
        for a in distances
    ]
    x1, x2 = (np.array([float(getattr(one, key)) for one in made]) for key in ("x1", "x2"))
    return replace(made[0], x1=x1, x2=x2, a_w=distances)


# ---------------------------------------------------------------- what may be wrong


def mistakes_of(given: Given, teeth: Teeth, pair: Pair) -> Iterator[Problem]:
    """Every shift and centre distance at which there are no such wheels."""
    if given.quality is not None:
        yield from _wrong(given, given.quality, teeth, pair)


def _wrong(given: Given, asked: Quality, teeth: Teeth, pair: Pair) -> Iterator[Problem]:
    pair = _usual_tips(given, pair)
    yield from _unsorted("x1", asked.x1 or ())
    yield from _unsorted("centre_distances", asked.centre_distances or ())
    if asked.x1:
        text = N_("with the shift %(value)s of wheel %(wheel)s, the sum kept, there are no such wheels")
        right = N_("from %(low)s to %(high)s")
        trial = np.arange(-500, 501) / 100
        yield from _no_wheels(
            "x1",
            asked.x1,
            text,
            right,
            lambda x: with_first_shift(pair, x),
            trial,
            given.wheels[0],
            "{:g}".format,
        )
    if asked.centre_distances:
        text = N_("at a centre distance of %(value)s mm pair %(wheel)s cannot be made")
        right = N_("from %(low)s to %(high)s mm")
        trial = FARTHEST * float(pair.a)
        name = "-".join(given.wheels)
        yield from _no_wheels(
            "centre_distances", asked.centre_distances, text, right,
            lambda a: _over(given, teeth, np.atleast_1d(a)), trial, name, lambda a: f"{1e3 * a:.6g}",
        )  # fmt: skip


def _unsorted(key: str, numbers: tuple[float, ...]) -> Iterator[Problem]:
    for k in range(1, len(numbers)):
        if numbers[k] <= numbers[k - 1]:
            right = Message(N_("from the least to the greatest, each once"))
            yield mistake(N_("the numbers of the list must ascend"), ("quality", key, k), right)
            return


def _no_wheels(
    key: str, numbers: tuple[float, ...], text: str, right: str, made: Callable[[Array], Pair], trial: Array,
    wheel: str, form: Callable[[float], str],
) -> Iterator[Problem]:  # fmt: skip
    bad = np.flatnonzero(~_sound(made(np.array(numbers))))
    if not bad.size:
        return
    good = trial[_sound(made(trial))]
    for k in bad:
        cure = Message(N_("other numbers of teeth"))
        if good.size:
            cure = Message(right, {"low": form(float(good[0])), "high": form(float(good[-1]))})
        yield mistake(text, ("quality", key, int(k)), cure, value=form(numbers[k]), wheel=wheel)


def _sound(pair: Pair) -> Array:
    """Whether there are such wheels, (P,)."""
    with unknown():
        margins = [limit.margin(pair) + 0 * pair.x1 for limit in limits(pair, WIDEST) if limit.hard]
        return np.all([margin >= 0 for margin in margins], axis=0) & np.isfinite(pair.x1)
