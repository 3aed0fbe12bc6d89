"""A branch of a group above class II: over change points, past near-misses, up to where the links before it end."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from higher_checks import beside, jumps, unclosed
from higher_schemes import drawn

from tmm_report import loading
from tmm_report.mechanics.lever.assembly.stated import assemble
from tmm_report.mechanics.lever.cycle import Cycle, cycle_of
from tmm_report.mechanics.lever.high_class.newton import HigherGroup, Run
from tmm_report.mechanics.lever.mechanism import Mechanism, ZeroAngle, ZeroExtreme
from tmm_report.problems import ProblemError

FULL_TURN = 2 * np.pi


def longer(made: Mechanism, link: str, point: str, factor: float) -> Mechanism:
    body = made.links[link]
    first = next(iter(body.points.values()))
    points = {**body.points, point: first + (body.points[point] - first) * factor}
    return replace(made, links={**made.links, link: replace(body, points=points)})


def run_of(made: Mechanism) -> Run:
    group = assemble(made).groups[-1]
    assert isinstance(group, HigherGroup)
    return group.branches[0].run


# ---------------------------------------------------------------- near-misses


def near_miss(factor: float) -> Mechanism:
    """A class IV group that goes all round with its link 3 longer by more than this factor, and else jams: two of its
    sheets touch. By bisection."""
    random = np.random.default_rng(28)
    sliding = list(random.choice(range(1, 6), size=random.integers(0, 3), replace=False))
    scheme = drawn("IV2", 28, sliding)
    made = replace(scheme, crank=scheme.crank * float(random.uniform(3, 8))).mechanism()
    return longer(made, "3", "P4", 1.009175747207921 + factor)


@pytest.mark.exhaustive
def test_gaps_shrink_with_the_square_root_and_are_never_jumped_over():
    """From one degree down to a ten-thousandth; past the tangency there is none, however near it is."""
    widths = []
    for off in (1e-4, 1e-6, 1e-8, 1e-10):
        first, last = run_of(near_miss(-off)).lost
        widths.append(last - first)
    assert np.array(widths[:-1]) / np.array(widths[1:]) == pytest.approx(10, rel=0.05)
    assert np.degrees(widths[-1]) < 2e-3
    assert all(run_of(near_miss(off)).whole for off in (1e-4, 1e-6, 1e-8, 1e-10))


@pytest.mark.parametrize("off", [1e-3, 1e-7])
def test_positions_close_on_both_sides_of_a_narrow_gap(off):
    found = cycle_of(assemble(near_miss(-off)))
    run = found.critical[-1].run
    motion = found.motion(beside(found))
    assert run.forward is not None and not run.overlaps
    assert motion.closes.all() and unclosed(motion).max() < 1e-12
    middle = np.array([sum(run.lost) / 2])
    assert not found.motion(middle).closes.any()


# ---------------------------------------------------------------- change points


def folding() -> Mechanism:
    """Crank and two legs of one length, parallel, on a plate that only shifts: the legs fold with the line of their
    pivots, the crank and the rod with that of theirs."""
    rod = abs(0.6 + 0.15j)
    text = f"""
mechanism:
  frame: {{O: [0, 0], E: [0.5, 0], F: [0.8, 0]}}
  links:
    1: {{points: {{O: 0, A: 0.2}}}}
    2: {{points: {{A: 0, B: {rod!r}}}}}
    3: {{points: {{C: 0, D: 0.3, B: [0.1, 0.15]}}}}
    4: {{points: {{E: 0, C: 0.2}}}}
    5: {{points: {{F: 0, D: 0.2}}}}
  driver: {{link: 1, speed: 5, zero: {{angle: 60 deg}}}}
  sketch: {{A: [0.1, 0.1732], B: [0.7, 0.3232], C: [0.6, 0.1732], D: [0.9, 0.1732]}}
"""
    return loading.loads(text).lever.mechanism


def test_change_points_are_gone_over_straight_on():
    """Four of them; the plate does not turn, and the legs stay parallel to the crank."""
    found = cycle_of(assemble(folding()))
    fold = np.angle(0.6 + 0.15j)
    (critical,) = found.critical
    assert critical.changes == pytest.approx((0.0, fold, np.pi, np.pi + fold), abs=1e-7)
    assert critical.run.whole and critical.gaps == ()
    x = found.turned(720)
    motion = found.motion(np.sort(np.concatenate([x, np.array(critical.changes) - found.zero + 1e-9])))
    assert motion.closes.all() and unclosed(motion).max() < 1e-12
    assert np.abs(motion.turn("3") - 1).max() < 1e-9
    assert np.abs(motion.turn("4") - np.exp(1j * motion.phi)).max() < 1e-9


# ---------------------------------------------------------------- links before the group


def hanging(rod: float, rotation: str = "counter-clockwise", arm: float = 0.01) -> Cycle:
    """A triad behind a crank-rocker whose rod may be too short to go round."""
    x = (0.25**2 + rod**2 - 0.15**2) / 0.5
    B = complex(0.1 + x, np.sqrt(rod**2 - x * x))
    D = 0.35 + (B - 0.35) / 0.15 * arm
    Q = D + (0.9 + 0.05j)
    R, S = Q + (0.2 + 0.3j), Q + (0.3 - 0.2j)
    E, F = R - (0.05 + 0.9j), S + (0.1 - 0.7j)

    def at(z: complex) -> str:
        return f"[{z.real!r}, {z.imag!r}]"

    text = f"""
