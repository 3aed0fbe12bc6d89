"""Every formula of a compound train against the equations of all its meshes together, and the balance of power."""

import pytest
from conftest import solved
from test_train import AXLE, AXLE_WITH_LOOP, CHAIN, SCHEMES, THREE_SETS, found
from twice import disagreements

from tmm_report.chapters.gears.train.steps import whole
from tmm_report.mechanics.gears.trains import loads, speeds

LOSSES = {"external": 0.98, "internal": 0.99, "bevel": 0.97}
ROPE = {"drum": "400 mm", "force": "9 kN"}


def ways(of):
    """Numbers of the whole train, W and N·m: speeds by Willis' equations of the meshes, torques by the equilibrium of
    every member."""
    train = of.flow.train
    held = {name: of.speed[name] for name in (of.input, *of.still)}
    speed = speeds(train, held, ("train",)) if of.single else of.speed
    one, other = (float(speed[name]) for name in (of.input, of.output))
    torque, power = of.flow.loads.torque, of.flow.loads.power
    found_again = {"u": one / other} if other else {}
    if of.single:
        ends = (*sorted(of.still), of.output)
        again = loads(train, speed, {of.input: float(torque[of.input])}, ends, ("train",))
        first, last = float(again.torque[of.input]), float(again.torque[of.output])
        found_again |= {
            "u_loss": -last / first,
            "T_in": first,
            "T_out": last,
            "P_in": first * one,
            "P_out": -last * other,
            "eta": -last * other / (first * one),
        }
    else:
        given = sum(float(one) for one in power.values() if one > 0)
        found_again |= {"eta": -sum(float(one) for one in power.values() if one < 0) / given}
    if of.given.rope is not None:
        found_again["v"] = abs(other) * of.given.rope.drum / 2
    if of.given.find is not None:
        found_again["delta_u"] = 100 * (one / other / of.given.find.ratio - 1)
    if of.plans is not None:
        found_again["h"] = of.plans.pole
    return found_again


def told(of):
    made = whole(of)
    wrong = disagreements(made.s, ways(of))
    for name, row in made.members.items():
        about = of.train.by_name[name].carried_by
        relative = of.speed[name] - of.speed[about] if about else None
        wrong += disagreements(row, {"omega": of.speed[name], "omega_rel": relative})
    return wrong


@pytest.mark.parametrize("rope", [None, ROPE], ids=["no load", "a rope"])
@pytest.mark.parametrize("name", [name for name in SCHEMES if name != "two inputs"])
def test_every_formula_of_a_train_with_one_output(name, rope):
    assert told(found(SCHEMES[name], efficiency=LOSSES, rope=rope)) == []


OTHERS = {"axle": AXLE, "chain": CHAIN, "two inputs": SCHEMES["two inputs"], "three sets": THREE_SETS}
OTHERS["axle with a loop"] = AXLE_WITH_LOOP


@pytest.mark.parametrize("stated", OTHERS.values(), ids=list(OTHERS))
def test_every_formula_of_other_trains(stated):
    assert told(found(stated, efficiency=LOSSES)) == []


def test_every_formula_of_the_ready_variant():
    assert told(solved("hoist_differential").train) == []
