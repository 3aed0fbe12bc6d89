"""Tables and values of a gear drive and of its stages."""

from __future__ import annotations

from collections.abc import Iterator
from types import ModuleType
from typing import Any

from tmm_report.chapters.drive.solve import Found
from tmm_report.chapters.planetary import quantities as planetary_tables
from tmm_report.chapters.spur import quantities as spur_tables
from tmm_report.chapters.spur import solve as spur
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Table, Value, plain, plain_value

SPEEDS = Message(N_("angular velocities of the members of the drive"))
LOADS = Message(N_("external torques and powers of the drive"))
MESHES = Message(N_("flow of the power through the meshes of the drive"))
COMPARISON = Message(N_("diagrams of velocities of the drive against calculation"))


def tables(found: Found, prefix: str = "drive") -> Iterator[Table]:
    """Speeds, loads, flow of the power, comparison; then those of the stages."""
    yield Table(f"{prefix}_speeds", SPEEDS, _speeds(found))
    yield Table(f"{prefix}_comparison", COMPARISON, _comparison(found))
    yield Table(f"{prefix}_loads", LOADS, _loads(found))
    yield Table(f"{prefix}_meshes", MESHES, _meshes(found))
    for name, stage in _stages(found):
        yield from _room(stage).tables(stage, name)


def values(found: Found, prefix: str = "drive") -> Iterator[Value]:
    """Ratio, deviation, efficiency of the drive; then the values of the stages."""
    graph = found.plans.ratio(found.input, found.output)
    yield plain_value(f"{prefix}_u", found.ratio, "", Message(N_("ratio of the drive at work")))
    yield plain_value(
        f"{prefix}_u_teeth", found.geared, "", Message(N_("ratio of the drive, second inputs at rest"))
    )
    yield plain_value(f"{prefix}_u_required", found.wanted, "", Message(N_("required ratio of the drive")))
    yield plain_value(f"{prefix}_delta_u", 100 * found.deviation, "%", Message(N_("deviation of the ratio")))
    yield plain_value(f"{prefix}_u_graph", graph, "", Message(N_("ratio by the plan of angular velocities")))
    yield plain_value(f"{prefix}_eta", found.efficiency, "", Message(N_("efficiency of the drive")))
    for name, stage in _stages(found):
        yield from _room(stage).values(stage, name)


def _stages(found: Found) -> list[tuple[str, Any]]:
    return [(f"stage{number}", stage) for number, stage in enumerate(found.stages, 1)]


def _room(stage: Any) -> ModuleType:
    return spur_tables if isinstance(stage, spur.Found) else planetary_tables


def _speeds(found: Found) -> tuple[Column, ...]:
    members = found.train.members
    carried = [found.speed[m.carried_by] if m.carried_by else 0.0 for m in members]
    omega = [found.speed[m.name] for m in members]
    relative = [w - c for w, c in zip(omega, carried, strict=True)]
    about = Message(N_("angular velocity about the carrier of the axis"))
    return (
        plain("member", "", Message(N_("member")), [m.name for m in members]),
        plain("z", "", Message(N_("number of teeth; 0: a carrier")), [m.teeth for m in members]),
        plain("omega", "rad/s", Message(N_("angular velocity")), omega),
        plain("omega_rel", "rad/s", about, relative),
    )


def _comparison(found: Found) -> tuple[Column, ...]:
    rows = found.plans.comparison
    delta = [float("nan") if row.delta is None else row.delta for row in rows]
    return (
        plain("key", "", Message(N_("quantity")), [row.key for row in rows]),
        plain("graph", "", Message(N_("by the diagrams, SI")), [row.graph for row in rows]),
        plain("analytic", "", Message(N_("by calculation, SI")), [row.analytic for row in rows]),
        plain("delta", "%", Message(N_("difference of the methods")), delta),
    )


def _loads(found: Found) -> tuple[Column, ...]:
    loads = found.loads
    return (
        plain("member", "", Message(N_("member")), list(loads.torque)),
        plain("T", "N·m", Message(N_("external torque")), [float(x) for x in loads.torque.values()]),
        plain("N", "W", Message(N_("power; positive: supplied")), [float(x) for x in loads.power.values()]),
    )


def _meshes(found: Found) -> tuple[Column, ...]:
    meshes, loads = found.train.meshes, found.loads
    power = Message(N_("power in the motion about the carrier; negative: the second wheel drives"))
    return (
        plain("mesh", "", Message(N_("wheels in mesh")), [f"{mesh.i}-{mesh.j}" for mesh in meshes]),
        plain("N", "W", power, [float(x) for x in loads.mesh_power]),
        plain("N_fr", "W", Message(N_("power lost")), [float(x) for x in loads.loss]),
    )
