"""A cycle of several turns of the driving link: positions, loads stroke by stroke, what is wrong with them."""

from __future__ import annotations

import math
import re
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from conftest import examples, read, solved, stating
from hypothesis import given, settings
from hypothesis import strategies as st
from loaded import loaded
from notes import note as note_of

from tmm_report import course, loading, render, stack
from tmm_report import results as of_results
from tmm_report.chapters.lever.kinetostatics.given import Loads
from tmm_report.chapters.lever.kinetostatics.solve.law_arguments import reading
from tmm_report.chapters.lever.kinetostatics.solve.load_breaks import breaks
from tmm_report.chapters.lever.moving import Moving, machine
from tmm_report.figures.charts.axes import position_marks
from tmm_report.figures.charts.graphs import Curve, graph
from tmm_report.mechanics.calculus.laws import ByDisplacement, ByStrokes
from tmm_report.mechanics.lever.mechanism import ZeroAngle
from tmm_report.problems import ProblemError

TURN = 2 * math.pi
MECHANISM = """
mechanism:
  frame: {O: [0, 0]}
  guides:
    y: {through: O, angle: 90 deg}
  links:
    1: {points: {O: 0, A: 60 mm, C: -60 mm}}
    2: {points: {A: 0, B: 230 mm, S2: 75 mm}, mass: 1.8 kg, mass_centre: S2, inertia: 0.017}
    3: {points: [B], slides: y, mass: 1.6 kg}
    4: {points: {C: 0, D: 230 mm, S4: 75 mm}, mass: 1.8 kg, mass_centre: S4, inertia: 0.017}
    5: {points: [D], slides: y, mass: 1.6 kg}
  driver: {link: 1, speed: 2200 rpm, DRIVER zero: {point: B, extreme: up}}
  assembly: {B: up, D: up}
loads:
  gravity: 0
  forces:
"""
FORCE = """
    - name: gas
      at: POINT
      direction: down
      LAW
"""
CURVES = {
    "intake": "[[0, 0.02 MPa], [0.05, -0.015 MPa], [1, -0.015 MPa]]",
    "compression": "[[0, 3.2 MPa], [0.05, 1.6 MPa], [0.2, 0.6 MPa], [0.5, 0.2 MPa], [1, -0.015 MPa]]",
    "power": "[[0, 3.2 MPa], [0.05, 4 MPa], [0.2, 2 MPa], [0.5, 0.8 MPa], [1, 0.25 MPa]]",
    "exhaust": "[[0, 0.02 MPa], [0.9, 0.02 MPa], [1, 0.25 MPa]]",
}
FOUR = tuple(CURVES)


def engine(driver: str = "turns: 2,", **laws: str) -> str:
    """The variant's text with a law of the gas for each point."""
    forces = (FORCE.replace("POINT", at).replace("LAW", law) for at, law in laws.items())
    return MECHANISM.replace("DRIVER", driver) + "".join(forces)


def by_ways(forward: str, back: str) -> str:
    ways = f"{{zero: up, forward: {CURVES[forward]}, back: {CURVES[back]}}}"
    return f"piston_diameter: 100 mm\n      by_displacement: {ways}"


def by_strokes(first: str = "", names: tuple[str, ...] = FOUR) -> str:
    strokes = "{" + ", ".join(f"{name}: {CURVES[name]}" for name in names) + "}"
    begun = f"first: {first}, " if first else ""
    return f"piston_diameter: 100 mm\n      by_displacement: {{zero: up, {begun}strokes: {strokes}}}"


@cache
def found(text: str) -> course.LeverFound:
    lever = course.solve(loading.loads(text)).lever
    assert lever is not None
    return lever


@cache
def whole() -> course.LeverFound:
    return found(engine(B=by_strokes("power"), D=by_strokes("compression")))


def halves() -> list[course.LeverFound]:
    """The same cycle as two variants of one turn each, as it had to be written without a cycle of two."""
    first = engine("", B=by_ways("power", "exhaust"), D=by_ways("power", "compression"))
    second = engine("", B=by_ways("intake", "compression"), D=by_ways("intake", "exhaust"))
    return [found(first), found(second)]


# ---------------------------------------------------------------- the whole cycle against its halves


