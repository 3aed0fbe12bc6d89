"""Engines of several cylinders: orders against the exact motion, the textbooks' table of layouts, what balances."""

from __future__ import annotations

import re
from itertools import pairwise

import numpy as np
import pytest
from conftest import examples, solved
from hypothesis import given, settings
from hypothesis import strategies as st
from notes import render

from tmm_report import course, loading
from tmm_report.chapters.machine.engine.draw import scheme, star_picture
from tmm_report.chapters.machine.engine.given import Cylinder, Given, Rod
from tmm_report.chapters.machine.engine.limits import peak, series
from tmm_report.chapters.machine.engine.solve import solve
from tmm_report.mechanics.masses import engine_cylinders
from tmm_report.problems import ProblemError

TURN = 2 * np.pi * np.arange(256) / 256
SIZES = "speed: 955 rpm, crank_radius: 50 mm, rod_length: 200 mm, reciprocating: 2 kg"


def engine(layout: str, more: str = ""):
    return course.solve(loading.loads(f"engine: {{{SIZES}, {layout}{more}}}")).engine


def built(layout, reciprocating, rotating, rod=None):
    """Cylinders by bank, crank and place."""
    cylinders = [Cylinder(str(k), *one) for k, one in enumerate(layout)]
    sizes = {"speed": 100.0, "crank_radius": 0.05, "rod_length": 0.2}
    given_ = Given(cylinders=cylinders, **sizes, reciprocating=reciprocating, rotating=rotating, rod=rod)
    return solve(given_, None)


def derived(values, times=1):
    """Derivative of periodic samples by their Fourier series."""
    orders = np.fft.fftfreq(len(values), 1 / len(values))
    return np.fft.ifft((1j * orders) ** times * np.fft.fft(values))


# --- one cylinder


@pytest.mark.parametrize("lam", [0.1, 0.25, 0.5])
def test_the_exact_acceleration_is_the_second_derivative_of_the_place_of_the_piston(lam):
    place = np.cos(TURN) + np.sqrt(1 / lam**2 - np.sin(TURN) ** 2)
    assert engine_cylinders.acceleration(TURN, lam) == pytest.approx(-derived(place, 2).real, abs=1e-9)


def test_coefficients_are_those_of_the_series_with_their_next_terms():
    lam = 0.1
    exact = engine_cylinders.coefficients(lam, (1, 2, 3, 4, 6))
    higher = [
        1.0,
        lam + lam**3 / 4 + 15 * lam**5 / 128,
        0.0,
        -(lam**3) / 4 - 3 * lam**5 / 16,
        9 * lam**5 / 128,
    ]
    assert exact == pytest.approx(higher, abs=3e-7)
    assert [series(lam)[k] for k in (2, 4, 6)] == pytest.approx(exact[[1, 3, 4]], rel=0.03)


def test_the_rod_is_replaced_with_its_mass_and_its_centre():
    found = built([(0, 0, 0)], 1.0, 0.4, Rod(0.8, 0.06))
    up, down = (found.s.number(key) for key in ("m", "m_rot"))
    assert up + down == pytest.approx(1.0 + 0.4 + 0.8)
    assert (up - 1.0) * 0.2 == pytest.approx(0.8 * 0.06)


# --- direct and reverse cranks

LAYOUT = st.lists(st.tuples(st.floats(-3, 3), st.floats(0, 6), st.floats(-0.5, 0.5)), min_size=1, max_size=8)


@pytest.mark.exhaustive
@settings(max_examples=examples(60))
@given(LAYOUT, st.floats(0.05, 0.4))
def test_the_orders_add_up_to_the_exact_forces_of_any_layout(layout, lam):
    banks, angles, places = np.array(layout).T
    for weights in (np.ones(len(banks)), places):
        exact = engine_cylinders.exact(TURN, lam, banks, angles, weights)
        total = sum(
            c * engine_cylinders.turning(k, banks, angles, weights).at(k, TURN)
            for k, c in zip(range(1, 41), engine_cylinders.coefficients(lam, range(1, 41)), strict=True)
        )
        assert total == pytest.approx(exact, abs=1e-8 * len(banks))


