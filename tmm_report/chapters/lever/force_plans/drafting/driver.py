"""The force plan of the driving link: balancing moment from the moments, reaction of the frame from the plan."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tmm_report.chapters.lever.force_plans.drafting.plan import Arm, Couple, ForcePlan, ForceStroke, Held
from tmm_report.chapters.lever.force_plans.drafting.sheet import Sheet, laid_end_to_end
from tmm_report.chapters.lever.force_plans.quantities import MU_L
from tmm_report.chapters.lever.force_plans.quantities import arm as arm_of
from tmm_report.chapters.lever.kinetostatics.quantities.positions import (
    ANGLE,
    BALANCING_MOMENT,
    BASE_RADIUS,
    FORCE,
    PITCH_RADIUS,
    reaction,
)
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.quantity.formula import Formula, Term, VectorEquation, cos
from tmm_report.quantity.text import round_significant
from tmm_report.quantity.written import DIGITS


def plan(sheet: Sheet) -> tuple[ForcePlan, float]:
    """The plan, and the balancing moment about the link's pivot, N m; a gear on the link gives a force in its place."""
    link, pair = sheet.mechanism.driver.link, sheet.motion.linkage.structure.driver_pair
    arms: list[Arm] = []
    total = sheet.moment_sum((link,), pair.name, sheet.joint(pair), arms)
    moment = -total * sheet.number(MU_L, sheet.mu_l) if sheet.in_mm else -total
    formula = sheet.hand(BALANCING_MOMENT, moment)
    value = float(formula.written)
    formulas, drive = [formula], Couple(BALANCING_MOMENT, value, value)
    sheet.compare(BALANCING_MOMENT, formula, float(sheet.solved.balancing[sheet.k]), sheet.moment_floor(link))
    teeth = _teeth(sheet, formula, formulas, arms)
    mu = _scale(sheet, teeth)
    of = reaction(FRAME, link)
    strokes, tip = sheet.laid_off(link, 0j, mu)
    if teeth is not None:
        end = tip + sheet.pen.place(teeth.vector / mu)
        strokes.append(ForceStroke(tip, end, teeth.quantity, "component"))
        tip = end
    strokes.append(ForceStroke(tip, 0j, of, "reaction"))
    reading = sheet.read(of, tip, pair, mu)
    pushed = [Term(teeth.quantity.sign, 2)] if teeth is not None else []
    held = [Held(of, link, -tip * mu, sheet.joint(pair))]
    drawn = ForcePlan(
        f"I(0,{link})", (link,), mu,
        {link: tuple(sheet.acting[link])}, {link: tuple(sheet.couples[link])},
        tuple(arms), tuple(formulas),
        VectorEquation([[*sheet.terms(link), *pushed, Term(of.sign, 0)], []]),
        tuple(strokes), (reading,),
        held=(*held, teeth) if teeth is not None else tuple(held),
        drive=None if teeth is not None else drive, chosen=sheet.chosen, stage="driver",
        poles=sheet.poles((link,)),
    )  # fmt: skip
    return drawn, float(formula.written)


def _teeth(sheet: Sheet, moment: Formula, formulas: list[Formula], arms: list[Arm]) -> Held | None:
    """The force of the gear: the moment over the base radius, in the pitch point along the line of action."""
    gear, link = sheet.mechanism.driver.gear, sheet.mechanism.driver.link
    pair = sheet.motion.linkage.structure.driver_pair
    if gear is None:
        return None
    radius = sheet.number(PITCH_RADIUS, float(gear.radius))
    angle = replace(sheet.number(ANGLE, float(np.degrees(gear.pressure))), number=float(gear.pressure))
    base = sheet.hand(BASE_RADIUS, radius * cos(angle))
    omega = float(np.ravel(sheet.mechanism.driver.omega)[0])
    value = sheet.number(BALANCING_MOMENT, moment.written)
    arm = sheet.number(BASE_RADIUS, base.written)
    force = sheet.hand(FORCE, (-value if gear.one_flank and omega < 0 else value) / arm)
    formulas += [base, force]
    along = complex(gear.line(float(moment.written), omega))
    centre = sheet.joint(pair)
    at = complex(centre + gear.pitch_point)
    mm = sheet.pen.read(float(gear.base_radius) / sheet.mu_l)
    of = arm_of(FORCE, pair.name, sheet.in_mm)
    metres = float(round_significant(mm * sheet.mu_l, DIGITS + 2))
    arms.append(Arm(FORCE, pair.name, mm, metres, of, link, centre, at, along))
    return Held(FORCE, link, along * force.written, at)


def _scale(sheet: Sheet, teeth: Held | None) -> float:
    """N per mm: a scale stated by groups is none of the driving link's."""
    link, pair = sheet.mechanism.driver.link, sheet.motion.linkage.structure.driver_pair
    corners = laid_end_to_end(sheet, (link,))
    corners += [corners[-1] + teeth.vector] if teeth is not None else []
    return sheet.scale_of((link,), (pair,), corners)
