"""Constraint equations of a whole mechanism in the coordinates x, y, θ of every moving link: no groups, no order.

A pivot is two equations, a slide two (across the guide, and of the turning), the driving link's angle one: as many as
coordinates, 3n = 2p5 + 1. One Jacobian serves positions (Newton's method), velocities and accelerations:

    Φ(q, φ) = 0,      Φ_q q' = −Φ_φ,      Φ_q q'' = −(Φ_q q')_q q',        ' = d/dφ

Lengths are reckoned over the mechanism's `size`, so that x and y weigh as angles do. q is (..., P, 3n).
Source: Haug, Computer aided kinematics and dynamics of mechanical systems, ch. 3; Nikravesh, Computer-aided analysis
of mechanical systems, ch. 4.
"""

from __future__ import annotations

from functools import cached_property, lru_cache
from typing import Any

import numpy as np

from tmm_report.mechanics.lever.assur_groups import Pair
from tmm_report.mechanics.lever.dyads import State
from tmm_report.mechanics.lever.loop_equations import solve_each
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.mechanics.lever.motion import Linkage, Motion
from tmm_report.mechanics.rivals.motion.joints import Joints, joints, line_of, spread, times, wrapped
from tmm_report.records import dataclass

Array = Any


@dataclass(frozen=True, eq=False)
class Coordinates:
    """The equations of one mechanism. Rows 2p, 2p + 1 belong to pair p of the structure, the last to the driving link;
    columns 3i, 3i + 1, 3i + 2 are x, y (over `size`) and θ of link i."""

    linkage: Linkage

    # ------------------------------------------------------------ what does not change with the position

    @cached_property
    def links(self) -> list[str]:
        """The moving links; the frame comes behind them, with columns that are cut off."""
        return [*self.linkage.mechanism.moving, FRAME]

    @property
    def count(self) -> int:
        """Number of coordinates, 3n."""
        return 3 * (len(self.links) - 1)

    @cached_property
    def origins(self) -> dict[str, complex]:
        """The links' reference points in their own axes, m: those of the linkage, so that states can be compared."""
        driver = self.linkage.mechanism.driver.link
        found = {FRAME: 0j, driver: complex(self.linkage.structure.driver_pair.at[driver])}
        for group in self.linkage.groups:
            found |= {link: complex(pair.at[link]) for link, pair in group.references.items()}
        return found

    @cached_property
    def pairs(self) -> list[Pair]:
        return self.linkage.structure.pairs

    @cached_property
    def size(self) -> float:
        """The longest arm of a moving link, m; where there is none, the farthest joint of the frame."""
        arms = [pair.at[link] - self.origins[link] for pair in self.pairs for link in pair.links]
        moving = [
            pair.at[link] - self.origins[link] for pair in self.pairs for link in pair.links if link != FRAME
        ]
        sizes = (max((abs(arm) for arm in some), default=0.0) for some in (moving, arms))
        return next((float(size) for size in sizes if size > 0), 1.0)

    @cached_property
    def _pivots(self) -> Joints:
        return joints(self.pairs, "R", self._places)

    @cached_property
    def _slides(self) -> Joints:
        """The link that carries the guide first, the one that slides second."""
        return joints(self.pairs, "P", self._places)

    def _places(self, link: str, at: complex) -> tuple[int, complex]:
        """A link by number, and a place in its axes from its reference point, over the size."""
        return self.links.index(link), complex(at - self.origins[link]) / self.size

    @cached_property
    def driver(self) -> int:
        """Column of the driving link's angle."""
        return 3 * self.links.index(self.linkage.mechanism.driver.link) + 2

    @cached_property
    def _constant(self) -> Array:
        """The part of the Jacobian that never changes, (3n, 3n + 3)."""
        J = np.zeros((self.count, self.count + 3))
        one, two = self._pivots.index.T
        for row, of in ((self._pivots.rows, 0), (self._pivots.rows + 1, 1)):
            J[row, 3 * one + of], J[row, 3 * two + of] = 1.0, -1.0
        carrier, slider = self._slides.index.T
        J[self._slides.rows + 1, 3 * slider + 2], J[self._slides.rows + 1, 3 * carrier + 2] = 1.0, -1.0
        J[-1, self.driver] = 1.0
        return J

    # ------------------------------------------------------------ the equations

    def _split(self, q: Array) -> tuple[Array, Array]:
        """Places, complex, over the size, and angles, rad, of all links, the frame last: (n + 1, ..., P)."""
        parts = np.moveaxis(q, -1, 0)
        nothing = np.zeros((1, *parts.shape[1:]))
        z = np.concatenate([parts[0::3] + 1j * parts[1::3], nothing])
        return z, np.concatenate([parts[2::3], nothing])

    def residual(self, q: Array, phi: Array) -> Array:
        """Φ at driver angles `phi` (..., P), rad: by how much the pairs are apart, (..., P, 3n)."""
        return self.equations(q, phi)[0]

    def equations(self, q: Array, phi: Array) -> tuple[Array, Array]:
        """Φ and its Jacobian Φ_q, (..., P, 3n, 3n)."""
        z, angle = self._split(q)
        U = np.exp(1j * angle)
        left = np.empty((self.count, *z.shape[1:]))
        J = np.empty((*z.shape[1:], *self._constant.shape))
        J[...] = self._constant
        pivots, slides = self._pivots, self._slides
        one, two = pivots.index.T
        s1, s2 = times(U[one], pivots.arms[:, 0]), times(U[two], pivots.arms[:, 1])
        gap = z[one] + s1 - z[two] - s2
        left[pivots.rows], left[pivots.rows + 1] = gap.real, gap.imag
        for row, turned1, turned2 in ((pivots.rows, -s1.imag, s2.imag), (pivots.rows + 1, s1.real, -s2.real)):
            J[..., row, 3 * one + 2], J[..., row, 3 * two + 2] = (
                np.moveaxis(turned1, 0, -1),
                np.moveaxis(turned2, 0, -1),
            )
        if len(slides.rows):
            self._slide(slides, z, angle, U, left, J)
        left[-1] = wrapped(angle[self.driver // 3] - phi)
        return np.moveaxis(left, 0, -1), J[..., : self.count]

    def _slide(self, slides: Joints, z: Array, angle: Array, U: Array, left: Array, J: Array) -> None:
        """The slides' equations t × (B − A) = 0 and θ_b = θ_a + constant; A, B points of the line in both links."""
        carrier, slider = slides.index.T
        back, gap, A, B = line_of(slides, z, U)
        left[slides.rows] = (back * gap).imag
        turn = np.angle(slides.along[:, 1] / slides.along[:, 0])
        left[slides.rows + 1] = wrapped(angle[slider] - angle[carrier] + spread(turn, angle))
        # t turns with its link, and so does the point A of it: i·(B − A) and i·A are one, i·(z_b + s_b − z_a)
        entries = (
            (3 * slider, back.imag), (3 * slider + 1, back.real), (3 * slider + 2, (1j * back * B).imag),
            (3 * carrier, -back.imag), (3 * carrier + 1, -back.real),
            (3 * carrier + 2, (-1j * back * (gap + A)).imag),
        )  # fmt: skip
        for column, value in entries:
            J[..., slides.rows, column] = np.moveaxis(value, 0, -1)

    def bend(self, q: Array, rate: Array) -> Array:
        """−(Φ_q q')_q q' of the coordinates and their rates by φ: the right side of accelerations, (..., P, 3n)."""
        z, angle = self._split(q)
        dz, w = self._split(rate)
        U = np.exp(1j * angle)
        found = np.zeros((self.count, *z.shape[1:]))
        one, two = self._pivots.index.T
        s1, s2 = times(U[one], self._pivots.arms[:, 0]), times(U[two], self._pivots.arms[:, 1])
        normal = w[one] ** 2 * s1 - w[two] ** 2 * s2
        found[self._pivots.rows], found[self._pivots.rows + 1] = normal.real, normal.imag
        slides = self._slides
        if len(slides.rows):
            carrier, slider = slides.index.T
            back, gap, A, B = line_of(slides, z, U)
            wa, wb = w[carrier], w[slider]
            moved = dz[slider] + 1j * wb * B - dz[carrier] - 1j * wa * A
            bent = -(wb**2) * B + wa**2 * A
            found[slides.rows] = -(back * (bent - 2j * wa * moved - wa**2 * gap)).imag
        return np.moveaxis(found, 0, -1)

    def rates(self, q: Array, phi: Array) -> tuple[Array, Array]:
        """q' and q'' by the driver's angle; nan in a singular position."""
        _, J = self.equations(q, phi)
        first = solve_each(J, self._drives(q))
        return first, solve_each(J, self.bend(q, first))

    def _drives(self, q: Array) -> Array:
        """−Φ_φ: the driving link's angle alone depends on φ."""
        found = np.zeros(q.shape)
        found[..., -1] = 1.0
        return found

    @cached_property
    def blocks(self) -> list[tuple[Array, Array]]:
        """Rows and columns of every group: the equations of its pairs, square in the coordinates of its links."""
        found = []
        for group in self.linkage.structure.groups:
            own = {id(pair) for pair in (*group.outer, *group.inner)}
            rows = [2 * p + k for p, pair in enumerate(self.pairs) if id(pair) in own for k in (0, 1)]
            columns = [3 * self.links.index(link) + k for link in group.links for k in (0, 1, 2)]
            found.append((np.array(rows)[:, None], np.array(columns)))
        return found

    def sines(self, J: Array) -> Array:
        """Of every group the determinant of its part of the Jacobian, over its columns, (..., P, groups):
        0 in a singular position, and of another sign in the assembly that meets this one there."""
        parts = [J[..., rows, columns] for rows, columns in self.blocks]
        if not parts:  # the driving link alone
            return np.empty((*J.shape[:-2], 0))
        return np.stack(
            [np.linalg.det(part) / np.prod(np.linalg.norm(part, axis=-2), axis=-1) for part in parts], axis=-1
        )

    # ------------------------------------------------------------ single points

    def column(self, link: str) -> int:
        """Column of a moving link's angle; its x and y stand before it."""
        return 3 * self.links.index(link) + 2

    def arm(self, q: Array, link: str, at: complex) -> Array:
        """From a moving link's reference point to the point `at` of its axes, over the size, (..., P)."""
        turn = np.exp(1j * q[..., self.column(link)])
        return turn * ((at - self.origins[link]) / self.size)

    def place(self, q: Array, link: str, at: complex) -> Array:
        """The place of that point, over the size, (..., P)."""
        column = self.column(link)
        return q[..., column - 2] + 1j * q[..., column - 1] + self.arm(q, link, at)

    # ------------------------------------------------------------ to and from a motion

    def read(self, motion: Motion) -> Array:
        """q of a solved motion, (P, 3n)."""
        s = motion.state
        rows = []
        for link in self.links[:-1]:
            r = s.r[link] + s.u[link] * (self.origins[link] - s.o[link])
            rows += [np.real(r) / self.size, np.imag(r) / self.size, np.angle(s.u[link])]
        return np.stack([np.broadcast_to(row, motion.shape) for row in rows], axis=-1)

    def motion(self, phi: Array, q: Array, first: Array, second: Array) -> Motion:
        """The motion of coordinates and their derivatives by the driver's angle, at its constant angular velocity."""
        omega = self.linkage.mechanism.driver.omega
        s = State(phi=phi)
        s.o[FRAME], s.r[FRAME], s.u[FRAME] = 0j, 0j, 1 + 0j
        s.carry(FRAME, 0j, 0j)
        s.turn(FRAME, 0.0, 0.0)
        (z, angle), (dz, w), (ddz, e) = (self._split(x) for x in (q, first, second))
        for k, link in enumerate(self.links[:-1]):
            s.o[link], s.r[link], s.u[link] = self.origins[link], z[k] * self.size, np.exp(1j * angle[k])
            s.carry(link, dz[k] * (self.size * omega), ddz[k] * (self.size * omega**2))
            s.turn(link, w[k] * omega, e[k] * omega**2)
        return Motion(self.linkage, phi, omega, s, np.shape(phi))


@lru_cache(maxsize=8)
def coordinates(linkage: Linkage) -> Coordinates:
    """The equations of a linkage, set up once."""
    return Coordinates(linkage)
