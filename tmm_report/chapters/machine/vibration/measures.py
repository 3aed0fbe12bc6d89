"""A base that gives way under the isolators; an absorber on the machine, and the damper without a spring."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from tmm_report.chapters.machine.vibration import mistakes
from tmm_report.chapters.machine.vibration.given import Given
from tmm_report.mechanics.calculus.distinct import distinct
from tmm_report.mechanics.masses import vibration as vib
from tmm_report.mechanics.masses.vibration import Body
from tmm_report.records import dataclass

Array = Any
SPAN = 2.5  # ω/ω0 up to which at least the greatest amplitude is looked for


@dataclass(frozen=True, eq=False)
class Stood:
    """`base`: the mass under the isolators on its own springs; `machine`, `under`: complex amplitudes by 1 N of force;
    `natural`: both natural frequencies, rad/s; `grounded`: force on the ground by the exciting one."""

    base: Body
    machine: complex
    under: complex
    natural: tuple[float, float]
    grounded: float


def stood(given: Given, body: Body, omega: float) -> Stood:
    stand = given.foundation
    assert stand is not None
    base = Body(stand.inertia, stand.stiffness, stand.damping)
    with np.errstate(divide="ignore", invalid="ignore"):
        under, machine = vib.pair(base, body, omega, (0.0, 1.0))
    low, high = vib.pair_natural(base, body)
    grounded = abs(complex(vib.through(base, omega) * under))
    return Stood(base, complex(machine), complex(under), (float(low), float(high)), grounded)


@dataclass(frozen=True, eq=False)
class Fitted:
    """A machine with something hung on it: `hung`; `work`, `swing`: amplitudes of both at work by 1 N of force; `eta`,
    `beta`: where its amplitude is greatest, against the machine alone without damping, and how great."""

    key: str
    hung: Body
    work: float
    swing: float
    eta: float
    beta: float

    @property
    def natural(self) -> float:
        """Own frequency, rad/s."""
        return float(self.hung.natural)

    @property
    def ratio(self) -> float:
        """Damping in parts of its own critical one."""
        return float(self.hung.ratio)


@dataclass(frozen=True, eq=False)
class Absorbed:
    """`mu`: ratio of the mass of the absorber to that of the machine; `natural`: both frequencies with the tuned one,
    rad/s; `fitted`: tuned, with the best damping, the damper without a spring."""

    mu: float
    natural: tuple[float, float]
    fitted: tuple[Fitted, ...]

    @property
    def tuned(self) -> Fitted:
        return self.fitted[0]


def absorbed(given: Given, body: Body, omega: float) -> Absorbed:
    mu = _share(given, body, omega)
    main = body._replace(damping=0.0)
    hung = {
        "tuned": vib.tuned(main, mu, omega),
        "best": vib.best_absorber(main, mu),
        "lanchester": vib.lanchester(main, mu),
    }
    low, high = vib.pair_natural(main, hung["tuned"])
    over = _over(float(main.natural), (float(low), float(high)))
    fitted = tuple(_fitted(key, body, one, omega, over) for key, one in hung.items())
    return Absorbed(mu, (float(low), float(high)), fitted)


def _share(given: Given, body: Body, omega: float) -> float:
    stated = given.absorber
    assert stated is not None
    if stated.inertia is not None:
        return stated.inertia / body.inertia
    assert stated.clear is not None
    share = vib.share_clear(float(body.natural), omega, stated.clear)
    if not share > 0:
        raise mistakes.unneeded()
    return share


def _over(natural: float, pair: tuple[float, float]) -> Array:
    """ω/ω0 among which the greatest amplitude is looked for: dense about both natural frequencies of the tuned one,
    of narrow peaks."""
    near = np.linspace(0.95, 1.05, 1001)
    return distinct([*np.linspace(0.02, SPAN, 2481), *np.outer(np.divide(pair, natural), near).ravel()])


def _fitted(key: str, body: Body, hung: Body, omega: float, over: Array) -> Fitted:
    with np.errstate(divide="ignore", invalid="ignore"):
        work, swing = vib.pair(body, hung, omega, (1.0, 0.0))
        eta, beta = vib.greatest(body, hung, over)
    return Fitted(
        key, hung, abs(complex(work)), abs(complex(swing)), eta, beta if _damped(body, hung) else math.inf
    )


def _damped(body: Body, hung: Body) -> bool:
    """Whether anything damps: else the amplitude is greatest at no finite value."""
    return bool(body.damping > 0 or hung.damping > 0)
