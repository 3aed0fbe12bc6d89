"""Published examples of balancing, through the chapters of the rotor and of the engine and through their mechanics.

The books of pounds and inches are taken as they are: a mass of 200 lb is stated as 200 kg, an inch as a millimetre,
where only ratios are asked; a force is turned into pounds with the book's g = 32.2 ft/s².
"""

from __future__ import annotations

import numpy as np
import pytest
from cases import agrees, case

from tmm_report import course, loading
from tmm_report.mechanics.masses import engine_cylinders, rotor

FOOT, INCH, G = 0.3048, 0.0254, 32.2  # m, m, ft/s²
RPM = np.pi / 30


def solved(text: str) -> course.Results:
    return course.solve(loading.loads(text))


def pounds(force: float) -> float:
    """Of a force in N of masses that are pounds stated as kilograms."""
    return force / FOOT / G


# --- one plane


def test_one_plane_as_a_variant():
    of = case("sarkar-8-1-one-plane")["inputs"]
    masses = ", ".join(f"{{mass: {m} kg, radius: {r} mm, angle: {angle} deg}}" for m, r, angle in of["mrA"])
    found = solved(f"rotor: {{masses: [{masses}], planes: [{{radius: {of['R']} mm}}]}}").rotor
    weight = found.corrections[0]
    agrees(
        "sarkar-8-1-one-plane",
        mb=weight.mass,
        angle_deg=np.degrees(weight.angle),
        resultant_deg=np.degrees(np.angle(found.resultant)) % 360,
    )


def test_one_plane_by_the_products():
    of = case("sarkar-8-1-one-plane")["inputs"]
    products = np.array([m * r * np.exp(1j * np.radians(angle)) for m, r, angle in of["mrA"]])
    needed = rotor.corrections(products, np.zeros(4), np.zeros(4), [0.0])[0]
    agrees("sarkar-8-1-one-plane", mb=abs(needed) / of["R"], angle_deg=np.degrees(np.angle(needed)) % 360)


# --- two planes


def in_two_planes(at: float) -> tuple[float, float]:
    """Weights in the far and in the near plane; the mass stands at `at` from the near one, + towards the far one."""
    of = case("bevan-14-1-two-planes")["inputs"]
    mass = f"{{mass: {of['W']} kg, radius: {of['r']} mm, angle: 0, at: {at} mm}}"
    planes = f"[{{at: 0, radius: {of['b']} mm}}, {{at: {of['d']} mm, radius: {of['b']} mm}}]"
    near, far = solved(f"rotor: {{masses: [{mass}], planes: {planes}}}").rotor.corrections
    assert near.angle == pytest.approx(np.pi)
    return far.mass, near.mass


def test_one_weight_in_two_planes_outside_and_inside():
    of = case("bevan-14-1-two-planes")["inputs"]
    far_out, near_out = in_two_planes(-of["l"])
    far_in, near_in = in_two_planes(of["l"])
    agrees("bevan-14-1-two-planes", Bfar_out=far_out, Bnear_out=near_out, Bfar_in=far_in, Bnear_in=near_in)


# --- a part of the reciprocating mass


def test_part_of_the_reciprocating_mass_is_balanced():
    of = case("bevan-14-5-partial")["inputs"]
    found = solved(
        f"engine: {{speed: {of['N']} rpm, crank_radius: {of['r_in'] * INCH} m, rod_length: 1 m, "
        f"reciprocating: {of['R']} kg, rotating: {of['W']} kg, inline: {{cranks: [0]}}, "
        f"counterweights: {{share: {of['c']}, radius: {of['b_in'] * INCH} m}}}}"
    ).engine
    force, _ = found.primary
    agrees("bevan-14-5-partial", B_lb=found.s.number("m_cw"), U_lb=pounds(force.along(1j)))


# --- a locomotive


def test_a_locomotive_as_a_lying_engine_of_two_cylinders():
    of = case("sarkar-12-3-locomotive")["inputs"]
    found = solved(
        f"engine: {{speed: {of['N']} rpm, crank_radius: {of['r']} m, rod_length: 1.5 m, "
        f"reciprocating: {of['mR']} kg, counterweights: {{share: {of['c']}, radius: 0.6 m}}, "
        f"inline: {{cranks: [0, 90 deg], spacing: {of['a']} m, bank: 90 deg}}}}"
    ).engine
    force, couple = found.primary
    agrees("sarkar-12-3-locomotive", T_N=force.along(1.0), S_Nm=couple.along(1.0), c=found.s.number("share"))
    assert force.along(1j) == pytest.approx(of["c"] * found.unit * np.sqrt(2))  # up and down, of both sides


def test_a_locomotive_by_its_formulas():
    of = case("sarkar-12-3-locomotive")["inputs"]
    found = engine_cylinders.locomotive(of["mR"], of["r"], of["N"] * RPM, of["c"], of["a"])
    agrees("sarkar-12-3-locomotive", T_N=found.traction, S_Nm=found.swaying)
    assert found.hammer == pytest.approx(of["c"] * of["mR"] * of["r"] * (of["N"] * RPM) ** 2)


# --- a star


def test_a_star_of_three_cylinders():
    of = case("bevan-14-12-radial-3")["inputs"]
    banks = ", ".join(f"{{bank: {bank} deg}}" for bank in of["banks_deg"])
    found = solved(
        f"engine: {{speed: {of['N']} rpm, crank_radius: {of['stroke_in'] / 2 * INCH} m, "
        f"rod_length: {of['l_in'] * INCH} m, reciprocating: {of['R_lb']} kg, cylinders: [{banks}], "
        f"counterweights: {{share: 0.5, radius: {of['b_in'] * INCH} m}}}}"
    ).engine
    force, _ = found.primary
    assert force.greatest == pytest.approx(0.0, abs=1e-9 * found.unit)  # one weight balances order 1
    second = found.second.force
    assert abs(second.forward) == 0.0  # it turns against the crankshaft
    agrees(
        "bevan-14-12-radial-3",
        B_lb=3 * found.s.number("m_cw"),
        F2_max=pounds(second.greatest),
        F2_min=pounds(second.least),
    )
