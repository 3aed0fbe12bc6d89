"""How large a cam is, near enough to judge its numbers by: its links have points of no size of their own."""

from __future__ import annotations

import math

from tmm_report.chapters.lever.structure.block.cams import CamModel


def radius(cam: CamModel, arm: float) -> float:
    """Greatest radius of a cam, m, whose swinging follower has this `arm`, m: a profile's own, else the base and what
    the law adds."""
    if cam.profile is not None:
        if cam.profile.circle is not None:
            return math.hypot(*cam.profile.circle.at) + cam.profile.circle.radius
        radii = [r for _, r in cam.profile.polar or ()] + [math.hypot(*at) for at in cam.profile.points or ()]
        return max(radii, default=0.0)
    lift = max([cam.lift or 0.0, *(lift for _, lift in cam.lifts)])
    swing = max([cam.swing or 0.0, *(swing for _, swing in cam.swings)])
    base = cam.base if isinstance(cam.base, float) else 0.0
    return base + lift + swing * arm
