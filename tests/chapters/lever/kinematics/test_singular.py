"""Singular positions: nothing made of rounding errors passes for a velocity, a reaction or a moment."""

from __future__ import annotations

import json

import numpy as np
import pytest
from notes import render

from tmm_report import solve
from tmm_report.loading import loads
from tmm_report.mechanics.lever.assembly.stated import assemble
from tmm_report.mechanics.lever.cycle import cycle_of
from tmm_report.mechanics.lever.mechanism import Driver, Link, Mechanism, ZeroAngle

PARALLELOGRAM = """\
language: en
mechanism:
  frame: {O: [0, 0], C: [300 mm, 0]}
  links:
    1: {points: {O: 0, A: 100 mm}}
    2: {points: {A: 0, B: 300 mm}, mass: 2 kg, mass_centre: B, inertia: 0.01}
    3: {points: {C: 0, B: 100 mm}}
  driver: {link: 1, period: 1 s, rotation: clockwise}
  sketch: {A: [0, 100 mm], B: [300 mm, 100 mm]}
loads:
  moments: [{on: 3, direction: against motion, constant: 5}]
friction: {pivots: {coefficient: 0.1, diameter: 20 mm}}
positions: {plans: [0, 2], force_plan: [2, 6]}
"""


@pytest.fixture(scope="module")
def parallelogram():
    return solve(loads(PARALLELOGRAM))


@pytest.mark.exhaustive
def test_the_parallelogram_stays_one_through_its_change_points(parallelogram):
    """Velocities in the change points are the limits; only plans and reactions do not exist there."""
    k = parallelogram.lever.kinematics
    assert k.singular == (0, 6, 12) and k.undefined == () and k.missing == ()
    assert parallelogram.lever.plans.singular == (0,) and parallelogram.lever.force_plans.singular == (6,)
    omega = k.values["w_1"]
    np.testing.assert_allclose(k.values["w_3"], omega, rtol=1e-9)
    np.testing.assert_allclose(np.abs(k.values["v_B"]), 0.1 * np.abs(omega), rtol=1e-9)
    np.testing.assert_allclose(k.values["w_2"], 0, atol=1e-8)
    assert np.allclose(k.closest[0].changes, [0, np.pi], atol=1e-9)


def test_the_antiparallelogram_stays_one():
    """The other assembly: the rocker turns against the crank, and goes smoothly through both change points."""
    text = PARALLELOGRAM.replace("B: [300 mm, 100 mm]", "B: [220 mm, -60 mm]")
    k = solve(loads(text)).lever.kinematics
    turns = np.unwrap(np.angle(k.diagram.turn("3")))
    assert turns[-1] - turns[0] == pytest.approx(2 * np.pi)  # the crank turns clockwise
    assert np.abs(np.diff(turns)).max() < 0.5
    assert np.isfinite(k.values["w_3"]).all()


@pytest.mark.parametrize("turn", np.linspace(-0.018, 0.018, 10))
def test_no_change_point_is_lost_at_the_seam_of_the_turn(turn):
    """The parallelogram turned a little: its change points lie on either side of the driver's angle 0."""
    u = np.exp(1j * turn)
    links = {
        "0": Link("0", {"O": 0j, "C": 0.3 * u}),
        "1": Link("1", {"O": 0j, "A": 0.1 + 0j}),
        "2": Link("2", {"A": 0j, "B": 0.3 + 0j}),
        "3": Link("3", {"C": 0j, "B": 0.1 + 0j}),
    }
    sketch = {"A": 0.1j * u, "B": (0.3 + 0.1j) * u}
    (found,) = cycle_of(assemble(Mechanism(links, Driver("1", 1.0, ZeroAngle(0.0)), sketch=sketch))).critical
    assert found.changes == pytest.approx(np.sort(np.mod([turn, turn + np.pi], 2 * np.pi)), abs=1e-9)


def slider(crank, rod, extra=""):
    return f"""\
language: en
{extra}
mechanism:
  frame: {{O: [0, 0]}}
  guides: {{x: {{through: O}}}}
  links:
    1: {{points: {{O: 0, A: {crank!r}}}}}
    2: {{points: {{A: 0, B: {rod!r}}}, mass: 1, mass_centre: A, inertia: 0.01}}
    3: {{points: [B], slides: x, mass: 2}}
  driver: {{link: 1, speed: 10, rotation: counter-clockwise}}
  assembly: {{B: right}}
loads: {{}}
"""


