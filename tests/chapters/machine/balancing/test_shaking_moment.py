"""What ways of balancing make of the shaking moment, wheels and weights in antiphase against it, rotors of any order:
by the angular momentum of positions, by the reactions of a mechanism that has the wheel, by Berkof's closed form."""

import json
import math
import re

import numpy as np
import pytest
from conftest import examples, solved
from hypothesis import given, settings
from hypothesis import strategies as st
from notes import VARIANTS, note

from tmm_report import course, loading, render
from tmm_report.chapters.machine.balancing.solve.cases import Case
from tmm_report.chapters.machine.balancing.solve.whole import Found
from tmm_report.mechanics.calculus import harmonics as fourier
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.mechanics.masses.counterweights import on_frame
from tmm_report.mechanics.masses.shaking_moment import not_negative
from tmm_report.problems import ProblemError

HEAVY = {"compressor": "124", "crank_rocker": "123", "slider_crank_offset": "12", "piston_pump": "13"}
WEIGHTS = (
    "counterweights: {1: {distance: 60 mm}, 2: {distance: 60 mm}, 3: {distance: 60 mm}, 4: {distance: 60 mm}}"
)
COUPLES = "couples: {1: {radius: 50 mm, distance: 200 mm}, 2: {radius: 40 mm, distance: 300 mm}}"


def found_in(name: str, block: str) -> Found:
    text = VARIANTS.joinpath(f"{name}.yaml").read_text("utf-8").split("\nloads:")[0]
    bare = re.sub(r"\n(balancing|harmonics|flywheel|vibration|reduction):[^\n]*(\n+ [^\n]*)*", "", text)
    weights = ", ".join(f"{link}: {{distance: 60 mm}}" for link in HEAVY[name] if "optimum" in block)
    stated = f"{bare}\nbalancing: {{counterweights: {{{weights}}}, {block}}}\n"
    balanced = course.solve(loading.loads(stated)).balancing
    assert balanced is not None
    return balanced


def case(found: Found, name: str) -> Case:
    return next(one for one in found.every if one.name == name)


def of_places(found: Found, case: Case) -> np.ndarray:
    """−dL/dt about the point, N m, at the positions, by differences of the places of masses and the angles of links."""
    kinematics, h = found.kinematics, 1e-4
    cycle, omega = kinematics.cycle, float(kinematics.omega)
    links = kinematics.linkage.mechanism.links
    about = complex(links[FRAME].points[found.about])
    motions = [cycle.motion(kinematics.turned + step * h) for step in (-2, -1, 0, 1, 2)]
    masses = [
        (link.mass, [m.place(link.mass_centre) for m in motions]) for link in links.values() if link.mass
    ]
    for one in case.weights:
        places = [m.state.r[one.link] + m.state.u[one.link] * (one.at - m.state.o[one.link]) for m in motions]
        masses.append((one.mass, places))
    moment = 0.0
    for mass, places in masses:
        moment -= mass * ((places[2] - about).conjugate() * second(places, h)).imag
    wheels: dict[str, float] = {}
    for wheel in case.geared:
        wheels[wheel.link] = wheel.inertia * wheel.ratio
    for name, link in links.items():
        if name != FRAME and (size := link.inertia + wheels.get(name, 0.0)):
            angles = list(np.unwrap(np.array([np.angle(m.turn(name)) for m in motions]), axis=0))
            moment -= size * second(angles, h)
    return moment * omega**2


def second(values: list, h: float) -> np.ndarray:
    a, b, c, d, e = values
    return (-a + 16 * b - 30 * c + 16 * d - e) / (12 * h * h)


ALL = "methods: [full, pivoted, substituted, optimum, inertia]"


@pytest.mark.parametrize("name", ["compressor", "crank_rocker", "slider_crank_offset"])
def test_moment_of_every_way_is_the_derivative_of_the_angular_momentum(name):
    found = found_in(name, ALL)
    assert len(found.every) >= 6
    for one in found.every:
        other = of_places(found, one)
        size = max(found.original.moment_max.value, np.abs(other).max())
        assert np.allclose(one.table.moment, other, rtol=0, atol=2e-5 * size), one.name


def test_full_balance_of_the_compressor_raises_the_moment_sevenfold():
    found = found_in("compressor", "methods: [full, optimum, inertia]")
    before, full, *_, geared = (one.moment_max.value for one in found.every)
    assert (before, full) == pytest.approx((98.51, 690.66), rel=1e-4)
    assert (
        geared < 0.05 * full and case(found, "inertia").force_max.value == case(found, "full").force_max.value
    )


