"""What is given to the plans: how they are drawn."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from tmm_report.quantity.paper import ACCURACY


@dataclass(frozen=True)
class Drawing:
    """How plans are drawn. Scales are SI units per mm of paper; None: chosen as a person would choose."""

    accuracy: float = ACCURACY  # m of paper: lengths are read to this
    length: float | None = None  # m/mm
    velocity: float | None = None  # (m/s)/mm
    acceleration: float | None = None  # (m/s²)/mm
    force: float | Mapping[str, float] | None = None  # N/mm, one for all or by group, "2-3"
