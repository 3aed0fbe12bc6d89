"""Forces in the meshes of an eccentric mechanism: by the lines of action, by equilibrium, powers, displacements."""

import itertools

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tmm_report import course, loading
from tmm_report.chapters.gears.eccentric.quantities import tables, values
from tmm_report.problems import ProblemError

SETS = {
    "four": "ratio: 4, eccentricity: 18 mm, t: 10",
    "three": "ratio: 4, eccentricity: 18 mm, t: 16, satellites: [smallest, middle]",
    "one": "ratio: 4, eccentricity: 18 mm, satellites: [largest]",
    "middle alone": "teeth: [54, 106], eccentricity: 6 mm, satellites: [middle]",
    "others": "ratio: 4, eccentricity: 18 mm, t: 13, backlash: 0.4 mm",
}
LOADS = {
    "sun": "moment: 20 N*m",
    "ring, elastic": "moment: 80 N*m, on: ring, meshes: 4e8 N/m, axes: 2e8 N/m",
    "against": "moment: -20 N*m, meshes: 4e8 N/m, axes: 1e8 N/m",
}


def solved(which, load):
    return course.solve(loading.loads(f"eccentric: {{module: 2 mm, {which}, load: {{{load}}}}}")).eccentric


@pytest.fixture(params=itertools.product(SETS, LOADS), ids="-".join)
def found(request):
    which, load = request.param
    return solved(SETS[which], LOADS[load])


def numbers(found):
    """Single numbers, and the columns of the forces."""
    single = {value.key.removeprefix("eccentric_"): value.value for value in values(found)}
    table = next(table for table in tables(found) if table.name == "eccentric_loads")
    return single, {column.key: column.numbers() for column in table.columns if column.key != "wheel"}


def lines(found, of):
    """Unit vectors of the forces of the sun and of the ring on a satellite: along the tangents from the base circles to
    the pitch points, whichever press it and turn as the moment does."""
    half, alpha, sense = found.given.module / 2, found.given.rack.alpha, np.sign(found.given.load.moment)
    made = []
    for axis, z, outward in ((0, found.sun, 1), (found.e, found.ring, -1)):
        to = (of.centre - axis) / abs(of.centre - axis)
        pitch, base = half * z * to, half * z * np.cos(alpha) * to
        ways = [way * (pitch - base * np.exp(1j * turn)) for turn in (alpha, -alpha) for way in (1, -1)]
        (line,) = [
            way
            for way in ways
            if sense * cross(pitch, way) > 0 and outward * (pitch.conjugate() * way).real > 0
        ]
        made.append(line / abs(line))
    return made


def cross(a, b):
    return (a.conjugate() * b).imag


def by_displacements(found):
    """Circumferential forces by wheel: the sun turned by the moment against the ring that is held, each satellite free
    to turn, its axis elastic or rigid: stiffnesses by displacements."""
    load, count = found.given.load, len(found.satellites)
    half, alpha = found.given.module / 2, found.given.rack.alpha
    c, k = (load.meshes, load.axes) if load.yielding is not None else (4e8, 0.0)
    stiffness = np.zeros((1 + 3 * count, 1 + 3 * count))
    springs = []
    for number, of in enumerate(found.satellites):
        r = half * of.teeth
        to_ring = (of.centre - found.e) / abs(of.centre - found.e)
        contacts = (-r * of.centre / abs(of.centre), r * to_ring)  # from the centre of the satellite
        for which, (arm, line) in enumerate(zip(contacts, lines(found, of), strict=True)):
            row = np.zeros(1 + 3 * count)  # how much the mesh is pressed together for each displacement
            if which == 0:
                row[0] = cross(of.centre + arm, line)
            at = 1 + 3 * number
            row[at : at + 3] = -cross(arm, line), -line.real, -line.imag
            springs.append(row)
            stiffness += c * np.outer(row, row)
        for axis in (2, 3):
            stiffness[axis + 3 * number, axis + 3 * number] += k
    size = np.array([1.0] + [half * of.teeth * (k == 0) or 1.0 for of in found.satellites for k in range(3)])
    free = [
        n for n in range(1 + 3 * count) if load.yielding is not None or n == 0 or n % 3 == 1
    ]  # rigid axes stay
    wanted = np.zeros(len(free))
    wanted[0] = load.moment if load.on == "sun" else load.moment * found.sun / found.ring
    displaced = np.zeros(1 + 3 * count)
    scaled = (stiffness / np.outer(size, size))[np.ix_(free, free)]
    displaced[free] = np.linalg.solve(scaled, wanted) / size[free]
    pressed = c * np.array(springs) @ displaced
    return {of.wheel: pressed[2 * n] * np.cos(alpha) for n, of in enumerate(found.satellites)}


