"""Dyads at the limits of their assembly: the ends exact, and beside them they close or are lost."""

from __future__ import annotations

import numpy as np
import pytest
import schemes
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from tmm_report.mechanics.lever.assur_groups import decompose
from tmm_report.mechanics.lever.cycle import Cycle, cycle_of
from tmm_report.mechanics.lever.mechanism import Guide, Link, Slide
from tmm_report.mechanics.lever.motion import linkage_of

LENGTHS = st.floats(0.3, 3.0)
BESIDE = st.floats(-12, -3).map(lambda power: 10**power)


def cycle(links, guides=(), slides=()) -> Cycle:
    return cycle_of(linkage_of(decompose(schemes.mechanism(links, guides, slides)), [1]))


def limits(of: Cycle) -> np.ndarray:
    return np.array([limit for critical in of.critical for limit in critical.limits])


@pytest.mark.exhaustive
@settings(max_examples=60)
@given(LENGTHS, LENGTHS, LENGTHS, LENGTHS, BESIDE, st.sampled_from([1, -1]))
def test_rod_and_rocker(a, b, c, d, off, side):
    """AC of the law of cosines is b + c or |b − c| there; on the inner side both links keep their lengths."""
    four_bar = cycle(
        [
            Link("0", {"O": 0j, "C": d + 0j}),
            Link("1", {"O": 0j, "A": a + 0j}),
            Link("2", {"A": 0j, "B": b + 0j}),
            Link("3", {"C": 0j, "B": c + 0j}),
        ]
    )
    ends = limits(four_bar)
    assume(ends.size)
    for cosine in ((a * a + d * d - far**2) / (2 * a * d) for far in (b + c, b - c)):
        if abs(cosine) < 0.9999:
            for angle in (np.arccos(cosine), 2 * np.pi - np.arccos(cosine)):
                assert np.abs(ends - angle).min() < 1e-12 / (1 - cosine**2)
    motion = four_bar.motion(ends + side * off)
    A, B = motion.place("A"), motion.place("B")
    there = motion.closes
    assert (there == np.isfinite(B.real)).all() and (np.isnan(B.real) == np.isnan(B.imag)).all()
    assert np.abs(B - A)[there] == pytest.approx(b, rel=1e-9)
    assert np.abs(B - d)[there] == pytest.approx(c, rel=1e-9)


@pytest.mark.exhaustive
@settings(max_examples=40)
@given(LENGTHS, LENGTHS, st.floats(-1, 1), BESIDE, st.sampled_from([1, -1]))
def test_rod_and_guide(r, l, e, off, side):
    slider = cycle(
        [
            Link("0", {"O": 0j}),
            Link("1", {"O": 0j, "A": r + 0j}),
            Link("2", {"A": 0j, "B": l + 0j}),
            Link("3", {"B": 0j}),
        ],
        [Guide("x", "0", 1j * e, 1 + 0j)],
        [Slide("3", "x")],
    )
    ends = limits(slider)
    assume(ends.size)
    assert np.abs(np.abs(r * np.sin(ends) - e) - l).max() < 1e-12
    motion = slider.motion(ends + side * off)
    A, B, there = motion.place("A"), motion.place("B"), motion.closes
    assert np.abs(B - A)[there] == pytest.approx(l, rel=1e-9)
    assert B.imag[there] == pytest.approx(e, abs=1e-12)
    assert np.isnan(B[~there].real).all() and np.isnan(B[~there].imag).all()
