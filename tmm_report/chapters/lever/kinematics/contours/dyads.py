"""The contour of a dyad (an Assur group of class II) by its kind."""

from __future__ import annotations

from collections.abc import Callable

from tmm_report.chapters.lever.kinematics.contours.dyads_sliding import prp, rpp
from tmm_report.chapters.lever.kinematics.contours.dyads_turning import rpr, rrp, rrr
from tmm_report.chapters.lever.kinematics.contours.equations import Written
from tmm_report.chapters.lever.kinematics.contours.worked import Bench
from tmm_report.mechanics.lever.dyads import Dyad

_KINDS: dict[int, Callable[[Bench, Dyad], Written]] = {1: rrr, 2: rrp, 3: rpr, 4: prp, 5: rpp}


def write(bench: Bench, d: Dyad) -> Written:
    """The contour of a dyad with its numbers; adds the poses of its links to the bench."""
    return _KINDS[d.kind](bench, d)
