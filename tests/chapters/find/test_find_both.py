"""Two numbers from two demands, and the rest of the textbook's tasks asked backwards: against answers by hand."""

import json
import math

import numpy as np
import pytest
from notes import render
from test_find import PIVOT, RAILS, asked, number_of, read_text, results_of

from tmm_report import course, loading, solve
from tmm_report.problems import ProblemError
from tmm_report.results import tables, values
from tmm_report.stack import solve_many
from tmm_report.yamlread import loads as data_of

SERVO = read_text("governor_servo").split("  machine:")[0]
SPRING = SERVO.replace("choose: {spring: [970 rpm, 1030 rpm]}", "spring: {stiffness: 60 kN/m, force: 2400 N}")
BY_SPEEDS = (
    "{unknown: {governor.spring.stiffness: 1 kN/m .. 200 kN/m, governor.spring.force: 100 N .. 5 kN}, "
    "so_that: {omega_0: %s, omega_h: %s}}"
)
CAM = """language: en
mechanism:
  frame: {O: [0, 0], T: [0, 300 mm]}
  guides: {y: {through: O, angle: 90 deg}}
  links: {1: {points: {O: 0}}, 2: {points: {B: 0}, slides: y, mass: 0.5 kg, mass_centre: B}}
  driver: {link: 1, speed: 30 rad/s, rotation: counter-clockwise, zero: {angle: 0 deg}}
  cams: {k: {follower: 2, roller: {at: B, radius: 8 mm}, base: 60 mm, lift: 12 mm, phases: [{rise: 97 deg, law: cosine},
    {dwell: 33 deg}, {return: 80 deg, law: cosine}, {dwell: 150 deg}]}}
loads:
  gravity: 9.81 m/s^2
  springs: [{name: s, between: [B, T], stiffness: 2 kN/m, preload: -40 N}]
positions: {table: 12, diagram: 72, plans: [1], force_plan: 1}
"""
ROTOR = """language: en
rotor:
  masses:
    - {name: a, unbalance: 0.3 kg*m, angle: 0 deg, at: 100 mm}
    - {name: b, unbalance: 0.4 kg*m, angle: 90 deg, at: 700 mm}
    - {name: c, unbalance: %r kg*m, angle: 200 deg, at: 300 mm}
    - {name: d, unbalance: %r kg*m, angle: 290 deg, at: 400 mm}
  planes: [{at: 0 mm, radius: 200 mm}, {at: 800 mm, radius: 200 mm}]
"""


def at(degrees):
    return np.exp(1j * np.radians(degrees))


def closing():
    """The unbalances c and d that close the polygon of all four."""
    matrix = np.array([[at(200).real, at(290).real], [at(200).imag, at(290).imag]])
    return np.linalg.solve(matrix, [-0.3, -0.4])


def whole(text, found):
    """The variant that states what was found."""
    return solve(loading.loads(json.dumps(found.given.put(data_of(text).data, found.numbers))))


# --- a spring for two speeds


@pytest.mark.parametrize("speeds", [("970 rpm", "1030 rpm"), ("1030 rpm", "1000 rpm")])
def test_a_spring_for_two_speeds_is_that_which_the_governor_chooses(speeds):
    """Rising and falling: of falling speeds the governor cannot stand, and the spring is found all the same."""
    results = results_of(SPRING, BY_SPEEDS % speeds)
    found = results.find
    assert found.sound and len(found.sought.roots) == 1
    chosen = solve(loading.loads(SERVO.replace("970 rpm, 1030 rpm", ", ".join(speeds))))
    right = [number_of(chosen, key) for key in ("governor_c", "governor_F_0")]
    assert found.sizes(found.chosen.at) == pytest.approx(right, rel=1e-9)
    assert {k: form.number for k, form in found.closed} == pytest.approx(dict(enumerate(right)), rel=1e-9)
    assert [
        number_of(whole(SPRING, found), key) for key in ("governor_omega_0", "governor_omega_h")
    ] == pytest.approx(found.levels, rel=1e-10)


