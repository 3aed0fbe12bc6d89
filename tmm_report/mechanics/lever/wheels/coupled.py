"""A link that a mesh moves: known at once when the other link of its mesh and their carrier are, like the driving link.

With one lower pair and one higher pair it is a group of one link, 3·1 = 2·1 + 1. Its forces are statically determinate:
moments about its axis (of a rack, forces along its guide) give the tangential force of the teeth, the rest its bearing.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from tmm_report.mechanics.calculus.vectors import cross, dot
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.mechanics.lever.wheels.mesh import Mesh, Way
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.mechanics.lever.assur_groups import Pair
    from tmm_report.mechanics.lever.dyads import State

Array = Any
WHOLE = 1e-12  # a ratio nearer to a whole number than this part is one


@dataclass(frozen=True, eq=False)
class Root:
    """A link known without meshes, of which others follow by `rate`: by its angle, or by its `way` as a slider.
    `leads`: whether it is the driving link. `middle`: of a link that swings the middle of its swing, unit complex, from
    which its angle goes 180° both ways."""

    link: str
    rate: float
    way: Way | None = None
    leads: bool = False
    middle: complex = 1 + 0j

    @property
    def whole(self) -> bool:
        """Whether full turns of it are full turns of what follows."""
        return self.way is None and abs(self.rate - round(self.rate)) < WHOLE * max(1.0, abs(self.rate))

    def coordinate(self, s: State) -> Array:
        if self.way is not None:
            return dot(s.world(self.link, self.way.own) - self.way.through, self.way.along)
        if self.leads:
            return s.phi
        return np.angle(self.middle) + np.angle(s.u[self.link] / self.middle)

    def rates(self, s: State) -> tuple[Array, Array]:
        """First and second derivative of the coordinate by the time."""
        if self.way is not None:
            return dot(s.v[self.link], self.way.along), dot(s.a[self.link], self.way.along)
        return s.w[self.link], s.e[self.link]


@dataclass(frozen=True, eq=False)
class Coupled:
    """`link`, moved by link `by`. `bearing`: its pair with the frame or the carrier; `contact`: the higher pair,
    (by, link). Its coordinate, angle of its x axis or way of a slider, is `zero` + Σ rate·coordinate over `roots`."""

    mesh: Mesh
    link: str
    by: str
    bearing: Pair
    contact: Pair
    zero: float = 0.0
    roots: tuple[Root, ...] = ()

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
    def share(self) -> float:
        """dx/dc, by the coordinate of a moving carrier."""
        return -self.mesh.share / self.mesh.ratio if self.backwards else self.mesh.share

    @property
    def slides(self) -> bool:
        return self.bearing.kind == "P"

    @property
    def by_slides(self) -> bool:
        return self.mesh.kind == "rack" and not self.slides

    @property
    def whole(self) -> bool:
        """Whether the link turns a whole number of times with each turn of all that move it."""
        return not self.slides and all(root.whole for root in self.roots)

    @property
    def by_turns(self) -> float:
        """Turns for each turn of the driving link, but for whole ones by links between; m/rad of a slider."""
        return sum(root.rate for root in self.roots if root.leads)

    # ------------------------------------------------------------ motion

    def coordinate(self, s: State) -> Array:
        """Angle of the link's x axis, rad, or the way of a slider along its guide, m, (..., P)."""
        return self.zero + sum(root.rate * root.coordinate(s) for root in self.roots)

    def rates(self, s: State) -> tuple[Array, Array]:
        """First and second derivative of the coordinate by the time."""
        each = [(root.rate, *root.rates(s)) for root in self.roots]
        return sum(c * w for c, w, _ in each), sum(c * e for c, _, e in each)

    def place(self, s: State) -> None:
        """Add the link's pose to the state."""
        link, own = self.link, self.bearing
        s.o[link] = own.at[link]
        if self.slides:
            t = own.along[FRAME]
            s.r[link] = self.mesh.through + t * self.coordinate(s)
            s.u[link] = t * np.conj(own.along[link]) + 0j
            return
        carrier = own.other(link)
        s.r[link] = s.world(carrier, own.at[carrier])
        if self.whole:
            u: Array = np.exp(1j * self.zero)
            for root in self.roots:
                u = u * s.u[root.link] ** round(root.rate)
            s.u[link] = u
        else:
            s.u[link] = np.exp(1j * self.coordinate(s))

    def move(self, s: State) -> None:
        """Add the link's rates to the state."""
        link, (first, second) = self.link, self.rates(s)
        if self.slides:
            t = self.bearing.along[FRAME]
            s.turn_with(link, FRAME)
            s.carry(link, t * first, t * second)
            return
        carrier = self.bearing.other(link)
        if carrier == FRAME:
            s.carry(link, 0j, 0j)
        else:
            arm = s.r[link] - s.r[carrier]
            s.carry(link, s.velocity(carrier, arm), s.acceleration(carrier, arm))
        s.turn(link, first, second)

    # ------------------------------------------------------------ forces

    def held(
        self, s: State, force: Array, moment: Array, flank: Array | None = None
    ) -> tuple[Array, Array, Array]:
        """The force of `by` on the link in the teeth, and the force and moment of its bearing on it, under its load,
        which is reduced to its reference point; complex N, N m, (..., P). `flank`: as of `Mesh.pressed`."""
        mesh, link = self.mesh, self.link
        if not self.slides:
            teeth = mesh.turn(s) * mesh.pressed(link, -moment / mesh.radius(link), flank)
            return teeth, -(force + teeth), 0.0
        across = 1j * mesh.outward(link)
        teeth = mesh.pressed(link, -dot(force, across), flank)
        about = moment + cross(mesh.touches(s) - s.r[link], teeth)
        return teeth, -(force + teeth), -about

    def flank(self, s: State, teeth: Array) -> Array:
        """Which flank a force in the teeth presses: the sign of its tangential part, (..., P)."""
        across = 1j * self.mesh.turn(s) * self.mesh.outward(self.link)
        return np.where(dot(teeth, across) >= 0, 1.0, -1.0)


def coupled(
    mesh: Mesh, link: str, bearing: Pair, contact: Pair, before: Sequence[Coupled], driver: str
) -> Coupled:
    """The link that follows by the mesh from what is known: `before` are those that follow so already."""
    bare = Coupled(mesh, link, mesh.other(link), bearing, contact)
    done = {one.link: one for one in before}
    zero = -mesh.phase / mesh.ratio if bare.backwards else mesh.phase
    roots: dict[tuple[str, bool], Root] = {}
    ways: Mapping[str, Way | None] = {
        mesh.carrier: mesh.carried,
        bare.by: Way(mesh.own, mesh.through, mesh.along) if bare.by_slides else None,
    }
    for name, rate in ((bare.by, bare.rate), (mesh.carrier, bare.share)):
        if name == FRAME:
            continue
        first = done.get(name)
        zero += rate * first.zero if first else 0.0
        of = first.roots if first else (Root(name, 1.0, ways[name], name == driver),)
        for root in of:
            key = (root.link, root.way is None)
            so_far = roots[key].rate if key in roots else 0.0
            roots[key] = replace(root, rate=so_far + rate * root.rate)
    return replace(bare, zero=zero, roots=tuple(roots.values()))
