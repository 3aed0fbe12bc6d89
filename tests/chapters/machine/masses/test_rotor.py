"""Masses on a turning shaft: their balance by sums that close, bearings by Newton and Euler, polygons as drawn."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from conftest import examples, solved
from hypothesis import given, settings
from hypothesis import strategies as st
from notes import render

from tmm_report import course, loading
from tmm_report.chapters.machine.rotor.draw import polygon_picture, scheme
from tmm_report.chapters.machine.rotor.given import Body, Given, Heavy, Plane, Products, Steps
from tmm_report.chapters.machine.rotor.quantities import tables, values
from tmm_report.chapters.machine.rotor.solve import solve
from tmm_report.figures.drawing import Arrow
from tmm_report.mechanics.masses import rotor
from tmm_report.problems import ProblemError
from tmm_report.quantity.model import Book

TWO = (Plane(0.1, radius=0.1), Plane(0.5, radius=0.2))


def heavy(name="1", product=0.02, angle=0.3, at=0.3, **more):
    """A mass; with a `couple`, kg m², a body set askew."""
    if "couple" in more:
        couple = more["couple"]
        products = Products(couple.real, couple.imag)
        return Body(name=name, mass=1.0, eccentricity=product, angle=angle, at=at, products=products)
    return Heavy(name=name, unbalance=product, angle=angle, at=at, **more)


def of(*shaft, planes=TWO, **more):
    bodies = [one for one in shaft if one.is_body]
    return solve(
        Given(masses=[one for one in shaft if not one.is_body], bodies=bodies, planes=[*planes], **more), None
    )


# --- balance


def test_one_mass_in_the_plane_of_correction_is_balanced_by_its_mirror_image():
    found = of(heavy(product=0.03, angle=0.5, at=0.1, mass=0.3, radius=0.1))
    first, second = found.corrections
    assert first.product == pytest.approx(-0.03 * np.exp(0.5j))
    assert (first.mass, first.radius) == pytest.approx((0.3, 0.1))
    assert first.angle == pytest.approx(0.5 + np.pi)
    assert second.mass == pytest.approx(0.0, abs=1e-15)


def test_one_mass_between_the_planes_is_shared_by_the_lever_rule():
    found = of(heavy(product=1.0, angle=0.0, at=0.2))
    assert [one.product.real for one in found.corrections] == pytest.approx([-0.75, -0.25])


MASSES = st.lists(
    st.tuples(
        st.floats(0, 0.1), st.floats(0, 6.3), st.floats(-1, 1), st.floats(-0.01, 0.01), st.floats(-0.01, 0.01)
    ),
    min_size=1,
    max_size=6,
)


@settings(max_examples=examples(60))
@given(MASSES, st.floats(-1, 1), st.floats(0.05, 1))
def test_any_masses_are_balanced_in_any_two_planes_and_bearings_feel_nothing(masses, first, apart):
    stated = [heavy(str(k), D, a, z, couple=complex(x, y)) for k, (D, a, z, x, y) in enumerate(masses)]
    planes = (Plane(first, radius=0.1), Plane(first + apart, radius=0.1))
    found = of(*stated, planes=planes, bearings=(-0.5, 0.7), speed=100.0)
    size = found.size / apart + 1e-12
    assert max(map(abs, found.exact)) < 1e-9 * size
    assert np.abs(found.after).max() < 1e-9 * size
    assert found.uneven < 1e-9 * size / (found.size or 1.0)


def test_one_plane_balances_the_force_and_leaves_the_couple_about_it():
    found = of(heavy(at=0.3), heavy("2", 0.01, 2.0, 0.5), planes=(Plane(0.2, radius=0.1),))
    assert abs(found.exact[0]) < 1e-15
    arms = np.array([0.1, 0.3])
    assert found.exact[1] == pytest.approx(complex(np.dot(found.products, arms)))


def test_the_mass_by_the_distance_and_the_distance_by_the_mass_are_one_product():
    one = of(heavy()).corrections[0]
    other = of(heavy(), planes=(Plane(0.1, mass=one.mass), TWO[1])).corrections[0]
    assert other.radius == pytest.approx(one.radius)
    assert other.product == one.product


def test_taken_off_on_the_opposite_side_is_put_on():
    planes = (replace(TWO[0], remove=True), TWO[1])
    on, off = of(heavy()).corrections[0], of(heavy(), planes=planes).corrections[0]
    assert off.made == pytest.approx(on.made)
    assert abs(off.angle - on.angle) == pytest.approx(np.pi)


@pytest.mark.parametrize(
    ("masses", "kind"),
    [
        ([heavy(angle=1.0), heavy("2", angle=1.0 + np.pi)], "none"),
        ([heavy(at=0.2), heavy("2", 0.05, 0.3, 0.4)], "static"),
        ([heavy(at=0.2), heavy("2", angle=0.3 + np.pi, at=0.4)], "couple"),
        ([heavy(at=0.2), heavy("2", angle=1.0, at=0.4)], "dynamic"),
        ([heavy(couple=0.001j)], "dynamic"),
        ([heavy(product=0.0, couple=0.001 + 0j)], "couple"),
    ],
)
def test_the_kind_of_the_unbalance(masses, kind):
    assert of(*masses).kind == kind


def test_a_static_unbalance_needs_one_weight_in_the_right_plane():
    """Force and couple of a static unbalance are those of one vector at the place M/D."""
    found = of(heavy(at=0.2), heavy("2", 0.05, 0.3, 0.4))
    place = (found.moment / found.resultant).real + TWO[0].at
    alone = of(*found.given.heavy, planes=(Plane(place, radius=0.1),))
    assert max(map(abs, alone.exact)) < 1e-15


# --- bearings


def test_bearings_by_newton_and_euler_in_space():
    """Mass points and a disc set askew: −Σ m a, and for the disc −ω × Jω with its tensor turned by the tilt."""
    omega, tilt, towards, axial, across = 120.0, 0.2, 0.7, 0.03, 0.02
    points = [heavy("1", 0.02, 0.4, -0.1), heavy("2", 0.03, 2.5, 0.45)]
    disc = heavy("3", 0.0, 0.0, 0.25, couple=rotor.tilted(axial, across, tilt, towards))
    found = of(*points, disc, bearings=(0.05, 0.6), speed=omega)
    force, moment = np.zeros(3), np.zeros(3)  # of the unbalances about bearing A
    for one in points:
        pull = omega**2 * one.product * np.array([np.cos(one.angle), np.sin(one.angle), 0.0])
        force += pull
        moment += np.cross([0.0, 0.0, one.at - 0.05], pull)
    axis = np.array([np.sin(tilt) * np.cos(towards), np.sin(tilt) * np.sin(towards), np.cos(tilt)])
    tensor = across * np.eye(3) + (axial - across) * np.outer(axis, axis)
    spin = np.array([0.0, 0.0, omega])
    moment -= np.cross(spin, tensor @ spin)
    second = np.array([moment[1], -moment[0], 0.0]) / 0.55  # ẑ L × R = moment
    expected = [force - second, second]
    for felt, vector in zip(found.before * omega**2, expected, strict=True):
        assert [felt.real, felt.imag] == pytest.approx(vector[:2])
    assert found.disagreement < 1e-14


def test_a_rod_set_askew_has_the_products_of_inertia_of_its_points():
    length, mass, tilt, towards = 0.4, 2.0, 0.3, 1.1
    along = np.linspace(-length / 2, length / 2, 20001)
    x = along * np.sin(tilt) * np.exp(1j * towards)
    summed = mass * np.mean(x * along * np.cos(tilt))
    assert rotor.tilted(0.0, mass * length**2 / 12, tilt, towards) == pytest.approx(summed, rel=1e-3)


# --- as made, and what is permitted


def test_what_rounded_weights_leave_is_within_half_their_steps():
    steps = Steps(mass=0.01, radius=0.0, angle=np.radians(1.0))
    found = of(heavy(), heavy("2", 0.05, 2.2, 0.4), bearings=(0.0, 0.6), speed=50.0, steps=steps)
    for one in found.corrections:
        assert (
            abs(one.made - one.product)
            <= 0.005 * one.radius + one.mass * one.radius * np.radians(0.5) + 1e-12
        )
    assert 0 < abs(found.left[0]) == pytest.approx(abs(sum(found.made)))


def test_the_grade_limits_eccentricity_times_speed():
    stated = {"bearings": (0.0, 1.0), "grade": 6.3, "speed": 100 * np.pi, "mass": 100.0}
    found = of(heavy(), centre=0.4, **stated)
    assert found.s.get("D_per") == pytest.approx(100 * 6.3e-3 / (100 * np.pi))
    assert found.permitted == pytest.approx(found.s.get("D_per") * np.array([0.6, 0.4]))
    assert of(heavy(), centre=0.05, **stated).permitted == pytest.approx(
        found.s.get("D_per") * np.array([0.7, 0.3])
    )


@pytest.mark.parametrize(("ratio", "rpm"), [(0.1, 1000), (0.5, 150), (2.0, 150), (2.5, 100)])
def test_one_plane_suffices_for_slow_and_for_thin_rotors(ratio, rpm):
    assert rotor.one_plane_up_to(ratio) == pytest.approx(rpm * np.pi / 30)


# --- polygons


def test_the_polygons_of_the_ready_variant_close_and_give_the_products_to_what_can_be_read():
    found = solved("rotor").rotor
    table = Book.of(tables(found)).tables["rotor_comparison"]
    assert np.abs(table["delta"].values).max() < 1.0
    for drawn in (found.force, found.couple):
        assert abs(drawn.corners[-1] + drawn.closing) < 0.1 + 1e-3 * abs(drawn.closing)


def test_every_vector_of_the_drawn_polygons_has_its_length_and_direction():
    found = solved("rotor").rotor
    arrows = {
        item.of: item for item in polygon_picture(found.couple, "M", "").items if isinstance(item, Arrow)
    }
    for name, moment in zip(found.given.names, found.moments, strict=True):
        arrow = arrows[f"M_{name}"]
        assert (arrow.end - arrow.start) * found.couple.scale == pytest.approx(
            moment, abs=0.06 * found.couple.scale
        )
    arrows = {
        item.of: item for item in polygon_picture(found.force, "D", "").items if isinstance(item, Arrow)
    }
    for one in found.corrections:
        arrow = arrows[f"D_{one.name}"]
        assert (arrow.end - arrow.start) * found.force.scale == pytest.approx(
            one.product, abs=0.4 * found.force.scale
        )


def test_values_of_the_ready_variant_are_sums_of_its_table():
    found = solved("rotor").rotor
    book = Book.of(tables(found), values(found))
    masses = book.tables["rotor_masses"]
    D, alpha = np.array(masses["D"].values), np.radians(masses["alpha"].values)
    assert book["rotor_D_x"].value == pytest.approx(np.sum(D * np.cos(alpha)))
    turned = D * np.exp(1j * alpha) * masses["l"].values
    couples = (
        np.array(masses["J_xz"].values) + 1j * np.array(masses["J_yz"].values) if "J_xz" in masses else 0.0
    )
    assert book["rotor_M"].value == pytest.approx(abs(np.sum(turned + couples)))


# --- mistakes

GOOD = "masses: [{mass: 1 kg, radius: 10 mm, angle: 0, at: 0}], planes: [{at: 0, radius: 50 mm}]"


def wrong(text):
    with pytest.raises(ProblemError) as error:
        course.solve(loading.loads(f"rotor: {{{text}}}"))
    return str(error.value)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("planes: [{at: 0, radius: 50 mm}]", "neither masses nor bodies"),
        (GOOD.replace("radius: 50 mm", ""), "states the radius of its weight or its mass"),
        (
            GOOD.replace("radius: 50 mm", "radius: 50 mm, mass: 1 kg"),
            "states the radius of its weight or its mass",
        ),
        (GOOD.replace("radius: 10 mm, ", ""), "needs its mass and its radius"),
        (GOOD.replace("}], planes: [", "}], planes: [{at: 0, radius: 9 mm}, "), "balance no couple"),
        (GOOD + ", bearings: [0, 0]", "cannot hold a couple"),
        (GOOD + ", grade: 6.3", "the speed is needed"),
        (GOOD + ", speed: 100 rpm, grade: -1", "must be greater than zero"),
        (GOOD + ", width: 10 mm", "the width and the diameter together"),
        (GOOD.replace("mass: 1 kg, radius: 10 mm", "unbalance: 3 N*m"), "does not measure what is asked"),
        (GOOD.replace("mass: 1 kg, radius: 10 mm", "unbalance: -3 g*mm"), "turn its angle by 180 deg"),
        (
            GOOD + ", bodies: [{mass: 1 kg, tilt: {angle: 95 deg, towards: 0, axial: 1, across: 1}}]",
            "cannot lean by 90",
        ),
        (
            GOOD + ", bodies: [{mass: 1 kg, tilt: {angle: 1 deg, towards: 0, axial: 3, across: 1}}]",
            "above twice",
        ),
        (GOOD + ", bodies: [{name: 1, mass: 1 kg}]", "two masses are named 1"),
    ],
)
def test_a_mistake_is_told(text, said):
    assert said in wrong(text)


def test_unbalance_may_be_stated_in_any_units():
    text = GOOD.replace("mass: 1 kg, radius: 10 mm", "unbalance: 250 g*mm")
    found = course.solve(loading.loads(f"rotor: {{{text}}}")).rotor
    assert found.products[0] == pytest.approx(250e-6)


def test_a_rotor_in_balance_is_solved_too():
    found = course.solve(
        loading.loads(f"rotor: {{{GOOD.replace('radius: 10 mm', 'radius: 0')}, bearings: [0, 1]}}")
    ).rotor
    assert found.kind == "none" and found.corrections[0].mass == 0.0 and found.uneven == 0.0


# --- what is nothing, what is left, what hangs over


def test_opposite_masses_leave_no_crumbs_of_rounding():
    """0.06 cos 180° is not −0.06 to the last digit: what is left of it is nothing, and has no direction."""
    found = of(
        heavy(angle=0.0), heavy("2", angle=np.pi), bearings=(0.0, 0.6), speed=100.0, steps=Steps(mass=0.001)
    )
    assert found.resultant == 0 and found.moment == 0
    assert [one.product for one in found.corrections] == [0, 0]
    assert np.all(found.before == 0) and np.all(found.made == 0)
    table = Book.of(tables(found)).tables["rotor_corrections"]
    for key in ("alpha", "beta", "beta_made"):
        assert np.isnan(table[key].values).all()
    assert len(list(found.summary())) == 1  # no weights of nothing are told


def test_a_plane_that_needs_no_weight_is_drawn_without_one():
    found = of(heavy(at=0.1))
    assert found.corrections[1].product == 0
    squares = [item for item in scheme(found).items if getattr(item, "fill", "") == "blue"]
    assert len(squares) == 2  # that of plane I, from the side and from the end


def test_the_mass_of_the_rotor_is_not_that_of_single_masses_on_it():
    """12 g on an armature do not make its mass centre 50 mm off: how heavy it is must be stated."""
    assert of(heavy(mass=0.012, radius=0.05)).s.get("mass") is None
    assert of(heavy(mass=0.012, radius=0.05)).centre is None
    disc = Body(name="2", mass=9.0, at=0.5)
    found = of(heavy(mass=1.0, radius=0.02), disc)
    assert found.s.number("mass") == 10.0 and found.centre == pytest.approx(0.48)
    assert of(heavy(), mass=7.0).s.number("mass") == 7.0


@pytest.mark.parametrize(
    ("centre", "shares"),
    [(-0.2, (1.2, 0.3)), (-0.5, (1.3, 0.5)), (1.2, (0.3, 1.2)), (0.9, (0.3, 0.7)), (0.5, (0.5, 0.5))],
)
def test_an_overhanging_mass_centre_is_shared_to_1_3(centre, shares):
    """ISO 21940-11, 6.2.3 and 6.2.4: by the distances from the other bearing, 0.3 … 0.7 between, 0.3 … 1.3 beyond."""
    for places in ((0.0, 1.0), (3.0, 3.0 - 1.0)):
        at = places[0] + centre * (places[1] - places[0])
        assert rotor.permitted(2.0, np.array(places), at) == pytest.approx(2 * np.array(shares))
        assert rotor.overhung(np.array(places), at) == (not 0 <= centre <= 1)


def said(text):
    return render(course.solve(loading.loads(f"language: en\nrotor: {{{text}}}")), "html")[
        "note.html"
    ].decode()


LIMIT = "speed: 500 rpm, mass: 120 kg, centre: 300 mm, bearings: [0, 600 mm], grade: 6.3"
HEAVY_DISC = "masses: [{unbalance: 0.3 kg*m, angle: 77 deg, at: 300 mm}]"


@pytest.mark.parametrize(
    ("plane", "steps", "sentence"),
    [
        (300, "1 g", "both bearings stay within what is permitted"),
        (300, "0.2 kg", "the weights must be made more finely"),
        (100, "1 g", "two planes are needed"),
    ],
)
def test_why_a_bearing_carries_too_much(plane, steps, sentence):
    """0.75 kg at 400 mm; made to 0.2 kg it leaves 0.02 kg·m where 0.0144 are permitted."""
    text = said(
        f"{HEAVY_DISC}, {LIMIT}, planes: [{{at: {plane} mm, radius: 400 mm}}], steps: {{mass: {steps}}}"
    )
    assert sentence in text


def test_one_plane_says_what_it_leaves():
    pair = "masses: [{unbalance: 0.1, angle: 0, at: 0}, {unbalance: 0.1, angle: 180 deg, at: 0.5}], diameter: 1, "
    text = said(pair + "width: 0.1, speed: 10 rpm, planes: [{at: 0, radius: 0.1}]")
    assert text.count("about it stays") == 2  # in the chapter and in the conclusions
    assert "suffices" not in text and "is balanced in plane I by the weight" not in text
    text = said(f"{HEAVY_DISC}, planes: [{{at: 300 mm, radius: 0.1}}]")
    assert "about it stays" not in text and "is balanced in plane I by the weight" in text


@pytest.mark.parametrize(
    ("text", "path"),
    [
        (GOOD.replace("angle: 0", "angle: 3 kg"), "rotor.masses.0.angle"),
        (GOOD.replace("mass: 1 kg, radius: 10 mm", "unbalance: 1e13"), "rotor.masses.0.unbalance"),
        (GOOD.replace("mass: 1 kg", "mass: 1 m") + ", grade: 3, speed: 1", "rotor.masses.0.mass"),
        (GOOD + ", grade: 6.3, mass: 3 kg, speed: -5 rpm", "rotor.speed"),
        (GOOD + ", grade: 6.3, mass: -3 kg, speed: 5 rpm", "rotor.mass"),
        (GOOD + ", width: 10 mm, diameter: 3 kg", "rotor.diameter"),
        (GOOD.replace("radius: 50 mm", "radius: 50 s"), "rotor.planes.0.radius"),
        (GOOD + ", steps: {angle: -1 deg}", "rotor.steps.angle"),
    ],
)
def test_one_mistake_is_told_once(text, path):
    """What is wrong in itself is not told again as missing."""
    with pytest.raises(ProblemError) as error:
        loading.loads(f"rotor: {{{text}}}")
    assert [".".join(map(str, problem.path)) for problem in error.value.problems] == [path]


def test_a_grade_needs_the_mass_of_the_rotor():
    assert "needs the mass of the whole rotor" in wrong(GOOD + ", grade: 6.3, speed: 300 rpm")
