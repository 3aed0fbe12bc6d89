"""Every number of a gear drive with its symbol, unit and meaning; then those of its stages."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from typing import assert_never

from tmm_report.chapters.gears.drive.bounds import check_listing
from tmm_report.chapters.gears.drive.crank_quantities import TEETH, crank_rows, teeth_columns
from tmm_report.chapters.gears.drive.solve import Found
from tmm_report.chapters.gears.drive.stages import Stage
from tmm_report.chapters.gears.planetary.quantities import stage as planetary_quantities
from tmm_report.chapters.gears.planetary.solve import stage as planetary
from tmm_report.chapters.gears.spur import quantities as spur_quantities
from tmm_report.chapters.gears.spur.solve import pair as spur
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Book, Column, Quantity, Table, Value, text_column
from tmm_report.quantity.symbols import Symbol, both, math_symbol, segment
from tmm_report.quantity.tabulated import tabulated

# key, symbol (None of what is never written as one), unit, meaning, number
Row = tuple[str, Symbol | None, str, str, float]

STAGES = Message(N_("stages of the drive in the order of the power"))
SPEEDS = Message(N_("angular velocities of the members of the drive"))
SEGMENTS = Message(N_("segments of the plan of angular velocities of the drive"))
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
    yield Table(f"{prefix}_stages", STAGES, _stages(found))
    yield Table(f"{prefix}_speeds", SPEEDS, _speeds(found))
    yield Table(f"{prefix}_segments", SEGMENTS, _segments(found))
    yield Table(f"{prefix}_comparison", COMPARISON, _comparison(found))
    yield Table(f"{prefix}_loads", LOADS, _loads(found))
    yield Table(f"{prefix}_meshes", MESHES, _meshes(found))
    if found.moments is not None and found.given.torque is not None:
        yield Table(f"{prefix}_teeth", TEETH, tuple(teeth_columns(found)))
    for number, stage in enumerate(found.stages, 1):
        yield from stage_tables(stage, f"stage{number}")


@tabulated
def values(found: Found, prefix: str = "drive") -> Iterator[Value]:
    """Ratio, deviation, efficiency of the drive; then the values of the stages."""
    for rows in (_ratios(found), _whole(found), _diagrams(found), crank_rows(found)):
        for key, symbol, unit, meaning, number in rows:
            yield Quantity(f"{prefix}_{key}", symbol, unit, Message(meaning)).value(float(number))
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
        case _:
            assert_never(stage)


def stage_values(stage: Stage, prefix: str) -> Iterable[Value]:
    match stage:
        case spur.Found():
            return spur_quantities.values(stage, prefix)
        case planetary.Found():
            return planetary_quantities.values(stage, prefix)
        case _:
            assert_never(stage)


# --- single numbers


def _ratios(found: Found) -> Iterator[Row]:
    whole = Symbol("u", both(found.input, found.output))
    # i of a differential, whose u is that with the second input at rest
    work = replace(whole, base="i") if found.differential else whole
    graph = replace(work, sup="gr")
    yield "u", work, "", N_("ratio of the drive at work"), found.ratio
    yield "u_teeth", whole, "", N_("ratio of the drive, second inputs at rest"), found.geared
    yield "u_required", replace(whole, sup="′"), "", N_("required ratio of the drive"), found.wanted
    yield "delta_u", Symbol("delta", "u"), "%", N_("deviation of the ratio"), 100 * found.deviation
    yield "u_graph", graph, "", N_("ratio by the plan of angular velocities"), found.graphical
    error = N_("difference of the ratio by the plan from the calculated one")
    yield "error", Symbol("delta"), "%", error, found.graphical_error
    yield "tolerance", None, "%", N_("allowed deviation of the ratio"), 100 * found.given.tolerance


def _whole(found: Found) -> Iterator[Row]:
    yield "eta", Symbol("eta"), "", N_("efficiency of the drive"), found.efficiency
    yield "losses", None, "W", N_("power lost in all the meshes"), found.losses


def _diagrams(found: Found) -> Iterator[Row]:
    plans, first = found.plans, found.plans.first.name
    yield "mu_l", math_symbol("mu_l"), "m/mm", N_("scale of the kinematic scheme"), plans.length_scale
    scale = N_("scale of the diagram of linear velocities")
    yield "mu_v", math_symbol("mu_v"), "(m/s)/mm", scale, plans.velocity_scale
    scale = N_("scale of the plan of angular velocities")
    yield "mu_omega", math_symbol("mu_omega"), "(rad/s)/mm", scale, plans.angular_scale
    yield "h", Symbol("h"), "mm", N_("pole distance of the plan of angular velocities"), plans.pole
    yield "step", None, "mm", N_("to which the segments are read"), plans.accuracy
    arm = N_("distance of the point whose velocity is laid off from the axis of the input member")
    yield "arm", Symbol("r", found.input), "m", arm, found.arm
    v = found.speed[found.input] * found.arm
    yield "v", Symbol("v", first), "m/s", N_("velocity of the point that is laid off"), v
    laid = segment(f"{first}{first.lower()}")
    yield "laid", laid, "mm", N_("segment as which this velocity is laid off"), abs(v) / plans.velocity_scale


# --- stages and members


def _stages(found: Found) -> tuple[Column, ...]:
    stages = found.stages
    ratios = [Symbol("u", both(stage.input, stage.output)) for stage in stages]
    required = [replace(symbol, sup="′") for symbol in ratios]
    etas = [replace(symbol, base="eta") for symbol in ratios]
    members = ["–".join(member.name for member in stage.members) for stage in stages]
    efficiency = Quantity("eta", Symbol("eta"), "", Message(N_("efficiency of the stage")))
    ratio = Quantity("u", Symbol("u"), "", Message(N_("ratio of the stage, the second input at rest")))
    wanted = Quantity("u_required", Symbol("u", "", "′"), "", Message(N_("required ratio of the stage")))
    number = Quantity("stage", None, "", Message(N_("number of the stage")))
    return (
        number.column(list(range(1, len(stages) + 1))),
        text_column("members", Message(N_("members of the stage")), members),
        Column(ratio, [stage.ratio for stage in stages], ratios),
        Column(wanted, [stage.wanted for stage in stages], required),
        Column(efficiency, [stage.efficiency for stage in stages], etas),
    )


def _speeds(found: Found) -> tuple[Column, ...]:
    members = found.train.members
    names = [m.name for m in members]
    omega = [found.speed[name] for name in names]
    carried = [found.speed[m.carried_by] if m.carried_by else 0.0 for m in members]
    relative = [w - c for w, c in zip(omega, carried, strict=True)]
    about = Message(N_("angular velocity about the carrier of the axis"))
    teeth = Quantity("z", Symbol("z"), "", Message(N_("number of teeth; 0: a carrier")))
    speed = Quantity("omega", Symbol("omega"), "rad/s", Message(N_("angular velocity")))
    turns = Quantity("n", Symbol("n"), "rpm", Message(N_("frequency of rotation")))
    return (
        text_column("member", MEMBER, names),
        Column(teeth, [m.teeth for m in members], [Symbol("z", name) for name in names]),
        Column(speed, omega, [Symbol("omega", name) for name in names]),
        Column(turns, [w * 30 / math.pi for w in omega], [Symbol("n", name) for name in names]),
        Quantity("omega_rel", Symbol("omega", "", "(H)"), "rad/s", about).column(relative),
    )


def _segments(found: Found) -> tuple[Column, ...]:
    names = [m.name for m in found.train.members]
    s = Quantity("s", Symbol("s"), "mm", Message(N_("segment as it is read, signed")))
    read = [found.plans.segment(name) for name in names]
    return text_column("member", MEMBER, names), Column(s, read, [Symbol("s", name) for name in names])


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
    torque = Quantity("T", Symbol("T"), "N·m", Message(N_("external torque")))
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
