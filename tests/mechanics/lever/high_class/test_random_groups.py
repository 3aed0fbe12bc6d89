"""Random mechanisms of class III and IV: the search that judges is right, the program agrees with it, and a wrong
answer would be noticed. The long run is `benchmarks/random_groups`."""

import dataclasses
import sys
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from exhaustive import many

sys.path.append(str(Path(__file__).parents[4]))
from benchmarks.random_groups import judge
from benchmarks.random_groups.confirm import confirmed
from benchmarks.random_groups.draw import draw
from benchmarks.random_groups.judge import asked, judged
from benchmarks.random_groups.near import stretched
from benchmarks.random_groups.schemes import RODS
from benchmarks.random_groups.search import truth

SEED = 4  # full turns, gaps, one without a way back and one that does not return
EACH = 4
ASKED = ("III-RRR", "III-RRR-L", "III-S2-L", "III-P", "dyad-III", "III-dyad", "IV-L", "IV-S")
NEAR = {  # lane of seed 5, rod, its change -> a gap of so many degrees, None where there is just none
    "III-RRR": [
        (12, "AB", 0.06338159120175986, 1.01e-3), (32, "FD", -0.04627036135643721, 3.26e-3),
        (26, "EC", -0.10003629207611084, None), (30, "AB", -0.075, 12.6),
    ],
    "IV": [
        (5, "BD", 0.09276065826416013, 0.173), (23, "CE", 0.0337799072265625, 1.34e-2),
        (13, "CE", -0.04634614604747185, None),
    ],
}  # fmt: skip
DRAWN_OF = {"III-RRR": 36, "IV": 30}  # lanes that were drawn at once with these seeds


@cache
def searched(family):
    """A few mechanisms of a family, and what the search finds of them."""
    batch = draw(family, EACH, SEED)
    return batch, truth(batch)


@cache
def searched_near(family):
    """Mechanisms a hair's breadth before or beyond a tangency."""
    lanes, rods, parts, _ = zip(*NEAR[family], strict=True)
    base = draw(family, DRAWN_OF[family], 5).of(np.array(lanes))
    rod = np.array([RODS[base.scheme].index(name) for name in rods])
    batch = stretched(base, rod, np.array(parts))
    return batch, truth(batch)


# ---------------------------------------------------------------- the search


@pytest.mark.exhaustive
@pytest.mark.parametrize("family", many(["III-RRR", "III-S2-L", "IV-S"]))
def test_the_branch_is_one_of_all_assemblies_at_every_angle_and_its_limit_takes_two_away(family):
    batch, right = searched(family)
    for lane in range(len(batch)):
        found = confirmed(batch, right, lane, every=4)
        assert found.apart < 1e-9 and found.slips == 0
        assert found.taken in (None, 2)


@pytest.mark.exhaustive
def test_a_parallelogram_of_rods_keeps_its_link_parallel_and_jams_where_a_four_bar_would():
    batch, right = searched("III-P")
    v = batch.numbers
    crank, coupler, rocker = v["crank"], v["AB"], v["EC"]
    # link 3 only shifts: C moves on a circle about E, and B, which is C shifted, about a point as far beside E
    ground = np.abs(v["E"] - v["C"] * np.exp(1j * batch.start[:, 1]) - v["O"])
    least, most = np.abs(ground - crank), ground + crank
    goes_round = (most < coupler + rocker) & (least > np.abs(coupler - rocker))
    np.testing.assert_array_equal(np.isinf(right.forward.limit), goes_round)
    turned = right.forward.path[:, :, 1] - batch.start[:, None, 1]
    assert np.nanmax(np.abs(turned)) < 1e-9


@pytest.mark.exhaustive
def test_it_jams_where_the_rods_of_the_four_bar_lie_in_one_line():
    batch, right = searched("III-P")
    v = batch.numbers
    centre = v["E"] - v["C"] * np.exp(1j * batch.start[:, 1])
    axis = np.angle(centre - v["O"])
    ground = np.abs(centre - v["O"])
    jammed = np.flatnonzero(np.isfinite(right.forward.limit))
    assert jammed.size
    for lane in jammed:
        phi = batch.start[lane, 0] + batch.sense[lane] * right.forward.limit[lane] - axis[lane]
        reach = np.abs(v["crank"][lane] * np.exp(1j * phi) - ground[lane])
        coupler, rocker = v["AB"][lane], v["EC"][lane]
        assert min(abs(reach - coupler - rocker), abs(reach - abs(coupler - rocker))) < 1e-12


