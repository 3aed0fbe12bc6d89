"""A rubric: which of the solution's numbers are asked, what each is worth, when it counts as right.

Weights are shares, level by level: chapters share the points, the tables of a chapter share its part, the columns of a
table share the table's, and the cells of a column the column's. A weight left out is 1.
"""

from __future__ import annotations

import math
import re
from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import field
from typing import Annotated, Any, Literal

import numpy as np
from pydantic import Field, Tag

from tmm_report import yamlread
from tmm_report.grading.model import Asked, Expected, Name
from tmm_report.problems import N_, Message, Problem, mistake, shown
from tmm_report.records import dataclass
from tmm_report.variant import model
from tmm_report.variant.model import Model, Read, Rooms
from tmm_report.variant.reading import read as read_blocks
from tmm_report.variant.values import LIST, MAP, SCALAR, Position, by_shape, quantity

Array = Any

Weight = Annotated[float, quantity("number", 0.0, 1e6)]
Points = Annotated[float, quantity("number", 1e-9, 1e6)]
Sense = Annotated[float, quantity("number", 0.0, 1e6)]
Limit = Annotated[float, quantity("number", 0.0, 1.0, "0 % … 100 %")]
Share = Annotated[float, quantity("number", 0.0, 1.0, "0 … 1")]
Reading = Annotated[float, quantity("length", 0.0, 0.01, "0 … 10 mm")]
Key = Annotated[str, Field(max_length=80)]
Weights = Annotated[
    Annotated[list[Key], Tag(LIST)] | Annotated[dict[Key, Weight], Tag(MAP)],
    by_shape(N_("a list of keys, or keys with weights: {v_B: 2}")),
]
Signs = Literal["free", "strict"]
Attempts = Literal["last", "best"]
SCALES = ("mu_l", "mu_v", "mu_a", "mu_F")
VALUES = "values"  # single numbers, of whatever chapter, share the points as a chapter of their own


class TableModel(Model):
    """One table: its weight, its columns and cells."""

    weight: Weight = 1.0
    columns: Weights | None = Field(default=None, description="those asked; left out, those of the template")
    positions: list[Position] | None = Field(default=None, min_length=1)
    cells: dict[Key, Weight] = Field(default={}, description="weights of rows: {7: 3}")
    limit: Limit | None = None
    signs: Signs | None = None


Tables = Annotated[
    Annotated[Weight, Tag(SCALAR)] | Annotated[TableModel, Tag(MAP)],
    by_shape(N_("a weight, or keys with values: {weight: 2}")),
]


class Block(model.Block):
    """A rubric's file."""

    ALONE = True

    points: Points = Field(default=100.0, description="of a work without a mistake")
    limit: Limit = Field(default=0.05, description="of the difference, 5 %")
    reading: Reading = Field(default=0.001, description="what cannot be read off a plan, on paper")
    carried: Share = Field(default=1.0, description="share of the points for what follows from a wrong value")
    named: Share = Field(default=0.0, description="share of the points for what one named mistake explains")
    senses: Sense = Field(
        default=0.0, description="points taken for another positive sense held throughout, once for each"
    )
    signs: Signs = Field(default="free", description="free: magnitudes read off plans are taken as such")
    attempts: Attempts = Field(default="last", description="which of several attempts counts")
    positions: list[Position] | None = Field(default=None, min_length=1, description="asked; left out, all")
    chapters: dict[Key, Weight] = Field(default={}, description="weights of the chapters")
    tables: dict[Key, Tables] | None = Field(
        default=None, description="asked; left out, those of the template"
    )
    values: Weights | None = Field(default=None, description="single numbers asked, by key")


@dataclass(frozen=True)
class TableRule:
    """What a rubric says of one table; None where it says nothing of its own."""

    weight: float = 1.0
    columns: Mapping[str, float] | None = None
    positions: tuple[int, ...] | None = None
    cells: Mapping[str, float] = field(default_factory=dict)
    limit: float | None = None
    signs: Signs | None = None


