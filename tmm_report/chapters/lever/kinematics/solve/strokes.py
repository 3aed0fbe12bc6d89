"""The motion of output links, and of other links that turn: how it is told, its stroke and its extremes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Literal

import numpy as np

from tmm_report.chapters.lever.kinematics.solve.swings import first, swing
from tmm_report.mechanics.calculus.vectors import dot
from tmm_report.mechanics.lever.cycle import Cycle, Extreme, Quantity, Rate, Slope
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.mechanics.lever.motion import Linkage, Motion
from tmm_report.mechanics.lever.vector_equations import turning_links, turns_with
from tmm_report.records import dataclass

Array = Any
MOST_STOPS = 5  # diagram positions at which an output without a dwell may happen to stand still
Extremes = tuple[Extreme, Extreme]


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


def carried(linkage: Linkage) -> dict[str, str]:
    """Links that slide on a turning link, and so turn as it does: link -> the one whose rotation is found."""
    turning, found = set(turning_links(linkage)), dict[str, str]()
    for group in linkage.groups:
        for link, source in turns_with(group).items():
            if source is not None and source in turning:
                found[link] = found.get(source, source)
    return found


def translating(motion: Motion) -> list[str]:
    """Links that do not turn at any position of the motion."""
    mechanism = motion.linkage.mechanism
    driver = mechanism.driver.link
    least = 1e-9 * float(np.nanmax(np.abs(motion.angular_velocity(driver)), initial=0.0))

    def still(link: str) -> bool:
        rates = np.abs(motion.angular_velocity(link))
        return bool(np.nanmax(rates, initial=0.0) <= least)

    return [link for link in mechanism.real.moving if link != driver and still(link)]


def driven(linkage: Linkage) -> list[Output]:
    """The links that turn, but for the driving link, those that turn with another and rocking outputs, as outputs that
    turn. Links that replace cam pairs are others in every position: their angles are no motion."""
    others = {*carried(linkage), *(cam.name for cam in linkage.mechanism.cams)}
    others |= {linkage.mechanism.driver.link, *(o.name for o in outputs(linkage) if o.kind == "rocker")}
    return [Output("rocker", link, link, 1.0) for link in turning_links(linkage) if link not in others]


def travels(cycle: Cycle, table: Motion, diagram: Motion, every: Sequence[Output]) -> tuple[Travel, ...]:
    """The motion of every output, their extremes found all together."""
    found = [pointed(output, diagram) for output in every]
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
    start = first(S)
    if output.kind == "rocker":  # the angle from position 0, without jumps of a turn
        reference = np.angle(np.exp(1j * start))
        (S, dS), (near, far) = swing(cycle, output.name, (table, diagram), reference, stops)
    else:
        S, dS = S - start, dS - start
        reached = bounded(cycle, output.coordinate, extremes[0]) if cycle.poles.size else extremes[0]
        near, far = (Extreme(float(x.value - start), x.turned, x.side) for x in reached)
    # of one stroke there and one back, over a whole turn, only
    strokes = cycle.closed and bool(np.all(table.closes)) and len(stops) == 2 and not _dwells(dV)
    back = (far.turned - near.turned) % cycle.sweep if strokes else None
    ratio = max(back, cycle.sweep - back) / min(back, cycle.sweep - back) if back else None
    return Travel(
        output=output, S=S, V=V, a=a, diagram_S=dS, diagram_V=dV, diagram_a=da,
        stroke=far.value - near.value, near=near, far=far,
        V_extremes=bounded(cycle, output.velocity, extremes[1]),
        a_extremes=bounded(cycle, output.acceleration, extremes[2]), time_ratio=ratio,
    )  # fmt: skip


NEAR_LIMIT, GROWS = (
    1e-7,
    3.0,
)  # rad from a limit of assembly; how many times a rate is larger still nearer to it


def bounded(cycle: Cycle, rate: Quantity, extremes: Extremes) -> Extremes:
    """Extremes of a rate; nan in place of what is none, as the rate grows without bound towards a limit of assembly:
    there it goes with 1/√(distance), towards parallel guides with a power of 1/distance."""
    if _runs_away(cycle, rate, extremes):
        return Extreme(np.nan, np.nan), Extreme(np.nan, np.nan)
    limits = cycle.limits
    if not limits.size:
        return extremes
    low, high = (_bounded(cycle, rate, extreme, limits) for extreme in extremes)
    return low, high


def _runs_away(cycle: Cycle, value: Quantity, extremes: Extremes) -> bool:
    """Whether a quantity is larger than its extremes beside parallel guides: it has none."""
    if not cycle.poles.size:
        return False
    beside = cycle.motion(np.concatenate([cycle.poles - NEAR_LIMIT, cycle.poles + NEAR_LIMIT]))
    return bool(np.nanmax(np.abs(value(beside)), initial=0.0) > GROWS * max(abs(x.value) for x in extremes))


def _bounded(cycle: Cycle, rate: Quantity, extreme: Extreme, limits: Array) -> Extreme:
    off = np.angle(np.exp(1j * (extreme.turned - limits)))
    nearest = off[np.argmin(np.abs(off))]
    if not abs(nearest) < NEAR_LIMIT:
        return extreme
    beside = cycle.motion(np.array([extreme.turned + np.sign(nearest) * NEAR_LIMIT]))
    if abs(extreme.value) <= GROWS * abs(float(np.real(rate(beside))[0])):
        return extreme
    return Extreme(np.nan, np.nan)


def pointed(output: Output, diagram: Motion) -> Output:
    """A slider's displacement is positive towards the farther end of its stroke from position 0."""
    if output.kind == "rocker":
        return output
    S = output.rates(diagram)[0]
    S = S - first(S)
    # of equally far ends, the one to which the guide points, and not the one that rounding chooses
    ahead = np.nanmax(S) >= -np.nanmin(S) * (1 - 1e-9)
    return Output(output.kind, output.name, output.link, output.direction * (1 if ahead else -1))


def _dwells(V: Array) -> bool:
    """Whether an output stands still over a part of the cycle, and not at single positions of it only."""
    return int(np.count_nonzero(np.abs(V) <= 1e-9 * np.nanmax(np.abs(V)))) > MOST_STOPS
