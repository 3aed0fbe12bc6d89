"""Newton's method on the constraint equations of the whole mechanism, followed from position to position.

It begins at position 0 in the assembly that the linkage states there, whose places it takes from the groups; from then
on it knows nothing of them. Where the driving link makes full turns, what cannot be reached forwards is sought
backwards; where both ways together leave no gap they may be two assemblies, and the second counts for nothing. Places
are followed roughly, and then polished at all positions at once.
Source: Haug, Computer aided kinematics and dynamics of mechanical systems, ch. 4; Nikravesh, ch. 5.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from tmm_report.mechanics.lever.cycle import Cycle
from tmm_report.mechanics.lever.loop_equations import solve_each
from tmm_report.mechanics.lever.motion import SINGULAR, Motion
from tmm_report.mechanics.rivals.motion.coordinates import Coordinates, coordinates
from tmm_report.problems import N_

Array = Any
March = Callable[[Coordinates, Array, Sequence[float]], Array]

ROUGH = 1e-4  # rad, and of lengths over the size: the last step of a rough solution, its error is its square
FINE = 1e-12
NEAR = 0.2  # the same: a root farther from where it was expected may be another assembly's
ITERATIONS = 12
PLAIN_ITERATIONS = 50
HALVINGS = 8  # of a step between two positions
POLISHES = 6
CLOSED = 1e-10  # of the equations: what is kept where rounding lets Newton's method settle no better


def newton(cycle: Cycle, count: int) -> Motion:
    """Motion by Newton's method with its step in hand.

    A position is expected on the tangent through the one before. A root farther than `NEAR` from there, or one at which
    the Jacobian's determinant has another sign, is not taken: the step is halved, at most `HALVINGS` times. A position
    that is not reached is nan, and all beyond it; so is a jump to another assembly, at which the determinant of a
    group's equations has changed its sign. A singular position is therefore an end: nothing in the equations says how
    the motion goes on. Raises ArithmeticError where position 0 cannot be assembled or is singular.
    """
    return followed(cycle, count, guarded, check=True, both_ways=True)


def plain_newton(cycle: Cycle, count: int) -> Motion:
    """Motion by the textbook's iteration: from the position before, whatever root it comes to; nan where it does not
    settle. Nothing notices a jump to another assembly."""
    return followed(cycle, count, plain, check=False)


def followed(cycle: Cycle, count: int, march: March, *, check: bool, both_ways: bool = False) -> Motion:
    """Motion at `count` steps of the cycle, followed by `march`; `check`: what has changed its assembly is nan.
    `both_ways`: what is not reached forwards is sought backwards."""
    c = coordinates(cycle.linkage)
    turned, where = np.unique(cycle.once(count), return_inverse=True)
    with np.errstate(all="ignore"):
        start = begin(c, cycle, check)
        q = _one_way(c, start, cycle.phi(turned), march, check)
        if both_ways and cycle.closed and np.isnan(q).any():
            back = _one_way(c, start, cycle.phi(np.append(0.0, turned[:0:-1] - cycle.sweep)), march, check)
            both = np.where(np.isfinite(q), q, np.concatenate([back[:1], back[:0:-1]]))
            q = both if np.isnan(both).any() else q
        phi = cycle.phi(turned[where])
        q = q[where]
        return c.motion(phi, q, *c.rates(q, phi))


def begin(c: Coordinates, cycle: Cycle, check: bool = True) -> Array:
    """q of position 0 in the assembly that the linkage states, (3n,). Raises ArithmeticError where there is none, and,
    with `check`, where it is singular."""
    motion = cycle.motion(np.array([0.0]))
    q = c.read(motion)[0]
    if not np.isfinite(q).all():
        raise ArithmeticError(N_("position 0 cannot be assembled"))
    if check and any(sine[0] < SINGULAR for sine in motion.sines.values()):
        raise ArithmeticError(N_("position 0 is singular: nothing says in which assembly the motion goes on"))
    return q


def _one_way(c: Coordinates, start: Array, phi: Array, march: March, check: bool) -> Array:
    """q at driver angles that lead away from the start's, phi[0]; nan from where they are not reached."""
    q = march(c, start, [float(x) for x in phi])
    return same_assembly(c, q, phi) if check else q


