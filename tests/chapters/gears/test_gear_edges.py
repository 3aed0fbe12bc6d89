"""Pairs at the edge, as variants state them: what is told, and what the exit code is."""

import json
import math
import re
import warnings
from functools import cache

import pytest
from conftest import examples
from hypothesis import given, settings
from hypothesis import strategies as st
from notes import render

from tmm_report import solve
from tmm_report.course import doubts, sound, summary
from tmm_report.loading import loads
from tmm_report.problems import ProblemError

UNDERCUT = "ratio: -1, module: 2 mm, teeth: [10, 10], shift: [0, 0]"
UNDERCUT_WHEEL = "ratio: -3.43, module: 1 mm, teeth: [14, 48], shift: [-0.317, 0.774]"
CLOSED = "ratio: 3, mesh: internal, module: 3 mm, teeth: [25, 75], shift: [0.5, 2.5]"
INTERNAL = "ratio: 3, mesh: internal, module: 3 mm, teeth: [25, 75], shift: [0.4, 0.5]"
NARROW = "ratio: 1.4, mesh: internal, module: 3 mm, teeth: [25, 35], shift: [0, 0], rack: {ha*: 0.8}"
ROUNDED = "ratio: -2, module: 6 mm, centre_distance: 130 mm, teeth: [14, 28], shift: [0.18, 0.559]"


def variant(stage, **more):
    more = "".join(f", {key}: {value}" for key, value in more.items())
    return f"language: en\ndrive:\n  speed: 1000 rpm\n  stages:\n    - {{kind: spur, {stage}{more}}}\n"


@cache
def solved(stage):
    return solve(loads(variant(stage)))


def pair_of(stage):
    return solved(stage).drive.stages[0]


@cache
def note(stage):
    markup = render(solved(stage), "html")["note.html"].decode()
    return re.sub(r"\s+", " ", re.sub(r"<[^>]+>", " ", markup.partition("</head>")[2]))


def told(stage):
    return [str(line) for line in summary(solved(stage))]


@pytest.mark.exhaustive
@pytest.mark.parametrize("stage, true, formula", [(UNDERCUT, 0.816, 1.369), (UNDERCUT_WHEEL, 1.121, 1.539)])
def test_the_true_contact_ratio_is_the_result_and_the_formulas_stands_beside_it(stage, true, formula):
    found = pair_of(stage)
    values = json.loads(render(solved(stage), "json")["results.json"])["values"]
    numbers = {one["key"]: one["value"] for one in values}
    assert numbers["stage1_eps"] == pytest.approx(true, abs=5e-4)
    assert numbers["stage1_eps_tips"] == pytest.approx(formula, abs=5e-4)
    assert numbers["stage1_eps_counted"] == pytest.approx(true, abs=2e-3)
    (contact,) = [c for c in found.conditions if c.key == "contact"]
    assert contact.value == numbers["stage1_eps"] and contact.met == (true > 1.05)
    assert "By the tip circles alone" in note(stage) and "contact begins where the involute does" in note(
        stage
    )


@pytest.mark.parametrize("stage", [UNDERCUT, UNDERCUT_WHEEL])
def test_interference_has_one_amount_in_the_table_and_in_the_contour(stage):
    found = pair_of(stage)
    table = {c.wheel: -c.margin for c in found.failed if c.key == "interference"}
    contour = {
        str(one.limit.wheel): one.lack * found.pair.m
        for one in found.contour.lacks
        if one.limit.kind == "interference"
    }
    assert table and table == pytest.approx(contour)


@pytest.mark.parametrize(
    "stage, good", [(UNDERCUT, False), (UNDERCUT_WHEEL, False), (INTERNAL, True), (NARROW, True)]
)
def test_a_condition_that_is_not_met_is_a_check_that_failed(stage, good):
    assert sound(solved(stage)) == good
    assert any(line.endswith("not met") for line in told(stage)) != good


