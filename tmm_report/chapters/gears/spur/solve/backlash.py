"""Backlash of a pair and the limits of the sizes by which its wheels are measured, from what the assignment states."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from functools import cached_property
from typing import Any

import numpy as np

from tmm_report.chapters.gears.spur.given import Backlash, Given
from tmm_report.chapters.gears.spur.solve.inspection import Measured
from tmm_report.mechanics.gears.backlash import Loose, closest, thinning_for
from tmm_report.mechanics.gears.inspection import Gauged
from tmm_report.mechanics.gears.meshing import Pair
from tmm_report.problems import N_, Message, Problem, mistake
from tmm_report.records import dataclass

Both = tuple[float, float]
SIZES = ("s", "W", "s_c", "s_y", "M")  # what is measured, in the order of the table
THINNEST = 0.25  # modules: of the teeth, what thinning takes away at most


@dataclass(frozen=True)
class Limit:
    """A measured size of wheel `i` without thinning, and with the least and the greatest; nan where it is not there or
    does not fit."""

    i: int
    size: str
    nominal: float
    least: float
    most: float


@dataclass(frozen=True, eq=False)
class Found:
    """`least`, `most`: thinning of both wheels along the pitch circles across the teeth, None where nothing states it;
    `asked`: whether it is what the guaranteed backlash asks for; `close`, `far`: the pair with the least and with the
    greatest backlash."""

    stated: Backlash
    pair: Pair
    inspected: tuple[Measured, Measured]
    least: Both | None
    most: Both | None
    asked: bool

    @property
    def single(self) -> bool:
        """Whether there is one backlash alone, without limits."""
        return not self.stated.axes and self.least == self.most

    @cached_property
    def close(self) -> Loose:
        return Loose(self.pair, closest(self.pair, self.stated.axes or 0.0), sum(self.least or (0.0, 0.0)))

    @cached_property
    def far(self) -> Loose:
        return Loose(self.pair, closest(self.pair, -(self.stated.axes or 0.0)), sum(self.most or (0.0, 0.0)))

    @property
    def known(self) -> bool:
        """Whether anything gives the pair a backlash."""
        return self.least is not None or bool(self.stated.axes)

    @property
    def jams(self) -> bool:
        """Whether the teeth would overlap at a limit of the centre distance."""
        return self.known and self.close.normal < -1e-9 * self.pair.m

    @property
    def enough(self) -> bool | None:
        """Whether the least backlash is what must be guaranteed; None where nothing states that."""
        wanted = self.stated.guaranteed
        return None if wanted is None or not self.known else self.close.normal >= wanted * (1 - 1e-9)

    @cached_property
    def limits(self) -> tuple[Limit, ...]:
        """Of every size that the wheels can be measured by."""
        if self.least is None or self.most is None:
            return ()
        return tuple(
            limit for of in self.inspected for limit in self._limits(of) if math.isfinite(limit.nominal)
        )

    def _limits(self, of: Measured) -> Iterator[Limit]:
        assert self.least is not None and self.most is not None
        i = of.gauge.i
        thinned = [sizes(of, by) for by in (0.0, self.least[i], self.most[i])]
        for key in SIZES:
            yield Limit(i, key, *(one[key] for one in thinned))


def sizes(of: Measured, thinned: float) -> dict[str, float]:
    """What a wheel measures when its teeth are thinned: chords where a caliper set to the nominal heights stands."""
    plain = of.gauge
    cut = replace(plain, thinned=thinned)
    found = {"s": cut.s * math.cos(cut.pair.beta)}
    found["W"] = float(cut.span(of.span)) if of.span is not None else math.nan
    found["s_c"] = _below(plain, cut, plain.constant_chord) if of.has_constant_chord else math.nan
    nowhere = of.circle is None or plain.pointed
    found["s_y"] = math.nan if nowhere else _below(plain, cut, plain.chord(of.circle))
    with np.errstate(invalid="ignore"):
        fits = of.pin is not None and bool(cut.pin_fits(of.pin))
    found["M"] = float(cut.over(of.pin)) if fits else math.nan
    return found


def _below(plain: Gauged, cut: Gauged, chord: tuple[Any, Any]) -> float:
    return float(chord[0]) if cut.thinned == 0 else cut.chord_below(float(chord[1]))


def backlash_of(given: Given, pair: Pair, inspected: tuple[Measured, Measured]) -> Found | None:
    """None where nothing is asked."""
    if (stated := given.backlash) is None:
        return None
    thin, wide = stated.of_both("thinning"), stated.of_both("tolerance")
    asked = thin is None and stated.guaranteed is not None
    least = _thicknesses(stated, pair, thin)
    if asked:
        a_w = closest(pair, stated.axes or 0.0)
        each = thinning_for(pair, a_w, float(stated.guaranteed or 0.0)) / 2
        least = each, each
    field = _thicknesses(stated, pair, wide) or (0.0, 0.0)
    most = None if least is None else (least[0] + field[0], least[1] + field[1])
    return Found(stated, pair, inspected, least, most, asked)


def _thicknesses(stated: Backlash, pair: Pair, both: Both | None) -> Both | None:
    """Of the teeth, what is stated of the shift of the rack or of the span."""
    if both is None:
        return None
    alpha = pair.rack.alpha
    turned = {"thickness": 1.0, "rack": 2 * math.tan(alpha), "span": 1 / math.cos(alpha)}[stated.by]
    return both[0] * turned, both[1] * turned


# ---------------------------------------------------------------- what may be wrong


def mistakes_of(given: Given, pair: Pair) -> Iterator[Problem]:
    """Where the block states nothing, or more than the teeth can lose."""
    if given.backlash is not None:
        yield from _wrong(given, given.backlash, pair)


def _wrong(given: Given, stated: Backlash, pair: Pair) -> Iterator[Problem]:
    thin = _thicknesses(stated, pair, stated.of_both("thinning"))
    wide = _thicknesses(stated, pair, stated.of_both("tolerance"))
    if wide and not thin and stated.guaranteed is None:
        right = Message(N_("state thinning: [0.06 mm, 0.09 mm], or guaranteed: 0.12 mm"))
        yield mistake(N_("a tolerance alone says nothing of the backlash"), ("backlash", "tolerance"), right)
    if stated.by == "span" and pair.internal and pair.beta:
        right = Message(N_("by: thickness, or by: rack"))
        yield mistake(N_("inside a helical ring there is no span to be measured"), ("backlash", "by"), right)
    for i in (0, 1):
        lost = sum(both[i] for both in (thin, wide) if both)
        if lost > THINNEST * pair.m:
            wrong = N_(
                "the teeth of wheel %(wheel)s would be thinner by %(lost)s mm, more than a quarter of the module"
            )
            key = "thinning" if thin and thin[i] > THINNEST * pair.m / 2 else "tolerance"
            right = Message(N_("hundredths of a millimetre, as 0.06 mm"))
            yield mistake(wrong, ("backlash", key), right, wheel=given.wheels[i], lost=f"{1e3 * lost:.4g}")
            if not isinstance(getattr(stated, key), tuple):  # one number for both
                break
    if (stated.axes or 0.0) > THINNEST * pair.m:
        right = Message(N_("hundredths of a millimetre, as 0.06 mm"))
        wrong = N_("a centre distance that may differ by %(axes)s mm, more than a quarter of the module")
        yield mistake(wrong, ("backlash", "axes"), right, axes=f"{1e3 * float(stated.axes or 0):.4g}")
    if (stated.guaranteed or 0.0) > THINNEST * pair.m:
        right = Message(N_("hundredths of a millimetre, as 0.06 mm"))
        wrong = N_("a backlash of %(backlash)s mm, more than a quarter of the module")
        yield mistake(
            wrong, ("backlash", "guaranteed"), right, backlash=f"{1e3 * float(stated.guaranteed or 0):.4g}"
        )
