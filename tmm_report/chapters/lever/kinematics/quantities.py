"""The numbers of kinematics: motion of the outputs, places, velocities and accelerations, singular positions."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from tmm_report.chapters.lever.initial_data.quantities import heavy_links
from tmm_report.chapters.lever.kinematics import stroke as driving
from tmm_report.chapters.lever.kinematics.checks.digits_left import digits_left
from tmm_report.chapters.lever.kinematics.checks.singular import Closest
from tmm_report.chapters.lever.kinematics.contours import solve as contours
from tmm_report.chapters.lever.kinematics.solve import analogues
from tmm_report.chapters.lever.kinematics.solve.points_and_links import POSITION as POSITION
from tmm_report.chapters.lever.kinematics.solve.points_and_links import UNITS as UNITS
from tmm_report.chapters.lever.kinematics.solve.points_and_links import along, places, rated
from tmm_report.chapters.lever.kinematics.solve.points_and_links import angle as angle
from tmm_report.chapters.lever.kinematics.solve.points_and_links import coordinate as coordinate
from tmm_report.chapters.lever.kinematics.solve.points_and_links import link_rate as link_rate
from tmm_report.chapters.lever.kinematics.solve.points_and_links import point_rate as point_rate
from tmm_report.chapters.lever.kinematics.solve.points_and_links import rates as rates
from tmm_report.chapters.lever.kinematics.solve.points_and_links import where as where
from tmm_report.chapters.lever.kinematics.solve.positions import Kinematics, Output, Travel
from tmm_report.chapters.lever.kinematics.solve.swings import first
from tmm_report.mechanics.lever.cycle import Extreme, larger
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.mechanics.lever.vector_equations import moving_points, named_values, turning_links
from tmm_report.problems import N_, Message
from tmm_report.quantity.formula import Expr
from tmm_report.quantity.model import Book, Column, Quantity, Table, Value, kept, plain, text_column
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.tabulated import tabulated

if TYPE_CHECKING:
    from tmm_report.mechanics.rivals.choice import Choice

OUTPUTS = Message(
    N_("displacement, velocity and acceleration of the output links, angles of the other driven links")
)
PLACES = Message(N_("places of points, angles of links, nearness of singular positions"))
OUTPUTS_AT = Message(N_("motion of the output links and driven links at the instants asked for"))
PLACES_AT = Message(N_("places of points and angles of links at the instants asked for"))
RATES_AT = Message(N_("velocities and accelerations at the instants asked for"))
RATES = Message(N_("velocities, accelerations and angular rates"))
METHOD = Message(N_("the method of the table and diagram positions, and its errors"))
SPECIAL = Message(N_("positions nearest to singular ones, singular positions, dead points"))


def book(found: Kinematics) -> Book:
    """All that the chapter says in numbers."""
    return Book.of(tables(found), values(found))


def kinetic(
    found: Kinematics, links: Collection[str], masses: Table, rates: Table, omega: Expr, k: int
) -> Iterator[Expr]:
    """m (v_S/ω₁)² and J (ω/ω₁)² of `links` at a position, of the driving link its J: what makes up their reduced moment
    of inertia. `masses`, `rates`: the tables of what is given and of the motion; `omega`: of the driving link."""
    turning, moving = turning_links(found.linkage), moving_points(found.linkage)
    mechanism = found.linkage.mechanism
    for row, link in enumerate(heavy_links(mechanism)):
        if link.name not in links:
            continue
        if link.mass and link.mass_centre in moving:
            speed = rates.var(point_rate("v", str(link.mass_centre)).key, k, size=True)
            yield masses.var("m", row) * (speed / omega) ** 2
        if link.inertia and link.name == mechanism.driver.link:
            yield masses.var("J", row)
        elif link.inertia and link.name in turning:
            yield masses.var("J", row) * (rates.var(link_rate("w", link.name).key, k, size=True) / omega) ** 2


@tabulated
def tables(found: Kinematics) -> Iterator[Table]:
    """Outputs, places and rates at the table positions and at the diagram positions; singular positions."""
    quantities = rates(found.linkage)
    sets = (
        ("table", found.table, found.turned, found.values),
        ("diagram", found.diagram, found.diagram_turned, found.diagram_values),
    )
    for name, motion, turned, values in sets:
        at = where(turned, found.by_law)
        yield Table(
            f"outputs_{name}",
            OUTPUTS,
            (
                *at,
                analogues.time(found, turned),
                *analogues.by_law(found, turned),
                *_outputs(found, name == "diagram"),
            ),
        )
        yield Table(f"positions_{name}", PLACES, (*at, *places(motion)))
        yield Table(f"rates_{name}", RATES, (*at, *rated(quantities, values)))
    if found.asked is not None:
        yield from _at_instants(found, found.asked)
    yield from driving.tables(found)
    yield Table("special", SPECIAL, _special(found))
    yield from analogues.tables(found)
    yield from contours.tables(found)
    if found.choice is not None:
        yield Table("method", METHOD, _method(found.choice))


def _at_instants(found: Kinematics, motion: Motion) -> Iterator[Table]:
    """The same at the instants that the variant asks for: motion of the outputs, places and rates."""
    turned = found.instants
    at = (along(found.by_law).column(np.degrees(turned)), analogues.time(found, turned))
    outputs = [one for travel in (*found.travels, *found.links) for one in _there(found, travel, motion)]
    columns = (*at, *analogues.by_law(found, turned), *outputs)
    yield Table("outputs_at", OUTPUTS_AT, tuple(replace(one, asked=False) for one in columns))
    yield Table("positions_at", PLACES_AT, (*at, *(replace(one, asked=False) for one in places(motion))))
    rated_there = rated(rates(found.linkage), named_values(motion))
    yield Table("rates_at", RATES_AT, (*at, *(replace(one, asked=False) for one in rated_there)))


def _there(found: Kinematics, travel: Travel, motion: Motion) -> Iterator[Column]:
    """Displacement of a slider from position 0, velocity, acceleration; angles of links stand with the places."""
    S, V, a = travel.output.rates(motion)
    displacement, velocity, acceleration = motion_of(travel.output)
    if travel.output.kind == "slider":
        yield displacement.column(S - first(travel.output.coordinate(found.table)))
    yield velocity.column(V)
    yield acceleration.column(a)


def _method(choice: Choice) -> tuple[Column, ...]:
    """A row for each kind of quantity."""
    kinds = list(choice.errors)
    return (
        text_column(
            "method", Message(N_("the method, by its name in the results")), [choice.taken.key] * len(kinds)
        ),
        text_column("kind", Message(N_("place, velocity or acceleration of points")), kinds),
        plain(
            "error",
            "",
            Message(N_("largest relative difference from the closed form")),
            list(choice.errors.values()),
        ),
        plain(
            "accuracy",
            "",
            Message(N_("relative error that the numbers are to hold")),
            [choice.accuracy] * len(kinds),
        ),
    )


# ---------------------------------------------------------------- outputs

SLIDER = (
    ("S", "S", "m", "", N_("displacement of slider %(name)s from position 0")),
    ("V", "V", "m/s", "", N_("velocity of slider %(name)s")),
    ("A", "a", "m/s²", "", N_("acceleration of point %(of)s")),
)
ROCKER = (
    ("psi", "psi", "rad", "deg", N_("angle of link %(name)s from position 0")),
    ("omega", "omega", "rad/s", "", N_("angular velocity of link %(name)s")),
    ("epsilon", "epsilon", "rad/s²", "", N_("angular acceleration of link %(name)s")),
)


def motion_of(output: Output) -> tuple[Quantity, Quantity, Quantity]:
    """Displacement, velocity and acceleration of an output."""
    return _motion_of(output.kind, output.name)


@kept
def _motion_of(kind: str, name: str) -> tuple[Quantity, Quantity, Quantity]:
    displacement, velocity, acceleration = (
        Quantity(
            f"{key}_{name}",
            Symbol(base, name),
            unit,
            Message(text, {"of" if base == "a" else "name": name}),
            shown,
        )
        for key, base, unit, shown, text in (SLIDER if kind == "slider" else ROCKER)
    )
    return displacement, velocity, acceleration


def _outputs(found: Kinematics, diagram: bool) -> Iterator[Column]:
    """Of the output links, then of the other driven links: their rates are asked for in the table of rates."""
    for travel in (*found.travels, *found.links):
        table, fine = (travel.S, travel.V, travel.a), (travel.diagram_S, travel.diagram_V, travel.diagram_a)
        for quantity, values in zip(motion_of(travel.output), fine if diagram else table, strict=True):
            yield replace(quantity.column(values), asked=travel in found.travels)


# ---------------------------------------------------------------- singular positions


def special_rows(found: Kinematics) -> Iterator[tuple[str, str, float, float]]:
    """Kind, group or output, angle turned (rad) and closeness of everything singular."""
    for c in found.closest:
        yield "closest", c.group, c.closeness.turned, c.closeness.value
        yield from _exact(c)
    for dead in found.dead:
        yield from (("dead", dead.output, turned, math.nan) for turned in dead.turned)


def _exact(c: Closest) -> Iterator[tuple[str, str, float, float]]:
    for kind, angles in (("change", c.changes), ("limit", c.limits), ("parallel", c.parallel)):
        yield from ((kind, c.group, turned, 0.0) for turned in angles)


NEAR = Quantity("closeness", None, "", Message(N_("closeness to a singular position, 1 … 0")))
DIGITS = Quantity("digits", None, "", Message(N_("decimal digits that remain")))


def _special(found: Kinematics) -> tuple[Column, ...]:
    """Exact angles of turn at which something is singular: one row each."""
    rows = list(special_rows(found))
    kinds, of = [row[0] for row in rows], [row[1] for row in rows]
    turned, closeness = [row[2] for row in rows], [row[3] for row in rows]
    return (
        text_column("kind", Message(N_("closest, change, limit, parallel (guides) or dead (point)")), kinds),
        text_column("of", Message(N_("the group, or the output link")), of),
        along(found.by_law).column(np.degrees(turned)),
        NEAR.column(closeness),
        DIGITS.column(digits_left(np.array(closeness, dtype=float))),
    )


# ---------------------------------------------------------------- single numbers


@tabulated
def values(found: Kinematics) -> Iterator[Value]:
    zero = Message(N_("angle of the driving link in position 0"))
    yield Quantity("phi_0", Symbol("phi", "0"), "deg", zero).value(math.degrees(found.cycle.zero))
    yield from driving.values(found)
    for travel in (*found.travels, *found.links):
        yield from _of_travel(travel)


ENDS = (
    ("S", N_("least displacement of %(name)s"), N_("greatest displacement of %(name)s")),
    ("V", N_("least velocity of %(name)s"), N_("greatest velocity of %(name)s")),
    ("A", N_("least acceleration of %(name)s"), N_("greatest acceleration of %(name)s")),
)


def _of_travel(travel: Travel) -> Iterator[Value]:
    name, of = travel.output.name, {"name": travel.output.name}
    yield stroke(travel)
    if travel.time_ratio is not None:
        ratio = Message(N_("time ratio of the strokes of %(name)s"), of)
        yield Quantity(f"K_{name}", Symbol("K", name), "", ratio).value(travel.time_ratio)
    for ends in extremes(travel):
        yield from ends


def headline(found: Kinematics) -> Iterator[Value]:
    """Of each output stroke or swing, time ratio and greatest speed; where it moves over the whole cycle."""
    for travel in () if found.gaps else found.travels:
        by_key = {value.key: value for value in _of_travel(travel)}
        name, fastest = travel.output.name, larger(travel.V_extremes)
        yield from (by_key[key] for key in (f"H_{name}", f"K_{name}") if key in by_key)
        _, speed, _ = motion_of(travel.output)
        meaning = Message(N_("greatest velocity of %(name)s by size"), {"name": name})
        yield replace(speed, key=f"V_{name}_most", meaning=meaning).value(abs(fastest.value), fastest.turned)


def stroke(travel: Travel) -> Value:
    """Stroke of a slider, or angle of swing of a rocker."""
    name, slider = travel.output.name, travel.output.kind == "slider"
    meaning = Message(
        N_("stroke of slider %(name)s") if slider else N_("swing of link %(name)s"), {"name": name}
    )
    symbol = Symbol("H" if slider else "Psi", name)
    unit, shown = ("m", "") if slider else ("rad", "deg")
    return Quantity(f"H_{name}", symbol, unit, meaning, shown).value(travel.stroke)


def extremes(travel: Travel) -> Iterator[tuple[Value, Value]]:
    """Least and greatest displacement, velocity and acceleration."""
    found = ((travel.near, travel.far), travel.V_extremes, travel.a_extremes)
    name = travel.output.name
    for (letter, *texts), quantity, pair in zip(ENDS, motion_of(travel.output), found, strict=True):
        low, high = (
            _extreme(f"{letter}_{name}_{end}", quantity, Message(text, {"name": name}), extreme)
            for end, text, extreme in zip(("min", "max"), texts, pair, strict=True)
        )
        yield low, high


def _extreme(key: str, of: Quantity, meaning: Message, extreme: Extreme) -> Value:
    return replace(of, key=key, meaning=meaning).value(extreme.value, extreme.turned, extreme.side)
