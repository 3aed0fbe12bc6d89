"""What is given of the wear of guides and pivots."""

from __future__ import annotations

from typing import Literal

import numpy as np

from tmm_report.records import dataclass

POSITIONS = 360  # over the cycle
PARTS = 100  # of a guide
SECTORS = 72  # of a pivot


@dataclass(frozen=True)
class Coefficient:
    """k, 1/Pa, against the pressure, Pa: one number, or a table between whose rows it is interpolated."""

    values: tuple[float, ...]
    pressures: tuple[float, ...] = (0.0,)

    def at(self, pressure: float) -> float:
        return float(np.interp(pressure, self.pressures, self.values))


@dataclass(frozen=True)
class Faces:
    """Coefficients of the lower and of the upper face, of the slider and of the guide."""

    slider: tuple[Coefficient, Coefficient]
    guide: tuple[Coefficient, Coefficient]


@dataclass(frozen=True)
class RunningIn:
    """u0, m, by which running in wears more than steady wear would, and its time constant τ, s."""

    wear: float
    time: float


@dataclass(frozen=True)
class GuideGiven:
    """A slider of `length` l_s and `width` b on a fixed guide, m. `middle`: of the slider from its point on the
    guide, along it; `cycles`: N_c; `force`, `couple`: coefficients at the mean pressure of the central reaction, of
    its moment; `density`, kg/m³; `limit`: of the wear, m."""

    guide: str
    length: float
    width: float
    cycles: float
    force: Faces
    couple: Faces
    slider: str | None = None
    middle: float = 0.0
    parts: int = PARTS
    density: float | None = None
    limit: float | None = None
    running_in: RunningIn | None = None


@dataclass(frozen=True)
class PivotGiven:
    """A pivot of `diameter` and `width`, m, whose journal belongs to the link `journal`. `arc`: half the angle of
    contact, rad, on which the pressure follows `law`; `journal_k`, `bushing_k`: 1/Pa against the mean pressure."""

    pivot: str
    journal: str
    diameter: float
    width: float
    cycles: float
    journal_k: Coefficient
    bushing_k: Coefficient
    bushing: str | None = None
    arc: float = np.pi / 2
    law: Literal["cosine", "uniform"] = "cosine"
    sectors: int = SECTORS
    density: float | None = None
    limit: float | None = None


@dataclass(frozen=True, eq=False)
class Given:
    """SI."""

    guides: tuple[GuideGiven, ...] = ()
    pivots: tuple[PivotGiven, ...] = ()
    positions: int = POSITIONS
