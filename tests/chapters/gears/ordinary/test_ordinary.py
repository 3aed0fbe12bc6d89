"""Ordinary stages in drives: what they state, how they turn and load the train, what is refused."""

import numpy as np
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
CHAIN = {
    "kind": "chain",
    "teeth": 25,
    "ratio": 2.4,
    "pitch": "19.05 mm",
    "distance": "700 mm",
    "mass": "1.9 kg/m",
}
FRICTION = {
    "kind": "friction", "driving": "80 mm", "driven": "160 mm", "slip": "2 %", "coefficient": 0.15, "width": "30 mm",
}  # fmt: skip
INNER = {"kind": "friction", "contact": "internal", "driving": "80 mm", "driven": "260 mm"}
TRAIN = {"kind": "train", "teeth": [20, 50], "idlers": [30, 24], "module": "4 mm"}
RINGED = {"kind": "train", "teeth": 20, "ratio": 4, "idlers": [30], "module": "4 mm", "mesh": "internal"}
CONES = FRICTION | {"contact": "bevel", "shaft_angle": "70 deg"}
BEVEL = {"kind": "bevel", "teeth": 20, "ratio": 2.5, "module": "4 mm"}
OBLIQUE = {
    "kind": "bevel", "teeth": [18, 40], "mean_module": "3 mm", "shaft_angle": "75 deg", "width": "30 mm",
    "efficiency": 0.97,
}  # fmt: skip
WORM = {
    "kind": "worm", "starts": 2, "teeth": 40, "module": "5 mm", "q": 10, "friction_angle": "1.8 deg", "splash": 0.96,
}  # fmt: skip
LOCKED = {
    "kind": "worm",
    "starts": 1,
    "ratio": 30,
    "module": "4 mm",
    "q": 12.5,
    "coefficient": 0.12,
    "worm": "below",
}
OTHERS = {
    "chain": CHAIN, "friction": FRICTION, "inner": INNER, "train": TRAIN, "ringed": RINGED, "cones": CONES,
    "bevel": BEVEL, "oblique": OBLIQUE, "worm": WORM, "locked": LOCKED,
}  # fmt: skip
EVERY = {**BELTS, **OTHERS}


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


@pytest.mark.parametrize("name", EVERY)
def test_the_driven_wheel_gets_the_efficiency_s_part_of_the_power(name):
    found = solve(EVERY[name], PAIR, torque="25 N*m")
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


@pytest.mark.parametrize("name", EVERY)
def test_the_diagrams_agree_with_calculation(name):
    found = solve(EVERY[name], PAIR)
    for row in found.plans.comparison:
        assert abs(row.graph - row.analytic) <= 1.001 * row.floor, row.key


@pytest.mark.parametrize("name", EVERY)
def test_the_sense_and_the_ratio_of_the_train_are_those_of_the_stage(name):
    found = solve(EVERY[name])
    (stage,) = found.stages
    assert found.ratio == pytest.approx(stage.ratio, rel=1e-12)
    assert (stage.ratio > 0) == (stage.given.sense > 0)


def test_idlers_change_the_sense_alone():
    for idlers in ([30], [30, 24], [17, 90, 33]):
        one = solve(TRAIN | {"idlers": idlers})
        assert one.ratio == pytest.approx(2.5 * (-1) ** (len(idlers) + 1), rel=1e-12)
        assert one.efficiency == pytest.approx(0.98 ** (len(idlers) + 1), rel=1e-12)


def test_every_idler_has_its_speed_and_its_load():
    found = solve(PAIR, TRAIN, torque="10 N*m")
    names = found.stages[1].given.wheels
    z = [found.train.by_name[name].teeth for name in names]
    for k, name in enumerate(names[1:], 1):
        turned = found.speed[names[0]] * z[0] / z[k] * (-1) ** k
        assert found.speed[name] == pytest.approx(turned, rel=1e-12)
    power = found.speed[names[0]] * found.stages[1].s.number("T1")
    for k, row in enumerate(found.stages[1].s.rows[:-1]):
        v = abs(found.speed[row.index]) * row.number("d") / 2
        assert row.number("F_t") * v == pytest.approx(abs(power) * 0.98**k, rel=1e-9)


def test_the_chain_has_an_even_number_of_links_near_the_distance():
    s = solve(CHAIN).stages[0].s
    assert s.number("links") == 116 and s.number("z2") == 60 and s.number("a") == pytest.approx(0.7, abs=0.02)
    odd = solve({"kind": "chain", "teeth": [25, 60], "pitch": "19.05 mm", "links": 117})
    assert "bent link" in odd.doubts[0].text() and odd.stages[0].s.number("links") == 117
    assert solve({"kind": "chain", "teeth": [25, 60], "pitch": "10 mm"}).stages[0].s.number("a_about") == 0.4


