"""A link that a mesh moves: known at once when the other link of its mesh is, like the driving link.

With one lower pair and one higher pair it is a group of one link, 3·1 = 2·1 + 1. Its forces are statically determinate:
moments about its axis (of a rack, forces along its guide) give the tangential force of the teeth, the rest its bearing.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from tmm_report.mechanics.calculus.vectors import cross, dot
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.mechanics.lever.wheels.mesh import Mesh
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.mechanics.lever.assur_groups import Pair
    from tmm_report.mechanics.lever.dyads import State

Array = Any
WHOLE = 1e-12  # a ratio nearer to a whole number than this part is one


@dataclass(frozen=True, eq=False)
class Coupled:
    """`link`, moved by link `by`. `bearing`: its pair with the frame; `contact`: the higher pair, (by, link).
    `before`: that which moves `by` where it is such a link too; `leads`: whether `by` is the driving link. `middle`: of
    a link `by` that swings the middle of its swing, unit complex, from which its angle goes 180° both ways."""

    mesh: Mesh
    link: str
    by: str
    bearing: Pair
    contact: Pair
    before: Coupled | None = None
    leads: bool = False
    middle: complex = 1 + 0j

    @property
    def group_class(self) -> int:
        return 2

    @property
    def backwards(self) -> bool:
        return self.link == self.mesh.links[0]

    @property
    def rate(self) -> float:
        """dx/dx_by."""
        return 1 / self.mesh.ratio if self.backwards else self.mesh.ratio

    @property
    def zero(self) -> float:
        """The coordinate where that of `by` is 0: rad, or m of a slider."""
        return -self.mesh.phase / self.mesh.ratio if self.backwards else self.mesh.phase

    @property
    def slides(self) -> bool:
        return self.bearing.kind == "P"

    @property
    def by_slides(self) -> bool:
        return self.mesh.kind == "rack" and not self.slides

    @property
    def whole(self) -> bool:
        """Whether the link turns a whole number of times with each turn of `by`."""
        turning = self.mesh.kind != "rack"
        return turning and abs(self.rate - round(self.rate)) < WHOLE * max(1.0, abs(self.rate))

    @property
    def by_turns(self) -> float | None:
        """Turns for each turn of the driving link, where that moves it through meshes alone; m/rad of a slider."""
        if self.leads:
            return self.rate
        root = self.before.by_turns if self.before else None
        return None if root is None else root * self.rate

    # ------------------------------------------------------------ motion

    def coordinate(self, s: State) -> Array:
        """Angle of the link's x axis, rad, or the way of a slider along its guide, m, (..., P)."""
        return self.zero + self.rate * self._of_partner(s)

    def _of_partner(self, s: State) -> Array:
        if self.before is not None:
            return self.before.coordinate(s)
        if self.leads:
            return s.phi
        if self.by_slides:
            return dot(s.world(self.by, self.mesh.own) - self.mesh.through, self.mesh.along)
        return np.angle(self.middle) + np.angle(s.u[self.by] / self.middle)

    def place(self, s: State) -> None:
        """Add the link's pose to the state."""
        link, own = self.link, self.bearing
        s.o[link] = own.at[link]
        if self.slides:
            t = own.along[FRAME]
            s.r[link] = self.mesh.through + t * self.coordinate(s)
            s.u[link] = t * np.conj(own.along[link]) + 0j
            return
        s.r[link] = own.at[FRAME]
        if self.whole:
            s.u[link] = np.exp(1j * self.zero) * s.u[self.by] ** round(self.rate)
        else:
            s.u[link] = np.exp(1j * self.coordinate(s))

    def move(self, s: State) -> None:
        """Add the link's rates to the state."""
        link, by, c = self.link, self.by, self.rate
        if self.slides:
            t = self.bearing.along[FRAME]
            s.turn_with(link, FRAME)
            s.carry(link, t * (c * s.w[by]), t * (c * s.e[by]))
            return
        s.carry(link, 0j, 0j)
        if self.by_slides:
            t = self.mesh.along
            s.turn(link, c * dot(s.v[by], t), c * dot(s.a[by], t))
        else:
            s.turn(link, c * s.w[by], c * s.e[by])

    # ------------------------------------------------------------ forces

    def held(self, s: State, force: Array, moment: Array) -> tuple[Array, Array, Array]:
        """The force of `by` on the link in the teeth, and the force and moment of the frame on it, under its load,
        which is reduced to its reference point; complex N, N m, (..., P)."""
        mesh, link = self.mesh, self.link
        if not self.slides:
            teeth = mesh.pressed(link, -moment / mesh.radius(link))
            return teeth, -(force + teeth), 0.0
        across = 1j * mesh.outward(link)
        teeth = mesh.pressed(link, -dot(force, across))
        about = moment + cross(mesh.pitch_point - s.r[link], teeth)
        return teeth, -(force + teeth), -about
