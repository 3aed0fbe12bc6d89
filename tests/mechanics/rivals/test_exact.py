"""Mechanisms to 40 digits: against closed formulas in as many digits, and against themselves differentiated."""

from __future__ import annotations

from pathlib import Path

import mpmath
import numpy as np
import pytest

from tmm_report import course, loading
from tmm_report.mechanics.gears.trains import Member, Mesh
from tmm_report.mechanics.lever import assur_groups, motion
from tmm_report.mechanics.lever.cycle import Cycle, cycle_of
from tmm_report.mechanics.lever.mechanism import Driver, Guide, Link, Mechanism, Slide
from tmm_report.mechanics.rivals import exact
from tmm_report.mechanics.rivals.exact import forces, gears
from tmm_report.mechanics.rivals.exact.numbers import context, dot, point
from tmm_report.mechanics.rivals.exact.numbers import exact as number
from tmm_report.mechanics.rivals.exact.scheme import Body
from tmm_report.mechanics.rivals.exact.solving import solved

VARIANTS = Path(__file__).parents[3] / "variants"
OWN = mpmath.mp.clone()
OWN.dps = 90
ALL = ("place", "velocity", "acceleration", "angular velocity", "angular acceleration")


def slider_crank(r: float, l: float) -> Cycle:
    points = {"0": {"O": 0j}, "1": {"O": 0j, "A": r + 0j}, "2": {"A": 0j, "B": l + 0j}, "3": {"B": 0j}}
    links = {name: Link(name, places) for name, places in points.items()}
    guides = {"x": Guide("x", "0", 0j, 1 + 0j)}
    built = Mechanism(links, Driver("1", 2.0), guides, [Slide("3", "x", 0j, 1 + 0j)])
    return cycle_of(motion.linkage_of(assur_groups.decompose(built), [1]))


def by_formula(
    r: float, l: float, angle: float, omega: float = 2.0
) -> tuple[mpmath.mpf, mpmath.mpf, mpmath.mpf]:
    """x, v, a of the slider by the textbook's formula in 90 digits."""
    r, l, angle = OWN.mpf(r), OWN.mpf(l), OWN.mpf(angle)
    s, c = OWN.sin(angle), OWN.cos(angle)
    root = OWN.sqrt(l * l - (r * s) ** 2)
    v = -r * s - r * r * s * c / root
    a = -r * c - r * r * (c * c - s * s) / root - r**4 * (s * c) ** 2 / root**3
    return r * c + root, v * omega, a * omega**2


def solved_kinematics(name: str) -> course.LeverFound:
    found = course.solve(loading.load(VARIANTS / f"{name}.yaml")).lever
    assert found is not None
    return found


@pytest.mark.parametrize("ratio", [0.3, 0.9, 0.999, 1 - 1e-9, 1 - 1e-12])
def test_a_slider_crank_has_40_digits_of_the_textbooks_formula_however_near_the_dead_point(
    ratio: float,
) -> None:
    cycle = slider_crank(ratio, 1.0)
    for angle in (0.5, np.pi / 2, 4.0):
        found = exact.at(cycle, angle)
        for of, true in zip(
            (Body.place, Body.velocity, Body.acceleration), by_formula(ratio, 1.0, angle), strict=True
        ):
            value = OWN.mpf(found.row("B", of)[0].real)
            assert abs(value / true - 1) < OWN.mpf(10) ** -38


def test_digits_of_other_users_of_the_library_stay_as_they_are() -> None:
    before = mpmath.mp.prec
    exact.at(slider_crank(0.999999999, 1.0), np.pi / 2)
    assert mpmath.mp.prec == before


def test_where_the_mechanism_does_not_close_there_is_nothing() -> None:
    found = exact.motion(slider_crank(1.5, 1.0), np.array([0.1, np.pi / 2]))
    place = found.pairs["place"].high[found.points.index("B")]
    assert np.isfinite(place[0]) and np.isnan(place[1])