def test_the_note_says_which_ways_raise_the_moment_and_which_lower_it():
    """By the greatest moments of the results."""
    document = json.loads(render(solved("crank_rocker"), "json", "en")["results.json"])
    columns = {one["key"]: one["values"] for one in document["tables"]["balancing_cases"]["columns"]}
    html = note("crank_rocker", "html", "en")["note.html"].decode()
    text = re.sub(r"\s+", " ", re.sub(r"<[^>]+>", "", html).replace("\xa0", " "))
    said = re.search(
        r"about point O is ([\d.]+) N·m. It is raised by ([^:]+):.*?It is lowered by (.*?)\. ", text
    )
    assert said is not None
    assert float(said[1]) == pytest.approx(columns["M_max"][0], rel=1e-4)
    for told, sense in ((said[2], 1), (said[3], -1)):
        ways = re.findall(r"way (\d+) to ([\d.]+) N·m \(([\d.]+) %\)", told)
        first = columns["M_max"][0]
        assert [int(n) for n, *_ in ways] == [
            n for n, moment in enumerate(columns["M_max"]) if sense * (moment - first) > 1e-6 * first
        ]
        for n, moment, percent in ways:
            assert float(moment) == pytest.approx(columns["M_max"][int(n)], rel=1e-4)
            assert float(percent) == pytest.approx(100 * columns["M_max"][int(n)] / first, rel=1e-3)


# ---------------------------------------------------------------- wheels

FOUR_BAR = """
mechanism:
  frame: {O: [0, 0], C: [200 mm, 20 mm], E: [300 mm, 20 mm]}
  links:
    1: {points: {O: 0, A: 60 mm}}
    2: {points: {A: 0, B: 180 mm, S2: 100 mm}, mass: 2.4 kg, mass_centre: S2, inertia: %s}
    3: {points: {C: 0, B: 120 mm, S3: 55 mm}, mass: 1.6 kg, mass_centre: S3, inertia: 0.003 kg*m^2}
%s  driver: {link: 1, speed: 90 rpm, rotation: clockwise, zero: {angle: 20 deg}}
  assembly: {B: left of A-C}
balancing: {%s}
"""


def four_bar(block: str, inertia: str = "0.0192 kg*m^2") -> Found:
    found = course.solve(loading.loads(FOUR_BAR % (inertia, "", block))).balancing
    assert found is not None
    return found


PIVOTED = "methods: [pivoted, inertia], counterweights: {1: {distance: 50 mm}, 3: {distance: 60 mm}}"


def test_in_line_four_bar_is_balanced_fully_by_wheels():
    """Berkof: the coupler a physical pendulum, J = m a b; on the rocker a wheel as heavy as all that turns with it,
    with the mass that the coupler puts into B and the counterweight."""
    found = four_bar(PIVOTED, inertia="0.01 kg*m^2")
    of = case(found, "inertia")
    wheels = {one.link: one for one in of.wheels}
    assert set(wheels) == {"2", "3"} and (wheels["2"].ratio, wheels["3"].ratio) == (1, -1)
    assert wheels["2"].inertia == pytest.approx(2.4 * 0.1 * 0.08 - 0.01, rel=1e-9)
    at_b = 2.4 * 0.1 / 0.18
    weight = next(one for one in case(found, "pivoted").placed if one.link == "3")
    assert weight.mass * 0.06 == pytest.approx(1.6 * 0.055 + at_b * 0.12, rel=1e-9)
    turning = 0.003 + 1.6 * 0.055**2 + at_b * 0.12**2 + weight.mass * 0.06**2
    assert wheels["3"].inertia == pytest.approx(turning, rel=1e-9)
    left = found.original.moment_max.value
    assert of.moment_max.value < 1e-8 * left < 1e-2 * case(found, "pivoted").moment_max.value
    assert of.force_max.value < 1e-9 * found.original.force_max.value


def test_a_mechanism_that_has_the_wheel_hands_on_what_is_left():
    """The wheel as a link of the mechanism, geared to the rocker: the reactions of its frame."""
    plain = four_bar("methods: [inertia], after: none, wheels: {3: -1.5}", inertia="0.012 kg*m^2")
    (wheel,) = case(plain, "inertia").wheels
    if not wheel.inertia:
        pytest.fail("the wheel is to take something")
    link = f"    4: {{points: {{E: 0, S4: 0}}, mass: 0 kg, inertia: {wheel.inertia!r} kg*m^2}}\n  wheels:\n"
    link += "    - {links: [4, 3], ratio: 1.5}\n"
    text = (FOUR_BAR % ("0.012 kg*m^2", link, "")).split("balancing:")[0]
    geared = course.solve(loading.loads(text)).lever
    assert geared is not None
    _, moment = on_frame(geared.kinematics.table, 0j)
    ours = case(plain, "inertia").table.moment
    assert np.allclose(moment, ours, rtol=0, atol=1e-9 * np.abs(ours).max())
    assert np.abs(ours - plain.original.table.moment).max() > 0.05 * np.abs(ours).max()


