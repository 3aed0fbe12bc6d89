"""The driving link of a lever mechanism that the drive turns: its speed, and the moment by which it loads the gears."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

from tmm_report.problems import N_, Message, Problem, doubt
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.chapters.machine import Moving

SPEED = ("mechanism", "driver", "speed")
RPM = 30 / math.pi


@dataclass(frozen=True)
class Crank:
    """The driving link as the file states it: `omega`, rad/s, + counter-clockwise; `linked`: its speed is that of the
    drive's output; `turned`: whether its sense of rotation is stated; `key`: speed or period."""

    link: str
    omega: float
    linked: bool = False
    turned: bool = False
    key: str = "speed"


@dataclass(frozen=True)
class Moments:
    """Of the balancing moment over the cycle, N·m, positive where the drive must give work: its mean, the greatest
    size and the angle of the link at it, rad."""

    mean: float
    greatest: float
    angle: float

    @property
    def peak(self) -> float:
        """How many times the greatest moment is the mean one, signed."""
        return self.greatest / self.mean if self.mean else math.inf


def moments(moving: Moving | None) -> Moments | None:
    """None without loads, or where the cycle has no mean."""
    if moving is None or moving.forces is None:
        return None
    forces = moving.forces
    omega = float(forces.table.motion.omega)
    if forces.works is None or not forces.bounded:
        return None
    sense = math.copysign(1.0, omega)
    ends = [(sense * end.value, end.turned) for end in forces.extremes]
    greatest, angle = max(ends, key=lambda end: abs(end[0]))
    return Moments(forces.works.power / abs(omega), float(greatest), float(angle))


def doubts(crank: Crank, speed: float, ratio: float, tolerance: float) -> Iterator[Problem]:
    """The output turns at `speed`, rad/s, the link as it is stated: they differ by more than the drive's tolerance, or
    in sense. `ratio`: of the drive."""
    path = (*SPEED[:2], crank.key)
    said = {"link": crank.link, "own": f"{abs(speed) * RPM:.5g}", "stated": f"{abs(crank.omega) * RPM:.5g}"}
    if abs(abs(speed / crank.omega) - 1) > tolerance:
        wrong = N_("the output of the drive makes %(own)s rpm, and the driving link %(link)s %(stated)s rpm")
        right = N_(
            "speed: drive in the driver takes the drive's; a drive of the ratio %(ratio)s gives the stated one; "
            "output: other in the drive if it turns something else"
        )
        wanted = f"{abs(ratio * speed / crank.omega):.5g}"
        yield doubt(wrong, path, Message(right, {"ratio": wanted}), **said)
    elif crank.turned and speed * crank.omega < 0:
        wrong = N_(
            "its input turning counter-clockwise, the drive turns the link %(link)s against its stated sense"
        )
        right = N_(
            "speed: drive in the driver turns the input shaft so that the link has its sense of rotation"
        )
        yield doubt(wrong, (*SPEED[:2], "rotation"), Message(right), link=crank.link)
