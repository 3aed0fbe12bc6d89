"""The ways in which a planetary stage runs: speeds, efficiency and torques, whichever member is held."""

from __future__ import annotations

import math
from collections.abc import Mapping
from itertools import permutations

from tmm_report.chapters.gears.planetary.given import Given
from tmm_report.mechanics.gears.planetary import stage as p
from tmm_report.records import dataclass


@dataclass(frozen=True, eq=False)
class Motion:
    """One of the ways in which the stage runs: speeds for an input speed of 1 and the efficiency.

    `exponent`: +1 where wheel 1 drives wheel 3 in the stopped-carrier frame, −1 where wheel 3 drives wheel 1.
    """

    input: p.Member
    output: p.Member
    held: p.Member
    speed: Mapping[p.Member, float]
    satellite: float
    exponent: int
    efficiency: float

    @property
    def ratio(self) -> float:
        return 1 / self.speed[self.output] if self.speed[self.output] else math.inf

    @property
    def locks(self) -> bool:
        return not self.efficiency > 0


def motions(given: Given, teeth: tuple[int, int, int, int], basic: float) -> tuple[Motion, ...]:
    """All the ways in which the stage can run: each member held, driven from either of the others.

    Of a basic ratio of 1 with the carrier stopped only: else a central wheel held holds the other.
    """
    ways = permutations(p.MEMBERS, 2)
    return tuple(_motion(given, teeth, basic, *way) for way in ways if basic != 1 or "carrier" not in way)


def _motion(
    given: Given, teeth: tuple[int, int, int, int], basic: float, input: p.Member, output: p.Member
) -> Motion:
    (held,) = set(p.MEMBERS) - {input, output}
    speed = {m: float(w) for m, w in p.relative_speeds(basic, input, held).items()}
    flow = p.power_flow(basic, given.efficiency, input, output)
    satellite = p.satellite_speed(given.task.scheme, teeth, speed["wheel1"], speed["carrier"])
    return Motion(input, output, held, speed, float(satellite), int(flow.exponent), float(flow.efficiency))


def torques(given: Given, basic: float) -> dict[p.Member, float]:
    """Torques on the members from outside, with losses, for 1 N·m at the input, N·m."""
    task = given.task
    torque = p.power_flow(basic, given.efficiency, task.input, task.output).torque
    return {member: float(value) / float(torque[task.input]) for member, value in torque.items()}
