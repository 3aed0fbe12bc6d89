"""Forces of a whole cycle: extremes against forces solved at their angles and on a dense grid, works of the loads
against closed answers and the energy."""

import math
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from conftest import read, solved

from tmm_report import course
from tmm_report.chapters.lever.kinetostatics.given import Force, Loads, Moment
from tmm_report.chapters.lever.kinetostatics.quantities.cycle import ranges
from tmm_report.chapters.lever.kinetostatics.solve.coordinates import Coordinate
from tmm_report.chapters.lever.kinetostatics.solve.drawn_cycle import sampled
from tmm_report.chapters.lever.kinetostatics.solve.indicator_strokes import reach
from tmm_report.chapters.lever.kinetostatics.solve.positions import at, stated

NAMES = (
    "compressor",
    "press",
    "crank_rocker",
    "shaper",
    "whitworth",
    "scotch_yoke",
    "engine_four_stroke",
    "loom",
)
"""Groups of classes II and IV, guides, change of sense, indicator diagrams, cycles of one and two turns."""


def forces(name):
    return solved(name).lever.kinetostatics


def under(variant, loads):
    """Of the mechanism of a variant under other loads, without what else is asked of it."""
    lever = replace(variant.lever, loads=loads, friction=None, readings={}, reduction=False)
    return course.solve_lever(lever).kinetostatics


def directly(found, turned):
    """Solved at these angles, by no panels."""
    turned = np.atleast_1d(np.asarray(turned, float))
    motion = found.kinematics.cycle.motion(turned)
    return at(found.given, motion, turned, stated(found.given, found.kinematics, motion, turned))


def rows(found):
    """Every extreme that is told: values at any angles, and the pair of extremes."""
    over = found.over
    yield lambda one: one.balancing, over.moment
    for key, peaks in over.sizes.items():
        yield lambda one, key=key: np.abs(one.statics.reactions[key].force), peaks
        for part, of in zip((np.real, np.imag), over.components[key], strict=True):
            yield lambda one, key=key, part=part: part(one.statics.reactions[key].force), of


@pytest.mark.parametrize("name", NAMES)
def test_extremes_are_exact(name):
    """What is told is the force at that angle, or at its side of a jump; nothing on a dense grid is beyond it."""
    found = forces(name)
    dense = directly(found, np.linspace(0, found.kinematics.cycle.period, 1441) + 1e-3)
    largest = max(high.value for _, high in found.over.sizes.values())
    for values, (low, high) in rows(found):
        size = max(abs(low.value), abs(high.value))
        room = 1e-9 * size + 1e-12 * largest
        grid = np.broadcast_to(values(dense), dense.turned.shape)
        assert low.value - room <= grid.min() and grid.max() <= high.value + room
        for peak in (low, high):
            beside = directly(found, peak.turned + (peak.side or 0) * 1e-9)
            assert float(np.ravel(values(beside))[0]) == pytest.approx(
                peak.value, abs=room + 1e-6 * size * bool(peak.side)
            )


def test_where_no_forces_are_none_is_told():
    """A mechanism that does not exist all round, and one that passes a singular position."""
    assert forces("elliptic_trammel").works is None
    variant = read("slider_crank_offset")
    short = replace(variant.lever.mechanism.links["2"], points={"A": 0j, "B": 0.05 + 0j, "S2": 0.02 + 0j})
    links = {**variant.lever.mechanism.links, "2": short}
    mechanism = replace(variant.lever.mechanism, links=links)
    found = under(replace(variant, lever=replace(variant.lever, mechanism=mechanism)), variant.lever.loads)
    assert found.over is None and found.works is None
    # towards the limit it grows without bound: the least of the positions printed is no extreme
    low, high = found.extremes
    assert np.isnan(low.value) and np.isnan(high.value)


@pytest.mark.parametrize("name", NAMES)
def test_works_of_all_loads_add_up_to_nothing(name):
    works = forces(name).works
    assert abs(works.whole) <= 1e-9 * works.size
    for weight in works.weights.values():
        assert abs(weight.whole) <= 1e-11 * max(weight.driving, 1e-6)


