"""Chapter of gears, the planetary stage: teeth by the ratio, conditions, sizes, efficiency and speeds.

Every combination of teeth of the ranges is judged (`mechanics.planetary_search`); the teacher's teeth, where given, are
checked by the same conditions. Source: Frolov (ed.), Theory of mechanisms and machines, ch. 15.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace
from functools import cached_property
from typing import Any

import numpy as np

from tmm_report.chapters.gears.planetary.given import Given
from tmm_report.chapters.gears.planetary.solve.combinations import Combinations, Solutions, every, solutions
from tmm_report.chapters.gears.planetary.solve.conditions import Condition, conditions
from tmm_report.chapters.gears.planetary.solve.limits import check, check_teeth, no_solution
from tmm_report.chapters.gears.planetary.solve.meshes import Rows, rows
from tmm_report.chapters.gears.planetary.solve.motions import Motion, motions, torques
from tmm_report.chapters.gears.planetary.solve.paper import scale
from tmm_report.chapters.gears.planetary.solve.schemes import Choice, choose, tasks
from tmm_report.chapters.gears.planetary.solve.stated_shifts import doubts as of_shifts
from tmm_report.chapters.gears.planetary.solve.stated_shifts import settled
from tmm_report.mechanics.gears import trains
from tmm_report.mechanics.gears.planetary import stage as p
from tmm_report.mechanics.gears.planetary.search import Candidates, ranked, search
from tmm_report.problems import Message, Problem
from tmm_report.records import dataclass

__all__ = ["Found", "Given", "Motion", "solve", "tasks"]

Array = Any


@dataclass(frozen=True, eq=False)
class Found:
    """A solved stage.

    `candidates`: how many were judged, and the solutions; `ranking`: indices of the solutions, best first;
    `solutions`: what is said of these; `teeth`: z1, z2, z2', z3; `basic`: u13(H), with the carrier stopped;
    `motions`: all the ways it runs;
    `torques`: on the members from outside, with losses, for 1 N·m at the input, N·m; `turns`: least whole p of the
    course's condition of assembly, None where there is none; `scale`: of its drawing, m/mm; `choice`: of the
    scheme, None where that is stated.
    """

    given: Given
    candidates: Candidates
    ranking: Array
    solutions: Solutions
    teeth: tuple[int, int, int, int]
    satellites: int
    sizes: p.Sizes
    rows: Rows
    conditions: tuple[Condition, ...]
    basic: float
    motions: tuple[Motion, ...]
    torques: Mapping[p.Member, float]
    turns: int | None
    members: tuple[trains.Member, ...]
    meshes: tuple[trains.Mesh, ...]
    scale: float
    choice: Choice | None = None

    # --- for the whole drive

    @property
    def name(self) -> str:
        return self.given.title or "-".join(self.given.names)

    @property
    def wanted(self) -> float:
        return self.given.task.ratio

    @property
    def input(self) -> str:
        return self.given.member(self.given.task.input)

    @property
    def output(self) -> str:
        return self.given.member(self.given.task.output)

    @property
    def fixed(self) -> tuple[str, ...]:
        return (self.given.member(self.given.task.held),) if self.given.driven is None else ()

    @property
    def second(self) -> tuple[str, float] | None:
        """The second input of a differential and its speed, rad/s."""
        driven = self.given.driven
        return None if driven is None else (self.given.member(self.given.task.held), driven)

    @property
    def angles(self) -> tuple[float | None, ...]:
        """Operating angles of pressure of the meshes, rad."""
        return tuple(float(angle) for angle, _ in zip(self.sizes.angles, self.meshes, strict=True))

    @property
    def shares(self) -> int:
        return self.satellites

    @property
    def sized(self) -> bool:
        return True

    @property
    def sound(self) -> bool:
        """Its conditions are met: the search takes no other teeth, and stated ones that break one are refused."""
        return True

    def summary(self) -> list[Message]:
        """What is wrong: nothing."""
        return []

    # --- the stage itself

    @property
    def scheme(self) -> p.Scheme:
        return self.given.task.scheme

    @property
    def ratio(self) -> float:
        """ω_input/ω_output with the held member at rest, signed."""
        return float(p.stage_ratio(self.basic, self.given.task.input, self.given.task.output))

    @property
    def deviation(self) -> float:
        """Of the ratio from the wanted one, relative, signed."""
        return self.ratio / self.wanted - 1

    @property
    def motion(self) -> Motion:
        """The way in which the stage runs in the drive, the held member at rest."""
        wanted = (self.given.task.input, self.given.task.output)
        return next(motion for motion in self.motions if (motion.input, motion.output) == wanted)

    @property
    def efficiency(self) -> float:
        """With the held member at rest, 0..1; 0 where the stage locks itself."""
        return 0.0 if self.motion.locks else self.motion.efficiency

    @property
    def forces(self) -> tuple[float, float]:
        """Circumferential forces on one satellite from wheels 1 and 3 for 1 N·m at the input, N: all carry alike."""
        pairs: tuple[tuple[p.Member, int], ...] = (("wheel1", 0), ("wheel3", 3))
        one, three = (
            abs(2 * self.torques[of] / (self.satellites * float(self.sizes.working[k]))) for of, k in pairs
        )
        return one, three

    @property
    def force_per_moment(self) -> float:
        """Circumferential force on one satellite from wheel 1 for each N·m of the moment of that wheel, N."""
        return 2 / (self.satellites * float(self.sizes.working[0]))

    @property
    def shifted(self) -> bool:
        """Whether wheels are cut with profile shift."""
        return bool(np.any(self.sizes.shifts != 0))

    @property
    def opened(self) -> list[int]:
        """The rows whose pitch circles do not roll on one another."""
        away = np.abs(self.sizes.pitch_distances / self.sizes.centre_distance - 1)
        return [int(row) for row in np.flatnonzero(away > 1e-12)]

    @property
    def coaxial(self) -> bool:
        """Whether both rows have one centre distance by their teeth."""
        one, other = self.sizes.pitch_distances
        return bool(abs(one / other - 1) < 1e-12)

    @property
    def doubts(self) -> tuple[Problem, ...]:
        return tuple(of_shifts(self.given, self.teeth))

    @property
    def apart(self) -> float:
        """Distance between the axes of neighbouring satellites, m."""
        return float(2 * self.sizes.centre_distance * np.sin(np.pi / self.satellites))

    @property
    def gap(self) -> float:
        """Free space between neighbouring satellites, m."""
        return float(p.neighbourhood_gap(self.sizes, self.satellites))

    @property
    def assembly_number(self) -> int:
        return round(float(p.assembly_number(self.scheme, self.teeth, self.satellites)))

    @property
    def usual_assembly(self) -> float:
        """The course's z1 u1H (1 + k p)/k; nan where no whole p makes it whole."""
        if self.turns is None:
            return math.nan
        return abs(self.teeth[0] * (1 - self.basic)) / self.satellites * (1 + self.satellites * self.turns)

    @property
    def least_teeth(self) -> float:
        """2 ha*/sin² α: fewer the rack undercuts without shift; the course rounds it."""
        rack = self.given.task.rack
        return 2 * rack.ha / math.sin(rack.alpha) ** 2

    @property
    def chosen(self) -> int | None:
        """Place of the chosen teeth among the ranked solutions, from 0; None where they are outside the ranges."""
        same = np.all(self.solutions.of.teeth == np.array(self.teeth)[:, None], axis=0)
        places = np.flatnonzero(same & (self.solutions.of.satellites == self.satellites))
        return int(places[0]) if len(places) else None

    @cached_property
    def combinations(self) -> Combinations:
        """Every combination that was judged, in the order of success: only the full list asks for it."""
        return every(self.given.task)


