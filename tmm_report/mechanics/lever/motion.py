"""Motion of a whole mechanism: the driving link, then its groups in the order of assembly.

Arrays are (..., P): variants, then positions of the driving link.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import field, fields, replace
from functools import cached_property, partial
from typing import Any

import numpy as np

from tmm_report.mechanics.calculus.variants import one
from tmm_report.mechanics.calculus.vectors import is_zero
from tmm_report.mechanics.lever.assur_groups import Structure
from tmm_report.mechanics.lever.dyads import Dyad, State, dyad
from tmm_report.mechanics.lever.high_class.newton import HigherGroup, Known
from tmm_report.mechanics.lever.mechanism import FRAME, Mechanism
from tmm_report.records import dataclass

Array = Any
SINGULAR = (
    1e-6  # closeness of a group below which velocities have lost half of their digits and lines cross nowhere
)


@dataclass(frozen=True, eq=False)
class Linkage:
    """A mechanism ready to be solved: its structure, and its groups with the assemblies they are in."""

    structure: Structure
    groups: tuple[Dyad | HigherGroup, ...]
    straight: Any = None  # the same as straight lines of numpy, where it was compiled (see `compiled`)

    @property
    def mechanism(self) -> Mechanism:
        return self.structure.mechanism

    @cached_property
    def carriers(self) -> dict[str, str]:
        """Point -> the link whose motion gives the point's: of those that share it, the one found first."""
        order = [FRAME, *self.structure.order]
        links = self.mechanism.links
        return {p: next(n for n in order if p in links[n].points) for p in self.mechanism.point_names}

    @cached_property
    def arms(self) -> dict[str, tuple[str, Array]]:
        """Point -> a link that has it, and the point's arm about that link's reference point, the link's axes.

        Of links that share the point, one whose reference point it is (arm 0), else the one found first.
        """
        driver = self.mechanism.driver.link
        origins: dict[str, Array] = {FRAME: 0j, driver: self.structure.driver_pair.at[driver]}
        origins |= {wheel.link: wheel.bearing.at[wheel.link] for wheel in self.structure.wheels}
        for group in self.groups:
            origins |= {link: pair.at[link] for link, pair in group.references.items()}
            origins |= {wheel.link: wheel.bearing.at[wheel.link] for wheel in group.group.wheels}
        arms: dict[str, tuple[str, Array]] = {}
        for link, origin in origins.items():
            for point, at in self.mechanism.links[link].points.items():
                if point not in arms or (is_zero(at - origin) and not is_zero(arms[point][1])):
                    arms[point] = link, at - origin
        return arms

    @cached_property
    def axes(self) -> tuple[int, ...]:
        """Shape of the variants' axes: (V, 1) where numbers of the mechanism are arrays, else ()."""
        m = self.mechanism
        numbers = [m.driver.omega]
        for link in m.links.values():
            numbers += [*link.points.values(), link.mass, link.inertia]
        for guide in m.guides.values():
            numbers += [guide.through, guide.direction]
        for slide in m.slides:
            numbers += [slide.through, slide.direction]
        return np.broadcast_shapes(*(np.shape(x) for x in numbers))


@dataclass(frozen=True, eq=False)
class Motion:
    """Positions, velocities and accelerations of every link (`state`) and named point at driver angles `phi`.

    `phi`: (..., P), rad, angle of the driving link's x axis; `omega`: rad/s; `shape`: that of all results. SI. `phase`:
    of a driving link that moves by a law of the time, its phase, rad.
    `limits`: label of a group -> where its motion is the limit from its neighbours (see `meeting`), (..., P) of bool.
    """

    linkage: Linkage
    phi: Array
    omega: Array
    state: State
    shape: tuple[int, ...]
    phase: Array | None = None
    limits: dict[str, Array] = field(default_factory=dict, repr=False)
    _arms: dict[str, tuple[str, Array]] = field(default_factory=dict, repr=False)

    @cached_property
    def point_index(self) -> dict[str, int]:
        return {point: k for k, point in enumerate(self.linkage.carriers)}

    @cached_property
    def places(self) -> Array:
        """World places of all named points, (N, ..., P), m; row `point_index[name]`."""
        return np.array([self.place(point) for point in self.point_index])

    @cached_property
    def velocities(self) -> Array:
        return np.array([self.velocity(point) for point in self.point_index])

    @cached_property
    def accelerations(self) -> Array:
        return np.array([self.acceleration(point) for point in self.point_index])

    def place(self, point: str) -> Array:
        """World place of a named point, (..., P), m."""
        link, arm = self._arm(point)
        r = self.state.r[link]
        return self._whole(r if arm is None else r + arm)

    def velocity(self, point: str) -> Array:
        link, arm = self._arm(point)
        return self._whole(self.state.v[link] if arm is None else self.state.velocity(link, arm))

    def acceleration(self, point: str) -> Array:
        link, arm = self._arm(point)
        return self._whole(self.state.a[link] if arm is None else self.state.acceleration(link, arm))

    def _arm(self, point: str) -> tuple[str, Array | None]:
        """The link that carries a point, and the point's arm in world axes; None at the reference point."""
        if point not in self._arms:
            link, arm = self.linkage.arms[point]
            self._arms[point] = link, None if is_zero(arm) else self.state.u[link] * arm
        return self._arms[point]

    def _whole(self, x: Array) -> Array:
        """A result in full shape: what does not depend on the position or the variant is one number inside."""
        return x if getattr(x, "shape", ()) == self.shape else np.broadcast_to(x, self.shape)

    def turn(self, link: str) -> Array:
        """Direction of a link's x axis, unit complex, (..., P)."""
        return self._whole(self.state.u[link])

    def angular_velocity(self, link: str) -> Array:
        return self._whole(self.state.w[link])

    def angular_acceleration(self, link: str) -> Array:
        return self._whole(self.state.e[link])

    @cached_property
    def closes(self) -> Array:
        """Where the mechanism can be assembled, (..., P) of bool."""
        return self._whole(np.isfinite(sum(self.state.u.values()) + sum(self.state.r.values())))

    @cached_property
    def sines(self) -> dict[str, Array]:
        """Group label -> how far it is from a singular position, 1 … 0, (..., P): of a dyad the sine of the angle of
        its two unknown directions, of a higher group the smallest singular value of its scaled Jacobian."""
        return {g.group.label: self._whole(g.closeness(self.state)) for g in self.linkage.groups}