@pytest.mark.parametrize("name", NAMES)
def test_senses_of_the_moment_fill_the_cycle(name):
    found = forces(name)
    zones, cycle = found.works.zones, found.kinematics.cycle
    assert zones[0].start == 0 and zones[-1].end == cycle.period
    assert [a.end for a in zones[:-1]] == [b.start for b in zones[1:]]
    assert all(a.drives != b.drives for a, b in pairwise(zones))
    assert sum(zone.work for zone in zones) == pytest.approx(
        found.works.balancing.whole, abs=1e-9 * found.works.size
    )
    middles = directly(found, [(zone.start + zone.end) / 2 for zone in zones if zone.end - zone.start > 0.3])
    assert list(middles.balancing * cycle.sense > 0) == [z.drives for z in zones if z.end - z.start > 0.3]


def test_a_constant_force_against_the_motion_does_force_times_way():
    """Both strokes resist: W = −2 F H, and the engine gives it back."""
    variant = read("crank_rocker")
    point = "B"
    force = Force(at=point, direction="against", constant=7.0)
    found = under(variant, Loads(forces=(force,)))
    (work,) = found.works.stated
    motion = found.kinematics.cycle.motion(np.linspace(0, 2 * math.pi, 20001))
    way = np.abs(np.diff(motion.place(point))).sum()
    assert work.driving == 0 and work.resisting == pytest.approx(-7.0 * way, rel=1e-7)
    assert found.works.balancing.whole == pytest.approx(7.0 * way, rel=1e-7)
    assert set(work.signs[:-1]) <= {-1, 0}


def test_a_fixed_force_on_a_slider_does_nothing_over_a_cycle():
    """It drives one way and resists the other, F H each, by the exact stroke."""
    variant = read("compressor")
    force = Force(at="B", direction=-1j, constant=100.0)
    found = under(variant, Loads(gravity=0j, forces=(force,)))
    (work,) = found.works.stated
    _, (low, high) = reach(found.kinematics.cycle, Coordinate("B", 1j))
    assert (work.driving, work.resisting) == pytest.approx(
        [100 * (high.value - low.value), -100 * (high.value - low.value)]
    )
    assert abs(work.whole) < 1e-9


def test_a_moment_along_the_rotation_drives_all_round():
    variant = read("crank_rocker")
    driver = variant.lever.mechanism.driver.link
    moment = Moment(on=driver, direction="along", constant=3.0)
    found = under(variant, Loads(gravity=0j, moments=(moment,)))
    (work,) = found.works.stated
    assert (work.driving, work.resisting) == (pytest.approx(6 * math.pi), 0.0)
    assert found.works.power == pytest.approx(-3.0 * abs(float(found.kinematics.omega)))


def test_mean_power_is_that_of_the_resistances():
    """Frictionless, the engine gives what the useful resistance takes; the compressor's clock is 0.05 s a turn."""
    works = forces("compressor").works
    taken = -sum(work.whole for work in works.stated)
    assert works.power == pytest.approx(taken / 0.05)


def test_curves_show_both_sides_of_a_jump_and_the_positions_as_they_are():
    found = forces("press")
    drawn = sampled(found)
    values = drawn.of(found.over.balancing, found.diagram.balancing)
    jump = np.radians(145)
    before, after = np.searchsorted(drawn.turned, [jump - 1e-4, jump + 1e-4])
    assert abs(values[before - 1]) < 3 and values[after] == pytest.approx(found.extremes[1].value, rel=1e-9)
    assert np.all(np.diff(drawn.turned) > 0)
    np.testing.assert_array_equal(values[drawn.known], found.diagram.balancing)


def test_the_end_of_a_law_that_jumps_there_is_drawn_too():
    """A load that grows over the whole turn and falls back at its end."""
    variant = read("compressor")
    force = Force(at="B", direction=1j, by_angle=[(0.0, 0.0), (2 * math.pi, 1000.0)])
    found = under(variant, Loads(forces=(force,)))
    drawn = sampled(found)
    values = drawn.of(found.over.loading.stated[0], found.diagram.loading.stated[0])
    assert (
        values.max() == pytest.approx(1000.0, rel=1e-6) and drawn.turned[values.argmax()] > 2 * math.pi - 1e-3
    )


@pytest.mark.parametrize(
    ("numbers", "text"), [([], ""), ([3], "3"), ([1, 2], "1, 2"), ([0, 1, 2, 5, 7, 8, 9], "0–2, 5, 7–9")]
)
def test_positions_in_a_row_are_told_by_their_ends(numbers, text):
    assert ranges(numbers) == text
