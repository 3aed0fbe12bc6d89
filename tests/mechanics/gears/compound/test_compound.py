"""Compound trains drawn at random: rows against a linear system of pitch points, powers, conditions, the search."""

import cmath
import itertools
import math
from fractions import Fraction

import numpy as np
import pytest
from conftest import examples
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from tmm_report.mechanics.gears.compound import conditions, search
from tmm_report.mechanics.gears.compound.conditions import Coaxial
from tmm_report.mechanics.gears.compound.powers import backwards, flow, locked, without_losses
from tmm_report.mechanics.gears.compound.rows import by_steps, order, row_ratio, rows_of, weighted
from tmm_report.mechanics.gears.trains import Member, Mesh, Train, speeds

Z = st.integers(12, 60)
ETA = st.floats(0.9, 0.999)


def wheel(name: str, z: int, carried: str = "", shaft: str = "") -> Member:
    return Member(name, "wheel", z, carried_by=carried, shaft=shaft or name)


def carrier(name: str = "H", shaft: str = "") -> Member:
    return Member(name, "carrier", shaft=shaft or name)


def mesh(text: str, eta: float, on: str = "") -> Mesh:
    i, j = text.strip("*").split("-")
    return Mesh(i, j, on, text.endswith("*"), eta)


def closed(z, eta) -> tuple[Train, str, str, list[str]]:
    """1-2-3-H closed by 3'-4-5, idlers 4, 5 with H."""
    a, g, c, d, _ = z
    members = (
        wheel("1", a), wheel("2", g, "H"), wheel("3", a + 2 * g, shaft="3"), wheel("3'", c, shaft="3"), wheel("4", d),
        wheel("5", c + 2 * d, shaft="H"), carrier(),
    )  # fmt: skip
    meshes = (mesh("1-2", eta, "H"), mesh("2-3*", eta, "H"), mesh("3'-4", eta), mesh("4-5*", eta))
    return Train(members, meshes), "1", "H", []


def three_k(z, eta):
    """a-g-b, f-e; b held."""
    a, g, f, _, _ = z
    if f == g:
        assume(False)
    members = (
        wheel("a", a), wheel("g", g, "H", "g"), wheel("f", f, "H", "g"), wheel("b", a + 2 * g), wheel("e", a + g + f),
        carrier(),
    )  # fmt: skip
    meshes = (mesh("a-g", eta, "H"), mesh("g-b*", eta, "H"), mesh("f-e*", eta, "H"))
    return Train(members, meshes), "a", "e", ["b"]


def two_rows(z, eta):
    """Planetary rows one after another: carrier H1 with sun 4, both rings held."""
    a, g, c, d, _ = z
    members = (
        wheel("1", a), wheel("2", g, "H1"), wheel("3", a + 2 * g), carrier("H1", "H1"), wheel("4", c, shaft="H1"),
        wheel("5", d, "H2"), wheel("6", c + 2 * d), carrier("H2"),
    )  # fmt: skip
    meshes = (
        mesh("1-2", eta, "H1"),
        mesh("2-3*", eta, "H1"),
        mesh("4-5", eta, "H2"),
        mesh("5-6*", eta, "H2"),
    )
    return Train(members, meshes), "1", "H2", ["3", "6"]


def ordinary(z, eta):
    """An idler, then a double gear, then a ring."""
    members = tuple(wheel(name, z[k]) for k, name in enumerate("123"))
    members += (wheel("3'", z[3], shaft="3"), wheel("4", z[3] + z[4]))
    return Train(members, (mesh("1-2", eta), mesh("2-3", eta), mesh("3'-4*", eta))), "1", "4", []


def chain(z, eta):
    """Two satellites in mesh between sun and ring, the ring held."""
    members = (
        wheel("1", z[0]),
        wheel("2", z[1], "H"),
        wheel("3", z[2], "H"),
        wheel("4", z[0] + z[1] + 2 * z[2]),
        carrier(),
    )
    return (
        Train(members, (mesh("1-2", eta, "H"), mesh("2-3", eta, "H"), mesh("3-4*", eta, "H"))),
        "1",
        "H",
        ["4"],
    )


def suns(z, eta):
    """Two suns and a double satellite, one sun held, the carrier drives."""
    if z[0] * z[2] == z[1] * z[3]:
        assume(False)
    members = (
        wheel("A", z[0]),
        wheel("B", z[1], "E", "B"),
        wheel("C", z[2], "E", "B"),
        wheel("D", z[3]),
        carrier("E"),
    )
    return Train(members, (mesh("A-B", eta, "E"), mesh("C-D", eta, "E"))), "E", "D", ["A"]


