"""What is asked of a linkage comes out of the motion of the mechanism with its lengths."""

import math
import random

import numpy as np
import pytest
from synthesised import MECHANISMS

from tmm_report import course, loading
from tmm_report.chapters.lever.synthesis.quantities import tables
from tmm_report.problems import ProblemError

QUICK, MANY = 6, 60


def demand(kind, draw):
    """The statement of a random demand."""
    number, K = draw.uniform, round(draw.uniform(1.02, 1.6), 3)
    if kind == "slider_crank":
        own = draw.choice([f"ratio: {number(1.2, 6):.3f}, K: {K}", f"offset: {number(5, 40):.2f} mm, K: {K}", f"K: {K}",
                           f"ratio: {number(2, 6):.3f}, offset_ratio: {number(0.05, 0.9):.3f}",
                           f"ratio: {number(2, 6):.3f}, offset: {number(1, 20):.2f} mm",
                           f"pressure_angle: {number(8, 45):.2f} deg"])  # fmt: skip
        return f"stroke: {number(50, 500):.2f} mm, {own}"
    if kind == "crank_rocker":
        own = draw.choice(["", f", crank: {number(20, 140):.2f} mm", f", rod: {number(200, 1200):.1f} mm"])
        return (f"K: {K}, swing: {number(15, 70):.2f} deg, rocker: {number(200, 700):.1f} mm{own}, "
                f"beyond: {draw.choice(['false', 'true'])}, middle: 90 deg")  # fmt: skip
    size = f"{draw.choice(['frame', 'crank'])}: {number(100, 500):.1f} mm"
    own = draw.choice([f"rod_ratio: {number(1.3, 5):.3f}", f"pressure_angle: {number(5, 40):.2f} deg"])
    return f"stroke: {number(100, 600):.1f} mm, K: {round(number(1.05, 2.8), 3)}, {size}, {own}"


def analysed(kind, stated, side="left"):
    text = f"language: en\nsynthesis: {{{kind}: {{{stated}}}}}\n{MECHANISMS[kind].format(side=side)}"
    return course.solve(loading.loads(text))


def meets(kind, stated):
    """Whether a demand can be met; then its motion is that which was asked. 1e-9, of what is near 1e-9 to a limit the
    digits that are left."""
    try:
        found = analysed(kind, stated)
    except ProblemError as error:
        assert all(problem.path[0] == "synthesis" for problem in error.problems), (stated, error)
        return False
    s, lever = found.synthesis.s, found.lever
    rocks = kind == "crank_rocker"
    if rocks and not math.isclose(s.number("swing_met"), s.number("swing"), rel_tol=1e-6):
        found = analysed(kind, stated, side="right")
        s, lever = found.synthesis.s, found.lever
    of = "swing" if rocks else "stroke"
    assert s.number(f"{of}_met") == pytest.approx(s.number(of), rel=1e-9), stated
    if "K" in s:
        assert s.number("K_met") == pytest.approx(s.number("K"), rel=1e-8), stated
    if lever.transmission is not None:
        (couple,) = [one for one in lever.transmission.couplers if one.inner.name == "B"]
        from tmm_report.chapters.lever.transmission.solve import least

        worst = least(couple, lever.kinematics).value
        asked = s.number("transmission") if rocks else math.pi / 2 - s.number("pressure")
        assert worst == pytest.approx(asked, rel=1e-8), stated
    return True


@pytest.mark.parametrize("kind", MECHANISMS)
def test_what_is_asked_comes_out_of_the_motion(kind):
    draw = random.Random(7)
    assert sum(meets(kind, demand(kind, draw)) for _ in range(QUICK))


@pytest.mark.exhaustive
@pytest.mark.parametrize("kind", MECHANISMS)
def test_what_is_asked_comes_out_of_the_motion_of_many(kind):
    draw = random.Random(8)
    assert sum(meets(kind, demand(kind, draw)) for _ in range(MANY)) > MANY / 4


def test_what_is_free_is_chosen_for_the_best_angle():
    """No neighbour of the free parameter has a better one."""
    for text, key, angle, best in (
        ("slider_crank: {stroke: 120 mm, K: 1.3}", "ratio", "pressure", min),
        ("crank_rocker: {K: 1.15, swing: 40 deg, rocker: 500 mm}", "crank", "transmission", max),
    ):
        found = synthesised(text).s
        chosen, size = found.number(angle), found.number(key)
        beside = []
        for part in (0.97, 0.999, 1.001, 1.03):
            stated = f"{size * part} m" if key == "crank" else f"{size * part}"
            beside.append(synthesised(text.replace("}", f", {key}: {stated}}}")).s.number(angle))
        assert best([chosen, *beside]) == chosen


