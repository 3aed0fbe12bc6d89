"""What is asked of a linkage comes out of the motion of the mechanism with its lengths; what cannot be is told."""

import math
import random

import numpy as np
import pytest

from tmm_report import course
from tmm_report.chapters.lever.synthesis.quantities import tables
from tmm_report.problems import ProblemError

QUICK, MANY = 6, 60

MECHANISMS = {
    "slider_crank": """
mechanism:
  frame: {{O: [0, 0], P: [0, synthesis.offset]}}
  guides: {{x: {{through: P}}}}
  links: {{1: {{points: {{O: 0, A: synthesis.crank}}}}, 2: {{points: {{A: 0, B: synthesis.rod}}}},
    3: {{points: [B], slides: x}}}}
  driver: {{link: 1, speed: 60 rpm}}
  assembly: {{B: right}}
transmission: 5 deg
""",
    "crank_rocker": """
mechanism:
  frame: {{O: [0, 0], C: [synthesis.frame_x, synthesis.frame_y]}}
  links: {{1: {{points: {{O: 0, A: synthesis.crank}}}}, 2: {{points: {{A: 0, B: synthesis.rod}}}},
    3: {{points: {{C: 0, B: synthesis.rocker}}}}}}
  driver: {{link: 1, speed: 60 rpm}}
  assembly: {{B: {side} of A-C}}
transmission: 5 deg
""",
    "slotted_link": """
mechanism:
  frame: {{O: [0, synthesis.frame], C: [0, 0], P: [0, synthesis.slide_line]}}
  guides: {{x: {{through: P}}, k: {{link: "3", through: C}}}}
  links: {{1: {{points: {{O: 0, A: synthesis.crank}}}}, 2: {{points: [A], slides: k}},
    3: {{points: {{C: 0, B: synthesis.link}}}}, 4: {{points: {{B: 0, D: synthesis.rod}}}},
    5: {{points: [D], slides: x}}}}
  driver: {{link: 1, speed: 60 rpm}}
  assembly: {{2-3: "+", D: right}}
""",
    "turning_guide": """
mechanism:
  frame: {{O: [0, 0], C: [0, synthesis.frame]}}
  guides: {{x: {{through: C}}, k: {{link: "3", through: C}}}}
  links: {{1: {{points: {{O: 0, A: synthesis.crank}}}}, 2: {{points: [A], slides: k}},
    3: {{points: {{C: 0, B: synthesis.arm}}}}, 4: {{points: {{B: 0, D: synthesis.rod}}}},
    5: {{points: [D], slides: x}}}}
  driver: {{link: 1, speed: 60 rpm}}
  assembly: {{2-3: "-", D: right}}
""",
}


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
    return course.solve(course.loads(text))


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
    found = course.solve(course.loads(text))
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
    found = course.solve(course.loads(f"language: en\n{asked}\n{MECHANISMS[kind].format(side='left')}"))
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
    return course.solve(course.loads(f"language: en\nsynthesis: {{{text}}}\n")).synthesis


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


# ---------------------------------------------------------------- what is told

