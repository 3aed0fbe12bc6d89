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

from tmm_report.chapters.machine.vibration import mistakes, steps
from tmm_report.chapters.machine.vibration.given import Given
from tmm_report.chapters.machine.vibration.measures import Absorbed, Stood, absorbed, stood
from tmm_report.chapters.machine.vibration.shaking import Shaking, shaking
from tmm_report.chapters.machine.vibration.values import Values
from tmm_report.mechanics.masses import vibration as vib
from tmm_report.mechanics.masses.vibration import Body
from tmm_report.problems import N_, Message
from tmm_report.quantity.text import Amount, amounts
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.chapters.lever.moving import Moving

__all__ = ["Found", "Given", "solve"]

Array = Any
DEEPEST = 0.3  # m, which softer springs than any would give way under the weight
WORKING = (2.0, 5.0)  # ω/ω0 of well isolated machines


@dataclass(frozen=True, eq=False)
class Found:
    """Found by `solve`. `s`: the single numbers; `body`: the machine on all its isolators; `order`: of the harmonic
    that is followed in full, 1 of a force that has but one; `omega`: its frequency, rad/s; `shaking`: of the mechanism;
    `stood`, `absorbed`: with a base that gives way, with an absorber."""

    given: Given
    s: Values
    body: Body
    order: int
    omega: float
    shaking: Shaking | None
    stood: Stood | None
    absorbed: Absorbed | None

    @property
    def zeta(self) -> float:
        return self.s.number("zeta")

    @property
    def natural(self) -> float:
        return self.s.number("natural")

    @property
    def eta(self) -> float:
        return self.omega / self.natural

    @property
    def force(self) -> float:
        """Amplitude of the force, N or N m; of a moving base what its springs and dampers bring."""
        if self.given.base is not None:
            return self.given.base * abs(complex(vib.through(self.body, self.omega)))
        return self.s.get("force") or 0.0

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
    def kind(self) -> str:
        """Of the free motion: it swings ("under"), or creeps back."""
        return vib.kind(self.zeta)

    @property
    def isolates(self) -> bool:
        """Whether less reaches the base than shakes the machine."""
        return self.eta > math.sqrt(2)

    @property
    def sags(self) -> bool:
        """Whether the springs would have to give way further than any do."""
        return (self.s.get("sag") or 0.0) > DEEPEST

    # --- in time

    @property
    def lasting(self) -> float:
        """How long the motion from the start is followed, s: till the free part is gone, within 4 … 30 periods."""
        period = 2 * math.pi / (min(self.omega, self.natural) or self.natural)
        decay = self.s.number("decay")
        slow = decay if "damped" in self.s else decay - math.sqrt(decay**2 - self.natural**2)
        wanted = 4.6 / slow if slow > 0 else math.inf
        return min(max(wanted, 4 * period), 12 * period)

    @cached_property
    def times(self) -> Array:
        count = 24 * self.lasting * max(self.omega, self.s.get("damped") or 0.0) / (2 * math.pi)
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
        start = self.given.start
        return vib.motion(self.body, self.times, self.omega, self.phasor, start.place, start.rate)

    @cached_property
    def settled(self) -> Array:
        """The steady part of it."""
        return np.imag(self.phasor * np.exp(1j * self.omega * self.times))

    # --- in sentences

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
            yield Message(text, {"natural": Amount(self.natural)})
            return
        text = N_(
            "vibration: natural frequency %(natural)s rad/s, amplitude %(amplitude)s mm, transmissibility %(ratio)s"
        )
        if self.given.turning:
            text = N_(
                "vibration: natural frequency %(natural)s rad/s, amplitude %(amplitude)s rad, "
                "transmissibility %(ratio)s"
            )
        size = self.s["amplitude"].number("" if self.given.turning else "mm")
        ratio = self.s.number(ratio_key(self.given))
        yield Message(text, amounts({"natural": self.natural, "amplitude": size, "ratio": ratio}))

    def _freely(self) -> Iterator[Message]:
        numbers = {"natural": self.natural, "zeta": self.zeta}
        text = N_(
            "free vibration: natural frequency %(natural)s rad/s, damping ratio %(zeta)s: it creeps back without "
            "swinging"
        )
        if "period" in self.s:
            text = N_(
                "free vibration: natural frequency %(natural)s rad/s, period %(period)s s, logarithmic decrement "
                "%(decrement)s"
            )
            decrement = self.s.get("decrement") or 0.0
            numbers |= {"period": self.s.number("period"), "decrement": decrement}
        yield Message(text, amounts(numbers))


def ratio_key(given: Given) -> str:
    """Of what a machine on a fixed base hands on to it, or one on a moving base takes from it."""
    return "ratio_z" if given.base is not None else "ratio"


def solve(given: Given, moving: Moving | None) -> Found:
    """`moving`: the solved lever mechanism, where the variant has one. Raises ProblemError: resonance without damping,
    friction that holds the machine, a mechanism without a shaking force."""
    shaken = shaking(moving, given.mechanism) if moving is not None and given.mechanism is not None else None
    order = shaken.leading if shaken else 1
    omega = order * shaken.omega if shaken else float(given.speed or 0.0)
    s = steps.isolators(given, omega, shaken is not None)
    body = Body(s.number("inertia"), s.number("stiffness"), s.number("damping"))
    if given.free:
        steps.free(s, given)
    else:
        steps.excitation(s, given, shaken)
    stands = stood(given, body, omega) if given.foundation else None
    hung = absorbed(given, body, omega) if given.absorber else None
    found = Found(given, s, body, order, omega, shaken, stands, hung)
    mistakes.check(found)
    found = replace(found, shaking=shaken.on(body)) if shaken else found
    if not given.free:
        _forced(found)
    return found


def _forced(found: Found) -> None:
    s, given, bare = found.s, found.given, found.body._replace(damping=0.0)
    if found.unbounded:
        steps.unbounded(s)
    else:
        steps.steady(s, given, found.order)
        steps.peak(s, found.grows)
        if found.shaking is None:
            steps.from_start(s)
    if given.transmissibility is not None:
        steps.wanted(s)
    if given.friction is not None:
        steps.dry(s, given, vib.dry_exact(bare, found.omega, found.force, given.friction))
    if found.stood is not None:
        steps.stood(s, found)
    if found.absorbed is not None:
        steps.absorber(s, found)
    if found.shaking is not None:
        steps.shaken(s, found.shaking)
