"""Vibration of one mass on springs and dampers, and of two masses one on the other: steady and free motion.

    m x'' + b x' + c x = F sin ωt,   ω0² = c/m,   n = b/(2m),   ζ = n/ω0,   η = ω/ω0

The same equations hold for a disc that swings on a shaft: its moment of inertia, torsional stiffness and damping stand
for m, c and b, a moment for the force. Arrays broadcast; SI. A complex amplitude X stands for x(t) = Im(X e^{iωt}).
Sources: Den Hartog, Mechanical vibrations, ch. 2 and 3; Biderman, Theory of mechanical vibrations, ch. 3.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

Array = Any

CRITICAL = 1e-9  # of ζ - 1, below which the damping is called critical
ROUNDING = 1e-10  # of the largest harmonic, below which another is rounding


class Body(NamedTuple):
    """A mass and what it stands on: kg, N/m, N s/m; or kg m², N m/rad, N m s/rad."""

    inertia: Array
    stiffness: Array
    damping: Array = 0.0

    @property
    def natural(self) -> Array:
        """ω0 without damping, rad/s."""
        return np.sqrt(np.divide(self.stiffness, self.inertia))

    @property
    def ratio(self) -> Array:
        """ζ, the damping in parts of the critical one."""
        return np.divide(self.damping, 2 * np.sqrt(np.multiply(self.stiffness, self.inertia)))


# --- one mass, against η and ζ


def magnification(eta: Array, zeta: Array) -> Array:
    """β, the amplitude in parts of the static deflection under the force; infinite at η = 1 without damping."""
    with np.errstate(divide="ignore"):
        return 1 / np.hypot(1 - np.square(eta), 2 * np.multiply(zeta, eta))


def lag(eta: Array, zeta: Array) -> Array:
    """ψ, 0 … π rad, by which the motion lags behind the force."""
    return np.arctan2(2 * np.multiply(zeta, eta), 1 - np.square(eta))


def transmissibility(eta: Array, zeta: Array) -> Array:
    """Force on a fixed base by the exciting one; motion of the mass by that of a moving base."""
    return np.hypot(1.0, 2 * np.multiply(zeta, eta)) * magnification(eta, zeta)


def peak(zeta: Array) -> tuple[Array, Array]:
    """η and β where the amplitude is greatest under a force that does not depend on ω; from ζ = 1/√2 on, at rest."""
    with np.errstate(divide="ignore"):
        low = np.square(zeta) < 0.5
        place = np.sqrt(np.where(low, 1 - 2 * np.square(zeta), 0.0))
    return place, magnification(place, zeta)


def eta_for(wanted: Array, zeta: Array) -> Array:
    """η > √2 at which the transmissibility falls to `wanted` < 1: the larger root of

    γ²(η²)² − (2γ² + 4ζ²(1 − γ²)) η² − (1 − γ²) = 0.
    """
    square, free = np.square(wanted), 1 - np.square(wanted)
    half = square + 2 * np.square(zeta) * free
    return np.sqrt((half + np.sqrt(half**2 + square * free)) / square)


def zeta_for(wanted: Array, eta: Array) -> Array:
    """The largest ζ at which the transmissibility at η is no more than `wanted` < 1; nan where none is small enough."""
    square = np.square(wanted)
    rest = square * np.square(1 - np.square(eta)) - 1
    with np.errstate(invalid="ignore"):
        return np.sqrt(rest / (1 - square)) / (2 * np.asarray(eta))


def from_frequencies(damped: float, peak: float) -> tuple[float, float]:
    """ζ and the natural frequency from those of the free damped swing and of the greatest amplitude, in one unit.

    (peak/damped)² = (1 − 2ζ²)/(1 − ζ²).
    """
    share = (peak / damped) ** 2
    zeta = float(np.sqrt((1 - share) / (2 - share)))
    return zeta, damped / float(np.sqrt(1 - zeta**2))


def kind(zeta: float) -> str:
    """Of the free motion: it swings, "under" the critical damping, is "critical", or creeps back, "over" it."""
    if abs(zeta - 1) <= CRITICAL:
        return "critical"
    return "under" if zeta < 1 else "over"


# --- one mass, in time


def steady(body: Body, omega: Array, force: Array) -> Array:
    """Complex amplitude under a force of complex amplitude; of a base that moves by Y the force is (c + ibω) Y."""
    inertia, stiffness, damping = body
    omega = np.asarray(omega, dtype=float)
    return force / (stiffness - inertia * omega**2 + 1j * damping * omega)


def through(body: Body, omega: Array) -> Array:
    """c + ibω: force of springs and dampers by the motion between their ends."""
    return body.stiffness + 1j * body.damping * np.asarray(omega, dtype=float)


def free(body: Body, t: Array, place: float, speed: float) -> Array:
    """x(t) of the free motion from x(0) and x'(0): it swings, or creeps back where the damping is critical or more.

    e^{−nt} (x0 C + (v0 + n x0) S) with C = cos ω1 t, S = sin ω1 t/ω1, ω1 = √(ω0² − n²); S = t at the critical damping;
    cosh qt and sinh qt/q, q = √(n² − ω0²), above it.
    """
    t = np.asarray(t, dtype=float)
    n = body.damping / (2 * body.inertia)
    rest = body.stiffness / body.inertia - n**2
    push = speed + n * place
    if rest >= 0:
        root = np.sqrt(rest)
        return np.exp(-n * t) * (place * np.cos(root * t) + push * t * np.sinc(root * t / np.pi))
    root = np.sqrt(-rest)
    slow, apart = np.exp((root - n) * t), np.exp(-2 * root * t)  # no exponent above 0
    return slow * (place * (1 + apart) / 2 + push * (1 - apart) / (2 * root))


def motion(body: Body, t: Array, omega: float, amplitude: complex, place: float, speed: float) -> Array:
    """x(t) from x(0) and x'(0) with the steady motion Im(X e^{iωt}): what is not steady dies away as free motion."""
    wave = np.imag(amplitude * np.exp(1j * omega * np.asarray(t, dtype=float)))
    return wave + free(body, t, place - amplitude.imag, speed - omega * amplitude.real)


