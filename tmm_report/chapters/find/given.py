"""A question asked backwards: which number of the file is unknown, and what is demanded of a result."""

from __future__ import annotations

from collections.abc import Callable
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
        return _put(data, self.path, self.written(number))


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
    """`choose`: which of several roots: its number, from 1; −1 the last. `restated`: the variant with a number, in the
    unit of the range, in the place of the unknown; it raises ProblemError."""

    unknown: Unknown
    demand: Demand
    choose: int = 1
    restated: Callable[[float], Variant] | None = None


def _put(data: Any, path: Path, value: object) -> Any:
    """Data with another value at a path; what does not lie on the way is shared."""
    if not path:
        return value
    key, *rest = path
    if isinstance(data, list):
        return [_put(item, tuple(rest), value) if k == key else item for k, item in enumerate(data)]
    return {**data, key: _put(data[key], tuple(rest), value)}
