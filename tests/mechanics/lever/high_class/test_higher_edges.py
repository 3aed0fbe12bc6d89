"""Groups of class III and IV that jam, nearly jam, jam over less than a degree, or go on over more than a turn."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from higher_checks import beside, jumps, limit_from, points_of, stepped, unclosed

from tmm_report import loading
from tmm_report.mechanics.lever.assembly.stated import assemble, ways
from tmm_report.mechanics.lever.cycle import Cycle, cycle_of
from tmm_report.mechanics.lever.mechanism import Mechanism, ZeroAngle
from tmm_report.problems import ProblemError

EDGES = Path(__file__).parents[3] / "edges" / "higher"
FULL_TURN = 2 * np.pi
# name -> turned angle of the limit ahead, of that behind, °, None: none within a turn; whether the two ways overlap
CASES: dict[str, tuple[float | None, float | None, bool]] = {
    "III-RRR-L_108": (None, None, False),
    "III-RRR-L_135": (95.77919, None, True),
    "III-RRR-N_107": (106.97729, 251.60943, False),
    "III-RRR-N_112": (None, None, False),
    "III-RRR_119": (0.02643, 0.10754, False),
    "III-RRR_180": (350.23596, 125.08246, True),
    "III-RRR_6": (236.16592, 34.52209, False),
    "III-S-N_103": (305.68969, 54.12789, False),
    "III-S2_127": (1.24591, None, True),
    "IV-N_106": (148.43945, 211.26108, False),
    "lim904": (41.08205, 319.44952, True),
    "lim904_noloads36": (41.08205, 319.44952, True),
    "z2017": (87.21733, 292.67550, True),
}
PIVOTS = [name for name in CASES if "-S" not in name]


def mechanism(name: str) -> Mechanism:
    return loading.load(EDGES / f"{name}.yaml").lever.mechanism


def cycle(made: Mechanism) -> Cycle:
    return cycle_of(assemble(made))


def degrees(x: float | None) -> float | None:
    return None if x is None else float(np.degrees(x))


@pytest.mark.parametrize("name", CASES)
def test_limits_ahead_and_behind(name):
    run = cycle(mechanism(name)).critical[-1].run
    ahead, behind, overlaps = CASES[name]
    assert degrees(run.forward) == (None if ahead is None else pytest.approx(ahead, abs=1e-5))
    assert degrees(run.backward) == (None if behind is None else pytest.approx(behind, abs=1e-5))
    assert run.overlaps == overlaps
    assert run.returns == (name != "III-RRR-L_108")


@pytest.mark.parametrize("name", CASES)
def test_positions_close_and_none_is_missing(name):
    found = cycle(mechanism(name))
    run = found.critical[-1].run
    x = found.turned(3600)
    motion = found.motion(np.concatenate([x, beside(found)]))
    assert unclosed(motion).max() < 1e-12
    lost = (0.0, 0.0) if run.lost is None else run.lost
    inside = (x > lost[0] + 1e-12) & (x < lost[1] - 1e-12)
    assert np.array_equal(motion.closes[: len(x)], ~inside)
    assert motion.closes[len(x) :].all()  # beside the limits down to 1e-12 rad
    assert np.nanmax(jumps(found.motion(x), x[1]), initial=0.0) < 1e-9


@pytest.mark.parametrize("name", CASES)
def test_gaps_are_what_is_null(name):
    """In driver angles, ascending whatever the sense of rotation."""
    found = cycle(mechanism(name))
    (critical,) = found.critical
    for first, last in critical.gaps:
        assert 0 <= first < FULL_TURN and first < last <= first + FULL_TURN
        turned = found.sense * (np.linspace(first, last, 9)[1:-1] - found.zero)
        assert not found.motion(turned).closes.any()
    assert bool(critical.gaps) == (critical.run.lost is not None)


@pytest.mark.parametrize("name", PIVOTS)
def test_stepped_by_distances_the_points_are_the_same(name):
    """Newton's method on the distances of the points, as far as it goes, and that is to the limit."""
    found = cycle(mechanism(name))
    run, points = found.critical[-1].run, points_of(mechanism(name))
    far = FULL_TURN if run.forward is None else 0.999 * run.forward
    x = np.linspace(0.0, far, 541)
    motion = found.motion(x)
    ours = np.array([motion.place(p) for p in points.names]).T
    theirs, dets = stepped(points, ours[0], found.phi(x))
    assert len(theirs) == len(x)
    assert np.abs(theirs - ours)[:-1].max() < 1e-9 * np.abs(ours).max()  # after a turn ours begins anew
    assert np.all(dets * dets[0] > 0)


