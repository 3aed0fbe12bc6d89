"""The key `cam` -> Given. What cannot be built raises Wrong with the key that is wrong; `wrong` tells it.

The cam turns about O at the origin. A translating follower is lifted upwards; a swinging one lies over the cam, its
pivot C on the level of O, so that the lift turns it upwards.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmm_report.chapters.cams.cam.block.alone import CHOSEN, FREE, CamAloneModel
from tmm_report.chapters.cams.cam.block.laws import Wrong, by_profile, law
from tmm_report.chapters.cams.cam.block.pieced import by_arcs
from tmm_report.chapters.cams.cam.block.sizes import (
    LIMITS,
    best_distance,
    chosen_roller,
    least,
    lowest,
    smallest,
)
from tmm_report.chapters.cams.cam.block.touching import GRID, must_touch
from tmm_report.chapters.cams.cam.given import Given
from tmm_report.mechanics.cams.cam import ByLaw, Cam, Sliding, Swinging
from tmm_report.mechanics.cams.follower_laws import FULL_TURN
from tmm_report.mechanics.cams.making import undercut
from tmm_report.mechanics.cams.sizes.least_size import Zone
from tmm_report.mechanics.cams.stated_profile import ByProfile
from tmm_report.problems import N_, Message, Problem, mistake

UP = 1j
UNIT = 1.0  # rad/s
DRAWN = 72  # equal parts of the turn for the curves, at least


def tried(stated: CamAloneModel) -> tuple[Given | None, list[Problem]]:
    """The cam where it can be built, and what the parts of the block say wrong of one another."""
    foreign = list(_foreign(stated))
    try:
        return built(stated), foreign
    except Wrong as error:
        key = "pitch_base" if error.key == "base" and stated.pitch_base is not None else error.key
        path = ("cam", key) if key in stated.model_fields_set else ("cam",)
        return None, [Problem(error.wrong, error.right, path), *foreign]


def _foreign(stated: CamAloneModel) -> Iterator[Problem]:
    """What is of another follower."""
    foreign = (
        ("offset", N_("a swinging follower has no offset"))
        if stated.swinging and stated.offset is not None
        else ("face_offset", N_("the offset of the face is that of a flat face that swings"))
        if stated.face_offset is not None and not (stated.swinging and stated.faced)
        else None
    )
    if foreign is not None:
        yield mistake(foreign[1], ("cam", foreign[0]))


def built(stated: CamAloneModel, driven: bool = False) -> Given:
    """`driven`: whether the drive has given its speed. Raises Wrong."""
    sense = _sense(stated)
    motion = _swinging(stated, sense) if stated.swinging else _sliding(stated, sense)
    face = _face(motion)
    limit, back = stated.pressure_angle_limit or LIMITS[type(motion)], stated.return_angle_limit
    roller = None if stated.faced else _roller(stated, motion, face, sense, limit)
    base, sized = _base(stated, roller), None
    if stated.sought:
        base, sized = smallest(stated, motion, roller, face, sense, limit)
    given: ByLaw | ByProfile
    if stated.profile and stated.profile.pieced:
        given, base = by_arcs(stated, motion, roller, face, sense, 0.0)
    elif stated.profile:
        given = by_profile(stated, motion, roller, face)
    else:
        side = motion.side if isinstance(motion, Swinging) else 1
        low = lowest(base, motion, roller, face)
        given = ByLaw(law(stated, stated.swinging), low, side, 0.0, sense)
    made = Cam(
        "", "1", "2", "B", "K", 0j, motion, given, roller, limit, base or least(given), face, "", back, sized
    )
    must_touch(made)
    groove = stated.closure == "groove"
    _must_be_made(made, groove, stated.cutter)
    omega = None if stated.speed is None else abs(_speed(stated))
    return Given(
        made,
        sense,
        omega,
        stated.positions,
        max(DRAWN, stated.positions),
        stated.shaft,
        stated.cutter,
        groove,
        driven,
    )


def _roller(
    stated: CamAloneModel, motion: Sliding | Swinging, face: complex, sense: int, limit: float
) -> float:
    """Its radius, m, 0 of an edge."""
    if stated.roller == CHOSEN:
        return chosen_roller(stated, motion, face, sense, limit, stated.pitch_base)
    return float(stated.roller or 0.0)


def _must_be_made(made: Cam, groove: bool, cutter: float | None) -> None:
    """A roller has room in its groove, and the cutter in every hollow. Raises Wrong."""
    roller = made.roller or 0.0
    if groove and not roller:
        raise Wrong(
            "closure",
            Message(N_("a groove holds a roller between its walls")),
            Message(N_("roller: 10 mm, or leave out closure")),
        )
    if groove and cutter is not None and cutter > roller:
        text = N_("the cutter, %(cutter)s m, does not enter the groove: the roller has %(roller)s m")
        told = {"cutter": f"{cutter:.4g}", "roller": f"{roller:.4g}"}
        raise Wrong("cutter", Message(text, told), Message(N_("a cutter of the roller's radius or smaller")))
    match undercut(made, groove, cutter, np.linspace(0, FULL_TURN, GRID)):
        case "outer":
            text = N_(
                "the outer wall of the groove is undercut: a hollow of the pitch curve is narrower than the roller"
            )
            raise Wrong(
                "closure",
                Message(text),
                Message(N_("a larger base circle, a smaller roller or a smoother law")),
            )
        case "cutter":
            text = N_("the cutter is too large for the hollow of the profile")
            raise Wrong("cutter", Message(text), Message(N_("a smaller cutter")))


def _sense(stated: CamAloneModel) -> int:
    sense = 1 if stated.rotation == "counter-clockwise" else -1
    if stated.speed is None or (speed := _speed(stated)) > 0:
        return sense
    if speed == 0:
        raise Wrong(
            "speed", Message(N_("the cam does not turn")), Message(N_("speed: 150 rpm, or leave it out"))
        )
    if "rotation" in stated.model_fields_set:
        text = N_("the sense of rotation is stated twice: by the sign of the speed and by rotation")
        raise Wrong("speed", Message(text), Message(N_("leave the sign or the key rotation")))
    return -1


def _speed(stated: CamAloneModel) -> float:
    """Until the drive has given it, one of any size: what may be wrong of a cam does not depend on that."""
    return UNIT if stated.speed is None or isinstance(stated.speed, str) else stated.speed


def _base(stated: CamAloneModel, roller: float | None) -> float | None:
    """Least radius of the profile, m; None where none is stated."""
    if stated.pitch_base is None:
        return stated.base if isinstance(stated.base, float) else None
    if stated.pitch_base <= (roller or 0.0):
        text = N_("the roller, %(roller)s m, is larger than the least radius of its centre, %(radius)s m")
        told = {"roller": f"{roller:.4g}", "radius": f"{stated.pitch_base:.4g}"}
        raise Wrong("base", Message(text, told), Message(N_("a smaller roller, or a larger pitch_base")))
    return stated.pitch_base - (roller or 0.0)


# ---------------------------------------------------------------- translating


def _sliding(stated: CamAloneModel, sense: int) -> Sliding:
    return Sliding(UP, complex(sense * _offset(stated, sense)), 1 + 0j)


def _offset(stated: CamAloneModel, sense: int) -> float:
    """Above zero where it lessens the pressure angle of the rise, m."""
    if stated.offset == FREE:
        return _best_offset(stated)
    e, side = float(stated.offset or 0.0), stated.side
    if side is None:
        return e
    if not e:
        text = N_("without an offset the line of the follower passes on no side")
        raise Wrong("side", Message(text), Message(N_("offset: 12 mm, or leave out side")))
    if e < 0:
        text = N_("the side of the offset is stated twice: by its sign and by side")
        raise Wrong("offset", Message(text), Message(N_("an offset above zero, or no side")))
    if side in ("left", "right"):
        return e if (side == "right") == (sense > 0) else -e
    return e if side == "against" else -e


def _best_offset(stated: CamAloneModel) -> float:
    if stated.base != "smallest" or stated.faced:
        text = N_("a free offset is that of the smallest cam under a roller or an edge")
        raise Wrong("offset", Message(text), Message(N_("base: smallest, or offset: 12 mm")))
    if stated.side is not None:
        raise Wrong("side", Message(N_("a free offset lies on the side that the law asks for")))
    limit = stated.pressure_angle_limit or LIMITS[Sliding]
    return Zone(law(stated, False), limit, stated.return_angle_limit).best.e


# ---------------------------------------------------------------- swinging


def _swinging(stated: CamAloneModel, sense: int) -> Swinging:
    if stated.phases and stated.swing is None:
        raise Wrong("swing", Message(N_("the key %(key)s is missing"), {"key": "swing"}))
    if stated.centre_distance is None:
        text = N_("the distance between the pivots of cam and follower is missing")
        raise Wrong("centre_distance", Message(text), Message(N_("centre_distance: 120 mm")))
    if stated.arm is None and not stated.faced:
        text = N_("the length of the swinging follower is missing, from its pivot to where it is lifted")
        raise Wrong("arm", Message(text), Message(N_("arm: 120 mm")))
    if stated.side not in ("against", "with"):
        text = N_("the side is not stated to which the swinging follower lifts")
        right = N_("side: against or side: with the cam's rotation")
        raise Wrong("side", Message(text), Message(right))
    side = sense if stated.side == "with" else -sense
    apart = stated.centre_distance
    if apart == FREE:
        apart = best_distance(stated, stated.side == "with")
    long = stated.arm or float(apart)
    arm = complex(long, -side * (stated.face_offset or 0.0)) if stated.faced else complex(long)
    return Swinging(complex(-side * float(apart)), arm, side)


def _face(motion: Sliding | Swinging) -> complex:
    """Direction of a flat face in the follower's axes: across the motion, or along the arm."""
    return 1j * motion.along * motion.turn.conjugate() if isinstance(motion, Sliding) else 1 + 0j
