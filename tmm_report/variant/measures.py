"""The numbers of a file with what they measure, as they are written and in SI; units that may have been meant."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from functools import lru_cache
from typing import Any

from tmm_report.problems import shown
from tmm_report.quantity import units
from tmm_report.quantity.units import WrongValue
from tmm_report.records import dataclass
from tmm_report.variant.leaves import Leaf, leaves
from tmm_report.variant.model import Read
from tmm_report.yamlread import Path

_CYRILLIC = re.compile("[\u0400-\u052f]")
# of a dimension: the units in which it is stated in projects, Latin and Cyrillic
_USUAL = {
    "length": (("mm", "мм"), ("m", "м")),
    "mass": (("g", "г"), ("kg", "кг"), ("t", "т")),
    "inertia": (("kg*mm^2", "кг*мм^2"), ("kg*cm^2", "кг*см^2"), ("g*m^2", "г*м^2"), ("kg*m^2", "кг*м^2")),
    "speed": (("rpm", "об/мин"),),
    "pressure": (("MPa", "МПа"), ("kPa", "кПа"), ("Pa", "Па")),
    "angle": (("deg", "град"),),
    "power": (("kW", "кВт"), ("W", "Вт")),
    "density": (("g/cm^3", "г/см^3"), ("kg/m^3", "кг/м^3")),
}


@dataclass(frozen=True, eq=False)
class Measure:
    """A number of the file. `size`: in SI; `unit`: as it is written, "" of a bare number."""

    path: Path
    written: Any
    dimension: str
    size: float
    number: float
    unit: str
    bounded: bool
    """Whether the format states a range for it, so that nothing is to be guessed."""
    cyrillic: bool = False
    """Whether units of the file are written in Cyrillic letters."""

    @property
    def bare(self) -> bool:
        return not self.unit

    @property
    def text(self) -> str:
        """As it is written; a bare number with the unit that it has."""
        own = "" if self.unit else f" {units.DIMENSIONS[self.dimension].unit}"
        return shown(self.written) + own

    def meant(self, low: float, high: float) -> str | None:
        """The same number in the usual unit that brings it, SI, between two limits, nearest to their middle; None if
        none does."""
        middle = math.sqrt(max(low, 1e-12) * high)
        found = [
            (abs(math.log(abs(size) / middle)), text)
            for text, size in self.others()
            if low <= abs(size) <= high
        ]
        return min(found)[1] if found else None

    def others(self) -> Iterator[tuple[str, float]]:
        """The same number in the other usual units: as it would be written, and its size in SI."""
        for names in _USUAL.get(self.dimension, ()):
            text = f"{self.number:.12g} {names[self.cyrillic]}"
            size = units.parse(text, self.dimension)
            if abs(size - self.size) > 1e-9 * abs(self.size):
                yield text, size


@lru_cache(maxsize=1)  # several chapters ask for those of the file that is read
def measures(read: Read) -> list[Measure]:
    """The numbers of the file that measure something, in its order by blocks."""
    stated = [leaf for leaf in leaves(read.blocks, read.data) if leaf.dimension]
    cyrillic = any(isinstance(leaf.written, str) and _CYRILLIC.search(leaf.written) for leaf in stated)
    return [measure for leaf in stated for measure in _measure(leaf, cyrillic)]


def _measure(leaf: Leaf, cyrillic: bool) -> Iterator[Measure]:
    try:
        size = units.parse(leaf.written, leaf.dimension)
        number, unit = units.measured(leaf.written)
    except WrongValue:
        return
    yield Measure(leaf.path, leaf.written, leaf.dimension, size, number, unit, leaf.bounded, cyrillic)
