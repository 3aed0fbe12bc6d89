"""Masses of the satellites, as solid discs of their pitch diameter: m = π d² b ρ/4."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from tmm_report.chapters.gears.eccentric.solve.family import Judged
from tmm_report.mechanics.gears.eccentric.mechanism import KINDS
from tmm_report.records import dataclass

Array = Any


@dataclass(frozen=True, eq=False)
class Masses:
    """Of every set, kg: `each` (T, 4) in the order of KINDS, nan of a middle satellite of half a tooth; `held` (T,): of
    those that the set holds together; `saving` (T,): the largest less the smallest."""

    each: Array
    held: Array
    saving: Array


def masses_of(judged: Judged, module: float, width: float, density: float) -> Masses:
    """`width`: face width, m; `density`, kg/m³."""
    z = judged.family.satellites
    each = disc(module * np.where(z % 1 == 0, z, np.nan), width, density)
    held = np.nansum(np.where(judged.fit, each, 0.0), axis=-1)
    largest, smallest = KINDS.index("largest"), KINDS.index("smallest")
    return Masses(each, held, each[:, largest] - each[:, smallest])


def disc(diameter: Array, width: float, density: float) -> Array:
    """π d² b ρ/4, kg."""
    return math.pi * np.asarray(diameter) ** 2 * width * density / 4