def resonant(body: Body, t: Array, force: float) -> Array:
    """x(t) from rest under F sin ω0 t without damping: F/(2 m ω0²) (sin ω0 t − ω0 t cos ω0 t) grows without bound."""
    turned = body.natural * np.asarray(t, dtype=float)
    return force / (2 * body.stiffness) * (np.sin(turned) - turned * np.cos(turned))


# --- dry friction


def dry_amplitude(body: Body, omega: float, force: float, friction: float) -> float:
    """Amplitude under F sin ωt with a dry friction F_f in place of the damper, by the energy of a cycle:

    k_eq = 4 F_f/(π ω A),  A = (F/c) √(1 − (4F_f/(πF))²)/|1 − η²|;  nan where friction takes more than the force gives.
    """
    share = 4 * friction / (np.pi * force)
    eta = omega / body.natural
    if share >= 1:
        return float("nan")
    return float(force / body.stiffness * np.sqrt(1 - share**2) / abs(1 - eta**2))


def dry_exact(body: Body, omega: float, force: float, friction: float) -> float:
    """The same without the equivalent damper, of a motion that never stops: A = (F/c) √(V² − (F_f/F)² H²).

    V = 1/(1 − η²), H = sin(π/η)/(η (1 + cos(π/η))); nan where the mass would stop within the cycle. (Den Hartog, Forced
    vibrations with combined Coulomb and viscous friction, Trans. ASME 53, 1931)
    """
    eta, share = omega / body.natural, friction / force
    swing, turn = 1 / (1 - eta**2), np.pi / eta
    with np.errstate(divide="ignore", invalid="ignore"):
        heave = np.sin(turn) / (eta * (1 + np.cos(turn)))
        square = swing**2 - (share * heave) ** 2
    if not square > 0 or not _moves(eta, share, float(np.sqrt(square)), float(heave)):
        return float("nan")
    return float(force / body.stiffness * np.sqrt(square))


def _moves(eta: float, share: float, size: float, heave: float) -> bool:
    """Whether the speed keeps its sign for half a cycle from where the mass turns round."""
    phase = np.linspace(0.0, np.pi, 181)[1:-1]
    # over x_st, from the turn at A: A cos τ + s H sin τ + s (1 − cos(τ/η)) − s η H sin(τ/η), τ = ωt, s = F_f/F
    rate = -size * np.sin(phase) + share * heave * (np.cos(phase) - np.cos(phase / eta))
    rate = rate + share / eta * np.sin(phase / eta)
    return bool(np.all(rate < 0))


# --- two masses


def pair(first: Body, second: Body, omega: Array, forces: tuple[Array, Array]) -> tuple[Array, Array]:
    """Complex amplitudes of a first mass on the ground and of a second one on it, under forces on both."""
    w = np.asarray(omega, dtype=float)
    between = through(second, w)
    one = through(first, w) + between - first.inertia * w**2
    other = between - second.inertia * w**2
    whole = one * other - between**2
    on_one, on_other = forces
    return (on_one * other + on_other * between) / whole, (on_other * one + on_one * between) / whole


