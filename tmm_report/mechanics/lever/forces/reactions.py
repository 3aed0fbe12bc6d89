"""Kinetostatics: reactions in all pairs, group by group from the farthest, and the balancing moment.

Inertia forces are loads among others (d'Alembert). R12 is the force of link 1 on link 2. Arrays (..., P), SI.
Source: Artobolevsky, Theory of mechanisms and machines, ch. 13; Levitsky, ch. 7.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from tmm_report.mechanics.calculus.vectors import cross, dot, if_known, is_zero
from tmm_report.mechanics.lever.assur_groups import Pair
from tmm_report.mechanics.lever.driving.stroke import Stroke
from tmm_report.mechanics.lever.dyads import Dyad, State
from tmm_report.mechanics.lever.forces.tape.run import Run, Straight
from tmm_report.mechanics.lever.high_class.newton import HigherGroup
from tmm_report.mechanics.lever.loop_equations import solve_each
from tmm_report.mechanics.lever.mechanism import FRAME, Link
from tmm_report.mechanics.lever.motion import SINGULAR, Motion
from tmm_report.mechanics.lever.wheels.coupled import Coupled
from tmm_report.records import dataclass

Array = Any


@dataclass(frozen=True, eq=False)
class Reaction:
    """The reaction in a pair: `force` and `moment` of link `pair.links[0]` on `pair.links[1]`.

    Complex N and N m, (..., P). The force acts at `at` (world place): a pivot's centre, or the point of the sliding
    link that lies on the guide; there a guide also gives the moment.
    """

    pair: Pair
    force: Array
    moment: Array
    at: Array
    along: Array | None = None  # the guide's direction, world axes

    @property
    def offset(self) -> Array:
        """How far along the guide from `at` the normal force alone would act, m; nan where there is no force."""
        normal = cross(self.along, self.force)
        some = np.abs(normal) > 1e-9 * np.max(np.abs(normal), initial=0.0)
        with np.errstate(invalid="ignore", divide="ignore"):
            return np.where(some, self.moment / normal, np.nan)


@dataclass(frozen=True, eq=False)
class Load:
    """Everything that acts on one link, inertia included, reduced to its reference point `State.r`."""

    force: Array
    moment: Array


@dataclass(frozen=True, eq=False)
class Statics:
    """`reactions`: pair key "1-2" -> Reaction; `balancing`: moment on the driving link, N m, (..., P).

    `driving`: where a slider or a cylinder drives, the force along its stroke, N, that does the work of this moment in
    its place, else None; the reactions are those under the force."""

    reactions: Mapping[str, Reaction]
    balancing: Array
    driving: Array = None

    def force(self, on: str, by: str) -> Array:
        """Force of link `by` on link `on`, complex N."""
        if (r := self.reactions.get(f"{by}-{on}")) is not None:
            return r.force
        return -self.reactions[f"{on}-{by}"].force


def inertia_and_gravity(motion: Motion, gravity: complex) -> dict[str, Load]:
    """Gravity and d'Alembert's inertia force and couple of every moving link, about its reference point."""
    if isinstance(motion, Run) and motion.unaltered:
        return {name: Load(*load) for name, load in motion.inertia_and_gravity(gravity).items()}
    links = motion.linkage.mechanism.links
    return {name: _inertia_and_gravity(motion, links[name], gravity) for name in links if name != FRAME}


def _inertia_and_gravity(motion: Motion, link: Link, gravity: complex) -> Load:
    s = motion.state
    moment = 0.0 if is_zero(link.inertia) else -link.inertia * s.e[link.name]
    if link.mass_centre is None or is_zero(link.mass):
        return Load(0j, moment)
    force = link.mass * (gravity - motion.acceleration(link.mass_centre))
    arm = link.points[link.mass_centre] - s.o[link.name]
    return Load(force, moment if is_zero(arm) else moment + cross(s.u[link.name] * arm, force))


def solve(
    motion: Motion,
    loads: Mapping[str, Load],
    flank: Array | None = None,
    flanks: Mapping[str, Array] | None = None,
) -> Statics:
    """Reactions in every pair and the balancing moment under `loads` (link -> resultant), inertia among them. Where a
    gear turns the driving link, the reaction of the frame on it holds the force of the teeth too; `flank`: the one that
    is in contact, of loads that are but a part of the whole; `flanks`: those of the wheels, by the keys of their
    contacts."""
    if (stroke := motion.linkage.mechanism.driver.stroke) is not None:
        return _by_stroke(stroke, motion, loads, flanks)
    if isinstance(motion, Run) and motion.unaltered and (values := motion.forces(loads)):
        reactions, driver, pivot = _by_lines(motion.straight, values)
    else:
        reactions, rest = by_groups(motion, loads, flanks)
        link = motion.linkage.mechanism.driver.link
        driver, pivot = rest[link], motion.state.r[link]
    driven, pair = motion.linkage.mechanism.driver, motion.linkage.structure.driver_pair
    pushed = driven.gear.force(-driver.moment, driven.omega, flank) if driven.gear else 0.0
    reactions[pair.key] = Reaction(pair, -driver.force - pushed, 0.0, pivot)
    return Statics(reactions, -driver.moment)


def _by_stroke(
    stroke: Stroke, motion: Motion, loads: Mapping[str, Load], flanks: Mapping[str, Array] | None
) -> Statics:
    """Where a slider or a cylinder drives: F ds = M dφ, the moment being the one that would balance the link that
    turns; under the force nothing is left of it."""
    law = motion.linkage.mechanism.driver.law
    assert law is not None and motion.phase is not None
    s = stroke.law.of_phase(motion.phase)[0]
    moment = -by_groups(motion, loads, flanks)[1][stroke.link].moment
    force = moment * stroke.transfer(s)
    along = stroke.along(motion)
    loaded = dict(loads)
    for taken in stroke.takes:
        push, own = taken.sign * force * along, loaded[taken.link]
        arm = motion.place(taken.point) - motion.state.r[taken.link]
        loaded[taken.link] = Load(own.force + push, own.moment + cross(arm, push))
    reactions, rest = by_groups(motion, loaded, flanks)
    pair = motion.linkage.structure.driver_pair
    reactions[pair.key] = Reaction(pair, -rest[stroke.link].force, 0.0, motion.state.r[stroke.link])
    return Statics(reactions, moment, force)


def by_groups(
    motion: Motion, loads: Mapping[str, Load], flanks: Mapping[str, Array] | None = None
) -> tuple[dict[str, Reaction], dict[str, Load]]:
    """Reactions in every pair of the groups, and the loads that are left on the links they hang on."""
    s, rest = motion.state, dict(loads)
    reactions: dict[str, Reaction] = {}
    with np.errstate(invalid="ignore", divide="ignore"):
        for group in reversed(motion.linkage.groups):
            _by_wheels(s, group.group.wheels, rest, reactions, flanks or {})
            outer, inner = _solve_group(s, group, rest)
            if (lost := motion.sines[group.group.label] <= SINGULAR).any():
                outer, inner = ([_undefined(r, lost) for r in part] for part in (outer, inner))
            for reaction in outer:
                _pass_on(s, rest, reaction)
            reactions |= {r.pair.key: r for r in (*outer, *inner)}
        _by_wheels(s, motion.linkage.structure.wheels, rest, reactions, flanks or {})
    return reactions, rest


def _by_wheels(
    s: State,
    wheels: Sequence[Coupled],
    rest: dict[str, Load],
    reactions: dict[str, Reaction],
    flanks: Mapping[str, Array],
) -> None:
    """Reactions of links that meshes move, from the last one on; the teeth load the links that move them."""
    for wheel in reversed(wheels):
        load, own = rest[wheel.link], wheel.bearing
        teeth, force, moment = wheel.held(s, load.force, load.moment, flanks.get(wheel.contact.key))
        contact = Reaction(wheel.contact, teeth, 0.0, wheel.mesh.touches(s))
        bearing = Reaction(own, force, moment, s.r[wheel.link], _guide(s, own))
        _pass_on(s, rest, contact)
        _pass_on(s, rest, bearing)
        reactions |= {contact.pair.key: contact, own.key: bearing}


def _by_lines(lines: Straight, v: list[Any]) -> tuple[dict[str, Reaction], Load, Array]:
    """The same by the straight lines of a compiled linkage, the load left on the driving link, and its pivot."""
    reactions = {
        key: Reaction(pair, v[force], v[moment], v[at], v[along])
        for key, (pair, force, moment, at, along) in lines.reactions.items()
    }
    force, moment, pivot = (v[n] for n in lines.driven)
    return reactions, Load(force, moment), pivot


def _solve_group(
    s: State, group: Dyad | HigherGroup, loads: Mapping[str, Load]
) -> tuple[list[Reaction], list[Reaction]]:
    """Outer and inner reactions of a group under the loads of its links."""
    if isinstance(group, Dyad):
        outer_a, outer_b, inner = _solve_dyad(s, group, loads[group.a], loads[group.b])
        return [outer_a, outer_b], [inner]
    return _solve_higher(s, group, loads)


def _undefined(reaction: Reaction, lost: Array) -> Reaction:
    """In a singular position a reaction grows without bound: nan, never a number made of rounding errors."""
    moment = reaction.moment if is_zero(reaction.moment) else if_known(~lost, reaction.moment)
    return replace(reaction, force=if_known(~lost, reaction.force), moment=moment)


def _pass_on(s: State, rest: dict[str, Load], reaction: Reaction) -> None:
    """A solved group loads the link it hangs on with its outer reaction, turned round."""
    carrier = reaction.pair.links[0]
    if carrier != FRAME:
        load = rest[carrier]
        moment = cross(reaction.at - s.r[carrier], reaction.force)
        if reaction.pair.kind == "P":
            moment = moment + reaction.moment
        rest[carrier] = Load(load.force - reaction.force, load.moment - moment)


def _solve_dyad(s: State, d: Dyad, load_a: Load, load_b: Load) -> tuple[Reaction, Reaction, Reaction]:
    """Outer reactions on a and on b, and the inner one, of a dyad under the loads of its links."""
    total = load_a.force + load_b.force
    at_a, at_b, at_i = (_acts_at(s, pair) for pair in (d.outer_a, d.outer_b, d.inner))
    (f1, c1), (f2, c2) = _conditions(s, d, load_a, load_b, total, at_i)
    on_a = (c2 * f1 - c1 * f2) / cross(f1, f2)
    on_b, inner = -(total + on_a), -(load_a.force + on_a)  # inner: of b on a
    m_a: Array = 0.0
    m_b: Array = 0.0
    m_i: Array = 0.0
    if d.inner.kind == "P":  # link a about its outer joint
        m_i = -load_a.moment - _moment(inner, at_i, at_a)
    if d.outer_a.kind == "P":  # link a about its inner joint
        m_a = -load_a.moment - _moment(on_a, at_a, at_i)
    if d.outer_b.kind == "P":
        m_b = m_i - _moment_about(s, d.b, load_b, at_i) - _moment(on_b, at_b, at_i)
    if d.inner.links[1] == d.b:
        inner, m_i = -inner, -m_i
    return (
        Reaction(d.outer_a, on_a, m_a, at_a, _guide(s, d.outer_a)),
        Reaction(d.outer_b, on_b, m_b, at_b, _guide(s, d.outer_b)),
        Reaction(d.inner, inner, m_i, at_i, _guide(s, d.inner)),
    )


def _solve_higher(
    s: State, group: HigherGroup, loads: Mapping[str, Load]
) -> tuple[list[Reaction], list[Reaction]]:
    """Outer and inner reactions of a group of any class: its 3k equations of equilibrium, moments over `size`.

    Unknown of a pivot is the force of its first link on the second, of a guide the normal force and the moment.
    """
    pairs = (*group.group.outer, *group.group.inner)
    row = {link: 3 * k for k, link in enumerate(group.links)}
    size = group.loops.size
    shape = np.broadcast_shapes(
        *(np.shape(s.r[link]) for link in row), *(np.shape(loads[x].force) for x in row)
    )
    A, b = np.zeros((*shape, 3 * len(row), 2 * len(pairs))), np.zeros((*shape, 3 * len(row)))
    for link, k in row.items():
        load = loads[link]
        b[..., k], b[..., k + 1], b[..., k + 2] = -load.force.real, -load.force.imag, -load.moment / size
    for column, pair in zip(range(0, 2 * len(pairs), 2), pairs, strict=True):
        at, t = _acts_at(s, pair), _guide(s, pair)
        vectors = (1 + 0j, 1j) if t is None else (1j * t,)
        for sign, link in zip((-1, 1), pair.links, strict=True):
            if link not in row:
                continue
            k = row[link]
            for c, e in enumerate(vectors):
                A[..., k, column + c], A[..., k + 1, column + c] = sign * np.real(e), sign * np.imag(e)
                A[..., k + 2, column + c] = sign * cross(at - s.r[link], e) / size
            if t is not None:
                A[..., k + 2, column + 1] = sign
    x = solve_each(A, b)
    found = [_reaction(s, pair, x[..., 2 * n], x[..., 2 * n + 1], size) for n, pair in enumerate(pairs)]
    outer = len(group.group.outer)
    return found[:outer], found[outer:]


def _reaction(s: State, pair: Pair, first: Array, second: Array, size: float) -> Reaction:
    """The reaction in a pair from the two unknowns of `_solve_higher`."""
    t = _guide(s, pair)
    if t is None:
        return Reaction(pair, first + 1j * second, 0.0, _acts_at(s, pair))
    return Reaction(pair, first * 1j * t, second * size, _acts_at(s, pair), t)


def _conditions(
    s: State, d: Dyad, load_a: Load, load_b: Load, total: Array, at_i: Array
) -> tuple[tuple, tuple]:
    """Two conditions R_a × f = c on the outer reaction of link a, one a free motion of the dyad without it."""
    if d.kind in (1, 2):  # link a turns about the inner joint B
        arm = s.r[d.a] - at_i
        first = arm, load_a.moment + cross(arm, load_a.force)
        if d.kind == 2:  # both slide along the guide of b
            return first, _no_force_along(_guide(s, d.outer_b), total)
        # link b turns about B: arm × (R_b + F_b) + M_b = 0, where R_b + F_b = −F_a − R_a
        arm = s.r[d.b] - at_i
        return first, (arm, cross(arm, load_a.force) - load_b.moment)
    if d.kind == 3:  # link a slides on b; both turn about C
        arm = s.r[d.a] - s.r[d.b]
        about_c = load_a.moment + cross(arm, load_a.force) + load_b.moment
        return (arm, about_c), _no_force_along(_guide(s, d.inner), load_a.force)
    slides_a = _guide(s, d.outer_a if d.kind == 4 else d.inner)
    own = 0j if d.kind == 4 else load_a.force
    return _no_force_along(slides_a, own), _no_force_along(_guide(s, d.outer_b), total)


def _no_force_along(t: Array, load: Array) -> tuple[Array, Array]:
    """(R + load)·t = 0, written as R × it = −load·t."""
    return 1j * t, -dot(t, load)


def _moment(force: Array, at: Array, about: Array) -> Array:
    """Moment of a force that acts at one world place about another."""
    return 0.0 if at is about else cross(at - about, force)


def _moment_about(s: State, link: str, load: Load, point: Array) -> Array:
    """Moment of a link's load, which is reduced to its reference point, about a world place."""
    return load.moment + _moment(load.force, s.r[link], point)


def _acts_at(s: State, pair: Pair) -> Array:
    """World place of a pair's reaction: the pivot, or the point of the sliding link that lies on the guide."""
    link = pair.slider or pair.links[1]
    return s.world(link, pair.at[link])


def _guide(s: State, pair: Pair) -> Array | None:
    """World direction of a prismatic pair's guide; None for a pivot."""
    if pair.kind == "R":
        return None
    link = pair.other(pair.slider)
    return s.u[link] * pair.along[link]
