"""The scales of the drawings of an eccentric epicyclic mechanism."""

from __future__ import annotations

import math

from tmm_report.chapters.gears.eccentric.given import Given
from tmm_report.chapters.gears.eccentric.paths import Traced

STEPS = (1, 2, 2.5, 4, 5, 10)  # of the standard scales
WIDTH = 158.0  # mm of paper that the assembled mechanism may take
RIM = 3.0  # modules outside the roots of the ring
MODULE = 8.0  # mm of paper that a module should take in a close view
ROUND = 25.0  # radius of a close view, mm of paper


def standard(ratio: float) -> float:
    """The largest standard scale (mm of paper to mm) not over `ratio`."""
    scales = [step * 10.0**power for power in range(-6, 4) for step in STEPS]
    inverse = [1 / scale for scale in scales]
    return max(scale for scale in (*scales, *inverse) if scale <= ratio * (1 + 1e-9) and _known(scale))


def _known(scale: float) -> bool:
    """1, 2, 2.5, 4, 5, 10 to one or one to these."""
    size = scale if scale >= 1 else 1 / scale
    return any(math.isclose(size / 10 ** math.floor(math.log10(size) + 1e-9), step) for step in STEPS)


def outside(given: Given, ring: int) -> float:
    """Radius of the ring's rim, m."""
    return given.module * (ring / 2 + given.rack.ha + given.rack.c + RIM)


def scale(given: Given, ring: int) -> float:
    """Scale of the assembled mechanism, mm of paper to mm."""
    return standard(WIDTH / (2e3 * outside(given, ring)))


def close_scale(given: Given) -> float:
    """Scale of the close views, mm of paper to mm."""
    return standard(MODULE / (1e3 * given.module))


def path_scale(path: Traced) -> float:
    """Scale of the drawing of a path, mm of paper to mm."""
    reach = abs(path.arm) + path.point.radius
    return standard(WIDTH / (2e3 * reach))
