"""Motion of a slider by harmonics of the crank's angle: exact, and by the series in λ of the textbooks.

    x = r cos φ + l cos β,   sin β = λ sin φ,   λ = r/l     (φ from the guide's direction, no offset)
    √(1 − λ² sin² φ) = c₀ + c₂ cos 2φ + c₄ cos 4φ + …
    a/(r ω²) = −[cos φ + A₂ cos 2φ + A₄ cos 4φ + …],   A_2k = (2k)² c_2k/λ

Lectures that call l/r λ write the same as 4λ(A₂ cos 2φ + 4A₄ cos 4φ + 9A₆ cos 6φ): their A_2k are the c_2k here.
Sources: Artobolevsky, ch. 13; Biezeno, Grammel, Engineering Dynamics, vol. 4.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from math import comb
from typing import Any

import numpy as np

from tmm_report.mechanics.calculus import harmonics as fourier
from tmm_report.mechanics.calculus.harmonics import Series
from tmm_report.mechanics.calculus.vectors import cross, dot
from tmm_report.mechanics.lever.cycle import Cycle
from tmm_report.mechanics.lever.dyads import Dyad
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.mechanics.lever.motion import Linkage
from tmm_report.records import dataclass

Array = Any


def rod_cosine(lam: Array, phi: Array, offset: Array = 0.0) -> Array:
    """cos β of the rod, exact; `lam` = r/l, `offset` = e/l, on which side φ = 90° lies above 0. nan: it cannot be."""
    with np.errstate(invalid="ignore"):
        return np.sqrt(1 - (lam * np.sin(phi) - offset) ** 2)


def rod_cosine_short(lam: Array, phi: Array) -> Array:
    """cos β by one term of the binomial series, 1 − λ² sin² φ/2."""
    return 1 - (lam * np.sin(phi)) ** 2 / 2


MOST = 20000  # terms of the exact coefficients: λ → 1


def root_exact(lam: float, order: int) -> float:
    """c of cos(order·φ) in √(1 − λ² sin² φ), |λ| ≤ 1, exact; odd orders have none.

    1 − λ² sin² φ = C² |1 + q e^{2iφ}|², C = (1 + s)/2, q = λ²/(1 + s)², s = √(1 − λ²), so that the root is a product
    of two binomial series in q, which falls as λ²/4 and nears 1 with λ: as many terms as rounding needs.
    """
    if order % 2:
        return 0.0
    k, s = order // 2, np.sqrt(1 - lam * lam)
    size, q = (1 + s) / 2, (lam / (1 + s)) ** 2
    terms = MOST if q**MOST > 1e-9 else int(np.ceil(-20 / np.log(q))) + 2
    sizes = _halves(terms + k)
    total = float(np.sum(sizes[:terms] * sizes[k : k + terms] * q ** (2.0 * np.arange(terms) + k)))
    return size * total * (2 if k else 1)


def _halves(count: int) -> Array:
    """Binomial coefficients (1/2 over j), j = 0 … count − 1."""
    j = np.arange(1, count)
    return np.cumprod(np.append(1.0, (1.5 - j) / j))


def root_series(lam: float, order: int, terms: int) -> float:
    """The same by so many terms of the power series in λ: c₂ ≈ λ²/4 + λ⁴/16, c₄ ≈ −λ⁴/64."""
    if order % 2:
        return 0.0
    k = order // 2
    sizes = _halves(k + terms)
    total = 0.0
    for n in range(k, k + terms):
        whole = comb(2 * n, n - k) / 4**n * (2 if k else 1)
        total += sizes[n] * (-1) ** (n + k) * whole * lam ** (2 * n)
    return float(total)


def acceleration_exact(lam: float, order: int) -> float:
    """A of cos(order·φ) in −a/(r ω²), no offset: A₁ = 1, A₂, A₄, A₆ …"""
    return 1.0 if order == 1 else order**2 * root_exact(lam, order) / lam


def acceleration_series(lam: float, order: int, terms: int = 2) -> float:
    """A₂ ≈ λ + λ³/4, A₄ ≈ −λ³/4 − 3λ⁵/16, A₆ ≈ 9λ⁵/128 + …: so many terms of the power series."""
    return 1.0 if order == 1 else order**2 * root_series(lam, order, terms) / lam


def acceleration_harmonics(lam: float, highest: int, offset: float = 0.0, count: int = 1024) -> Series:
    """Harmonics of −a/(r ω²) with an offset e/l of the guide too: cosines and sines, odd orders beside the even.

    Without an offset by the closed coefficients, whose small ones do not drown in the rounding of sums."""
    if not offset:
        own = [0.0, *(acceleration_exact(lam, order) for order in range(1, highest + 1))]
        return Series(np.array(own), np.zeros(highest + 1))
    phi = np.arange(count) * (2 * np.pi / count)
    found = fourier.series(np.cos(phi) + rod_cosine(lam, phi, offset) / lam, highest)
    squares = np.arange(highest + 1) ** 2
    return Series(found.cosine * squares, found.sine * squares)


# ---------------------------------------------------------------- slider-cranks within a mechanism

ORDERS = (1, 2, 4, 6)
ALL = 6  # orders of an offset slider-crank: sines and odd ones too
CENTRAL = 1e-9  # of the rod: an offset that is rounding


@dataclass(frozen=True, eq=False)
class SliderCrank:
    """Driving link, rod and slider on a fixed guide. `pivot`, `pin`, `joint`: names of the points O, A, B; `r`, `l`,
    m; `offset`: of the pivot from the line of B, m, in the sense of rotation; `along`: unit direction from the pivot
    towards the slider; `start`: angle of the crank from it at position 0, in the sense of rotation, rad; `mass`: what
    reciprocates, kg."""

    rod: str
    slider: str
    pivot: str
    pin: str
    joint: str
    r: float
    l: float
    offset: float
    along: complex
    start: float
    mass: float
    harmonics: Series

    @property
    def lam(self) -> float:
        return self.r / self.l

    @property
    def central(self) -> bool:
        return abs(self.offset) <= CENTRAL * self.l

    @property
    def orders(self) -> tuple[int, ...]:
        return ORDERS if self.central else tuple(range(1, ALL + 1))

    def force(self, omega: float, order: int) -> float:
        """Amplitude of the inertia force of the order along the guide, N."""
        return self.mass * self.r * omega**2 * float(self.harmonics.amplitude[order])

    def product(self, order: int) -> float:
        """m r of each of the two rotors that balance the order, kg m: m_I r_I = m_B r/2, m_II r_II = A₂ m_B r/8."""
        return self.mass * self.r * float(self.harmonics.amplitude[order]) / (2 * order**2)

    def angle(self, turned: Array) -> Array:
        """Angle of the crank from the guide's direction, in the sense of rotation, rad."""
        return self.start + turned


