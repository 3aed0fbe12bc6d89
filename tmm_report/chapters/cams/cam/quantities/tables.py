"""The tables of a cam: phases, laws, what its size asks, shocks, motion and profile by positions."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np

from tmm_report.chapters.cams.cam.quantities import arcs
from tmm_report.chapters.cams.cam.quantities.names import (
    acceleration,
    displacement,
    first,
    letter,
    named,
    of,
    pressure,
    second,
    unit,
    velocity,
)
from tmm_report.chapters.cams.cam.solve.found import CamFound, Cams, Divided
from tmm_report.chapters.cams.cam.solve.lifting import Lifted
from tmm_report.i18n import NP_
from tmm_report.mechanics.cams.follower_laws import Kind, Phase
from tmm_report.mechanics.cams.shapes import Parabolic
from tmm_report.mechanics.cams.sizes.least_face import Face, TurnedFace
from tmm_report.mechanics.cams.sizes.least_size import Lever, Turned, Zone
from tmm_report.mechanics.cams.sizes.searched import Demand
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Quantity, Table, text_column
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.tabulated import tabulated
from tmm_report.quantity.terms.cycle import PHI, POSITION

Array = Any
PHASES = Message(N_("phases of the cam's turn"))
SAMPLES = Message(N_("positions of which the laws of the cam are written out"))
MOTION = Message(
    N_("displacement of the follower, its derivatives with respect to the angle turned, pressure angle")
)
JUMPS = Message(N_("angles at which derivatives of the follower's displacement jump"))
PIECES = Message(N_("pieces of the graphs of acceleration by which phases go, for a lift and a phase of 1"))
PROFILE = Message(N_("polar coordinates of the profile and of the pitch curve in the cam's axes"))
DIVISIONS = N_("motion and profile at the ends of equal parts of phase %(number)s")
XY = (
    N_("abscissa of the profile of cam %(cam)s in its axes"),
    N_("ordinate of the profile of cam %(cam)s in its axes"),
)
XY_PITCH = (
    N_("abscissa of the pitch curve of cam %(cam)s in its axes"),
    N_("ordinate of the pitch curve of cam %(cam)s in its axes"),
)
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
    "tabled": N_("tabulated"),
}
NONE = N_("none")
FORMS = {"line": N_("straight"), "sine": N_("quarter of a sine")}
PITCH = NP_("index", "pc")  # of the pitch curve
OF_PHASE, OF_PROFILE = NP_("index", "phase"), NP_("index", "prof")

LEAST = Message(N_("what the permitted pressure angles require of the size of the cam"))
HOLDING = Message(N_("what holds the axis of the smallest cam at the best distance between the pivots"))
AT = Quantity("theta", Symbol("theta"), "deg", Message(N_("angle of the cam from the beginning of its law")))
MOST_ASKED = N_("%(of)s where the requirement is greatest")
ASKED_BEND = Quantity("S2", Symbol("s′′"), "m", Message(N_("its second derivative there")))

PART = Quantity("part", None, "", Message(N_("number of the part of the phase that ends here")))
TURNED = Quantity("phi", Symbol("phi"), "deg", Message(N_("angle turned by the cam from position 0")))
NUMBER = Quantity("number", None, "", Message(N_("its number")))
START = Quantity(
    "start", Symbol("theta", "0"), "deg", Message(N_("angle of the cam at which the phase begins"))
)
ANGLE = Quantity("angle", Symbol("phi", OF_PHASE), "deg", Message(N_("angle of the phase")))
WITHIN = Quantity(
    "theta", Symbol("theta"), "rad", Message(N_("angle of the cam from the beginning of the phase"))
)
BETA = Quantity("delta", Symbol("phi", OF_PHASE), "rad", Message(N_("angle of the phase")))
SHARE = Quantity("tau", Symbol("tau"), "", Message(N_("completed fraction of the phase")))
RATIO = Quantity("ratio", Symbol("n"), "", Message(N_("acceleration of the law over its deceleration")))
BEGINS = Quantity(
    "begins", Symbol("tau", "i"), "", Message(N_("fraction of the phase at which the piece begins"))
)
WIDTH = Quantity("width", Symbol("Deltatau", "i"), "", Message(N_("share of the phase that the piece takes")))
REACHED = Quantity("f", Symbol("f", "i"), "", Message(N_("share of the lift reached where the piece begins")))
SLOPE = Quantity(
    "f1", Symbol("f′", "i"), "", Message(N_("first derivative of that share with respect to τ there"))
)
BEND = Quantity("f2", Symbol("f′′", "i"), "", Message(N_("second derivative where the piece begins")))
NEXT = Quantity("f2_end", Symbol("f′′", "i+1"), "", Message(N_("second derivative where the piece ends")))


@tabulated
def tables(found: Cams) -> Iterator[Table]:
    for one in found.cams:
        if one.phases:
            yield Table(named(one, "cam_phases"), PHASES, _phases(one))
            yield Table(named(one, "cam_law"), SAMPLES, tuple(_samples(one)))
        if one.pieces:
            yield Table(named(one, "cam_pieces"), PIECES, _pieces(one))
        if one.cam.sized is not None:
            yield Table(named(one, "cam_least"), LEAST, tuple(_demands(one)))
        if isinstance(one.cam.sized, Lever):
            yield Table(named(one, "cam_zone"), HOLDING, tuple(_holding(one, one.cam.sized)))
        yield from arcs.tables(one)
        if one.shocks:
            yield Table(named(one, "cam_shocks"), JUMPS, _shocks(one))
        for which, lifted in (("table", one.table), ("diagram", one.diagram)):
            at = where(one, lifted)
            yield Table(named(one, "cam_motion", which), MOTION, (*at, *_motion(one, lifted)))
        yield Table(named(one, "cam_profile"), PROFILE, (*where(one, one.table), *_profile(one, one.table)))
        for part in one.divided:
            text = Message(DIVISIONS, {"number": str(part.phase + 1)})
            name = named(one, "cam_divisions", str(part.phase + 1))
            yield Table(name, text, tuple(_divisions(one, part)))


def where(found: CamFound, lifted: Lifted) -> tuple[Column, Column]:
    """The first columns of a table by positions: their numbers and the angle turned."""
    turned = TURNED if found.alone else PHI
    return POSITION.column(list(range(len(lifted.turned)))), turned.column(np.degrees(lifted.turned))


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
        case TurnedFace(lowest=float(lowest)) as turned:
            worst = turned.worst(lowest)
            return {_way(found, worst): worst}
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
        "S",
        Symbol(letter(found)),
        unit(found),
        Message(MOST_ASKED, {"of": displacement(found).meaning}),
        shown,
    )


def asked_slope(found: CamFound) -> Quantity:
    own = "m" if found.slides else ""
    meaning = Message(MOST_ASKED, {"of": first(found).meaning})
    return Quantity("S1", Symbol(letter(found) + "′"), own, meaning)


def _demands(found: CamFound) -> Iterator[Column]:
    asked = demands(found)
    yield text_column("phase", Message(N_("what the follower does")), [KINDS[kind] for kind in asked])
    yield AT.column([math.degrees(demand.theta) for demand in asked.values()])
    yield asked_S(found).column([demand.S for demand in asked.values()])
    if isinstance(under := found.cam.sized, Face):
        yield ASKED_BEND.column([under.curvature - under.asked.b - under.asked.S])
    else:
        yield asked_slope(found).column([demand.slope for demand in asked.values()])


def _holding(found: CamFound, lever: Lever) -> Iterator[Column]:
    """The conditions that hold the best axis."""
    asked = lever.centres.best.by
    yield text_column("phase", Message(N_("what the follower does")), [KINDS[one.way] for one in asked])
    yield AT.column([math.degrees(one.at.theta) for one in asked])
    yield asked_S(found).column([one.at.S for one in asked])
    yield asked_slope(found).column([one.at.slope for one in asked])


def _shocks(found: CamFound) -> tuple[Column, ...]:
    shocks, letter_ = found.shocks, letter(found)
    own = unit(found) if found.slides else ""
    at = Message(N_("angle of rotation at which a derivative of the displacement jumps"))
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
    if (omega := found.turn.omega) is not None:
        yield velocity(found).column(omega * lifted.first)
        yield acceleration(found).column(omega**2 * lifted.second)
    yield pressure(found).column(np.degrees(lifted.alpha))


def _divisions(found: CamFound, part: Divided) -> Iterator[Column]:
    yield PART.column(list(range(len(part.lifted.turned))))
    yield TURNED.column(np.degrees(part.lifted.turned))
    yield from _motion(found, part.lifted)
    yield from _profile(found, part.lifted)


def _profile(found: CamFound, lifted: Lifted) -> Iterator[Column]:
    text = N_("polar radius of the profile of cam %(cam)s")
    yield of(found, "cam_R", Symbol("R"), "m", text).column(lifted.radius)
    text = N_("polar angle of the profile of cam %(cam)s in its axes")
    yield of(found, "cam_gamma", Symbol("gamma"), "deg", text).column(np.degrees(lifted.direction))
    text = N_("angle of the profile from its first radius, against the turn of cam %(cam)s")
    yield of(found, "cam_delta", Symbol("delta", OF_PROFILE), "deg", text).column(
        _against(found, lifted.direction, found.table.direction)
    )
    yield from _rectangular(found, lifted.radius, lifted.direction, "", XY)
    if found.cam.roller:
        text = N_("polar radius of the pitch curve of cam %(cam)s")
        yield of(found, "cam_R_pitch", Symbol("R", PITCH), "m", text).column(lifted.pitch)
        text = N_("polar angle of the pitch curve of cam %(cam)s in its axes")
        yield of(found, "cam_gamma_pitch", Symbol("gamma", PITCH), "deg", text).column(
            np.degrees(lifted.pitch_direction)
        )
    if found.cam.roller and found.alone:
        text = N_("angle of the pitch curve from its first radius, against the turn of cam %(cam)s")
        delta = of(found, "cam_delta_pitch", Symbol("delta", PITCH), "deg", text)
        yield delta.column(_against(found, lifted.pitch_direction, found.table.pitch_direction))
        yield from _rectangular(found, lifted.pitch, lifted.pitch_direction, PITCH, XY_PITCH)


def _against(found: CamFound, direction: Array, first: Array) -> Array:
    """Angles from the `first` of the turn's, against the turn of the cam, degrees."""
    return np.degrees(np.mod(found.sense * (first[0] - direction) + ROUNDING, 2 * np.pi) - ROUNDING)


def _rectangular(
    found: CamFound, radius: Array, direction: Array, index: str, texts: tuple[str, str]
) -> Iterator[Column]:
    """Abscissae and ordinates of a curve in the cam's axes."""
    for key, part, text in zip(("x", "y"), (np.cos, np.sin), texts, strict=True):
        name = "_".join(filter(None, (f"cam_{key}", "pitch" if index else "")))
        yield of(found, name, Symbol(key, index), "m", text).column(radius * part(direction))
