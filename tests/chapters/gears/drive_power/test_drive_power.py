"""A drive from its machine back to the motor: its numbers against a plain walk, the powers and torques of the train."""

import math
import re

import pytest
from conftest import examples
from hypothesis import given, settings
from hypothesis import strategies as st
from notes import render, static

from tmm_report import course, loading
from tmm_report.chapters.gears.drive import bounds, stages
from tmm_report.chapters.gears.drive import solve as drive
from tmm_report.chapters.gears.drive.block import DriveModel, build
from tmm_report.chapters.gears.drive.power.quantities import verdict
from tmm_report.chapters.gears.drive.quantities import tables
from tmm_report.chapters.gears.drive.view import DriveView
from tmm_report.i18n import Translator
from tmm_report.problems import ProblemError
from tmm_report.report.formats import Html
from tmm_report.report.numbering import Numbering
from tmm_report.report.page import Page

RPM = 30 / math.pi
PAIR = {"kind": "spur", "ratio": -3, "module": "3 mm", "teeth": [20, 60], "efficiency": 0.97}
OPEN = {"kind": "spur", "module": "3 mm", "teeth": [20, "rest"], "efficiency": 0.97}
PLANETARY = {
    "kind": "planetary", "ratio": 6.56, "module": "5 mm", "satellites": 3, "teeth": [20, 46, 112],
    "input": "sun", "output": "carrier", "fixed": "ring",
}  # fmt: skip
DRUM = {"force": "3.2 kN", "speed": "0.85 m/s", "diameter": "315 mm"}
MOTORS = [
    ["90L2", "3 kW", "2840 rpm"], ["100S2", "4 kW", "2850 rpm"], ["100S4", "3 kW", "1410 rpm"],
    ["100L4", "4 kW", "1410 rpm"], ["112MA6", "3 kW", "950 rpm"], ["112MB6", "4 kW", "950 rpm"],
]  # fmt: skip


def solve(*stages, **more):
    return drive.solve(build(DriveModel.model_validate({"stages": list(stages), **more})))


def problems(*stages, **more):
    with pytest.raises(ProblemError) as raised:
        solve(*stages, **more)
    return [problem.text() for problem in raised.value.problems]


ETA = st.floats(0.6, 0.999)


@given(
    st.lists(st.tuples(st.integers(17, 40), st.integers(20, 120), ETA), min_size=1, max_size=4),
    ETA, ETA, ETA, st.data(), st.floats(100.0, 9000.0), st.floats(0.1, 3.0), st.floats(0.1, 0.8), st.booleans(),
)  # fmt: skip
@settings(max_examples=examples(40), deadline=None)
def test_a_plain_walk_from_the_machine_to_the_motor(
    pairs, bearing, coupling, own, data, force, v, diameter, before
):
    count = len(pairs)
    after = data.draw(st.lists(st.integers(0, count), min_size=0, max_size=3))
    shafts = 1 + count + len(after)
    numbers = data.draw(st.lists(st.integers(0, 3), min_size=shafts, max_size=shafts))
    found = solve(
        *({**PAIR, "ratio": -b / a, "teeth": [a, b], "efficiency": eta} for a, b, eta in pairs),
        speed="1410 rpm",
        output={"force": force, "speed": f"{v} m/s", "diameter": f"{diameter} m", "efficiency": own},
        bearings={"efficiency": bearing, "pairs": numbers},
        shafts={"at": "before bearings" if before else "after bearings", "torque": 9550},
        **({"coupling": {"efficiency": coupling, "after": after}} if after else {}),
    ).power

    # what stands between the machine and the motor, walked backwards: (ratio, efficiency) of each link
    links = []
    for k in range(count + 1):
        if k:
            a, b, eta = pairs[k - 1]
            links.append((b / a, eta))
        links += [(1.0, coupling)] * after.count(k)
    power, turns = force * v / own, 1410.0
    for u, _ in links:
        turns /= u
    told = []
    for shaft in range(shafts - 1, -1, -1):
        received = power / bearing ** numbers[shaft]
        told.append((received if before else power, turns))
        if shaft:
            u, eta = links[shaft - 1]
            power, turns = received / eta, turns * u
    for shaft, (power_, turns_) in enumerate(reversed(told)):
        assert found.power[shaft] == pytest.approx(power_, rel=1e-12)
        assert found.omega[shaft] * RPM == pytest.approx(turns_, rel=1e-12)
        assert found.torque[shaft] == pytest.approx(9550 * power_ / 1000 / turns_, rel=1e-12)
    assert found.plan.required == pytest.approx(power / bearing ** numbers[0], rel=1e-12)
    assert found.deviation == pytest.approx(math.pi * diameter * told[0][1] / 60 / v - 1, abs=1e-12)


