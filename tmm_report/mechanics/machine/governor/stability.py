"""The closed loop of a machine and its governor for small deviations: matrices, characteristic equations, stability.

Deviations from the steady state are relative: φ = Δω/ω of the machine, η = Δz/h of the sleeve, ϑ = dη/dt, σ = Δs of the
supply, ξ = x/h of the isodromic feedback. (Vyshnegradsky 1876; Stodola 1893; Hurwitz, Math. Ann. 46, 1895;
Popov, Theory of automatic control systems; Neimark 1948 for the boundary over two parameters)
"""

from __future__ import annotations

from typing import Any

import numpy as np

from tmm_report.records import dataclass

Array = Any


@dataclass(frozen=True)
class Loop:
    """What small motions depend on, SI: inertia `J` of the machine; `D` = −∂(M_d s − M_c)/∂ω its self-regulation, N m
    s; `M` moment of the full supply at the steady speed, `supply` = −ds/dη of the throttle that the sleeve moves;
    reduced mass `m` of the governor, its damper `k`, factor of stability `S`, `R` = 2 A ω_g i by which the speed
    lifts the sleeve, N s; steady speed `omega` of the machine; lift `h` of the sleeve."""

    J: float
    D: float
    M: float
    supply: float
    m: float
    k: float
    S: float
    R: float
    omega: float
    h: float

    @property
    def Q(self) -> float:
        """Moment by which a unit of lift lowers the drive, N."""
        return self.M * self.supply / self.h


@dataclass(frozen=True)
class Servo:
    """`T`: time of the whole stroke of the piston with the valve shifted by the whole lift of the sleeve, s; `zone`:
    shift of the valve within which it stays closed, m; isodromic feedback: `beta`: shift of the valve, in lifts, by
    the whole stroke of the piston, `Ti`: the time in which the dashpot lets it go, s; without one both are 0."""

    T: float
    zone: float = 0.0
    beta: float = 0.0
    Ti: float = 0.0


# --- direct action


def cubic(loop: Loop) -> Array:
    """Coefficients a0 … a3 of J m λ³ + (J k + D m) λ² + (J S + D k) λ + D S + Q R, SI."""
    return np.array(
        [
            loop.J * loop.m,
            loop.J * loop.k + loop.D * loop.m,
            loop.J * loop.S + loop.D * loop.k,
            loop.D * loop.S + loop.Q * loop.R,
        ]
    )


def vyshnegradsky(coefficients: Array) -> tuple[float, float]:
    """X, Y of q³ + X q² + Y q + 1, to which λ = q (a3/a0)^⅓ brings the cubic. Raises ValueError where a3/a0 is not
    positive: then a root is positive, or nought, whatever X and Y."""
    a0, a1, a2, a3 = coefficients
    if not a3 / a0 > 0:
        raise ValueError("the last coefficient is not positive")
    p = (a3 / a0) ** (1 / 3)
    return float(a1 / a0 / p), float(a2 / a0 / p**2)


def damping_needed(loop: Loop) -> float | None:
    """The damper k with which the direct loop is at the boundary of stability, N s/m: the positive root of a1 a2 = a0
    a3, a quadratic in k. 0 where none is needed; None where no damper helps."""
    J, D, m, S = loop.J, loop.D, loop.m, loop.S
    if D * S + loop.Q * loop.R <= 0:
        return None
    a, b = J * D, J * J * S + D * D * m
    c = D * m * J * S - J * m * (D * S + loop.Q * loop.R)
    if c >= 0 and b >= 0:
        return 0.0
    if a == 0:
        return -c / b if b > 0 else None
    return float((-b + np.sqrt(b * b - 4 * a * c)) / (2 * a))


# --- matrices

DIRECT = ("phi", "eta", "vartheta")
SERVO = (*DIRECT, "sigma")
ISODROME = (*SERVO, "xi")


def matrix(loop: Loop, servo: Servo | None = None) -> Array:
    """The matrix of the states `DIRECT`, with a servo `SERVO`, with an isodrome `ISODROME`; its elements are in 1/s
    but for the rows of ϑ."""
    drive = loop.M / (loop.J * loop.omega)
    lifted = [loop.R * loop.omega / (loop.m * loop.h), -loop.S / loop.m, -loop.k / loop.m]
    damped = -loop.D / loop.J
    if servo is None:
        return np.array([[damped, -drive * loop.supply, 0.0], [0.0, 0.0, 1.0], lifted])
    if not servo.beta:
        return np.array(
            [[damped, 0, 0, drive], [0, 0, 1, 0], [*lifted, 0], [0, -1 / servo.T, 0, 0]], dtype=float
        )
    back = servo.beta / servo.T
    return np.array(
        [
            [damped, 0, 0, drive, 0],
            [0, 0, 1, 0, 0],
            [*lifted, 0, 0],
            [0, -1 / servo.T, 0, 0, -1 / servo.T],
            [0, -back, 0, 0, -back - 1 / servo.Ti],
        ],
        dtype=float,
    )


def states(servo: Servo | None) -> tuple[str, ...]:
    """Names of the states of `matrix`."""
    return DIRECT if servo is None else ISODROME if servo.beta else SERVO


