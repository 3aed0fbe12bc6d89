"""The contours written out: every formula gives what the solver finds by its own way, at every position."""

from __future__ import annotations

import math

import numpy as np
import pytest
from conftest import FILES, read

from tmm_report import course, loading
from tmm_report.chapters.lever.kinematics.contours.nodes import Bearing, Branched, total
from tmm_report.chapters.lever.kinematics.contours.solve import contours
from tmm_report.chapters.lever.kinematics.contours.solve import tables as contour_tables
from tmm_report.chapters.lever.kinematics.contours.terms import WrittenSystem
from tmm_report.chapters.lever.kinematics.contours.translating import Translating
from tmm_report.chapters.lever.kinematics.solve import positions as kinematics
from tmm_report.chapters.lever.structure import solve as structure
from tmm_report.i18n import Translator
from tmm_report.mechanics.lever.dyads import Dyad
from tmm_report.quantity.formula import Formula, Number, Var

NAMES = [path.stem for path in FILES]
LEAST = 1e-3  # closeness to a singular position, nearer to which digits are lost

SLOTS = """
language: en
mechanism:
  frame: {O: [0, 0], C: [-20 mm, -210 mm], Q: [150 mm, -180 mm]}
  guides:
    k: {through: M, angle: 12 deg, link: 3}
    m: {through: N, angle: 100 deg, link: 3}
  links:
    1: {points: {O: 0, A: [55 mm, 20 mm]}}
    2: {points: {A: 0, S2: [0, 12 mm]}, slides: {guide: k, at: S2}}
    3: {points: {C: 0, M: [15 mm, 10 mm], N: [90 mm, -30 mm], S3: [200 mm, 25 mm]}}
    4: {points: {Q: 0, B: [10 mm, 190 mm], S4: [40 mm, 90 mm]}}
    5: {points: {B: 0, E: [30 mm, 8 mm]}, slides: {guide: m, at: E, angle: 35 deg}}
  driver: {link: 1, speed: 90 rpm, rotation: clockwise, zero: {angle: 25 deg}}
  assembly: {2-3: +, 4-5: +}
"""
YOKE = """
language: en
mechanism:
  frame: {O: [0, 0], P: [0, 35 mm], H: [150 mm, -140 mm]}
  guides:
    x: {through: P, angle: 20 deg}
    k: {through: M, angle: 80 deg, link: 3}
  links:
    1: {points: {O: 0, A: 60 mm}}
    2: {points: {A: 0, S2: [4 mm, 15 mm]}, slides: {guide: k, at: S2}}
    3: {points: {D: 0, M: [12 mm, 0], E: [70 mm, 20 mm]}, slides: {guide: x, at: E}}
    4: {points: {E: 0, F: [200 mm, 40 mm], S4: [90 mm, 30 mm]}}
    5: {points: {H: 0, F: [0, 230 mm]}}
  driver: {link: 1, period: 0.5 s, rotation: counter-clockwise, zero: {angle: 0 deg}}
  assembly: {F: left of E-H}
"""


def moved(variant: course.Variant) -> kinematics.Kinematics:
    assert variant.lever is not None
    return kinematics.solve(variant.lever.positions, structure.solve(variant.lever.mechanism))


def regular(found: kinematics.Kinematics) -> np.ndarray:
    """The positions at which digits are left."""
    sines = np.array(list(found.table.sines.values()))
    return np.all(np.nan_to_num(sines) > LEAST, axis=0)


def off(found: kinematics.Kinematics) -> float:
    """The worst disagreement of a formula with the solver, beside the quantity's own size and that of its kind."""
    written, there = contours(found, 0), regular(found)
    arm = max(float(np.nanmax(np.abs(found.table.places))), 1e-3)
    omega, worst = abs(found.omega), 0.0
    sizes = {"m": arm, "m/s": omega * arm, "m/s²": omega**2 * arm, "rad/s": omega, "rad/s²": omega**2}
    for formula, values in written.bench.checks:
        ours, theirs = np.broadcast_arrays(formula.value, values)
        size = max(sizes[formula.unit], float(np.max(np.abs(theirs[there]), initial=0.0)))
        worst = max(worst, float(np.max(np.abs(ours - theirs)[there], initial=0.0)) / size)
        assert np.isfinite(ours[there]).all(), formula.ref
    return max(worst, *(_system_off(one, written.bench.columns, there) for one in written.groups), 0.0)


def _system_off(written, columns, there) -> float:
    """Of a group above class II: the contours close, and both linear systems hold with the solver's rates."""
    if not isinstance(written, WrittenSystem):
        return 0.0
    rows = np.array([[columns[key][1] for key in row] for row in written.rows])[..., there]
    worst = max(float(np.max(np.abs(one.value[there]))) for one in written.residuals)
    for found, known in ((written.rates, rows[:, -2]), (written.bends, rows[:, -1])):
        rates = np.array([np.broadcast_to(one.number, len(there))[there] for one in found])
        left = np.einsum("ijp,jp->ip", rows[:, :-2], rates)
        worst = max(worst, float(np.max(np.abs(left - known)) / max(np.max(np.abs(known)), 1e-9)))
    return worst