@settings(max_examples=examples(40))
@given(LAYOUT)
def test_the_force_is_what_the_momentum_of_all_masses_loses(layout):
    """Positions of pistons and pins in the plane, differentiated twice; couples by their places."""
    found = built(layout, 2.0, 1.5)
    r, l, turned = 0.05, 0.2, TURN[:, None] + found.angles
    theta = turned - found.banks
    pistons = 1j * np.exp(1j * found.banks) * (r * np.cos(theta) + np.sqrt(l**2 - r**2 * np.sin(theta) ** 2))
    pins = 1j * np.exp(1j * turned) * r
    momentum = 2.0 * pistons + 1.5 * pins
    course_ = found._courses(TURN)["after"]
    for weights, values in ((np.ones(len(layout)), course_.force), (found.places, course_.couple)):
        expected = -(100.0**2) * derived(np.sum(momentum * weights, axis=1), 2)
        assert values == pytest.approx(expected, abs=1e-7 * found.unit * len(layout))


@settings(max_examples=examples(40))
@given(LAYOUT, st.integers(1, 2))
def test_greatest_least_and_direction_are_those_of_the_ellipse(layout, order):
    banks, angles, _ = np.array(layout).T
    turning = engine_cylinders.turning(order, banks, angles, np.ones(len(banks)))
    phi = 2 * np.pi * np.arange(4000) / 4000
    values = turning.at(order, phi)
    assert turning.greatest == pytest.approx(np.abs(values).max(), rel=1e-5, abs=1e-9)
    assert turning.least == pytest.approx(np.abs(values).min(), abs=2e-3 * turning.greatest + 1e-9)
    assert turning.along(1.0) == pytest.approx(np.abs(values.real).max(), rel=1e-5, abs=1e-9)
    if turning.greatest > turning.least + 0.1:
        at = values[np.argmax(np.abs(values))]
        assert abs((at * np.exp(-1j * turning.direction)).imag) < 0.02 * abs(at)


# --- the table of layouts, by m r ω² and, of moments, by m r ω² and the distance of the cylinders (Bevan; Norton)

P, A = 1.0, 0.1
ROOT3 = np.sqrt(3.0)
LAYOUTS = {
    "inline: {cranks: [0]}": (1, 1, 0, 0),
    "inline: {cranks: [0, 180 deg], spacing: 0.1}": (0, 2, 1, 0),
    "inline: {cranks: [0, 120 deg, 240 deg], spacing: 0.1}": (0, 0, ROOT3, ROOT3),
    "inline: {cranks: [0, 180 deg, 180 deg, 0], spacing: 0.1}": (0, 4, 0, 0),
    "inline: {cranks: [0, 90 deg, 270 deg, 180 deg], spacing: 0.1}": (0, 0, np.sqrt(10), 0),
    "inline: {cranks: [0, 120 deg, 240 deg, 240 deg, 120 deg, 0], spacing: 0.1}": (0, 0, 0, 0),
    "opposed: {cranks: [0, 180 deg], spacing: 0.1}": (0, 0, 1, 1),
    "vee: {angle: 90 deg, cranks: [0]}": (1, np.sqrt(2), 0, 0),
    "vee: {angle: 90 deg, cranks: [0, 90 deg, 270 deg, 180 deg], spacing: 0.1}": (0, 0, np.sqrt(10), 0),
    "vee: {angle: 60 deg, cranks: [0, 120 deg, 240 deg, 240 deg, 120 deg, 0], spacing: 0.1}": (0, 0, 0, 0),
    "radial: {cylinders: 3}": (1.5, 1.5, 0, 0),
    "radial: {cylinders: 5}": (2.5, 0, 0, 0),
    "radial: {cylinders: 7}": (3.5, 0, 0, 0),
}


@pytest.mark.parametrize("layout", LAYOUTS)
def test_the_table_of_layouts(layout):
    found = engine(layout)
    orders = (found.first, found.second)
    sizes = [one.force.greatest / (found.unit * one.textbook) for one in orders]
    sizes += [one.couple.greatest / (found.unit * one.textbook * A) for one in orders]
    assert sizes == pytest.approx(LAYOUTS[layout], abs=1e-9)


def test_the_moment_of_a_crossplane_v8_turns_with_the_crankshaft():
    found = engine("vee: {angle: 90 deg, cranks: [0, 90 deg, 270 deg, 180 deg], spacing: 0.1}")
    assert found.first.couple.backward == pytest.approx(0.0, abs=1e-9)
    assert [one.kind for one in found.remedies] == ["none", "forward", "none", "none"]


