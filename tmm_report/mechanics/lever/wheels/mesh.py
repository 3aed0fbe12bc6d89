"""A gear pair or a rack within a linkage as it is stated: links that carry the wheels, radii, phase, line of action.

A carrier keeps the distance of the axes: the frame, or a moving link to which both wheels are pivoted. Seen from it
both axes are fixed (Willis), and the coordinates of the two links, angles of their x axes, go one by the other in a
straight line, x2 − c = phase + i (x1 − c), with c the angle of the carrier and i = −r1/r2 (external), +r1/r2
(internal). A rack, 1, is cut on a link that slides along a fixed guide, or is the frame; its wheel, 2, turns about a
fixed point or on a slider that goes along a parallel guide: x2 = phase + i (x1 ∓ c), with i = ±1/r and their ways.
Source: Artobolevsky, Theory of mechanisms and machines, ch. 7; Frolov (ed.), Theory of mechanisms, ch. 2.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from tmm_report.mechanics.calculus.vectors import cross, dot
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.mechanics.lever.dyads import State

Array = Any


@dataclass(frozen=True, eq=False)
class Way:
    """How far a slider is along its fixed guide: of its point `own`, in its axes, m, from `through`, unit `along`."""

    own: complex
    through: complex
    along: complex


@dataclass(frozen=True, eq=False)
class Mesh:
    """`links`: of a rack the slider, then the wheel. `axes`: the points about which they turn, in the axes of the
    `carrier`, m; of a rack None first. `radii`: of the pitch circles, m, of a rack 0 first. `pressure`: the angle of
    engagement, rad. Of a rack `along`, `through`: its guide, and the point from which its way is counted; `own`: its
    point that lies on the guide, in its axes, m; `toward`: from the wheel's axis to the rack, unit complex, both in the
    axes of the drawing; `carried`: the way of a carrier that slides. `teeth`, `module`: as stated. `rolls`: without
    teeth, held by friction. `points`: the names of the axes."""

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
    carrier: str = FRAME
    carried: Way | None = None
    rolls: bool = False
    points: tuple[str, str] = ("", "")

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

    @property
    def share(self) -> float:
        """dx2/dc, by the coordinate c of a moving carrier: its angle, or its way."""
        if self.carried is not None:
            return -self.ratio * float(np.sign(dot(self.carried.along, self.along)))
        return 1.0 - self.ratio if self.carrier != FRAME else 0.0

    def outward(self, link: str) -> complex:
        """From the link's axis to the pitch point, unit complex, in the axes of a carrier that turns; of a rack from
        its wheel's axis."""
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

    def turn(self, s: State) -> Array:
        """From the axes of `outward` to those of the drawing, unit complex, (..., P)."""
        return 1.0 if self.kind == "rack" else s.u[self.carrier]

    def touches(self, s: State) -> Array:
        """Where the pitch circles touch in the drawing, m, (..., P)."""
        return s.world(self.carrier, self.axes[1]) + self.turn(s) * (
            self.radii[1] * self.outward(self.links[1])
        )

    def other(self, link: str) -> str:
        return self.links[1] if link == self.links[0] else self.links[0]

    def pressed(self, link: str, tangential: Array, flank: Array | None = None) -> Array:
        """The force of the teeth on a link, complex N, (..., P), in the axes of `outward`, of its tangential part,
        along i·outward: it lies on the line of action of the flank that is pressed, and drives the wheels apart.
        `flank`: the one that is pressed, the sign of the whole tangential part, where this is but a share of it."""
        e = self.outward(link)
        away = e if self.rings(link) or self.radius(link) == 0 else -e
        apart = np.abs(tangential) if flank is None else flank * tangential
        return tangential * 1j * e + apart * np.tan(self.pressure) * away

    def normal(self, tangential: Array) -> Array:
        """F_n = |F_t| / cos α, N, (..., P)."""
        return np.abs(tangential) / np.cos(self.pressure)
