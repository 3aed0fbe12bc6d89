"""Every formula of a main link that slides in another way: sums over the samples of the motion."""

import numpy as np
import pytest
from conftest import solved
from twice import disagreements

from tmm_report import course, loading

UNIFORM = """
travel:
  from: 0.1 m
  to: 0.5 m
  mass: 25 kg
  rise: 15 deg
  speed: 0.8 m/s
  wheels: [{inertia: 0.02 kg*m^2, radius: 60 mm}]
  driving: [{constant: 500 N}]
  resistance: [{constant: 60 N}]
"""
STOPS = UNIFORM.replace("driving: [{constant: 500 N}]", "driving: [{constant: 10 N}]")
COASTS = "travel: {to: 0.5 m, mass: 4 kg, speed: 2 m/s}\n"


@pytest.mark.parametrize(
    "text", ["steam_hammer", UNIFORM, STOPS, COASTS], ids=["hammer", "uniform", "stops", "coasts"]
)
def test_every_formula_agrees_with_the_second_way(text):
    found = (solved(text) if "\n" not in text else course.solve(loading.loads(text))).travel
    assert disagreements(found.s, _ways(found)) == []


def _ways(found):
    """By the energies, by the mean speed of a uniform acceleration, by the fall of the weight's height."""
    given, s = found.given, found.s
    own = 2 * found.whole.plant.inertia.flat[0] * found.whole.turn**2
    ways = {"length": np.hypot(found.whole.end - found.whole.begin, 0), "m_red": own / 2}
    if given.rise is not None:
        high = 0.0 - 1.0 * np.cos(np.pi / 2 - given.rise)  # of a metre of the way
        ways["weight"] = given.mass * given.gravity * high
    if found.whole.even:
        works = sum(found.motion.works.values())
        ways["a"] = works / s.number("way") / (own / 2)
        ways["v_end"] = 0.0 if found.stops else np.sqrt(given.speed**2 + 4 * works / own)
        ways["t_end"] = 2 * s.number("way") / (given.speed + ways["v_end"])
    return ways