def pair_natural(first: Body, second: Body) -> tuple[Array, Array]:
    """Both natural frequencies of two masses without damping, rad/s: roots s = ω² of

    m1 m2 s² − (m1 c2 + m2 (c1 + c2)) s + c1 c2 = 0.
    """
    half = (first.inertia * second.stiffness + second.inertia * (first.stiffness + second.stiffness)) / 2
    product = first.inertia * second.inertia
    rest = first.stiffness * second.stiffness
    high = (half + np.sqrt(half**2 - product * rest)) / product
    return np.sqrt(rest / (product * high)), np.sqrt(high)


# --- absorbers; μ: mass of the absorber in parts of the main one


def share_clear(natural: float, omega: float, apart: tuple[float, float]) -> float:
    """The least μ of an absorber tuned to ω with which neither natural frequency lies between these parts of ω:

    μ = (ω0² − x²ω²)(1 − x²)/(x²ω²) for the part x that asks for more.
    """
    x = np.array(apart)
    asked = ((natural / omega) ** 2 - x**2) * (1 - x**2) / x**2
    return float(max(0.0, *asked))


def tuned(main: Body, mu: float, omega: float) -> Body:
    """An absorber without damping whose natural frequency is ω: there the main mass stands still."""
    mass = mu * main.inertia
    return Body(mass, mass * omega**2)


def best_absorber(main: Body, mu: float) -> Body:
    """Stiffness and damping with which the greatest amplitude of an undamped main mass is the least, near enough:
    ω_a = ω0/(1 + μ), ζ_a = √(3μ/(8(1 + μ))); the greatest β is then about √(1 + 2/μ). (Den Hartog, 3.3)"""
    mass, frequency = mu * main.inertia, main.natural / (1 + mu)
    ratio = np.sqrt(3 * mu / (8 * (1 + mu)))
    return Body(mass, mass * frequency**2, 2 * ratio * mass * frequency)


def lanchester_ratio(mu: Array) -> Array:
    """The best b_a/(2 m_a ω0) of an absorber without a spring, 1/√(2(1 + μ)(2 + μ)); the greatest β is 1 + 2/μ."""
    return 1 / np.sqrt(2 * (1 + np.asarray(mu)) * (2 + np.asarray(mu)))


def lanchester(main: Body, mu: float) -> Body:
    """A damper's mass that hangs on the main one by its damper alone."""
    mass = mu * main.inertia
    return Body(mass, 0.0, 2 * float(lanchester_ratio(mu)) * mass * main.natural)


def greatest(main: Body, absorber: Body, over: Array) -> tuple[float, float]:
    """η (of the main mass alone) and β where its amplitude is greatest among η `over`, (N,)."""
    omega = np.asarray(over) * main.natural
    beta = np.abs(pair(main, absorber, omega, (main.stiffness, 0.0))[0])
    k = int(np.argmax(beta))
    return float(over[k]), float(beta[k])


# --- any periodic force


def spectrum(values: Array) -> Array:
    """Harmonics 0 … N/2 of a periodic function (N,), as of `np.fft.rfft`; rounding is nothing, even at resonance."""
    sizes = np.fft.rfft(values)
    return np.where(np.abs(sizes) > ROUNDING * np.abs(sizes).max(initial=0.0), sizes, 0)


def periodic(body: Body, omega: float, values: Array) -> tuple[Array, Array]:
    """Steady motion and force on the base, (N,), under a force of the period 2π/ω, `values` (N,), at the same times.

    Each harmonic by itself: no step of time, and no error but that of the harmonics beyond N/2 and of rounding.
    """
    count, sizes = len(values), spectrum(values)
    orders, there = np.arange(len(sizes)), sizes != 0
    moved = np.zeros_like(sizes)
    moved[there] = steady(body, orders[there] * omega, sizes[there])
    return np.fft.irfft(moved, count), np.fft.irfft(moved * through(body, orders * omega), count)


def harmonics(values: Array, most: int) -> tuple[Array, Array]:
    """Size and phase of harmonics 1 … most of a periodic function (N,): Σ A_k cos(kφ − φ_k)."""
    spectrum = np.fft.rfft(values)[1 : most + 1] * 2 / len(values)
    return np.abs(spectrum), -np.angle(spectrum)
