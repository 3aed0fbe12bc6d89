"""Quantities of one position: exact with their bounds, and as a motion in doubles has them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from benchmarks.near_singular.bound import Key, Value, bounded
from benchmarks.near_singular.closed import Body, Number, chain, exactly, forces
from benchmarks.near_singular.scenes import GRAVITY, PUSH, Scene
from tmm_report.mechanics.calculus.vectors import cross
from tmm_report.mechanics.lever.assur_groups import decompose
from tmm_report.mechanics.lever.cycle import Cycle
from tmm_report.mechanics.lever.dyads import Dyad
from tmm_report.mechanics.lever.forces import reactions as statics
from tmm_report.mechanics.lever.mechanism import Mechanism
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.mechanics.lever.motion import solve as solve_motion
from tmm_report.mechanics.rivals.exact.moving import starts
from tmm_report.mechanics.rivals.exact.scheme import scheme
from tmm_report.mechanics.rivals.exact.solving import solved

KINDS = ("place", "velocity", "acceleration", "force")
DIGITS = 60
ZERO = 1e-14  # of the largest of its kind: a value that is nothing


def exact(scene: Scene, cycle: Cycle, phi: float) -> dict[Key, Value] | None:
    """All quantities in the position `phi`, rad, with their bounds: dyads in their first roots by closed formulas,
    groups above class II from the solution in doubles on. None where the mechanism cannot be assembled."""
    start = starts(solve_motion(cycle.linkage, np.array([phi])))[0]

    def solve(mechanism: Mechanism, angle: Number) -> Mapping[Key, Number]:
        if all(isinstance(group, Dyad) for group in cycle.linkage.groups):
            whole = chain(mechanism, [1] * len(cycle.linkage.groups))
            return named(scene, mechanism, whole.structure, whole.motion(angle, mechanism.driver.omega))
        structure = decompose(mechanism)
        pose = start and solved(scheme(structure), angle, start, DIGITS)
        if pose is None:
            raise ArithmeticError("no position")
        return named(scene, mechanism, structure, {link: carried(body) for link, body in pose.items()})

    try:
        values = bounded(cycle.linkage.mechanism, phi, solve)
    except (ArithmeticError, ValueError):
        return None
    large: dict[str, Number] = {}
    for (kind, _), value in values.items():
        large[kind] = max(abs(value.exact), large.get(kind, 0))
    return {key: value for key, value in values.items() if abs(value.exact) > ZERO * large[key[0]]}


def carried(body: Any) -> Body:
    """A link's motion in numbers of this benchmark's own context."""
    return Body(*(exactly(getattr(body, name)) for name in ("r", "u", "v", "w", "a", "e")))


def named(scene: Scene, m: Mechanism, structure: Any, pose: Mapping[str, Any]) -> dict[Key, Number]:
    found: dict[Key, Number] = {}
    for link, body in m.links.items():
        for point, at in body.points.items():
            if ("place", point) not in found:
                found["place", point] = pose[link].place(at)
                found["velocity", point] = pose[link].velocity(at)
                found["acceleration", point] = pose[link].acceleration(at)
        found["velocity", link], found["acceleration", link] = pose[link].w, pose[link].e
    link, point = scene.push
    reactions = forces(structure, pose, GRAVITY, {link: (PUSH, point)})
    return found | {("force", pair): force for pair, force in reactions.items()}


def found(scene: Scene, motion: Motion, k: int = -1) -> dict[Key, Any]:
    """The same of a motion in doubles, at its position `k`; the forces by groups."""
    values: dict[Key, Any] = {}
    for point in motion.point_index:
        values["place", point] = complex(motion.place(point)[k])
        values["velocity", point] = complex(motion.velocity(point)[k])
        values["acceleration", point] = complex(motion.acceleration(point)[k])
    for link in motion.linkage.mechanism.links:
        values["velocity", link] = float(motion.angular_velocity(link)[k])
        values["acceleration", link] = float(motion.angular_acceleration(link)[k])
    solved = statics.solve(motion, loads(scene, motion))
    values |= {
        ("force", pair): complex(np.broadcast_to(r.force, motion.shape)[k])
        for pair, r in solved.reactions.items()
    }
    values["force", "balancing"] = float(np.broadcast_to(solved.balancing, motion.shape)[k])
    return values


def loads(scene: Scene, motion: Motion) -> dict[str, statics.Load]:
    """Weight, inertia and the push."""
    acting = statics.inertia_and_gravity(motion, GRAVITY)
    link, point = scene.push
    arm = motion.place(point) - motion.state.r[link]
    load = acting[link]
    acting[link] = replace(load, force=load.force + PUSH, moment=load.moment + cross(arm, PUSH))
    return acting


@dataclass(frozen=True)
class Miss:
    """How far one kind of quantity is off: in conditioning bounds, and relative to the largest of its kind; `bound` of
    that largest error, likewise relative. nan where something was not found."""

    times: float
    error: float
    bound: float


def misses(values: Mapping[Key, Value], got: Mapping[Key, Any]) -> dict[str, Miss]:
    """By kind. Points and links are of one kind, but have a largest of their own."""
    found = {}
    for kind in KINDS:
        times, error, bound = 0.0, 0.0, 0.0
        for part in (str.isdigit, lambda name: not name.isdigit()):
            here = {k: v for k, v in values.items() if k[0] == kind and part(k[1])}
            size = max((abs(v.exact) for v in here.values()), default=1)
            for key, value in here.items():
                off = value.times(got[key]) if np.isfinite(got[key]) else np.nan
                times = float(np.maximum(times, off))
                error = float(np.maximum(error, off * float(value.bound / size)))
                bound = max(bound, float(value.bound / size))
        found[kind] = Miss(times, error, bound)
    return found
