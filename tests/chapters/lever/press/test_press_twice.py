"""Each formula of a press a second time, by the motion of the mechanism alone."""

import numpy as np
from conftest import solved
from twice import disagreements

from tmm_report.mechanics.calculus.vectors import dot


def test_every_formula_has_a_second_way():
    lever = solved("knuckle_press").lever
    found, given = lever.press, lever.press.given
    cycle, omega = lever.kinematics.cycle, 2 * np.pi
    dead = found.dead

    def place(turned):
        return -dot(cycle.motion(np.asarray(turned, float)).place("D"), 1j)

    def speed(turned):
        return -dot(cycle.motion(np.asarray(turned, float)).velocity("D"), 1j)

    lowest = float(place([dead])[0])
    fastest = speed(np.linspace(0, dead, 400001)).max()
    edges = [dead + sign * x for sign, x in ((-1, found.s.number("before")), (1, found.s.number("after")))]
    assert np.allclose(lowest - place(edges), given.within, rtol=1e-9)
    times = [(dead - found.s.number(key)) / omega for key in ("alpha_1", "alpha_2")]
    assert np.allclose(lowest - place(np.array(times) * omega), given.working, rtol=1e-9)
    mean = float(np.diff(place(np.array(times) * omega))[0] / np.diff(times)[0])
    within = speed(np.linspace(*times, 200001) * omega)
    ways = {
        "F_least": given.torque * omega / fastest,  # by the power
        "h_nom": given.torque * omega / given.rated / omega,
        "dwell": edges[1] - edges[0],
        "t_dwell": (edges[1] - edges[0]) / omega,
        "t_working": times[1] - times[0],
        "v_mean": mean,
        "peak": within.max() / mean,
        "unevenness": np.ptp(within) / mean,
    }
    assert disagreements(found.s, ways, 1e-8) == []