CRANK = "crank_rocker: {K: 1.1, swing: 32 deg, rocker: 0.6 m"
TOLD = {
    "{}": ("synthesis", "the kind of the linkage must be stated by one key"),
    "{slider_crank: {stroke: 1 m, ratio: 4}, dwell: {}}": ("synthesis.dwell.crank", "missing"),
    "{slider_crank: {ratio: 4}}": ("synthesis.slider_crank", "the stroke must be stated once"),
    "{slider_crank: {mean_speed: 1 m/s, ratio: 4}}": ("synthesis.slider_crank", "go together"),
    "{slider_crank: {stroke: 1 m, mean_speed: 1 m/s, speed: 60 rpm, ratio: 4}}": (
        "synthesis.slider_crank.speed", "one follows from the two others; stroke, alone or with"),
    "{slotted_link: {stroke: 1 m, K: 1.5, frame: 1 m, pressure_angle: 9 deg, transmission: 80 deg}}": (
        "synthesis.slotted_link.transmission", "make 90° together"),
    "{slotted_link: {stroke: 1 m, crank: 1 m, frame: 1 m, rod_ratio: 2}}": (
        "synthesis.slotted_link.crank", "turning_guide is such a mechanism; less than 1000 mm"),
    "{slotted_link: {stroke: 1 m, K: 1.5, swing: 1 rad, rod_ratio: 2}}": (
        "synthesis.slotted_link", "K or swing, with crank or frame; or crank and frame"),
    "{turning_guide: {stroke: 1 m, K: 1.5, frame: 1 m, rod_ratio: 2, transmission: 70 deg}}": (
        "synthesis.turning_guide.transmission", "30 deg"),
    "{slider_crank: {stroke: 1 m}}": ("synthesis.slider_crank", "nothing says how long the rod is"),
    "{slider_crank: {stroke: 1 m, K: 1.2, ratio: 3, offset: 1 cm}}": (
        "synthesis.slider_crank.ratio", "its ratio follows"),
    "{slider_crank: {stroke: 1 m, K: 1.2, ratio: 3, offset_ratio: 1}}": (
        "synthesis.slider_crank.K", "follows from the ratios"),
    "{slider_crank: {stroke: 1 m, ratio: 3, offset_ratio: 2.5}}": (
        "synthesis.slider_crank.offset_ratio", "at most 2 with this ratio"),
    "{slider_crank: {stroke: 120 mm, K: 1.5, pressure_angle: 20 deg}}": (
        "synthesis.slider_crank.pressure_angle", "the least is"),
    "{slider_crank: {stroke: 120 mm, K: 1.2, ratio: 4, pressure_angle: 20 deg}}": (
        "synthesis.slider_crank.pressure_angle", "more than the permitted 20 deg"),
    "{slider_crank: {stroke: 120 mm, K: 12}}": ("synthesis.slider_crank.K", "1 … 10"),
    f"{{{CRANK}, crank: 170 mm}}}}": ("synthesis.crank_rocker.crank", "less than 165.382 mm"),
    f"{{{CRANK}, crank: 1 mm}}}}": ("synthesis.crank_rocker.crank", "assembled anew"),
    f"{{{CRANK}, rod: 3 m}}}}": ("synthesis.crank_rocker.rod", "less than"),
    f"{{{CRANK}, frame: 3 m}}}}": ("synthesis.crank_rocker.frame", "this distance of the pivots"),
    f"{{{CRANK}, frame: 1 m, rod: 1 m}}}}": ("synthesis.crank_rocker.frame", "stated once"),
    f"{{{CRANK}, crank_at: down}}}}": ("synthesis.crank_rocker.crank_at", "lies that way"),
    "{crank_rocker: {swing: 60 deg, rocker: 0.3 m, crank: 0.1 m}}": ("synthesis.crank_rocker.crank", "half the chord"),
    "{crank_rocker: {swing: 60 deg, rocker: 0.3 m, frame: 0.2 m}}": (
        "synthesis.crank_rocker.frame", "more than 300 mm"),
    "{slotted_link: {stroke: 1 m, K: 1, frame: 1 m, rod: 1 m}}": ("synthesis.slotted_link.K", "different times"),
    "{slotted_link: {stroke: 1 m, K: 1.5, rod: 1 m}}": ("synthesis.slotted_link", "exactly one of: frame, crank"),
    "{slotted_link: {stroke: 1 m, K: 1.5, frame: 1 m, rod: 1 mm}}": ("synthesis.slotted_link.rod", "too short"),
    "{turning_guide: {stroke: 1 m, K: 1.5, frame: 1 m, rod_ratio: 2, pressure_angle: 20 deg}}": (
        "synthesis.turning_guide.pressure_angle", "30 deg"),
    "{function: {y: sinh x, x: [1, 2], crank_from: 0, crank_turn: 1, rocker_from: 1, rocker_turn: 1, frame: 1 m}}": (
        "synthesis.function.y", "log10 x, ln x"),
    "{function: {y: x^2, x: [-1, 1], crank_from: 0, crank_turn: 1, rocker_from: 1, rocker_turn: 1, frame: 1 m}}": (
        "synthesis.function.x", "equal ones at its ends"),
    "{function: {y: x^2, x: [0, 1], crank_from: 0, crank_turn: 3, rocker_from: 0, rocker_turn: 3, frame: 1 m}}": (
        "synthesis.function", "other angles"),
    "{body: {positions: [[0, 0, 0], [1, 0, 0], [2, 0, 0]], points: [[0, 0], [1, 1]]}}": (
        "synthesis.body.points", "infinitely far"),
    "{body: {positions: [[0, 0, 0], [1, 0, 1], [2, 1, 0]], points: [[0, 0], [0, 0]]}}": (
        "synthesis.body.points", "at one place"),
    "{body: {positions: [[0, 0, 0]], points: [[0, 0], [0, 1]]}}": ("synthesis.body.positions", "2 expected, 1 found"),
    "{body: {positions: [[0, 0, 0], [1, 0, 1]], points: [[0, 0], [0, 1]]}}": (
        "synthesis.body", "the crank must be stated"),
    "{slider_crank: {stroke: 120 mm, ratio: 4}, round: 300 mm}": ("synthesis.round", "at most 60 mm"),
    "{crank_rocker: {K: 1.1, swing: 40 deg, rocker: 300 mm, crank: 102 mm}, round: 140 mm}": (
        "synthesis.round", "no longer goes through its motion"),
    "{body: {positions: [[0, 0, 0], [1, 0, 1]], points: [[0, 0], [0, 1]], crank: 0.4}}": (
        "synthesis.body.crank", "at least 500 mm"),
    "{body: {positions: [[0, 0, 0], [0, 0, 1]], points: [[0, 0], [0, 1]], crank: 0.4}}": (
        "synthesis.body.points", "at one place in both positions"),
    "{body: {positions: [[0, 0, 0], [1, 0, 1], [2, 1, 0]], points: [[0, 0], [0, 1]], rocker: 1}}": (
        "synthesis.body.rocker", "leave it out, or state two positions"),
    "{body: {positions: [[0, 0, 0], [90 mm, 40 mm, 50 deg]], points: [[0, 0], [80 mm, 20 mm]], crank: 60 mm, "
    "rocker: 60 mm, rocker_pivot: right}}": ("synthesis.body", "another length of the crank, another side"),
    "{body: {positions: [[76 mm, 69 mm, 0 deg], [18 mm, -93 mm, -21 deg], [59 mm, -17 mm, -26 deg]], "
    "points: [[10 mm, 41 mm], [35 mm, -25 mm]]}}": ("synthesis.body.positions", "the order 2, 3, 1"),
    "{body: {positions: [[-26 mm, -6 mm, -13 deg], [21 mm, -64 mm, 30 deg], [39 mm, 7 mm, -35 deg]], "
    "points: [[-35 mm, 38 mm], [29 mm, 62 mm]]}}": ("synthesis.body", "its links do not meet"),
    "{crank_rocker: {swing: 60 deg, rocker: 200 mm, K: 1.3, frame: 600 mm}}": (
        "synthesis.crank_rocker.frame", "from some 200 mm to 298.753 mm"),
    "{crank_rocker: {swing: 60 deg, rocker: 200 mm, K: 1.3, frame: 300 mm}}": (
        "synthesis.crank_rocker.frame", "beyond: true"),
    "{function: {pairs: [[50 deg, 35 deg], [35 deg, 45 deg], [80 deg, 60 deg]], frame: 1 m}}": (
        "synthesis.function.pairs", "in the order"),
    "{function: {pairs: [[30 deg, 40 deg], [50 deg, 60 deg], [80 deg, 90 deg]], frame: 1 m}}": (
        "synthesis.function", "infinitely long"),
    "{slider_crank: {stroke: 120 mm, K: 3.2}}": ("synthesis.slider_crank.K", "less than 3"),
    "{slider_crank: {stroke: 120 mm, K: 1.6, ratio: 19}}": (
        "synthesis.slider_crank.ratio", "at most 6.95263 with this time ratio"),
    "{slider_crank: {stroke: 120 mm, K: 1.2, offset: 450 mm}}": (
        "synthesis.slider_crank.offset", "at most 408.682 mm"),
    "{slotted_link: {stroke: 400 mm, K: 2.2, frame: 420 mm, rod: 33 mm}}": (
        "synthesis.slotted_link.rod", "turns back before the slotted link does; a rod longer than"),
    "{dwell: {crank: 50 mm, coupler: 125 mm, rocker: 125 mm, frame: 100 mm, point: [125 mm, 125 mm], "
    "angles: [140 deg, 220 deg, 180 deg]}}": ("synthesis.dwell.angles", "in another order"),
    "{dwell: {crank: 50 mm, coupler: 125 mm, rocker: 125 mm, frame: 100 mm, point: [-150 mm, 75 mm], "
    "angles: [30 deg, 90 deg, 150 deg]}}": ("synthesis.dwell.angles", "stand across the slide line"),
    "{function: {y: ln x, x: [2, 1], crank_from: 0, crank_turn: 1, rocker_from: 1, rocker_turn: 1, frame: 1 m}}": (
        "synthesis.function.x", "goes upwards"),
    "{function: {y: x^-3, x: [-1, 2], crank_from: 1, crank_turn: 1, rocker_from: 1, rocker_turn: 1, frame: 1 m}}": (
        "synthesis.function.x", "no finite values"),
    "{function: {y: tan x, x: [0, 2], crank_from: 1, crank_turn: 1, rocker_from: 1, rocker_turn: 1, frame: 1 m}}": (
        "synthesis.function.x", "no finite values"),
    "{function: {y: exp x, x: [0, 800], crank_from: 1, crank_turn: 1, rocker_from: 1, rocker_turn: 1, frame: 1 m}}": (
        "synthesis.function.x", "no finite values"),
    "{function: {y: x, x: [0, 3], crank_from: 0.2, crank_turn: 1, rocker_from: 0.7, rocker_turn: 1, frame: 1 m}}": (
        "synthesis.function", "infinitely long"),
    "{dwell: {crank: 50 mm, coupler: 125 mm, rocker: 125 mm, frame: 100 mm, point: [0, 0], angles: [0, 0, 1]}}": (
        "synthesis.dwell.angles", "one line"),
    "{dwell: {crank: 50 mm, coupler: 20 mm, rocker: 20 mm, frame: 200 mm, point: [0, 0], angles: [0, 1, 2]}}": (
        "synthesis.dwell.crank", "cannot turn round"),
}  # fmt: skip


