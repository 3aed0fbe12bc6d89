"""The base circle of a cam: stated, or the smallest that its law asks for; the follower's place on it. What cannot be
found raises Wrong with the key that is wrong."""

from __future__ import annotations

import math
from collections.abc import Sequence

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
from tmm_report.mechanics.cams.sizes.centres import Centres, Condition, NoZone
from tmm_report.mechanics.cams.sizes.curvature import OnArm, OnLine, least_convex, least_hollow
from tmm_report.mechanics.cams.sizes.least_face import Face, TurnedFace, under_face
from tmm_report.mechanics.cams.sizes.least_size import Lever, Size, Zone
from tmm_report.mechanics.cams.sizes.rules import by_shaft, chosen, roller_limits
from tmm_report.mechanics.cams.stated_profile import ByProfile
from tmm_report.problems import N_, Message
from tmm_report.quantity.text import for_example

STEP = 1e-3  # m: to whole steps a chosen roller is rounded down
LIMITS = {Sliding: math.radians(30.0), Swinging: math.radians(45.0)}  # of the pressure angle, the course's


def smallest(
    model: CamStated,
    motion: Sliding | Swinging,
    roller: float | None,
    face: complex,
    sense: int,
    limit: float,
) -> tuple[float, Size]:
    """Least radius of the profile, rounded up, m, and by what of the law it was found."""
    if model.profile:
        raise Wrong("base", Message(N_("this follows from the profile of the cam")))
    radius, sized = _by_law(model, motion, roller, face, sense, limit)
    within = roller or 0.0
    if (shaft := getattr(model, "shaft", None)) is not None:
        radius = max(radius, by_shaft(shaft, within))
    pitch = _rounded(model, radius)
    if pitch <= within:
        text = N_("the roller, %(roller)s m, is larger than the least radius of its centre, %(radius)s m")
        told = {"roller": f"{roller:.4g}", "radius": f"{pitch:.4g}"}
        raise Wrong("base", Message(text, told), Message(N_("a smaller roller, or state it: base: 40 mm")))
    return pitch - within, sized


def _by_law(
    model: CamStated,
    motion: Sliding | Swinging,
    roller: float | None,
    face: complex,
    sense: int,
    limit: float,
) -> tuple[float, Size]:
    """Least radius of the pitch curve, of the profile under a face, m, by the law alone."""
    if isinstance(motion, Sliding):
        if roller is None:
            under = _under_face(model, motion, face)
            return under.asked.b, under
        zone = Zone(law(model, False), limit, model.return_angle_limit)
        return zone.at(sense * motion.offset).radius, zone
    alike = motion.side * sense > 0
    if roller is None:
        turned = _under_turned_face(model, motion, face, alike, limit)
        assert turned.lowest is not None
        return float(turned.radius(turned.lowest)), turned
    lever = Lever(
        law(model, True), abs(motion.arm), abs(motion.pivot), alike, limit, model.return_angle_limit
    )
    if lever.lowest is None:
        raise _no_place(lever)
    return lever.radius(lever.lowest.least), lever


def best_distance(model: CamStated, alike: bool) -> float:
    """Of the pivots of the smallest cam under a swinging roller or edge, m."""
    arm = getattr(model, "arm", None)
    if model.faced:
        text = N_(
            "under a flat face nothing but the room for both pivots bounds how near they stand: their distance is "
            "stated"
        )
        raise Wrong("centre_distance", Message(text), Message(N_("centre_distance: 120 mm")))
    if model.base != "smallest" or arm is None:
        text = N_("a free distance between the pivots is that of the smallest cam under a roller or an edge")
        raise Wrong(
            "centre_distance", Message(text), Message(N_("base: smallest, or centre_distance: 120 mm"))
        )
    limit = model.pressure_angle_limit or LIMITS[Swinging]
    centres = Centres(law(model, True), arm, alike, limit, model.return_angle_limit)
    try:
        return abs(centres.best.p)
    except NoZone as error:
        raise _nowhere(error) from None


def _no_place(sized: Lever) -> Wrong:
    """Why no cam keeps the angles at a distance of the pivots, and what would."""
    try:
        closest = sized.centres.closest
    except NoZone as error:
        return _nowhere(error)
    text = N_("no cam keeps the pressure angles with these pivots and this lever")
    least = abs(closest.p)
    if sized.apart >= least:
        right = N_("the pivots nearer to one another: the axis of the cam may stand from %(least)s m on")
        return Wrong("base", Message(text), Message(right, {"least": f"{least:.4g}"}))
    right = N_("the pivots %(least)s m apart or more, or a longer phase: %(phases)s")
    told = {"least": f"{math.ceil(1e4 * least) / 1e4:.4g}", "phases": _asking(closest.by)}
    return Wrong("base", Message(text), Message(right, told))


