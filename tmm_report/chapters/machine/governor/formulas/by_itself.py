"""Formulas of the centrifugal governor: in symbols, in numbers, with their value, at the middle of the lift."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import reduce
from operator import add

import numpy as np

from tmm_report.chapters.machine.governor.solve.by_itself import DirectFound
from tmm_report.mechanics.machine.governor.equilibrium import Arms, BellCrank
from tmm_report.quantity.formula import Expr, Formula, Function, Number, cos, expr, sin, sqrt, tan
from tmm_report.quantity.model import Book

ANGLES = ("alpha", "beta", "gamma", "theta")


def arcsin(argument: Expr) -> Expr:
    return Function("arcsin", expr(argument), np.arcsin)


class DirectFormulas:
    """`row`: the place of the table that is written out."""

    def __init__(self, found: DirectFound, book: Book):
        self.direct, self.book, self.row = found, book, found.middle
        self.places = book.tables["governor_equilibrium"]

    def var(self, key: str) -> Expr:
        """A single number of the governor; an angle in degrees."""
        of = self.book[f"governor_{key}"]
        return of.var("deg" if of.unit == "rad" else "")

    def at(self, key: str, row: int | None = None) -> Expr:
        """A number of the table."""
        return self.places.var(key, self.row if row is None else row, "deg" if key in ANGLES else "")

    def _of(self, key: str, expression: Expr) -> Formula:
        return self.places.formula(key, self.row, expression, "deg" if key in ANGLES else "")

    def _value(self, key: str, expression: Expr) -> Formula:
        return self.book[f"governor_{key}"].formula(expression)

    # ------------------------------------------------------------ the mechanism

    def mechanism(self) -> list[Formula]:
        """From the lift to r, r' and y'."""
        geometry = self.direct.given.geometry
        return list(self._crank(geometry) if isinstance(geometry, BellCrank) else self._arms(geometry))

    def _off(self, arm: str) -> Expr:
        """The pin's distance from a pivot, across the axis."""
        arms = self.direct.given.geometry
        assert isinstance(arms, Arms)
        offset = arms.upper_offset if arm == "1" else arms.lower_offset
        return self.at("x") - self.var(f"e_{arm}") if offset else self.at("x")

    def _arms(self, arms: Arms) -> Iterator[Formula]:
        one, two = (sqrt(self.var(f"l_{arm}") ** 2 - self._off(arm) ** 2) for arm in "12")
        yield self._of("H", one + two)
        yield self._of("alpha", arcsin(self._off("1") / self.var("l_1")))
        yield self._of("beta", arcsin(self._off("2") / self.var("l_2")))
        yield self._of("dx", Number(1) / (tan(self.at("alpha")) + tan(self.at("beta"))))
        if arms.distance is not None:
            yield from self._on_upper(arms)
        elif arms.extension is not None:
            yield from self._on_lower()
        else:
            yield self._of("r", self.at("x"))
            yield self._of("dr", self.at("dx"))
            yield self._of("dy", self.at("dr") * tan(self.at("alpha")))

    def _on_upper(self, arms: Arms) -> Iterator[Formula]:
        across = self.var("L") * sin(self.at("alpha"))
        yield self._of("r", self.var("e_1") + across if arms.upper_offset else across)
        yield self._of("dr", self.at("dx") * self.var("L") / self.var("l_1"))
        yield self._of("dy", self.at("dr") * tan(self.at("alpha")))

    def _on_lower(self) -> Iterator[Formula]:
        turned = self.var("b") / (self.var("l_2") * cos(self.at("beta")))
        gamma = self.at("gamma")
        yield self._of("gamma", self.at("beta") - self.var("beta_0"))
        yield self._of("r", self.at("x") + self.var("b") * sin(gamma))
        yield self._of("dr", self.at("dx") * (Number(1) + turned * cos(gamma)))
        yield self._of("dy", self.at("dx") * (tan(self.at("alpha")) - turned * sin(gamma)))

    def _crank(self, crank: BellCrank) -> Iterator[Formula]:
        ratio = self.var("a") / self.var("b")
        yield self._of("r", self.var("r_min") + ratio * self.at("z"))
        yield self._of("dr", ratio)
        if not crank.level:
            yield self._of("theta", arcsin((self.at("r") - self.var("r_0")) / self.var("a")))
            yield self._of("dy", -(self.at("dr") * tan(self.at("theta"))))

    # ------------------------------------------------------------ equilibrium

    def inertial(self) -> Formula:
        return self._of("A", self._balls() * self.at("r") * self.at("dr"))

    def supporting(self) -> Formula:
        return self._of("E", added(self._held(self.row)))

    def _balls(self) -> Expr:
        return self.var("n") * self.var("m")

    def _held(self, row: int, balls: bool = True, sleeve: bool = True, spring: bool = True) -> Iterator[Expr]:
        """The parts of the supporting force that are not nought."""
        weights = self.direct.weights
        if balls and np.any(self.direct.table.balls.dh):
            yield self._balls() * self.var("g") * self.at("dy", row)
        if sleeve and weights.sleeve:
            yield self.var("m_0") * self.var("g")
        if spring and weights.preload:
            yield self.var("F_0")
        if spring and weights.stiffness:
            yield self.var("c") * self.at("z", row)

    def speed(self) -> Formula:
        return self._of("omega_g", sqrt(self.at("E") / self.at("A")))

    def controlling(self) -> Formula:
        return self._of("C", self.var("m") * self.at("omega_g") ** 2 * self.at("r"))

    # ------------------------------------------------------------ choice

    def choice(self) -> list[Formula]:
        """What was not stated."""
        choice = self.direct.given.choice
        if choice is None:
            return []
        if choice.what == "spring":
            ends = [
                self._value("F_0", self._spring(0, "omega_0")),
                self._value("spring_top", self._spring(len(self.places) - 1, "omega_h")),
            ]
            return [*ends, self._value("c", (self.var("spring_top") - self.var("F_0")) / self.var("h"))]
        squared = self.var("omega_chosen") ** 2
        if choice.what == "balls":
            lifted = self.at("r") * self.at("dr") * squared
            if np.any(self.direct.table.balls.dh):
                lifted = lifted - self.var("g") * self.at("dy")
            return [self._value("m", added(self._held(self.row, balls=False)) / (self.var("n") * lifted))]
        rest = taken(self.at("A") * squared, self._held(self.row, sleeve=False))
        return [self._value("m_0", rest / self.var("g"))]

    def _spring(self, row: int, speed: str) -> Expr:
        """What the spring presses with at an end of the lift."""
        lifted = self._balls() * self.at("r", row) * self.at("dr", row) * self.var(speed) ** 2
        return taken(lifted, self._held(row, spring=False))

    # ------------------------------------------------------------ figures of merit

    def nonuniformity(self) -> Formula:
        low, high = self.var("omega_0"), self.var("omega_h")
        return self._value("delta", Number(2) * (high - low) / (high + low))

    def stability(self) -> Formula:
        return self._of("S", self.at("dE") - self.at("omega_g") ** 2 * self.at("dA"))

    def band(self) -> list[Formula]:
        friction = self.var("F_fr")
        return [
            self._of("omega_low", sqrt((self.at("E") - friction) / self.at("A"))),
            self._of("omega_up", sqrt((self.at("E") + friction) / self.at("A"))),
            self._of("epsilon", (self.at("omega_up") - self.at("omega_low")) / self.at("omega_g")),
        ]

    def effort(self) -> list[Formula]:
        grown = (Number(1) + self.var("q")) ** 2 - Number(1)
        return [
            self._value("effort", self.at("E") / Number(2) * grown),
            self._value("power", self.var("effort") * self.var("h")),
        ]


def added(parts: Iterable[Expr]) -> Expr:
    return reduce(add, parts)


def taken(whole: Expr, parts: Iterable[Expr]) -> Expr:
    """The whole less each of the parts."""
    return reduce(lambda rest, part: rest - part, parts, whole)
