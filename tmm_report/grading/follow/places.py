"""Places from places: where the links and points would be by the student's own angles and coordinates."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import field
from typing import Any

import numpy as np

from tmm_report.grading.follow.known import NONE, NOWHERE, Known, derived, derived_together, first
from tmm_report.grading.follow.sheet import Names, Other, Same, Sheet
from tmm_report.mechanics.calculus.vectors import dot, is_zero
from tmm_report.mechanics.lever import from_read_values
from tmm_report.mechanics.lever.dyads import Dyad, State
from tmm_report.mechanics.lever.high_class.newton import HigherGroup
from tmm_report.mechanics.lever.mechanism import FRAME, Link
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.mechanics.lever.vector_equations import moving_points, turning_links
from tmm_report.records import dataclass

Array = Any
Group = Dyad | HigherGroup
FAR = 0.02  # of the mechanism's size, rad


@dataclass(frozen=True)
class Travelling:
    """An output of the results: its displacement, velocity and acceleration say again what a point or link does.

    `name`: the slider's point, or the rocker's link; `direction`: unit vector, or ±1; `S`: its displacement.
    """

    slider: bool
    name: str
    direction: complex
    S: Array


@dataclass(eq=False)
class Poses:
    """How the links stand: `u`, `r` as in `dyads.State`; `points`: places of the moving points, m."""

    motion: Motion
    sheet: Sheet
    travels: tuple[Travelling, ...]
    u: dict[str, Known] = field(default_factory=dict)
    r: dict[str, Known] = field(default_factory=dict)
    points: dict[str, Known] = field(default_factory=dict)
    phi: Known = field(default_factory=lambda: Known(0.0))

    def __post_init__(self) -> None:
        linkage = self.motion.linkage
        self.moving, self.turning = set(moving_points(linkage)), set(turning_links(linkage))
        self.u[FRAME], self.r[FRAME] = Known(1 + 0j), Known(0j)
        self._driver(linkage.mechanism.driver.link)
        for group in linkage.groups:
            self._group(group)

    # ------------------------------------------------------------ what others ask

    def place(self, point: str) -> Known:
        """Place of a named point, a fixed one too."""
        return self.points.get(point) or Known(self.motion.place(point))

    def arm(self, link: str, start: str, end: str) -> Known:
        """From one point to another in world axes: along the link where both are on it, else as they stand."""
        on = self.link(link).points
        if start in on and end in on:
            local = on[end] - on[start]
            return derived(self.motion.turn(link) * local, lambda u: u * local, self.u[link])
        right = self.motion.place(end) - self.motion.place(start)
        return derived(right, lambda a, b: b - a, self.place(start), self.place(end))

    def link(self, name: str) -> Link:
        return self.motion.linkage.mechanism.links[name]

    def reference(self, link: str) -> str | None:
        """The named point at the link's reference point."""
        o = self.motion.state.o[link]
        return next((p for p, at in self.link(link).points.items() if is_zero(at - o)), None)

    def state(self) -> State:
        """Poses of all links, no rates."""
        right = self.motion.state
        s = State(o=right.o, phi=self.phi.value)
        for link in right.u:
            s.u[link], s.r[link] = self.u[link].value, self.r[link].value
        return s

    def known(self, links: tuple[str, ...]) -> Known:
        """Whether any of the links' poses is the student's: a Known without a value."""
        each = [part[link] for link in links for part in (self.u, self.r) if part[link].sources]
        if not each:
            return Known(0.0)
        told, sources = NOWHERE, NONE
        for one in each:
            told, sources = told | one.told, sources | one.sources
        return Known(0.0, told, sources)

    @property
    def keys(self) -> set[str]:
        """Keys of the numbers that say where something is."""
        keys = {f"{axis}_{point}" for point in self.moving for axis in "xy"}
        keys |= {f"phi_{link}" for link in self.turning}
        return keys | {f"S_{t.name}" if t.slider else f"psi_{t.name}" for t in self.travels}

    @property
    def elsewhere(self) -> bool:
        """Whether the student has a point or link far from its right place, beyond what a drawing misses it by."""
        right = self.motion
        far = [
            np.abs(known.value - right.place(point)) > FAR * np.nanmax(np.abs(right.places))
            for point, known in self.points.items()
            if known.sources
        ]
        far += [
            np.abs(known.value - right.turn(link)) > FAR for link, known in self.u.items() if known.sources
        ]
        return any(one.any() for one in far)

    # ------------------------------------------------------------ solving

    def _driver(self, link: str) -> None:
        self._own(link, Known(self.motion.turn(link)), Known(self.motion.state.r[link]))
        self.phi = derived(self.motion.phi, np.angle, self.u[link])

    def _group(self, group: Group) -> None:
        """The links of a group as they are assembled on the links before it, then as the student has them."""
        links, s = group.links, self.motion.state
        carriers = sorted({link for pair in group.group.outer for link in pair.links} - set(links))
        rights = [part for link in links for part in (self.motion.turn(link), s.r[link])]
        inputs = [self.known(tuple(carriers)), *self._shifted(group), self.phi]
        found = derived_together(rights, lambda *_: self._assembled(group, carriers), *inputs)
        for k, link in enumerate(links):
            self._own(link, found[2 * k], found[2 * k + 1])

    def _shifted(self, group: Group) -> list[Known]:
        return [self.points[name] for name in self._outer_joints(group).values() if name in self.points]

    def _outer_joints(self, group: Group) -> dict[str, str]:
        """Link before the group -> the joint by which the group hangs on it."""
        pairs = [pair for pair in group.group.outer if pair.kind == "R" and pair.links[0] not in group.links]
        return {pair.links[0]: pair.name for pair in pairs}

    def _assembled(self, group: Group, carriers: list[str]) -> list[Array]:
        s = State(o=dict(self.motion.state.o), phi=self.phi.value)
        for link in carriers:
            s.u[link], s.r[link] = self.u[link].value, self.r[link].value
        for link, joint in self._outer_joints(group).items():  # the joint is where the student has it
            if joint in self.points:
                s.r[link] = self.points[joint].value - s.u[link] * (self.link(link).points[joint] - s.o[link])
        from_read_values.place(s, group)
        return [part for link in group.links for part in (s.u[link], s.r[link])]

    def _own(self, link: str, u: Known, r: Known) -> None:
        """A link's pose and points: the student's own, elsewhere as assembled."""
        self._joints(link, u, r)
        self.u[link] = self._turn(link, u, [self._by_points(link), u])
        reference = self.reference(link)
        own = reference is not None and reference in self.points
        self.r[link] = self.points[str(reference)] if own else r
        self._points(link, u, r)

    def first_of(self, link: str) -> list[str]:
        """Moving points that the link is the first to have."""
        return [point for point, _ in self._carried(link)]

    def _carried(self, link: str) -> Iterator[tuple[str, Array]]:
        """Moving points that the link is the first to have, and their arms about its reference point."""
        carriers, o = self.motion.linkage.carriers, self.motion.state.o[link]
        for point, at in self.link(link).points.items():
            if point in self.moving and carriers[point] == link:
                yield point, at - o

    def _joints(self, link: str, u: Known, r: Known) -> None:
        """Joints as they are assembled, or as the student has them, before the link's turn is known."""
        for point, arm in self._carried(link):
            placed = self._at(point, arm, u, r)
            own = self.sheet.own_vector(self._names(point), placed.value)
            self.points[point] = first(placed.value, [*own, placed])

    def _points(self, link: str, u: Known, r: Known) -> None:
        """Points of the link: by its own turn and place, or as it was assembled."""
        for point, arm in self._carried(link):
            by_own = self._at(point, arm, self.u[link], self.r[link])
            choices = [by_own, self._at(point, arm, u, r)]
            self.points[point] = self.sheet.vector(self._names(point), self.motion.place(point), *choices)

    def _at(self, point: str, arm: Array, u: Known, r: Known) -> Known:
        return derived(self.motion.place(point), lambda u, r: r + u * arm, u, r)

    def _by_points(self, link: str) -> Known:
        """The turn of a link by the farthest from its reference point of the joints that the student has placed."""
        o, reference = self.motion.state.o[link], self.reference(link)
        joints = self.motion.linkage.mechanism.links_at
        told = [
            (float(np.max(np.abs(at - o))), point, at - o)
            for point, at in self.link(link).points.items()
            if point in self.points and point != reference and len(joints(point)) > 1 and self._has(point)
        ]
        if not told or reference is None:
            return Known(self.motion.turn(link))
        _, point, arm = max(told, key=lambda one: one[0])

        def turned(start: Array, end: Array) -> Array:
            u = (end - start) / arm
            return u / np.abs(u)

        return derived(self.motion.turn(link), turned, self.place(reference), self.points[point])

    def _has(self, point: str) -> bool:
        names = self._names(point)
        return self.sheet.gives(names.x, names.y) or bool(names.other and self.sheet.gives(names.other.key))

    def _turn(self, link: str, u: Known, choices: list[Known]) -> Known:
        right = self.motion.turn(link)
        if link not in self.turning:
            return u
        return self.sheet.turn(f"phi_{link}", right, *choices, same=self._rocker(link, right))

    def _rocker(self, link: str, right: Array) -> Same | None:
        travel = next((t for t in self.travels if not t.slider and t.name == link), None)
        if travel is None:
            return None
        S = travel.S

        def of(u: Array) -> Array:
            return S + np.angle(u / right)

        return Same(f"psi_{link}", of, lambda psi: right * np.exp(1j * (psi - S)))

    def _names(self, point: str) -> Names:
        travel = next((t for t in self.travels if t.slider and t.name == point), None)
        if travel is None:
            return Names("", f"x_{point}", f"y_{point}")
        S, along, right = travel.S, travel.direction, self.motion.place(point)
        other = Other(
            f"S_{point}",
            lambda place: S + dot(along + 0j, place - right),
            lambda number, _: right + (number - S) * along,
        )
        return Names("", f"x_{point}", f"y_{point}", other)
