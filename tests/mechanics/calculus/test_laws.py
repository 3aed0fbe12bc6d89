"""Every law of the family: its value, breaks, order, exact value and printed formula say the same.

A new law comes into `LAWS` by itself and wants its examples here.
"""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest

from tmm_report.i18n import Translator
from tmm_report.mechanics.calculus import laws
from tmm_report.mechanics.calculus.laws import Law
from tmm_report.mechanics.calculus.panels import panels
from tmm_report.mechanics.machine import characteristics as ch
from tmm_report.mechanics.pairs import coefficients
from tmm_report.mechanics.rivals.exact.laws import Digits
from tmm_report.mechanics.rivals.exact.numbers import exact
from tmm_report.quantity.formula import Formula, Var
from tmm_report.quantity.laws import written

TURN = 2 * math.pi
CURVES = ((0.0, 1.0), (0.1, 7.0), (0.1, 3.0), (1.0, -2.0)), ((0.0, -2.0), (0.6, 4.0), (1.0, 1.0))
EXAMPLES = [
    laws.Constant(3.5),
    laws.Harmonics(2.0, (laws.Wave(1, 3.0, -1.0), laws.Wave(2.5, 0.5, 0.2))),
    laws.ByAngle((0.5, 1.0, 1.0, 3.0), (1.0, 4.0, 2.0, -5.0)),
    laws.ByAngle((0.5, 1.0, 1.0, 3.0), (1.0, 4.0, 2.0, -5.0), TURN),
    laws.ByAngle((0.0, 2.0, TURN), (0.0, 1.0, 10.0), TURN),
    laws.ByAngle((0.0, 2.0, 2.0, 5.0, TURN), (1.0, 4.0, 2.0, 3.0, 1.0), 2 * TURN),
    laws.ByPosition((5.0, 1.0, 4.0, -2.0)),
    laws.ByPosition((5.0, 1.0, 4.0, -2.0)).by_angle(math.pi / 2).repeating(TURN),
    laws.ByTime((0.0, 1.5, 1.5, 4.0), (1.0, 2.0, 0.0, 6.0)),
    laws.BySpeed((0.0, 10.0, 50.0), (100.0, 130.0, 0.0)),
    laws.ByPlace((0.1, 0.2, 0.2, 0.5), (800.0, 300.0, 0.0, 500.0)),
    laws.ByDisplacement(1j, *CURVES),
    laws.ByStrokes(1j, ("intake", "power", "other", "last"), (*CURVES, *CURVES[::-1])),
    laws.ByLength(1200.0, 0.24),
    laws.ByRate(300.0),
    laws.ByTurn(40.0, 0.3),
    coefficients.BySliding((0.0, 0.5, 2.0), (0.15, 0.1, 0.12)),
    coefficients.Stribeck(0.15, 0.08, 0.4),
    coefficients.Stribeck(0.15, 0.08, 0.4, 0.02, 2),
    ch.Linear(40.0, 100.0),
    ch.Series(5e4, 20.0),
    ch.Kloss(157.0, 60.0, 0.15),
    ch.Kloss(157.0, 60.0, 0.15, 0.7),
    ch.Power(12.0, 90.0),
    ch.Power(12.0, 90.0, 2),
]
AXES = {
    laws.NOTHING: (0.0, 1.0),
    laws.ANGLE: (0.0, 2 * TURN),
    laws.POSITION: (0.0, 5.0),
    laws.TRAVEL: (0.0, 1.0),
    laws.TIME: (0.0, 6.0),
    laws.SPEED: (0.0, 150.0),
    laws.LENGTH: (0.0, 0.5),
    laws.RATE: (-3.0, 3.0),
    laws.STROKE: (0.0, 0.6),
    laws.TURN: (-3.0, 3.0),
    laws.SLIDING: (0.0, 3.0),
}
EVERY = pytest.mark.parametrize("law", EXAMPLES, ids=lambda law: type(law).__name__)


def family(of: type[Law] = Law) -> set[type[Law]]:
    """The laws: all that no other is derived from."""
    below = of.__subclasses__()
    return set().union(*map(family, below)) if below else {of}


def curves(law: Law) -> range:
    return range(len(law.named()) if isinstance(law, laws.Diagram) else 1)


def at(law: Law, x: np.ndarray, which: int) -> np.ndarray:
    return np.asarray(law.value(x, np.full(x.shape, which)))


def breaks(law: Law, which: int) -> list[laws.Break]:
    return [one for one in law.breaks(AXES[law.of][1]) if one.which == which]


def pieces(law: Law, which: int) -> list[tuple[float, float]]:
    """What lies between the breaks."""
    low, high = AXES[law.of]
    inner = {one.at for one in breaks(law, which) if low < one.at < high}
    return list(pairwise(sorted({low, *inner, high})))


def places(law: Law) -> np.ndarray:
    low, high = AXES[law.of]
    return np.sort(np.random.default_rng(7).uniform(low, high, 60))


def test_every_law_is_judged_here():
    assert family() - {type(one) for one in EXAMPLES} == set()
    assert {one.of for one in EXAMPLES} == set(AXES)