@dataclass(frozen=True)
class Rubric:
    """`limit`: per cent; `reading`: mm of paper; `carried`, `named`: shares of a cell's points, 0 … 1;
    `senses`: points."""

    points: float = 100.0
    limit: float = 5.0
    reading: float = 1.0
    carried: float = 1.0
    named: float = 0.0
    senses: float = 0.0
    signs: Signs = "free"
    attempts: Attempts = "last"
    positions: tuple[int, ...] | None = None
    chapters: Mapping[str, float] = field(default_factory=dict)
    tables: Mapping[str, TableRule] | None = None
    values: Mapping[str, float] | None = None

    def limit_of(self, table: str) -> float:
        """Allowed difference in a table, %."""
        rule = (self.tables or {}).get(table)
        return self.limit if rule is None or rule.limit is None else rule.limit

    def asks(self, one: Asked) -> bool:
        """Whether a column is worth anything."""
        return _column_weight(self, one) > 0

    @property
    def asks_of_plans(self) -> bool:
        """Whether it names tables of what is read off drawings: these have the number of a position, arms_7."""
        return any(re.search(r"_\d+$", table) for table in self.tables or {})

    def strict(self, table: str) -> bool:
        """Whether a number without its sign is wrong."""
        rule = (self.tables or {}).get(table)
        own = rule.signs if rule is not None else None
        return (own or self.signs) == "strict"


# ---------------------------------------------------------------- the file


def load(path: Any) -> Rubric:
    """Read a rubric. Raises ProblemError with all its mistakes."""
    soft: list[Problem] = []
    return _rubric(yamlread.read(path, soft), yamlread.file_label(path), soft)


def loads(text: str | bytes, file: str = "") -> Rubric:
    """The rubric that a text states. Raises ProblemError."""
    soft: list[Problem] = []
    return _rubric(yamlread.loads(text, file, soft), file, soft)


class _Room:
    Block = Block

    @staticmethod
    def given(read: Read) -> Mapping[str, object]:
        return {}

    @staticmethod
    def mistakes(read: Read) -> Iterator[Problem]:
        block = read.block(Block)
        if not sum(block.chapters.values(), start=float(not block.chapters)):
            yield mistake(N_("all weights are 0: nothing is asked"), ("chapters",))


def _rubric(document: yamlread.Document, file: str, soft: list[Problem]) -> Rubric:
    block = read_blocks(document, file, soft, Rooms([_Room], {})).block(Block)  # type: ignore[list-item]
    return Rubric(
        points=block.points,
        limit=100 * block.limit,
        reading=1000 * block.reading,
        carried=block.carried,
        named=block.named,
        senses=block.senses,
        signs=block.signs,
        attempts=block.attempts,
        positions=_tuple(block.positions),
        chapters=block.chapters,
        tables=None if block.tables is None else {key: _table(one) for key, one in block.tables.items()},
        values=_weights(block.values),
    )


def _table(written: float | TableModel) -> TableRule:
    if not isinstance(written, TableModel):
        return TableRule(weight=written)
    return TableRule(
        written.weight,
        _weights(written.columns),
        _tuple(written.positions),
        written.cells,
        None if written.limit is None else 100 * written.limit,
        written.signs,
    )


def _weights(written: list[str] | dict[str, float] | None) -> dict[str, float] | None:
    return dict.fromkeys(written, 1.0) if isinstance(written, list) else written


def _tuple(written: list[int] | None) -> tuple[int, ...] | None:
    return None if written is None else tuple(written)


# ---------------------------------------------------------------- what is asked, and what it is worth


