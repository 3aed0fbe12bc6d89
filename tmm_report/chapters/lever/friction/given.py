"""What is given of the friction in the joints."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from typing import Any

from tmm_report.mechanics.pairs.coefficients import Rubs
from tmm_report.mechanics.pairs.materials import Stock
from tmm_report.records import dataclass


@dataclass(frozen=True)
class Rubbing:
    """A pair's friction coefficient and, for a pivot, its journal diameter, m, for a guide the length of its slider.
    The coefficient is a number, or a law of the velocity of sliding: in a pivot that of the journal's surface.

    `stock`: the materials of which the coefficient is taken, None where it is stated itself.
    """

    coefficient: float | Rubs
    diameter: float | None = None
    length: float | None = None
    stock: Stock | None = None

    @property
    def law(self) -> Rubs | None:
        """How the coefficient depends on the velocity of sliding; None of a number."""
        return None if isinstance(self.coefficient, int | float) else self.coefficient

    def at(self, sliding: Any) -> Any:
        """The coefficient at velocities of sliding, m/s, whatever their signs."""
        law = self.law
        return self.coefficient if law is None else law.value(abs(sliding))

    def arm(self, kind: str) -> float:
        """Velocity of sliding by the relative rate of a pair of the kind: radius of a journal, m; 1 of a guide."""
        return (self.diameter or 0.0) / 2 if kind == "R" else 1.0

    @property
    def half(self) -> float | None:
        """Half the length of the slider, m; None where it is not stated: its moment then presses nothing."""
        return None if self.length is None else self.length / 2


@dataclass(frozen=True)
class Friction:
    """Friction of all pivots, of all guides, of all cam pairs (of a roller that of its pin), and of single joints named
    by their point, guide or cam pair.

    `corrected`: whether the reactions are found with the friction, too; `rails`: guides that stand for rails on which
    wheels roll: nothing slides on them.
    """

    pivots: Rubbing | None = None
    guides: Rubbing | None = None
    joints: Mapping[str, Rubbing] = field(default_factory=dict)
    corrected: bool = False
    rails: tuple[str, ...] = ()
    cams: Rubbing | None = None
