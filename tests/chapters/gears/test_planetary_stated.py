"""A planetary stage with a stated centre distance, stated shifts or helical teeth; tolerances; bounds of a search."""

import math

import numpy as np
import pytest
from pydantic import ValidationError

from tmm_report import loading
from tmm_report.chapters.gears.drive import bounds
from tmm_report.chapters.gears.drive import solve as drive
from tmm_report.chapters.gears.drive.block import DriveModel
from tmm_report.chapters.gears.drive.block import build as build_drive
from tmm_report.chapters.gears.planetary.block import PlanetaryModel, build
from tmm_report.chapters.gears.planetary.quantities.stage import tables
from tmm_report.chapters.gears.planetary.solve.stage import solve
from tmm_report.mechanics.gears.involute import inv
from tmm_report.mechanics.gears.tooth_outlines import external, over_pitch, ring
from tmm_report.problems import ProblemError

STAGE = {
    "kind": "planetary", "ratio": 6.56, "module": "5 mm", "satellites": 3, "input": "sun", "output": "carrier",
    "teeth": [20, 46, 112],
}  # fmt: skip
FREE = {key: value for key, value in STAGE.items() if key != "teeth"}
DOUBLE = {
    "kind": "planetary", "scheme": "external-internal", "ratio": 10, "module": "2 mm", "input": "wheel1",
    "output": "carrier",
}  # fmt: skip


def solved(**block):
    return solve(build(PlanetaryModel.model_validate({**STAGE, **block}), ("1", "2", "3", "H")))


def overlaps(found):
    """Of the drawn teeth in both meshes, m², and the clearances, m."""
    task, sizes, a = found.given.task, found.sizes, float(found.sizes.centre_distance)
    tips = {i: float(sizes.trimmed[i]) / 2 for i in (0, 1, 3)}
    made = [
        external(
            found.teeth[i], task.modules[0], float(sizes.shifts[i]), task.rack, tip=tips[i], tolerance=1e-6
        )
        for i in (0, 1)
    ]
    outer = ring(
        found.teeth[3], task.modules[1], float(sizes.shifts[3]), task.rack, tip=tips[3], tolerance=1e-6
    )
    return [over_pitch(made[0], made[1], a, 3), over_pitch(made[1], outer, a, 3)]


@pytest.mark.parametrize(
    "stated",
    [
        {"centre_distance": "166 mm"},
        {"centre_distance": "164 mm"},
        {"shift": -0.1},
        {"shift": [0.15, 0.1, 0.35]},
        {"helix": "15 deg"},
        {"helix": "20 deg", "shift": [0.2, 0.1, 0.4]},
    ],
)
def test_teeth_cut_as_stated_run_without_overlap(stated):
    """The polygons of the drawn teeth share nothing and all but touch: the distance and the shifts belong together."""
    for shared, free in overlaps(solved(**stated)):
        assert shared.max() < 1e-12 and free.min() < 5e-6


def test_the_shifts_follow_from_a_stated_distance():
    found = solved(centre_distance="166 mm")
    alpha, alpha_w = math.pi / 9, math.acos(165 / 166 * math.cos(math.pi / 9))
    total = 66 * (inv(alpha_w) - inv(alpha)) / (2 * math.tan(alpha))
    assert found.sizes.shift_sums == pytest.approx([total, total])
    x1, x2, _, x3 = found.sizes.shifts
    assert (x1 + x2, x3 - x2) == pytest.approx((total, total))


def test_stated_shifts_are_taken_to_the_last_digit():
    found = solved(shift=[0.15, 0.1, 0.3502])
    assert list(found.sizes.shifts[[0, 1, 3]]) == [0.15, 0.1, 0.3502]
    (doubt,) = found.doubts
    assert doubt.doubt and "0.000728 mm" in str(doubt.wrong)  # 2 · 0.0002 · 5 mm · tan 20°
    assert not solved(shift=[0.15, 0.1, 0.35]).doubts


def test_shifts_that_do_not_belong_together_are_refused_with_those_that_do():
    with pytest.raises(ProblemError) as caught:
        solved(shift=[0.15, 0.1, 0.5])
    (problem,) = caught.value.problems
    assert problem.path == ("shift",) and "wheel 3 is 0.3500" in str(problem.right)