def slider_cranks(linkage: Linkage, cycle: Cycle, sliding: Mapping[str, float]) -> Iterator[SliderCrank]:
    """Found by structure, whatever the names: a dyad of rod and slider on the driving link and a fixed guide, whose
    motion has all angles of the crank. `sliding`: reciprocating masses by the sliding links. A link that replaces a
    cam pair is no rod: it is another in every position."""
    driver, put = linkage.mechanism.driver.link, {cam.name for cam in linkage.mechanism.cams}
    for group in linkage.groups:
        if not isinstance(group, Dyad) or group.kind != 2 or put & set(group.links):
            continue
        if group.carrier_a == driver and group.carrier_b == FRAME:
            found = _slider_crank(linkage, cycle, group, sliding.get(group.b, 0.0))
            if found is not None:
                yield found


def _slider_crank(linkage: Linkage, cycle: Cycle, group: Dyad, mass: float) -> SliderCrank | None:
    """None where the rod turns over: that has other formulas."""
    pair, driver = linkage.structure.driver_pair, linkage.mechanism.driver.link
    pivot = complex(pair.at[FRAME])
    pin = complex(group.outer_a.at[driver] - pair.at[driver])
    r, length = abs(pin), abs(complex(group.inner.at[group.a] - group.outer_a.at[group.a]))
    motion = cycle.motion(np.array([0.0, np.pi / 2, np.pi, 3 * np.pi / 2]))
    place = motion.state.world(group.a, group.inner.at[group.a])
    along = complex(group.outer_b.along[FRAME])
    along = along if np.mean(dot(place - pivot, along)) > 0 else -along
    offset = cycle.sense * float(np.mean(cross(along + 0 * place, place - pivot)))
    offset = 0.0 if abs(offset) <= CENTRAL * length else offset
    if r + abs(offset) >= length * (1 - CENTRAL):
        return None
    turn = complex(motion.turn(driver)[0]) * pin / abs(pin)
    start = cycle.sense * float(np.angle(turn / along))
    harmonics = acceleration_harmonics(r / length, ALL, offset / length)
    return SliderCrank(
        group.a, group.b, pair.name, group.outer_a.name, group.inner.name, r, length, offset, along, start, mass,
        harmonics,
    )  # fmt: skip
