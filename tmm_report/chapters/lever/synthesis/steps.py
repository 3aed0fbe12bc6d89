"""The numbers of slider-cranks and slotted links, each assigned the expression that the note prints; what is free is
chosen by search.

Closed forms: Artobolevsky, Theory of mechanisms and machines, ch. 27.
"""

from __future__ import annotations

import math

import numpy as np

from tmm_report.chapters.lever.synthesis.given import Permits, SliderCrank, SlottedLink, TurningGuide
from tmm_report.chapters.lever.synthesis.refused import degrees, mm, refused
from tmm_report.chapters.lever.synthesis.values import Values
from tmm_report.mechanics.lever import synthesis
from tmm_report.problems import N_, Message
from tmm_report.quantity.formula import PI, Expr, cos, sin, sqrt
from tmm_report.quantity.functions import HALF, RIGHT, arcsin

SAME = 1e-9  # relative: what differs by less is equal
MOST_RATIO = 25.0  # of rod to crank that is tried where it is free


def between(s: Values, K: float) -> float:
    """The angle theta of a time ratio, rad."""
    s.K = K
    s.theta = HALF * (s.K - 1) / (s.K + 1)
    return s.number("theta")


# ---------------------------------------------------------------- slider-crank


def slider_crank(s: Values, asked: SliderCrank) -> None:
    if asked.stroke is not None:
        s.stroke = asked.stroke
        if asked.mean_speed is not None:
            s.mean_speed = asked.mean_speed
            s.speed = PI * s.mean_speed / s.stroke
    else:
        s.mean_speed, s.speed = asked.mean_speed, asked.speed
        s.stroke = PI * s.mean_speed / s.speed
    _permits(s, asked)
    if asked.offset_ratio is not None or asked.K == 1:
        _by_ratios(s, asked)
    else:
        _by_time_ratio(s, asked)
    if s.number("rod") < s.number("crank") + s.number("offset"):
        wrong = N_(
            "the crank cannot turn round: the rod of %(rod)s is shorter than crank and offset, %(both)s"
        )
        both = mm(s.number("crank") + s.number("offset"))
        raise refused(wrong, "slider_crank", right=_longer(asked), rod=mm(s.number("rod")), both=both)
    s.pressure = arcsin((s.crank + s.offset) / s.rod if s.get("offset") else s.crank / s.rod)
    if asked.permitted is not None and s.number("pressure") > asked.permitted * (1 + SAME):
        _too_steep(s, "slider_crank", asked)
    _transmits(s, asked)


def _permits(s: Values, asked: Permits) -> None:
    """The permitted pressure angle, stated or what the transmission angle lacks to a right one."""
    if asked.transmission is None:
        s.permitted = asked.pressure_angle
    else:
        s.mu_permitted = asked.transmission
        s.permitted = RIGHT - s.mu_permitted


def _transmits(s: Values, asked: Permits) -> None:
    if asked.transmission is not None:
        s.transmission = RIGHT - s.pressure


def _longer(asked: SliderCrank) -> Message:
    return Message(N_("a greater ratio, or a smaller offset") if asked.ratio else N_("a smaller offset"))


def _by_ratios(s: Values, asked: SliderCrank) -> None:
    """Both dead positions by the ratios of the sides; in line with the crank, both strokes last equally long."""
    stroke = s.number("stroke")
    if asked.offset_ratio:
        s.ratio, s.offset_ratio = asked.ratio, asked.offset_ratio
        if asked.offset_ratio > s.number("ratio") - 1:
            raise refused(
                N_("the crank cannot turn round: the rod is shorter than crank and offset"),
                "slider_crank", "offset_ratio",
                right=Message(N_("at most %(most)s with this ratio"), {"most": f"{s.number('ratio') - 1:.6g}"}),
            )  # fmt: skip
        far, near = sqrt((s.ratio + 1) ** 2 - s.offset_ratio**2), sqrt((s.ratio - 1) ** 2 - s.offset_ratio**2)
        s.crank = s.stroke / (far - near)
        s.rod, s.offset = s.ratio * s.crank, s.offset_ratio * s.crank
    elif asked.offset:
        s.offset, s.ratio = asked.offset, asked.ratio
        found = cranks_of(stroke, s.number("ratio"), asked.offset)
        if not found.size:
            raise refused(
                N_("no crank with this offset gives the stroke: the rod is shorter than crank and offset"),
                "slider_crank", "offset", right=Message(N_("a greater ratio, or a smaller offset")),
            )  # fmt: skip
        s.crank = float(found[-1])  # of two the longer one: its pressure angle is the smaller
        s.rod = s.ratio * s.crank
    else:
        s.offset = 0.0
        s.crank = s.stroke / 2
        if asked.ratio is not None:
            s.ratio = asked.ratio
            s.rod = s.ratio * s.crank
        else:
            s.rod = s.crank / sin(s.permitted)


