"""Planetary stages: the search against brute force, Willis, efficiency by two ways, assembly and room in the plane."""

import math
from dataclasses import replace
from fractions import Fraction
from itertools import permutations, product

import numpy as np
import pytest
from conftest import examples
from exhaustive import many
from hypothesis import given, settings
from hypothesis import strategies as st

from tmm_report.mechanics.gears import trains
from tmm_report.mechanics.gears.meshing import Rack
from tmm_report.mechanics.gears.planetary import stage as p
from tmm_report.mechanics.gears.planetary.search import (
    Reason,
    Task,
    candidates,
    judge,
    multiples,
    ranked,
    search,
)

SMALL = {"external": (16, 30), "rings": (30, 90), "satellites": (2, 3, 4)}
TASKS = {
    "sun-ring": Task(p.SCHEMES["sun-ring"], 4.2, (0.005, 0.005), "wheel1", "carrier", **SMALL),
    "sun-ring shifted": Task(
        p.SCHEMES["sun-ring"], 4.2, (0.005, 0.005), "wheel1", "carrier", **SMALL, shifted=2
    ),
    "external-external": Task(
        p.SCHEMES["external-external"], -5.0, (0.004, 0.004), "carrier", "wheel1", **SMALL
    ),
    "external-external, two modules, shifted": Task(
        p.SCHEMES["external-external"], -5.0, (0.005, 0.004), "carrier", "wheel1", **SMALL, shifted=1
    ),
    "external-internal": Task(
        p.SCHEMES["external-internal"], 4.0, (0.005, 0.005), "wheel1", "carrier", **SMALL
    ),
    "internal-internal": Task(
        p.SCHEMES["internal-internal"],
        9.0,
        (0.003, 0.003),
        "carrier",
        "wheel1",
        **{**SMALL, "rings": (40, 70)},
        tolerance=0.3,
    ),
}


# --- the search


def by_hand(task: Task, z1: int, z2: int, z2_: int, z3: int, k: int) -> bool:
    """Every condition of one candidate by scalar arithmetic of its own."""
    s1, s2 = task.scheme.rows
    u = Fraction(z2 * z3, z1 * z2_) * s1 * s2
    if u == 1 and "carrier" in (task.input, task.output):
        return False
    ratio = 1 - u if task.input == "wheel1" else 1 / (1 - u)
    if abs(float(ratio) - task.ratio) > task.tolerance * abs(task.ratio) + 1e-9:
        return False
    sums = z1 + s1 * z2, z3 + s2 * z2_
    a = [m * s / 2 for m, s in zip(task.modules, sums, strict=True)]
    if min(sums) <= 0 or 2 * abs(a[0] - a[1]) > (task.shifted + 1e-9) * task.modules[int(a[1] < a[0])]:
        return False
    x, da, alpha_w = shapes(task, (z1, z2, z2_, z3), a)
    wheels = [(z1, x[0], s1), (z2, x[1], 1), (z2_, x[2], 1), (z3, x[3], s2)]
    if any(z < 17 * (1 - shift) - 1e-9 for z, shift, kind in wheels if kind == 1):
        return False
    for row, ring, satellite in ((0, 0, 1), (1, 3, 2)):
        if task.scheme.rows[row] < 0 and not clear(
            (z1, z2, z2_, z3), da, task, a, alpha_w, row, ring, satellite
        ):
            return False
    rows = ((0, 0, 1), (1, 3, 2))
    if min(overlap((z1, z2, z2_, z3), da, task, alpha_w, *row) for row in rows) < 1.05:
        return False
    if 2 * max(a) * math.sin(math.pi / k) <= max(da[1], da[2]):
        return False
    return seats(task.scheme, (z1, z2, z2_, z3), k)