KINDS = [closed, three_k, two_rows, ordinary, chain, suns]


@st.composite
def trains(draw, kinds=tuple(KINDS)):
    return draw(st.sampled_from(kinds))(draw(st.tuples(Z, Z, Z, Z, Z)), draw(ETA))


def ratio_of(train: Train, one: str, other: str, held: list[str]) -> float:
    rows = rows_of(train, [one, other, *held], held)
    still = {train.by_name[name].body for name in held}
    end, start = (train.by_name[name].body for name in (other, one))
    steps = order(rows, {end, *still})
    assert steps is not None
    found = by_steps(steps, {end: 1.0}, lambda row: row_ratio(train, row), still, end)
    return found[start]


def by_pitch_points(train: Train, one: str, held: list[str]) -> dict[str, float]:
    """Speeds for 1 of the input from v = v_axis + ω r at the pitch points, each wheel with an unknown of its own.

    A wheel has radius z; an axis is carried at the radius at which its first mesh puts it."""
    names = [m.name for m in train.members]
    place = {name: k for k, name in enumerate(names)}
    rows, right = [], []

    def equation(terms: dict[str, float], value: float = 0.0) -> None:
        row = np.zeros(len(names))
        for name, factor in terms.items():
            row[place[name]] += factor
        rows.append(row)
        right.append(value)

    for m in train.members:
        first = next(o.name for o in train.members if o.body == m.body)
        if first != m.name:
            equation({m.name: 1.0, first: -1.0})
    for link in train.meshes:
        z_i, z_j = (train.by_name[name].teeth for name in (link.i, link.j))
        # both axes and the pitch point on one line: i at 0, j beside it at ±(z_i ± z_j), the point at z_i
        apart = z_i - z_j if link.internal else z_i + z_j
        terms = {link.i: float(z_i), link.j: float(apart - z_i)}
        if link.carrier:  # j's axis goes round i's with the carrier
            terms[link.carrier] = terms.get(link.carrier, 0.0) - apart
        equation(terms)
    for name in held:
        equation({name: 1.0})
    equation({one: 1.0}, 1.0)
    found, _, rank, _ = np.linalg.lstsq(np.array(rows), np.array(right), rcond=None)
    assert rank == len(names)
    return dict(zip(names, found, strict=True))


@given(trains())
@settings(max_examples=examples(60))
def test_rows_pitch_points_and_willis_matrix_agree(made):
    train, one, other, held = made
    points = by_pitch_points(train, one, held)
    assume(abs(points[other]) > 1e-3)
    matrix = speeds(train, {one: 1.0} | dict.fromkeys(held, 0.0))
    assert {name: float(v) for name, v in matrix.items()} == pytest.approx(points, rel=1e-7, abs=1e-7)
    assert ratio_of(train, one, other, held) == pytest.approx(1 / points[other], rel=1e-6)


def solved(made, torque: float = 1.0):
    train, one, other, held = made
    speed = {name: float(v) for name, v in speeds(train, {one: 1.0} | dict.fromkeys(held, 0.0)).items()}
    assume(abs(speed[other]) > 1e-3)
    return speed, flow(train, speed, {one: torque}, (*held, other))


@given(trains())
@settings(max_examples=examples(60))
def test_every_link_is_balanced_and_kreines_gives_the_efficiency(made):
    train, one, other, held = made
    speed, found = solved(made)
    assume(bool(found.loads.settled))
    scale = max(abs(t) for t in found.member.values())
    for body in train.bodies:
        assert abs(found.imbalance(body)) < 1e-9 * scale
    outside = sum(float(p) for p in found.loads.power.values())
    inside = sum(found.power(name) for name in train.by_name)
    assert outside == pytest.approx(found.lost, abs=1e-9 * scale)
    assert inside == pytest.approx(-found.lost, abs=1e-9 * scale)
    assert found.lost >= -1e-12
    rows = rows_of(train, [one, other, *held], held)
    still, end = {train.by_name[name].body for name in held}, train.by_name[other].body
    eta = [m.efficiency for m in train.meshes]
    steps = order(rows, {end, *still})
    lossy = by_steps(steps, {end: 1.0}, lambda row: weighted(train, row, found.way, eta), still, end)
    whole = float(-found.loads.torque[other] / found.loads.torque[one])
    assert lossy[train.by_name[one].body] == pytest.approx(whole, rel=1e-6)
    if not found.loads.locks(other):
        assert float(found.loads.efficiency) == pytest.approx(whole * speed[other], rel=1e-7)
        assert float(found.loads.efficiency) < 1