mechanism:
  frame: {{O: [0, 0], C: [0.35, 0], E: {at(E)}, F: {at(F)}}}
  links:
    1: {{points: {{O: 0, A: 0.1}}}}
    2: {{points: {{A: 0, B: {rod}}}}}
    3: {{points: {{C: 0, B: 0.15, D: {arm}}}}}
    4: {{points: {{D: 0, Q: {abs(Q - D)!r}}}}}
    5: {{points: {{Q: 0, R: {at(R - Q)}, S: {at(S - Q)}}}}}
    6: {{points: {{R: 0, E: {abs(E - R)!r}}}}}
    7: {{points: {{S: 0, F: {abs(F - S)!r}}}}}
  driver: {{link: 1, speed: 5, rotation: {rotation}, zero: {{angle: 0}}}}
  assembly: {{B: left of A-C}}
  sketch: {{A: [0.1, 0], B: {at(B)}, D: {at(D)}, Q: {at(Q)}, R: {at(R)}, S: {at(S)}}}
"""
    return cycle_of(assemble(loading.loads(text).lever.mechanism))


@pytest.mark.parametrize("rotation", ["clockwise", "counter-clockwise"])
@pytest.mark.parametrize("rod", [0.25, 0.28, 0.2999999])
def test_the_gap_is_the_earlier_groups(rod, rotation):
    """The triad ends where the rocker does, exactly, and is not blamed for it."""
    found = hanging(rod, rotation)
    dyad, triad = found.critical
    limit = np.arccos((0.1**2 + 0.35**2 - (rod + 0.15) ** 2) / (2 * 0.1 * 0.35))
    assert dyad.gaps[0] == pytest.approx((limit, FULL_TURN - limit), abs=1e-9)
    assert triad.gaps == () and triad.limits == () and triad.run.blocked == (True, True)
    assert (triad.run.forward, triad.run.backward) == pytest.approx((limit, limit), abs=1e-9)
    near = 10.0 ** -np.arange(2, 12)
    motion = found.motion(np.concatenate([limit - near, FULL_TURN - limit + near]))
    assert motion.closes.all() and unclosed(motion).max() < 1e-12


def test_own_limits_before_the_earlier_groups_end_are_the_triads():
    found = hanging(0.28, arm=0.04)
    dyad, triad = found.critical
    (low, high), (first, last) = dyad.gaps[0], triad.gaps[0]
    assert (
        first < low
        and last == pytest.approx(low, abs=1e-9)
        and triad.gaps[1][0] == pytest.approx(high, abs=1e-9)
    )
    assert triad.run.blocked == (False, False) and len(triad.limits) == 2


# ---------------------------------------------------------------- position 0 and the range


def jamming() -> Mechanism:
    """A triad that goes 112 degrees one way and 245 degrees the other."""
    scheme = drawn("III3", 5)
    return replace(scheme, crank=scheme.crank * 6).mechanism()


def test_within_a_range_nothing_is_said_of_what_is_beyond():
    made = jamming()
    far = run_of(made).forward
    assert far is not None
    driver = replace(made.driver, zero=ZeroAngle(assemble(made).groups[-1].start[0][0]), sweep=0.8 * far)
    found = cycle_of(assemble(replace(made, driver=driver)))
    assert found.critical[-1].gaps == () and found.critical[-1].run.forward is None
    x = np.linspace(0.0, 0.8 * far, 181)
    assert found.motion(x).closes.all()
    beyond = replace(driver, sweep=min(far + 0.2, FULL_TURN - 0.1))
    (critical,) = cycle_of(assemble(replace(made, driver=beyond))).critical
    assert len(critical.gaps) == 1 and critical.run.forward == pytest.approx(far, abs=1e-9)


def test_position_0_at_an_extreme_lies_on_the_sheet():
    made = loading.load("variants/quick_return.yaml").lever.mechanism
    assert isinstance(made.driver.zero, ZeroExtreme)
    found = cycle_of(assemble(made))
    assert found.critical[-1].run.whole and found.motion(np.zeros(1)).closes.all()


@pytest.mark.parametrize("off", [0.0, 1e-13, 1e-10])
def test_a_sketch_at_a_limit_is_refused(off):
    """Two assemblies meet there: the motion could go on in either."""
    made = jamming()
    found = cycle_of(assemble(made))
    run = found.critical[-1].run
    at = run.forward - max(off, 1e-14)
    motion = found.motion(np.array([at]))
    sketch = {p: complex(motion.place(p)[0]) for p in made.sketch}
    with pytest.raises(ProblemError) as caught:
        assemble(replace(made, sketch=sketch))
    (problem,) = caught.value.problems
    assert "two assemblies" in problem.text() and problem.path == ("mechanism", "sketch")


@pytest.mark.exhaustive
def test_positions_do_not_jump_at_random():
    """Class III and IV with long cranks, most of which jam: joints meet and nothing jumps, both ways round."""
    jammed = 0
    for seed in range(12):
        scheme = drawn(("III3", "IV2", "III4")[seed % 3], 300 + seed, [seed % 5 + 1] if seed % 2 else [])
        made = replace(scheme, crank=scheme.crank * (1 + seed % 6)).mechanism()
        made = replace(made, driver=replace(made.driver, omega=made.driver.omega * (-1) ** seed))
        found = cycle_of(assemble(made))
        x = found.turned(360)
        motion = found.motion(np.concatenate([x, beside(found)]))
        assert unclosed(motion).max() < 1e-11 and motion.closes[len(x) :].all()
        assert np.nanmax(jumps(found.motion(x), x[1]), initial=0.0) < 1e-9
        jammed += found.critical[-1].run.forward is not None
    assert jammed >= 4