def test_the_shortest_rod_that_keeps_the_permitted_angle():
    found = synthesised("slider_crank: {stroke: 120 mm, K: 1.1, pressure_angle: 40 deg}").s
    assert math.degrees(found.number("pressure")) == pytest.approx(40, rel=1e-9)
    shorter = synthesised(
        f"slider_crank: {{stroke: 120 mm, K: 1.1, ratio: {found.number('ratio') * 0.99}}}"
    ).s
    assert math.degrees(shorter.number("pressure")) > 40


def test_both_solutions_of_a_swing_are_found():
    near = synthesised("crank_rocker: {K: 1.1, swing: 32 deg, rocker: 0.6 m, crank: 0.15 m}").s
    far = synthesised("crank_rocker: {K: 1.1, swing: 32 deg, rocker: 0.6 m, crank: 0.15 m, beyond: true}").s
    assert near.number("rod") == far.number("rod") and far.number("frame") == pytest.approx(
        1.29248856, rel=1e-8
    )


def test_rounded_lengths_go_to_the_mechanism_and_their_effect_is_told():
    stated = "stroke: 123.4 mm, K: 1.2, ratio: 3"
    asked = f"synthesis: {{slider_crank: {{{stated}}}, round: 1 mm}}"
    text = f"language: en\n{asked}\n{MECHANISMS['slider_crank'].format()}"
    found = course.solve(loading.loads(text))
    links = found.lever.given.mechanism.links
    taken = {key: found.synthesis.design.taken(key) for key in ("crank", "rod", "offset")}
    assert all(1e3 * size == pytest.approx(round(1e3 * size), abs=1e-9) for size in taken.values())
    assert (links["1"].points["A"], links["2"].points["B"]) == (taken["crank"], taken["rod"])
    s = found.synthesis.s
    a, b, e = (taken[key] for key in ("crank", "rod", "offset"))
    stroke = math.sqrt((b + a) ** 2 - e**2) - math.sqrt((b - a) ** 2 - e**2)
    assert s.number("stroke_met") == pytest.approx(stroke, rel=1e-9) != s.number("stroke")


ROUNDED = {
    "slider_crank": "stroke: 123.4 mm, K: 1.2, ratio: 3",
    "crank_rocker": "K: 1.1, swing: 40 deg, rocker: 303 mm, middle: 90 deg",
    "slotted_link": "stroke: 403 mm, K: 1.55, frame: 421 mm, rod_ratio: 0.25",
    "turning_guide": "stroke: 303 mm, K: 1.8, crank: 152 mm, pressure_angle: 14 deg",
}


@pytest.mark.parametrize("kind", ROUNDED)
def test_what_rounding_does_is_what_the_analysed_motion_has(kind):
    asked = f"synthesis: {{{kind}: {{{ROUNDED[kind]}}}, round: 4 mm}}"
    found = course.solve(loading.loads(f"language: en\n{asked}\n{MECHANISMS[kind].format(side='left')}"))
    s = found.synthesis.s
    keys = {"swing", "transmission"} if kind == "crank_rocker" else {"stroke", "pressure"}
    for key in ("K", *keys):
        assert s.number(f"{key}_taken") == pytest.approx(s.number(f"{key}_met"), rel=1e-8), key
        assert key == "stroke" or s.number(f"{key}_taken") != pytest.approx(s.number(key), rel=1e-5), key


def test_what_rounding_leaves_open_is_told():
    s = synthesised("body: {positions: [[0, 0, 0], [60 mm, 25 mm, 20 deg], [110 mm, 20 mm, 45 deg]], "
                    "points: [[0, 0], [80 mm, 20 mm]]}, round: 5 mm")  # fmt: skip
    taken, number = s.design.taken, s.s.number
    gaps = []
    for x, y, turned in ((0, 0, 0), (0.06, 0.025, math.radians(20)), (0.11, 0.02, math.radians(45))):
        for key, point in (("crank", 0j), ("rocker", 0.08 + 0.02j)):
            pivot = complex(taken(f"{key}_pivot_x"), taken(f"{key}_pivot_y"))
            gaps.append(abs(abs(complex(x, y) + np.exp(1j * turned) * point - pivot) - taken(key)))
    assert number("misfit") == pytest.approx(max(gaps), rel=1e-9) and 0 < max(gaps) < 0.01