@pytest.mark.parametrize("which", ["table", "diagram"])
def test_the_halves_of_the_cycle_are_its_two_turns(which):
    one, two = (getattr(half.kinetostatics, which) for half in halves())
    both = getattr(whole().kinetostatics, which)
    n = len(one.turned) - 1
    assert both.turned == pytest.approx(np.concatenate([one.turned[:-1], TURN + two.turned]), rel=1e-14)

    def same(values, *of_halves):
        expected = np.concatenate([np.broadcast_to(x, n + 1)[:-1] for x in of_halves])
        size = max(np.abs(expected).max(), 1.0)
        assert np.abs(np.broadcast_to(values, 2 * n + 1)[:-1] - expected).max() <= 1e-12 * size

    for name in ("balancing", "lever", "power"):
        same(getattr(both, name), getattr(one, name), getattr(two, name))
    for key, reaction in both.statics.reactions.items():
        for part in ("force", "moment"):
            same(getattr(reaction, part), *(getattr(h.statics.reactions[key], part) for h in (one, two)))
    for own, *parts in zip(both.loading.stated, one.loading.stated, two.loading.stated, strict=True):
        same(own, *parts)
    motion, turns = (f"{which}_values" if which == "diagram" else "values"), halves()
    for key, values in getattr(whole().kinematics, motion).items():
        same(values, *(getattr(half.kinematics, motion)[key] for half in turns))


def test_the_last_position_of_the_cycle_is_the_first():
    forces = whole().kinetostatics.table
    assert forces.balancing[-1] == forces.balancing[0]
    assert all(load[-1] == load[0] for load in forces.loading.stated)
    assert not all(load[12] == load[0] for load in forces.loading.stated)  # the next turn has other loads


def test_the_cycle_has_the_positions_of_a_turn_as_often_as_it_has_turns():
    positions = whole().kinematics.positions
    assert (positions.table, positions.diagram, positions.plans) == (24, 72, (1, 7))
    assert whole().kinematics.distinct == 12
    assert np.degrees(whole().kinematics.turned) == pytest.approx(np.arange(0, 721, 30))


def test_the_extremes_of_the_balancing_moment_are_those_of_both_halves():
    low, high = whole().kinetostatics.extremes
    ends = [half.kinetostatics.extremes for half in halves()]
    assert low.value == pytest.approx(min(end.value for end, _ in ends), rel=1e-12)
    assert high.value == pytest.approx(max(end.value for _, end in ends), rel=1e-12)
    assert (
        low.turned < TURN < high.turned
    )  # against the crank in the first power stroke, with it in the other turn


# ---------------------------------------------------------------- one turn said twice


def twice(name: str, turns: int = 2) -> course.LeverFound:
    lever = read(name).lever
    driver = replace(lever.mechanism.driver, turns=turns)
    positions = replace(
        lever.positions, table=turns * lever.positions.table, diagram=turns * lever.positions.diagram
    )
    mechanism = replace(lever.mechanism, driver=driver)
    return course.solve(stating(read(name), mechanism=mechanism, positions=positions, readings={})).lever


@pytest.mark.parametrize("name", ["v_engine", "shaper", "whitworth", "parallelogram_drive"])
def test_a_turn_stated_twice_repeats_itself(name):
    once, again = solved(name).lever, twice(name)
    n = once.kinematics.positions.table
    for key, values in once.kinematics.values.items():
        for start in (0, n):
            np.testing.assert_array_equal(again.kinematics.values[key][start : start + n + 1], values)
    for alone, same in zip(once.kinematics.travels, again.kinematics.travels, strict=True):
        np.testing.assert_array_equal(same.V[n:], alone.V)
        assert same.V_extremes == alone.V_extremes and same.time_ratio == alone.time_ratio
    if once.kinetostatics:
        expected = once.kinetostatics.table.balancing
        size = np.nanmax(np.abs(expected))
        for start in (0, n):
            assert again.kinetostatics.table.balancing[start : start + n + 1] == pytest.approx(
                expected, abs=1e-12 * size, nan_ok=True
            )


def test_a_driven_crank_goes_on_turning():
    """Its angle from position 0 grows by a turn with every turn of the driving link; that of a rocker does not."""
    turning = [t for t in twice("whitworth", 3).kinematics.travels if t.output.kind == "rocker"]
    assert turning and all(abs(t.S[-1]) == pytest.approx(3 * TURN) for t in turning)
    assert all(t.stroke == pytest.approx(3 * TURN) for t in turning)
    alone, same = (
        solved("crank_rocker").lever.kinematics.travels[0],
        twice("crank_rocker").kinematics.travels[0],
    )
    assert same.stroke == pytest.approx(alone.stroke, rel=1e-12) and same.far.turned == alone.far.turned


