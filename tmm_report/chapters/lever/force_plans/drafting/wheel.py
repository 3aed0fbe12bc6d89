"""The force plan of a link that a mesh moves: the force in the teeth along the line of action, the rest its bearing.

Of a wheel the moments about its axis give the force, its arm being the radius of the base circle; the bearing closes
the polygon. Of a rack both directions are known, that of the line of action and that across the guide, and the polygon
gives both forces. On which flank the teeth press, the loads decide.
Source: Frolov (ed.), Theory of mechanisms, ch. 5.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tmm_report.chapters.lever.force_plans.drafting.dyad import reaction_held
from tmm_report.chapters.lever.force_plans.drafting.plan import Arm, ForcePlan, ForceStroke, Held, Stage
from tmm_report.chapters.lever.force_plans.drafting.sheet import Sheet, laid_end_to_end
from tmm_report.chapters.lever.force_plans.quantities import MU_L, base_radius, moment_sum
from tmm_report.chapters.lever.force_plans.quantities import arm as arm_of
from tmm_report.chapters.lever.kinetostatics.quantities.positions import reaction
from tmm_report.chapters.lever.kinetostatics.quantities.wheels import engagement_of
from tmm_report.chapters.lever.structure.quantities import pitch_radius
from tmm_report.mechanics.calculus.vectors import dot, resolve, unit
from tmm_report.mechanics.lever.wheels.coupled import Coupled
from tmm_report.quantity.formula import Expr, Formula, Number, Term, Var, VectorEquation, cos
from tmm_report.quantity.text import round_significant
from tmm_report.quantity.written import DIGITS


def plan(sheet: Sheet, wheel: Coupled) -> ForcePlan:
    """Draw the plan, read the reactions and load the links that bear the wheel and that its teeth press."""
    return _rack(sheet, wheel) if wheel.slides else _wheel(sheet, wheel)


def _line(sheet: Sheet, wheel: Coupled, tangential: float) -> complex:
    """Direction of the force in the teeth on the link, unit complex, by the sign of its tangential part."""
    turn = complex(np.ravel(wheel.mesh.turn(sheet.motion.state))[0])
    return complex(unit(turn * wheel.mesh.pressed(wheel.link, np.copysign(1.0, tangential))))


def _wheel(sheet: Sheet, wheel: Coupled) -> ForcePlan:
    link, mesh, bearing = wheel.link, wheel.mesh, wheel.bearing
    arms: list[Arm] = []
    formulas, moment = _teeth(sheet, wheel, arms)
    along, teeth = _line(sheet, wheel, -moment), reaction(wheel.by, link)
    force = along * formulas[-1].written
    of = reaction(bearing.other(link), link)
    corners = laid_end_to_end(sheet, (link,))
    mu = sheet.scale_of((link,), (bearing, wheel.contact), [*corners, corners[-1] + force])
    strokes, tip = sheet.laid_off(link, 0j, mu)
    end = tip + sheet.pen.place(force / mu)
    strokes += [ForceStroke(tip, end, teeth, "reaction"), ForceStroke(end, 0j, of, "reaction")]
    reading = sheet.read(of, end, bearing, mu)
    held = Held(teeth, link, force, sheet.touch(mesh)), Held(of, link, -end * mu, sheet.joint(bearing))
    equation = VectorEquation([[*sheet.terms(link), Term(teeth.sign, 2), Term(of.sign, 0)], []])
    drawn = _drawn(sheet, wheel, mu, strokes, equation, held, (reading,))
    sheet.load(wheel.contact, link, force)
    sheet.pass_on(bearing, link, -end, mu)
    stage: Stage = "rolling" if mesh.rolls else "wheel"
    return replace(drawn, arms=tuple(arms), moments=tuple(formulas), stage=stage)


def _teeth(sheet: Sheet, wheel: Coupled, arms: list[Arm]) -> tuple[list[Formula], float]:
    """The sum of the moments about the axis, the radius of the base circle, the size of the force; and that sum."""
    link, mesh, axis = wheel.link, wheel.mesh, wheel.bearing
    of, centre = reaction(wheel.by, link), sheet.joint(axis)
    total = sheet.moment_sum((link,), axis.name, centre, arms)
    if isinstance(total, Number):
        force = sheet.hand(of, Number(0.0))
        sheet.compare(of, force, abs(sheet.exact(wheel.contact)), 0.0)
        return [force], 0.0
    known = moment_sum(axis.name, (link,), sheet.in_mm)
    formulas = [sheet.hand(known, total)]
    moment: Expr = abs(sheet.number(known, formulas[0].written))
    if sheet.in_mm:
        moment = moment * sheet.number(MU_L, sheet.mu_l)
    arm = sheet.number(pitch_radius(sheet.motion.linkage, mesh, link), mesh.radius(link))
    if mesh.pressure:
        formulas.append(_base(sheet, wheel, arm))
        arm = sheet.number(base_radius(mesh, link), formulas[-1].written)
    formulas.append(sheet.hand(of, moment / arm))
    floor = sheet.moment_floor(link) / arm.value
    sheet.compare(of, formulas[-1], abs(sheet.exact(wheel.contact)), floor)
    mm = sheet.pen.read(arm.value / sheet.mu_l)
    metres = float(round_significant(mm * sheet.mu_l, DIGITS + 2))
    along, name = _line(sheet, wheel, -formulas[0].written), arm_of(of, axis.name, sheet.in_mm)
    arms.append(Arm(of, axis.name, mm, metres, name, link, centre, sheet.touch(mesh), along))
    return formulas, formulas[0].written


def _base(sheet: Sheet, wheel: Coupled, radius: Var) -> Formula:
    mesh = wheel.mesh
    angle = sheet.number(engagement_of(mesh), float(np.degrees(mesh.pressure)))
    return sheet.hand(base_radius(mesh, wheel.link), radius * cos(replace(angle, number=mesh.pressure)))


def _rack(sheet: Sheet, wheel: Coupled) -> ForcePlan:
    link, mesh, bearing = wheel.link, wheel.mesh, wheel.bearing
    teeth, of = reaction(wheel.by, link), reaction(bearing.other(link), link)
    loads = laid_end_to_end(sheet, (link,))
    along = _line(sheet, wheel, -float(dot(loads[-1], 1j * mesh.outward(link))))
    size = abs(sheet.exact(wheel.contact))
    mu = sheet.scale_of((link,), (bearing, wheel.contact), [*loads, loads[-1] + along * size])
    strokes, tip = sheet.laid_off(link, 0j, mu)
    x, _ = resolve(-tip, along, -1j * sheet.guide(bearing))
    end = sheet.pen.place(complex(tip + x * along))
    strokes += [ForceStroke(tip, end, teeth, "reaction"), ForceStroke(end, 0j, of, "reaction")]
    readings = sheet.read(teeth, end - tip, wheel.contact, mu), sheet.read(of, end, bearing, mu)
    held = (
        Held(teeth, link, (end - tip) * mu, sheet.touch(mesh)),
        reaction_held(sheet, bearing, of, link, -end * mu),
    )
    equation = VectorEquation([[Term(of.sign, 1), *sheet.terms(link), Term(teeth.sign, 1)], []])
    drawn = _drawn(sheet, wheel, mu, strokes, equation, held, readings)
    sheet.pass_on(wheel.contact, link, end - tip, mu)
    return replace(drawn, stage="rack")


def _drawn(
    sheet: Sheet,
    wheel: Coupled,
    mu: float,
    strokes: list[ForceStroke],
    equation: VectorEquation,
    held: tuple[Held, ...],
    readings: tuple[Formula, ...],
) -> ForcePlan:
    link = wheel.link
    return ForcePlan(
        f"z({link})", (link,), mu,
        {link: tuple(sheet.acting[link])}, {link: tuple(sheet.couples[link])},
        (), (), equation, tuple(strokes), readings, held=held, chosen=sheet.chosen, poles=sheet.poles((link,)),
    )  # fmt: skip
