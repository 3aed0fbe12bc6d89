"""Links that move with what travels: their masses and moments of inertia are in the reduced mass, and asked about."""

from pathlib import Path

import pytest

from tmm_report import course, loading

BOOM = (Path(__file__).parents[3] / "cases" / "explain" / "boom_by_cylinder.yaml").read_text("utf-8")
TRAVEL = (
    BOOM[: BOOM.index("loads:")]
    + "travel: {from: 500 mm, to: 640 mm, mass: 5 kg, driving: [{constant: 2 kN}]}\n"
)
OWN = ", inertia: 0.07 kg*m^2"


def doubts(text):
    return {one.key: one.text() for one in loading.loads("language: en\n" + text).doubts}


def test_masses_without_loads_have_their_effect_in_the_travel():
    assert doubts(TRAVEL) == {}
    without = TRAVEL[: TRAVEL.index("travel:")]
    assert any("no force analysis is made" in said for said in doubts(without).values())


@pytest.mark.parametrize(("inertia", "asked"), [("", True), (", inertia: 0", False), (OWN, False)])
def test_a_link_that_turns_without_inertia_is_asked_about(inertia, asked):
    assert TRAVEL.count(OWN) == 1
    said = doubts(TRAVEL.replace(OWN, inertia))
    assert list(said) == (["mechanism.links.4.mass"] if asked else [])
    assert not asked or "no moment of inertia: none is reckoned with" in said["mechanism.links.4.mass"]


def test_the_inertia_is_in_the_motion():
    """Less of it goes faster: what is asked about matters."""
    ends = [
        course.solve(loading.loads(text)).travel.s.number("v_end")
        for text in (TRAVEL, TRAVEL.replace(OWN, ", inertia: 7 kg*m^2"))
    ]
    assert ends[0] > ends[1] * 1.001
