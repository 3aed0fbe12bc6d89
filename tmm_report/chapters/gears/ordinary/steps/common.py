"""What several kinds of ordinary stages share: slip, cones that become planes."""

from __future__ import annotations

import math

from tmm_report.chapters.gears.ordinary.values import Belt, Friction
from tmm_report.quantity.formula import Expr

FLATTEST = math.radians(89)  # of a cone


def kept(diameter: Expr, s: Belt | Friction) -> Expr:
    """The part that the driven wheel keeps, for its slip, of what is in proportion to its velocity."""
    return diameter * (1 - s.epsilon) if "epsilon" in s else diameter


def is_plane(angle: float, ratio: float) -> bool:
    """Whether one of two cones whose axes are at `angle`, rad, is a plane or hollow; `ratio`: d2/d1."""
    first = math.atan2(math.sin(angle), ratio + math.cos(angle))
    return first >= math.pi / 2 or angle - first >= FLATTEST
