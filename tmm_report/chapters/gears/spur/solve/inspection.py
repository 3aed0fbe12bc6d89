"""By what each wheel is measured: stated, or what the rules of GOST 16532 and 19274 take, where that fits the teeth."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from functools import cached_property
from typing import Any

import numpy as np

from tmm_report.chapters.gears.spur.given import Given, Inspection
from tmm_report.mechanics.gears.inspection import Gauged
from tmm_report.mechanics.gears.meshing import Pair
from tmm_report.problems import N_, Message, Problem, mistake
from tmm_report.records import dataclass

Array = Any
PIN = 1.7  # modules
TRIED = np.arange(20, 501) / 100  # diameters of pins, modules
NARROW, HELICAL_RING = "narrow", "helical ring"  # why a wheel has no span


@dataclass(frozen=True, eq=False)
class Measured:
    """Wheel `i` of a pair with what it is measured by; None: it cannot be."""

    given: Given
    gauge: Gauged

    def _stated(self, key: str) -> Any:
        both = getattr(self.given.inspection, key, None)
        return None if both is None else both[self.gauge.i]

    # ------------------------------------------------------------ span

    @cached_property
    def span(self) -> int | None:
        """Number of teeth: by the rule, rounded, or the nearest with which the span touches active profiles, and both
        of them on the face of helical teeth."""
        if (stated := self._stated("span")) is not None:
            return int(stated)
        fitting = self.gauge.spans(self.gauge.active)
        if not fitting.size:
            return None
        rule = self.gauge.rule
        return int(fitting[np.argmin(np.abs(fitting - rule))] if math.isfinite(rule) else fitting[0])

    @property
    def why_no_span(self) -> str:
        """NARROW, HELICAL_RING, or "" where no number of teeth fits."""
        if not self.gauge.spannable:
            return HELICAL_RING
        return NARROW if self.gauge.spans(self.gauge.active, narrow=False).size else ""

    @property
    def moved(self) -> bool:
        """Whether the number of teeth is not the rounded one of the rule."""
        rule = self.gauge.rule
        return self.span is not None and not (math.isfinite(rule) and abs(self.span - rule) <= 0.5 + 1e-9)

    # ------------------------------------------------------------ chords

    @cached_property
    def circle(self) -> float | None:
        """Diameter of the chordal thickness: the pitch circle, or one half way up where that is off the involute."""
        if (stated := self._stated("chords")) is not None:
            return float(stated)
        g = self.gauge
        low, high = self.circles
        half_way = g.of("d") + 2 * g.shift * g.pair.m
        return next((d for d in (g.of("d"), half_way) if low <= d <= high), None)

    @property
    def circles(self) -> tuple[float, float]:
        """Diameters between which the flanks are involutes."""
        low, high = (float(self.gauge.at(rho)) for rho in self.gauge.involute)
        return low, high

    @property
    def has_constant_chord(self) -> bool:
        low, high = self.gauge.involute
        return low < self.gauge.chord_touches < high and not self.gauge.pointed

    # ------------------------------------------------------------ pins

    @cached_property
    def pin(self) -> float | None:
        """Diameter: 1.7 modules, or the nearest that fits."""
        if (stated := self._stated("pins")) is not None:
            return float(stated)
        usual = PIN * self.gauge.pair.m
        if self.gauge.pin_fits(usual):
            return usual
        fitting = self.pins
        return float(fitting[np.argmin(np.abs(fitting - usual))]) if fitting.size else None

    @property
    def pins(self) -> Array:
        """Diameters that fit, of those tried."""
        tried = TRIED * self.gauge.pair.m
        with np.errstate(invalid="ignore"):
            return tried[self.gauge.pin_fits(tried)]


def measured(given: Given, pair: Pair) -> tuple[Measured, Measured]:
    one, two = (Measured(given, Gauged(pair, i, given.width)) for i in (0, 1))
    return one, two


def mistakes_of(given: Given, pair: Pair) -> Iterator[Problem]:
    """All that is stated and does not fit the teeth, and what would."""
    if given.inspection is not None:
        for of in measured(given, pair):
            yield from _wrong(given, given.inspection, of)


def _wrong(given: Given, stated: Inspection, of: Measured) -> Iterator[Problem]:
    g = of.gauge
    wheel = given.wheels[g.i]
    if stated.span and stated.span[g.i] not in g.spans(g.involute):
        yield _wrong_span(of, wheel, stated.span[g.i])
    if stated.chords and not of.circles[0] <= stated.chords[g.i] <= of.circles[1]:
        text = N_("the circle of %(diameter)s mm does not cut the involutes of wheel %(wheel)s")
        right = _from(*of.circles, N_("a diameter from %(low)s to %(high)s mm"))
        yield mistake(text, _path("chords", g.i), right, diameter=_mm(stated.chords[g.i]), wheel=wheel)
    if stated.pins and not g.pin_fits(stated.pins[g.i]):
        text = N_(
            "pins of %(diameter)s mm do not lie between the teeth of wheel %(wheel)s so that they touch the involutes "
            "and stand out of the tips"
        )
        fitting = of.pins
        right = Message(N_("leave out pins: no pin fits"))
        if fitting.size:
            right = _from(fitting[0], fitting[-1], N_("a diameter from %(low)s to %(high)s mm"))
        yield mistake(text, _path("pins", g.i), right, diameter=_mm(stated.pins[g.i]), wheel=wheel)


def _wrong_span(of: Measured, wheel: str, count: int) -> Problem:
    g, where = of.gauge, _path("span", of.gauge.i)
    right = Message(N_("leave out span: no number of teeth fits"))
    if not g.spannable:
        text = N_("inside the helical ring %(wheel)s there is no span to be measured")
        return mistake(text, where, right, wheel=wheel)
    if (fitting := g.spans(g.involute)).size:
        right = _from(fitting[0], fitting[-1], N_("from %(low)s to %(high)s teeth"), "{:d}".format)
    text = N_("a span over %(count)s teeth of wheel %(wheel)s does not touch their involutes")
    if count in g.spans(g.involute, narrow=False):
        text = N_(
            "a span over %(count)s teeth of wheel %(wheel)s is too long for the face width of its helical teeth"
        )
    return mistake(text, where, right, count=count, wheel=wheel)


def _path(key: str, i: int) -> tuple[str | int, ...]:
    return ("inspection", key, i)


def _from(low: float, high: float, text: str, form: Callable[[Any], str] | None = None) -> Message:
    """The range, in mm rounded inwards, or as `form` writes its ends."""
    if form is not None:
        return Message(text, {"low": form(int(low)), "high": form(int(high))})
    inwards = math.ceil(1e5 * low - 1e-6) / 1e5, math.floor(1e5 * high + 1e-6) / 1e5
    return Message(text, {"low": _mm(inwards[0]), "high": _mm(inwards[1])})


def _mm(length: float) -> str:
    return f"{1e3 * length:.6g}"
