"""Reactions with Coulomb friction in the pairs, over a whole cycle at once.

Friction of a pair is as large as the force that presses it, and changes that force: a pivot brakes with the moment
f R d/2, a guide with the force f N (Artobolevsky, Theory of mechanisms and machines, ch. 11). The force analysis is
linear in its loads, so the reactions are R = R0 + Σ x_k R_k, where x_k is the pressing force of pair k and R_k what
its friction alone, of 1 N pressing, does to the pairs. What is left are the equations x_j = |R_j(x)|, as many as pairs
that rub, solved by Newton's method for all positions together.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from tmm_report.mechanics.calculus.vectors import cross, dot
from tmm_report.mechanics.lever.assur_groups import Pair
from tmm_report.mechanics.lever.dyads import State
from tmm_report.mechanics.lever.forces import reactions as statics
from tmm_report.mechanics.lever.forces.force_on_crank_gear import pressed_flank
from tmm_report.mechanics.lever.forces.reactions import Load, Reaction, Statics
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.records import dataclass

Array = Any
TOLERANCE = 1e-12  # of a pressing force, by the largest of the position
STEPS = 40  # of Newton's method; it needs about five
GEAR = ""  # the flank of the gear that turns the driving link, among those of the wheels
FLANKS = 4  # how often the pressed flanks are looked at again: once is enough but beside their change
PARTS = 32  # in which friction is put on where the whole of it at once is too much


@dataclass(frozen=True, eq=False)
class Rub:
    """What rubs in a pair. `coefficient`: one, or at every position; `radius`: of the journal, m; `half`: half the
    length of the slider, m, None where it is not stated: its moment then presses nothing. `sense`: of the motion of
    `pair.links[1]` relative to `pair.links[0]` (turning, or sliding along the guide), +1, −1, and 0 at a stop,
    (..., P). `loads`: what 1 N of pressing does to the links, by their names, where it is not the friction of a lower
    pair: of a cam and its follower."""

    pair: Pair
    coefficient: Array
    sense: Array
    radius: float = 0.0
    half: float | None = None
    loads: Mapping[str, Load] | None = None


@dataclass(frozen=True, eq=False)
class Rubbed:
    """Found by `solve`. `statics`: reactions with friction in the loads, those of guides normal to them;
    `pressing`: N, `friction`: N m of a pivot, N of a guide, of `links[0]` on `links[1]`, by the key of the pair;
    `borne`: the part of the stated friction at which each position jams, 1 where it does not; arrays (P,)."""

    statics: Statics
    pressing: Mapping[str, Array]
    friction: Mapping[str, Array]
    borne: Array
    steps: int

    @property
    def jammed(self) -> Array:
        return self.borne < 1


def solve(motion: Motion, loads: Mapping[str, Load], rubs: Sequence[Rub]) -> Rubbed:
    """Reactions and balancing moment with the friction of `rubs` under `loads`. Where no equilibrium of motion exists
    (jamming) they are nan, and `borne` says how much of the friction the position bears."""
    gear, coupled = motion.linkage.mechanism.driver.gear, motion.linkage.structure.coupled
    chooses = gear is not None and not gear.one_flank
    if not chooses and not any(wheel.mesh.pressure for wheel in coupled):
        return _solved(motion, loads, rubs, {})
    # the parts of the force of teeth add up on one flank alone: that of the whole force, with the friction in it
    flanks = _flanks(motion, statics.solve(motion, loads), chooses)
    for _ in range(FLANKS):
        found = _solved(motion, loads, rubs, flanks)
        pressed = _flanks(motion, found.statics, chooses)
        if all((pressed[key] == flanks[key]).all() for key in flanks):
            break
        flanks = pressed
    return found


def _flanks(motion: Motion, found: Statics, chooses: bool) -> dict[str, Array]:
    """Which flanks the teeth press, by the keys of contacts; of the gear that turns the driving link, where it has a
    choice, as `GEAR`."""
    flanks = {
        wheel.contact.key: wheel.flank(motion.state, found.reactions[wheel.contact.key].force)
        for wheel in motion.linkage.structure.coupled
    }
    return flanks | ({GEAR: pressed_flank(found.balancing)} if chooses else {})


def _solved(
    motion: Motion, loads: Mapping[str, Load], rubs: Sequence[Rub], flanks: Mapping[str, Array]
) -> Rubbed:
    count, shape = len(rubs), motion.shape
    units = [_unit(motion.state, rub, shape) for rub in rubs]
    basis = statics.solve(motion, _stacked(loads, units, shape), flanks.get(GEAR), flanks)
    found = [_pressed(rub, basis.reactions[rub.pair.key], count, shape) for rub in rubs]
    x, steps, borne = _equilibrium(np.array([one for one, _ in found]), np.array([two for _, two in found]))
    x = np.where(borne < 1, np.nan, x)
    return Rubbed(
        _combined(basis, x, shape),
        {rub.pair.key: x[j] for j, rub in enumerate(rubs)},
        {rub.pair.key: _intensity(rub) * x[j] for j, rub in enumerate(rubs)},
        borne,
        steps,
    )


# ---------------------------------------------------------------- what presses a pair


def pressing(reaction: Reaction, half: float | None = None) -> Array:
    """The force that presses the links of a pair by its reaction, N, (..., P): of a pivot the whole of it; of a guide
    the normal force or, of a slider of the half length `half`, m, that its couple tilts, the sum of the forces at both
    its ends, 2|M|/l, where that is more: the normal force then passes beyond the ends."""
    return _size(*_parts(reaction, half))


def _parts(reaction: Reaction, half: float | None) -> tuple[Array, Array]:
    """A pivot's force, complex, and nothing; a guide's normal force and the couple of the faces M/(l/2), real."""
    if reaction.pair.kind == "R":
        return reaction.force, np.zeros(())
    return cross(reaction.along, reaction.force), reaction.moment / half if half else np.zeros(())


def _size(force: Array, couple: Array) -> Array:
    """The sum of what presses the faces: of a slider that touches at both ends its couple, else its force."""
    return np.maximum(np.abs(force), np.abs(couple))


# ---------------------------------------------------------------- the relative motion


def relative_rate(motion: Motion, pair: Pair) -> Array:
    """Relative angular velocity in a pivot, rad/s, or sliding velocity in a guide, m/s; (..., P)."""
    one, other = pair.links
    s = motion.state
    if pair.kind == "R":
        return np.broadcast_to(s.w[other] - s.w[one], motion.shape)
    slider, carrier = str(pair.slider), pair.other(str(pair.slider))
    place = s.world(slider, pair.at[slider])
    sliding = s.velocity(slider, place - s.r[slider]) - s.velocity(carrier, place - s.r[carrier])
    return np.broadcast_to(dot(sliding, s.u[carrier] * pair.along[carrier]), motion.shape)


def signed_rate(motion: Motion, pair: Pair) -> Array:
    """Motion of `links[1]` of a pair relative to `links[0]`: rad/s, or m/s along the guide; (..., P)."""
    rate = relative_rate(motion, pair)
    return rate if pair.kind == "R" or pair.slider == pair.links[1] else -rate


# ---------------------------------------------------------------- the loads


def _intensity(rub: Rub) -> Array:
    """Moment or force of `links[0]` on `links[1]` for 1 N of pressing: against the relative motion."""
    return -rub.coefficient * (rub.radius if rub.pair.kind == "R" else 1.0) * rub.sense


def _unit(s: State, rub: Rub, shape: tuple[int, ...]) -> dict[str, Load]:
    """Friction of 1 N of pressing, on both links of a pair, about their reference points."""
    if rub.loads is not None:
        return dict(rub.loads)
    pair, size = rub.pair, _intensity(rub) * np.ones(shape)
    if pair.kind == "R":
        return {link: Load(0j, sign * size) for sign, link in zip((-1, 1), pair.links, strict=True)}
    slider = str(pair.slider)
    carrier = pair.other(slider)
    at = s.world(slider, pair.at[slider])
    force = size * s.u[carrier] * pair.along[carrier]
    return {
        link: Load(sign * force, cross(at - s.r[link], sign * force))
        for sign, link in zip((-1, 1), pair.links, strict=True)
    }


def _stacked(
    loads: Mapping[str, Load], units: Sequence[Mapping[str, Load]], shape: tuple[int, ...]
) -> dict[str, Load]:
    """Row 0 the loads, row k the friction of pair k alone; (1 + pairs, ..., P)."""
    nothing = Load(0j, 0.0)
    rows = {link: [load, *(unit.get(link, nothing) for unit in units)] for link, load in loads.items()}
    return {
        link: Load(
            np.array([np.broadcast_to(row.force, shape) for row in of]).astype(complex),
            np.array([np.broadcast_to(row.moment, shape) for row in of]).astype(float),
        )
        for link, of in rows.items()
        if link != FRAME
    }


def _pressed(rub: Rub, reaction: Reaction, count: int, shape: tuple[int, ...]) -> tuple[Array, Array]:
    """What presses the pair, of each row: a pivot its force, complex; a guide the normal force and the couple of its
    faces M/(l/2), each real; (1 + pairs, ..., P)."""
    full = (count + 1, *shape)
    force, couple = (np.broadcast_to(part, full) + 0j for part in _parts(reaction, rub.half))
    return force, couple


def _combined(basis: Statics, x: Array, shape: tuple[int, ...]) -> Statics:
    """The row of the loads and the rows of friction, each with its pressing force."""
    weights = np.concatenate([np.ones((1, *shape)), x])
    full = weights.shape

    def whole(rows: Array) -> Array:
        return np.sum(weights * np.broadcast_to(rows, full), axis=0)

    reactions = {
        key: replace(one, force=whole(one.force), moment=whole(one.moment))
        for key, one in basis.reactions.items()
    }
    return Statics(reactions, whole(basis.balancing))


# ---------------------------------------------------------------- the equations


def _equilibrium(force: Array, couple: Array) -> tuple[Array, int, Array]:
    """Pressing forces (pairs, P), steps of Newton's method, and the part of the friction borne (P,).

    `force`, `couple`: (pairs, 1 + pairs, P). Singular positions stay nan.
    """
    known = np.isfinite(force).all(axis=(0, 1)) & np.isfinite(couple).all(axis=(0, 1))
    start = _size(force[:, 0], couple[:, 0])
    x, steps, good = _newton(force, couple, np.where(known, start, 0.0))
    borne = np.where(good | ~known, 1.0, 0.0)
    hard = np.flatnonzero(~good & known)
    if hard.size:
        x[:, hard], borne[hard] = _by_parts(force[..., hard], couple[..., hard])
    return np.where(known, x, np.nan), steps, borne


def _by_parts(force: Array, couple: Array) -> tuple[Array, Array]:
    """Friction put on little by little from none: the solution that belongs to it (pairs, P), and the part of the
    friction up to which there is one (P,). Positions that end are left behind."""
    x = _size(force[:, 0], couple[:, 0])
    borne, going = np.zeros(x.shape[1]), np.arange(x.shape[1])
    for part in range(1, PARTS + 1):
        scale = np.ones((force.shape[1], 1))
        scale[1:] = part / PARTS
        x[:, going], _, good = _newton(force[..., going] * scale, couple[..., going] * scale, x[:, going])
        going = going[good]
        borne[going] = part / PARTS
        if not going.size:
            break
    return x, borne


def _newton(force: Array, couple: Array, x: Array) -> tuple[Array, int, Array]:
    """Newton's method from `x` (pairs, P); beside it how many steps, and where it found an equilibrium that friction
    reaches when it grows from nothing: there the determinant has not changed its sign."""
    one, steps = np.eye(len(x))[..., None], 0
    with np.errstate(all="ignore"):
        while True:
            size, slope = _slopes(force, couple, x)
            miss = x - size
            matrix = np.moveaxis(one - slope, -1, 0)
            best = np.max(np.abs(miss), axis=0) / np.maximum(np.max(size, axis=0), 1e-300)
            if steps == STEPS or not (best > TOLERANCE).any():
                break
            x, steps = x - _divided(matrix, miss), steps + 1
        bent = np.linalg.det(np.nan_to_num(matrix))
    return x, steps, (best <= 10 * TOLERANCE) & (bent > 0)


def _slopes(force: Array, couple: Array, x: Array) -> tuple[Array, Array]:
    """Sizes (pairs, P) and their derivatives by the pressing forces (pairs, pairs, P)."""
    sums = [rows[:, 0] + np.einsum("jkp,kp->jp", rows[:, 1:], x) for rows in (force, couple)]
    slopes = []
    for rows, whole in zip((force, couple), sums, strict=True):
        size = np.abs(whole)
        unit = np.where(size > 0, whole / np.where(size > 0, size, 1.0), 0.0)
        slopes.append((unit.conj()[:, None] * rows[:, 1:]).real)
    tilted = np.abs(sums[1]) > np.abs(sums[0])
    return _size(*sums), np.where(tilted[:, None], slopes[1], slopes[0])


def _divided(matrix: Array, miss: Array) -> Array:
    """The step of each position, 0 where its matrix is singular."""
    good = np.isfinite(matrix).all(axis=(1, 2)) & (np.abs(np.linalg.det(np.nan_to_num(matrix))) > 1e-14)
    step = np.zeros_like(miss)
    if good.any():
        step[:, good] = np.linalg.solve(matrix[good], miss.T[good][..., None])[..., 0].T
    return step