def cranks_of(stroke: float, ratio: float, e: float) -> np.ndarray:
    """Cranks of a ratio and an offset, m, ascending: near the shortest that turns round there are two."""

    def miss(a: np.ndarray) -> np.ndarray:
        with np.errstate(invalid="ignore"):
            far, near = (np.sqrt(((ratio + sign) * a) ** 2 - e**2) for sign in (1, -1))
            return np.asarray(far - near - stroke)

    return np.asarray(synthesis.roots(miss, e / (ratio - 1), stroke / 2 * (1 + SAME)))


def _by_time_ratio(s: Values, asked: SliderCrank) -> None:
    """Of a triangle with the crank's pivot and the extreme places of the slider. Where the foot of its height lies
    within the stroke the slider would be on either side of the pivot: two assemblies, and the crank moves it in one."""
    theta = between(s, asked.K)
    half = s.theta / 2
    if theta >= math.pi / 2:
        raise refused(
            N_("no slider-crank has such a time ratio: it would be assembled anew between its extreme positions"),
            "slider_crank", "K", right=Message(N_("less than 3")),
        )  # fmt: skip
    if asked.offset is not None:
        s.offset = asked.offset
        most = s.number("stroke") / math.tan(theta)
        if asked.offset > most:
            _anew("offset", mm(most))
        s.difference = s.offset * s.stroke / sin(s.theta)
        squares: Expr = (s.stroke**2 + 2 * s.difference * cos(s.theta)) / 4
        s.crank = sqrt(squares - s.difference / 2)
        s.rod = sqrt(squares + s.difference / 2)
        return
    if asked.ratio is not None and asked.ratio > synthesis.most_ratio(theta):
        _anew("ratio", f"{synthesis.most_ratio(theta):.6g}")
    s.ratio = asked.ratio if asked.ratio is not None else _free_ratio(s, theta, asked)
    s.crank = s.stroke / (2 * sqrt(cos(half) ** 2 + s.ratio**2 * sin(half) ** 2))
    s.rod = s.ratio * s.crank
    s.offset = (s.rod**2 - s.crank**2) * sin(s.theta) / s.stroke


def _anew(key: str, most: object) -> None:
    raise refused(
        N_("the linkage would have to be assembled anew between its extreme positions"),
        "slider_crank", key, right=Message(N_("at most %(most)s with this time ratio"), {"most": most}),
    )  # fmt: skip


def _free_ratio(s: Values, theta: float, asked: SliderCrank) -> float:
    """The shortest rod that keeps the permitted angle; with none permitted, that of the least angle."""

    def pressure(ratio: np.ndarray) -> np.ndarray:
        return synthesis.slider_cranks(s.number("stroke"), theta, ratio).pressure

    best, least = synthesis.least(pressure, 1.0, min(MOST_RATIO, synthesis.most_ratio(theta)))
    if asked.permitted is None:
        return best
    if least > asked.permitted * (1 + SAME):
        raise refused(
            N_("no ratio of rod to crank keeps this pressure angle: with the time ratio the least is %(least)s"),
            "slider_crank", angle_key(asked),
            right=Message(N_("at least %(least)s, or a smaller K"), {"least": degrees(least)}), least=degrees(least),
        )  # fmt: skip
    found = synthesis.roots(lambda ratio: pressure(ratio) - asked.permitted, 1.0, best)
    return float(found[0]) if found.size else best


