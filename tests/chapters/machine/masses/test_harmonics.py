"""Harmonics of the motion: sums against the motion, orders of velocity and acceleration, waves along links."""

import math
import re

import numpy as np
import pytest
from conftest import examples, read, solved
from hypothesis import given, settings
from hypothesis import strategies as st
from notes import VARIANTS

from tmm_report import course, loading
from tmm_report.chapters.lever.moving import Moving
from tmm_report.chapters.machine.harmonics.given import Given
from tmm_report.chapters.machine.harmonics.solve import Found, solve
from tmm_report.mechanics.calculus import harmonics as fourier
from tmm_report.problems import ProblemError


def harmonics(name: str, **changes) -> Found:
    return solve(Given(**changes), Moving(solved(name).lever.kinematics, None))


@pytest.fixture
def turning(variant) -> Found:
    """Every ready mechanism whose driving link turns all round."""
    try:
        return harmonics(variant.file.removesuffix(".yaml").rsplit("/", 1)[-1], highest=8)
    except ProblemError as error:
        pytest.skip(error.problems[0].wrong.text)


# ---------------------------------------------------------------- the transform


@settings(max_examples=examples(60))
@given(
    st.lists(st.floats(-5, 5), min_size=4, max_size=4),
    st.lists(st.floats(-5, 5), min_size=4, max_size=4),
    st.sampled_from([16, 25, 96]),
)
def test_harmonics_put_in_come_out(cosine, sine, count):
    theta = np.arange(count) * 2 * math.pi / count
    sine = [0.0, *sine[1:]]
    values = sum(
        a * np.cos(k * theta) + b * np.sin(k * theta)
        for k, (a, b) in enumerate(zip(cosine, sine, strict=True))
    )
    found = fourier.series(values, 5)
    assert np.allclose(found.cosine, [*cosine, 0, 0], atol=1e-12) and np.allclose(
        found.sine, [*sine, 0, 0], atol=1e-12
    )
    assert np.allclose(found.at(theta), values, atol=1e-12)
    k = np.arange(6)
    wave = found.amplitude[:, None] * np.cos(np.outer(k, theta) - found.phase[:, None])
    assert np.allclose(wave.sum(axis=0), values, atol=1e-9)


def test_too_few_samples_are_refused():
    with pytest.raises(ValueError):
        fourier.series(np.zeros(8), 4)


@settings(max_examples=examples(40))
@given(st.floats(0, 6.28), st.integers(2, 5), st.sampled_from([15, 24, 97]))
def test_values_between_the_samples_are_those_of_the_function(shift, times, count):
    theta = np.arange(count) * 2 * math.pi / count
    fine = np.arange(count * times) * 2 * math.pi / (count * times)

    def f(x):
        return 1 + np.cos(x - shift) - 0.3 * np.sin(5 * x)

    assert np.allclose(fourier.refined(f(theta), times), f(fine), atol=1e-12)
    turned = fourier.refined(np.exp(1j * theta) + 0.2 * np.exp(-3j * theta), times)
    assert np.allclose(turned, np.exp(1j * fine) + 0.2 * np.exp(-3j * fine), atol=1e-12)


def test_tail_tells_how_much_is_missed():
    theta = np.arange(64) * 2 * math.pi / 64
    assert fourier.tail(np.cos(theta) + 1e-3 * np.cos(20 * theta)) == pytest.approx(1e-3)
    assert fourier.tail(np.full(64, 7.0)) == 0.0
    count, left = fourier.enough(lambda n: np.cos(60 * np.arange(n) * 2 * math.pi / n))
    assert count > 4 * 60 - 1 and left < 1e-12


def test_turning_vectors_go_by_their_sense():
    theta = np.arange(32) * 2 * math.pi / 32
    found = fourier.turning(3 * np.exp(2j * theta) + 1j * np.exp(-1j * theta), 3)
    assert np.allclose(found, [0, 0, 1j, 0, 0, 3, 0], atol=1e-13)


# ---------------------------------------------------------------- motions


