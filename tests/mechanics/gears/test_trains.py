"""Trains: Willis in every mesh, closed forms of the textbooks, power balance, errors."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tmm_report.mechanics.gears.trains import Member, Mesh, Train, loads, speeds
from tmm_report.problems import ProblemError

TEETH = st.integers(12, 60)


def sun_ring(z1: int, z2: int, eta: float = 1.0) -> Train:
    """Sun 1, satellite 2, ring 3, carrier H; η_H = eta."""
    root = eta**0.5
    members = (
        Member("1", "wheel", z1),
        Member("2", "satellite", z2, carried_by="H"),
        Member("3", "ring", z1 + 2 * z2),
        Member("H", "carrier"),
    )
    return Train(members, (Mesh("1", "2", "H", False, root), Mesh("2", "3", "H", True, root)))


def double(z: tuple[int, int, int, int], eta: float = 1.0) -> Train:
    """Suns 1 and 3, satellites 2 and 2' on one shaft."""
    root = eta**0.5
    members = (
        Member("1", "wheel", z[0]),
        Member("2", "satellite", z[1], carried_by="H", shaft="2"),
        Member("2'", "satellite", z[2], carried_by="H", shaft="2"),
        Member("3", "wheel", z[3]),
        Member("H", "carrier"),
    )
    return Train(members, (Mesh("1", "2", "H", False, root), Mesh("2'", "3", "H", False, root)))


def miss(train: Train, speed: dict[str, float]) -> float:
    """The largest |z_i (ω_i − ω_c) ± z_j (ω_j − ω_c)|, computed apart from the solver's matrix."""
    found = [0.0]
    for mesh in train.meshes:
        carried = speed[mesh.carrier] if mesh.carrier else 0.0
        one = train.by_name[mesh.i].teeth * (speed[mesh.i] - carried)
        other = train.by_name[mesh.j].teeth * (speed[mesh.j] - carried)
        found.append(abs(one - other if mesh.internal else one + other))
    return max(found)


@given(TEETH, TEETH, st.floats(-300, 300), st.floats(-300, 300), st.sampled_from(["13", "1H", "3H"]))
def test_willis_holds_for_any_two_given_speeds(z1, z2, one, other, which):
    train = sun_ring(z1, z2)
    speed = speeds(train, dict(zip(which, (one, other), strict=True)))
    assert miss(train, speed) < 1e-8 * (1 + abs(one) + abs(other)) * 100
    assert [speed[name] for name in which] == [one, other]


@given(TEETH, TEETH)
def test_the_ratios_of_the_textbooks(z1, z2):
    train, z3 = sun_ring(z1, z2), z1 + 2 * z2
    assert 1 / speeds(train, {"1": 1.0, "3": 0.0})["H"] == pytest.approx(1 + z3 / z1, rel=1e-12)
    assert 1 / speeds(train, {"3": 1.0, "1": 0.0})["H"] == pytest.approx(1 + z1 / z3, rel=1e-12)
    assert 1 / speeds(train, {"1": 1.0, "H": 0.0})["3"] == pytest.approx(-z3 / z1, rel=1e-12)


def test_ferguson_s_ratio_of_ten_thousand():
    assert speeds(double((100, 101, 100, 99)), {"H": 1.0, "3": 0.0})["1"] == pytest.approx(1e-4, rel=1e-9)


def test_an_ordinary_train_of_pairs_and_an_idler():
    members = tuple(Member(name, "wheel", z) for name, z in zip("1234", (20, 40, 30, 60), strict=True))
    train = Train(members, (Mesh("1", "2"), Mesh("2", "3"), Mesh("3", "4")))
    assert speeds(train, {"1": 6.0})["4"] == pytest.approx(-2.0)  # the idlers only turn the sense


def test_arrays_equal_a_loop_of_singles():
    train = sun_ring(20, 46, 0.96)
    one, ring = np.linspace(-50, 80, 7)[:, None], np.array([0.0, 3.0, -9.0])
    speed = speeds(train, {"1": one, "3": ring})
    load = loads(train, speed, {"1": np.array(2.0)}, ("3", "H"))
    for place in np.ndindex(7, 3):
        single = speeds(train, {"1": float(one[place[0], 0]), "3": float(ring[place[1]])})
        assert all(speed[name][place] == pytest.approx(single[name], abs=1e-12) for name in single)
        alone = loads(train, single, {"1": 2.0}, ("3", "H"))
        for name in alone.torque:
            assert load.torque[name][place] == pytest.approx(float(alone.torque[name]), abs=1e-12)


@pytest.mark.parametrize(
    ("known", "text"),
    [
        ({"1": 1.0}, "the speeds of the members 2, 3, H are not determined"),
        ({"1": 1.0, "3": 0.0, "H": 5.0}, "3 given speeds contradict one another"),
    ],
)
def test_too_few_and_too_many_speeds_are_told(known, text):
    with pytest.raises(ProblemError) as raised:
        speeds(sun_ring(20, 46), known, ("drive", "stages", 0))
    (problem,) = raised.value.problems
    assert text in problem.text() and "degrees of freedom: 2" in problem.text()
    assert problem.path == ("drive", "stages", 0)


def test_members_of_one_shaft_with_two_speeds_are_told():
    with pytest.raises(ProblemError, match="contradict"):
        speeds(double((20, 40, 20, 40)), {"2": 1.0, "2'": 2.0, "H": 0.0})


