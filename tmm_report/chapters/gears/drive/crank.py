"""The driving link of a lever mechanism that the drive turns: its speed, and the moment by which it loads the gears."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

from tmm_report.mechanics.lever.extremes import peaks
from tmm_report.problems import N_, Message, Problem, doubt
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.chapters.lever.friction.solve import FrictionFound
    from tmm_report.chapters.lever.moving import Moving

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
    size and the angle of the link at it, rad. `friction`: the mean moment of the friction of the pairs, which is in all
    of them where it is `rubs`; None where none is stated, nan where it has no mean."""

    mean: float
    greatest: float
    angle: float
    friction: float | None = None
    rubs: bool = False

    @property
    def peak(self) -> float:
        """How many times the greatest moment is the mean one, signed."""
        return self.greatest / self.mean if self.mean else math.inf


def moments(moving: Moving | None, friction: bool) -> Moments | None:
    """None without loads, or where the cycle has no mean; `friction`: with that of the pairs, where it is stated."""
    if moving is None or moving.forces is None:
        return None
    forces = moving.forces
    omega = float(forces.table.motion.omega)
    if forces.works is None or not forces.bounded:
        return None
    sense, mean = math.copysign(1.0, omega), forces.works.power / abs(omega)
    ends, lost = [(sense * end.value, end.turned) for end in forces.extremes], None
    reduced = moving.friction.reduced if moving.friction else None
    if moving.friction:
        lost = float(reduced.panels.mean(reduced.moment)) if reduced else math.nan
    if rubs := friction and reduced is not None and moving.friction is not None:
        mean, ends = mean + float(lost or 0.0), _rubbing_ends(moving.friction, sense)
    greatest, angle = max(ends, key=lambda end: abs(end[0]))
    return Moments(mean, float(greatest), float(angle), lost, rubs)


def _rubbing_ends(found: FrictionFound, sense: float) -> list[tuple[float, float]]:
    """Least and greatest of the balancing moment with the friction of the pairs in it, with their angles."""
    assert found.whole is not None and found.reduced is not None  # asked for only where it is known
    over, reduced = found.whole[0], found.reduced
    return [
        (end.value, end.turned)
        for end in peaks(over.panels, (sense * over.balancing + reduced.moment)[None], over.closed)[0]
    ]


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
