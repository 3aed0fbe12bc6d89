"""Tables and values of the lever mechanism's chapters."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from tmm_report.chapters.kinematics.solve import Kinematics, Travel, digits_left
from tmm_report.chapters.kinetostatics.solve import Solved
from tmm_report.course import LeverFound
from tmm_report.mechanics.motion import Linkage, Motion
from tmm_report.mechanics.relations import moving_points, relations, turning_links
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Table, Value, plain, plain_value
from tmm_report.quantity.written import load_keys, reaction_key, unit_of

Array = Any


def tables(results: LeverFound) -> list[Table]:
    """All tables of the lever mechanism."""
    k = results.kinematics
    sets = (
        ("table", k.table, k.turned, k.values),
        ("diagram", k.diagram, k.diagram_turned, k.diagram_values),
    )
    found = []
    for name, motion, turned, rates in sets:
        where = _where(turned)
        found.append(Table(f"outputs_{name}", OUTPUTS, (*where, *_outputs(k.travels, name))))
        found.append(Table(f"positions_{name}", PLACES, (*where, *_places(motion))))
        found.append(Table(f"rates_{name}", RATES, (*where, *_rates(k.linkage, rates))))
    found.append(Table("special", SPECIAL, _special(k)))
    found += [_comparison(f"comparison_{d.position}", COMPARISON, d.comparison) for d in results.plans.drawn]
    found += [
        _comparison(f"readings_{d.position}", READINGS, d.readings) for d in results.plans.drawn if d.readings
    ]
    return found + list(_force_tables(results)) + list(_friction_tables(results))


OUTPUTS = Message(N_("displacement, velocity and acceleration of the output links"))
PLACES = Message(N_("places of points, angles of links, nearness of singular positions"))
CLOSENESS = N_("closeness of group %(group)s to a singular position, 1 … 0 (of a dyad, a sine)")
SPECIAL = Message(N_("positions nearest to singular ones, singular positions, dead points"))
RATES = Message(N_("velocities, accelerations and angular rates"))
COMPARISON = Message(N_("graph-analytical method against the analytical one"))
READINGS = Message(N_("the student's own readings against the analytical method"))
LOADS = Message(N_("loads: weights, inertia forces and couples, stated forces and moments"))
REACTIONS = Message(N_("reactions in all pairs"))
BALANCING = Message(N_("balancing moment by groups, by Zhukovsky's lever and by power balance"))
FRICTION = Message(N_("friction power and instantaneous efficiency"))


def _where(turned: Array) -> list[Column]:
    number = Message(N_("number of the position"))
    angle = Message(N_("angle turned by the driving link from position 0"))
    return [
        plain("position", "", number, list(range(len(turned)))),
        plain("phi", "deg", angle, np.degrees(turned)),
    ]


def _vector(key: str, unit: str, meaning: Message, vector: Array) -> Iterator[Column]:
    """Magnitude and components of a vector."""
    yield plain(key, unit, meaning, np.abs(vector))
    yield plain(f"{key}_x", unit, Message(N_("%(of)s, x component"), {"of": meaning}), np.real(vector))
    yield plain(f"{key}_y", unit, Message(N_("%(of)s, y component"), {"of": meaning}), np.imag(vector))


def _outputs(travels: Iterable[Travel], name: str) -> Iterator[Column]:
    for travel in travels:
        slider = travel.output.kind == "slider"
        of = {"name": travel.output.name}
        texts = SLIDER if slider else ROCKER
        rows = (
            (travel.S, travel.V, travel.a)
            if name == "table"
            else (travel.diagram_S, travel.diagram_V, travel.diagram_a)
        )
        for (base, unit, text), row in zip(texts, rows, strict=True):
            yield plain(f"{base}_{travel.output.name}", unit, Message(text, of), row)


SLIDER = (
    ("S", "m", N_("displacement of slider %(name)s from position 0")),
    ("V", "m/s", N_("velocity of slider %(name)s")),
    ("A", "m/s²", N_("acceleration of slider %(name)s")),
)
ROCKER = (
    ("psi", "rad", N_("angle of link %(name)s from position 0")),
    ("omega", "rad/s", N_("angular velocity of link %(name)s")),
    ("epsilon", "rad/s²", N_("angular acceleration of link %(name)s")),
)


def _places(motion: Motion) -> Iterator[Column]:
    for point in moving_points(motion.linkage):
        of = {"name": point}
        yield plain(f"x_{point}", "m", Message(N_("x of point %(name)s"), of), motion.place(point).real)
        yield plain(f"y_{point}", "m", Message(N_("y of point %(name)s"), of), motion.place(point).imag)
    for link in turning_links(motion.linkage):
        text = Message(N_("angle of link %(name)s from the x axis"), {"name": link})
        yield plain(f"phi_{link}", "deg", text, np.degrees(np.angle(motion.turn(link))))
    for label, sine in motion.sines.items():
        of = {"group": label}
        yield plain(f"sin_{label}", "", Message(CLOSENESS, of), sine)
        text = Message(N_("decimal digits that remain in group %(group)s"), of)
        yield plain(f"digits_{label}", "", text, digits_left(sine))


def _rates(linkage: Linkage, rates: Mapping[str, Array]) -> Iterator[Column]:
    meaning = meanings(linkage)
    for key, values in rates.items():
        if np.iscomplexobj(values):
            yield from _vector(key, unit_of(key), meaning[key], values)
        else:
            yield plain(key, unit_of(key), meaning[key], values)


def meanings(linkage: Linkage) -> dict[str, Message]:
    """What each key of `relations.named_values` means."""
    texts: dict[str, Message] = {}
    for point in moving_points(linkage):
        texts[f"v_{point}"] = Message(N_("velocity of point %(name)s"), {"name": point})
        texts[f"a_{point}"] = Message(N_("acceleration of point %(name)s"), {"name": point})
    for r in relations(linkage):
        for branch in r.branches:
            for point in (p for p in (branch.start, branch.end) if p is not None):
                texts.setdefault(f"v_{point}", Message(N_("velocity of point %(name)s"), {"name": point}))
                texts.setdefault(f"a_{point}", Message(N_("acceleration of point %(name)s"), {"name": point}))
            about = branch.start or (branch.arm[0] if branch.arm else branch.guide)
            pair = {"name": branch.end, "about": about}
            texts.setdefault(branch.v_key, Message(N_("velocity of %(name)s relative to %(about)s"), pair))
            if branch.turns:
                texts[branch.a_key("n")] = Message(
                    N_("normal acceleration of %(name)s relative to %(about)s"), pair
                )
                texts[branch.a_key("t")] = Message(
                    N_("tangential acceleration of %(name)s relative to %(about)s"), pair
                )
            elif branch.has_bend:
                texts[branch.a_key("k")] = Message(
                    N_("Coriolis acceleration of %(name)s relative to %(about)s"), pair
                )
            relative = Message(N_("relative acceleration of %(name)s along %(about)s"), pair)
            texts.setdefault(branch.a_key("r"), relative)
    for link in turning_links(linkage):
        texts[f"w_{link}"] = Message(N_("angular velocity of link %(name)s"), {"name": link})
        texts[f"e_{link}"] = Message(N_("angular acceleration of link %(name)s"), {"name": link})
    return texts


def _special(k: Kinematics) -> tuple[Column, ...]:
    """Exact angles of turn at which something is singular: one row each."""
    rows: list[tuple[str, str, float, float]] = []
    for c in k.closest:
        rows.append(("closest", c.group, c.closeness.turned, c.closeness.value))
        for kind in ("changes", "limits", "parallel"):
            rows += [(SPECIAL_KINDS[kind], c.group, turned, 0.0) for turned in getattr(c, kind)]
    rows += [("dead", dead.output, turned, math.nan) for dead in k.dead for turned in dead.turned]
    kinds, of, turned, closeness = ([row[i] for row in rows] for i in range(4))
    return (
        plain("kind", "", Message(N_("closest, change, limit, parallel (guides) or dead (point)")), kinds),
        plain("of", "", Message(N_("the group, or the output link")), of),
        plain(
            "phi", "deg", Message(N_("angle turned by the driving link from position 0")), np.degrees(turned)
        ),
        plain("closeness", "", Message(N_("closeness to a singular position, 1 … 0")), closeness),
    )


SPECIAL_KINDS = {"changes": "change", "limits": "limit", "parallel": "parallel"}


def _comparison(
    name: str, meaning: Message, rows: Sequence[Any], unit: Callable[[str], str] = unit_of
) -> Table:
    deltas = [math.nan if row.delta is None else row.delta for row in rows]
    columns = (
        plain("key", "", Message(N_("the value compared")), [row.key for row in rows]),
        plain("unit", "", Message(N_("its unit")), [unit(row.key) for row in rows]),
        plain("graph", "", Message(N_("read off the plan")), [row.graph for row in rows]),
        plain("analytic", "", Message(N_("analytical")), [row.analytic for row in rows]),
        plain("delta", "%", Message(N_("difference; empty where both are zero within the reading")), deltas),
    )
    return Table(name, meaning, columns)


def _force_tables(results: LeverFound) -> Iterator[Table]:
    found = results.kinetostatics
    if found is None:
        return
    for name, solved in (("table", found.table), ("diagram", found.diagram)):
        where = _where(solved.turned)
        yield Table(f"loads_{name}", LOADS, (*where, *_loads(results, solved)))
        yield Table(f"reactions_{name}", REACTIONS, (*where, *_reactions(solved)))
        yield Table(f"balancing_{name}", BALANCING, (*where, *_balancing(solved)))
    if results.force_plans is not None:
        for drawn in results.force_plans.drawn:
            yield _comparison(f"force_comparison_{drawn.position}", COMPARISON, drawn.comparison)


def _loads(results: LeverFound, solved: Solved) -> Iterator[Column]:
    assert results.kinetostatics is not None
    load, given = solved.loading, results.kinetostatics.given
    for link, force in load.gravity.items():
        yield from _vector(f"G_{link}", "N", Message(N_("weight of link %(name)s"), {"name": link}), force)
    for link, force in load.inertia.items():
        yield from _vector(
            f"F_I{link}", "N", Message(N_("inertia force of link %(name)s"), {"name": link}), force
        )
    for link, couple in load.couples.items():
        yield plain(
            f"M_I{link}", "N·m", Message(N_("inertia couple of link %(name)s"), {"name": link}), couple
        )
    keys = load_keys([force.at for force in given.forces])
    for stated, key, force in zip(given.forces, keys, load.forces, strict=True):
        text = Message(N_("force on point %(at)s: %(name)s"), {"at": stated.at, "name": stated.name})
        yield from _vector(key, "N", text, force)
    for i, (on, couple) in enumerate(zip(given.moments, load.moments, strict=True), 1):
        text = Message(N_("moment on link %(on)s: %(name)s"), {"on": on.on, "name": on.name})
        yield plain(f"M_{on.on},{i}", "N·m", text, couple)


def _reactions(solved: Solved) -> Iterator[Column]:
    shape = solved.motion.shape
    for reaction in solved.statics.reactions.values():
        by, on = reaction.pair.links
        text = Message(
            N_("force of link %(by)s on link %(on)s in pair %(pair)s"),
            {"by": by, "on": on, "pair": reaction.pair.name},
        )
        yield from _vector(reaction_key(by, on), "N", text, np.broadcast_to(reaction.force, shape))
        if reaction.pair.kind == "P":
            of = {"pair": reaction.pair.name}
            moment = np.broadcast_to(reaction.moment, shape)
            key = reaction_key(by, on).replace("R", "M", 1)
            yield plain(
                key,
                "N·m",
                Message(N_("moment of the reaction in guide %(pair)s about the slider's point"), of),
                moment,
            )
            text = Message(N_("where the reaction acts along guide %(pair)s, from the slider's point"), of)
            offset = np.broadcast_to(reaction.offset, shape)
            yield plain(key.replace("M", "x", 1), "m", text, offset)


def _balancing(solved: Solved) -> Iterator[Column]:
    yield plain("M_bal", "N·m", Message(N_("balancing moment, by groups")), solved.balancing)
    yield plain("M_lever", "N·m", Message(N_("balancing moment by Zhukovsky's lever")), solved.lever)
    yield plain("M_power", "N·m", Message(N_("balancing moment by the power balance")), solved.power)
    text = Message(N_("relative disagreement of the lever"))
    yield plain("lever_disagreement", "", text, solved.disagreement(solved.lever))
    text = Message(N_("relative disagreement of the power balance"))
    yield plain("power_disagreement", "", text, solved.disagreement(solved.power))


def _friction_tables(results: LeverFound) -> Iterator[Table]:
    if results.friction is None or results.kinetostatics is None:
        return
    sets = (
        ("table", results.friction.table, results.kinetostatics.table),
        ("diagram", results.friction.diagram, results.kinetostatics.diagram),
    )
    for name, losses, solved in sets:
        columns = []
        for loss in losses.pairs:
            text = Message(
                N_("friction power in pair %(pair)s of links %(links)s"),
                {"pair": loss.pair.name, "links": loss.pair.key},
            )
            columns.append(plain(f"P_fr_{loss.pair.key}", "W", text, loss.power))
        columns.append(plain("P_fr", "W", Message(N_("friction power of all pairs")), losses.total))
        columns.append(
            plain("P_drive", "W", Message(N_("power of the balancing moment, magnitude")), losses.driving)
        )
        columns.append(plain("eta", "", Message(N_("instantaneous efficiency")), losses.efficiency))
        yield Table(f"friction_{name}", FRICTION, (*_where(solved.turned), *columns))


def values(results: LeverFound) -> list[Value]:
    """The single numbers of the lever mechanism."""
    s, k, p = results.structure, results.kinematics, results.plans
    found = [
        plain_value("n", s.moving_links, "", Message(N_("number of moving links"))),
        plain_value("p5", s.lower_pairs, "", Message(N_("number of lower pairs"))),
        plain_value("p4", s.higher_pairs, "", Message(N_("number of higher pairs"))),
        plain_value("W", s.mobility, "", Message(N_("mobility"))),
        plain_value("class", s.mechanism_class, "", Message(N_("class of the mechanism"))),
        plain_value("omega", k.omega, "rad/s", Message(N_("angular velocity of the driving link"))),
        plain_value(
            "phi_0", math.degrees(k.cycle.zero), "deg", Message(N_("angle of the driving link in position 0"))
        ),
        plain_value("mu_l", p.length_scale, "m/mm", Message(N_("scale of the scheme"))),
        plain_value("mu_v", p.velocity_scale, "(m/s)/mm", Message(N_("scale of the velocity plans"))),
        plain_value(
            "mu_a", p.acceleration_scale, "(m/s²)/mm", Message(N_("scale of the acceleration plans"))
        ),
        plain_value(
            "delta_max", p.worst, "%", Message(N_("largest difference of plans from the analytical method"))
        ),
    ]
    for travel in k.travels:
        found += _travel_values(travel)
    return found + list(_force_values(results))


def _travel_values(travel: Travel) -> Iterator[Value]:
    slider = travel.output.kind == "slider"
    name, of = travel.output.name, {"name": travel.output.name}
    units = ("m", "m/s", "m/s²") if slider else ("rad", "rad/s", "rad/s²")
    stroke = N_("stroke of slider %(name)s") if slider else N_("swing of link %(name)s")
    yield plain_value(f"H_{name}", travel.stroke, units[0], Message(stroke, of))
    if travel.time_ratio is not None:
        yield plain_value(
            f"K_{name}", travel.time_ratio, "", Message(N_("time ratio of the strokes of %(name)s"), of)
        )
    ends = ((travel.near, travel.far), travel.V_extremes, travel.a_extremes)
    texts = (
        (N_("least displacement of %(name)s"), N_("greatest displacement of %(name)s")),
        (N_("least velocity of %(name)s"), N_("greatest velocity of %(name)s")),
        (N_("least acceleration of %(name)s"), N_("greatest acceleration of %(name)s")),
    )
    for base, unit, pair, (low, high) in zip("SVA", units, ends, texts, strict=True):
        yield plain_value(f"{base}_{name}_min", pair[0].value, unit, Message(low, of), pair[0].turned)
        yield plain_value(f"{base}_{name}_max", pair[1].value, unit, Message(high, of), pair[1].turned)


def _force_values(results: LeverFound) -> Iterator[Value]:
    found = results.kinetostatics
    if found is not None:
        low, high = found.extremes
        yield plain_value("M_bal_min", low.value, "N·m", Message(N_("least balancing moment")), low.turned)
        yield plain_value(
            "M_bal_max", high.value, "N·m", Message(N_("greatest balancing moment")), high.turned
        )
        yield plain_value(
            "lever_disagreement",
            found.worst_lever,
            "",
            Message(N_("worst relative disagreement of the lever")),
        )
        text = Message(N_("worst relative disagreement of the power balance"))
        yield plain_value("power_disagreement", found.worst_power, "", text)
    if results.force_plans is not None:
        text = Message(N_("largest difference of force plans from the analytical method"))
        yield plain_value("delta_F_max", results.force_plans.worst, "%", text)
    if results.friction is not None:
        yield plain_value("P_fr_mean", results.friction.mean_power, "W", Message(N_("mean friction power")))
        yield plain_value(
            "eta_mean", results.friction.mean_efficiency, "", Message(N_("efficiency over the cycle"))
        )
