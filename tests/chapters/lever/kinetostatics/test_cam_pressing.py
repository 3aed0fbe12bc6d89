"""How hard a cam presses its follower, and shocks of its law, by hand and by limit cases."""

from functools import cache

import numpy as np
import pytest

from tmm_report import course, loading
from tmm_report.chapters.lever.kinetostatics.quantities import positions as quantities
from tmm_report.problems import ProblemError

SPEED = 30.0


@cache
def valve(
    law: str = "cosine",
    roller: str = "roller: {at: B, radius: 8 mm}",
    mass: str = "0.5 kg",
    more: str = "",
    sense: str = "counter-clockwise",
    rise: float = 97.0,
):
    """A follower on a vertical guide, offset from the cam's axis, under its weight and what is more."""
    return course.solve(
        loading.loads(f"""
mechanism:
  frame: {{O: [0, 0], G: [6 mm, 0]}}
  guides: {{y: {{through: G, angle: 90 deg}}}}
  links: {{1: {{points: {{O: 0}}}}, 2: {{points: {{B: 0}}, slides: y, mass: {mass}, mass_centre: B}}}}
  driver: {{link: 1, speed: {SPEED} rad/s, rotation: {sense}, zero: {{angle: 10 deg}}}}
  cams: {{k: {{follower: 2, {roller}, base: 60 mm, lift: 12 mm, phases: [{{rise: {rise} deg, law: {law}}},
    {{dwell: 33 deg}}, {{return: 80 deg, law: {law}}}, {{dwell: {247 - rise} deg}}]}}}}
loads: {{gravity: 9.81 m/s^2{more}}}
positions: {{table: 12, diagram: 72, plans: [1], force_plan: 1}}
""")
    ).lever


@pytest.mark.parametrize("sense", ["counter-clockwise", "clockwise"])
@pytest.mark.parametrize("roller", ["roller: {at: B, radius: 8 mm}", "flat: {at: B}"])
def test_along_the_normal_the_follower_has_what_its_weight_and_acceleration_take(roller, sense):
    """One mass on a guide without friction: N cos α = m(g + S''ω²), by hand."""
    lever = valve(roller=roller, sense=sense)
    (one,), (found,) = lever.kinetostatics.pressings, lever.cams.cams
    for pressed, lifted in ((one.table, found.table), (one.diagram, found.diagram)):
        wanted = 0.5 * (9.81 + lifted.second * SPEED**2) / np.cos(lifted.alpha)
        assert np.allclose(pressed, wanted, rtol=1e-9)


def test_a_fast_cam_throws_its_follower_off_and_its_closure_is_told():
    (one,) = valve().kinetostatics.pressings
    (found,) = valve().cams.cams
    fine = found.at(np.linspace(0.0, 2 * np.pi, 100001))
    deepest = np.min(0.5 * (9.81 + fine.second * SPEED**2) / np.cos(fine.alpha))
    assert one.parts and one.closure == pytest.approx(-deepest, rel=1e-7)
    assert (
        130.0 < np.degrees(one.least.turned) < 132.0
    )  # a little after the return begins: the normal leans more
    assert one.parting == [3, 5]
    # a cosine law presses while g + S''ω² > 0: cos πτ = −2gβ²/(π² h ω²) in the rise
    beta = np.radians(97.0)
    tau = np.arccos(-2 * 9.81 * beta**2 / (np.pi**2 * 0.012 * SPEED**2)) / np.pi
    assert np.degrees(one.zones[0]) == pytest.approx([97.0 * tau, 97.0], abs=1e-6)
    assert all(np.all(np.diff(zone) > 0) for zone in one.zones) and len(one.zones) == 2


def test_a_spring_that_is_strong_enough_closes_the_pair():
    force = ", forces: [{name: spring, at: B, direction: down, constant: 60 N}]"
    (one,) = valve(more=force).kinetostatics.pressings
    assert not one.parts and one.closure == 0.0 and one.zones == () and one.parting == []
    assert one.least.value > 0


@pytest.mark.exhaustive
def test_the_least_and_the_greatest_bound_all_positions():
    for law in ("parabolic", "sine", "polynomial"):
        (one,) = valve(law).kinetostatics.pressings
        for values in (one.table, one.diagram):
            assert one.least.value - 1e-9 <= values.min() and values.max() <= one.greatest.value + 1e-9


def test_nothing_presses_where_nothing_weighs():
    (one,) = valve(mass="0 kg").kinetostatics.pressings
    assert not one.parts and one.closure == 0.0 and np.allclose(one.table, 0.0)


def test_results_tell_the_reaction_and_the_angles_at_which_they_part():
    lever = valve()
    (one,), book = lever.kinetostatics.pressings, quantities.book(lever.kinetostatics)
    told = np.asarray(book.tables["cam_press_table"]["cam_press_k"].values)
    assert np.allclose(told, one.table) and told[0] > 0 > told[3]
    assert np.allclose(np.abs(told), book.tables["reactions_table"]["R_2k"].values)
    zones = book.tables["cam_parting_k"]
    ends = np.array([zones["from"].values, zones["to"].values]).T
    assert np.allclose(np.radians(ends), one.zones)
    assert book["cam_closure_k"].value == one.closure == -book["cam_press_min_k"].value


# ---------------------------------------------------------------- shocks


