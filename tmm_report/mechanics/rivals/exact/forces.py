"""Exact reactions in all pairs and the balancing moment: one linear system for all links in every position.

Three equations of equilibrium for each moving link, inertia forces among its loads (d'Alembert); unknowns are two
numbers of every pair (a force, or a normal force and a moment) and the balancing moment. Groups are unknown here.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cached_property
from typing import Any

from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.mechanics.rivals.exact.moving import Exact
from tmm_report.mechanics.rivals.exact.numbers import (
    DIGITS,
    GUARD,
    Number,
    context,
    cross,
    exact,
    point,
    rows_of,
    solve,
)
from tmm_report.mechanics.rivals.exact.scheme import Joint, Pose
from tmm_report.mechanics.rivals.model import Pair
from tmm_report.records import dataclass

Array = Any


@dataclass(frozen=True, eq=False)
class Acting:
    """What acts on the links beside their inertia. `forces`: (link, named point of it, the force at each position,
    complex N); `moments`: (link, N m at each position); `gravity`: complex, m/s². Doubles or numbers of mpmath."""

    forces: Sequence[tuple[str, str, Sequence[Any]]] = ()
    moments: Sequence[tuple[str, Sequence[Any]]] = ()
    gravity: Any = 0j


@dataclass(frozen=True, eq=False)
class Balance:
    """Forces at one position. `reactions`: pair's key -> force and moment of its first link on its second."""

    reactions: Mapping[str, tuple[Number, Number]]
    moment: Number


@dataclass(frozen=True, eq=False)
class Forces:
    """Exact forces at the positions of a motion; None where there are none."""

    found: Exact
    balances: Sequence[Balance | None]

    @cached_property
    def keys(self) -> tuple[str, ...]:
        """Keys of the pairs: rows of reactions."""
        return tuple(pair.key for pair in self.found.linkage.structure.pairs)

    @cached_property
    def pairs(self) -> Mapping[str, Pair]:
        """Rows by position: "reaction", complex N, and "couple", N m, of the pairs; "moment", one row, N m."""
        return {
            "reaction": rows_of([self._reactions(key, 0) for key in self.keys]),
            "couple": rows_of([self._reactions(key, 1) for key in self.keys]),
            "moment": rows_of([[None if b is None else b.moment for b in self.balances]]),
        }

    def _reactions(self, key: str, part: int) -> list[Number | None]:
        return [None if b is None else b.reactions[key][part] for b in self.balances]


def forces(found: Exact, acting: Acting, digits: int = DIGITS) -> Forces:
    """Reactions and the balancing moment at the positions of an exact motion."""
    with context().workdps(digits + GUARD):
        return Forces(
            found,
            [None if pose is None else balance(found, pose, acting, k) for k, pose in enumerate(found.poses)],
        )


def balance(found: Exact, pose: Pose, acting: Acting, k: int) -> Balance | None:
    """Forces in the k-th position; None in a singular one."""
    mechanism, joints, size = found.linkage.mechanism, found.scheme.joints, found.scheme.size
    rows: list[dict[int, Number]] = [{} for _ in range(3 * len(mechanism.moving))]
    at = {link: 3 * n for n, link in enumerate(mechanism.moving)}
    for n, j in enumerate(joints):
        for sign, link in zip((-1, 1), j.pair.links, strict=True):
            if link != FRAME:
                _add(rows, at[link], 2 * n, sign, _directions(j, pose), _place(j, pose) - pose[link].r, size)
    rows[at[mechanism.driver.link] + 2][2 * len(joints)] = 1
    right = [
        -part
        for load in _loads(found, pose, acting, k).values()
        for part in (load[0].real, load[0].imag, load[1] / size)
    ]
    x = solve(rows, right)
    if x is None:
        return None
    reactions = {j.pair.key: _reaction(j, pose, x[2 * n], x[2 * n + 1], size) for n, j in enumerate(joints)}
    moment = x[-1] * size
    if mechanism.driver.gear is not None:
        key = found.linkage.structure.driver_pair.key
        force, couple = reactions[key]
        reactions[key] = force - _teeth(mechanism.driver, moment), couple
    return Balance(reactions, moment)


def _directions(j: Joint, pose: Pose) -> tuple[Number, ...]:
    """Unit vectors of the unknown forces of a pair."""
    if j.along is None:
        return context().mpc(1), context().mpc(0, 1)
    return (1j * j.line(pose)[0],)


def _place(j: Joint, pose: Pose) -> Number:
    """Where the reaction of a pair is taken: its pivot, or the sliding link's point on the guide."""
    if j.along is None:
        return pose[j.second].place(j.at[1])
    return pose[j.first].place(j.at[0])


def _add(
    rows: list[dict[int, Number]],
    row: int,
    column: int,
    sign: int,
    units: Sequence[Number],
    arm: Number,
    size: Number,
) -> None:
    """What a pair's unknowns add to the three equations of one of its links."""
    for c, unit in enumerate(units):
        rows[row][column + c], rows[row + 1][column + c] = sign * unit.real, sign * unit.imag
        rows[row + 2][column + c] = sign * cross(arm, unit) / size
    if len(units) == 1:
        rows[row + 2][column + 1] = sign


def _reaction(j: Joint, pose: Pose, first: Number, second: Number, size: Number) -> tuple[Number, Number]:
    if j.along is None:
        return context().mpc(first, second), context().mpf(0)
    return first * _directions(j, pose)[0], second * size


def _loads(found: Exact, pose: Pose, acting: Acting, k: int) -> dict[str, tuple[Number, Number]]:
    """Force and moment about its origin of everything that acts on each moving link, inertia included."""
    links, own = found.linkage.mechanism.links, context()
    total = {link: (own.mpc(0), own.mpf(0)) for link in found.linkage.mechanism.moving}

    def add(link: str, at: str | None, force: Number, couple: Number = 0) -> None:
        before, moment = total[link]
        arm = own.mpc(0) if at is None else pose[link].u * point(links[link].points[at])
        total[link] = before + force, moment + couple + cross(arm, force)

    for name in total:
        link = links[name]
        if link.mass_centre is not None:
            centre = point(link.points[link.mass_centre])
            force = exact(link.mass) * (point(acting.gravity) - pose[name].acceleration(centre))
            add(name, link.mass_centre, force)
        add(name, None, own.mpc(0), -exact(link.inertia) * pose[name].e)
    for name, at, values in acting.forces:
        add(name, at, point(values[k]))
    for name, values in acting.moments:
        add(name, None, own.mpc(0), exact(values[k]))
    return total


def _teeth(driver: Any, moment: Number) -> Number:
    """Force of the wheel that turns the driving link, whose moment about the pivot is the balancing moment."""
    own, gear = context(), driver.gear
    pressure = exact(gear.pressure)
    outward, arm = own.expj(exact(gear.at)), exact(gear.radius) * own.cos(pressure)
    if gear.one_flank:
        sense = 1 if driver.omega > 0 else -1
        return moment / (sense * arm) * outward * (1j * sense * own.cos(pressure) - own.sin(pressure))
    sense = -1 if moment < 0 else 1
    return moment / arm * outward * (1j * own.cos(pressure) - sense * own.sin(pressure))
