"""The block `loads` of a variant."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TypedDict

from tmm_report.chapters.lever.kinetostatics.block.checks import check
from tmm_report.chapters.lever.kinetostatics.block.doubts import doubts as odd
from tmm_report.chapters.lever.kinetostatics.block.models import LoadsModel
from tmm_report.chapters.lever.kinetostatics.given import Loads
from tmm_report.chapters.lever.structure.block import stated, without
from tmm_report.problems import Problem
from tmm_report.variant import model
from tmm_report.variant.model import Read


class Block(model.Block):
    """Loads."""

    ONE_SIZE = True
    HOLES = frozenset({("loads", "forces"), ("loads", "moments")})

    loads: LoadsModel | None = None


class Given(TypedDict):
    loads: Loads | None


def given(read: Read) -> Given:
    written = read.block(Block).loads
    if written is None:
        return {"loads": None}
    forces, moments = filter(None, written.forces), filter(None, written.moments)
    return {"loads": Loads(written.pull, tuple(forces), tuple(moments))}


def mistakes(read: Read) -> Iterator[Problem]:
    if stated(read):
        yield from check(read.block(Block).loads or LoadsModel(), read)
    else:
        yield from without(read, "loads")


def doubts(read: Read) -> Iterator[Problem]:
    if stated(read):
        yield from odd(read.block(Block).loads, read)
