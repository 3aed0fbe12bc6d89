"""Two things of one name: what cannot move is told, and no point has the name of a link."""

from __future__ import annotations

from pathlib import Path

import pytest
from notes import render

from tmm_report import course, loading
from tmm_report.problems import ProblemError

CASE = Path(__file__).parents[1] / "cases" / "mechanics" / "two_labels.yaml"
TWO_OUTPUTS = """
language: en
mechanism:
  frame: {O: [0, 0], C: [300 mm, 0]}
  guides: {x: {through: C}}
  links:
    1: {points: {O: 0, A: 100 mm}}
    2: {points: {A: 0, B: 300 mm}}
    3: {points: {B: 0, C: 250 mm, D: 350 mm}}
    4: {points: {D: 0, E: 400 mm}}
    5: {points: [E], slides: x}
  driver: {link: 1, speed: 90 rpm}
  assembly: {B: left of A-C, E: right}
"""


def refused(text):
    with pytest.raises(ProblemError) as error:
        course.solve(loading.loads(text))
    return [problem.text() for problem in error.value.problems]


def test_links_that_the_frame_alone_holds_are_told():
    (told,) = refused(CASE.read_text("utf-8"))
    assert "links 2, 3 stand still" in told and "link: 1" in told


def test_a_still_group_is_told_before_what_hangs_on_it():
    text = TWO_OUTPUTS.replace("C: [300 mm, 0]", "C: [300 mm, 0], P: [0, 200 mm], Q: [150 mm, 200 mm]")
    text = text.replace(
        "  driver:", "    6: {points: {P: 0, R: 100 mm}}\n    7: {points: {Q: 0, R: 90 mm}}\n  driver:"
    )
    (told,) = refused(text.replace("E: right", "E: right, R: up"))
    assert "links 6, 7 stand still" in told


@pytest.mark.parametrize("link", ("1", "2", "3", "5"))
@pytest.mark.parametrize("point", ("A", "B", "D", "E", "C"))
def test_a_point_may_not_be_called_as_a_link_is(point, link):
    """Else S, V and a of an output slider 3 are those of the rocker 3, too."""
    text = TWO_OUTPUTS
    for old, new in (
        (f"{point}:", f"{link}:"),
        (f"[{point}]", f"[{link}]"),
        (f"through: {point}", f"through: {link}"),
    ):
        text = text.replace(old, new)
    (told,) = refused(text.replace("left of A-C", f"left of {'A-C'.replace(point, link)}"))
    assert f"a link is also called {link}" in told


@pytest.mark.exhaustive
def test_a_name_that_nothing_else_has_may_be_a_number():
    text = TWO_OUTPUTS.replace("E:", "7:").replace("[E]", "[7]")
    assert b"</html>" in render(course.solve(loading.loads(text)), "html")["note.html"]
