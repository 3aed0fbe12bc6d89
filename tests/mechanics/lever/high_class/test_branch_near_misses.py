"""Branches that all but cross another, or all but turn back: gaps a hair wide are told, and places beside them found.

Two mechanisms of `benchmarks.random_groups`; their limits are those of its search, in long doubles.
"""

import pickle

import numpy as np
import pytest

from tmm_report.loading import loads
from tmm_report.mechanics.lever.assembly.all_roots import assemblies
from tmm_report.mechanics.lever.assembly.stated import assemble
from tmm_report.mechanics.lever.cycle import cycle_of
from tmm_report.mechanics.lever.motion import solve

BESIDE = np.array([1e-12, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-3, 1e-2])

NEAR_CROSSING = """
mechanism:
  frame: {O: [0.08603469936216412, 0.12911139229010649], E: [0.1767945606694205, -0.059558745940403474],
    F: [0.03167637962863795, 0.2626707920897626]}
  links:
    1: {points: {O: 0, A: 0.08466692996428446}}
    2: {points: {A: 0, B: 0.1810903803642248}}
    3: {points: {B: 0, C: [-0.3434407342507877, -0.02983741407259903],
      D: [0.26973347217974214, 0.09647234362204839]}}
    4: {points: {E: 0, C: 0.42884874497349207}}
    5: {points: {F: 0, D: 0.5209988593530658}}
  driver: {link: 1, speed: 5, rotation: counter-clockwise, zero: {angle: -1.7409101919938965}}
  sketch: {A: [0.0717010477, 0.0456665874], B: [-0.1081702388, 0.0666438642], C: [0.0768950571, 0.3574920127],
    D: [-0.1955211522, -0.206180030]}
"""
NEAR_CUSP = """
mechanism:
  frame: {O: [0.1741514242614396, -0.22654248765634394], F: [0.015203258658812446, -0.20129940192949541]}
  links:
    1: {points: {O: 0, A: 0.053119722181046145}}
    2: {points: {A: 0, B: [-0.11494310934271915, 0.1112889825868356], C: [0.27434936259631215, -0.39471639527011854]}}
    3: {points: {B: 0, D: 0.40391039802267}}
    4: {points: {C: 0, E: 0.479102652882708}}
    5: {points: {F: 0, D: [0.3402100842080108, -0.3100289145576997], E: [0.024901392142034597, 0.16454513471319018]}}
  driver: {link: 1, speed: 5, rotation: clockwise, zero: {angle: -1.0757600389152886}}
  sketch: {A: [0.1993866698, -0.2732852653], C: [0.6285824338, -0.0568144783], D: [-0.2921575022, -0.5439219230],
    E: [0.179937969, -0.224914140], B: [0.0731208273, -0.3715405097]}
"""


def solved(text):
    """The cycle, and the gap in angles turned, rad."""
    cycle = cycle_of(assemble(loads(text).lever.mechanism))
    return cycle, cycle.critical[0].run.lost


def ways(cycle, turned):
    """In how many ways the group can be assembled."""
    group = cycle.linkage.groups[0]
    phi = np.array([cycle.zero + cycle.sense * turned])
    return len(assemblies(group.loops, group.known[0](phi)))


@pytest.mark.exhaustive
def test_a_gap_of_five_thousandths_of_a_degree_is_not_taken_for_a_crossing():
    cycle, (first, last) = solved(NEAR_CROSSING)
    assert np.degrees([first, last]) == pytest.approx([195.721697, 195.726923], abs=1e-6)
    assert cycle.critical[0].changes == ()
    middle = (first + last) / 2
    assert ways(cycle, middle) == ways(cycle, first - 1e-4) - 2 == ways(cycle, last + 1e-4) - 2


@pytest.mark.parametrize("text", [NEAR_CROSSING, NEAR_CUSP])
def test_places_within_a_limit_exist_however_near(text):
    cycle, (first, last) = solved(text)
    for turned in (first - BESIDE, last + BESIDE):
        motion = cycle.motion(turned)
        assert motion.closes.all()
        group = cycle.linkage.groups[0]
        assert np.abs(group.loops.residual(motion.state, group.loops.read(motion.state))).max() < 1e-12
    assert not cycle.motion(np.array([first + 1e-9, last - 1e-9])).closes.any()


def test_places_beside_a_limit_go_as_the_root_of_the_angle_left():
    """q − q₀ ~ √x: a hundredth of the angle is a tenth of the way."""
    cycle, (first, _) = solved(NEAR_CUSP)
    joint = cycle.motion(first - np.array([0.0, 1e-12, 1e-10])).place("E")
    one, other = np.abs(joint[1:] - joint[0])
    assert other / one == pytest.approx(10.0, rel=0.05)


def test_a_group_goes_to_another_process_with_what_moves_before_it():
    linkage = assemble(loads(NEAR_CUSP).lever.mechanism)
    sent = pickle.loads(pickle.dumps(linkage))
    phi = linkage.mechanism.driver.omega * np.linspace(0, 0.01, 5) - 1.0757600389152886
    assert (solve(sent, phi).place("E") == solve(linkage, phi).place("E")).all()
