"""Tables of a drive from the machine back to the motor: motors, losses, teeth by the division, shafts, meshes."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

from tmm_report.chapters.gears.drive.power.plan import RPM
from tmm_report.chapters.gears.drive.power.solve import Found as Shafts
from tmm_report.chapters.gears.drive.power.steps import Steps
from tmm_report.chapters.gears.drive.power.values import MOTOR
from tmm_report.chapters.gears.drive.stages import run
from tmm_report.i18n import NP_
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Quantity, Table, text_column
from tmm_report.quantity.sheet import columns
from tmm_report.quantity.symbols import Symbol

if TYPE_CHECKING:
    from tmm_report.chapters.gears.drive.solve import Found

MESH = NP_("index", "mesh")
MOTORS = Message(N_("motors to choose from"))
LOSSES = Message(N_("what loses power between the motor and the machine"))
SOUGHT = Message(N_("teeth of the wheels by the divided ratio"))
SHAFTS = Message(N_("shafts of the drive along the power flow"))
LOADED = Message(N_("forces in the teeth of the drive by the torques of its shafts"))
VERDICTS = {
    "taken": N_("this one is taken"),
    "will do": N_("will do"),
    "weak": N_("too weak"),
    "slow": N_("ratio too small"),
    "fast": N_("ratio too great"),
    "weak, slow": N_("too weak, ratio too small"),
    "weak, fast": N_("too weak, ratio too great"),
}


def tables(found: Found, steps: Steps, prefix: str) -> Iterator[Table]:
    shafts = steps.found
    if shafts.plan.judged:
        yield Table(f"{prefix}_motors", MOTORS, tuple(_motors(shafts)))
    yield Table(f"{prefix}_losses", LOSSES, tuple(_losses(found, shafts)))
    if steps.sought:
        rows = [*steps.sought.values()]
        wheels = text_column("wheel", Message(N_("wheel")), [*steps.sought])
        yield Table(f"{prefix}_sought", SOUGHT, (wheels, *columns(rows)))
    yield Table(f"{prefix}_shafts", SHAFTS, tuple(_shafts(shafts, steps)))
    if loaded := tuple(_loaded(found, shafts)):
        yield Table(f"{prefix}_mesh_loads", LOADED, loaded)


def verdict(shafts: Shafts, row: int) -> str:
    """Why a motor of the list is taken or not, a key of `VERDICTS`."""
    one, range_ = shafts.plan.judged[row], shafts.plan.range
    if row == shafts.plan.chosen:
        return "taken"
    off = "" if one.fits or range_ is None else "slow" if one.ratio < range_[0] else "fast"
    return ", ".join(filter(None, ("" if one.strong else "weak", off))) or "will do"


def _motors(shafts: Shafts) -> Iterator[Column]:
    motors, judged = shafts.given.motors, shafts.plan.judged
    yield text_column("motor", Message(N_("type of the motor")), [motor.name for motor in motors])
    power = Quantity("P", Symbol("P", MOTOR), "W", Message(N_("rated power of the motor")), "kW")
    yield power.column([motor.power for motor in motors])
    turns = Quantity("n", Symbol("n", MOTOR), "rpm", Message(N_("rated rotational speed of the motor")))
    yield turns.column([motor.speed * RPM for motor in motors])
    ratio = Quantity("u", Symbol("u"), "", Message(N_("ratio of the whole drive with the motor")))
    yield ratio.column([one.ratio for one in judged])
    load = Quantity(
        "load", Symbol("k", "P"), "", Message(N_("ratio of the needed power to the rated power of the motor"))
    )
    yield load.column([one.load for one in judged])
    words = [verdict(shafts, row) for row in range(len(motors))]
    yield text_column("verdict", Message(N_("whether the motor will do")), words)


def _losses(found: Found, shafts: Shafts) -> Iterator[Column]:
    """Each stage, then the bearings, the couplings and the working member with their numbers."""
    given, plan = shafts.given, shafts.plan
    rows = [("stage", "–".join((stage.input, stage.output)), stage.efficiency, 1) for stage in found.stages]
    if given.bearings.efficiency < 1 and any(plan.pairs):
        rows.append(("bearings", "", given.bearings.efficiency, sum(plan.pairs)))
    if given.couplings is not None:
        count = sum(link.kind == "coupling" for link in plan.links)
        rows.append(("coupling", "", given.couplings.efficiency, count))
    if given.machine is not None and given.machine.efficiency < 1:
        rows.append(("machine", "", given.machine.efficiency, 1))
    yield text_column("part", Message(N_("what loses the power")), [row[0] for row in rows])
    yield text_column(
        "wheels", Message(N_("driving and driven member of the stage")), [row[1] for row in rows]
    )
    eta = Quantity("eta", Symbol("eta"), "", Message(N_("efficiency")))
    yield eta.column([row[2] for row in rows])
    many = Quantity("count", None, "", Message(N_("how many of them the power passes")))
    yield many.column([row[3] for row in rows])


def _shafts(shafts: Shafts, steps: Steps) -> Iterator[Column]:
    number = Quantity("shaft", None, "", Message(N_("number of the shaft, the motor's 0")))
    yield number.column(list(range(len(steps.shafts))))
    words = [
        "motor",
        *(f"stage {link.stage + 1}" if link.kind == "stage" else "coupling" for link in shafts.plan.links),
    ]
    yield text_column("by", Message(N_("what brings the power to the shaft")), words)
    yield from columns(steps.shafts)


def _loaded(found: Found, shafts: Shafts) -> Iterator[Column]:
    """Of every mesh of teeth: the torque on the driving wheel of its stage is that which its shaft hands on; what a
    mesh of the stage carries is in proportion to it."""
    torques, rows = iter(found.loads.mesh_torque), []
    carried = 0.0 if found.given.torque is None else found.given.torque
    for stage, torque in zip(map(run, found.stages), shafts.driving(), strict=True):
        for mesh, angle in zip(stage.meshes, stage.angles, strict=True):
            size = torque / carried * abs(float(next(torques)))
            if angle is not None:
                force = size / (found.train.by_name[mesh.i].radius * stage.shares)
                rows.append((f"{mesh.i}-{mesh.j}", force, force * math.tan(angle)))
        carried *= abs(stage.ratio) * stage.efficiency
    if not rows:
        return
    names, along, across = zip(*rows, strict=True)
    yield text_column("mesh", Message(N_("wheels in mesh")), names)
    text = N_("circumferential force in the mesh, on one planet gear where there are several")
    yield Quantity("F_t", Symbol("F", f"t,{MESH}"), "N", Message(text)).column(along)
    text = N_("radial force in the mesh, on one planet gear where there are several")
    yield Quantity("F_r", Symbol("F", f"r,{MESH}"), "N", Message(text)).column(across)