def test_variants_of_other_cycles_are_not_solved_together():
    once, again = (
        stating(read("v_engine"), mechanism=of.given.mechanism)
        for of in (solved("v_engine").lever, twice("v_engine"))
    )
    assert stack.topology(once.lever) != stack.topology(again.lever)


@pytest.mark.exhaustive
def test_a_cycle_of_two_turns_finds_in_a_stack_what_it_finds_alone():
    text = engine(B=by_strokes("power"), D=by_strokes("compression"))
    variants = [loading.loads(text.replace("2200", n)) for n in ("2200", "1900", "2500")]
    for variant, together in zip(variants, stack.solve_many(variants), strict=True):
        assert render(together, "json") == render(course.solve(variant), "json")


# ---------------------------------------------------------------- laws of the cycle


def test_by_angle_over_the_cycle_is_the_same_law():
    """Stated at the angles of the table positions; the strokes of the first cylinder begin there with jumps."""
    values = whole().kinetostatics.table.loading.stated[0]
    pairs = ", ".join(f"[{30 * k} deg, {value!r}]" for k, value in enumerate(values.tolist()))
    each = ", ".join(map(repr, values[:-1].tolist()))
    for law in (f"by_angle: [{pairs}]", f"by_position: [{each}]"):
        stated = found(engine(B=law)).kinetostatics.table.loading.stated[0]
        assert stated == pytest.approx(values, rel=1e-12)


def test_an_indicator_diagram_by_angle_is_of_pressures():
    pressures = "[[0, 3.2 MPa], [180 deg, 0.25 MPa], [540 deg, 0], [720 deg, 3.2 MPa]]"
    stated = found(engine(B=f"piston_diameter: 100 mm\n      by_angle: {pressures}"))
    expected = np.interp(np.arange(25) * 30, [0, 180, 540, 720], np.array([3.2e6, 0.25e6, 0, 3.2e6]))
    assert stated.kinetostatics.table.loading.stated[0] == pytest.approx(expected * math.pi / 400, rel=1e-12)


def test_the_gas_does_the_work_that_its_diagram_encloses():
    """Over 720°: area of the diagram times that of the piston times the stroke, + of strokes away from the zero."""
    lever = whole()
    of = machine(Moving(lever.kinematics, lever.kinetostatics))
    assert of.panels.period == pytest.approx(2 * TURN)
    stroke = 0.12
    for force in lever.given.loads.forces:
        curves = [np.array(curve) for curve in force.law.curves]
        areas = [np.sum(np.diff(x) * (y[1:] + y[:-1]) / 2) for x, y in (curve.T for curve in curves)]
        work = stroke * np.dot(areas, [1, -1, 1, -1])
        key = f"P_{force.at}"
        (moment,) = [part for load, part in of.moments if load.key == key]
        assert of.panels.total(moment) == pytest.approx(work, rel=1e-12)


@pytest.mark.parametrize("at", ["B", "D"])
def test_the_loads_are_smooth_between_their_breaks(at):
    """A line through three points of the cycle's force by the displacement, between two breaks, is straight."""
    lever = whole()
    cycle, (force,) = lever.kinematics.cycle, [f for f in lever.given.loads.forces if f.at == at]
    edges = breaks(Loads(0j, forces=(force,)), lever.kinematics)
    assert len(edges) == len(np.unique(np.round(edges, 9))) and edges.max() < 2 * TURN
    edges = np.append(edges, 2 * TURN)
    inside = edges[:-1, None] + np.diff(edges)[:, None] * np.array([0.2, 0.5, 0.8])
    x = cycle.motion(inside.ravel()).place(at).imag.reshape(inside.shape)
    force_of = reading(force, lever.kinematics, cycle.motion(inside.ravel()), inside.ravel())
    y = force_of.value.reshape(inside.shape)
    middle = y[:, 0] + (y[:, 2] - y[:, 0]) * (x[:, 1] - x[:, 0]) / (x[:, 2] - x[:, 0])
    assert y[:, 1] == pytest.approx(middle, abs=1e-9 * np.abs(y).max())
    assert 4 + 8 < len(edges) < 4 + 20  # ends of strokes and each point of each curve once, and no more


def test_a_kink_of_one_stroke_is_none_of_another():
    lever = whole()
    (force,) = [f for f in lever.given.loads.forces if f.at == "B"]
    edges = np.degrees(breaks(Loads(0j, forces=(force,)), lever.kinematics))
    exhaust = edges[(edges > 181) & (edges < 359)]
    assert len(exhaust) == 1  # at x = 0.9 alone


