"""Chapter of the balance of an engine of several cylinders: inertia forces and their moments by orders and exactly.

Reciprocating masses by direct and reverse cranks, rotating ones with the crankshaft, counterweights opposite the
cranks; what is left is told from the exact motion. (Bevan, The theory of machines, ch. 14; Artobolevsky, ch. 13)
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from tmm_report.chapters.machine.engine import limits, steps
from tmm_report.chapters.machine.engine.drawn import Star, scales, stars
from tmm_report.chapters.machine.engine.given import Given
from tmm_report.chapters.machine.engine.values import Values
from tmm_report.mechanics.masses import engine_cylinders
from tmm_report.mechanics.masses.engine_cylinders import Turning
from tmm_report.problems import N_, Message
from tmm_report.quantity.text import amounts
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
    """Found by `solve`. `s`: the single numbers; `banks`, `angles`, rad, `places`, m from the plane of the moments,
    (N,)."""

    given: Given
    s: Values
    banks: Array
    angles: Array
    places: Array

    @property
    def unit(self) -> float:
        """m r ω², N."""
        return self.s.number("unit")

    @property
    def product(self) -> float:
        """m r, kg m."""
        return self.s.number("m") * self.given.crank_radius

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
        lam = self.s.number("lambda")
        exact, series = engine_cylinders.coefficients(lam, ORDERS), limits.series(lam)
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

    @property
    def _rotating(self) -> float:
        """Of each crank, kg m."""
        return (self.s.get("m_rot") or 0.0) * self.given.crank_radius

    @property
    def _opposite(self) -> float:
        """Of each counterweight, kg m."""
        return (self.s.get("m_cw") or 0.0) * (self.s.get("r_cw") or 0.0)

    def turned(self, product: float) -> tuple[complex, complex]:
        """Force, N, and couple, N m, at φ = 0 of equal products of mass and radius at every crank."""
        size = product * self.given.speed**2
        weights = (np.ones(len(self.angles)), self.places)
        pull, turn = (complex(size * engine_cylinders.rotating(0.0, self.angles, w)) for w in weights)
        return pull, turn

    @cached_property
    def stages(self) -> tuple[tuple[str, Turning, Turning], ...]:
        """Force and couple of order 1: of the reciprocating masses, with the rotating ones, with the counterweights."""
        force, couple = self.first.force, self.first.couple
        found = [("reciprocating", force, couple)]
        for name, product in (("rotating", self._rotating), ("balanced", -self._opposite)):
            if product:
                pull, turn = self.turned(product)
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
        added = self._turning(phi, -self._opposite)
        force, couple = self.primary
        both = Course(
            phi,
            force.at(1, phi) + self.second.force.at(2, phi),
            couple.at(1, phi) + self.second.couple.at(2, phi),
        )
        after = Course(phi, before.force + added.force, before.couple + added.couple)
        return {"before": before, "after": after, "orders": both}

    def _exact(self, phi: Array) -> Course:
        ones, lam = np.ones(len(self.banks)), self.s.number("lambda")
        pull, turn = (
            self.unit * engine_cylinders.exact(phi, lam, self.banks, self.angles, weights)
            for weights in (ones, self.places)
        )
        own = self._turning(phi, self._rotating)
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

    @cached_property
    def stars(self) -> tuple[Star, ...]:
        """By the polygons of the cranks."""
        return tuple(stars(self))

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
        shown = {key: float(size) if size > scale else 0.0 for key, size in sizes.items()}
        yield Message(text, {"count": len(self.banks), **amounts(shown)})


def solve(given: Given, moving: Moving | None) -> Found:
    """An engine stands alone: the mechanism is not needed. Raises ProblemError for a counterweight or an order of
    firing that cannot be."""
    s, laid = Values(), given.laid
    steps.cylinder(s, given)
    steps.counterweight(s, given)
    limits.check_share(s, given)
    banks, angles, places = (np.array([one[k] for one in laid]) for k in (1, 2, 3))
    about = given.about if given.about is not None else (places.min() + places.max()) / 2
    found = Found(given, s, banks, angles, places - about)
    steps.left(s, found)
    of = scales(found)
    s.mu_F, s.mu_M = of.get("force"), of.get("couple")
    limits.check(found.firing, given)
    return found
