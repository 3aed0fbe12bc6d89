"""What assignments speak of: a template, its parameters, and what is asked of a variant that is drawn."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field
from decimal import Decimal
from functools import cached_property
from pathlib import Path as File
from typing import Any

from tmm_report.assignments.emit import flow, scalar
from tmm_report.assignments.keys import value_at
from tmm_report.assignments.numbers import Cell, scaled, text_of
from tmm_report.languages import DEFAULT
from tmm_report.records import dataclass
from tmm_report.yamlread import Path, Place


@dataclass(frozen=True, eq=False)
class Template:
    """A complete variant as plain data, and where it lies. `raw`: its numbers as they are written, by their paths."""

    data: Mapping[str, Any]
    source: File
    raw: Mapping[Path, str] = field(default_factory=dict)

    @property
    def title(self) -> Mapping[str, Any]:
        title = self.data.get("title")
        return title if isinstance(title, dict) else {}

    @property
    def group(self) -> str:
        """The group that the template's title page names; of several languages, in the variant's, or the first."""
        stated = self.title.get("group", "")
        if not isinstance(stated, dict):
            return str(self.written(("title", "group"))) if "group" in self.title else ""
        own = str(self.data.get("language", DEFAULT))
        code = own if own in stated else next(iter(stated), "")
        return str(self.written(("title", "group", code))) if code else ""

    def written(self, path: Path) -> Any:
        """The value at a path, a number as it is written."""
        value = value_at(self.data, path)
        number = isinstance(value, int | float) and not isinstance(value, bool)
        return Decimal(self.raw.get(path, repr(value))) if number else value


@dataclass(frozen=True, eq=False)
class Parameter:
    """A number, or a word, that differs from student to student.

    `paths`: where it stands in the template. `unit`: of its numbers in the table, as it is written into the variant.
    `options`: what may be drawn; a parameter without them is `times` the parameter `of`, rounded to `step`. `scales`:
    what stands in the template is multiplied by it. `place`: of its key in the ranges, (line, column).
    """

    name: str
    paths: tuple[Path, ...]
    unit: str = ""
    options: tuple[Cell, ...] = ()
    of: str = ""
    times: Decimal = Decimal(1)
    step: Decimal | None = None
    scales: bool = False
    place: Place | None = None

    @property
    def head(self) -> str:
        """Its column of the table."""
        return f"{self.name}, {self.unit}" if self.unit else self.name

    @property
    def numeric(self) -> bool:
        """Whether its values are numbers, not words."""
        return bool(self.of) or all(isinstance(option, Decimal) for option in self.options)

    def follows(self, base: Decimal) -> Decimal:
        """Its number by that of the parameter on which it depends."""
        number = base * self.times
        return number if self.step is None else (number / self.step).to_integral_value() * self.step

    def texts(self, cell: Cell, template: Template) -> Mapping[Path, str]:
        """What is written into the variant, by the paths. Raises ValueError where a word is to multiply."""
        return {path: self._text(cell, path, template) for path in self.paths}

    def _text(self, cell: Cell, path: Path, template: Template) -> str:
        if self.scales:
            return _multiplied(cell, path, template)
        if isinstance(cell, Decimal):
            return scalar(f"{text_of(cell)} {self.unit}") if self.unit else text_of(cell)
        return cell if cell in ("true", "false") else scalar(cell)


def _multiplied(by: Cell, path: Path, template: Template) -> str:
    """The template's value, or each item of its list, multiplied; of pairs the second numbers."""
    if not isinstance(by, Decimal):
        raise ValueError(by)
    value = template.written(path)
    if not isinstance(value, list):
        return scaled(value, by)
    count = range(len(value))
    if value and all(isinstance(item, list) and len(item) == 2 for item in value):
        pairs = ((template.written((*path, n, 0)), _multiplied(by, (*path, n, 1), template)) for n in count)
        return flow([flow([scaled(first, Decimal(1)), second]) for first, second in pairs])
    return flow([_multiplied(by, (*path, n), template) for n in count])


@dataclass(frozen=True, eq=False)
class Bound:
    """Limits of a single value of the results, as stated in the ranges; None: no limit."""

    key: str
    low: object = None
    high: object = None
    place: Place | None = None


@dataclass(frozen=True, eq=False)
class Condition:
    """`left` is less than `right`, or may be equal: each a number times a parameter, or a number with a unit.

    A parameter's name is "" of a number alone; its factor is then in SI. `text`: as it is written.
    """

    text: str
    left: tuple[Decimal, str]
    right: tuple[Decimal, str]
    equal: bool = False


@dataclass(frozen=True, eq=False)
class Ranges:
    """A template and what of it is drawn."""

    template: Template
    parameters: tuple[Parameter, ...]
    conditions: tuple[Condition, ...] = ()
    closeness: float | None = None  # None: not stated
    bounds: tuple[Bound, ...] = ()
    file: str = ""

    @cached_property
    def drawn(self) -> tuple[Parameter, ...]:
        return tuple(parameter for parameter in self.parameters if parameter.options)

    def cells(self, choice: Sequence[int]) -> dict[str, Cell]:
        """Name -> value of every parameter, in their order, by the numbers of the drawn options."""
        cells: dict[str, Cell] = {p.name: p.options[n] for p, n in zip(self.drawn, choice, strict=True)}
        complete(self.parameters, cells)
        return {parameter.name: cells[parameter.name] for parameter in self.parameters}


def complete(parameters: Sequence[Parameter], cells: dict[str, Cell]) -> None:
    """Add the parameters that follow from others."""
    for parameter in parameters:
        if parameter.of and parameter.name not in cells:
            base = cells.get(parameter.of)
            if isinstance(base, Decimal):
                cells[parameter.name] = parameter.follows(base)