def test_a_diagram_that_repeats_has_its_kinks_in_every_turn():
    once = breaks(Loads(0j, found(engine("", B=by_ways("power", "exhaust"))).given.loads.forces), of_turns(1))
    twice_over = found(engine(B=by_ways("power", "exhaust")))
    edges = breaks(Loads(0j, twice_over.given.loads.forces), twice_over.kinematics)
    assert len(once) > 4 and edges == pytest.approx(np.concatenate([once, once + TURN]))


def of_turns(turns: int):
    return found(engine(f"turns: {turns},", B=by_ways("power", "exhaust"))).kinematics


curves = st.lists(
    st.tuples(st.floats(0, 1), st.floats(-5, 5)), min_size=1, max_size=5, unique_by=lambda pair: pair[0]
)
curves = curves.map(lambda pairs: tuple(sorted(pairs)))


@pytest.mark.exhaustive
@settings(max_examples=examples(60))
@given(forward=curves, back=curves, zero=st.floats(0, TURN), turns=st.integers(1, 3), at=st.floats(0, 1))
def test_ways_that_repeat_are_strokes_that_repeat(forward, back, zero, turns, at):
    """However the mechanism stands at position 0; where the point turns back both hold alike."""
    kinematics = of_zero(zero, turns)
    turned = np.append(kinematics.turned, at * kinematics.cycle.period)
    motion = kinematics.cycle.motion(turned)
    ways = ByDisplacement(1j, forward, back)
    strokes = ByStrokes(1j, ("a", "b") * turns, (forward, back) * turns)
    expected, got = (reading(loaded(law), kinematics, motion, turned).value for law in (ways, strokes))
    assert got == pytest.approx(expected, abs=1e-9)


NUMBERS = tuple(((0.0, float(k)),) for k in range(4))  # each stroke has its number for its force


@cache
def of_zero(zero: float, turns: int):
    mechanism = whole().given.mechanism
    driver = replace(mechanism.driver, zero=ZeroAngle(zero), turns=turns)
    positions = replace(
        whole().kinematics.positions, table=6 * turns, diagram=4 * turns, plans=(), force_plan=()
    )
    lever = course.LeverGiven(replace(mechanism, driver=driver), positions)
    return course.solve_lever(lever).kinematics


@pytest.mark.parametrize(
    ("zero", "at", "first", "order"),
    [
        (90, (0, 90, 270, 450, 630), "power", "power power exhaust intake compression"),
        (90, (0, 90, 270, 450, 630), None, "intake intake compression power exhaust"),
        (100, (0, 160, 180, 360, 540, 719), "power", "power power exhaust intake compression power"),
        (100, (0, 160, 180, 360, 540, 719), "intake", "intake intake compression power exhaust intake"),
        (300, (0, 140, 160, 340, 520, 700), "exhaust", "exhaust exhaust intake compression power exhaust"),
        (300, (0, 140, 160, 340, 520, 700), None, "exhaust exhaust intake compression power exhaust"),
        (300, (0, 140, 160, 340, 520, 700), "compression", "compression compression power exhaust intake compression"),
    ],
)  # fmt: skip
def test_the_first_stroke_is_the_one_under_way_at_position_0(zero, at, first, order):
    """B is up where the crank is at 90°, and the crank turns counter-clockwise: from 100° B goes down for 170°, from
    300° up for 150°."""
    kinematics, turned = of_zero(math.radians(zero), 2), np.radians(at)
    law = ByStrokes(1j, FOUR, NUMBERS, FOUR.index(first) if first else None)
    got = reading(loaded(law), kinematics, kinematics.cycle.motion(turned), turned).value
    assert [FOUR[int(k)] for k in got] == order.split()


def test_the_stroke_that_begins_at_a_dead_centre_holds_there():
    kinematics = whole().kinematics
    law = ByStrokes(1j, FOUR, NUMBERS, 2)
    ends = np.arange(4) * math.pi
    for off, expected in ((0.0, [2, 3, 0, 1]), (1e-6, [2, 3, 0, 1]), (-1e-6, [1, 2, 3, 0])):
        turned = np.mod(ends + off, 2 * TURN)
        got = reading(loaded(law), kinematics, kinematics.cycle.motion(turned), turned).value
        assert got.tolist() == expected


