"""Friction in single pairs: limit cases, equilibrium put together from forces, what locks, rolls and jams."""

from __future__ import annotations

import cmath
import math
from dataclasses import replace

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tmm_report import course, loading, note
from tmm_report.chapters.machine.contacts import given as state
from tmm_report.chapters.machine.contacts import quantities, solve, words
from tmm_report.chapters.machine.contacts.draw_turning import SKETCHES
from tmm_report.chapters.machine.contacts.given import Given
from tmm_report.figures.drawing import Arrow, Circle, Text
from tmm_report.i18n import Translator
from tmm_report.mechanics.pairs import friction as law
from tmm_report.problems import ProblemError

KINDS = {
    "incline": "angle: 20 deg, load: 1 kN, coefficient: 0.2",
    "wedge": "angle: 8 deg, load: 1 kN, coefficient: 0.15, base: 0.1",
    "sliders": "between: 70 deg, guides: 0.1, coefficient: 0.12, face: 30 deg, load: 1 kN",
    "trial": "angle: 20 deg, pull: 100 N, push: 130 N",
    "screw": "diameter: 30 mm, pitch: 6 mm, starts: 2, profile: 15 deg, coefficient: 0.1, load: 5 kN, arm: 0.3 m",
    "pivot": "outer: 40 mm, inner: 15 mm, half_cone: 45 deg, load: 3 kN, coefficient: 0.08, speed: 300 rpm",
    "belt": "wrap: 200 deg, tight: 1 kN, groove: 20 deg, coefficient: 0.2, diameter: 0.2 m, speed: 100 rpm",
    "belt drive": "driving: 0.1 m, driven: 0.3 m, distance: 0.6 m, speed: 1440 rpm, width: 50 mm, thickness: 4 mm, "
    "stress: 1.6 MPa, coefficient: 0.3, density: 1000 kg/m^3",
    "wheel": "radius: 0.2 m, arm: 1 mm, load: 1 kN, coefficient: 0.2, pull: 20 N",
    "journal": "diameter: 50 mm, load: 2 kN, coefficient: 0.1, speed: 600 rpm",
    "crank": "force: 1 kN, crank: 50 mm, rod: 200 mm, angle: 130 deg, coefficient: 0.1, "
    "journals: {shaft: 40 mm, crank_pin: 35 mm, wrist_pin: 20 mm}",
}


def stated(kind: str, text: str = "") -> solve.Solved:
    lines = f"language: en\ncontacts:\n  - {{kind: {kind}, {text or KINDS[kind]}}}\n"
    found = course.solve(loading.loads(lines)).contacts
    assert found is not None
    return found.items[0]


def numbers(item: solve.Solved) -> dict[str, float]:
    return {one.key: one.value for one in item.s.values()}


def incline(f, angle, load, force="level"):
    return state.Incline(kind="incline", coefficient=f, angle=angle, load=load, force=force)


def wedge(f, angle, load, base):
    return state.Wedge(kind="wedge", coefficient=f, angle=angle, load=load, base=base)


def screw(f, diameter, pitch, load, **more):
    return state.Screw(kind="screw", coefficient=f, diameter=diameter, pitch=pitch, load=load, **more)


def solved(pair) -> solve.Solved:
    return solve.solve(Given((pair,)), None).items[0]


def of(pair) -> dict[str, float]:
    return numbers(solved(pair))


# ---------------------------------------------------------------- every kind


@pytest.mark.parametrize("kind", KINDS)
def test_every_number_has_a_symbol_of_its_own(kind):
    item = stated(kind)
    (_, table) = quantities.tables(solve.Found(Given(()), (item,)))
    signs = [str(column.symbol()) for column in table.columns]
    assert len(set(signs)) == len(signs)


# ---------------------------------------------------------------- planes


@settings(max_examples=20)
@given(st.floats(2, 60), st.floats(0.01, 0.5))
def test_forces_on_a_plane_are_in_equilibrium(slope, f):
    """Load, moving force and the reaction of N (1, ±f) close, whether the force is level or along the plane."""
    angle = math.radians(slope)
    along, up = cmath.rect(1, angle), cmath.rect(1, angle + math.pi / 2)
    for force, way in (("level", 1 + 0j), ("along", along)):
        pair = incline(f, angle, 100.0, force)
        if force == "level" and angle + math.atan(f) >= math.pi / 2:
            continue
        numbers = of(pair)
        for key, sense in (("F_up", -1), ("F_down", 1)):
            rest = numbers[key] * way - 100j
            normal = -(rest * up.conjugate()).real
            assert normal > 0
            assert (rest * along.conjugate()).real == pytest.approx(-sense * f * normal, abs=1e-9)