def shapes(task, z, a):
    """Shift coefficients, tip diameters and operating angles, one by one."""
    alpha, m, rows = task.rack.alpha, task.modules, task.scheme.rows
    involute = lambda angle: math.tan(angle) - angle  # noqa: E731
    alpha_w = [
        math.acos(min(1.0, math.cos(alpha) * one / max(a))) if one < max(a) * (1 - 1e-12) else alpha
        for one in a
    ]
    sums = [
        (z[c] + s * z[t]) * (involute(w) - involute(alpha)) / (2 * math.tan(alpha))
        for s, w, c, t in zip(rows, alpha_w, (0, 3), (1, 2), strict=True)
    ]
    cuts = [
        total - (max(a) - one) / module if s > 0 else 0.0
        for total, one, module, s in zip(sums, a, m, rows, strict=True)
    ]
    x2 = sums[0] / 2 if rows[0] > 0 else 0.0
    x2_ = x2 if task.scheme.single else (sums[1] / 2 if rows[1] > 0 else 0.0)
    x = [
        sums[0] - x2 if rows[0] > 0 else sums[0] + x2,
        x2,
        x2_,
        sums[1] - x2_ if rows[1] > 0 else sums[1] + x2_,
    ]
    cut = [cuts[0], cuts[0], cuts[0] if task.scheme.single else cuts[1], cuts[1]]
    module = [m[0], m[0], m[1], m[1]]
    kinds = [rows[0], 1, 1, rows[1]]
    da = [n * (t + 2 * (s + shift - c)) for n, t, s, shift, c in zip(module, z, kinds, x, cut, strict=True)]
    return x, da, alpha_w


def clear(z, da, task, a, alpha_w, row, ring, satellite):
    """An internal pair: the ring's tip beyond the satellite's limit point, and the tips passing each other."""
    m, distance = task.modules[row], max(a)
    rb = [m * z[w] * math.cos(task.rack.alpha) / 2 for w in (ring, satellite)]
    R, r = da[ring] / 2, da[satellite] / 2
    if rb[0] > R or math.sqrt(R**2 - rb[0] ** 2) < distance * math.sin(alpha_w[row]):
        return False
    if not abs(R - r) < distance:  # the satellite's tip circle encloses the ring's
        return False
    at_ring = math.acos((R**2 + distance**2 - r**2) / (2 * distance * R))
    at_satellite = math.acos((R**2 - distance**2 - r**2) / (2 * distance * r))
    involute = lambda angle: math.tan(angle) - angle  # noqa: E731
    inv_w, inv_r = involute(alpha_w[row]), involute(math.acos(rb[1] / r))
    turned = (at_satellite + inv_r - inv_w) * z[satellite] / z[ring]
    return turned >= at_ring + involute(math.acos(rb[0] / R)) - inv_w


def overlap(z, da, task, alpha_w, row, central, satellite):
    """The contact ratio of a row."""
    total = 0.0
    for wheel, sign in ((central, task.scheme.rows[row]), (satellite, 1)):
        angle = math.acos(task.modules[row] * z[wheel] * math.cos(task.rack.alpha) / da[wheel])
        total += sign * z[wheel] * (math.tan(angle) - math.tan(alpha_w[row]))
    return total / (2 * math.pi)


def seats(scheme, z, k):
    """Whether every satellite finds a turn in which both its crowns stand in the gaps of the central wheels.

    In turns; satellite j is at j/k of a turn. Its own turn ψ must make the phases of both meshes whole.
    """
    (s1, s2), (z1, z2, z2_, z3) = scheme.rows, z
    for j in range(1, k):
        place = Fraction(j, k)
        turns = (((z1 + s1 * z2) * place - n) / (s1 * z2) for n in range(z2))
        if not any((((z3 + s2 * z2_) * place - s2 * z2_ * psi) % 1) == 0 for psi in turns):
            return False
    return True


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", many(TASKS, 3))
def test_search_equals_brute_force(name):
    task = TASKS[name]
    found = search(task)
    ours = {(*found.teeth[:, i].tolist(), int(found.satellites[i])) for i in found.accepted}
    ranges = [task.external if kind == p.EXTERNAL else task.rings for kind in p.kinds(task.scheme)]
    numbers = [range(low, high + 1) for low, high in ranges]
    boxes = product(*numbers[:2], [0] if task.scheme.single else numbers[2])
    theirs = set()
    for z1, z2, z2_ in boxes:
        crown = z2_ or z2
        for z3 in near_coaxial(task, z1, z2, crown, numbers[3]):
            theirs |= {(z1, z2, crown, z3, k) for k in task.satellites if by_hand(task, z1, z2, crown, z3, k)}
    assert ours == theirs
    assert len(ours) > 5


