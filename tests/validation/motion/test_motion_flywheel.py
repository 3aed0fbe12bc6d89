"""Published examples of flywheels: each through a variant as a student would state it, and by the mechanics alone.

The angles, scales and loads are the examples' own; what is not printed is held against their recomputation. Areas of a
diagram whose angles are not stated are laid off over equal parts of the cycle, which changes no number that is asked.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from cases import agrees, case

from tmm_report import course, loading
from tmm_report.mechanics.calculus.panels import panels
from tmm_report.mechanics.machine.flywheel import inertia as fly
from tmm_report.mechanics.machine.flywheel.motion import turning

RPM = math.pi / 30


def solved(**keys: object):
    """The flywheel of a variant that states these keys, each as YAML text."""
    text = "flywheel:\n" + "".join(f"  {key}: {value}\n" for key, value in keys.items())
    return course.solve(loading.loads(text)).flywheel


def kinetic(numbers: dict) -> str:
    return f"{{mass: {numbers['m_kg']}, radius_of_gyration: {numbers['k_m']}}}"


def test_extreme_areas_of_a_turning_moment_diagram():
    given = case("khurmi-16-4-areas")["inputs"]
    most, least = given["Emax_mm2"], given["Emin_mm2"]
    areas = f"{{values: [{most}, {least - most}, {-least}], scale: {given['J_per_mm2']}}}"
    found = solved(areas=areas, wheel=kinetic(given), speed=f"{given['N_rpm']} rpm")
    agrees("khurmi-16-4-areas", dE_J=found.s.number("A_ex"), Cs_percent=100 * found.s.number("delta"))


def trapezoid() -> str:
    points = case("khurmi-16-6-trapezoid")["inputs"]["points_pi_Nm"]
    return "{table: [" + ", ".join(f"[{180 * x} deg, {y}]" for x, y in points) + "]}"


def test_a_machine_that_needs_a_trapezoidal_moment_over_three_turns():
    given = case("khurmi-16-6-trapezoid")["inputs"]
    found = solved(driving=trapezoid(), turns=3, wheel=kinetic(given), speed=f"{given['N_rpm']} rpm")
    (_, least), (_, greatest) = found.cycle.swing
    agrees(
        "khurmi-16-6-trapezoid",
        T_mean_Nm=found.s.number("M_m"),
        W_J=found.s.number("W"),
        dE_J=found.s.number("A_ex"),
        CE_percent=100 * found.s.number("A_ex") / found.s.number("W"),
        P_kW=found.s.number("P_m") / 1e3,
        theta_min_deg=math.degrees(least),
        theta_max_deg=math.degrees(greatest),
        Cs=found.s.number("delta"),
    )


def test_the_same_moment_as_a_resistance_has_its_extremes_the_other_way_round():
    given = case("khurmi-16-6-trapezoid")["inputs"]
    found = solved(resisting=trapezoid(), turns=3, wheel=kinetic(given), speed=f"{given['N_rpm']} rpm")
    (_, least), (_, greatest) = found.cycle.swing
    assert math.degrees(least) == pytest.approx(630) and math.degrees(greatest) == pytest.approx(90)
    agrees(
        "khurmi-16-6-trapezoid",
        dE_J=found.s.number("A_ex"),
        Cs=found.s.number("delta"),
        P_kW=found.s.number("P_m") / 1e3,
    )


def test_a_four_stroke_engine_with_a_triangle_of_expansion():
    given = case("khurmi-16-9-four-stroke")["inputs"]
    work = given["P_W"] * 120 / given["N_rpm"]  # of two turns
    up, down = 2 * 1.5 * work / math.pi, -2 * 0.5 * work / math.pi
    table = f"[[180 deg, 0], [270 deg, {down}], [360 deg, 0], [450 deg, {up}], [540 deg, 0], [720 deg, 0]]"
    found = solved(driving=f"{{table: {table}}}", turns=2, delta=given["Cs"], speed=f"{given['N_rpm']} rpm")
    assert found.s.number("P_m") == pytest.approx(given["P_W"])
    agrees("khurmi-16-9-four-stroke", dE_J=found.s.number("A_ex"), I_kgm2=found.s.number("J_fl"))


def harmonics(mean: float, rows: list) -> str:
    waves = ", ".join(f"{{order: {n}, cos: {a}, sin: {b}}}" for n, a, b in rows)
    return f"{{mean: {mean}, harmonics: [{waves}]}}"


def test_a_moment_of_two_harmonics_against_a_constant_load():
    given = case("khurmi-16-11-harmonic")["inputs"]
    driving = harmonics(given["Tm_Nm"], given["diff_harmonics"])
    found = solved(driving=driving, delta=given["Cs"], speed=f"{given['N_rpm']} rpm")
    after, over = found.after, found.cycle.panels
    (low, at_low), (high, at_high) = over.extremes(after.epsilon)
    agrees(
        "khurmi-16-11-harmonic",
        dE_J=found.s.number("A_ex"),
        P_kW=found.s.number("P_m") / 1e3,
        I_kgm2=found.s.number("J_fl"),
        Cs_percent=100 * after.delta,
        alpha_max=high,
        alpha_min_abs=-low,
        theta_alpha_max_deg=math.degrees(at_high) % 180,
        theta_alpha_min_deg=math.degrees(at_low) % 180,
        alpha_at=float(over.at(after.epsilon, np.radians([given["theta_deg"]]))[0]),
    )


def test_a_third_harmonic_against_a_constant_load_and_against_a_sine():
    given = case("khurmi-16-13-third-harmonic")["inputs"]
    stated = {"wheel": f"{{inertia: {given['I_kgm2']}}}", "speed": f"{given['N_rpm']} rpm"}
    driving = harmonics(given["Tm_Nm"], given["diff_harmonics"])
    found = solved(driving=driving, **stated)
    (low, _), (high, _) = found.cycle.panels.extremes(found.after.epsilon)
    sine = harmonics(given["Tm_Nm"], [[n, -a, -b] for n, a, b in given["diff2_harmonics"][1:]])
    other = solved(driving=driving, resisting=sine, **stated)
    agrees(
        "khurmi-16-13-third-harmonic",
        dE_J=found.s.number("A_ex"),
        P_kW=found.s.number("P_m") / 1e3,
        I_kgm2=found.s.number("J_fl"),
        Cs_percent=100 * found.s.number("delta"),
        alpha_max=high,
        alpha_min_abs=-low,
        Cs2_percent=100 * other.s.number("delta"),
    )


def test_a_punching_machine():
    given = case("khurmi-16-19-punch")["inputs"]
    punch = (
        f"{{work: {given['E_hole_J']}, period: {3600 / given['holes_per_h']}, time: {given['t_punch_s']}}}"
    )
    speeds = f"[{given['N2_rpm']} rpm, {given['N1_rpm']} rpm]"
    found = solved(punch=punch, speeds=speeds, radius_of_gyration=given["k_m"])
    assert (found.after.greatest, found.after.least) == pytest.approx((225 * RPM, 200 * RPM))
    agrees("khurmi-16-19-punch", P_kW=found.s.number("P_m") / 1e3, m_kg=found.s.number("m"))


def test_the_mass_of_a_rim_from_seven_areas():
    given = case("sarkar-6-4-areas")["inputs"]
    areas = f"{{values: {given['areas']}, scale: {given['J_per_area']}}}"
    found = solved(
        areas=areas, delta=given["Cs"], speed=f"{given['N_rpm']} rpm", radius_of_gyration=given["k_m"]
    )
    agrees("sarkar-6-4-areas", dE_J=found.s.number("A_ex"), m_kg=found.s.number("m"))


def test_an_engine_and_a_machine_that_both_vary():
    given = case("sarkar-6-10-two-harmonics")["inputs"]
    engine, machine = given["diff_harmonics"]
    driving = harmonics(given["Tm_Nm"], [engine])
    resisting = harmonics(given["Tm_Nm"], [[machine[0], -machine[1], -machine[2]]])
    found = solved(driving=driving, resisting=resisting, delta=given["Cs"], speed=f"{given['N_rpm']} rpm")
    (low, at_low), (high, at_high) = found.cycle.panels.extremes(found.after.epsilon)
    agrees(
        "sarkar-6-10-two-harmonics",
        dE_J=found.s.number("A_ex"),
        P_kW=found.s.number("P_m") / 1e3,
        I_kgm2=found.s.number("J_fl"),
        Cs_percent=100 * found.after.delta,
        alpha_max=high,
        alpha_min_abs=-low,
        theta_alpha_max_deg=math.degrees(at_high),
        theta_alpha_min_deg=math.degrees(at_low),
    )


def test_a_question_of_a_virtual_laboratory():
    given = case("vlabs-flywheel-mcq")["inputs"]
    work = given["dE_J"]
    found = solved(areas=f"{{values: [{work}, {-work}]}}", delta=given["Cs"], speed=given["omega"])
    agrees("vlabs-flywheel-mcq", I_kgm2=found.s.number("J_fl"))


# --- the same by the mechanics alone


def cycle(moment, turns: float = 1.0, breaks=()) -> fly.Cycle:
    over = panels(2 * math.pi * turns, breaks)
    values = moment(over.x)
    return fly.Cycle(over, values - over.mean(values), np.zeros(over.shape))


def series(rows: list):
    return lambda x: sum(a * np.cos(n * x) + b * np.sin(n * x) for n, a, b in rows)


@pytest.mark.parametrize("method", fly.METHODS)
@pytest.mark.parametrize("name", ["khurmi-16-11-harmonic", "sarkar-6-10-two-harmonics"])
def test_every_method_finds_the_published_inertia_of_a_machine_without_varying_links(name, method):
    given = case(name)["inputs"]
    found = method(cycle(series(given["diff_harmonics"])), given["Cs"], given["N_rpm"] * RPM)
    agrees(name, I_kgm2=found.inertia)


@pytest.mark.parametrize(
    ("rows", "key"), [("diff_harmonics", "Cs_percent"), ("diff2_harmonics", "Cs2_percent")]
)
def test_the_unevenness_of_a_known_flywheel(rows, key):
    given = case("khurmi-16-13-third-harmonic")["inputs"]
    found = turning(cycle(series(given[rows])), given["I_kgm2"], given["N_rpm"] * RPM)
    assert found is not None
    agrees("khurmi-16-13-third-harmonic", **{key: 100 * found.delta})


def test_the_trapezoid_integrated_between_its_corners():
    given = case("khurmi-16-6-trapezoid")["inputs"]
    angles, moments = np.array(given["points_pi_Nm"]).T
    known = cycle(lambda x: np.interp(x, math.pi * angles, moments), 3, math.pi * angles)
    (low, _), (high, _) = known.swing
    found = turning(known, given["m_kg"] * given["k_m"] ** 2, given["N_rpm"] * RPM)
    assert found is not None
    agrees("khurmi-16-6-trapezoid", dE_J=high - low, Cs=found.delta)