@pytest.mark.exhaustive
def test_in_a_change_point_the_rates_are_the_limit_from_both_sides() -> None:
    links = {
        "0": Link("0", {"O": 0j, "C": 2 + 0j}),
        "1": Link("1", {"O": 0j, "A": 1 + 0j}),
        "2": Link("2", {"A": 0j, "B": 2 + 0j}),
        "3": Link("3", {"C": 0j, "B": 1 + 0j}),
    }
    built = Mechanism(links, Driver("1", 3.0))
    linkage = motion.linkage_of(assur_groups.decompose(built), [1])
    cycle = cycle_of(linkage)
    found = exact.at(cycle, 0.0)  # a parallelogram folded into a line, exactly
    assert found.poses[0] is not None
    assert abs(found.poses[0]["2"].w) < 1e-30  # the coupler goes on without turning
    assert abs(found.poses[0]["3"].w - 3) < 1e-30


@pytest.mark.parametrize("name", ["quick_return", "press", "shaper", "scotch_yoke", "cam_press"])
def test_velocities_and_accelerations_are_the_derivatives_of_exact_places(name: str) -> None:
    found = solved_kinematics(name).kinematics
    angle, omega = float(found.table.phi[4]), number(found.omega)
    there = exact.at(found.cycle, angle)
    start = {link: (body.r, body.u) for link, body in there.poses[0].items()}
    with context().workdps(80):
        h = context().mpf(10) ** -20
        ends = [solved(there.scheme, number(angle) + way * h, start, 60) for way in (-1, 1)]
        for link, body in there.poses[0].items():
            (r0, v0), (r1, v1) = ((end[link].r, end[link].v) for end in ends)
            if link in [cam.name for cam in found.linkage.mechanism.cams]:
                continue  # in every position another link
            assert abs((r1 - r0) / (2 * h) * omega - body.v) < 1e-33 * (1 + abs(body.v))
            assert abs((v1 - v0) / (2 * h) * omega - body.a) < 1e-33 * (1 + abs(body.a))


@pytest.mark.parametrize("name", ["compressor", "quick_return", "whitworth", "cam_press", "elliptic_trammel"])
def test_the_balancing_moment_has_the_power_that_all_loads_and_the_inertia_lack(name: str) -> None:
    from tmm_report.chapters.lever.kinetostatics.solve.acting_exact import acting

    lever = solved_kinematics(name)
    found, given = lever.kinematics, lever.kinetostatics.given
    solution = exact.motion(found.cycle, found.table.phi)
    loads = acting(given, found, found.table, solution, found.turned)
    balances = forces.forces(solution, loads).balances
    links = found.linkage.mechanism.links
    for k in (1, 5, 8):
        pose, power, size = solution.poses[k], 0, 0
        for link, at, values in loads.forces:
            part = dot(values[k], pose[link].velocity(point(links[link].points[at])))
            power, size = power + part, size + abs(part)
        for link, values in loads.moments:
            power += values[k] * pose[link].w
        for link in found.linkage.mechanism.moving:
            body, own = pose[link], links[link]
            power -= number(own.inertia) * body.e * body.w
            if own.mass_centre is not None:
                centre = point(own.points[own.mass_centre])
                force = number(own.mass) * (point(loads.gravity) - body.acceleration(centre))
                power += dot(force, body.velocity(centre))
        assert abs(balances[k].moment * number(found.omega) + power) <= 1e-36 * (1 + size + abs(power))


@pytest.mark.parametrize(
    "name", ["compressor", "whitworth", "engine_four_stroke", "crank_rocker", "parallelogram_drive"]
)
def test_exact_loads_are_those_of_the_program_to_rounding(name: str) -> None:
    from tmm_report.chapters.lever.kinetostatics.solve.acting_exact import acting

    lever = solved_kinematics(name)
    found, own = lever.kinematics, lever.kinetostatics.table.loading
    solution = exact.motion(found.cycle, found.table.phi)
    loads = acting(lever.kinetostatics.given, found, found.table, solution, found.turned)
    stated = [*own.forces, *own.moments]
    assert stated
    for values, numbers in zip(
        stated, [*(x for *_, x in loads.forces), *(x for _, x in loads.moments)], strict=True
    ):
        there = np.array([complex(x) for x in numbers])
        assert np.max(np.abs(there - values)) < 1e-12 * np.max(np.abs(values))


