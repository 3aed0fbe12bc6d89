"""Friction in single pairs in closed form: planes and wedges, screws, pivots, belts, wheels, journals.

Numbers or arrays that broadcast; SI, angles in radians. Sources: Artobolevsky, Theory of mechanisms and machines,
ch. 11; Khurmi, Gupta, Theory of machines, ch. 10–11; Bevan, The theory of machines, ch. 6.
"""

from __future__ import annotations

from typing import Any

import numpy as np

Value = Any  # a number or an array


def angle(f: Value) -> Value:
    """Angle of friction, half the angle of the cone: φ = arctan f. A plane steeper than it does not hold a body."""
    return np.arctan(f)


# ---------------------------------------------------------------- planes and wedges


def up_plane(load: Value, slope: Value, phi: Value) -> Value:
    """Level force that moves a body up a plane, N: Q tan(α + φ). It grows without bound at α + φ = 90°."""
    return load * np.tan(slope + phi)


def down_plane(load: Value, slope: Value, phi: Value) -> Value:
    """Level force that lets a body down a plane at constant speed, N: Q tan(α − φ); negative: it must be pulled."""
    return load * np.tan(slope - phi)


def up_plane_along(load: Value, slope: Value, phi: Value) -> Value:
    """Force along the plane that moves a body up, N: Q sin(α + φ)/cos φ."""
    return load * np.sin(slope + phi) / np.cos(phi)


def down_plane_along(load: Value, slope: Value, phi: Value) -> Value:
    """Force along the plane that lets a body down, N: Q sin(α − φ)/cos φ; negative: it must be pulled."""
    return load * np.sin(slope - phi) / np.cos(phi)


def wedge(load: Value, slope: Value, face: Value, base: Value) -> Value:
    """Force that drives a wedge under a load guided upright, N: Q [tan(α + φ1) + tan φ2]; angles of friction of the
    sloping face and of the base."""
    return load * (np.tan(slope + face) + np.tan(base))


def wedge_out(load: Value, slope: Value, face: Value, base: Value) -> Value:
    """Force that holds a wedge against the load, N: Q [tan(α − φ1) − tan φ2]; negative: it must be pulled out."""
    return load * (np.tan(slope - face) - np.tan(base))


def guided_pair(between: Value, face: Value, phi: Value) -> Value:
    """Efficiency of two guided sliders, one of which drives the other over a sloping face: directions of the sliders
    `between` each other, the normal of the face at `face` to the driving one; `phi`: the angles of friction of face
    and guides together. η = cos α cos(θ − α + Φ)/[cos(θ − α) cos(α − Φ)], from the equilibrium of both."""
    turned = np.cos(face) * np.cos(between - face + phi)
    return turned / (np.cos(between - face) * np.cos(face - phi))


def best_face(between: Value, phi: Value) -> Value:
    """The face for the greatest efficiency of two guided sliders: α = (θ + Φ)/2."""
    return (between + phi) / 2


def best_guided_pair(between: Value, phi: Value) -> Value:
    """The greatest efficiency: [cos((θ + Φ)/2)/cos((θ − Φ)/2)]²."""
    return (np.cos((between + phi) / 2) / np.cos((between - phi) / 2)) ** 2


def pulled_and_pushed(pull: Value, push: Value, slope: Value) -> tuple[Value, Value]:
    """Coefficient of friction and weight of a body that one force at `slope` above the level just pulls and one at
    `slope` below it just pushes: f = (P2 − P1)/[(P1 + P2) tan θ], G = P1 (cos θ/f + sin θ)."""
    f = (push - pull) / ((pull + push) * np.tan(slope))
    return f, pull * (np.cos(slope) / f + np.sin(slope))


# ---------------------------------------------------------------- screws


def lead_angle(lead: Value, diameter: Value) -> Value:
    """ψ = arctan(h/(π d2)). `lead`: pitch times starts; `diameter`: mean, of the thread."""
    return np.arctan(lead / (np.pi * diameter))