def test_a_plane_locks_up_to_the_angle_of_friction():
    phi = math.atan(0.2)
    flat, steep = incline(0.2, 0.999 * phi, 1.0), incline(0.2, 1.001 * phi, 1.0)
    assert of(flat)["F_down"] < 0 < of(steep)["F_down"]
    assert "eta_back" not in of(flat) and of(steep)["eta_back"] == pytest.approx(0, abs=0.02)


def test_without_friction_nothing_is_lost():
    assert of(incline(0.0, 0.3, 10.0))["eta"] == pytest.approx(1)
    assert of(wedge(0.0, 0.2, 10.0, 0.0))["eta"] == pytest.approx(1)
    found = of(screw(0.0, 0.02, 0.004, 100.0))
    assert found["eta"] == pytest.approx(1)
    assert found["M_screw"] == pytest.approx(100 * 0.004 / (2 * math.pi))  # work of a turn: Q h


def test_a_wedge_locks_up_to_both_angles_of_friction():
    both = math.atan(0.1) + math.atan(0.2)
    for part, sign in ((0.99, -1), (1.01, 1)):
        assert math.copysign(1, of(wedge(0.1, part * both, 1.0, 0.2))["F_out"]) == sign


def test_the_best_face_of_sliders_is_the_best():
    theta, both = math.radians(60), math.atan(0.15) + math.atan(0.1)
    best = law.best_face(theta, both)
    assert law.guided_pair(theta, best, both) == pytest.approx(law.best_guided_pair(theta, both))
    assert all(
        law.guided_pair(theta, best + off, both) < law.guided_pair(theta, best, both) for off in (-0.05, 0.05)
    )
    assert law.guided_pair(theta, 0.4, 0.0) == pytest.approx(1)


def test_a_trial_is_undone_by_its_own_forces():
    f, weight = law.pulled_and_pushed(150.0, 190.0, 0.4)
    for force, sign in ((150.0, 1), (190.0, -1)):
        assert force * math.cos(0.4) == pytest.approx(f * (weight - sign * force * math.sin(0.4)))


# ---------------------------------------------------------------- screws


def test_a_thread_that_locks_has_an_efficiency_below_one_half():
    """η = tan ψ/tan(ψ + φ) at ψ = φ is (1 − tan² φ)/2."""
    f = 0.12
    lead = math.pi * 0.03 * f
    numbers = of(screw(f, 0.03, lead, 1000.0))
    assert numbers["M_low"] == pytest.approx(0, abs=1e-12)
    assert numbers["eta"] == pytest.approx((1 - f * f) / 2)


def test_a_square_thread_is_one_of_no_angle_and_starts_multiply_the_lead():
    square = of(screw(0.1, 0.03, 0.006, 1000.0))
    sharp = of(screw(0.1, 0.03, 0.006, 1000.0, profile=math.radians(30)))
    double = of(screw(0.1, 0.03, 0.003, 1000.0, starts=2))
    assert sharp["M_thread"] > square["M_thread"] == pytest.approx(double["M_thread"])


def test_the_collar_is_added_and_the_hands_share_the_moment():
    plain = of(screw(0.1, 0.03, 0.006, 1000.0, arm=0.25))
    loaded = of(screw(0.1, 0.03, 0.006, 1000.0, collar=state.Collar(0.2, 0.02), hand_force=50.0, hands=2))
    assert loaded["M_screw"] - plain["M_screw"] == pytest.approx(0.2 * 1000 * 0.02)
    assert plain["P_hand"] * 0.25 == pytest.approx(plain["M_screw"])
    assert 2 * 50 * loaded["D_wheel"] / 2 == pytest.approx(loaded["M_screw"])


# ---------------------------------------------------------------- what turns


def test_pivots_by_integrals_over_their_rings():
    """Uniform pressure: p constant; run in: p r constant; M = ∫ f p 2π r² dr/sin α."""
    outer, inner, f, load, cone = 0.05, 0.02, 0.1, 2000.0, math.radians(60)
    count = 20000
    step = (outer - inner) / count
    rings = [inner + (k + 0.5) * step for k in range(count)]
    even = load / (math.pi * (outer**2 - inner**2))
    pressure = sum(f * even * 2 * math.pi * r**2 * step for r in rings) / math.sin(cone)
    worn = load / (2 * math.pi * (outer - inner))
    wear = sum(f * worn / r * 2 * math.pi * r**2 * step for r in rings) / math.sin(cone)
    assert law.pivot_pressure(load, f, outer, inner, cone) == pytest.approx(pressure, rel=1e-8)
    assert law.pivot_wear(load, f, outer, inner, cone) == pytest.approx(wear, rel=1e-8)


