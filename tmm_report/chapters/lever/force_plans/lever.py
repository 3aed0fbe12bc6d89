"""Zhukovsky's lever: the plan of velocities, turned by 90° against the driving link's rotation, as a rigid lever.

Every force acts in the end of its point's velocity; the moments about the pole, arms read off the turned plan, balance
that of the balancing force across the crank, or of that along the stroke where a slider or a cylinder drives. Turned
so, the crank's segment pa lies along the crank, and a couple on a link becomes a pair of forces M/l in the ends of its
segment, whose arm is that segment; of a wheel without a second point in its axis and its pitch point.
Source: Artobolevsky, Theory of mechanisms and machines, ch. 15; Zhukovsky, On the reduction of dynamic problems.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from tmm_report.chapters.lever.force_plans import lever_quantities as q
from tmm_report.chapters.lever.force_plans.drafting.plan import Acting, Couple, ForceDrawn
from tmm_report.chapters.lever.initial_data.quantities import segment_between
from tmm_report.chapters.lever.kinetostatics.quantities.driving_stroke import FORCE
from tmm_report.chapters.lever.kinetostatics.solve.positions import Kinetostatics
from tmm_report.chapters.lever.plans.solve import Comparison, Plans
from tmm_report.chapters.lever.structure.quantities import pitch_radius
from tmm_report.mechanics.calculus.vectors import cross, unit
from tmm_report.mechanics.lever.driving.stroke import Stroke
from tmm_report.mechanics.lever.mechanism import FRAME, Mechanism
from tmm_report.quantity.formula import Expr, Formula, Number
from tmm_report.quantity.model import Quantity
from tmm_report.quantity.paper import Pen
from tmm_report.quantity.text import round_significant
from tmm_report.quantity.written import DIGITS, Worked, segment_of
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.chapters.lever.plans.drafting.plan import Plan


@dataclass(frozen=True)
class LeverArm:
    """A force on the lever: N, its place, mm from the pole, its arm, mm as read, and its moment, N mm, + counter-
    clockwise. Of a pair of forces, `pair` is the place of the other one and the arm is between them; `ends`
    are then the points of the link, that of the other one first, none of a wheel's."""

    quantity: Quantity
    arm_quantity: Quantity
    point: str
    vector: complex
    place: complex
    arm: float
    moment: float
    pair: complex | None = None
    ends: tuple[str, ...] = ()


@dataclass(frozen=True, eq=False)
class Lever:
    """Of one table position. `turn`: by what the plan is turned, ±1j; `arms`: of all loads; `pairs`: couples as forces;
    `balance`: the sum of moments, the balancing force and moment, of a stroke the force alone; `driving`: that force,
    N, and its place; `compared`: with the other ways; `thrust`: whether it is along a stroke; `pitch`: pitch points of
    wheels on the lever, mm from the pole."""

    position: int
    plan: Plan
    turn: complex
    arms: tuple[LeverArm, ...]
    pairs: tuple[Formula, ...]
    balance: tuple[Formula, ...]
    driving: LeverArm
    worked: Worked
    compared: tuple[Comparison, ...]
    thrust: bool
    pitch: Mapping[str, complex]

    @property
    def agrees(self) -> bool:
        return all(one.ok for one in self.compared)


class _Drive(NamedTuple):
    """The balancing force of 1 N: its point, its direction; across the crank the pivot and the crank's length, m."""

    point: str
    along: complex
    pivot: str = ""
    length: float = 0.0


class _Ends(NamedTuple):
    """Two places of a link where a pair of forces replaces a couple: their distance and its name, m, their letters on
    the lever, their places there, mm, and the way from one to the other, m."""

    name: tuple[Quantity, float]
    letters: str
    start: complex
    end: complex
    along: complex
    points: tuple[str, ...] = ()


def levers(found: Kinetostatics, drawn: tuple[ForceDrawn, ...], plans: Plans) -> tuple[Lever, ...]:
    """Of the positions of force plans whose plan of velocities is drawn too."""
    return tuple(
        lever
        for one in drawn
        if (plan := _velocity_plan(found, one.position, plans)) is not None
        and (lever := _Lever(found, one, plan, plans).solved()) is not None
    )


def _velocity_plan(found: Kinetostatics, position: int, plans: Plans) -> Plan | None:
    """The same motion returns every turn, whatever the loads do."""
    turned, sweep = found.kinematics.turned, found.kinematics.cycle.sweep
    for one in plans.drawn:
        turns = (turned[one.position] - turned[position]) / sweep
        if abs(turns - round(turns)) < 1e-9:
            return one.velocity
    return None


