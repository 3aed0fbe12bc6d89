"""The chapter of the eccentric mechanism: what is chosen, what is refused and with which sentence."""

from fractions import Fraction

import numpy as np
import pytest
from pydantic import ValidationError

from tmm_report.chapters.gears.eccentric.given import Eccentric
from tmm_report.chapters.gears.eccentric.solve import family as eccentric_family
from tmm_report.chapters.gears.eccentric.solve import mechanism as eccentric
from tmm_report.chapters.gears.eccentric.view.mechanism import EccentricView
from tmm_report.course import Results, Variant
from tmm_report.i18n import Translator
from tmm_report.mechanics.gears.meshing import Rack
from tmm_report.note import render
from tmm_report.problems import ProblemError
from tmm_report.report.formats import Html
from tmm_report.report.numbering import Numbering
from tmm_report.report.page import Page
from tmm_report.variant.stated import model_of

BASE = {"module": 0.002, "ratio": Fraction(4), "eccentricity": 0.018}


def solved(**changes):
    return eccentric.solve(eccentric.Given(**{**BASE, **changes}))


@pytest.mark.exhaustive
def test_eccentricity_from_teeth():
    found = solved(ratio=None, eccentricity=None, teeth=(34, 60, 136))
    assert found.e == pytest.approx(0.018) and found.t == 10 and found.ratio_of_teeth == 4


@pytest.mark.exhaustive
def test_teeth_of_sun_and_ring_with_the_eccentricity():
    assert solved(ratio=None, teeth=(26, 104)).largest == 48


@pytest.mark.exhaustive
def test_teeth_beyond_the_family_are_taken():
    """A ring of 216 teeth and a sun of 14, undercut: both are what the teacher chose."""
    assert solved(ratio=None, eccentricity=None, teeth=(54, 90, 216)).t == 0
    small = solved(ratio=None, eccentricity=None, teeth=(14, 40, 76))
    assert ("undercut", "1") in {(c.key, c.wheel) for c in small.failed}


@pytest.mark.exhaustive
def test_a_wider_clearance_takes_a_larger_set():
    assert solved(clearance=0.001).t == 12
    assert solved(clearance=0.003).t == 10


@pytest.mark.exhaustive
def test_fractional_ratio():
    found = solved(ratio=Fraction(7, 2))
    assert found.ring / found.sun == 3.5
    assert found.proof.overlap.max() == 0


def test_odd_eccentricity_leaves_no_middle_satellite():
    found = solved(eccentricity=0.017)
    assert {s.kind for s in found.satellites} == {"largest", "smallest"}
    assert not found.failed


@pytest.mark.exhaustive
def test_nothing_is_said_of_middle_satellites_of_half_a_tooth():
    """Neither that they do not assemble nor how far they are from their neighbours."""
    odd, even = (solved(eccentricity=e) for e in (0.017, 0.018))
    assert _view(odd).sets("residue") is None and _view(even).sets("residue") is not None
    for found, whole in ((odd, False), (even, True)):
        (part,) = _view(found).family().parts
        assert {len(row) for row in part.rows} == {10 if whole else 6}
        assert ("in closed form" in _chapter(found)) == whole


@pytest.mark.exhaustive
def test_the_close_view_promises_neighbours_only_where_it_shows_them():
    for e, shown in ((0.017, False), (0.018, True)):
        found = solved(eccentricity=e)
        assert ("narrowest place between neighbours in" in _chapter(found)) == shown
        assert ("Meshes and neighbours, scale" in _chapter(found)) == shown


@pytest.mark.parametrize("ratio", ["4/0", 3.14159])
def test_a_ratio_is_one_of_whole_numbers_of_teeth(ratio):
    with pytest.raises(ValidationError, match="no ratio of whole numbers"):
        model_of(Eccentric).model_validate({"ratio": ratio, "eccentricity": "18 mm", "module": "2 mm"})


@pytest.mark.exhaustive
def test_a_coefficient_of_one_is_not_written():
    """(1 − 3/2)·2 = −1: −z1 + 4 z2 − 36 = 0, not −1z1."""
    view = _view(solved(ratio=Fraction(3, 2)))
    assert "<mn>1</mn></mrow><msub>" not in str(view.page.math(view.with_numbers()))


def _view(found):
    return EccentricView(found, Page(Html(), Translator("en"), Numbering()))


def _chapter(found):
    """The chapter's text in a note of its own."""
    results = Results(Variant(language="en"), eccentric=found)
    return render(results, "html", Translator("en"))["note.html"].decode()


@pytest.mark.exhaustive
def test_backlash_lets_other_satellites_in():
    """With 0.4 mm of backlash a residue of 0.068 of a pitch is taken up; without it only exact ones stand."""
    exact, loose = solved(t=13), solved(t=13, backlash=4e-4)
    assert all(s.residue == 0 for s in exact.satellites)
    assert len(loose.satellites) > len(exact.satellites)
    assert loose.proof.overlap.max() == 0
    assert all(s.wheel[0] == "6" or s.kind for s in loose.satellites)


