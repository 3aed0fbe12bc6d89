"""Mistakes seen in a column by itself: its sign, its unit, a factor, its positions."""

from __future__ import annotations

import math
import re
from dataclasses import replace
from functools import lru_cache
from typing import Any

import numpy as np

from tmm_report.judging.diagnose.candidates import LOUD_CELLS, SHARE, Candidates, Mistake
from tmm_report.judging.diagnose.columns import LOUD, Fit, Stack
from tmm_report.judging.model import Asked

Array = Any

RPM, DEGREES, GRAVITY = 30 / math.pi, 180 / math.pi, 9.81
APART = 2.0  # allowances: a number cannot be within the limit of two that lie farther apart
STEPS = 6  # how far positions may be shifted
NEARLY_ALL = 0.9  # of the answered cells: a scale hits every vector of a plan, noise most of them by chance
NEAR_ONE = 0.1  # a factor nearer to 1 is no other scale

TURN = 2 * math.pi
SECONDS = 60.0  # ω = 2πn, not divided
TIGHT = 1 / 3  # of a factor's logarithm: numbers that scatter by more show no scale

SIGN = Mistake("sign", special=True)
MODULUS = Mistake("modulus", cost=0.2)
_TENS = [Mistake("power of ten", f"10^{k}", 10.0**k, cost=0.5) for k in range(-6, 7) if k]
REVERSED = Mistake("reversed", cost=0.8, broad=True)
ROTATION = Mistake("reversed", "rotation", cost=0.9, broad=True)  # the crank turned the other way
SPEEDS = (
    RPM,
    1 / TURN,
    SECONDS,
)  # what stands for ω, in parts of it: n in rpm, n in revolutions a second, 2πn
FACTORS = (
    *(Mistake("mm for m", f"{by:g}", by, special=True) for by in (1e3, 1e-3, 1e6, 1e-6)),
    *(Mistake("rpm for rad/s", f"{by:.4g}", by, special=True) for by in (RPM, 1 / RPM)),
    *(Mistake("turns for radians", f"{by:.4g}", by, special=True) for by in (1 / TURN, TURN)),
    *(Mistake("speed", f"{by:.4g}", by, cost=0.3, special=True) for by in SPEEDS),
    *(Mistake("speed", f"{by:.4g}²", by**2, cost=0.3, special=True) for by in SPEEDS),
    *(Mistake("degrees for radians", f"{by:.4g}", by, special=True) for by in (DEGREES, 1 / DEGREES)),
    *(Mistake("mass for weight", f"{by:.4g}", by, cost=0.2, special=True) for by in (1 / GRAVITY,)),
    *(Mistake("weight for mass", f"{by:.4g}", by, cost=0.2, special=True) for by in (GRAVITY,)),
    Mistake("coriolis", "0.5", 0.5, cost=0.1),
    *(Mistake("radius for diameter", f"{by:g}", by, cost=0.1) for by in (0.5, 2.0)),
    *(Mistake("factor", f"{by:g}", by, cost=0.4) for by in (2.0, 0.5)),
    *_TENS,
)
# the opposite sign besides
NEGATIVE = tuple(replace(one, by=-one.by, cost=one.cost + 0.6) for one in FACTORS)
_CORIOLIS = re.compile(r".*_k(_[xy])?")


def factors(stack: Stack, found: Candidates) -> None:
    """A unit or a factor all along: the student's numbers are `by` times the right ones; or minus as many."""
    mistakes = (*FACTORS, *NEGATIVE)
    by = np.array([mistake.by for mistake in mistakes])
    undone = stack.mine[:, None] / by[:, None]
    able = np.array([_applies(one.unit, one.angle, _trait(one)) for one in stack.asked])
    signed = np.array([one.signed and not one.angle for one in stack.asked])[:, None] & ~stack.magnitudes
    found.add(
        mistakes,
        stack,
        stack.fit(undone, stack.right[:, None]),
        np.concatenate([able, able & signed], axis=1),
    )


