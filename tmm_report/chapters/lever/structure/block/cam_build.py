"""The key `cams` -> Cam. What cannot be built raises Wrong with the key that is wrong; `cam_checks` tries it first."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np

from tmm_report.chapters.lever.structure.block import cams as c
from tmm_report.chapters.lever.structure.block.cam_laws_build import Wrong as Wrong
from tmm_report.chapters.lever.structure.block.cam_laws_build import by_profile, law
from tmm_report.chapters.lever.structure.block.cam_touching import GRID, must_touch
from tmm_report.mechanics.cams.cam import (
    ByLaw,
    Cam,
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
from tmm_report.mechanics.lever.mechanism import FRAME, Guide, Link, Slide, ZeroAngle
from tmm_report.problems import N_, Message
from tmm_report.variant.values import unit_vector

LIMITS = {Sliding: math.radians(30.0), Swinging: math.radians(45.0)}  # of the pressure angle, the course's
SIDES = {"left": 1, "right": -1}


def cam(
    name: str,
    model: c.CamModel,
    links: Mapping[str, Link],
    guides: Mapping[str, Guide],
    slides: tuple[Slide, ...],
    driver: tuple[str, int, object],
) -> Cam:
    """`driver`: the driving link, its sense of rotation, its position 0. Raises Wrong."""
    link, sense, zero = driver
    body, follower = links[model.cam or link], links[model.follower]
    pivot = pivot_of(body, links[FRAME])
    if pivot is None:
        raise Wrong(
            "cam", Message(N_("the cam %(name)s has no fixed point to turn about"), {"name": body.name})
        )
    axis = complex(links[FRAME].points[pivot])
    motion = _motion(model, follower, links[FRAME], pivot, axis, guides, slides)
    face = _face(model.flat, motion) if model.flat else 1 + 0j
    roller = model.roller.radius if model.roller else None
    limit, back = model.pressure_angle_limit or LIMITS[type(motion)], model.return_angle_limit
    base, sized = model.base, None
    if base == "smallest":
        base, sized = _smallest(model, motion, roller, face, sense, limit)
    given = _given(model, motion, roller, face, sense, zero, base)
    made = Cam(
        name, body.name, follower.name, model.at, model.centre or "K", axis, motion, given, roller, limit,
        base or _least(given), face, f"{name}t" if model.flat else "", back, sized,
    )  # fmt: skip
    must_touch(made)
    return made


def _given(
    model: c.CamModel,
    motion: Sliding | Swinging,
    roller: float | None,
    face: complex,
    sense: int,
    zero: object,
    base: float | None,
) -> ByLaw | ByProfile:
    """The follower's motion; a law begins at `start`, left out at the angle of position 0 if that is stated."""
    if model.profile:
        return by_profile(model, motion, roller, face)
    begins = zero.angle if isinstance(zero, ZeroAngle) else 0.0
    start = model.start if model.start is not None else begins
    side = motion.side if isinstance(motion, Swinging) else 1
    low = _lowest(base, motion, roller, face)
    return ByLaw(law(model, isinstance(motion, Swinging)), low, side, start, sense)


def _face(flat: c.FlatModel, motion: Sliding | Swinging) -> complex:
    """Direction of a flat face in the follower's axes."""
    if flat.angle is not None:
        return unit_vector(flat.angle)
    if isinstance(motion, Sliding):
        return 1j * motion.along * motion.turn.conjugate()
    return motion.arm / abs(motion.arm)


def pivot_of(link: Link, frame: Link) -> str | None:
    """The link's point that is fixed."""
    return next((point for point in link.points if point in frame.points), None)


def _motion(
    model: c.CamModel,
    follower: Link,
    frame: Link,
    pivot: str,
    axis: complex,
    guides: Mapping[str, Guide],
    slides: tuple[Slide, ...],
) -> Sliding | Swinging:
    if model.at not in follower.points:
        values = {"name": model.at, "link": follower.name}
        end = "roller" if model.roller else "flat"
        raise Wrong(end, Message(N_("the point %(name)s is not on link %(link)s"), values))
    slide = next((s for s in slides if s.link == follower.name and guides[s.guide].link == FRAME), None)
    if slide is not None:
        return _sliding(follower.points[model.at], slide, guides[slide.guide], axis)
    centre = next((point for point in follower.points if point in frame.points and point != pivot), None)
    if centre is None:
        text = N_("the follower %(link)s neither slides on a fixed guide nor has a fixed point")
        right = N_("slides: a guide of the frame, or a point of the frame to swing about")
        raise Wrong("follower", Message(text, {"link": follower.name}), Message(right))
    return _swinging(model, follower, centre, frame, pivot)


def _sliding(own: complex, slide: Slide, guide: Guide, axis: complex) -> Sliding:
    """`own`: the follower's point that the cam moves, in the follower's axes."""
    turn = guide.direction * slide.direction.conjugate()
    through = guide.through + turn * (own - slide.through) - axis
    foot = through - guide.direction * (guide.direction.conjugate() * through).real
    return Sliding(complex(guide.direction), complex(foot), complex(turn))


def _swinging(model: c.CamModel, follower: Link, centre: str, frame: Link, pivot: str) -> Swinging:
    """`centre`, `pivot`: the fixed points about which the follower swings and the cam turns."""
    if model.side is None:
        text = N_("the side is not stated on which the swinging follower touches its cam")
        right = N_("side: left or side: right of the line from %(pivot)s to %(axis)s")
        raise Wrong("side", Message(text), Message(right, {"pivot": centre, "axis": pivot}))
    arm = complex(follower.points[model.at]) - complex(follower.points[centre])
    if abs(arm) < 1e-9:
        raise Wrong(
            "roller" if model.roller else "flat", Message(N_("the follower touches in its own pivot"))
        )
    return Swinging(complex(frame.points[centre]) - complex(frame.points[pivot]), arm, SIDES[model.side])


# ---------------------------------------------------------------- the base circle


def _smallest(
    model: c.CamModel,
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


def _rounded(model: c.CamModel, radius: float) -> float:
    step = model.round
    return radius if step is None else step * math.ceil(radius / step - 1e-9)


def _under_face(model: c.CamModel, motion: Sliding | Swinging, face: complex) -> Face:
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


def _lowest(base: float | None, motion: Sliding | Swinging, roller: float | None, face: complex) -> float:
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


def _least(given: ByLaw | ByProfile) -> float:
    """Least radius of a stated profile, m."""
    assert isinstance(given, ByProfile)
    return float(np.min(np.abs(given.curve.of(np.linspace(0, FULL_TURN, GRID)).z)))
