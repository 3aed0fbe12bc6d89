"""The moving scheme: what each link looks like in its own axes, and where these axes are in every position.

Between two positions the script finds a link's pose by the polynomial of the fifth degree that has the places, the
velocities and the accelerations of both: of x and y of its origin and of its angle, so that a link stays stiff by
itself. Whether its joints stay together is looked up here: where they part by more than `OPEN` the script shows
positions alone, and nothing between.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cached_property
from typing import Any

import numpy as np

from tmm_report.chapters.lever.kinetostatics.quantities import positions as loads
from tmm_report.chapters.lever.schemes import schemes_of, ties_of
from tmm_report.course import LeverFound
from tmm_report.figures.drawing import Drawing, svg
from tmm_report.figures.schemes.bodies import Body, number
from tmm_report.figures.schemes.view import View, view_of
from tmm_report.living.cycle import Cycle, places
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.records import dataclass
from tmm_report.report.page import Page

Array = Any
OPEN = 0.005  # mm of paper
BETWEEN = (0.25, 0.5, 0.75)  # where the joints are looked at, of the way between two positions
COORDINATE, ANGLE = 4, 6  # decimals of mm and rad


def seen(lever: LeverFound, cycle: Cycle, page: Page) -> View:
    """The mechanism in all positions of the script, at the scale of the note's schemes."""
    schemes = page.once(schemes_of, lever, page)
    return view_of(schemes.mechanism, *_seen(schemes.mechanism, cycle), schemes.scale, lever.sample)


def moving(lever: LeverFound, cycle: Cycle, view: View) -> dict[str, Any]:
    poses = Poses(cycle, view)
    return {
        "scale": view.motion.mu,
        "sample": lever.sample,
        "driver": view.driver,
        "block": _pair(view.block),
        "links": {name: _link(view, name, poses) for name in view.mechanism.moving},
        "points": _points(view),
        "ties": [
            [one.kind, *one.ends] for one in ties_of(lever) if all(isinstance(e, str) for e in one.ends)
        ],
        "cylinder": list(view.cylinder) if view.cylinder else None,
        "smooth": [int(one) for one in poses.smooth],
        "frame": svg(Drawing(tuple(view.frame()))),
        "forces": list(_forces(lever, cycle, view)),
    }


def _seen(mechanism: Any, cycle: Cycle) -> tuple[dict[str, Array], dict[str, Array]]:
    """Places of the points, m, and directions of the links at all positions."""
    return (
        {point: cycle.both(Motion.place, point) for point in mechanism.point_names},
        {link: cycle.both(Motion.turn, link) for link in mechanism.moving},
    )


def _pair(z: complex, digits: int = 3) -> list[float]:
    return [round(z.real, digits) + 0.0, round(z.imag, digits) + 0.0]


def _row(points: Any) -> list[float]:
    return [x for z in points for x in _pair(complex(z))]


def _link(view: View, name: str, poses: Poses) -> dict[str, Any]:
    body = view.shapes.get(name, Body())
    x, y, angle = poses.of[name]
    return {
        "pose": [*(places(one, COORDINATE) for one in (*x, *y)), *(places(one, ANGLE) for one in angle)],
        "bars": [_row(bar) for bar in body.bars],
        "plate": _row(body.plate),
        "blocks": [[*_pair(at), *_pair(along, 6)] for at, along in body.blocks],
        "outlines": [_row(outline) for outline in body.outlines],
        "rollers": [[*_pair(at), round(radius, 3)] for at, radius in body.rollers],
        "wheel": any(name in mesh.links for mesh in view.mechanism.meshes),
    }


def _points(view: View) -> dict[str, Any]:
    """Point -> its links, its place in the axes of the first that moves, mm, whether it is a joint."""
    found = {}
    for point in view.mechanism.point_names:
        links = view.mechanism.links_at(point)
        own = next((name for name in links if name != FRAME), FRAME)
        found[point] = [own, *_pair(view.motion.local(own, point), 5), len(links) > 1, links]
    return found


def _forces(lever: LeverFound, cycle: Cycle, view: View) -> Iterator[list[Any]]:
    """Key of each force and where it acts: a point, or its places, mm."""
    found = lever.kinetostatics
    if found is None:
        return
    links = view.mechanism.links
    for link in found.diagram.loading.gravity:
        if link in links:
            yield [loads.weight(link).key, str(links[link].mass_centre), "weight"]
    for link in found.diagram.loading.inertia:
        if link in links:
            yield [loads.inertia_force(link).key, str(links[link].mass_centre), "inertia"]
    for quantity, force in zip(loads.forces(found.given.forces), found.given.forces, strict=True):
        yield [quantity.key, force.at, "load"]
    table, diagram = found.table.statics.reactions, found.diagram.statics.reactions
    for key in diagram:
        by, on = diagram[key].pair.links
        at = cycle.merged(
            *(
                np.broadcast_to(one[key].at, s.motion.shape)
                for one, s in ((table, found.table), (diagram, found.diagram))
            )
        )
        at = at / view.motion.mu
        yield [loads.reaction(by, on).key, [places(at.real, 2), places(at.imag, 2)], "reaction"]