def test_helical_teeth_are_counted_in_the_transverse_section():
    found, straight = solved(helix="15 deg"), solved()
    turn = math.cos(math.radians(15))
    assert found.sizes.centre_distance == pytest.approx(float(straight.sizes.centre_distance) / turn)
    assert found.given.task.rack.alpha == pytest.approx(math.atan(math.tan(math.pi / 9) / turn))
    height = found.sizes.tip[0] - found.sizes.pitch[0]
    assert height == pytest.approx(0.01)  # 2 ha* m of the normal section
    assert found.least_teeth < straight.least_teeth and found.ratio == straight.ratio


@pytest.mark.parametrize(
    ("block", "wrong"),
    [
        ({"shift": [0.1, 0.2]}, "3 profile shift coefficients, not 2"),
        ({"teeth": None, "shift": [0.1, 0.2, 0.3]}, "their teeth are not"),
        ({"teeth": None, "scheme": "any", "input": "wheel1", "centre_distance": "166 mm"}, "of which scheme"),
        ({"ratio_weight": 2}, "out of range"),
        ({"helix": "60 deg"}, "out of range"),
    ],
)
def test_what_cannot_be_meant_is_refused(block, wrong):
    with pytest.raises(ValidationError, match=wrong):
        PlanetaryModel.model_validate({**STAGE, **block})


def test_a_distance_out_of_reach_names_the_condition():
    with pytest.raises(ProblemError) as caught:
        solved(centre_distance="180 mm")
    assert caught.value.problems[0].path == ("teeth",)


# --- tolerances of stage and drive


def given_drive(**drive_):
    return build_drive(DriveModel.model_validate({"speed": "3000 rpm", **drive_}))


def test_a_wider_stage_is_refused_where_the_drive_is_stated(tmp_path):
    text = """
drive:
  speed: 3000 rpm
  tolerance: 4 %
  stages: [{kind: planetary, ratio: 6.56, module: 5 mm, satellites: 3, input: sun, output: carrier, tolerance: 10 %}]
"""
    with pytest.raises(ProblemError) as caught:
        loading.loads(text)
    (problem,) = caught.value.problems
    assert problem.path == ("drive", "stages", 0, "tolerance") and problem.line == 5
    assert "10 %" in str(problem.wrong) and "up to 4 %" in str(problem.right)


def test_left_out_the_tolerance_of_the_drive_is_that_of_its_widest_stage_and_the_stages_that_of_the_drive():
    assert given_drive(stages=[{**FREE, "tolerance": "10 %"}]).tolerance == 0.1
    assert given_drive(stages=[FREE], tolerance="2 %").stages[0].task.tolerance == 0.02
    assert given_drive(stages=[FREE]).stages[0].task.tolerance == 0.04
    assert drive.solve(given_drive(stages=[{**FREE, "tolerance": "10 %"}])).within


# --- how far a search goes


def test_ranges_too_wide_are_refused_before_anything_is_tried():
    widest = {**DOUBLE, "scheme": "any", "external_teeth": [6, 120], "ring_teeth": [10, 250]}
    with pytest.raises(ProblemError) as caught:
        bounds.check_search(given_drive(stages=[widest, widest]).stages)
    (problem,) = caught.value.problems
    assert problem.path == ("drive", "stages", 0) and "12513380" in str(problem.wrong)
    bounds.check_search(given_drive(stages=[widest]).stages)


def test_a_list_too_long_is_refused_before_it_is_made(monkeypatch):
    found = solve(build(PlanetaryModel.model_validate(FREE), ("1", "2", "3", "H")))
    bounds.check_listing(found, 0)
    monkeypatch.setattr(bounds, "LISTED", found.candidates.examined - 1)
    with pytest.raises(ProblemError, match="lines, and at most"):
        bounds.check_listing(found, 0)


def test_the_room_to_put_satellites_in_radially_is_a_condition():
    """Beside a ring of 112 a satellite of 46 passes; the spur pair of the same wheels has the same room."""
    row = next(c for c in solved().conditions if c.key == "radial")
    assert np.isfinite(row.value) and row.wheels == (3,)


def test_stated_shifts_of_helical_teeth_stand_in_the_note_beside_those_of_the_transverse_section():
    found = solved(helix="20 deg", shift=[0.2, 0.1, 0.4])
    columns = {column.key: column for table in tables(found, "stage1") for column in table.columns}
    assert list(columns["x_n"].values) == pytest.approx([0.2, 0.1, 0.4])
    assert list(columns["x"].values) == pytest.approx(np.cos(np.radians(20)) * np.array([0.2, 0.1, 0.4]))
    assert (columns["x_n"].symbol().sub, columns["x"].symbol().sub) == ("n", "t")
