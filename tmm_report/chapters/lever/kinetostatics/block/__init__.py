"""The block `loads` of a variant."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TypedDict, TypeVar

from tmm_report.chapters.lever.kinetostatics.block.checks import check
from tmm_report.chapters.lever.kinetostatics.block.doubts import doubts as odd
from tmm_report.chapters.lever.kinetostatics.block.models import LoadsModel
from tmm_report.chapters.lever.kinetostatics.given import Force, Loads, Moment, SharedDiagram
from tmm_report.chapters.lever.kinetostatics.ties import End, ends, twists
from tmm_report.chapters.lever.kinetostatics.ties import TorsionSpring as TorsionSpring
from tmm_report.chapters.lever.structure.block import FRAME, names, stated, without
from tmm_report.problems import Problem
from tmm_report.variant import model
from tmm_report.variant.model import Read

AnyLoad = TypeVar("AnyLoad", Force, Moment)


class Block(model.Block):
    """Loads."""

    ONE_SIZE = True
    HOLES = frozenset(
        {
            ("loads", "forces"),
            ("loads", "moments"),
            ("loads", "springs"),
            ("loads", "dampers"),
            ("loads", "torsion_springs"),
        }
    )

    loads: LoadsModel | None = None


class Given(TypedDict):
    loads: Loads | None


def given(read: Read) -> Given:
    written = read.block(Block).loads
    if written is None:
        return {"loads": None}
    forces = tuple(_drawn(one, written) for one in written.forces if one)
    moments = tuple(_drawn(one, written) for one in written.moments if one)
    turning = twists([one for one in written.torsion_springs if one], FRAME)
    return {"loads": Loads(written.pull, (*forces, *_ends(written, read)), (*moments, *turning))}


def _ends(written: LoadsModel, read: Read) -> Iterator[End]:
    """The forces of springs and dampers on moving links."""
    fixed = names(read.data).points[FRAME]
    for ties in (written.springs, written.dampers):
        yield from ends([tie for tie in ties if tie], fixed)


def _drawn(load: AnyLoad, written: LoadsModel) -> AnyLoad:
    """A load with the diagram that a curve of several loads stands for."""
    if not isinstance(load.by_displacement, SharedDiagram):
        return load
    shared = load.by_displacement
    return replace(load, by_displacement=shared.through(written.curves[shared.curve]))


def mistakes(read: Read) -> Iterator[Problem]:
    if stated(read):
        yield from check(read.block(Block).loads or LoadsModel(), read)
    else:
        yield from without(read, "loads")


def doubts(read: Read) -> Iterator[Problem]:
    if stated(read):
        yield from odd(read.block(Block).loads, read)