def test_moments_of_inertia_are_the_best():
    """A little more or less of any leaves a greater mean square."""
    found = found_in("crank_rocker", "methods: [full, optimum, inertia]")
    of, motion = case(found, "inertia"), found.kinematics.cycle.motion(found.turned)
    for one in of.wheels:
        for change in (-1e-3, 1e-3):
            moved = of.cycle.moment - change * one.ratio * motion.angular_acceleration(one.link)
            if one.inertia + change >= 0:
                assert fourier.mean_square(moved) >= of.moment_rms * (1 - 1e-12)


@settings(max_examples=examples(60))
@given(st.integers(0, 2**32 - 1), st.integers(1, 5))
def test_least_squares_that_are_not_negative_meet_their_conditions(seed, count):
    """Nothing used can be bettered, nothing unused would help (Karush, Kuhn, Tucker); a column twice does no harm."""
    random = np.random.default_rng(seed)
    columns = random.normal(size=(24, count)) * 10.0 ** random.integers(-3, 3, count)
    columns = np.column_stack([columns, columns[:, 0]])
    wanted = random.normal(size=24)
    x = not_negative(columns, wanted)
    slope = columns.T @ (wanted - columns @ x) / np.linalg.norm(columns, axis=0)
    assert x.min() >= 0
    assert np.abs(slope[x > 0]).max(initial=0.0) < 1e-8
    assert slope.max() < 1e-8


YOKE = """
mechanism:
  frame: {O: [0, 0]}
  guides:
    x: {through: O}
    s: {through: E, angle: 90 deg, link: 3}
  links:
    1: {points: {O: 0, A: 50 mm, S1: -8 mm}, mass: 2 kg, mass_centre: S1}
    2: {points: [A], slides: {guide: s, angle: 0 deg}, mass: 0.3 kg}
    3: {points: {E: 0, S3: [60 mm, 30 mm]}, slides: {guide: x, at: E}, mass: 3.2 kg, mass_centre: S3}
  driver: {link: 1, speed: 300 rpm, zero: {angle: 90 deg}}
balancing: {methods: [inertia, couples], couples: {1: {radius: 5 cm, distance: 30 cm}}}
"""


def test_where_no_link_turns_unevenly_wheels_take_nothing_and_weights_do():
    found = course.solve(loading.loads(YOKE)).balancing
    assert found is not None
    geared, coupled = case(found, "inertia"), case(found, "couples")
    assert geared.wheels == () and geared.moment_max.value == found.original.moment_max.value > 1
    assert coupled.moment_max.value < 1e-9 * found.original.moment_max.value


# ---------------------------------------------------------------- weights in antiphase


@pytest.mark.parametrize("name", ["compressor", "crank_rocker"])
def test_weights_in_antiphase_take_their_orders_and_nothing_else(name):
    found = found_in(name, f"methods: [couples], after: none, {COUPLES}")
    of = case(found, "couples")
    before, after = (fourier.series(one.cycle.moment, 6).amplitude for one in (found.original, of))
    assert np.allclose(after[1:3], 0, atol=1e-9 * before.max())
    assert np.allclose(after[3:], before[3:], rtol=0, atol=1e-9 * before.max())
    assert np.array_equal(of.cycle.force, found.original.cycle.force)


@pytest.mark.parametrize("sense", ["clockwise", "counter-clockwise"])
def test_weights_in_antiphase_are_two_masses_on_two_axes(sense):
    """By differences of their places; a motor of either sense. Their forces cancel, the moment is the same about any
    point."""
    text = (FOUR_BAR % ("0.01 kg*m^2", "", f"methods: [couples], after: none, {COUPLES}")).replace(
        "clockwise", sense
    )
    found = course.solve(loading.loads(text)).balancing
    assert found is not None
    of = case(found, "couples")
    omega, h = abs(found.kinematics.omega), 1e-4
    ways = 1 if sense == "counter-clockwise" else -1
    steps = [found.kinematics.turned + k * h for k in (-2, -1, 0, 1, 2)]
    force, moment = 0, 0
    for one in of.couples:
        for side in (0.5, -0.5):
            arm = one.radius * np.sign(side)
            places = [
                1.3 + 0.4j + side * one.distance + arm * np.exp(1j * (one.angle + ways * one.order * at))
                for at in steps
            ]
            inertia = -one.mass * second(places, h) * omega**2
            force, moment = force + inertia, moment + (places[2].conjugate() * inertia).imag
    added = of.table.moment - found.original.table.moment
    assert np.allclose(moment, added, rtol=0, atol=1e-5 * np.abs(added).max())
    assert np.abs(force).max() < 1e-5 * np.abs(added).max()