def test_redundant_but_agreeing_speeds_are_accepted():
    train = sun_ring(20, 46)
    speed = speeds(train, {"1": 6.6, "3": 0.0})
    assert speeds(train, {"1": 6.6, "3": 0.0, "H": float(speed["H"])})["2"] == pytest.approx(speed["2"])


def test_a_mesh_of_unknown_wheels_is_a_bug():
    with pytest.raises(ValueError, match="two wheels with teeth"):
        Train((Member("1", "wheel", 20), Member("H", "carrier")), (Mesh("1", "H"),))


# --- torques and powers


@given(TEETH, TEETH, st.floats(0.9, 1.0), st.sampled_from(["13H", "1H3", "31H", "3H1", "H13", "H31"]))
def test_power_balance_and_equilibrium_in_all_kinematic_cases(z1, z2, eta, case):
    train = sun_ring(z1, z2, eta)
    into, out, held = case
    speed = speeds(train, {into: 100.0, held: 0.0})
    load = loads(train, speed, {into: 1.0}, (out, held))
    assert load.settled
    assert abs(load.imbalance) < 1e-9 * load.supplied
    assert abs(sum(float(torque) for torque in load.torque.values())) < 1e-9 * (1 + z2)
    assert all(loss >= -1e-12 for loss in load.loss)
    assert 0 < load.efficiency <= 1 + 1e-12 and not load.locks(out)


@given(TEETH, TEETH, st.floats(0.9, 0.999))
def test_efficiency_of_the_single_row_by_its_closed_forms(z1, z2, eta):
    """Kudryavtsev: sun to carrier (1 − u η)/(1 − u), carrier to sun (1 − u)/(1 − u/η), u = −z3/z1."""
    train, u = sun_ring(z1, z2, eta), -(z1 + 2 * z2) / z1
    forward = loads(train, speeds(train, {"1": 9.0, "3": 0.0}), {"1": 1.0}, ("3", "H"))
    assert forward.efficiency == pytest.approx((1 - u * eta) / (1 - u), rel=1e-12)
    back = loads(train, speeds(train, {"H": 9.0, "3": 0.0}), {"H": 1.0}, ("3", "1"))
    assert back.efficiency == pytest.approx((1 - u) / (1 - u / eta), rel=1e-12)


def test_a_large_reduction_locks_itself_when_driven_from_the_wheel():
    train = double((100, 101, 100, 99), 0.96)
    slow = loads(train, speeds(train, {"H": 100.0, "3": 0.0}), {"H": 1.0}, ("1", "3"))
    assert slow.efficiency < 0.01 and not slow.locks("1")
    fast = loads(train, speeds(train, {"1": 1.0, "3": 0.0}), {"1": 1.0}, ("H", "3"))
    assert fast.locks("H") and fast.efficiency == 0.0


@given(st.floats(-80, 80), st.floats(0.9, 0.999), st.sampled_from([1.0, -1.0]))
def test_each_driven_wheel_receives_the_efficiency_s_part(ring, eta, torque):
    train = sun_ring(20, 46, eta)
    speed = speeds(train, {"1": 50.0, "3": ring})
    load = loads(train, speed, {"1": torque}, ("3", "H"))
    assert load.settled and abs(load.imbalance) < 1e-9 * (load.supplied + sum(load.loss))
    for mesh, power, loss in zip(train.meshes, load.mesh_power, load.loss, strict=True):
        given_power = power if power > 0 else -power / mesh.efficiency
        assert loss == pytest.approx((1 - mesh.efficiency) * given_power, rel=1e-9, abs=1e-9)


def test_a_closed_train_circulates_power_and_balances():
    """A differential whose ring and carrier are closed by the idler 6 between wheels 5 and 7."""
    base = sun_ring(20, 40, 0.96)
    sun, satellite, ring, carrier = base.members
    closing = (
        Member("5", "wheel", 45, shaft="H"),
        Member("6", "wheel", 30),
        Member("7", "wheel", 80, shaft="3"),
    )
    pairs = (Mesh("5", "6", efficiency=0.98), Mesh("6", "7", efficiency=0.98))
    train = Train((sun, satellite, ring, carrier, *closing), (*base.meshes, *pairs))
    speed = speeds(train, {"1": 10.0})
    assert train.freedom == 1 and miss(train, speed) < 1e-9
    # ω3 = ωH z5/z7 through the idler, so ω1 = (1 − u) ωH + u ω3 with u = −5
    assert speed["1"] / speed["H"] == pytest.approx(6 - 5 * 45 / 80)
    load = loads(train, speed, {"1": 1.0}, ("H",))
    assert load.settled and abs(load.imbalance) < 1e-9
    assert load.mesh_power[2] * load.mesh_power[3] > 0  # the power goes on through the idler
    assert 0.9 < load.efficiency < 0.96


def test_a_repeated_connection_leaves_the_torques_undetermined():
    members = tuple(Member(str(k), "wheel", 20, shaft="a" if k in (1, 3) else "b") for k in range(1, 5))
    train = Train(members, (Mesh("1", "2"), Mesh("3", "4")))
    speed = speeds(train, {"1": 1.0})
    with pytest.raises(ProblemError, match="not determined by equilibrium"):
        loads(train, speed, {"1": 1.0}, ("2",))
