"""The chapter of a compound gear train: its numbers by second ways, its scheme and diagrams, what it refuses."""

import math
import re

import pytest
import yaml
from conftest import solved
from notes import render

from tmm_report.chapters.gears.train.draw.routes import Bar, crossings
from tmm_report.chapters.gears.train.draw.scheme import Scheme
from tmm_report.chapters.gears.train.steps import whole
from tmm_report.course import solve
from tmm_report.loading import loads
from tmm_report.problems import ProblemError

CLOSED = {
    "wheels": {"1": 18, "2": 36, "3": 90, "3'": 21, "4": 30, "5": 81}, "carriers": {"H": "2"}, "joined": [["5", "H"]],
    "meshes": ["1-2", "2-3 internal", "3'-4", "4-5 internal"], "input": "1", "output": "H", "speed": "1440 rpm",
}  # fmt: skip
THREE_K = {
    "wheels": {"a": 18, "g": 36, "b": 90, "f": 33, "e": 87}, "carriers": {"H": ["g", "f"]}, "joined": [["g", "f"]],
    "meshes": ["a-g", "g-b internal", "f-e internal"], "input": "a", "output": "e", "fixed": "b", "speed": "1440 rpm",
}  # fmt: skip
AXLE = {
    "wheels": {"1": 11, "2": 43, "3": 20, "4": 12, "5": 20}, "carriers": {"H": "4"}, "joined": [["2", "H"]],
    "meshes": ["1-2 bevel", "3-4 bevel", "4-5 bevel"], "input": "1", "output": ["3", "5"],
    "road": {"speed": "36 km/h", "radius": "18 m", "track": "1450 mm", "wheel": "640 mm"},
}  # fmt: skip
SUNS = {
    "wheels": {"A": 28, "B": 22, "C": 26, "D": 24}, "carriers": {"E": ["B", "C"]}, "joined": [["B", "C"]],
    "meshes": ["A-B", "C-D"], "input": "E", "output": "D", "fixed": "A",
}  # fmt: skip
ONE_CROWN = {
    "wheels": {"a": 15, "g": 16, "b": 47, "e": 49}, "carriers": {"H": "g"},
    "meshes": ["a-g", "g-b internal", "g-e internal"], "input": "a", "output": "e", "fixed": "b",
}  # fmt: skip
CHAIN = {
    "wheels": {"1": 20, "2": 20, "3": 21, "4": 82}, "carriers": {"H": ["2", "3"]},
    "meshes": ["1-2", "2-3", "3-4 internal"], "input": "1", "output": "H", "fixed": "4",
}  # fmt: skip
TWO_INPUTS = {
    "wheels": {"1": 21, "2": 33, "3": 87}, "carriers": {"H": "2"}, "meshes": ["1-2", "2-3 internal"],
    "input": ["1", "3"], "output": "H", "speed": "960 rpm", "speeds": {"3": "150 rpm"},
}  # fmt: skip
HELD_BEVEL = {
    "wheels": {"1": 30, "2": 15, "3": 30}, "carriers": {"H": "2"}, "meshes": ["1-2 bevel", "2-3 bevel"], "input": "1",
    "output": "H", "fixed": "3",
}  # fmt: skip
RING_DRIVES = {
    "wheels": {"1": 20, "2": 30, "3": 80, "4": 20, "5": 28, "6": 76}, "carriers": {"H": "2", "C": "5"},
    "meshes": ["1-2", "2-3 internal", "4-5", "5-6 internal"], "joined": [["H", "6"]], "input": "3", "output": "C",
    "fixed": ["1", "4"],
}  # fmt: skip
THREE_SETS = {
    "wheels": {"a": 30, "p": 20, "b": 70, "a'": 24, "q": 30, "b'": 84, "c": 40, "r": 20, "f": 80},
    "carriers": {"C": "p", "D": "q", "E": "r"}, "joined": [["C", "c"], ["D", "E"]], "input": "a", "output": "b",
    "meshes": ["a-p", "p-b internal", "a'-q", "q-b' internal", "c-r", "r-f internal"], "fixed": "f",
}  # fmt: skip
AXLE_WITH_LOOP = {
    "wheels": {"1": 20, "2": 40, "3": 100, "1'": 30, "4": 30, "5": 90, "6": 20, "7": 12, "8": 20},
    "carriers": {"H": ["2", "7"]}, "joined": [["3", "5"]], "input": "1", "output": ["6", "8"],
    "meshes": ["1-2", "2-3 internal", "1'-4", "4-5 internal", "6-7 bevel", "7-8 bevel"],
    "speed": "1000 rpm", "speeds": {"6": "-105 rpm"}, "torque": "10 N*m",
}  # fmt: skip
SCHEMES = {"closed": CLOSED, "3K": THREE_K, "suns": SUNS, "one crown": ONE_CROWN, "two inputs": TWO_INPUTS}