# ---------------------------------------------------------------- mistakes


def told(text: str) -> str:
    with pytest.raises(ProblemError) as caught:
        course.solve(loading.loads(text))
    return str(caught.value)


@pytest.mark.parametrize(
    ("text", "path", "sentence"),
    [
        (engine("turns: 2, range: 90 deg,"), "mechanism.driver", "it has no range"),
        (engine("turns: 5,"), "mechanism.driver.turns", "a whole number from 1 to 4 is expected"),
        (engine("turns: 1.5,"), "mechanism.driver.turns", "a whole number from 1 to 4 is expected"),
        (engine() + "positions: {table: 25}\n", "positions.table",
         "25 positions are not divided equally among 2 turns of the driving link; for example, 26"),
        (engine("turns: 3,") + "positions: {diagram: 40}\n", "positions.diagram", "for example, 42"),
        (engine(B=by_strokes("", FOUR[:3])), "by_displacement.strokes", "3 strokes are stated, the cycle has 4"),
        (engine(B=by_strokes("", FOUR[:2])), "by_displacement.strokes", "2 strokes are stated, the cycle has 4"),
        (engine("turns: 1,", B=by_strokes().replace("{zero: up", "{zero: down")), "loads.forces",
         "point B makes 2 strokes in the cycle, 4 are stated"),
        (engine(B=by_strokes("powre")), "by_displacement.first", "there is no stroke powre; did you mean power?"),
        (engine(B=by_strokes("exhaust")), "loads.forces",
         "point B goes away from the zero of its diagram at position 0: exhaust is a stroke towards it; "
         "first: one of intake, power"),
        (engine(D=by_strokes("power")), "loads.forces",
         "point D goes towards the zero of its diagram at position 0: power is a stroke away from it; "
         "first: one of compression, exhaust"),
        (engine("range: 90 deg,", B=by_strokes()), "by_displacement.strokes",
         "the driving link makes no full turn: no strokes follow"),
        (engine("", B="by_angle: [[0, 1], [361 deg, 1]]"), "by_angle.1.0",
         "361 deg is out of range: an angle from 0 … 360 deg is expected"),
        (engine(B="by_angle: [[0, 1], [721 deg, 1]]"), "by_angle.1.0",
         "721 deg is out of range: an angle from 0 … 720 deg is expected"),
        (engine(B="by_angle: [[0, 1], [360 deg, 1]]"), "by_angle",
         "the law ends within the first turn, the cycle has 2 turns, 720 deg; state it to the end of the cycle"),
        (engine(B="piston_diameter: 100 mm"), "loads.forces.0",
         "must be stated by one law; exactly one of: constant, by_position, by_angle, by_time, by_displacement"),
        (engine(B="piston_diameter: 100 mm\n      by_angle: [[0, 1 N], [700 deg, 1]]"), "by_angle.0.1",
         "1 N is a force (N); expected: a pressure (Pa)"),
        (engine(B="by_position: [1, 2]"), "by_position", "2 values, 24 positions"),
        (engine(B="by_displacement: {zero: up, strokes: {}}"), "by_displacement.strokes",
         "0 strokes are stated, the cycle has 4"),
        (engine(B="by_displacement: {zero: right, strokes: {a: [[0, 1]], b: [[0, 1]], c: [[0, 1]], d: [[0, 1]]}}"),
         "loads.forces", "point B does not move in the direction of zero"),
    ],
)  # fmt: skip
def test_what_is_wrong_with_a_cycle_is_said(text, path, sentence):
    message = told(text)
    assert path in message and sentence in message


@pytest.mark.parametrize(
    ("text", "told_of"),
    [
        (engine(B=by_strokes("power")).replace("[0.05, 4 MPa]", "[0.05, 4 mm]"), "strokes.power.1.1"),
        (engine("turns: 9,", B=by_strokes("power")), "driver.turns"),
        (engine(B=by_strokes("power")).replace("2200 rpm", "0 rpm"), "driver.speed"),
    ],
)
def test_a_mistake_in_one_stroke_is_none_of_their_number(text, told_of):
    """A curve with a mistake is still a stroke, and keeps its name."""
    with pytest.raises(ProblemError) as caught:
        loading.loads(text)
    assert [".".join(map(str, problem.path)) for problem in caught.value.problems] == [
        f"mechanism.{told_of}" if "driver" in told_of else f"loads.forces.0.by_displacement.{told_of}"
    ]


