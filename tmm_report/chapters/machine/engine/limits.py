"""Limits of the counterweight, the shafts that balance what is left, the order of firing."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import Any

import numpy as np

from tmm_report.chapters.machine.engine.given import Given
from tmm_report.chapters.machine.engine.values import Values
from tmm_report.mechanics.masses.engine_cylinders import Turning
from tmm_report.problems import N_, Message, ProblemError, mistake
from tmm_report.records import dataclass

Array = Any
NOTHING = 1e-9  # of the scale: less is rounding
SAME = 1e-6  # rad: angles of firing so close coincide


def series(lam: float) -> dict[int, float]:
    """Coefficients of the series of the piston's acceleration in λ, each to its first term.

    1, λ, −λ³/4, 9 λ⁵/128 of the orders 1, 2, 4, 6.
    """
    return {1: 1.0, 2: lam, 4: -(lam**3) / 4, 6: 9 * lam**5 / 128}


def check_share(s: Values, given: Given) -> None:
    """Of a counterweight whose mass and radius are stated. Raises ProblemError."""
    of = given.counterweights
    if of is None or of.share is not None or 0 <= s.number("share") <= 1:
        return
    up, down = s.number("m"), s.get("m_rot") or 0.0
    least, most = (f"{(down + part * up) * given.crank_radius / s.number('r_cw'):.4g}" for part in (0.0, 1.0))
    text = N_(
        "the counterweight does not balance the rotating mass, or more than all of the reciprocating one: "
        "its share is %(share)s"
    )
    right = Message(N_("a mass from %(least)s to %(most)s kg at this radius"), {"least": least, "most": most})
    path = ("engine", "counterweights", "mass")
    raise ProblemError([mistake(text, path, right, share=f"{s.number('share'):.3g}")])


def peak(sizes: Array) -> float:
    """The greatest of periodic samples (P,), between them by the parabola through three."""
    k = int(np.argmax(sizes))
    before, top, after = sizes[k - 1], sizes[k], sizes[(k + 1) % len(sizes)]
    bend = before - 2 * top + after
    return float(top - (after - before) ** 2 / (8 * bend)) if bend < -1e-6 * top else float(top)


# --- balancing shafts


@dataclass(frozen=True)
class Remedy:
    """What balances a force or a couple of an order. `kind`: "none" (nothing is left), "forward" (it turns with the
    crankshaft), "backward", "pair" (it swings along a line: two shafts that turn in opposite senses carry equal
    weights) or "unequal". `forward`, `backward`: products of the weights at φ = 0, kg m or kg m², complex."""

    order: int
    of: str
    kind: str
    forward: complex
    backward: complex


def remedy(order: int, of: str, turning: Turning, speed: float, scale: float) -> Remedy:
    """`turning` in N or N m; weights on shafts that turn at ± order ω. `scale`: beside which a vector is nothing."""
    rate = (order * speed) ** 2
    forward, backward = (complex(-part / rate) for part in turning)
    ahead, back = (abs(part) > NOTHING * scale for part in turning)
    alike = abs(abs(turning.forward) - abs(turning.backward)) <= NOTHING * scale
    if ahead and back:
        kind = "pair" if alike else "unequal"
    else:
        kind = "forward" if ahead else "backward" if back else "none"
    return Remedy(order, of, kind, forward if ahead else 0j, backward if back else 0j)


# --- firing


@dataclass(frozen=True)
class Fired:
    """A cylinder, the crankshaft's angle at which it fires, rad from the first, and the angle to the next."""

    name: str
    angle: float
    interval: float


def firing(given: Given, banks: Array, angles: Array) -> tuple[Fired, ...]:
    """In the stated order, each in the first turn after the one before it; what the cycle then wants of turns goes to
    the smallest interval, so that it does not matter which cylinder is named first."""
    if not given.firing:
        return ()
    names = [one.name for one in given.laid]
    dead = {name: float(b - a) for name, b, a in zip(names, banks, angles, strict=True)}
    order = [*given.firing, given.firing[0]]
    steps = [_turn(dead[other] - dead[one], given.strokes) for one, other in pairwise(order)]
    missing = np.pi * given.strokes - sum(steps)
    if missing > SAME:
        steps[_smallest(steps, [names.index(name) for name in given.firing])] += missing
    at = np.concatenate([[0.0], np.cumsum(steps)])
    return tuple(Fired(name, float(x), step) for name, x, step in zip(given.firing, at, steps, strict=False))


def _smallest(steps: Sequence[float], rows: Sequence[int]) -> int:
    """Number of the smallest step; of equal ones that after the cylinder that is stated last, of nothing the last."""
    equal = [k for k, step in enumerate(steps) if step < min(steps) + SAME]
    return max(equal, key=lambda k: rows[k] if steps[k] > SAME else k)


def _turn(angle: float, strokes: int) -> float:
    """Less than a turn; of pistons that reach the top together a whole one, as they fire by turns, but in a two-stroke
    engine, which fires in every cylinder every turn, nothing."""
    turned = float(np.mod(angle, 2 * np.pi))
    if SAME < turned < 2 * np.pi - SAME:
        return turned
    return 0.0 if strokes == 2 else 2 * np.pi


def check(fired: tuple[Fired, ...], given: Given) -> None:
    """Raises ProblemError where the order takes more turns than the cycle has."""
    cycle = np.pi * given.strokes
    whole = sum(one.interval for one in fired)
    if len(fired) > 1 and abs(whole - cycle) > SAME:
        text = N_(
            "the order of firing cannot be: with these cranks it takes %(found)s° of the crankshaft, the cycle of a "
            "%(strokes)s-stroke engine has %(cycle)s°"
        )
        values = {"found": f"{np.degrees(whole):.4g}", "cycle": f"{np.degrees(cycle):.4g}"}
        right = Message(
            N_(
                "an order that the cranks allow as the shaft turns counter-clockwise, for example 1, 3, 4, 2 of cranks "
                "0, 180, 180, 0 deg"
            )
        )
        raise ProblemError([mistake(text, ("engine", "firing"), right, strokes=given.strokes, **values)])
