"""Kinetic energy of the links and its rate, by which the accelerations are checked: a difference of velocities."""

from __future__ import annotations

from typing import Any

import numpy as np

from tmm_report.mechanics.calculus.roots import DIFFERENCE
from tmm_report.mechanics.calculus.vectors import dot
from tmm_report.mechanics.lever.cams.kinks import breaks as cam_breaks
from tmm_report.mechanics.lever.cams.kinks import law_sense, slope_between, slope_within
from tmm_report.mechanics.lever.high_class.newton import HigherGroup
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.mechanics.lever.meeting import meets, settle
from tmm_report.mechanics.lever.motion import SINGULAR, Motion, solve_by_law
from tmm_report.mechanics.lever.motion import solve as solve_motion

Array = Any
FULL_TURN = 2 * np.pi
STEP = 0.007  # rad, of the differences far from singular positions


def kinetic_energy(motion: Motion) -> Array:
    """Kinetic energy of all links, J, (..., P)."""
    energy = np.zeros(motion.shape)
    for name, link in motion.linkage.mechanism.links.items():
        if name != FRAME:
            if link.mass_centre is not None:
                v = motion.velocity(link.mass_centre)
                energy = energy + link.mass * dot(v, v) / 2
            energy = energy + link.inertia * motion.angular_velocity(name) ** 2 / 2
    return energy


def kinetic_power(motion: Motion) -> Array:
    """dT/dt by a difference of the kinetic energy: from velocities alone, so it checks every acceleration.

    The step shrinks where the motion changes fast: towards a singular position, and where a link turns faster than
    the driving link.
    """
    if motion.phase is not None:
        return _by_phase(motion)
    omega = motion.state.w[motion.linkage.mechanism.driver.link]
    ratios = [np.abs(motion.angular_velocity(link) / omega) for link in motion.linkage.mechanism.moving]
    shrinks = np.ones(motion.shape)
    step = np.full(motion.shape, STEP)
    for group in motion.linkage.groups:
        sine = np.maximum(motion.sines[group.group.label], SINGULAR)
        for (
            meeting
        ) in group.meetings:  # there the motion is smooth, but near positions differ by rounding errors
            beside = np.abs(np.angle(np.exp(1j * (motion.phi - meeting)))) < 0.15
            step, sine = np.where(beside, 0.03, step), np.where(beside, 1.0, sine)
        shrinks = np.minimum(shrinks, sine)
    step = step * shrinks / np.maximum.reduce(ratios)
    k = np.arange(1, len(DIFFERENCE) + 1).reshape(-1, *(1,) * len(motion.shape))
    phi = np.stack([motion.phi + k * step, motion.phi - k * step])
    beside_it = solve_motion(motion.linkage, phi)
    if meets(motion.linkage.groups):
        settle(beside_it)
    energy = kinetic_energy(beside_it)
    return _within_turn(motion, _beside_breaks(motion, _summed(energy[0] - energy[1]) / step)) * omega


def _by_phase(motion: Motion) -> Array:
    """The same of a driving link that moves by a law of the time: by its phase, which goes uniformly; within a piece
    beside the breaks of the law and the ends of one that does not repeat."""
    linkage, law = motion.linkage, motion.linkage.mechanism.driver.law
    assert law is not None and motion.phase is not None
    rate = linkage.mechanism.driver.omega
    fastest = np.maximum.reduce([np.abs(motion.angular_velocity(n) / rate) for n in linkage.mechanism.moving])
    sines = [np.maximum(motion.sines[group.group.label], SINGULAR) for group in linkage.groups]
    step = STEP * np.minimum.reduce([np.ones(motion.shape), *sines]) / np.maximum(fastest, 1.0)
    k = np.arange(1, len(DIFFERENCE) + 1).reshape(-1, *(1,) * len(motion.shape))
    energy = kinetic_energy(
        solve_by_law(linkage, np.stack([motion.phase + k * step, motion.phase - k * step]))
    )
    slope = _summed(energy[0] - energy[1]) / step
    edges = np.array(law.breaks, dtype=float) * (FULL_TURN / law.period)
    if not law.returns:
        edges = np.concatenate([[0.0, FULL_TURN], edges])
    if edges.size:
        within, near = slope_within(
            lambda phase: kinetic_energy(solve_by_law(linkage, phase)), motion.phase, 1, np.unique(edges)
        )
        slope = np.where(near, within, slope)
    return slope * rate


def _energy(motion: Motion, phi: Array) -> Array:
    """Kinetic energy at other driver angles, J."""
    there = solve_motion(motion.linkage, phi, motion.state.w[motion.linkage.mechanism.driver.link])
    if meets(motion.linkage.groups):
        settle(there)
    return kinetic_energy(there)


def _beside_breaks(motion: Motion, rate: Array) -> Array:
    """The rate of the kinetic energy by the driver's angle, near the breaks of a cam's law, and near corners, taken
    within a piece."""
    linkage = motion.linkage
    corners = [c for group in linkage.groups if (c := getattr(group, "corner", None)) is not None]
    edges = np.concatenate([cam_breaks(linkage.mechanism), corners])
    if not edges.size:
        return rate
    within, near = slope_within(
        lambda phi: _energy(motion, phi), motion.phi, law_sense(linkage.mechanism), edges
    )
    return np.where(near, within, rate)


def _within_turn(motion: Motion, rate: Array) -> Array:
    """The same of a motion that does not come back after a turn: beside its ends from values within it."""
    for group in motion.linkage.groups:
        if isinstance(group, HigherGroup) and not group.branches[0].run.returns:
            run = group.branches[0].run
            x = run.sense * (motion.phi - run.zero)
            x = np.where((x < 0) | (x > FULL_TURN), np.mod(x, FULL_TURN), x)
            within, near = slope_between(
                lambda phi: _energy(motion, phi), motion.phi, run.sense, x, FULL_TURN - x
            )
            rate = np.where(near, within, rate)
    return rate


def _summed(rows: Array) -> Array:
    """The sum of rows (N, ..., P) of a difference: of many variants each by itself, as the order in which products are
    added depends on how many there are."""
    if rows.ndim == 2:
        return np.tensordot(np.array(DIFFERENCE), rows, axes=1)
    return np.array([_summed(np.ascontiguousarray(rows[:, v])) for v in range(rows.shape[1])])