def worth(rubric: Rubric, asked: Expected, closed: bool) -> dict[Name, Array]:
    """Points of every cell asked, (P,) a column; all together `rubric.points`.

    `closed`: the last position repeats position 0 and is not asked for itself.
    """
    columns = {one.name: weight for one in asked.values() if (weight := _column_weight(rubric, one)) > 0}
    cells = {name: _cell_weights(rubric, asked[name], closed) for name in columns}
    columns = {name: weight for name, weight in columns.items() if cells[name].any()}
    tables = _sums((name[0], weight) for name, weight in columns.items())
    of_table = {name[0]: asked[name].chapter if name[0] else VALUES for name in columns}
    weights = {table: _table_weight(rubric, table) for table in tables}
    chapters = _sums((of_table[table], weight) for table, weight in weights.items())
    given = {chapter: rubric.chapters.get(chapter, 1.0) for chapter in chapters}
    total = math.fsum(given.values())
    found = {}
    for name, weight in columns.items():
        table, chapter = name[0], of_table[name[0]]
        share = weight / tables[table] * weights[table] / chapters[chapter] * given[chapter] / total
        found[name] = rubric.points * share * cells[name] / cells[name].sum()
    return found


def _sums(weights: Iterable[tuple[str, float]]) -> dict[str, float]:
    sums: dict[str, float] = {}
    for name, weight in weights:
        sums[name] = sums.get(name, 0.0) + weight
    return {name: whole for name, whole in sums.items() if whole > 0}


def _table_weight(rubric: Rubric, table: str) -> float:
    rule = (rubric.tables or {}).get(table)
    return 1.0 if rule is None else rule.weight


def _column_weight(rubric: Rubric, one: Asked) -> float:
    """0 of a column that is not asked. The scales of plans are everybody's own."""
    if not one.table and one.key in SCALES:
        return 0.0
    if not one.table:
        return (rubric.values or {}).get(one.key, 0.0)
    if rubric.tables is None:
        return float(rubric.values is None and _by_default(one))
    rule = rubric.tables.get(one.table)
    if rule is None or rule.weight == 0:
        return 0.0
    return float(_by_default(one, of_table=True)) if rule.columns is None else rule.columns.get(one.key, 0.0)


DEFAULT_TABLES = ("outputs_table", "rates_table", "reactions_table", "balancing_table", "drive_table")
GEARS = ("z", "x", "d", "d_a", "d_f", "d_b")


def _by_default(one: Asked, of_table: bool = False) -> bool:
    """Whether a column stands in a template that no rubric shapes: sizes of vectors rather than their components, of
    several ways to a number the first, of wheels what a drawing needs."""
    if one.table.endswith("_wheels"):
        return one.key in GEARS
    if not of_table and one.table not in DEFAULT_TABLES:
        return False
    if one.table == "balancing_table":
        return one.key == "M_bal"
    if one.table == "drive_table":
        return one.key == "F_stroke"
    if one.table == "reactions_table":
        return not one.signed
    return not one.key.endswith(("_x", "_y"))


def _cell_weights(rubric: Rubric, one: Asked, closed: bool) -> Array:
    rule = (rubric.tables or {}).get(one.table, TableRule())
    weights = np.array([rule.cells.get(row, 1.0) for row in one.rows])
    if one.by_position:
        positions = rule.positions or rubric.positions or range(len(one.rows) - closed)
        weights[~np.isin(np.arange(len(one.rows)), list(positions))] = 0.0
    weights[~np.isfinite(one.values)] = 0.0
    return weights


def unmatched(rubric: Rubric, columns: Collection[Name]) -> set[str]:
    """What the rubric names and no variant has among its columns: tables, "table.key" of columns, keys of values."""
    tables = {table for table, _ in columns}
    named = {key for key in rubric.values or {} if ("", key) not in columns}
    for table, rule in (rubric.tables or {}).items():
        if table not in tables:
            named.add(table)
        else:
            named |= {f"{table}.{key}" for key in rule.columns or {} if (table, key) not in columns}
    return named


def unknown(names: Iterable[str], file: str) -> list[Problem]:
    """What a rubric names and no variant has, a warning each."""
    text, right = N_("no variant has %(name)s"), Message(N_("keys are those of results.json"))
    return [Problem(Message(text, {"name": shown(name, 80)}), right, file=file) for name in sorted(names)]
