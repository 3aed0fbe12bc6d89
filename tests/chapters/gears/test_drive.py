"""A drive of any stages in any order: whole ratio, speeds, power, diagrams against calculation, mistakes."""

import math

import numpy as np
import pytest
from conftest import examples
from hypothesis import given, settings
from hypothesis import strategies as st

from tmm_report.chapters.gears.drive import quantities as tables
from tmm_report.chapters.gears.drive import solve as drive
from tmm_report.chapters.gears.drive.block import DriveModel, build
from tmm_report.chapters.gears.drive.view import DriveView
from tmm_report.i18n import Translator
from tmm_report.problems import ProblemError
from tmm_report.report.formats import Html
from tmm_report.report.numbering import Numbering
from tmm_report.report.page import Page

PLANETARY = {
    "kind": "planetary",
    "scheme": "sun-ring",
    "ratio": 6.56,
    "module": "5 mm",
    "satellites": 3,
    "teeth": [20, 46, 112],
    "input": "sun",
    "output": "carrier",
    "fixed": "ring",
}
PAIR = {"kind": "spur", "ratio": -2, "module": "6 mm", "centre_distance": "130 mm"}
INTERNAL = {"kind": "spur", "ratio": 3, "module": "4 mm", "teeth": [30, 90], "shift": [0, 0]}
SECOND = {key: value for key, value in PLANETARY.items() if key != "fixed"} | {
    "second": {"member": "ring", "speed": "500 rpm"}
}
DOUBLE = {
    "kind": "planetary",
    "scheme": "external-internal",
    "ratio": 12,
    "module": "3 mm",
    "satellites": 3,
    "input": "wheel1",
    "output": "carrier",
    "fixed": "wheel3",
}
BACK = PLANETARY | {"input": "carrier", "output": "sun", "ratio": 1 / 6.56}

DRIVES = {
    "planetary, pair": [PLANETARY, PAIR],
    "pair, planetary": [PAIR, PLANETARY],
    "two planetary": [PLANETARY, PLANETARY],
    "double row, internal pair": [DOUBLE, INTERNAL],
    "pair, double row, pair": [PAIR, DOUBLE, PAIR],
    "ordinary": [PAIR, INTERNAL, PAIR],
    "differential, pair": [SECOND, PAIR],
    "pair, differential": [PAIR, SECOND],
    "multiplier": [BACK, PAIR],
}


def solve(*stages, accuracy=1e-5, **more):
    model = DriveModel.model_validate({"speed": "3000 rpm", "stages": list(stages), **more})
    return drive.solve(build(model, accuracy))


@pytest.fixture(scope="module", params=DRIVES, ids=str)
def found(request):
    return solve(*DRIVES[request.param])


def test_every_mesh_satisfies_willis(found):
    for mesh in found.train.meshes:
        carried = found.speed[mesh.carrier] if mesh.carrier else 0.0
        ratio = (found.speed[mesh.i] - carried) / (found.speed[mesh.j] - carried)
        teeth = found.train.by_name[mesh.j].teeth / found.train.by_name[mesh.i].teeth
        assert ratio == pytest.approx(teeth if mesh.internal else -teeth, rel=1e-9)


def test_shafts_of_neighbouring_stages_turn_together(found):
    for before, after in zip(found.stages, found.stages[1:], strict=False):
        assert found.speed[before.output] == found.speed[after.input]


def test_powers_balance(found):
    assert abs(found.loads.imbalance) < 1e-9 * found.loads.supplied
    assert found.loads.settled and not found.locks


def test_without_a_second_input_ratio_and_efficiency_are_products(found):
    if not found.differential:
        assert found.ratio == pytest.approx(found.geared, rel=1e-12)
        assert found.efficiency == pytest.approx(math.prod(s.efficiency for s in found.stages), rel=1e-12)


def test_the_diagrams_agree_with_calculation_to_the_reading(found):
    """Read to 0.01 mm, a value differs by half a step of its scale at most."""
    for row in found.plans.comparison:
        assert abs(row.graph - row.analytic) <= 0.5001 * row.floor, row.key


def test_segments_and_velocities_have_the_sense_of_the_rotation(found):
    """Signed: to the right where a member turns as the input shaft does."""
    plans = found.plans
    for line in plans.lines:
        assert line.s * plans.angular_scale == pytest.approx(
            found.speed[line.members[0]], abs=0.0051 * plans.angular_scale
        )
    for spot in plans.spots:
        wheel = found.train.by_name[spot.members[0]]
        if not wheel.carried_by:
            v = found.speed[wheel.name] * (spot.y - plans.axes[wheel.name])
            drawn = plans.velocity[spot.name] * plans.velocity_scale
            assert drawn == pytest.approx(v, abs=0.0051 * plans.velocity_scale)


def test_the_graphical_ratio(found):
    names = found.input, found.output
    reading = 0.005 / min(abs(found.plans.segment(name)) for name in names)
    assert found.plans.ratio(*names) == pytest.approx(found.ratio, rel=2.1 * reading)


