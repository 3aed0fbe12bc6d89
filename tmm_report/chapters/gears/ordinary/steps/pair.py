"""A pair of toothed wheels of which no size is stated: its ratio by the teeth."""

from __future__ import annotations

from tmm_report.chapters.gears.ordinary.given import DRAWN, PairStage
from tmm_report.chapters.gears.ordinary.values import PairOfWheels
from tmm_report.mechanics.gears import trains


def geometry(s: PairOfWheels, of: PairStage) -> None:
    s.u_required, (s.z1, s.z2) = of.ratio, map(float, of.teeth)
    turned = s.z2 / s.z1
    s.u = turned if of.sense > 0 else -turned


def members(s: PairOfWheels, of: PairStage) -> tuple[trains.Member, ...]:
    """Drawn with the module `DRAWN`, for no other is stated."""
    (one, two), ring = of.teeth, of.sense > 0
    apart = (two - one if ring else one + two) * DRAWN / 2
    places = (0.0, abs(apart))
    return tuple(
        trains.Member(name, "ring" if ring and z == max(one, two) else "wheel", z, z * DRAWN / 2, place)
        for name, z, place in zip(of.wheels, (one, two), places, strict=True)
    )


def meshes(s: PairOfWheels, of: PairStage) -> tuple[trains.Mesh, ...]:
    one, two = of.wheels
    return (trains.Mesh(one, two, internal=of.sense > 0, efficiency=of.eta),)


def work(s: PairOfWheels, of: PairStage, speed: float, torque: float | None) -> None:
    """`speed`: of the driving wheel, rad/s; `torque`: on it, N·m, None: not known."""
    s.omega1 = abs(speed)
    if torque is not None:
        s.T1 = abs(torque)