def _too_steep(s: Values, kind: str, asked: Permits) -> None:
    values = {"found": degrees(s.number("pressure")), "most": degrees(s.number("permitted"))}
    raise refused(
        N_("the pressure angle comes to %(found)s, more than the permitted %(most)s"),
        kind, angle_key(asked), right=Message(N_("a longer rod, or leave its length to be found")), **values,
    )  # fmt: skip


def angle_key(asked: Permits) -> str:
    return "pressure_angle" if asked.transmission is None else "transmission"


# ---------------------------------------------------------------- slotted links


def slotted_link(s: Values, asked: SlottedLink) -> None:
    if asked.K is not None:
        between(s, asked.K)
    elif asked.swing is not None:
        s.theta = asked.swing
        s.K = (HALF + s.theta) / (HALF - s.theta)
    else:
        s.crank, s.frame = asked.crank, asked.frame
        s.theta = 2 * arcsin(s.crank / s.frame)
        s.K = (HALF + s.theta) / (HALF - s.theta)
    half = s.theta / 2
    s.stroke = asked.stroke
    _permits(s, asked)
    _driven(s, asked)
    if asked.crank is None:
        s.frame = asked.frame
        s.crank = s.frame * sin(half)
    elif asked.frame is None:
        s.crank = asked.crank
        s.frame = s.crank / sin(half)
    s.link = s.stroke / (2 * sin(half))
    s.sagitta = s.link * (1 - cos(half))
    s.slide_line = s.link - s.sagitta / 2
    _rod(s, asked, s.link, s.sagitta / 2, "slotted_link")
    s.pressure = arcsin(s.sagitta / (2 * s.rod))
    _transmits(s, asked)
    if s.number("pressure") + s.number("theta") / 2 >= math.pi / 2:
        limit = s.number("sagitta") / 2 / math.cos(s.number("theta") / 2)
        raise refused(
            N_("with so short a rod the slider turns back before the slotted link does"), "slotted_link",
            "rod" if asked.rod is not None else "rod_ratio" if asked.rod_ratio is not None else angle_key(asked),
            right=Message(N_("a rod longer than %(limit)s"), {"limit": mm(limit)}),
        )  # fmt: skip


def turning_guide(s: Values, asked: TurningGuide) -> None:
    s.K, s.stroke = asked.K, asked.stroke
    _permits(s, asked)
    _driven(s, asked)
    share = cos(HALF / (s.K + 1))
    if asked.frame is not None:
        s.frame = asked.frame
        s.crank = s.frame / share
    else:
        s.crank = asked.crank
        s.frame = s.crank * share
    s.arm = s.stroke / 2
    _rod(s, asked, s.arm, s.arm, "turning_guide")
    s.pressure = arcsin(s.arm / s.rod)
    _transmits(s, asked)


def _driven(s: Values, asked: SlottedLink | TurningGuide) -> None:
    """The speed of the crank: the working stroke takes K/(K + 1) of the turn."""
    if asked.working_speed is not None:
        s.working_speed = asked.working_speed
        s.speed = 2 * PI * s.working_speed * s.K / (s.stroke * (s.K + 1))


def _rod(s: Values, asked: SlottedLink | TurningGuide, moved_by: Expr, off: Expr, kind: str) -> None:
    """The rod that stands at the pressure angle where its joint is `off` the slide line, or as stated."""
    if asked.rod is not None:
        s.rod = asked.rod
    elif asked.rod_ratio is not None:
        s.rod_ratio = asked.rod_ratio
        s.rod = s.rod_ratio * moved_by
    else:
        s.rod = off / sin(s.permitted)
    sine = float(off.value) / s.number("rod")
    if sine >= 1:
        right = Message(N_("more than %(limit)s"), {"limit": mm(float(off.value))})
        raise refused(N_("the rod is too short to reach the slide line"), kind, "rod", right=right)
    if asked.permitted is not None and math.asin(sine) > asked.permitted * (1 + SAME):
        values = {"found": degrees(math.asin(sine)), "most": degrees(asked.permitted)}
        raise refused(
            N_("the pressure angle comes to %(found)s, more than the permitted %(most)s"),
            kind, angle_key(asked), right=Message(N_("a longer rod, or leave its length to be found")), **values,
        )  # fmt: skip
