"""Quality over the shifts and over the centre distance: each row is a pair of its own, bounds, conventions, slips."""

import json
import math
import re
from dataclasses import replace

import numpy as np
import pytest
from notes import render
from test_spur_stage import CASES, FREE, GUIDE

from tmm_report import course, loading
from tmm_report.chapters.gears.spur.given import Quality
from tmm_report.chapters.gears.spur.solve import pair as spur
from tmm_report.problems import ProblemError

PAIR = "kind: spur, module: 4 mm, teeth: [12, 25], centre_distance: 76 mm, shift: [0.5, rest]"
TEXT = "language: en\ndrive:\n  speed: 1000 rpm\n  stages:\n    - {{{}}}\n"


def results(stage):
    return json.loads(render(course.solve(loading.loads(TEXT.format(stage))), "json")["results.json"])


def columns(document, name):
    return {one["key"]: one["values"] for one in document["tables"][f"stage1_{name}"]["columns"]}


def numbers(document):
    return {one["key"].removeprefix("stage1_"): one["value"] for one in document["values"]}


@pytest.mark.parametrize("name", ["centre distance", "internal", "helical", "internal, helical"])
def test_each_row_is_a_pair_of_its_own(name):
    """Stated alone, at the same centre distance, a pair has the numbers of its row."""
    given = CASES.get(name, GUIDE)
    found = spur.solve(replace(given, quality=Quality()))
    course_ = found.quality.stated
    rows = np.array([course_.pair.x1, course_.pair.x2]).T
    assert len(rows) >= 5
    for k, (x1, x2) in enumerate(rows):
        alone = spur.solve(
            replace(
                given,
                teeth=found.teeth.z,
                centre_distance=float(found.pair.a_w),
                shift=(float(x1), float(x2)),
            )
        ).pair
        assert float(alone.eps) == pytest.approx(course_.pair.eps[k], rel=1e-12)
        for i in (0, 1):
            assert float(alone.root_sliding[i]) == pytest.approx(course_.root_sliding[i][k], rel=1e-9)
            assert float(alone.tip_sliding[i]) == pytest.approx(course_.tip_sliding[i][k], rel=1e-9)
            assert float(alone.s_na[i]) / alone.m == pytest.approx(course_.tips[i][k], rel=1e-9)


def test_over_the_centre_distance_the_shifts_are_chosen_as_the_pairs_are():
    ways = {"rule": "rule", "limit": "limit", "equal sliding": "equal sliding", "kept": (0.3, math.nan)}
    for way in ways.values():
        given = replace(
            GUIDE, teeth=(14, 28), shift=way, quality=Quality(centre_distances=(0.129, 0.13, 0.131))
        )
        over = spur.solve(given).quality.stated_over.pair
        for k, a in enumerate((0.129, 0.13, 0.131)):
            alone = spur.solve(replace(given, centre_distance=a, quality=None)).pair
            assert (over.x1[k], over.x2[k]) == pytest.approx((float(alone.x1), float(alone.x2)), abs=1e-12)
            assert over.eps[k] == pytest.approx(float(alone.eps), rel=1e-12)


def test_of_two_stated_shifts_the_first_is_kept_over_the_centre_distance():
    over = columns(
        results(f"{PAIR.replace('rest', '0.0468001')}, quality: {{centre_distances: [75 mm, 77 mm]}}"),
        "distances",
    )
    assert over["x_1"] == [0.5, 0.5] and over["x_2"][0] < 0.0468 < over["x_2"][1]


def test_round_shifts_within_the_bounds_are_taken_where_none_are_stated():
    document = results(f"{PAIR}, quality: {{}}")
    one = numbers(document)
    shifts = columns(document, "quality")["x_1"]
    assert one["x_least_1"] <= shifts[0] and shifts[-1] <= one["x_most_1"] and len(shifts) >= 5
    assert all(x == round(x, 2) for x in shifts)
    assert (
        shifts[0] - one["x_least_1"] < shifts[1] - shifts[0]
        and one["x_most_1"] - shifts[-1] < shifts[1] - shifts[0]
    )


def test_clearance_is_the_least_of_both_wheels_within_the_bounds():
    for stage in (PAIR, PAIR.replace("[12, 25]", "[25, 12]").replace("0.5", "0.1")):
        document = results(f"{stage}, quality: {{}}")
        one = numbers(document)
        ends = [round(one["x_least_1"], 9) + 1e-9, round(one["x_most_1"], 9) - 1e-9]
        table = columns(results(f"{stage}, quality: {{x1: {ends}}}"), "quality")
        assert one["play"] == pytest.approx(min(*table["play_1"], *table["play_2"]), rel=1e-6)