@pytest.mark.parametrize("name", ["crank_rocker", "hacksaw", "v_engine", "slotter", "tangent", "cam_press"])
def test_the_programs_motion_is_the_exact_one_to_rounding(name: str) -> None:
    found = solved_kinematics(name).kinematics
    solution = exact.motion(found.cycle, found.table.phi)
    m = found.table
    own = (
        m.places, m.velocities, m.accelerations,
        np.array([m.angular_velocity(x) for x in solution.links]),
        np.array([m.angular_acceleration(x) for x in solution.links]),
    )  # fmt: skip
    for kind, values in zip(ALL, own, strict=True):
        assert solution.pairs[kind].error(values) < 1e-13
        assert not values.any() or solution.pairs[kind].error(values * (1 + 1e-12)) > 1e-13


def test_high_and_low_halves_hold_32_digits() -> None:
    found = exact.at(slider_crank(0.3, 1.0), 1.0)
    place, k = found.pairs["place"], found.points.index("B")
    whole = OWN.mpf(float(place.high[k, 0].real)) + OWN.mpf(float(place.low[k, 0].real))
    assert abs(whole / by_formula(0.3, 1.0, 1.0)[0] - 1) < 1e-31


@pytest.mark.parametrize("angle", [1e-9, 1e-3, 0.35, 1.2, 1.57])
def test_the_inverse_involute_brings_the_angle_back(angle: float) -> None:
    assert abs(gears.inverse(gears.inv(angle)) / number(angle) - 1) < 1e-40
    assert abs(gears.inverse(-gears.inv(angle)) + gears.inverse(gears.inv(angle))) < 1e-40 * angle


def test_an_unshifted_pair_works_at_the_angle_of_its_rack() -> None:
    a_w = 0.004 * (20 + 50) / 2
    found = gears.pair(gears.External((20, 50), 0.004, np.radians(20), 1.0, 0.25, 0.0, a_w, 0.0))
    assert abs(found["alpha_w"] - number(np.radians(20))) < 1e-15  # a_w is a rounded number
    assert abs(found["x_sum"]) < 1e-14
    eps = sum(np.sqrt((z + 2) ** 2 - (z * np.cos(np.radians(20))) ** 2) for z in (20, 50))
    eps = (eps - 70 * np.sin(np.radians(20))) / (2 * np.pi * np.cos(np.radians(20)))
    assert float(found["eps"]) == pytest.approx(eps, rel=1e-13)


def test_a_planetary_stage_turns_by_willis() -> None:
    members = (
        Member("1", "wheel", 20), Member("2", "satellite", 46, carried_by="H"), Member("3", "ring", 112),
        Member("H", "carrier"),
    )  # fmt: skip
    meshes = (Mesh("1", "2", "H"), Mesh("2", "3", "H", internal=True))
    assert gears.speeds(members, meshes, {"3": 0, "H": 1})["1"] == pytest.approx(1 + 112 / 20)


@pytest.mark.parametrize("apart", [1e-2, 1e-4, 1e-6, 1e-8])
def test_near_a_dead_point_the_program_keeps_the_digits_that_it_states(apart: float) -> None:
    from tmm_report.chapters.lever.kinematics.checks.digits_left import rounding

    cycle = slider_crank(1 - apart, 1.0)
    phi = np.pi / 2 + np.array([-1.0, -0.1, -0.01, -0.001, 0.0, 0.001, 0.5])
    found, solution = motion.solve(cycle.linkage, phi), exact.motion(cycle, phi)
    for kind, own in (("velocity", found.velocities), ("acceleration", found.accelerations)):
        true = solution.pairs[kind]
        largest = np.max(np.abs(true.high), axis=-1, keepdims=True)
        errors = np.abs(own - true.high - true.low) / np.where(largest > 0, largest, 1.0)
        assert (errors <= rounding(found)).all()
        # and they are lost indeed: the exact motion is no start in doubles handed on
        assert apart > 1e-5 or errors.max() > 1e-14
