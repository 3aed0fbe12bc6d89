"""Mechanisms with wheels balanced on their foundation: a wheel is a part of its link, teeth are forces inside.

Drawn at random; momenta by a solver that shares no code, and the common mass centre of links and counterweights.
"""

from functools import cache

import numpy as np
import pytest
from test_planets import KINDS, Alone, at, centre, finished, poses, rolls, text

from tmm_report import course, loading
from tmm_report.mechanics.lever.motion import solve as motion_at

CASES = [(kind, seed) for kind in KINDS for seed in (range(4) if kind is not rolls else (1, 2, 4, 6))]
every = pytest.mark.parametrize(
    ("kind", "seed"), CASES, ids=[f"{kind.__name__} {seed}" for kind, seed in CASES]
)


@cache
def solved(kind, seed):
    rng = np.random.default_rng(700 + seed)
    made = finished(kind(rng), rng)
    weights = ", ".join(f"{link}: {{distance: 50 mm}}" for link in made["links"])
    block = f"\nbalancing: {{methods: [full, pivoted, optimum], counterweights: {{{weights}}}}}\n"
    return made, course.solve(loading.loads(text(made) + block))


def momenta(made, linkage, phi):
    """Momentum and its moment about the frame's origin at angles of the driving link, (P,), by constraints alone."""
    motion = motion_at(linkage, phi)
    there, found = poses(made, motion), []
    for k in range(len(phi)):
        alone = Alone(made, at(there, k))
        q = alone.rates()
        momentum, spin = 0j, 0.0
        for n, name in enumerate(made["links"]):
            x, y, w = q[3 * n : 3 * n + 3]
            place = alone.place(name, centre(made, name))
            part = made["m"][name] * (complex(x, y) + 1j * w * (place - alone.pose[name][0]))
            momentum += part
            spin += (np.conj(place) * part).imag + made["J"][name] * w
        found.append((momentum, spin))
    return np.array(found, complex).T


@every
def test_shaking_is_what_the_momenta_lose(kind, seed):
    made, results = solved(kind, seed)
    found, motion, h = results.balancing, results.lever.kinematics.table, 1e-4
    around = {way: momenta(made, motion.linkage, motion.phi + way * h) for way in (-2, -1, 1, 2)}
    lost = -made["omega"] * (around[-2] - 8 * around[-1] + 8 * around[1] - around[2]) / (12 * h)
    force, moment = found.original.table.force, found.original.table.moment
    about = complex(results.lever.kinematics.linkage.mechanism.links["0"].points[found.about])
    expected = lost[1].real - (np.conj(about) * lost[0]).imag
    assert force == pytest.approx(lost[0], abs=1e-6 * np.abs(force).max())
    assert moment == pytest.approx(expected, abs=1e-6 * np.abs(moment).max())
    assert found.original.check < 1e-9  # and by the reactions of the frame, teeth and rails among them


@every
def test_full_balance_holds_the_common_mass_centre(kind, seed):
    """Of the links as they are drawn and the counterweights that are fixed to them; a rack that slides hangs on no
    pivot, and no counterweight follows it."""
    made, results = solved(kind, seed)
    if "7" in made["links"]:
        assert results.balancing.unreached == ("7",)
        assert "full" not in [one.name for one in results.balancing.cases]
        return
    case = next(one for one in results.balancing.cases if one.name == "full")
    assert results.balancing.complete(case)
    motion = results.lever.kinematics.table
    there = poses(made, motion)
    sums = []
    for k in range(len(motion.phi)):
        alone = Alone(made, at(there, k))
        own = sum(made["m"][name] * alone.place(name, centre(made, name)) for name in made["links"])
        more = sum(w.mass * (alone.pose[w.link][0] + np.exp(1j * alone.pose[w.link][1])
                             * w.at) for w in case.weights)  # fmt: skip
        sums.append(own + more)
    assert np.ptp(np.real(sums)) < 1e-9 * sum(made["m"].values())
    assert np.ptp(np.imag(sums)) < 1e-9 * sum(made["m"].values())


@every
def test_counterweights_of_pivoted_links_leave_less(kind, seed):
    _, results = solved(kind, seed)
    found = results.balancing
    optimum = next(one for one in found.cases if one.name.startswith("optimum"))
    assert optimum.force_rms <= found.original.force_rms * (1 + 1e-12)
