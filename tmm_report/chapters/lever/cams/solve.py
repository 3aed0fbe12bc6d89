"""Cam pairs of a lever mechanism: each is found over the turn that its driving link makes."""

from __future__ import annotations

from tmm_report.chapters.cams.cam.solve.found import Cams, pair
from tmm_report.chapters.cams.cam.solve.turn import Turn, breaks_of
from tmm_report.chapters.lever.kinematics.solve.positions import Kinematics
from tmm_report.mechanics.cams.cam import Cam
from tmm_report.mechanics.lever.mechanism import FRAME

NEAR = 1e-9  # m: so near its place a fixed point is the pivot


def solve(kinematics: Kinematics) -> Cams:
    turn = turn_of(kinematics)
    cams = kinematics.linkage.mechanism.cams
    return Cams(tuple(pair(cam, turn, _letters(cam, kinematics)) for cam in cams))


def turn_of(kinematics: Kinematics) -> Turn:
    """The turn of the driving link, which is the cam."""
    cycle = kinematics.cycle
    breaks = breaks_of(kinematics.linkage.mechanism.cams, cycle.sense, cycle.zero, cycle.sweep)
    return Turn(
        cycle.sense, cycle.sweep, cycle.phi, kinematics.turned, kinematics.diagram_turned, breaks,
        kinematics.numbered, kinematics.distinct,
    )  # fmt: skip


def _letters(cam: Cam, kinematics: Kinematics) -> tuple[str, str]:
    """Names of the cam's axis and of the pivot of a follower that swings."""
    own = kinematics.linkage.structure
    frame, pivot = own.mechanism.links[FRAME].points, complex(getattr(cam.motion, "pivot", 0j))
    name = next((point for point, z in frame.items() if abs(z - cam.axis - pivot) < NEAR), "")
    return own.driver_pair.name, name