@pytest.mark.parametrize("name", NAMES)
def test_formulas_agree_with_the_solver(name):
    found = moved(read(name))
    assert regular(found).any()
    assert off(found) < 1e-9


@pytest.mark.parametrize("text", [SLOTS, YOKE])
def test_guides_at_any_angle_with_offsets_and_on_moving_links(text):
    assert off(moved(loading.loads(text))) < 1e-10


def test_all_five_kinds_of_dyads_are_among_these():
    kinds = set()
    for name in NAMES:
        lever = read(name).lever
        kinds |= {g.kind for g in structure.solve(lever.mechanism).linkage.groups if type(g) is Dyad}
    assert kinds == {1, 2, 3, 4, 5}


def test_a_wrong_sign_would_be_seen():
    found = moved(read("crank_rocker"))
    formula, values = next(
        (f, v) for f, v in contours(found, 0).bench.checks if f.ref is not None and f.ref.key == "e_3"
    )
    assert not np.allclose(-formula.value, values)
    assert np.allclose(formula.value, values)


def test_a_central_slider_crank_is_the_textbooks():
    """S = r cos φ + √(l² − (r sin φ)²), whatever solved it."""
    found = moved(read("compressor_inline"))
    bench = contours(found, 0).bench
    lengths = bench.known_lengths
    r, length = lengths["l_OA"], lengths["l_AB"]
    A = found.table.place("A")
    s = bench.columns["s_3"][1]
    axis = found.linkage.mechanism.guides[next(iter(found.linkage.mechanism.guides))].direction
    along = (A * np.conj(axis)).real
    across = (A * np.conj(axis)).imag
    side = np.sign(s[0] - along[0])
    assert np.allclose(s, along + side * np.sqrt(length**2 - across**2), atol=1e-12)
    assert np.allclose(np.abs(A), r)


def test_the_numbers_of_a_formula_are_columns_of_the_results():
    found = moved(read("shaper"))
    table = {column.key: column for column in next(iter(contour_tables(found))).columns}
    for written in contours(found, 4).groups:
        for formula in (*written.positions, *written.velocities, *written.accelerations):
            if formula.ref.table == "contours":
                value = table[formula.ref.key].values[4]
                own = math.radians(value) if formula.unit == "deg" else value
                assert formula.written == pytest.approx(own, rel=1e-4, abs=1e-12)


@pytest.mark.parametrize("degrees", [0, 17, 45, 80, 90, 100, 179.5, -10, -50, -90, -120, -180 + 1e-3])
def test_a_bearing_is_printed_by_what_is_true_in_its_quadrant(degrees):
    """The number that is printed is worked out again from the printed arctangent."""
    x, y = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    bearing = Bearing(Var("y_B", y, "m"), Var("x_B", x, "m"))
    assert math.degrees(bearing.value) == pytest.approx(degrees)
    text = Formula("phi_1", bearing, "deg").latex(Translator("en"))
    assert ("180" in text) == (abs(degrees) > 135)
    assert ("90" in text.split("=")[1]) == (45 < abs(degrees) <= 135)


def test_a_root_has_the_sign_of_the_printed_position():
    signs = np.array([1.0, -1.0])
    root = Branched(Number(5), Number(2), signs)
    assert root.value.tolist() == [7, 3]
    one, other = (Formula("s_1", root, index=k).latex(Translator("en")) for k in (0, 1))
    assert "5+2" in one.replace(" ", "") and "5-2" in other.replace(" ", "")


def test_a_sum_rather_begins_without_a_minus():
    a, b = Var("a_1", 2.0), Var("b_1", 3.0)
    assert Formula("x_1", total([(-1, a), (1, b)])).latex(Translator("en")).split("=")[1].strip()[0] == "b"
    assert total([(-1, a), (1, None)]).value == -2
    assert total([]).value == 0


# --- links that only translate


LINKED = """
language: en
mechanism:
  frame: {{O: [0, 0], Q: [{x} mm, {y} mm]}}
  links:
    1: {{points: {{O: 0, K: 120 mm}}}}
    7: {{points: {{K: 0, T: {rod} mm, S: [100 mm, 30 mm]}}}}
    4: {{points: {{Q: 0, T: {rocker} mm}}}}
  driver: {{link: 1, speed: -90 rpm, zero: {{angle: 40 deg}}}}
  assembly: {{T: {side} of K-Q}}
"""
PARALLEL = {"x": 180, "y": 240, "rod": 300, "rocker": 120, "side": "right"}


def translated(**other):
    """The groups of a four-bar linkage that are written as having a link that only translates, and its motion."""
    found = moved(loading.loads(LINKED.format(**(PARALLEL | other))))
    return [one for one in contours(found, 1).groups if isinstance(one, Translating)], found


