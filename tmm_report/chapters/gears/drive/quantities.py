"""Every number of a gear drive with its symbol, unit and meaning; then those of its stages."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import assert_never

from tmm_report.chapters.gears.drive.bounds import check_listing
from tmm_report.chapters.gears.drive.crank_quantities import TEETH, teeth_columns
from tmm_report.chapters.gears.drive.power import quantities as power_quantities
from tmm_report.chapters.gears.drive.solve import Found
from tmm_report.chapters.gears.drive.stages import Stage
from tmm_report.chapters.gears.drive.steps import whole
from tmm_report.chapters.gears.ordinary import quantities as ordinary_quantities
from tmm_report.chapters.gears.ordinary import solve as ordinary
from tmm_report.chapters.gears.planetary.quantities import stage as planetary_quantities
from tmm_report.chapters.gears.planetary.solve import stage as planetary
from tmm_report.chapters.gears.spur import quantities as spur_quantities
from tmm_report.chapters.gears.spur.solve import pair as spur
from tmm_report.i18n import NP_
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Book, Column, Quantity, Table, Value, text_column
from tmm_report.quantity.sheet import Row, columns
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.tabulated import tabulated

HEADLINE = ("drive_u", "drive_delta_u", "drive_eta")  # what is looked for first

EXTERNAL = NP_("index", "ext")
STAGES = Message(N_("stages of the drive along the power flow"))
SPEEDS = Message(N_("angular velocities of the members of the drive"))
SEGMENTS = Message(N_("segments of the diagram of angular velocities of the drive"))
LOADS = Message(N_("external torques and powers of the drive"))
MESHES = Message(N_("flow of the power through the meshes of the drive"))
COMPARISON = Message(N_("diagrams of velocities of the drive against calculation"))
MEMBER = Message(N_("member"))


def book(found: Found, prefix: str = "drive") -> Book:
    """All that is said in numbers of the drive and of its stages."""
    return Book.of(tables(found, prefix), values(found, prefix))


@tabulated
def tables(found: Found, prefix: str = "drive") -> Iterator[Table]:
    """Speeds, loads, flow of the power, comparison; then those of the stages."""
    made = whole(found, prefix)
    yield Table(f"{prefix}_stages", STAGES, tuple(_stages(found, made.stages)))
    yield Table(f"{prefix}_speeds", SPEEDS, tuple(_of_members(made.members)))
    yield Table(f"{prefix}_segments", SEGMENTS, tuple(_of_members(made.segments)))
    yield Table(f"{prefix}_comparison", COMPARISON, _comparison(found))
    yield Table(f"{prefix}_loads", LOADS, _loads(found))
    yield Table(f"{prefix}_meshes", MESHES, _meshes(found))
    if found.asked:
        yield Table(f"{prefix}_teeth", TEETH, tuple(teeth_columns(found)))
    if made.power is not None:
        yield from power_quantities.tables(found, made.power, prefix)
    for number, stage in enumerate(found.stages, 1):
        yield from stage_tables(stage, f"stage{number}")


@tabulated
def values(found: Found, prefix: str = "drive") -> Iterator[Value]:
    """Ratio, deviation, efficiency of the drive; then the values of the stages."""
    made = whole(found, prefix)
    yield from made.s.values()
    if made.power is not None:
        yield from made.power.s.values()
    for number, stage in enumerate(found.stages, 1):
        yield from stage_values(stage, f"stage{number}")


def listings(found: Found, say: Callable[[str], str]) -> Iterator[tuple[str, list[str]]]:
    """Of every planetary stage, all the combinations of teeth that were judged and why most were rejected.

    Raises ProblemError where they are too many."""
    for number, stage in enumerate(found.stages, 1):
        if isinstance(stage, planetary.Found):
            check_listing(stage, number - 1)
            yield f"stage{number}_combinations", planetary_quantities.judged(stage, say)


def stage_tables(stage: Stage, prefix: str) -> Iterable[Table]:
    match stage:
        case spur.Found():
            return spur_quantities.tables(stage, prefix)
        case planetary.Found():
            return planetary_quantities.tables(stage, prefix)
        case ordinary.Found():
            return ordinary_quantities.tables(stage, prefix)
        case _:
            assert_never(stage)


def stage_values(stage: Stage, prefix: str) -> Iterable[Value]:
    match stage:
        case spur.Found():
            return spur_quantities.values(stage, prefix)
        case planetary.Found():
            return planetary_quantities.values(stage, prefix)
        case ordinary.Found():
            return ordinary_quantities.values(stage, prefix)
        case _:
            assert_never(stage)


# --- stages and members


def _stages(found: Found, rows: Sequence[Row]) -> Iterator[Column]:
    stages = found.stages
    members = ["–".join(member.name for member in stage.members) for stage in stages]
    number = Quantity("stage", None, "", Message(N_("number of the stage")))
    yield number.column(list(range(1, len(stages) + 1)))
    yield text_column("members", Message(N_("members of the stage")), members)
    yield from columns(rows)


def _of_members(rows: Mapping[str, Row]) -> Iterator[Column]:
    yield text_column("member", MEMBER, list(rows))
    yield from columns([*rows.values()])


def _comparison(found: Found) -> tuple[Column, ...]:
    rows = found.plans.comparison
    spots, lines = found.plans.spots, found.plans.lines
    symbols = [Symbol("v", spot.name) for spot in spots]
    symbols += [Symbol("omega", line.members[0]) for line in lines]
    units = ["m/s"] * len(spots) + ["rad/s"] * len(lines)
    delta = [math.nan if row.delta is None else row.delta for row in rows]
    graph = Quantity("graph", None, "", Message(N_("by the diagrams, SI")))
    analytic = Quantity("analytic", None, "", Message(N_("by calculation, SI")))
    difference = Quantity("delta", Symbol("delta"), "%", Message(N_("difference of the methods")))
    return (
        text_column("key", Message(N_("quantity")), [row.key for row in rows]),
        text_column("unit", Message(N_("unit of the numbers in the row")), units),
        Column(graph, [row.graph for row in rows], symbols, units),
        Column(analytic, [row.analytic for row in rows], symbols, units),
        difference.column(delta),
    )


# --- loads


def _loads(found: Found) -> tuple[Column, ...]:
    loads = found.loads
    torque = Quantity("T", Symbol("T", EXTERNAL), "N·m", Message(N_("external torque")))
    power = Quantity("N", Symbol("N"), "W", Message(N_("power; positive: supplied")))
    return (
        text_column("member", MEMBER, list(loads.torque)),
        torque.column([float(x) for x in loads.torque.values()]),
        power.column([float(x) for x in loads.power.values()]),
    )


def _meshes(found: Found) -> tuple[Column, ...]:
    meshes, loads = found.train.meshes, found.loads
    meaning = Message(N_("power in the motion about the carrier; negative: the second wheel drives"))
    power = Quantity("N", Symbol("N"), "W", meaning)
    lost = Quantity("N_fr", Symbol("N", "fr"), "W", Message(N_("power lost")))
    eta = Quantity("eta", Symbol("eta"), "", Message(N_("efficiency of the mesh, its carrier stopped")))
    flows = zip(meshes, loads.mesh_power, strict=True)
    driving = [mesh.i if power > 0 else mesh.j if power < 0 else "" for mesh, power in flows]
    return (
        text_column("mesh", Message(N_("wheels in mesh")), [f"{mesh.i}-{mesh.j}" for mesh in meshes]),
        text_column("carrier", Message(N_("carrier of the axes")), [mesh.carrier for mesh in meshes]),
        text_column("driving", Message(N_("driving wheel")), driving),
        power.column([float(x) for x in loads.mesh_power]),
        lost.column([float(x) for x in loads.loss]),
        eta.column([mesh.efficiency for mesh in meshes]),
    )