def test_moments_are_taken_about_the_middle_of_the_cylinders_or_the_stated_plane():
    """One force at two places: its moment about the middle is nothing, about a plane the force by the distance."""
    both = "cylinders: [{at: 0.2}, {at: 0.4}]"
    found = engine(both)
    assert found.first.couple.greatest == pytest.approx(0.0, abs=1e-9)
    found = engine(both, ", about: 0.1")
    assert found.first.couple.greatest == pytest.approx(2 * found.unit * 0.2)


def test_half_the_reciprocating_mass_balances_order_1_of_a_radial_engine_and_of_a_v_of_90_degrees():
    for layout in ("radial: {cylinders: 5}", "vee: {angle: 90 deg, cranks: [0]}"):
        found = engine(layout, ", counterweights: {share: 0.5, radius: 60 mm}, rotating: 0.7 kg")
        force, couple = found.primary
        assert force.greatest == pytest.approx(0.0, abs=1e-9 * found.unit)
        assert couple.greatest == 0.0


def test_a_share_of_one_cylinder_turns_the_force_of_order_1_across():
    """c along the crank's way back: 1 − c along the axis, c across it."""
    found = engine("inline: {cranks: [0]}", ", counterweights: {share: 0.3, radius: 60 mm}, rotating: 0.7 kg")
    force, _ = found.primary
    assert force.along(1j) == pytest.approx(0.7 * found.unit)
    assert force.along(1.0) == pytest.approx(0.3 * found.unit)


def test_share_mass_and_distance_of_a_counterweight_follow_from_each_other():
    one = engine("inline: {cranks: [0]}", ", rotating: 0.7 kg, counterweights: {share: 0.4, radius: 60 mm}")
    mass = one.s.number("m_cw")
    for stated in (f"mass: {mass!r}, radius: 60 mm", f"mass: {mass!r}, share: 0.4"):
        other = engine("inline: {cranks: [0]}", f", rotating: 0.7 kg, counterweights: {{{stated}}}")
        told = [other.s.number(key) for key in ("share", "r_cw", "m_cw")]
        assert told == pytest.approx([0.4, 0.06, (0.7 + 0.4 * 2) * 50 / 60])


@settings(max_examples=examples(60))
@given(LAYOUT, st.floats(0, 1))
def test_weights_on_the_shafts_found_balance_orders_1_and_2_of_any_engine(layout, share):
    found = built(layout, 2.0, 1.5)
    left = found._courses(TURN)["orders"]
    for one in found.remedies:
        rate = one.order * 100.0
        added = one.forward * np.exp(1j * one.order * TURN) + one.backward * np.exp(-1j * one.order * TURN)
        values = getattr(left, one.of)
        values += rate**2 * added
    size = found.unit * len(layout)
    assert np.abs(left.force).max() < 1e-9 * size
    assert np.abs(left.couple).max() < 1e-9 * size


@pytest.mark.parametrize(
    ("layout", "kinds"),
    [
        ("inline: {cranks: [0]}", ["pair", "none", "pair", "none"]),
        ("inline: {cranks: [0, 180 deg, 180 deg, 0], spacing: 0.1}", ["none", "none", "pair", "none"]),
        ("vee: {angle: 90 deg, cranks: [0]}", ["forward", "none", "pair", "none"]),
        ("vee: {angle: 60 deg, cranks: [0]}", ["unequal", "none", "forward", "none"]),
        ("vee: {angle: 45 deg, cranks: [0]}", ["unequal", "none", "unequal", "none"]),
        ("radial: {cylinders: 3}", ["forward", "none", "backward", "none"]),
    ],
)
def test_how_the_rest_turns_says_what_balances_it(layout, kinds):
    assert [one.kind for one in engine(layout).remedies] == kinds


def test_the_shafts_of_lanchester_of_an_inline_four():
    found = engine("inline: {cranks: [0, 180 deg, 180 deg, 0], spacing: 0.1}")
    pair = found.remedies[2]
    assert abs(pair.forward) == pytest.approx(found.product * found.s.number("lambda") / 2)
    assert abs(pair.backward) == pytest.approx(abs(pair.forward))


# --- over a turn, polygons, firing