def results(stated, **changes):
    block = {key: value for key, value in {**stated, **changes}.items() if value is not None}
    return solve(loads(yaml.safe_dump({"language": "en", "train": block}, allow_unicode=True)))


def found(stated, **changes):
    return results(stated, **changes).train


# --- numbers


def test_the_formulas_give_the_numbers_of_the_solver():
    """Every number with a formula is that which its expression evaluates to, rows and members too."""
    for stated in (CLOSED, THREE_K, SUNS, AXLE, CHAIN, TWO_INPUTS):
        made = whole(found(stated, efficiency={"external": 0.98, "internal": 0.99, "bevel": 0.97}))
        rows = [made.s, *made.rows.values(), *made.ratios.values(), *made.members.values()]
        count = 0
        for sheet in rows:
            for key in sheet.computed():
                formula = sheet.formula(key)
                number = sheet[key].value
                unit = sheet.declared(key).formed
                scaled = number / 1000 if unit == "kW" else number
                assert float(formula.value) == pytest.approx(scaled, rel=1e-9, abs=1e-9), key
                count += 1
        assert count > 6


def test_a_train_is_itself_whatever_its_wheels_are_called():
    other = {"wheels": {"8": 18, "9": 36, "x": 90, "y": 21, "z": 30, "w": 81}, "carriers": {"C": "9"}}
    other |= {"joined": [["w", "C"], ["x", "y"]], "meshes": ["8-9", "9-x internal", "y-z", "z-w internal"]}
    other |= {"input": "8", "output": "C", "speed": "1440 rpm"}
    assert found(other).ratio == pytest.approx(found(CLOSED).ratio, rel=1e-14)


def test_a_load_is_the_same_stated_in_every_way():
    one = found(
        CLOSED, rope={"drum": "400 mm", "force": "9 kN"}, efficiency={"external": 0.98, "internal": 0.99}
    )
    torque = float(one.flow.loads.torque["1"])
    row = whole(one).loads["1"]
    assert row["T"].value == torque == pytest.approx(row["T_0"].value / one.efficiency)
    power, useful = (abs(float(one.flow.loads.power[name])) for name in ("1", "H"))
    for load in (
        {"torque": torque}, {"power": power}, {"output_power": useful}, {"output_torque": "1800 N*m"},
    ):  # fmt: skip
        again = found(CLOSED, **load, efficiency={"external": 0.98, "internal": 0.99})
        assert float(again.flow.loads.torque["H"]) == pytest.approx(-1800.0, rel=1e-12)
        assert again.efficiency == pytest.approx(one.efficiency, rel=1e-12)


def test_the_branches_share_the_power_as_the_terms_of_the_formula():
    """u = (1 − u13) + u13 u35: the first term is what goes through the carrier, the second through the ring."""
    of = found(CLOSED, efficiency={"external": 0.98, "internal": 0.99}, torque="10 N*m")
    branches, u13, u35 = whole(of).branches, -90 / 18, -81 / 21
    assert branches["H"]["share_0"].value == pytest.approx((1 - u13) / of.ratio)
    assert branches["5"]["share_0"].value == pytest.approx(u13 * u35 / of.ratio)
    lossy = u13 * 0.98 * 0.99 * u35 * 0.98 * 0.99
    assert branches["5"]["share"].value == pytest.approx(lossy / of.force_ratio)


