"""What is said of a demand that no linkage meets."""

from __future__ import annotations

import math

from tmm_report.problems import Message, ProblemError, mistake
from tmm_report.quantity.text import Amount


def refused(text: str, *keys: str, right: Message | None = None, **values: object) -> ProblemError:
    """`keys`: where in the block the demand stands."""
    return ProblemError([mistake(text, ("synthesis", *keys), right, **values)])


def mm(length: float) -> Amount:
    return Amount(1e3 * length, 6, "mm")


def degrees(angle: float) -> Amount:
    return Amount(math.degrees(angle), 5, "deg")
