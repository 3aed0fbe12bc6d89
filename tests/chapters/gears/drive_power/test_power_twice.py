"""Every formula of a drive from its machine back to the motor against a walk that shares none of its expressions."""

import math

import pytest
from test_drive_power import DRUM, MOTORS, OPEN, PAIR, PLANETARY, solve
from test_drive_twice import LINKED
from twice import disagreements

from tmm_report import course, loading
from tmm_report.chapters.gears.drive.steps import whole

RPM = 30 / math.pi
LOSSES = {"bearings": 0.99, "coupling": {"efficiency": 0.98, "after": [0, 2]}}
TWO = OPEN | {"teeth": [22, "rest"]}

DRIVES = {
    "conveyor": ([OPEN, PAIR, TWO], {"output": DRUM, "motors": MOTORS, "ratio_range": [25, 30], **LOSSES}),
    "by the root": ([OPEN, TWO], {"output": DRUM, "motors": MOTORS, "split": {"slow": 0.9}, **LOSSES}),
    "fast": ([OPEN, TWO], {"output": DRUM, "motors": [MOTORS[3]], "split": {"fast": 1.1}}),
    "in progression": ([OPEN, OPEN, TWO], {"output": DRUM, "motors": [MOTORS[1]], "split": {"step": 1.1}}),
    "one stage, driven wheel stated": (
        [OPEN | {"teeth": ["rest", 90]}], {"output": {"torque": 500, "speed": "300 rpm"}, "motors": [MOTORS[3]]},
    ),
    "power, planetary": ([PLANETARY, PAIR], {"output": {"power": "3 kW", "speed": "71 rpm"}, "speed": "1410 rpm"}),
    "sprocket": (
        [PAIR], {"output": {"force": 4e3, "speed": "0.5 m/s", "teeth": 9, "pitch": "80 mm", "efficiency": 0.9},
                 "motors": [["m", "4 kW", "128 rpm"]], "shafts": {"at": "before bearings"}, **{"bearings": 0.98}},
    ),
    "what a motor allows": ([PAIR], {"output": {"diameter": "0.4 m"}, "motors": [MOTORS[4]], "bearings": 0.99}),
    "rated": (
        [PAIR], {"output": DRUM, "motors": [["m", "4 kW", "154 rpm"]], "shafts": {"by": "rated", "torque": 9550}},
    ),
    "rope": ([PAIR], {"output": {"force": "9 kN", "diameter": "0.4 m"}, "speed": "144 rpm"}),
}  # fmt: skip


@pytest.mark.parametrize("name", DRIVES)
def test_every_formula_agrees_with_the_second_way(name):
    stages, more = DRIVES[name]
    assert told(solve(*stages, **more)) == []


def told(found):
    made = whole(found, "drive")
    steps = made.power
    wrong = disagreements(steps.s, singles(found))
    for k, row in enumerate(steps.shafts):
        wrong += disagreements(row, shaft(found, k))
    for name, row in steps.sought.items():
        wrong += disagreements(row, {"z_exact": exact(found, name)})
    for row, stage in zip(made.stages, found.stages, strict=True):
        wrong += disagreements(row, {"u_required": stage.wanted})
    return wrong


