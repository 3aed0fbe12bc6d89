"""The blocks `positions` and `allow_partial` of a variant."""

from collections.abc import Iterator
from typing import Annotated, Literal, TypedDict

from pydantic import Field, Tag

from tmm_report.chapters.kinematics.given import Positions
from tmm_report.problems import N_, Problem, mistake
from tmm_report.variant import model
from tmm_report.variant.model import Model, Read
from tmm_report.variant.values import (
    LIST,
    SCALAR,
    DiagramCount,
    Flag,
    Position,
    TableCount,
    by_shape,
)
from tmm_report.yamlread import Path

Some = Annotated[
    Annotated[Position, Tag(SCALAR)] | Annotated[list[Position], Field(min_length=1), Tag(LIST)],
    by_shape(N_("a position, or a list of positions")),
]


class PositionsModel(Model):
    """How many positions are solved and which are drawn."""

    table: TableCount = Field(default=12, description="positions of the tables")
    diagram: DiagramCount = Field(default=36, description="positions of the diagrams")
    plans: Some | None = Field(
        default=None, description="table positions whose plans are drawn", examples=["[1, 7]"]
    )
    force_plan: Some | None = Field(default=None, description="table positions whose force plan is drawn")


class Block(model.Block):
    """The positions, and whether the mechanism may be in part of them only."""

    positions: PositionsModel = Field(default_factory=PositionsModel)
    allow_partial: Flag = Field(
        default=False, description="true: a mechanism that exists over part of the cycle only is meant so"
    )


class Given(TypedDict):
    positions: Positions
    allow_partial: bool


def given(read: Read) -> Given:
    """Left out: the plans of the first and the opposite position, the force plan of the last of the plans."""
    written = read.block(Block).positions
    plans = some(written.plans) or (1, written.table // 2 + 1)
    positions = Positions(written.table, written.diagram, plans, some(written.force_plan) or plans[-1:])
    return {"positions": positions, "allow_partial": read.block(Block).allow_partial}


def some(written: int | list[int] | None) -> tuple[int, ...]:
    return () if written is None else (written,) if isinstance(written, int) else tuple(written)


def mistakes(read: Read) -> Iterator[Problem]:
    yield from ()


def table_of(read: Read) -> int | None:
    """How many positions the table has; None where the block is wrong and nothing can be counted by it."""
    return None if read.is_broken("positions") else read.block(Block).positions.table


def beyond_the_table(position: int, path: Path, read: Read) -> Iterator[Problem]:
    last = table_of(read)
    if last is not None and position > last:
        text = N_("there is no position %(position)s: the table has positions 0 to %(last)s")
        yield mistake(text, path, position=position, last=last)


def undrawn(key: Literal["plans", "force_plan"], read: Read) -> Iterator[Problem]:
    """Positions to be drawn that the table has not."""
    block = read.block(Block).positions
    written = block.plans if key == "plans" else block.force_plan
    for index, position in enumerate(some(written)):
        path: Path = ("positions", key, index) if isinstance(written, list) else ("positions", key)
        yield from beyond_the_table(position, path, read)
