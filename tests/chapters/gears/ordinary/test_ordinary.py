"""Ordinary stages in drives: what they state, how they turn and load the train, what is refused."""

import pytest
from test_drive import PAIR, solve

from tmm_report.chapters.gears.ordinary.given import BeltStage
from tmm_report.mechanics.gears.trains import Member, Mesh, Train
from tmm_report.problems import ProblemError

OPEN = {"kind": "belt", "driving": "100 mm", "driven": "250 mm", "distance": "600 mm"}
CROSSED = OPEN | {"belt": "crossed", "slip": 0.02}
V = {
    "kind": "belt", "belt": "V", "driving": "100 mm", "ratio": 2, "driven": "standard", "slip": "1.5 %",
    "distance": "400 mm", "length": "standard", "coefficient": 0.3, "reserve": 1.3, "mass": "0.18 kg/m",
}  # fmt: skip
BELTS = {"open": OPEN, "crossed": CROSSED, "V": V}


def test_a_mesh_without_teeth_needs_a_ratio():
    members = (Member("1", "wheel", radius=0.1), Member("2", "wheel", radius=0.2, distance=0.5))
    assert Train(members, (Mesh("1", "2", internal=True, size=2.0),)).freedom == 1
    with pytest.raises(ValueError, match="or a ratio"):
        Train(members, (Mesh("1", "2"),))


def test_the_sense_is_known_before_the_stage_is_solved():
    assert [BeltStage(belt=one, driving=0.1, driven=0.2).sense for one in ("open", "V", "crossed")] == [
        1,
        1,
        -1,
    ]


@pytest.mark.parametrize("name", BELTS)
def test_the_belt_has_one_velocity_on_both_pulleys_but_for_the_slip(name):
    found = solve(BELTS[name])
    (stage,) = found.stages
    one, two = (abs(found.speed[m.name]) * m.radius for m in stage.members)
    assert two == pytest.approx(one * (1 - stage.given.slip), rel=1e-12)
    assert (found.speed[stage.output] < 0) == (name == "crossed")


@pytest.mark.parametrize("name", BELTS)
def test_the_driven_pulley_gets_the_efficiency_s_part_of_the_power(name):
    found = solve(BELTS[name], PAIR, torque="25 N*m")
    assert abs(found.loads.imbalance) < 1e-9 * found.loads.supplied
    expected = found.stages[0].efficiency * found.stages[1].efficiency
    assert found.efficiency == pytest.approx(expected, rel=1e-12)


def test_the_torque_of_a_stage_is_that_of_its_input():
    found = solve(PAIR, V, torque="25 N*m")
    belt = found.stages[1]
    wanted = 25 * abs(found.stages[0].ratio) * found.stages[0].efficiency
    assert belt.s.number("T1") == pytest.approx(wanted, rel=1e-12)
    assert belt.s.number("omega1") == pytest.approx(abs(found.speed[belt.input]), rel=1e-12)
    assert "T1" not in solve(PAIR, V).stages[1].s


@pytest.mark.parametrize("name", BELTS)
def test_the_diagrams_carry_the_velocity_of_the_belt_over(name):
    found = solve(PAIR, BELTS[name], PAIR)
    for row in found.plans.comparison:
        assert abs(row.graph - row.analytic) <= 1.001 * row.floor, row.key
    tied = [spot for spot in found.plans.spots if spot.tied]
    (spot,) = tied
    v = found.plans.velocity
    step = 0.011 / abs(v[spot.tied])
    assert v[spot.name] / v[spot.tied] == pytest.approx(1 - found.stages[1].given.slip, rel=step)


def test_the_usual_rules():
    """Without a distance, without an efficiency."""
    found = solve({"kind": "belt", "driving": "100 mm", "driven": "200 mm"}).stages[0]
    assert found.s.number("a") == pytest.approx(0.45) and found.efficiency == 0.96
    found = solve({"kind": "belt", "belt": "V", "driving": "100 mm", "driven": "200 mm"}).stages[0]
    assert found.s.number("a") == pytest.approx(0.3) and found.efficiency == 0.95


def test_two_of_the_diameters_and_the_ratio_give_the_third():
    one = solve({"kind": "belt", "driving": "100 mm", "ratio": 2.5, "slip": 0.02}).stages[0]
    assert one.s.number("d2") == pytest.approx(0.245) and one.ratio == pytest.approx(2.5)
    two = solve({"kind": "belt", "belt": "crossed", "driven": "245 mm", "ratio": 2.5, "slip": 0.02}).stages[0]
    assert two.s.number("d1") == pytest.approx(0.1) and two.ratio == pytest.approx(-2.5)
    three = solve(V).stages[0]
    assert three.s.number("d2") == 0.2 and three.wanted == 2 and three.ratio == pytest.approx(2 / 0.985)


def test_a_given_length_is_kept():
    s = solve({"kind": "belt", "driving": "100 mm", "driven": "200 mm", "length": "1250 mm"}).stages[0].s
    assert s.number("L") == 1.25 and float(s.formula("L").value) == pytest.approx(1.25, rel=1e-12)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"distance": "120 mm"}, "pulleys meet"),
        ({"length": "1250 mm"}, "both stated"),
        ({"distance": None, "length": "500 mm"}, "too short"),
    ],
)
def test_belts_that_cannot_be(change, words):
    stated = {key: value for key, value in (OPEN | change).items() if value is not None}
    with pytest.raises(ProblemError, match=words) as raised:
        solve(PAIR, stated)
    assert raised.value.problems[0].path[:3] == ("drive", "stages", 1)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"ratio": -2}, "same sense"),
        ({"driven": None}, "not determined"),
        ({"driven": "standard"}, "not determined"),
        ({"groove": "38 deg"}, "no groove"),
        ({"slip": 0.3}, "slip"),
        ({"kind": "belts"}, "begin with kind"),
    ],
)
def test_belts_that_are_stated_wrongly(change, words):
    stated = {key: value for key, value in (OPEN | change).items() if value is not None}
    with pytest.raises(ValueError, match=words):
        solve(stated)