@given(trains())
@settings(max_examples=examples(30))
def test_without_losses_the_torques_are_as_the_speeds(made):
    train, one, other, held = made
    speed, found = solved((without_losses(train), one, other, held))
    assert float(found.loads.torque[other]) == pytest.approx(-1 / speed[other], rel=1e-6)
    assert found.lost == pytest.approx(0.0, abs=1e-9)
    powers = found.branches(train.by_name[other].body)
    assert sum(powers.values()) == pytest.approx(1.0 if powers else 0.0, abs=1e-6)


def test_driven_from_its_output_a_train_has_another_efficiency_or_none():
    train, one, other, held = three_k((18, 36, 33, 0, 0), 0.98)
    speed = {name: float(v) for name, v in speeds(train, {one: 1.0, "b": 0.0}).items()}
    found = backwards(train, speed, other, (*held, one))
    there = flow(train, speed, {other: math.copysign(1, speed[other])}, (*held, one))
    assert found == pytest.approx(1 - there.lost / there.supplied)
    poor, *_ = three_k((18, 36, 35, 0, 0), 0.9)
    turned = {name: float(v) for name, v in speeds(poor, {one: 1.0, "b": 0.0}).items()}
    assert backwards(poor, turned, other, (*held, one)) <= 0


def test_power_circulates_where_a_branch_brings_it_back():
    """A ring before the carrier: 3' drives 5 without an idler, in the same sense."""
    members = (
        wheel("1", 20), wheel("2", 30, "H"), wheel("3", 80, shaft="3"), wheel("3'", 30, shaft="3"),
        wheel("4", 20, shaft="4"),
        wheel("4'", 19, shaft="4"), wheel("5", 31, shaft="H"), carrier(),
    )  # fmt: skip
    meshes = (mesh("1-2", 1.0, "H"), mesh("2-3*", 1.0, "H"), mesh("3'-4", 1.0), mesh("4'-5", 1.0))
    train = Train(members, meshes)
    speed = {name: float(v) for name, v in speeds(train, {"1": 1.0}).items()}
    found = flow(train, speed, {"1": 1.0}, ("H",))
    shares = found.branches("H")
    assert sum(shares.values()) == pytest.approx(1.0)
    assert min(shares.values()) < 0
    assert found.circulating("H") == pytest.approx(-min(shares.values()))
    assert max(shares.values()) > 1


@given(st.integers(10, 30), st.floats(1.0, 8.0), st.floats(-0.9, 0.9))
@settings(max_examples=examples(30))
def test_a_locking_factor_divides_the_torque_of_the_case(z, factor, turn):
    """The slower output has as many times the torque of the faster one; half their difference turns in vain."""
    assume(abs(turn) > 0.01)
    members = (wheel("l", z), wheel("s", 12, "H"), wheel("r", z), carrier())
    train = Train(members, (Mesh("l", "s", "H"), Mesh("s", "r", "H", True)))
    (row,) = rows_of(train, ["l", "r", "H"])
    speed = {name: float(v) for name, v in speeds(train, {"l": 1 + turn, "r": 1 - turn}).items()}
    found = flow(locked(train, row, factor), speed, {"H": 100.0}, ("l", "r"))
    slow, fast = ("r", "l") if turn > 0 else ("l", "r")
    assert float(found.loads.torque[slow] / found.loads.torque[fast]) == pytest.approx(factor)
    apart = abs(float(found.loads.torque["l"] - found.loads.torque["r"]))
    assert found.lost == pytest.approx(apart * abs(turn), rel=1e-9)


# --- conditions


def fits(teeth: list[tuple[int, int]], internal: list[bool], k: int) -> bool:
    """Whether a copy of the chain, turned by 1/k of a turn, fits the wheels: every way of turning its satellites by
    whole pitches is tried. `teeth`: of the driving and the driven wheel of each mesh."""
    turn = Fraction(1, k)
    (z_a, _), *_ = teeth
    reached = {-turn + Fraction(i, z_a) for i in range(z_a)}
    for (z_i, z_j), inside in zip(teeth, internal, strict=True):
        ratio = Fraction(z_i, z_j) * (1 if inside else -1)
        reached = {(angle * ratio + Fraction(n, z_j)) % 1 for angle in reached for n in range(z_j)}
    last = teeth[-1][1]
    return any(((angle + turn) * last).denominator == 1 for angle in reached)


