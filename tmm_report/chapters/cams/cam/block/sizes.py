"""The base circle of a cam: stated, or the smallest that its law asks for; the follower's place on it. What cannot be
found raises Wrong with the key that is wrong."""

from __future__ import annotations

import math

import numpy as np

from tmm_report.chapters.cams.cam.block.laws import Wrong, law
from tmm_report.chapters.cams.cam.block.models import CamStated
from tmm_report.chapters.cams.cam.block.touching import GRID
from tmm_report.mechanics.cams.cam import (
    ByLaw,
    Sliding,
    Swinging,
    lowest_face_sliding,
    lowest_face_swinging,
    lowest_sliding,
    lowest_swinging,
)
from tmm_report.mechanics.cams.follower_laws import FULL_TURN
from tmm_report.mechanics.cams.least_size import Face, Lever, Size, Zone, under_face
from tmm_report.mechanics.cams.stated_profile import ByProfile
from tmm_report.problems import N_, Message

LIMITS = {Sliding: math.radians(30.0), Swinging: math.radians(45.0)}  # of the pressure angle, the course's


def smallest(
    model: CamStated,
    motion: Sliding | Swinging,
    roller: float | None,
    face: complex,
    sense: int,
    limit: float,
) -> tuple[float, Size]:
    """Least radius of the profile, rounded up, m, and by what it was found."""
    if model.profile:
        raise Wrong("base", Message(N_("this follows from the profile of the cam")))
    if roller is None:
        under = _under_face(model, motion, face)
        return _rounded(model, under.asked.b), under
    sized: Zone | Lever
    if isinstance(motion, Sliding):
        sized = Zone(law(model, False), limit, model.return_angle_limit)
        radius = sized.at(sense * motion.offset).radius
    else:
        sized = Lever(
            law(model, True), abs(motion.arm), abs(motion.pivot), motion.side * sense > 0, limit,
            model.return_angle_limit,
        )  # fmt: skip
        if sized.lowest is None:
            text = N_("no cam keeps the pressure angles with these pivots and this lever")
            right = N_("a longer phase, a smaller swing, another distance of the pivots, greater angles")
            raise Wrong("base", Message(text), Message(right))
        radius = sized.radius(sized.lowest.least)
    pitch = _rounded(model, radius)
    if pitch <= roller:
        text = N_("the roller, %(roller)s m, is larger than the least radius of its centre, %(radius)s m")
        told = {"roller": f"{roller:.4g}", "radius": f"{pitch:.4g}"}
        raise Wrong("base", Message(text, told), Message(N_("a smaller roller, or state it: base: 40 mm")))
    return pitch - roller, sized


def _rounded(model: CamStated, radius: float) -> float:
    step = model.round
    return radius if step is None else step * math.ceil(radius / step - 1e-9)


def _under_face(model: CamStated, motion: Sliding | Swinging, face: complex) -> Face:
    """Least base circle by the curvature."""
    state = Message(N_("state it: base: 40 mm"))
    if isinstance(motion, Swinging) or abs((face * motion.turn * motion.along.conjugate()).real) > 1e-9:
        text = N_("the smallest cam under a flat face is found of one that slides across its face")
        raise Wrong("base", Message(text), state)
    if model.least_curvature is None:
        text = N_("under a flat face the smallest cam follows from the least radius of curvature")
        right = Message(N_("for example, %(example)s"), {"example": "least_curvature: 5 mm"})
        raise Wrong("base", Message(text), right)
    under = under_face(law(model, False), model.least_curvature)
    if not under.asked.b > 0:
        raise Wrong(
            "base", Message(N_("by this law any base circle keeps the curvature: none is smallest")), state
        )
    return under


def lowest(base: float | None, motion: Sliding | Swinging, roller: float | None, face: complex) -> float:
    """The follower's coordinate on the base circle."""
    if base is None:
        raise Wrong("base", Message(N_("the key %(key)s is missing"), {"key": "base"}))
    low, text, values = (
        _lowest_face(base, motion, face) if roller is None else _lowest_roller(base + roller, motion)
    )
    if low is None:
        raise Wrong("base", Message(text, values))
    return low


Lowest = tuple[float | None, str, dict[str, str]]  # the coordinate, or what to say where there is none


def _lowest_roller(radius: float, motion: Sliding | Swinging) -> Lowest:
    """`radius`: of the pitch curve, m."""
    if isinstance(motion, Sliding):
        text = N_(
            "the base circle and the roller, %(radius)s m, do not reach the follower's line: its offset is %(away)s m"
        )
        values = {"radius": f"{radius:.4g}", "away": f"{abs(motion.offset):.4g}"}
        return lowest_sliding(motion, radius), text, values
    text = N_("the lever of %(arm)s m does not reach the base circle: the pivots are %(apart)s m apart")
    values = {"arm": f"{abs(motion.arm):.4g}", "apart": f"{abs(motion.pivot):.4g}"}
    return lowest_swinging(motion, radius), text, values


def _lowest_face(base: float, motion: Sliding | Swinging, face: complex) -> Lowest:
    if isinstance(motion, Sliding):
        low = lowest_face_sliding(motion, face, base)
        return low, N_("the flat face lies along the follower's motion"), {}
    text = N_("the flat face cannot touch the base circle: the pivots are %(apart)s m apart")
    return lowest_face_swinging(motion, face, base), text, {"apart": f"{abs(motion.pivot):.4g}"}


def least(given: ByLaw | ByProfile) -> float:
    """Least radius of a stated profile, m."""
    assert isinstance(given, ByProfile)
    return float(np.min(np.abs(given.curve.of(np.linspace(0, FULL_TURN, GRID)).z)))
