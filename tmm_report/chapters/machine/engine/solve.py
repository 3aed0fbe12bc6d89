"""Chapter of the balance of an engine of several cylinders: inertia forces and their moments by orders and exactly.

Reciprocating masses by direct and reverse cranks, rotating ones with the crankshaft, counterweights opposite the
cranks; what is left is told from the exact motion. (Bevan, The theory of machines, ch. 14; Artobolevsky, ch. 13)
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from tmm_report.chapters.machine.engine import limits
from tmm_report.chapters.machine.engine.given import Given
from tmm_report.mechanics.masses import engine_cylinders
from tmm_report.mechanics.masses.engine_cylinders import Turning
from tmm_report.problems import N_, Message
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.chapters.lever.moving import Moving

__all__ = ["Found", "Given", "Order", "solve"]

Array = Any
ORDERS = (1, 2, 4, 6)
DIAGRAM = 72  # angles of a turn in the tables
FINE = 720  # in the search of extremes


@dataclass(frozen=True, eq=False)
class Order:
    """Of the reciprocating masses: `textbook`: coefficient of the series in λ, `exact`: of the exact motion; `force` N
    and `couple` N m, by the textbook's coefficient."""

    order: int
    textbook: float
    exact: float
    force: Turning
    couple: Turning


@dataclass(frozen=True, eq=False)
class Course:
    """Over a turn at the angles `phi`, rad, (P,): complex force N and couple N m."""

    phi: Array
    force: Array
    couple: Array

    def less(self, other: Course) -> Course:
        return Course(self.phi, self.force - other.force, self.couple - other.couple)


