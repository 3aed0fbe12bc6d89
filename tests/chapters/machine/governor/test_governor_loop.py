"""The machine with its governor: stability by several ways; the ready variants; what is wrong with one."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from conftest import ALL_FILES, solved
from hypothesis import given
from hypothesis import strategies as st
from notes import render

from tmm_report import course, loading
from tmm_report.mechanics.machine.governor import stability as small
from tmm_report.problems import ProblemError

LOOP = small.Loop(J=60, D=2.8, M=400, supply=0.9, m=53, k=900, S=1220, R=91, omega=10, h=0.06)
SERVOS = {"direct": None, "servo": small.Servo(0.1), "isodrome": small.Servo(0.1, 0.0, 0.5, 2.0)}
sizes = st.floats(0.1, 10.0)


def scaled(*factors: float) -> small.Loop:
    names = ("J", "D", "M", "m", "k", "S", "R")
    return replace(LOOP, **{name: getattr(LOOP, name) * by for name, by in zip(names, factors, strict=True)})


# --- small motions


@pytest.mark.parametrize("servo", SERVOS)
@given(st.tuples(*[sizes] * 7))
def test_the_matrix_and_the_elements_give_one_polynomial(servo, factors):
    loop = scaled(*factors)
    by_matrix = np.poly(small.matrix(loop, SERVOS[servo]))
    by_elements = small.polynomial(loop, SERVOS[servo])
    size = np.abs(np.linalg.eigvals(small.matrix(loop, SERVOS[servo]))).max()
    weights = size ** np.arange(len(by_matrix))
    assert by_matrix / weights == pytest.approx(by_elements / weights, abs=1e-9)


@pytest.mark.parametrize("servo", SERVOS)
@given(st.tuples(*[sizes] * 7))
def test_hurwitz_and_the_eigenvalues_agree(servo, factors):
    loop = scaled(*factors)
    real = np.linalg.eigvals(small.matrix(loop, SERVOS[servo])).real.max()
    if abs(real) > 1e-6:
        assert small.stable(small.polynomial(loop, SERVOS[servo])) is bool(real < 0)


@given(st.tuples(*[sizes] * 7))
def test_vyshnegradsky_agrees_with_the_eigenvalues(factors):
    loop = scaled(*factors)
    x, y = small.vyshnegradsky(small.cubic(loop))
    real = np.linalg.eigvals(small.matrix(loop)).real.max()
    if abs(x * y - 1) > 1e-6:
        assert (x * y > 1) is bool(real < 0)
    # his roots are those of the loop in the unit p
    p = (small.cubic(loop)[3] / small.cubic(loop)[0]) ** (1 / 3)
    mine, his = (
        np.sort_complex(np.linalg.eigvals(small.matrix(loop))),
        np.sort_complex(np.roots([1, x, y, 1]) * p),
    )
    assert np.abs(mine - his).max() < 1e-4 * np.abs(mine).max()


@given(st.tuples(*[sizes] * 7))
def test_the_dashpot_needed_is_on_the_boundary(factors):
    loop = scaled(*factors)
    k = small.damping_needed(loop)
    if not k:
        assert k == 0.0 and small.stable(small.cubic(replace(loop, k=1e-9)))
        return
    found = np.linalg.eigvals(small.matrix(replace(loop, k=k)))
    assert np.abs(found.real).min() < 1e-7 * np.abs(found).max()
    assert small.stable(small.cubic(replace(loop, k=1.01 * k)))


def test_a_flat_governor_without_self_regulation_has_no_dashpot_that_helps():
    """Vyshnegradsky: without non-uniformity there is no governor."""
    assert small.damping_needed(replace(LOOP, S=0.0, D=0.0)) is None
    assert not small.stable(small.cubic(replace(LOOP, S=0.0, D=0.0)))


def test_without_a_dashpot_and_self_regulation_the_loop_is_unstable():
    assert not small.stable(small.cubic(replace(LOOP, k=0.0, D=0.0)))


@given(st.floats(0.2, 4.0))
def test_curves_of_the_diagram(a):
    """On one two roots are equal, on the other all real parts are."""
    x, y = small.double_roots(a)
    assert np.polyval([1, x, y, 1], -a) == pytest.approx(0, abs=1e-9 * (1 + a**3))
    assert small.discriminant(float(x), float(y)) == pytest.approx(0, abs=1e-6 * float(x * y) ** 2)
    if a < 2.9:
        roots = np.roots([1, a, small.equal_decay(a), 1])
        assert np.ptp(roots.real) < 1e-5


@pytest.mark.parametrize(
    ("x", "y", "kind"),
    [
        (3, 3, "monotonic"),
        (4, 4, "monotonic"),
        (1, 5, "aperiodic"),
        (2, 1, "oscillating"),
        (0.5, 1.9, "unstable"),
    ],
)
def test_regions_of_the_diagram(x, y, kind):
    assert small.kind(x, y) == kind


@given(st.floats(0.3, 3.0), st.floats(0.3, 3.0))
def test_the_boundary_of_the_isodrome_has_imaginary_roots(m, k):
    loop, nu = scaled(1, 1, 1, m, k, 1, 1), np.geomspace(0.2, 10, 60)
    beta, q = small.isodrome_boundary(loop, 0.1, nu)
    kept = (beta > 1e-3) & (q > 1e-3)
    for one, other, frequency in zip(beta[kept], q[kept], nu[kept], strict=True):
        roots = np.linalg.eigvals(small.matrix(loop, small.Servo(0.1, 0.0, float(one), 1 / float(other))))
        assert np.abs(roots - 1j * frequency).min() < 1e-6 * np.abs(roots).max()


@pytest.mark.parametrize("servo", SERVOS)
def test_small_motions_are_those_of_the_eigenvectors(servo):
    A = small.matrix(LOOP, SERVOS[servo])
    start = np.arange(1.0, len(A) + 1)
    found = small.linear(A, start, 3.0, 41)
    values, vectors = np.linalg.eig(A)
    t = np.linspace(0, 3.0, 41)
    exact = (vectors * np.linalg.solve(vectors, start)) @ np.exp(np.outer(values, t))
    assert np.abs(found - exact.real).max() < 1e-9 * np.abs(exact).max()


# --- the ready variants, and what is wrong


def variant(name: str, **changes: str) -> str:
    text = next(path for path in ALL_FILES if path.stem == name).read_text("utf-8")
    for old, new in changes.items():
        assert old in text
        text = text.replace(old, new)
    return text


@pytest.mark.parametrize("name", ["governor_porter", "governor_servo"])
def test_steady_states_balance(name):
    found = solved(name).governor
    loop, plant, mean = found.loop, found.loop.plant, found.loop.s.number("omega_mean")
    for state, load in ((loop.before, plant.load.before), (loop.after, plant.load.after)):
        drive = plant.torque.full - plant.torque.slope * (state.omega - mean)
        assert drive * state.s == pytest.approx(load, rel=1e-9)
        held = found.direct.at(np.array([state.z])).omega[0]
        assert held == pytest.approx(plant.ratio * state.omega, rel=1e-9)
    assert loop.stable and (loop.hurwitz > 0).all()


def test_the_indirect_governor_has_no_static_error_and_the_direct_one_has():
    assert solved("governor_servo").governor.loop.s.number("static") == 0
    direct = solved("governor_porter").governor
    assert -direct.direct.s.number("delta") < direct.loop.s.number("static") < 0


def test_feedback_below_the_least_is_unstable():
    found = solved("governor_servo").governor.loop
    low, _ = found.feedback_needed
    for factor, stable in ((1.001, True), (0.999, False)):
        servo = replace(found.servo, beta=low * factor)
        assert small.stable(small.polynomial(found.loop, servo)) is stable


def test_an_unstable_loop_is_solved_and_said():
    text = variant("governor_porter", **{"damping: 1200": "damping: 20"})
    found = course.solve(loading.loads(text)).governor
    assert not found.loop.stable and "unstable" in " ".join(str(line) for line in found.summary())


def test_a_dead_zone_leaves_the_speed_where_the_response_ends():
    text = variant(
        "governor_servo", **{"  servo:\n": "  servo:\n    dead_zone: 0.3 mm\n", "friction: 1 N, ": ""}
    )
    found = course.solve(loading.loads(text)).governor.loop
    assert found.short and found.final == found.response.omega[-1] != found.after.omega
    assert found.final == pytest.approx(found.after.omega, rel=2e-3)
    assert not solved("governor_servo").governor.loop.short


def test_friction_may_hold_what_small_motions_say_grows():
    """The sentence of the note follows the response: the swings of the sleeve become smaller."""
    changes = {
        "damping: 1200": "damping: 150",
        "friction: 2 N,": "friction: 30 N,",
        "after: 280": "after: 215",
    }
    found = course.solve(loading.loads(variant("governor_porter", **changes)))
    loop, text = found.governor.loop, render(found, "html")["note.html"].decode()
    assert not loop.stable and not loop.stopped
    assert "Колебания растут" not in text


def test_a_throttle_too_heavy_asks_for_an_indirect_governor():
    text = variant("governor_porter", **{"force: 2 N": "force: 20 N"})
    assert course.solve(loading.loads(text)).governor.loop.too_heavy
    assert not solved("governor_porter").governor.loop.too_heavy


WRONG = {
    "too much load": ("governor_porter", "after: 280 N*m", "after: 500 N*m", "load.after", "no equilibrium"),
    "too little load": (
        "governor_porter",
        "before: 200 N*m",
        "before: -20 N*m",
        "load.before",
        "no equilibrium",
    ),
    "beyond the drive": (
        "governor_servo",
        "after: 700 N*m",
        "after: 990 N*m",
        "load.after",
        "beyond the drive",
    ),
    "stall": ("governor_porter", "inertia: 60 kg*m^2", "inertia: 0.06 kg*m^2", "machine.inertia", "stops"),
    "always braking": (
        "governor_porter",
        "spring: {stiffness: 60 kN/m, force: 900 N}",
        "spring: {stiffness: 0 kN/m, force: 0 N}",
        "brake.spring",
        "standstill",
    ),
    "no friction": ("governor_porter", "friction: 0.35", "friction: 0", "brake.friction", "without friction"),
    "outside the drum": (
        "governor_porter",
        "drum: 130 mm",
        "drum: 80 mm",
        "brake.drum",
        "not within the drum",
    ),
}


@pytest.mark.parametrize("name", WRONG)
def test_what_is_wrong_is_said_in_a_sentence(name):
    of, old, new, key, words = WRONG[name]
    with pytest.raises(ProblemError) as caught:
        course.solve(loading.loads(variant(of, **{old: new})))
    (problem,) = caught.value.problems
    assert problem.key.endswith(key) and words in problem.text() and problem.right is not None
