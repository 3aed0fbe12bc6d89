"""Chapter of vibration: a machine on isolators under a periodic force, how it moves and what reaches its base.

The arithmetic and its sources are in mechanics/masses/vibration.py.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from tmm_report.chapters.machine.vibration import mistakes
from tmm_report.chapters.machine.vibration.given import Given
from tmm_report.chapters.machine.vibration.measures import Absorbed, Stood, absorbed, stood
from tmm_report.chapters.machine.vibration.shaking import Shaking, shaking
from tmm_report.mechanics.masses import vibration as vib
from tmm_report.mechanics.masses.vibration import Body
from tmm_report.problems import N_, Message
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.chapters.lever.moving import Moving

__all__ = ["Found", "Given", "solve"]

Array = Any
G = 9.81  # m/s², of the static deflection
DEEPEST = 0.3  # m, which softer springs than any would give way under the weight
WORKING = (2.0, 5.0)  # ω/ω0 of well isolated machines


@dataclass(frozen=True, eq=False)
class Found:
    """Found by `solve`. `body`: the machine on all its isolators; `order`: of the harmonic that is followed in full, 1
    of a force that has but one; `omega`: its frequency, rad/s; `shaking`: of the mechanism; `stood`, `absorbed`: with a
    base that gives way, with an absorber."""

    given: Given
    body: Body
    order: int
    omega: float
    shaking: Shaking | None
    stood: Stood | None
    absorbed: Absorbed | None

    # --- the excitation

    @property
    def force(self) -> float:
        """Amplitude of the force, N or N m; of a moving base what its springs and dampers bring."""
        given = self.given
        if self.shaking is not None:
            return float(self.shaking.sizes[self.order - 1])
        if given.unbalance is not None:
            return given.unbalance.mass * given.unbalance.radius * self.omega**2
        if given.base is not None:
            return given.base * abs(complex(vib.through(self.body, self.omega)))
        return float(given.force or 0.0)

    @property
    def grows(self) -> bool:
        """Whether the force grows with the square of the speed: of an unbalance or a mechanism."""
        return self.given.unbalance is not None or self.shaking is not None

    @property
    def unbounded(self) -> bool:
        """Whether the machine alone is in resonance without damping, under one force: its amplitude has no bound."""
        one = self.shaking is None and not self.given.free
        return one and self.zeta == 0 and abs(self.eta - 1) <= mistakes.NEAR

    @property
    def growth(self) -> float:
        """Of the amplitude with every cycle of such a resonance, m or rad: of F/(2 m ω0) t. (`vib.resonant`)"""
        return math.pi * self.static

    # --- the machine on its isolators

    @property
    def zeta(self) -> float:
        return float(self.body.ratio)

    @property
    def natural(self) -> float:
        return float(self.body.natural)

    @property
    def decay(self) -> float:
        """n = b/(2m), 1/s."""
        return self.body.damping / (2 * self.body.inertia)

    @property
    def kind(self) -> str:
        """Of the free motion: it swings ("under"), or creeps back."""
        if abs(self.zeta - 1) <= vib.CRITICAL:
            return "critical"
        return "under" if self.zeta < 1 else "over"

    @property
    def damped(self) -> float | None:
        """Frequency of the free motion, rad/s, None where it does not swing."""
        return math.sqrt(self.natural**2 - self.decay**2) if self.kind == "under" else None

    @property
    def creep(self) -> float | None:
        """q = √(n² − ω0²) of a motion that creeps, rad/s."""
        return math.sqrt(self.decay**2 - self.natural**2) if self.kind == "over" else None

    @property
    def constants(self) -> tuple[float, float]:
        """C1, C2 of the free motion e^{−nt}(C1 C + C2 S): C, S are cos, sin ω_d t; 1, t; or cosh, sinh qt."""
        one = self.given.place - self.phasor.imag
        other = self.given.speed - self.omega * self.phasor.real + self.decay * one
        return one, other / (self.damped or self.creep or 1.0)

    @property
    def eta(self) -> float:
        return self.omega / self.natural

    @property
    def isolates(self) -> bool:
        """Whether less reaches the base than shakes the machine."""
        return self.eta > math.sqrt(2)

    @property
    def sag(self) -> float | None:
        """Deflection under the weight, m; None where the springs do not bear it: of a shaft, or across the plumb."""
        direction = self.given.direction
        if self.given.turning or (direction is not None and abs(direction.real) > 1e-9):
            return None
        return self.body.inertia * G / self.body.stiffness

    @property
    def sags(self) -> bool:
        """Whether the springs would have to give way further than any do."""
        return self.sag is not None and self.sag > DEEPEST

    # --- free motion

    @property
    def period(self) -> float | None:
        """Of the free motion, s; None where it does not swing."""
        return None if self.damped is None else 2 * math.pi / self.damped

    @property
    def decrement(self) -> float | None:
        """Logarithmic decrement: of amplitudes a period apart."""
        return None if self.period is None or self.decay == 0 else self.decay * self.period

    @property
    def begins(self) -> float | None:
        """Amplitude of the free motion at the start, by which it dies away, m or rad; None where it does not swing."""
        return math.hypot(*self.constants) if self.damped is not None else None

    # --- steady motion

    @property
    def static(self) -> float:
        """Deflection under the force at rest, m or rad."""
        return self.force / self.body.stiffness

    @cached_property
    def amplitude(self) -> float:
        return self.static * float(vib.magnification(self.eta, self.zeta))

    @property
    def lag(self) -> float:
        """Of the machine behind the force, or behind the base that moves, rad."""
        lag = float(vib.lag(self.eta, self.zeta))
        return lag if self.given.base is None else lag - math.atan(2 * self.zeta * self.eta)

    @property
    def ratio(self) -> float:
        """Force on the base by the exciting force; of a moving base, motion of the machine by that of the base."""
        return float(vib.transmissibility(self.eta, self.zeta))

    @property
    def on_base(self) -> float:
        """Amplitude of the force that the isolators hand on, N or N m."""
        if self.given.base is not None:
            return self.body.inertia * self.omega**2 * self.amplitude
        return self.ratio * self.force

    @property
    def peak(self) -> tuple[float, float]:
        """ω/ω0 and dynamic coefficient where it is greatest."""
        place, height = vib.peak(self.zeta)
        return float(place), float(height)

    @property
    def most(self) -> float | None:
        """ω/ω0 where the amplitude under a force that grows with ω² is greatest, 1/√(1 − 2ζ²): the greatest of
        η²β(η); None where there is no such peak. (Den Hartog, 2.11)"""
        return 1 / self.peak[0] if self.grows and 0 < self.zeta < math.sqrt(0.5) else None

    @property
    def half(self) -> float | None:
        """Of the equation of `needed`: p = γ² + 2ζ²(1 − γ²), as in `vib.eta_for`."""
        wanted = self.given.wanted
        return None if wanted is None else wanted**2 + 2 * self.zeta**2 * (1 - wanted**2)

    @property
    def needed(self) -> float | None:
        """ω/ω0 that the wanted force ratio asks for."""
        wanted = self.given.wanted
        return None if wanted is None else float(vib.eta_for(wanted, self.zeta))

    @property
    def needed_stiffness(self) -> float | None:
        return None if self.needed is None else self.body.inertia * (self.omega / self.needed) ** 2

    @property
    def most_damping(self) -> float | None:
        """The largest ζ that the wanted force ratio leaves at this stiffness; None where nothing is wanted or no
        damping is small enough."""
        if self.given.wanted is None:
            return None
        zeta = float(vib.zeta_for(self.given.wanted, self.eta))
        return zeta if math.isfinite(zeta) and self.eta > 1 else None

    # --- dry friction

    @property
    def dry(self) -> float | None:
        """Amplitude with dry friction in place of the dampers."""
        friction = self.given.friction
        return None if friction is None else vib.dry_amplitude(self._bare, self.omega, self.force, friction)

    @property
    def dry_exact(self) -> float | None:
        """The same by the motion in closed form; None where nothing is stated or the machine stops within the cycle."""
        friction = self.given.friction
        found = math.nan if friction is None else vib.dry_exact(self._bare, self.omega, self.force, friction)
        return found if math.isfinite(found) else None

    @property
    def equivalent(self) -> float | None:
        """Damping that takes as much energy out of a cycle as the dry friction, N s/m or N m s/rad."""
        friction = self.given.friction
        return (
            None if friction is None else 4 * friction / (math.pi * self.omega * float(self.dry or math.nan))
        )

    @property
    def _bare(self) -> Body:
        return self.body._replace(damping=0.0)

    # --- in time

    @property
    def lasting(self) -> float:
        """How long the motion from the start is followed, s: till the free part is gone, within 4 … 30 periods."""
        period = 2 * math.pi / (min(self.omega, self.natural) or self.natural)
        slow = (
            self.decay if self.damped is not None else self.decay - math.sqrt(self.decay**2 - self.natural**2)
        )
        wanted = 4.6 / slow if slow > 0 else math.inf
        return min(max(wanted, 4 * period), 12 * period)

    @cached_property
    def times(self) -> Array:
        count = 24 * self.lasting * max(self.omega, self.damped or 0.0) / (2 * math.pi)
        return np.linspace(0.0, self.lasting, min(1200, max(240, math.ceil(count))) + 1)

    @property
    def phasor(self) -> complex:
        """Complex amplitude of the steady motion under F sin ωt, or of a base that moves as Y sin ωt."""
        given = self.given
        force = complex(self.force)
        if given.base is not None:
            force = complex(given.base * vib.through(self.body, self.omega))
        return complex(vib.steady(self.body, self.omega, force))

    @cached_property
    def motion(self) -> Array:
        """x at `times`, from the start."""
        given = self.given
        return vib.motion(self.body, self.times, self.omega, self.phasor, given.place, given.speed)

    @cached_property
    def settled(self) -> Array:
        """The steady part of it."""
        return np.imag(self.phasor * np.exp(1j * self.omega * self.times))

    def summary(self) -> Iterator[Message]:
        """The main numbers in a sentence."""
        if self.given.free:
            yield from self._freely()
            return
        if self.unbounded:
            text = N_(
                "vibration: alone the machine is in resonance without damping at %(natural)s rad/s; what is added to "
                "it bounds its motion"
            )
            yield Message(text, {"natural": f"{self.natural:.4g}"})
            return
        text = N_(
            "vibration: natural frequency %(natural)s rad/s, amplitude %(amplitude)s mm, force ratio %(ratio)s"
        )
        if self.given.turning:
            text = N_(
                "vibration: natural frequency %(natural)s rad/s, amplitude %(amplitude)s rad, force ratio %(ratio)s"
            )
        size = self.amplitude if self.given.turning else 1e3 * self.amplitude
        numbers = {"natural": f"{self.natural:.4g}", "amplitude": f"{size:.4g}", "ratio": f"{self.ratio:.3g}"}
        yield Message(text, numbers)

    def _freely(self) -> Iterator[Message]:
        numbers = {"natural": f"{self.natural:.4g}", "zeta": f"{self.zeta:.3g}"}
        text = N_(
            "free vibration: natural frequency %(natural)s rad/s, damping ratio %(zeta)s: it creeps back without "
            "swinging"
        )
        if self.period is not None:
            text = N_(
                "free vibration: natural frequency %(natural)s rad/s, period %(period)s s, logarithmic decrement "
                "%(decrement)s"
            )
            numbers |= {"period": f"{self.period:.4g}", "decrement": f"{self.decrement or 0.0:.4g}"}
        yield Message(text, numbers)


def solve(given: Given, moving: Moving | None) -> Found:
    """`moving`: the solved lever mechanism, where the variant has one. Raises ProblemError: resonance without damping,
    friction that holds the machine, a mechanism without a shaking force."""
    shaken = shaking(moving, given.direction) if moving is not None and given.direction is not None else None
    order = shaken.leading if shaken else 1
    omega = order * shaken.omega if shaken else float(given.omega or 0.0)
    body = _body(given, omega)
    found = Found(
        given,
        body,
        order,
        omega,
        shaken,
        stood(given, body, omega) if given.foundation else None,
        absorbed(given, body, omega) if given.absorber else None,
    )
    mistakes.check(found)
    return replace(found, shaking=shaken.on(body)) if shaken else found


def _body(given: Given, omega: float) -> Body:
    """The machine on all its isolators; a stiffness that is not stated is what the wanted force ratio asks for."""
    if given.stiffness is not None:
        whole = given.isolators * given.stiffness
    else:
        eta = float(vib.eta_for(given.wanted, given.ratio or 0.0))
        whole = given.inertia * (omega / eta) ** 2
    if given.ratio is not None:
        return Body(given.inertia, whole, 2 * given.ratio * math.sqrt(whole * given.inertia))
    return Body(given.inertia, whole, given.isolators * (given.damping or 0.0))