@pytest.mark.exhaustive
def test_speeds_satisfy_willis():
    found = solved(t=10, speed=60.0)
    assert [(of.stopped, of.driven) for of in found.motions] == [("H", "1"), ("3", "1"), ("1", "3")]
    for motion in found.motions:
        speed = motion.speed
        assert speed[motion.stopped] == 0 and speed[motion.driven] == 60
        carrier = speed["H"]
        assert (speed["1"] - carrier) == pytest.approx(-4 * (speed["3"] - carrier))
        for s in found.satellites:
            assert (speed[s.wheel] - carrier) * s.teeth == pytest.approx(-(speed["1"] - carrier) * found.sun)


@pytest.mark.exhaustive
def test_condition_margins_are_those_of_the_places():
    found = solved(t=10, clearance=0.001)
    margin = {c.wheel: c.margin for c in found.conditions if c.key == "neighbourhood"}
    centre = {s.wheel: s for s in found.satellites}
    for (one, other), value in ((("2", "4"), margin["2–4"]), (("4", "5"), margin["4–5"])):
        a, b = centre[one], centre[other]
        free = abs(a.centre - b.centre) - 0.001 * (a.teeth + b.teeth) - 0.004 - 0.001
        assert value == pytest.approx(free, abs=1e-12)


@pytest.mark.parametrize(
    ("changes", "wrong", "right"),
    [
        ({"eccentricity": 0.0173}, "not a whole number of half modules", "17 mm or 18 mm"),
        ({"eccentricity": 0.0004}, "not a whole number of half modules", "1 mm or 2 mm"),
        ({"ratio": None}, "the ratio of ring and sun is not stated", "ratio: 4"),
        ({"eccentricity": None}, "the eccentricity is not stated", "18 mm"),
        ({"ratio": Fraction(4, 5)}, "no room between sun and ring", "above 1"),
        ({"ratio": Fraction(3), "eccentricity": 0.017}, "no whole numbers of teeth", "16 mm or 18 mm"),
        ({"t": 40}, "no usable set at t = 40", "t from 2 to 18"),
        ({"eccentricity": 0.4}, "at most 200 teeth holds two planet gears", "ring_up_to"),
        ({"ratio": None, "teeth": (34, 60, 30)}, "cannot go round the sun", "[34, 60, 136]"),
        (
            {"ratio": None, "teeth": (34, 51, 136)},
            "no room for the smallest or no eccentricity",
            "from 52 to 96",
        ),
        ({"ratio": None, "teeth": (34, 61, 136)}, "the teeth give the eccentricity 20 mm", "leave one"),
        ({"ratio": Fraction(5), "teeth": (34, 60, 136)}, "the teeth give the ratio 4", "leave one"),
        (
            {"ratio": None, "eccentricity": None, "teeth": (34, 136)},
            "do not give the eccentricity",
            "[34, 60, 136]",
        ),
        ({"ratio": None, "teeth": (34, 135)}, "half a tooth", "17 mm or 19 mm"),
        ({"clearance": 0.5}, "leave a clearance of 500 mm", "a clearance under 96 mm"),
        ({"rack": Rack(ha=2.0, c=0.5)}, "come to a point", "less than 2.157"),
        ({"backlash": 0.002}, "backlash", "up to 0.4 mm"),
        (
            {"eccentricity": 0.017, "satellites": ("middle",)},
            "no planet gear of this kind",
            "largest, smallest",
        ),
        ({"ratio": None, "eccentricity": None, "teeth": (6, 20, 36)}, "the ring cuts into", "[18, 50, 108]"),
    ],
)
def test_mistakes_say_what_would_work(changes, wrong, right):
    with pytest.raises(ProblemError) as caught:
        solved(**changes)
    (problem,) = caught.value.problems
    assert wrong in str(problem.wrong) and right in str(problem.right)
    assert problem.path[0] == "eccentric" and len(problem.path) == 2


@pytest.mark.exhaustive
def test_what_would_work_works():
    """The eccentricities proposed for a ratio without whole teeth have solutions."""
    for e in (0.016, 0.018):
        assert solved(ratio=Fraction(3), eccentricity=e).sun > 0
    assert len(solved(clearance=0.0959).satellites) == 2


@pytest.mark.exhaustive
def test_proposed_eccentricity_and_ring_work():
    with pytest.raises(ProblemError) as caught:
        solved(eccentricity=0.4)
    proposed = caught.value.problems[0].right.values
    assert len(solved(eccentricity=float(proposed["e"]) / 1e3).satellites) >= 2
    assert len(solved(eccentricity=0.4, ring_up_to=proposed["ring"]).satellites) >= 2
    with pytest.raises(ProblemError):
        solved(eccentricity=0.4, ring_up_to=proposed["ring"] - 1)


@pytest.mark.exhaustive
def test_arrays_are_judged_as_singles():
    """A row of the family judged alone is the same row."""
    found = solved()
    family = found.judged.family
    for row in (0, 7, len(family.t) - 1):
        one = type(family)(*(part[row : row + 1] for part in family))
        alone = eccentric_family.judge(found.given, found.ratio_of_teeth, found.E, one)
        for name in ("phi1", "belt", "gap", "closed", "root", "tips", "fit"):
            np.testing.assert_array_equal(getattr(alone, name)[0], getattr(found.judged, name)[row])
