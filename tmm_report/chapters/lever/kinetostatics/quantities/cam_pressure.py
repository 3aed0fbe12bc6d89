"""The numbers of how hard the cams press their followers."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from tmm_report.chapters.lever.kinematics.quantities import where
from tmm_report.chapters.lever.kinetostatics.solve.cam_pressure import Pressing
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Quantity, Table, Value
from tmm_report.quantity.symbols import Symbol

if TYPE_CHECKING:
    from tmm_report.chapters.lever.kinetostatics.solve.positions import Kinetostatics

PRESSING = Message(
    N_("reactions of the cams on their followers along the common normal; below zero: they part")
)
ZONES = Message(N_("angles over which a follower would leave its cam"))
LEAST = N_("least reaction of cam %(cam)s on follower %(follower)s along the normal")
GREATEST = N_("greatest reaction of cam %(cam)s on follower %(follower)s along the normal")
CLOSURE = N_(
    "greatest force along the normal by which a closure has to hold follower %(follower)s to its cam"
)


def along(one: Pressing) -> Quantity:
    """The reaction along the normal."""
    text = N_(
        "reaction of cam %(cam)s on follower %(follower)s along the common normal, above zero where it presses"
    )
    return _of(one, "cam_press", text)


def _of(one: Pressing, key: str, text: str) -> Quantity:
    meaning = Message(text, {"cam": one.cam.cam, "follower": one.cam.follower})
    return Quantity(f"{key}_{one.cam.name}", Symbol("R", one.cam.name, "n"), "N", meaning)


def tables(found: Kinetostatics, pressed: Sequence[Pressing]) -> Iterator[Table]:
    if not pressed:
        return
    for name, turned in (("table", found.table.turned), ("diagram", found.diagram.turned)):
        columns = [along(one).column(getattr(one, name)) for one in pressed]
        yield Table(f"cam_press_{name}", PRESSING, (*where(turned), *columns))
    for one in pressed:
        if one.zones:
            yield _zones(one)


def _zones(one: Pressing) -> Table:
    begin, end = (
        Message(N_("angle of rotation at which it begins")),
        Message(N_("angle of rotation at which it ends")),
    )
    return Table(
        f"cam_parting_{one.cam.name}",
        ZONES,
        (
            Quantity("from", Symbol("phi"), "deg", begin).column([math.degrees(a) for a, _ in one.zones]),
            Quantity("to", Symbol("phi"), "deg", end).column([math.degrees(b) for _, b in one.zones]),
        ),
    )


def values(pressed: Sequence[Pressing]) -> Iterator[Value]:
    for one in pressed:
        yield _of(one, "cam_press_min", LEAST).value(one.least.value, one.least.turned)
        yield _of(one, "cam_press_max", GREATEST).value(one.greatest.value, one.greatest.turned)
        if one.parts:
            yield _of(one, "cam_closure", CLOSURE).value(one.closure, one.least.turned)
