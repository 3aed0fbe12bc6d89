"""Chapter 2, kinematics: positions, velocities and accelerations; strokes and extreme positions; diagrams."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Literal

import numpy as np

from tmm_report.chapters.kinematics.given import Positions
from tmm_report.chapters.kinematics.limits import Closest, Dead, Gap, closest, dead, gaps
from tmm_report.chapters.structure.solve import Structure
from tmm_report.mechanics.cycle import Cycle, Extreme, Quantity, Rate, Slope, cycle_of, least_and_greatest
from tmm_report.mechanics.mechanism import FRAME
from tmm_report.mechanics.motion import SINGULAR, Linkage, Motion
from tmm_report.mechanics.planar import dot
from tmm_report.mechanics.relations import named_values
from tmm_report.mechanics.singular import settle
from tmm_report.problems import N_, Message, ProblemError, mistake

Array = Any
Extremes = tuple[Extreme, Extreme]


def digits_left(sine: Array) -> Array:
    """Decimal digits of a double that remain where a group's sine is this: dividing by it costs -log10 of them."""
    return np.maximum(np.floor(15.95 + np.log10(np.maximum(sine, 1e-300))), 0.0)


@dataclass(frozen=True)
class Output:
    """A link whose motion the course tabulates: a slider on a fixed guide, or a rocker on a fixed pivot.

    `name`: the slider's point, or the rocker's link. `direction`: unit vector of positive displacement, or ±1.
    """

    kind: Literal["slider", "rocker"]
    name: str
    link: str
    direction: complex

    def rates(self, motion: Motion) -> tuple[Array, Array, Array]:
        """Coordinate, velocity and acceleration, (..., P): m or rad. A rocker's angle is within ±π."""
        return self.coordinate(motion), self.velocity(motion), self.acceleration(motion)

    def coordinate(self, motion: Motion) -> Array:
        if self.kind == "rocker":
            return np.angle(motion.turn(self.name))
        return dot(motion.place(self.name), self.direction)

    def velocity(self, motion: Motion) -> Array:
        if self.kind == "rocker":
            return motion.angular_velocity(self.name) * np.real(self.direction)
        return dot(motion.velocity(self.name), self.direction)

    def acceleration(self, motion: Motion) -> Array:
        if self.kind == "rocker":
            return motion.angular_acceleration(self.name) * np.real(self.direction)
        return dot(motion.acceleration(self.name), self.direction)

    @property
    def values(self) -> tuple[Quantity, ...]:
        """What has extremes."""
        return self.coordinate, self.velocity, self.acceleration

    @property
    def stops(self) -> tuple[Rate, ...]:
        """The derivatives of `values`."""
        return self.velocity, self.acceleration, Slope(self.acceleration)

    def size(self, motion: Motion) -> Array:
        """A speed of the mechanism beside which the output's is more than rounding: m/s or rad/s."""
        return motion.velocities if self.kind == "slider" else motion.omega


@dataclass(frozen=True, eq=False)
class Travel:
    """An output's displacement from position 0, velocity and acceleration, at the table and diagram positions.

    m, m/s, m/s² of a slider; rad, rad/s, rad/s² of a rocker. `stroke` and the extremes are exact, by root finding.
    `time_ratio`: longer stroke's angle of turn to the shorter one's; None where the output does not return.
    """

    output: Output
    S: Array
    V: Array
    a: Array
    diagram_S: Array
    diagram_V: Array
    diagram_a: Array
    stroke: float
    near: Extreme  # least displacement
    far: Extreme  # greatest displacement
    V_extremes: Extremes
    a_extremes: Extremes
    time_ratio: float | None


