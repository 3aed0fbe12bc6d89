"""Chapter of masses on a turning shaft: their unbalance, its balance in one plane or in two, what bearings feel.

The polygons are drawn as by hand: lengths laid off and read to the accuracy of the drawing. (Artobolevsky, Theory of
mechanisms and machines, ch. 13; Norton, Design of machinery, ch. 12)
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from tmm_report.chapters.machine.rotor import steps
from tmm_report.chapters.machine.rotor.correction import PLANES, Correction, correction
from tmm_report.chapters.machine.rotor.given import Given
from tmm_report.chapters.machine.rotor.values import Values
from tmm_report.mechanics.masses import rotor
from tmm_report.mechanics.masses.rotor import Polygon, polygon
from tmm_report.problems import N_, Message
from tmm_report.quantity.paper import round_scale
from tmm_report.quantity.text import Amount, amounts
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.chapters.lever.moving import Moving

__all__ = ["Correction", "Found", "Given", "solve"]

Array = Any
PAPER = 75.0  # mm: the largest of the vectors and of the polygon's extents is at most so long


@dataclass(frozen=True, eq=False)
class Found:
    """Found by `solve`. `s`: the single numbers; `products` kg m, `places` m, `couples` kg m²: (N,), complex in axes of
    the shaft; `corrections`: one or two; `force`, `couple`: the polygons, the latter with two planes alone."""

    given: Given
    s: Values
    products: Array
    places: Array
    couples: Array
    corrections: tuple[Correction, ...]
    force: Polygon
    couple: Polygon | None

    @property
    def two(self) -> bool:
        return len(self.corrections) == 2

    # --- the unbalance

    @property
    def resultant(self) -> complex:
        """Σ D, kg m."""
        return rotor.settled(np.sum(self.products), self.products)

    @cached_property
    def moments(self) -> Array:
        """D l + J of each about plane I, kg m²."""
        return rotor.moments(self.products, self.places, self.couples, self.given.planes[0].at)

    @property
    def moment(self) -> complex:
        """Σ about plane I, kg m²."""
        return rotor.settled(np.sum(self.moments), self.moments)

    @cached_property
    def length(self) -> float:
        """A length of the shaft, m: what lies furthest apart."""
        of = self.given
        places = [*self.places, *(plane.at for plane in of.planes), *(of.bearings or ())]
        return float(max(places) - min(places)) or 1.0

    @property
    def kind(self) -> str:
        first = self.given.planes[0].at
        return rotor.kind(self.products, self.places, self.couples, first, self.length)

    @property
    def size(self) -> float:
        """Beside which a product is nothing, kg m."""
        return float(np.sum(np.abs(self.products)) + np.sum(np.abs(self.couples)) / self.length)

    @property
    def pulls(self) -> bool:
        """Whether the sum of the unbalances is anything."""
        return abs(self.resultant) > rotor.CLEAR * self.size

    @cached_property
    def masses(self) -> Array | None:
        """Of all that the rotor is made of, kg, (N,); None where single masses are stated on a shaft that is not."""
        masses = [one.mass for one in self.given.heavy]
        made_up = None not in masses and any(one.is_body for one in self.given.heavy)
        return np.array(masses) if made_up else None

    @property
    def summed_mass(self) -> float | None:
        """Of all the bodies, kg."""
        return None if self.masses is None else float(np.sum(self.masses))

    @property
    def centre(self) -> float | None:
        """Place of the mass centre along the shaft, m: stated, or of all its bodies."""
        if self.given.centre is not None or self.masses is None:
            return self.given.centre
        return float(np.dot(self.masses, self.places) / np.sum(self.masses))

    # --- what is left

    @cached_property
    def exact(self) -> tuple[complex, complex]:
        """Force, kg m, and couple about plane I, kg m², with the exact weights."""
        return self._left([one.product for one in self.corrections])

    @cached_property
    def left(self) -> tuple[complex, complex]:
        """The same with the weights as they are made."""
        return self._left([one.made for one in self.corrections])

    def _left(self, added: list[complex]) -> tuple[complex, complex]:
        arms = np.array([one.at for one in self.corrections]) - self.given.planes[0].at
        return self.resultant + sum(added), self.moment + complex(np.dot(np.array(added), arms))

    @property
    def uneven(self) -> float:
        """What the exact weights leave, relative to what was there."""
        force, couple = self.exact
        left = abs(force) + (abs(couple) / self.length if self.two else 0.0)
        return left / self.size if self.size else 0.0

    # --- bearings

    def felt(self, added: list[complex]) -> Array:
        """Unbalances in the planes of the bearings A and B with products added in the planes of correction, (2,)."""
        products = np.array([*self.products, *added])
        places = np.array([*self.places, *(one.at for one in self.corrections[: len(added)])])
        couples = np.array([*self.couples, *(0j for _ in added)])
        return rotor.bearings(products, places, couples, np.array(self.given.bearings))

    @cached_property
    def before(self) -> Array:
        return self.felt([])

    @cached_property
    def after(self) -> Array:
        """With the exact weights: nothing where there are two planes."""
        return self.felt([one.product for one in self.corrections])

    @cached_property
    def made(self) -> Array:
        return self.felt([one.made for one in self.corrections])

    @property
    def disagreement(self) -> float:
        """Of the sum of both bearings, each found by the moments about the other, from the sum of the forces."""
        largest = float(np.max(np.abs(self.before)))
        miss = abs(complex(np.sum(self.before)) - self.resultant)
        return miss / largest if largest else 0.0

    # --- limits

    @cached_property
    def permitted(self) -> Array | None:
        """In the planes of the bearings, kg m, (2,)."""
        whole, centre, of = self.s.get("D_per"), self.centre, self.given
        if whole is None or of.bearings is None or centre is None:
            return None
        return rotor.permitted(whole, np.array(of.bearings), centre)

    @property
    def overhung(self) -> bool:
        """Whether the mass centre does not lie between the bearings."""
        of = self.given
        return (
            self.centre is not None and of.bearings is not None and rotor.overhung(of.bearings, self.centre)
        )

    @property
    def couple_stays(self) -> bool:
        """Whether one correction plane is stated and a moment is left."""
        return not self.two and abs(self.exact[1]) > rotor.CLEAR * self.size * self.length

    def summary(self) -> Iterator[Message]:
        """The main numbers in sentences."""
        text = N_("rotor: unbalance %(before)s kg·m")
        yield Message(text, {"before": Amount(abs(self.resultant))})
        text = N_("weight in plane %(plane)s: %(mass)s kg at the radius %(radius)s mm, %(angle)s°")
        for one in filter(lambda one: one.product, self.corrections):
            sizes = {"mass": one.mass, "radius": 1e3 * one.radius, "angle": np.degrees(one.angle)}
            yield Message(text, {"plane": one.name, **amounts(sizes)})


def solve(given: Given, moving: Moving | None) -> Found:
    """A rotor stands alone: the mechanism is not needed."""
    products = np.array([one.product * np.exp(1j * one.angle) for one in given.heavy])
    places = np.array([one.at for one in given.heavy])
    couples = np.array([one.couple for one in given.heavy])
    needed = rotor.corrections(products, places, couples, np.array([plane.at for plane in given.planes]))
    corrections = tuple(correction(given, k, complex(product)) for k, product in enumerate(needed))
    moments = rotor.moments(products, places, couples, given.planes[0].at)
    drawn = _polygons(given, products, moments, corrections)
    found = Found(given, Values(), products, places, couples, corrections, *drawn)
    steps.unbalance(found)
    steps.shaft(found)
    steps.polygons(found)
    steps.left(found)
    return found


def _polygons(
    given: Given, products: Array, moments: Array, corrections: tuple[Correction, ...]
) -> tuple[Polygon, Polygon | None]:
    """Of the couples first, as its closing vector goes into that of the forces."""
    names, step = given.names, given.accuracy * 1e3
    if len(corrections) == 1:
        return polygon(names, products, scale_for(products), step, PLANES[0]), None
    arm = corrections[1].at - corrections[0].at
    couple = polygon(names, moments, scale_for(moments), step, PLANES[1])
    second = couple.closing * couple.scale / arm
    both = np.array([*products, second])
    return polygon([*names, PLANES[1]], both, scale_for(both), step, PLANES[0]), couple


def scale_for(vectors: Array) -> float:
    """A round scale at which the polygon fits the paper."""
    return round_scale(rotor.extent(vectors), PAPER)
