"""A press: the closed form of an in-line slider-crank, power and balancing moment, dense scanning, what is refused."""

from __future__ import annotations

import math

import numpy as np
import pytest
from conftest import solved

from tmm_report import course, loading
from tmm_report.chapters.lever.press import quantities
from tmm_report.chapters.lever.press.view import PressView
from tmm_report.i18n import Translator
from tmm_report.problems import ProblemError
from tmm_report.report.formats import Html
from tmm_report.report.numbering import Numbering
from tmm_report.report.page import Page

R, L = 0.15, 0.6
CRANK = """
mechanism:
  frame: {{O: [0, 0]}}
  guides: {{y: {{through: O, angle: {guide} deg}}}}
  links:
    1: {{points: {{O: 0, A: 150 mm}}}}
    2: {{points: {{A: 0, B: 600 mm}}}}
    3: {{points: [B], slides: y}}
  driver: {{link: 1, speed: {speed}, zero: {{angle: 20 deg}}}}
  assembly: {{B: {side}}}
positions: {{table: 12, diagram: 36}}
"""
ASKED = "{slider: 3, extreme: down, torque: 30 kN*m, rated: 600 kN, within: 3 mm, working: [40 mm, 5 mm]}"


def crank(press=ASKED, guide=90, speed="60 rpm", side="down"):
    text = CRANK.format(guide=guide, speed=speed, side=side)
    return course.solve(loading.loads(text + f"press: {press}\n")).lever.press


def path(alpha):
    """Left to the farther dead point of an in-line slider-crank, m."""
    return R * (1 - np.cos(alpha)) + L * (1 - np.sqrt(1 - (R / L * np.sin(alpha)) ** 2))


def arm(alpha):
    lean = R / L * np.sin(alpha)
    return R * np.sin(alpha) + R * np.cos(alpha) * lean / np.sqrt(1 - lean**2)


def bisect(of, low, high):
    for _ in range(80):
        middle = (low + high) / 2
        low, high = (middle, high) if (of(low) > 0) == (of(middle) > 0) else (low, middle)
    return low


@pytest.fixture(scope="module")
def ready():
    return solved("knuckle_press").lever.press


# --- the closed form


@pytest.mark.parametrize(("guide", "speed"), [(90, "60 rpm"), (-90, "-60 rpm"), (90, "-2 rad/s")])
def test_a_slider_crank_is_that_of_its_closed_form(guide, speed):
    found = crank(guide=guide, speed=speed)
    s, omega = found.s, 2.0 if "rad" in speed else 2 * math.pi
    assert s.number("omega") == pytest.approx(omega)
    assert s.number("stroke") == pytest.approx(2 * R) and s.number("alpha_stroke") == pytest.approx(math.pi)
    alpha = bisect(lambda x: arm(x) - 0.05, 0.0, 0.9)
    assert s.number("alpha_nom") == pytest.approx(alpha, rel=1e-10)
    assert s.number("s_nom") == pytest.approx(path(alpha), rel=1e-9)
    half = bisect(lambda x: path(x) - 0.003, 0.0, 1.0)
    assert (s.number("before"), s.number("after")) == pytest.approx((half, half), rel=1e-8)
    assert s.number("dwell") == pytest.approx(2 * half) and s.number("t_dwell") == pytest.approx(
        2 * half / omega
    )
    begin, end = (bisect(lambda x, to=to: path(x) - to, 0.0, 2.0) for to in (0.04, 0.005))
    assert (s.number("alpha_1"), s.number("alpha_2")) == pytest.approx((begin, end), rel=1e-9)
    assert s.number("v_max") == pytest.approx(omega * arm(begin), rel=1e-9)  # it slows down all the way
    assert s.number("v_min") == pytest.approx(omega * arm(end), rel=1e-9)
    mean = 0.035 * omega / (begin - end)
    assert s.number("peak") == pytest.approx(omega * arm(begin) / mean)
    assert s.number("unevenness") == pytest.approx(omega * (arm(begin) - arm(end)) / mean)
    assert s.number("h_max") == pytest.approx(arm(np.linspace(0, math.pi, 200001)).max(), rel=1e-9)