def test_what_cannot_be_cut_is_refused_and_outside_the_contour():
    with pytest.raises(ProblemError) as caught:
        solve(loads(variant(CLOSED)))
    assert "the spaces of ring 2 come to a point" in caught.value.problems[0].text()
    blocking = pair_of(INTERNAL).contour.blocking
    kinds = {(one.limit.kind, one.limit.wheel) for one in blocking.lacks(0.5 + 2.5j)}
    assert kinds == {("space", 2)}


@pytest.mark.exhaustive
def test_radial_assembly_is_shown_and_no_condition_that_fails():
    (room,) = [c for c in pair_of(INTERNAL).conditions if c.key == "radial"]
    assert room.met and room.value == pytest.approx(math.radians(0.5122), abs=1e-5)
    narrow = pair_of(NARROW)
    assert narrow.axially and "radial" not in {c.key for c in narrow.failed}
    assert any("put into the ring axially" in line for line in told(NARROW))
    assert "only axially" in note(NARROW) and "which needs no other numbers" in note(NARROW)


@pytest.mark.exhaustive
def test_a_stated_cutter_gives_the_ring_its_root():
    """By GOST 19274: d_f2 = 2 a_w0 + d_a0, with the operating angle of ring and cutter."""
    plain, cut = pair_of(INTERNAL), pair_of(INTERNAL + ", cutter: {z0: 20, x0: 0.1}")
    inv = math.tan(math.radians(20)) - math.radians(20)
    wanted = inv + 2 * (0.5 - 0.1) * math.tan(math.radians(20)) / 55
    low, high = 0.1, 0.9
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if math.tan(middle) - middle < wanted else (low, middle)
    distance = 3e-3 * 55 / 2 * math.cos(math.radians(20)) / math.cos(low)
    tip = 3e-3 * (20 + 2 * (1.25 + 0.1))
    assert float(cut.pair.d_f[1]) == pytest.approx(2 * distance + tip, rel=1e-12)
    assert float(plain.pair.d_f[1]) == pytest.approx(3e-3 * (75 + 2 * 1.75), rel=1e-12)
    assert {"trimming", "cutter fouling", "feed"} <= {c.key for c in cut.conditions}
    assert "is cut by a pinion cutter" in note(INTERNAL + ", cutter: {z0: 20, x0: 0.1}")


def test_the_tips_of_a_ring_are_whole_above_the_end_of_the_line_of_action_in_cutting():
    """√(r_a2² − r_b2²) against a_w0 sin α_w0, the distance between the base circles: (z2 − z0) r_b0/z0 tan α_w0."""
    pair = pair_of(INTERNAL + ", cutter: {z0: 20, x0: 0.1}").pair
    base = 1.5e-3 * 55 * math.cos(math.pi / 9)
    tips = math.sqrt(float(pair.d_a[1]) ** 2 - float(pair.d_b[1]) ** 2) / 2
    assert pair.cut_ring(1).trimming == pytest.approx(tips - base * math.tan(pair.cuts[1].alpha), rel=1e-9)


@pytest.mark.exhaustive
def test_where_none_is_stated_a_usual_cutter_is_named():
    (cut,) = pair_of(INTERNAL).cutters
    assert (cut.by.tool.z, cut.by.tool.x) == (33, 0.0)  # 100 mm by 3 mm
    assert "what a usual pinion cutter would leave" in note(INTERNAL)


@pytest.mark.parametrize(
    "cutter, range", [("{z0: 6, x0: -5}", "from -1.43 to -0.05"), ("{z0: 12, x0: 1.2}", "from -1.61 to 0.31")]
)
def test_a_cutter_with_no_sound_teeth_is_refused_with_the_shifts_that_it_may_have(cutter, range):
    """Tips inside the base circle, z/2 + ha* + c* + x < z cos α/2; and teeth that come to a point before the tips."""
    for stage in (INTERNAL, UNDERCUT):
        with pytest.raises(ProblemError) as caught:
            solve(loads(variant(stage, cutter=cutter)))
        (problem,) = caught.value.problems
        assert problem.path == ("drive", "stages", 0, "cutter", "x0") and range in problem.text()