@given(st.sampled_from([three_k, chain, suns]), st.tuples(*[st.integers(5, 14)] * 5), st.integers(2, 5))
@settings(max_examples=examples(40))
def test_assembly_is_that_of_every_way_to_put_the_satellites_in(kind, z, k):
    train, one, other, held = kind(z, 1.0)
    teeth = {m.name: m.teeth for m in train.members if m.teeth}
    for row in conditions.groups_of(train, rows_of(train, [one, other, *held], held)):
        pairs = [(teeth[link.i], teeth[link.j]) for link in row.links]
        inside = [train.meshes[link.mesh].internal for link in row.links]
        number = float(conditions.assembly_number(train, row, teeth, k))
        assert (abs(number - round(number)) < 1e-9) == fits(pairs, inside, k)


@pytest.mark.parametrize(("kind", "wanted"), [(chain, (20 + 21 + 2 * 22) - 20), (three_k, 20 + 20 + 2 * 21)])
def test_of_single_crowns_it_is_the_sum_or_the_difference_of_the_central_wheels(kind, wanted):
    """Both turn against the stopped carrier in one sense: their difference, else their sum."""
    train, one, other, held = kind((20, 21, 22, 0, 0), 1.0)
    teeth = {m.name: m.teeth for m in train.members if m.teeth}
    row = next(row for row in rows_of(train, [one, other, *held], held) if one in (row.a, row.b))
    assert float(conditions.assembly_number(train, row, teeth, 4)) == pytest.approx(wanted / 4)


def test_of_three_central_wheels_every_two_are_judged():
    train, one, other, held = three_k((18, 36, 33, 0, 0), 1.0)
    rows = rows_of(train, [one, other, *held], held)
    ends = {frozenset((row.a, row.b)) for row in conditions.groups_of(train, rows)}
    assert ends == {frozenset("ab"), frozenset("be"), frozenset("ae")}


@given(Z, Z, st.integers(2, 6), st.floats(1, 9))
def test_the_gap_is_that_between_drawn_circles(a, g, k, module):
    train, *_ = three_k((a, g, g + 1, 0, 0), 1.0)
    (crowd,) = conditions.crowds(train, [True] * 3)
    teeth = {m.name: m.teeth for m in train.members if m.teeth}
    found = float(conditions.gap(train, crowd, teeth, dict.fromkeys(teeth, module), k))
    centres = [cmath.rect(module * (a + g) / 2, 2 * math.pi * j / k) for j in range(2)]
    tip = module * (g + 1 + 2) / 2
    assert found == pytest.approx(abs(centres[0] - centres[1]) - 2 * tip, abs=1e-9)


def test_meshes_between_the_same_axes_are_coaxial():
    train, *_ = closed((18, 36, 21, 30, 0), 1.0)
    assert conditions.coaxial_pairs(train, [True] * 4) == (Coaxial(0, 1), Coaxial(2, 3))
    alone, *_ = chain((18, 20, 20, 0, 0), 1.0)
    assert conditions.coaxial_pairs(alone, [True] * 3) == ()  # a chain bends


@given(st.integers(10, 60), st.integers(1, 150))
def test_the_least_ring_is_where_its_tips_clear_the_line_of_action(z, more):
    assert bool(z + more >= conditions.least_ring(z) - 1e-9) == ring_free(z, z + more)


# --- the search


def task(kind, ranges, ratio, tolerance, shifted=0, satellites=(3, 4)):
    train, one, other, held = kind((20, 30, 25, 26, 0), 1.0)
    rows = rows_of(train, [one, other, *held], held)
    still = tuple(train.by_name[name].body for name in held)
    start, end = (train.by_name[name].body for name in (one, other))
    steps = order(rows, {end, *still})
    names = [m.name for m in train.members if m.teeth]
    return search.Task(
        train, rows, steps, still, start, end, ratio, tolerance, {name: ranges[name] for name in names}, satellites,
        shifted, dict.fromkeys(names, 1.0), (True,) * len(train.meshes),
    )  # fmt: skip


def tips_apart(distance: int, tips: int, k: int) -> bool:
    return 2 * distance * math.sin(math.pi / k) - (tips + 2) > 1e-12


def ring_free(g: int, b: int) -> bool:
    """The ring's tip beyond the end of the line of action, by its radii."""
    angle = math.radians(20)
    tip, base = (b - 2) / 2, b * math.cos(angle) / 2
    return b > g and tip > base and math.sqrt(tip**2 - base**2) >= (b - g) / 2 * math.sin(angle) - 1e-9