def near_coaxial(task, z1, z2, z2_, numbers):
    """z3 within a wide band of coaxiality: `by_hand` judges, this only keeps the loop short."""
    s1, s2 = task.scheme.rows
    middle = task.modules[0] * (z1 + s1 * z2) / task.modules[1] - s2 * z2_
    return range(max(numbers[0], math.floor(middle) - 4), min(numbers[-1], math.ceil(middle) + 4) + 1)


def test_reasons_name_the_first_condition_that_fails():
    task = replace(TASKS["sun-ring"], external=(12, 100), rings=(20, 200))
    cases = [  # z1, z2, z3, k
        ((20, 20, 100, 3), Reason.RATIO),  # 1 + 100/20 = 6
        ((20, 21, 64, 3), Reason.COAXIALITY),  # 41 and 43
        ((16, 18, 52, 2), Reason.UNDERCUT),
        ((17, 19, 55, 3), Reason.INTERFERENCE),  # a satellite of 19 needs a ring of 86
        ((21, 24, 69, 6), Reason.NEIGHBOURHOOD),
        ((20, 22, 64, 2), Reason.ACCEPTED),
        ((20, 22, 64, 3), Reason.ACCEPTED),
        ((21, 23, 67, 3), Reason.ASSEMBLY),  # 88/3
    ]
    z = np.array([(z1, z2, z2, z3) for (z1, z2, z3, _), _ in cases]).T
    found = judge(task, z, np.array([k for (*_, k), _ in cases]))
    assert [Reason(code) for code in found] == [reason for _, reason in cases]


def test_the_ranking():
    task = replace(TASKS["sun-ring"], rings=(30, 120), external=(16, 60))
    found = search(task)
    order = ranked(task, found)
    assert sorted(order) == sorted(found.accepted)
    repeated = multiples(found.teeth[:, order], found.satellites[order])
    assert np.array_equal(repeated, np.sort(repeated))  # those in new pairs of teeth first
    rings = found.teeth[3, order][~repeated]
    assert np.array_equal(rings, np.sort(rings))  # of one module: compact is a small ring


def test_interference_of_a_ring_agrees_with_the_published_limits():
    """20°, ha* = 1: no ring serves a satellite of 17, and 8 or 9 teeth of difference are needed; ha* = 0.8: 7."""
    scheme = p.Scheme("one row", (p.INTERNAL, p.INTERNAL))

    def free(satellite, ring, ha=1.0):
        z = np.array([ring, satellite, satellite, ring])
        return p.internal_pair(scheme, p.sizes(scheme, (1, 1), Rack(ha=ha), z), z, 0).free

    rings = np.arange(25, 400)
    assert not np.any(free(np.full_like(rings, 17), rings))
    assert not free(20, 60) and free(20, 64) and not free(19, 85) and free(19, 86)
    assert not free(60, 67) and free(60, 69) and free(100, 108)
    assert not free(60, 66, 0.8) and free(60, 67, 0.8)


@given(
    scheme=st.sampled_from(list(p.SCHEMES)),
    teeth=st.tuples(*[st.integers(17, 60)] * 4),
    k=st.integers(2, 6),
)
@settings(max_examples=examples(300))
def test_assembly_is_exactly_where_every_satellite_finds_its_seat(scheme, teeth, k):
    scheme = p.SCHEMES[scheme]
    z1, z2, z2_, z3 = teeth
    z = (z1, z2, z2 if scheme.single else z2_, z3)
    assert bool(p.assembles(scheme, np.array(z), k)) == seats(scheme, z, k)
    if p.carrier_turns(scheme, z, k) is not None:  # the course's condition is sufficient
        assert p.assembles(scheme, np.array(z), k)


