"""Reduced mass and force of a link that slides: closed forms, energy and power, derivative, force analysis."""

from dataclasses import replace

import numpy as np
import pytest
import yaml
from conftest import solved, stating
from notes import VARIANTS

from tmm_report import course, loading
from tmm_report.chapters.lever.kinematics.given import Positions
from tmm_report.chapters.lever.kinetostatics.solve.positions import external_power, kinetic_energy
from tmm_report.problems import ProblemError

STATEMENTS = VARIANTS.parent / "tests" / "statements"
DRIVEN = ("slider_drives", "tipper_by_cylinder")
CRANK = """
mechanism:
  frame: {O: [0, 0]}
  guides: {x: {through: O, angle: 0 deg}}
  links:
    1: {points: {O: 0, A: 0.1 m}, inertia: 0.05 kg*m^2}
    2: {points: {A: 0, B: 0.35 m}}
    3: {points: [B], slides: x, mass: 4 kg}
  driver: {link: 1, speed: 20 rad/s, zero: {angle: 10 deg}}
  assembly: {B: right}
loads:
  gravity: 0 m/s^2
  forces:
    - {at: B, direction: left, constant: 800 N}
positions: {table: 12, diagram: 720}
reduction: {link: 3}
"""


def statement(name: str, more: str = "reduction: true") -> course.LeverFound:
    text = STATEMENTS.joinpath(f"{name}.yaml").read_text("utf-8")
    return course.solve(loading.loads(f"{text}\n{more}\n")).lever


@pytest.fixture(
    params=[
        "piston_pump 5",
        "compressor 3",
        "shaper 5",
        "shaper 2",
        "whitworth 5",
        *DRIVEN,
        "rack_on_slider 3",
    ]
)
def reduced(request) -> course.LeverFound:
    """Cranks that move sliders, a block in a link that turns, a rack, a driving slider and a driving cylinder."""
    name, _, link = request.param.partition(" ")
    if STATEMENTS.joinpath(f"{name}.yaml").exists():
        return statement(name, f"reduction: {{link: {link}}}" if link else "reduction: true")
    variant = solved(name).variant
    return course.solve_lever(stating(variant, translation=link, reduction=True, readings={}).lever)


def test_by_the_closed_form_of_a_slider_crank():
    """m = m_3 + J/(ds/dφ)², and its derivative by its own formula."""
    found = course.solve(loading.loads(CRANK)).lever.translation
    r, l, J, m3, omega = 0.1, 0.35, 0.05, 4.0, 20.0
    phi = np.radians(10) + found.table.turned
    root = np.sqrt(l**2 - (r * np.sin(phi)) ** 2)
    s = r * np.cos(phi) + root
    u = -r * np.sin(phi) - r**2 * np.sin(phi) * np.cos(phi) / root
    du = -r * np.cos(phi) - r**2 * np.cos(2 * phi) / root - r**4 * (np.sin(phi) * np.cos(phi)) ** 2 / root**3
    assert found.table.s == pytest.approx(s, rel=1e-12)
    assert found.table.v == pytest.approx(u * omega, rel=1e-10)
    assert found.table.a == pytest.approx(du * omega**2, rel=1e-9)
    assert found.table.whole_mass == pytest.approx(m3 + J / u**2, rel=1e-10)
    assert found.table.slope == pytest.approx(-2 * J * du / u**4, rel=1e-9)
    assert found.table.whole_force == pytest.approx(np.full(13, -800.0), rel=1e-12)
    # the crank turns uniformly, so that what drives moves the slider alone
    assert found.table.needed == pytest.approx(m3 * du * omega**2 + 800, rel=1e-9)


def test_energy_of_the_links_is_that_of_the_reduced_mass(reduced):
    ours = reduced.translation.table
    energy = kinetic_energy(reduced.kinematics.table)
    known = np.isfinite(ours.whole_mass)
    assert known.sum() >= len(known) - 3
    assert (ours.whole_mass * ours.v**2 / 2)[known] == pytest.approx(
        energy[known], rel=1e-9, abs=1e-12 * energy.max()
    )


def test_it_is_the_energy_of_the_reduced_disc(reduced):
    if reduced.reduction is None:
        return
    ours, disc, omega = reduced.translation.table, reduced.reduction.table, reduced.kinematics.omega
    known = np.isfinite(ours.whole_mass)
    assert (ours.whole_mass * ours.v**2)[known] == pytest.approx(
        (disc.whole_inertia * omega**2)[known], rel=1e-9
    )
    assert (ours.whole_force * ours.v)[known] == pytest.approx(
        (disc.whole_moment * omega)[known],
        rel=1e-9,
        abs=1e-9 * np.nanmax(np.abs(disc.whole_moment * omega), initial=0),
    )


def test_power_of_the_loads_is_that_of_the_reduced_force(reduced):
    forces, ours = reduced.kinetostatics, reduced.translation.table
    if forces is None:
        return
    power = external_power(forces.given, forces.table.motion, forces.table.loading)
    known = np.isfinite(ours.whole_mass)
    scale = np.nanmax(np.abs(power))
    assert (ours.whole_force * ours.v)[known] == pytest.approx(power[known], rel=1e-9, abs=1e-9 * scale)


