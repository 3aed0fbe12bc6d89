"""Eccentric epicyclic mechanism: sun and ring on parallel axes e apart, satellites of different size between them.

              ring 3, centre O3 = (e, 0)         E = 2e/m, the eccentricity in halves of a module
       .---------------.                         satellite z touches the sun at φ1 (about O1) and
     /   (4)     .      \\                        the ring at φ3 (about O3); all centres lie on one
    |  (5) ( sun 1 ) ( 2 ) |                     ellipse with the foci O1, O3
     \\   (4')    '      /                        2 largest, φ = 0; 5 smallest, φ = 180°; 4 and 4' middle
       '---------------'

Teeth are unshifted: every wheel rolls on its pitch circle. Numbers of teeth broadcast as arrays; angles rad,
lengths m. Source: the theory of the mechanism with the linear Diophantine equation of its teeth is that of the course
guide; conditions of neighbourhood and assembly as in Artobolevsky, Theory of mechanisms and machines, ch. VII.
"""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any, NamedTuple

import numpy as np

from tmm_report.mechanics.gears.meshing import Pair, Rack
from tmm_report.mechanics.gears.pair_sizes import clear_ring_tip

Array = Any

KINDS = ("largest", "middle", "smallest", "middle'")  # the four places whose assembly is exact, by φ1
EXACT = 1e-9  # pitches: a residue that is the rounding of a whole number


# --- teeth ---


class Equation(NamedTuple):
    """a z1 + b z2 + c = 0 in whole numbers: (1 − u) k z1 + 2k z2 − E k = 0."""

    a: int
    b: int
    c: int
    k: int


class Solution(NamedTuple):
    """z1 = first − b1 t, z2 = second + a1 t for every whole t; a x + b y = divisor by the extended Euclid."""

    divisor: int
    x: int
    y: int
    first: int
    second: int
    a1: int
    b1: int


class Family(NamedTuple):
    """Sets of teeth, (T,) each. `satellites` (T, 4) in the order of KINDS; the middle ones may have half a tooth, or
    the largest and the smallest."""

    t: Array
    sun: Array
    ring: Array
    satellites: Array


def equation(u: Fraction, E: int) -> Equation:
    """The equation of the teeth of sun z1 and largest satellite z2 for u = z3/z1 > 1; k makes all of it whole."""
    k = u.denominator
    return Equation(int((1 - u) * k), 2 * k, -E * k, k)


def extended_euclid(a: int, b: int) -> tuple[int, int, int]:
    """(g, x, y) with a x + b y = g = gcd(a, b) > 0."""
    x, y, x_next, y_next = 1, 0, 0, 1
    while b:
        whole, rest = divmod(a, b)
        a, b = b, rest
        x, x_next = x_next, x - whole * x_next
        y, y_next = y_next, y - whole * y_next
    return (a, x, y) if a > 0 else (-a, -x, -y)


def general_solution(eq: Equation) -> Solution | None:
    """All whole solutions; None where gcd(a, b) does not divide c.

    Of the coefficients x + b1 k of Euclid's algorithm the first not under b1 is taken, and y with it, so that t
    counts from a large sun downwards.
    """
    g, x, y = extended_euclid(eq.a, eq.b)
    if eq.c % g:
        return None
    a1, b1 = eq.a // g, eq.b // g
    steps = 1 - x // b1  # x mod b1, and one step further
    x, y = x + b1 * steps, y - a1 * steps
    scale = -eq.c // g
    return Solution(g, x, y, scale * x, scale * y, a1, b1)


def middle_equation(u: Fraction) -> Equation:
    """The same for the middle satellite z4 in the place of z2, (1 − u) k z1 + 2k z4 = 0: it always has solutions."""
    return Equation(*equation(u, 0)[:2], 0, u.denominator)


def family(solution: Solution, u: Fraction, E: int, t: Array, by_middle: bool = False) -> Family:
    """The sets of teeth at the whole numbers t (T,); `by_middle`: the solution is that of `middle_equation`."""
    sun = solution.first - solution.b1 * np.asarray(t)
    second = solution.second + solution.a1 * np.asarray(t)
    largest = second + E / 2 if by_middle else second
    middle = largest - E / 2
    return Family(
        np.asarray(t),
        sun,
        sun * u.numerator // u.denominator,
        np.stack([largest, middle, largest - E, middle], axis=-1),
    )


def range_of(solution: Solution, u: Fraction, least_sun: int, most_ring: int) -> Array:
    """The numbers t with z1 ≥ least_sun and z3 ≤ most_ring, ascending; (T,)."""
    most_sun = most_ring / u
    low, high = (Fraction(solution.first - z) / solution.b1 for z in (most_sun, least_sun))
    return np.arange(math.ceil(low), math.floor(high) + 1)