def test_the_forces_in_the_meshes_turn_the_sun_and_the_ring():
    """2T/(m z) on each of three satellites, the same in both meshes without losses; the ring is held by its moment."""
    plain = {**SUNS, "wheels": {"1": 20, "2": 30, "3": 80}, "carriers": {"H": "2"}, "joined": []}
    plain |= {"meshes": ["1-2", "2-3 internal"], "input": "1", "output": "H", "fixed": "3"}
    of = found(plain, torque="30 N*m", module="2 mm", satellites=3)
    forces = [one["F_t"].value for one in whole(of).meshes]
    assert forces == pytest.approx([30 / 0.020 / 3] * 2)
    assert float(of.flow.loads.torque["3"]) == pytest.approx(forces[1] * 3 * 0.080)
    assert "F_t" not in whole(found(plain, torque="30 N*m")).meshes[0]


def test_the_speed_of_the_output_is_stated_as_well():
    forth = found(THREE_K)
    back = found(THREE_K, speed=None, speeds={"e": forth.speed["e"]})
    assert back.speed["a"] == pytest.approx(forth.speed["a"], rel=1e-9)
    assert back.single and back.ratio == pytest.approx(116)


def test_on_a_straight_road_the_axle_turns_as_one():
    straight = found(AXLE, road={"speed": "36 km/h", "wheel": "640 mm"}, locking=1.5)
    assert straight.speed["3"] == pytest.approx(straight.speed["5"]) == pytest.approx(2 * 10 / 0.64)
    torques = straight.flow.loads.torque
    assert float(torques["3"]) == pytest.approx(float(torques["5"]))  # nothing slides, nothing locks


def test_the_wheels_of_a_curve_turn_about_one_point():
    """Each wheel's way is its own radius times the turn of the car."""
    curve = found(AXLE)
    turn = 10 / 18
    for name, radius in (("3", 18 + 1.45 / 2), ("5", 18 - 1.45 / 2)):
        assert curve.speed[name] * 0.32 == pytest.approx(turn * radius, rel=1e-12)


def test_a_train_that_locks_itself_is_said_to():
    poor = found(
        THREE_K, wheels={**THREE_K["wheels"], "f": 35, "e": 89}, efficiency={"external": 0.9, "internal": 0.9}
    )
    assert poor.locks_back and poor.back <= 0
    assert not found(CLOSED, efficiency={"external": 0.98}).locks_back


def test_rows_that_give_speeds_only_together_are_solved():
    """Two differentials closed by each other: no row has but one unknown speed."""
    stated = {
        "wheels": {"1": 20, "2": 30, "3": 80, "4": 24, "5": 26, "6": 76}, "carriers": {"H": "2", "C": "5"},
        "meshes": ["1-2", "2-3 internal", "4-5", "5-6 internal"], "joined": [["1", "4"], ["3", "C"], ["H", "6"]],
        "input": "1", "output": "H",
    }  # fmt: skip
    of = found(stated)
    one, ring, carrier = (of.speed[name] for name in ("1", "3", "H"))
    assert of.steps is None and of.speed["C"] == ring and of.speed["6"] == carrier
    assert one - carrier == pytest.approx(-80 / 20 * (ring - carrier))
    assert one - ring == pytest.approx(-76 / 24 * (carrier - ring))


def note(of, language="en"):
    page = render(of, "html", language)["note.html"].decode()
    return re.sub(r"\s+", " ", re.sub(r"<[^>]+>", " ", page).replace("\N{NO-BREAK SPACE}", " "))