def test_the_driving_force_has_the_power_of_the_balancing_moment(reduced):
    """Reactions, joint by joint, share no formula with the reduced mass."""
    forces, ours = reduced.kinetostatics, reduced.translation.table
    if forces is None:
        return
    assert reduced.translation.disagreement < 1e-9
    motion = forces.table.motion
    power = forces.table.balancing * motion.state.w[motion.linkage.mechanism.driver.link]
    known = np.isfinite(ours.whole_mass)
    assert (ours.needed * ours.v)[known] == pytest.approx(
        power[known], rel=1e-8, abs=1e-9 * np.nanmax(np.abs(power))
    )


@pytest.mark.parametrize("name", ["piston_pump 5", "shaper 2", *DRIVEN])
def test_slope_is_the_derivative_by_differences(name):
    """By differences of fourth order of the reduced mass and of the stroke, where the link is not slow."""
    name, _, link = name.partition(" ")
    if link:
        given = stating(solved(name).variant, translation=link, readings={}, loads=None, friction=None).lever
    else:
        text = STATEMENTS.joinpath(f"{name}.yaml").read_text("utf-8").split("\nloads:")[0]
        given = loading.loads(text + "\nreduction: true\n").lever
    fine = Positions(table=12, diagram=720, plans=(), force_plan=())
    found = course.solve_lever(replace(given, positions=fine)).translation.diagram

    def by_differences(x):
        return (8 * (x[3:-1] - x[1:-3]) - (x[4:] - x[:-4])) / 12

    with np.errstate(invalid="ignore", divide="ignore"):
        slope = by_differences(found.whole_mass) / by_differences(found.s)
    off = np.abs(slope - found.slope[2:-2])
    smooth = np.isfinite(off)
    assert smooth.sum() > 200
    assert np.nanquantile(off, 0.9) < 2e-5 * np.nanmax(np.abs(found.slope))


def test_parts_add_up(reduced):
    one = reduced.translation.table
    assert np.allclose(sum(one.mass.values()), one.whole_mass, rtol=1e-14, equal_nan=True)
    assert all(np.nanmin(part) >= 0 for part in one.mass.values())


def test_the_rod_of_a_cylinder_moves_along_its_barrel_as_the_stroke_grows():
    """Its guide turns, and the stroke is that along the guide."""
    by_drive = statement("tipper_by_cylinder").translation.table
    by_rod = statement("tipper_by_cylinder", "reduction: {link: 2}").translation.table
    assert by_rod.v == pytest.approx(by_drive.v, rel=1e-12, abs=1e-15)
    assert by_rod.a == pytest.approx(by_drive.a, rel=1e-10, abs=1e-12)
    assert by_rod.whole_mass == pytest.approx(by_drive.whole_mass, rel=1e-11)
    assert by_rod.slope == pytest.approx(by_drive.slope, rel=1e-9)
    assert by_rod.whole_force == pytest.approx(by_drive.whole_force, rel=1e-11)


def test_at_a_dead_point_there_is_no_reduced_mass():
    found = solved("piston_pump")
    found = course.solve_lever(stating(found.variant, translation="5", readings={}).lever).translation
    assert found.still == [0, 12]
    assert np.isnan(found.table.whole_mass[[0, 12]]).all() and np.isnan(found.table.needed[[0, 12]]).all()
    assert np.isfinite(found.table.whole_mass[1:12]).all()


def test_a_stroke_that_starts_from_rest_has_its_reduced_mass_there():
    found = statement("tipper_by_cylinder").translation
    assert found.table.v[0] == 0 and np.isfinite(found.table.whole_mass).all() and not found.still


@pytest.mark.parametrize(
    ("asked", "wrong", "right"),
    [
        ("{link: 1}", "link 1 slides along no guide", "a link that slides: 3"),
        ("{link: 9}", "there is no link 9", "a link that slides: 3"),
    ],
)
def test_a_link_that_does_not_slide_is_told(asked, wrong, right):
    with pytest.raises(ProblemError) as error:
        loading.loads(CRANK.replace("{link: 3}\n", f"{asked}\n"))
    assert [one.path for one in error.value.problems] == [("reduction", "link")]
    told = str(error.value)
    assert wrong in told and right in told


def test_something_else_than_true_or_a_link_is_told():
    with pytest.raises(ProblemError) as error:
        loading.loads(CRANK.replace("{link: 3}\n", "[3]\n"))
    assert "true, or a link that slides along a guide: {link: 5}" in str(error.value)


@pytest.mark.parametrize("name", DRIVEN)
def test_the_force_of_a_driving_slider_and_of_a_cylinder_is_that_of_independent_solvers(name):
    """The answers of the statements come from programs that share no code with this one."""
    answers = yaml.safe_load(STATEMENTS.joinpath(f"{name}.answers.yaml").read_text("utf-8"))["positions"]
    needed = statement(name).translation.table.needed
    asked = {k: one["F_stroke"] for k, one in answers.items() if "F_stroke" in one}
    assert asked and {k: needed[int(k)] for k in asked} == pytest.approx(asked, rel=1e-9)


def test_a_piston_of_an_engine_of_two_turns_and_a_follower_that_dwells():
    """Every position in which the link stands still is left out, and the others hold against the reactions."""
    for name, link, still in (
        ("engine_four_stroke", "3", [0, 6, 12, 18, 24]),
        ("cam_press", "4", [0, 5, 10, 11, 12]),
    ):
        found = course.solve_lever(
            stating(solved(name).variant, translation=link, readings={}, methods=None).lever
        )
        assert found.translation.still == still
        assert found.translation.disagreement < 1e-9