def test_a_cosine_law_jumps_at_both_ends_by_its_greatest_acceleration():
    (found,) = valve("cosine").cams.cams
    rise, back = (np.pi**2 / 2 * 0.012 / np.radians(angle) ** 2 for angle in (97.0, 80.0))
    assert np.degrees([shock.turned for shock in found.shocks]) == pytest.approx([0.0, 97.0, 130.0, 210.0])
    assert [shock.second for shock in found.shocks] == pytest.approx([rise, rise, -back, -back], rel=1e-6)
    assert not any(shock.hard for shock in found.shocks)


def test_a_parabolic_law_jumps_in_the_middle_too_twice_as_far():
    (found,) = valve("parabolic").cams.cams
    rise = 4 * 0.012 / np.radians(97.0) ** 2
    assert [shock.second for shock in found.shocks[:3]] == pytest.approx([rise, -2 * rise, rise])
    assert len(found.shocks) == 6


def test_a_uniform_law_has_hard_shocks_only():
    (found,) = valve("uniform").cams.cams
    rise, back = (0.012 / np.radians(angle) for angle in (97.0, 80.0))
    assert [shock.first for shock in found.shocks] == pytest.approx([rise, -rise, -back, back])
    assert all(shock.hard for shock in found.shocks)


def test_sine_and_polynomial_have_none():
    assert valve("sine").cams.cams[0].shocks == () == valve("polynomial").cams.cams[0].shocks


def test_extremes_of_the_law_are_the_published_ones_between_the_positions_too():
    (found,) = valve("sine").cams.cams
    h, beta, back = 0.012, np.radians(97.0), np.radians(80.0)
    S, first, second = ([end.value for end in ends] for ends in found.ends)
    assert S[0] == pytest.approx(0.0, abs=1e-12) and S[1] == pytest.approx(h)
    assert first == pytest.approx([-2 * h / back, 2 * h / beta], rel=1e-9)
    assert second == pytest.approx([-2 * np.pi * h / back**2, 2 * np.pi * h / back**2], rel=1e-9)


def test_an_extreme_at_the_end_of_a_phase_is_that_of_its_own_side():
    """The end of a phase is between the angles that are searched: the acceleration there is the law's greatest."""
    (found,) = valve("cosine", rise=97.13).cams.cams
    largest = np.pi**2 / 2 * 0.012 / np.radians(80.0) ** 2
    low, high = found.ends[2]
    assert (low.value, high.value) == pytest.approx((-largest, largest), rel=1e-9)
    assert np.degrees([low.turned, high.turned]) == pytest.approx([130.13, 210.13], abs=1e-6)


def test_drawn_curves_hold_all_diagram_positions_and_both_sides_of_a_jump():
    (found,) = valve("parabolic").cams.cams
    drawn, known = found.drawn, found.diagram
    near = np.abs(drawn.turned[:, None] - known.turned).argmin(axis=0)
    assert np.allclose(drawn.turned[near], known.turned) and np.allclose(drawn.second[near], known.second)
    steps = np.abs(np.diff(drawn.second)) > 1e-3 * found.ends[2][1].value
    assert np.all(np.diff(drawn.turned)[steps] < 1e-3)


def test_a_table_that_dips_below_its_base_circle_says_so():
    steep = "[0 deg, 0 mm], [45 deg, 0 mm], [90 deg, 9 mm], [135 deg, 9 mm], [180 deg, 9 mm], [225 deg, 0 mm]"
    more = "lifts: [" + steep + ", [270 deg, 0 mm], [315 deg, 0 mm]]"
    (found,) = tabled(more).lever.cams.cams
    assert found.below and found.ends[0][0].value < -1e-4
    smooth = ", ".join(f"[{x} deg, {8 - 8 * np.cos(np.radians(x)):.6f} mm]" for x in range(0, 360, 15))
    assert not tabled(f"lifts: [{smooth}]").lever.cams.cams[0].below


def tabled(law: str, more: str = ""):
    return course.solve(
        loading.loads(f"""
mechanism:
  frame: {{O: [0, 0]}}
  guides: {{y: {{through: O, angle: 90 deg}}}}
  links: {{1: {{points: {{O: 0}}}}, 2: {{points: {{B: 0}}, slides: y, mass: 1 kg, mass_centre: B}}}}
  driver: {{link: 1, speed: 10 rad/s, zero: {{angle: 0 deg}}}}
  cams: {{k: {{follower: 2, roller: {{at: B, radius: 8 mm}}, base: 60 mm, {law}}}}}
positions: {{table: 12, diagram: 36, plans: [1]}}
{more}
""")
    )


COSINE = "lift: 9 mm, phases: [{rise: 90 deg, law: cosine}, {return: 90 deg, law: cosine}, {dwell: 180 deg}]"


def test_harmonics_are_those_of_the_follower_and_not_of_the_centre_of_curvature_that_jumps():
    found = tabled(COSINE, "harmonics: {highest: 4, points: [B], links: []}")
    assert found.harmonics.s.number("tail") < 1e-4


def test_balancing_needs_an_acceleration_that_does_not_jump():
    with pytest.raises(ProblemError) as raised:
        tabled(COSINE, "balancing: {methods: [optimum], counterweights: {1: {distance: 60 mm}}}")
    assert "acceleration of the cam's follower jumps" in raised.value.problems[0].wrong.text