class _Lever:
    """The lever of a position in the making."""

    def __init__(self, found: Kinetostatics, drawn: ForceDrawn, plan: Plan, plans: Plans):
        self.found, self.drawn, self.plan = found, drawn, plan
        self.k, self.pen = drawn.position, Pen(plans.accuracy * 1e-3)
        self.motion = found.kinematics.cycle.motion(found.kinematics.turned[self.k : self.k + 1])
        self.mechanism: Mechanism = self.motion.linkage.mechanism
        turning = self.motion.angular_velocity(self.mechanism.driver.link)
        self.turn = -1j if float(np.ravel(turning)[0]) > 0 else 1j
        self.velocities = {s.key: s.end - s.start for s in plan.strokes}
        self.worked = Worked(f"lever_{self.k}", self.k)
        self.arms: list[LeverArm] = []
        self.pairs: list[Formula] = []
        self.pitch: dict[str, complex] = {}
        self.stroke = self.mechanism.driver.stroke

    def solved(self) -> Lever | None:
        drive = self._crank() if self.stroke is None else self._thrust(self.stroke)
        if drive is None or any(self.place(force.point) is None for _, force in self.drawn.acting):
            return None
        if self.pen.read(self._arm(drive)) == 0:  # beside the rates of far points its own is no length
            return None
        for _, force in self.drawn.acting:
            self._force(force)
        for link, couple in self.drawn.couples:
            self._pair(link, couple)
        balance, driving = self._balanced(drive)
        compared = tuple(self._compared(balance[-1].written, drive))
        return Lever(
            self.k, self.plan, self.turn, tuple(self.arms), tuple(self.pairs), balance, driving, self.worked, compared,
            self.stroke is not None, self.pitch,
        )  # fmt: skip

    # ------------------------------------------------------------ places

    def place(self, point: str) -> complex | None:
        """Where a point is on the lever, mm from the pole; None where the plan does not show it."""
        if point in self.mechanism.links[FRAME].points:
            return 0j
        drawn = self.velocities.get(f"v_{point}")
        return None if drawn is None else self.turn * drawn

    def _crank(self) -> _Drive | None:
        """Across the crank in the driving link's joint farthest from its pivot."""
        pivot = self.motion.linkage.structure.driver_pair.name
        points = self.mechanism.links[self.mechanism.driver.link].points
        joints = [p for p in points if self.place(p) and (len(self.mechanism.links_at(p)) > 1)]
        joints = joints or [p for p in points if self.place(p)]
        arms = {p: self._at(p) - self._at(pivot) for p in joints}
        far = max(arms, key=lambda p: round(abs(arms[p]), 12), default=None)
        return None if far is None else _Drive(far, complex(1j * unit(arms[far])), pivot, abs(arms[far]))

    def _thrust(self, stroke: Stroke) -> _Drive | None:
        """Along the stroke in the driving slider, or where the cylinder's rod presses."""
        point = stroke.ends[-1]
        along = complex(np.ravel(stroke.along(self.motion))[0])
        return None if self.place(point) is None else _Drive(point, along)

    def _arm(self, drive: _Drive) -> float:
        """Of the balancing force about the pole, mm, above zero where it turns counter-clockwise."""
        return float(cross(self.place(drive.point) or 0j, drive.along))

    def _at(self, point: str) -> complex:
        return complex(np.ravel(self.motion.place(point))[0])

    # ------------------------------------------------------------ forces and couples

    def _force(self, force: Acting) -> None:
        place = self.place(force.point) or 0j
        moment = cross(place, unit(force.vector))
        arm = self.pen.read(moment)
        size = float(abs(force.vector))
        product = float(round_significant(size * arm * np.sign(moment), DIGITS))
        of = q.arm_on_lever(force.quantity)
        self.arms.append(LeverArm(force.quantity, of, force.point, force.vector, place, arm, product))

    def _pair(self, link: str, couple: Couple) -> None:
        """A couple as forces across the link in two of its points; one on a link that does not turn does nothing."""
        ends = self._ends(link) or self._radius(link)
        if ends is None:
            return
        name, letters, start, end, along, points = ends
        moment = self.worked.number(couple.quantity, couple.printed)
        size = moment if couple.printed > 0 else abs(moment)
        formula = self.worked.hand(q.pair_force(couple.quantity), size / self.worked.number(*name))
        self.pairs.append(formula)
        vector = 1j * unit(along) * np.copysign(formula.written, couple.value)
        moment = cross(end - start, vector)
        arm = self.pen.read(end - start)
        product = float(round_significant(formula.written * arm * np.sign(moment), DIGITS))
        of = segment_of(letters)
        self.arms.append(
            LeverArm(
                q.pair_force(couple.quantity), of, letters, complex(vector), end, arm, product, start, points
            )
        )

    def _radius(self, link: str) -> _Ends | None:
        """The axis of a wheel and its pitch point, where the plan shows no second point of it."""
        meshes = [one for one in self.mechanism.meshes if link in one.links and one.radius(link)]
        if not meshes or link not in self.plan.turns:
            return None
        mesh = meshes[0]
        axis = mesh.points[mesh.links.index(link)]
        out = complex(np.ravel(mesh.turn(self.motion.state))[0]) * mesh.outward(link) * mesh.radius(link)
        start = self.place(axis) or 0j
        end = start + self.turn * self.plan.turns[link] * out
        self.pitch[mesh.pole.lower()] = end
        radius = pitch_radius(self.motion.linkage, mesh, link), mesh.radius(link)
        return _Ends(radius, self._letter(axis) + mesh.pole.lower(), start, end, out)

    def _letter(self, point: str) -> str:
        """Fixed points are in the pole."""
        return self.plan.pole if point in self.mechanism.links[FRAME].points else point.lower()

    def _ends(self, link: str) -> _Ends | None:
        """Two points of the link, or of one that turns with it, farthest apart on the lever."""
        for own in self._turning_together(link):
            points = [p for p in self.mechanism.links[own].points if self.place(p) is not None]
            pairs = [(p, r) for i, p in enumerate(points) for r in points[i + 1 :]]
            far = max(pairs, key=lambda pair: self._apart(*pair), default=None)
            if far is not None and self._apart(*far) > 0:
                one, other = far
                start, end = (self.place(p) or 0j for p in far)
                along = self._at(other) - self._at(one)
                name = (
                    segment_between(self.mechanism, one, other),
                    float(round_significant(abs(along), DIGITS)),
                )
                return _Ends(name, "".join(map(self._letter, far)), start, end, along, far)
        return None

    def _apart(self, one: str, other: str) -> float:
        return round(abs((self.place(one) or 0j) - (self.place(other) or 0j)), 6)

    def _turning_together(self, link: str) -> list[str]:
        """The link and those that only slide on it or it on them."""
        found = [link]
        for name in found:
            for slide in self.mechanism.slides:
                both = (slide.link, self.mechanism.guides[slide.guide].link)
                if name in both:
                    other = both[1] if name == both[0] else both[0]
                    found += [other] if other not in (*found, FRAME) else []
        return found

    # ------------------------------------------------------------ balance

    def _balanced(self, drive: _Drive) -> tuple[tuple[Formula, ...], LeverArm]:
        total = self.worked.hand(q.LEVER_SUM, self._sum())
        place, arm = self.place(drive.point) or 0j, self._arm(drive)
        of, arm_of = q.LEVER_FORCE, segment_of(f"{self.plan.pole}{drive.point.lower()}")
        if not drive.length:
            of, arm_of = FORCE, q.arm_on_lever(FORCE)
        mm = self.pen.read(arm)
        sum_of = self.worked.number(q.LEVER_SUM, total.written)
        over = self.worked.number(arm_of, mm)
        force = self.worked.hand(of, (-sum_of if arm > 0 else sum_of) / over)
        found = [total, force]
        if drive.length:
            crank = segment_between(self.mechanism, drive.pivot, drive.point)
            size = self.worked.number(crank, float(round_significant(drive.length, DIGITS)))
            found.append(
                self.worked.hand(q.LEVER_MOMENT, self.worked.number(of, force.written) * size),
            )
        vector = drive.along * force.written
        return tuple(found), LeverArm(of, arm_of, drive.point, vector, place, mm, -total.written)

    def _sum(self) -> Expr:
        """Σ F·h with the senses of the moments."""
        total: Expr | None = None
        for arm in (arm for arm in self.arms if arm.arm):
            force = self.worked.number(arm.quantity, abs(arm.vector))
            term = force * self.worked.number(arm.arm_quantity, arm.arm)
            if total is None:
                total = term if arm.moment >= 0 else -term
            else:
                total = total + term if arm.moment >= 0 else total - term
        return total if total is not None else Number(0.0)

    def _compared(self, found: float, drive: _Drive) -> Iterator[Comparison]:
        """The lever's moment, N m, or its force along the stroke, N, beside the others; below the floor all are
        nothing: what half a step of reading of all arms makes."""
        solved = self.found.table
        step = self.pen.read_step * (drive.length or 1.0) / abs(self._arm(drive))
        floor = sum(abs(a.vector) for a in self.arms) * step
        others = {"force_plan": self.drawn.balancing, "power": solved.power, "analytic": solved.balancing}
        if self.stroke is not None:
            transfer = self.stroke.transfer(self.stroke.law.of_phase(solved.motion.phase)[0])
            others |= {"power": solved.power * transfer, "analytic": solved.statics.driving}
        for key, other in others.items():
            yield Comparison(key, found, float(np.ravel(other)[self.k if np.size(other) > 1 else 0]), floor)


__all__ = ["Lever", "LeverArm", "levers"]