def test_without_bearings_and_couplings_the_shafts_have_the_torques_of_the_train():
    """Willis and the balance of every member against the walk along the shafts; a planetary stage among them."""
    found = solve(PAIR, PLANETARY, PAIR, speed="1410 rpm", output={"torque": "900 N*m", "speed": "27 rpm"})
    shafts, load = found.power, found.loads
    assert abs(load.torque[found.output]) == pytest.approx(shafts.torque[-1], rel=1e-12)
    assert load.power[found.input] == pytest.approx(shafts.plan.required, rel=1e-12)
    assert shafts.torque[-1] * found.speed[found.output] == pytest.approx(
        -load.power[found.output], rel=1e-12
    )
    assert -load.power[found.output] == pytest.approx(900 * 27 / RPM, rel=1e-12)
    # the output turns otherwise than wanted, so its torque is not the stated one, and its power is
    assert shafts.torque[-1] == pytest.approx(900 * 27 / RPM / abs(found.speed[found.output]), rel=1e-12)


def test_forces_in_the_teeth_follow_the_shafts():
    found = solve(
        PAIR,
        PLANETARY,
        speed="1410 rpm",
        output=DRUM,
        bearings=0.98,
        coupling={"efficiency": 0.9, "after": [1]},
    )
    (loaded,) = (table for table in tables(found) if table.name == "drive_mesh_loads")
    forces = dict(zip(loaded["mesh"].values, loaded["F_t"].values, strict=True))
    required = found.power.plan.required
    pinion, sun = (found.train.by_name[name].radius for name in ("1", "3"))
    assert forces["1-2"] == pytest.approx(required / (1410 / RPM) / pinion, rel=1e-12)
    # behind the coupling and its bearings, on each of three satellites
    on_sun = required * 0.97 * 0.98 * 0.9 * 0.98 / (1410 / RPM / 3)
    assert forces["3-4"] == pytest.approx(on_sun / (3 * sun), rel=1e-12)


def test_stages_and_meshes_have_the_torques_of_the_printed_table():
    belt = {"kind": "belt", "driving": "100 mm", "driven": "200 mm"}
    found = solve(belt, PAIR, speed="1410 rpm", output=DRUM, bearings=0.99, shafts={"torque": 9550})
    assert found.stages[0].s.number("T1") == pytest.approx(found.power.torque[0], rel=1e-12)
    (loaded,) = (table for table in tables(found) if table.name == "drive_mesh_loads")
    radius = found.train.by_name["3"].radius
    assert loaded["F_t"].values[0] == pytest.approx(found.power.torque[1] / radius, rel=1e-12)


def test_the_motor_is_chosen_and_every_one_is_told_why_not():
    losses = {"bearings": 0.99, "coupling": 0.97}
    found = solve(OPEN, OPEN, output=DRUM, motors=MOTORS, ratio_range=[25, 30], **losses).power
    assert found.motor.name == "100L4"
    told = [verdict(found, row) for row in range(len(MOTORS))]
    assert told == ["weak, fast", "fast", "weak", "taken", "weak, slow", "slow"]
    assert found.plan.judged[3].load == pytest.approx(2720 / 0.97**3 / 0.99**3 / 4000)


def test_a_permitted_overload_takes_a_weaker_motor():
    found = solve(OPEN, OPEN, output=DRUM, motors=MOTORS, ratio_range=[25, 30], overload="5 %").power
    assert found.motor.name == "100S4" and not found.overloaded
    assert verdict(found, 3) == "will do"


@pytest.mark.parametrize(
    ("split", "ratios"),
    [
        ("equal", lambda u: (math.sqrt(u), math.sqrt(u))),
        ({"slow": 0.88}, lambda u: (math.sqrt(u) / 0.88, 0.88 * math.sqrt(u))),
        ({"fast": 1.2}, lambda u: (1.2 * math.sqrt(u), math.sqrt(u) / 1.2)),
        ({"step": 1.25}, lambda u: (math.sqrt(1.25 * u), math.sqrt(u / 1.25))),
    ],
)  # fmt: skip
def test_the_ratio_is_divided_and_the_teeth_are_rounded(split, ratios):
    found = solve(OPEN, PAIR, OPEN | {"teeth": [22, "rest"]}, output=DRUM, motors=[MOTORS[3]], split=split)
    u = 1410 / (60 * 0.85 / (math.pi * 0.315)) / 3
    for stage, z, wanted in zip((found.stages[0], found.stages[2]), (20, 22), ratios(u), strict=True):
        assert stage.wanted == pytest.approx(-wanted)
        assert stage.teeth.z == (z, math.floor(z * wanted + 0.5))
    actual = math.prod(stage.teeth.z[1] / stage.teeth.z[0] for stage in found.stages)
    assert found.power.deviation == pytest.approx(3 * u / actual - 1)