def _nowhere(error: NoZone) -> Wrong:
    text = N_(
        "no place of the cam's axis keeps the pressure angles, whatever the distance between the pivots"
    )
    right = N_("a smaller swing, greater angles, or a longer phase: %(phases)s")
    return Wrong("base", Message(text), Message(right, {"phases": _asking(error.args[0])}))


def _asking(conditions: Sequence[Condition]) -> str:
    """The phases, as their keys, in which the follower moves where a condition is asked."""
    asked = {"rise" if one.at.slope > 0 else "return" for one in conditions if one.at.slope}
    return ", ".join(sorted(asked, reverse=True)) or "rise, return"


def _rounded(model: CamStated, radius: float) -> float:
    step = model.round
    return radius if step is None else step * math.ceil(radius / step - 1e-9)


STATE = N_("state it: base: 40 mm")


def _under_face(model: CamStated, motion: Sliding, face: complex) -> Face:
    """Least base circle by the curvature."""
    if abs((face * motion.turn * motion.along.conjugate()).real) > 1e-9:
        text = N_("the smallest cam under a flat face is found of one that slides across its face")
        raise Wrong("base", Message(text), Message(STATE))
    under = under_face(law(model, False), _curvature(model))
    if not under.asked.b > 0:
        raise _any_will_do()
    return under


def _under_turned_face(
    model: CamStated, motion: Swinging, face: complex, alike: bool, limit: float
) -> TurnedFace:
    """The same of a face that swings."""
    away = face_away(motion, face)
    turned = TurnedFace(law(model, True), away, abs(motion.pivot), alike, _curvature(model), limit)
    if turned.lowest is None:
        text = N_(
            "no cam under this face keeps the curvature and the pressure angle at this distance between the pivots"
        )
        right = N_("a longer phase, a smaller swing, a greater distance, a smaller least_curvature")
        raise Wrong("base", Message(text), Message(right))
    if turned.any_will_do:
        raise _any_will_do()
    return turned


def face_away(motion: Swinging, face: complex) -> float:
    """Distance of a swinging face from its pivot, m, above zero on its far side from the cam."""
    normal = 1j * face * (1 if motion.side * (motion.arm * face.conjugate()).real > 0 else -1)
    return float((normal * motion.arm.conjugate()).real)


def _curvature(model: CamStated) -> float:
    if model.least_curvature is None:
        text = N_("under a flat face the smallest cam follows from the least radius of curvature")
        right = for_example("least_curvature: 5 mm")
        raise Wrong("base", Message(text), right)
    return model.least_curvature


def _any_will_do() -> Wrong:
    text = N_("by this law any base circle keeps the curvature: none is smallest")
    return Wrong("base", Message(text), Message(STATE))


def chosen_roller(
    model: CamStated, motion: Sliding | Swinging, face: complex, sense: int, limit: float, pitch: float | None
) -> float:
    """The greatest roller that the rules allow, rounded down; `pitch`: least radius of the pitch curve, m, where it is
    stated."""
    if pitch is None and not getattr(model, "sought", False):
        text = N_("a roller is chosen by the pitch curve")
        raise Wrong(
            "roller", Message(text), Message(N_("base: smallest, pitch_base: 50 mm, or roller: 10 mm"))
        )
    if model.profile:
        raise Wrong("roller", Message(N_("this is stated where the profile is: roller: 10 mm")))
    if pitch is not None:
        return _fitting(model, motion, face, sense, pitch)
    found = 0.0
    while True:  # about a shaft the pitch curve grows with the roller, by less than the roller would need to
        radius = smallest(model, motion, found, face, sense, limit)[0] + found
        most = _fitting(model, motion, face, sense, radius)
        if most <= found or getattr(model, "shaft", None) is None:
            return most
        found = most


def _fitting(model: CamStated, motion: Sliding | Swinging, face: complex, sense: int, radius: float) -> float:
    """The greatest roller on a pitch curve of the least `radius`, m."""
    start = lowest(radius, motion, 0.0, face)
    place: OnLine | OnArm
    if isinstance(motion, Sliding):
        place = OnLine(sense * motion.offset, start)
    else:
        d, arm = abs(motion.pivot), abs(motion.arm)
        leaning = math.acos((d * d + arm * arm - radius**2) / (2 * d * arm))
        place = OnArm(arm, d, leaning, motion.side * sense > 0)
    own = law(model, isinstance(motion, Swinging))
    hollow = least_hollow(own, place) if getattr(model, "closure", "") == "groove" else math.inf
    limits = roller_limits(radius, least_convex(own, place), hollow)
    found = chosen(limits.most, STEP if limits.most >= STEP else STEP / 10)
    if found is None:
        raise Wrong("roller", Message(N_("no roller keeps the rules on this pitch curve")), Message(STATE))
    return found


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