@pytest.mark.parametrize("name", [name for name in PIVOTS if CASES[name][0] is not None])
def test_limits_are_where_the_distances_are_singular(name):
    found = cycle(mechanism(name))
    run, points = found.critical[-1].run, points_of(mechanism(name))
    ends = [(run.forward, 1)] if run.overlaps else [(run.forward, 1), (FULL_TURN - run.backward, -1)]
    for end, way in ends:
        near = np.array([end - way * 1e-5])
        place = np.array([found.motion(near).place(p)[0] for p in points.names])
        limit = limit_from(points, place, float(found.phi(near)[0]), way * found.sense)
        assert limit == pytest.approx(float(found.phi(end)), abs=2e-10)


def test_position_0_is_there_whatever_a_turn_rounds_to():
    """A driver angle that is a hair less than a turn after position 0 is position 0."""
    found = cycle(mechanism("III-RRR_104"))
    assert found.critical[-1].run.whole
    around = np.array([0.0, -4e-16, 4e-16, FULL_TURN - 1e-15, FULL_TURN])
    assert found.motion(around).closes.all()


def test_the_sketched_assembly_is_found_where_a_path_to_it_leaps():
    """Of two assemblies at position 0 the sketch is one exactly; one start system leads to the other alone."""
    made = mechanism("III-RRR_469")
    assert sum(way.closes for way in ways(made, made.driver.zero.angle)) == 2
    found = cycle(made).motion(np.zeros(1))
    assert max(abs(found.place(p)[0] - at) for p, at in made.sketch.items()) < 1e-12


# ---------------------------------------------------------------- brothers


def brother(made: Mechanism, seed: int, part: float = 0.03) -> Mechanism:
    """Every arm of the links of the group longer or shorter by up to a few per cent."""
    random = np.random.default_rng(seed)
    links = dict(made.links)
    for name, body in made.links.items():
        if name not in ("frame", "0", made.driver.link) and body.points:
            first = next(iter(body.points.values()))
            points = {
                p: first + (at - first) * random.uniform(1 - part, 1 + part) for p, at in body.points.items()
            }
            links[name] = replace(body, points=points)
    return replace(made, links=links)


@pytest.mark.parametrize("name", ["III-RRR-N_107", "III-RRR_180", "III-S-N_103", "IV-N_106", "lim904"])
@pytest.mark.parametrize("seed", range(4))
def test_brothers_close_and_do_not_jump(name, seed):
    try:
        found = cycle(brother(mechanism(name), seed))
    except ProblemError:
        return  # cannot be assembled in the position of the sketch
    x = found.turned(720)
    motion = found.motion(np.concatenate([x, beside(found)]))
    assert unclosed(motion).max() < 1e-12
    assert motion.closes[len(x) :].all()
    assert np.nanmax(jumps(found.motion(x), x[1]), initial=0.0) < 1e-9


@pytest.mark.parametrize("name", ["III-RRR_180", "III-RRR_6", "III-S-N_103", "lim904", "z2017"])
def test_limits_do_not_depend_on_where_position_0_is(name):
    """Begun elsewhere on the sheet, the same limits are met; turned the other way, they change places."""
    made = mechanism(name)
    found = cycle(made)
    run = found.critical[-1].run
    at = 0.4 * run.forward
    begun = replace(made, driver=replace(made.driver, zero=ZeroAngle(float(found.phi(at)))))
    other = cycle(begun).critical[-1].run
    assert other.forward == pytest.approx(run.forward - at, abs=1e-9)
    assert other.backward == pytest.approx(run.backward + at, abs=1e-9)
    turned = cycle(replace(made, driver=replace(made.driver, omega=-made.driver.omega))).critical[-1].run
    assert (turned.forward, turned.backward) == pytest.approx((run.backward, run.forward), abs=1e-9)


def test_a_dyad_that_stops_soon_after_position_0_has_its_gap_from_there_on():
    """Its triad's sheet begins at position 0: no cell of a grid has the limit between two positions that exist."""
    found = cycle(mechanism("III-dyad_6"))
    dyad = found.critical[-1]
    (first, last), *_ = dyad.gaps
    start = np.mod(found.sense * ((first if found.sense > 0 else last) - found.zero), 2 * np.pi)
    turned = np.array([1e-9, start - 1e-6, start + 1e-6, 0.1])
    assert 1e-4 < start < 1e-3
    assert found.motion(turned).closes.tolist() == [True, True, False, False]