@pytest.mark.parametrize("text", TOLD, ids=[f"{key}-{n}" for n, (key, _) in enumerate(TOLD.values())])
def test_what_cannot_be_is_told(text):
    path, words = TOLD[text]
    told = problems(f"synthesis: {text}\n")
    assert any(problem.key == path and words in problem.text() for problem in told), [
        one.text() for one in told
    ]


def problems(text):
    with pytest.raises(ProblemError) as caught:
        course.loads(f"language: en\n{text}")
    return caught.value.problems


ONE = MECHANISMS["slider_crank"].format()


def test_the_mechanism_takes_what_there_is():
    (told,) = problems(
        ONE.replace("A: synthesis.crank", "A: 100 mm").replace("synthesis.offset", "0").lstrip()
    )
    assert told.key == "mechanism.links.2.points.B" and "there is no synthesis" in told.text()
    wrong = ONE.replace("B: synthesis.rod", "B: synthesis.rocker")
    (told,) = problems(f"synthesis: {{slider_crank: {{stroke: 120 mm, ratio: 4}}}}\n{wrong}")
    assert told.key == "mechanism.links.2.points.B"
    assert "one of synthesis.crank, synthesis.rod, synthesis.offset" in told.text()


def test_a_mistake_of_the_synthesis_is_told_once():
    (told,) = problems(f"synthesis: {{slider_crank: {{stroke: 120 mm, ratio: 0.4}}}}\n{ONE}")
    assert told.key == "synthesis.slider_crank.ratio"
    (told,) = problems(f"synthesis: {{slider_crank: {{stroke: 120 mm}}}}\n{ONE}")
    assert told.key == "synthesis.slider_crank"