def test_of_two_cranks_of_one_offset_the_better_is_taken():
    """Near the limit two cranks have the stroke: the one that is longer has the smaller pressure angle."""
    s = synthesised("slider_crank: {stroke: 207 mm, ratio: 1.6, offset: 50 mm}").s
    assert s.number("crank") > 0.0856  # the other one is between 83.4 and 85.5 mm
    found = synthesised("slider_crank: {stroke: 207 mm, ratio: 1.6, offset: 50 mm}")
    (table,) = [one for one in tables(found) if one.name == "synthesis_solutions"]
    for row, (a, b, sine) in enumerate(
        zip(table["crank"].values, table["rod"].values, np.sin(table["pressure"].values), strict=True)
    ):
        assert (a == s.number("crank")) == (row == 0) and sine == pytest.approx((a + 0.05) / b)
        assert math.sqrt((b + a) ** 2 - 0.05**2) - math.sqrt((b - a) ** 2 - 0.05**2) == pytest.approx(0.207)
    a, b = s.number("crank"), s.number("rod")
    assert math.sqrt((b + a) ** 2 - 0.05**2) - math.sqrt((b - a) ** 2 - 0.05**2) == pytest.approx(0.207)


def test_all_crank_rockers_of_a_demand_are_told():
    """Both sides of the chord, and every root of a stated distance of the pivots; the one that is taken first."""
    found = synthesised("crank_rocker: {K: 1.1, swing: 40 deg, rocker: 300 mm}")
    (table,) = [one for one in tables(found) if one.name == "synthesis_solutions"]
    other = synthesised("crank_rocker: {K: 1.1, swing: 40 deg, rocker: 300 mm, beyond: true}").s
    for row, s in enumerate((found.s, other)):
        for key in ("crank", "rod", "frame", "transmission"):
            assert table[key].values[row] == pytest.approx(s.number(key), rel=1e-9)
    again = synthesised(
        f"crank_rocker: {{K: 1.1, swing: 40 deg, rocker: 300 mm, frame: {found.s.number('frame')}}}"
    )
    (table,) = [one for one in tables(again) if one.name == "synthesis_solutions"]
    assert table["frame"].values == pytest.approx([found.s.number("frame")] * len(table["frame"].values))


def test_a_function_is_met_in_its_points_and_nowhere_worse_than_told():
    found = synthesised("function: {y: log10 x, x: [1, 2], crank_from: 315 deg, crank_turn: 60 deg, "
                        "rocker_from: 180 deg, rocker_turn: -90 deg, frame: 400 mm}")  # fmt: skip
    table, bar = found.design.table, found.design.bar
    phi, psi = (np.asarray(table[key].values, float) for key in ("phi", "psi"))
    assert np.angle(bar.rocker(phi) * np.exp(-1j * psi)) == pytest.approx(np.zeros(3), abs=1e-9)
    x = np.linspace(1, 2, 20001)
    wanted = np.pi - np.pi / 2 * np.log10(x) / np.log10(2)
    off = np.angle(bar.rocker(np.radians(315 + 60 * (x - 1))) * np.exp(-1j * wanted))
    assert np.max(np.abs(off)) == pytest.approx(found.s.number("error"), rel=1e-7)
    (course_table,) = [one for one in tables(found) if one.name == "synthesis_course"]
    shown = {key: np.asarray(course_table[key].values, float) for key in ("x", "psi_wanted", "error")}
    assert shown["error"] == pytest.approx(np.interp(shown["x"], x, off), abs=1e-6)
    assert shown["psi_wanted"] == pytest.approx(np.interp(shown["x"], x, wanted), abs=1e-6)


def test_a_linkage_goes_through_three_stated_pairs_of_angles():
    """Between them it keeps its assembly: the joint, by circles, follows without a jump."""
    found = synthesised(
        "function: {pairs: [[20 deg, 35 deg], [35 deg, 45 deg], [50 deg, 60 deg]], frame: 100 mm}, round: 1 mm"
    )
    a, b, c = (found.s.number(key) for key in ("crank", "rod", "rocker"))
    (way,) = [one for one in tables(found) if one.name == "synthesis_course"]
    phi, psi, mu = (np.asarray(way[key].values, float) for key in ("phi", "psi", "transmission"))
    pin, end = a * np.exp(1j * phi), 0.1 + c * np.exp(1j * psi)
    assert np.abs(end - pin) == pytest.approx(np.full(len(phi), b), rel=1e-9)
    assert np.degrees(psi[[0, 45, 90]]) == pytest.approx([35, 45, 60], abs=1e-9)
    assert np.abs(np.diff(psi)).max() < 0.01
    angle = np.abs(np.angle((pin - end) / (0.1 - end)))
    assert mu == pytest.approx(np.minimum(angle, np.pi - angle), abs=1e-9)
    assert found.s.number("transmission") == pytest.approx(mu.min(), abs=1e-6)
    assert found.s.number("pairs_taken") == pytest.approx(
        rounded_off(*(round(1e3 * x) for x in (a, b, c))), abs=1e-9
    )