# ---------------------------------------------------------------- rotors of any order


def test_rotors_of_stated_orders_take_these_ellipses():
    found = found_in("crank_rocker", "methods: [rotors], rotors: {3: 30 mm, first: 60 mm, 5: 20 mm}")
    assert [one.name for one in found.cases] == ["rotors_1", "rotors_3", "rotors_5"]
    before = fourier.turning(found.original.cycle.force, 6)
    for one, taken in zip(found.cases, ((1,), (1, 3), (1, 3, 5)), strict=True):
        after = fourier.turning(one.cycle.force, 6)
        expected = [0.0 if abs(k - 6) in taken else before[k] for k in range(13)]
        assert np.allclose(after, expected, rtol=0, atol=1e-10 * np.abs(before).max())
    assert found.cases[2].force_rms < found.cases[1].force_rms < found.cases[0].force_rms


def test_a_pair_of_rotors_is_two_masses_that_turn():
    """The force of order 3 by differences of the places of both masses: its harmonic with the other sign."""
    found = found_in("crank_rocker", "methods: [rotors], rotors: {3: 30 mm}, highest: 3")
    ways, omega, h = found.kinematics.cycle.sense, abs(found.kinematics.omega), 1e-4
    total = 0
    for one in found.cases[0].rotors:
        places = [
            0.03 * np.exp(1j * (one.angle + ways * one.order * (found.turned + k * h)))
            for k in (-2, -1, 0, 1, 2)
        ]
        total = total - one.mass * second(places, h) * omega**2
    harmonic = fourier.turning(found.original.cycle.force, 3)
    wanted = sum(harmonic[3 + k] * np.exp(1j * k * found.turned) for k in (3, -3))
    assert np.allclose(total, -wanted, rtol=0, atol=1e-5 * np.abs(wanted).max())


# ---------------------------------------------------------------- what is stated wrongly

OPTIMUM = "methods: [optimum], counterweights: {1: {distance: 5 cm}}"


@pytest.mark.parametrize(
    ("block", "key", "words"),
    [
        ("methods: [couples]", "balancing.couples", "not stated"),
        ("couples: {7: {radius: 5 cm, distance: 1 m}}", "balancing.couples.7", "1 … 6"),
        ("couples: {x: {radius: 5 cm, distance: 1 m}}", "balancing.couples.x", "no order"),
        ("couples: {1: {radius: 5 cm}}", "balancing.couples.1.distance", "missing"),
        ("rotors: {0: 60 mm}", "balancing.rotors.0", "1 … 6"),
        ("rotors: {first: 60 mm, 1: 50 mm}", "balancing.rotors.1", "twice"),
        ("methods: [inertia], wheels: {3: 0}", "balancing.wheels.3", "does not turn"),
        ("methods: [inertia], wheels: {2: -1}", "balancing.wheels.2", "not pivoted to the frame"),
        ("methods: [inertia], wheels: {8: -1}", "balancing.wheels.8", "no link 8"),
        ("methods: [inertia], wheels: {1: -1}", "balancing.wheels.1", "does not turn unevenly"),
        ("methods: [inertia], after: full", "balancing.after", "not asked for"),
        (f"{OPTIMUM}, wheels: {{3: -1}}", "balancing.wheels", "add inertia to the methods"),
        (f"{OPTIMUM}, {COUPLES}", "balancing.couples", "add couples to the methods"),
        (f"{OPTIMUM}, after: optimum", "balancing.after", "no method that uses it"),
        ("methods: [inertia], after: stated", "balancing.after", "one of: none"),
    ],
)
def test_a_wrong_value_is_told_where_it_stands(block, key, words):
    with pytest.raises(ProblemError) as error:
        four_bar(block)
    found = [(problem.key, problem.text()) for problem in error.value.problems]
    assert [one for one, _ in found] == [key] and words in found[0][1], found


def test_full_balance_that_guides_forbid_is_no_way_before_the_moment():
    block = "methods: [full, optimum, inertia], after: full"
    with pytest.raises(ProblemError) as error:
        found_in("piston_pump", block)
    (problem,) = error.value.problems
    assert problem.key == "balancing.after" and "one of: none, optimum" in problem.text()


def test_wheels_and_weights_stated_are_asked_for():
    block = f"{WEIGHTS}, wheels: {{3: -1}}, {COUPLES}".replace(", 4: {distance: 60 mm}", "")
    ways = [one.name for one in four_bar(block).cases]
    assert ways[-2:] == ["inertia", "couples"] and "full" in ways
    assert math.isfinite(four_bar(block).every[-1].moment_max.value)