def test_the_greatest_of_samples_is_found_between_them():
    assert peak(3 + np.cos(TURN + 0.01)) == pytest.approx(4.0, abs=1e-8)
    assert peak(np.full(16, 2.0)) == 2.0


def test_what_orders_1_and_2_leave_is_small_and_not_nothing():
    found = solved("engine_balance").engine
    assert 0 < found.greatest("left", "couple") < 0.1 * found.greatest("orders", "couple")
    direct = max(abs(found._courses(np.linspace(0, 2 * np.pi, 20001))["after"].couple))
    assert found.greatest("after", "couple") == pytest.approx(direct, rel=1e-5)


@pytest.mark.parametrize("layout", [one for one in LAYOUTS if "spacing" in one])
def test_polygons_give_what_is_calculated_to_what_can_be_read(layout):
    found = engine(layout)
    size = max(star.analytic for star in found.stars) or found.unit
    for star in found.stars:
        assert star.graph == pytest.approx(star.analytic, abs=2e-3 * size)


@pytest.mark.parametrize(
    ("layout", "order", "steps"),
    [
        ("inline: {cranks: [0, 180 deg, 180 deg, 0]}", "1, 3, 4, 2", [180] * 4),
        ("inline: {cranks: [0, 240 deg, 120 deg, 120 deg, 240 deg, 0]}", "1, 5, 3, 6, 2, 4", [120] * 6),
        ("inline: {cranks: [0, 0]}", "1, 2", [360, 360]),
        ("vee: {angle: 45 deg, cranks: [0]}", "1, 2", [315, 405]),
    ],
)
def test_angles_of_firing(layout, order, steps):
    fired = engine(layout, f", firing: [{order}]").firing
    assert np.degrees([one.interval for one in fired]) == pytest.approx(steps)
    assert np.degrees([b.angle - a.angle for a, b in pairwise(fired)]) == pytest.approx(steps[:-1])


# --- mistakes

FOUR = "inline: {cranks: [0, 180 deg, 180 deg, 0], spacing: 0.1}"


def test_a_rod_of_the_length_of_the_crank_is_told():
    with pytest.raises(ProblemError, match="hardly turns over"):
        loading.loads(f"engine: {{{SIZES.replace('200 mm', '52 mm')}, {FOUR}}}")


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "must be stated by one key"),
        (f"{FOUR}, radial: {{cylinders: 3}}", "must be stated by one key"),
        (f"{FOUR}, counterweights: {{share: 0.5}}", "two of share, radius and mass"),
        (f"{FOUR}, counterweights: {{mass: 9 kg, radius: 60 mm}}", "more than all of the reciprocating one"),
        (f"{FOUR}, rotating: 1 kg, counterweights: {{mass: 10 g, radius: 60 mm}}", "its share is -0.494"),
        (f"{FOUR}, firing: [1, 2, 3]", "must name every cylinder once"),
        (f"{FOUR}, strokes: 2, firing: [1, 3, 4, 2]", "the order of firing cannot be"),
        (f"{FOUR}, rod: {{mass: 1 kg, centre: 300 mm}}", "beyond its piston pin"),
        ("cylinders: [{name: 1}, {name: 1}]", "two cylinders are named 1"),
        ("radial: {cylinders: 1}", "a whole number from 2 to 24"),
    ],
)
def test_a_mistake_is_told(text, said):
    with pytest.raises(ProblemError) as error:
        engine(text)
    assert said in str(error.value)


# --- firing together, whichever cylinder is named first


def fired(layout, order, strokes=4):
    return engine(layout, f", strokes: {strokes}, firing: [{order}]").firing


@pytest.mark.parametrize(
    ("layout", "order"),
    [
        ("vee: {angle: 45 deg, cranks: [0]}", "1 2"),
        ("vee: {angle: 60 deg, cranks: [0, 120 deg, 240 deg]}", "1 4 3 6 5 2"),
        ("inline: {cranks: [0, 240 deg, 120 deg]}", "1 2 3"),
        ("radial: {cylinders: 7}", "1 3 5 7 2 4 6"),
    ],
)
def test_the_order_of_firing_is_one_whichever_cylinder_is_named_first(layout, order):
    """A V of 45 degrees fires after 315 and 405 degrees, never after 45 and 675."""
    names = order.split()
    whole = {one.name: one.interval for one in fired(layout, ", ".join(names))}
    for k in range(1, len(names)):
        again = fired(layout, ", ".join(names[k:] + names[:k]))
        assert {one.name: one.interval for one in again} == pytest.approx(whole)
    assert sum(whole.values()) == pytest.approx(4 * np.pi)