def test_the_formulas_of_the_spring_whatever_stands_first():
    find = BY_SPEEDS % ("970 rpm", "1030 rpm")
    turned = (
        "{unknown: {governor.spring.force: 100 N .. 5 kN, governor.spring.stiffness: 1 kN/m .. 200 kN/m}, "
        "so_that: {omega_h: 1030 rpm, omega_0: 970 rpm}}"
    )
    one, other = results_of(SPRING, find), results_of(SPRING, turned)
    numbers = [{key.key: key.value for key in values(results)} for results in (one, other)]
    for last, there in (("", "2"), ("2", "")):
        assert numbers[0][f"find_closed{last}"] == pytest.approx(numbers[1][f"find_closed{there}"], rel=1e-12)
        assert numbers[0][f"find_x{last}"] == pytest.approx(numbers[1][f"find_x{there}"], rel=1e-9)
        for of in numbers:
            off = 100 * (1 - of[f"find_closed{last}"] / of[f"find_x{last}"])
            assert of[f"find_closed_off{last}"] == pytest.approx(off, abs=1e-9)


def test_the_sensitivities_of_the_spring_are_those_of_its_formula():
    """At a stop F = A ω² − (what is held); F = F₀ + c z: dω/dF₀ = 1/(2 A ω) at both, dω_h/dc = h of it, dω₀/dc = 0."""
    found = results_of(SPRING, BY_SPEEDS % ("970 rpm", "1030 rpm")).find
    full = whole(SPRING, found)
    places = next(one for one in tables(full) if one.name == "governor_equilibrium")
    rates = [1 / (2 * places["A"].values[row] * places["omega_g"].values[row]) for row in (0, -1)]
    lift = number_of(full, "governor_h")
    right = np.array([[0, rates[0]], [lift * rates[1], rates[1]]])
    assert found.slopes[0] == pytest.approx(right, rel=1e-7, abs=1e-12)


def test_two_demands_that_cannot_be_met_say_how_near_they_come():
    """The stiffest spring of the range, and for it a force between those for the one speed and for the other."""
    results = results_of(SPRING, BY_SPEEDS.replace("200 kN/m", "20 kN/m") % ("970 rpm", "1030 rpm"))
    found = results.find
    assert not found.sound and not course.sound(results)
    assert found.numbers[0] == pytest.approx(20)
    low, high = found.chosen.value
    assert low > found.levels[0] and high < found.levels[1]
    assert "cannot both be met" in render(results, "html", "en")["note.html"].decode()


# --- radii of a pivot


def test_radii_of_a_pivot_for_a_pressure_and_a_moment():
    """p = Q/(π (R² − r²)) and of a run-in pivot M = f Q (R + r)/2 give R + r and R − r."""
    text = (
        "{unknown: {contacts.step.outer: 20 mm .. 90 mm, contacts.step.inner: 1 mm .. 60 mm}, "
        "so_that: {contacts_1.p_mean: 8 MPa, contacts_1.M_wear: 120 N*m}}"
    )
    found = results_of(PIVOT, text).find
    both = 2 * 120 / (0.12 * 40e3)
    apart = 40e3 / (math.pi * 8e6) / both
    assert found.sizes(found.chosen.at) == pytest.approx([(both + apart) / 2, (both - apart) / 2], rel=1e-9)
    assert found.closed == () and found.reason is not None  # an inner radius above the outer one is no pivot


# --- planes of two masses


def test_planes_of_two_masses_that_balance_a_shaft():
    """Four masses whose sum is nought: where two of them stand, the moments are nought too (linear equations)."""
    c, d = closing()
    text = ROTOR % (float(c), float(d))
    find = (
        "{unknown: {rotor.masses.c.at: -2 m .. 2 m, rotor.masses.d.at: -2 m .. 2 m}, "
        "so_that: {rotor_M_x: 0, rotor_M_y: 0}}"
    )
    found = results_of(text, find).find
    turned = np.array([c * at(200), d * at(290)])
    rest = 0.3 * 0.1 + 0.4 * 0.7j
    right = np.linalg.solve(np.array([turned.real, turned.imag]), [-rest.real, -rest.imag])
    assert len(found.sought.roots) == 1
    assert found.sizes(found.chosen.at) == pytest.approx(right, abs=1e-11)
    full = whole(text, found)
    assert abs(number_of(full, "rotor_M")) < 1e-12


