"""A gear pair or a rack within a linkage as it is stated: links that carry the wheels, radii, phase, line of action.

Both wheels turn about fixed points, a rack is cut on a link that slides along a fixed guide. The coordinates of the two
links, angles of their x axes and of a slider its way along the guide, then go one by the other in a straight line:
x2 = phase + i x1, with i = −r1/r2 (external), +r1/r2 (internal), ±1/r (a rack, 1, and its wheel, 2).
Source: Artobolevsky, Theory of mechanisms and machines, ch. 7; Frolov (ed.), Theory of mechanisms, ch. 2.
"""

from __future__ import annotations

from typing import Any, Literal

import numpy as np

from tmm_report.mechanics.calculus.vectors import cross
from tmm_report.records import dataclass

Array = Any


@dataclass(frozen=True, eq=False)
class Mesh:
    """`links`: of a rack the slider, then the wheel. `axes`: the fixed points about which they turn, m; of a rack None
    first. `radii`: of the pitch circles, m, of a rack 0 first. `pressure`: the angle of engagement, rad.
    Of a rack `along`, `through`: its guide, and the point from which its way is counted; `own`: its point that lies on
    the guide, in its axes, m; `toward`: from the wheel's axis to the rack, unit complex. `teeth`, `module`: as
    stated."""

    name: str
    links: tuple[str, str]
    kind: Literal["external", "internal", "rack"]
    radii: tuple[float, float]
    axes: tuple[complex | None, complex]
    phase: float = 0.0
    pressure: float = 0.0
    along: complex = 1 + 0j
    through: complex = 0j
    own: complex = 0j
    toward: complex = -1j
    teeth: tuple[int, int] | None = None
    module: float | None = None

    @property
    def pole(self) -> str:
        """What the pitch point is called: P12; longer names are told apart by a comma."""
        first, second = self.links
        return f"P{first}{second}" if len(first) == len(second) == 1 else f"P{first},{second}"

    @property
    def ratio(self) -> float:
        """dx2/dx1; of a rack 1/m."""
        if self.kind == "rack":
            return float(np.sign(cross(self.toward, self.along))) / self.radii[1]
        size = self.radii[0] / self.radii[1]
        return -size if self.kind == "external" else size

    def outward(self, link: str) -> complex:
        """From the link's axis to the pitch point, unit complex; of a rack from its wheel's axis."""
        first, second = self.axes
        if first is None:
            return self.toward
        apart = second - first if link == self.links[0] else first - second
        if self.kind == "internal" and not self.rings(link):  # from the ring's axis through the pinion's
            apart = -apart
        return apart / abs(apart)

    def rings(self, link: str) -> bool:
        """Whether the link carries the ring of an internal pair."""
        return self.kind == "internal" and self.radius(link) == max(self.radii)

    def radius(self, link: str) -> float:
        return self.radii[self.links.index(link)]

    @property
    def pitch_point(self) -> complex:
        """Where the pitch circles touch, m: it stands still."""
        second = self.links[1]
        return self.axes[1] + self.radii[1] * self.outward(second)

    def other(self, link: str) -> str:
        return self.links[1] if link == self.links[0] else self.links[0]

    def pressed(self, link: str, tangential: Array) -> Array:
        """The force of the teeth on a link, complex N, (..., P), of its tangential part, along i·outward: it lies on
        the line of action of the flank that is pressed, and drives the wheels apart."""
        e = self.outward(link)
        away = e if self.rings(link) or self.radius(link) == 0 else -e
        return tangential * 1j * e + np.abs(tangential) * np.tan(self.pressure) * away

    def normal(self, tangential: Array) -> Array:
        """F_n = |F_t| / cos α, N, (..., P)."""
        return np.abs(tangential) / np.cos(self.pressure)
