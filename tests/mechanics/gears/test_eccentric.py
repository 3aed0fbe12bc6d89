"""Teeth, places, assembly and neighbourhood of eccentric sets against brute force, coordinates and the drawn teeth."""

import math
from fractions import Fraction
from itertools import combinations

import numpy as np
import pytest
from conftest import examples
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from tmm_report.mechanics.calculus.polygons import overlap
from tmm_report.mechanics.gears.eccentric import mechanism as ecc
from tmm_report.mechanics.gears.eccentric.teeth import Cut, Place, assemble, proof
from tmm_report.mechanics.gears.meshing import Rack
from tmm_report.mechanics.gears.pair_sizes import least_teeth
from tmm_report.mechanics.gears.tooth_outlines import external, over_pitch, ring

RACK, M = Rack(), 0.002
ratios = st.builds(Fraction, st.integers(5, 60), st.integers(1, 8)).filter(lambda u: 1.2 < u < 12)


@st.composite
def sets(draw):
    """(sun, ring, E) of a set in which all whole satellites touch both wheels."""
    sun, E = draw(st.integers(12, 60)), draw(st.integers(1, 24))
    smallest = draw(st.integers(10, 70))
    return sun, sun + 2 * smallest + E, E


# --- teeth


@given(st.integers(-500, 500).filter(bool), st.integers(-500, 500).filter(bool))
def test_extended_euclid(a, b):
    g, x, y = ecc.extended_euclid(a, b)
    assert g == math.gcd(a, b) and a * x + b * y == g


