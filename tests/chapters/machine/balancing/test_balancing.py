"""Balancing on the foundation: shaking by two ways, counterweights of each method, what they leave."""

import math
from dataclasses import replace

import numpy as np
import pytest
from conftest import examples, read, solved, stating
from hypothesis import given, settings
from hypothesis import strategies as st

from tmm_report import course
from tmm_report.chapters.lever.kinetostatics.given import Loads
from tmm_report.chapters.lever.moving import Moving
from tmm_report.chapters.machine.balancing.given import METHODS, Antiphase, Counterweight, Existing, Given
from tmm_report.chapters.machine.balancing.solve.substituted_masses import substitute, unreached
from tmm_report.chapters.machine.balancing.solve.whole import Found, solve
from tmm_report.mechanics.calculus import harmonics as fourier
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.mechanics.masses.counterweights import added, smallest_circle
from tmm_report.problems import ProblemError

EVERY = {
    "rotors": {"first": 0.06, "second": 0.04},
    "couples": {"1": Antiphase(0.06, 0.3)},
    "methods": list(METHODS),
}


def balanced(name: str, **changes) -> Found:
    """A variant balanced by all methods, with counterweights at 50 mm on every link."""
    lever = solved(name).lever
    links = lever.kinematics.linkage.mechanism.moving
    weights = dict.fromkeys(links, Counterweight(distance=0.05))
    stated = Given(**{**EVERY, "counterweights": weights, **changes})
    return solve(stated, Moving(lever.kinematics, lever.kinetostatics))


def case(found: Found, name: str):
    return next(one for one in found.every if one.name == name)


@pytest.fixture
def turning(variant) -> Found:
    """Every ready mechanism that has masses and turns all round, balanced by all methods."""
    try:
        return balanced(variant.file.removesuffix(".yaml").rsplit("/", 1)[-1])
    except ProblemError as error:
        pytest.skip(error.problems[0].wrong.text)


# ---------------------------------------------------------------- two ways to the shaking


def test_frame_hands_on_the_inertia_forces(turning):
    """As it is and with all counterweights as parts of the links: force and moment by the frame's reactions."""
    assert turning.s.number("balancing_disagreement") < 1e-9
    beside = [one for one in turning.every if one.rotors or one.couples]  # what turns beside the links
    assert all(one.check is not None for one in turning.every if one not in beside and one.base not in beside)


@pytest.mark.parametrize("name", ["compressor", "crank_rocker", "piston_pump"])
def test_reactions_of_the_force_analysis_give_it_too(name):
    """The chapter of kinetostatics without weights and loads: the sum of what the links do to the frame."""
    lever = course.solve_lever(stating(read(name), loads=Loads(gravity=0j), readings={}, friction=None).lever)
    table, force = lever.kinetostatics.table, 0
    for reaction in table.statics.reactions.values():
        if FRAME in reaction.pair.links:
            force = force + table.statics.force(FRAME, reaction.pair.other(FRAME))
    ours = balanced(name).original.table.force
    assert np.allclose(force, ours, rtol=0, atol=1e-9 * np.abs(ours).max())


def test_shaking_force_has_no_mean(turning):
    """The momentum of a cycle comes back to itself."""
    force = turning.original.cycle.force
    assert abs(force.mean()) < 1e-11 * np.abs(force).max()


def test_moment_about_another_point_differs_by_the_force_on_the_arm():
    one, other = balanced("crank_rocker"), balanced("crank_rocker", about="C")
    away = 0.2 + 0.02j  # from O to C
    expected = one.original.cycle.moment - (away.conjugate() * one.original.cycle.force).imag
    assert np.allclose(other.original.cycle.moment, expected, rtol=0, atol=1e-12 * np.abs(expected).max())


# ---------------------------------------------------------------- all mass centres moved to the frame


def test_full_balance_leaves_no_force_where_every_link_hangs_by_pivots(turning):
    linkage = turning.kinematics.linkage
    names = [one.name for one in turning.cases]
    assert ("full" in names) == (not unreached(linkage))
    if "full" in names:
        assert turning.complete(case(turning, "full"))


def test_contour_theorem_by_structure():
    """A rod of a pump whose only pairs are guides; a four-bar; a slider-crank."""
    assert unreached(solved("piston_pump").lever.kinematics.linkage) == ["5"]
    assert unreached(solved("crank_rocker").lever.kinematics.linkage) == []
    assert unreached(solved("slider_crank_offset").lever.kinematics.linkage) == []


