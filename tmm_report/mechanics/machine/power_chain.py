"""A machine's drive from its end backwards: needed power, motor, ratios of the stages, power and torque of the shafts.

Shafts are numbered in the order of the power, 0 the motor's. Shaft k > 0 takes its power from shaft k − 1 through a
link (a gear stage, a belt, a coupling) of the efficiency `links[k]`, its own bearings lose 1 − `bearings[k]` of it;
what leaves the last shaft's bearings goes to the machine. `links[0]` is 1. The power that is written for a shaft is
either that behind its bearings or, `received`, that before them. All arrays have leading axes (...), the last one is
of shafts or stages. Sources: Dunaev, Lelikov, Design of units and machine parts, ch. 1; Sheinblit, Course design of
machine parts, ch. 1-2.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from tmm_report.records import dataclass

Array = Any

PER_KILOWATT = 9550.0  # N·m rpm: rounded from 30 000/π


def efficiency(links: Array, bearings: Array) -> Array:
    """From the motor to what leaves the last shaft, (...)."""
    return np.prod(links, axis=-1) * np.prod(bearings, axis=-1)


def shaft_powers(motor: Array, links: Array, bearings: Array, received: bool = False) -> Array:
    """W, (..., S), of the motor's power, W, (...)."""
    links, bearings = np.broadcast_arrays(np.asarray(links, float), np.asarray(bearings, float))
    lost = (
        np.concatenate([np.ones_like(bearings[..., :1]), bearings[..., :-1]], axis=-1)
        if received
        else bearings
    )
    return np.asarray(motor, float)[..., None] * np.cumprod(links * lost, axis=-1)


def shaft_speeds(motor: Array, ratios: Array) -> Array:
    """Of every shaft, (..., S), in the unit of the motor's speed; `ratios[k]`: ω_(k−1)/ω_k, `ratios[0]` is 1."""
    return np.asarray(motor, float)[..., None] / np.cumprod(np.asarray(ratios, float), axis=-1)


def torque(power: Array, speed: Array, rounded: bool = False) -> Array:
    """N·m, of W and rad/s; `rounded`: by 9550 P/n with P in kW and n in rpm, as guides print it."""
    exact = np.asarray(power, float) / np.asarray(speed, float)
    return exact * (PER_KILOWATT * math.pi / 30000) if rounded else exact


@dataclass(frozen=True)
class Judged:
    """A motor of the list. `ratio`: of the whole drive with it; `load`: needed power by its own; `strong`: whether it
    has the power; `fits`: whether the ratio is in the range."""

    ratio: float
    load: float
    strong: bool
    fits: bool


def judge(
    motors: Sequence[tuple[float, float]],
    needed: float,
    speed: float,
    overload: float,
    low: float,
    high: float,
) -> list[Judged]:
    """Each motor by its power, W, and speed, rad/s. `needed`: W at the motor; `speed`: of the machine, rad/s;
    `overload`: permitted, relative; `low`, `high`: of the whole ratio."""
    close = 1e-9
    found = []
    for power, own in motors:
        ratio, load = own / speed, needed / power
        fits = low * (1 - close) <= ratio <= high * (1 + close)
        found.append(Judged(ratio, load, load <= (1 + overload) * (1 + close), fits))
    return found


def chosen(
    motors: Sequence[tuple[float, float]], judged: Sequence[Judged], low: float, high: float
) -> int | None:
    """The weakest motor that is strong enough and whose ratio fits; of equally strong ones that whose ratio is nearest
    to the middle of the range, √(low high), then the first. None where none does."""
    fit = [k for k, one in enumerate(judged) if one.strong and one.fits]
    middle = math.sqrt(low * high)
    return min(fit, key=lambda k: (motors[k][0], abs(math.log(judged[k].ratio / middle)), k), default=None)


def shares(whole: Array, count: int, times: float = 1.0) -> Array:
    """Ratios (..., n) of stages, each `times` that of the next one, whose product is `whole`, (...); 1: equal."""
    powers = (count - 1) / 2 - np.arange(count)
    return np.asarray(whole, float)[..., None] ** (1 / count) * times**powers


def by_root(whole: Array, factor: float, slow: bool = True) -> Array:
    """Ratios (..., 2) of a fast and a slow stage: the slow one's (the fast one's) is `factor` √whole."""
    whole = np.asarray(whole, float)
    one = factor * np.sqrt(whole)
    return np.stack([whole / one, one] if slow else [one, whole / one], axis=-1)
