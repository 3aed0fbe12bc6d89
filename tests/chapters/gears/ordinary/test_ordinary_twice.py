"""Every formula of an ordinary stage by a second way: numpy, equilibrium of a pulley, powers of the train."""

import math
from itertools import pairwise

import numpy as np
import pytest
from test_drive import PAIR, solve
from test_ordinary import BELTS, OTHERS
from twice import disagreements

from tmm_report.mechanics.gears import belts

TWO = {"kind": "belt", "driving": "90 mm", "driven": "250 mm"}
DRIVES = {
    **{f"belt {name}": [one] for name, one in BELTS.items()},
    **{name: [PAIR, one] for name, one in OTHERS.items()},
    "chain by its links": [{"kind": "chain", "teeth": [17, 40], "pitch": "12.7 mm", "links": 100, "slack": 0}],
    "friction, driving sought": [{"kind": "friction", "driven": "300 mm", "ratio": 3, "slip": 0.01}],
    "friction, driven sought": [{"kind": "friction", "driving": "90 mm", "ratio": 3, "slip": 0.01}],
    "a ring drives": [{"kind": "friction", "contact": "internal", "driving": "300 mm", "driven": "90 mm"}],
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
    ways = WAYS[stage.kind](found, stage)
    assert disagreements(stage.s, ways) == []
    for row in getattr(stage.s, "rows", ()):
        assert disagreements(row, ways["rows"][row.row]) == []


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


def _chain(found, stage):
    """By the polygon of the sprocket, by the power; the number of links that the distance found has again."""
    n, of = stage.s.number, stage.given
    one, two = of.z
    pitch, speed = of.pitch, abs(found.speed[stage.input])
    # a regular polygon of side p: circumscribed radius
    radius = [abs(pitch / (np.exp(2j * np.pi / z) - 1)) for z in (one, two)]
    bent = ((two - one) / math.pi / 2) ** 2

    def links(a):
        return 2 * a / pitch + (one + two) / 2 + bent * pitch / a

    mean = speed * one * pitch / math.pi / 2
    steps = np.linspace(-math.pi / one, math.pi / one, 2001)  # a joint goes round by one tooth
    along = speed * radius[0] * np.cos(steps)
    ways = {
        "z_exact": one * abs(of.ratio or 0), "u": found.speed[stage.input] / found.speed[stage.output],
        "d1": 2 * radius[0], "d2": 2 * radius[1], "L": n("links") * pitch, "a_put": n("a") * (1 - of.slack),
        "v": mean, "v_max": along.max(), "v_min": along.min(), "delta": (along.max() - along.min()) / mean,
    }  # fmt: skip
    assert links(n("a")) == pytest.approx(n("links"), rel=1e-12)
    ways["a"] = n("a")
    if "a_about" in stage.s:
        ways["links_about"] = links(n("a_about"))
    if "T1" in stage.s:
        force = abs(found.loads.power[found.input]) * _before(found, stage) / mean
        heavy = (of.mass or 0.0) * mean**2
        ways |= {"F_t": force, "F_c": heavy, "F_tight": force + heavy}
    return ways


def _friction(found, stage):
    """By the train; the pressing force from the friction that it makes."""
    of = stage.given
    one, two = stage.members
    speed = abs(found.speed[stage.input])
    v = speed * one.radius
    ways = {
        "d1": 2 * one.radius, "d2": 2 * two.radius, "u": found.speed[stage.input] / found.speed[stage.output],
        "a": two.distance, "v": v, "v_slip": v - abs(found.speed[stage.output]) * two.radius,
    }  # fmt: skip
    assert (
        abs(two.distance - (two.radius + one.radius if of.sense < 0 else abs(two.radius - one.radius)))
        < 1e-12
    )
    if "T1" in stage.s:
        force = abs(found.loads.power[found.input]) * _before(found, stage) / v
        ways["F_t"] = force
        if of.coefficient:
            pressed = of.reserve * force / of.coefficient
            ways |= {"F_n": pressed, "q_n": pressed / (of.width or 1.0)}
    if of.contact == "bevel":
        angle = of.shaft_angle  # the apex is as far from both circles
        reach = math.hypot(one.radius, (two.radius + one.radius * math.cos(angle)) / math.sin(angle))
        first, second = math.asin(one.radius / reach), math.asin(two.radius / reach)
        assert first + second == pytest.approx(angle, rel=1e-9)
        ways |= {"delta1": first, "delta2": second}
        if "F_n" in ways:
            ways |= {"F_a1": ways["F_n"] * one.radius / reach, "F_a2": ways["F_n"] * two.radius / reach}
    return ways


def _bevel(found, stage):
    """In space: both cones touch along a line; a force on the tooth square to it, taken apart along both axes."""
    n, of = stage.s.number, stage.given
    angle, (one, two) = of.shaft_angle, of.z
    # the common line parts the angle between the axes so that the circles on it are as the teeth
    line = np.array([math.cos(angle), math.sin(angle)]) * one + np.array([1.0, 0.0]) * two
    first = math.atan2(line[1], line[0])
    second = angle - first
    module, mean = n("m_e"), n("m_m")
    outer = module * one / math.sin(first) / 2
    speed = abs(found.speed[stage.input])
    ways = {
        "z_exact": one * abs(of.ratio or 0), "u": found.speed[stage.input] / found.speed[stage.output],
        "delta1": first, "delta2": second, "R_e": outer, "b": 2 * (outer - n("R_m")),
        "R_m": outer * mean / module, "m_e": module, "m_m": mean, "d_e1": module * one, "d_e2": module * two,
        "d_m1": mean * one, "d_m2": mean * two, "z_v1": one / math.sin(math.pi / 2 - first),
        "z_v2": two / math.sin(math.pi / 2 - second), "v": speed * stage.members[0].radius,
    }  # fmt: skip
    assert n("b") == pytest.approx(of.width or 0.285 * outer, rel=1e-12)
    assert (module if of.module else mean) == (of.module or of.mean_module)
    if "T1" in stage.s:
        force = (
            abs(found.loads.power[found.input]) * _before(found, stage) / (speed * stage.members[0].radius)
        )
        axes = [np.array([1.0, 0.0]), np.array([math.cos(angle), math.sin(angle)])]  # both away from the apex
        across = np.array([math.sin(first), -math.cos(first)])  # square to the common line, towards axis 1
        pressed = (
            force * math.sin(of.alpha) / math.cos(of.alpha) * across
        )  # on wheel 1; on wheel 2 the other way
        ways["F_t"] = force
        for k, (axis, on) in enumerate(zip(axes, (pressed, -pressed), strict=True), 1):
            ways[f"F_a{k}"] = float(on @ axis)
            ways[f"F_r{k}"] = float(np.linalg.norm(on - (on @ axis) * axis))
    return ways


def _worm(found, stage):
    """By the inclined plane into which a turn of the thread is unrolled; velocities and powers in space."""
    n, of = stage.s.number, stage.given
    z1, z2 = of.z
    around, along = math.pi * of.module * of.q, math.pi * of.module * z1
    slope = along / around
    rough = math.tan(math.radians(n("phi")))
    raised, lowered = (
        (slope + rough) / (1 - slope * rough),
        (slope - rough) / (1 + slope * rough),
    )  # force by the load
    speed = abs(found.speed[stage.input])
    turned = abs(found.speed[stage.output])
    one, two = (member.radius for member in stage.members)
    ways = {
        "z_exact": z1 * abs(of.ratio or 0), "u": found.speed[stage.input] / found.speed[stage.output],
        "gamma": math.acos(around / math.hypot(around, along)), "d1": around / math.pi,
        "d2": of.module * z2, "a": one + two, "eta_mesh": slope / raised, "eta": stage.efficiency,
        "eta_back": lowered / slope, "omega2": turned, "v1": speed * one, "v2": turned * two,
        "v_slip": math.hypot(speed * one, turned * two),
    }  # fmt: skip
    ways["phi"] = math.atan(of.coefficient) if of.coefficient is not None else math.radians(n("phi"))
    assert stage.efficiency == pytest.approx(of.splash * slope / raised, rel=1e-12)
    if "T1" in stage.s:
        power = abs(found.loads.power[found.input]) * _before(found, stage)
        load = power * stage.efficiency / (turned * two)
        ways |= {"T2": power * stage.efficiency / turned, "F_t2": load, "F_t1": load * raised}
        ways["F_r"] = load * math.sin(of.alpha) / math.cos(of.alpha)
        # what the worm's shaft gives the mesh: its power without what the oil takes
        assert ways["F_t1"] * speed * one == pytest.approx(power * of.splash, rel=1e-9)
    return ways


def _train(found, stage):
    """By the speeds of the train; the forces by the torques of its meshes."""
    of, members = stage.given, stage.members
    ways = {
        "z_exact": abs(of.ratio or 0) * of.z[0], "u": found.speed[stage.input] / found.speed[stage.output],
        "a": members[-1].distance,
    }  # fmt: skip
    first = sum(len(one.meshes) for one in found.stages[: found.stages.index(stage)])
    rows = [{} for _ in members]
    for k, (one, two) in enumerate(pairwise(members)):
        force = abs(float(found.loads.mesh_torque[first + k])) / one.radius
        rows[k] = {
            "a": abs(two.distance - one.distance),
            "F_t": force,
            "F_r": force * math.sin(math.pi / 9) / math.cos(math.pi / 9),
        }
    for k in range(1, len(members) - 1):
        before, after = rows[k - 1]["F_t"], rows[k]["F_t"]
        lean = math.tan(math.pi / 9)
        # on the idler the forces lie on the same side across, and one against the other along the line of the axes
        rows[k]["F_axis"] = abs(before * (1 + 1j * lean) + after * (1 - 1j * lean))
    return {**ways, "rows": rows}


WAYS = {
    "belt": _belt,
    "chain": _chain,
    "friction": _friction,
    "train": _train,
    "bevel": _bevel,
    "worm": _worm,
}
