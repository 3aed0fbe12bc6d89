"""The numbers of kinetostatics: loads, reactions, balancing moment by three methods, powers of the loads."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from tmm_report.chapters.lever.kinematics.quantities import where
from tmm_report.chapters.lever.kinematics.solve.analogues import time
from tmm_report.chapters.lever.kinematics.solve.points_and_links import along
from tmm_report.chapters.lever.kinetostatics.given import Carried, Towards
from tmm_report.chapters.lever.kinetostatics.quantities import cam_pressure as pressing_quantities
from tmm_report.chapters.lever.kinetostatics.quantities import cycle
from tmm_report.chapters.lever.kinetostatics.quantities import driving_gear as gear_quantities
from tmm_report.chapters.lever.kinetostatics.quantities import driving_stroke as stroke_quantities
from tmm_report.chapters.lever.kinetostatics.quantities import ties as tie_quantities
from tmm_report.chapters.lever.kinetostatics.quantities import twists as twist_quantities
from tmm_report.chapters.lever.kinetostatics.quantities import wheels as wheel_quantities
from tmm_report.chapters.lever.kinetostatics.quantities.cycle import Row
from tmm_report.chapters.lever.kinetostatics.quantities.driving_gear import ANGLE as ANGLE
from tmm_report.chapters.lever.kinetostatics.quantities.driving_gear import BASE_RADIUS as BASE_RADIUS
from tmm_report.chapters.lever.kinetostatics.quantities.driving_gear import FORCE as FORCE
from tmm_report.chapters.lever.kinetostatics.quantities.driving_gear import PITCH_RADIUS as PITCH_RADIUS
from tmm_report.chapters.lever.kinetostatics.quantities.strokes import strokes_table
from tmm_report.chapters.lever.kinetostatics.solve.acting_forces import loaded_link
from tmm_report.chapters.lever.kinetostatics.ties import End, Twist, apart
from tmm_report.mechanics.lever.assur_groups import Pair
from tmm_report.mechanics.lever.cycle import larger
from tmm_report.mechanics.lever.forces.reactions import Reaction
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Book, Column, Quantity, Table, Value, kept, text_column
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.tabulated import tabulated

if TYPE_CHECKING:  # the solver's own names are taken from here
    from tmm_report.chapters.lever.kinetostatics.given import Carried, Force, Loads, Moment
    from tmm_report.chapters.lever.kinetostatics.solve.positions import Kinetostatics, Solved
    from tmm_report.chapters.lever.kinetostatics.solve.whole_cycle import Over
    from tmm_report.chapters.lever.kinetostatics.solve.works import Work, Works

Array = Any

GIVEN = Message(N_("the stated loads: what they act on and their directions"))
STATED = Message(N_("the stated loads along their stated directions; negative: against them"))
LOADS = Message(N_("loads: weights, inertia forces and couples, stated forces and moments"))
LOADS_AT = Message(N_("loads at the instants asked for"))
REACTIONS_AT = Message(N_("reactions at the instants asked for"))
BALANCING_AT = Message(N_("balancing moment at the instants asked for"))
REACTIONS = Message(N_("reactions in all pairs"))
BALANCING = Message(N_("balancing moment by groups, by Zhukovsky's lever and by power balance"))
POWERS = Message(N_("powers of the loads"))

M_BAL = Symbol("M", "bal")
BALANCING_MOMENT = Quantity("M_bal", M_BAL, "N·m", Message(N_("balancing moment on the driving link")))
BY_LEVER = stroke_quantities.by_lever(BALANCING_MOMENT, "M_lever")
BY_POWER = stroke_quantities.by_power(BALANCING_MOMENT, "M_power")
ALONG_STROKE = stroke_quantities.FORCE
LEVER_MISS = Quantity("lever_disagreement", None, "", Message(N_("relative disagreement of the lever")))
POWER_MISS = Quantity(
    "power_disagreement", None, "", Message(N_("relative disagreement of the power balance"))
)
TOTAL_POWER = Quantity("N_sum", Symbol("SigmaN"), "W", Message(N_("sum of the powers of all loads")))


# ---------------------------------------------------------------- loads


@kept
def weight(link: str) -> Quantity:
    return Quantity(f"G_{link}", Symbol("G", link), "N", Message(N_("weight of link %(of)s"), {"of": link}))


@kept
def inertia_force(link: str) -> Quantity:
    meaning = Message(N_("inertia force of link %(of)s"), {"of": link})
    return Quantity(f"F_I{link}", Symbol("F", f"I{link}"), "N", meaning)


@kept
def inertia_couple(link: str) -> Quantity:
    meaning = Message(N_("inertia couple of link %(of)s"), {"of": link})
    return Quantity(f"M_I{link}", Symbol("M", f"I{link}"), "N·m", meaning)


def names(given: Sequence[Force | Moment]) -> list[str]:
    """As they are stated; of a load without a name F1, F2, … or M1, M2, … by its order."""
    return [load.name or f"{load.LETTER}{k}" for k, load in enumerate(given, 1)]


def forces(given: Sequence[Force]) -> list[Quantity]:
    """The stated forces in their order: P_B; several at one point are numbered, P_B,1, P_B,2. Then those of springs and
    dampers on their points: F_c1,B."""
    at = [force.at for force in given if not isinstance(force, End)]
    own = [_force(at[k], name, _numbered(at, k)) for k, name in enumerate(names(given)[: len(at)])]
    return [*own, *(tie_quantities.at_end(force) for force in given if isinstance(force, End))]


def stated_loads(given: Loads) -> list[Quantity]:
    """What has one power each: the stated forces, the springs and dampers with both their ends, the stated moments."""
    own = forces(given.forces)
    tied = (tie_quantities.force(given.forces[ends[0]]) for ends in apart(given.forces)[1])  # type: ignore[arg-type]
    return [*own[: len(apart(given.forces)[0])], *tied, *moments(given.moments)]


@kept
def _force(at: str, name: str, index: str) -> Quantity:
    meaning = Message(N_("%(name)s on point %(at)s"), {"at": at, "name": name})
    return Quantity(f"P_{index}", Symbol("P", index), "N", meaning)


def moments(given: Sequence[Moment]) -> list[Quantity]:
    """The stated moments in their order: M_3; several on one link are numbered in the symbol, M_3,1, M_3,2. Then those
    of torsion springs on their links: M_k1,3."""
    on = [moment.on for moment in given if not isinstance(moment, Twist)]
    own = [
        _moment(link, name, k, link if on.count(link) == 1 else f"{link},{k}")
        for k, (link, name) in enumerate(zip(on, names(given), strict=False), 1)
    ]
    return [*own, *(twist_quantities.at_end(one) for one in given if isinstance(one, Twist))]


@kept
def _moment(on: str, name: str, k: int, index: str) -> Quantity:
    meaning = Message(N_("moment on link %(on)s: %(name)s"), {"on": on, "name": name})
    return Quantity(f"M_{on},{k}", Symbol("M", index), "N·m", meaning)


def _numbered(names: Sequence[str], k: int) -> str:
    name = names[k]
    return name if names.count(name) == 1 else f"{name},{names[: k + 1].count(name)}"


# ---------------------------------------------------------------- reactions

PARTS = {
    "x": N_("projection of the reaction of link %(one)s on link %(other)s on the x axis"),
    "y": N_("projection of the reaction of link %(one)s on link %(other)s on the y axis"),
    "t": N_("tangential component of the reaction of link %(one)s on link %(other)s"),
    "n": N_("normal component of the reaction of link %(one)s on link %(other)s"),
}


def both(by: str, on: str) -> str:
    """The index of what link `by` does to link `on`: 12; longer names are told apart by a comma."""
    return f"{by}{on}" if len(by) == len(on) == 1 else f"{by},{on}"


@kept
def reaction(by: str, on: str) -> Quantity:
    """Force of link `by` on link `on`."""
    meaning = Message(N_("reaction of link %(one)s on link %(other)s"), {"one": by, "other": on})
    return Quantity(f"R_{both(by, on)}", Symbol("R", both(by, on)), "N", meaning)


@kept
def reaction_part(by: str, on: str, part: str) -> Quantity:
    """Its projection "x", "y" or its tangential or normal component "t", "n"."""
    meaning = Message(PARTS[part], {"one": by, "other": on})
    return Quantity(f"R_{both(by, on)}_{part}", Symbol("R", both(by, on), part), "N", meaning)


@kept
def reaction_angle(by: str, on: str) -> Quantity:
    meaning = Message(
        N_("angle of the reaction of link %(one)s on link %(other)s with the x axis"),
        {"one": by, "other": on},
    )
    return Quantity(f"alpha_{both(by, on)}", Symbol("alpha", both(by, on)), "deg", meaning)


@kept
def guide_moment(by: str, on: str) -> Quantity:
    meaning = Message(
        N_("moment of the reaction of link %(one)s on link %(other)s in their guide"),
        {"one": by, "other": on},
    )
    return Quantity(f"M_{both(by, on)}", Symbol("M", both(by, on)), "N·m", meaning)


@kept
def guide_offset(by: str, on: str, guide: str) -> Quantity:
    meaning = Message(
        N_("where the reaction acts along guide %(pair)s, from the slider's point"), {"pair": guide}
    )
    return Quantity(f"x_{both(by, on)}", Symbol("x", both(by, on)), "m", meaning)


# ---------------------------------------------------------------- tables


def book(found: Kinetostatics) -> Book:
    """All that the chapter says in numbers."""
    return Book.of(tables(found), values(found))


@tabulated
def tables(found: Kinetostatics) -> Iterator[Table]:
    given, law = found.given, found.kinematics.by_law
    table, diagram = (where(solved.turned, law) for solved in (found.table, found.diagram))
    if apart(given.forces)[0] or given.moments:
        yield _stated(found)
        yield Table("stated_table", STATED, (*table, *_along(found, found.table)))
    yield from tie_quantities.tables(found)
    yield from twist_quantities.tables(found)
    yield from strokes_table(found, [force.key for force in forces(given.forces)])
    if found.followed:
        yield Table("stated_diagram", STATED, (*diagram, *_along(found, found.diagram)))
    yield Table("powers_table", POWERS, (*table, *_powers(found, found.table)))
    for name, solved, at in (("table", found.table, table), ("diagram", found.diagram, diagram)):
        yield Table(f"loads_{name}", LOADS, (*at, *_loads(found, solved)))
        yield Table(f"reactions_{name}", REACTIONS, (*at, *_reactions(solved)))
        yield Table(f"balancing_{name}", BALANCING, (*at, *_balancing(solved)))
    if found.asked is not None:
        yield from _at_instants(found, found.asked)
    yield from gear_quantities.tables(found)
    yield from stroke_quantities.tables(found)
    yield from pressing_quantities.tables(found, found.pressings)
    yield from wheel_quantities.tables(found)
    if found.over is not None:
        yield cycle.extremes_table(peaks_of(found.over))
    if found.works is not None:
        yield from cycle.works_tables(found.works, named_works(found, found.works))


def _at_instants(found: Kinetostatics, solved: Solved) -> Iterator[Table]:
    """Loads, reactions and the balancing moment at the instants that the variant asks for."""
    kinematics = found.kinematics
    where_ = (along(kinematics.by_law).column(np.degrees(solved.turned)), time(kinematics, solved.turned))
    for name, meaning, columns in (
        ("loads_at", LOADS_AT, _loads(found, solved)),
        ("reactions_at", REACTIONS_AT, _reactions(solved)),
        ("balancing_at", BALANCING_AT, _balancing(solved)),
    ):
        yield Table(name, meaning, (*where_, *(replace(one, asked=False) for one in columns)))


def _stated(found: Kinetostatics) -> Table:
    """One row a load: forces, then moments."""
    given, motion = found.given, found.table.motion
    own = apart(given.forces)[0]
    stated = zip(forces(own), names(own), own, strict=True)
    turning = zip(moments(given.moments), names(given.moments), given.moments, strict=True)
    rows = [(q.key, name, f.at, loaded_link(motion, f), _way(f.way)) for q, name, f in stated]
    rows += [(q.key, name, m.on, m.on, _way(m.direction)) for q, name, m in turning]
    texts = (
        ("key", N_("load")),
        ("name", N_("its name")),
        ("on", N_("point or link on which it acts")),
        ("link", N_("link that takes it")),
        (
            "direction",
            N_(
                "direction of a force, degrees from the x axis; sense of a moment; along or against the motion"
            ),
        ),
    )
    columns = (
        text_column(key, Message(text), [row[i] for row in rows]) for i, (key, text) in enumerate(texts)
    )
    return Table("loads_given", GIVEN, tuple(columns))


def _along(found: Kinetostatics, solved: Solved) -> Iterator[Column]:
    quantities = [*forces(found.given.forces), *moments(found.given.moments)]
    tied = {k for own in apart(found.given.forces)[1] for k in own}
    for k, (quantity, values) in enumerate(zip(quantities, solved.loading.stated, strict=True)):
        if k not in tied:
            yield quantity.column(values)


def _way(direction: complex | int | str | Carried | Towards) -> str:
    """A direction as a text: "along", "against", degrees, "counter-clockwise" or "clockwise"; of one that a link
    carries its name before the degrees."""
    match direction:
        case Carried(link=link, angle=angle):
            return f"{link}: {math.degrees(angle):.10g}"
        case Towards(point=point):
            return point
        case str():
            return direction
        case int():
            return "counter-clockwise" if direction > 0 else "clockwise"
        case _:
            return f"{math.degrees(math.atan2(direction.imag, direction.real)):.10g}"


def _loads(found: Kinetostatics, solved: Solved) -> Iterator[Column]:
    load, given = solved.loading, found.given
    for link, force in load.gravity.items():
        yield from weight(link).vector(force)
    for link, force in load.inertia.items():
        yield from inertia_force(link).vector(force)
    for link, couple in load.couples.items():
        yield inertia_couple(link).column(couple)
    for quantity, force in zip(forces(given.forces), load.forces, strict=True):
        yield from quantity.vector(force)
    for quantity, couple in zip(moments(given.moments), load.moments, strict=True):
        yield quantity.column(couple)


def _reactions(solved: Solved) -> Iterator[Column]:
    shape = solved.motion.shape
    for found in solved.statics.reactions.values():
        force = np.broadcast_to(found.force, shape)
        yield from reaction(*found.pair.links).vector(force)
        yield reaction_angle(*found.pair.links).column(_angle(force))
        if found.pair.kind == "P":
            yield from _in_guide(found, shape)


def _angle(force: Array) -> Array:
    """Degrees from the x axis, 0 … 360; none where there is no force."""
    none = np.abs(force) <= 1e-9 * np.nanmax(np.abs(force))
    return np.where(none, np.nan, np.degrees(np.angle(force)) % 360)


def _in_guide(found: Reaction, shape: tuple[int, ...]) -> Iterator[Column]:
    pair: Pair = found.pair
    full = replace(found, moment=np.broadcast_to(found.moment, shape))
    yield guide_moment(*pair.links).column(full.moment)
    yield guide_offset(*pair.links, pair.name).column(np.broadcast_to(full.offset, shape))


def _balancing(solved: Solved) -> Iterator[Column]:
    yield BALANCING_MOMENT.column(solved.balancing)
    yield BY_LEVER.column(solved.lever)
    yield BY_POWER.column(solved.power)
    yield LEVER_MISS.column(solved.disagreement(solved.lever))
    yield POWER_MISS.column(solved.disagreement(solved.power))


# ---------------------------------------------------------------- the whole cycle


def peaks_of(over: Over) -> list[Row]:
    """Of the balancing moment, of every reaction, its projections and, in a guide, its moment."""
    rows = [Row(BALANCING_MOMENT, over.moment)]
    for key, size in over.sizes.items():
        by, on = over.statics.reactions[key].pair.links
        of = reaction(by, on)
        rows += [Row(of, size), *map(Row, of.components, over.components[key])]
        if key in over.couples:
            rows.append(Row(guide_moment(by, on), over.couples[key]))
    return rows


def named_works(found: Kinetostatics, of: Works) -> list[tuple[Quantity, Work]]:
    """The balancing moment, the stated forces, springs and dampers, moments, the weights."""
    return [
        (BALANCING_MOMENT, of.balancing),
        *zip(stated_loads(found.given), of.stated, strict=True),
        *((weight(link), work) for link, work in of.weights.items()),
    ]


# ---------------------------------------------------------------- powers


def loads_of_powers(found: Kinetostatics) -> list[tuple[Quantity, ...]]:
    """The loads of each row of `solve.lever_terms`, in its order; weight and inertia force of a link stand together."""
    load, given = found.table.loading, found.given
    return [
        *((inertia_force(link), weight(link)) for link in load.inertia),
        *((force,) for force in forces(given.forces)),
        *((inertia_couple(link),) for link in load.couples),
        *((moment,) for moment in moments(given.moments)),
    ]


def power(loads: tuple[Quantity, ...]) -> Quantity:
    """Power of a load, or of both forces at a mass centre."""
    key = "+".join(load.key for load in loads)
    meaning: Message = Message(N_("power of: %(load)s"), {"load": loads[0].meaning})
    if len(loads) > 1:
        both_of = {"one": loads[0].meaning, "other": loads[1].meaning}
        meaning = Message(N_("power of: %(one)s, %(other)s"), both_of)
    return Quantity(f"N_{key}", None, "W", meaning)


def _powers(found: Kinetostatics, solved: Solved) -> Iterator[Column]:
    rows = loads_of_powers(found)
    for loads, values in zip(rows, solved.powers, strict=False):
        yield power(loads).column(values)
    yield TOTAL_POWER.column(np.sum(solved.powers, axis=0))


# ---------------------------------------------------------------- single numbers


@tabulated
def values(found: Kinetostatics) -> Iterator[Value]:
    yield from extremes(found)
    yield from gear_quantities.values(found)
    yield from stroke_quantities.values(found)
    yield from pressing_quantities.values(found.pressings)
    yield from wheel_quantities.values(found)
    if found.works is not None:
        yield from cycle.works_values(found.works)
    worst = Message(N_("worst relative disagreement of the lever"))
    yield replace(LEVER_MISS, meaning=worst).value(found.worst_lever)
    worst = Message(N_("worst relative disagreement of the power balance"))
    yield replace(POWER_MISS, meaning=worst).value(found.worst_power)


def headline(found: Kinetostatics) -> Iterator[Value]:
    """The greatest balancing moment; where a stroke drives, the greatest force along it."""
    if found.kinematics.stroke is None and found.bounded:
        most, meaning = larger(found.extremes), Message(N_("greatest balancing moment by size"))
        yield Quantity("M_bal_most", M_BAL, "N·m", meaning).value(abs(most.value), most.turned)
    elif found.kinematics.stroke is not None:
        least, greatest = stroke_quantities.values(found)
        yield max(least, greatest, key=lambda one: abs(one.value))


def extremes(found: Kinetostatics) -> tuple[Value, Value]:
    """Least and greatest balancing moment."""
    low, high = found.extremes
    least = Quantity("M_bal_min", M_BAL, "N·m", Message(N_("least balancing moment")))
    greatest = Quantity("M_bal_max", M_BAL, "N·m", Message(N_("greatest balancing moment")))
    return least.value(low.value, low.turned), greatest.value(high.value, high.turned)