def test_four_bars_counterweights_are_those_of_the_lecture():
    """m_c2 ρ2 = m2 l_S2, m_c3 ρ3 = (m2 + m_c2) l_CB + m3 l_CS3: the one on the rod weighs on the rocker too."""
    weights = {link: Counterweight(distance=0.06) for link in "123"}
    placed = {one.link: one for one in case(balanced("crank_rocker", counterweights=weights), "full").placed}
    from_b = abs(0.1 + 0.02j - 0.18)  # S2 from B, by which the rod hangs on the rocker
    m_c2 = 2.4 * from_b / 0.06
    m_c3 = ((2.4 + m_c2) * 0.12 + 1.6 * 0.055) / 0.06
    assert set(placed) == {"2", "3"}  # the crank has no mass
    assert placed["2"].mass == pytest.approx(m_c2, rel=1e-12)
    assert placed["3"].mass == pytest.approx(m_c3, rel=1e-12)
    assert placed["3"].moment.imag == 0 and placed["3"].moment.real < 0  # on the other side of the pivot


def test_cranks_counterweight_is_that_of_its_own_mass():
    """m_c1 ρ1 = m1 l_OS1, where the rod hangs on the rocker."""
    lever = read("crank_rocker").lever
    crank = lever.mechanism.links["1"]
    heavy = replace(crank, points={**crank.points, "S1": 0.025 + 0j}, mass=3.0, mass_centre="S1")
    mechanism = replace(lever.mechanism, links={**lever.mechanism.links, "1": heavy})
    kinematics = course.solve_lever(replace(lever, mechanism=mechanism, readings={}, loads=None)).kinematics
    weights = {link: Counterweight(distance=0.05) for link in "123"}
    full = case(solve(Given(("full",), weights), Moving(kinematics, None)), "full")
    assert {one.link: one.mass for one in full.placed}["1"] == pytest.approx(3.0 * 0.025 / 0.05, rel=1e-12)
    assert full.force_max.value < 1e-9 * full.mass


def test_distance_from_mass_is_mass_from_distance():
    one = case(balanced("crank_rocker"), "full").placed[1]
    by_mass = {
        "2": Counterweight(distance=0.05),
        "3": Counterweight(mass=one.mass),
        "1": Counterweight(mass=1.0),
    }
    other = case(balanced("crank_rocker", counterweights=by_mass), "full").placed[1]
    assert other.distance == pytest.approx(0.05, rel=1e-12) and one.link == other.link == "3"


# ---------------------------------------------------------------- linearly independent vectors


def test_four_bar_is_balanced_by_its_two_pivoted_links():
    """Berkof and Lowen: m2 (l2 − s2)/l2 comes on the crank, m2 s2/l2 on the rocker, s2 complex."""
    found = balanced("crank_rocker")
    pivoted = case(found, "pivoted")
    share = (0.1 + 0.02j) / 0.18
    crank, rocker = -2.4 * (1 - share) * 0.06, -2.4 * share * 0.12 - 1.6 * 0.055
    assert found.complete(pivoted)
    assert [one.moment for one in pivoted.placed] == pytest.approx([crank, rocker], rel=1e-11)


def test_pivoted_links_never_leave_more_than_the_crank_alone(turning):
    rms = {one.name: one.force_rms for one in turning.every}
    assert rms["pivoted"] <= rms["optimum_rms"] * (1 + 1e-9) <= rms["original"] * (1 + 1e-9)


# ---------------------------------------------------------------- substituted masses


def test_uniform_rod_is_a_sixth_two_thirds_a_sixth():
    lever = read("compressor").lever
    mechanism = lever.mechanism
    rod = replace(mechanism.links["2"], inertia=1.5 * 0.3**2 / 12)
    uniform = replace(mechanism, links={**mechanism.links, "2": rod})
    linkage = course.solve_lever(replace(lever, mechanism=uniform, readings={})).kinematics.linkage
    split = substitute(linkage, 0.5).splits[0]
    assert split.masses == pytest.approx((0.75, 0.75))
    assert split.dynamic == pytest.approx((0.25, 1.0, 0.25)) or split.dynamic == pytest.approx(
        (0.25, 0.25, 1.0)
    )


def test_two_masses_keep_mass_and_centre_three_keep_inertia(turning):
    for one in turning.substituted.splits:
        a, b = one.arms
        assert sum(one.masses) == pytest.approx(one.mass, rel=1e-12)
        assert one.masses[0] * a == pytest.approx(one.masses[1] * b, rel=1e-12)
        if not math.isnan(one.dynamic[2]):
            assert sum(one.dynamic) == pytest.approx(one.mass, rel=1e-12)
            assert one.dynamic[0] * a == pytest.approx(one.dynamic[1] * b, rel=1e-12)
            inertia = one.dynamic[0] * a**2 + one.dynamic[1] * b**2
            assert inertia == pytest.approx(one.inertia, rel=1e-12)


