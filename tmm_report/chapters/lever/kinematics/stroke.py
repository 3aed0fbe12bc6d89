"""The numbers of a driving slider or cylinder: its stroke by the time, and how a link follows it: by a triangle, or by
the position function of the mechanism, reversed."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from tmm_report.chapters.lever.initial_data.quantities import length
from tmm_report.chapters.lever.kinematics.solve.analogues import in_unit_motion, time
from tmm_report.chapters.lever.kinematics.solve.points_and_links import along, where
from tmm_report.mechanics.lever.driving.reversed import Reversed
from tmm_report.mechanics.lever.driving.stroke import Stroke
from tmm_report.mechanics.lever.driving.triangle import Triangle
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Quantity, Table, Value
from tmm_report.quantity.symbols import Symbol

if TYPE_CHECKING:
    from tmm_report.chapters.lever.kinematics.solve.positions import Kinematics

Array = Any

MEANING = Message(N_("stroke of the driving slider or cylinder, and how a link follows it"))
PLACE = Quantity(
    "stroke", Symbol("s"), "m", Message(N_("stroke: place of the driving slider along its guide"))
)
LENGTH = replace(PLACE, meaning=Message(N_("stroke: length of the driving cylinder between its points")))
SPEED = Quantity("stroke_v", Symbol("v", "s"), "m/s", Message(N_("speed of the stroke")))
ACCELERATION = Quantity("stroke_a", Symbol("a", "s"), "m/s²", Message(N_("acceleration of the stroke")))
GUIDE = Quantity(
    "stroke_gamma",
    Symbol("gamma", "0"),
    "deg",
    Message(N_("angle of the driving slider's guide with the x axis")),
)
LAG = Quantity(
    "stroke_lag",
    Symbol("delta"),
    "deg",
    Message(N_("angle of the arm in the axes of the link that follows the stroke")),
)


def of(stroke: Stroke) -> Quantity:
    """The stroke itself."""
    return PLACE if stroke.slides else LENGTH


def arm(stroke: Triangle) -> Quantity:
    """r = OP."""
    pivot, pin, _ = stroke.names
    return replace(length(pivot + pin), key="stroke_arm")


def rod(stroke: Triangle) -> Quantity:
    """d = PQ of a slider."""
    _, pin, far = stroke.names
    return replace(length(pin + far), key="stroke_rod")


def base(stroke: Triangle) -> Quantity:
    """OQ."""
    pivot, _, far = stroke.names
    return replace(length(pivot + far), key="stroke_base")


def _angle(key: str, letter: str, one: str, other: str) -> Quantity:
    meaning = Message(
        N_("angle of the line from %(one)s to %(other)s with the x axis"), {"one": one, "other": other}
    )
    return Quantity(key, Symbol(letter, one + other), "deg", meaning)


def base_angle(stroke: Triangle) -> Quantity:
    pivot, _, far = stroke.names
    return _angle("stroke_alpha", "alpha", pivot, far)


def arm_angle(stroke: Triangle) -> Quantity:
    pivot, pin, _ = stroke.names
    return _angle("stroke_phi", "phi", pivot, pin)


def line(stroke: Triangle) -> tuple[str, str]:
    """The rod from the link to the slider; the cylinder from its fixed point to the link."""
    _, pin, far = stroke.names
    return (pin, far) if stroke.slides else (far, pin)


def line_angle(stroke: Triangle) -> Quantity:
    return _angle("stroke_psi", "alpha", *line(stroke))


def line_rate(stroke: Triangle) -> Quantity:
    one, other = line(stroke)
    meaning = Message(N_("angular velocity of the line %(one)s%(other)s"), {"one": one, "other": other})
    return Quantity("stroke_omega", Symbol("omega", one + other), "rad/s", meaning)


def corner(stroke: Triangle) -> Quantity:
    """The angle QOP."""
    pivot, pin, far = stroke.names
    of_points = {"one": far, "two": pivot, "three": pin}
    return Quantity(
        "stroke_beta",
        Symbol("beta"),
        "deg",
        Message(N_("angle %(one)s%(two)s%(three)s of the triangle"), of_points),
    )


TRANSFER = Quantity(
    "stroke_transfer",
    Symbol("phi′"),
    "1/m",
    Message(N_("analogue of the angular velocity of the link that follows the stroke, by the stroke")),
)

D_MEANING = {
    True: N_("%(axis)s component of the vector from the point that the guide is stated by to %(end)s"),
    False: N_("%(axis)s component of the vector from %(start)s to %(end)s"),
}
D_FIRST = N_(
    "derivative of the %(axis)s component of the vector d with respect to the angle of link %(link)s"
)
D_SECOND = N_(
    "second derivative of the %(axis)s component of the vector d with respect to the angle of link %(link)s"
)


def vector(stroke: Reversed) -> tuple[Quantity, ...]:
    """d_x, d_y of the vector whose length, or part along the guide, is the stroke, and their derivatives by φ."""
    words = {"start": stroke.ends[0], "end": stroke.ends[-1], "link": stroke.link}
    return tuple(
        Quantity(
            f"stroke_d{order}_{axis}",
            Symbol("d" + "′" * order, axis),
            "m",
            Message(text, {"axis": axis, **words}),
        )
        for order, text in enumerate((D_MEANING[stroke.slides], D_FIRST, D_SECOND))
        for axis in "xy"
    )


def derivatives(stroke: Reversed) -> tuple[Quantity, Quantity]:
    """s′ and s″ by the angle of the link."""
    of = {"link": stroke.link}
    first = Message(N_("derivative of the stroke with respect to the angle of link %(link)s"), of)
    second = Message(N_("second derivative of the stroke with respect to the angle of link %(link)s"), of)
    return Quantity("stroke_s1", Symbol("s′"), "m", first), Quantity("stroke_s2", Symbol("s′′"), "m", second)


def tables(found: Kinematics) -> Iterator[Table]:
    """At the table and at the diagram positions, and at the instants that are asked for."""
    stroke = found.stroke
    if stroke is None:
        return
    for name, motion, turned in (
        ("table", found.table, found.turned),
        ("diagram", found.diagram, found.diagram_turned),
    ):
        yield Table(
            f"stroke_{name}", MEANING, (*where(turned, True), time(found, turned), *_columns(stroke, motion))
        )
    if found.asked is not None:
        at = (along(True).column(np.degrees(found.instants)), time(found, found.instants))
        yield Table("stroke_at", MEANING, (*at, *_columns(stroke, found.asked)))


def _columns(stroke: Stroke, motion: Motion) -> Iterator[Column]:
    s, v, a = stroke.law.of_phase(motion.phase)
    parts = _of_triangle(stroke, motion) if isinstance(stroke, Triangle) else _of_function(stroke, motion)
    for quantity, values in ((of(stroke), s), (SPEED, v), (ACCELERATION, a), *parts):
        yield replace(quantity.column(np.broadcast_to(values, motion.shape)), asked=False)


def _of_triangle(stroke: Triangle, motion: Motion) -> Iterator[tuple[Quantity, Array]]:
    s, v, _ = stroke.law.of_phase(motion.phase)
    p, c = stroke.arms(s)
    c = -c if stroke.slides else c
    omega = motion.state.w[stroke.link]
    turned = 1j * omega * p - stroke.way * v  # of P about Q
    rate = (np.conj(c) * (-turned if stroke.slides else turned)).imag / np.abs(c) ** 2
    beta = np.arccos(stroke.cosine(s))
    yield base(stroke), np.abs(stroke.far(s))
    yield base_angle(stroke), np.degrees(np.angle(stroke.far(s)))
    yield corner(stroke), np.degrees(beta)
    yield arm_angle(stroke), np.degrees(np.angle(stroke.far(s)) + stroke.side * beta)
    yield line_angle(stroke), np.degrees(np.angle(c))
    yield line_rate(stroke), rate
    yield TRANSFER, stroke.transfer(s)


def _of_function(stroke: Stroke, motion: Motion) -> Iterator[tuple[Quantity, Array]]:
    assert isinstance(stroke, Reversed)
    unit = in_unit_motion(motion)
    d = stroke.function.relative(unit)
    of_d = [part for one in (d.place, d.velocity, d.acceleration) for part in (np.real(one), np.imag(one))]
    _, first, second = stroke.function.of(unit)
    yield from zip((*vector(stroke), *derivatives(stroke)), (*of_d, first, second), strict=True)
    yield TRANSFER, 1 / first


def values(found: Kinematics) -> Iterator[Value]:
    stroke = found.stroke
    if stroke is None:
        return
    if isinstance(stroke, Triangle):
        yield arm(stroke).value(stroke.crank)
        if np.angle(stroke.pin):
            yield LAG.value(float(np.degrees(np.angle(stroke.pin))))
        if stroke.slides:
            yield rod(stroke).value(stroke.rod)
    if stroke.slides:
        yield GUIDE.value(float(np.degrees(np.angle(stroke.way))))
