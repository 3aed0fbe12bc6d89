"""The blocks `positions` and `allow_partial` of a variant."""

import math
from collections.abc import Iterator
from typing import Annotated, Literal, TypedDict

from pydantic import Field, Tag

from tmm_report.chapters.lever.kinematics.given import By, Positions
from tmm_report.chapters.lever.structure import block as structure
from tmm_report.mechanics.calculus.motion_laws import MotionLaw
from tmm_report.problems import N_, Message, Problem, mistake
from tmm_report.quantity import units
from tmm_report.quantity.text import for_example
from tmm_report.quantity.units import WrongValue
from tmm_report.variant import model
from tmm_report.variant.model import Model, Read
from tmm_report.variant.values import (
    LIST,
    SCALAR,
    DiagramCount,
    Flag,
    Position,
    Reads,
    TableCount,
    by_shape,
)
from tmm_report.yamlread import Path

TABLE, DIAGRAM = 12, 36  # positions a turn, where they are not stated

Some = Annotated[
    Annotated[Position, Tag(SCALAR)] | Annotated[list[Position], Field(min_length=1), Tag(LIST)],
    by_shape(N_("a position, or a list of positions")),
]


def _instant(value: object) -> tuple[float, By]:
    """An angle turned, rad, a time, s, or a stroke, m, and which of them it is."""
    dimensions: tuple[By, ...] = ("time", "length", "angle") if isinstance(value, str) else ("angle",)
    for dimension in dimensions:
        try:
            return units.parse(value, dimension), dimension
        except WrongValue as error:
            wrong = error.wrong
    raise WrongValue(
        wrong, Message(N_("40 deg, an angle turned, 0.05 s, a time, or 0.5 m of a driving stroke"))
    )


Instant = Annotated[
    tuple[float, By],
    Reads(_instant, {"type": ["number", "string"], "examples": ["40 deg", "0.05 s"]}),
]


class PositionsModel(Model):
    """How many positions are solved and which are drawn."""

    table: TableCount | None = Field(
        default=None, description="positions of the tables over the cycle; left out, 12 a turn"
    )
    diagram: DiagramCount | None = Field(
        default=None, description="positions of the diagrams over the cycle; left out, 36 a turn"
    )
    plans: Some | None = Field(
        default=None, description="table positions whose plans are drawn", examples=["[1, 7]"]
    )
    force_plan: Some | None = Field(default=None, description="table positions whose force plan is drawn")
    at: list[Instant] = Field(
        default=[],
        max_length=60,
        description="more positions, by the angle turned from position 0, the time or the stroke that drives",
        examples=[["40 deg", "100 deg"], ["0.05 s"]],
    )


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
    written, turns = read.block(Block).positions, turns_of(read)
    table, diagram = written.table or TABLE * turns, written.diagram or DIAGRAM * turns
    plans = _once(written.plans) or (1, table // turns // 2 + 1)
    drawn = _once(written.force_plan) or plans[-1:]
    positions = Positions(table, diagram, plans, drawn, tuple(dict.fromkeys(written.at)))
    return {"positions": positions, "allow_partial": read.block(Block).allow_partial}


def _once(written: int | list[int] | None) -> tuple[int, ...]:
    """A position that is written twice is drawn once."""
    return tuple(dict.fromkeys(some(written)))


def some(written: int | list[int] | None) -> tuple[int, ...]:
    return () if written is None else (written,) if isinstance(written, int) else tuple(written)


def mistakes(read: Read) -> Iterator[Problem]:
    """Every turn of the cycle has the same positions."""
    written, turns = read.block(Block).positions, turns_of(read)
    for key, count in (("table", written.table), ("diagram", written.diagram)):
        if count is not None and count % turns:
            text = N_("%(count)s positions are not divided equally among %(turns)s turns of the driving link")
            right = Message(N_("for example, %(example)s"), {"example": count + turns - count % turns})
            yield mistake(text, ("positions", key), right, count=count, turns=turns)
    yield from _beyond_the_cycle(written, read)


def _beyond_the_cycle(written: PositionsModel, read: Read) -> Iterator[Problem]:
    """Instants that the cycle has not; of a speed that the drive gives only angles are judged."""
    driver = read.block(structure.Block).mechanism.driver
    built = structure.driver(read) if written.at else None
    if driver is None or built is None:
        return
    whole = built.sweep * built.turns
    for index, (value, by) in enumerate(written.at):
        path, timed = ("positions", "at", index), by == "time"
        if by == "length":
            yield from _beyond_the_stroke(value, built.law if driver.stroke else None, path)
        elif built.law is not None and not timed:
            if driver.stroke is not None or not built.law.turned_by(value) >= 0:
                text = N_(
                    "by its law the driving link does not go on by this angle from position 0, or it turns back: "
                    "positions are stated by the time"
                )
                yield mistake(text, path, for_example("0.05 s"))
        elif timed and driver.speed == "drive":
            text = N_("the speed is that of the drive: positions are stated by the angle")
            yield mistake(text, path, for_example("40 deg"))
        elif not 0 <= (value * abs(built.omega) if timed else value) <= whole * (1 + 1e-6):
            text = N_("it is beyond the cycle, from 0 to %(angle)s° or %(time)s s")
            angle, time = f"{math.degrees(whole):.6g}", f"{whole / abs(built.omega):.6g}"
            yield mistake(text, path, angle=angle, time=time)


def _beyond_the_stroke(value: float, law: MotionLaw | None, path: Path) -> Iterator[Problem]:
    if law is None:
        text = N_("positions are stated by a length only where a slider or a cylinder drives by its stroke")
        yield mistake(text, path, for_example("40 deg"))
    elif not len(law.times_at(value)):
        low, high = (f"{end * 1e3:.6g}" for end in law.reach)
        text = N_("the stroke does not come there: it goes from %(low)s to %(high)s mm")
        yield mistake(text, path, low=low, high=high)


def doubts(read: Read) -> Iterator[Problem]:
    yield from structure.belongs(read, "positions", "allow_partial")


def turns_of(read: Read) -> int:
    """How many turns of the driving link the cycle takes; of a driver with mistakes, by what is written."""
    driver = read.block(structure.Block).mechanism.driver
    if driver is not None:
        return driver.turns
    written = read.data
    for key in ("mechanism", "driver"):
        part = written.get(key)
        written = part if isinstance(part, dict) else {}
    turns = written.get("turns")
    return turns if turns in (1, 2, 3, 4) else 1


def table_of(read: Read) -> int | None:
    """How many positions the table has over the cycle; None where the block is wrong and nothing can be counted by
    it."""
    return (
        None if read.is_broken("positions") else read.block(Block).positions.table or TABLE * turns_of(read)
    )


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
