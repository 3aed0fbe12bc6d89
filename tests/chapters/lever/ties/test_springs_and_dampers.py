"""Springs and viscous dampers between points, by ways that know nothing of how they are solved.

The potential energy and its derivative, virtual powers by finite differences of the lengths, works over the cycle, 40
digits.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from conftest import examples
from hypothesis import given, settings
from hypothesis import strategies as st
from notes import render

from tmm_report import course, loading, stack
from tmm_report.chapters.lever.kinetostatics.solve import acting_exact
from tmm_report.chapters.lever.kinetostatics.solve.positions import solve
from tmm_report.mechanics.lever.cycle import Cycle
from tmm_report.mechanics.rivals.exact import forces as exact_forces
from tmm_report.mechanics.rivals.exact.moving import motion as exact_motion
from tmm_report.problems import ProblemError

MECHANISM = """language: en
mechanism:
  frame: {{O: [0, 0], C: [{c} mm, 10 mm], K: [600 mm, 300 mm], L: [500 mm, -50 mm]}}
  links:
    1: {{points: {{O: 0, A: {a} mm}}}}
    2: {{points: {{A: 0, B: {b} mm, D: [180 mm, 60 mm]}}, mass: {m} kg, mass_centre: D, inertia: 0.02 kg*m^2}}
    3: {{points: {{C: 0, B: {d} mm, E: [260 mm, -40 mm]}}, mass: 3 kg, mass_centre: E, inertia: 0.04 kg*m^2}}
  driver: {{link: 1, speed: {speed} rpm}}
  assembly: {{B: left of A-C}}
loads:
"""
USUAL = MECHANISM.format(a=60, b=350, c=350, d=200, m=2, speed=120)
LOADS = """  gravity: 0
  springs:
    - {between: [E, K], stiffness: 2 kN/m, free_length: 180 mm}
    - {between: [D, E], stiffness: 1.5 kN/m, free_length: 90 mm}
  dampers:
    - {between: [L, E], viscosity: 300 N*s/m}
    - {between: [D, K], viscosity: 80 N*s/m}
