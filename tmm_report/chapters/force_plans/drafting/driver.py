"""The force plan of the driving link: balancing moment from the moments, reaction of the frame from the plan."""

from __future__ import annotations

from tmm_report.chapters.force_plans.drafting.plan import Arm, ForcePlan, ForceStroke
from tmm_report.chapters.force_plans.drafting.sheet import Sheet
from tmm_report.chapters.kinetostatics.quantities import BALANCING_MOMENT, reaction
from tmm_report.chapters.plans.solve import PAPER, Comparison
from tmm_report.mechanics.mechanism import FRAME
from tmm_report.quantity.formula import Term, VectorEquation
from tmm_report.quantity.paper import round_scale


def plan(sheet: Sheet) -> tuple[ForcePlan, float]:
    """The plan, and the balancing moment about the link's pivot, N m."""
    link, pair = sheet.mechanism.driver.link, sheet.motion.linkage.structure.driver_pair
    arms: list[Arm] = []
    formula = sheet.hand(BALANCING_MOMENT, -sheet.moment_sum((link,), pair.name, sheet.joint(pair), arms))
    mu = _scale(sheet)
    of = reaction(FRAME, link)
    strokes, tip = sheet.laid_off(link, 0j, mu)
    strokes.append(ForceStroke(tip, 0j, of, "reaction"))
    reading = sheet.read(of, tip, pair, mu)
    exact, largest = float(sheet.solved.balancing[sheet.k]), max(_sizes(sheet), default=0.0)
    floor = largest * sheet.mu_l * sheet.pen.read_step
    sheet.comparison.append(Comparison(BALANCING_MOMENT.key, abs(formula.written), abs(exact), floor))
    equation = VectorEquation([[*sheet.terms(link), Term(of.sign, 0)], []])
    loads, couples = {link: tuple(sheet.acting[link])}, {link: tuple(sheet.couples[link])}
    drawn = ForcePlan(
        f"I(0,{link})",
        (link,),
        mu,
        loads,
        couples,
        tuple(arms),
        (formula,),
        equation,
        tuple(strokes),
        (reading,),
    )
    return drawn, float(formula.written)


def _sizes(sheet: Sheet) -> list[float]:
    return [abs(a.vector) for a in sheet.acting[sheet.mechanism.driver.link]]


def _scale(sheet: Sheet) -> float:
    """N per mm."""
    if isinstance(sheet.scale, int | float):
        return float(sheet.scale)
    pair = sheet.motion.linkage.structure.driver_pair
    return round_scale(max([*_sizes(sheet), abs(sheet.exact(pair))]), PAPER)
