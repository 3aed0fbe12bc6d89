"""A pair of spur wheels for every program, and its exact geometry in 40 digits."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

Array = Any
KINDS = ("profile", "thickness", "distance", "contact ratio")
POINTS = 100  # of a flank


@dataclass(frozen=True)
class GearPair:
    """Teeth, module in mm, shifts; a rack of 20°, height 1, clearance 0.25; no backlash, tips not shortened."""

    z1: int
    z2: int
    m: float
    x1: float = 0.0
    x2: float = 0.0


PAIRS = {"without shifts": GearPair(25, 40, 2.0), "with shifts": GearPair(22, 41, 2.0, 0.3, 0.2)}


def exact(pair: GearPair, digits: int = 40) -> dict[str, Any]:
    """Thickness at the reference circle of wheel 1, mm; distance of the axes, mm; contact ratio. Levitsky, ch. 10."""
    import mpmath as mp

    with mp.workdps(digits):
        alpha, m = mp.radians(20), mp.mpf(pair.m)
        z1, z2, x1, x2 = pair.z1, pair.z2, mp.mpf(pair.x1), mp.mpf(pair.x2)
        v = mp.tan(alpha) - alpha + 2 * (x1 + x2) * mp.tan(alpha) / (z1 + z2)
        alpha_w = mp.findroot(lambda a: mp.tan(a) - a - v, alpha)
        distance = m * (z1 + z2) / 2 * mp.cos(alpha) / mp.cos(alpha_w)
        base = [m * z / 2 * mp.cos(alpha) for z in (z1, z2)]
        tips = [m * z / 2 + m * (1 + x) for z, x in ((z1, x1), (z2, x2))]
        reach = sum(mp.sqrt(tip**2 - b**2) for tip, b in zip(tips, base, strict=True))
        path = reach - distance * mp.sin(alpha_w)
        return {
            "thickness": float(m * (mp.pi / 2 + 2 * x1 * mp.tan(alpha))),
            "distance": float(distance),
            "contact ratio": float(path / (mp.pi * m * mp.cos(alpha))),
        }


def half_angles(pair: GearPair, radii: Array, digits: int = 40) -> Array:
    """Exact half of the angle of a tooth of wheel 1 at the radii, rad: (π/2 + 2x tan α)/z + inv α − inv α_r."""
    import mpmath as mp

    found = []
    with mp.workdps(digits):
        alpha = mp.radians(20)
        base = mp.mpf(pair.m) * pair.z1 / 2 * mp.cos(alpha)
        own = (mp.pi / 2 + 2 * mp.mpf(pair.x1) * mp.tan(alpha)) / pair.z1 + mp.tan(alpha) - alpha
        for radius in radii:
            at = mp.acos(base / mp.mpf(float(radius)))
            found.append(float(own - mp.tan(at) + at))
    return np.array(found)


def errors(found: Mapping[str, Any], pair: GearPair) -> dict[str, float | None]:
    """Of the profile the distance from the exact involute over the module, of the others relative; None: not offered.

    `found["profile"]`: points of a flank of the tooth on the +x axis, complex, mm; those under the base circle, where
    there is no involute, are not judged.
    """
    truth = exact(pair)
    off: dict[str, float | None] = {
        kind: abs(found[kind] - truth[kind]) / truth[kind] if kind in found else None for kind in KINDS[1:]
    }
    return {"profile": _profile(found["profile"], pair) if "profile" in found else None} | off


def _profile(points: Array, pair: GearPair) -> float:
    base = pair.m * pair.z1 / 2 * np.cos(np.pi / 9)
    radii = np.abs(points)
    judged = radii > base * (1 + 1e-12)
    angles = half_angles(pair, radii[judged])
    return float(np.max(radii[judged] * np.abs(np.abs(np.angle(points[judged])) - angles)) / pair.m)
