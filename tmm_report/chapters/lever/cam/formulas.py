"""The law of a cam written out at table positions, one for each way in which the follower moves, and how the pressure
angle and the sizes follow."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmm_report.chapters.lever.cam import quantities as q
from tmm_report.chapters.lever.cam.solve import CamFound, Sample
from tmm_report.quantity.formula import PI, Expr, Formula, Number, cos, expr, sin, sqrt
from tmm_report.quantity.formula import arccos as angle_of
from tmm_report.quantity.functions import arctan
from tmm_report.quantity.model import Book
from tmm_report.records import dataclass

Three = tuple[Expr, Expr, Expr]


@dataclass(frozen=True, eq=False)
class Written:
    """A law at one position: the share of its phase that is over, and the displacement with its derivatives."""

    sample: Sample
    formulas: tuple[Formula, ...]


def laws(found: CamFound, book: Book) -> list[Written]:
    """Each law of each way, at the first table position that has it."""
    return [Written(sample, tuple(_law(found, book, row))) for row, sample in enumerate(found.samples)]


def _law(found: CamFound, book: Book, row: int) -> Iterator[Formula]:
    sample, table = found.samples[row], book.tables[f"cam_law_{found.cam.name}"]
    h = book[q.lift(found).key].var()
    theta, beta, tau = (table.var(key, row) for key in (q.WITHIN.key, q.BETA.key, q.SHARE.key))
    yield table.formula(q.SHARE.key, row, theta / beta)
    f, slope, bend = _shape(sample.phase.law, tau, sample.share)
    rises = sample.phase.kind == "rise"
    motion = book.tables[f"cam_motion_{found.cam.name}_table"]
    steps: list[Expr] = [h * f if rises else h * (1 - f)]
    steps += [h * slope / beta, h * bend / beta**2] if rises else [-(h * slope / beta), -(h * bend / beta**2)]
    keys = [make(found).key for make in (q.displacement, q.first, q.second)]
    for key, step in zip(keys, steps, strict=True):
        yield motion.formula(key, sample.position, step)


def _shape(law: str, tau: Expr, share: float) -> Three:
    """f, f', f'' of a law; of the parabolic one by the half of the phase."""
    if law == "parabolic":
        if share < 0.5:
            return 2 * tau**2, 4 * tau, Number(4.0)
        return 1 - 2 * (1 - tau) ** 2, 4 * (1 - tau), Number(-4.0)
    if law == "cosine":
        return (1 - cos(PI * tau)) / 2, PI / 2 * sin(PI * tau), PI**2 / 2 * cos(PI * tau)
    if law == "sine":
        turned = 2 * PI * tau
        return tau - sin(turned) / (2 * PI), 1 - cos(turned), 2 * PI * sin(turned)
    if law == "polynomial":
        return (
            10 * tau**3 - 15 * tau**4 + 6 * tau**5,
            30 * tau**2 - 60 * tau**3 + 30 * tau**4,
            60 * tau - 180 * tau**2 + 120 * tau**3,
        )
    return tau, expr(1), expr(0)


# ---------------------------------------------------------------- sizes


def pitch_base(found: CamFound, book: Book) -> Formula | None:
    """R0 = R + r of a roller."""
    if not found.cam.roller:
        return None
    name = found.cam.name
    return book[f"cam_pitch_base_{name}"].formula(
        book[f"cam_base_{name}"].var() + book[f"cam_roller_{name}"].var()
    )


def start(found: CamFound, book: Book) -> Formula | None:
    """The follower's lowest position over the base circle: S0 = √(R0² − e²), or the angle of triangle O, C, B."""
    if found.cam.flat or found.law is None:
        return None
    name = found.cam.name
    base = book[f"cam_{'pitch_' if found.cam.roller else ''}base_{name}"].var()
    if found.slides:
        return book[f"cam_start_{name}"].formula(sqrt(base**2 - book[f"cam_offset_{name}"].var() ** 2))
    d, arm = book[f"cam_apart_{name}"].var(), book[f"cam_arm_{name}"].var()
    return book[f"cam_start_{name}"].formula(angle_of((d**2 + arm**2 - base**2) / (2 * d * arm)))


def pressure(found: CamFound, book: Book, position: int) -> Formula | None:
    """tan α = (S' − e)/(S0 + S), or [l(ψ' ∓ 1) ± d cos(ψ0 + ψ)]/(d sin(ψ0 + ψ)); None of a flat face."""
    if found.cam.flat or not np.isfinite(found.table.alpha[position]):
        return None
    name, table = found.cam.name, book.tables[f"cam_motion_{found.cam.name}_table"]
    S, slope = (table.var(make(found).key, position) for make in (q.displacement, q.first))
    lowest = book[f"cam_start_{name}"].var()
    if found.slides:
        tangent = (slope - book[f"cam_offset_{name}"].var()) / (lowest + S)
    else:
        d, arm = book[f"cam_apart_{name}"].var(), book[f"cam_arm_{name}"].var()
        turned = lowest + S
        near = d * cos(turned)
        top = near - arm * (1 - slope) if found.alike else arm * (1 + slope) - near
        tangent = top / (d * sin(turned))
    return table.formula(q.pressure(found).key, position, arctan(tangent))