@EVERY
def test_between_its_breaks_a_law_is_the_polynomial_of_its_order_or_smooth(law):
    """So that Gauss's formula is exact there: a break that is not told, or an order too low, leaves a residual."""
    for which in curves(law):
        for low, high in pieces(law, which):
            t = np.linspace(-1, 1, 401)[1:-1]
            values = at(law, (low + high) / 2 + t * (high - low) / 2, which)
            fit = np.polynomial.chebyshev.chebfit(t, values, 60 if law.order is None else law.order)
            off = np.abs(np.polynomial.chebyshev.chebval(t, fit) - values).max()
            assert off <= 1e-9 * np.abs(values).max(), (low, high)


@EVERY
def test_a_break_is_a_corner_or_a_jump_with_the_values_that_it_tells(law):
    low, high = AXES[law.of]
    h = 1e-6 * (high - low)
    for which in curves(law):
        for one in breaks(law, which):
            x = one.at + h * np.array([-2.0, -1.0, 0.0, 1.0, 2.0])
            first, before, here, after, last = at(law, x, which)
            near = 1e-4 * max(1.0, np.abs(at(law, places(law), which)).max())
            assert (before, after) == pytest.approx((one.before, one.after), abs=near)
            assert here == pytest.approx(one.after, abs=1e-9 * near + 1e-12)
            corner = abs((last - after) - (before - first)) / h
            assert one.before != one.after or corner > 1e-3, one


@EVERY
def test_breaks_are_told_once_and_over_all_periods(law):
    for which in curves(law):
        told = [one.at for one in breaks(law, which)]
        assert sorted(set(told)) == told
        period = getattr(law, "period", None)
        if period is not None:
            own = [one.at for one in law.breaks()]
            assert told == pytest.approx(
                [x + k * period for k in range(math.ceil(2 * TURN / period)) for x in own]
            )


@EVERY
def test_as_wide_as_it_says_its_panels_integrate_it_to_all_digits(law):
    _, high = AXES[law.of]
    for which in curves(law):
        marks = [one.at for one in breaks(law, which) if one.at <= high]
        wide, narrow = (panels(high, marks, min(law.widest, widest)) for widest in (high, high / 50))
        whole, exactly = (float(of.total(at(law, of.x, which))) for of in (wide, narrow))
        if law.order is not None or math.isfinite(law.widest):
            assert whole == pytest.approx(exactly, rel=1e-12, abs=1e-12)


@EVERY
def test_one_place_is_read_as_many_are(law):
    for which in curves(law):
        x = places(law)
        alone = [float(np.asarray(law.value(np.array([one]), np.array([which])))[0]) for one in x]
        assert at(law, x, which) == pytest.approx(alone, rel=1e-15)


@EVERY
def test_the_exact_value_is_that_of_the_doubles_to_their_rounding(law):
    for which in curves(law):
        x = np.concatenate([places(law), [one.at for one in breaks(law, which)]])
        size = max(1.0, np.abs(at(law, x, which)).max())
        for place, value in zip(x.tolist(), at(law, x, which), strict=True):
            assert float(law.value(exact(place), which, Digits(place)) - float(value)) == pytest.approx(
                0, abs=1e-13 * size
            )


@EVERY
def test_the_printed_formula_gives_the_value_and_prints(law):
    for which in curves(law):
        x = places(law)
        for place, value in zip(x.tolist(), at(law, x, which), strict=True):
            formula = Formula("F", written(law, Var("x", place), which), "N")
            assert float(formula.value) == pytest.approx(float(value), rel=1e-12, abs=1e-12)
        for print_ in (formula.latex, formula.mathml):
            assert "F" in print_(Translator("en"))


@EVERY
def test_a_law_of_a_pressure_is_that_of_the_force_many_times(law):
    if law.of == laws.SPEED and not isinstance(law, laws.Lines):
        return  # a motor's: it is of no pressure
    for which in curves(law):
        x = places(law)
        assert at(law.scaled(0.25), x, which) == pytest.approx(at(law, x, which) / 4, rel=1e-14)


def test_the_slope_of_lines_is_their_difference():
    for law in EXAMPLES:
        if isinstance(law, laws.Lines):
            x, h = places(law), 1e-7
            ahead, behind = (law.value(x + side * h) for side in (1, -1))
            away = np.abs(x[:, None] - [one.at for one in law.breaks(AXES[law.of][1])]).min(axis=1) > 2 * h
            np.testing.assert_allclose(law.slope(x)[away], ((ahead - behind) / (2 * h))[away], atol=1e-5)


def test_a_machine_reads_a_law_by_its_own_argument():
    assert laws.BySpeed((0.0, 10.0), (0.0, 5.0)).at(4.0, 9.0, 9.0) == pytest.approx(2.0)
    assert laws.ByTime((0.0, 10.0), (0.0, 5.0)).at(9.0, 9.0, 4.0) == pytest.approx(2.0)
    assert laws.ByAngle((0.0, 10.0), (0.0, 5.0)).at(9.0, 4.0, 9.0) == pytest.approx(2.0)
    assert laws.Constant(3.0).at(9.0, 4.0, 9.0) == 3.0
