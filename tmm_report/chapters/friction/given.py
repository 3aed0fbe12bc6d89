"""What is given of the friction in the joints."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field


@dataclass(frozen=True)
class Rubbing:
    """A pair's friction coefficient and, for a pivot, its journal diameter, m."""

    coefficient: float
    diameter: float | None = None


@dataclass(frozen=True)
class Friction:
    """Friction of all pivots, of all guides, and of single joints named by their point or guide."""

    pivots: Rubbing | None = None
    guides: Rubbing | None = None
    joints: Mapping[str, Rubbing] = field(default_factory=dict)
