"""Every method at every distance: its errors in the last position of the swing, against the conditioning bound."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache

import numpy as np

from benchmarks.near_singular import ours
from benchmarks.near_singular.bound import Key, Value
from benchmarks.near_singular.ours import KINDS, Miss
from benchmarks.near_singular.scenes import SCENES
from tmm_report.mechanics.lever.cycle import Cycle
from tmm_report.mechanics.rivals.forces import FORCES
from tmm_report.mechanics.rivals.model import Loaded, MotionMethod
from tmm_report.mechanics.rivals.motion.every import MOTIONS
from tmm_report.mechanics.rivals.tables import TABLES

COUNT = 12  # steps of the swing; a table method differentiates these
JITTERS = 3  # mechanisms with slightly other lengths, of which the worst counts
OWN = "groups"


@dataclass(frozen=True)
class Run:
    """One method of one scene at one distance; `closeness` of the mechanism's worst group there. `misses` by kind:
    nothing of a kind that it does not find; None where it refused or broke down."""

    scene: str
    method: str
    distance: float
    closeness: float
    misses: Mapping[str, Miss] | None
    bounds: Mapping[str, float]  # by kind, relative


def methods() -> dict[str, MotionMethod]:
    return {method.key: method for method in (*MOTIONS, *TABLES)}


def run(scene: str, distance: float, keys: tuple[str, ...], jitters: int = JITTERS) -> list[Run]:
    """The methods `keys` of motion, and where it is "groups" those of forces."""
    rows: dict[str, list[Run]] = {}
    for jitter in range(jitters):
        cycle = SCENES[scene].cycle(distance, jitter)
        values = _exact(scene, distance, jitter)
        if values is None:
            continue
        for key in keys:
            for one in _of(scene, distance, cycle, values, key):
                rows.setdefault(one.method, []).append(one)
    return [_worst(found) for found in rows.values()]


@cache
def _exact(scene: str, distance: float, jitter: int) -> dict[Key, Value] | None:
    cycle = SCENES[scene].cycle(distance, jitter)
    return ours.exact(SCENES[scene], cycle, float(cycle.phi(cycle.once(COUNT))[-1]))


def _of(scene: str, distance: float, cycle: Cycle, values: Mapping[Key, Value], key: str) -> list[Run]:
    method = methods()[key]
    closeness = float(min(sine[-1] for sine in cycle.motion(cycle.once(COUNT)).sines.values()))
    bounds = {kind: miss.bound for kind, miss in ours.misses(values, _nothing(values)).items()}
    if method.refuses(cycle) is not None:
        return []
    try:
        motion = method.run(cycle, COUNT)
    except ArithmeticError:
        return [Run(scene, key, distance, closeness, None, bounds)]
    with np.errstate(all="ignore"):
        got = ours.found(SCENES[scene], motion)
    found = [Run(scene, key, distance, closeness, ours.misses(values, got), bounds)]
    if key == OWN:
        found += [
            Run(
                scene,
                f"forces: {force.key}",
                distance,
                closeness,
                ours.misses(_forces(values), got | new),
                bounds,
            )
            for force in FORCES
            if force.key != OWN and (new := _by(scene, cycle, force)) is not None
        ]
    return found


def _by(scene: str, cycle: Cycle, force: object) -> dict[Key, complex] | None:
    """Reactions and the balancing moment by a method of forces, None where it refuses; what it does not find is nothing
    that can be wrong."""
    loaded = Loaded(cycle, lambda motion: ours.loads(SCENES[scene], motion))
    if force.refuses(loaded) is not None:  # type: ignore[attr-defined]
        return None
    with np.errstate(all="ignore"):
        solved = force.run(loaded, COUNT)  # type: ignore[attr-defined]
    found: dict[Key, complex] = {
        ("force", key): complex(np.ravel(r.force)[-1]) for key, r in solved.reactions.items()
    }
    return found | {("force", "balancing"): float(np.ravel(solved.balancing)[-1])}


def _forces(values: Mapping[Key, Value]) -> dict[Key, Value]:
    return {key: value for key, value in values.items() if key[0] == "force"}


def _nothing(values: Mapping[Key, Value]) -> dict[Key, complex]:
    return {key: complex(value.exact) for key, value in values.items()}


def _worst(runs: list[Run]) -> Run:
    """Of mechanisms that differ by a jitter, kind by kind the worst; refused, if one of them is."""
    first = runs[0]
    if any(one.misses is None for one in runs):
        return Run(first.scene, first.method, first.distance, first.closeness, None, first.bounds)
    worst = {}
    for kind in KINDS:
        all_ = [one.misses[kind] for one in runs if one.misses]
        worst[kind] = Miss(
            *(float(np.max([getattr(miss, name) for miss in all_])) for name in ("times", "error", "bound"))
        )
    bounds = {kind: max(one.bounds[kind] for one in runs) for kind in KINDS}
    return Run(first.scene, first.method, first.distance, min(one.closeness for one in runs), worst, bounds)
