"""The numbers of kinematics: motion of the outputs, places, velocities and accelerations, singular positions."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from tmm_report.chapters.kinematics.limits import Closest
from tmm_report.chapters.kinematics.solve import Kinematics, Output, Travel, digits_left
from tmm_report.mechanics.cycle import Extreme
from tmm_report.mechanics.motion import Linkage, Motion
from tmm_report.mechanics.relations import Branch, moving_points, relations, turning_links
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Book, Column, Quantity, Table, Value, kept, text_column
from tmm_report.quantity.symbols import Symbol

Array = Any

OUTPUTS = Message(N_("displacement, velocity and acceleration of the output links"))
PLACES = Message(N_("places of points, angles of links, nearness of singular positions"))
RATES = Message(N_("velocities, accelerations and angular rates"))
SPECIAL = Message(N_("positions nearest to singular ones, singular positions, dead points"))
CLOSENESS = N_("closeness of group %(group)s to a singular position, 1 … 0 (of a dyad, a sine)")

POSITION = Quantity("position", None, "", Message(N_("number of the position")))
PHI = Quantity("phi", Symbol("phi"), "deg", Message(N_("angle turned by the driving link from position 0")))


def where(turned: Array) -> tuple[Column, Column]:
    """The first columns of a table by positions: their numbers and the angle turned, rad."""
    return POSITION.column(list(range(len(turned)))), PHI.column(np.degrees(turned))


def book(found: Kinematics) -> Book:
    """All that the chapter says in numbers."""
    return Book.of(tables(found), values(found))


def tables(found: Kinematics) -> Iterator[Table]:
    """Outputs, places and rates at the table positions and at the diagram positions; singular positions."""
    quantities = rates(found.linkage)
    sets = (
        ("table", found.table, found.turned, found.values),
        ("diagram", found.diagram, found.diagram_turned, found.diagram_values),
    )
    for name, motion, turned, values in sets:
        at = where(turned)
        yield Table(f"outputs_{name}", OUTPUTS, (*at, *_outputs(found.travels, name == "diagram")))
        yield Table(f"positions_{name}", PLACES, (*at, *_places(motion)))
        yield Table(f"rates_{name}", RATES, (*at, *_rates(quantities, values)))
    yield Table("special", SPECIAL, _special(found))


# ---------------------------------------------------------------- outputs

SLIDER = (
    ("S", "S", "m", N_("displacement of slider %(name)s from position 0")),
    ("V", "V", "m/s", N_("velocity of slider %(name)s")),
    ("A", "a", "m/s²", N_("acceleration of slider %(name)s")),
)
ROCKER = (
    ("psi", "psi", "rad", N_("angle of link %(name)s from position 0")),
    ("omega", "omega", "rad/s", N_("angular velocity of link %(name)s")),
    ("epsilon", "epsilon", "rad/s²", N_("angular acceleration of link %(name)s")),
)


def motion_of(output: Output) -> tuple[Quantity, Quantity, Quantity]:
    """Displacement, velocity and acceleration of an output."""
    return _motion_of(output.kind, output.name)


@kept
def _motion_of(kind: str, name: str) -> tuple[Quantity, Quantity, Quantity]:
    displacement, velocity, acceleration = (
        Quantity(f"{key}_{name}", Symbol(base, name), unit, Message(text, {"name": name}))
        for key, base, unit, text in (SLIDER if kind == "slider" else ROCKER)
    )
    return displacement, velocity, acceleration


def _outputs(travels: Sequence[Travel], diagram: bool) -> Iterator[Column]:
    for travel in travels:
        table, fine = (travel.S, travel.V, travel.a), (travel.diagram_S, travel.diagram_V, travel.diagram_a)
        for quantity, values in zip(motion_of(travel.output), fine if diagram else table, strict=True):
            yield quantity.column(values)


# ---------------------------------------------------------------- places


def _places(motion: Motion) -> Iterator[Column]:
    for point in moving_points(motion.linkage):
        place = motion.place(point)
        for axis, text, values in (
            ("x", N_("x of point %(name)s"), place.real),
            ("y", N_("y of point %(name)s"), place.imag),
        ):
            yield coordinate(axis, text, point).column(values)
    for link in turning_links(motion.linkage):
        yield angle(link).column(np.degrees(np.angle(motion.turn(link))))
    for label, sine in motion.sines.items():
        near, digits = nearness(label)
        yield near.column(sine)
        yield digits.column(digits_left(sine))


@kept
def coordinate(axis: str, text: str, point: str) -> Quantity:
    """x or y of a point."""
    return Quantity(f"{axis}_{point}", Symbol(axis, point), "m", Message(text, {"name": point}))


@kept
def angle(link: str) -> Quantity:
    meaning = Message(N_("angle of link %(name)s from the x axis"), {"name": link})
    return Quantity(f"phi_{link}", Symbol("phi", link), "deg", meaning)


@kept
def nearness(group: str) -> tuple[Quantity, Quantity]:
    """Closeness of a group to a singular position, and the digits that remain there."""
    of = {"group": group}
    digits = Message(N_("decimal digits that remain in group %(group)s"), of)
    return (
        Quantity(f"sin_{group}", None, "", Message(CLOSENESS, of)),
        Quantity(f"digits_{group}", None, "", digits),
    )


# ---------------------------------------------------------------- velocities and accelerations

POINT = {"v": N_("velocity of point %(of)s"), "a": N_("acceleration of point %(of)s")}
LINK = {"w": N_("angular velocity of link %(name)s"), "e": N_("angular acceleration of link %(name)s")}
RELATIVE = N_("velocity of point %(one)s relative to point %(other)s")
PARTS = {
    "n": N_("normal acceleration of point %(one)s relative to point %(other)s"),
    "t": N_("tangential acceleration of point %(one)s relative to point %(other)s"),
    "k": N_("Coriolis acceleration of point %(one)s relative to point %(other)s"),
    "r": N_("sliding acceleration of point %(one)s relative to point %(other)s"),
}
BASES = {"w": "omega", "e": "epsilon"}
UNITS = {"v": "m/s", "a": "m/s²", "w": "rad/s", "e": "rad/s²"}


@kept
def point_rate(letter: str, point: str) -> Quantity:
    """Velocity "v" or acceleration "a" of a point."""
    meaning = Message(POINT[letter], {"of": point})
    return Quantity(f"{letter}_{point}", Symbol(letter, point), UNITS[letter], meaning)


@kept
def link_rate(letter: str, link: str) -> Quantity:
    """Angular velocity "w" or acceleration "e" of a link."""
    meaning = Message(LINK[letter], {"name": link})
    return Quantity(f"{letter}_{link}", Symbol(BASES[letter], link), UNITS[letter], meaning)


def rates(linkage: Linkage) -> dict[str, Quantity]:
    """Every velocity, acceleration and angular rate of the note by its key (see `relations.named_values`)."""
    found: list[Quantity] = []
    for point in moving_points(linkage):
        found += [point_rate("v", point), point_rate("a", point)]
    for relation in relations(linkage):
        for branch in relation.branches:
            found += _of_branch(branch)
    for link in turning_links(linkage):
        found += [link_rate("w", link), link_rate("e", link)]
    known: dict[str, Quantity] = {}
    for quantity in found:
        known.setdefault(quantity.key, quantity)
    return known


@kept
def _of_branch(branch: Branch) -> tuple[Quantity, ...]:
    return tuple(_branch_rates(branch))


def _branch_rates(branch: Branch) -> Iterator[Quantity]:
    for point in (branch.start, branch.end):
        if point is not None:
            yield from (point_rate("v", point), point_rate("a", point))
    about = branch.start or (branch.arm[0] if branch.arm else branch.guide)
    pair = {"one": branch.end, "other": about}
    yield Quantity(branch.v_key, Symbol("v", branch.pair), "m/s", Message(RELATIVE, pair))
    if branch.has_bend or branch.start is not None:
        for part in ("n", "t") if branch.turns else ("k", "r") if branch.has_bend else ("r",):
            symbol = Symbol("a", branch.pair, part)
            yield Quantity(f"a_{branch.pair}_{part}", symbol, "m/s²", Message(PARTS[part], pair))


def _rates(quantities: Mapping[str, Quantity], values: Mapping[str, Array]) -> Iterator[Column]:
    for key, numbers in values.items():
        if np.iscomplexobj(numbers):
            yield from quantities[key].vector(numbers)
        else:
            yield quantities[key].column(numbers)


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
        PHI.column(np.degrees(turned)),
        NEAR.column(closeness),
        DIGITS.column(digits_left(np.array(closeness, dtype=float))),
    )


# ---------------------------------------------------------------- single numbers


def values(found: Kinematics) -> Iterator[Value]:
    zero = Message(N_("angle of the driving link in position 0"))
    yield Quantity("phi_0", Symbol("phi", "0"), "deg", zero).value(math.degrees(found.cycle.zero))
    for travel in found.travels:
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


def stroke(travel: Travel) -> Value:
    """Stroke of a slider, or angle of swing of a rocker."""
    name, slider = travel.output.name, travel.output.kind == "slider"
    meaning = Message(
        N_("stroke of slider %(name)s") if slider else N_("swing of link %(name)s"), {"name": name}
    )
    symbol = Symbol("H" if slider else "psi", name)
    return Quantity(f"H_{name}", symbol, "m" if slider else "rad", meaning).value(travel.stroke)


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
    return Quantity(key, of.symbol, of.unit, meaning).value(extreme.value, extreme.turned)