@dataclass(frozen=True, eq=False)
class Kinematics:
    """Found by `solve`: the motion at the table positions 0..N and at the diagram positions."""

    linkage: Linkage
    cycle: Cycle
    positions: Positions
    turned: Array  # angle turned at the table positions, rad; position N of a closed cycle repeats position 0
    table: Motion
    diagram_turned: Array
    diagram: Motion
    travels: tuple[Travel, ...]
    singular: tuple[int, ...]  # table positions in which a group is singular: no plan can be drawn
    undefined: tuple[int, ...]  # those of them without velocities
    missing: tuple[int, ...]  # table positions in which the mechanism cannot be assembled

    @cached_property
    def values(self) -> Mapping[str, Array]:
        """Key -> velocities, accelerations, angular rates at the table positions (see `relations`)."""
        return named_values(self.table)

    @cached_property
    def diagram_values(self) -> Mapping[str, Array]:
        return named_values(self.diagram)

    @cached_property
    def digits(self) -> int:
        """Decimal digits that remain at the worst solved position of the table and diagram."""
        sines = [s[s > SINGULAR] for m in (self.table, self.diagram) for s in m.sines.values()]
        return int(digits_left(min((s.min(initial=1.0) for s in sines), default=1.0)))

    @cached_property
    def gaps(self) -> tuple[Gap, ...]:
        """Groups that cannot be assembled over part of the cycle, with causes and cures."""
        return gaps(self.cycle)

    @cached_property
    def closest(self) -> tuple[Closest, ...]:
        """How near each group comes to a singular position, and its singular positions."""
        return closest(self.cycle)

    @cached_property
    def dead(self) -> tuple[Dead, ...]:
        """Dead points of every output, were it to drive."""
        return dead(self.cycle, [travel.output for travel in self.travels])

    @property
    def distinct(self) -> int:
        """How many table positions have places of their own: those of one turn, the last without it."""
        return self.positions.table // self.cycle.turns if self.cycle.closed else len(self.turned)

    @property
    def omega(self) -> float:
        """Angular velocity of the driving link, rad/s, + counter-clockwise."""
        return float(self.linkage.mechanism.driver.omega)


def solve(positions: Positions, structure: Structure) -> Kinematics:
    """Positions that cannot be assembled are nan. Raises ProblemError where none can."""
    cycle = cycle_of(structure.linkage)
    (turned, table), (diagram_turned, diagram) = (
        steps(cycle, count) for count in (positions.table, positions.diagram)
    )
    _must_close(cycle, table, diagram)
    undefined = settle(table)
    settle(diagram)
    flat = np.logical_or.reduce([undefined, *(sine <= SINGULAR for sine in table.sines.values())])
    travels = _travels(cycle, table, diagram)
    return Kinematics(
        cycle.linkage, cycle, positions, turned, table, diagram_turned, diagram, travels,
        _numbers(flat & table.closes), _numbers(undefined & table.closes), _numbers(~table.closes),
    )  # fmt: skip


def steps(cycle: Cycle, count: int) -> tuple[Array, Motion]:
    """Angles turned at `count` equal steps of the cycle, rad, the last included, and the motion there."""
    turned = np.arange(count + 1) * (cycle.period / count)
    # position N of a full turn is position 0: solved as such, so that both print the same digits
    return turned, cycle.motion(cycle.once(count))


def _numbers(mask: Array) -> tuple[int, ...]:
    return tuple(int(k) for k in np.flatnonzero(mask))


def _must_close(cycle: Cycle, table: Motion, diagram: Motion) -> None:
    if table.closes.any() and diagram.closes.any():
        return
    causes = gaps(cycle)
    if causes:
        raise ProblemError([causes[0].problem])
    group = cycle.linkage.groups[-1].group
    text = N_("group %(group)s cannot be assembled at any position")
    right = Message(
        N_("check the lengths of links %(links)s and the places of their joints"),
        {"links": ", ".join(group.links)},
    )
    raise ProblemError([mistake(text, ("mechanism", "links", group.links[0]), right, group=group.label)])


def outputs(linkage: Linkage) -> list[Output]:
    """Sliders on fixed guides, then links pivoted to the frame, without the driving link."""
    mechanism = linkage.mechanism
    found = []
    for pair in linkage.structure.pairs:
        if FRAME in pair.links and pair.kind == "P":
            link = pair.other(FRAME)
            point = _traced_point(linkage, link)
            if point is not None:
                found.append(Output("slider", point, link, complex(pair.along[FRAME])))
        elif FRAME in pair.links and pair.other(FRAME) != mechanism.driver.link:
            found.append(Output("rocker", pair.other(FRAME), pair.other(FRAME), 1.0))
    return sorted(found, key=lambda output: output.kind == "rocker")