def test_the_rows_are_those_of_the_closed_form():
    for table in quantities.tables(crank()):
        alpha = table["alpha"].numbers()
        assert table["s"].numbers() == pytest.approx(path(alpha), abs=1e-12)
        assert table["h"].numbers() == pytest.approx(arm(alpha), abs=1e-12)
        assert table["v"].numbers() == pytest.approx(2 * math.pi * arm(alpha), abs=1e-11)
        forces = table["F_lim"].numbers()
        assert np.isnan(forces[0]) and forces[1:-1] == pytest.approx(30e3 / arm(alpha[1:-1]), rel=1e-9)
    table, _ = quantities.tables(crank())
    assert table["alpha"].numbers("deg") == pytest.approx(np.arange(0, 91, 5))


def test_to_the_dead_point_itself_the_least_velocity_is_nil():
    s = crank("{slider: 3, extreme: down, working: [300 mm, 0]}").s
    assert s.number("v_min") == 0 and s.number("alpha_2") == 0
    assert s.number("alpha_1") == pytest.approx(math.pi, abs=1e-6)
    assert s.number("v_max") == pytest.approx(
        2 * math.pi * arm(np.linspace(0, math.pi, 200001)).max(), rel=1e-9
    )
    assert s.number("v_mean") == pytest.approx(0.3 / 0.5)


def test_the_other_dead_point_is_asked_by_its_side():
    other = crank(ASKED.replace("down", "up")).s
    # towards the crank the rod shortens the stroke less than it lengthens it on the other side
    half = bisect(lambda x: path(math.pi) - path(math.pi - x) - 0.003, 0.0, 1.0)
    assert other.number("before") == pytest.approx(half, rel=1e-8)
    assert other.number("before") > crank().s.number("before")


def test_a_rated_force_below_the_least_permitted_is_permitted_everywhere():
    found = crank("{slider: 3, extreme: down, torque: 30 kN*m, rated: 100 kN}")
    assert found.always and found.s.number("F_least") > 100e3
    assert found.s.number("alpha_nom") == pytest.approx(math.pi)
    assert found.s.number("s_nom") == pytest.approx(2 * R)


# --- any mechanism


def dense(found, count=400001):
    alpha = np.linspace(0, found.begins, count)
    motion = found.before(alpha)
    return alpha, found.path(motion), found.arm(motion)


def test_a_knuckle_press_is_that_of_dense_scanning(ready):
    s, given = ready.s, ready.given
    alpha, left, h = dense(ready)
    assert (np.diff(left) > -1e-12).all() and left[-1] == pytest.approx(s.number("stroke"))
    first = np.argmax(h >= given.torque / given.rated)
    assert s.number("alpha_nom") == pytest.approx(alpha[first], abs=2e-5)
    assert s.number("s_nom") == pytest.approx(left[first], abs=1e-6)
    assert s.number("before") == pytest.approx(alpha[np.argmax(left >= given.within)], abs=2e-5)
    after = np.linspace(0, 2.0, 200001)
    assert s.number("after") == pytest.approx(
        after[np.argmax(ready.path(ready.before(-after)) >= given.within)], abs=2e-5
    )
    working = (left >= given.working[1]) & (left <= given.working[0])
    omega = s.number("omega")
    assert s.number("v_max") == pytest.approx(omega * h[working].max(), rel=1e-4)
    assert s.number("v_min") == pytest.approx(omega * h[working].min(), rel=1e-4)
    assert s.number("t_working") == pytest.approx(np.ptp(alpha[working]) / omega, rel=1e-4)
    assert s.number("v_mean") == pytest.approx(np.trapezoid(omega * h[working]) / working.sum(), rel=1e-4)
    assert s.number("h_max") == pytest.approx(h.max(), rel=1e-9)


def test_the_arm_is_the_slope_of_the_path(ready):
    alpha, left, h = dense(ready, 20001)
    assert np.gradient(left, alpha, edge_order=2) == pytest.approx(h, abs=1e-6 * h.max())