def singles(found):
    """By energy, and by the speeds of the train; in the units of the results."""
    shafts = found.power
    machine, plan = shafts.given.machine, shafts.plan
    radius, last = machine and machine.radius, abs(found.speed[found.output])
    eta = 1.0
    for stage in found.stages:
        eta *= stage.efficiency
    eta *= shafts.given.bearings.efficiency ** sum(plan.pairs)
    for link in plan.links:
        eta *= link.efficiency if link.kind == "coupling" else 1.0
    eta *= machine.efficiency if machine else 1.0
    ways = {"eta_total": eta}
    omega = plan.need.omega
    if omega is not None:
        ways |= {"omega_out": omega, "n_out": omega * RPM, "u_total": plan.speed / omega}
        assert plan.need.wanted or omega == pytest.approx(last, rel=1e-12)
        ways["delta_n"] = 100 * (last - omega) / omega
        stated = [abs(stage.wanted) for k, stage in enumerate(found.stages) if k not in (plan.shares or ())]
        ways["u_rest"] = plan.speed / omega / math.prod(stated)
    if machine and machine.force:
        ways["T_out"] = machine.force * radius
        ways["P_out"] = machine.force * radius * omega
    elif machine and machine.torque:
        ways["P_out"] = machine.torque * omega
    elif machine and machine.power:
        ways["T_out"] = machine.power / omega
    if found.moments is not None:
        ways["P_out"] = found.moments.mean * plan.need.power / found.moments.mean
    if plan.required is not None:
        ways["P_req"] = plan.need.power / eta
    if radius:
        ways["v_actual"] = radius * last
    if shafts.motor:
        own = shafts.motor.power
        ways |= {"P_allowed": own * eta, "T_allowed": own * eta / last}
        if plan.required is not None:
            ways["load_factor"] = plan.required / own
        if radius:
            ways["F_allowed"] = own * eta / last / radius
    return ways


def shaft(found, k):
    """Power backwards from the machine, speed by the train."""
    shafts = found.power
    plan, bearing = shafts.plan, shafts.given.bearings.efficiency
    before = shafts.given.shafts.at == "before bearings"
    own = (shafts.given.machine.efficiency if shafts.given.machine else 1.0) or 1.0
    power = shafts.base * plan.eta / own
    for number in range(len(plan.links), k, -1):
        power /= bearing ** plan.pairs[number] * plan.links[number - 1].efficiency
    power /= bearing ** plan.pairs[k] if before else 1.0
    passed = [link.stage for link in plan.links[:k] if link.kind == "stage"]
    turned = abs(found.speed[found.stages[passed[-1]].output if passed else found.input])
    torque = power / turned * (9550 * math.pi / 30000 if shafts.given.shafts.torque == 9550 else 1.0)
    return {"P": power, "n": turned * RPM, "omega": turned, "T": torque}


def exact(found, wheel):
    """Teeth of a sought wheel before rounding, by its stage's wanted ratio."""
    (stage,) = (stage for stage in found.stages if wheel in (stage.input, stage.output))
    z = dict(zip((stage.input, stage.output), stage.teeth.z, strict=True))
    return (
        z[stage.input] * abs(stage.wanted) if wheel == stage.output else z[stage.output] / abs(stage.wanted)
    )


FREE = LINKED.replace("speed: drive", "speed: 240 rpm").replace("  speed: 960 rpm\n", "")
CRANK = {
    "linked": LINKED.replace("  speed: 960 rpm\n", "  motors: [[m, 1.1 kW, 960 rpm]]\n"),
    "its own speed": FREE
    + "  motors: [[a, 0.75 kW, 960 rpm], [b, 1.1 kW, 950 rpm], [c, 1.5 kW, 1400 rpm]]\n",
    "sought teeth": FREE.replace("ratio: -4, ", "").replace("[20, 80]", "[20, rest]")
    + "  motors: [[a, 1.1 kW, 930 rpm]]\n  bearings: 0.99\n",
    "greatest": FREE + "  motors: [[a, 4 kW, 960 rpm]]\n  needed: greatest\n",
}


@pytest.mark.parametrize("name", CRANK)
def test_every_formula_of_a_drive_that_turns_the_link(name):
    found = course.solve(loading.loads(CRANK[name])).drive
    assert told(found) == []
    moment = found.moments.greatest if name == "greatest" else found.moments.mean
    turned = 960 / 4 if name == "linked" else 240
    assert found.power.plan.need.power == pytest.approx(abs(moment) * turned / RPM, rel=1e-9)


def test_the_mean_moment_is_the_work_of_the_load():
    """500 N over 0.2 m forward and back, in one turn."""
    found = course.solve(loading.loads(CRANK["its own speed"])).drive
    assert found.power.plan.need.power == pytest.approx(500 * 0.4 * 240 / 60, rel=1e-9)
    assert found.power.motor.name == "b"  # 0.75 kW are too few, 1400 rpm is too quick
