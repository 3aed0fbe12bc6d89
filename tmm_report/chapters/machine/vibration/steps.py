"""The numbers of the vibration, each assigned the expression that the note prints.

What loses digits in a textbook's form, or is searched for, comes from mechanics/masses/vibration.py.
"""

from __future__ import annotations

import cmath
from typing import TYPE_CHECKING, Any

import numpy as np

from tmm_report.chapters.machine.vibration.given import Given
from tmm_report.chapters.machine.vibration.values import Values, sheet
from tmm_report.mechanics.masses import vibration as vib
from tmm_report.quantity.formula import PI, Expr, cos, sin, sqrt
from tmm_report.quantity.functions import arctan, exp
from tmm_report.quantity.sheet import Computed

if TYPE_CHECKING:
    from tmm_report.chapters.machine.vibration.shaking import Shaking
    from tmm_report.chapters.machine.vibration.solve import Found

G = 9.81  # m/s², of the static deflection


def isolators(given: Given, omega: float, shaken: bool) -> Values:
    """The machine on all its isolators; a stiffness that is not stated is what the wanted transmissibility asks for."""
    arm = given.absorber.arm if given.absorber else None
    s = sheet(given.turning, given.base is not None, shaken or given.unbalance is not None, arm is not None)
    s.inertia, s.isolators = given.inertia, given.isolators
    if not given.free:
        s.omega = omega
    s.wanted, s.zeta = given.transmissibility, given.damping_ratio
    if given.stiffness is not None:
        s.stiffness_each = given.stiffness
        s.stiffness = s.isolators * s.stiffness_each
    elif given.deflection is not None:
        s.g, s.deflection = G, given.deflection
        s.stiffness = s.inertia * s.g / s.deflection
        s.stiffness_each = s.stiffness / s.isolators
    else:
        if given.damping_ratio is None:
            s.zeta = 0.0  # nothing damps: a damping in N·s/m is refused where the stiffness is chosen
        _chosen(s)
        s.stiffness_each = s.needed_stiffness / s.isolators
        s.stiffness = s.number("needed_stiffness")
    s.natural = sqrt(s.stiffness / s.inertia)
    _damping(s, given)
    if given.turning or given.deflection is not None:
        return s
    s.g = G
    if given.mechanism is None or abs(given.mechanism.real) <= 1e-9:
        s.sag = s.inertia * s.g / s.stiffness  # springs across the plumb do not bear the weight
    return s


def _chosen(s: Values) -> None:
    """The stiffness that the wanted transmissibility asks for; it stands alone or beside a stated one."""
    free = 1 - s.wanted**2
    s.half = s.wanted**2 + 2 * s.zeta**2 * free
    s.needed = sqrt(s.half + sqrt(s.half**2 + s.wanted**2 * free)) / s.wanted
    s.needed_stiffness = s.inertia * (s.omega / s.needed) ** 2


def _damping(s: Values, given: Given) -> None:
    """From the damping to its ratio, or back."""
    if given.damping_ratio is not None:
        s.decay = s.zeta * s.natural
        s.damping = 2 * s.decay * s.inertia
        s.damping_each = s.number("damping") / given.isolators
    else:
        s.damping_each = given.damping or 0.0
        s.damping = s.isolators * s.damping_each
        s.decay = s.damping / (2 * s.inertia)
        if "zeta" not in s:
            s.zeta = s.decay / s.natural
    kind = vib.kind(s.number("zeta"))
    if kind == "under":
        s.damped = sqrt(s.natural**2 - s.decay**2)
    elif kind == "over":
        s.root = sqrt(s.decay**2 - s.natural**2)


def excitation(s: Values, given: Given, shaken: Shaking | None) -> None:
    if given.unbalance is not None:
        s.unbalance, s.radius = given.unbalance.mass, given.unbalance.radius
        s.force = s.unbalance * s.radius * s.omega**2
    if given.mechanism is not None:
        s.direction = cmath.phase(given.mechanism)
    if shaken is not None:
        s.order, s.shaft = shaken.leading, shaken.omega
        s.force = float(shaken.sizes[shaken.leading - 1])
    s.base = given.base
    if given.shaken is not None:
        s.force = given.shaken
    s.place, s.speed = given.start.place, given.start.rate
    s.eta = s.omega / s.natural
    if given.base is None:
        s.static = s.force / s.stiffness


# --- free motion


def free(s: Values, given: Given) -> None:
    """Its constants; period, logarithmic decrement and what it says of two amplitudes, the first of these."""
    s.place, s.speed = given.start.place, given.start.rate
    s.C1 = s.place
    push = s.speed + s.decay * s.C1
    if "damped" not in s:
        s.C2 = push / s.root if "root" in s else push
        return
    s.C2 = push / s.damped
    s.period = 2 * PI / s.damped
    if s.number("decay"):
        s.decrement = s.decay * s.period
        s.falls = exp(s.decrement)
    s.begins = sqrt(s.C1**2 + s.C2**2)


# --- forced motion


def unbounded(s: Values) -> None:
    """In resonance without damping: the growth of the amplitude with every cycle, of F/(2 m ω0) t."""
    if "static" in s:
        s.growth = PI * s.static
    s.resonance = s.number("natural")


def steady(s: Values, given: Given, order: int) -> None:
    """The amplitude, its lag within a half turn, what reaches the base."""
    rest, resists = 1 - s.eta**2, 4 * s.zeta**2 * s.eta**2
    ratio = sqrt((1 + resists) / (rest**2 + resists))
    if given.base is not None:
        s.ratio_z = ratio
        s.amplitude = s.ratio_z * s.base
        s.on_base = s.inertia * s.omega**2 * s.amplitude
    else:
        s.ratio = ratio
        s.beta = 1 / sqrt(rest**2 + resists)
        s.amplitude = s.beta * s.static
        s.on_base = s.ratio * s.force
    s.lag = _lag(s, s.number("eta"), given.base is not None)
    s.on_base_each = s.on_base / s.isolators
    s.resonance = s.number("natural") / order