@dataclass(frozen=True, eq=False)
class Poses:
    """Of each link x and y of its origin, mm, and its angle, rad: each (3, Q), the value and its first and second
    derivative by the angle turned, rad."""

    cycle: Cycle
    view: View

    @cached_property
    def of(self) -> Mapping[str, tuple[Array, Array, Array]]:
        return {name: self._of(name) for name in self.view.mechanism.moving}

    def _of(self, name: str) -> tuple[Array, Array, Array]:
        both, mu, rate = self.cycle.both, self.view.motion.mu, abs(self.cycle.kinematics.omega)
        omega = both(Motion.angular_velocity, name) / rate
        epsilon = both(Motion.angular_acceleration, name) / rate**2
        angle = _unwrapped(np.angle(self.view.motion.axes[name]))
        place = self.view.motion.origins[name]
        velocity, acceleration = (both(of, name) for of in (_velocity, _acceleration))
        velocity, acceleration = velocity / (mu * rate), acceleration / (mu * rate**2)
        along = np.array([place, velocity, acceleration])
        return along.real, along.imag, np.array([angle, omega, epsilon])

    @cached_property
    def smooth(self) -> Array:
        """Whether there is a way between neighbouring positions on which all joints hold, (Q - 1,) of bool."""
        if len(self.cycle.turned) < 2:
            return np.zeros(0, dtype=bool)
        between = {name: [_hermite(one, self.cycle.turned) for one in self.of[name]] for name in self.of}
        still = np.zeros((len(BETWEEN), len(self.cycle.turned) - 1))
        origins = {name: x + 1j * y for name, (x, y, _) in between.items()} | {FRAME: still + 0j}
        turns = {name: np.exp(1j * angle) for name, (_, _, angle) in between.items()} | {FRAME: still + 1}
        holds = np.ones(still.shape, dtype=bool)
        with np.errstate(invalid="ignore"):
            for gap in self._gaps(origins, turns):
                holds &= np.abs(gap) <= OPEN
            for name in between:
                holds &= np.isfinite(origins[name]) & np.isfinite(turns[name])
        return holds.all(axis=0)

    def _gaps(self, origins: Mapping[str, Array], turns: Mapping[str, Array]) -> Iterator[Array]:
        """By how much joints part, and points leave their guides, mm."""
        motion, mechanism = self.view.motion, self.view.mechanism
        for point in mechanism.point_names:
            spots = [
                origins[n] + turns[n] * motion.local(n, point)
                for n in mechanism.links_at(point)
                if n in origins
            ]
            yield from (spot - spots[0] for spot in spots[1:])
        for slide in mechanism.slides:
            guide = mechanism.guides[slide.guide]
            if slide.link in origins and guide.link in origins:
                spot = origins[slide.link] + turns[slide.link] * number(slide.through) / motion.mu
                start = origins[guide.link] + turns[guide.link] * number(guide.through) / motion.mu
                along = turns[guide.link] * number(guide.direction)
                yield ((spot - start) * along.conj()).imag


def _velocity(motion: Motion, name: str) -> Array:
    """Of the origin of a link's axes, m/s."""
    s = motion.state
    return s.v[name] - 1j * s.w[name] * s.u[name] * s.o[name]


def _acceleration(motion: Motion, name: str) -> Array:
    """Of the origin of a link's axes, m/s²."""
    s = motion.state
    return s.a[name] - (1j * s.e[name] - s.w[name] ** 2) * s.u[name] * s.o[name]


def _unwrapped(angle: Array) -> Array:
    """Without jumps of a turn, over positions that are there."""
    there = np.isfinite(angle)
    out = angle.copy()
    out[there] = np.unwrap(angle[there])
    return out


def _hermite(values: Array, turned: Array) -> Array:
    """Between neighbouring positions, at the shares BETWEEN: (3, Q) -> (len(BETWEEN), Q - 1)."""
    h = np.diff(turned)
    (p0, v0, a0), (p1, v1, a1) = values[:, :-1], values[:, 1:]
    s = np.array(BETWEEN)[:, None]
    rise, first, second = p1 - p0, v0 * h, a0 * h**2 / 2
    last, bend = v1 * h, a1 * h**2 / 2
    c3 = 10 * rise - 6 * first - 3 * second - 4 * last + bend
    c4 = -15 * rise + 8 * first + 3 * second + 7 * last - 2 * bend
    c5 = 6 * rise - 3 * first - second - 3 * last + bend
    return p0 + s * (first + s * (second + s * (c3 + s * (c4 + s * c5))))
