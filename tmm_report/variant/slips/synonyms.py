"""Keys by other names than the format has for them, as textbooks and other programs call them."""

from __future__ import annotations

from collections.abc import Collection

_SYNONYMS = {
    "viscosity": "damping, damping_coefficient, resistance, b",
    "stiffness": "rate, spring_rate, spring_constant, c, k",
    "free_length": "l0, rest_length, natural_length",
    "preload": "pretension, initial_force",
    "between": "points, ends, joints",
    "on": "at, link",
    "at": "on, point",
    "constant": "value, magnitude, force, moment",
    "by_displacement": "by_stroke, diagram, indicator",
    "by_angle": "angles, by_phi",
    "components": "xy, vector, projections",
    "inertia": "J, I, moment_of_inertia",
    "mass_centre": "mass_center, centre_of_mass, center_of_mass, cog",
    "mass": "m, weight",
    "speed": "omega, rpm, n, angular_velocity, velocity",
    "teeth": "z, tooth_numbers",
    "module": "m",
    "ratio": "i, u, gear_ratio, lambda",
    "stroke": "H, travel",
    "swing": "psi, angle_of_swing",
    "K": "time_ratio, k, quick_return",
    "offset": "e, eccentricity",
    "rocker": "c, l3",
    "crank": "a, r, l1",
    "rod": "b, l, l2, coupler",
    "frame": "d, a0, distance, l0",
    "pressure_angle": "gamma, pressure",
    "transmission": "mu, transmission_angle, gamma_min",
    "points": "pins",
    "y": "function, f",
    "x": "range, argument",
    "slider_crank": "crank_slider, slider, crank_and_slider",
    "crank_rocker": "rocker_crank, four_bar, fourbar, crank_and_rocker",
    "slotted_link": "shaper, quick_return, swinging_guide",
    "turning_guide": "whitworth, turning_link, rotating_guide",
    "function": "function_generator, generator",
    "body": "rigid_body, poses, coupler_positions",
    "dwell": "dwell_mechanism, rest",
    "so_that": "demand, target, equals, to_be",
    "unknown": "find, seek, variable, parameter",
}


def meant(key: str, known: Collection[str]) -> str | None:
    """The one of the known keys that another name stands for."""
    found = [word for word, names in _SYNONYMS.items() if word in known and key in names.split(", ")]
    return found[0] if len(found) == 1 else None