def test_satellites_sun_and_ring_are_in_equilibrium(found):
    """Forces along the lines of action: no moment on a satellite, the stated one on its wheel, nothing on the whole."""
    single, columns = numbers(found)
    half, on_sun, on_ring, on_axes = found.given.module / 2, 0.0, 0.0, 0.0
    sums = np.zeros(2, dtype=complex)
    for row, of in enumerate(found.satellites):
        to_ring = (of.centre - found.e) / abs(of.centre - found.e)
        forces = [columns["F_n"][row] * line for line in lines(found, of)]
        places = half * found.sun * of.centre / abs(of.centre), found.e + half * found.ring * to_ring
        own = sum(cross(place - of.centre, force) for place, force in zip(places, forces, strict=True))
        assert abs(own) < 1e-9 * columns["F_n"][row] * half * of.teeth
        on_sun -= cross(places[0], forces[0])
        on_ring -= cross(places[1] - found.e, forces[1])
        assert columns["Q"][row] == pytest.approx(abs(sum(forces)), rel=1e-9)
        on_axes += cross(of.centre, sum(forces))
        sums -= forces
    assert single["M_1"] == pytest.approx(-on_sun, rel=1e-9)
    assert single["M_3"] == pytest.approx(-on_ring, rel=1e-9)
    assert np.abs(sums) == pytest.approx([single["R_1"], single["R_3"]], rel=1e-9, abs=1e-9 * single["F_sum"])
    # the body of the axes: pressed by the satellites and by the axis of the ring, at the distance e
    assert single["M_H"] == pytest.approx(-(on_axes + cross(complex(found.e), sums[1])), rel=1e-9)


def test_powers_of_the_moments_are_nothing_in_all_motions(found):
    single, _ = numbers(found)
    for motion in found.motions:
        powers = [single[f"M_{name}"] * motion.speed[name] for name in "13H"]
        assert sum(powers) == pytest.approx(0, abs=1e-9 * max(map(abs, powers)))


def test_forces_are_those_of_elastic_meshes_and_axes(found):
    _, columns = numbers(found)
    forces = by_displacements(found)
    assert columns["F_t"] == pytest.approx([forces[of.wheel] for of in found.satellites], rel=1e-9)


@settings(max_examples=12)
@given(st.floats(1e6, 1e10), st.floats(1e6, 1e10))
def test_no_other_sharing_has_less_energy(meshes, axes):
    load = f"moment: 20 N*m, meshes: {meshes!r} N/m, axes: {axes!r} N/m"
    found = solved(SETS["three"], load)
    _, columns = numbers(found)
    alpha = found.given.rack.alpha
    pressed = np.array([abs(sum(lines(found, of))) for of in found.satellites])

    def energy(force):
        normal = force / np.cos(alpha)
        return (normal**2 * (1 / meshes + pressed**2 / (2 * axes))).sum()

    least = energy(columns["F_t"])
    for one, other in itertools.permutations(range(len(pressed)), 2):
        moved = columns["F_t"].copy()
        moved[one] += 0.01
        moved[other] -= 0.01
        assert energy(moved) > least


def test_with_rigid_axes_all_meshes_carry_the_same_and_the_axes_do_not():
    found = solved(SETS["four"], LOADS["sun"])
    single, columns = numbers(found)
    assert columns["F_t"] == pytest.approx(np.full(4, 20 / 0.034 / 4), rel=1e-12)
    assert single["M_3"] == pytest.approx(80) and single["M_H"] == pytest.approx(-100)
    assert columns["Q"].max() > 1.05 * columns["Q"].min()  # 4 and 4' lean to either side


@pytest.mark.parametrize(
    ("load", "words"),
    [
        ("moment: 0 N*m", "loads no mesh"),
        ("moment: 20 N*m, meshes: 4e8 N/m", "stiffness axes"),
        ("moment: 20 N*m, axes: 4e8 N/m", "stiffness meshes"),
        ("moment: 20 N*m, meshes: 4e8 N/m, axes: 0", "without stiffness"),
        ("moment: 20 mm", "is a length"),
        ("moment: 20 N*m, on: carrier", "sun"),
    ],
)
def test_a_wrong_load_is_told(load, words):
    with pytest.raises(ProblemError) as error:
        solved(SETS["four"], load)
    (problem,) = error.value.problems
    assert problem.key.startswith("eccentric.load") and words in problem.text()
