"""Every formula of a spur stage against mechanics/gears, which finds the same in other ways."""

import math
from dataclasses import replace

import numpy as np
import pytest
from notes import VARIANTS
from test_spur_stage import CASES, FREE, GUIDE
from twice import disagreements

from tmm_report import course, loading
from tmm_report.chapters.gears.spur.given import Backlash, Inspection, Quality
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
STATED_TIPS = tuple(float(d) + 1e-4 * (-1, 1)[i] for i, d in enumerate(spur.solve(RING).pair.d_a))
LOOSE = replace(GUIDE, teeth=(14, 28), shift=(0.18, 0.5))
MORE = {
    "undercut": replace(FREE, teeth=(10, 40), ratio=-4.0, shift=(-0.2, 0.5)),
    "pointed": replace(FREE, shift=(1.2, 0.0)),
    "cut by a pinion": replace(GUIDE, cutter=Cutter(20)),
    "cut by a worn pinion": replace(GUIDE, cutter=Cutter(25, -0.1), shift="limit"),
    "ring cut": replace(RING, cutter=Cutter(16, 0.1)),
    "full tips of a cutter": replace(FREE, shift=(0.5, 0.4), tip_shortening=False, cutter=Cutter(20)),
    "rounded": replace(GUIDE, shift=(0.176, 0.563)),
    "needs no shift": replace(GUIDE, module=2e-3),
    "measured": replace(
        FREE, shift=(0.5, 0.4), inspection=Inspection((2, 4), (10.5e-3, 11e-3), (0.092, 0.172), True)
    ),
    "measured helical": replace(CASES["helical"], inspection=Inspection(None, None, (0.088, 0.17))),
    "measured ring": replace(RING, inspection=Inspection(None, (8.6e-3, 8.6e-3), (0.1, 0.298))),
    "one shift": replace(GUIDE, teeth=(14, 28), shift=(math.nan, 0.5)),
    "one shift, of a ring": replace(RING, centre_distance=0.101, shift=(math.nan, 0.4)),
    "one shift, of a ring's pinion": replace(RING, centre_distance=0.101, shift=(0.1, math.nan)),
    "quality": replace(GUIDE, quality=Quality()),
    "quality, helical": replace(CASES["helical"], quality=Quality()),
    "quality, ring": replace(RING, quality=Quality()),
    "quality, cut short": replace(FREE, teeth=(10, 40), ratio=-4.0, shift=(-0.2, 0.5), quality=Quality()),
    "thinned": replace(FREE, backlash=Backlash(thinning=(60e-6, 9e-5), tolerance=5e-5, axes=4e-5)),
    "thinned by the rack": replace(
        CASES["helical"], backlash=Backlash(thinning=1e-4, tolerance=(5e-5, 8e-5), by="rack", axes=5e-5)
    ),
    "thinned by the span": replace(RING, backlash=Backlash(thinning=6e-5, by="span")),
    "guaranteed": replace(FREE, backlash=Backlash(guaranteed=1e-4)),
    "guaranteed, helical": replace(CASES["helical"], backlash=Backlash(guaranteed=1e-4, axes=3e-5)),
    "guaranteed, helical ring": replace(
        CASES["internal, helical"], backlash=Backlash(guaranteed=1e-4, axes=3e-5, tolerance=5e-5)
    ),
    "guaranteed, loose": replace(LOOSE, backlash=Backlash(guaranteed=0.4e-3)),
    "thinned, loose": replace(LOOSE, backlash=Backlash(thinning=5e-5)),
    "stated tips": replace(FREE, tip_diameters=(0.097, 0.181)),
    "stated tips, ring": replace(RING, tip_diameters=STATED_TIPS),
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
    stages = course.solve(loading.load(VARIANTS / f"{name}.yaml")).drive.stages
    assert [told(one) for one in stages if isinstance(one, spur.Found)] == [[]]


def told(found):
    made = stage(found, "stage1")
    wrong = disagreements(made.s, _ways(found), formed=True)
    for i, wheel in enumerate(made.wheels):
        wrong += disagreements(wheel, _of_wheel(found, i), formed=True)
        wrong += disagreements(made.gauges[i], _of_gauge(found.inspected[i]), formed=True)
    if made.divided is not None:
        wrong += disagreements(made.divided, _of_pressure(found), formed=True)
    if made.loosened is not None:
        wrong += disagreements(made.loosened, _of_backlash(found), formed=True)
    for tool, cut in zip(made.tools, found.cutters, strict=True):
        wrong += disagreements(tool, _of_tool(cut.by), formed=True)
    return wrong


def _ways(found):
    """In the units of the formulas."""
    p, given, choice = found.pair, found.given, found.teeth.choice
    ways = {key: 1e3 * float(getattr(p, key)) for key in LENGTHS.split()}
    ways |= {key: float(getattr(p, key)) for key in PURE.split()}
    ways |= {"alpha_w": float(p.alpha_w), "alpha_t": float(p.t.alpha), "x_needed": found.needed}
    ways["beta_b"] = math.atan(math.tan(p.beta) * math.cos(p.t.alpha))
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


def _of_backlash(found):
    """From pairs without backlash: how far the axes are apart of those, and of what shift the thinned teeth are."""
    of, p, given = found.backlash, found.pair, found.given
    turn, ways = math.tan(p.rack.alpha), {}
    factor = {"rack": 2 * turn, "span": 1 / math.cos(p.rack.alpha)}.get(of.stated.by, 1.0)
    for place, i in (("one", 0), ("two", 1)):
        ways[f"field_{place}"] = 1e3 * factor * (of.stated.of_both("tolerance") or (0.0, 0.0))[i]
        stated = of.stated.of_both("thinning") or (0.0, 0.0)
        thin = {"rack": 2 * stated[i] * turn, "span": stated[i] / math.cos(p.rack.alpha)}.get(of.stated.by)
        thin = of.least[i] if of.asked or thin is None else thin
        ways[f"thin_{place}"] = 1e3 * thin
        ways[f"span_fall_{place}"] = 1e3 * thin * math.cos(p.rack.alpha)
    for end, loose, thinned in (("least", of.close, of.least), ("most", of.far, of.most)):
        lost = [thin / (2 * p.m * turn) for thin in thinned]
        less = replace(p, a_w=loose.a_w, x1=p.x1 - p.signs[0] * lost[0], x2=p.x2 - p.signs[1] * lost[1])
        bare = float(less.p_w - sum(replace(p, a_w=loose.a_w).s_w))
        ways |= {f"a_{end}": 1e3 * loose.a_w, f"alpha_{end}": float(less.alpha_w)}
        ways |= {f"by_axes_{end}": 1e3 * bare, f"j_w_{end}": 1e3 * float(less.backlash)}
        ways[f"by_teeth_{end}"] = 1e3 * (float(less.backlash) - bare)
        ways[f"j_n_{end}"] = 1e3 * float(less.normal_backlash)
        for i, place in enumerate(("one", "two")):
            ways[f"turn_{end}_{place}"] = float(less.backlash / less.d_w[i] * 2)
    if of.asked:
        assert of.close.normal == pytest.approx(given.backlash.guaranteed, rel=1e-9)
    return ways


def _of_pressure(found):
    """By the radii of both profiles, of helical teeth those across them."""
    p = found.pair
    turn = math.cos(math.atan(math.tan(p.beta) * math.cos(p.t.alpha)))
    ends = {"gamma_w": p.rho_w, "gamma_p": (p.rho_p[0], p.rho_u[1]), "gamma_a": (p.rho_u[0], p.rho_p[1])}
    return {
        key: float(p.m * turn * (abs(a - b) if p.internal else a + b) / (a * b))
        for key, (a, b) in ends.items()
    }


def _of_wheel(found, i):
    p = found.pair
    ways = {key: 1e3 * float(getattr(p, key)[i]) for key in OF_WHEELS.split()}
    ways |= {"x": float((p.x1, p.x2)[i]), "x_min": float(p.x_min[i]), "alpha_a": float(p.alpha_a[i])}
    if found.given.tip_diameters:
        sign = p.signs[i]
        ways["tip_lost"] = sign * (float(p.d[i]) - float(p.d_a[i])) / (2 * p.m) + p.rack.ha + sign * ways["x"]
        reach = [float(d) / 2 for d in (p.d_f[i], p.d_a[1 - i])]
        ways["clearance"] = 1e3 * (
            float(p.a_w) - sum(reach) if not p.internal else sign * (reach[1] - reach[0]) - p.a_w
        )
    along = p.sliding(np.array([p.rho_p[0], p.rho_u[0]]))
    lower, upper = along.first if i == 0 else along.second[::-1]
    return ways | {"rho_l": 1e3 * float(p.rho_l[i]), "root_sliding": lower, "tip_sliding": upper}


def _of_gauge(of):
    """From thicknesses on the base circle, where the formulas go by the shift."""
    g, pair = of.gauge, of.gauge.pair

    def helix(d):
        return math.atan(math.tan(pair.beta) * d / g.of("d"))

    span, pin, circle = of.span or 1, of.pin or 1.7 * pair.m, of.circle or g.of("d")
    rise = g.pin_centres(pin) ** 2 - g.of("d_b") ** 2
    half_way = g.of("d") + 2 * g.shift * pair.m
    turn = math.cos(helix(circle)) ** 3
    lengths = {
        "W": g.span(span), "rho_W": g.span_touches(span), "s_ay": g.chord(g.of("d_a"))[0], "sag": g.tip_sag,
        "s_c": g.constant_chord[0], "h_c": g.constant_chord[1], "s_y": g.chord(circle)[0], "h_y": g.chord(circle)[1],
        "d_D": math.sqrt(rise + g.of("d_b") ** 2), "d_k": g.at(g.pin_touches(pin)), "M": g.over(pin),
    }  # fmt: skip
    return {key: 1e3 * float(length) for key, length in lengths.items()} | {
        "alpha_m": math.acos(min(1.0, g.of("d_b") / half_way)), "span_rule": g.rule, "beta_a": helix(g.of("d_a")),
        "beta_y": helix(circle), "alpha_y": math.acos(g.of("d_b") / circle),
        "psi_y": pair.thickness((circle, circle))[g.i] / circle * turn,
        "inv_alpha_D": math.sqrt(rise) / g.of("d_b") - math.atan(math.sqrt(rise) / g.of("d_b")),
    }  # fmt: skip


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
    sheets = (made.s, *made.wheels, *made.tools, *made.gauges)
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
