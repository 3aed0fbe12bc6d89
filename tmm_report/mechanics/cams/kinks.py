"""Where the motion of a cam's follower is not smooth: the ends of a law's phases, the points of a stated profile."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmm_report.mechanics.cams.cam import ByLaw, Cam, Sliding, lowest_sliding, lowest_swinging
from tmm_report.mechanics.cams.stated_profile import ByProfile, Polar


def kinks(cam: Cam) -> Iterator[float]:
    """Angles of the cam's x axis, rad."""
    given = cam.given
    if isinstance(given, ByLaw):
        yield from (given.start + given.sense * theta for theta in given.law.breaks)
    elif isinstance(given, ByProfile) and isinstance(given.curve, Polar):
        yield from (phi for u in given.curve.angles if (phi := _touched(cam, given, u)) is not None)


def _touched(cam: Cam, given: ByProfile, u: float) -> float | None:
    """The cam's angle at which the follower touches the point of the parameter `u`; None where it never does."""
    p, d, _ = given.curve.of(np.array([u]))
    normal = complex(-1j * d[0] / abs(d[0]))
    if cam.flat:
        return float(np.angle(complex(cam.normal(np.array(0.0))) / normal))
    b = complex(p[0]) + (cam.roller or 0.0) * normal
    motion = cam.motion
    q = lowest_sliding(motion, abs(b)) if isinstance(motion, Sliding) else lowest_swinging(motion, abs(b))
    return None if q is None else float(np.angle(complex(motion.point(np.array(q), 0.0, 0.0).z) / b))
