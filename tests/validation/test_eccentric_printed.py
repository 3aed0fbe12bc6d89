"""The published eccentric epicyclic mechanism: its table of teeth, its relations and its claims, judged with numbers.

Source: a coursework guide's own example (see eccentric_printed.yaml): e = 18 mm, u = 4, m = 2 mm.

ERRATUM: the guide's text gives z4 = 33 for t = 10 and 51 for t = 16; its table, and the arithmetic, have them the
other way round.
"""

from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
import yaml

from tmm_report.chapters.gears.eccentric.solve import mechanism as eccentric

PRINTED = yaml.safe_load(Path(__file__).with_name("eccentric_printed.yaml").read_text(encoding="utf-8"))
DATA = PRINTED["input"]


def solved(**more):
    given = eccentric.Given(
        module=DATA["m_mm"] / 1e3, ratio=Fraction(DATA["u13H"]), eccentricity=DATA["e_mm"] / 1e3, **more
    )
    return eccentric.solve(given)


@pytest.fixture(scope="module")
def found():
    return solved(t=10)


@pytest.mark.exhaustive
def test_equation(found):
    """-3*z1 + 2*z2 - 18 = 0"""
    assert found.equation == (-3, 2, -18, 1)


@pytest.mark.exhaustive
def test_table(found):
    """The guide lists the sets whose middle satellite assembles, up to rings of 200 teeth."""
    family, judged = found.judged.family, found.judged
    assembles = judged.residue[:, 1] == 0
    z = np.stack(
        [family.t, family.sun, family.satellites[:, 0], family.ring, family.satellites[:, 1]], axis=-1
    )
    ours = {int(row[0]): [int(x) for x in row] for row in z[assembles]}
    wrong = [(row, ours.get(row[0])) for row in PRINTED["rows"] if ours.get(row[0]) != row]
    assert not wrong
    # one more assembles: there the ring would cut into the roots of the smallest satellite
    assert set(ours) - {row[0] for row in PRINTED["rows"]} == {18}
    assert judged.root[judged.row(18), 2] < 0


def test_relations(found):
    family, E = found.judged.family, 2 * DATA["e_mm"] / DATA["m_mm"]
    np.testing.assert_array_equal(family.satellites[:, 0], ((DATA["u13H"] - 1) * family.sun + E) / 2)
    np.testing.assert_array_equal(family.satellites[:, 1], (family.ring - family.sun) / 2)
    np.testing.assert_array_equal(family.satellites[:, 2], ((DATA["u13H"] - 1) * family.sun - E) / 2)


def test_claim_for_t_10(found):
    """Assembly and neighbourhood hold with the largest satellite: 4.871 mm in hand."""
    assert (found.sun, found.largest, found.ring) == (34, 60, 136)
    assert [s.wheel for s in found.satellites] == ["2", "4", "5", "4'"]
    assert [s.belt for s in found.satellites] == pytest.approx([60, 98, 136, 183], abs=1e-9)
    assert round(1e3 * min(pair.gap for pair in found.neighbours), 3) == 4.871
    assert not found.failed


def test_claim_for_t_16():
    """Assembly holds, neighbourhood fails by 1.741 mm, and the smallest satellite can replace the largest."""
    found = solved(t=16)
    row = found.row
    assert (found.judged.residue[row] == 0).all()
    assert round(1e3 * float(found.judged.closed[row]), 3) == -1.741
    assert [(s.wheel, s.teeth) for s in found.satellites] == [("4", 33), ("5", 24), ("4'", 33)]
    assert not found.failed
    assert found.proof.overlap.max() == 0


@pytest.mark.exhaustive
def test_t_16_with_the_largest_overlaps():
    found = solved(t=16, satellites=("largest", "middle"))
    assert {(c.key, c.wheel) for c in found.failed} == {("neighbourhood", "2–4"), ("neighbourhood", "4'–2")}
    worst = dict(zip(found.proof.meshes, found.proof.overlap.max(axis=1), strict=True))
    assert worst.pop(("2", "4")) > 1e-6 and worst.pop(("2", "4'")) > 1e-6
    assert max(worst.values()) == 0  # all the meshes themselves are right


@pytest.mark.exhaustive
def test_most_compact_set_with_all_satellites():
    """(26, 48, 104, 39) with 0.482 mm; it is what the program takes of itself."""
    found = solved()
    assert (found.sun, found.largest, found.ring) == (26, 48, 104)
    assert found.judged.full == found.row and found.t == 14
    assert [(s.wheel, s.teeth) for s in found.satellites] == [("2", 48), ("4", 39), ("5", 30), ("4'", 39)]
    assert round(1e3 * min(pair.gap for pair in found.neighbours), 3) == 0.482
    assert found.proof.overlap.max() == 0 and found.proof.clearance.min() >= 0


@pytest.mark.exhaustive
@pytest.mark.parametrize(("t", "middle"), [(10, 51), (16, 33)])
def test_erratum(t, middle):
    found = solved(t=t)
    assert (found.ring - found.sun) / 2 == middle
    assert middle == next(row[4] for row in PRINTED["rows"] if row[0] == t)
