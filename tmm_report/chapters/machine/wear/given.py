"""What the block of the wear is read into. The block itself is what the chapter computes with: its frozen models, as a
coefficient is told by its shape, a number, a table or a mapping, which no plain record says."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Protocol

import numpy as np

from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.chapters.machine.wear.block import GuideModel, PivotModel

POSITIONS = 360  # over the cycle
PARTS = 100  # of a guide
SECTORS = 72  # of a pivot


class Given(Protocol):
    """What the chapter asks of its block."""

    @property
    def positions(self) -> int: ...
    @property
    def guides(self) -> Sequence[GuideModel]: ...
    @property
    def pivots(self) -> Sequence[PivotModel]: ...


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
