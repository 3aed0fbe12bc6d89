"""Transmission angles: by the directions of the links, the known least of a crank-rocker, every ready mechanism."""

import math

import numpy as np
import pytest
from conftest import read, solved, stating

from tmm_report import course, loading, note
from tmm_report.chapters.lever.transmission import solve
from tmm_report.i18n import Translator
from tmm_report.problems import ProblemError


def transmitted(name: str, permitted: float = 0.7):
    return course.solve_lever(stating(read(name), transmission=permitted, readings={}).lever).transmission


def acute(directions, others):
    """Angles between lines, (P,), rad."""
    turned = np.abs(np.angle(directions / others))
    return np.minimum(turned, np.pi - turned)


def by_directions(of, motion):
    """Between the lines of both links as they stand, or between the link and the normal of the guide."""
    joint, outer = motion.place(of.inner.name), motion.place(of.outer_a.name)
    if of.kind == 1:
        return acute(joint - outer, joint - motion.place(of.outer_b.name))
    guide = motion.turn(of.b) * of.outer_b.along[of.b]  # as the slider has it, not its carrier
    return acute(joint - outer, 1j * guide)


@pytest.mark.parametrize("name", ["compressor", "crank_rocker", "shaper", "jaw_crusher", "slotter"])
def test_angles_are_those_between_the_links_and_the_least_is_the_least_of_a_thousand(name):
    found = transmitted(name)
    assert found.couplers
    for of in found.couplers:
        for motion in (found.kinematics.table, found.kinematics.diagram):
            assert solve.angle(of, motion) == pytest.approx(by_directions(of, motion), abs=1e-9, nan_ok=True)
        turned = np.linspace(0, found.kinematics.cycle.sweep, 4001)
        dense = by_directions(of, found.kinematics.cycle.motion(turned))
        least = solve.least(of, found.kinematics)
        assert (
            least.value == pytest.approx(np.nanmin(dense), abs=2e-6)
            and least.value <= np.nanmin(dense) + 1e-9
        )
        (there,) = by_directions(of, found.kinematics.cycle.motion(np.array([least.turned])))
        assert there == pytest.approx(least.value, abs=1e-7)


def test_the_least_of_a_crank_rocker_stands_where_the_crank_lies_along_the_frame():
    frame = math.hypot(200, 20)
    cosines = [(180**2 + 120**2 - (frame + side * 60) ** 2) / (2 * 180 * 120) for side in (1, -1)]
    found = transmitted("crank_rocker")
    (of,) = found.couplers
    assert solve.least(of, found.kinematics).value == pytest.approx(
        min(math.acos(abs(one)) for one in cosines), rel=1e-12
    )


@pytest.mark.exhaustive
@pytest.mark.parametrize(("permitted", "word"), [("50 deg", "not less"), ("60 deg", "less than")])
def test_the_conclusion_says_whether_it_is_permitted(permitted, word):
    text = solved("crank_rocker").variant
    results = course.solve(stating(text, transmission=math.radians(float(permitted[:2])), readings={}))
    page = note.render(results, "html", Translator("en"))
    html = page if isinstance(page, str) else str(page)
    assert (
        "The least transmission angle is" in html and word in html.split("The least transmission angle is")[1]
    )


@pytest.mark.exhaustive
def test_a_mechanism_of_blocks_alone_is_told_to_have_none():
    results = course.solve(stating(read("piston_pump"), transmission=0.7, readings={}))
    assert not results.lever.transmission.couplers
    assert "there is no transmission angle to judge" in str(note.render(results, "html", Translator("en")))


def test_without_a_mechanism_it_is_told():
    with pytest.raises(ProblemError) as error:
        loading.loads("transmission: 40 deg\nrotor: {}\n")
    assert ("transmission",) in [problem.path for problem in error.value.problems]


def test_a_cam_has_a_pressure_angle_and_no_transmission_angle():
    """The link that replaces it is measured in its own length: the law of cosines says nothing of it."""
    with open("variants/cam_press.yaml", encoding="utf-8") as file:
        solved = course.solve(loading.loads(file.read() + "\ntransmission: 40 deg\n"))
    assert [one.group.links for one in solved.lever.transmission.couplers] == [("3", "4")]
