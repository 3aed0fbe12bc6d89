"""Chapter before the structure: lengths of a linkage from what is asked of its motion.

The mechanism of the variant takes them as they are found, or rounded; its motion is then held against what was asked.
(Artobolevsky, Theory of mechanisms and machines, ch. 27)
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from tmm_report.chapters.lever.synthesis import (
    body_steps,
    points_steps,
    positions_steps,
    rocker_steps,
    rounding,
    steps,
)
from tmm_report.chapters.lever.synthesis.given import (
    AnglePairs,
    Body,
    CrankRocker,
    Dwell,
    Generator,
    Given,
    RockerPositions,
    SliderCrank,
    SliderPositions,
    SlottedLink,
    Synthesis,
    TurningGuide,
)
from tmm_report.chapters.lever.synthesis.values import ANGLES, LENGTHS, SPEEDS, SWING_OF_LINK, Values
from tmm_report.mechanics.lever.dyads import Dyad
from tmm_report.mechanics.lever.stated_masses import Synthesised
from tmm_report.mechanics.lever.synthesis import FourBar, least
from tmm_report.problems import N_, Message, Problem, doubt
from tmm_report.quantity.model import Table
from tmm_report.quantity.text import Amount, equalities
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.chapters.lever.kinematics.solve.positions import Kinematics
    from tmm_report.chapters.lever.kinematics.solve.strokes import Travel
    from tmm_report.course import LeverFound

__all__ = ["Design", "Found", "Given", "design", "offered", "solve"]


@dataclass(frozen=True, eq=False)
class Design:
    """`s`: the single numbers; `table`: of the points that the linkage goes through, where it goes through any; `bar`:
    of a function; `solutions`: of two positions of a body, the one that is taken the first (`body_steps`)."""

    given: Synthesis
    s: Values
    table: Table | None = None
    bar: FourBar | None = None
    solutions: tuple[tuple[float, ...], ...] = ()

    @property
    def lengths(self) -> list[str]:
        """What the mechanism may take as a length, by its keys."""
        return [key for key in LENGTHS if key in self.s]

    def taken(self, key: str) -> float:
        """A length as the mechanism takes it, m, an angle, rad, or a speed, rad/s."""
        number, step = self.s.number(key), self.given.round
        if key == "crank_way":  # the sense is that of the driving link's speed
            return abs(number)
        return number if step is None or key in (*ANGLES, *SPEEDS) else round(number / step) * step


@dataclass(frozen=True, eq=False)
class Found:
    """Found by `solve`. `unclear`: whether the demand may be of several links of the mechanism."""

    design: Design
    unclear: bool

    @property
    def given(self) -> Synthesis:
        return self.design.given

    @property
    def s(self) -> Values:
        return self.design.s

    @property
    def doubts(self) -> tuple[Problem, ...]:
        if not self.unclear:
            return ()
        right = Message(N_("name it: output: B"))
        return (doubt(N_("several links may be the one whose motion is asked"), ("synthesis",), right),)

    def summary(self) -> Iterator[Message]:
        """The main numbers in a sentence."""
        lengths = [key for key in ("crank", "rod", "rocker", "frame", "offset") if self.s.get(key)]
        said = {
            str(self.s.named(key).sign.base): Amount(1e3 * self.design.taken(key), 5, "mm") for key in lengths
        }
        yield Message(N_("synthesis: %(lengths)s"), {"lengths": equalities(said)})


def design(given: Synthesis) -> Design:
    """Raises ProblemError for what no linkage does, nor one of lengths that are rounded."""
    found = _exact(given)
    if given.round is not None:
        rounding.rounded(found)
    return found


def _exact(given: Synthesis) -> Design:
    asked = given.asked
    s = Values({"theta": SWING_OF_LINK} if isinstance(asked, SlottedLink) else None)
    match asked:
        case SliderCrank():
            steps.slider_crank(s, asked)
        case CrankRocker():
            rocker_steps.crank_rocker(s, asked)
        case SlottedLink():
            steps.slotted_link(s, asked)
        case TurningGuide():
            steps.turning_guide(s, asked)
        case RockerPositions():
            positions_steps.rocker(s, asked)
        case SliderPositions():
            positions_steps.slider(s, asked)
        case Generator():
            table, bar = points_steps.generator(s, asked)
            return Design(given, s, table, bar)
        case AnglePairs():
            table, bar = points_steps.pairs(s, asked)
            return Design(given, s, table, bar)
        case Dwell():
            return Design(given, s, points_steps.dwell(s, asked))
        case Body():
            poses, solutions = body_steps.body(s, asked)
            return Design(given, s, poses, solutions=solutions)
    return Design(given, s)


def offered(found: Design) -> dict[str, Synthesised]:
    """What the mechanism may take, by its keys."""
    rows = {key: row for row, key in enumerate(found.lengths)} if found.given.round is not None else {}
    keys = (*found.lengths, *(key for key in (*ANGLES, *SPEEDS) if key in found.s))
    return {key: Synthesised(key, found.taken(key), rows.get(key)) for key in keys}


def solve(given: Synthesis, lever: LeverFound | None) -> Found:
    """`lever`: the analysed mechanism."""
    found = design(given)
    kind = {
        "slider_crank": "slider",
        "slotted_link": "slider",
        "turning_guide": "slider",
        "crank_rocker": "rocker",
        "rocker_positions": "rocker",
        "slider_positions": "slider",
    }
    wanted = kind.get(given.kind)
    if getattr(given.asked, "crank_angles", None) is not None:  # two positions on the way, no stroke
        wanted = None
    if lever is None or wanted is None:
        return Found(found, False)
    may_be = [one for one in lever.kinematics.travels if one.output.kind == wanted]
    if given.output is not None:
        may_be = [one for one in may_be if given.output in (one.output.name, one.output.link)]
    may_be = [one for one in may_be if math.isfinite(one.stroke)]
    if len(may_be) == 1:
        _met(found.s, may_be[0], lever)
    return Found(found, len(may_be) > 1)


def _met(s: Values, travel: Travel, lever: LeverFound) -> None:
    """What the analysed mechanism makes of the demand."""
    if travel.output.kind == "slider":
        s.stroke_met = travel.stroke
    else:
        s.swing_met = travel.stroke
    s.K_met = travel.time_ratio
    _angle_met(s, travel, lever.kinematics)


def _angle_met(s: Values, travel: Travel, found: Kinematics) -> None:
    """Of the dyad that moves the output: the least angle of its links, or of its link and the normal of its guide."""
    moved_by = (one for one in found.linkage.groups if travel.output.link in one.group.links)
    dyad = next((one for one in moved_by if isinstance(one, Dyad) and one.kind in (1, 2)), None)
    if dyad is None or not found.cycle.closed:
        return
    label = dyad.group.label
    angle = least(
        lambda x: np.arcsin(np.minimum(found.cycle.motion(x).sines[label], 1.0)), 0.0, found.cycle.sweep
    )[1]
    if travel.output.kind == "slider":
        s.pressure_met = math.pi / 2 - angle
    if "transmission" in s:
        s.transmission_met = angle