def test_a_known_linkage_is_found_again_from_three_of_its_pairs():
    """Its transmission angle is least on the way, where the crank lies on the line of the pivots."""
    a, b, c, d = 0.04, 0.11, 0.09, 0.1
    pairs = []
    for phi in np.radians([-40, 10, 60]):
        pin = a * np.exp(1j * phi) - d
        turned = np.arccos((abs(pin) ** 2 + c**2 - b**2) / (2 * abs(pin) * c))
        pairs.append([float(phi), float(np.angle(pin) - turned)])
    s = synthesised(f"function: {{pairs: {pairs}, frame: {d}}}").s
    assert [s.number(key) for key in ("crank", "rod", "rocker")] == pytest.approx([a, b, c], rel=1e-9)
    least = np.arccos((b**2 + c**2 - (d - a) ** 2) / (2 * b * c))
    assert s.number("transmission") == pytest.approx(least, rel=1e-9)


def rounded_off(a, b, c):
    """By how much the rocker of whole millimetres misses 35, 45 and 60 degrees, rad: by the triangle of its joint."""
    missed = []
    for phi, psi in np.radians([[20, 35], [35, 45], [50, 60]]):
        pin = a * np.exp(1j * phi) - 100
        turned = np.arccos((abs(pin) ** 2 + c**2 - b**2) / (2 * abs(pin) * c))
        missed.append(min(abs(np.angle(pin) + side * turned - psi) for side in (1, -1)))
    return max(missed)


def synthesised(text):
    return course.solve(loading.loads(f"language: en\nsynthesis: {{{text}}}\n")).synthesis


def test_a_body_goes_through_its_three_positions():
    """Both pins keep their distances from their pivots; the mechanism that takes them leads the body there."""
    draw, met = random.Random(3), 0
    for _ in range(120):
        poses = [
            [draw.uniform(-0.1, 0.1), draw.uniform(-0.1, 0.1), draw.uniform(-0.6, 0.6)] for _ in range(3)
        ]
        points = [[draw.uniform(-0.1, 0.1), draw.uniform(-0.1, 0.1)] for _ in range(2)]
        try:
            s = synthesised(f"body: {{positions: {poses}, points: {points}}}").s
        except ProblemError as error:
            told = error.problems[0].text()
            assert any(why in told for why in ("different assemblies", "another order", "links do not meet"))
            continue
        met += 1
        for pivot, key, point in (("crank", "crank", points[0]), ("rocker", "rocker", points[1])):
            centre = complex(s.number(f"{pivot}_pivot_x"), s.number(f"{pivot}_pivot_y"))
            places = [complex(x, y) + np.exp(1j * angle) * complex(*point) for x, y, angle in poses]
            assert [abs(place - centre) for place in places] == pytest.approx([s.number(key)] * 3, rel=1e-9)
        assert s.number("rod") == pytest.approx(abs(complex(*points[0]) - complex(*points[1])), rel=1e-9)
    assert met > 5


def test_between_two_positions_the_best_transmission_angle_is_taken():
    """On every side that is stated, and with every other rocker, it is worse."""
    poses = "body: {positions: [[0, 0, 0], [90 mm, 40 mm, 50 deg]], points: [[0, 0], [80 mm, 20 mm]], crank: 70 mm"
    found = synthesised(f"{poses}}}")
    best, rocker = found.s.number("transmission"), found.s.number("rocker")
    others = []
    for part in (0.8, 0.99, 1.01, 1.2):
        others.append(synthesised(f"{poses}, rocker: {part * rocker}}}").s.number("transmission"))
    for crank in ("left", "right"):
        for side in ("left", "right"):
            one = synthesised(f"{poses}, crank_pivot: {crank}, rocker_pivot: {side}}}").s
            assert (one.number("off_A") > 0) == (crank == "left") and (one.number("off_B") >= 0) == (
                side == "left"
            )
            others.append(one.number("transmission"))
    assert max(others) == pytest.approx(best, rel=1e-9) and min(others) < 0.9 * best
    (table,) = [one for one in tables(found) if one.name == "synthesis_solutions"]
    angles = [*table["transmission"].values]
    assert angles == sorted(angles, reverse=True) and angles[0] == best
    (table,) = [one for one in tables(found) if one.name == "synthesis_family"]
    for row in (60, 80):
        size = table["rocker"].values[row]
        one = synthesised(f"{poses}, rocker: {size}, crank_pivot: left, rocker_pivot: left}}").s
        for key in ("off_B", "frame", "transmission"):
            assert one.number(key) == pytest.approx(table[key].values[row], rel=1e-9), key
