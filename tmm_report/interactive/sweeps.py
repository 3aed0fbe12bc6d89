"""A variant solved with several values of some of its keys: all combinations, those of one topology at once.

s = sweep(load("my.yaml"), {"mechanism.driver.speed": [60, 80, "100 rpm"]})
s["M_bal_max"]          # array (3,)
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from tmm_report import loading, stack
from tmm_report.course import Variant
from tmm_report.interactive.numbers import Numbers
from tmm_report.interactive.solved import NO_PANDAS, NotFound, Solved
from tmm_report.interactive.source import Source, load
from tmm_report.problems import ProblemError
from tmm_report.records import dataclass
from tmm_report.variant import failed

if TYPE_CHECKING:
    import pandas

MOST = 10_000  # variants


@dataclass(frozen=True, eq=False)
class Sweep:
    """`values`: by their paths, a row a variant, the last path the quickest; `results`: of each, or the ProblemError
    that says why there are none."""

    values: Mapping[str, Sequence[Any]]
    results: Sequence[Solved | ProblemError]

    def __len__(self) -> int:
        return len(self.results)

    def __iter__(self) -> Iterator[Solved | ProblemError]:
        return iter(self.results)

    @property
    def failed(self) -> dict[int, ProblemError]:
        """What stopped those that have no results, by their places."""
        return {k: one for k, one in enumerate(self.results) if isinstance(one, ProblemError)}

    def __getitem__(self, name: str) -> Numbers:
        """A number of every variant, (V,), or a column by positions, (V, P); nan where there are no results. Raises
        NotFound, with the mistakes where no variant has results."""
        good = [one for one in self.results if isinstance(one, Solved)]
        if not good:
            raise NotFound(
                "no variant is solved: " + "; ".join(str(e) for e in list(self.failed.values())[:1])
            )
        first = good[0][name]
        shape = first.shape
        rows = [one[name] if isinstance(one, Solved) else np.full(shape, np.nan) for one in self.results]
        if any(row.shape != shape for row in rows):
            raise NotFound(
                f"{name} has other positions in other variants: take it of each, s.results[k][{name!r}]"
            )
        return Numbers(np.array([np.asarray(row) for row in rows]), first.quantity)

    def table(self, *names: str) -> pandas.DataFrame:
        """A DataFrame: the swept values and single numbers of the results, a row a variant. Raises NotFound,
        ImportError."""
        columns = {name: self[name] for name in names}
        if wide := [name for name, column in columns.items() if column.ndim > 1]:
            raise NotFound(f"{wide[0]} goes by positions: s[{wide[0]!r}] is an array (variants, positions)")
        try:
            import pandas
        except ImportError:
            raise ImportError(NO_PANDAS) from None
        return pandas.DataFrame({**self.values, **{name: np.asarray(one) for name, one in columns.items()}})

    def __repr__(self) -> str:
        swept = ", ".join(
            f"{path} ({len(dict.fromkeys(map(str, row)))})" for path, row in self.values.items()
        )
        lost = f", {len(self.failed)} not solved" if self.failed else ""
        return f"<Sweep of {len(self)} variants over {swept}{lost}>"


def sweep(variant: Variant | Source, values: Mapping[str, Sequence[Any]]) -> Sweep:
    """Solve a variant with every combination of `values`, which stand by the paths of keys, as in a file: bare numbers
    in SI, texts with their units. An item of a list goes by its number from 0.

    >>> from tmm_report import load
    >>> s = sweep(load("variants/crank_rocker.yaml"), {"mechanism.driver.speed": ["60 rpm", "120 rpm"]})
    >>> s["n_1"]
    n, rpm: [ 60. 120.]

    Raises ProblemError for a path that the file has not, ValueError for none and for more than 10 000 combinations;
    what is wrong with one combination is told in its place.
    """
    base = variant if isinstance(variant, Variant) else load(variant)
    rows = list(_combinations(values))
    paths = [loading.path_of(base, name) for name in values]
    stated = [_or_mistakes(base, dict(zip(paths, row, strict=True))) for row in rows]
    solved = stack.solve_each([one for one in stated if isinstance(one, Variant)])
    results = [one if isinstance(one, ProblemError) else _of(next(solved), one) for one in stated]
    return Sweep({name: [row[k] for row in rows] for k, name in enumerate(values)}, results)


def _combinations(values: Mapping[str, Sequence[Any]]) -> Iterator[tuple[Any, ...]]:
    lists = [list(one) if not isinstance(one, str) else [one] for one in values.values()]
    count = int(np.prod([len(one) for one in lists])) if lists else 0
    if not 0 < count <= MOST:
        raise ValueError(f"{count} combinations: from 1 to {MOST} are solved")
    return itertools.product(*lists)


def _or_mistakes(base: Variant, values: Mapping[Any, Any]) -> Variant | ProblemError:
    try:
        return loading.restated(base, values)
    except ProblemError as error:
        return error


def _of(found: Any, variant: Variant) -> Solved | ProblemError:
    return failed(found, variant) if isinstance(found, ProblemError) else Solved.of(found)