def _lag(s: Values, eta: float, moving_base: bool) -> Expr:
    """Beyond resonance the force is more than a quarter ahead."""
    twice = 2 * s.zeta * s.eta
    lag = PI / 2
    if eta != 1:
        lag = arctan(twice / (1 - s.eta**2)) if eta < 1 else PI - arctan(twice / (s.eta**2 - 1))
    return lag - arctan(twice) if moving_base else lag


def peak(s: Values, grows: bool) -> None:
    """Where the magnification factor is greatest, and where the amplitude under a force that grows with ω²: the
    greatest of η²β(η). (Den Hartog, 2.11)"""
    if not 0 < s.number("zeta") < 2**-0.5:
        return
    s.eta_peak = sqrt(1 - 2 * s.zeta**2)
    s.beta_peak = 1 / (2 * s.zeta * sqrt(1 - s.zeta**2))
    if grows:
        s.eta_most = 1 / sqrt(1 - 2 * s.zeta**2)


def from_start(s: Values) -> None:
    """Constants of the free part, by the place and the velocity at the start."""
    s.C1 = s.place + s.amplitude * sin(s.lag)
    push = s.speed + s.decay * s.C1 - s.amplitude * s.omega * cos(s.lag)
    s.C2 = push / s.damped if "damped" in s else push / s.root if "root" in s else push


def wanted(s: Values) -> None:
    """What the wanted transmissibility asks for beside a stated stiffness: another one, or less damping."""
    if "needed" not in s:
        _chosen(s)
    eta, most = s.number("eta"), float(vib.zeta_for(s.number("wanted"), s.number("eta")))
    if eta > 1 and most > 1e-7:  # the root of a rounding where the ratio is just reached without damping; nan
        above = s.wanted**2 * (1 - s.eta**2) ** 2 - 1
        s.most_damping = sqrt(above / (1 - s.wanted**2)) / (2 * s.eta)


def dry(s: Values, given: Given, exact: float) -> None:
    """With dry friction in place of the dampers; `exact`: by the motion in closed form, nan where the machine stops
    within the cycle."""
    s.friction = given.friction
    free = sqrt(1 - (4 * s.friction / (PI * s.force)) ** 2)
    s.dry = s.static * free / abs(1 - s.eta**2)
    s.equivalent = 4 * s.friction / (PI * s.omega * s.dry)
    s.dry_exact = exact if np.isfinite(exact) else None


# --- a base that gives way, an absorber, the mechanism's own force


def stood(s: Values, found: Found) -> None:
    of = found.stood
    assert of is not None
    s.base_inertia, s.base_stiffness, s.base_damping = of.base
    m, c, under, below = s.inertia, s.stiffness, s.base_inertia, s.base_stiffness
    s.pair_half = (under * c + m * (below + c)) / (2 * under * m)
    low, high = _split(s.pair_half, c * below / (under * m))
    s.pair_low, s.pair_high = Computed(low, of.natural[0]), Computed(high, of.natural[1])
    s.pair_machine, s.pair_base = found.force * abs(of.machine), found.force * abs(of.under)
    stiff = c + below - under * s.omega**2
    rough = s.omega * (s.damping + s.base_damping)
    s.gamma = sqrt((stiff**2 + rough**2) / (c**2 + (s.omega * s.damping) ** 2))
    s.gamma_ground = of.grounded


def _split(half: Expr, product: Expr) -> tuple[Expr, Expr]:
    """Roots of ω⁴ − 2hω² + q: the lower one loses digits where they lie far apart."""
    swing = sqrt(half**2 - product)
    return sqrt(half - swing), sqrt(half + swing)


def absorber(s: Values, found: Found) -> None:
    """Tuned, without damping; with the best damping; the damper without a spring."""
    of, stated = found.absorbed, found.given.absorber
    assert of is not None and stated is not None
    if stated.inertia is not None:
        s.absorber = stated.inertia
        s.mu = s.absorber / s.inertia
    else:
        s.mu = of.mu
        s.absorber = s.mu * s.inertia
    s.absorber_springs, s.absorber_arm = stated.springs, stated.arm
    s.absorber_stiffness = s.absorber * s.omega**2
    across = s.absorber_springs if stated.arm is None else s.absorber_springs * s.absorber_arm**2
    s.absorber_each = s.absorber_stiffness / across
    own = found.force * of.tuned.swing
    s.absorber_swing = own if found.given.base is not None else s.force / s.absorber_stiffness
    s.split_half = (s.natural**2 + (1 + s.mu) * s.omega**2) / 2
    low, high = _split(s.split_half, s.natural**2 * s.omega**2)
    s.split_low, s.split_high = Computed(low, of.natural[0]), Computed(high, of.natural[1])
    s.best_natural = s.natural / (1 + s.mu)
    s.best_ratio = sqrt(3 * s.mu / (8 * (1 + s.mu)))
    s.lanchester_ratio = 1 / sqrt(2 * (1 + s.mu) * (2 + s.mu))


def shaken(s: Values, of: Shaking) -> None:
    """The greatest over a turn."""

    def most(numbers: Any) -> float:
        return float(np.max(np.abs(numbers)))

    s.force_most, s.moved_most, s.handed_most = most(of.force), most(of.moved), most(of.handed)
