"""Published examples of vibration: isolators, a moving base, torsion, absorbers, dampers."""

import math

import numpy as np
import pytest
from cases import agrees, case

from tmm_report import course, loading
from tmm_report.mechanics.masses import vibration as vib
from tmm_report.mechanics.masses.vibration import Body

RPM = math.pi / 30


def found(lines: str):
    return course.solve(loading.loads("vibration:\n" + lines)).vibration


def test_isolators_stiff_and_soft():
    of = case("grover-4-10-1-isolation")["inputs"]
    stiff, soft = (
        found(f"  mass: {of['m']} kg\n  stiffness: {k}\n  force: {of['F0']} N\n  speed: {of['N']} rpm\n")
        for k in of["k_N_per_m"]
    )
    agrees(
        "grover-4-10-1-isolation",
        X_a=stiff.s.number("amplitude"), Ft_a=stiff.s.number("on_base"),
        X_b=soft.s.number("amplitude"), Ft_b=soft.s.number("on_base"),
    )  # fmt: skip


def test_radio_on_a_moving_base():
    of = case("grover-4-10-3-base")["inputs"]
    n = of["n"]
    radio = found(
        f"  mass: {of['m']} kg\n  isolators: {n}\n  stiffness: {of['k'] / n}\n  damping: {of['c'] / n}\n"
        f"  base: {of['Y']}\n  speed: {of['N']} rpm\n"
    )
    agrees("grover-4-10-3-base", X=radio.s.number("amplitude"), F_each=radio.s.number("on_base") / n)


def test_damping_from_two_measured_frequencies():
    """The source forgets to square the ratio of the frequencies: 0.1414 for 0.1971."""
    of = case("grover-4-2-2-peak")["inputs"]
    zeta, natural = vib.from_frequencies(of["fd"], of["fp"])
    agrees("grover-4-2-2-peak", zeta=zeta, fn_Hz=natural)
    assert natural * vib.peak(zeta)[0] == pytest.approx(of["fp"], rel=1e-12)


def test_disc_on_a_shaft_beyond_resonance():
    of = case("grover-4-2-1-torsion")["inputs"]
    disc = found(
        f"  inertia: {of['J']}\n  stiffness: {of['K']}\n  damping: {of['C']}\n  moment: {of['T0']}\n"
        f"  speed: {of['w']} rad/s\n"
    )
    theta, lag = disc.s.number("amplitude"), math.degrees(disc.s.number("lag"))
    couple = disc.body.damping * disc.omega * theta
    agrees("grover-4-2-1-torsion", theta=theta, damp_couple=couple, lag_deg=lag)


def test_absorber_that_keeps_resonances_away():
    of = case("grover-5-7-1-absorber")["inputs"]
    shaft = found(
        f"  inertia: {of['J1']}\n  stiffness: {of['J1'] * of['w'] ** 2!r}\n  moment: {of['T0']}\n"
        f"  speed: {of['w']} rad/s\n  damping_ratio: 0.001\n"
        f"  absorber: {{clear: {of['x']}, springs: {of['n']}, arm: {of['arm']}}}\n"
    )
    hung = shaft.absorbed
    swing = shaft.force * hung.tuned.swing  # against the moment: the source gives it its sign
    agrees(
        "grover-5-7-1-absorber",
        mu=hung.mu, J2=hung.tuned.hung.inertia, k_each=shaft.s.number("absorber_each"), b2=-swing,
    )  # fmt: skip


def test_engine_whose_shaking_force_is_isolated():
    """In pounds and inches: ratios do not mind. The source takes the exciting force at resonance for what reaches the
    base, 7 lb for 97.8 lb."""
    of = case("bevan-15-7-isolation")["inputs"]
    omega, zeta = of["N"] * RPM, math.sqrt(of["a2_over_b"]) / 2
    eta = math.sqrt(1 + 1 / of["eps"])  # without damping 1/30 is handed on
    assert vib.eta_for(of["eps"], 0.0) == pytest.approx(eta, rel=1e-12)
    force = of["m_lb"] / 32.2 * of["stroke_in"] / 24 * omega**2
    agrees(
        "bevan-15-7-isolation",
        F0_lb=force, Ft_lb=force * vib.transmissibility(eta, zeta),
        Ft_res_lb=force / eta**2 * vib.transmissibility(1.0, zeta),
    )  # fmt: skip


def test_fan_on_damped_isolators():
    of = case("solutioninn-fan-45kg")["inputs"]
    fan = found(
        f"  mass: {of['m']} kg\n  damping_ratio: {of['zeta']}\n  transmissibility: {of['TR']}\n"
        f"  force: 1 N\n  speed: {of['N']} rpm\n"
    )
    agrees("solutioninn-fan-45kg", r2=fan.s.number("needed") ** 2, k=fan.body.stiffness)


def test_damper_without_a_spring():
    """The second number of the case is a search over a coarse grid: a search as fine finds the closed form."""
    of = case("lanchester-damper-mu1")
    agrees("lanchester-damper-mu1", zeta_opt=vib.lanchester_ratio(of["inputs"]["mu"]))
    main = Body(1.0, 1.0)

    def height(zeta):
        return vib.greatest(main, Body(1.0, 0.0, 2 * zeta), np.linspace(0.3, 1.3, 4001))[1]

    grid = [0.2865 + 0.001 * k for k in range(5)]
    assert min(grid, key=height) == pytest.approx(of["recomputed"]["zeta_opt_numeric"], abs=1e-9)
