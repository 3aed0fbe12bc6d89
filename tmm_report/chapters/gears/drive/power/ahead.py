"""The drive as its power side leaves it: with the motor's speed, and with teeth of the stages that had no ratio."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import TYPE_CHECKING, TypeVar

from tmm_report.chapters.gears.drive.crank import Crank, Moments
from tmm_report.chapters.gears.drive.power.given import Given as PowerGiven
from tmm_report.chapters.gears.drive.power.plan import Known, Need, Plan, make
from tmm_report.chapters.gears.drive.stages import Given as StageGiven
from tmm_report.chapters.gears.drive.stages import Stage, solve_known
from tmm_report.chapters.gears.ordinary.given import PairStage
from tmm_report.chapters.gears.spur.given import Spur
from tmm_report.problems import N_, Message, ProblemError, mistake

if TYPE_CHECKING:
    from tmm_report.chapters.gears.drive.solve import Given

    Drive = TypeVar("Drive", bound=Given)


def planned(given: Drive, moments: Moments | None) -> tuple[Drive, Plan | None]:
    """The drive with every stage known, and by what it was found; None where nothing is asked of a machine or a motor.

    `moments`: of the driving link that it turns. Raises ProblemError with the mistakes of its stages, with what is
    missing, or where no motor will do.
    """
    if given.power is None:
        return given, None
    known = [_known(one, found) for one, found in zip(given.stages, solve_known(given.stages), strict=True)]
    speed = abs(given.speed) if math.isfinite(given.speed) else None
    need = Need()
    if given.power.machine is None and given.crank is not None:
        need = _of_crank(given.power, given.crank, moments, speed, known)
    plan = make(given.power, known, speed, need, given.tolerance)
    stages = list(given.stages)
    for k, teeth in (plan.teeth or {}).items():
        stages[k] = _with(stages[k], (plan.shares or {})[k], teeth)
    # the sign of a speed that is not known yet is that in which the shaft is to turn
    return replace(given, speed=math.copysign(plan.speed, given.speed), stages=tuple(stages)), plan


def _known(given: StageGiven, found: Stage | None) -> Known:
    if found is not None:
        return Known(
            getattr(given, "kind", "planetary"), found.efficiency, abs(found.wanted), abs(found.ratio)
        )
    assert isinstance(given, Spur | PairStage) and given.teeth is not None  # no other is open
    return Known("spur", given.efficiency if isinstance(given, Spur) else given.eta, teeth=given.teeth)


def _with(given: StageGiven, ratio: float, teeth: tuple[int, int]) -> StageGiven:
    assert isinstance(given, Spur | PairStage)
    return replace(given, ratio=given.sense * ratio, teeth=teeth)


def _of_crank(
    given: PowerGiven, crank: Crank, moments: Moments | None, speed: float | None, stages: list[Known]
) -> Need:
    """By the balancing moment of the driving link, at its stated speed, or at that which the drive gives it."""
    if moments is None:
        if len(given.motors) == 1:
            return Need(None, None if crank.linked else abs(crank.omega))
        wrong = N_("the driving link has no balancing moment with a mean, so no power is known")
        right = Message(
            N_("state loads of the mechanism, or the machine: output: {power: 3 kW, speed: 60 rpm}")
        )
        raise ProblemError([mistake(wrong, ("drive", "output"), right)])
    moment = abs(moments.greatest) if given.peak else moments.mean
    if moment <= 0:
        wrong = N_("on average the driving link gives work to the drive, so no motor is needed")
        right = Message(N_("needed: greatest, or other loads of the mechanism"))
        raise ProblemError([mistake(wrong, ("drive", "output"), right)])
    if not crank.linked:
        return Need(moment * abs(crank.omega), abs(crank.omega))
    assert speed is not None  # of a linked one the motor is stated
    turned = speed / math.prod(one.ratio or 1.0 for one in stages)
    return Need(moment * turned, turned, wanted=False)