def test_of_rows_solved_together_the_note_tells_ratio_and_efficiency():
    """Three sets of which each has two members of the others: no member's speed gives any other by one row."""
    solved_ = results(THREE_SETS, efficiency={"external": 0.98, "internal": 0.99}, torque="10 N*m")
    of = solved_.train
    assert of.steps is None
    # a − C = −7/3 (b − C), a − E = −7/2 (b − E), E = C/3; with losses 7/3 and 7/2 by 0.98·0.99, 1/2 times it
    ratios = []
    for one, two, three in ((7 / 3, 7 / 2, 0.5), (7 / 3 / 0.9702, 3.5 * 0.9702, 0.5 * 0.9702)):
        part = three / (1 + three)  # E by C
        C = (one - two) / (1 + one - (1 + two) * part)
        ratios.append((1 + one) * C - one)
    assert [of.ratio, of.force_ratio] == pytest.approx(ratios, rel=1e-12)
    assert of.efficiency == pytest.approx(ratios[1] / ratios[0])
    text = note(solved_)
    assert "The ratio of the train by the speeds of its input and output" in text
    assert "the rows solved together with them give the ratio of the torques" in text
    assert "решённые с ними совместно" in note(solved_, "ru")


@pytest.mark.parametrize("stated", [THREE_SETS, AXLE_WITH_LOOP], ids=["one output", "two outputs"])
def test_power_that_comes_back_through_a_branch_circulates(stated):
    """Whatever ends the train has: a share below nought, and the power that it is of."""
    solved_ = results(stated, torque="10 N*m")
    of = solved_.train
    shares = [row["share"].value for row in whole(of).branches.values()]
    assert min(shares) < 0 and max(shares) > 1
    text = note(solved_)
    assert "All branches carry power one way" not in text and "circulates in the closed loop" in text
    supplied = float(of.flow.loads.supplied)
    assert whole(of).s["P_circulating"].value == pytest.approx(-min(shares) * supplied)
    assert "All branches carry power one way" in note(results(CLOSED))


def test_one_satellite_has_no_neighbours():
    of = found(PLAIN, satellites=1)
    assert of.sound and not of.conditions.neighbours and of.conditions.k == 1
    ranges = {"1": [17, 24], "2": [20, 40], "3": [60, 100]}
    alone = found(PLAIN, wheels=ranges, find={"ratio": 5, "tolerance": "1 %"}, satellites=1)
    assert alone.sound and alone.sought.satellites == (1,)


# --- pictures


TANGLED = {"axle": AXLE, "bevel, one wheel held": HELD_BEVEL, "two rows, a ring drives": RING_DRIVES}


@pytest.mark.parametrize("name", [*SCHEMES, *TANGLED])
def test_the_scheme_of_a_usual_train_crosses_nothing(name):
    drawn = Scheme(found({**SCHEMES, **TANGLED}[name]))
    assert crossings(drawn.bars(drawn.route)) < 1


def test_what_crosses_is_counted():
    one, other = Bar("1", 0j, 10 + 0j), Bar("2", 5 - 3j, 5 + 3j)
    assert crossings([one, other]) >= 1
    assert crossings([one, Bar("1", 5 - 3j, 5 + 3j)]) < 1  # a body does not cross itself
    assert crossings([one, Bar("2", 5 + 1j, 5 + 3j)]) < 1


@pytest.mark.parametrize("name", SCHEMES)
def test_wheels_in_mesh_stand_in_one_plane_and_touch_on_the_scheme(name):
    of = found(SCHEMES[name])
    drawn = Scheme(of)
    for mesh in of.train.meshes:
        one, other = drawn.y(mesh.i), drawn.y(mesh.j)
        apart = abs(drawn.r(mesh.j) - drawn.r(mesh.i)) if mesh.internal else drawn.r(mesh.i) + drawn.r(mesh.j)
        assert abs(one - other) == pytest.approx(apart, abs=1.6e-3 / drawn.scale)  # shift opens it