def test_sums_of_enough_orders_are_the_motion_at_the_positions(turning):
    """Of every output: at the positions of the table, which the samples need not meet."""
    if turning.s.number("tail") > 1e-12:
        pytest.skip("a singular position is near")
    kinematics = turning.kinematics
    travels = {travel.output.name: travel for travel in kinematics.travels}
    for signal in turning.signals:
        whole = fourier.series(signal.samples, (len(turning.turned) - 1) // 2)
        table = getattr(travels[signal.name], signal.kind)
        size = np.abs(table).max() + abs(kinematics.omega)  # one that stays the same is rounding
        assert np.allclose(whole.at(kinematics.turned), table, rtol=0, atol=1e-6 * size)


def test_velocity_and_acceleration_have_the_order_as_factor(turning):
    """A_V = kω A_S, A_a = kω A_V."""
    omega = abs(turning.kinematics.omega)
    by_name = {(one.kind, one.name): one.series.amplitude[1:] for one in turning.signals}
    k = np.arange(1, 9)
    for (kind, name), amplitude in by_name.items():
        before = by_name.get(({"V": "S", "a": "V"}.get(kind, ""), name))
        if before is not None and turning.s.number("tail") < 1e-12:
            assert np.allclose(amplitude, k * omega * before, rtol=0, atol=1e-9 * (amplitude.max() + omega))


def test_what_is_left_is_the_rest_of_the_harmonics():
    """Not more than the sum of the amplitudes beyond, and nothing if all are taken."""
    few, many = (harmonics("slider_crank_offset", highest=n) for n in (2, 24))
    for short, long in zip(few.signals, many.signals, strict=True):
        beyond = long.series.amplitude[3:].sum()
        swing = np.abs(short.samples - short.series.cosine[0]).max()
        assert 0 < short.left <= beyond / swing * (1 + 1e-9) + 1e-12
        assert long.left < 1e-8 < short.left


def test_a_crank_pin_has_the_first_order_alone():
    found = harmonics("crank_rocker", points=("A",), links=("1",), highest=5)
    x, y = found.signals[-2:]
    for signal in (x, y):
        assert signal.series.amplitude[1] == pytest.approx(0.06, rel=1e-12)
        assert signal.series.amplitude[2:].max() < 1e-15 and signal.left < 1e-12
    wave = found.waves[0]
    assert np.allclose(wave.x.amplitude[:, 1], 0.06 * wave.xi, atol=1e-15)  # from O to A


# ---------------------------------------------------------------- waves


def test_waves_are_the_harmonics_of_the_places_between(turning):
    """A place at 0.3 of the way, of its own samples."""
    for wave in turning.waves:
        place = wave.places[0] + 0.3 * (wave.places[1] - wave.places[0])
        own = fourier.series(place.real, 8)
        k = int(np.flatnonzero(np.isclose(wave.xi, 0.3))[0])
        assert np.allclose(own.cosine, wave.x.cosine[k], atol=1e-12)
        assert np.allclose(own.sine, wave.x.sine[k], atol=1e-12)


@pytest.mark.parametrize("name", ["compressor", "slider_crank_offset", "v_engine", "compressor_inline"])
def test_waves_of_the_rods_of_slider_cranks_are_those_of_the_formulas(name):
    checks = [wave.check for wave in harmonics(name, highest=6).waves if wave.check is not None]
    assert checks and max(checks) < 1e-12


def test_wave_of_a_rod_written_out():
    """x = r cos φ + ξ √(l² − r² sin² φ), y = (1 − ξ) r sin φ, φ the angle of the crank: the compressor lies along x."""
    found = harmonics("compressor", links=("2",))
    wave = found.waves[0]
    phi = -found.turned  # clockwise from the right
    for k, xi in enumerate(wave.xi):
        x = 0.1 * np.cos(phi) + xi * np.sqrt(0.3**2 - 0.1**2 * np.sin(phi) ** 2)
        y = (1 - xi) * 0.1 * np.sin(phi)
        assert np.allclose(fourier.series(x, 4).amplitude, wave.x.amplitude[k], atol=1e-14)
        assert np.allclose(fourier.series(y, 4).amplitude, wave.y.amplitude[k], atol=1e-14)


# ---------------------------------------------------------------- what a variant states


def problems(block: str) -> list[tuple[str, str]]:
    text = VARIANTS.joinpath("crank_rocker.yaml").read_text("utf-8")
    bare = re.sub(r"\n(balancing|harmonics|flywheel|vibration):[^\n]*(\n+ [^\n]*)*", "", text)
    with pytest.raises(ProblemError) as error:
        course.solve(loading.loads(f"{bare}\nharmonics: {block}\n"))
    return [(problem.key, problem.text()) for problem in error.value.problems]


@pytest.mark.parametrize(
    ("block", "key", "words"),
    [
        ("{points: [Z]}", "harmonics.points.0", "Z"),
        ("{points: [C]}", "harmonics.points.0", "does not move"),
        ("{links: [9]}", "harmonics.links.0", "there is no link 9"),
        ("{links: [0]}", "harmonics.links.0", "the frame does not move"),
        ("{highest: 0}", "harmonics.highest", "from 1 to 24"),
        ("{steps: 1}", "harmonics.steps", "from 2 to 50"),
    ],
)
def test_a_wrong_value_is_told_where_it_stands(block, key, words):
    found = problems(block)
    assert any(one == key and words in text for one, text in found), found


def test_a_slider_of_one_point_has_no_wave():
    text = VARIANTS.joinpath("slider_crank_offset.yaml").read_text("utf-8")
    with pytest.raises(ProblemError) as error:
        loading.loads(text.replace("links: [2]", "links: [3]"))
    assert "less than two points" in str(error.value)


def test_ready_variant_states_it():
    given_ = read("slider_crank_offset").harmonics
    assert given_ is not None and given_.links == ["2"]
