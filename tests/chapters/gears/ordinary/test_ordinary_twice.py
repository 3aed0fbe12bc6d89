"""Every formula of an ordinary stage by a second way: numpy, equilibrium of a pulley, powers of the train."""

import math

import numpy as np
import pytest
from test_drive import PAIR, solve
from test_ordinary import BELTS
from twice import disagreements

from tmm_report.mechanics.gears import belts

TWO = {"kind": "belt", "driving": "90 mm", "driven": "250 mm"}
DRIVES = {
    **{f"belt {name}": [one] for name, one in BELTS.items()},
    "belt by length": [TWO | {"length": "1600 mm", "coefficient": 0.25}],
    "belt, driving sought": [PAIR, {"kind": "belt", "belt": "crossed", "driven": "250 mm", "ratio": 2.5, "slip": 0.01}],
    "belt, multiplier": [TWO | {"driven": "60 mm", "distance": "0.5 m", "coefficient": 0.3}],
    "belt, driven sought": [{"kind": "belt", "driving": "250 mm", "ratio": 1.5}],
}  # fmt: skip


@pytest.mark.parametrize("name", DRIVES)
@pytest.mark.parametrize("torque", [None, "21.9 N*m"])
def test_every_formula_agrees_with_the_second_way(name, torque):
    found = solve(*DRIVES[name], **({"torque": torque} if torque else {}))
    stage = found.stages[-1]
    assert disagreements(stage.s, WAYS[stage.kind](found, stage)) == []


def _belt(found, stage):
    """Lengths of the outline; Euler's equation integrated over the arc; equilibrium of the driving pulley."""
    n, of = stage.s.number, stage.given
    one, two = (member.radius for member in stage.members)
    distance = stage.members[1].distance
    reach = (two + one) if of.crossed else two - one
    strand = math.sqrt(distance**2 - reach**2)
    theta = math.atan2(reach, strand)
    wraps = (math.pi + 2 * theta if of.crossed else math.pi - 2 * theta, math.pi + 2 * theta)
    speed = abs(found.speed[of.wheels[0]])
    ways = {
        "d_exact": 2 * one * abs(of.ratio or 0) * (1 - of.slip),
        "d1": 2 * two / abs(stage.ratio) / (1 - of.slip), "d2": 2 * one * abs(stage.ratio) * (1 - of.slip),
        "u": found.speed[of.wheels[0]] / found.speed[of.wheels[1]],
        "theta": theta, "alpha1": wraps[0], "alpha2": wraps[1],
        "L": 2 * strand + one * wraps[0] + two * wraps[1], "v": speed * one,
        "runs": speed * one / belts.length(2 * one, 2 * two, distance, of.crossed),
    }  # fmt: skip
    if "a_about" in stage.s:
        a = n("a_about")
        ways["L_about"] = 2 * a + math.pi * (one + two) + (2 * reach) ** 2 / a / 4
    if "T1" in stage.s:
        force = abs(found.loads.power[found.input]) * _before(found, stage) / (speed * one)
        ways |= {"F_t": force, **_strands(stage, force, min(wraps), theta, speed * one)}
    return ways


def _before(found, stage):
    """The part of the power that is left at the input of the stage."""
    return math.prod(one.efficiency for one in found.stages[: found.stages.index(stage)])


def _strands(stage, force, wrap, theta, v):
    of = stage.given
    if not of.coefficient:
        return {}
    rough = (
        of.coefficient / math.sin((of.groove or math.radians(40)) / 2) if of.belt == "V" else of.coefficient
    )
    steps = 1000
    times = (
        float((1 - rough * wrap / steps / 2) / (1 + rough * wrap / steps / 2)) ** -steps
    )  # dF = f F dα, midpoint
    exact = math.e ** (rough * wrap)
    assert times == pytest.approx(exact, rel=1e-4)
    slack = of.reserve * force / (exact - 1)  # where it begins to slip: F1 − F2 = k F_t, F1 = m F2
    least = (slack + exact * slack) / 2
    tight, other = least + force / 2, least - force / 2
    pull = tight * np.exp(1j * theta) + other * np.exp(-1j * theta)
    mass = of.mass or 0.0
    return {
        "f_red": rough, "m": exact, "F_0": least, "F_tight": tight, "F_slack": other, "F_shaft": abs(pull),
        "F_c": mass * v * v, "F_put": least + mass * v * v,
    }  # fmt: skip


WAYS = {"belt": _belt}