# --- places ---


def angles(sun: Array, ring: Array, E: Array, z: Array) -> tuple[Array, Array]:
    """φ1 and φ3 of a satellite of z teeth, rad in [0, π], by the cosine rule in the triangle O1 O3 P.

    nan for a satellite that is too small or too large to touch both wheels.
    """
    near, far = sun + z, ring - z  # O1P and O3P in halves of a module
    with np.errstate(divide="ignore", invalid="ignore"):
        cos1 = (near**2 + E**2 - far**2) / (2 * E * near)
        cos3 = (near**2 - far**2 - E**2) / (2 * E * far)
        return _arccos(cos1), _arccos(cos3)


def _arccos(x: Array) -> Array:
    """arccos with the rounding of ±1 taken off."""
    x = np.where(np.abs(np.abs(x) - 1) < 1e-14, np.sign(x), x)
    return np.arccos(x)[()]


def centres(sun: Array, z: Array, phi1: Array, m: float) -> Array:
    """Places of the satellites' axes from O1, complex, m."""
    return m / 2 * (sun + z) * np.exp(1j * phi1)


def belt(sun: Array, ring: Array, first: Array, z: Array, phi1: Array, phi3: Array) -> Array:
    """Pitches in the closed line over a first satellite, sun, this satellite and ring; whole where it assembles.

    L = z2/2 + z1 φ1/360° + z3 φ3/360° + (z/2) (1 − (φ3 − φ1)/180°) over the largest satellite, `first` = z2. Over a
    middle one, for which φ3 = 180° − φ1 leaves z3/2 of the last three, −z3/2 stands for z2/2, `first` = −z3: both
    middle satellites then give a whole number in every set where their teeth are whole.
    """
    turn = 2 * np.pi
    return first / 2 + sun * phi1 / turn + ring * phi3 / turn + z / 2 * (1 - (phi3 - phi1) / np.pi)


def residue(belt: Array) -> Array:
    """What the belt is away from a whole number of pitches, −0.5 … 0.5; exactly 0 where that is rounding."""
    part = belt - np.round(belt)
    return np.where(np.abs(part) < EXACT, 0.0, part)


# --- conditions: each says how much is in hand, m; negative where it fails ---


def distance(sun: Array, one: Array, other: Array, phi: Array, m: float) -> Array:
    """|PiPj| by the cosine rule; `one`, `other`: teeth, `phi`: the angle at O1 between the axes."""
    near, far = m / 2 * (sun + one), m / 2 * (sun + other)
    return np.sqrt(near**2 + far**2 - 2 * near * far * np.cos(phi))


def gaps(sun: Array, z: Array, phi1: Array, m: float, ha: float) -> Array:
    """Free distance between the tip circles of every two satellites, (..., N, N) from (..., N); inf on the diagonal."""
    one, other = z[..., :, None], z[..., None, :]
    apart = distance(np.asarray(sun)[..., None, None], one, other, phi1[..., :, None] - phi1[..., None, :], m)
    free = apart - m / 2 * (one + other) - 2 * ha * m
    return np.where(np.eye(z.shape[-1], dtype=bool), np.inf, free)


def closed_gap(sun: Array, ring: Array, e: float, m: float, ha: float) -> Array:
    """The same for the largest and a middle satellite: √((r1 + r3)²/2 − e²/4) − (r3 − r1) − e/2 − 2 ha* m."""
    r1, r3 = m / 2 * sun, m / 2 * ring
    return np.sqrt((r1 + r3) ** 2 / 2 - e**2 / 4) - (r3 - r1) - e / 2 - 2 * ha * m


def tips_apart(sun: Array, ring: Array, e: float, m: float, ha: float) -> Array:
    """Between the tip circles of sun and ring where they are nearest: r3 − r1 − e − 2 ha* m."""
    return m / 2 * (ring - sun) - e - 2 * ha * m


def internal_pair(ring: Array, z: Array, m: float, rack: Rack) -> Pair:
    """A satellite in the ring, unshifted, at its standard centre distance."""
    return Pair(z, ring, m, rack, 0.0, 0.0, 0.0, m / 2 * (ring - z), internal=True)


def root_in_hand(ring: Array, z: Array, m: float, rack: Rack) -> Array:
    """Radius of curvature of the satellite where the ring's tip touches it; negative: the ring cuts into its root."""
    return internal_pair(ring, z, m, rack).rho_m[0]