@pytest.mark.parametrize("name", SCHEMES)
def test_the_diagrams_are_those_of_the_speeds(name):
    """At every pitch point both members have the velocity drawn there; the plan's segments are as the speeds."""
    of = found(SCHEMES[name])
    plans = of.plans
    assert plans is not None
    for spot in plans.spots:
        for member in spot.members:
            zero, omega, low, high = plans.lines[of.built.body(member)]
            assert zero + omega * spot.y == pytest.approx(spot.v, abs=1e-9)
            assert low - 1e-12 <= spot.y <= high + 1e-12
    for member, omega in of.speed.items():
        assert plans.lines[of.built.body(member)][1] == omega
    assert plans.pole == pytest.approx(plans.velocity / (plans.length * plans.angular))


def test_bent_chains_and_crossed_axes_have_no_diagram():
    assert found(CHAIN).plans is None and found(AXLE).plans is None


# --- the search


def test_the_teeth_found_are_solved_as_if_they_were_stated():
    ranges = {"a": [15, 24], "g": [18, 40], "b": [50, 100], "f": [15, 40], "e": [50, 100]}
    of = found(THREE_K, wheels=ranges, find={"ratio": 100, "tolerance": "2 %"}, satellites=[3, 4])
    again = found(THREE_K, wheels=dict(of.sought.teeth), satellites=of.sought.satellites[0])
    assert again.ratio == pytest.approx(of.ratio) and abs(of.ratio / 100 - 1) <= 0.02
    assert again.conditions.met and of.sound and not of.sought.efficiency
    lossy = {"external": 0.98, "internal": 0.99}
    sets = found(THREE_K, wheels=ranges, find={"ratio": 100, "tolerance": "2 %"}, efficiency=lossy).sought
    third = found(THREE_K, wheels=sets.candidates.set(2), efficiency=lossy)
    assert len(sets.efficiency) == len(sets.candidates.ratio)
    assert sets.efficiency[2] == pytest.approx(third.efficiency)
    assert sum(of.sought.candidates.counts.values()) == of.sought.candidates.examined


# --- refused in words

SLIPS = [
    ({"meshes": ["1-2", "2-7 internal"]}, "no member 7"),
    ({"meshes": ["1-2", "2-3 outer"]}, "no mesh of two wheels"),
    ({"meshes": ["1-2", "3-2 internal"]}, "no more teeth than wheel 3"),
    ({"meshes": ["1-2", "2-3 internal", "H-1"]}, "has no teeth"),
    ({"meshes": ["1-1", "2-3 internal"]}, "turn as one"),
    ({"wheels": {"1": 20, "2": 30, "3": 80, "9": 20}}, "wheel 9 meshes with nothing"),
    ({"wheels": {"1": 20, "2": [30, 20], "3": 80}}, "no number of teeth"),
    ({"wheels": {"1": 20, "2": 30.5, "3": 80}}, "no number of teeth"),
    ({"wheels": {"1": 20, "2": [20, 40], "3": 80}}, "sought for no ratio"),
    ({"find": {"ratio": 5}}, "nothing is left to find"),
    ({"carriers": {"H": "2", "C": "2"}}, "carried by two carriers"),
    ({"carriers": {"H": "H"}}, "cannot carry another carrier"),
    ({"carriers": {"1": "2"}}, "1 is a wheel and a carrier"),
    ({"input": "2"}, "planet gear 2 goes round"),
    ({"input": []}, "names no members"),
    ({"fixed": None}, "2 degrees of freedom, and 1 speeds"),
    ({"fixed": "1"}, "member 1 is held and turns"),
    ({"joined": [["2", "3"]]}, "joined to what its carrier does not carry"),
    ({"torque": "5 N*m", "power": "2 kW"}, "the load is stated 2 times"),
    ({"rope": {"drum": "0.4 m", "force": "0 N"}}, "a rope without force"),
    ({"road": {"speed": "36 km/h", "wheel": "0.6 m"}}, "two outputs, and this one has 1"),
    ({"locking": 2}, "two outputs, and this one has 1"),
    ({"efficiency": {"meshes": {"3-4": 0.9}}}, "no mesh 3-4"),
    ({"efficiency": {"external": 1.2}}, "out of range"),
    ({"satellites": 0}, "no number of planet gears"),
    ({"output": ["H", "2"]}, "planet gear 2 goes round"),
    ({"cases": [{"1": "900 rpm", "3": "5 rpm", "H": "7 rpm"}]}, "contradict"),
    ({"cases": [{"7": "900 rpm"}]}, "no member 7"),
    ({"speed": "0 rpm", "power": "2 kW"}, "stands still and has no power"),
    ({"wheels": {"1": [6, 900], "2": [6, 900], "3": [6, 900], }, "find": {"ratio": 0}}, "a ratio of 0"),
    ({"speeds": {"1": "800 rpm"}}, "speed of member 1 is stated twice, by speeds and by speed"),
    ({"speeds": {"3": "20 rpm"}}, "speed of member 3 is stated twice, by speeds and by fixed"),
    ({"modules": {"1": "2 mm", "2": "3 mm", "3": "3 mm"}}, "modules of 2 and 3 mm"),
    ({"module": "2 mm", "modules": {"3": "3 mm"}}, "mesh 2-3 have modules of 2 and 3 mm"),
    ({"modules": {"1": "2 mm", "2": "2 mm"}}, "wheel 2 has a module, and its mate 3 has none"),
]  # fmt: skip
PLAIN = {
    "wheels": {"1": 20, "2": 30, "3": 80}, "carriers": {"H": "2"}, "meshes": ["1-2", "2-3 internal"], "input": "1",
    "output": "H", "fixed": "3", "speed": "900 rpm",
}  # fmt: skip