@pytest.mark.parametrize("name", ["parallelogram_drive", "press"])
def test_a_link_kept_parallel_is_told_to_translate_and_does_not_turn_anywhere(name):
    found = moved(read(name))
    (written,) = [one for one in contours(found, 2).groups if isinstance(one, Translating)]
    assert "2" in written.links and off(found) < 1e-9
    motion = found.cycle.motion(np.linspace(0, found.cycle.sweep, 1001)[1:-1] + 1e-3)
    assert np.abs(motion.angular_velocity("2")).max() < 1e-9 * abs(found.omega)
    assert np.abs(motion.angular_acceleration("2")).max() < 1e-7 * found.omega**2
    one, other = (motion.angular_velocity(link) for link in written.turned)
    assert one == pytest.approx(other * np.ones(motion.shape), rel=1e-9)
    a, b, c, d = (np.abs(motion.place(p) - motion.place(q)) for p, q in sides_of(written.corners))
    assert a == pytest.approx(c * np.ones(a.shape)) and b == pytest.approx(d * np.ones(b.shape))
    lengths = [float(one.number) for one in written.sides]
    assert lengths[::2] == pytest.approx(lengths[1::2])


def sides_of(corners):
    return list(zip(corners, (*corners[1:], corners[0]), strict=True))


@pytest.mark.parametrize(("x", "y", "side"), [(180, 240, "right"), (-300, 0, "right"), (84, -288, "left")])
def test_a_four_bar_of_any_names_and_direction_is_told(x, y, side):
    (written,), found = translated(x=x, y=y, side=side)
    assert written.links == ("7",) and written.turned == ("4", "1")
    assert written.corners == ("O", "K", "T", "Q") and written.at == "K" and not written.by
    assert float(written.angle.number) == pytest.approx(math.atan2(y, x), abs=1e-12)
    assert off(found) < 1e-9


@pytest.mark.parametrize(
    "other",
    [{"rod": 300.001}, {"rocker": 121}, {"x": 180.5}, {"rod": 350, "rocker": 170}],
)
def test_what_is_no_parallelogram_turns(other):
    written, found = translated(**other)
    assert not written and off(found) < 1e-8


def test_a_crossed_contour_turns():
    """Opposite sides are equal too, but the coupler turns against the crank."""
    first, second = (translated(side=side) for side in ("left", "right"))
    told = [bool(written) for written, _ in (first, second)]
    turns = [
        np.abs(found.cycle.motion(np.linspace(0.3, 2.0, 50)).angular_velocity("7")).max() > 1e-6
        for _, found in (first, second)
    ]
    assert told == [False, True] and told == [not turning for turning in turns]


def test_the_slotted_link_of_a_scotch_yoke_only_translates():
    found = moved(read("scotch_yoke"))
    assert contours(found, 0).slotted == ["3"]
    motion = found.cycle.motion(np.linspace(0, found.cycle.sweep, 200))
    assert np.abs(motion.angular_velocity("3")).max() == 0
    assert not contours(moved(read("compressor")), 0).slotted


ON_SLIDER = """
language: en
mechanism:
  frame: {O: [0, 0]}
  guides: {x: {through: O}}
  links:
    1: {points: {O: 0, A: 50 mm}}
    2: {points: {A: 0, B: 200 mm, M: 120 mm}}
    3: {points: {B: 0, Q: [100 mm, 40 mm]}, slides: {guide: x, at: B}}
    5: {points: {M: 0, N: [100 mm, 40 mm], S: [30 mm, -20 mm]}}
    6: {points: {Q: 0, N: 80 mm}}
  driver: {link: 1, speed: 60 rpm, zero: {angle: 20 deg}}
  assembly: {B: right, N: left of M-Q}
"""


def test_a_link_parallel_to_a_side_of_a_slider_translates_too():
    found = moved(loading.loads(ON_SLIDER))
    *_, written = contours(found, 1).groups
    assert isinstance(written, Translating) and written.links == ("5",) and written.by == "3"
    assert written.corners == ("B", "M", "N", "Q") and written.turned == ("6", "2")
    assert off(found) < 1e-9
    motion = found.cycle.motion(np.linspace(0.01, 6.2, 300))
    assert np.abs(motion.angular_velocity("5")).max() < 1e-9 * found.omega
    assert motion.velocity("S") == pytest.approx(motion.velocity("M"), abs=1e-9)


BETWEEN = """
language: en
mechanism:
  frame: {O: [0, 0]}
  guides: {x: {through: O}}
  links:
    1: {points: {O: 0, A: 50 mm, P: 90 mm}}
    2: {points: {A: 0, B: 200 mm, M: 120 mm}}
    3: {points: [B], slides: x}
    5: {points: {P: 0, N: 120 mm}}
    6: {points: {M: 0, N: 40 mm}}
  driver: {link: 1, speed: 60 rpm, zero: {angle: 100 deg}}
  assembly: {B: right, N: SIDE of P-M}
"""


def test_a_link_parallel_to_one_that_turns_turns_with_it():
    found = [moved(loading.loads(BETWEEN.replace("SIDE", side))) for side in ("left", "right")]
    for one in found:
        assert not [w for w in contours(one, 1).groups if isinstance(w, Translating)] and off(one) < 1e-9
    motions = [one.cycle.motion(np.linspace(0, 0.5, 20)) for one in found]
    alike = [np.allclose(m.angular_velocity("5"), m.angular_velocity("2"), rtol=1e-9) for m in motions]
    assert any(alike)