@pytest.mark.exhaustive
@pytest.mark.parametrize("family", many(sorted(NEAR)))
def test_gaps_as_narrow_as_a_thousandth_of_a_degree_are_found(family):
    _, right = searched_near(family)
    for lane, (*_, width) in enumerate(NEAR[family]):
        gap = right.gap(lane)
        assert (gap is None) == (width is None)
        if gap is not None:
            assert np.degrees(gap[1] - gap[0]) == pytest.approx(width, rel=0.01)


# ---------------------------------------------------------------- the program


@pytest.mark.parametrize("family", many(ASKED))
def test_the_program_agrees_with_the_search(family):
    batch, right = searched(family)
    verdicts = [judged(batch, right, lane, asked(batch.file(lane))) for lane in range(len(batch))]
    assert not [v for v in verdicts if v.wrong]
    assert any(v.kind != "undecided" for v in verdicts)


@pytest.mark.exhaustive
def test_the_sample_has_every_kind_of_run():
    kinds = {judge.kind_of(right, k) for _, right in map(searched, ASKED) for k in range(EACH)}
    assert kinds == {"full turn", "no return", "gap", "no way back"}


@pytest.mark.exhaustive
@pytest.mark.parametrize("family", many(sorted(NEAR)))
def test_the_program_agrees_with_the_search_beside_a_tangency(family):
    batch, right = searched_near(family)
    verdicts = [judged(batch, right, lane, asked(batch.file(lane))) for lane in range(len(batch))]
    assert not [v for v in verdicts if v.wrong or v.kind == "undecided"]


# ---------------------------------------------------------------- the judge can say no


@cache
def with_a_gap():
    """A mechanism with a gap, what is right, and the program's answer."""
    batch, right = searched("III-RRR")
    lane = next(k for k in range(len(batch)) if right.gap(k) and not right.overlaps[k])
    return batch, right, lane, asked(batch.file(lane))


@pytest.mark.parametrize(
    ("said", "named"),
    [
        (lambda a, b: (), "missed gap"),
        (lambda a, b: ((a, b), (b + 0.1, b + 0.2)), "false gap"),
        (lambda a, b: ((a + 1e-8, b),), "end off"),
        (lambda a, b: ((b, a + 2 * np.pi),), "wrong gap"),
    ],
)
def test_another_gap_is_noticed(said, named):
    batch, right, lane, answer = with_a_gap()
    wrong = dataclasses.replace(answer, gaps=said(*right.gap(lane)))
    assert named in judged(batch, right, lane, wrong).wrong


def test_another_assembly_is_noticed():
    batch, right, lane, answer = with_a_gap()
    other = next(k for k in range(len(batch)) if k != lane)
    wrong = dataclasses.replace(answer, motion=asked(batch.file(other)).motion)
    assert "another branch" in judged(batch, right, lane, wrong).wrong


def test_a_joint_that_does_not_close_is_noticed():
    batch, right, lane, _ = with_a_gap()
    answer = asked(batch.file(lane))
    link = answer.motion.linkage.groups[-1].links[0]
    answer.motion.state.r[link] = answer.motion.state.r[link] + 1e-8
    assert "unclosed" in judged(batch, right, lane, answer).wrong


def test_a_refusal_and_a_crash_are_wrong_answers(monkeypatch):
    batch, right, lane, _ = with_a_gap()
    refused = asked("mechanism: {}")
    assert judged(batch, right, lane, refused).wrong == ("no answer",) and "refused" in refused.error
    monkeypatch.setattr(judge, "cycle_of", lambda linkage: 1 / 0)
    assert "ZeroDivisionError" in asked(batch.file(lane)).error