@pytest.mark.parametrize(("change", "said"), SLIPS, ids=lambda value: value if isinstance(value, str) else "")
def test_a_mistake_is_told_with_its_cure(change, said):
    with pytest.raises(ProblemError) as raised:
        found(PLAIN, **change)
    assert re.search(said, str(raised.value))
    assert all(problem.path[0] == "train" for problem in raised.value.problems)


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"speed": "3000 rpm"}, "2 degrees of freedom, and 3 speeds"),
        ({"speeds": {"5": "300 rpm"}}, "speed of member 5 is stated twice, by speeds and by road"),
    ],
)
def test_nothing_is_stated_beside_a_road_that_the_road_says(change, said):
    with pytest.raises(ProblemError, match=said):
        found(AXLE, **change)


def test_no_speed_is_stated_of_what_turns_as_one_with_a_member_of_known_speed():
    """a' is on the shaft of the driving wheel a."""
    with pytest.raises(ProblemError, match="speed of member a' is stated twice, by speeds and by speed"):
        found(THREE_SETS, speed="900 rpm", speeds={"a'": "700 rpm"})


def test_too_many_combinations_are_refused_before_any_is_tried():
    wide = {name: [6, 900] for name in THREE_K["wheels"]}
    with pytest.raises(ProblemError, match="combinations, and at most"):
        found(THREE_K, wheels=wide, find={"ratio": 60})


def test_what_cannot_be_found_says_how_many_had_the_ratio():
    ranges = {"a": [20, 24], "g": [18, 22], "b": [56, 68], "f": [17, 20], "e": [50, 80]}
    with pytest.raises(ProblemError, match=r"no teeth in the ranges give the ratio: of \d+ sets"):
        found(THREE_K, wheels=ranges, find={"ratio": 300, "tolerance": "0.01 %"})


def test_the_ready_variant_winds_its_rope():
    of = solved("hoist_differential").train
    assert of.sound and abs(of.ratio / 30 - 1) <= 0.01
    assert abs(of.speed["H"]) * 0.21 == pytest.approx(whole(of).s["v"].value)
    assert math.isclose(float(of.flow.loads.torque["H"]), -11000 * 0.21, rel_tol=1e-12)
