"""What is given of the choice of method."""

from __future__ import annotations

from tmm_report.records import dataclass


@dataclass(frozen=True)
class Comparison:
    """Asked for by `methods: true`. `accuracy`: what the numbers of the note are to hold, relative, or None."""

    accuracy: float | None = None