@pytest.mark.parametrize("position", [3, 4, 5])
def test_the_permitted_force_is_balanced_by_the_permitted_torque(position):
    """Of the mechanism without masses, under a constant force alone, by the reactions of its groups."""
    text = solved_text("knuckle_press")
    head, _ = text.split("\nloads:")
    for key in ("inertia", "mass"):
        head = "\n".join(without(line, key) for line in head.splitlines())
    loads = "\nloads:\n  gravity: 0\n  forces: [{name: F, at: D, direction: up, constant: 1 N}]\n"
    asked = "press: {slider: 5, extreme: down, torque: 1 N*m}\npositions: {table: 12, diagram: 36}\n"
    lever = course.solve(loading.loads(head + loads + asked)).lever
    found, moment = lever.press, abs(float(lever.kinetostatics.table.balancing[position]))
    alpha = found.dead - lever.kinematics.turned[position]
    assert abs(float(found.arm(found.before([alpha]))[0])) == pytest.approx(moment, rel=1e-9)


def solved_text(name):
    from notes import VARIANTS

    return (VARIANTS / f"{name}.yaml").read_text("utf-8")


def without(line, key):
    import re

    return re.sub(rf", {key}(_centre)?: [^,}}]*", "", line)


# --- what is refused


@pytest.mark.parametrize(
    ("press", "path", "words"),
    [
        ("{slider: 3, extreme: down}", ("press",), "nothing is asked"),
        ("{slider: 2, extreme: down, within: 1 mm}", ("press", "slider"), "does not slide"),
        ("{slider: 9, extreme: down, within: 1 mm}", ("press", "slider"), "9"),
        ("{slider: 3, extreme: left, within: 1 mm}", ("press", "extreme"), "does not lead there"),
        ("{slider: 3, extreme: down, rated: 1 kN}", ("press", "rated"), "without the permitted torque"),
        ("{slider: 3, extreme: down, working: [1 mm, 2 mm]}", ("press", "working"), "ends before it begins"),
        ("{slider: 3, extreme: down, working: [301 mm, 2 mm]}", ("press", "working"), "300 mm"),
        ("{slider: 3, extreme: down, within: 301 mm}", ("press", "within"), "300 mm"),
        ("{slider: 3, extreme: down, torque: -1 N*m}", ("press", "torque"), ""),
    ],
)
def test_what_is_stated_wrong_is_told(press, path, words):
    with pytest.raises(ProblemError) as error:
        crank(press)
    assert [one.path[:2] for one in error.value.problems] == [path]
    assert words in error.value.problems[0].text()


def test_it_goes_all_round_and_evenly():
    text = CRANK.format(guide=90, speed="60 rpm", side="down").replace("O: 0, A: 150 mm", "O: 0, A: 650 mm")
    with pytest.raises(ProblemError) as error:
        course.solve(loading.loads(f"allow_partial: true\n{text}press: {ASKED}\n"))
    assert "all round" in error.value.problems[0].text()
    law = CRANK.replace("speed: {speed}", "law: {{speed: 2 rad/s, acceleration: 1 rad/s^2}}").replace(
        ", zero: {{angle: 20 deg}}", ""
    )
    with pytest.raises(ProblemError) as error:
        loading.loads(law.format(guide=90, side="down") + f"press: {ASKED}\n")
    assert ("press",) in [one.path for one in error.value.problems]
    with pytest.raises(ProblemError) as error:
        loading.loads(f"press: {ASKED}\nrotor: {{}}\n")
    assert ("press",) in [one.path for one in error.value.problems]


# --- the chart


def test_the_chart_crosses_the_rated_force_at_its_path(ready):
    page = Page(Html(), Translator("en"), Numbering())
    graph = PressView(ready, page).diagram()
    forces, rated, speed = graph.curves
    ((at, force),) = forces.marked(graph.x)
    assert (at, force) == (ready.s.number("s_nom") * 1e3, 800.0)
    assert np.interp(at, graph.x, forces.values) == pytest.approx(force, rel=0.02)
    assert (rated.values == 800.0).all()
    given = np.isfinite(forces.values)
    assert speed.values[given] == pytest.approx(8e3 / forces.values[given] / 1e3 * 2 * math.pi, rel=1e-9)