@given(ratios, st.integers(1, 40))
def test_family_is_every_whole_solution(u, E):
    """Against trying all suns up to 150 teeth: ring and largest satellite are whole exactly in the family."""
    tried = []
    for sun in range(1, 151):
        ring_ = sun * u
        if ring_.denominator == 1 and (ring_ - sun + E) % 2 == 0:
            tried.append((sun, (ring_ - sun + E) // 2, ring_))
    solution = ecc.general_solution(ecc.equation(u, E))
    if solution is None:
        assert not tried
        return
    t = ecc.range_of(solution, u, 1, int(150 * u))
    found = ecc.family(solution, u, E, t)
    rows = sorted(zip(found.sun, found.satellites[:, 0], found.ring, strict=True))
    assert [tuple(map(int, row)) for row in rows] == tried
    np.testing.assert_array_equal(found.satellites[:, 0] - found.satellites[:, 2], E)


# --- places and assembly


@given(sets())
def test_every_satellite_touches_both_wheels(wheels):
    sun, outer, E = wheels
    all_ = ecc.candidates(*wheels)
    centres = ecc.centres(sun, all_.z, all_.phi1, 2.0)  # in halves of a module
    third = E + (outer - all_.z) * np.exp(1j * all_.phi3)
    np.testing.assert_allclose(third, centres, atol=1e-6)
    np.testing.assert_allclose(np.abs(centres) + np.abs(centres - E), sun + outer, atol=1e-9)


@given(sets())
def test_known_satellites(wheels):
    """Largest on the axis, smallest opposite it; of the middle one cos φ1 = e/(r1 + r3), φ3 = 180° − φ1."""
    sun, outer, E = wheels
    z = np.array([outer - sun + E, outer - sun, outer - sun - E]) / 2
    phi1, phi3 = ecc.angles(sun, outer, E, z)
    middle = math.acos(E / (sun + outer))
    np.testing.assert_allclose(phi1, [0, middle, np.pi], atol=1e-6)
    np.testing.assert_allclose(phi3, [0, np.pi - middle, np.pi], atol=1e-6)


@given(sets())
def test_assembly(wheels):
    """Largest and smallest always, the middle one by the remainders of z1 + z3 and E divided by 4."""
    sun, outer, E = wheels
    largest = (outer - sun + E) // 2
    z = np.array([largest, (outer - sun) / 2, largest - E])
    belts = ecc.belt(sun, outer, largest, z, *ecc.angles(sun, outer, E, z))
    assert belts[0] == pytest.approx(largest, abs=1e-6) and belts[2] == pytest.approx(outer, abs=1e-6)
    if E % 2 == 0:
        assert (abs(ecc.residue(belts[1])) < 1e-6) == ((sun + outer) % 4 == E % 4)


def test_too_large_a_satellite_has_no_place():
    assert np.isnan(ecc.angles(34, 136, 18, np.array([41, 61]))).all()


# --- neighbourhood


@given(sets())
def test_gaps_are_those_of_the_coordinates(wheels):
    sun, *_ = wheels
    all_ = ecc.candidates(*wheels)
    centres = ecc.centres(sun, all_.z, all_.phi1, M)
    apart = np.abs(centres[:, None] - centres) - M / 2 * (all_.z[:, None] + all_.z) - 2 * M
    gap = ecc.gaps(np.array(sun), all_.z, all_.phi1, M, 1.0)
    off = ~np.eye(len(apart), dtype=bool)
    np.testing.assert_allclose(gap[off], apart[off], atol=1e-8)


@given(sets())
def test_closed_form_of_the_neighbourhood(wheels):
    sun, outer, E = wheels
    z = np.array([(outer - sun + E) / 2, (outer - sun) / 2])
    phi1, _ = ecc.angles(sun, outer, E, z)
    gap = ecc.gaps(np.array(sun), z, phi1, M, 1.0)[0, 1]
    assert ecc.closed_gap(sun, outer, E * M / 2, M, 1.0) == pytest.approx(gap, abs=1e-10)


def most_by_trial(gap, allowed, clearance):
    """Size and least gap of the best subset, every pair of which is apart."""
    order = np.flatnonzero(allowed)
    for size in range(len(order), 0, -1):
        gaps = [
            min([gap[i, j] for i, j in combinations(c, 2)], default=np.inf) for c in combinations(order, size)
        ]
        if (widest := max(gaps)) > clearance:
            return size, widest
    return 0, np.inf


@settings(max_examples=examples(60))
@given(
    st.integers(12, 40), st.integers(6, 40), st.integers(1, 5), st.floats(0, 0.004), st.integers(0, 2**10 - 1)
)
def test_largest_set_is_the_largest(sun, smallest, E, clearance, allowed):
    """Every pair is tried here, so this also shows that only neighbours can collide."""
    all_ = ecc.candidates(sun, sun + 2 * smallest + E, E)
    gap = ecc.gaps(np.array(sun), all_.z, all_.phi1, M, 1.0)
    mask = np.array([bool(allowed >> i & 1) for i in range(len(all_.z))])
    order = np.flatnonzero(mask)
    found = [int(order[i]) for i in ecc.largest_set(gap[np.ix_(order, order)], clearance)]
    size, widest = most_by_trial(gap, mask, clearance)
    assert len(found) == size and mask[found].all()
    if size > 1:
        assert min(gap[i, j] for i, j in combinations(found, 2)) == pytest.approx(widest, abs=1e-12)


@given(st.lists(sets(), min_size=1, max_size=6), st.floats(0, 0.01))
def test_subsets_of_a_batch_are_those_of_singles(batch, clearance):
    sun, outer, E = (np.array(column) for column in zip(*batch, strict=True))
    z = np.stack([outer - sun + E, outer - sun, outer - sun - E, outer - sun], axis=-1) / 2
    phi1, _ = ecc.angles(sun[:, None], outer[:, None], E[:, None], z)
    gap = ecc.gaps(sun, z, phi1 * [1, 1, 1, -1], M, 1.0)
    allowed = z % 1 == 0
    fit = ecc.subsets(gap, allowed, clearance)
    for k in range(len(batch)):
        assert fit[k].sum() == most_by_trial(gap[k], allowed[k], clearance)[0]
        np.testing.assert_array_equal(fit[k], ecc.subsets(gap[k], allowed[k], clearance))


# --- the ring


def test_least_teeth_is_the_courses():
    assert least_teeth(RACK) == 17


def test_tips_of_the_ring_are_cut_for_the_fillets():
    """A ring of full height enters the fillet that the rack leaves on its satellite; the cut one does not."""
    pinion, distance = external(48, M, 0.0, RACK), M * (104 - 48) / 2
    full = ring(104, M, 0.0, RACK)
    cut = ring(104, M, 0.0, RACK, tip=ecc.ring_tip(104, np.array([48]), M, RACK))
    assert cut.tip > full.tip
    assert over_pitch(pinion, full, distance, 6)[0].max() > 1e-10
    assert over_pitch(pinion, cut, distance, 6)[0].max() == 0


def test_interference_in_the_ring():
    """18 teeth in a ring of 72: its tip reaches below the base circle; 24 in 88 are clear of it."""
    assert ecc.root_in_hand(72, 18, M, RACK) < 0 < ecc.root_in_hand(88, 24, M, RACK)


# --- the drawn teeth


def made_of(sun, outer, E, picked, backlash=0.0):
    all_ = ecc.candidates(sun, outer, E)
    centres = ecc.centres(sun, all_.z, all_.phi1, M)
    places = [
        Place(f"P{i}", int(all_.z[i]), complex(centres[i]), all_.phi1[i], all_.phi3[i], all_.residue[i])
        for i in picked
    ]
    return assemble(sun, outer, E * M / 2, places, Cut(M, RACK, backlash))


@settings(max_examples=examples(8))
@given(st.integers(17, 40), st.integers(20, 40), st.integers(2, 20))
def test_teeth_of_exact_satellites_do_not_overlap(sun, smallest, E):
    """Largest and smallest of any set, without any backlash."""
    outer = sun + 2 * smallest + E
    assume(ecc.root_in_hand(outer, smallest, M, RACK) > 0)
    found = proof(made_of(sun, outer, E, (0, E)), 4)
    assert found.overlap.max() == 0
    assert found.clearance.min() >= 0 and found.clearance.max() < 1e-3 * M


def test_backlash_is_shared_by_both_flanks():
    found = proof(made_of(26, 104, 18, (0, 9, 18), backlash=1e-4), 4)
    np.testing.assert_allclose(found.clearance.min(axis=1), 0.5e-4, rtol=0.02)


def test_a_residue_beyond_the_backlash_shows():
    """t = 11: half a pitch is missing at the middle satellite; its teeth overlap those of both wheels."""
    found = proof(made_of(32, 128, 18, (0, 9)), 3)
    assert found.overlap[:2].max() == 0
    assert found.overlap[2:].min() > 1e-6


@pytest.mark.exhaustive
def test_a_small_residue_is_taken_up_by_backlash():
    """49 teeth at t = 10 miss 0.096 of a pitch: 0.60 mm on the pitch circle, 0.57 mm along the normal."""
    part = abs(ecc.candidates(34, 136, 18).residue[11])
    needed = part * np.pi * M * np.cos(RACK.alpha)
    assert proof(made_of(34, 136, 18, (0, 11), 1.02 * needed), 6).overlap.max() == 0
    # the turn of the ring is the same, whichever satellite it is found by
    assert proof(made_of(34, 136, 18, (11, 0), 1.02 * needed), 6).overlap.max() == 0
    assert proof(made_of(34, 136, 18, (0, 11), 0.95 * needed), 6).overlap.max() > 0


def test_speeds_of_the_drawn_wheels_keep_them_in_mesh():
    """Also far from the start: the sun turned by 1.234 rad."""
    made = made_of(34, 136, 18, (0, 9, 18, 27))
    sun, outer = made.sun.outline(1.234), made.ring.outline(1.234)
    for satellite in made.satellites:
        outline = satellite.outline(1.234)
        assert overlap(sun, outline) == 0 and overlap(outline, outer, True) == 0
