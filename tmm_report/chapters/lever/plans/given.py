"""What is given to the plans: how they are drawn."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal

from tmm_report.quantity.paper import ACCURACY
from tmm_report.records import dataclass

Kind = Literal["length", "velocity", "acceleration", "force"]


@dataclass(frozen=True)
class Segment:
    """A whole segment that a person chooses, mm, so that the scale follows from it.

    `points`: both ends of a link's line, or the one point whose velocity or acceleration is laid off; none of a force.
    """

    name: str  # as it is lettered: "OA", "pa", "πa"
    kind: Kind
    points: tuple[str, ...]
    mm: float


@dataclass(frozen=True)
class Drawing:
    """How plans are drawn. Scales are SI units per mm of paper; None: from a segment, or as a person would choose."""

    accuracy: float = ACCURACY  # m of paper: lengths are read to this
    length: float | None = None  # m/mm
    velocity: float | None = None  # (m/s)/mm
    acceleration: float | None = None  # (m/s²)/mm
    force: float | Mapping[str, float] | None = None  # N/mm, one for all or by group, "2-3"
    segments: tuple[Segment, ...] = ()

    def segment(self, kind: Kind) -> Segment | None:
        """The segment chosen for a scale."""
        return next((one for one in self.segments if one.kind == kind), None)

    @property
    def force_segment(self) -> float | None:
        """mm at which the largest force of a plan is drawn, where that is stated."""
        chosen = self.segment("force")
        return chosen.mm if chosen else None