def _trait(one: Asked) -> str:
    """What a column is, where that says which mistakes can be made in it."""
    if _CORIOLIS.fullmatch(one.key):
        return "coriolis"
    if not one.by_position and one.key.split("_")[0] in ("d", "r"):
        return one.key[0]
    return ""


@lru_cache(maxsize=1024)
def _applies(unit: str, angle: bool, trait: str) -> tuple[bool, ...]:
    """Which of FACTORS can be met in a unit."""
    metres = _metres(unit)
    lengths = [1e3**metres, 1e-3**metres] if metres else []

    def applies(mistake: Mistake) -> bool:
        match mistake.kind:
            case "mm for m":
                return any(math.isclose(mistake.by, by) for by in lengths)
            case "rpm for rad/s":
                return unit == ("rad/s" if mistake.by > 1 else "rpm")
            case "turns for radians":
                return unit == "rad/s" and mistake.by < 1
            case "speed":
                squared = mistake.detail.endswith("²")
                return unit in (("m/s²", "rad/s²") if squared else ("m/s",))
            case "degrees for radians":
                return unit.startswith("rad") if mistake.by > 1 else unit == "deg"
            case "mass for weight":
                return unit == "N"
            case "weight for mass":
                return unit in ("N", "N·m")
            case "coriolis":
                return trait == "coriolis"
            case "radius for diameter":
                return trait == ("d" if mistake.by < 1 else "r")
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
    size = np.abs(np.log(np.where(ratio > 0, ratio, 1)))
    free = (
        (ratio > 0) & (size > NEAR_ONE) & ~turning & _varies(stack) & (_scatter(stack, ratio) < TIGHT * size)
    )
    alone = stack.fit((stack.mine / ratio[:, None])[:, None], stack.right[:, None])
    seeds = np.flatnonzero(free & (alone.right[:, 0] >= NEARLY_ALL * stack.count))
    if not len(seeds):
        return
    units = np.array([one.unit for one in stack.asked])
    mistakes = [Mistake("scale", f"{ratio[c]:.4g}", float(ratio[c]), cost=1.5) for c in seeds]
    fit = stack.fit(stack.mine[:, None] / ratio[seeds][:, None], stack.right[:, None])
    found.add(mistakes, stack, fit, (units[:, None] == units[seeds]) & ~turning[:, None])


def _parts(stack: Stack) -> Array:
    """(C, P): what the student's numbers are of the right ones, far from 0; nan elsewhere."""
    loud = stack.answered & (np.abs(stack.right) > LOUD * stack.floor)
    parts = np.where(loud, stack.mine / stack.right, np.nan)
    return np.where(stack.magnitudes, np.abs(parts), parts)


def _ratios(stack: Stack) -> Array:
    """(C,): the median of these parts; nan where there are none."""
    return _medians(_parts(stack))


def _scatter(stack: Stack, ratio: Array) -> Array:
    """(C,): by how much half of the parts miss their median, beyond what a plan is read to; as a logarithm."""
    parts = _parts(stack) / ratio[:, None]
    missed = np.abs(np.log(np.where(parts > 0, parts, np.nan)))
    return _medians(np.where(np.isfinite(parts) & ~(parts > 0), np.inf, missed))


def _medians(numbers: Array) -> Array:
    medians, some = np.full(len(numbers), np.nan), ~np.isnan(numbers).all(axis=1)
    medians[some] = np.nanmedian(numbers[some], axis=1)
    return medians


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
    fit = stack.fit(stack.mine[:, None], aims)
    found.add(mistakes, stack, fit, applies, _told_apart(stack, fit, aims))


def _told_apart(stack: Stack, fit: Fit, aims: Array) -> Array:
    """(C, T): whether the cells show another order. Where it puts nearly the number that belongs there, as in a column
    that goes back as it came, agreement with it shows nothing."""
    apart = stack.fit(stack.right[:, None], aims).apart
    telling = fit.answered & (apart > APART)
    count = telling.sum(axis=2)
    return (count >= LOUD_CELLS) & ((fit.fits & telling).sum(axis=2) >= SHARE * count)


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
