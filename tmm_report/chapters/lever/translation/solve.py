"""Reduced mass and reduced force of a link that slides along a guide, over the cycle; what must drive it.

The energy of the links is that of one mass that slides so, and the power of the forces that of one force along it:
m v²/2 = Σ (m v_S² + J ω²)/2,  F v = Σ F v cos α + Σ M ω. By the coordinate q of what drives (the angle of the driving
link, or a stroke), with u = ds/dq and u′ = du/dq: m = I/u², F = M/u, dm/ds = (I′ − 2 I u′/u)/u³. Where the link stands
still u is nothing, and no finite mass has the energy. The equation of motion is m dv/dt + (v²/2) dm/ds = F.
(Artobolevsky, Theory of mechanisms and machines, ch. 15–16; Frolov, Theory of mechanisms and machines, ch. 9)
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import cached_property
from typing import Any

import numpy as np

from tmm_report.chapters.lever.kinematics.solve.positions import Kinematics
from tmm_report.chapters.lever.kinetostatics.solve.positions import Kinetostatics, Solved
from tmm_report.chapters.lever.moving import Load, by_stroke, inertia_parts, inertia_slope, powers
from tmm_report.mechanics.calculus.vectors import dot
from tmm_report.mechanics.lever.cycle import Extreme, least_and_greatest
from tmm_report.mechanics.lever.driving.stroke import Stroke
from tmm_report.mechanics.lever.mechanism import FRAME, Guide, Mechanism, Slide
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.problems import N_, Message, ProblemError, mistake
from tmm_report.records import dataclass

Array = Any
STILL = 1e-6  # part of the greatest speed below which the link stands still, as groups are singular
SLOW = 0.25  # part of it below which the diagrams leave the reduced mass out: it grows without bound there


@dataclass(frozen=True, eq=False)
class Reduced:
    """At some positions: of the stroke the place `s`, m, the speed `v` and the acceleration `a` as they are; `mass`:
    link -> its part, kg; `slope`: dm/ds of the whole, kg/m; `forces`: each load with its part, N; `miss`: relative
    difference of the force needed from the balancing moment of the force analysis. Arrays (P,), nan where the link
    stands still."""

    turned: Array
    s: Array
    v: Array
    a: Array
    mass: Mapping[str, Array]
    slope: Array
    forces: tuple[Load, ...]
    miss: Array = None

    @cached_property
    def whole_mass(self) -> Array:
        return np.sum(list(self.mass.values()), axis=0)

    @cached_property
    def whole_force(self) -> Array:
        return np.sum([part for _, part in self.forces], axis=0) + 0 * self.whole_mass

    @cached_property
    def needed(self) -> Array:
        """The force along the stroke that must act for the motion as it is, N."""
        return self.whole_mass * self.a + self.v**2 * self.slope / 2 - self.whole_force


@dataclass(frozen=True, eq=False)
class Found:
    """Found by `solve`, at the table positions 0..N and at the diagram positions. `link`: that slides, "" of a driving
    cylinder; `guide`: along which, None of the stroke of what drives; `forces`: None without loads."""

    kinematics: Kinematics
    forces: Kinetostatics | None
    link: str
    guide: Guide | None
    table: Reduced
    diagram: Reduced

    @property
    def still(self) -> list[int]:
        """Table positions in which the link stands still and its reduced mass has no bound."""
        closes = self.kinematics.table.closes
        return [int(k) for k in np.flatnonzero(~np.isfinite(self.table.whole_mass) & closes)]

    @cached_property
    def extremes(self) -> tuple[Extreme, Extreme]:
        """Least and greatest reduced mass over the diagram positions, kg."""
        return least_and_greatest(self.diagram.whole_mass, self.diagram.turned)

    @cached_property
    def disagreement(self) -> float | None:
        """Worst of the positions; None without forces."""
        if self.forces is None:
            return None
        return float(max(np.nanmax(one.miss, initial=0.0) for one in (self.table, self.diagram)))


@dataclass(frozen=True, eq=False)
class _Unit:
    """The mechanism by the coordinate q of what drives: `motion` at the rate `rate` of q, which does not change."""

    motion: Motion
    rate: Array
    speed: Array  # the rate of q as it is
    growth: Array  # and its acceleration

    @property
    def inertia(self) -> dict[str, Array]:
        omega = self.motion.omega / self.rate
        return {link: part * omega**2 for link, part in inertia_parts(self.motion)}

    @property
    def slope(self) -> Array:
        return inertia_slope(self.motion) * (self.motion.omega / self.rate) ** 3


def solve(link: str, kinematics: Kinematics, forces: Kinetostatics | None) -> Found:
    """`link`: a link that slides, or "" for the stroke of what drives. Raises ProblemError where no mass moves."""
    mechanism, stroke = kinematics.linkage.mechanism, kinematics.stroke
    slide = _slide(mechanism, link) if link else None
    sets = (
        (kinematics.table, kinematics.turned, forces.table if forces else None, STILL),
        (kinematics.diagram, kinematics.diagram_turned, forces.diagram if forces else None, SLOW),
    )
    found = []
    with np.errstate(invalid="ignore", divide="ignore"):
        for motion, turned, solved, least in sets:
            unit = _unit(motion, stroke)
            found.append(_reduced(unit, motion, slide, turned, forces, solved, least))
    table, diagram = found
    if not np.any(np.nan_to_num(table.whole_mass)):
        right = Message(N_("give the links their mass, mass_centre and inertia"))
        wrong = N_("there is nothing to reduce: no mass of the links moves")
        raise ProblemError([mistake(wrong, ("reduction",), right)])
    name = link or (stroke.by[0] if stroke is not None and stroke.slides else "")
    guide = mechanism.guides[slide.guide] if slide is not None else None
    return Found(kinematics, forces, name, guide, table, diagram)


def _slide(mechanism: Mechanism, link: str) -> Slide:
    """That along a guide of the frame, of a link that slides along several."""
    own = [one for one in mechanism.slides if one.link == link]
    return next((one for one in own if mechanism.guides[one.guide].link == FRAME), own[0])


def _unit(motion: Motion, stroke: Stroke | None) -> _Unit:
    """By the angle of the driving link as it turns, uniformly; by a stroke with the speed 1."""
    if stroke is None:
        return _Unit(motion, motion.omega, motion.omega, 0.0)
    s, v, a = stroke.law.of_phase(motion.phase)
    return _Unit(by_stroke(motion, stroke, s), 1.0, v, a)


def along(motion: Motion, slide: Slide) -> tuple[Array, Array, Array]:
    """Place of a link along its guide from the point that the guide is stated by, m, speed and acceleration: where the
    guide turns, as seen from it."""
    state, mechanism = motion.state, motion.linkage.mechanism
    guide = mechanism.guides[slide.guide]
    on, link = guide.link, slide.link
    e = state.u[on] * guide.direction
    own, base = state.u[link] * (slide.through - state.o[link]), state.u[on] * (guide.through - state.o[on])
    r = state.r[link] + own - state.r[on] - base
    v = state.velocity(link, own) - state.velocity(on, base)
    a = state.acceleration(link, own) - state.acceleration(on, base)
    turning, growing = state.iw[on] * e, state.ie[on] * e
    found = (dot(r, e), dot(v, e), dot(a, e) + 2 * dot(v, turning) + dot(r, growing))
    s, v, a = (np.broadcast_to(one, motion.shape) for one in found)
    return s, v, a


def _reduced(
    unit: _Unit,
    motion: Motion,
    slide: Slide | None,
    turned: Array,
    forces: Kinetostatics | None,
    solved: Solved | None,
    least: float,
) -> Reduced:
    """`least`: part of the greatest speed below which the cells are blank."""
    if slide is not None:
        s, v, a = along(unit.motion, slide)
        u, du = v / unit.rate, a / unit.rate**2
        slow = np.abs(u) <= least * np.nanmax(np.abs(u), initial=0.0)
    else:
        of = motion.linkage.mechanism.driver.stroke
        assert of is not None
        s, u, du = of.law.of_phase(motion.phase)[0], np.ones(motion.shape), 0.0
        slow = np.zeros(motion.shape, dtype=bool)
    by = np.where(slow, np.nan, u)
    inertia = unit.inertia
    whole = np.sum(list(inertia.values()), axis=0)
    loads: tuple[Load, ...] = ()
    if forces is not None and solved is not None:
        taken = powers(forces.given, unit.motion, solved.loading)
        loads = tuple((of_load, power / unit.rate / by) for of_load, power in taken)
    found = Reduced(
        turned, s, u * unit.speed, du * unit.speed**2 + u * unit.growth,
        {name: part / by**2 for name, part in inertia.items()},
        (unit.slope - 2 * whole * du / by) / by**3, loads,
    )  # fmt: skip
    if solved is None:
        return found
    moment = found.needed * u * unit.rate / unit.motion.omega  # on the driving link
    return replace(found, miss=solved.disagreement(moment))
