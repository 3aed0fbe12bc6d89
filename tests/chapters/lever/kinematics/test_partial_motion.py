"""Motion of mechanisms that close over part of the cycle: extremes and angles beside the gap, and what is blamed."""

from __future__ import annotations

import re

import numpy as np
import pytest

from tmm_report.chapters.lever.kinematics.solve.strokes import Travel
from tmm_report.commands.solve import _differences
from tmm_report.course import solve
from tmm_report.i18n import Translator
from tmm_report.loading import loads
from tmm_report.note import render
from tmm_report.problems import ProblemError

FOUR_BAR = """\
mechanism:
  frame: {O: [0, 0], C: [0.1, 0]}
  links:
    1: {points: {O: 0, A: CRANK}}
    2: {points: {A: 0, B: ROD}}
    3: {points: {C: 0, B: SWING}}
  driver: {link: 1, speed: 6, rotation: SENSE, zero: {angle: 0 deg}}
  assembly: {B: left of A-C}
allow_partial: true
"""
TRIAD = """\
mechanism:
  frame: {O: [0, 0], E: [273.052 mm, -27.847 mm], G: [129.235 mm, -32.708 mm], H: [373 mm, -28 mm]}
  links:
    1: {points: {O: 0, A: 23.426 mm}}
    2: {points: {A: 0, B: 102.496 mm}}
    3: {points: {B: 0, D: 98.981 mm, F: [-5.028 mm, -81.663 mm]}}
    4: {points: {D: 0, E: 135.591 mm}}
    5: {points: {F: 0, G: 33.016 mm}}
  driver: {link: 1, speed: 60 rpm, rotation: clockwise, zero: {angle: ZERO deg}}
  sketch: {A: [23.4 mm, 0], B: [120.5 mm, 32.9 mm], D: [202.7 mm, 88.1 mm], F: [161.9 mm, -37.7 mm]}
allow_partial: true
"""


def four_bar(crank: float, rod: float, rocker: float, sense: str) -> str:
    text, stated = FOUR_BAR, {"CRANK": crank, "ROD": rod, "SWING": rocker, "SENSE": sense}
    for name, value in stated.items():
        text = text.replace(name, str(value))
    return text


def travel_of(text: str, link: str) -> Travel:
    k = solve(loads(text)).lever.kinematics
    return next(t for t in (*k.travels, *k.links) if t.output.name == link)


def coupler(crank: float, rod: float, rocker: float, phi: np.ndarray) -> np.ndarray:
    """Angle of the coupler by the law of cosines, B on the left of A-C."""
    AC = 0.1 - crank * np.exp(1j * phi)
    d = np.abs(AC)
    with np.errstate(invalid="ignore"):
        return np.angle(AC) + np.arccos((rod**2 + d**2 - rocker**2) / (2 * rod * d))


def test_what_grows_on_one_side_keeps_its_extreme_on_the_other():
    """The coupler's acceleration falls without bound towards both limits, and is greatest between them."""
    low, high = travel_of(four_bar(0.06, 0.03, 0.06, "clockwise"), "2").a_extremes
    turned = np.radians(np.linspace(310, 410, 100_001))
    psi = np.unwrap(coupler(0.06, 0.03, 0.06, -turned))
    epsilon = 36 * np.gradient(np.gradient(psi, turned), turned)[2:-2]
    assert np.isnan(low.value)
    assert high.value == pytest.approx(epsilon.max(), rel=1e-4)
    assert high.turned == pytest.approx(turned[2:-2][np.argmax(epsilon)], abs=1e-3)


@pytest.mark.parametrize("rod, rocker, sense", [(0.08, 0.07, "counter-clockwise"), (0.07, 0.08, "clockwise")])
def test_what_lies_behind_a_gap_is_reached_over_position_0(rod, rocker, sense):
    """The coupler turns by more than half a turn from one limit to the other; position 12 is position 0 again."""
    travel = travel_of(four_bar(0.12, rod, rocker, sense), "2")
    side = 1 if sense == "counter-clockwise" else -1
    limit = np.arccos((0.12**2 + 0.1**2 - (rod + rocker) ** 2) / (2 * 0.12 * 0.1))
    phi = np.linspace(-limit + 1e-9, limit - 1e-9, 20_001)
    psi = np.unwrap(coupler(0.12, rod, rocker, side * phi) % (2 * np.pi))
    assert travel.S[-1] == pytest.approx(0.0, abs=1e-12)
    assert travel.stroke == pytest.approx(np.ptp(psi), abs=1e-4)
    assert travel.S[10] == pytest.approx(np.interp(-np.pi / 3, phi, psi) - np.interp(0, phi, psi), abs=1e-6)


@pytest.mark.exhaustive
def test_no_limit_is_counted_from_the_sketch():
    """Position 0 lies in the gap: there is no turning from it, and angles are of it alone."""
    (gap,) = solve(loads(TRIAD.replace("ZERO", "-160"))).lever.kinematics.gaps
    assert "jams at" not in str(gap.text) and "341.16° < φ < 360° and 0° ≤ φ < 33.5" in str(gap.text)
    (gap,) = solve(loads(TRIAD.replace("ZERO", "0"))).lever.kinematics.gaps
    assert "jams at φ = 141.16°" in str(gap.text)


def test_every_group_is_blamed_for_its_own_part():
    """The triad is lost over a part of the turn, the dyad on it over all the rest."""
    dyad = "    6: {points: {D: 0, K: 60 mm}}\n    7: {points: {K: 0, H: 55 mm}}\n  driver:"
    text = TRIAD.replace("ZERO", "0").replace("  driver:", dyad)
    text = text.replace("  sketch", "  assembly: {K: left of D-H}\n  sketch")
    with pytest.raises(ProblemError) as error:
        solve(loads(text))
    first, second = (str(problem.wrong) for problem in error.value.problems)
    assert "III3(2,3,4,5)" in first and re.search(r"DK = 60 mm and HK = 55 mm do not meet", second)


def test_of_no_plans_no_difference_and_no_scale_is_told():
    said: list[object] = []
    talk = type("Talk", (), {"tell": lambda self, message: said.append(message)})()
    text = four_bar(0.06, 0.03, 0.06, "clockwise") + "language: en\npositions: {plans: [5, 6]}\n"
    found = solve(loads(text))
    _differences(found.lever, Translator("en"), talk)
    assert not found.lever.plans.drawn and not said
    note = render(found, "html", Translator("en"))["note.html"].decode()
    assert "At positions 5, 6 no polygon can be drawn" in note and "Scales of the polygons" not in note