def test_eulers_formula_by_small_steps():
    """dT = −f T dα."""
    tension, count = 1000.0, 100_000
    for _ in range(count):
        tension *= 1 - 0.25 * 3.0 / count
    assert law.slack(1000.0, 0.25, 3.0) == pytest.approx(tension, rel=1e-5)
    flat = state.Belt(kind="belt", coefficient=0.2, wrap=3.0, tight=1000.0)
    flat, grooved = of(flat), of(replace(flat, groove=math.radians(20)))
    assert grooved["T_2"] < flat["T_2"]


def test_a_belt_carries_most_at_its_best_speed():
    found = numbers(stated("belt drive"))
    slack = math.exp(-0.3 * found["alpha"])

    def power(v: float) -> float:
        return (found["T_max"] - found["q"] * v * v) * (1 - slack) * v

    best = found["v_best"]
    assert found["P_best"] == pytest.approx(power(best))
    assert power(0.99 * best) < power(best) > power(1.01 * best)
    assert found["q"] * best**2 == pytest.approx(found["T_max"] / 3)


def test_equal_pulleys_are_held_over_half_a_turn():
    assert law.open_wrap(0.2, 0.2, 1.0) == pytest.approx(math.pi)
    assert law.open_wrap(0.2, 0.4, 1.0) == law.open_wrap(0.4, 0.2, 1.0) < math.pi


def test_a_driving_wheel_slips_beyond_its_moment_and_what_is_told_helps():
    """What the note tells to be enough is enough, and a little less is not."""

    def slips(**changes):
        stated_ = {"coefficient": 0.2, "radius": 0.2, "arm": 0.001, "load": 1000.0, "moment": 50.0} | changes
        of = solved(state.Wheel(kind="wheel", **stated_)).s
        return of.number("M") > of.number("M_most")

    of = solved(state.Wheel(kind="wheel", coefficient=0.2, radius=0.2, arm=0.001, load=1000.0, moment=50.0)).s
    assert slips()
    helps = {"coefficient": "f_need", "load": "N_need", "radius": "r_need", "moment": "M_most"}
    for key, number in helps.items():
        more = -1e-9 if key == "moment" else 1e-9
        assert not slips(**{key: of.number(number) * (1 + more)}), key
        assert slips(**{key: of.number(number) * (1 - more)}), key
    text = "radius: 0.2 m, arm: 1 mm, load: 1 kN, coefficient: 0.2, moment: "
    for moment, said in ((0.5, "stays at rest"), (30, "without slipping"), (50, "It would not slip with")):
        found = course.solve(
            loading.loads(f"language: en\ncontacts:\n  - {{kind: wheel, {text}{moment} N*m}}\n")
        )
        assert said in note.render(found, "html", Translator("en"))["note.html"].decode()
    with pytest.raises(ProblemError, match="at most one of: pull, moment"):
        stated("wheel", f"{text}5 N*m, pull: 3 N")
    with pytest.raises(ProblemError, match="slips under any moment"):
        stated("wheel", f"{text}5 N*m".replace("0.2,", "0,"))
    slow = {"coefficient": 0.2, "radius": 0.002, "arm": 0.001, "load": 1000.0}
    of = solved(state.Wheel(kind="wheel", **slow)).s
    for key, enough in (("radius", 1.001 * of.number("r_least")), ("arm", 0.999 * of.number("k_most"))):
        assert not solved(state.Wheel(kind="wheel", **slow)).rolls
        assert solved(state.Wheel(kind="wheel", **(slow | {key: enough}))).rolls


@pytest.mark.parametrize(("f", "rolls"), [(0.0051, True), (0.0049, False)])
def test_a_wheel_rolls_where_friction_is_greater_than_k_by_r(f, rolls):
    """A lecture prints it the other way round: what must be overcome is the less of k N/r and f N."""
    found = solved(state.Wheel(kind="wheel", coefficient=f, radius=0.2, arm=0.001, load=1000.0))
    assert found.rolls is rolls
    assert (found.s.number("F_roll") < found.s.number("F_slide")) is rolls


def test_a_journal_is_turned_against_its_friction_circle():
    numbers = of(state.Journal(kind="journal", coefficient=0.1, diameter=0.06, load=500.0, speed=10.0))
    assert numbers["rho"] == pytest.approx(0.003)
    assert numbers["P"] == pytest.approx(500 * 0.003 * 10)