def test_a_driver_with_a_mistake_keeps_its_cycle():
    """The values of its 24 positions are not counted against 12 because its speed is mistyped."""
    values = ", ".join(["1"] * 24)
    message = told(engine(B=f"by_position: [{values}]").replace("2200 rpm", "2200 rmp"))
    assert "speed" in message and "24 positions" not in message and "by_position" not in message


def test_a_diagram_of_two_turns_numbers_all_positions():
    of = graph([Curve(np.zeros(73))], np.linspace(0, 720, 73), "φ", ["M"], positions=24)
    xs, names = zip(*position_marks(of.panels[0], 24), strict=True)
    assert [*names] == [*map(str, range(25))]
    assert np.diff(xs) == pytest.approx(np.full(24, of.panels[0].wide / 24))


@cache
def english(name: str) -> str:
    return note_of(name, "html", "en")["note.html"].decode()


@pytest.mark.exhaustive
def test_the_note_says_how_the_cycle_goes():
    text = re.sub(r"<[^>]*>", "", english("engine_four_stroke"))
    for words in (
        "The cycle takes 2 turns of the driving link, 720° in 0.054545\N{NO-BREAK SPACE}s",
        "drawn at 12 equally spaced positions",
        "position 12 has the coordinates, velocities and accelerations of position 0",
        "extreme values are given for the first turn",
    ):
        assert words in text
    assert "turns of the driving link" not in english("slider_crank_offset")
    assert "Every turn" not in english("slider_crank_offset")


def test_the_cycle_takes_the_time_of_its_turns():
    values = {value.key: value.value for value in of_results.values(solved("engine_four_stroke"))}
    assert (values["turns"], values["phi_cycle"]) == (2, 720)
    assert values["T_cycle"] == pytest.approx(2 * 60 / values["n_1"], rel=1e-12)


def test_the_table_of_strokes_says_which_curve_holds_when():
    """At every position strictly between the ends of a row the force is that of the named curve."""
    results = solved("engine_four_stroke")
    tables = {table.name: table for table in of_results.tables(results)}
    laws = {f"P_{force.at}": force.law for force in results.lever.given.loads.forces}
    rows, seen, stated = tables["strokes"], 0, tables["stated_table"]
    for key, name, begin, end in zip(
        *(rows[c].values for c in ("load", "stroke", "begins", "ends")), strict=True
    ):
        phi, law = stated["phi"].values, laws[key]
        curve = np.array(law.curves[law.names.index(name)])
        inside = (phi > begin + 1) & (phi < end - 1)
        point = results.lever.kinematics.table.place(key[2:]).imag[inside]
        top = results.lever.kinematics.diagram.place(key[2:]).imag.max()
        assert stated[key].values[inside] == pytest.approx(
            np.interp((top - point) / 0.12, *curve.T), rel=1e-9
        )
        seen += inside.sum()
    assert seen == 2 * 20  # all but the four dead centres of each


def test_a_stroke_under_way_at_position_0_ends_early_in_the_cycle():
    """The crank goes clockwise and stands at 50°: 40° past the upper dead centre, 140° before the lower one."""
    text = engine(B=by_strokes("power")).replace("{point: B, extreme: up}", "{angle: 50 deg}")
    text = text.replace("speed: 2200 rpm,", "speed: 2200 rpm, rotation: clockwise,")
    (rows,) = [
        table for table in of_results.tables(course.solve(loading.loads(text))) if table.name == "strokes"
    ]
    assert rows["stroke"].values == ["exhaust", "intake", "compression", "power"]
    assert rows["begins"].values == pytest.approx([140, 320, 500, 680])
    assert rows["ends"].values == pytest.approx([320, 500, 680, 140])


@pytest.mark.exhaustive
def test_strokes_have_their_words_in_the_note():
    text = english("engine_four_stroke")
    words = re.findall(r'<td data-q="stroke"[^>]*>([^<]*)</td>', text)
    order = ["power", "exhaust", "intake", "compression"]
    assert words == [f"{name} stroke" for name in (*order, "compression", "power", "exhaust", "intake")]


@pytest.mark.exhaustive
def test_a_name_of_a_stroke_that_is_not_known_is_printed_as_it_is():
    text = engine(B=by_strokes("power")).replace("power", "working").replace("working: ", "'рабочий ход': ")
    text = text.replace("first: working", "first: рабочий ход")
    assert "рабочий ход" in render(course.solve(loading.loads(text)), "html", "en")["note.html"].decode()