def _traced_point(linkage: Linkage, link: str) -> str | None:
    """The point that stands for a sliding link: a joint rather than a mass centre; None for a link without points."""
    points = linkage.mechanism.links[link].points
    joints = [p for p in points if len(linkage.mechanism.links_at(p)) > 1]
    return next(iter([*joints, *points]), None)


def _travels(cycle: Cycle, table: Motion, diagram: Motion) -> tuple[Travel, ...]:
    """The motion of every output, their extremes found all together."""
    found = [pointed(output, diagram) for output in outputs(cycle.linkage)]
    if not found:
        return ()
    values = [value for output in found for value in output.values]
    still = cycle.roots_of([rate for output in found for rate in output.stops])
    extremes = cycle.extremes_of(values, still)
    return tuple(
        travel(cycle, output, table, diagram, still[3 * k], extremes[3 * k : 3 * k + 3])
        for k, output in enumerate(found)
    )


def travel(
    cycle: Cycle, output: Output, table: Motion, diagram: Motion, stops: Array, extremes: Sequence[Extremes]
) -> Travel:
    """`stops`: angles turned at which the output stands still; `extremes` of coordinate, velocity, acceleration."""
    S, V, a = output.rates(table)
    dS, dV, da = output.rates(diagram)
    start = _first(S)
    if output.kind == "rocker":  # the angle from position 0, without jumps of a turn
        reference = np.angle(np.exp(1j * start))
        S, dS = (_unwrapped(m.turn(output.name), reference) * output.direction.real for m in (table, diagram))
        near, far = _rocker_extremes(cycle, output, reference, stops)
    else:
        S, dS = S - start, dS - start
        near, far = (Extreme(float(x.value - start), x.turned) for x in extremes[0])
    # of one stroke there and one back, over a whole turn, only
    strokes = cycle.closed and bool(np.all(table.closes)) and len(stops) == 2
    back = (far.turned - near.turned) % cycle.sweep if strokes else None
    ratio = max(back, cycle.sweep - back) / min(back, cycle.sweep - back) if back else None
    return Travel(
        output=output, S=S, V=V, a=a, diagram_S=dS, diagram_V=dV, diagram_a=da,
        stroke=far.value - near.value, near=near, far=far,
        V_extremes=extremes[1], a_extremes=extremes[2], time_ratio=ratio,
    )  # fmt: skip


def pointed(output: Output, diagram: Motion) -> Output:
    """A slider's displacement is positive towards the farther end of its stroke from position 0."""
    if output.kind == "rocker":
        return output
    S = output.rates(diagram)[0]
    S = S - _first(S)
    # of equally far ends, the one to which the guide points, and not the one that rounding chooses
    ahead = np.nanmax(S) >= -np.nanmin(S) * (1 - 1e-9)
    return Output(output.kind, output.name, output.link, output.direction * (1 if ahead else -1))


def _first(values: Array) -> Any:
    """The value at the first position that exists: position 0, where the mechanism closes there."""
    return values[np.argmax(np.isfinite(values))]


def _unwrapped(u: Array, reference: float) -> Array:
    """Angle from the first position, rad, continuous along the positions that exist."""
    angle = np.angle(u * np.exp(-1j * reference))
    exists = np.isfinite(angle)
    angle[exists] = np.unwrap(angle[exists])
    return angle - _first(angle)


def _rocker_extremes(cycle: Cycle, output: Output, reference: float, stops: Array) -> Extremes:
    """Extremes of a rocker's angle from position 0 over the cycle, rad, exact; of what goes all round, the ends."""
    fine = np.linspace(0, cycle.period, 360 * cycle.turns + 1)
    where = np.sort(np.concatenate([fine, cycle.repeated(stops)]))
    angle = _unwrapped(cycle.motion(where).turn(output.name), reference)
    return least_and_greatest(angle, where)