"""
SPRINGS, DAMPERS = LOADS.split("  dampers:")
STEP = 1e-4  # rad, of central differences


def forces_of(text: str):
    return course.solve(loading.loads(text)).lever.kinetostatics


def lengths(cycle: Cycle, ends: tuple[str, str], turned: np.ndarray) -> np.ndarray:
    motion = cycle.motion(turned)
    return np.abs(motion.place(ends[1]) - motion.place(ends[0]))


def slopes(cycle: Cycle, ends: tuple[str, str], turned: np.ndarray) -> np.ndarray:
    """dl/dφ, m/rad, by differences of the fourth order."""
    at = [lengths(cycle, ends, turned + k * STEP) for k in (-2, -1, 1, 2)]
    return (at[0] - 8 * at[1] + 8 * at[2] - at[3]) / (12 * STEP)


def part_of(text: str, loads: str):
    """What the loads add to the balancing moment, N m, with the kinetostatics; nothing else depends on them."""
    with_loads, without = forces_of(text + loads), forces_of(text + "  gravity: 0\n")
    return with_loads, with_loads.table.balancing - without.table.balancing


def test_the_moment_of_springs_is_the_derivative_of_their_energy():
    found, moment = part_of(USUAL, SPRINGS)
    cycle, turned = found.kinematics.cycle, found.kinematics.turned
    energy = np.zeros(len(turned))
    for ends, stiffness, free in ((("E", "K"), 2000, 0.18), (("D", "E"), 1500, 0.09)):

        def stored(shift, ends=ends, stiffness=stiffness, free=free):
            return stiffness * (lengths(cycle, ends, turned + shift) - free) ** 2 / 2

        energy += (stored(-2 * STEP) - 8 * stored(-STEP) + 8 * stored(STEP) - stored(2 * STEP)) / (12 * STEP)
    assert moment * np.sign(found.kinematics.omega) == pytest.approx(energy, abs=1e-6 * np.abs(energy).max())


def test_springs_do_no_work_over_the_cycle():
    works = forces_of(USUAL + SPRINGS).works
    for one in works.stated:
        assert one.driving > 1 and abs(one.whole) < 1e-9 * one.driving
    assert abs(works.balancing.whole) < 1e-9 * works.balancing.driving


def test_what_dampers_take_the_balancing_moment_gives():
    found, moment = part_of(USUAL, "  gravity: 0\n  dampers:" + DAMPERS)
    kinematics = found.kinematics
    lost = np.zeros(len(kinematics.turned))
    for ends, viscosity in ((("L", "E"), 300), (("D", "K"), 80)):
        lost += viscosity * (slopes(kinematics.cycle, ends, kinematics.turned) * kinematics.omega) ** 2
    assert moment * kinematics.omega == pytest.approx(lost, rel=1e-7)
    fine = np.linspace(0, 2 * np.pi, 721)[:-1]
    whole = sum(
        viscosity * np.mean(slopes(kinematics.cycle, ends, fine) ** 2) * 2 * np.pi * abs(kinematics.omega)
        for ends, viscosity in ((("L", "E"), 300), (("D", "K"), 80))
    )
    assert sum(one.whole for one in found.works.stated) == pytest.approx(-whole, rel=1e-8)
    assert found.works.balancing.whole == pytest.approx(whole, rel=1e-8)
    assert all(one.driving == 0 for one in found.works.stated)


@settings(max_examples=examples(30))
@given(
    st.integers(30, 70),
    st.integers(320, 400),
    st.integers(330, 380),
    st.integers(150, 230),
    st.sampled_from([-300, -60, 45, 240]),
    st.floats(100, 5000),
    st.floats(0, 400),
    st.floats(1, 900),
)
def test_any_four_bar_has_the_moment_of_virtual_powers(a, b, c, d, speed, stiffness, free, viscosity):
    text = MECHANISM.format(a=a, b=b, c=c, d=d, m=2, speed=speed)
    loads = (
        f"  gravity: 0\n  springs:\n"
        f"    - {{between: [K, E], stiffness: {stiffness:.3f} N/m, free_length: {free:.3f} mm}}\n"
        f"    - {{between: [E, D], stiffness: 700 N/m, preload: -40 N, at_position: 5}}\n"
        f"  dampers: [{{between: [E, L], viscosity: {viscosity:.3f} N*s/m}}]\n"
    )
    found, moment = part_of(text, loads)
    kinematics = found.kinematics
    cycle, turned, omega = kinematics.cycle, kinematics.turned, kinematics.omega
    power = np.zeros(len(turned))
    free_2 = lengths(cycle, ("E", "D"), turned[5:6])[0] + 40 / 700
    for ends, size in (
        (("K", "E"), lambda l, v: float(f"{stiffness:.3f}") * (l - float(f"{free:.3f}") / 1e3)),
        (("E", "D"), lambda l, v: 700 * (l - free_2)),
        (("E", "L"), lambda l, v: float(f"{viscosity:.3f}") * v),
    ):
        rate = slopes(cycle, ends, turned) * abs(omega)
        power -= size(lengths(cycle, ends, turned), rate) * rate
    scale = np.abs(power / omega).max() + 1e-3
    assert moment == pytest.approx(-power / omega, abs=2e-6 * scale)
    assert max(found.worst_lever, found.worst_power) < 1e-9
    assert found.works.whole == pytest.approx(0, abs=1e-8 * found.works.size)


def test_both_ends_are_drawn_together():
    """Of a stretched spring between two moving points the forces are opposite and along the line; sums of all outer
    forces on the links, by the sides of the pairs with the frame, leave what the fixed ends take."""
    found = forces_of(USUAL + LOADS)
    loads = found.table.loading
    ends = [(one.of, one.at, vector) for one, vector in zip(found.given.forces, loads.forces, strict=True)]
    assert [(of, at) for of, at, _ in ends] == [
        ("c1", "E"),
        ("c2", "D"),
        ("c2", "E"),
        ("b1", "E"),
        ("b2", "D"),
    ]
    assert ends[1][2] == pytest.approx(-ends[2][2])
    motion = found.table.motion
    out = motion.place("E") - motion.place("D")
    tension = 1500 * (np.abs(out) - 0.09)
    assert ends[1][2] == pytest.approx(tension * out / np.abs(out))
    inertia = sum(loads.inertia.values())
    outer = sum(vector for _, _, vector in ends)
    held = sum(
        np.broadcast_to(one.force, motion.shape)
        for one in found.table.statics.reactions.values()
        if one.pair.links[0] == "0"
    )
    assert held + outer + inertia == pytest.approx(np.zeros(len(outer)), abs=1e-9 * np.abs(held).max())


@pytest.mark.parametrize(
    "preload",
    [
        "preload: 150 N",
        "preload: 150 N, at_position: 4",
        "preload: 150 N, at_length: 260 mm",
        "free_length: 0.2",
    ],
)
def test_forty_digits_agree(preload):
    text = USUAL + LOADS.replace("free_length: 180 mm", preload)
    found = forces_of(text)
    kinematics, motion, turned = found.kinematics, found.table.motion, found.kinematics.turned
    exact = exact_motion(kinematics.cycle, motion.phi)
    acting = acting_exact.acting(found.given, kinematics, motion, exact, turned)
    for (_, _, values), vector in zip(acting.forces, found.table.loading.forces, strict=True):
        assert np.array([complex(one) for one in values]) == pytest.approx(vector, rel=1e-12)
    whole = exact_forces.forces(exact, acting)
    balancing = np.array([float(one.moment) for one in whole.balances])
    assert balancing == pytest.approx(found.table.balancing, rel=1e-10)


def test_a_preload_holds_where_it_is_stated():
    def drawn(preload):
        found = forces_of(USUAL + LOADS.replace("free_length: 180 mm", preload))
        return found.table.loading.stated[0], lengths(
            found.kinematics.cycle, ("E", "K"), found.kinematics.turned
        )

    assert drawn("preload: 150 N")[0][0] == pytest.approx(150)
    assert drawn("preload: -75 N, at_position: 7")[0][7] == pytest.approx(-75)
    force, length = drawn("preload: 150 N, at_length: 260 mm")
    assert force == pytest.approx(150 + 2000 * (length - 0.26))


def test_two_springs_side_by_side_are_one_of_both_stiffnesses():
    half = "    - {between: [E, K], stiffness: 1 kN/m, free_length: 180 mm}\n"
    one = forces_of(USUAL + "  springs:\n" + half.replace("1 kN", "2 kN"))
    two = forces_of(USUAL + "  springs:\n" + half + half)
    assert two.table.balancing == pytest.approx(one.table.balancing)
    for key, reaction in one.table.statics.reactions.items():
        assert two.table.statics.reactions[key].force == pytest.approx(reaction.force)


def test_order_of_the_points_says_nothing():
    turned = LOADS.replace("[E, K]", "[K, E]").replace("[D, E]", "[E, D]").replace("[L, E]", "[E, L]")
    one, other = forces_of(USUAL + LOADS), forces_of(USUAL + turned)
    assert other.table.balancing == pytest.approx(one.table.balancing)


def test_the_link_said_takes_the_force():
    """At a joint one link or the other: the reaction there differs by the force, others do not."""
    spring = "  gravity: 0\n  springs: [{{between: [B, K], stiffness: 2 kN/m, free_length: 180 mm{}}}]\n"
    first, second = (forces_of(USUAL + spring.format(f", on: {{B: {link}}}")) for link in (2, 3))
    differences = {
        key: one.force - second.table.statics.reactions[key].force
        for key, one in first.table.statics.reactions.items()
    }
    force = first.table.loading.forces[0]
    changed = [key for key, value in differences.items() if np.abs(value).max() > 1e-6]
    assert len(changed) == 1
    assert np.abs(differences[changed[0]]) == pytest.approx(np.abs(force))


SLIDER = """language: en
mechanism:
  frame: {O: [0, 0], K: [300 mm, 0]}
  guides: {x: {through: O}}
  links: {1: {points: {O: 0, A: 100 mm}}, 2: {points: {A: 0, B: 300 mm}}, 3: {points: [B], slides: x}}
  driver: {link: 1, speed: 60 rpm, zero: {angle: 0 deg}}
  assembly: {B: right}
