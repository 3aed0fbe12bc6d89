"""A train with idlers: each counts once in the ratio and cancels out of its size; forces in every mesh."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import reduce
from itertools import pairwise
from operator import add

from tmm_report.chapters.gears.ordinary.given import TrainStage
from tmm_report.chapters.gears.ordinary.values import Train, TrainWheel
from tmm_report.mechanics.gears import trains
from tmm_report.problems import N_, Message, ProblemError, mistake
from tmm_report.quantity.formula import Expr, sqrt, tan
from tmm_report.quantity.functions import Degrees

ANGLE = math.radians(20)  # of pressure, of wheels without shift


def geometry(s: Train, of: TrainStage) -> None:
    """Raises ProblemError for an idler that does not fit into the ring."""
    s.m, s.u_required, s.eta_mesh = of.module, of.ratio, of.of_mesh
    ring, last = of.z[-1], of.z[-2]
    if of.mesh == "internal" and ring - last < 8:
        wrong = N_("a ring of %(ring)s teeth holds no wheel of %(wheel)s")
        right = Message(N_("a ring of at least %(least)s teeth, or mesh: external"), {"least": last + 8})
        raise ProblemError([mistake(wrong, ("teeth",), right, ring=ring, wheel=last)])
    rows = s.rows = wheels(of)
    if not isinstance(of.teeth, tuple):
        s.z_exact = rows[0].z * abs(s.u_required)
    s.u = _product(of, rows)
    for one, other in pairwise(rows):
        apart = other.z - one.z if of.mesh == "internal" and other is rows[-1] else one.z + other.z
        one.a = s.m * apart / 2
    if of.mesh == "external":
        s.a = reduce(add, [row.a for row in rows[:-1]])


def wheels(of: TrainStage) -> tuple[TrainWheel, ...]:
    rows = tuple(TrainWheel(f"{of.label}_train", row, name) for row, name in enumerate(of.wheels))
    for row, z in zip(rows, of.z, strict=True):
        row.z = z
        row.d = z * of.module
    return rows


def _product(of: TrainStage, rows: Sequence[TrainWheel]) -> Expr:
    """Of the ratios of the meshes, each with its sign."""
    whole: Expr | None = None
    for one, other in pairwise(rows):
        turned = other.z / one.z
        signed = turned if of.mesh == "internal" and other is rows[-1] else -turned
        whole = signed if whole is None else whole * signed
    assert whole is not None
    return whole


def members(s: Train, of: TrainStage) -> tuple[trains.Member, ...]:
    place, found = 0.0, []
    for row, name in zip(s.rows, of.wheels, strict=True):
        last = row is s.rows[-1]
        ring = last and of.mesh == "internal"
        found.append(
            trains.Member(name, "ring" if ring else "wheel", int(row.number("z")), row.number("d") / 2, place)
        )
        if not last:
            back = of.mesh == "internal" and row is s.rows[-2]
            place += -row.number("a") if back else row.number("a")
    return tuple(found)


def meshes(s: Train, of: TrainStage) -> tuple[trains.Mesh, ...]:
    ends = list(pairwise(of.wheels))
    return tuple(
        trains.Mesh(one, two, "", of.mesh == "internal" and two == of.wheels[-1], of.of_mesh)
        for one, two in ends
    )


def work(s: Train, of: TrainStage, speed: float, torque: float | None) -> None:
    """`speed`: of the driving wheel, rad/s; `torque`: on it, N·m, None: not known."""
    s.omega1 = abs(speed)
    if torque is None:
        return
    s.T1 = abs(torque)
    force: Expr = 2 * s.T1 / s.rows[0].d
    for row in s.rows[:-1]:
        row.F_t = force
        row.F_r = row.F_t * tan(Degrees(ANGLE))
        force = s.eta_mesh * row.F_t
    for before, row in pairwise(s.rows[:-1]):
        row.F_axis = sqrt((before.F_t + row.F_t) ** 2 + (before.F_r - row.F_r) ** 2)