def solve(given: Given) -> Found:
    """Raises ProblemError where no teeth give the ratio, or those given fail a condition, or the rack cuts none."""
    check(given.task)
    given = settled(given)
    if given.any_scheme:
        return _of_any(given)
    found = search(given.task)
    order = ranked(given.task, found)
    if given.teeth is not None:
        return _found(given, found, order, given.teeth, check_teeth(given.task, given.teeth, found, order))
    if not len(order):
        raise no_solution(given.task, found)
    z1, z2, z2_, z3 = (int(teeth) for teeth in found.teeth[:, order[0]])
    return _found(given, found, order, (z1, z2, z2_, z3), int(found.satellites[order[0]]))


def _of_any(given: Given) -> Found:
    """The stage of the scheme that is taken, with all that were judged."""
    choice = choose(given)
    taken = choice.taken
    assert taken.teeth is not None  # it works
    found = _found(taken.given, taken.found, taken.ranking, taken.teeth, taken.satellites)
    return replace(found, choice=choice)


def _found(given: Given, found: Candidates, order: Array, teeth: tuple[int, int, int, int], k: int) -> Found:
    """All that follows from the chosen teeth and the number of satellites."""
    task = given.task
    sizes = task.sizes(np.array(teeth))
    meshed = rows(task, teeth, sizes)
    basic = float(p.basic_ratio(task.scheme, teeth))
    return Found(
        given,
        found,
        order,
        solutions(task, found, order),
        teeth,
        k,
        sizes,
        meshed,
        tuple(conditions(task, teeth, k, sizes, meshed)),
        basic,
        motions(given, teeth, basic),
        torques(given, basic),
        p.carrier_turns(task.scheme, teeth, k),
        _members(given, teeth, sizes),
        _meshes(given),
        scale(task, sizes),
    )


def _members(given: Given, teeth: tuple[int, int, int, int], sizes: p.Sizes) -> tuple[trains.Member, ...]:
    """Wheels, crowns of one satellite, carrier; radii of the rolling circles, m."""
    scheme, arm = given.task.scheme, float(sizes.centre_distance)
    one, three, carrier = (given.member(member) for member in p.MEMBERS)
    kinds: list[trains.Kind] = ["wheel" if row == p.EXTERNAL else "ring" for row in scheme.rows]
    radius = [float(d) / 2 for d in sizes.working]
    first, second = given.crowns
    crowns = [trains.Member(first, "satellite", teeth[1], radius[1], arm, carrier)]
    if not scheme.single:
        crowns.append(trains.Member(second, "satellite", teeth[2], radius[2], arm, carrier, first))
    return (
        trains.Member(one, kinds[0], teeth[0], radius[0]),
        *crowns,
        trains.Member(three, kinds[1], teeth[3], radius[3]),
        trains.Member(carrier, "carrier", radius=arm),
    )


def _meshes(given: Given) -> tuple[trains.Mesh, ...]:
    """Wheel 1 with its crown, the other crown with wheel 3; each has the root of η_H."""
    eta = math.sqrt(given.efficiency)
    one, three, carrier = (given.member(member) for member in p.MEMBERS)
    first, second = given.crowns
    inner = [row == p.INTERNAL for row in given.task.scheme.rows]
    return (
        trains.Mesh(one, first, carrier, inner[0], eta),
        trains.Mesh(second, three, carrier, inner[1], eta),
    )