def test_three_stages_in_progression():
    found = solve(OPEN, OPEN, OPEN, output=DRUM, motors=[MOTORS[1]], split={"step": 1.1})
    u = [abs(stage.wanted) for stage in found.stages]
    assert u[0] / u[1] == pytest.approx(1.1) and u[1] / u[2] == pytest.approx(1.1)
    assert math.prod(u) == pytest.approx(2850 / (60 * 0.85 / (math.pi * 0.315)))


def test_the_driven_wheel_may_be_the_stated_one():
    found = solve(OPEN | {"teeth": ["rest", 80]}, output=DRUM, motors=[["m", "4 kW", "206 rpm"]])
    assert found.stages[0].teeth.z == (20, 80)


def test_what_the_motor_allows():
    """The reverse question: the machine has a drum and no load."""
    found = solve(
        PAIR, PAIR, output={"diameter": "0.4 m"}, motors=[["m", "3 kW", "900 rpm"]], bearings=0.99
    ).power
    eta = 0.97**2 * 0.99**2
    assert found.plan.required is None and found.rated
    assert found.allowed == pytest.approx(3000 * eta)
    assert found.torque[-1] == pytest.approx(3000 * eta / (100 / RPM))
    made = {one.key: one.value for one in values(PAIR, PAIR, output={"diameter": "0.4 m"},
                                                  motors=[["m", "3 kW", "900 rpm"]], bearings=0.99)}  # fmt: skip
    assert made["drive_F_allowed"] == pytest.approx(3000 * eta / (math.pi * 0.4 * 100 / 60))
    assert made["drive_T_allowed"] == pytest.approx(3000 * eta / (100 / RPM))


def values(*stages, **more):
    from tmm_report.chapters.gears.drive.quantities import values as all_values

    return list(all_values(solve(*stages, **more)))


def test_powers_from_the_rated_one():
    found = solve(
        PAIR, output=DRUM, motors=[["m", "4 kW", "154 rpm"]], shafts={"by": "rated"}, bearings=0.99
    ).power
    assert found.power[0] == pytest.approx(4000) and found.power[1] == pytest.approx(4000 * 0.97 * 0.99)
    assert found.plan.required == pytest.approx(2720 / 0.97 / 0.99)


def test_a_load_without_a_speed_goes_at_that_of_the_drive():
    found = solve(PAIR, speed="900 rpm", output={"force": "9 kN", "diameter": "400 mm"}).power
    assert found.plan.need.power == pytest.approx(9000 * 0.2 * 300 / RPM)


def test_a_sprocket_goes_by_its_pitches_and_a_load_by_its_mass():
    found = solve(
        PAIR, speed="90 rpm", output={"force": "500 kg", "speed": "0.5 m/s", "teeth": 9, "pitch": "80 mm"}
    )
    assert found.power.plan.need.omega * RPM == pytest.approx(0.5 * 60 / (9 * 0.08))
    assert found.power.plan.need.power == pytest.approx(500 * 9.81 * 0.5)


def test_the_usual_range_of_the_ratio():
    """Of two pairs without a ratio 2 … 6.3 each, of the stated one its own."""
    found = solve(OPEN, PAIR, OPEN, output=DRUM, motors=MOTORS).power
    assert found.plan.usual and found.plan.range == pytest.approx((12, 3 * 6.3**2))
    assert found.motor.name == "100S4"  # nearest to √(12·119) of those with 3 kW


WRONG = [
    (([OPEN], {"output": DRUM, "motors": MOTORS, "ratio_range": [100, 200]}), "no motor of the list will do"),
    (
        ([OPEN], {"speed": "1400 rpm", "output": {"power": "3 kW"}}),
        "the ratio of the stage is stated by nothing",
    ),
    (
        ([PAIR], {"motors": MOTORS, "output": {"force": 900, "diameter": "0.4 m"}}),
        "how fast the machine works",
    ),
    (([PAIR], {"motors": MOTORS, "output": {"power": "3 kW"}}), "no motor of the list can be chosen"),
    (
        ([PAIR], {"speed": "99 rpm", "output": DRUM, "coupling": {"efficiency": 0.98, "after": [2]}}),
        "behind stage 2",
    ),
    (
        ([PAIR], {"speed": "99 rpm", "output": DRUM, "bearings": {"efficiency": 0.9, "pairs": [1, 1, 1]}}),
        "pairs of bearings of 3 shafts are stated, and the drive has 2",
    ),
    (
        ([OPEN] * 3, {"output": DRUM, "motors": [MOTORS[1]], "split": {"slow": 0.88}}),
        "between two stages, and 3",
    ),
    (([OPEN], {"output": DRUM, "motors": [["m", "4 kW", "60 rpm"]]}), None),
    (([OPEN], {"output": DRUM, "motors": [["m", "4 kW", "8 rpm"]]}), "its other wheel 3 teeth"),
]


