"""What is said of a demand that no linkage meets."""

from __future__ import annotations

import math

from tmm_report.problems import Message, ProblemError, mistake


def refused(text: str, *keys: str, right: Message | None = None, **values: object) -> ProblemError:
    """`keys`: where in the block the demand stands."""
    return ProblemError([mistake(text, ("synthesis", *keys), right, **values)])


def mm(length: float) -> str:
    return f"{1e3 * length:.6g} mm"


def degrees(angle: float) -> str:
    return f"{math.degrees(angle):.5g} deg"
