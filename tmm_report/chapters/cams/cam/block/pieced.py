"""A cam of base circle, flanks and nose -> the law by which it lifts its follower. What cannot be built raises
Wrong."""

from __future__ import annotations

import math

from tmm_report.chapters.cams.cam.block.laws import Wrong
from tmm_report.chapters.cams.cam.block.models import CamStated, TangentModel
from tmm_report.chapters.cams.cam.block.sizes import face_away, lowest
from tmm_report.mechanics.calculus.vectors import dot
from tmm_report.mechanics.cams.arcs import ArcLaw, Impossible, Outline, Rocker, Slider, outline
from tmm_report.mechanics.cams.cam import ByLaw, Sliding, Swinging
from tmm_report.problems import N_, Message

WHY = {
    "sizes": (
        N_("the radius of the nose, the distance of its centre and the lift do not all come out above zero"),
        N_("a smaller nose, or a greater lift"),
    ),
    "flank": (
        N_("the flanks are less curved than the base circle and the nose: their radius is greater than both"),
        N_("a greater flank, or tangent in place of arcs"),
    ),
    "hollow": (
        N_("with this half angle the flanks would be hollow"),
        N_("a greater half angle: straight flanks have the least"),
    ),
    "angle": (
        N_("base circle, flanks and nose of these sizes do not meet"),
        N_("another half angle, or a smaller nose"),
    ),
    "face": (
        N_("a flat face does not pass along a straight flank: it jumps from one end of it to the other"),
        N_("a roller, or flanks that are arcs: arcs with flank"),
    ),
    "reach": (N_("the follower does not reach its cam all round"), N_("a longer lever, a smaller offset")),
}


def by_arcs(
    stated: CamStated,
    motion: Sliding | Swinging,
    roller: float | None,
    face: complex,
    sense: int,
    start: float,
) -> tuple[ByLaw, float]:
    """The follower's motion, which begins to rise at the angle `start` of the cam's x axis; the base circle, m."""
    assert stated.profile is not None and stated.profile.pieced is not None
    for key in ("base", "pitch_base", "lift", "swing"):
        if getattr(stated, key, None) is not None:
            raise Wrong(key, Message(N_("this follows from the profile of the cam")))
    try:
        made = _outline(stated.profile.pieced)
        law = ArcLaw(made, _follower(motion, roller, face, sense))
    except Impossible as error:
        text, right = WHY[str(error)]
        raise Wrong("profile", Message(text), Message(right)) from None
    side = motion.side if isinstance(motion, Swinging) else 1
    return ByLaw(law, lowest(made.base, motion, roller, face), side, start, sense), made.base


def _outline(stated: TangentModel) -> Outline:
    straight = {} if "flank" in stated.SIZES else {"flank": math.inf}
    return outline(stated.base, **stated.sizes, **straight)


def _follower(motion: Sliding | Swinging, roller: float | None, face: complex, sense: int) -> Slider | Rocker:
    if isinstance(motion, Sliding):
        if roller is None and abs(float(dot(face * motion.turn, motion.along))) > 1e-9:
            text = N_("over a cam of arcs a flat face that slides lies across its motion")
            raise Wrong("flat", Message(text), Message(N_("leave its angle out")))
        return Slider(sense * motion.offset, roller)
    alike = motion.side * sense > 0
    if roller is not None:
        return Rocker(abs(motion.arm), abs(motion.pivot), alike, roller)
    return Rocker(face_away(motion, face), abs(motion.pivot), alike, None)
