"""Zhukovsky's lever: the plan of velocities, turned by 90° against the driving link's rotation, as a rigid lever.

Every force acts in the end of its point's velocity; the moments about the pole, arms read off the turned plan, balance
that of the balancing force across the crank. Turned so, the crank's segment pa lies along the crank, and a couple on a
link becomes a pair of forces M/l in the ends of its segment, whose arm is that segment.
Source: Artobolevsky, Theory of mechanisms and machines, ch. 15; Zhukovsky, On the reduction of dynamic problems.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from tmm_report.chapters.lever.force_plans import lever_quantities as q
from tmm_report.chapters.lever.force_plans.drafting.plan import Acting, Couple, ForceDrawn
from tmm_report.chapters.lever.initial_data.quantities import length
from tmm_report.chapters.lever.kinetostatics.solve.positions import Kinetostatics
from tmm_report.chapters.lever.plans.solve import Comparison, Plans
from tmm_report.mechanics.calculus.vectors import cross, unit
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
    clockwise. Of a pair of forces, `pair` is the place of the other one and the arm is between them."""

    quantity: Quantity
    arm_quantity: Quantity
    point: str
    vector: complex
    place: complex
    arm: float
    moment: float
    pair: complex | None = None


@dataclass(frozen=True, eq=False)
class Lever:
    """Of one table position. `turn`: by what the plan is turned, ±1j; `arms`: of all loads; `pairs`: couples as forces;
    `balance`: the sum of moments, the balancing force and moment; `driving`: the force at the crank's point, N, and its
    place; `compared`: with the other ways."""

    position: int
    plan: Plan
    turn: complex
    arms: tuple[LeverArm, ...]
    pairs: tuple[Formula, ...]
    balance: tuple[Formula, ...]
    driving: LeverArm
    worked: Worked
    compared: tuple[Comparison, ...]

    @property
    def agrees(self) -> bool:
        return all(one.ok for one in self.compared)


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

    def solved(self) -> Lever | None:
        crank = self._crank()
        if crank is None or any(self.place(force.point) is None for _, force in self.drawn.acting):
            return None
        if (
            self.pen.read(self.place(crank[0]) or 0j) == 0
        ):  # beside the rates of far points its own is no length
            return None
        for _, force in self.drawn.acting:
            self._force(force)
        for link, couple in self.drawn.couples:
            self._pair(link, couple)
        balance, driving = self._balanced(*crank)
        compared = tuple(self._compared(balance[-1].written, driving.arm, crank[1]))
        return Lever(
            self.k, self.plan, self.turn, tuple(self.arms), tuple(self.pairs), balance, driving, self.worked, compared
        )  # fmt: skip

    # ------------------------------------------------------------ places

    def place(self, point: str) -> complex | None:
        """Where a point is on the lever, mm from the pole; None where the plan does not show it."""
        if point in self.mechanism.links[FRAME].points:
            return 0j
        drawn = self.velocities.get(f"v_{point}")
        return None if drawn is None else self.turn * drawn

    def _crank(self) -> tuple[str, complex] | None:
        """The driving link's joint farthest from its pivot, and its place from there, m."""
        pivot = self.motion.linkage.structure.driver_pair.name
        points = self.mechanism.links[self.mechanism.driver.link].points
        joints = [p for p in points if self.place(p) and (len(self.mechanism.links_at(p)) > 1)]
        joints = joints or [p for p in points if self.place(p)]
        arms = {p: self._at(p) - self._at(pivot) for p in joints}
        far = max(arms, key=lambda p: round(abs(arms[p]), 12), default=None)
        return None if far is None else (far, arms[far])

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
        ends = self._ends(link)
        if ends is None:
            return
        one, other = ends
        start, end = (self.place(p) or 0j for p in ends)
        along = self._at(other) - self._at(one)
        name = one + other
        size = self.worked.number(couple.quantity, abs(couple.value))
        formula = self.worked.hand(q.pair_force(couple.quantity), size / self._length(name, along))
        self.pairs.append(formula)
        vector = 1j * unit(along) * np.copysign(formula.written, couple.value)
        moment = cross(end - start, vector)
        arm = self.pen.read(end - start)
        product = float(round_significant(formula.written * arm * np.sign(moment), DIGITS))
        letters = "".join(map(self._letter, ends))
        of = segment_of(letters)
        self.arms.append(
            LeverArm(q.pair_force(couple.quantity), of, letters, complex(vector), end, arm, product, start)
        )

    def _letter(self, point: str) -> str:
        """Fixed points are in the pole."""
        return self.plan.pole if point in self.mechanism.links[FRAME].points else point.lower()

    def _length(self, name: str, along: complex) -> Expr:
        return self.worked.number(length(name), float(round_significant(abs(along), DIGITS + 2)))

    def _ends(self, link: str) -> tuple[str, str] | None:
        """Two points of the link, or of one that turns with it, farthest apart on the lever."""
        for own in self._turning_together(link):
            points = [p for p in self.mechanism.links[own].points if self.place(p) is not None]
            pairs = [(p, r) for i, p in enumerate(points) for r in points[i + 1 :]]
            far = max(pairs, key=lambda pair: self._apart(*pair), default=None)
            if far is not None and self._apart(*far) > 0:
                return far
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

    def _balanced(self, point: str, crank: complex) -> tuple[tuple[Formula, ...], LeverArm]:
        total = self.worked.hand(q.LEVER_SUM, self._sum())
        place = self.place(point) or 0j
        segment = self.worked.number(segment_of(f"{self.plan.pole}{point.lower()}"), self.pen.read(place))
        sum_of = self.worked.number(q.LEVER_SUM, total.written)
        force = self.worked.hand(q.LEVER_FORCE, -sum_of / segment)
        pivot = self.motion.linkage.structure.driver_pair.name
        name = pivot + point
        moment = self.worked.hand(
            q.LEVER_MOMENT, self.worked.number(q.LEVER_FORCE, force.written) * self._length(name, crank)
        )
        vector = complex(1j * unit(crank) * force.written)
        arm = LeverArm(
            q.LEVER_FORCE, segment_of(f"{self.plan.pole}{point.lower()}"), point, vector, place,
            self.pen.read(place), -total.written,
        )  # fmt: skip
        return (total, force, moment), arm

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

    def _compared(self, moment: float, pa: float, crank: complex) -> Iterator[Comparison]:
        """The lever's moment beside the others, N m; below the floor all are nothing: what half a step of reading of
        all arms makes."""
        solved = self.found.table
        floor = sum(abs(a.vector) for a in self.arms) * self.pen.read_step * abs(crank) / max(pa, 1e-9)
        others = {
            "force_plan": self.drawn.balancing,
            "power": float(solved.power[self.k]),
            "analytic": float(solved.balancing[self.k]),
        }
        for key, other in others.items():
            yield Comparison(key, moment, other, floor)


__all__ = ["Lever", "LeverArm", "levers"]