def polynomial(loop: Loop, servo: Servo | None = None) -> Array:
    """Characteristic polynomial from the equations of the elements, highest power first and that coefficient 1; a
    second way beside the matrix."""
    machine = np.array([loop.J, loop.D])
    governor = np.array([loop.m, loop.k, loop.S])
    both = np.polymul(machine, governor)
    if servo is None:
        found = np.polyadd(both, [loop.Q * loop.R])
    elif not servo.beta:
        found = np.polyadd(np.polymul(both, [loop.h * servo.T, 0.0]), [loop.M * loop.R])
    else:
        rate = 1 / servo.Ti
        open_ = np.polymul(both, [loop.h * servo.T, 0.0])
        found = np.polyadd(np.polymul(open_, [1.0, rate]), loop.M * loop.R * np.array([1.0, rate]))
        found = np.polyadd(found, np.polymul(both, [servo.beta * loop.h, 0.0]))
    return np.asarray(found / found[0])


# --- criteria


def hurwitz(coefficients: Array) -> Array:
    """Determinants Δ1 … Δn of the polynomial (n + 1,), highest power first; all of them and the leading coefficient are
    positive exactly where all roots lie in the left half plane (Hurwitz)."""
    a = np.asarray(coefficients, dtype=float)
    n = len(a) - 1
    row, column = np.indices((n, n))
    place = 2 * (column + 1) - (row + 1)
    table = np.where((place >= 0) & (place <= n), a[np.clip(place, 0, n)], 0.0)
    return np.array([np.linalg.det(table[:k, :k]) for k in range(1, n + 1)])


def stable(coefficients: Array) -> bool:
    return bool(coefficients[0] > 0 and (hurwitz(coefficients) > 0).all())


# --- charts


def hyperbola(x: Array) -> Array:
    """Y = 1/X, the boundary of stability on Vyshnegradsky's diagram."""
    return 1 / np.asarray(x, dtype=float)


def double_roots(a: Array) -> tuple[Array, Array]:
    """X, Y of the curve on which two roots −a of q³ + X q² + Y q + 1 are equal: within it, to the right of its cusp
    (3, 3) at a = 1, all three are real and the process has no oscillations."""
    a = np.asarray(a, dtype=float)
    return 2 * a + a**-2, a**2 + 2 / a


def equal_decay(x: Array) -> Array:
    """Y of the curve from infinity to (3, 3) on which the real root and the complex pair die away alike: above it the
    real one is slower, below it the oscillation."""
    x = np.asarray(x, dtype=float)
    return 2 * x**2 / 9 + 3 / x


def discriminant(x: float, y: float) -> float:
    """Of q³ + X q² + Y q + 1: not negative where all roots are real."""
    return x * x * y * y - 4 * x**3 - 4 * y**3 + 18 * x * y - 27


def kind(x: float, y: float) -> str:
    """The region of Vyshnegradsky's diagram: "unstable"; "monotonic": all roots real; "aperiodic": the real root dies
    away more slowly than the oscillation; "oscillating"."""
    if x <= 0 or x * y <= 1:
        return "unstable"
    if discriminant(x, y) >= -1e-9 * (x * y) ** 2:
        return "monotonic"
    roots = np.roots([1.0, x, y, 1.0])
    alone = np.argmin(np.abs(roots.imag))
    return "aperiodic" if roots[alone].real > np.delete(roots, alone)[0].real else "oscillating"


def isodrome_boundary(loop: Loop, T: float, nu: Array) -> tuple[Array, Array]:
    """(β, 1/T_i) at which ±iν are roots of the loop with an isodrome, both (P,): the characteristic equation is
    linear in the two, q [λ h T P + M R] + β [h λ P] + λ [λ h T P + M R] = 0 with P = (Jλ + D)(mλ² + kλ + S), q =
    1/T_i, λ = iν (Neimark's D-partition)."""
    s = 1j * np.asarray(nu, dtype=float)
    P = (loop.J * s + loop.D) * (loop.m * s**2 + loop.k * s + loop.S)
    one, two = s * loop.h * T * P + loop.M * loop.R, loop.h * s * P
    known = s * one
    determinant = np.imag(np.conj(one) * two)
    with np.errstate(divide="ignore", invalid="ignore"):
        q = -np.imag(np.conj(known) * two) / determinant
        beta = -np.imag(np.conj(one) * known) / determinant
    return beta, q


def linear(A: Array, start: Array, t: float, count: int) -> Array:
    """x(t) of x' = A x from `start` (N,) at `count` even moments from 0 to t, (N, count): powers of the matrix
    exponential of one step, by doubling."""
    step = exponential(np.asarray(A) * (t / (count - 1)))
    found = np.asarray(start, dtype=float)[:, None]
    while found.shape[1] < count:
        found = np.concatenate([found, step @ found], axis=1)
        step = step @ step
    return found[:, :count]


def exponential(A: Array) -> Array:
    """exp A of a small matrix: its series after halving to a norm below 1/2, squared back (scaling and squaring)."""
    halvings = max(0, int(np.ceil(np.log2(max(np.abs(A).sum(axis=1).max(), 1e-300)))) + 1)
    small, total, term = A / 2**halvings, np.eye(len(A)), np.eye(len(A))
    for k in range(1, 18):
        term = term @ small / k
        total = total + term
    for _ in range(halvings):
        total = total @ total
    return total