def reduced_angle(f: Value, profile: Value) -> Value:
    """Angle of friction of a thread whose flank leans by `profile` from square: φ' = arctan(f/cos β)."""
    return np.arctan(f / np.cos(profile))


def screw_moment(load: Value, diameter: Value, psi: Value, phi: Value) -> Value:
    """Moment that raises a load by a screw, N m: Q d2/2 tan(ψ + φ')."""
    return load * diameter / 2 * np.tan(psi + phi)


def lowering_moment(load: Value, diameter: Value, psi: Value, phi: Value) -> Value:
    """Moment that lowers the load, N m: Q d2/2 tan(φ' − ψ); negative: the screw runs back by itself."""
    return load * diameter / 2 * np.tan(phi - psi)


# ---------------------------------------------------------------- pivots


def pivot_pressure(load: Value, f: Value, outer: Value, inner: Value, half_cone: Value) -> Value:
    """Moment of friction of a pivot under uniform pressure, N m: (2/3) f Q (R³ − r³)/[(R² − r²) sin α]."""
    radius = 2 / 3 * (outer**3 - inner**3) / (outer**2 - inner**2)
    return f * load * radius / np.sin(half_cone)


def pivot_wear(load: Value, f: Value, outer: Value, inner: Value, half_cone: Value) -> Value:
    """Moment of friction of a run-in pivot, of which every place wears alike, N m: f Q (R + r)/(2 sin α)."""
    return f * load * (outer + inner) / 2 / np.sin(half_cone)


def friction_circle(f: Value, diameter: Value) -> Value:
    """Radius of the friction circle of a journal, m: ρ = f d/2. The reaction is tangent to it."""
    return f * diameter / 2


def tilted_rod(rod: Value, crank: Value, circles: Value, length: Value) -> Value:
    """Angle of the force in a connecting rod with the line of the stroke, rad: that of the rod less what both friction
    circles turn it, sin δ = (ρ2 ± ρ3)/l. `circles`: ρ2 + ρ3 while the rod swings out, ρ2 − ρ3 while it swings back."""
    return np.arcsin(crank * np.sin(rod) / length) - np.arcsin(circles / length)


def crank_moment(force: Value, turned: Value, crank: Value, tilt: Value, circles: Value) -> Value:
    """Moment on a crank of the force that comes through a rod tilted by `tilt`, N m: P/cos τ [r sin(φ + τ) − ρ1 − ρ2].
    `circles`: the sum of the radii of the friction circles of shaft and crank pin."""
    return force / np.cos(tilt) * (crank * np.sin(turned + tilt) - circles)


# ---------------------------------------------------------------- belts


def grooved(f: Value, half_groove: Value) -> Value:
    """Coefficient of friction in a V-groove: f' = f/sin γ; γ = 90° is a flat pulley."""
    return f / np.sin(half_groove)


def slack(tight: Value, f: Value, wrap: Value) -> Value:
    """Tension of the slack side where the belt is about to slip (Euler), N: T2 = T1 e^(−f' α)."""
    return tight * np.exp(-f * wrap)


def open_wrap(one: Value, other: Value, distance: Value) -> Value:
    """Angle of contact on the smaller pulley of an open belt, rad: π − 2 arcsin(|d2 − d1|/(2a))."""
    return np.pi - 2 * np.arcsin(np.abs(other - one) / (2 * distance))


def best_speed(most: Value, mass: Value) -> Value:
    """Speed at which a belt carries most power, m/s: its centrifugal tension is then a third of what it bears,
    v = √(T/(3 q)). `mass`: of a metre of the belt, kg/m."""
    return np.sqrt(most / (3 * mass))


# ---------------------------------------------------------------- wheels


def rolling_moment(load: Value, arm: Value) -> Value:
    """Moment of rolling resistance, N m: M = k N. `arm`: k, m."""
    return load * arm