def test_a_wheel_that_a_rack_could_not_cut_is_refused_though_a_cutter_is_stated():
    """Its fillets are drawn by a rack; where one leaves no involute there is no drawing, and no traceback either."""
    stage = "ratio: -2.25532, module: 2 mm, teeth: [47, 106], centre_distance: 161.207 mm, rack: {ha*: 0.8}"
    for cutter in ("", ", cutter: {z0: 8, x0: 0.1}"):
        with pytest.raises(ProblemError, match="no involute is left on the teeth of wheel 2"):
            solve(loads(variant(stage + cutter)))


@pytest.mark.exhaustive
def test_the_cut_down_tips_of_a_ring_are_worked_out_from_the_fillets_of_the_pinion():
    """ρ_l1 = d1/2 sin α − (ha* − x1) m/sin α is written out, and every symbol of the cutting is explained."""
    told = note(INTERNAL + ", cutter: {z0: 20, x0: 0.1}")
    assert "The fillets begin where the rack leaves the involute of the pinion" in told
    assert "base diameter of the pinion cutter" in told and "of the ring: The calculation" not in told


def test_a_cutter_that_does_not_fit_is_refused_by_its_key():
    with pytest.raises(ProblemError) as caught:
        solve(loads(variant(INTERNAL, cutter="{z0: 80}")))
    (problem,) = caught.value.problems
    assert problem.path == ("drive", "stages", 0, "cutter", "z0") and "fewer than 75 teeth" in problem.text()


@pytest.mark.exhaustive
def test_the_tips_of_a_ring_are_cut_down_unless_that_is_forbidden():
    full = pair_of(INTERNAL + ", tip_shortening: false")
    cut = pair_of(INTERNAL)
    assert float(full.pair.d_a[1]) == pytest.approx(3e-3 * (75 - 2 * 0.5), rel=1e-12)
    assert cut.pair.d_a[1] > full.pair.d_a[1] and "they are cut down to the circle" in note(INTERNAL)
    (touching,) = full.failed
    assert (touching.key, touching.wheel) == ("interference", "1")
    assert cut.failed == ()


@pytest.mark.exhaustive
def test_stated_shifts_are_not_changed_without_a_word():
    found = pair_of(ROUNDED)
    (doubt,) = doubts(solved(ROUNDED))
    assert doubt.path == ("drive", "stages", 0, "shift")
    assert "0.18, 0.559" in doubt.text() and f"{float(found.pair.x2):.6g}" in doubt.text()
    assert "Taken are" in note(ROUNDED)
    assert doubts(solved(INTERNAL)) == [] and "Taken are" not in note(INTERNAL)


@settings(max_examples=examples(40))
@given(st.integers(6, 150), st.integers(6, 150), st.floats(-1.5, 2.5), st.floats(-1.5, 2.5), st.booleans(),
       st.floats(0, 30), st.sampled_from(["", ", cutter: {z0: 20, x0: 0.1}", ", cutter: {z0: 9, x0: -1}"]))  # fmt: skip
@pytest.mark.exhaustive
def test_any_pair_is_solved_or_refused_without_a_warning_of_numpy(z1, z2, x1, x2, internal, helix, cutter):
    stage = (
        f"ratio: {z2 / z1 if internal else -z2 / z1:.6f}, module: 2 mm, teeth: [{z1}, {z2}], "
        f"shift: [{x1:.4f}, {x2:.4f}], helix: {helix:.3f} deg{cutter}"
    )
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        try:
            found = solve(loads(variant(stage))).drive.stages[0]
        except ProblemError as refused:
            assert all(problem.right for problem in refused.problems)
            return
        assert found.pair.eps <= found.pair.eps_tips * (1 + 1e-12)
        assert found.contour.feasible == (found.failed == ())