def test_limits_that_set_no_end_are_not_told():
    """Only where a limit is met exactly: below −1.3 there are no such wheels, which is no bound of pointing."""
    bounds = columns(results(f"{PAIR}, quality: {{}}"), "bounds")
    told = set(zip(bounds["limit"], bounds["wheel"], bounds["side"], strict=True))
    assert ("pointing", "1", "to") in told and ("pointing", "1", "from") not in told
    assert {("undercut", "1", "from"), ("undercut", "2", "to"), ("contact", "", "to")} <= told


def test_conventions_of_specific_sliding():
    """By velocities: of the wheel itself, of its mate, by size."""
    own, mate, size = (
        columns(results(f"{PAIR}, quality: {{sliding: {how}, x1: [0.4, 0.5]}}"), "quality")
        for how in ("own", "mate", "size")
    )
    for key in ("lambda_p_1", "lambda_p_2", "lambda_a_1", "lambda_a_2"):
        for a, b, c in zip(own[key], mate[key], size[key], strict=True):
            rolling = 1 - a  # of the mate's velocity to the wheel's own
            assert b == pytest.approx(1 / rolling - 1, rel=1e-12) and c == abs(a)
    assert own["eps"] == mate["eps"] == size["eps"]


def note(stage, language="en"):
    page = render(course.solve(loading.loads(TEXT.format(stage))), "html", language)["note.html"].decode()
    return re.sub(r"<[^>]+>", "", page).replace("\N{NO-BREAK SPACE}", " ")


def test_the_note_says_how_sliding_is_counted_and_what_is_not_there():
    assert "1 − v′/v with v′ of its mate" in note(f"{PAIR}, quality: {{}}")
    assert "v/v′ − 1" in note(f"{PAIR}, quality: {{sliding: mate}}")
    assert "|1 − v′/v|" in note(f"{PAIR}, quality: {{sliding: size}}", "ru")
    none = "kind: spur, module: 4 mm, teeth: [8, 9], shift: [0.3, 0.3], quality: {x1: [0.2, 0.3], least_tip: 0.4}"
    assert "No shift is allowed by all of them." in note(none)
    assert "Quality of the mesh over the shifts" not in note(PAIR)


# ---------------------------------------------------------------- slips

SLIPS = {
    "x1: [0.3, 0.5, 0.4]": ("x1.2", "from the least to the greatest"),
    "x1: [0.3]": ("x1", "too few values"),
    "x1: [0.3, 7]": ("x1.1", "out of range"),
    "x1: 0.3": ("x1", "[0.3, 0.4, 0.5, 0.6, 0.7]"),
    "x1: [0.3, 2.9]": ("x1.1", "from -"),
    "centre_distances: [75 mm, 99 mm]": ("centre_distances.1", "from 69.856 to 84.286 mm"),
    "centre_distances: [77 mm, 75 mm]": ("centre_distances.1", "from the least to the greatest"),
    "centre_distances: [75, 76]": ("centre_distances.0", "mm?"),
    "sliding: theirs": ("sliding", "own"),
    "least_tip: 2": ("least_tip", "0 … 1"),
    "least_contact: 0.5": ("least_contact", "1 … 3"),
    "tips: 0.3": ("tips", "least_tip"),
}


@pytest.mark.parametrize("slip", SLIPS)
def test_slips_are_told_at_their_place(slip):
    place, text = SLIPS[slip]
    with pytest.raises(ProblemError) as told:
        course.solve(loading.loads(TEXT.format(f"{PAIR}, quality: {{{slip}}}")))
    assert f"quality.{place}:" in str(told.value) and text in str(told.value)


def test_a_wrong_number_of_a_list_does_not_make_it_short():
    with pytest.raises(ProblemError) as told:
        loading.loads(TEXT.format(f"{PAIR}, quality: {{x1: [0.3, 7]}}"))
    assert [problem.key for problem in told.value.problems] == ["drive.stages.0.quality.x1.1"]


def test_all_that_is_asked_of_a_pair_is_judged_at_once():
    asked = "inspection: {span: [40, 2]}, backlash: {tolerance: 0.05 mm}, quality: {x1: [0.3, 2.9]}"
    with pytest.raises(ProblemError) as told:
        course.solve(loading.loads(TEXT.format(f"{PAIR}, {asked}")))
    keys = [problem.key.removeprefix("drive.stages.0.") for problem in told.value.problems]
    assert keys == ["inspection.span.0", "backlash.tolerance", "quality.x1.1"]


def test_a_free_pair_has_its_quality_too():
    found = spur.solve(replace(FREE, quality=Quality()))
    assert found.quality.ends is not None and found.quality.stated_over is None
