"""Force plans with pencil and paper, of all positions at once: what is read off them to an accuracy of so many mm.

The plan of a dyad: the loads of link b from P0 to P1, those of a from P1 to P2; the reactions close it, R_a from P2 to
X, R_b from X to P0, the inner one, of b on a, from X to P1. Two lines through X solve any dyad: a moment equation, or a
guide that has no force along itself.

A person takes from the scheme the arm of a load, on the plan places every point, and reads the length of every
reaction: each to the accuracy of the drawing; with 0.01 mm, by computer, points are exact and lengths are read. Numbers
are written with five digits. The loads of a link are laid off as one force with one arm. (Artobolevsky, Theory of
mechanisms and machines, ch. 13)
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from tmm_report.mechanics.calculus.vectors import cross, if_known, resolve
from tmm_report.mechanics.lever.assur_groups import Pair
from tmm_report.mechanics.lever.dyads import Dyad, State
from tmm_report.mechanics.lever.forces.reactions import Load, Reaction, Statics
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.mechanics.lever.motion import SINGULAR, Motion
from tmm_report.mechanics.rivals.model import Loaded
from tmm_report.mechanics.rivals.paper import EXACT, LONGEST, SHEET, Pen, round_scale, written
from tmm_report.problems import N_, Message

Array = Any


def plans(motion: Motion, loads: Mapping[str, Load], accuracy: float) -> Statics:
    """Reactions and the balancing moment as read off plans of every group; nan in singular positions."""
    s, linkage = motion.state, motion.linkage
    rest, reactions = {link: _laid_off(load, motion.shape) for link, load in loads.items()}, {}
    with np.errstate(invalid="ignore", divide="ignore"):
        pen = Pen(accuracy, float(round_scale(_span(motion), SHEET)))
        for group in reversed(linkage.groups):
            if not isinstance(group, Dyad):
                raise ArithmeticError(N_("a force polygon is drawn of dyads"))
            outer_a, outer_b, inner = _dyad(s, group, rest, pen)
            drawn = motion.sines[group.group.label] > SINGULAR
            for one in (outer_a, outer_b, inner):
                moment = if_known(drawn, one.moment)
                found = Reaction(one.pair, if_known(drawn, one.force), moment, one.at, one.along)
                reactions[one.pair.key] = found
                if one is not inner:
                    _pass_on(s, rest, found)
        return _driver(motion, rest, reactions, pen)


def no_plans(scene: Loaded) -> Message | None:
    linkage = scene.cycle.linkage
    if linkage.mechanism.cams:
        return Message(N_("a cam is replaced by another linkage in every position: each has its own scheme"))
    if not all(isinstance(group, Dyad) for group in linkage.groups):
        return Message(
            N_("a group above class II: its equations are solved, its polygon shows only the result")
        )
    return None


def _span(motion: Motion) -> float:
    """The larger side of the scheme, m."""
    places = motion.places
    sides = (np.nanmax(part) - np.nanmin(part) for part in (places.real, places.imag))
    return float(max(sides))


def _laid_off(load: Load, shape: tuple[int, ...]) -> Load:
    """All in full shape; the size of the force as written."""
    force = np.broadcast_to(load.force, shape) + 0j
    size = np.abs(force)
    return Load(force * (written(size) / np.where(size > 0, size, 1.0)), np.broadcast_to(load.moment, shape))


# ---------------------------------------------------------------- the plan of a dyad


def _dyad(s: State, d: Dyad, rest: Mapping[str, Load], pen: Pen) -> tuple[Reaction, Reaction, Reaction]:
    """Outer reactions on a and on b, and the inner one, in the sense of their pairs."""
    a, b = rest[d.a], rest[d.b]
    scale = _scale(s, d, rest, pen)
    corners = _corners(a, b, scale, pen)
    X = pen.placed(_crossing(_lines(s, d, rest, corners, scale, pen)))
    P0, P1, P2 = corners
    on_a, on_b, inner = (pen.read(vector) * scale for vector in (X - P2, P0 - X, P1 - X))
    m_a, m_b, m_i = _moments(s, d, rest, (on_a, on_b, inner), pen)
    if d.inner.links[1] == d.b:
        inner, m_i = -inner, -m_i
    rows = ((d.outer_a, on_a, m_a), (d.outer_b, on_b, m_b), (d.inner, inner, m_i))
    found = (Reaction(pair, force, moment, _at(s, pair), _guide(s, pair)) for pair, force, moment in rows)
    outer_a, outer_b, between = found
    return outer_a, outer_b, between


def _scale(s: State, d: Dyad, rest: Mapping[str, Load], pen: Pen) -> Array:
    """N in a mm, so that the longest vector is as long as a sheet takes: from the same plan before it is drawn."""
    exact = Pen(EXACT, pen.metres)
    corners = _corners(rest[d.a], rest[d.b], 1.0, exact)
    X = _crossing(_lines(s, d, rest, corners, 1.0, exact))
    P0, P1, P2 = corners
    vectors = np.abs([P1 - P0, P2 - P1, X - P2, P0 - X, P1 - X])
    return round_scale(np.max(np.nan_to_num(vectors), axis=0), LONGEST)


def _corners(a: Load, b: Load, scale: Array, pen: Pen) -> tuple[Array, Array, Array]:
    """P0, P1, P2, mm."""
    P1 = pen.placed(b.force / scale)
    return 0 * P1, P1, pen.placed(P1 + a.force / scale)


def _crossing(lines: tuple[tuple[Array, Array], tuple[Array, Array]]) -> Array:
    (start1, along1), (start2, along2) = lines
    x, _ = resolve(start2 - start1, along1, -along2)
    return start1 + x * along1


def _lines(
    s: State, d: Dyad, rest: Mapping[str, Load], corners: tuple[Array, Array, Array], scale: Array, pen: Pen
) -> tuple[tuple[Array, Array], tuple[Array, Array]]:
    """Two lines through X, each by a point and its direction."""
    P0, P1, P2 = corners
    A, B, C = (_at(s, pair) for pair in (d.outer_a, d.inner, d.outer_b))

    def across(arm: Array, moment: Array) -> Array:
        """The component of a reaction across its arm that balances a moment about the other end, mm."""
        size = np.abs(arm)
        return pen.placed(-1j * arm / size * written(moment / size) / scale)

    def about(link: str, place: Array) -> Array:
        load = rest[link]
        return pen.moment(load.moment + cross(s.r[link] - place, load.force), load.force)

    if d.outer_a.kind == "P":
        first = P2, 1j * _guide(s, d.outer_a)
    elif d.inner.kind == "P":
        first = P1, 1j * _guide(s, d.inner)
    else:
        first = P2 + across(A - B, about(d.a, B)), A - B
    if d.outer_b.kind == "P":
        second = P0, 1j * _guide(s, d.outer_b)
    elif d.inner.kind == "P":
        second = P2 + across(A - C, about(d.a, C) + about(d.b, C)), A - C
    else:
        second = P0 - across(C - B, about(d.b, B)), C - B
    return first, second


def _moments(
    s: State, d: Dyad, rest: Mapping[str, Load], forces: tuple[Array, Array, Array], pen: Pen
) -> tuple[Array, Array, Array]:
    """Moments of the reactions of guides: on a, on b, the inner one on a; 0 of a pivot."""
    on_a, on_b, inner = forces
    A, B, C = (_at(s, pair) for pair in (d.outer_a, d.inner, d.outer_b))
    m_a = m_b = m_i = np.zeros(np.shape(on_a))

    def about(link: str, place: Array) -> Array:
        load = rest[link]
        return pen.moment(load.moment + cross(s.r[link] - place, load.force), load.force)

    if d.inner.kind == "P":
        m_i = -about(d.a, A) - pen.moment(cross(B - A, inner), inner)
    if d.outer_a.kind == "P":
        m_a = -about(d.a, B) - pen.moment(cross(A - B, on_a), on_a)
    if d.outer_b.kind == "P":
        m_b = m_i - about(d.b, B) - pen.moment(cross(C - B, on_b), on_b)
    return m_a, m_b, m_i


def _pass_on(s: State, rest: dict[str, Load], reaction: Reaction) -> None:
    """A reaction read off loads the link on which the group hangs, turned round."""
    carrier = reaction.pair.links[0]
    if carrier != FRAME:
        load = rest[carrier]
        moment = cross(reaction.at - s.r[carrier], reaction.force) + reaction.moment
        rest[carrier] = Load(load.force - reaction.force, load.moment - moment)


def _driver(motion: Motion, rest: Mapping[str, Load], reactions: dict[str, Reaction], pen: Pen) -> Statics:
    """The balancing moment from the moments about the pivot, the frame's reaction from the plan."""
    driver, pair = motion.linkage.mechanism.driver, motion.linkage.structure.driver_pair
    load = rest[driver.link]
    moment = -pen.moment(load.moment, load.force)
    pushed = driver.gear.force(moment, driver.omega) if driver.gear else 0.0
    force = -load.force - pushed
    scale = round_scale(np.nan_to_num(np.maximum(np.abs(force), np.abs(load.force))), LONGEST)
    force = pen.read(pen.placed(force / scale)) * scale
    reactions[pair.key] = Reaction(pair, force, 0.0, motion.state.r[driver.link])
    return Statics(reactions, moment)


def _at(s: State, pair: Pair) -> Array:
    link = pair.slider or pair.links[1]
    return s.world(link, pair.at[link])


def _guide(s: State, pair: Pair) -> Array:
    """World direction of a guide; None of a pivot."""
    if pair.kind == "R":
        return None
    link = pair.other(pair.slider)
    return s.u[link] * pair.along[link]
