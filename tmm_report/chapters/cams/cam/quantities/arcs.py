"""The numbers of a cam of base circle, flanks and nose, and of its follower where one passes into the other."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from tmm_report.chapters.cams.cam.quantities.names import (
    acceleration,
    displacement,
    first,
    letter,
    named,
    of,
    second,
    unit,
    velocity,
)
from tmm_report.chapters.cams.cam.solve.found import CamFound
from tmm_report.i18n import NP_
from tmm_report.mechanics.cams.arcs import ArcLaw
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Quantity, Table, Value, text_column
from tmm_report.quantity.symbols import Symbol

NOSE, FLANK, START, CHANGE, APEX = (
    NP_("index", "nose"), NP_("index", "flank"), NP_("index", "begin"), NP_("index", "change"), NP_("index", "apex"),
)  # fmt: skip
CHANGES = Message(N_("motion of the follower where flanks, nose and base circle meet, on both sides"))
RISES, FLANK_ENDS, NOSE_BEGINS, TIP, NOSE_ENDS, FALLS, FLANK_LEAVES = (
    N_("rising flank, beginning"), N_("rising flank, end"), N_("nose, beginning"), N_("nose, greatest lift"),
    N_("nose, end"), N_("falling flank, beginning"), N_("falling flank, end"),
)  # fmt: skip
TURNED = Quantity(
    "theta", Symbol("theta"), "deg", Message(N_("angle of the cam from the beginning of the rise"))
)


class Place(NamedTuple):
    """A place of the turn as one piece of the profile has it: rad, m, m or rad and their derivatives."""

    text: str
    theta: float
    S: float
    first: float
    second: float


def places(law: ArcLaw) -> list[Place]:
    """In the order of the turn."""
    edges = [float(x) for x in law.edges]
    at = (
        (RISES, 0, edges[0]), (FLANK_ENDS, 0, edges[1]), (NOSE_BEGINS, 1, edges[1]), (TIP, 1, law.apex),
        (NOSE_ENDS, 1, edges[2]), (FALLS, 2, edges[2]), (FLANK_LEAVES, 2, edges[3]),
    )  # fmt: skip
    return [Place(text, theta, *(float(x) for x in law.within(piece, theta))) for text, piece, theta in at]


def tables(found: CamFound) -> Iterator[Table]:
    if found.pieced is not None:
        yield Table(named(found, "cam_changes"), CHANGES, tuple(_columns(found, places(found.pieced))))


def _columns(found: CamFound, rows: list[Place]) -> Iterator[Column]:
    yield text_column("place", Message(N_("where")), [one.text for one in rows])
    yield TURNED.column(np.degrees([one.theta for one in rows]))
    yield displacement(found).column([one.S for one in rows])
    yield first(found).column([one.first for one in rows])
    yield second(found).column([one.second for one in rows])
    if (omega := found.turn.omega) is not None:
        yield velocity(found).column([omega * one.first for one in rows])
        yield acceleration(found).column([omega**2 * one.second for one in rows])


def values(found: CamFound) -> Iterator[Value]:
    law = found.pieced
    if law is None:
        return
    one = law.outline
    yield of(found, "cam_nose", Symbol("r", NOSE), "m", N_("radius of the nose of cam %(cam)s"), "mm").value(
        one.nose
    )
    if not one.straight:
        text = N_("radius of the flanks of cam %(cam)s")
        yield of(found, "cam_flank", Symbol("R", FLANK), "m", text, "mm").value(one.flank)
    text = N_("distance of the centre of the nose from the axis of cam %(cam)s")
    yield of(found, "cam_distance", Symbol("c"), "m", text, "mm").value(one.distance)
    text = N_("half angle of action of cam %(cam)s, from the beginning of the flank to the tip")
    yield of(found, "cam_half_angle", Symbol("theta", "a"), "rad", text, "deg").value(one.half_angle)
    text = N_("angle through which cam %(cam)s turns while the follower is on its flank")
    yield of(found, "cam_flank_angle", Symbol("theta", FLANK), "rad", text, "deg").value(float(law.edges[1]))
    text = N_("angle through which cam %(cam)s turns from the beginning of the nose to the greatest lift")
    left = law.apex - float(law.edges[1])
    yield of(found, "cam_nose_angle", Symbol("theta", NOSE), "rad", text, "deg").value(left)
    yield from _at_changes(found, places(law))


def _at_changes(found: CamFound, rows: list[Place]) -> Iterator[Value]:
    start, end, nose, tip = rows[:4]
    own, sign, slope = unit(found), letter(found), unit(found) if found.slides else ""
    shown = "mm" if found.slides else ""
    text = N_("displacement where the follower passes from the flank to the nose")
    yield of(found, "cam_S_change", Symbol(sign, CHANGE), own, text, "mm" if found.slides else "deg").value(
        end.S
    )
    text = N_("first derivative of the displacement where the follower passes from the flank to the nose")
    yield of(found, "cam_S1_change", Symbol(sign + "′", CHANGE), slope, text, shown).value(end.first)
    for key, index, place, text in (
        ("start", START, start, N_("second derivative of the displacement where the rise begins")),
        ("flank", FLANK, end, N_("second derivative of the displacement at the end of the flank")),
        ("nose", NOSE, nose, N_("second derivative of the displacement at the beginning of the nose")),
        ("apex", APEX, tip, N_("second derivative of the displacement at the greatest lift")),
    ):
        yield of(found, f"cam_S2_{key}", Symbol(sign + "′′", index), slope, text, shown).value(place.second)
    if (omega := found.turn.omega) is None:
        return
    fast, grows = velocity(found), acceleration(found)
    text = N_("velocity where the follower passes from the flank to the nose")
    yield of(found, "cam_v_change", Symbol(fast.sign.base, CHANGE), fast.unit, text).value(omega * end.first)
    for key, index, place, text in (
        ("start", START, start, N_("acceleration where the rise begins")),
        ("flank", FLANK, end, N_("acceleration at the end of the flank")),
        ("nose", NOSE, nose, N_("acceleration at the beginning of the nose")),
        ("apex", APEX, tip, N_("acceleration at the greatest lift")),
    ):
        made = of(found, f"cam_a_{key}", Symbol(grows.sign.base, index), grows.unit, text)
        yield made.value(omega**2 * place.second)