# --- sizes


@given(
    z1=st.integers(17, 40), half=st.integers(20, 60), spare=st.integers(-2, 2), double=st.sampled_from([1, 2])
)
def test_shifted_rows_share_one_centre_distance(z1, half, spare, double):
    """The shift coefficients put back the centre distance, with clearance in both meshes."""
    scheme, rack, m = p.SCHEMES["sun-ring"], Rack(), 0.004
    z = np.array([z1, half, half, z1 + 2 * half + spare])
    found = p.sizes(scheme, (m, m), rack, z)
    sums = p.teeth_sums(scheme, z)
    involute = np.tan(found.angles) - found.angles
    again = 2 * found.shift_sums * np.tan(rack.alpha) / sums + np.tan(rack.alpha) - rack.alpha
    assert involute == pytest.approx(again, abs=1e-12)
    x1, x2, x2_, x3 = found.shifts
    assert (x1 + x2, x3 - x2_) == pytest.approx(tuple(found.shift_sums), abs=1e-12) and x2 == x2_
    assert found.working[0] + found.working[1] == pytest.approx(2 * found.centre_distance)
    assert found.working[3] - found.working[2] == pytest.approx(2 * found.centre_distance)
    clearances = [
        found.centre_distance - (found.tip[0] + found.root[1]) / 2,
        found.centre_distance - (found.root[0] + found.tip[1]) / 2,
        (found.root[3] - found.tip[2]) / 2 - found.centre_distance,
        (found.tip[3] - found.root[2]) / 2 - found.centre_distance,
    ]
    assert min(clearances) >= rack.c * m * (1 - 1e-9)
    assert np.all(found.shift_sums >= 0) and (np.max(found.shift_sums) > 0) == (spare != 0)


def test_shifted_solutions_have_teeth_that_work():
    """Of all that the search accepts with shift: no pointed tips."""
    task = replace(TASKS["sun-ring shifted"], external=(12, 60), rings=(30, 160), tolerance=2.0)
    found = search(task)
    z = found.teeth[:, found.accepted]
    sizes = p.sizes(task.scheme, task.modules, task.rack, z)
    tangent = np.sqrt(sizes.tip**2 - sizes.base**2) / sizes.base
    alpha, tip = task.rack.alpha, np.arctan(tangent)
    half = np.pi / 2 + 2 * sizes.shifts * np.tan(alpha) + z * (np.tan(alpha) - alpha - tangent + tip)
    assert np.min((half * sizes.tip / z / task.modules[0])[:2]) > 0.25


# --- kinematics and efficiency

TEETH = st.tuples(*[st.integers(12, 120)] * 4)


def train_of(scheme, z, eta):
    inner = [row == p.INTERNAL for row in scheme.rows]
    crown = "2" if scheme.single else "2'"
    members = [
        trains.Member("1", "ring" if inner[0] else "wheel", z[0]),
        trains.Member("2", "satellite", z[1], carried_by="H"),
        *([] if scheme.single else [trains.Member("2'", "satellite", z[2], carried_by="H", shaft="2")]),
        trains.Member("3", "ring" if inner[1] else "wheel", z[3]),
        trains.Member("H", "carrier"),
    ]
    meshes = (
        trains.Mesh("1", "2", "H", inner[0], math.sqrt(eta)),
        trains.Mesh(crown, "3", "H", inner[1], math.sqrt(eta)),
    )
    return trains.Train(tuple(members), meshes)


NAMES = {"wheel1": "1", "wheel3": "3", "carrier": "H"}