def test_planes_in_which_two_stated_weights_balance():
    """With these weights in these planes neither a force nor a moment is left, of whatever the shaft carries."""
    text = ROTOR % (0.1, 0.2)
    find = (
        "{unknown: {rotor.planes.0.at: -200 mm .. 90 mm, rotor.planes.1.at: 710 mm .. 1500 mm}, "
        "so_that: {rotor_corrections.m.0: 1.25 kg, rotor_corrections.m.1: 0.88 kg}}"
    )
    found = results_of(text, find).find
    assert found.sound
    full = whole(text, found)
    table = next(one for one in tables(full) if one.name == "rotor_corrections")
    put = [
        m * r * at(beta)
        for m, r, beta in zip((1.25, 0.88), table["r"].values, table["beta"].values, strict=True)
    ]
    there = [(0.3, 0, 0.1), (0.4, 90, 0.7), (0.1, 200, 0.3), (0.2, 290, 0.4)]
    pulls = sum(d * at(a) for d, a, _ in there) + sum(put)
    turns = sum(d * z * at(a) for d, a, z in there) + sum(
        one * z for one, z in zip(put, found.sizes(found.chosen.at), strict=True)
    )
    assert abs(pulls) < 1e-9 and abs(turns) < 1e-9


# --- a locomotive


def test_the_share_of_the_balanced_mass_for_a_hammer_blow():
    """N = c m r ω²: mechanics has it for a locomotive, too."""
    find = "{unknown: {engine.counterweights.share: 0 .. 1}, so_that: {engine_hammer: 40 kN}}"
    found = results_of(RAILS, find).find
    right = 40e3 / (260 * 0.3 * (300 * math.pi / 30) ** 2)
    assert found.size(found.chosen.at) == pytest.approx(right, rel=1e-11)
    assert found.closed.number == pytest.approx(right, rel=1e-12)


def test_the_speed_at_which_a_wheel_is_lifted_off_the_rail():
    find = "{unknown: {engine.speed: 100 rpm .. 900 rpm}, so_that: {engine_hammer: 70 kN}}"
    found = results_of(RAILS, find).find
    right = math.sqrt(70e3 / (0.5 * 260 * 0.3))
    assert found.size(found.chosen.at) == pytest.approx(right, rel=1e-11)
    assert found.closed.number == pytest.approx(right, rel=1e-12)


# --- where a pair parts


def test_the_speed_at_which_a_follower_leaves_its_cam():
    """A cosine law under weight and spring: first at the top of the faster stroke, where
    m g + F₀ + c h = m ω² (π/β)² h/2."""
    find = "{unknown: {mechanism.driver.speed: 5 .. 200}, so_that: {cam_press_min_k: 0}}"
    found = results_of(CAM, find).find
    h, m, beta = 0.012, 0.5, math.radians(80)
    right = math.sqrt((m * 9.81 + 40 + 2000 * h) / (m * (math.pi / beta) ** 2 * h / 2))
    assert found.sound and found.size(found.chosen.at) == pytest.approx(right, rel=1e-9)


# --- what is told of mistakes


MISTAKES = {
    "one demand": ("{unknown: {%s}, so_that: {omega_0: 970 rpm}}", "unknowns: 2, demands: 1"),
    "no equality": ("{unknown: {%s}, so_that: {omega_0: 970 rpm, omega_h: at most 1030 rpm}}", "equalities"),
    "the greatest": ("{unknown: {%s}, so_that: {omega_0: 970 rpm}, greatest: omega_h}", "equalities"),
    "three unknowns": (
        "{unknown: {%s, governor.lift: 1 mm .. 20 mm}, so_that: {omega_0: 970 rpm, omega_h: 1030 rpm}}",
        "3 unknowns",
    ),
    "one on which nothing depends": (
        "{unknown: {governor.spring.force: 1 kN .. 5 kN, governor.sleeve.damping: 1 .. 9}, "
        "so_that: {omega_0: 970 rpm, omega_h: 1030 rpm}}",
        "neither of the demanded numbers depends on governor.sleeve.damping",
    ),
    "one number of no unknown": ("{unknown: {%s}, so_that: {omega_0: 970 rpm, governor_m: 1}}", "governor_m depends"),
    "one demand twice": ("{unknown: {%s}, so_that: {omega_h: 970 rpm, governor_omega_h: 970 rpm}}", "change together"),
}  # fmt: skip
TWO = "governor.spring.stiffness: 1 kN/m .. 200 kN/m, governor.spring.force: 100 N .. 5 kN"


