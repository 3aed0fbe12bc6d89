"""The schemes of a lever mechanism that its initial data, structure and kinematics print: one set for a note."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from tmm_report.figures.schemes.scheme import PAGE
from tmm_report.figures.schemes.ties import Tie
from tmm_report.report.page import Page
from tmm_report.report.schemes import Schemes

if TYPE_CHECKING:
    from tmm_report.course import LeverFound


def schemes_of(lever: LeverFound, page: Page) -> Schemes:
    """The schemes of the note, made once for all its chapters."""
    return page.once(_schemes, lever)


def _schemes(lever: LeverFound) -> Schemes:
    k = lever.kinematics
    # every turn goes through the same places: those of the first are drawn
    turns, count = k.cycle.turns, k.positions.diagram
    paths = k.diagram if turns == 1 else k.cycle.motion(k.cycle.once(count)[: count // turns + 1])
    ties = (*ties_of(lever), *_sprung(lever))
    return Schemes(lever.given.mechanism, k.table, paths, k.distinct, lever.plans.length_scale, ties)


def ties_of(lever: LeverFound) -> Iterator[Tie]:
    """Springs and dampers among the loads."""
    for one in lever.kinetostatics.tied if lever.kinetostatics else ():
        name = f"{one.letter}{one.number}"
        yield Tie("spring" if one.letter == "c" else "damper", one.points, name, one.links)


def _sprung(lever: LeverFound) -> Iterator[Tie]:
    """Springs of the machine in motion, but for those whose fixed end is beyond the sheet."""
    motion = lever.kinematics.diagram
    places = motion.places[np.isfinite(motion.places)]
    for point, fixed in lever.sprung:
        every = np.append(places, fixed) / lever.plans.length_scale
        if np.ptp(every.real) <= PAGE[0] and np.ptp(every.imag) <= PAGE[1]:
            yield Tie("spring", (point, fixed))