def tips_in_hand(ring: Array, z: Array, m: float, rack: Rack) -> Array:
    """Arc on the ring's tip circle between the tips of ring and satellite where their tip circles cross."""
    pair = internal_pair(ring, z, m, rack)
    return pair.fouling * pair.d_a[1] / 2


def ring_tip(ring: int, z: Array, m: float, rack: Rack) -> float:
    """Radius of the ring's tip circle, m: of full height, or larger where it would touch the fillets of a satellite.

    A rack cuts the satellite's involute down to ρ_l = r sin α − ha* m/sin α; a ring of full height asks for more.
    """
    pair = internal_pair(ring, np.asarray(z), m, rack)
    clear = clear_ring_tip(m * ring / 2 * math.cos(rack.alpha), pair.line, pair.rho_l[0])
    return float(max(np.max(pair.d_a[1]) / 2, np.max(clear)))


# --- the largest set of satellites ---


class Candidates(NamedTuple):
    """Every satellite of whole teeth that touches both wheels, by ascending φ1 in [0, 2π); (N,) each."""

    z: Array
    phi1: Array
    phi3: Array
    residue: Array


def candidates(sun: int, ring: int, E: int, by_middle: bool = False) -> Candidates:
    """From the largest at φ = 0 to the smallest at 180° and back on the other side.

    `by_middle`: the residues are those over a middle satellite, in whose company neither of these two need be.
    """
    twice = ring - sun + E
    largest = twice // 2
    z = np.arange(largest, (twice - 1) // 2 - E, -1)
    phi1, phi3 = angles(sun, ring, E, z)
    back = (
        slice(-2, 0, -1) if twice % 2 == 0 else slice(None, None, -1)
    )  # mirrored; whole ends lie on the axis
    z = np.append(z, z[back])
    phi1 = np.append(phi1, -phi1[back] % (2 * np.pi))
    phi3 = np.append(phi3, -phi3[back] % (2 * np.pi))
    first = -ring if by_middle else largest
    return Candidates(z, phi1, phi3, residue(belt(sun, ring, first, z, phi1, phi3)))


def largest_set(gap: Array, clearance: float) -> list[int]:
    """Indices of the most satellites that fit, and of such sets the one with the widest least gap.

    `gap` (N, N): free distances, m. Satellites come in the order of their angle, and each fills the room between sun
    and ring, so only neighbours can collide: the longest closed path over pairs that fit.
    """
    free = np.where(gap > clearance, gap, -np.inf)
    best: tuple[int, float, list[int]] = (0, -np.inf, [])
    for start in range(len(free)):
        best = max(best, _longest_from(free, start), key=lambda found: found[:2])
    return best[2]


def _longest_from(free: Array, start: int) -> tuple[int, float, list[int]]:
    """The longest closed path that begins at `start` and goes upwards: its length, least gap and indices."""
    count = np.full(len(free), -1)
    least = np.full(len(free), -np.inf)
    before = np.full(len(free), -1)
    count[start], least[start] = 1, np.inf
    for j in range(start + 1, len(free)):
        narrow = np.minimum(least, free[:, j])
        reach = np.where(narrow > -np.inf, count, -1)
        i = int(np.lexsort((narrow, reach))[-1])
        if reach[i] > 0:
            count[j], least[j], before[j] = reach[i] + 1, narrow[i], i
    closing = np.where(np.arange(len(free)) == start, np.inf, np.minimum(least, free[:, start]))
    length = np.where(closing > -np.inf, count, -1)
    end = int(np.lexsort((closing, length))[-1])
    path = [end]
    while before[path[-1]] >= 0:
        path.append(int(before[path[-1]]))
    return int(length[end]), float(closing[end]), path[::-1]


def subsets(gap: Array, allowed: Array, clearance: float) -> Array:
    """Which of the four KINDS fit together at most, (..., 4) bool, from gaps (..., 4, 4) and allowed (..., 4).

    Of sets of one size the one with the larger wheels, in the order of KINDS.
    """
    choices = np.array([[bool(bits & (8 >> k)) for k in range(4)] for bits in range(16)])
    clash = ~(gap > clearance)
    bad = np.zeros((*allowed.shape[:-1], 16), dtype=bool)
    for bits, choice in enumerate(choices):
        both = choice[:, None] & choice[None, :]
        bad[..., bits] = (clash & both).any(axis=(-1, -2)) | (choice & ~allowed).any(axis=-1)
    score = np.where(bad, -1, choices.sum(axis=1) * 16 + np.arange(16))
    return choices[np.argmax(score, axis=-1)]
