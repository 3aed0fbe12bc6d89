"""What rounding does to a found linkage: stroke, time ratio and angles of the lengths as they are taken."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from tmm_report.chapters.lever.synthesis import body_steps, points_steps
from tmm_report.chapters.lever.synthesis.given import (
    AnglePairs,
    Body,
    CrankRocker,
    Dwell,
    Generator,
    RockerPositions,
    SliderCrank,
    SliderPositions,
    SlottedLink,
    TurningGuide,
)
from tmm_report.chapters.lever.synthesis.refused import mm, refused
from tmm_report.mechanics.lever import synthesis
from tmm_report.problems import N_, Message

if TYPE_CHECKING:
    from collections.abc import Callable

    from tmm_report.chapters.lever.synthesis.solve import Design
    from tmm_report.chapters.lever.synthesis.values import Values

LINKS = ("crank", "rod", "rocker", "frame", "link", "arm", "radius")


def rounded(found: Design) -> None:
    """Adds to the numbers of the design what its rounded lengths do. Raises ProblemError where they no longer do it."""
    step = found.given.round
    assert step is not None
    for key in LINKS:
        if key in found.s and abs(found.taken(key)) < step / 2 and found.s.number(key):
            limit = Message(N_("at most %(most)s"), {"most": mm(abs(found.s.number(key)))})
            wrong = N_("a length of %(length)s would be rounded to nothing")
            raise refused(wrong, "round", right=limit, length=mm(abs(found.s.number(key))))
    s, of = found.s, found.taken
    match asked := found.given.asked:
        case SliderCrank():
            does = synthesis.slider_crank_does(of("crank"), of("rod"), of("offset"))
        case CrankRocker():
            frame = math.hypot(of("frame_x"), of("frame_y"))
            does = synthesis.crank_rocker_does(of("crank"), of("rod"), of("rocker"), frame)
        case RockerPositions() | SliderPositions() if asked.crank_angles is not None:
            moved = moved_joints(s, of)
            turned = of("crank") * np.exp(1j * np.array(asked.crank_angles))
            s.misfit = float(np.abs(np.abs(moved - turned) - of("rod")).max())
            return
        case RockerPositions():
            does = synthesis.crank_rocker_does(*map(of, ("crank", "rod", "rocker", "frame")))
        case SliderPositions():
            does = synthesis.slider_crank_does(of("crank"), of("rod"), of("offset"))
        case SlottedLink():
            does = synthesis.slotted_link_does(*map(of, ("crank", "frame", "link", "slide_line", "rod")))
        case TurningGuide():
            does = synthesis.turning_guide_does(*map(of, ("crank", "frame", "arm", "rod")))
        case Generator():
            assert found.bar is not None
            a, b, c, d = map(of, ("crank", "rod", "rocker", "frame"))
            bar = synthesis.FourBar(a, b, c, d, found.bar.side)
            x = np.linspace(*asked.x, synthesis.GRID + 1)
            _whole(bool(np.isfinite(bar.rocker(points_steps.angles(asked, x)[0])).all()))
            s.error_taken = points_steps.greatest_error(asked, bar)
            return
        case AnglePairs():
            assert found.bar is not None
            a, b, c, d = map(of, ("crank", "rod", "rocker", "frame"))
            phi, psi = np.array(asked.pairs).T
            rocker = synthesis.FourBar(a, b, c, d, found.bar.side).rocker(phi)
            _whole(bool(np.isfinite(rocker).all()))
            s.pairs_taken = float(np.abs(np.angle(rocker * np.exp(-1j * psi))).max())
            return
        case Dwell():
            place = points_steps.traced(asked, points_steps.linkage(asked), np.array(asked.angles))
            s.misfit = _misfit(place, complex(of("centre_x"), of("centre_y")), of("radius"))
            return
        case Body():
            pins = body_steps.pinned(asked)
            s.misfit = max(
                _misfit(places, complex(of(f"{key}_pivot_x"), of(f"{key}_pivot_y")), of(key))
                for places, key in zip(pins, ("crank", "rocker"), strict=True)
            )
            return
    _whole(math.isfinite(does.travel + does.K + does.angle))
    s.K_taken = does.K
    if isinstance(asked, CrankRocker | RockerPositions):
        s.swing_taken, s.transmission_taken = does.travel, does.angle
    else:
        s.stroke_taken, s.pressure_taken = does.travel, does.angle
        if "transmission" in s:
            s.transmission_taken = math.pi / 2 - does.angle


def moved_joints(s: Values, of: Callable[[str], float]) -> np.ndarray:
    """Of two positions of a rocker or a slider both places of its joint, complex, m; `of`: lengths by their keys."""
    if "psi_1" in s:
        psi = np.array([s.number("psi_1"), s.number("psi_2")])
        return np.asarray(of("frame") + of("rocker") * np.exp(1j * psi))
    return np.array([s.number("x_1"), s.number("x_2")]) - 1j * of("offset")


def _misfit(places: np.ndarray, pivot: complex, length: float) -> float:
    return float(np.abs(np.abs(places - pivot) - length).max())


def _whole(turns: bool) -> None:
    if not turns:
        wrong = N_("with the lengths rounded the linkage no longer goes through its motion")
        raise refused(wrong, "round", right=Message(N_("a smaller step, or leave it out")))
