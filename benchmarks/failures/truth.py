"""What is true of a scene: places and rates of its points in many digits, and how far off a number may be.

In a change point rates are the limit from both sides; in a corner only places are known.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from benchmarks.failures.scenes import CORNER, NOWHERE, Root, Scene
from benchmarks.near_singular.bound import bounded
from benchmarks.near_singular.closed import Number, Pose, chain, exactly, forces, lifted, mp
from benchmarks.near_singular.ours import carried
from tmm_report.mechanics.lever.assur_groups import decompose
from tmm_report.mechanics.lever.cycle import Cycle
from tmm_report.mechanics.lever.dyads import Dyad
from tmm_report.mechanics.lever.mechanism import Mechanism
from tmm_report.mechanics.rivals.exact import at as in_digits

HAIR = mp.mpf(10) ** -20  # rad, beside a change point
KINDS = ("place", "velocity", "acceleration")
SLACK = 1e-6  # of the largest value: what is off by no more is right
BOUNDS = 10.0  # or by no more than as many conditioning bounds
MOST = 1e-2  # of the largest value: what is off by more is wrong, however ill-conditioned

Key = tuple[str, str]


@dataclass(frozen=True, eq=False)
class Truth:
    """`at`: by position the values of every quantity; an empty mapping where there is no position, and only places in a
    corner. `angles`: of the driver, rad, binary numbers."""

    scene: Scene
    mechanism: Mechanism
    angles: Sequence[float]
    at: Sequence[Mapping[Key, Number]]
    roots: Sequence[Root]

    @cached_property
    def sizes(self) -> Mapping[Key, float]:
        """The largest magnitude of each quantity over the positions; of what is nothing throughout, of its kind."""
        sizes: dict[Key, float] = {}
        for values in self.at:
            for key, value in values.items():
                sizes[key] = max(sizes.get(key, 0.0), float(abs(value)))
        usual: dict[str, float] = {}
        for (kind, _), size in sizes.items():
            usual[kind] = max(usual.get(kind, 0.0), size)
        return {
            key: size if size > 1e-9 * usual[key[0]] else usual[key[0]] or 1.0 for key, size in sizes.items()
        }

    def off(self, k: int, key: Key, found: complex) -> float:
        """Error of what was found at position k, over the size of the quantity."""
        return float(abs(exactly(found) - self.at[k][key])) / self.sizes[key]

    def allowed(self, k: int, key: Key) -> float:
        """What rounding alone may do at position k: conditioning bounds, over the size of the quantity."""
        return BOUNDS * self._bounds(k).get(key, 0.0) / self.sizes[key]

    def _bounds(self, k: int) -> Mapping[Key, float]:
        known: dict[int, Mapping[Key, float]] = self._known
        if k not in known:
            known[k] = {} if not isinstance(self.roots[k], int) else self._bounded(k)
        return known[k]

    @cached_property
    def _known(self) -> dict[int, Mapping[Key, float]]:
        return {}

    def _bounded(self, k: int) -> Mapping[Key, float]:
        root = int(self.roots[k])
        if len(self.mechanism.moving) > 3:  # a group above class II: 1e-6 is asked for
            return {}

        def solve(m: Mechanism, phi: Number) -> Mapping[Key, Number]:
            return _values(m, root, phi)

        try:
            return {
                key: float(value.bound)
                for key, value in bounded(self.mechanism, self.angles[k], solve).items()
            }
        except (ArithmeticError, ValueError, TypeError):  # a change point: there is no bound
            return {}


def truth(scene: Scene, cycle: Cycle, angles: Sequence[float]) -> Truth:
    mechanism = cycle.linkage.mechanism
    whole = lifted(mechanism)
    roots = [scene.roots(exactly(float(phi))) for phi in angles]
    if not all(isinstance(group, Dyad) for group in cycle.linkage.groups):
        return Truth(scene, mechanism, angles, _higher(cycle, angles, roots), roots)
    at = [_at(scene, whole, exactly(float(phi)), root) for phi, root in zip(angles, roots, strict=True)]
    return Truth(scene, mechanism, angles, at, roots)


def _higher(cycle: Cycle, angles: Sequence[float], roots: Sequence[Root]) -> list[Mapping[Key, Number]]:
    """Of a group above class II, in 40 digits from the solution in doubles on; beyond its limit nothing is true."""
    whole = lifted(cycle.linkage.mechanism)
    structure = decompose(whole)
    found: list[Mapping[Key, Number]] = []
    for phi, root in zip(angles, roots, strict=True):
        pose = in_digits(cycle, phi).poses[0] if root != NOWHERE else None
        if pose is None:
            found.append({})
            continue
        bodies = {link: carried(body) for link, body in pose.items()}
        found.append(points(whole, bodies) | _forces(structure, bodies))
    return found


def _at(scene: Scene, m: Mechanism, phi: Number, root: Root) -> Mapping[Key, Number]:
    if root in (NOWHERE, CORNER):
        return {}
    if scene.roots(phi - HAIR) == root == scene.roots(phi + HAIR) and _apart(m, int(root), phi):
        return _values(m, int(root), phi)
    sides = [_values(m, int(scene.roots(phi + way * HAIR)), phi + way * HAIR) for way in (-1, 1)]
    bounded_there = (key for key in sides[0] if key[0] != "force" or key[1] == "balancing")
    return {key: (sides[0][key] + sides[1][key]) / 2 for key in bounded_there}  # reactions grow without bound


def _apart(m: Mechanism, root: int, phi: Number) -> bool:
    """Whether the two roots can be told apart in the digits that are carried."""
    whole = chain(m, [root] * _dyads(m))
    other = chain(m, [-root] * _dyads(m))
    return any(
        abs(one.u - two.u) > mp.mpf(10) ** -15
        for one, two in zip(whole.pose(phi).values(), other.pose(phi).values(), strict=True)
    ) or all(d.kind > 3 for d in whole.dyads)


def _dyads(m: Mechanism) -> int:
    return (len(m.moving) - 1) // 2


def _values(m: Mechanism, root: int, phi: Number) -> dict[Key, Number]:
    whole = chain(m, [root] * _dyads(m))
    pose = whole.motion(phi, m.driver.omega)
    return points(m, pose) | _forces(whole.structure, pose)


def points(m: Mechanism, pose: Mapping[str, Any]) -> dict[Key, Number]:
    found: dict[Key, Number] = {}
    for link, body in m.links.items():
        for point, at in body.points.items():
            if ("place", point) not in found:
                found["place", point] = pose[link].place(at)
                found["velocity", point] = pose[link].velocity(at)
                found["acceleration", point] = pose[link].acceleration(at)
    return found


GRAVITY = -9.81j


def _forces(structure: Any, pose: Pose) -> dict[Key, Number]:
    """Reactions and the balancing moment under weight and inertia alone; nothing where the links are in line."""
    try:
        found = forces(structure, pose, GRAVITY, {})
    except ZeroDivisionError:
        return {}
    return {("force", key): value for key, value in found.items()}


def finite(x: Any) -> bool:
    return bool(np.isfinite(x))
