"""Published examples of governors, through the functions of the chapter."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from cases import agrees, case, every

from tmm_report import course, loading
from tmm_report.mechanics.machine.governor import equilibrium as g
from tmm_report.mechanics.machine.governor import stability as small

RPM = 30 / math.pi


def given(name: str) -> dict[str, float]:
    return case(name)["inputs"]


def rpm(geometry: g.Geometry, weights: g.Weights, lowest: float, lift: float, friction: float = 0.0):
    """Speeds of the shaft at the ends of the lift, falling and rising, rpm."""
    found = g.equilibrium(geometry.moves(np.array([0.0, lift]), lowest), weights)
    down, up = found.band(friction)
    return down * RPM, up * RPM


def test_watt_lift():
    at = given("sarkar-7-1-watt")
    l, x = at["l_m"], at["l_m"] * math.sin(math.radians(at["alpha_deg"]))
    arms = g.Arms(l, l)
    # the sleeve on equal arms goes twice as far as the cone of the balls
    _, (low, high) = rpm(arms, g.Weights(1.0), x, 2 * at["rise_m"])
    agrees("sarkar-7-1-watt", percent=100 * (high / low - 1))


@pytest.mark.parametrize("name", ["sarkar-7-3-porter-offset", "askfilo-porter-friction"])
def test_porter_range(name):
    at = given(name)
    arms = g.Arms(at["l1"], at["l2"], lower_offset=at.get("e2", 0.0))
    lift = arms.height(at["r_min"]) - arms.height(at["r_max"])
    weights = g.Weights(at["m"], at["M"])
    _, (low, high) = rpm(arms, weights, at["r_min"], lift)
    agrees(name, N_min=low, N_max=high, range=high - low)
    if "F_N" in at:
        (low, _), (_, high) = rpm(arms, weights, at["r_min"], lift, at["F_N"])
        agrees(name, N_min_f=low, N_max_f=high, range_f=high - low)


def test_porter_friction():
    at = given("sarkar-7-5-porter-friction")
    arms, weights = g.Arms(at["l1"], at["l2"], lower_offset=at["e2"]), g.Weights(at["m"], at["M"])
    _, (speed, _) = rpm(arms, weights, at["r"], 0.0)
    down, up = rpm(arms, weights, at["r"], 0.0, at["F_N"])
    agrees("sarkar-7-5-porter-friction", N=speed, range=up[0] - down[0])


def test_hartnell_with_a_given_spring():
    at = given("sarkar-7-7-hartnell")
    crank = g.BellCrank(at["a"], at["b"], at["r2"], level=True)
    balls = crank.moves(np.array([0.0, at["h"]]), at["r2"])
    bare = g.Weights(at["m"])
    preload = g.spring_force(balls, bare, at["N2"] / RPM)[0]
    held = g.equilibrium(balls, g.Weights(at["m"], stiffness=at["s"], preload=preload))
    agrees("sarkar-7-7-hartnell", S2_N=preload, N1=held.omega[1] * RPM)


def test_hartnell_with_oblique_arms():
    """As the source has it the weight of the balls opposes at both ends; at the outer end it assists."""
    name = "sarkar-7-9-hartnell-oblique"
    at = given(name)
    crank = g.BellCrank(at["a"], at["b"], at["r"])
    balls = crank.moves(np.array([0.0, at["h"]]), at["r2"])
    ends = np.array([1.0, at["ratio"]]) * at["N2"]
    mean = ends.mean()
    for found, keys in ((replace(balls, dh=np.abs(balls.dh)), ("x0_cm", "alteration_rpm")),
                        (balls, ("x0_cm_consistent", "alteration_consistent"))):  # fmt: skip
        low, high = g.spring_force(found, g.Weights(at["m"]), ends / RPM)
        stiffness = (high - low) / at["h"]
        # at the middle the arm is upright and the spring alone holds the sleeve, at the mean speed
        E = (low + high) / 2
        band = math.sqrt(1 + at["F"] / E) - math.sqrt(1 - at["F"] / E)
        agrees(name, **{keys[0]: 100 * low / stiffness, keys[1]: mean * band})


def test_proell_range():
    at = given("sarkar-7-12-proell-range")
    arms = g.Arms(at["l"], at["l"], lower_offset=at["e2"], extension=at["ext"], upright_at=at["r_min"])
    lift = arms.height(at["r_min"]) - arms.height(at["r_max"])
    _, (low, high) = rpm(arms, g.Weights(at["m"], at["M"]), at["r_min"], lift)
    agrees("sarkar-7-12-proell-range", N_min=low, N_max=high)


def test_hartnell_of_bevan():
    """In pounds and inches, with g = 32.2 ft/s²; the speed between lies on the straight line of the controlling
    force."""
    at = given("bevan-13-3-hartnell")
    gravity = 32.2 * 12
    crank = g.BellCrank(at["a"], at["b"], at["r2_in"], level=True)
    lift = crank.lift(at["r2_in"], at["r1_in"])
    balls = crank.moves(np.array([0.0, crank.lift(at["r2_in"], at["r0_in"]), lift]), at["r2_in"])
    weights = g.Weights(at["w"] / gravity, gravity=gravity)
    ends = np.array([1.0, np.nan, at["ratio"]]) * at["N2"] / RPM
    low, _, high = g.spring_force(balls, weights, ends)
    stiffness = (high - low) / lift
    found = g.equilibrium(balls, replace(weights, stiffness=stiffness, preload=low))
    agrees("bevan-13-3-hartnell", p_lb_in=stiffness, N_rpm=found.omega[1] * RPM)
    # the same on the line through the ends
    a, b = g.line_through((at["r2_in"], at["r1_in"]), (found.force[0], found.force[2]))
    speed = g.speed_on_ray(a * at["r0_in"] + b, weights.ball, at["r0_in"])
    agrees("bevan-13-3-hartnell", N_rpm=speed * RPM)


def test_insensitivity_of_bevan():
    """f/E of a dead-weight governor, half the friction against the controlling force of a ball of a spring-loaded
    one."""
    at = given("bevan-13-10-11-insensitive")
    level = g.BellCrank(1.0, 1.0, 1.0, level=True).moves(np.array([0.0]), 1.0)
    dead = g.equilibrium(level, g.Weights(1.0, at["W"] + at["w"], gravity=1.0))
    agrees("bevan-13-10-11-insensitive", k_dead=at["fs_dead"] / dead.E[0])
    crank = g.BellCrank(at["a"], at["b"], 1.0, level=True)
    for key, force in (("k_min_r", at["F2"]), ("k_max_r", at["F1"])):
        # E on the sleeve that holds two balls, each with the force
        E = 2 * force * crank.ball_arm / crank.sleeve_arm
        agrees("bevan-13-10-11-insensitive", **{key: at["fs"] / E})


def test_isochronous_tension():
    at = given("vlabs-isochronous")
    a, b = g.line_through((at["d2_m"] / 2, at["d1_m"] / 2), (at["F2"], at["F1"]))
    agrees("vlabs-isochronous", tension_N=-b)
    # with that added the line goes through the origin: one speed at both ends
    ends = np.array([at["d2_m"], at["d1_m"]]) / 2
    speeds = g.speed_on_ray(a * ends, 1.0, ends)
    assert speeds[0] == pytest.approx(speeds[1], rel=1e-12)


def test_hartnell_stiffness():
    at = given("ktu-hartnell")
    crank = g.BellCrank(at["a"], at["b"], at["r2"], level=True)
    lift = crank.lift(at["r2"], at["r1"])
    balls = crank.moves(np.array([0.0, lift]), at["r2"])
    low, high = g.spring_force(balls, g.Weights(at["m"]), np.array([at["N2"], at["N1"]]) / RPM)
    stiffness = (high - low) / lift
    agrees(
        "ktu-hartnell", S2_N=low, s_N_per_m=stiffness, s_kN_per_m=stiffness / 1e3, x0_mm=1e3 * low / stiffness
    )


def test_vyshnegradsky_normal_form():
    at = given("vyshnegradsky-normal-form")
    bound = at["A_b"] * float(small.hyperbola(at["A_b"]))
    assert not small.stable(np.array([1, at["A_b"], 0.999 / at["A_b"], 1])) and small.stable(
        np.array([1, at["A_b"], 1.001 / at["A_b"], 1])
    )
    roots = np.roots([1.0, at["A3"], at["B3"], 1.0])
    agrees("vyshnegradsky-normal-form", AB_limit=bound, triple_root=roots.real.mean())
    assert np.abs(roots + 1).max() < 1e-4 and small.double_roots(1.0) == (at["A3"], at["B3"])


# --- the same through variants


def solved(text: str):
    return course.solve(loading.loads("governor:\n" + text)).governor.direct


def test_porter_range_by_a_variant():
    at = given("sarkar-7-3-porter-offset")
    found = solved(
        f"  arms: {{upper: {at['l1']}, lower: {at['l2']}, lower_offset: {at['e2']}}}\n"
        f"  balls: {{mass: {at['m']}}}\n  sleeve: {{mass: {at['M']}}}\n"
        f"  radius: {{lowest: {at['r_min']}, highest: {at['r_max']}}}\n"
    )
    low, high = (omega * RPM for omega in found.ends)
    agrees("sarkar-7-3-porter-offset", N_min=low, N_max=high, range=high - low)


def test_porter_friction_by_a_variant():
    """Once with the radius stated as that of the lower stop, once with both ends and friction."""
    at = given("sarkar-7-5-porter-friction")
    found = solved(
        f"  arms: {{upper: {at['l1']}, lower: {at['l2']}, lower_offset: {at['e2']}}}\n"
        f"  balls: {{mass: {at['m']}}}\n  sleeve: {{mass: {at['M']}, friction: {at['F_N']}}}\n"
        f"  radius: {{lowest: {at['r']}}}\n  lift: 10 mm\n"
    )
    down, up = found.table.band(at["F_N"])
    agrees("sarkar-7-5-porter-friction", N=found.ends[0] * RPM, range=(up[0] - down[0]) * RPM)
    at = given("askfilo-porter-friction")
    found = solved(
        f"  arms: {{upper: {at['l1']}, lower: {at['l2']}}}\n"
        f"  balls: {{mass: {at['m']}}}\n  sleeve: {{mass: {at['M']}, friction: {at['F_N']}}}\n"
        f"  radius: {{lowest: {at['r_min']}, highest: {at['r_max']}}}\n"
    )
    down, up = found.table.band(at["F_N"])
    low, high = (omega * RPM for omega in found.ends)
    agrees("askfilo-porter-friction", N_min=low, N_max=high, range=high - low)
    low, high = down[0] * RPM, up[-1] * RPM
    agrees("askfilo-porter-friction", N_min_f=low, N_max_f=high, range_f=high - low)


def test_watt_by_a_variant():
    at = given("sarkar-7-1-watt")
    x = at["l_m"] * math.sin(math.radians(at["alpha_deg"]))
    found = solved(
        f"  arms: {{upper: {at['l_m']}, lower: {at['l_m']}}}\n  balls: {{mass: 2 kg}}\n"
        f"  radius: {{lowest: {x}}}\n  lift: {2 * at['rise_m']}\n"
    )
    low, high = found.ends
    agrees("sarkar-7-1-watt", percent=100 * (high / low - 1))


def test_hartnell_by_a_variant():
    at = given("sarkar-7-7-hartnell")
    crank = (
        f"  bell_crank: {{ball_arm: {at['a']}, sleeve_arm: {at['b']}, fulcrum: {at['r2']}, level: true}}\n"
    )
    rest = f"  balls: {{mass: {at['m']}}}\n  radius: {{lowest: {at['r2']}}}\n  lift: {at['h']}\n"
    preload = case("sarkar-7-7-hartnell")["recomputed"]["S2_N"]
    found = solved(f"{crank}{rest}  spring: {{stiffness: {at['s']}, force: {preload}}}\n")
    agrees("sarkar-7-7-hartnell", N1=found.ends[1] * RPM)
    chosen = solved(f"{crank}{rest}  choose: {{spring: [{at['N2']} rpm, {found.ends[1] * RPM} rpm]}}\n")
    agrees("sarkar-7-7-hartnell", S2_N=chosen.weights.preload)
    assert chosen.weights.stiffness == pytest.approx(at["s"], rel=1e-6)


def test_hartnell_stiffness_by_a_variant():
    at = given("ktu-hartnell")
    found = solved(
        f"  bell_crank: {{ball_arm: {at['a']}, sleeve_arm: {at['b']}, fulcrum: {at['r2']}, level: true}}\n"
        f"  balls: {{mass: {at['m']}}}\n  radius: {{lowest: {at['r2']}, highest: {at['r1']}}}\n"
        f"  choose: {{spring: [{at['N2']} rpm, {at['N1']} rpm]}}\n"
    )
    spring = found.weights
    agrees(
        "ktu-hartnell", S2_N=spring.preload, s_N_per_m=spring.stiffness, s_kN_per_m=spring.stiffness / 1e3,
        x0_mm=1e3 * spring.preload / spring.stiffness,
    )  # fmt: skip


def test_hartnell_with_oblique_arms_by_a_variant():
    """The weight of the balls is taken as it acts; the last output is at the mean of the speeds of both stops."""
    at = given("sarkar-7-9-hartnell-oblique")
    found = solved(
        f"  bell_crank: {{ball_arm: {at['a']}, sleeve_arm: {at['b']}, fulcrum: {at['r']}}}\n"
        f"  balls: {{mass: {at['m']}}}\n  sleeve: {{friction: {at['F']}}}\n"
        f"  radius: {{lowest: {at['r2']}}}\n  lift: {at['h']}\n"
        f"  choose: {{spring: [{at['N2']} rpm, {at['N2'] * at['ratio']} rpm]}}\n"
    )
    spring = found.weights
    alteration = found.table.insensitivity(at["F"])[found.middle] * found.mean * RPM
    agrees(
        "sarkar-7-9-hartnell-oblique", x0_cm_consistent=100 * spring.preload / spring.stiffness,
        alteration_consistent=alteration,
    )  # fmt: skip


def test_proell_by_a_variant():
    at = given("sarkar-7-12-proell-range")
    found = solved(
        f"  arms: {{upper: {at['l']}, lower: {at['l']}, lower_offset: {at['e2']}}}\n"
        f"  balls: {{mass: {at['m']}, extension: {at['ext']}}}\n  sleeve: {{mass: {at['M']}}}\n"
        f"  radius: {{lowest: {at['r_min']}, highest: {at['r_max']}}}\n"
    )
    low, high = found.ends
    agrees("sarkar-7-12-proell-range", N_min=low * RPM, N_max=high * RPM)


def test_every_published_example_is_here():
    of_topic = {name for name, one in every().items() if one["topic"] == 4}
    with open(__file__, encoding="utf-8") as file:
        text = file.read()
    assert len(of_topic) == 12 and not [name for name in of_topic if f'"{name}"' not in text]
