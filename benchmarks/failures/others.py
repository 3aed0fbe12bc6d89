"""Failing scenes of other families: stiff start-ups, and the inverse involute at its ends."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np
from mpmath import mp

from benchmarks.failures.judge import REFUSED, RIGHT, WRONG, Cell
from benchmarks.failures.truth import SLACK
from tmm_report import course, loading
from tmm_report.mechanics.rivals.involutes import INVOLUTES
from tmm_report.mechanics.rivals.run_up import RUN_UPS, Arrived, StartUp, errors

STEPS = 400  # of the methods with equal ones
TOLERANCE = 1e-7  # of the others
LOOSE = 1e3  # times its tolerance: what an integrator's result may be off

# ---------------------------------------------------------------- start-ups

SHAFT = """
dynamics:
  parts: [{{name: rotor, inertia: {inertia} kg*m^2}}]
  motor: {{shunt: {{moment: 60 N*m, speed: 1470 rpm, no_load: 1500 rpm}}}}
  resistance: [{{by_time: [[0 s, 10 N*m], [2 s, 10 N*m]]}}]
  start: {{time: 1 s}}
"""
INERTIAS = {"0.26 s": 5.0, "2.6 ms": 0.05, "0.1 ms": 0.002, "0.5 µs": 1e-5}  # time constant -> kg m²
TIME = 1.0


def start_ups() -> Iterator[tuple[str, dict[str, Cell]]]:
    """A rotor against a constant load, by time constants: ω = ω∞ (1 − exp(−t/τ)) exactly."""
    usual: dict[str, float] = {}
    for name, inertia in INERTIAS.items():
        found = course.solve(loading.loads(SHAFT.format(inertia=inertia))).dynamics
        assert found is not None
        scene = StartUp(found.supplied, 0.0, TIME)
        yield (
            f"start-up, τ = {name} of 1 s",
            {
                method.key: _arrived(scene, method, inertia, usual)
                for method in RUN_UPS
                if method.refuses(scene) is None and (not method.settings or method.settings == "1e-7")
            },
        )


def _exact(inertia: float) -> Arrived:
    with mp.workdps(40):
        slip = mp.mpf(1500 - 1470) * mp.pi / 30
        no_load = mp.mpf(1500) * mp.pi / 30
        tau = inertia * slip / 60
        end = no_load - slip / 6
        gone = mp.e ** (-TIME / tau)
        return Arrived(float(end * (TIME - tau * (1 - gone))), float(end * (1 - gone)))


def _arrived(scene: StartUp, method: object, inertia: float, usual: dict[str, float]) -> Cell:
    key = method.key  # type: ignore[attr-defined]
    try:
        found = method.run(scene, STEPS)  # type: ignore[attr-defined]
    except ArithmeticError as error:
        return Cell(REFUSED, word=str(error))
    off = max(errors(_exact(inertia), found).values())
    slack = max(SLACK, 10 * usual.setdefault(key, off), LOOSE * TOLERANCE if "1e-7" in key else 0.0)
    if not math.isfinite(off):
        return Cell(REFUSED, word="nan")
    return Cell(RIGHT if off <= slack else WRONG, off)


# ---------------------------------------------------------------- the inverse involute

ANGLES = {
    "0": 0.0, "1e-9 rad": 1e-9, "1e-5 rad": 1e-5, "1°": math.radians(1), "20°": math.radians(20),
    "80°": math.radians(80), "89.99°": math.radians(89.99), "90° − 1e-9 rad": math.pi / 2 - 1e-9,
    "90° − 1e-15 rad": math.pi / 2 - 1e-15,
}  # fmt: skip


def involutes() -> Iterator[tuple[str, dict[str, Cell]]]:
    """α of inv α = v, for the double v nearest to the involute function of these angles."""
    for name, angle in ANGLES.items():
        v, exact = _involute(angle)
        yield (
            f"inverse involute at {name}",
            {
                method.key: _found(float(np.ravel(method.run(np.array([v]), 1))[0]), exact)
                for method in INVOLUTES
            },
        )


def _involute(angle: float) -> tuple[float, float]:
    """The double v, and the angle whose involute function it is exactly."""
    if not angle:
        return 0.0, 0.0
    with mp.workdps(60):
        v = float(mp.tan(mp.mpf(angle)) - mp.mpf(angle))
        near = mp.mpf(angle) * (1 - mp.mpf(10) ** -18), mp.mpf(angle)
        exact = mp.findroot(lambda a: mp.tan(a) - a - mp.mpf(v), near, tol=mp.mpf(10) ** -90, verify=False)
        return v, float(exact)


def _found(value: float, exact: float) -> Cell:
    if not math.isfinite(value):
        return Cell(REFUSED, word="nan")
    off = abs(value - exact) / (exact or 1.0)
    return Cell(RIGHT if off <= SLACK else WRONG, off)