def test_rod_equal_to_crank_goes_on_smoothly():
    k = solve(loads(slider(0.1, 0.1))).lever.kinematics
    np.testing.assert_allclose(k.table.place("B"), 0.2 * np.cos(k.turned), atol=1e-12)
    np.testing.assert_allclose(k.values["v_B"].real, -2 * np.sin(k.turned), atol=1e-10)
    assert np.allclose(k.closest[0].changes, [np.pi / 2, 3 * np.pi / 2], atol=1e-9)


@pytest.mark.parametrize("count", [12, 36])
@pytest.mark.parametrize("ratio", [0.95, 0.999])
def test_the_branch_never_changes_near_a_dead_point(ratio, count):
    text = slider(0.1 * ratio, 0.1) + f"positions: {{table: {count}}}\n"
    k = solve(loads(text)).lever.kinematics
    ahead = k.table.place("B").real - k.table.place("A").real
    assert (ahead > 0).all() and k.closest[0].changes == ()
    assert k.closest[0].closeness.value == pytest.approx(np.sqrt(1 - ratio**2), rel=1e-9)


def test_unreachable_rod_is_told_with_its_cure(tmp_path):
    found = solve(loads(slider(0.1, 0.05)))
    (gap,) = found.lever.kinematics.gaps
    assert str(gap.text) == (
        "rod AB = 50 mm cannot reach guide x for 30.00° < φ < 150.00° and 210.00° < φ < 330.00° "
        "(φ is the angle of rotation from position 0); joint A goes as far as 100 mm from its line: "
        "the rod needs at least 100 mm"
    )
    missing = set(found.lever.kinematics.missing)  # the limits themselves are positions too, to rounding
    assert found.lever.partial and {2, 3, 4, 8, 9, 10} <= missing <= {1, 2, 3, 4, 5, 7, 8, 9, 10, 11}
    assert not solve(loads(slider(0.1, 0.05, "allow_partial: true"))).lever.partial


def test_four_bar_that_jams():
    text = """\
language: en
mechanism:
  frame: {O: [0, 0], C: [4.2, 0]}
  links:
    1: {points: {O: 0, A: 3}}
    2: {points: {A: 0, B: 1}}
    3: {points: {C: 0, B: 2}}
  driver: {link: 1, speed: 1}
  assembly: {B: left of A-C}
"""
    k = solve(loads(text)).lever.kinematics
    limit = np.arccos(0.7)  # 45.57°: the rod and the rocker in one line
    assert k.closest[0].limits == pytest.approx((limit, 2 * np.pi - limit), abs=1e-10)
    assert "together the links need at least 7200 mm" in str(k.gaps[0].text)


TRIAD = """\
language: en
mechanism:
  frame: {O: [0, 0], E: [300 mm, 0], F: [100 mm, -200 mm]}
  links:
    1: {points: {O: 0, A: CRANK}}
    2: {points: {A: 0, B: 200 mm}}
    3: {points: {B: 0, C: 120 mm, D: [60 mm, -80 mm]}, mass: 3, mass_centre: B, inertia: 0.01}
    4: {points: {E: 0, C: 150 mm}}
    5: {points: {F: 0, D: 160 mm}}
  driver: {link: 1, speed: 10}
  sketch: {A: [0, CRANK], B: [190 mm, 100 mm], C: [300 mm, 150 mm], D: [220 mm, 20 mm]}
loads: {}
"""


@pytest.mark.exhaustive
def test_class_three_group_is_followed_to_its_limits():
    """With a longer crank the group reaches its limit: found exactly, and the positions that exist are solved."""
    whole = solve(loads(TRIAD.replace("CRANK", "50 mm")))
    assert whole.lever.structure.formula == "I(0,1) → III3(2,3,4,5)"
    assert whole.lever.kinematics.gaps == () and whole.lever.kinetostatics.agrees
    part = solve(loads(TRIAD.replace("CRANK", "140 mm")))
    (gap,) = part.lever.kinematics.gaps
    assert "group III3(2,3,4,5) cannot be assembled for " in str(gap.text)
    assert 0 < len(part.lever.kinematics.missing) < 13 and part.lever.kinetostatics.agrees
    for end in gap.intervals[0]:
        beside = part.lever.kinematics.cycle.motion(np.array([end - 1e-7, end + 1e-7]))
        assert sorted(beside.closes) == [False, True]


