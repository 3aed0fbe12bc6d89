"""A question asked backwards: which numbers of the file are unknown, and what is demanded of the results."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, Literal

from tmm_report.quantity.units import parse
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.course import Variant

Path = tuple[str | int, ...]
Kind = Literal["equal", "most", "least_allowed", "greatest", "least"]


@dataclass(frozen=True)
class Unknown:
    """`name`: its path as it is written; `low`, `high`: of the range, in `unit`, "" of a bare number; `dimension`: what
    it measures."""

    name: str
    path: Path
    low: float
    high: float
    unit: str
    dimension: str

    def at(self, part: float) -> float:
        """The number at a part of the range, in its own unit."""
        return self.low * (1 - part) + self.high * part

    def written(self, number: float) -> float | str:
        """As it stands in a file."""
        return f"{number!r} {self.unit}" if self.unit else number

    def size(self, number: float) -> float:
        """In SI."""
        return parse(self.written(number), self.dimension)

    def put(self, data: Any, number: float) -> Any:
        """The data of a file with the number in the place of the unknown."""
        return put(data, self.path, self.written(number))


@dataclass(frozen=True)
class Demand:
    """`name`: of a result; `level`: the wanted number, in `unit`, of those that are compared; `path`: its key."""

    name: str
    kind: Kind
    level: float = 0.0
    unit: str = ""
    path: Path = ()

    @property
    def best(self) -> Literal["greatest", "least"] | None:
        """Whether it is the greatest or the least value that is asked for."""
        return self.kind if self.kind == "greatest" or self.kind == "least" else None

    def met(self, rest: float) -> bool:
        """Whether a number that differs from the wanted one by `rest` is allowed though they are not equal."""
        return rest <= 0 if self.kind == "most" else rest >= 0 if self.kind == "least_allowed" else False


@dataclass(frozen=True, eq=False)
class Given:
    """One unknown and one demand, or two of each. `choose`: which of several roots: its number, from 1; −1 the last.
    `restated`: the variant with numbers, in the units of the ranges, in the places of the unknowns; it raises
    ProblemError."""

    unknowns: tuple[Unknown, ...]
    demands: tuple[Demand, ...]
    choose: int = 1
    restated: Callable[[Sequence[float]], Variant] | None = None

    @property
    def unknown(self) -> Unknown:
        return self.unknowns[0]

    @property
    def demand(self) -> Demand:
        return self.demands[0]

    def at(self, parts: Sequence[float]) -> tuple[float, ...]:
        """The unknowns at parts of their ranges, in their own units."""
        return tuple(one.at(part) for one, part in zip(self.unknowns, parts, strict=True))

    def sizes(self, parts: Sequence[float]) -> tuple[float, ...]:
        """The same in SI."""
        return tuple(one.size(one.at(part)) for one, part in zip(self.unknowns, parts, strict=True))

    def put(self, data: Any, numbers: Sequence[float]) -> Any:
        """The data of a file with numbers in the places of the unknowns."""
        for one, number in zip(self.unknowns, numbers, strict=True):
            data = one.put(data, number)
        return data


def put(data: Any, path: Path, value: object) -> Any:
    """Data with another value at a path; what does not lie on the way is shared."""
    if not path:
        return value
    key, *rest = path
    if isinstance(data, list):
        return [put(item, tuple(rest), value) if k == key else item for k, item in enumerate(data)]
    return {**data, key: put(data[key], tuple(rest), value)}
