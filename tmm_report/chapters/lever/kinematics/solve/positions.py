"""Chapter 2, kinematics: positions, velocities and accelerations; strokes and extreme positions; diagrams."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cached_property, partial
from typing import TYPE_CHECKING, Any

import numpy as np

from tmm_report.chapters.lever.kinematics.checks.closure import leave_out_unclosed, told
from tmm_report.chapters.lever.kinematics.checks.digits_left import PRINTED as PRINTED
from tmm_report.chapters.lever.kinematics.checks.digits_left import Near, digits_left, near
from tmm_report.chapters.lever.kinematics.checks.digits_left import rounding as rounding
from tmm_report.chapters.lever.kinematics.checks.open_cycle import Gap, gaps
from tmm_report.chapters.lever.kinematics.checks.singular import Closest, Dead, closest, dead
from tmm_report.chapters.lever.kinematics.given import Positions, Way
from tmm_report.chapters.lever.kinematics.solve.jumps import Jumps, jumps
from tmm_report.chapters.lever.kinematics.solve.strokes import Output as Output
from tmm_report.chapters.lever.kinematics.solve.strokes import Travel as Travel
from tmm_report.chapters.lever.kinematics.solve.strokes import driven, outputs, travels
from tmm_report.chapters.lever.structure.solve import Structure
from tmm_report.mechanics.calculus.vectors import if_known
from tmm_report.mechanics.lever.cycle import Cycle, Extreme, cycle_of
from tmm_report.mechanics.lever.cycle_search import side_of
from tmm_report.mechanics.lever.meeting import settle
from tmm_report.mechanics.lever.motion import SINGULAR, Linkage, Motion
from tmm_report.mechanics.lever.vector_equations import named_values
from tmm_report.problems import N_, Message, Problem, ProblemError, mistake
from tmm_report.records import dataclass

if TYPE_CHECKING:  # loaded only for a variant that states a stroke or a method
    from tmm_report.mechanics.lever.driving.stroke import Stroke
    from tmm_report.mechanics.rivals.choice import Choice

Array = Any
Extremes = tuple[Extreme, Extreme]
TOLERANCE = 1e-9  # relative disagreement of two exact ways above which something is wrong
WAYS = 10.0  # times the error of the motion: what ways through places, velocities and accelerations may differ by
STILL = 1e-9  # of the greatest speed of the driving link: where it turns no faster it stands
AT_LIMIT = 1e-5  # rad from a limit of assembly: to the thousandth of a degree that is printed the position is the limit


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
    travels: tuple[Travel, ...]  # of the outputs
    links: tuple[Travel, ...]  # of the other driven links that turn
    singular: tuple[int, ...]  # table positions in which a group is singular: no plan can be drawn
    undefined: tuple[int, ...]  # those of them without velocities
    missing: tuple[int, ...]  # table positions in which the mechanism cannot be assembled
    unclosed: tuple[Gap, ...] = ()  # positions that were solved, but whose joints do not close
    choice: Choice | None = None  # the method of the positions, where the variant states one
    instants: Array = ()  # angles turned at which the variant asks for the motion beside the positions, rad

    @property
    def numbered(self) -> int:
        """How many positions are numbered under a diagram over the cycle: none where it is not closed."""
        return self.positions.table if self.cycle.closed else 0

    @property
    def stroke(self) -> Stroke | None:
        """What drives, where that is a slider or a cylinder."""
        return self.linkage.mechanism.driver.stroke

    @cached_property
    def asked(self) -> Motion | None:
        """The motion at the instants; None without any."""
        return self.cycle.motion(self.instants) if len(self.instants) else None

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
    def near(self) -> tuple[Near, ...]:
        """Positions in which few digits remain, by groups."""
        return near(self)

    @property
    def doubts(self) -> tuple[Problem, ...]:
        """What the variant may not have meant: positions near singular ones."""
        return tuple(one.problem for one in self.near)

    @property
    def missed(self) -> Problem | None:
        """What failed: the method that the variant names does not hold its accuracy."""
        if self.choice is None:
            return None
        from tmm_report.chapters.lever.kinematics.solve.method import missed

        return missed(self.choice)

    @property
    def tolerance(self) -> float:
        """Relative disagreement above which something is wrong with two ways to one number: by the errors of the
        method of the positions, not by what is asked of it."""
        if self.choice is None or self.choice.worst <= TOLERANCE:
            return TOLERANCE
        return WAYS * self.choice.worst

    @cached_property
    def gaps(self) -> tuple[Gap, ...]:
        """Groups that cannot be assembled over part of the cycle, with causes and cures."""
        return (*gaps(self.cycle), *self.unclosed)

    @property
    def limited(self) -> bool:
        """Whether the mechanism comes to a limit, or its guides become parallel: towards that rates and forces grow
        without bound."""
        return bool(self.cycle.poles.size) or any(gap.intervals for gap in self.gaps)

    @cached_property
    def closest(self) -> tuple[Closest, ...]:
        """How near each group comes to a singular position, and its singular positions."""
        return closest(self.cycle)

    @cached_property
    def jumps(self) -> Jumps:
        """Where accelerations jump, with the motion on both sides."""
        return jumps(self)

    @cached_property
    def dead(self) -> tuple[Dead, ...]:
        """Dead points of every output, were it to drive."""
        return dead(self.cycle, [travel.output for travel in self.travels])

    @property
    def distinct(self) -> int:
        """How many table positions have places of their own: those of one turn, the last without it."""
        return self.positions.table // self.cycle.turns if self.cycle.closed else len(self.turned)

    @property
    def by_law(self) -> bool:
        """Whether the driving link moves by a law of the time: what is turned is then the phase of the law."""
        return self.cycle.law is not None

    @property
    def omega(self) -> float:
        """Angular velocity of the driving link, rad/s, + counter-clockwise; where it moves by a law, that of its
        phase."""
        return float(self.linkage.mechanism.driver.omega)


def solve(positions: Positions, structure: Structure, way: Way | None = None) -> Kinematics:
    """Positions that cannot be assembled are nan. Raises ProblemError where none can, or where the method that is asked
    for cannot be used."""
    cycle = cycle_of(structure.linkage)
    choice = _chosen(way, cycle, positions)
    find = _by(choice)
    (turned, table), (diagram_turned, diagram) = (
        find(cycle, count) for count in (positions.table, positions.diagram)
    )
    opened: list[Gap] = []
    if find is steps:  # other methods leave the joints open by their errors
        opened = told(leave_out_unclosed(table), turned) + told(leave_out_unclosed(diagram), diagram_turned)
    _must_close(cycle, table, diagram)
    undefined = settle(table, side_of(turned)) | at_limits(cycle, turned, table)
    settle(diagram, side_of(diagram_turned))
    at_limits(cycle, diagram_turned, diagram)
    # plans are drawn in the closed form's positions, and may be flat where another method is only near
    sines = [
        *table.sines.values(),
        *(() if find is steps else steps(cycle, positions.table)[1].sines.values()),
    ]
    flat = np.logical_or.reduce([undefined, stands(table), *(sine <= SINGULAR for sine in sines)])
    own = outputs(cycle.linkage)
    turning = [link for link in driven(cycle.linkage) if cycle.moves(link.velocity, link.size)]
    motions = travels(cycle, table, diagram, [*own, *turning])
    return Kinematics(
        cycle.linkage, cycle, positions, turned, table, diagram_turned, diagram,
        motions[: len(own)], motions[len(own) :],
        _numbers(flat & table.closes), _numbers(undefined & table.closes), _numbers(~table.closes),
        tuple(opened), choice, turned_at(positions, cycle),
    )  # fmt: skip


def turned_at(positions: Positions, cycle: Cycle) -> Array:
    """Angles turned at the instants that are asked for, rad."""
    driver = cycle.linkage.mechanism.driver
    omega = abs(float(driver.omega))
    found = list[float]()
    for value, by in positions.instants:
        if by == "length" and driver.stroke is not None:  # as often as the stroke comes to it
            found += (driver.stroke.law.times_at(value) * omega).tolist()
        elif by == "angle" and driver.law is not None:
            found.append(driver.law.turned_by(value) * omega)
        else:
            found.append(value * omega if by == "time" else value)
    return np.array(found)


def _chosen(way: Way | None, cycle: Cycle, positions: Positions) -> Choice | None:
    if way is None:
        return None
    from tmm_report.chapters.lever.kinematics.solve.method import chosen

    return chosen(way, cycle, positions)


def _by(choice: Choice | None) -> Callable[[Cycle, int], tuple[Array, Motion]]:
    """How the motion at equal steps is found."""
    if choice is None:
        return steps
    from tmm_report.chapters.lever.kinematics.solve.method import own, run

    return steps if own(choice) else partial(run, choice)


def steps(cycle: Cycle, count: int) -> tuple[Array, Motion]:
    """Angles turned at `count` equal steps of the cycle, rad, the last included, and the motion there."""
    turned = np.arange(count + 1) * (cycle.period / count)
    # position N of a full turn is position 0: solved as such, so that both print the same digits
    return turned, cycle.motion(cycle.once(count))


def at_limits(cycle: Cycle, turned: Array, motion: Motion) -> Array:
    """Take the rates from the positions that are limits of assembly, where they grow without bound; the mask of these,
    (P,)."""
    s, lost = motion.state, np.zeros(motion.shape, dtype=bool)
    for critical in cycle.critical:
        limits = cycle.turned_at(critical.limits)
        off = np.abs(np.angle(np.exp(1j * (turned[:, None] - limits)))).min(axis=-1, initial=np.inf)
        lost = lost | (off < AT_LIMIT)
        if lost.any():
            for rates in (s.v, s.w, s.a, s.e, s.iw, s.ie):
                rates.update({link: if_known(~lost, rates[link]) for link in critical.group.links})
    return lost


def stands(motion: Motion) -> Array:
    """Where a driving link that moves by a law stands still: there it has no velocity to draw by, (..., P) of bool."""
    if motion.phase is None:
        return np.zeros(motion.shape, dtype=bool)
    return np.abs(motion.omega) <= STILL * np.max(np.abs(motion.omega))


def _numbers(mask: Array) -> tuple[int, ...]:
    return tuple(int(k) for k in np.flatnonzero(mask))


def _must_close(cycle: Cycle, table: Motion, diagram: Motion) -> None:
    if table.closes.any() and diagram.closes.any():
        return
    causes = [gap for gap in gaps(cycle) if gap.intervals]
    if causes:  # none of them alone, it may be: each group takes its own part
        raise ProblemError([gap.problem for gap in causes])
    group = cycle.linkage.groups[-1].group
    text = N_("group %(group)s cannot be assembled at any position")
    right = Message(
        N_("check the lengths of links %(links)s and the places of their joints"),
        {"links": ", ".join(group.links)},
    )
    raise ProblemError([mistake(text, ("mechanism", "links", group.links[0]), right, group=group.label)])