@pytest.mark.parametrize(("stated", "said"), WRONG)
def test_what_cannot_be_found_is_said(stated, said):
    stages, more = stated
    if said is None:
        assert solve(*stages, **more).stages[0].teeth.z == (20, 23)
        return
    (line,) = problems(*stages, **more)
    assert said in line and line.startswith("drive.")


def test_the_mistakes_of_all_the_stages_are_told_beside_one_without_a_ratio():
    chain = {"kind": "chain", "teeth": [20, 50], "pitch": "19.05 mm", "distance": "100 mm"}
    cones = {"kind": "bevel", "teeth": [20, 50], "module": "4 mm", "width": "60 mm"}
    back = OPEN | {"teeth": [20, 50], "coaxial": True}
    said = problems(chain, OPEN, cones, back, output=DRUM, motors=[MOTORS[3]])
    places = ["drive.stages.0.distance", "drive.stages.2.width", "drive.stages.3.coaxial"]
    assert [line.partition(":")[0] for line in said] == places


SOUGHT = {
    "kind": "planetary", "scheme": "external-internal", "ratio": 11, "module": "3 mm", "satellites": 3,
    "input": "wheel1", "output": "carrier", "fixed": "wheel3",
}  # fmt: skip


def test_the_search_of_a_stage_is_bounded_and_made_once_beside_one_without_a_ratio(monkeypatch):
    made = []
    searched = stages.planetary.solve
    monkeypatch.setattr(stages.planetary, "solve", lambda one: made.append(one) or searched(one))
    more = {"output": DRUM, "motors": [["m", "4 kW", "1800 rpm"]]}
    monkeypatch.setattr(bounds, "MOST", 100)
    with pytest.raises(ProblemError, match="combinations of teeth to be tried"):
        solve(SOUGHT, OPEN, **more)
    assert not made
    monkeypatch.undo()
    monkeypatch.setattr(stages.planetary, "solve", lambda one: made.append(one) or searched(one))
    assert solve(SOUGHT, OPEN, **more).stages[1].teeth.z[0] == 20
    assert len(made) == 1


@pytest.mark.parametrize(
    "keys",
    [
        "speed: 90 rpm, output: {force: 9 kN, diameter: 0.4 m}",  # the machine goes as the drive does
        "motors: [[m, 3 kW, 900 rpm]], output: {diameter: 0.4 m}",
        "motors: [[m, 3 kW, 900 rpm]]",
        "speed: 90 rpm, output: {power: 2 kW}",
        "speed: 90 rpm, output: {power: 2 kW, teeth: 9, pitch: 80 mm, speed: 0.5 m/s}",
    ],
)
def test_its_note_is_written_whatever_is_left_out(keys):
    text = f"language: en\ndrive: {{{keys}, stages: [{{kind: spur, teeth: [20, 60]}}]}}\n"
    note = render(course.solve(loading.loads(text)), "html")["note.html"].decode()
    assert "The power passes the parts" in note and not re.search(r"\bnan\b", static(note))


def test_the_words_of_the_tables_stand_in_their_rows():
    """What a motor is refused for, and what brings the power to a shaft: words that no number of the results holds."""
    belt = {"kind": "belt", "ratio": 2, "driving": "100 mm", "driven": "200 mm"}
    losses = {"bearings": 0.99, "coupling": 0.98}
    found = solve(belt, OPEN, OPEN, output=DRUM, motors=MOTORS, ratio_range=[25, 30], **losses)
    view = DriveView(found, Page(Html(), Translator("en"), Numbering()), "drive").power_view
    verdicts = [str(row[-1]) for row in view.motors_table().parts[0].rows]
    assert verdicts == [
        "too weak, ratio too great", "ratio too great", "too weak", "this one is taken",
        "too weak, ratio too small", "ratio too small",
    ]  # fmt: skip
    assert [str(row[1]) for row in view.shafts_table().parts[0].rows] == [
        "motor", "stage 1–2", "stage 3–4", "stage 5–6", "coupling",
    ]  # fmt: skip
