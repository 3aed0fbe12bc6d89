"""The key `cams` -> Cam. What cannot be built raises Wrong with the key that is wrong; `cam_checks` tries it first."""

from __future__ import annotations

from collections.abc import Mapping

from tmm_report.chapters.cams.cam.block.laws import Wrong as Wrong
from tmm_report.chapters.cams.cam.block.laws import by_profile, law
from tmm_report.chapters.cams.cam.block.pieced import by_arcs
from tmm_report.chapters.cams.cam.block.sizes import LIMITS, least, lowest, smallest
from tmm_report.chapters.cams.cam.block.touching import must_touch
from tmm_report.chapters.lever.structure.block import cams as c
from tmm_report.mechanics.cams.cam import (
    ByLaw,
    Cam,
    Sliding,
    Swinging,
)
from tmm_report.mechanics.cams.stated_profile import ByProfile
from tmm_report.mechanics.lever.mechanism import FRAME, Guide, Link, Slide, ZeroAngle
from tmm_report.problems import N_, Message
from tmm_report.variant.values import unit_vector

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
        base, sized = smallest(model, motion, roller, face, sense, limit)
    given, base = _given(model, motion, roller, face, sense, zero, base)
    made = Cam(
        name, body.name, follower.name, model.at, model.centre or "K", axis, motion, given, roller, limit,
        base or least(given), face, f"{name}t" if model.flat else "", back, sized,
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
) -> tuple[ByLaw | ByProfile, float | None]:
    """The follower's motion, and the base circle; a law begins at `start`, left out at the angle of position 0 if that
    is stated."""
    if model.profile and not model.profile.pieced:
        return by_profile(model, motion, roller, face), base
    begins = zero.angle if isinstance(zero, ZeroAngle) else 0.0
    start = model.start if model.start is not None else begins
    if model.profile:
        return by_arcs(model, motion, roller, face, sense, start)
    side = motion.side if isinstance(motion, Swinging) else 1
    low = lowest(base, motion, roller, face)
    return ByLaw(law(model, isinstance(motion, Swinging)), low, side, start, sense), base


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
