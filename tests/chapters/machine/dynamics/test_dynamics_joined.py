"""The regimes as one motion, against an integration of its own by scipy and works by quadrature of its powers."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest
from conftest import solved
from notes import render
from scipy.integrate import solve_ivp
from test_dynamics_chapter import alone, book

from tmm_report import course, loading
from tmm_report.chapters.machine.dynamics import draw
from tmm_report.figures.charts.axes import PAPER
from tmm_report.i18n import Translator
from tmm_report.report.formats import Html
from tmm_report.report.numbering import Numbering
from tmm_report.report.page import Page

G = 9.81
SWUNG = """
  parts:
    - {name: rotor, inertia: 1.5}
    - {name: bob, mass: 4, offset: 0.3, angle: -90 deg}
  motor: {shunt: {moment: 60, speed: 26, no_load: 30}}
  resistance: [{name: oil, viscous: 0.4}]
  start: {within: 2 %}
  coast: {brake: 25}
"""


class Hoist:
    """variants/hoist_start.yaml by hand."""

    inertia = 0.16 + 0.35 * 0.2**2 + 4.2 * 0.04**2 + (650 + 300) * (0.04 * 0.16) ** 2
    lifting = (40 * 0.04) / 0.94 + (650 / 0.9 - 300 * 0.9) * G * 0.04 * 0.16
    brake = 90.0

    def motor(self, omega):
        synchronous, nominal = 1500 * math.pi / 30, 1455 * math.pi / 30
        slip, critical = 1 - omega / synchronous, 0.03 * (2.8 + math.sqrt(2.8**2 - 1))
        return 2 * 2.8 * 11000 / nominal / (slip / critical + critical / slip)

    def load(self, phi):
        return -self.lifting + 0 * phi

    def friction(self, omega):
        return -1.5 * (omega / (1500 * math.pi / 30)) ** 2


class Swung:
    inertia, brake = 1.5 + 4 * 0.3**2, 25.0

    def motor(self, omega):
        return 60 * (30 - omega) / (30 - 26)

    def load(self, phi):
        return -4 * G * 0.3 * np.cos(phi - math.pi / 2)

    def friction(self, omega):
        return -0.4 * omega


CASES = {"hoist": (Hoist(), lambda: solved("hoist_start").dynamics), "swung": (Swung(), lambda: alone(SWUNG))}


@pytest.fixture(params=CASES)
def case(request):
    machine, solve = CASES[request.param]
    return machine, solve()


def integrated(machine, begin, end, state, driven):
    """t, φ, ω and the works of motor, brake, load and friction from one time to another."""

    def rates(t, y):
        phi, omega = y[:2]
        powers = [
            machine.motor(omega) * omega if driven else 0.0,
            0.0 if driven else -machine.brake * omega,
            machine.load(phi) * omega,
            machine.friction(omega) * omega,
        ]
        moment = (
            (machine.motor(omega) if driven else -machine.brake) + machine.load(phi) + machine.friction(omega)
        )
        return [omega, moment / machine.inertia, *powers]

    return solve_ivp(
        rates, (begin, end), [*state, 0, 0, 0, 0], "DOP853", rtol=1e-11, atol=1e-10, dense_output=True
    )


def test_one_integration_through_all_regimes_is_the_motion(case):
    machine, found = case
    t, phi, omega = found.joined.samples()
    coast = float(sum(one.t[-1] for one in found.joined.stretches[:-1]))
    driven = integrated(machine, 0.0, coast, (0.0, 0.0), True)
    free = integrated(machine, coast, t[-1], driven.y[:2, -1], False)
    on = t <= coast
    ours = np.where(on, driven.sol(np.minimum(t, coast))[:2], free.sol(np.maximum(t, coast))[:2])
    assert omega == pytest.approx(ours[1], abs=3e-5 * omega.max())
    assert phi == pytest.approx(ours[0], abs=3e-5 * phi.max())


def test_works_of_each_regime_are_those_of_its_powers(case):
    machine, found = case
    table = book(found).tables["dynamics_regimes"]
    state, works = (0.0, 0.0), []
    for row, name in enumerate(table["regime"].values[:-1]):
        begin, end = (float(table[key].values[row]) for key in ("t_begin", "t_end"))
        solution = integrated(machine, begin, end, state, name != "coast")
        state = solution.y[:2, -1]
        assert state[1] == pytest.approx(table["omega_end"].values[row], abs=3e-5 * found.steady.mean)
        works.append(solution.y[2:, -1])
    total = np.abs(works).sum(axis=0)
    for k, key in enumerate(("A_dr", "A_br", "A_load", "A_fr")):
        ours = [one[k] for one in works]
        assert table[key].numbers()[:-1] == pytest.approx(ours, abs=1e-4 * total[k])
        assert table[key].numbers()[-1] == pytest.approx(sum(ours), abs=1e-4 * total[k])


@pytest.mark.parametrize("name", ["hoist_start", "piston_pump", "tram_start"])
def test_each_regime_begins_as_the_one_before_it_ends(name):
    found = solved(name).dynamics
    stretches = found.joined.stretches
    assert [one.name for one in stretches] == ["start", "settling", "steady", "coast"]
    for before, after in pairwise(stretches):
        assert after.omega[0] == pytest.approx(before.omega[-1], rel=1.01e-5)
        assert after.t[0] == after.phi[0] == 0
    turned = np.cumsum([one.phi[-1] for one in stretches])
    if not found.even:  # the steady motion and the run-down begin at position 0
        cycles = turned[1:3] / found.whole.panels.period
        assert cycles == pytest.approx(np.round(cycles), abs=1e-9)
    t, phi, omega = found.joined.samples()
    assert (np.diff(t) > 0).all() and (np.diff(phi) > 0).all()
    assert omega[0] == found.start.omega[0] and omega[-1] == found.coast.omega[-1]


@pytest.mark.parametrize("name", ["hoist_start", "piston_pump", "tram_start"])
def test_the_regimes_are_those_of_the_other_tables(name):
    values = book(solved(name).dynamics)
    table, works = values.tables["dynamics_regimes"], values.tables["dynamics_works"]
    rows = list(table["regime"].values)
    kinds = [table[key].numbers() for key in ("A_dr", "A_br", "A_load", "A_fr") if key in table]
    size = np.abs(kinds).max()
    assert sum(kinds) == pytest.approx(table["gained"].numbers(), abs=1e-8 * size)
    for row, key in ((rows.index("start"), "start"), (rows.index("coast"), "coast")):
        assert table["t"].values[row] == pytest.approx(values[f"dynamics_t_{key}"].value)
        assert table["turns"].values[row] == pytest.approx(values[f"dynamics_turns_{key}"].value)
        assert table["gained"].values[row] == pytest.approx(works[f"A_{key}"].numbers()[-1])
    steady, motor = rows.index("steady"), list(works["acting"].values).index("motor")
    cycles = values["dynamics_cycles"].value
    assert table["A_dr"].values[steady] == pytest.approx(cycles * works["A_steady"].values[motor])
    for key in ("t", "phi", "turns", "gained"):
        assert table[key].numbers()[-1] == pytest.approx(table[key].numbers()[:-1].sum(), abs=1e-9 * size)
    assert table["phi"].numbers() == pytest.approx(2 * math.pi * table["turns"].numbers())
    assert table["t_end"].numbers()[:-1] == pytest.approx(np.cumsum(table["t"].numbers()[:-1]))
    assert table["t_begin"].numbers()[1:-1] == pytest.approx(table["t_end"].numbers()[:-2])


def test_friction_of_the_pairs_is_friction_and_weights_are_loads():
    found = solved("piston_pump").dynamics
    table, works = (book(found).tables[f"dynamics_{name}"] for name in ("regimes", "works"))
    of = dict(zip(works["acting"].values, works["A_start"].numbers(), strict=True))
    assert table["A_fr"].values[0] == pytest.approx(of["pairs"] + of["res1"])
    others = sum(work for key, work in of.items() if key not in ("motor", "pairs", "res1", "sum", "gained"))
    assert table["A_load"].values[0] == pytest.approx(others)


def test_so_many_cycles_as_stated_are_followed():
    three = alone(SWUNG + "  cycles: 3\n")
    steady = next(one for one in three.joined.stretches if one.name == "steady")
    assert steady.cycles == 3 and steady.t[-1] == pytest.approx(3 * three.steady.cycle)
    assert steady.phi[-1] == pytest.approx(6 * math.pi)
    assert steady.omega[::72] == pytest.approx([steady.omega[0]] * 4)
    ripple = steady.omega[:73]
    assert ripple.max() == pytest.approx(three.steady.extremes[1][0], rel=1e-3)


@pytest.mark.parametrize(
    ("regimes", "names"),
    [
        ("start: {within: 2 %}", ["start", "settling", "steady"]),
        ("coast: {brake: 25}", ["steady", "coast"]),
        ("start: {speed: 10}\n  coast: {}", ["start", "settling", "steady", "coast"]),
        ("start: {begin: 40}\n  coast: {}", ["start", "settling", "steady", "coast"]),
        ("start: {within: 2 %}\n  coast: {begin: 20}", ["start", "settling", "steady"]),
    ],
)
def test_two_regimes_are_joined_where_they_follow_one_another(regimes, names):
    text = SWUNG[: SWUNG.index("  start:")] + f"  {regimes}\n"
    found = alone(text)
    assert [one.name for one in found.joined.stretches] == names


def test_a_run_down_from_the_speed_of_the_start_up_is_joined_with_it():
    text = "  parts: [{name: a, inertia: 2}]\n  motor: {constant: 5}\n  resistance: [{friction: 1}]\n"
    found = alone(text + "  start: {speed: 20}\n  coast: {begin: 20}\n")
    assert [one.name for one in found.joined.stretches] == ["start", "coast"]
    assert found.joined.samples()[0][-1] == pytest.approx(2 * 20 / 4 + 2 * 20 / 1)
    assert alone(text + "  start: {speed: 20}\n  coast: {begin: 10}\n").joined is None
    in_vain = alone(text + "  start: {speed: 20}\n  coast: {begin: 20}\n  cycles: 3\n")
    assert [one.path for one in in_vain.doubts] == [("dynamics", "cycles")]


def test_cycles_that_nothing_shows_are_doubted():
    text = SWUNG[: SWUNG.index("  start:")]
    found = course.solve(loading.loads("dynamics:\n" + text + "  steady: true\n  cycles: 4\n")).dynamics
    assert found.joined is None
    assert [one.path for one in found.doubts] == [("dynamics", "cycles")]
    assert not list(alone(SWUNG + "  cycles: 4\n").doubts)


def test_the_chart_bounds_the_regimes_at_their_times():
    found = solved("hoist_start").dynamics
    page = Page(Html(), Translator("en"), Numbering())
    graph, table = draw.joined(found, page), book(found).tables["dynamics_regimes"]
    assert graph.bounds == pytest.approx([0.0, *table["t_end"].numbers()[:-1]])
    marked = graph.curves[0].marked(graph.x)
    assert [x for x, _ in marked] == pytest.approx(table["t_end"].numbers()[:-2])
    assert [y for _, y in marked] == pytest.approx(table["omega_end"].numbers()[:-2], rel=1.01e-5)


@pytest.mark.parametrize("name", ["hoist_start", "tram_start", "piston_pump"])
def test_the_last_time_stays_on_the_paper(name):
    graph = draw.joined(solved(name).dynamics, Page(Html(), Translator("ru"), Numbering()))
    assert graph.drawing.size[0] <= PAPER


@pytest.mark.parametrize(
    ("regimes", "told"),
    [
        ("start: {within: 2 %}\n  coast: {begin: 20}", True),  # the steady speed is another
        ("start: {within: 2 %}\n  coast: {}", False),
        ("steady: false\n  coast: {begin: 20}", False),  # there is nothing to follow upon
        ("steady: false\n  start: {speed: 10}\n  coast: {begin: 8}", True),
    ],
)
def test_a_run_down_by_itself_says_why(regimes, told):
    text = SWUNG[: SWUNG.index("  start:")] + f"  {regimes}\n"
    results = course.solve(loading.loads("language: en\ndynamics:\n" + text))
    html = render(results, "html", "en")["note.html"].decode()
    assert ("follows upon no other regime and stands by itself" in html) == told
    joined = results.dynamics.joined
    assert not told or joined is None or "coast" not in [one.name for one in joined.stretches]