# ---------------------------------------------------------------- what cannot be


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("kind: incline, angle: 80 deg, coefficient: 0.2, load: 1 kN", "it jams: the slope of 80"),
        ("kind: incline, angle: -5 deg, coefficient: 0.2, load: 1 kN", "is none; an angle between 0 and 90"),
        ("kind: incline, angle: 5 deg, load: 1 kN", "by its coefficient or by the materials"),
        ("kind: sliders, between: 175 deg, guides: 0.2, coefficient: 0.2", "make 180° or more"),
        ("kind: sliders, between: 60 deg, guides: 0.2, coefficient: 0.2, face: 88 deg, load: 0", "greater than zero"),
        ("kind: trial, angle: 30 deg, pull: 220 N, push: 180 N", "a push greater than the pull"),
        ("kind: pivot, outer: 20 mm, inner: 20 mm, load: 1 kN, coefficient: 0.1", "less than the outer one"),
        ("kind: belt, wrap: 90 deg, tight: 1 kN, coefficient: 0.1, groove: 100 deg", "90° for a flat drum"),
        (f"kind: belt drive, {KINDS['belt drive'].replace('0.6 m', '0.15 m')}", "the pulleys overlap"),
        (f"kind: belt drive, {KINDS['belt drive'].replace('1440', '14400')}", "nothing is left to carry power"),
        ("kind: belt drive, speed: 100 rpm, distance: 1 m, width: 1 mm, thickness: 1 mm, stress: 1 MPa, "
         "coefficient: 0.1", "two of their diameters and the driven speed"),
        (f"kind: crank, {KINDS['crank'].replace('130', '1')}", "dead zone"),
        (f"kind: screw, {KINDS['screw']}, hand_force: 10 N", "one of them: the other follows"),
        (f"kind: screw, {KINDS['screw'].replace('15 deg', '120 deg')}", "half the angle of the thread is 120"),
        (f"kind: screw, {KINDS['screw'].replace('15 deg', '-15 deg')}", "half the angle of the thread is -15"),
        (f"kind: screw, {KINDS['screw'].replace('arm: 0.3 m', 'hands: 2')}", "neither their arm nor their force"),
        (f"kind: crank, {KINDS['crank'].replace('130', '250')}", "does not turn the crank on"),
        (f"kind: crank, {KINDS['crank'].replace('130', '-30')}", "does not turn the crank on"),
        ("kind: sliders, between: 0 deg, guides: 0.1, coefficient: 0.1", "do not drive one another"),
        ("kind: sliders, between: 60 deg, guides: 0.1, coefficient: 0.2, face: 75 deg", "other side of its guide"),
        ("kind: sliders, between: 60 deg, guides: 0.1, coefficient: 0.2, face: 5 deg", "between 11.31 and 71.31"),
        ("kind: sliders, between: 90 deg, guides: 0.1, coefficient: 0.2, face: 10 deg", "it jams"),
        ("kind: sliders, between: 2 deg, guides: 0, coefficient: 0.5", "other side of its guide"),
        ("kind: trial, angle: 1 deg, pull: 1 N, push: 100 N", "need a coefficient of friction of 56.16"),
        ("kind: nut, coefficient: 0.1", "begin with kind"),
        ("coefficient: 0.1", "begin with kind"),
    ],
)  # fmt: skip
def test_what_cannot_be_is_told_with_its_reason(text, said):
    with pytest.raises(ProblemError, match=said):
        course.solve(loading.loads(f"language: en\ncontacts:\n  - {{{text}}}\n"))


def test_all_mistakes_are_told_at_once():
    lines = "\n".join(
        f"  - {{kind: incline, angle: {angle} deg, coefficient: 1, load: 1 N}}" for angle in (50, 60)
    )
    with pytest.raises(ProblemError) as told:
        course.solve(loading.loads(f"language: en\ncontacts:\n{lines}\n"))
    assert len(told.value.problems) == 2


def test_the_summary_names_efficiencies():
    found = course.solve(
        loading.loads(f"language: en\ncontacts: [{{kind: screw, {KINDS['screw']}}}]")
    ).contacts
    (line,) = found.summary()
    assert f"{found.items[0].s.number('eta'):.4g}" in str(line)


def test_the_summary_table_has_the_angle_of_friction_of_each_pair():
    """Of a crank its own angle has the letter φ, too; of a thread the angle is the reduced one."""
    items = [replace(stated(kind), number=k) for k, kind in enumerate(KINDS, 1)]
    (listed, *_) = quantities.tables(solve.Found(Given(()), tuple(items)))
    for item, f, phi in zip(items, listed["f"].numbers(), listed["phi_fr"].numbers(), strict=True):
        steeper = math.cos(math.radians(15)) if item.kind == "screw" else 1.0
        assert phi == pytest.approx(math.degrees(math.atan(f / steeper)))


