"""The motion of a machine over a stated time from a stated speed, by the ways a user might choose.

    dφ/dt = ω,   dω/dt = (M(φ, ω, t) − J′(φ) ω²/2)/J(φ)

What is compared is where the machine is at the end of the time, and how fast. The energy integral holds where the
moments depend on the angle alone. Fixed steps are as many as are asked for; the others choose their own by a tolerance:
explicit ones (DOP853), implicit ones (Radau), and one that changes between Adams' formulas and backward differences
(LSODA).
(Hairer, Nørsett, Wanner, Solving ordinary differential equations I, ch. II-III; II, ch. IV)
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from itertools import count as counted
from itertools import pairwise
from math import isfinite, nextafter
from typing import Any

import numpy as np

from tmm_report.mechanics.calculus.laws import TIME
from tmm_report.mechanics.calculus.ode import integrate
from tmm_report.mechanics.machine.reduced import Plant
from tmm_report.mechanics.machine.run.by_angle import by_angle
from tmm_report.mechanics.machine.run.law import run as program
from tmm_report.mechanics.machine.run.motion_law import Goal, NeverReached, Run
from tmm_report.mechanics.rivals.model import Method
from tmm_report.problems import N_, Message
from tmm_report.records import dataclass

Array = Any
Derivatives = Callable[[float, float, float], tuple[float, float]]  # of t, φ, ω: dφ/dt, dω/dt
STEPS = (100, 400, 1600)  # of the methods with fixed ones
TOLERANCES = (1e-5, 1e-7, 1e-9)
MOST = 300_000  # evaluations of the rates: a machine so stiff for its load is given up
FINEST = 1e-13  # tolerance of the reference
RUNS_AWAY = N_("the steps are too long: the speed grows without bound")


@dataclass(frozen=True, eq=False)
class StartUp:
    """A machine at the angle `phi` turned, rad, with the speed `omega`, rad/s, and what moves it for the `time`, s."""

    plant: Plant
    omega: float
    time: float
    phi: float = 0.0


@dataclass(frozen=True)
class Arrived:
    """Angle turned, rad, and speed, rad/s, at the end; `steps`: evaluations of the rates, 0 of an integral."""

    phi: float
    omega: float
    steps: int = 0


RunUpMethod = Method[StartUp, Arrived]


def scene_of(run: Run) -> StartUp:
    """A motion that the program has found, as a task for its rivals."""
    return StartUp(run.plant, float(run.omega[0]), float(run.t[-1] - run.t[0]), float(run.phi[0]))


def errors(exact: Arrived, found: Arrived) -> dict[str, float]:
    """Relative, by kind; nan of what was not found."""
    pairs = {"angle": (exact.phi, found.phi), "speed": (exact.omega, found.omega)}
    return {kind: abs(own - true) / (abs(true) or 1.0) for kind, (true, own) in pairs.items()}


def derivatives(plant: Plant) -> Derivatives:
    """The equation in differential form. Raises ArithmeticError after more evaluations than a task is worth."""
    places, laws, passing, calls = plant.places, plant.laws, plant.passing, counted()

    def rates(t: float, phi: float, omega: float) -> tuple[float, float]:
        if next(calls) > MOST:
            raise ArithmeticError(N_("too stiff: the steps become too many"))
        if not (isfinite(phi) and isfinite(omega)):
            raise ArithmeticError(RUNS_AWAY)
        J, slope, moment = places(phi)
        moment += sum(float(one.at(omega, t)) for one in laws)
        left = moment - slope * omega * omega / 2
        return omega, left / J if passing is None else float(passing.acceleration(left, J))

    return rates


# ---------------------------------------------------------------- integrals


def own(scene: StartUp, count: int) -> Arrived:
    """The program's own way: an integral where the moments allow one, else by time."""
    return _followed(program, scene)


def energy(scene: StartUp, count: int) -> Arrived:
    """J ω²/2 = T₀ + ∫M dφ, dt = dφ/ω."""
    return _followed(by_angle, scene)


def _followed(way: Callable[[Plant, float, Goal, float], Run], scene: StartUp) -> Arrived:
    try:
        found = way(scene.plant, scene.omega, Goal(time=scene.time), scene.phi)
    except NeverReached as error:
        raise ArithmeticError(N_("the machine stops before the time is over")) from error
    return Arrived(float(found.phi[-1]), float(found.omega[-1]), found.steps)


def _more_than_angle(scene: StartUp) -> Message | None:
    if scene.plant.of or scene.plant.passing is not None:
        return Message(N_("the moments depend on more than the angle: there is no integral of energy"))
    return None


# ---------------------------------------------------------------- fixed steps


def runge_kutta(scene: StartUp, count: int) -> Arrived:
    """The classical method of the fourth order with `count` equal steps."""
    rates, h = derivatives(scene.plant), scene.time / count
    y = scene.phi, scene.omega
    with np.errstate(all="ignore"):
        for k in range(count):
            y = _rk4(rates, k * h, y, h)
    return _arrived(y, 4 * count)


