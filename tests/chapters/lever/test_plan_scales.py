"""Scales of the plans: round ones that fill a portrait page, or such that a chosen segment has its chosen length."""

from __future__ import annotations

import json

import numpy as np
import pytest
from conftest import read
from notes import VARIANTS, render

from tmm_report import course, loading, yamlread
from tmm_report.chapters.lever.plans.draw import plan_picture
from tmm_report.problems import ProblemError
from tmm_report.quantity.paper import LONGEST, ROUND, fitting_scale, segment_scale

PAGE = (165.0, 218.0)  # mm: the text of a portrait page without a caption
UNSTATED = [
    "loom",
    "parallelogram_drive",
    "whitworth",
    "v_engine",
    "knuckle_press",
    "engine_four_stroke",
    "slotter",
]


def drawn(drawing: dict, name: str = "crank_rocker") -> course.Results:
    return solved(name, drawing=drawing)


def solved(name: str, **blocks: dict) -> course.Results:
    """The variant without readings and with these blocks."""
    data = yamlread.loads((VARIANTS / f"{name}.yaml").read_text("utf-8"), "v.yaml", []).data
    data.pop("readings", None)
    return course.solve(loading.loads(json.dumps(data | blocks), "v.yaml"))


def mistakes(drawing: dict) -> list[tuple[str, str]]:
    with pytest.raises(ProblemError) as error:
        drawn(drawing)
    return [(".".join(map(str, problem.path)), problem.text()) for problem in error.value.problems]


def is_round(scale: float) -> bool:
    return any(np.isclose(scale / 10 ** np.floor(np.log10(scale)), one) for one in ROUND)


@pytest.mark.parametrize("name", UNSTATED)
def test_plans_fill_a_portrait_page_at_round_scales(name):
    plans = drawn({}, name).lever.plans
    scales = (plans.length_scale, plans.velocity_scale, plans.acceleration_scale)
    assert all(map(is_round, scales))
    for kind in ("velocity", "acceleration"):
        pictures = [plan_picture(getattr(one, kind)) for one in plans.drawn]
        assert all(size <= most for one in pictures for size, most in zip(one.size, PAGE, strict=True))
        longest = max(abs(s.end - s.start) for one in plans.drawn for s in getattr(one, kind).strokes)
        assert 60 <= longest <= LONGEST + 0.01


@pytest.mark.parametrize("name", UNSTATED)
def test_the_scheme_has_room_for_its_marks(name):
    found = drawn({}, name).lever
    places = found.kinematics.diagram.places
    wide, tall = (np.nanmax(part) - np.nanmin(part) for part in (places.real, places.imag))
    mu = found.plans.length_scale
    assert wide / mu <= 135 + 1e-9 and tall / mu <= 185 + 1e-9
    assert wide / mu > 135 / 2.01 or tall / mu > 185 / 2.01  # a finer round scale would not


def test_a_box_that_is_higher_than_wide_is_fitted_by_its_height():
    assert fitting_scale(149.0, 1.0) == 1.0 and fitting_scale(150.0, 1.0) == 2.0
    assert fitting_scale(150.0, 199.1 * 4) == 5.0
    assert fitting_scale(0.0, 0.0) == 1.0 and segment_scale(12.566, 100) == 0.12566


def test_chosen_segments_have_the_lengths_chosen():
    """Of the compressor, as the guide draws it: OA 50 mm, pa 100 mm, πa 120 mm."""
    plans = drawn({"OA": "50 mm", "pa": "100 mm", "pia": "120 mm"}, "compressor").lever.plans
    scales = (plans.length_scale, plans.velocity_scale, plans.acceleration_scale)
    assert scales == (0.002, 0.12566, 13.159)
    for one in plans.drawn:
        assert one.velocity.segments["pa"] == pytest.approx(100, abs=0.02)
        assert one.acceleration.segments["πa"] == pytest.approx(120, abs=0.02)


def test_a_segment_of_another_point_is_that_long_where_it_is_longest():
    plans = drawn({"pb": "90 mm", "πb": "75 mm", "AB": "80 mm"}).lever.plans
    lengths = [(one.velocity.segments["pb"], one.acceleration.segments["πb"]) for one in plans.drawn]
    assert [max(both) for both in zip(*lengths, strict=True)] == pytest.approx([90, 75], abs=0.02)


@pytest.mark.exhaustive
def test_the_note_works_the_scales_out():
    note = render(drawn({"OA": "50 mm", "pa": "100 mm"}), "html", "en")["note.html"].decode()
    for key in ("chosen_OA", "chosen_pa", "largest_v_A"):
        assert f'data-q="{key}"' in note
    assert "Scales follow from the lengths of segments" in note
    assert "Scales follow" not in render(drawn({}), "html", "en")["note.html"].decode()


def test_what_is_no_segment_or_contradicts_a_scale_is_refused_all_at_once():
    wrong = {
        "OA": "50 mm",
        "AB": "40 mm",
        "pa": "100 mm",
        "pq": "1 mm",
        "acuracy": "0.1 mm",
        "scales": {"velocity": 1},
    }
    found = dict(mistakes(wrong))
    assert set(found) == {"drawing.AB", "drawing.pa", "drawing.pq", "drawing.acuracy"}
    assert "OA and AB, state one scale" in found["drawing.AB"]
    assert "drawing.scales.velocity" in found["drawing.pa"]
    assert "accuracy" in found["drawing.acuracy"]


@pytest.mark.parametrize(
    ("drawing", "said"),
    [
        ({"OA": "0.5 mm"}, "out of range"), ({"OA": "50"}, "out of range"), ({"OA": "50 kg"}, "kg"),
        ({"po": "50 mm"}, "neither a key of the drawing nor a segment"),
        ({"OB": "50 mm"}, "neither a key of the drawing nor a segment"),
        ({"force": "200 mm", "scales": {"force": 20}}, "stated twice"),
    ],
)  # fmt: skip
def test_a_segment_that_cannot_be_meant_is_named(drawing, said):
    ((_, text),) = mistakes(drawing)
    assert said in text


def test_a_segment_of_no_length_gives_no_scale():
    """At the dead point of the compressor's right piston nothing of v_B can be drawn."""
    with pytest.raises(ProblemError, match="no length"):
        solved("compressor", positions={"table": 12, "plans": [6]}, drawing={"pb": "50 mm"})


def test_force_is_kept_for_the_force_plans():
    assert read("compressor").lever.drawing.force_segment is None
    assert drawn({"force": "200 mm"}).variant.lever.drawing.force_segment == pytest.approx(200)
