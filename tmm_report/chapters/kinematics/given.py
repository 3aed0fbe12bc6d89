"""What is given to the kinematics beside the mechanism: the positions."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Positions:
    """How many positions the tables and diagrams have over the cycle, and which table positions are drawn."""

    table: int = 12
    diagram: int = 36
    plans: tuple[int, ...] = (1,)
    force_plan: tuple[int, ...] = (1,)
