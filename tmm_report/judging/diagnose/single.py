"""Mistakes seen in a column by itself: its sign, its unit, a factor, its positions."""

from __future__ import annotations

import math
import re
from functools import lru_cache
from typing import Any

import numpy as np

from tmm_report.judging.diagnose.candidates import SHARE, Candidates, Mistake
from tmm_report.judging.diagnose.columns import LOUD, Stack
from tmm_report.judging.model import Asked

Array = Any

RPM, DEGREES, GRAVITY = 30 / math.pi, 180 / math.pi, 9.81
STEPS = 6  # how far positions may be shifted
NEAR_ONE = 0.05  # a factor nearer to 1 is no other scale

SIGN = Mistake("sign", special=True)
MODULUS = Mistake("modulus", cost=0.2)
_TENS = [Mistake("power of ten", f"10^{k}", 10.0**k, cost=0.5) for k in range(-6, 7) if k]
REVERSED = Mistake("reversed", cost=0.8, broad=True)
ROTATION = Mistake("reversed", "rotation", cost=0.9, broad=True)  # the crank turned the other way
FACTORS = (
    *(Mistake("mm for m", f"{by:g}", by, special=True) for by in (1e3, 1e-3, 1e6, 1e-6)),
    *(Mistake("rpm for rad/s", f"{by:.4g}", by, special=True) for by in (RPM, 1 / RPM)),
    *(Mistake("degrees for radians", f"{by:.4g}", by, special=True) for by in (DEGREES, 1 / DEGREES)),
    *(Mistake("mass for weight", f"{by:.4g}", by, cost=0.2, special=True) for by in (1 / GRAVITY,)),
    *(Mistake("factor", f"{by:g}", by, cost=0.4) for by in (2.0, 0.5)),
    *_TENS,
)


def factors(stack: Stack, found: Candidates) -> None:
    """A unit or a factor all along: the student's numbers are `by` times the right ones."""
    by = np.array([mistake.by for mistake in FACTORS])
    undone = stack.mine[:, None] / by[:, None]
    applies = np.array([_applies(one.unit, one.angle) for one in stack.asked])
    found.add(FACTORS, stack, stack.fit(undone, stack.right[:, None]), applies)


@lru_cache(maxsize=1024)
def _applies(unit: str, angle: bool) -> tuple[bool, ...]:
    """Which of FACTORS can be met in a unit."""
    metres = _metres(unit)
    lengths = [1e3**metres, 1e-3**metres] if metres else []

    def applies(mistake: Mistake) -> bool:
        match mistake.kind:
            case "mm for m":
                return any(math.isclose(mistake.by, by) for by in lengths)
            case "rpm for rad/s":
                return unit == ("rad/s" if mistake.by > 1 else "rpm")
            case "degrees for radians":
                return unit.startswith("rad") if mistake.by > 1 else unit == "deg"
            case "mass for weight":
                return unit == "N"
            case "power of ten":
                return not angle and not any(math.isclose(mistake.by, by) for by in lengths)
            case _:
                return not angle

    return tuple(applies(mistake) for mistake in FACTORS)


@lru_cache(maxsize=1024)
def _metres(unit: str) -> int:
    """The power of metres in a unit's numerator: 1 of m/s² and N·m, 2 of kg·m²."""
    for part in re.split(r"[·*]", unit.split("/")[0]):
        if part[:1] == "m" and part[1:] in ("", "²", "³", "⁴"):
            return " ²³⁴".index(part[1:] or " ") + 1
    return 0


def signs(stack: Stack, found: Candidates) -> None:
    """The opposite sign all along; magnitudes where a sign is asked."""
    undone = np.stack([-stack.mine, np.copysign(stack.mine, stack.right)], axis=1)
    unsigned = ~(stack.mine < -stack.floor).any(axis=1)
    signed = ~stack.magnitudes[:, 0]
    turning = np.isfinite(stack.turn[:, 0])
    applies = np.stack([signed, signed & unsigned & ~turning], axis=1)
    found.add((SIGN, MODULUS), stack, stack.fit(undone, stack.right[:, None]), applies)


