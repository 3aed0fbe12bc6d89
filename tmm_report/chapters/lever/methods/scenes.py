"""What methods are tried on, and judged by with 40 digits: the motion of a mechanism, its forces, the work of its
loads over the cycle."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import lru_cache
from typing import Any

import numpy as np

from tmm_report.chapters.lever.kinematics.solve.positions import Kinematics
from tmm_report.chapters.lever.kinetostatics.solve.positions import Kinetostatics, breaks, loading
from tmm_report.chapters.lever.methods.scene import scene
from tmm_report.chapters.lever.moving import Moving, powers
from tmm_report.mechanics.lever.cycle import Cycle
from tmm_report.mechanics.lever.forces.reactions import Statics
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.mechanics.rivals import exact
from tmm_report.mechanics.rivals.exact import forces as exact_forces
from tmm_report.mechanics.rivals.forces import FORCES
from tmm_report.mechanics.rivals.integrals import INTEGRALS, Sampled
from tmm_report.mechanics.rivals.integrals import exact as by_panels
from tmm_report.mechanics.rivals.model import Loaded, Pair
from tmm_report.mechanics.rivals.motion.every import MOTIONS
from tmm_report.mechanics.rivals.trials import Errors, Rivals, errors_of, force_rows, motion_rows

Array = Any
Counts = tuple[int, ...]
Acting = Callable[..., exact_forces.Acting]
KINDS = ("place", "velocity", "acceleration")


def motions(found: Kinematics, counts: Counts) -> Rivals[Cycle, Motion]:
    """The methods of the motion, judged by 40 digits."""
    cycle = found.cycle

    @lru_cache
    def known(count: int) -> Mapping[str, Pair]:
        pairs = exact.motion(cycle, cycle.phi(cycle.once(count))).pairs
        return {kind: pairs[kind] for kind in KINDS}

    def errors(count: int, motion: Motion) -> Errors:
        return errors_of(known(count), motion_rows(motion))

    return Rivals(MOTIONS, cycle, errors, counts)


def forces(found: Kinetostatics, counts: Counts, acting: Acting) -> Rivals[Loaded, Statics]:
    """The methods of the forces, judged by 40 digits; `acting`: what acts at an exact motion (kinetostatics'
    `exactly`)."""
    kinematics, cycle = found.kinematics, found.kinematics.cycle
    keys = [pair.key for pair in cycle.linkage.structure.pairs]

    @lru_cache
    def known(count: int) -> Mapping[str, Pair]:
        motion = cycle.motion(cycle.once(count))
        turned = np.arange(count + 1) * (cycle.period / count)
        at = exact.motion(cycle, motion.phi)
        loads = acting(found.given, kinematics, motion, at, turned)
        return exact_forces.forces(at, loads).pairs

    def errors(count: int, statics: Statics) -> Errors:
        return errors_of(known(count), force_rows(keys, statics))

    return Rivals(FORCES, scene(found.given, kinematics), errors, counts)


def work(moving: Moving, counts: Counts) -> Rivals[Sampled, Array] | None:
    """The work of the loads over the cycle, judged by Gauss's formula between the kinks; None where there is
    none, or the mechanism does not go all round."""
    loads = moving.forces
    if loads is None or moving.kinematics.gaps or not moving.kinematics.cycle.closed:
        return None
    sampled = Sampled(
        _power(moving.kinematics, loads),
        moving.kinematics.cycle.period,
        breaks(loads.given, moving.kinematics),
    )
    size = by_panels(Sampled(lambda x: np.abs(sampled.of(x)), sampled.period, sampled.breaks))
    if not size > 0:
        return None
    true = by_panels(sampled)
    return Rivals(INTEGRALS, sampled, lambda _, found: {"work": float(abs(found - true) / size)}, counts)


def _power(kinematics: Kinematics, loads: Kinetostatics) -> Callable[[Array], Array]:
    """Moment of all weights and stated loads reduced to the driving link, N m, by the angle turned, rad."""
    cycle = kinematics.cycle

    def of(turned: Array) -> Array:
        motion = cycle.motion(np.mod(turned, cycle.sweep))
        load = loading(loads.given, kinematics, motion, turned)
        parts = (power for _, power in powers(loads.given, motion, load))
        return sum(parts, np.zeros(motion.shape)) / abs(motion.omega)

    return of