@settings(max_examples=30)
@given(st.floats(10, 100), st.floats(0, 0.4), st.floats(0, 0.4), st.floats(-20, 89))
def test_sliders_by_the_forces_on_both_of_them(between, f, guides, face):
    """Each slider by itself, its guide pressed to the side on which the reaction of the face lies; what is refused is
    that for which the formula gives another efficiency, or what jams."""
    theta, alpha, phi = math.radians(between), math.radians(face), math.atan(f)
    try:
        pair = state.Sliders(kind="sliders", coefficient=f, between=theta, guides=guides, face=alpha)
        eta = of(pair)["eta"]
    except ProblemError:
        return
    driving = cmath.rect(1, alpha - phi)  # the reaction of the face on the driven slider, 1 N
    driven = driving * cmath.rect(1, -theta)
    force, load = driving.real + guides * abs(driving.imag), driven.real - guides * abs(driven.imag)
    assert eta == pytest.approx(load * math.cos(alpha) / (math.cos(theta - alpha) * force), abs=1e-9)
    assert 0 < eta <= 1 + 1e-12


def test_a_collar_holds_a_screw_whose_thread_runs_back():
    thread = screw(0.02, 0.03, 0.03, 1000.0)
    held = replace(thread, collar=state.Collar(0.2, 0.05))
    bare, whole = solved(thread), solved(held)
    assert bare.s.number("M_low") < 0 and not bare.locks and not bare.held
    assert whole.s.number("M_back") == pytest.approx(bare.s.number("M_low") + 0.2 * 1000 * 0.05)
    assert whole.locks and whole.held


def test_hands_share_the_force_on_an_arm():
    one = of(screw(0.1, 0.03, 0.006, 1000.0, arm=0.3))
    two = of(screw(0.1, 0.03, 0.006, 1000.0, arm=0.3, hands=2))
    assert one["P_hand"] == pytest.approx(one["M_screw"] / 0.3) and "n_hand" not in one
    assert two["P_hand"] == pytest.approx(one["P_hand"] / 2)
    text = KINDS["screw"] + ", hands: 2"
    assert stated("screw", text).s.number("P_hand") == pytest.approx(stated("screw").s.number("P_hand") / 2)
    wheel = stated("screw", KINDS["screw"].replace("arm: 0.3 m", "hand_force: 100 N"))
    assert wheel.s.number("n_hand") == 2


@pytest.mark.parametrize(
    ("pull", "said"),
    [(4, "stays at rest"), (20, "makes the wheel roll"), (201, "rolls or slides, too")],
)
def test_what_a_force_at_the_axle_does(pull, said):
    """It rolls from 5 N; from 200 N on friction may not turn it as fast as it is pulled."""
    item = stated("wheel", KINDS["wheel"].replace("20 N", f"{pull} N"))
    assert said in words._pulled(item)


def test_the_summary_names_the_kind_in_words():
    (line,) = solve.Found(Given(()), (stated("belt drive"), stated("crank"))).summary()
    assert "Slider-crank with friction circles" in str(line)


# ---------------------------------------------------------------- sketches


@pytest.mark.parametrize("kind", [kind for kind in KINDS if kind != "trial"])
def test_every_pair_has_a_sketch_that_fits_the_page(kind):
    item = stated(kind)
    drawn = SKETCHES[item.kind](item, "a sketch")
    wide, tall = drawn.size
    assert 30 < wide < 165 and 30 < tall < 120
    assert sum(isinstance(one, Text) for one in drawn.items) >= 3


def test_the_force_in_the_rod_is_drawn_tangent_to_both_friction_circles():
    """Once they are crossed by the line's two sides: while the rod swings out, and after 90° on one side."""
    for angle, same in ((60, False), (130, True)):
        item = stated("crank", KINDS["crank"].replace("130", str(angle)))
        drawn = SKETCHES["crank"](item, "")
        force = next(one for one in drawn.items if isinstance(one, Arrow) and one.pen.colour == "red")
        along = (force.end - force.start) / abs(force.end - force.start)
        circles = [one for one in drawn.items if isinstance(one, Circle) and one.pen.dash]
        _, pin, wrist = ((along.conjugate() * (one.centre - force.start)).imag for one in circles)
        sizes = [one.radius for one in circles[1:]]
        assert [abs(pin), abs(wrist)] == pytest.approx(sizes)
        assert (pin * wrist > 0) is same
