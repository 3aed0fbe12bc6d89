"""Every formula of a spur stage against mechanics/gears, which finds the same in other ways."""

import math
from dataclasses import replace

import numpy as np
import pytest
from notes import VARIANTS
from test_spur_stage import CASES, FREE, GUIDE
from twice import disagreements

from tmm_report import course
from tmm_report.chapters.gears.spur.quantities import book
from tmm_report.chapters.gears.spur.solve import pair as spur
from tmm_report.chapters.gears.spur.solve.motion import sliding_limit
from tmm_report.chapters.gears.spur.steps import stage
from tmm_report.chapters.gears.spur.view.pair import SpurView
from tmm_report.i18n import Translator
from tmm_report.mechanics.gears.meshing import Cutter
from tmm_report.report.formats import Html
from tmm_report.report.numbering import Numbering
from tmm_report.report.page import Page

RING = CASES["internal"]
MORE = {
    "undercut": replace(FREE, teeth=(10, 40), ratio=-4.0, shift=(-0.2, 0.5)),
    "pointed": replace(FREE, shift=(1.2, 0.0)),
    "cut by a pinion": replace(GUIDE, cutter=Cutter(20)),
    "cut by a worn pinion": replace(GUIDE, cutter=Cutter(25, -0.1), shift="limit"),
    "ring cut": replace(RING, cutter=Cutter(16, 0.1)),
    "full tips of a cutter": replace(FREE, shift=(0.5, 0.4), tip_shortening=False, cutter=Cutter(20)),
    "rounded": replace(GUIDE, shift=(0.176, 0.563)),
    "needs no shift": replace(GUIDE, module=2e-3),
    "fast": spur.Given(-2, 0.0025, None, (42, 84), shift=(0.2, 0.0)),
}
ALL = {**CASES, **MORE}
LENGTHS = "a a_w p p_b p_w backlash line active active_tips m_t"
PURE = "ratio x_sum y shortening eps eps_tips"
OF_WHEELS = "d d_b d_w d_f d_a s s_b s_w s_a rho_a rho_p rho_m rho_u"


def solved(given):
    found = spur.solve(given)
    return spur.moving(found, -300.0)


@pytest.mark.parametrize("name", ALL)
def test_every_formula_agrees_with_the_second_way(name):
    assert told(solved(ALL[name])) == []


@pytest.mark.parametrize("name", ["compressor", "hoist_drive"])
def test_every_formula_of_a_ready_variant(name):
    stages = course.solve(course.load(VARIANTS / f"{name}.yaml")).drive.stages
    assert [told(one) for one in stages if isinstance(one, spur.Found)] == [[]]


def told(found):
    made = stage(found, "stage1")
    wrong = disagreements(made.s, _ways(found), formed=True)
    for i, wheel in enumerate(made.wheels):
        wrong += disagreements(wheel, _of_wheel(found, i), formed=True)
    for tool, cut in zip(made.tools, found.cutters, strict=True):
        wrong += disagreements(tool, _of_tool(cut.by), formed=True)
    return wrong


def _ways(found):
    """In the units of the formulas."""
    p, given, choice = found.pair, found.given, found.teeth.choice
    ways = {key: 1e3 * float(getattr(p, key)) for key in LENGTHS.split()}
    ways |= {key: float(getattr(p, key)) for key in PURE.split()}
    ways |= {"alpha_w": float(p.alpha_w), "alpha_t": float(p.t.alpha), "x_needed": found.needed}
    ways |= dict(
        zip(("inv_alpha", "inv_alpha_w"), (math.tan(x) - x for x in (p.t.alpha, p.alpha_w)), strict=True)
    )
    ways |= {"two_pairs": 100 * p.two_pairs, "two_length": 1e3 * (p.active - p.p_b)}
    if given.width is not None:
        ways["eps_beta"] = float(p.overlap(given.width))
    if choice is not None:
        small, large = sorted(found.teeth.z)
        sum_ = large - small if given.internal else large + small
        ways |= {"z_bound": choice.bound, "z_share": choice.share, "z_larger": choice.larger}
        ways["z_spare"] = 2e3 * given.centre_distance * math.cos(given.helix) / (1e3 * given.module) - sum_
    if (motion := found.motion) is not None:
        ways |= {"v_pitch": motion.whole[0][2], "v_along": motion.omega[1] * float(p.d_b[1]) / 2}
        ways["sliding_limit"] = sliding_limit(motion.whole[0][2])
    return ways


def _of_wheel(found, i):
    p = found.pair
    ways = {key: 1e3 * float(getattr(p, key)[i]) for key in OF_WHEELS.split()}
    ways |= {"x": float((p.x1, p.x2)[i]), "x_min": float(p.x_min[i]), "alpha_a": float(p.alpha_a[i])}
    along = p.sliding(np.array([p.rho_p[0], p.rho_u[0]]))
    lower, upper = along.first if i == 0 else along.second[::-1]
    return ways | {"rho_l": 1e3 * float(p.rho_l[i]), "root_sliding": lower, "tip_sliding": upper}


def _of_tool(by):
    return {
        "inv_alpha_w0": math.tan(by.alpha) - by.alpha, "a_w0": 1e3 * abs(by.distance), "d_a0": 2e3 * by.tip,
        "d_b0": 2e3 * by.base, "rho_l0": 1e3 * abs(by.start),
    }  # fmt: skip


# ---------------------------------------------------------------- where the values stand


@pytest.mark.parametrize("name", ALL)
def test_formulas_say_where_their_value_stands(name):
    """The number that a formula's result refers to is its value, in the unit of print."""
    found = solved(ALL[name])
    of, made = book(found, "stage1"), stage(found, "stage1")
    sheets = (made.s, *made.wheels, *made.tools)
    formulas = [one.formula(key) for one in sheets for key in one.DECLARED if one.has_formula(key)]
    wrong = [
        f"{formula.ref}: {formula.value}, there {there}"
        for formula in (*formulas, *_of_views(found))
        if not np.isclose(formula.value, there := _at(of, formula.ref), rtol=1e-9, atol=1e-9)
    ]
    assert wrong == []


def _of_views(found):
    """Those that stand beside a table or are a second one of their number."""
    view = SpurView(found, Page(Html(), Translator("en"), Numbering()), "stage1")
    if not found.loose:
        yield view.filled()
    yield view.drawings.graph_ratio()
    yield from view.moving.across()
    yield view.moving.by_distance()


def _at(of, ref):
    unit = ref.unit or "rad"  # of angles alone the unit of print is that of the results
    if not ref.table:
        value = of[ref.key]
        return value.number(ref.unit or (unit if value.unit == "deg" else ""))
    column = of.tables[ref.table][ref.key]
    number = column.number(ref.row, ref.unit or (unit if column.unit == "deg" else ""))
    return abs(number) if ref.size else number
