"""Polygons of the direct and the reverse cranks as drawn by hand, at one scale for forces and one for moments."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from tmm_report.chapters.machine.engine.values import KINDS
from tmm_report.mechanics.masses.engine_cylinders import cranks
from tmm_report.mechanics.masses.rotor import Polygon, extent, polygon
from tmm_report.quantity.paper import round_scale
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.chapters.machine.engine.solve import Found

Array = Any
PAPER = 36.0  # mm: the size of a polygon


@dataclass(frozen=True, eq=False)
class Star:
    """Cranks of an order, with unit length (`direct_cranks`, `reverse_cranks`, (N,)), and their polygons in mm; `graph`
    and `analytic`: the greatest force, N, or moment, N m, by the polygons and by calculation."""

    order: int
    of: str
    direct_cranks: Array
    reverse_cranks: Array
    direct: Polygon
    reverse: Polygon
    graph: float
    analytic: float

    @property
    def label(self) -> str:
        """What its figure is referred to by."""
        return f"{self.of}{self.order}"

    @property
    def direct_length(self) -> float:
        return abs(self.direct.closing)

    @property
    def reverse_length(self) -> float:
        return abs(self.reverse.closing)


def scales(found: Found) -> dict[str, float]:
    """kg m/mm and kg m²/mm; of the moments only where there are any."""
    sizes = {of: [extent(v) for k in (1, 2) for v in _vectors(found, k, of)] for of in KINDS}
    return {
        of: round_scale(max(found_sizes), PAPER) for of, found_sizes in sizes.items() if max(found_sizes) > 0
    }


def stars(found: Found) -> Iterator[Star]:
    """Of orders 1 and 2, of forces and of moments."""
    names, step = [one.name for one in found.given.laid], found.given.accuracy * 1e3
    for of, scale in scales(found).items():
        for order in (found.first, found.second):
            direct, reverse = (polygon(names, v, scale, step, "Σ") for v in _vectors(found, order.order, of))
            size = scale * found.given.speed**2 * order.textbook
            graph = (abs(direct.closing) + abs(reverse.closing)) / 2 * size
            turning = order.force if of == "force" else order.couple
            yield Star(
                order.order, of, *_cranks(found, order.order), direct, reverse, graph, float(turning.greatest)
            )


def _cranks(found: Found, order: int) -> tuple[Array, Array]:
    """Upright: the crank of angle 0 points upwards."""
    direct, reverse = (1j * np.exp(1j * turned) for turned in cranks(order, found.banks, found.angles))
    return direct, reverse


def _vectors(found: Found, order: int, of: str) -> tuple[Array, Array]:
    """kg m, or with the places kg m²."""
    weights = found.product * (1.0 if of == "force" else found.places)
    direct, reverse = _cranks(found, order)
    return direct * weights, reverse * weights
