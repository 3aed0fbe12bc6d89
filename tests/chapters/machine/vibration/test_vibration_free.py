"""Free vibration, without a force; a resonance without damping that an absorber or a base bounds."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from tmm_report import course, loading, note
from tmm_report.chapters.machine.vibration import quantities
from tmm_report.i18n import Translator
from tmm_report.problems import ProblemError


def solved(text):
    return course.solve(loading.loads(f"vibration: {text}"))


def value(found, key):
    return found.s[key].value


KINDS = {
    "light": (
        "{mass: 10, stiffness: 1000, damping: 5, start: {displacement: 5 mm}}",
        10,
        1000,
        5,
        0.005,
        0.0,
    ),
    "pushed": ("{mass: 2, isolators: 4, stiffness: 300, start: {velocity: 1}}", 2, 1200, 0, 0.0, 1.0),
    "heavy": (
        "{inertia: 2, stiffness: 300, damping: 60, start: {angle: 5 deg}}",
        2,
        300,
        60,
        math.radians(5),
        0,
    ),
    "critical": (
        "{mass: 4, stiffness: 100, damping_ratio: 1, start: {displacement: 3 mm}}",
        4,
        100,
        40,
        0.003,
        0,
    ),
}


@pytest.mark.parametrize("kind", KINDS)
def test_a_free_motion_is_that_of_an_integration_of_its_equation(kind):
    text, m, c, b, place, speed = KINDS[kind]
    found = solved(text).vibration
    own = solve_ivp(lambda t, y: [y[1], -(b * y[1] + c * y[0]) / m], (0, found.times[-1]), [place, speed],
                    t_eval=found.times, rtol=1e-10, atol=1e-13)  # fmt: skip
    assert found.motion == pytest.approx(own.y[0], abs=1e-7)


def test_the_logarithmic_decrement_is_that_of_the_motion_itself():
    """Of two tops of the integrated motion, not of its formula."""
    text, m, c, b, *_ = KINDS["light"]
    found = solved(text).vibration

    def stands(t, y):
        return y[1]

    stands.direction = -1
    own = solve_ivp(lambda t, y: [y[1], -(b * y[1] + c * y[0]) / m], (0, 3), [0.0, 1.0], events=stands,
                    rtol=1e-11, atol=1e-13)  # fmt: skip
    times, tops = own.t_events[0], own.y_events[0][:, 0]
    assert value(found, "decrement") == pytest.approx(math.log(tops[0] / tops[1]), rel=1e-8)
    assert value(found, "falls") == pytest.approx(tops[1] / tops[2], rel=1e-8)
    assert value(found, "period") == pytest.approx(times[1] - times[0], rel=1e-8)
    table = {table.name: table for table in quantities.tables(found)}["vibration_swings"]
    sizes, t = table["size"].numbers(), table["t"].numbers()
    assert sizes[1:] / sizes[:-1] == pytest.approx(math.exp(-value(found, "decrement")))
    within = t <= found.times[-1]
    assert (np.abs(np.interp(t[within], found.times, found.motion)) <= sizes[within] * (1 + 1e-3)).all()


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("fmt", ["html", "tex"])
def test_the_note_of_a_free_vibration_has_no_force(kind, fmt):
    text = str(note.render(solved(KINDS[kind][0]), fmt, Translator("en")))
    assert "Free vibration" in text and "amplitude of the exciting force" not in text


def test_what_needs_a_force_is_not_asked_of_a_free_vibration():
    with pytest.raises(ProblemError) as error:
        solved("{mass: 1, stiffness: 9, start: {velocity: 1}, absorber: {mass: 1}, transmissibility: 0.1}")
    assert {one.path[-1] for one in error.value.problems} == {"absorber", "transmissibility"}
    with pytest.raises(ProblemError, match=r"start: {displacement: 5 mm}"):
        solved("{mass: 1, stiffness: 9}")


# --- resonance without damping

MAIN = "mass: 100, stiffness: 100 kN/m, force: 500, speed: 31.622776601683793"


@pytest.mark.parametrize(("mass", "speed"), [(20, 31.622776601683793), (5, 31.62), (50, 31.63)])
def test_an_absorber_stills_a_machine_that_alone_is_in_resonance(mass, speed):
    found = solved(
        f"{{mass: 100, stiffness: 100 kN/m, force: 500, speed: {speed}, absorber: {{mass: {mass}}}}}"
    )
    of = found.vibration
    main, hung = np.array([[100.0, 0], [0, mass]]), mass * speed**2
    stiff = np.array([[100e3 + hung, -hung], [-hung, hung]])
    moved = np.linalg.solve(stiff - speed**2 * main, [500.0, 0.0])
    assert value(of, "absorber_swing") == pytest.approx(abs(moved[1]), rel=1e-6)
    assert of.absorbed.tuned.work * 500 == pytest.approx(abs(moved[0]), abs=1e-12)
    natural = np.sqrt(np.linalg.eigvals(np.linalg.solve(main, stiff)).real)
    assert sorted(natural) == pytest.approx([value(of, "split_low"), value(of, "split_high")])
    assert "vibration_amplitude" not in [one.quantity.key for one in quantities.values(of)]
    for fmt in ("html", "tex"):
        assert "without bound" in str(note.render(found, fmt, Translator("en")))


@pytest.mark.exhaustive
def test_the_amplitude_alone_grows_as_the_motion_from_rest_does():
    of = solved(f"{{{MAIN}, absorber: {{mass: 20}}}}").vibration
    own = solve_ivp(lambda t, y: [y[1], (500 * math.sin(of.omega * t) - 1e5 * y[0]) / 100], (0, 4), [0.0, 0.0],
                    rtol=1e-10, atol=1e-13, dense_output=True)  # fmt: skip
    period = 2 * math.pi / of.omega
    tops = [np.abs(own.sol(np.linspace(k * period, (k + 1) * period, 4001))[0]).max() for k in (15, 16)]
    assert value(of, "growth") == pytest.approx(tops[1] - tops[0], rel=1e-3)


def test_a_base_that_moves_bounds_the_same_resonance_and_nothing_else_does():
    of = solved(f"{{{MAIN}, foundation: {{mass: 400, stiffness: 900 kN/m}}}}").vibration
    main = np.array([[100.0, 0], [0, 400]])
    stiff = np.array([[1e5, -1e5], [-1e5, 1e6]])
    moved = np.linalg.solve(stiff - of.omega**2 * main, [500.0, 0.0])
    assert [value(of, "pair_machine"), value(of, "pair_base")] == pytest.approx(abs(moved))
    with pytest.raises(ProblemError, match="without bound"):
        solved(f"{{{MAIN}}}")