def test_a_two_stroke_boxer_fires_both_cylinders_together():
    """Both pistons are at the top at once; a four-stroke one fires them by turns."""
    boxer = "opposed: {cranks: [0, 180 deg], spacing: 0.1}"
    assert [one.angle for one in fired(boxer, "1, 2", 2)] == pytest.approx([0, 0])
    assert sum(one.interval for one in fired(boxer, "1, 2", 2)) == pytest.approx(2 * np.pi)
    assert np.degrees([one.interval for one in fired(boxer, "1, 2")]) == pytest.approx([360, 360])
    four = fired("inline: {cranks: [0, 180 deg, 180 deg, 0]}", "1, 4, 2, 3", 2)
    assert np.degrees([one.angle for one in four]) == pytest.approx([0, 0, 180, 180])


# --- in the note


def note(layout, more=""):
    results = course.solve(loading.loads(f"language: en\nengine: {{{SIZES}, {layout}{more}}}"))
    return render(results, "html")["note.html"].decode()


def test_the_note_says_where_the_weights_are_put():
    text = note("vee: {angle: 60 deg, cranks: [0]}")
    found = engine("vee: {angle: 60 deg, cranks: [0]}")
    for row, one in enumerate(found.remedies):
        for sense in ("forward", "backward"):
            printed = re.search(rf'data-q="{sense}_angle" data-k="{row}"[^>]*>([^<]*)<', text)
            product = getattr(one, sense)
            if one.kind == "none":
                assert printed is None
            elif product:
                angle = np.degrees(np.angle(product)) % 360
                assert float(printed[1]) == pytest.approx(angle, abs=0.01)
            else:
                assert printed[1] == "—"
    assert "turns counter-clockwise" in text and "the axis y points upwards" in text
    assert "The weights are put" not in note(
        "radial: {cylinders: 5}", ", counterweights: {share: 0.5, radius: 0.1}"
    )


def test_cylinders_in_one_plane_have_no_moments_to_speak_of():
    text = note("inline: {cranks: [0]}", ", rotating: 0.7 kg")
    assert "Moments of order" not in text and 'data-q="M_max"' not in text
    both = note("inline: {cranks: [0, 180 deg, 180 deg, 0], spacing: 0.1}", ", rotating: 0.7 kg")
    assert "Moments of order 1 balance each other." in both and 'data-q="M_max"' in both


def test_what_is_left_of_rounding_needs_no_weight():
    found = engine(
        "vee: {angle: 90 deg, cranks: [0]}", ", counterweights: {share: 0.5, radius: 60 mm}, rotating: 0.7 kg"
    )
    assert [one.forward for one in found.remedies if one.kind == "none"] == [0, 0, 0]


@pytest.mark.exhaustive
@pytest.mark.parametrize(
    "layout", ["vee: {angle: 45 deg, cranks: [%s], spacing: 0.1}", "radial: {cylinders: 24}"]
)
def test_drawings_of_many_cylinders_stand_upright(layout):
    found = engine(layout.replace("%s", "0, 90 deg, 270 deg, 180 deg, 180 deg, 270 deg, 90 deg, 0"))
    pictures = [scheme(found), *(star_picture(one, ["direct", "reverse"], False, "") for one in found.stars)]
    for picture in pictures:
        left, _, right, _ = picture.box
        assert right - left < 165  # mm: the width of a page


@pytest.mark.parametrize(
    ("text", "path"),
    [
        (f"{FOUR}, counterweights: {{share: 1.5, radius: 60 mm}}", "engine.counterweights.share"),
        ("inline: {cranks: [0, 3 kg]}, firing: [1, 2]", "engine.inline.cranks.1"),
        (f"{FOUR}, firing: [1, 3, 4, {{}}]", "engine.firing.3"),
    ],
)
def test_one_mistake_is_told_once(text, path):
    """What is wrong in itself is not told again as missing."""
    with pytest.raises(ProblemError) as error:
        engine(text)
    assert [".".join(map(str, problem.path)) for problem in error.value.problems] == [path]