def scales(stack: Stack, found: Candidates) -> None:
    """One free factor: every column of one unit is tried with the factor of each. A column that hardly changes from
    cell to cell shows no factor by itself, as any number would do."""
    ratio, turning = _ratios(stack), np.isfinite(stack.turn[:, 0])
    free = (
        (ratio > 0) & (np.abs(np.log(np.where(ratio > 0, ratio, 1))) > NEAR_ONE) & ~turning & _varies(stack)
    )
    alone = stack.fit((stack.mine / ratio[:, None])[:, None], stack.right[:, None])
    seeds = np.flatnonzero(free & (alone.right[:, 0] >= SHARE * stack.count))
    if not len(seeds):
        return
    units = np.array([one.unit for one in stack.asked])
    mistakes = [Mistake("scale", f"{ratio[c]:.4g}", float(ratio[c]), cost=1.5) for c in seeds]
    fit = stack.fit(stack.mine[:, None] / ratio[seeds][:, None], stack.right[:, None])
    found.add(mistakes, stack, fit, (units[:, None] == units[seeds]) & ~turning[:, None])


def _ratios(stack: Stack) -> Array:
    """(C,): the median of what the student's numbers are of the right ones, far from 0; nan where none is."""
    loud = stack.answered & (np.abs(stack.right) > LOUD * stack.floor)
    parts = np.where(loud, stack.mine / stack.right, np.nan)
    parts = np.where(stack.magnitudes, np.abs(parts), parts)
    ratios = np.full(len(parts), np.nan)
    ratios[loud.any(axis=1)] = np.nanmedian(parts[loud.any(axis=1)], axis=1)
    return ratios


def _varies(stack: Stack) -> Array:
    """(C,): whether the right numbers change from cell to cell by more than agreement allows."""
    size = np.where(stack.answered, np.abs(stack.right), np.nan)
    return np.nanmax(size, axis=1) - np.nanmin(size, axis=1) > 4 * stack.limit / 100 * np.nanmax(size, axis=1)


# ---------------------------------------------------------------- positions


def orders(stack: Stack, found: Candidates) -> None:
    """Positions shifted, or counted the other way round, on the closed cycle of N positions."""
    closed = np.array([goes_round(one) for one in stack.asked])
    if not closed.any():
        return
    mistakes, aims = _reordered(stack)
    applies = np.repeat(closed[:, None], len(mistakes), axis=1)
    found.add(mistakes, stack, stack.fit(stack.mine[:, None], aims), applies)


def reordered(stack: Stack, mistake: Mistake) -> Array:
    """(C, P): the right numbers in the rows where a mistake in the order of positions puts them."""
    mistakes, aims = _reordered(stack)
    return aims[:, mistakes.index(mistake)]


def _reordered(stack: Stack) -> tuple[tuple[Mistake, ...], Array]:
    """The mistakes in the order of positions, and (C, T, P): the right numbers as each puts them into the rows."""
    mistakes, turned = _turned(stack.right.shape[1] - 1)
    aims = stack.right[:, turned]
    aims[:, -1] *= np.array([[senses(one)] for one in stack.asked])
    return mistakes, aims


def goes_round(asked: Asked) -> bool:
    """Whether the rows are positions 0, 1, … N, of which the last is the first again."""
    return asked.by_position and _all_positions(asked.rows)


@lru_cache(maxsize=64)
def _all_positions(rows: tuple[str, ...]) -> bool:
    return len(rows) > 3 and rows == tuple(map(str, range(len(rows))))


def senses(asked: Asked) -> float:
    """-1 of what changes its sign with the sense of rotation, as velocities do; 1 of anything else."""
    return -1.0 if asked.unit in ("m/s", "rad/s") and (asked.values < 0).any() else 1.0


@lru_cache(maxsize=64)
def _turned(n: int) -> tuple[tuple[Mistake, ...], Array]:
    """The mistakes in the order of n positions, T of them, and (T, n + 1): whose number each puts into row 0 … n."""
    most = min(STEPS, n // 2)
    steps = [s for s in range(-most, most + 1) if s and s != -n / 2]
    shifts = [
        Mistake("shifted", f"{s:+d}", float(s), cost=0.3 + 0.1 * abs(s), special=abs(s) == 1, broad=True)
        for s in steps
    ]
    here = np.arange(n + 1)
    turned = np.array([*((here + s) % n for s in steps), -here % n, -here % n])
    return (*shifts, REVERSED, ROTATION), turned
