"""Chapter "choice of method": every method on this mechanism, with its errors and what it costs.

All of it is the same at every run and on every machine: costs are those of a table, errors are found against the
closed form in double precision and rounded up to one digit.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cached_property
from typing import Any

from tmm_report.chapters.lever.kinematics.solve.positions import Kinematics
from tmm_report.chapters.lever.methods.counting import counting
from tmm_report.chapters.lever.methods.given import Comparison
from tmm_report.chapters.lever.methods.scene import scene
from tmm_report.chapters.lever.moving import Moving
from tmm_report.mechanics.rivals import choice
from tmm_report.mechanics.rivals.cost import CLOSED
from tmm_report.mechanics.rivals.counts import Counted
from tmm_report.mechanics.rivals.model import Trial
from tmm_report.mechanics.rivals.trials import Judged, Rivals, by_method
from tmm_report.records import dataclass

FINE = 100  # positions a turn of the finest table


@dataclass(frozen=True, eq=False)
class Family(Judged):
    """The methods for one thing, "motion" or "forces": trials by method and rising count, seconds by the table of
    costs; `asked`: steps of the table and of the diagrams."""

    @cached_property
    def unit(self) -> float:
        """Seconds of the closed form at the positions of the table: costs are told by it."""
        return next(
            one.seconds for one in self.trials if one.method.key == CLOSED and one.count == self.asked[0]
        )


@dataclass(frozen=True, eq=False)
class Found:
    """`accuracy`: what is to hold, stated or not."""

    given: Comparison
    kinematics: Kinematics
    accuracy: float
    families: Mapping[str, Family]
    counted: (
        Counted | None
    )  # how many positions are enough; None where the mechanism does not close all round


def solve(given: Comparison, moving: Moving) -> Found:
    """`moving`: its friction is in the machine whose positions are counted; None leaves it out."""
    motion, loaded = moving.kinematics, moving.forces
    accuracy = choice.ACCURACY if given.accuracy is None else given.accuracy
    asked = tuple(dict.fromkeys((motion.positions.table, motion.positions.diagram)))
    counts = sorted({*asked, FINE * motion.cycle.turns})

    def family(key: str, tried: tuple[Rivals[Any, Any], list[Trial]]) -> Family:
        rivals, trials = tried
        return Family(key, _ordered(trials), tuple(rivals.refused), accuracy, asked)

    families = {"motion": family("motion", choice.motions(motion.cycle, counts))}
    if loaded is not None:
        families["forces"] = family("forces", choice.forces(scene(loaded.given, motion), counts))
    counted = counting(moving, given.accuracy)
    return Found(given, motion, accuracy, families, counted)


def _ordered(trials: Sequence[Trial]) -> tuple[Trial, ...]:
    return tuple(one for own in by_method(trials) for one in own)