def test_velocities_of_common_points_agree(found):
    """v of a point in mesh is the same from both wheels: the lines of the diagram meet there."""
    axes = found.plans.axes
    for spot in found.plans.spots:
        values = []
        for name in spot.members:
            wheel = found.train.by_name[name]
            arm = axes[name] - axes[wheel.carried_by] if wheel.carried_by else 0.0
            carried = found.speed[wheel.carried_by] * arm if wheel.carried_by else 0.0
            values.append(carried + found.speed[name] * (spot.y - axes[name]))
        assert values[0] == pytest.approx(values[1], rel=1e-9, abs=1e-9), spot.name


def test_every_drive_is_drawn_and_printed(found):
    view = DriveView(found, Page(Html(), Translator("ru"), Numbering()), "drive")
    for picture in (view.scheme, view.diagrams):
        left, bottom, right, top = picture.box
        assert 0 < right - left < 200 and 0 < top - bottom < 260
    assert view.laid_off().value == pytest.approx(abs(view.s.number("v")))


def test_every_drive_gives_its_tables(found):
    by_name = {table.name: table for table in tables.tables(found, "drive")}
    columns = {column.key: column.values for column in by_name["drive_speeds"].columns}
    assert dict(zip(columns["member"], columns["omega"], strict=True)) == dict(found.speed)
    values = {value.key: value.value for value in tables.values(found, "drive")}
    assert values["drive_u"] == found.ratio and values["drive_eta"] == found.efficiency


def test_by_hand_the_diagrams_are_coarser_but_within_their_limit():
    coarse = solve(PLANETARY, PAIR, accuracy=5e-4).plans
    fine = solve(PLANETARY, PAIR).plans
    assert coarse.segment("5") % 0.5 == 0 and coarse.segment("5") != fine.segment("5")
    assert all(row.ok for row in coarse.comparison)


def test_stated_scales_are_kept():
    plans = solve(PLANETARY, PAIR, scales={"length": 0.005, "velocity": 0.4, "angular": 4}).plans
    assert (plans.length_scale, plans.velocity_scale, plans.angular_scale) == (0.005, 0.4, 4.0)
    assert plans.velocity["A"] == pytest.approx(15.708 / 0.4, abs=0.01)


def test_the_torque_of_the_input_scales_all():
    one, many = solve(PLANETARY, PAIR).loads, solve(PLANETARY, PAIR, torque="25 N*m").loads
    for name, torque in one.torque.items():
        assert many.torque[name] == pytest.approx(25 * float(torque), rel=1e-12)


@pytest.mark.exhaustive
@settings(max_examples=examples(30))
@given(st.floats(-3000, 3000).filter(lambda n: abs(n) > 1))
def test_a_second_input_adds_its_share(rpm):
    """ω5 is linear in both inputs: that of the sun alone plus that of the ring alone."""
    stage = SECOND | {"second": {"member": "ring", "speed": f"{rpm} rpm"}}
    both, alone = solve(stage, PAIR), solve(PLANETARY, PAIR)
    share = np.pi * rpm / 30 * (5.6 / 6.6) / -2
    assert both.speed["5"] == pytest.approx(alone.speed["5"] + share, rel=1e-9, abs=1e-9)


def test_two_inputs_may_hold_the_output():
    """ω_H = (ω1 + 5.6 ω3)/6.6 = 0."""
    stage = SECOND | {"second": {"member": "ring", "speed": f"{-3000 / 5.6} rpm"}}
    found = solve(stage, PAIR)
    assert found.speed["H"] == found.speed["5"] == 0.0 and math.isinf(found.ratio)
    assert found.geared == pytest.approx(-13.2) and not found.runs


def test_wheels_are_numbered_through_the_drive():
    names = [member.name for member in solve(PAIR, DOUBLE, PLANETARY).train.members]
    assert names == ["1", "2", "3", "4", "4'", "5", "H1", "6", "7", "8", "H2"]


@pytest.mark.parametrize("torque", ["0 N*m", "-5 N*m"])
def test_the_input_drives(torque):
    """Without torque there is no power and so no efficiency."""
    with pytest.raises(ValueError, match="torque"):
        DriveModel.model_validate({"speed": "1500 rpm", "torque": torque, "stages": [PAIR]})


def test_the_whole_deviation_is_judged():
    assert solve(PLANETARY, PAIR).within
    assert not solve(PLANETARY, PAIR, tolerance="0.5 %").within


def test_mistakes_of_all_stages_come_at_once_with_their_places():
    wrong = PLANETARY | {"teeth": [20, 45, 112]}
    with pytest.raises(ProblemError) as raised:
        solve(wrong, PAIR, wrong)
    assert {problem.path[:3] for problem in raised.value.problems} == {
        ("drive", "stages", 0),
        ("drive", "stages", 2),
    }
