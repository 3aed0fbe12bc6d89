"""Extremes of mechanisms at their Grashof limits, where two assemblies meet, held against places in 50 digits. The long
run is `benchmarks/at_limits`."""

import dataclasses
import sys
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from exhaustive import many

sys.path.append(str(Path(__file__).parents[3]))
from benchmarks.at_limits import judge
from benchmarks.at_limits import truth as truth_of
from benchmarks.at_limits.draw import FAMILIES, draw
from benchmarks.at_limits.judge import asked, judged
from benchmarks.at_limits.truth import Output, Truth
from tmm_report.mechanics.lever.cycle import Extreme

SEED = 7
QUICK = ("four-bar", "offset = rod − crank", "slot, crank = frame")  # a kind of dyad each
EACH = 1  # scenes of each kind; the long run has hundreds
GRID = 1440  # samples of a turn of the truth: it refines what they find


@pytest.fixture(autouse=True)
def coarse(monkeypatch):
    monkeypatch.setattr(truth_of, "GRID", GRID)


@pytest.mark.exhaustive
@pytest.mark.parametrize("family", many(sorted(FAMILIES, key=lambda family: family not in QUICK), len(QUICK)))
def test_extremes_are_right_on_both_sides_of_every_corner(family):
    verdicts = [judged(draw(family, number, SEED)) for number in range(EACH)]
    assert not [v for v in verdicts if v.wrong]


def test_the_sample_begins_in_change_points_too():
    drawn = [draw(family, number, SEED) for family in FAMILIES for number in range(EACH)]
    assert 3 <= sum(scene.starts_at for scene in drawn) <= 9


@pytest.mark.parametrize("family", ["four-bar", "parallelogram", "offset = rod − crank", "slot beside"])
def test_a_thousandth_of_a_millimetre_beside_the_limit_they_are_right_to_the_digits_that_are_told(family):
    assert not judged(draw(family, 0, SEED, Fraction(1, 1000))).wrong


@pytest.mark.exhaustive
@pytest.mark.parametrize("family", ["four-bar", "kite, crank = frame", "offset = rod − crank"])
def test_the_side_that_is_told_is_the_side_that_has_the_value(family):
    """Before the corner and after it the rates differ; what is told of one side is the limit from there."""
    met = 0
    for number in range(2):
        scene = draw(family, number, SEED)
        found, _ = asked(scene)
        truth = Truth(scene)
        for travel in found.travels:
            one = Output(travel.output.kind, travel.output.name, complex(travel.output.direction))
            for low_or_high in travel.V_extremes:
                if low_or_high.side:
                    met += 1
                    # before the corner ends the first piece, after it the last begins: of a turn that begins in
                    # its corner both are the whole turn
                    start, end = truth.pieces[0 if low_or_high.side < 0 else -1]
                    at = end - 1e-12 if low_or_high.side < 0 else start + 1e-12
                    right = truth.rates(one, at, (start + end) / 2 + 0.1)[0]
                    assert low_or_high.value == pytest.approx(float(right), rel=1e-8)
    assert met


@pytest.mark.exhaustive
def test_a_wrong_extreme_is_noticed(monkeypatch):
    """The judge can say no: one value off by a millionth, one jump that is not told."""
    scene = draw("four-bar", 0, SEED)
    found, seconds = asked(scene)
    travel = found.travels[0]
    low, high = travel.V_extremes
    wrong = dataclasses.replace(travel, V_extremes=(low, Extreme(high.value * (1 + 1e-6), high.turned)))
    altered = dataclasses.replace(found, travels=(wrong, *found.travels[1:]))
    monkeypatch.setattr(judge, "asked", lambda scene: (altered, seconds))
    assert judged(scene).wrong == ("V",)
    monkeypatch.setattr(judge, "_jumps", lambda scene: True)
    assert judged(scene).wrong == ("V", "jump")


def test_the_truth_of_a_kite_is_its_closed_form():
    """ω3 = ω (1 ± k cos φ/2 / √(1 − k² sin² φ/2))/2 with k = crank/rod: at the corner ω (1 ± k)/2."""
    scene = draw("kite, crank = frame", 0, SEED)
    k = float(scene.crank / scene.steps[0].p)
    rates, swing = Truth(scene).extremes(Output("rocker", "3"))
    np.testing.assert_allclose(rates[0], [5 * (1 - k), 5 * (1 + k)], rtol=1e-12)
    assert swing == pytest.approx(np.pi, abs=1e-7)