def turned_by_worm(hand, place):
    """How the wheel turns, > 0: counter-clockwise to the reader. In space: the worm along x, turning counter-clockwise
    as seen from its left end; a point of its thread at the wheel, held back from sliding along the tooth, moves the
    tooth along the axis."""
    spin, up = np.array([-1.0, 0, 0]), -1.0 if place == "above" else 1.0  # the wheel lies that way
    contact = np.array([0, up, 0])
    rubbing = np.cross(spin, contact)  # velocity of the worm's point there
    lead = 0.2 if hand == "right" else -0.2
    tooth = np.array([1, 0, 0]) * lead + np.cross(
        [1, 0, 0], contact
    )  # a right-handed helix advances as it turns along x
    # the tooth moves along x so that the difference of the velocities lies along the thread
    along = float(np.linalg.solve(np.array([[1, tooth[0]], [0, tooth[2]]]), [0, rubbing[2]])[1])
    forth = -along * tooth[0]
    wheel = np.cross([0, 0, 1], -contact)[0]  # of the point at the worm where the wheel turns about +z
    return forth / wheel


@pytest.mark.parametrize("hand", ["right", "left"])
@pytest.mark.parametrize("place", ["above", "below"])
def test_the_wheel_turns_as_the_thread_drives_it(hand, place):
    found = solve(WORM | {"hand": hand, "worm": place}).stages[0]
    # turned about the line of centres, the reader's side of the wheel looks to the output, at the right
    seen_from_left = -turned_by_worm(hand, place)
    assert np.sign(seen_from_left) == found.given.sense == np.sign(found.ratio)


def test_a_worm_of_the_stated_efficiency_has_its_friction():
    stated = {key: value for key, value in WORM.items() if key != "friction_angle"} | {"efficiency": 0.75}
    found = solve(stated, torque="20 N*m").stages[0]
    assert found.efficiency == pytest.approx(0.75) and found.s.number("eta") == pytest.approx(0.75)
    again = solve(WORM | {"friction_angle": f"{found.s.number('phi')!r} deg"}).stages[0]
    assert again.efficiency == pytest.approx(0.75, rel=1e-9)


def test_the_worm_locks_where_its_lead_does_not_exceed_the_friction():
    assert not solve(WORM).stages[0].locks and solve(LOCKED).stages[0].locks
    assert "eta_back" in solve(WORM).stages[0].s and "eta_back" not in solve(LOCKED).stages[0].s


def test_power_that_would_flow_back_through_a_worm_is_refused():
    planet = {
        "kind": "planetary", "ratio": 6.6, "module": "5 mm", "satellites": 3, "teeth": [20, 46, 112], "input": "sun",
        "output": "carrier", "second": {"member": "ring", "speed": "-1400 rpm"},
    }  # fmt: skip
    with pytest.raises(ProblemError, match="backwards through the worm"):
        solve(planet, WORM)
    assert solve(planet | {"second": {"member": "ring", "speed": "300 rpm"}}, WORM).loads.settled


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
        ({"distance": None, "length": "920 mm"}, "a belt longer than 932.44 mm"),  # the pulleys would overlap
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


@pytest.mark.parametrize(
    ("stated", "words"),
    [
        (CHAIN | {"distance": "100 mm"}, "sprockets meet"),
        ({"kind": "chain", "teeth": [25, 60], "pitch": "19.05 mm", "links": 60}, "too short"),
        (INNER | {"driven": "80 mm"}, "does not run within"),
        (RINGED | {"ratio": 1.5}, "holds no wheel"),
        (BEVEL | {"shaft_angle": "150 deg"}, "crown wheel"),
        (BEVEL | {"width": "60 mm"}, "too near to the apex"),
        (CONES | {"shaft_angle": "150 deg"}, "is a plate"),
    ],
)
def test_other_stages_that_cannot_be(stated, words):
    with pytest.raises(ProblemError, match=words):
        solve(stated)


@pytest.mark.parametrize(
    ("stated", "words"),
    [
        (CHAIN | {"ratio": -2}, "same sense"),
        (CHAIN | {"links": 120}, "both stated"),
        (CHAIN | {"ratio": 90}, "asks for a driven wheel of 2250"),
        ({"kind": "chain", "teeth": 25, "pitch": "19.05 mm"}, "neither the ratio nor the teeth"),
        (FRICTION | {"driven": None}, "not determined"),
        (INNER | {"ratio": -3}, "same sense"),
        ({"kind": "train", "teeth": [20, 40], "module": "4 mm"}, "idlers"),
        (TRAIN | {"idlers": []}, "idlers"),
        (FRICTION | {"shaft_angle": "90 deg"}, "axes of cylinders"),
        (BEVEL | {"mean_module": "3 mm"}, "one module"),
        (BEVEL | {"ratio": None}, "neither the ratio nor the teeth"),
        (WORM | {"efficiency": 0.8}, "one statement"),
        (WORM | {"friction_angle": None}, "one statement"),
        (LOCKED | {"ratio": 3}, "asks for a driven wheel of 3"),
        (LOCKED | {"ratio": None}, "neither the ratio nor the teeth"),
    ],
)
def test_other_stages_that_are_stated_wrongly(stated, words):
    with pytest.raises(ValueError, match=words):
        solve({key: value for key, value in stated.items() if value is not None})