def test_3k_against_brute_force():
    """Every set of the ranges by loops over whole numbers: the same solutions, the same count."""
    ranges = {"a": (15, 22), "g": (18, 27), "f": (15, 24), "b": (40, 90), "e": (40, 90)}
    found = search.search(task(three_k, ranges, 60.0, 0.05), most=10**6)
    wanted, tried = set(), 0
    for a, g, f in itertools.product(*(range(ranges[n][0], ranges[n][1] + 1) for n in "agf")):
        b, e = a + 2 * g, a + g + f
        tried += 1
        if not (40 <= b <= 90 and 40 <= e <= 90) or b * f == g * e:
            continue
        u = (1 + Fraction(b, a)) / (1 - Fraction(b * f, g * e))
        if abs(u / 60 - 1) > Fraction(5, 100) or not (ring_free(g, b) and ring_free(f, e)):
            continue
        for k in (3, 4):
            put = (
                fits([(a, g), (g, b)], [False, True], k)
                and fits([(b, g), (f, e)], [True, True], k)
                and fits([(a, g), (f, e)], [False, True], k)
            )
            if put and tips_apart(a + g, max(f, g), k):
                wanted.add((a, g, f, b, e, k))
    assert wanted
    assert {(*map(int, z), int(k)) for z, k in zip(found.teeth.T, found.satellites, strict=True)} == wanted
    once = sum(n for reason, n in found.counts.items() if 0 < reason < search.Reason.ASSEMBLY)
    twice = sum(n for reason, n in found.counts.items() if not 0 < reason < search.Reason.ASSEMBLY)
    assert once + twice / 2 == tried == search.extent(task(three_k, ranges, 60.0, 0.05))


def test_closed_against_brute_force():
    ranges = {"1": (16, 20), "2": (26, 31), "3": (70, 90), "3'": (17, 20), "4": (24, 28), "5": (60, 90)}
    found = search.search(task(closed, ranges, 22.0, 0.02), most=10**6)
    wanted = set()
    for a, g, c, d in itertools.product(
        *(range(ranges[n][0], ranges[n][1] + 1) for n in ("1", "2", "3'", "4"))
    ):
        b, e = a + 2 * g, c + 2 * d
        u = 1 + Fraction(b, a) + Fraction(b * e, a * c)
        if not (70 <= b <= 90 and 60 <= e <= 90) or abs(u / 22 - 1) > Fraction(2, 100):
            continue
        if ring_free(g, b) and ring_free(d, e):
            wanted |= {(a, g, b, c, d, e, k) for k in (3, 4) if (a + b) % k == 0 and tips_apart(a + g, g, k)}
    assert wanted
    assert {(*map(int, z), int(k)) for z, k in zip(found.teeth.T, found.satellites, strict=True)} == wanted


def test_shift_lets_rings_of_other_teeth_share_one_satellite():
    """a, b and e on one crown: without shift b and e would be equal, and nothing would turn."""

    def single(z, eta):
        members = (
            wheel("a", z[0]),
            wheel("g", z[1], "H"),
            wheel("b", z[0] + 2 * z[1]),
            wheel("e", z[0] + 2 * z[1] + 1),
            carrier(),
        )
        return (
            Train(members, (mesh("a-g", eta, "H"), mesh("g-b*", eta, "H"), mesh("g-e*", eta, "H"))),
            "a",
            "e",
            ["b"],
        )

    ranges = {"a": (15, 20), "g": (17, 24), "b": (40, 80), "e": (40, 80)}
    found = search.search(task(single, ranges, 80.0, 0.05, shifted=2, satellites=(3,)), most=10**6)
    wanted = set()
    for a, g, b, e in itertools.product(*(range(ranges[n][0], ranges[n][1] + 1) for n in "agbe")):
        if max(abs(b - a - 2 * g), abs(e - a - 2 * g)) > 2 or b == e or min(b, e) <= g:
            continue
        u = (1 + Fraction(b, a)) / (1 - Fraction(b, e))
        if abs(u / 80 - 1) <= Fraction(5, 100) and (a + b) % 3 == (a + e) % 3 == 0 and (b - e) % 3 == 0:
            wanted |= {(a, g, b, e)} if tips_apart(a + g, g, 3) else set()
    assert wanted
    assert {tuple(map(int, z)) for z in found.teeth.T} == wanted
    sizes = list(found.size)
    assert sizes == sorted(sizes)  # the smallest first