def test_substituted_masses_shake_as_the_links_do():
    """Of the compressor, whose mass centres lie on their rods: m_B a_B, m_D a_D and m_A a_A alone."""
    found = balanced("compressor", part=0.0)
    motion = found.kinematics.table
    of = found.substituted
    on_pin = of.carried["1"]["A"].mass
    force = -on_pin * motion.acceleration("A")
    force = force - of.sliding["3"] * motion.acceleration("B") - of.sliding["5"] * motion.acceleration("D")
    assert np.allclose(force, found.original.table.force, rtol=0, atol=1e-10 * np.abs(force).max())
    whole = sum(link.mass for link in found.kinematics.linkage.mechanism.links.values())
    assert on_pin + sum(of.sliding.values()) == pytest.approx(whole, rel=1e-12)


def test_static_balance_of_a_four_bar_with_its_centres_in_line_is_full():
    lever = read("crank_rocker").lever
    rod = lever.mechanism.links["2"]
    straight = replace(rod, points={**rod.points, "S2": 0.1 + 0j})
    mechanism = replace(lever.mechanism, links={**lever.mechanism.links, "2": straight})
    kinematics = course.solve_lever(replace(lever, mechanism=mechanism, readings={})).kinematics
    weights = {link: Counterweight(distance=0.05) for link in "13"}
    found = solve(Given(("substituted",), weights), Moving(kinematics, None))
    assert found.complete(case(found, "substituted"))


def test_part_of_the_reciprocating_mass_is_met_on_the_crank():
    """m_A r + k m_B r, from nothing to all of it."""
    moments = [
        abs(case(balanced("slider_crank_offset", part=k), "substituted").placed[0].moment)
        for k in (0.0, 0.4, 1.0)
    ]
    found = balanced("slider_crank_offset")
    reciprocating = found.substituted.sliding["3"] * 0.06
    assert moments[1] - moments[0] == pytest.approx(0.4 * reciprocating, rel=1e-12)
    assert moments[2] - moments[0] == pytest.approx(reciprocating, rel=1e-12)


# ---------------------------------------------------------------- one counterweight on the crank


@settings(max_examples=examples(30))
@given(st.sampled_from(["compressor", "crank_rocker", "slider_crank_offset"]), st.floats(0, 2 * math.pi))
def test_no_other_counterweight_on_the_crank_leaves_less(name, angle):
    """Moved a little in any direction it leaves a greater mean square, or a greater maximum."""
    found = balanced(name)
    omega, motion = found.kinematics.omega, found.kinematics.cycle.motion(found.turned)
    for kind, size in (("rms", fourier.mean_square), ("max", lambda force: fourier.greatest(force)[0])):
        best = case(found, f"optimum_{kind}").cycle.force
        moved = 1e-3 * found.circle[1] * np.exp(1j * angle) * omega**2 * motion.turn("1")
        assert size(best + moved) > size(best) * (1 - 1e-9)


def test_least_maximum_is_the_radius_of_the_circle(turning):
    """But for what lies between the samples."""
    left = case(turning, "optimum_max").force_max.value
    assert left == pytest.approx(turning.circle[1] * turning.kinematics.omega**2, rel=1e-6)
    assert left <= case(turning, "optimum_rms").force_max.value * (1 + 1e-6)


def test_rotating_mass_alone_is_met_wholly():
    """A crank with a mass and nothing else heavy: both optima are the counterweight that leaves nothing."""
    lever = read("slider_crank_offset").lever
    light = {
        name: replace(link, mass=0.0, mass_centre=None, inertia=0.0) if name in "23" else link
        for name, link in lever.mechanism.links.items()
    }
    mechanism = replace(lever.mechanism, links=light)
    kinematics = course.solve_lever(replace(lever, mechanism=mechanism, loads=None, readings={})).kinematics
    found = solve(Given(("optimum",), {"1": Counterweight(distance=0.05)}), Moving(kinematics, None))
    for one in found.cases:
        assert found.complete(one)
        assert one.placed[0].mass == pytest.approx(1.2 * 0.02 / 0.05, rel=1e-9)


