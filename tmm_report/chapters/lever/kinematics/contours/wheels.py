"""Angular velocities and accelerations of the links that meshes move, by those of the links that move them."""

from __future__ import annotations

from collections.abc import Sequence

from tmm_report.chapters.lever.kinematics.contours.worked import Bench
from tmm_report.chapters.lever.kinematics.solve import points_and_links as q
from tmm_report.chapters.lever.structure.quantities import share_of, transfer_of
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.mechanics.lever.wheels.coupled import Coupled
from tmm_report.quantity.formula import Expr, Formula


def rates(bench: Bench, wheels: Sequence[Coupled]) -> list[Formula]:
    """Of wheels that wheels move; a rack's are those of its slider. Their poses are taken as found."""
    for wheel in wheels:
        bench.take_pose(wheel.link)
        if wheel.mesh.kind != "rack":
            _written(bench, wheel, "w")
            _written(bench, wheel, "e")
    return bench.taken()


def _written(bench: Bench, wheel: Coupled, letter: str) -> None:
    of = bench.w if letter == "w" else bench.e
    by, carrier = (of(link) if link != FRAME else None for link in (wheel.by, wheel.mesh.carrier))
    if (rate := _rate(wheel, by, carrier)) is not None:
        key = f"{letter}_{wheel.link}"
        bench.solved("rates_table", q.link_rate(letter, wheel.link), rate, bench.found.values[key])


def _rate(wheel: Coupled, by: Expr | None, carrier: Expr | None) -> Expr | None:
    """By Willis, relative to the carrier; None where both are nothing."""
    mesh = wheel.mesh
    if wheel.by == FRAME:
        return None if carrier is None else share_of(mesh).value(mesh.share).var() * carrier
    ratio = transfer_of(mesh).value(mesh.ratio).var()
    if carrier is None:
        return by and (by / ratio if wheel.backwards else ratio * by)
    relative = by - carrier if by is not None else -carrier
    return carrier + (relative / ratio if wheel.backwards else ratio * relative)
