"""Harmonics of what repeats with each turn: coefficients from equally spaced samples, values between them.

Of a smooth periodic function the sums over equal steps are exact but for the harmonics beyond the samples, whose
amplitudes fall faster than any power: so many samples are taken that they are rounding. (Trefethen, Weideman, The
exponentially convergent trapezoidal rule, SIAM Review 56)
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from tmm_report.records import dataclass

Array = Any
TAIL = 1e-12  # of the largest harmonic: what is beyond is rounding
LEAST, MOST = 96, 3072  # samples a turn
BROKEN = 1e-4  # a tail of so many samples that is no smooth function's: a jump leaves 1e-3


@dataclass(frozen=True, eq=False)
class Series:
    """f(θ) = a₀ + Σ a_k cos kθ + b_k sin kθ; `cosine`, `sine` (..., K+1), orders 0 … K."""

    cosine: Array
    sine: Array

    @property
    def amplitude(self) -> Array:
        """A_k of A_k cos(kθ − α_k), (..., K+1); of order 0 the mean with its sign."""
        size = np.hypot(self.cosine, self.sine)
        size[..., 0] = self.cosine[..., 0]
        return size

    @property
    def phase(self) -> Array:
        """α_k, rad, (..., K+1); 0 where there is no harmonic, and of the mean."""
        size = np.hypot(self.cosine, self.sine)
        size[..., 0] = 0.0
        some = size > TAIL * np.max(size, initial=0.0, axis=-1, keepdims=True)
        return np.where(some, np.arctan2(self.sine, self.cosine), 0.0)

    def at(self, theta: Array) -> Array:
        """The sum at angles (P,), rad: (..., P)."""
        turns = np.outer(np.arange(self.cosine.shape[-1]), theta)
        return self.cosine @ np.cos(turns) + self.sine @ np.sin(turns)


def series(values: Array, highest: int) -> Series:
    """Harmonics 0 … `highest` of a real function (..., N) at θ = 2πj/N. Raises ValueError for too few samples."""
    count = np.shape(values)[-1]
    if 2 * highest >= count:
        raise ValueError(f"{count} samples tell no harmonic of order {highest}")
    found = np.fft.rfft(values)[..., : highest + 1] / count
    cosine, sine = 2 * found.real, -2 * found.imag
    cosine[..., 0] /= 2
    sine[..., 0] = 0.0
    return Series(cosine, sine)


def turning(values: Array, highest: int) -> Array:
    """c_k of a plane vector f(θ) = Σ c_k e^{ikθ}, k = −`highest` … `highest`, (..., 2·highest + 1): vectors that turn
    k times a turn, backwards where k < 0."""
    count = np.shape(values)[-1]
    if 2 * highest >= count:
        raise ValueError(f"{count} samples tell no harmonic of order {highest}")
    orders = np.arange(-highest, highest + 1)
    return (np.fft.fft(values) / count)[..., orders]


def tail(values: Array) -> float:
    """The largest amplitude in the upper half of the harmonics that (..., N) samples tell, by the largest of all but
    the mean; 0 of a constant."""
    spectrum = np.abs(np.fft.fft(values))
    count = spectrum.shape[-1]
    orders = np.minimum(np.arange(count), count - np.arange(count))
    whole = spectrum[..., orders > 0].max(initial=0.0)
    # a constant leaves nothing but its own rounding
    if whole <= 1e-14 * spectrum.max(initial=0.0):
        return 0.0
    return float(spectrum[..., orders > count // 4].max(initial=0.0) / whole)


def enough(samples: Callable[[int], Array], least: int = LEAST, most: int = MOST) -> tuple[int, float]:
    """How many samples a turn leave a tail of rounding, and that tail: `samples(n)` gives (..., n) of the function.

    Where even `most` do not, these and what is left.
    """
    count = least
    while (left := tail(samples(count))) > TAIL and 2 * count <= most:
        count *= 2
    return count, left


def refined(values: Array, times: int) -> Array:
    """The same function at `times` as many places, (..., times·N): trigonometric interpolation."""
    count = np.shape(values)[-1]
    spectrum = np.fft.fft(values)
    half = (count + 1) // 2
    wide = np.zeros((*np.shape(values)[:-1], count * times), dtype=complex)
    wide[..., :half] = spectrum[..., :half]
    wide[..., -(count - half) :] = spectrum[..., half:]
    if count % 2 == 0 and times > 1:  # the highest harmonic is neither forward nor backward
        wide[..., half] = wide[..., -half] = spectrum[..., half] / 2
    found = np.fft.ifft(wide) * times
    return found if np.iscomplexobj(values) else found.real


def mean_square(values: Array) -> Array:
    """Root of the mean square over a turn, (...)."""
    return np.sqrt(np.mean(np.abs(values) ** 2, axis=-1))


PEAK = 8192  # places among which a greatest value is looked for


def fine(values: Array) -> Array:
    """The same function (N,) at so many places that what lies between them is of no account."""
    return refined(values, max(1, PEAK // len(values)))


def greatest(values: Array) -> tuple[float, float]:
    """Greatest magnitude of a function (N,) and the angle θ at which it is reached, rad: between the samples too."""
    sizes = np.abs(fine(values))
    if sizes.max() - sizes.min() <= 1e-12 * sizes.max():  # the same all round
        return float(sizes.max()), 0.0
    k = int(np.argmax(sizes >= sizes.max() * (1 - 1e-12)))
    before, here, after = sizes[k - 1], sizes[k], sizes[(k + 1) % len(sizes)]
    bend = before - 2 * here + after
    shift = 0.5 * (before - after) / bend if bend < 0 else 0.0
    shift = shift if abs(shift) <= 1 else 0.0
    height = here - 0.25 * (before - after) * shift
    angle = float(2 * np.pi * (k + shift) / len(sizes)) % (2 * np.pi)
    return float(height), 0.0 if 2 * np.pi - angle < 1e-6 else angle  # a turn is no turn
