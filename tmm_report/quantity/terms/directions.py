"""Directions, coordinates and senses in words."""

from __future__ import annotations

import numpy as np

from tmm_report.problems import N_, Message

COMPASS = {1: N_("to the right"), -1: N_("to the left"), 1j: N_("upwards"), -1j: N_("downwards")}
X_OF, Y_OF = N_("x coordinate of point %(name)s"), N_("y coordinate of point %(name)s")
CLOCKWISE, COUNTER_CLOCKWISE = N_("clockwise"), N_("counter-clockwise")


def direction(way: complex) -> Message:
    """Of a unit vector: by the compass, else by its angle."""
    for unit, word in COMPASS.items():
        if abs(way - unit) < 1e-9:
            return Message(word)
    return Message(N_("at %(angle)s° to the x axis"), {"angle": f"{np.degrees(np.angle(way)):.4g}"})


def sense(way: float) -> Message:
    return Message(COUNTER_CLOCKWISE if way > 0 else CLOCKWISE)
