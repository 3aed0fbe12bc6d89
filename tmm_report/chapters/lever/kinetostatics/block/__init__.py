"""The block `loads` of a variant."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TypedDict, TypeVar

from tmm_report.chapters.lever.kinetostatics.block.checks import check
from tmm_report.chapters.lever.kinetostatics.block.doubts import doubts as odd
from tmm_report.chapters.lever.kinetostatics.block.models import LoadsModel
from tmm_report.chapters.lever.kinetostatics.block.stroke_parts import in_parts, is_measured
from tmm_report.chapters.lever.kinetostatics.given import Force, Loads, Moment, SharedDiagram
from tmm_report.chapters.lever.kinetostatics.ties import End, ends, twists
from tmm_report.chapters.lever.kinetostatics.ties import TorsionSpring as TorsionSpring
from tmm_report.chapters.lever.structure import block as structure
from tmm_report.chapters.lever.structure.block import FRAME, names, stated, without
from tmm_report.mechanics.lever.assembly.stated import assemble
from tmm_report.mechanics.lever.cycle import Cycle, cycle_of
from tmm_report.problems import Problem, ProblemError
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
    forces = [_drawn(one, written) for one in written.forces if one]
    moments = [_drawn(one, written) for one in written.moments if one]
    if any(is_measured(one) for one in forces) or any(is_measured(one) for one in moments):
        cycle = _cycle(read)
        if cycle is not None:
            forces, moments = _in_parts("forces", forces, cycle), _in_parts("moments", moments, cycle)
    turning = twists([one for one in written.torsion_springs if one], FRAME)
    return {"loads": Loads(written.pull, (*forces, *_ends(written, read)), (*moments, *turning))}


def _cycle(read: Read) -> Cycle | None:
    """None of a mechanism that is not solved either: what it lacks is told, or shown, by who asks for it."""
    try:
        return cycle_of(assemble(structure.given(read)["mechanism"]))
    except ProblemError:
        return None


def _in_parts(key: str, loads: list[AnyLoad], cycle: Cycle) -> list[AnyLoad]:
    found: list[AnyLoad] = []
    for index, load in enumerate(loads):
        found.append(in_parts(load, ("loads", key, index), cycle) if is_measured(load) else load)
    return found


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
        found = list(check(read.block(Block).loads or LoadsModel(), read))
        yield from found or _strokes(read)
    else:
        yield from without(read, "loads")


def _strokes(read: Read) -> Iterator[Problem]:
    """Diagrams in lengths that do not end with the stroke: it is known when all else is right."""
    written = read.block(Block).loads
    if written is None or read.broken or any(structure.mistakes(read)):
        return
    forces = any(is_measured(_drawn(one, written)) for one in written.forces if one)
    if not forces and not any(is_measured(_drawn(one, written)) for one in written.moments if one):
        return
    try:
        given(read)
    except ProblemError as error:
        yield from error.problems


def doubts(read: Read) -> Iterator[Problem]:
    if stated(read):
        yield from odd(read.block(Block).loads, read)
