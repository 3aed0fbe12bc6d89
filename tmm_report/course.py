"""The table of contents: a variant (all that is given), its results (all that is found), and the order of solving."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

from tmm_report.chapters.given import Drawing, Friction, Loads, Positions, Readings, Title
from tmm_report.mechanics.mechanism import Mechanism


@dataclass(frozen=True, eq=False)
class Variant:
    """Everything a variant states, checked, in SI. A chapter whose block is None is not solved."""

    mechanism: Mechanism
    title: Title = field(default_factory=Title)
    language: Literal["ru", "en"] = "ru"
    decimal_sign: Literal["comma", "point"] = "comma"
    positions: Positions = field(default_factory=Positions)
    drawing: Drawing = field(default_factory=Drawing)
    readings: Readings = field(default_factory=dict)
    loads: Loads | None = None
    friction: Friction | None = None
    places: Mapping[tuple[str | int, ...], tuple[int, int]] = field(default_factory=dict, repr=False)
    """Where each key of the file stands: path -> (line, column), for mistakes found only in solving."""
    file: str = ""