positions: {table: 12}
loads:
  springs: [{between: [K, B], stiffness: 2 kN/m, free_length: 50 mm}]
"""


def test_a_slider_through_the_point_of_its_spring_has_a_jump_there():
    found = forces_of(SLIDER)
    [through] = found.kinematics.cycle.roots_of([lambda motion: motion.place("B").real - 0.3])
    assert len(through) == 2
    assert all(np.abs(found.over.panels.edges - x).min() < 1e-9 for x in through)
    assert abs(found.works.stated[0].whole) < 1e-9 * found.works.stated[0].driving


def test_where_the_points_meet_there_is_no_force_and_it_is_said():
    text = SLIDER.replace("K: [300 mm, 0]", "K: [400 mm, 0]")  # the dead centre, position 0
    found = forces_of(text)
    assert np.isnan(found.table.balancing[0]) and np.isfinite(found.table.balancing[1:-1]).all()
    assert np.isnan(found.table.loading.forces[0][0])
    [told] = found.doubts
    assert "meet at position 0" in told.text() and told.path == ("loads", "springs", 0, "between")


def test_a_preload_where_the_points_meet_is_no_length_of_nothing():
    text = SLIDER.replace("K: [300 mm, 0]", "K: [400 mm, 0]").replace("free_length: 50 mm", "preload: 10 N")
    told = [problem.text() for problem in forces_of(text).doubts]
    assert any("comes out below zero" in one for one in told)


def test_points_always_in_one_place_are_refused():
    text = SLIDER.replace("{A: 0, B: 300 mm}", "{A: 0, B: 300 mm, C: 300 mm}").replace("[K, B]", "[C, B]")
    text = text.replace("points: [B], slides", "points: {B: 0, Q: 0}, slides").replace("[C, B]", "[C, Q]")
    with pytest.raises(ProblemError, match="in one place"):
        forces_of(text)


def test_a_cycle_alone_and_in_a_batch():
    """Over the whole cycle the forces at positions of the table are those of the table."""
    found = forces_of(USUAL + LOADS)
    again = solve(replace(found.given), found.kinematics)
    assert again.table.balancing == pytest.approx(found.table.balancing, abs=0)
    low, high = found.extremes
    assert low.value <= found.diagram.balancing.min() and high.value >= found.diagram.balancing.max()


def test_many_variants_together_are_each_as_alone():
    texts = [
        USUAL + LOADS.replace("free_length: 180 mm", f"preload: {50 + 10 * k} N, at_position: {k}")
        for k in range(stack.LEAST)
    ]
    variants = [loading.loads(text) for text in texts]
    for variant, found in zip(variants, stack.solve_many(variants), strict=True):
        alone = course.solve(variant).lever.kinetostatics
        assert found.lever.kinetostatics.table.balancing.tobytes() == alone.table.balancing.tobytes()


RUNNING = """dynamics:
  motor: {constant: 40 N*m}
  resistance: [{viscous: 2 N*m*s}]
