"""Powers, speeds, torques of the shafts of a drive against a plain walk along it; motors and ratios against search."""

import math
from itertools import pairwise, product

import numpy as np
import pytest
from conftest import examples
from hypothesis import given, settings
from hypothesis import strategies as st

from tmm_report.mechanics.machine.power_chain import (
    by_root,
    chosen,
    efficiency,
    judge,
    shaft_powers,
    shaft_speeds,
    shares,
    torque,
)  # fmt: skip

ETA = st.floats(0.3, 1.0)
SHAFTS = st.lists(st.tuples(ETA, ETA, st.floats(0.2, 12.0)), min_size=1, max_size=9)


@given(SHAFTS, st.floats(10.0, 1e5), st.floats(1.0, 400.0), st.booleans())
@settings(max_examples=examples(200))
def test_a_walk_along_the_shafts(shafts, power, speed, received):
    links, bearings, ratios = (np.array(column) for column in zip(*shafts, strict=True))
    links[0] = ratios[0] = 1.0
    powers = shaft_powers(power, links, bearings, received)
    speeds = shaft_speeds(speed, ratios)
    left, turning = power, speed
    for k in range(len(shafts)):
        before = left * links[k]
        left = before * bearings[k]
        turning /= ratios[k]
        assert powers[k] == pytest.approx(before if received else left, rel=1e-12)
        assert speeds[k] == pytest.approx(turning, rel=1e-12)
        assert torque(powers[k], speeds[k]) * turning == pytest.approx(powers[k], rel=1e-12)
    assert efficiency(links, bearings) * power == pytest.approx(left, rel=1e-12)


@given(SHAFTS, st.floats(10.0, 1e5), st.floats(1.0, 400.0))
@settings(max_examples=examples(200))
def test_torques_by_the_ratios_backwards(shafts, power, speed):
    """T_(k−1) = T_k/(u η), from the machine to the motor."""
    links, bearings, ratios = (np.array(column) for column in zip(*shafts, strict=True))
    links[0] = ratios[0] = 1.0
    torques = torque(shaft_powers(power, links, bearings), shaft_speeds(speed, ratios))
    for k in range(len(shafts) - 1, 0, -1):
        assert torques[k - 1] == pytest.approx(torques[k] / (ratios[k] * links[k] * bearings[k]), rel=1e-12)


def test_a_batch_is_a_loop_of_singles():
    rng = np.random.default_rng(5)
    links, bearings, ratios = (
        rng.uniform(0.5, 1, (2, 3, 4, 5)).tolist(),
        rng.uniform(0.5, 1, (4, 5)),
        rng.uniform(1, 5, 5),
    )
    motor = rng.uniform(1, 9, (2, 3, 4))
    for received in (False, True):
        whole = shaft_powers(motor, links, bearings, received)
        for i, j, k in product(range(2), range(3), range(4)):
            one = shaft_powers(motor[i, j, k], links[i][j][k], bearings[k], received)
            assert np.array_equal(whole[i, j, k], one)
    assert shaft_speeds(motor, ratios)[1, 2, 3] == pytest.approx(shaft_speeds(motor[1, 2, 3], ratios))


def test_the_rounded_torque():
    """9550 P/n is greater than P/ω by 7.4e-5."""
    assert torque(4000.0, 1410 * math.pi / 30, rounded=True) == pytest.approx(9550 * 4 / 1410, rel=1e-14)
    assert torque(4000.0, 150.0) == 4000 / 150


@given(st.floats(1.1, 900.0), st.integers(1, 6), st.floats(0.4, 2.5))
@settings(max_examples=examples(100))
def test_shares_of_a_ratio(whole, count, times):
    u = shares(whole, count, times)
    assert math.prod(u) == pytest.approx(whole, rel=1e-12)
    assert all(one == pytest.approx(times * other, rel=1e-12) for one, other in pairwise(u))


@given(st.floats(1.1, 900.0), st.floats(0.5, 1.5), st.booleans())
@settings(max_examples=examples(100))
def test_shares_by_the_root(whole, factor, slow):
    fast, other = by_root(whole, factor, slow)
    assert fast * other == pytest.approx(whole, rel=1e-12)
    assert (other if slow else fast) ** 2 == pytest.approx(factor**2 * whole, rel=1e-12)


MOTORS = st.lists(
    st.tuples(st.sampled_from([1500.0, 2200.0, 3e3, 4e3, 5500.0]), st.floats(60.0, 310.0)),
    min_size=1,
    max_size=12,
)


@given(
    MOTORS,
    st.floats(800.0, 6000.0),
    st.floats(1.0, 20.0),
    st.floats(0.0, 0.1),
    st.floats(2.0, 40.0),
    st.floats(1.0, 3.0),
)
@settings(max_examples=examples(300))
def test_no_other_motor_is_better(motors, needed, speed, overload, low, wide):
    high = low * wide
    judged = judge(motors, needed, speed, overload, low, high)
    k = chosen(motors, judged, low, high)
    able = [
        i for i, (power, own) in enumerate(motors)
        if needed <= power * (1 + overload) * (1 + 1e-9) and low * (1 - 1e-9) <= own / speed <= high * (1 + 1e-9)
    ]  # fmt: skip
    assert (k is None) == (not able)
    if k is not None:
        assert k in able and motors[k][0] == min(motors[i][0] for i in able)

        def off(i):
            ratio = motors[i][1] / speed
            return max(ratio / math.sqrt(low * high), math.sqrt(low * high) / ratio)

        assert all(off(k) <= off(i) * (1 + 1e-12) for i in able if motors[i][0] == motors[k][0])


def test_the_weakest_that_will_do_and_of_equal_ones_the_nearest():
    motors = [(5500.0, 100.0), (4000.0, 120.0), (4000.0, 104.0), (3000.0, 100.0)]
    assert chosen(motors, judge(motors, 3500, 10.0, 0.0, 8.0, 12.5), 8.0, 12.5) == 2
    assert chosen(motors, judge(motors, 3500, 10.0, 0.2, 8.0, 12.5), 8.0, 12.5) == 3
    assert chosen(motors, judge(motors, 6000, 10.0, 0.05, 8.0, 12.5), 8.0, 12.5) is None