@dataclass(frozen=True, eq=False)
class Found:
    """Found by `solve`. `banks`, `angles`, rad, `places`, m from the plane of the moments, (N,); `reciprocating`,
    `rotating`: masses of a cylinder, kg; `share`, `weight_mass`, `weight_radius`: of its counterweight, if any."""

    given: Given
    banks: Array
    angles: Array
    places: Array
    reciprocating: float
    rotating: float
    share: float | None
    weight_mass: float | None
    weight_radius: float | None

    @property
    def lam(self) -> float:
        """λ = r/l."""
        return self.given.radius / self.given.length

    @property
    def unit(self) -> float:
        """m r ω², N."""
        return self.reciprocating * self.given.radius * self.given.speed**2

    @property
    def product(self) -> float:
        """m r, kg m."""
        return self.reciprocating * self.given.radius

    @property
    def spread(self) -> float:
        """The largest distance of a cylinder from the plane of the moments, m."""
        return float(np.max(np.abs(self.places)))

    @property
    def in_line(self) -> bool:
        """Whether all cylinders have one direction."""
        return bool(np.all(np.abs(np.exp(1j * self.banks) - np.exp(1j * self.banks[0])) < 1e-9))

    # --- by orders

    @cached_property
    def orders(self) -> tuple[Order, ...]:
        exact = engine_cylinders.coefficients(self.lam, ORDERS)
        series = limits.series(self.lam)
        return tuple(self._order(k, series[k], float(c)) for k, c in zip(ORDERS, exact, strict=True))

    def _order(self, k: int, textbook: float, exact: float) -> Order:
        force = engine_cylinders.turning(k, self.banks, self.angles, np.ones(len(self.banks)))
        couple = engine_cylinders.turning(k, self.banks, self.angles, self.places)
        size = self.unit * textbook
        return Order(
            k,
            textbook,
            exact,
            Turning(force.forward * size, force.backward * size),
            Turning(couple.forward * size, couple.backward * size),
        )

    @property
    def first(self) -> Order:
        return self.orders[0]

    @property
    def second(self) -> Order:
        return self.orders[1]

    # --- masses that turn with the cranks

    def turned(self, mass: float, radius: float) -> tuple[complex, complex]:
        """Force, N, and couple, N m, at φ = 0 of equal masses at every crank."""
        size = mass * radius * self.given.speed**2
        weights = (np.ones(len(self.angles)), self.places)
        pull, turn = (complex(size * engine_cylinders.rotating(0.0, self.angles, w)) for w in weights)
        return pull, turn

    @cached_property
    def stages(self) -> tuple[tuple[str, Turning, Turning], ...]:
        """Force and couple of order 1: of the reciprocating masses, with the rotating ones, with the counterweights."""
        force, couple = self.first.force, self.first.couple
        found = [("reciprocating", force, couple)]
        for name, mass, radius in (
            ("rotating", self.rotating, self.given.radius),
            ("balanced", -(self.weight_mass or 0.0), self.weight_radius or 0.0),
        ):
            if mass:
                pull, turn = self.turned(mass, radius)
                force = Turning(force.forward + pull, force.backward)
                couple = Turning(couple.forward + turn, couple.backward)
                found.append((name, force, couple))
        return tuple(found)

    @property
    def primary(self) -> tuple[Turning, Turning]:
        """Force and couple of order 1 with all that turns."""
        return self.stages[-1][1:]

    # --- over a turn

    @cached_property
    def diagram(self) -> dict[str, Course]:
        return self._courses(2 * np.pi * np.arange(DIAGRAM + 1) / DIAGRAM)

    @cached_property
    def fine(self) -> dict[str, Course]:
        return self._courses(2 * np.pi * np.arange(FINE) / FINE)

    def _courses(self, phi: Array) -> dict[str, Course]:
        """Exact without counterweights, exact with them, orders 1 and 2 with them."""
        before = self._exact(phi)
        added = self._turning(phi, -(self.weight_mass or 0.0) * (self.weight_radius or 0.0))
        force, couple = self.primary
        both = Course(
            phi,
            force.at(1, phi) + self.second.force.at(2, phi),
            couple.at(1, phi) + self.second.couple.at(2, phi),
        )
        after = Course(phi, before.force + added.force, before.couple + added.couple)
        return {"before": before, "after": after, "orders": both}

    def _exact(self, phi: Array) -> Course:
        ones = np.ones(len(self.banks))
        pull, turn = (
            self.unit * engine_cylinders.exact(phi, self.lam, self.banks, self.angles, weights)
            for weights in (ones, self.places)
        )
        own = self._turning(phi, self.rotating * self.given.radius)
        return Course(phi, pull + own.force, turn + own.couple)

    def _turning(self, phi: Array, product: float) -> Course:
        size = product * self.given.speed**2
        ones = np.ones(len(self.angles))
        force, couple = (size * engine_cylinders.rotating(phi, self.angles, w) for w in (ones, self.places))
        return Course(phi, force, couple)

    def greatest(self, which: str, of: str) -> float:
        """Of "before", "after", "orders" or "left" (what orders 1 and 2 leave of the exact), force or couple."""
        fine = self.fine
        course = fine["after"].less(fine["orders"]) if which == "left" else fine[which]
        return limits.peak(np.abs(getattr(course, of)))

    # --- what balances the rest

    @cached_property
    def remedies(self) -> tuple[limits.Remedy, ...]:
        speed, order = self.given.speed, self.second
        rows = [(1, *self.primary), (2, order.force, order.couple)]
        scale = self.unit * len(self.banks)
        return tuple(
            limits.remedy(k, of, turning, speed, scale * (1.0 if of == "force" else self.spread))
            for k, force, couple in rows
            for of, turning in (("force", force), ("couple", couple))
        )

    # --- firing

    @cached_property
    def firing(self) -> tuple[limits.Fired, ...]:
        return limits.firing(self.given, self.banks, self.angles)

    def summary(self) -> Iterator[Message]:
        """The main numbers in sentences."""
        text = N_(
            "engine of %(count)s cylinders: greatest inertia force %(force)s N, greatest moment %(couple)s N·m, of "
            "order 1 %(first)s N and %(turn)s N·m, of order 2 %(second)s N and %(other)s N·m"
        )
        force, couple = self.primary
        sizes = {
            "force": self.greatest("after", "force"), "couple": self.greatest("after", "couple"),
            "first": force.greatest, "turn": couple.greatest,
            "second": self.second.force.greatest, "other": self.second.couple.greatest,
        }  # fmt: skip
        scale = self.unit * 1e-9
        shown = {key: f"{float(size):.4g}" if size > scale else "0" for key, size in sizes.items()}
        yield Message(text, {"count": len(self.banks), **shown})


def solve(given: Given, moving: Moving | None) -> Found:
    """An engine stands alone: the mechanism is not needed. Raises ProblemError for a counterweight or an order of
    firing that cannot be."""
    places = np.array([one.at for one in given.cylinders])
    about = given.about if given.about is not None else (places.min() + places.max()) / 2
    up, down = limits.split(given)
    found = Found(
        given,
        np.array([one.bank for one in given.cylinders]),
        np.array([one.crank for one in given.cylinders]),
        places - about,
        up,
        down,
        *limits.counterweight(given, up, down),
    )
    limits.check(found.firing, given)
    return found
