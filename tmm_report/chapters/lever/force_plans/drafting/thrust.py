"""The force plans where a slider or a hydraulic cylinder drives: the balancing force along the stroke closes the last.

Between the link OP that follows the stroke and the point Q stands a rod, or the cylinder as one body of its length at
the moment. The moments of its loads about Q give the part of the reaction in P across PQ; those of the link about O
the part along PQ, with its arm read off the scheme. Polygons give the rest: of the link, of the rod or the cylinder,
and of the slider or the cylinder's rod alone, where the balancing force along the stroke and the normal reaction of the
guide close it. A cylinder without links of its own presses along PQ, and this is the balancing force.
Source: Artobolevsky, Theory of mechanisms and machines, ch. 13.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from tmm_report.chapters.lever.force_plans.drafting.dyad import reaction_held
from tmm_report.chapters.lever.force_plans.drafting.plan import (
    Acting,
    Arm,
    ForcePlan,
    ForceStroke,
    Held,
    Kind,
    Stage,
)
from tmm_report.chapters.lever.force_plans.drafting.sheet import Sheet, laid_end_to_end
from tmm_report.chapters.lever.force_plans.quantities import arm as arm_of
from tmm_report.chapters.lever.force_plans.quantities import moment_sum
from tmm_report.chapters.lever.kinetostatics.quantities.driving_stroke import FORCE
from tmm_report.chapters.lever.kinetostatics.quantities.positions import reaction, reaction_part
from tmm_report.mechanics.calculus.vectors import cross, dot, resolve, unit
from tmm_report.mechanics.lever.assur_groups import Pair
from tmm_report.mechanics.lever.driving.triangle import Triangle
from tmm_report.mechanics.lever.dyads import Dyad
from tmm_report.mechanics.lever.high_class.newton import HigherGroup
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.quantity.formula import Formula, Number, Term, VectorEquation
from tmm_report.quantity.model import Quantity
from tmm_report.quantity.text import round_significant
from tmm_report.quantity.written import DIGITS
from tmm_report.records import dataclass


def carries(sheet: Sheet, group: Dyad | HigherGroup) -> bool:
    """Whether a group holds the slider or the links of the cylinder: it has no plan of its own."""
    stroke = sheet.mechanism.driver.stroke
    return stroke is not None and bool(set(stroke.by) & set(group.links))


def plans(sheet: Sheet) -> tuple[list[ForcePlan], float]:
    """The plans, and the balancing force, N, above zero where the stroke grows by it."""
    stroke = sheet.mechanism.driver.stroke
    assert isinstance(stroke, Triangle)
    line = _Line.of(sheet, stroke)
    sheet.begin()
    first, pushed = _led(sheet, line)
    if not line.bodies:
        return [first], pushed.written
    sheet.begin()
    second = _line(sheet, line)
    sheet.begin()
    third, force = _thrust(sheet, line)
    of_line = tuple(
        arm for arm in first.arms if arm.link in line.bodies
    )  # dimensioned where these links are shown
    first = replace(first, arms=tuple(arm for arm in first.arms if arm not in of_line))
    return [first, replace(second, arms=of_line), third], force.written


@dataclass(frozen=True, eq=False)
class _Line:
    """`O`, `P`, `Q`: world places of the points, m; `along`: direction in which the stroke grows; `bodies`: the rod, or
    barrel and rod of the cylinder, none of one without links; `end`: the one that is pivoted to the link in P by the
    pair `pin`; `far`: its pair in Q; `guide`: the pair along which the force acts, `pushed` the link that takes it."""

    stroke: Triangle
    O: complex
    P: complex
    Q: complex
    along: complex
    bodies: tuple[str, ...] = ()
    end: str = ""
    pin: Pair | None = None
    far: Pair | None = None
    guide: Pair | None = None
    pushed: str = ""

    @property
    def out(self) -> complex:
        """From Q to P, unit complex."""
        return complex(unit(self.P - self.Q))

    @staticmethod
    def of(sheet: Sheet, stroke: Triangle) -> _Line:
        O, P, Q = (complex(np.ravel(sheet.motion.place(name))[0]) for name in stroke.names)
        along = complex(np.ravel(stroke.along(sheet.motion))[0])
        group = next((g.group for g in sheet.motion.linkage.groups if carries(sheet, g)), None)
        if group is None:
            return _Line(stroke, O, P, Q, along)
        pairs = (*group.outer, *group.inner)
        pin = next(p for p in pairs if p.kind == "R" and stroke.link in p.links)
        end = pin.other(stroke.link)
        guide = next(p for p in pairs if p.kind == "P")
        far = next(p for p in pairs if p.kind == "R" and p is not pin)
        bodies = (end,) if stroke.slides else stroke.by
        pushed = stroke.by[0] if stroke.slides else end
        return _Line(stroke, O, P, Q, along, bodies, end, pin, far, guide, pushed)


# ---------------------------------------------------------------- the link that follows the stroke


def _led(sheet: Sheet, line: _Line) -> tuple[ForcePlan, Formula]:
    """The link OP: what the rod or the cylinder does to it in P, from moments; its pivot from the polygon."""
    link, pivot = line.stroke.link, sheet.motion.linkage.structure.driver_pair
    arms: list[Arm] = []
    formulas: list[Formula] = []
    start = len(sheet.acting[link])
    if line.bodies:
        _across(sheet, line, arms, formulas)
    normal = reaction_part(line.end, link, "n") if line.bodies else FORCE
    along = line.out if line.bodies else line.along
    pressed = _along(sheet, line, (normal, along), arms, formulas)
    force = along * pressed.written
    corners = laid_end_to_end(sheet, (link,))
    mu = sheet.scale_of((link,), [p for p in (pivot, line.pin) if p], [*corners, corners[-1] + force])
    strokes, tip = sheet.laid_off(link, 0j, mu)
    begin = strokes[start].start if len(strokes) > start else tip
    end = tip + sheet.pen.place(force / mu)
    of = reaction(FRAME, link)
    kind: Kind = "component" if line.bodies else "reaction"
    strokes.append(ForceStroke(tip, end, normal, kind))
    held = [Held(of, link, -end * mu, sheet.joint(pivot)), Held(normal, link, force, line.P, kind)]
    readings = [sheet.read(of, end, pivot, mu)]
    if line.pin is not None:
        whole = reaction(line.end, link)
        strokes.append(ForceStroke(begin, end, whole, "reaction"))
        readings.append(sheet.read(whole, end - begin, line.pin, mu))
    strokes.append(ForceStroke(end, 0j, of, "reaction"))
    equation = VectorEquation([[*sheet.terms(link), Term(normal.sign, 2), Term(of.sign, 0)], []])
    drawn = _drawn(sheet, "led", (link,), mu, strokes, equation, held, readings, arms, formulas)
    if line.pin is not None:
        sheet.pass_on(line.pin, link, end - begin, mu)
    return drawn, pressed


def _across(sheet: Sheet, line: _Line, arms: list[Arm], formulas: list[Formula]) -> None:
    """The part of the reaction on the link across PQ, laid on it as a load."""
    _, pin, far = line.stroke.names
    link, of = line.stroke.link, reaction_part(line.end, line.stroke.link, "t")
    total = sheet.moment_sum(line.bodies, far, line.Q, arms)
    if isinstance(total, Number):
        formulas.append(sheet.hand(of, Number(0.0)))
        return
    known = moment_sum(far, line.bodies, sheet.in_mm)
    formulas.append(sheet.hand(known, total))
    moment = sheet.number(known, formulas[-1].written)
    formulas.append(sheet.hand(of, moment / sheet.length(far, pin, abs(line.P - line.Q))))
    vector = 1j * line.out * formulas[-1].written
    sense = -1 if formulas[-1].written < 0 else 1
    sheet.acting[link].append(Acting(of, "component", vector, line.P, pin, sense))


def _along(
    sheet: Sheet, line: _Line, sought: tuple[Quantity, complex], arms: list[Arm], formulas: list[Formula]
) -> Formula:
    """The force on the link in P of the direction that is given, from the moments about O."""
    of, along = sought
    link, pivot = line.stroke.link, line.stroke.names[0]
    total = sheet.moment_sum((link,), pivot, line.O, arms)
    turning = float(cross(line.P - line.O, along))
    mm = sheet.pen.read(abs(turning) / sheet.mu_l)
    metres = float(round_significant(mm * sheet.mu_l, DIGITS + 2))
    name = arm_of(of, pivot, sheet.in_mm)
    arms.append(Arm(of, pivot, mm, metres, name, link, line.O, line.P, along))
    if isinstance(total, Number):
        formulas.append(sheet.hand(of, Number(0.0)))
    else:
        known = moment_sum(pivot, (link,), sheet.in_mm)
        formulas.append(sheet.hand(known, total))
        moment = sheet.number(known, formulas[-1].written)
        arm = sheet.number(name, mm if sheet.in_mm else metres)
        formulas.append(sheet.hand(of, (-moment if turning > 0 else moment) / arm))
    if not line.bodies:
        exact = float(np.broadcast_to(sheet.solved.statics.driving, sheet.solved.motion.shape)[sheet.k])
        sheet.compare(of, formulas[-1], exact, sheet.moment_floor(link) / abs(turning))
    return formulas[-1]


# ---------------------------------------------------------------- what stands between


def _line(sheet: Sheet, line: _Line) -> ForcePlan:
    """The rod, or the cylinder as one body: its joint in Q closes the polygon."""
    assert line.far is not None
    near = next(link for link in line.far.links if link in line.bodies)
    of = reaction(line.far.other(near), near)
    mu = sheet.scale_of(line.bodies, (line.far,), laid_end_to_end(sheet, line.bodies))
    strokes: list[ForceStroke] = []
    tip = 0j
    for link in line.bodies:
        own, tip = sheet.laid_off(link, tip, mu)
        strokes += own
    strokes.append(ForceStroke(tip, 0j, of, "reaction"))
    reading = sheet.read(of, tip, line.far, mu)
    terms = [term for link in line.bodies for term in sheet.terms(link)]
    equation = VectorEquation([[*terms, Term(of.sign, 0)], []])
    held = [Held(of, near, -tip * mu, line.Q)]
    drawn = _drawn(sheet, "line", line.bodies, mu, strokes, equation, held, [reading], [], [])
    sheet.pass_on(line.far, near, -tip, mu)
    return drawn


def _thrust(sheet: Sheet, line: _Line) -> tuple[ForcePlan, Formula]:
    """The slider, or the cylinder's rod alone: the force along the stroke and the reaction across the guide."""
    assert line.guide is not None
    link = line.pushed
    of = reaction(line.guide.other(link), link)
    exact = float(np.broadcast_to(sheet.solved.statics.driving, sheet.solved.motion.shape)[sheet.k])
    corners = laid_end_to_end(sheet, (link,))
    mu = sheet.scale_of((link,), (line.guide,), [*corners, corners[-1] + exact * line.along])
    strokes, tip = sheet.laid_off(link, 0j, mu)
    x, _ = resolve(-tip, line.along, -1j * line.along)
    end = sheet.pen.place(complex(tip + x * line.along))
    strokes += [ForceStroke(tip, end, FORCE, "reaction"), ForceStroke(end, 0j, of, "reaction")]
    sign = -1 if dot(end - tip, line.along) < 0 else 1
    force = sheet.read_force(FORCE, end - tip, exact, mu, sign)
    readings = [force, sheet.read(of, end, line.guide, mu)]
    equation = VectorEquation([[Term(of.sign, 1), *sheet.terms(link), Term(FORCE.sign, 1)], []])
    at = line.Q if line.stroke.slides else line.P
    held = [
        Held(FORCE, link, (end - tip) * mu, at),
        reaction_held(sheet, line.guide, of, link, -end * mu),
    ]
    return _drawn(sheet, "thrust", (link,), mu, strokes, equation, held, readings, [], []), force


def _drawn(
    sheet: Sheet,
    stage: Stage,
    links: tuple[str, ...],
    mu: float,
    strokes: list[ForceStroke],
    equation: VectorEquation,
    held: Sequence[Held],
    readings: Sequence[Formula],
    arms: list[Arm],
    formulas: list[Formula],
) -> ForcePlan:
    loads = {link: tuple(sheet.acting[link]) for link in links}
    couples = {link: tuple(sheet.couples[link]) for link in links}
    return ForcePlan(
        f"s({','.join(links)})", links, mu, loads, couples, tuple(arms), tuple(formulas), equation,
        tuple(strokes), tuple(readings), held=tuple(held), chosen=sheet.chosen, stage=stage, poles=sheet.poles(links),
        together=True,
    )  # fmt: skip