def test_places_and_directions_may_be_taken():
    wrong = ONE.replace("P: [0, synthesis.offset]", "P: [0, l_OA]").replace(
        "{through: P}", "{through: P, angle: synthesis.turn}"
    )
    told = {
        one.key: one.text()
        for one in problems(f"synthesis: {{slider_crank: {{stroke: 120 mm, ratio: 4}}}}\n{wrong}")
    }
    assert "places in the frame follow from no links" in told["mechanism.frame.P.1"]
    assert "the synthesis finds no turn" in told["mechanism.guides.x.angle"]


def test_a_demand_of_one_of_several_sliders_is_asked_about():
    text = "language: en\nsynthesis: {slider_crank: {stroke: 120 mm, ratio: 4}}\n" + ONE
    other = "4: {points: {A: 0, E: synthesis.rod}}, 5: {points: [E], slides: x}"
    more = text.replace("3: {points: [B], slides: x}", f"3: {{points: [B], slides: x}}, {other}")
    more = more.replace("{B: right}", "{B: right, E: left}")
    assert any("several links" in one.text() for one in course.doubts(course.solve(course.loads(more))))
    named = more.replace("ratio: 4}}", "ratio: 4}, output: E}")
    found = course.solve(course.loads(named))
    assert not course.doubts(found) and found.synthesis.s.number("stroke_met") == pytest.approx(
        0.12, rel=1e-9
    )