def same_assembly(c: Coordinates, q: Array, phi: Array) -> Array:
    """q with nan from where some group's determinant has no longer the sign that it has in the first position, or is
    nothing beside the first (`SINGULAR`): there two assemblies meet, and the sign tells them apart no more."""
    _, J = c.equations(q, phi)
    kept = np.isfinite(q).all(axis=-1)
    sines = c.sines(np.where(kept[:, None, None], J, 0.0))
    with np.errstate(invalid="ignore"):
        kept &= (sines / sines[0] > SINGULAR).all(axis=-1)
    return np.where(np.logical_and.accumulate(kept)[:, None], q, np.nan)


# ---------------------------------------------------------------- from one position to the next


def guarded(c: Coordinates, start: Array, phi: Sequence[float]) -> Array:
    """q along the tangents, step by step, halved where it goes astray; nan from the first position not reached."""
    found = np.full((len(phi), c.count), np.nan)
    _, tangent, sign = _newton_step(c, start, phi[0])
    at = (start, tangent)
    for k, angle in enumerate(phi):
        on = _advance(c, at, phi[max(k - 1, 0)], angle, sign, HALVINGS)
        if on is None:
            break
        found[k], at = on[0], on
    return polished(c, found, np.array(phi))


def _advance(
    c: Coordinates, at: tuple[Array, Array], here: float, there: float, sign: float, halvings: int
) -> tuple[Array, Array] | None:
    """q and its tangent at driver angle `there` from those at `here`; None where no step is short enough."""
    guess = at[0] + at[1] * (there - here)
    found = _settled(c, guess, there)
    if found is not None and np.abs(found[0] - guess).max() <= NEAR and found[2] == sign:
        return found[:2]
    if not halvings:
        return None
    middle = (here + there) / 2
    half = _advance(c, at, here, middle, sign, halvings - 1)
    return None if half is None else _advance(c, half, middle, there, sign, halvings - 1)


def _settled(c: Coordinates, q: Array, phi: float) -> tuple[Array, Array, float] | None:
    """A rough root near q, its tangent q' and the determinant's sign; None where Newton's method comes to none."""
    for _ in range(ITERATIONS):
        step, tangent, sign = _newton_step(c, q, phi)
        q = q - step
        size = np.abs(step).max()
        if size < ROUGH:
            return q, tangent, sign
        if not size < 1e3:
            break
    return None


def _newton_step(c: Coordinates, q: Array, phi: float) -> tuple[Array, Array, float]:
    """Φ_q⁻¹Φ, the tangent q' = −Φ_q⁻¹Φ_φ, nan where Φ_q is singular, and the sign of its determinant: another one in
    the assembly that meets this one in a singular position."""
    left, J = c.equations(q[None], np.array([phi]))
    right = np.stack([left[0], np.zeros(c.count)], axis=-1)
    right[-1, 1] = 1.0
    try:
        both = np.linalg.solve(J[0], right)
    except np.linalg.LinAlgError:
        both = np.full(right.shape, np.nan)
    return both[:, 0], both[:, 1], float(np.linalg.slogdet(J[0])[0])


def plain(c: Coordinates, start: Array, phi: Sequence[float]) -> Array:
    """q of every position from that of the last one found; nan where the iteration does not settle."""
    found = np.full((len(phi), c.count), np.nan)
    q = start
    for k, angle in enumerate(phi):
        trial = q
        for _ in range(PLAIN_ITERATIONS):
            step = _newton_step(c, trial, angle)[0]
            trial = trial - step
            if not np.abs(step).max() > FINE:
                break
        if np.abs(step).max() <= 1e3 * FINE:
            found[k] = q = trial
    return found


def polished(c: Coordinates, q: Array, phi: Array, room: float = NEAR) -> Array:
    """Rough roots (P, 3n) made exact, all at once; nan where they move away by more than `room` or do not close."""
    rough = q
    for _ in range(POLISHES):
        left, J = c.equations(q, phi)
        step = solve_each(J, left)
        q = np.where(np.isfinite(step), q - step, q)
        if not np.nanmax(np.abs(step), initial=0.0) > FINE:
            break
    closed = np.abs(c.residual(q, phi)).max(axis=-1) <= CLOSED
    near = np.abs(q - rough).max(axis=-1) <= room
    return np.where((closed & near)[:, None], q, np.nan)
