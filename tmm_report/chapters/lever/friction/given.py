"""What is given of the friction in the joints."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field

from tmm_report.mechanics.pairs.materials import Stock
from tmm_report.records import dataclass


@dataclass(frozen=True)
class Rubbing:
    """A pair's friction coefficient and, for a pivot, its journal diameter, m, for a guide the length of its slider.

    `stock`: the materials of which the coefficient is taken, None where it is stated itself.
    """

    coefficient: float
    diameter: float | None = None
    length: float | None = None
    stock: Stock | None = None

    @property
    def half(self) -> float | None:
        """Half the length of the slider, m; None where it is not stated: its moment then presses nothing."""
        return None if self.length is None else self.length / 2


@dataclass(frozen=True)
class Friction:
    """Friction of all pivots, of all guides, and of single joints named by their point or guide.

    `corrected`: whether the reactions are found with the friction, too.
    """

    pivots: Rubbing | None = None
    guides: Rubbing | None = None
    joints: Mapping[str, Rubbing] = field(default_factory=dict)
    corrected: bool = False