def adams(scene: StartUp, count: int) -> Arrived:
    """Adams, Bashforth and Moulton's method of the fourth order, predicted, evaluated, corrected, evaluated, with
    `count` equal steps; the first three by Runge and Kutta."""
    rates, h = derivatives(scene.plant), scene.time / count
    y = scene.phi, scene.omega
    with np.errstate(all="ignore"):
        f = [rates(0.0, *y)]
        for k in range(count):
            if k < 3:
                y = _rk4(rates, k * h, y, h)
            else:
                ahead = _stepped(y, h / 24, (55.0, f[-1]), (-59.0, f[-2]), (37.0, f[-3]), (-9.0, f[-4]))
                at_end = rates((k + 1) * h, *ahead)
                y = _stepped(y, h / 24, (9.0, at_end), (19.0, f[-1]), (-5.0, f[-2]), (1.0, f[-3]))
            f = [*f[-3:], rates((k + 1) * h, *y)]
    return _arrived(y, 2 * count + 10)


def _rk4(rates: Derivatives, t: float, y: tuple[float, float], h: float) -> tuple[float, float]:
    a = rates(t, *y)
    b = rates(t + h / 2, *_stepped(y, h / 2, (1.0, a)))
    c = rates(t + h / 2, *_stepped(y, h / 2, (1.0, b)))
    d = rates(t + h, *_stepped(y, h, (1.0, c)))
    return _stepped(y, h / 6, (1.0, a), (2.0, b), (2.0, c), (1.0, d))


def _stepped(
    y: tuple[float, float], h: float, *terms: tuple[float, tuple[float, float]]
) -> tuple[float, float]:
    """y + h Σ weight·rate."""
    return (
        y[0] + h * sum(weight * rate[0] for weight, rate in terms),
        y[1] + h * sum(weight * rate[1] for weight, rate in terms),
    )


def _arrived(y: tuple[float, float], steps: int) -> Arrived:
    if not (isfinite(y[0]) and isfinite(y[1])):
        raise ArithmeticError(RUNS_AWAY)
    return Arrived(*y, steps)


# ---------------------------------------------------------------- steps by a tolerance


def by_tolerance(
    scene: StartUp, count: int, method: str, relative: float, marks: tuple[float, ...] = ()
) -> Arrived:
    """scipy's integrators; `marks`: times over which no step leads, s."""
    rates = derivatives(scene.plant)
    y, steps = np.array([scene.phi, scene.omega]), 0
    with np.errstate(all="ignore"):
        for begin, end in pairwise([0.0, *marks, scene.time]):
            found = integrate(
                partial(_within, rates, nextafter(end, begin)), y, (begin, end), method=method,
                relative=relative, absolute=relative / 100,
            )  # fmt: skip
            y, steps = found.y[:, -1], steps + found.steps
    return _arrived((float(y[0]), float(y[1])), steps)


def _within(rates: Derivatives, last: float, t: float, y: Array) -> tuple[float, float]:
    """Of a stretch: where a moment by time jumps at its end, its earlier side holds up to there."""
    return rates(min(t, last), float(y[0]), float(y[1]))


def reference(scene: StartUp) -> Arrived:
    """What the others are measured by: DOP853 as fine as doubles allow, from kink to kink of the moments by time."""
    times = {x for one in scene.plant.laws for x in one.breaks(TIME) if 0 < x < scene.time}
    return by_tolerance(scene, 0, "DOP853", FINEST, tuple(sorted(times)))


def _of_tolerance(key: str, title: str, method: str) -> tuple[RunUpMethod, ...]:
    return tuple(
        Method(
            f"{key}_{tolerance:.0e}".replace("e-0", "e-"),
            title,
            partial(by_tolerance, method=method, relative=tolerance),
            settings=f"{tolerance:.0e}".replace("e-0", "e-"),
            counted=False,
        )
        for tolerance in TOLERANCES
    )


RUN_UPS: tuple[RunUpMethod, ...] = (
    Method(
        "program", N_("integrals where the moments allow, else steps and collocation"), own, counted=False
    ),
    Method("energy", N_("integral of energy"), energy, _more_than_angle, counted=False),
    Method("runge_kutta", N_("Runge–Kutta of the fourth order, equal steps"), runge_kutta),
    Method("adams", N_("Adams–Bashforth–Moulton of the fourth order, equal steps"), adams),
    *_of_tolerance("lsoda", N_("LSODA: Adams and backward differences"), "LSODA"),
    *_of_tolerance("dop853", N_("DOP853: Runge–Kutta of the eighth order"), "DOP853"),
    *_of_tolerance("radau", N_("Radau: implicit Runge–Kutta of the fifth order"), "Radau"),
)