@pytest.mark.parametrize("case", MISTAKES)
def test_a_mistake_of_two_unknowns_is_told_once(case):
    find, words = MISTAKES[case]
    with pytest.raises(ProblemError) as caught:
        solve(loading.loads(asked(SPRING, find % TWO if "%s" in find else find)))
    (problem,) = caught.value.problems
    assert words in problem.text()


def test_both_unknowns_may_not_be_one_number():
    find = (
        "{unknown: {contacts.0.outer: 1 mm .. 9 mm, contacts.step.outer: 1 mm .. 8 mm}, "
        "so_that: {contacts_1.p_mean: 1, contacts_1.M_wear: 1}}"
    )
    with pytest.raises(ProblemError, match="same number"):
        loading.loads(asked(PIVOT, find))


def test_results_and_every_format():
    results = results_of(SPRING, BY_SPEEDS % ("970 rpm", "1030 rpm"))
    numbers = {one.key: one.value for one in values(results)}
    table = next(one for one in tables(results) if one.name == "find_roots")
    for last in ("", "2"):
        assert numbers[f"find_x{last}"] == table[f"x{last}"].values[0]
        assert numbers[f"find_residual{last}"] == table[f"residual{last}"].values[0]
        assert numbers[f"find_y{last}"] - numbers[f"find_wanted{last}"] == numbers[f"find_residual{last}"]
    for fmt in ("html", "tex", "json", "csv"):
        assert all(render(results, fmt, "ru").values())


def test_a_search_that_ends_for_want_of_solvings_says_so(monkeypatch):
    monkeypatch.setattr("tmm_report.chapters.find.pair.MOST", 295)
    results = results_of.__wrapped__(
        SPRING, BY_SPEEDS.replace("200 kN/m", "20 kN/m") % ("970 rpm", "1030 rpm")
    )
    (told,) = course.doubts(results)
    assert "after 295 solvings" in told.text()


# --- a motor, and many at once


def test_the_falling_characteristic_of_a_motor_by_two_of_its_points():
    """M = M₀ (1 − ω/ω₀): at rest M₀ = J ε + Q, in steady motion M₀ (1 − ω/ω₀) = Q; the stated moment is at 20 rad/s."""
    text = """language: en
dynamics:
  parts: [{name: disc, inertia: 2 kg*m^2, moment: 15 N*m}]
  motor: {shunt: {moment: 40 N*m, speed: 20, no_load: 25}}
  start: {within: 2 %}
"""
    find = (
        "{unknown: {dynamics.motor.shunt.moment: 5 .. 60, dynamics.motor.shunt.no_load: 21 .. 60}, "
        "so_that: {dynamics_start.epsilon.0: 30 rad/s^2, dynamics_omega_m: 24}}"
    )
    found = results_of(text, find).find
    stall = 2 * 30 + 15
    no_load = 24 * stall / (stall - 15)
    right = [stall * (1 - 20 / no_load), no_load]
    assert found.sizes(found.chosen.at) == pytest.approx(right, rel=1e-9)


def test_many_at_once_find_what_each_finds_alone():
    texts = [asked(SPRING, BY_SPEEDS % (low, "1030 rpm")) for low in ("970 rpm", "990 rpm")]
    together = solve_many([loading.loads(text) for text in texts])
    alone = [solve(loading.loads(text)) for text in texts]
    assert [one.find.numbers for one in together] == [one.find.numbers for one in alone]