"""


def test_springs_in_the_machine_in_motion_have_their_potential():
    """By the force analysis the moment, by the lengths the energy: over a cycle it takes no work, and −dV/dφ is it."""
    found = course.solve(loading.loads(USUAL + SPRINGS + RUNNING)).dynamics
    springs = [moment for of, moment in found.whole.machine.moments if of.key.startswith("F_c")]
    panels = found.whole.panels
    assert len(springs) == 2 and all(np.abs(moment).max() > 1 for moment in springs)
    assert abs(float(panels.mean(sum(springs)))) < 1e-9 * np.abs(sum(springs)).max()
    assert -panels.slope(found.whole.potential) == pytest.approx(
        sum(springs), abs=1e-7 * np.abs(sum(springs)).max()
    )


FLYWHEEL = "flywheel: {delta: 0.02}\n"
KINDS = {
    "springs": SPRINGS,
    "dampers": "  gravity: 0\n  dampers:" + DAMPERS,
    "flywheel": LOADS + FLYWHEEL,
    "turns": LOADS.replace("gravity: 0", "gravity: 9.81"),
    "instants": LOADS + "positions: {table: 12, at: [40 deg, 100 deg]}\n",
    "methods": LOADS + "methods: true\n",
}


@pytest.mark.parametrize("kind", KINDS)
def test_the_note_is_written(kind):
    text = USUAL.replace("speed: 120 rpm", "speed: 120 rpm, turns: 2") if kind == "turns" else USUAL
    results = course.solve(loading.loads(text + KINDS[kind]))
    for language, words in (("en", "Springs and dampers"), ("ru", "Пружины и демпферы")):
        assert words in render(results, "html", language)["note.html"].decode()


def test_the_note_says_where_the_points_meet():
    text = SLIDER.replace("K: [300 mm, 0]", "K: [400 mm, 0]")
    note = render(course.solve(loading.loads(text)), "html")["note.html"].decode()
    assert "two points meet" in note


def test_a_flywheel_takes_the_work_of_dampers():
    found = course.solve(loading.loads(USUAL + "  gravity: 0\n  dampers:" + DAMPERS + FLYWHEEL))
    whole = found.lever.kinetostatics.works.balancing.whole
    assert found.flywheel.sides.machine.panels.mean(
        found.flywheel.sides.machine.whole_moment
    ) * 2 * np.pi == (pytest.approx(-whole, rel=1e-9))


@pytest.mark.parametrize(("at", "told"), [("E", True), ("B", False)])
def test_a_spring_that_is_also_stated_of_the_machine_in_motion_is_doubted(at, told):
    spring = f"springs: [{{at: {at}, to: [600 mm, 300 mm], stiffness: 2 kN/m, length: 180 mm}}]"
    text = f"{USUAL}{LOADS.split('  dampers:')[0]}dynamics: {{{spring}, start: {{time: 0.1 s}}}}\n"
    said = [problem.text(str) for problem in loading.loads(text).doubts]
    assert any("state it once, in loads.springs" in one for one in said) is told
