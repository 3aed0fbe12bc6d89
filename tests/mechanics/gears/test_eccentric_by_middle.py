"""Middle satellites assembled with one another, the largest left out: the belt's whole number and the drawn teeth."""

from fractions import Fraction

import numpy as np
import pytest
from conftest import examples
from exhaustive import many
from hypothesis import given, settings
from hypothesis import strategies as st

from tmm_report.chapters.gears.eccentric.solve import mechanism as eccentric
from tmm_report.mechanics.gears.eccentric import mechanism as ecc
from tmm_report.mechanics.gears.eccentric.teeth import Cut, Place, assemble, proof
from tmm_report.mechanics.gears.meshing import Rack
from tmm_report.problems import ProblemError

M = 0.002


@st.composite
def pairs(draw):
    """(sun, ring, E) with whole middle satellites; the largest is whole or not."""
    sun, middle = draw(st.integers(17, 60)), draw(st.integers(20, 60))
    return sun, sun + 2 * middle, draw(st.integers(1, 20))


def placed(sun, ring, E, spoilt=0.0):
    """Both middle satellites, by their belt over one another; `spoilt`: a residue that is put in, pitches."""
    z = (ring - sun) // 2
    phi1, phi3 = (float(angle) for angle in ecc.angles(sun, ring, E, z))
    centre = complex(ecc.centres(sun, z, phi1, M))
    return [
        Place("4", z, centre, phi1, phi3, 0.0),
        Place("4'", z, centre.conjugate(), 2 * np.pi - phi1, 2 * np.pi - phi3, spoilt),
    ]


@given(pairs())
def test_both_middle_satellites_have_whole_belts_over_one_of_them(teeth):
    sun, ring, E = teeth
    all_ = ecc.candidates(sun, ring, E, by_middle=True)
    middle = 2 * all_.z == ring - sun
    assert np.count_nonzero(middle) == 2 and not all_.residue[middle].any()


@given(pairs())
def test_candidates_touch_both_wheels_all_the_way_round(teeth):
    sun, ring, E = teeth
    all_ = ecc.candidates(sun, ring, E)
    assert np.isfinite(all_.phi1).all() and (np.diff(all_.phi1) > 0).all()
    near, far = sun + all_.z, ring - all_.z
    assert np.allclose(near * np.exp(1j * all_.phi1) - E, far * np.exp(1j * all_.phi3), atol=1e-9 * ring)


@given(pairs())
@settings(max_examples=examples(6), deadline=None)
def test_their_teeth_do_not_overlap_wherever_the_remainders_lie(teeth):
    """The turns are computed, never fitted: polygons of teeth at positions over a pitch share nothing."""
    sun, ring, E = teeth
    made = assemble(sun, ring, E * M / 2, placed(sun, ring, E), Cut(M, Rack(), tolerance=2e-6))
    assert proof(made, count=2).overlap.max() < 1e-12


def test_half_a_pitch_more_and_the_teeth_do_overlap():
    made = assemble(54, 106, 0.003, placed(54, 106, 3, spoilt=0.5), Cut(M, Rack(), tolerance=2e-6))
    assert proof(made, count=2).overlap.max() > 1e-9


@pytest.mark.parametrize(("teeth", "e"), [((54, 106), 0.003), ((54, 106), 0.007), ((63, 117), 0.005)])
def test_sets_of_the_ratios_53_27_and_39_21_assemble(teeth, e):
    """The largest satellite would have half a tooth, or its belt and the middle ones' differ by half a pitch."""
    found = eccentric.solve(eccentric.Given(module=M, teeth=teeth, eccentricity=e))
    assert [s.kind for s in found.satellites] == ["middle", "middle'"]
    assert not found.failed and found.touching
    assert all(s.residue == 0 for s in found.satellites)


@pytest.mark.exhaustive
def test_middle_satellites_asked_for_alone_are_judged_over_one_another():
    """z1 + z3 = 160 leaves 0 and E = 6 leaves 2 when divided by 4: over the largest satellite half a pitch is left."""
    alone = eccentric.solve(
        eccentric.Given(module=M, teeth=(54, 106), eccentricity=0.006, satellites=("middle",))
    )
    assert alone.touching and not alone.failed and alone.by_middle
    both = eccentric.solve(
        eccentric.Given(module=M, teeth=(54, 106), eccentricity=0.006, satellites=("largest", "middle"))
    )
    assert {c.key for c in both.failed} == {"assembly"} and not both.touching


def test_the_family_by_the_middle_satellite_is_that_of_the_ratio():
    found = eccentric.solve(
        eccentric.Given(module=M, ratio=Fraction(53, 27), eccentricity=0.003, satellites=("middle",))
    )
    family = found.judged.family
    assert found.halved and (family.ring * 27 == family.sun * 53).all()
    assert (family.satellites[:, 1] * 2 == family.ring - family.sun).all()


@pytest.mark.parametrize("teeth", [(27, 53), (21, 39), (30, 60), (34, 136)])
@pytest.mark.parametrize("ratio", [None, Fraction(53, 27), Fraction(39, 21), Fraction(4)])
@pytest.mark.parametrize("halves", many([1, 4, 9, 20], 2))
def test_nothing_is_said_of_a_t_that_was_not_given(teeth, ratio, halves):
    """Ratio and teeth stated together, of all kinds: solved as stated, or refused by a key that is there."""
    given_ = eccentric.Given(module=M, ratio=ratio, teeth=teeth, eccentricity=halves * M / 2)
    try:
        found = eccentric.solve(given_)
    except ProblemError as error:
        keys = {problem.path[-1] for problem in error.problems}
        assert "t" not in keys and keys <= {"teeth", "eccentricity", "ratio"}
        if ratio is not None and Fraction(teeth[1], teeth[0]) != ratio:
            assert "ratio" in keys
        assert all(problem.right for problem in error.problems)
    else:
        assert (found.sun, found.ring) == teeth
        assert ratio in (None, Fraction(teeth[1], teeth[0]))
