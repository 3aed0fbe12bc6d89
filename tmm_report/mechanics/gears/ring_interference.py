"""Whether a pinion, or a pinion cutter, gets past the tips of its ring; everything broadcasts.

Source: Litvin, Gear geometry and applied theory, ch. 11; GOST 19274.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from tmm_report.mechanics.gears.cutting import ByCutter
from tmm_report.mechanics.gears.involute import inv
from tmm_report.mechanics.gears.rack import arccos, root

Array = Any
Both = tuple[Array, Array]


class Cutting(NamedTuple):
    """What is in hand when a ring is cut by its pinion cutter; negative: part of the teeth is cut away.

    `trimming`: radius of curvature at the ring's tip less a_w0 sin α_w0, m: below it the cutter's root takes away the
    tips; `fouling`: between the tips, rad of the ring; `radial`: the same while the cutter is fed radially.
    """

    trimming: Array
    fouling: Array
    radial: Array


def cutting_of(cut: ByCutter, z: Array, tip: Array, angle: Array) -> Cutting:
    """Of a ring of `z` teeth with the tip radius `tip`, m, and the profile angle there."""
    line = np.abs(cut.line)
    of = (cut.tool.z, z), (cut.tip, tip), (cut.tip_angle, angle), np.abs(cut.distance), cut.alpha
    return Cutting(root(tip**2 - (tip * np.cos(angle)) ** 2) - line, fouling(*of), radial(*of))


def fouling(z: Both, tips: Both, angles: Both, a_w: Array, alpha_w: Array) -> Array:
    """Gap between the tips of pinion and ring off the line of action, as an angle of the ring, rad, (...).

    Of (pinion, ring): numbers of teeth, radii of the tips, m, and profile angles there. At the crossing of the tip
    circles each wheel stands at an angle δ from the centre line, and the ring must lead. ∞ where the pinion's tips do
    not come to those of the ring, −∞ where they enclose them; nan for a ring's tip inside its base circle.
    Source: Litvin, Gear geometry and applied theory, ch. 11 (the same as GOST 19274).
    """
    (r, R), (tip, Tip) = tips, (inv(alpha) for alpha in angles)
    delta = arccos((R**2 - a_w**2 - r**2) / (2 * a_w * r))
    Delta = arccos((R**2 + a_w**2 - r**2) / (2 * a_w * R))
    gap = (z[0] * (tip + delta) - z[1] * (Tip + Delta) + (z[1] - z[0]) * inv(alpha_w)) / z[1]
    gap = np.where(a_w + r <= R, np.inf, gap)
    return np.where(r - a_w >= R, -np.inf, gap)[()]


def radial(z: Both, tips: Both, angles: Both, a_w: Array, alpha_w: Array) -> Array:
    """Least gap between the corners of pinion and ring that pass one another as the pinion is moved radially, as an
    angle of the ring, rad, (...); arguments as of `fouling`.

    At the turn θ of a pinion's tooth from the line of centres the corners are level where r sin θ = R sin Θ. The gap
    Θ is least where they pass without a change of it, r z2 cos θ = R z1 cos Θ; beyond the crossing of the tip circles
    no corners pass, and the gap there is that of `fouling`.
    Source: Litvin, Gear geometry and applied theory, ch. 11 (the radial feed of a cutter in GOST 19274 is the same).
    """
    (r, R), (tip, Tip) = tips, (inv(alpha) for alpha in angles)
    with np.errstate(invalid="ignore", divide="ignore"):
        narrow, u = np.cos(angles[0]) / np.cos(angles[1]), z[1] / z[0]
        theta = np.arcsin(np.sqrt((1 - narrow**2) / (1 - 1 / u**2)))
        Theta = np.arcsin(np.sqrt((1 / narrow**2 - 1) / (u**2 - 1)))
        gap = (z[0] * (theta + tip) - z[1] * (Theta + Tip) + (z[1] - z[0]) * inv(alpha_w)) / z[1]
    crossing = arccos((R**2 - a_w**2 - r**2) / (2 * a_w * r))
    passed = (narrow < 1) & (theta < crossing)
    return np.where(passed, gap, fouling(z, tips, angles, a_w, alpha_w))[()]