@settings(max_examples=examples(60))
@given(st.lists(st.complex_numbers(max_magnitude=10, allow_subnormal=False), min_size=2, max_size=40))
def test_smallest_circle_holds_all_points_and_rests_on_two_or_three(points):
    points = np.array(points)
    if np.ptp(points.real) + np.ptp(points.imag) < 1e-6:
        return
    centre, radius, on = smallest_circle(points)
    distances = np.abs(points - centre)
    assert distances.max() <= radius * (1 + 1e-9)
    assert np.allclose(distances[on], radius, rtol=1e-6)
    # those on it do not lie on one side of the centre, or it could be smaller
    angles = np.sort(np.angle(points[on] - centre))
    gaps = np.diff(np.append(angles, angles[0] + 2 * math.pi))
    assert gaps.max() <= math.pi * (1 + 1e-6)


# ---------------------------------------------------------------- stated counterweights and rotors


def test_stated_counterweight_adds_its_centrifugal_force():
    found = balanced("compressor", stated={"1": Existing(2.0, 0.05, math.pi)})
    stated, omega = case(found, "stated"), found.kinematics.omega
    pin = found.kinematics.table.turn("1")
    added_ = stated.table.force - found.original.table.force
    assert np.allclose(added_, -2.0 * 0.05 * omega**2 * pin, rtol=1e-10)
    assert stated.mass == 2.0


def test_rotors_take_the_first_two_orders_and_nothing_else(turning):
    for name, taken in (("rotors_1", (1, -1)), ("rotors_2", (1, -1, 2, -2))):
        before = fourier.turning(turning.original.cycle.force, 6)
        after = fourier.turning(case(turning, name).cycle.force, 6)
        expected = [0.0 if k - 6 in taken else before[k] for k in range(13)]
        assert np.allclose(after, expected, rtol=0, atol=1e-10 * np.abs(before).max())


def test_wheels_and_weights_never_leave_more_of_the_moment(turning):
    """In the mean square, and nothing more of the force; weights add no wheel."""
    geared, coupled = case(turning, "inertia"), case(turning, "couples")
    assert geared.base is not None and coupled.base is geared
    size = turning.original.moment_max.value
    assert geared.moment_rms <= geared.base.moment_rms + 1e-9 * size
    assert coupled.moment_rms <= geared.moment_rms + 1e-9 * size
    assert geared.force_max.value == coupled.force_max.value == geared.base.force_max.value


def test_sense_of_rotation_changes_nothing_but_the_sense():
    lever = read("slider_crank_offset").lever
    other = replace(lever.mechanism.driver, omega=-lever.mechanism.driver.omega)
    found, mirrored = (
        solve(
            Given(
                ("optimum", "rotors"),
                {"1": Counterweight(distance=0.05)},
                rotors={"first": 0.05, "second": 0.05},
            ),
            Moving(course.solve_lever(replace(lever, mechanism=m, readings={}, loads=None)).kinematics, None),
        )
        for m in (lever.mechanism, replace(lever.mechanism, driver=other))
    )
    for one, another in zip(found.every, mirrored.every, strict=True):
        assert one.force_max.value == pytest.approx(another.force_max.value, rel=1e-7)
        assert one.mass == pytest.approx(another.mass, rel=1e-6)
    forward = [abs(c) for c in (found.harmonics[7], mirrored.harmonics[7])]
    assert forward[0] == pytest.approx(forward[1], rel=1e-9)  # with the crank, whichever way it turns


def test_greatest_force_is_found_between_the_samples():
    """Of cos θ + cos 2θ shifted off the samples: 2 at the shift."""
    theta = np.arange(96) * 2 * math.pi / 96 - 0.0123
    value, at = fourier.greatest(np.cos(theta) + np.cos(2 * theta))
    assert value == pytest.approx(2.0, rel=1e-9) and at == pytest.approx(0.0123, abs=1e-5)


def test_counterweight_in_the_motion_is_a_point_of_its_link():
    """Force and moment of a point mass by its own acceleration, found by differences."""
    found = balanced("crank_rocker")
    weight = case(found, "full").placed[0].weight
    h = 1e-4
    motions = [found.kinematics.cycle.motion(found.turned + step) for step in (-h, 0.0, h)]
    links = found.kinematics.linkage.mechanism.links["2"]
    places = [m.place("A") + m.turn("2") * (weight.at - links.points["A"]) for m in motions]
    acceleration = (places[0] - 2 * places[1] + places[2]) / h**2 * found.kinematics.omega**2
    force, moment = added(motions[1], [weight])
    assert np.allclose(force, -weight.mass * acceleration, rtol=0, atol=1e-5 * np.abs(force).max())
    expected = (places[1].conjugate() * force).imag
    assert np.allclose(moment, expected, rtol=0, atol=1e-9 * np.abs(expected).max())
