"""The numbers of the cam pairs: sizes, phases, the law, pressure angles, coordinates of the profile."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from tmm_report.chapters.lever.cam.solve import CamFound, Cams, Lifted
from tmm_report.chapters.lever.kinematics.quantities import where
from tmm_report.i18n import NP_
from tmm_report.mechanics.cams.cam import Sliding, Swinging
from tmm_report.mechanics.cams.follower_laws import Kind, Phase
from tmm_report.mechanics.cams.least_size import Demand, Face, Lever, Turned, Zone
from tmm_report.mechanics.cams.shapes import Parabolic
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Quantity, Table, Value, text_column
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.tabulated import tabulated

PHASES = Message(N_("phases of the cam's turn"))
SAMPLES = Message(N_("positions of which the laws of the cam are written out"))
MOTION = Message(N_("displacement of the follower, its derivatives by the angle turned, pressure angle"))
JUMPS = Message(N_("angles at which derivatives of the follower's displacement jump"))
PIECES = Message(N_("pieces of the graphs of acceleration by which phases go, for a lift and a phase of 1"))
PROFILE = Message(N_("polar coordinates of the profile and of the pitch curve in the cam's axes"))
ROUNDING = 1e-9  # rad: an angle so little below a whole turn is none
KINDS = {"rise": N_("rise"), "dwell": N_("dwell"), "return": N_("return")}
SHOCKS = {True: N_("hard"), False: N_("soft")}
LAWS = {
    "parabolic": N_("parabolic"),
    "cosine": N_("cosine"),
    "sine": N_("sine"),
    "polynomial": N_("polynomial 3-4-5"),
    "uniform": N_("uniform"),
    "decreasing": N_("linearly decreasing"),
    "trapezoid": N_("trapezoidal"),
    "modified_trapezoid": N_("modified trapezoidal"),
    "modified_sine": N_("modified sine"),
    "polynomial_4567": N_("polynomial 4-5-6-7"),
    "stated": N_("stated"),
}
NONE = N_("none")
FORMS = {"line": N_("straight"), "sine": N_("quarter of a sine")}
RISE, RETURN, LIMIT = NP_("index", "rise"), NP_("index", "ret"), NP_("index", "lim")
PITCH = NP_("index", "pc")  # of the pitch curve
MAX, MIN, BEST = NP_("index", "max"), NP_("index", "min"), NP_("index", "best")

LEAST = Message(N_("what the permitted pressure angles ask of the size of the cam"))
AT = Quantity("theta", Symbol("theta"), "deg", Message(N_("angle of the cam from the beginning of its law")))
ASKED_SLOPE_MEANING = Message(
    N_("first derivative of the displacement by the angle of the cam at the same place")
)
ASKED_BEND = Quantity("S2", Symbol("s′′"), "m", Message(N_("its second derivative there")))

ASKS = {
    "rise": N_("distance of the axis below the lowest place that the rise asks without an offset"),
    "return": N_("distance of the axis below the lowest place that the return asks without an offset"),
}

NUMBER = Quantity("number", None, "", Message(N_("its number")))
START = Quantity(
    "start", Symbol("theta", "0"), "deg", Message(N_("angle of the cam at which the phase begins"))
)
ANGLE = Quantity("angle", Symbol("delta"), "deg", Message(N_("angle of the phase")))
WITHIN = Quantity(
    "theta", Symbol("theta"), "rad", Message(N_("angle of the cam from the beginning of the phase"))
)
BETA = Quantity("delta", Symbol("delta"), "rad", Message(N_("angle of the phase")))
SHARE = Quantity("tau", Symbol("tau"), "", Message(N_("share of the phase that is over")))
RATIO = Quantity("ratio", Symbol("n"), "", Message(N_("acceleration of the law over its deceleration")))
BEGINS = Quantity(
    "begins", Symbol("tau", "i"), "", Message(N_("share of the phase at which the piece begins"))
)
WIDTH = Quantity("width", Symbol("Deltatau", "i"), "", Message(N_("share of the phase that the piece takes")))
REACHED = Quantity("f", Symbol("f", "i"), "", Message(N_("share of the lift reached where the piece begins")))
SLOPE = Quantity("f1", Symbol("f′", "i"), "", Message(N_("first derivative of that share by τ there")))
BEND = Quantity("f2", Symbol("f′′", "i"), "", Message(N_("second derivative where the piece begins")))
NEXT = Quantity("f2_end", Symbol("f′′", "i+1"), "", Message(N_("second derivative where the piece ends")))


def unit(found: CamFound) -> str:
    """Of a displacement."""
    return "m" if found.slides else "rad"


def letter(found: CamFound) -> str:
    return "s" if found.slides else "beta"


def of(found: CamFound, key: str, symbol: Symbol, unit_: str, text: str, shown: str = "") -> Quantity:
    """A quantity of one cam pair, with its name in key and index."""
    name = found.cam.name
    index = ",".join(filter(None, (symbol.sub, name)))
    meaning = Message(text, {"cam": found.cam.cam, "follower": found.cam.follower})
    return Quantity(f"{key}_{name}", Symbol(symbol.base, index, symbol.sup), unit_, meaning, shown)


def displacement(found: CamFound) -> Quantity:
    text = (
        N_("displacement of follower %(follower)s")
        if found.slides
        else N_("angle of swing of follower %(follower)s")
    )
    return of(found, "cam_S", Symbol(letter(found)), unit(found), text)


def first(found: CamFound) -> Quantity:
    text = N_("first derivative of the displacement of follower %(follower)s by the angle of cam %(cam)s")
    return of(found, "cam_S1", Symbol(letter(found) + "′"), unit(found) if found.slides else "", text)


def second(found: CamFound) -> Quantity:
    text = N_("second derivative of the displacement of follower %(follower)s by the angle of cam %(cam)s")
    return of(found, "cam_S2", Symbol(letter(found) + "′′"), unit(found) if found.slides else "", text)


def pressure(found: CamFound) -> Quantity:
    return of(
        found,
        "cam_alpha",
        Symbol("alpha"),
        "deg",
        N_("pressure angle between cam %(cam)s and follower %(follower)s"),
    )


@tabulated
def tables(found: Cams) -> Iterator[Table]:
    for one in found.cams:
        name = one.cam.name
        if one.phases:
            yield Table(f"cam_phases_{name}", PHASES, _phases(one))
            yield Table(f"cam_law_{name}", SAMPLES, tuple(_samples(one)))
        if one.pieces:
            yield Table(f"cam_pieces_{name}", PIECES, _pieces(one))
        if one.cam.sized is not None:
            yield Table(f"cam_least_{name}", LEAST, tuple(_demands(one)))
        if one.shocks:
            yield Table(f"cam_shocks_{name}", JUMPS, _shocks(one))
        for which, lifted in (("table", one.table), ("diagram", one.diagram)):
            at = where(lifted.turned)
            yield Table(f"cam_motion_{name}_{which}", MOTION, (*at, *_motion(one, lifted)))
        yield Table(f"cam_profile_{name}", PROFILE, (*where(one.table.turned), *_profile(one, one.table)))


def _phases(found: CamFound) -> tuple[Column, ...]:
    phases = found.phases
    edges = np.concatenate([[0.0], np.cumsum([phase.angle for phase in phases])])[:-1]
    return (
        NUMBER.column(list(range(1, len(phases) + 1))),
        text_column("phase", Message(N_("what the follower does")), [KINDS[phase.kind] for phase in phases]),
        text_column("law", Message(N_("its law")), [law_word(phase) for phase in phases]),
        START.column(np.degrees(edges)),
        ANGLE.column(np.degrees([phase.angle for phase in phases])),
    )


def law_word(phase: Phase) -> str:
    return LAWS[phase.law.name] if phase.law else NONE


def _samples(found: CamFound) -> Iterator[Column]:
    samples = found.samples
    yield Quantity("at", None, "", Message(N_("table position"))).column([s.position for s in samples])
    yield text_column("phase", Message(N_("what the follower does")), [KINDS[s.phase.kind] for s in samples])
    yield text_column("law", Message(N_("its law")), [law_word(s.phase) for s in samples])
    yield WITHIN.column([s.within for s in samples])
    yield BETA.column([s.phase.angle for s in samples])
    yield SHARE.column([s.share for s in samples])
    ratios = [s.phase.law.ratio if isinstance(s.phase.law, Parabolic) else math.nan for s in samples]
    if any(ratio != 1 and ratio == ratio for ratio in ratios):
        yield RATIO.column(ratios)


def _pieces(found: CamFound) -> tuple[Column, ...]:
    laid = [one.laid for one in found.pieces]
    return (
        NUMBER.column([one.phase + 1 for one in found.pieces]),
        text_column("form", Message(N_("its form")), [FORMS[one.form] for one in laid]),
        BEGINS.column([one.at for one in laid]),
        WIDTH.column([one.width for one in laid]),
        REACHED.column([one.f for one in laid]),
        SLOPE.column([one.slope for one in laid]),
        BEND.column([one.start for one in laid]),
        NEXT.column([one.end for one in laid]),
    )


def demands(found: CamFound) -> dict[Kind, Demand]:
    """What decides the size: of a sliding roller what the rise asks, and the return where it is limited."""
    match found.cam.sized:
        case Zone() as zone:
            asked: dict[Kind, Demand] = {"rise": zone.of_rise}
            return asked | ({"return": zone.of_return} if zone.of_return is not None else {})
        case Lever(lowest=Turned() as lowest):
            return {lowest.way: lowest.asked}
        case Face() as under:
            return {_way(found, under.asked): under.asked}
    return {}


def _way(found: CamFound, asked: Demand) -> Kind:
    """What the follower does at an angle of its law; where a phase begins, what it does there."""
    edges = np.cumsum([phase.angle for phase in found.phases])[:-1]
    return (
        found.phases[int(np.searchsorted(edges, asked.theta, side="right"))].kind if found.phases else "rise"
    )


def asked_S(found: CamFound) -> Quantity:
    shown = "" if found.slides else "deg"
    return Quantity(
        "S", Symbol(letter(found)), unit(found), Message(N_("displacement at which most is asked")), shown
    )


def asked_slope(found: CamFound) -> Quantity:
    own = "m" if found.slides else ""
    return Quantity("S1", Symbol(letter(found) + "′"), own, ASKED_SLOPE_MEANING)


def _demands(found: CamFound) -> Iterator[Column]:
    asked = demands(found)
    yield text_column("phase", Message(N_("what the follower does")), [KINDS[kind] for kind in asked])
    yield AT.column([math.degrees(demand.theta) for demand in asked.values()])
    yield asked_S(found).column([demand.S for demand in asked.values()])
    if isinstance(under := found.cam.sized, Face):
        yield ASKED_BEND.column([under.curvature - under.asked.b - under.asked.S])
    else:
        yield asked_slope(found).column([demand.slope for demand in asked.values()])


def _shocks(found: CamFound) -> tuple[Column, ...]:
    shocks, letter_ = found.shocks, letter(found)
    own = unit(found) if found.slides else ""
    at = Message(N_("angle of turn at which a derivative of the displacement jumps"))
    jumps = [Message(N_("jump of the first derivative")), Message(N_("jump of the second derivative"))]
    return (
        Quantity("phi", Symbol("phi"), "deg", at).column([np.degrees(shock.turned) for shock in shocks]),
        Quantity("first", Symbol(f"Delta{letter_}′"), own, jumps[0]).column([s.first for s in shocks]),
        Quantity("second", Symbol(f"Delta{letter_}′′"), own, jumps[1]).column([s.second for s in shocks]),
        text_column(
            "shock", Message(N_("whether the shock is hard or soft")), [SHOCKS[s.hard] for s in shocks]
        ),
    )


def _motion(found: CamFound, lifted: Lifted) -> Iterator[Column]:
    yield displacement(found).column(lifted.S)
    yield first(found).column(lifted.first)
    yield second(found).column(lifted.second)
    yield pressure(found).column(np.degrees(lifted.alpha))


def _profile(found: CamFound, lifted: Lifted) -> Iterator[Column]:
    text = N_("polar radius of the profile of cam %(cam)s")
    yield of(found, "cam_R", Symbol("R"), "m", text).column(lifted.radius)
    text = N_("polar angle of the profile of cam %(cam)s in its axes")
    yield of(found, "cam_gamma", Symbol("gamma"), "deg", text).column(np.degrees(lifted.direction))
    text = N_("angle of the profile from its first radius, against the turn of cam %(cam)s")
    turned = found.sense * (lifted.direction[0] - lifted.direction)
    delta = of(found, "cam_delta", Symbol("delta"), "deg", text)
    yield delta.column(np.degrees(np.mod(turned + ROUNDING, 2 * np.pi) - ROUNDING))
    for key, part, text in (
        ("x", np.cos, N_("abscissa of the profile of cam %(cam)s in its axes")),
        ("y", np.sin, N_("ordinate of the profile of cam %(cam)s in its axes")),
    ):
        yield of(found, f"cam_{key}", Symbol(key), "m", text).column(lifted.radius * part(lifted.direction))
    if found.cam.roller:
        text = N_("polar radius of the pitch curve of cam %(cam)s")
        yield of(found, "cam_R_pitch", Symbol("R", PITCH), "m", text).column(lifted.pitch)
        text = N_("polar angle of the pitch curve of cam %(cam)s in its axes")
        yield of(found, "cam_gamma_pitch", Symbol("gamma", PITCH), "deg", text).column(
            np.degrees(lifted.pitch_direction)
        )


@tabulated
def values(found: Cams) -> Iterator[Value]:
    for one in found.cams:
        yield from _sizes(one)
        match one.cam.sized:
            case Zone() as zone:
                yield from _least(one, zone)
            case Lever(lowest=Turned() as lowest) as lever:
                yield from _least_lever(one, lever, lowest.least)
            case Face() as under:
                yield from _least_face(one, under)
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
        text = N_("distance of the pivots of cam %(cam)s and follower %(follower)s")
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


def _least_lever(found: CamFound, lever: Lever, lowest: float) -> Iterator[Value]:
    text = N_("least angle between the arm of follower %(follower)s and the line of the pivots")
    least = of(found, "cam_start_least", Symbol("beta", f"0,{MIN}"), "rad", text, "deg")
    yield least.value(lowest)
    text = N_("least radius of the pitch curve by the pressure angles")
    yield of(found, "cam_r0_least", Symbol("R", f"0,{MIN}"), "m", text).value(lever.radius(lowest))


def _least_face(found: CamFound, under: Face) -> Iterator[Value]:
    text = N_("least permitted radius of curvature of the profile")
    yield of(found, "cam_curvature", Symbol("rho", LIMIT), "m", text, "mm").value(under.curvature)
    text = N_("least radius of the base circle by the curvature")
    yield of(found, "cam_r0_least", Symbol("R", f"0,{MIN}"), "m", text).value(under.asked.b)
    text = N_("greatest distance of the contact from the axis of the follower along its face")
    ends = (abs(end.value) for end in found.ends[1])
    yield of(found, "cam_reach", Symbol("b"), "m", text, "mm").value(max(ends))


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
