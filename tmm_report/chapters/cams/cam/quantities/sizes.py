"""The single numbers of a cam: its sizes, the least of them, the limits and what is reached."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmm_report.chapters.cams.cam.quantities import arcs
from tmm_report.chapters.cams.cam.quantities.names import letter, of, speed, unit
from tmm_report.chapters.cams.cam.quantities.tables import PITCH, demands
from tmm_report.chapters.cams.cam.solve.found import CamFound, Cams
from tmm_report.i18n import NP_
from tmm_report.mechanics.cams.cam import Sliding, Swinging
from tmm_report.mechanics.cams.sizes.least_face import Face, TurnedFace
from tmm_report.mechanics.cams.sizes.least_size import Lever, Turned, Zone
from tmm_report.mechanics.cams.sizes.rules import by_shaft
from tmm_report.problems import N_
from tmm_report.quantity.model import Quantity, Value
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.tabulated import tabulated

RISE, RETURN, LIMIT = NP_("index", "rise"), NP_("index", "ret"), NP_("index", "lim")
MAX, MIN, BEST = NP_("index", "max"), NP_("index", "min"), NP_("index", "best")
FACE, SHAFT, HOLLOW = NP_("index", "face"), NP_("index", "shaft"), NP_("index", "hol")
MOVES = NP_("index", "mov")  # where the follower moves
LEANS = {
    "rise min": N_(
        "least pressure angle of the rise with its sign, above zero where the normal leans as in a rise"
    ),
    "rise max": N_("greatest pressure angle of the rise with its sign"),
    "return min": N_("least pressure angle of the return with its sign"),
    "return max": N_("greatest pressure angle of the return with its sign"),
}
ASKS = {
    "rise": N_("distance of the axis below the lowest place that the rise requires without an offset"),
    "return": N_("distance of the axis below the lowest place that the return requires without an offset"),
}


@tabulated
def values(found: Cams) -> Iterator[Value]:
    for one in found.cams:
        yield from _sizes(one)
        yield from arcs.values(one)
        match one.cam.sized:
            case Zone() as zone:
                yield from _least(one, zone)
                if one.alone and one.offset:
                    yield from _central(one, zone)
            case Lever(lowest=Turned() as lowest) as lever:
                yield from _least_lever(one, lever, lowest.least)
            case Face() as under:
                yield from _least_face(one, under)
            case TurnedFace(lowest=float(lowest)) as turned:
                yield from _least_turned_face(one, turned, lowest)
        if one.alone:
            yield from _rules(one)
        if one.alone and one.cam.flat:
            yield from _face(one)
        yield from _limits(one)


def base(found: CamFound) -> Quantity:
    return of(found, "cam_base", Symbol("R", MIN), "m", N_("radius of the base circle of cam %(cam)s"))


def lift(found: CamFound) -> Quantity:
    text = N_("lift of follower %(follower)s") if found.slides else N_("swing of follower %(follower)s")
    if found.slides:
        return of(found, "cam_lift", Symbol("h"), "m", text)
    return of(found, "cam_lift", Symbol("beta", MAX), "rad", text, "deg")


def _sizes(found: CamFound) -> Iterator[Value]:
    cam, motion = found.cam, found.cam.motion
    yield base(found).value(cam.base)
    yield lift(found).value(found.lift)
    if found.turn.omega is not None:
        yield speed(found).value(found.turn.omega)
    if found.below:
        low, text = found.ends[0][0], N_("least displacement of follower %(follower)s")
        least = of(
            found,
            "cam_least",
            Symbol(letter(found), MIN),
            unit(found),
            text,
            "mm" if found.slides else "deg",
        )
        yield least.value(low.value, low.turned)
    if cam.roller:
        yield of(
            found, "cam_roller", Symbol("r"), "m", N_("radius of the roller of follower %(follower)s")
        ).value(cam.roller)
        text = N_("least radius of the pitch curve of cam %(cam)s")
        yield of(found, "cam_pitch_base", Symbol("R", "0"), "m", text).value(cam.base + cam.roller)
    if isinstance(motion, Sliding):
        if not cam.flat:
            text = N_(
                "offset of follower %(follower)s, above zero where it lessens the pressure angle of a rise"
            )
            yield of(found, "cam_offset", Symbol("e"), "m", text).value(found.offset)
            text = N_(
                "lowest distance of the follower's point from the foot of the perpendicular from the cam's axis"
            )
            yield of(found, "cam_start", Symbol("s", "0"), "m", text).value(found.start)
    elif isinstance(motion, Swinging):
        text = N_("distance between the pivots of cam %(cam)s and follower %(follower)s")
        yield of(found, "cam_apart", Symbol("d"), "m", text).value(abs(motion.pivot))
        if not cam.flat:
            text = N_("length of the arm of follower %(follower)s that the cam lifts")
            yield of(found, "cam_arm", Symbol("l"), "m", text).value(abs(motion.arm))
            text = N_("lowest angle between the arm of follower %(follower)s and the line of the pivots")
            yield of(found, "cam_start", Symbol("beta", "0"), "rad", text).value(found.start)


def _least(found: CamFound, zone: Zone) -> Iterator[Value]:
    """What is asked, the least size with the stated offset, and with the best one."""
    for kind, demand in demands(found).items():
        index = RISE if kind == "rise" else RETURN
        asked = of(found, f"cam_b_{kind}", Symbol("b", index), "m", ASKS[kind])
        yield asked.value(demand.b)
    places = {"": zone.at(found.offset), "best": zone.best}
    texts = {
        "": (
            "", N_("least distance of the lowest place from the foot of the perpendicular"),
            N_("least radius of the pitch curve by the pressure angles"),
        ),
        "best": (
            N_("offset at which the cam is smallest"),
            N_("least distance of the lowest place with the best offset"),
            N_("least radius of the pitch curve with the best offset"),
        ),
    }  # fmt: skip
    for which, place in places.items():
        index = BEST if which else MIN
        offset, start, radius = texts[which]
        if which:
            yield of(found, "cam_e_best", Symbol("e", index), "m", offset).value(place.e)
        key = f"_{which}" if which else ""
        yield of(found, f"cam_s0_least{key}", Symbol("s", f"0,{index}"), "m", start).value(place.s0)
        yield of(found, f"cam_r0_least{key}", Symbol("R", f"0,{index}"), "m", radius).value(place.radius)


def _central(found: CamFound, zone: Zone) -> Iterator[Value]:
    """Without an offset."""
    text = N_("least radius of the pitch curve without an offset")
    one = of(found, "cam_r0_least_central", Symbol("R", f"0,{MIN}", "0"), "m", text)
    yield one.value(zone.at(0.0).radius)


def _least_lever(found: CamFound, lever: Lever, lowest: float) -> Iterator[Value]:
    text = N_("least angle between the arm of follower %(follower)s and the line of the pivots")
    least = of(found, "cam_start_least", Symbol("beta", f"0,{MIN}"), "rad", text, "deg")
    yield least.value(lowest)
    text = N_("least radius of the pitch curve by the pressure angles")
    yield of(found, "cam_r0_least", Symbol("R", f"0,{MIN}"), "m", text).value(lever.radius(lowest))
    best = lever.centres.best
    text = N_("distance between the pivots with which the cam is smallest")
    yield of(found, "cam_apart_best", Symbol("d", BEST), "m", text).value(abs(best.p))
    text = N_(
        "least angle between the arm of follower %(follower)s and the line of the pivots at that distance"
    )
    start = of(found, "cam_start_least_best", Symbol("beta", f"0,{BEST}"), "rad", text, "deg")
    yield start.value(-float(np.angle(best.p)))
    text = N_("least radius of the pitch curve with that distance between the pivots")
    yield of(found, "cam_r0_least_best", Symbol("R", f"0,{BEST}"), "m", text).value(
        lever.centres.radius(best)
    )
    text = N_("least distance between the pivots with which the pressure angles are permitted")
    yield of(found, "cam_apart_least", Symbol("d", MIN), "m", text).value(abs(lever.centres.closest.p))


def _least_face(found: CamFound, under: Face) -> Iterator[Value]:
    text = N_("least permitted radius of curvature of the profile")
    yield of(found, "cam_curvature", Symbol("rho", LIMIT), "m", text, "mm").value(under.curvature)
    text = N_("least radius of the base circle by the curvature")
    yield of(found, "cam_r0_least", Symbol("R", f"0,{MIN}"), "m", text).value(under.asked.b)
    text = N_("greatest distance of the contact from the axis of the follower along its face")
    ends = (abs(end.value) for end in found.ends[1])
    yield of(found, "cam_reach", Symbol("b"), "m", text, "mm").value(max(ends))


def _least_turned_face(found: CamFound, turned: TurnedFace, lowest: float) -> Iterator[Value]:
    text = N_("least permitted radius of curvature of the profile")
    yield of(found, "cam_curvature", Symbol("rho", LIMIT), "m", text, "mm").value(turned.curvature)
    text = N_("distance of the face from its pivot, above zero on the far side from the cam")
    yield of(found, "cam_away", Symbol("b", FACE), "m", text, "mm").value(turned.away)
    text = N_("least angle of the flat face with the line of the pivots by the curvature")
    yield of(found, "cam_start_least", Symbol("beta", f"0,{MIN}"), "rad", text, "deg").value(lowest)
    text = N_("least radius of the base circle by the curvature")
    yield of(found, "cam_r0_least", Symbol("R", f"0,{MIN}"), "m", text).value(float(turned.radius(lowest)))


def _rules(found: CamFound) -> Iterator[Value]:
    """What guides allow of the roller and of the shaft; the jerk."""
    if (limits := found.roller_limits) is not None:
        text = N_("greatest radius of the roller by the least radius of the pitch curve")
        yield of(found, "cam_roller_by_radius", Symbol("r", "1"), "m", text, "mm").value(limits.by_radius)
        text = N_("greatest radius of the roller by the curvature of the pitch curve")
        yield of(found, "cam_roller_by_curvature", Symbol("r", "2"), "m", text, "mm").value(
            limits.by_curvature
        )
        if found.hollow is not None:
            text = N_("greatest radius of the roller by the curvature of the pitch curve where it is hollow")
            by_hollow = of(found, "cam_roller_by_hollow", Symbol("r", "3"), "m", text, "mm")
            yield by_hollow.value(limits.by_hollow)
            text = N_("greatest radius of the roller by all rules")
        else:
            text = N_("greatest radius of the roller by both rules")
        yield of(found, "cam_roller_most", Symbol("r", LIMIT), "m", text, "mm").value(limits.most)
    if found.shaft is not None:
        text = N_("diameter of the shaft of cam %(cam)s")
        yield of(found, "cam_shaft", Symbol("d", SHAFT), "m", text, "mm").value(found.shaft)
        text = N_("least radius of the pitch curve about the shaft")
        least = by_shaft(found.shaft, found.cam.roller or 0.0)
        yield of(found, "cam_r0_shaft", Symbol("R", f"0,{SHAFT}"), "m", text, "mm").value(least)
    if found.jerk is not None:
        text = N_("greatest size of the third derivative of the displacement within the pieces of the law")
        sign = Symbol(letter(found) + "′′′", MAX)
        jerk = of(found, "cam_jerk", sign, unit(found) if found.slides else "", text)
        yield jerk.value(found.jerk.value, found.jerk.turned)


def _face(found: CamFound) -> Iterator[Value]:
    """How far the contact goes along a flat face."""
    low, high = found.face
    text = N_("least length of the flat face of follower %(follower)s: between the outermost contacts")
    yield of(found, "cam_face", Symbol("l", FACE), "m", text, "mm").value(high.value - low.value)
    for which, word, end, text in (
        ("low", MIN, low, N_("contact on the flat face that lies farthest back, from the point %(point)s")),
        (
            "high",
            MAX,
            high,
            N_("contact on the flat face that lies farthest ahead, from the point %(point)s"),
        ),
    ):
        one = of(found, f"cam_face_{which}", Symbol("l", f"{FACE},{word}"), "m", text, "mm")
        yield one.value(end.value, end.turned)


def _limits(found: CamFound) -> Iterator[Value]:
    if found.cam.back is not None:
        text = N_("allowed pressure angle of the return of follower %(follower)s")
        limit = of(found, "cam_alpha_back", Symbol("alpha", f"{LIMIT},{RETURN}"), "deg", text)
        yield limit.value(np.degrees(found.cam.back))
    text = N_("allowed pressure angle of cam %(cam)s and follower %(follower)s")
    yield of(found, "cam_alpha_limit", Symbol("alpha", LIMIT), "deg", text).value(np.degrees(found.cam.limit))
    for key, index, at, text in (
        (
            "cam_alpha_rise",
            RISE,
            found.rise,
            N_("greatest pressure angle of the rise of follower %(follower)s"),
        ),
        (
            "cam_alpha_return",
            RETURN,
            found.back,
            N_("greatest pressure angle of the return of follower %(follower)s"),
        ),
    ):
        yield of(found, key, Symbol("alpha", f"{MAX},{index}"), "deg", text).value(
            np.degrees(at.value), at.turned
        )
    if np.isfinite(found.least.value):
        text = N_("least radius of curvature of the profile of cam %(cam)s where it is convex")
        radius = of(found, "cam_rho", Symbol("rho", MIN), "m", text, "mm")
        yield radius.value(found.least.value, found.least.turned)
    if found.alone:
        yield from _signed(found)
        yield from _curved(found)


def _signed(found: CamFound) -> Iterator[Value]:
    """The least and the greatest pressure angle of the rises and of the returns."""
    for kind, ends in found.leaning.items():
        index = RISE if kind == "rise" else RETURN
        for which, word, end in zip(("min", "max"), (MIN, MAX), ends, strict=True):
            sign = Symbol("alpha", f"{word},{index}", "±")
            one = of(found, f"cam_alpha_{kind}_{which}", sign, "deg", LEANS[f"{kind} {which}"])
            yield one.value(np.degrees(end.value), end.turned)


def _curved(found: CamFound) -> Iterator[Value]:
    """Radii of curvature of the pitch curve, and without the dwells."""
    if (moving := found.moving) is not None:
        text = N_("least radius of curvature of the profile where it is convex and the follower moves")
        yield of(found, "cam_rho_moving", Symbol("rho", MOVES), "m", text, "mm").value(
            moving.value, moving.turned
        )
    if found.cam.roller and np.isfinite(found.least.value):
        text = N_("least radius of curvature of the pitch curve where the profile is convex")
        pitch = of(found, "cam_rho_pitch", Symbol("rho", f"{MIN},{PITCH}"), "m", text, "mm")
        yield pitch.value(found.least.value + found.cam.roller, found.least.turned)
    if (hollow := found.hollow) is not None:
        text = N_("least radius of curvature of the pitch curve where it is hollow")
        of_wall = of(found, "cam_rho_hollow", Symbol("rho", HOLLOW), "m", text, "mm")
        yield of_wall.value(hollow.value, hollow.turned)