@pytest.mark.exhaustive
def test_no_huge_number_anywhere(parallelogram):
    assert parallelogram.lever.kinetostatics.agrees
    document = json.loads(render(parallelogram, "json")["results.json"])
    numbers = [
        x
        for t in document["tables"].values()
        for c in t["columns"]
        for x in c["values"]
        if isinstance(x, float)
    ]
    assert len(numbers) > 1000 and max(map(abs, numbers)) < 1e5
    balancing = document["tables"]["balancing_table"]["columns"]
    assert balancing[2]["key"] == "M_bal" and abs(balancing[2]["values"][6] + 6.962) < 1e-9


@pytest.mark.exhaustive
def test_the_note_says_so(parallelogram):
    text = render(parallelogram, "html")["note.html"].decode()
    assert "passes a change point: its two assemblies meet and two continuations exist" in text


@pytest.mark.parametrize("ratio, digits", [(0.5, 14), (0.999, 11), (1 - 1e-9, 5)])
def test_digits_that_remain_near_a_dead_point(ratio, digits):
    """Rod and crank all but equal: the rod stands across the guide when the crank does."""
    text = f"""\
mechanism:
  frame: {{O: [0, 0]}}
  guides: {{x: {{through: O}}}}
  links:
    1: {{points: {{O: 0, A: {ratio!r}}}}}
    2: {{points: {{A: 0, B: 1}}}}
    3: {{points: [B], slides: x}}
  driver: {{link: 1, speed: 10, rotation: counter-clockwise}}
  assembly: {{B: right}}
"""
    found = solve(loads(text)).lever.kinematics
    assert found.digits == digits and found.singular == ()
    expected = (
        -10
        * ratio
        * (
            np.sin(found.turned)
            + ratio * np.sin(2 * found.turned) / 2 / np.sqrt(1 - (ratio * np.sin(found.turned)) ** 2)
        )
    )
    error = np.abs(found.values["v_B"].real - expected) / np.abs(expected).max()
    assert error.max() < 10.0 ** (1 - digits)


def test_parallel_guides_do_not_meet():
    """A tangent mechanism at a right angle: the slot never crosses the guide, and that is said."""
    text = """\
mechanism:
  frame: {O: [0, 0], Q: [400 mm, 0]}
  guides: {slot: {through: O, link: 1}, y: {through: Q, angle: 90 deg}}
  links:
    1: {points: {O: 0}}
    2: {points: [A], slides: slot}
    3: {points: [A], slides: y}
  driver: {link: 1, speed: 1, rotation: counter-clockwise, zero: {angle: 30 deg}, range: 120 deg}
"""
    k = solve(loads(text)).lever.kinematics
    assert k.missing == (6,)
    assert k.closest[0].parallel == pytest.approx((np.pi / 3,), abs=1e-9)


@pytest.mark.exhaustive
def test_a_lone_change_point_exists_but_has_no_velocities():
    """rod = crank + offset: at 270° the rod is just long enough, and the slider turns back with a jump of velocity."""
    text = (
        slider(0.1, 0.12)
        .replace("through: O}", "through: Q}")
        .replace("O: [0, 0]}", "O: [0, 0], Q: [0, 0.02]}")
    )
    results = solve(loads(text))
    k = results.lever.kinematics
    assert k.missing == () and k.undefined == (9,)
    np.testing.assert_allclose(k.closest[0].corners, [3 * np.pi / 2], atol=1e-7)
    note = render(results, "html")["note.html"].decode()
    assert "is kept in the stated one" in note and "passes a change point" not in note


@pytest.mark.exhaustive
def test_a_slider_at_rest_has_no_dead_points():
    """Rod equal to crank from 90° on: the slider stays in the crank's pivot all round."""
    text = slider(0.1, 0.1).replace("counter-clockwise}", "counter-clockwise, zero: {angle: 90 deg}}")
    (dead,) = solve(loads(text)).lever.kinematics.dead
    assert dead.turned == ()
