"""Chapter of gears, the planetary stage: teeth by the ratio, conditions, sizes, efficiency and speeds.

Every combination of teeth of the ranges is judged (`mechanics.planetary_search`); the teacher's teeth, where given, are
checked by the same conditions. Source: Frolov (ed.), Theory of mechanisms and machines, ch. 15.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from itertools import permutations
from typing import Any

import numpy as np

from tmm_report.chapters.planetary.limits import check, check_teeth, no_solution
from tmm_report.mechanics import planetary as p
from tmm_report.mechanics import trains
from tmm_report.mechanics.planetary_search import Candidates, Task, ranked, search

Array = Any


@dataclass(frozen=True)
class Given:
    """A planetary stage. `task`: what teeth are sought for, its ratio with the held member at rest.

    `names`: of wheel 1, of the satellite (its two crowns), of wheel 3 and of the carrier. `teeth`: z1, z2, z2', z3
    chosen by the teacher. `second`: the held member and its speed, rad/s: a differential with two inputs.
    `efficiency`: η_H, of the stage with its carrier stopped.
    """

    task: Task
    names: tuple[str, ...] = ("1", "2", "3", "H")
    efficiency: float = 0.98
    teeth: tuple[int, int, int, int] | None = None
    driven: float | None = None
    title: str = ""

    def member(self, member: p.Member) -> str:
        """The name of wheel 1, wheel 3 or the carrier."""
        return {"wheel1": self.names[0], "wheel3": self.names[-2], "carrier": self.names[-1]}[member]

    @property
    def crowns(self) -> tuple[str, str]:
        """Names of the crowns that mesh with wheels 1 and 3: in a single row one."""
        return self.names[1], self.names[-3]


@dataclass(frozen=True, eq=False)
class Motion:
    """One of the ways in which the stage runs: speeds for an input speed of 1 and the efficiency.

    `exponent`: +1 where wheel 1 drives wheel 3 in the stopped-carrier frame, −1 where wheel 3 drives wheel 1.
    """

    input: p.Member
    output: p.Member
    held: p.Member
    speed: dict[p.Member, float]
    satellite: float
    exponent: int
    efficiency: float

    @property
    def ratio(self) -> float:
        return 1 / self.speed[self.output] if self.speed[self.output] else math.inf

    @property
    def locks(self) -> bool:
        return not self.efficiency > 0


@dataclass(frozen=True, eq=False)
class Found:
    """A solved stage. `candidates`: all that were judged, `ranking`: indices of the solutions, best first."""

    given: Given
    candidates: Candidates
    ranking: Array
    teeth: tuple[int, int, int, int]
    satellites: int

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

    @cached_property
    def members(self) -> tuple[trains.Member, ...]:
        """Wheels, crowns of one satellite, carrier; radii of the rolling circles, m."""
        given, arm = self.given, float(self.sizes.centre_distance)
        one, three, carrier = (given.member(member) for member in p.MEMBERS)
        kinds: list[trains.Kind] = ["wheel" if row == p.EXTERNAL else "ring" for row in self.scheme.rows]
        radius = [float(d) / 2 for d in self.sizes.working]
        first, second = given.crowns
        crowns = [trains.Member(first, "satellite", self.teeth[1], radius[1], arm, carrier)]
        if not self.scheme.single:
            crowns.append(trains.Member(second, "satellite", self.teeth[2], radius[2], arm, carrier, first))
        return (
            trains.Member(one, kinds[0], self.teeth[0], radius[0]),
            *crowns,
            trains.Member(three, kinds[1], self.teeth[3], radius[3]),
            trains.Member(carrier, "carrier", radius=arm),
        )

    @cached_property
    def meshes(self) -> tuple[trains.Mesh, ...]:
        """Wheel 1 with its crown, the other crown with wheel 3; each has the root of η_H."""
        given, eta = self.given, math.sqrt(self.given.efficiency)
        one, three, carrier = (given.member(member) for member in p.MEMBERS)
        first, second = given.crowns
        inner = [row == p.INTERNAL for row in self.scheme.rows]
        return (
            trains.Mesh(one, first, carrier, inner[0], eta),
            trains.Mesh(second, three, carrier, inner[1], eta),
        )

    # --- the stage itself

    @property
    def scheme(self) -> p.Scheme:
        return self.given.task.scheme

    @cached_property
    def sizes(self) -> p.Sizes:
        task = self.given.task
        return p.sizes(task.scheme, task.modules, task.rack, np.array(self.teeth))

    @cached_property
    def basic(self) -> float:
        """u13(H), with the carrier stopped."""
        return float(p.basic_ratio(self.scheme, self.teeth))

    @cached_property
    def ratio(self) -> float:
        """ω_input/ω_output with the held member at rest, signed."""
        return float(p.stage_ratio(self.basic, self.given.task.input, self.given.task.output))

    @property
    def deviation(self) -> float:
        """Of the ratio from the wanted one, relative, signed."""
        return self.ratio / self.wanted - 1

    @cached_property
    def motions(self) -> tuple[Motion, ...]:
        """All the ways in which the stage can run: each member held, driven from either of the others.

        Of a basic ratio of 1 with the carrier stopped only: else a central wheel held holds the other.
        """
        ways = permutations(p.MEMBERS, 2)
        return tuple(self._motion(*way) for way in ways if self.basic != 1 or "carrier" not in way)

    @property
    def motion(self) -> Motion:
        """The way in which the stage runs in the drive, the held member at rest."""
        wanted = (self.given.task.input, self.given.task.output)
        return next(motion for motion in self.motions if (motion.input, motion.output) == wanted)

    def _motion(self, input: p.Member, output: p.Member) -> Motion:
        (held,) = set(p.MEMBERS) - {input, output}
        speed = {m: float(w) for m, w in p.relative_speeds(self.basic, input, held).items()}
        flow = p.power_flow(self.basic, self.given.efficiency, input, output)
        satellite = p.satellite_speed(self.scheme, self.teeth, speed["wheel1"], speed["carrier"])
        return Motion(
            input, output, held, speed, float(satellite), int(flow.exponent), float(flow.efficiency)
        )

    @property
    def efficiency(self) -> float:
        """With the held member at rest, 0..1; 0 where the stage locks itself."""
        return 0.0 if self.motion.locks else self.motion.efficiency

    @cached_property
    def torques(self) -> dict[p.Member, float]:
        """Torques on the members from outside, with losses, for 1 N·m at the input, N·m."""
        task = self.given.task
        torque = p.power_flow(self.basic, self.given.efficiency, task.input, task.output).torque
        return {member: float(value) / float(torque[task.input]) for member, value in torque.items()}

    @property
    def forces(self) -> tuple[float, float]:
        """Circumferential forces on one satellite from wheels 1 and 3 for 1 N·m at the input, N: all carry alike."""
        working = self.sizes.working
        wheels = zip(("wheel1", "wheel3"), (working[0], working[3]), strict=True)
        one, three = (abs(2 * self.torques[w] / (self.satellites * float(d))) for w, d in wheels)  # type: ignore[index]
        return one, three

    @property
    def shifted(self) -> bool:
        """Whether coaxiality is by profile shift."""
        return bool(np.any(self.sizes.shift_sums > 0))

    @property
    def gap(self) -> float:
        """Free space between neighbouring satellites, m."""
        return float(p.neighbourhood_gap(self.sizes, self.satellites))

    @property
    def assembly_number(self) -> int:
        return round(float(p.assembly_number(self.scheme, self.teeth, self.satellites)))

    @cached_property
    def interference(self) -> tuple[tuple[int, p.Internal], ...]:
        """Margins of the rows that have a ring: (row, margins)."""
        rows = [row for row, kind in enumerate(self.scheme.rows) if kind == p.INTERNAL]
        return tuple((row, p.internal_pair(self.scheme, self.sizes, self.teeth, row)) for row in rows)

    @cached_property
    def chosen(self) -> int | None:
        """Place of the chosen teeth among the ranked solutions, from 0; None where they are outside the ranges."""
        found = self.candidates
        same = np.all(found.teeth[:, self.ranking] == np.array(self.teeth)[:, None], axis=0)
        same &= found.satellites[self.ranking] == self.satellites
        places = np.flatnonzero(same)
        return int(places[0]) if len(places) else None


def solve(given: Given) -> Found:
    """Raises ProblemError where no teeth give the ratio, or those given fail a condition, or the rack cuts none."""
    check(given.task)
    found = all_candidates(given)
    order = ranked(given.task, found)
    if given.teeth is not None:
        return Found(given, found, order, given.teeth, check_teeth(given.task, given.teeth, found, order))
    if not len(order):
        raise no_solution(given.task)
    z1, z2, z2_, z3 = (int(teeth) for teeth in found.teeth[:, order[0]])
    return Found(given, found, order, (z1, z2, z2_, z3), int(found.satellites[order[0]]))


def all_candidates(given: Given) -> Candidates:
    """Every combination of teeth and satellites that was considered, with the reason of its rejection."""
    return search(given.task)