@given(
    scheme=st.sampled_from(list(p.SCHEMES)), teeth=TEETH, way=st.sampled_from(list(permutations(p.MEMBERS)))
)
def test_speeds_satisfy_willis_and_agree_with_the_general_train(scheme, teeth, way):
    scheme = p.SCHEMES[scheme]
    z = (teeth[0], teeth[1], teeth[1] if scheme.single else teeth[2], teeth[3])
    basic = float(p.basic_ratio(scheme, np.array(z)))
    if abs(basic - 1) < 1e-9:  # the carrier turns alone
        return
    input, output, held = way
    speed = p.relative_speeds(basic, input, held)
    assert speed[input] == pytest.approx(1) and speed[held] == pytest.approx(0, abs=1e-12)
    carrier = speed["carrier"]
    assert speed["wheel1"] - carrier == pytest.approx(basic * (speed["wheel3"] - carrier))
    assert p.stage_ratio(basic, input, output) == pytest.approx(1 / speed[output])
    theirs = trains.speeds(train_of(scheme, z, 0.98), {NAMES[input]: 1.0, NAMES[held]: 0.0})
    for member, name in NAMES.items():
        assert speed[member] == pytest.approx(float(theirs[name]), rel=1e-9, abs=1e-12)
    satellite = p.satellite_speed(scheme, z, speed["wheel1"], carrier)
    assert satellite == pytest.approx(float(theirs["2"]), rel=1e-9, abs=1e-9)


@pytest.mark.exhaustive
@given(
    scheme=st.sampled_from(list(p.SCHEMES)),
    teeth=TEETH,
    way=st.sampled_from(list(permutations(p.MEMBERS))),
    eta=st.floats(0.8, 0.999),
)
@settings(max_examples=examples(300))
def test_efficiency_agrees_with_the_general_flow_of_power(scheme, teeth, way, eta):
    scheme = p.SCHEMES[scheme]
    z = (teeth[0], teeth[1], teeth[1] if scheme.single else teeth[2], teeth[3])
    basic = float(p.basic_ratio(scheme, np.array(z)))
    if abs(basic - 1) < 1e-6:
        return
    input, output, held = way
    flow = p.power_flow(basic, eta, input, output)
    speed = p.relative_speeds(basic, input, held)
    train = train_of(scheme, z, eta)
    known = {NAMES[m]: float(speed[m]) for m in p.MEMBERS}
    moved = {name: float(w) for name, w in trains.speeds(train, known).items()}
    torque = {m: float(value) for m, value in flow.torque.items()}
    assert sum(torque.values()) == pytest.approx(0, abs=1e-9 * max(map(abs, torque.values())))
    if flow.efficiency > 0:
        sought = (NAMES[held], NAMES[output])
        general = trains.loads(train, moved, {NAMES[input]: torque[input]}, sought)
        assert float(general.efficiency) == pytest.approx(float(flow.efficiency), rel=1e-7)
        assert 0 < flow.efficiency < 1
        for member, name in NAMES.items():
            assert float(general.torque[name]) == pytest.approx(torque[member], rel=1e-6, abs=1e-9)


def test_the_formula_of_the_course_and_a_stage_that_locks_itself():
    """u13(H) = −5.6 and 0.98: (1 − u η)/(1 − u); of u close to 1 wheel 1 cannot drive."""
    assert p.power_flow(-5.6, 0.98, "wheel1", "carrier").efficiency == pytest.approx(6.488 / 6.6)
    step_up = p.power_flow(1.01, 0.98, "wheel1", "carrier")
    assert step_up.efficiency < 0 and step_up.exponent == 1
    slow = p.power_flow(1.01, 0.98, "carrier", "wheel1")
    assert 0 < slow.efficiency < 0.5 and slow.exponent == -1


def test_a_million_candidates_are_looked_through():
    task = Task(
        p.SCHEMES["internal-internal"], 40.0, (0.005, 0.005), "carrier", "wheel1", satellites=(2, 3, 4)
    )
    assert search(task).examined > 1e6 and candidates(task).shape[0] == 4
