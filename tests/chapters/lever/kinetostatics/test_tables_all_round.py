"""Tables over a turn, a cycle or a stroke say what is there all the way, or are asked for it."""

from __future__ import annotations

import pytest
from edge_variants import PUMP, ROCKER
from notes import VARIANTS

from tmm_report import loading
from tmm_report.problems import ProblemError
from tmm_report.variant.gaps import not_all_round, not_to_the_end

CAM = (VARIANTS / "cam_press.yaml").read_text("utf-8")


def said(text: str) -> list[str]:
    try:
        loading.loads(text)
    except ProblemError as error:
        return [one.text() for one in error.problems]
    return []


def load(law: str) -> str:
    return PUMP + f"loads:\n  forces:\n    - {{at: B, direction: left, {law}}}\n"


HALF = "[0, 300], [60 deg, 900], [120 deg, 300]"


@pytest.mark.parametrize(("end", "asked"), [("", True), (", [120 deg, 0]", True), (", [360 deg, 300]", False),
                                            (", [120 deg, 0], [360 deg, 0]", False)])  # fmt: skip
def test_a_force_by_the_angle_that_leaves_out_most_of_the_turn(end, asked):
    told = said(load(f"by_angle: [{HALF}{end}]"))
    assert any("from 120 to 360 deg" in text for text in told) == asked, told


@pytest.mark.parametrize("curve", ["[0.5, 2], [1, 2]", "[0, 2], [0.4, 2]", "[0, 2], [0.2, 3], [0.5, 1]"])
def test_an_indicator_diagram_says_what_acts_over_the_whole_stroke(curve):
    law = "by_displacement: {{zero: right, forward: [{}], back: [[0, 1], [1, 1]]}}"
    assert any("nothing is stated from" in text for text in said(load(law.format(curve))))
    assert not any("nothing is stated" in text for text in said(load(law.format("[0.5, 0], [1, 2]"))))
    assert not any("nothing is stated" in text for text in said(load(law.format("[0, 2]"))))


def test_a_law_of_a_link_that_swings_is_asked_for_its_whole_way():
    swings = ROCKER.replace("rad/s,", "rad/s, range: 60 deg,")
    forces = "loads:\n  forces:\n    - {at: B, direction: left, by_angle: [[0, 5], [10 deg, 5]%s]}\n"
    assert any("from 10 to 60" in text for text in said(swings + forces % ""))
    assert not said(swings + forces % ", [60 deg, 5]")


def test_a_table_of_a_cam_goes_all_round():
    law = CAM[CAM.index("      swing: 18 deg") : CAM.index("  assembly:")]
    table = "      side: right\n      swings: [%s]\n"
    half = ", ".join(f"[{15 * k} deg, {round(9 - 9 * abs(k - 6) / 6, 3)} deg]" for k in range(13))
    told = said(CAM.replace(law, table % half))
    assert any("from 180 to 360 deg" in text and "all round" in text for text in told), told
    whole = half + ", " + ", ".join(f"[{15 * k} deg, 0 deg]" for k in range(13, 24))
    assert not any("nothing is stated" in text for text in said(CAM.replace(law, table % whole)))


@pytest.mark.parametrize("shift", [0.0, 1.0, 5.0])
def test_what_is_asked_does_not_depend_on_where_the_table_begins(shift):
    gap = [(x + shift, 1.0 + x) for x in (0.0, 1.0, 2.0)]
    even = [(x + shift, float(x)) for x in (0.0, 2.0, 4.0)]
    assert list(not_all_round(gap, (), 6.0)) and not list(not_all_round(even, (), 6.0))


def test_a_line_over_half_of_the_cycle_is_not_drawn_unasked():
    assert list(not_all_round([(0.0, 90.0), (3.0, 900.0)], (), 6.0))
    assert list(not_all_round([(0.0, 300.0), (3.0, 300.0), (3.0, 90.0)], (), 6.0))
    assert not list(not_all_round([(0.0, 90.0), (3.0, 900.0), (6.0, 90.0)], (), 6.0))


def test_a_table_of_one_value_has_it_all_round():
    """There is but one straight line through its points."""
    same = [(x, 7.0) for x in (0.0, 1.0, 2.0)]
    assert not list(not_all_round(same, (), 6.0))
    assert not any("nothing is stated" in text for text in said(load("by_angle: [[0, 300], [60 deg, 300]]")))


@pytest.mark.parametrize(("reach", "asked"), [("100 deg", False), ("300 deg", True), ("360 deg", True)])
def test_a_law_is_asked_for_over_the_range_alone(reach, asked):
    swings = ROCKER.replace("rad/s,", f"rad/s, range: {reach},").replace("0.1}}", "0.05}}")
    told = said(swings + load("by_angle: [[0, -9], [95 deg, -9], [96 deg, 9]]").replace(PUMP, ""))
    assert any("nothing is stated from 96 to " in text for text in told) == asked, told


def test_of_a_single_value_nothing_is_asked():
    assert not list(not_all_round([(0.0, 5.0)], (), 6.0)) and not list(not_to_the_end([(0.3, 5.0)], (), 1.0))