def drive(linkage: Linkage, phi: Array, omega: Array | None = None, epsilon: Array = 0.0) -> State:
    """State of the frame and the driving link at angles `phi`, rad; `omega` in rad/s (default: the variant's),
    `epsilon` in rad/s²."""
    mechanism, pair = linkage.mechanism, linkage.structure.driver_pair
    link = mechanism.driver.link
    omega = mechanism.driver.omega if omega is None else omega
    s = State(phi=phi)
    for name, o, r, u in ((FRAME, 0j, 0j, 1 + 0j), (link, pair.at[link], pair.at[FRAME], np.exp(1j * phi))):
        s.o[name], s.r[name], s.u[name] = o, r, u
        s.carry(name, 0j, 0j)
        s.turn(name, *((omega, epsilon) if name == link else (0.0, 0.0)))
    for wheel in linkage.structure.wheels:
        wheel.place(s)
        wheel.move(s)
    return s


def positions(linkage: Linkage, phi: Array) -> State:
    """Poses only, no rates: what root finding and sketches need."""
    with np.errstate(invalid="ignore", divide="ignore"):
        s = drive(linkage, phi)
        for group in linkage.groups:
            group.place(s)
    return s


def solve(linkage: Linkage, phi: Array, omega: Array | None = None, epsilon: Array = 0.0) -> Motion:
    """Motion at driver angles `phi`, (P,) or (..., P), rad, at `omega`, rad/s (default: the variant's), and `epsilon`,
    rad/s². What does not close is nan in its position only."""
    lines = linkage.straight
    if lines is not None and omega is None and np.ndim(phi) and lines.serves(linkage):
        found: Motion = lines.motion(linkage, phi)
        return found
    omega = linkage.mechanism.driver.omega if omega is None else omega
    with np.errstate(invalid="ignore", divide="ignore"):
        s = drive(linkage, phi, omega, epsilon)
        for group in linkage.groups:
            group.place(s)
            group.move(s)
    shape = np.broadcast_shapes(linkage.axes, np.shape(phi), np.shape(omega))
    return Motion(linkage, phi, omega, s, shape)


def solve_by_law(linkage: Linkage, phase: Array) -> Motion:
    """Motion of a driving link that moves by a law of the time, at its phases 2π t/T, rad."""
    law = linkage.mechanism.driver.law
    assert law is not None
    phi, omega, epsilon = law.of_phase(phase)
    return replace(solve(linkage, phi, omega, epsilon), phase=np.asarray(phase, dtype=float))


def apart(motion: Motion, linkages: Sequence[Linkage]) -> list[Motion]:
    """The motions of variants that were solved together, each with the linkage that it has by itself."""
    parts = {item.name: getattr(motion.state, item.name) for item in fields(State)}
    return [
        Motion(
            linkage,
            one(motion.phi, v),
            one(motion.omega, v),
            State(**{name: one(part, v) for name, part in parts.items()}),
            motion.shape[1:],
        )
        for v, linkage in enumerate(linkages)
    ]


def known_motion(before: Linkage) -> Known:
    """Motion of the driving link and the groups before another, rates by the driver's angle."""
    return partial(_known_state, before)


def _known_state(before: Linkage, phi: Array) -> State:
    return solve(before, phi, 1.0).state


def linkage_of(structure: Structure, signs: Sequence[int]) -> Linkage:
    """A Linkage with the given roots, one a group."""
    groups = zip(structure.groups, signs, strict=True)
    return Linkage(structure, tuple(dyad(structure.mechanism, group, sign) for group, sign in groups))
