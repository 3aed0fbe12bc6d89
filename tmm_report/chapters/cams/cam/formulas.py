"""The law of a cam written out at table positions, one for each way in which the follower moves, and how the pressure
angle and the sizes follow."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from tmm_report.chapters.cams.cam import quantities as q
from tmm_report.chapters.cams.cam.solve.found import CamFound, Sample
from tmm_report.mechanics.cams.shapes import Graph, Laid, Parabolic, rising
from tmm_report.quantity.formula import PI, Expr, Formula, Number, cos, expr, sin, sqrt
from tmm_report.quantity.formula import arccos as angle_of
from tmm_report.quantity.functions import arctan
from tmm_report.quantity.model import Book, Table
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
    sample, table = found.samples[row], book.tables[q.named(found, "cam_law")]
    h = book[q.lift(found).key].var()
    theta, beta, tau = (table.var(key, row) for key in (q.WITHIN.key, q.BETA.key, q.SHARE.key))
    yield table.formula(q.SHARE.key, row, theta / beta)
    f, slope, bend = _shape(found, book, row, tau)
    rises = sample.phase.kind == "rise"
    motion = book.tables[q.named(found, "cam_motion", "table")]
    steps: list[Expr] = [h * f if rises else h * (1 - f)]
    steps += [h * slope / beta, h * bend / beta**2] if rises else [-(h * slope / beta), -(h * bend / beta**2)]
    keys = [make(found).key for make in (q.displacement, q.first, q.second)]
    for key, step in zip(keys, steps, strict=True):
        yield motion.formula(key, sample.position, step)


def _shape(found: CamFound, book: Book, row: int, tau: Expr) -> Three:
    """f, f', f'' of the law of a sample; of one made of pieces that in which the sample is."""
    sample = found.samples[row]
    law = sample.phase.law
    if isinstance(law, Parabolic):
        n: Expr = expr(1)
        if law.ratio != 1:
            n = book.tables[q.named(found, "cam_law")].var(q.RATIO.key, row)
        return _parabolic(tau, n, sample.share < law.switch, law.ratio == 1)
    if isinstance(law, Graph):
        number = found.number_of(sample)
        return _piece(found.pieces[number].laid, book.tables[q.named(found, "cam_pieces")], number, tau)
    return WHOLE[law.name](tau) if law else (expr(0), expr(0), expr(0))


def _parabolic(tau: Expr, n: Expr, first: bool, even: bool) -> Three:
    """`even`: as long an acceleration as a deceleration, n = 1."""
    if first:
        up = expr(2) if even else 1 + n
        return up * tau**2, (Number(4.0) if even else 2 * up) * tau, Number(4.0) if even else 2 * up
    down = expr(2) if even else 1 + 1 / n
    left = 1 - tau
    return (
        1 - down * left**2,
        (Number(4.0) if even else 2 * down) * left,
        Number(-4.0) if even else -(2 * down),
    )


def _decreasing(tau: Expr) -> Three:
    return 3 * tau**2 - 2 * tau**3, 6 * tau - 6 * tau**2, 6 - 12 * tau


def _cosine(tau: Expr) -> Three:
    return (1 - cos(PI * tau)) / 2, PI / 2 * sin(PI * tau), PI**2 / 2 * cos(PI * tau)


def _sine(tau: Expr) -> Three:
    turned = 2 * PI * tau
    return tau - sin(turned) / (2 * PI), 1 - cos(turned), 2 * PI * sin(turned)


def _polynomial(tau: Expr) -> Three:
    return (
        10 * tau**3 - 15 * tau**4 + 6 * tau**5,
        30 * tau**2 - 60 * tau**3 + 30 * tau**4,
        60 * tau - 180 * tau**2 + 120 * tau**3,
    )


def _polynomial_4567(tau: Expr) -> Three:
    return (
        35 * tau**4 - 84 * tau**5 + 70 * tau**6 - 20 * tau**7,
        140 * tau**3 - 420 * tau**4 + 420 * tau**5 - 140 * tau**6,
        420 * tau**2 - 1680 * tau**3 + 2100 * tau**4 - 840 * tau**5,
    )


def _uniform(tau: Expr) -> Three:
    return tau, expr(1), expr(0)


WHOLE: dict[str, Callable[[Expr], Three]] = {
    "uniform": _uniform,
    "decreasing": _decreasing,
    "cosine": _cosine,
    "sine": _sine,
    "polynomial": _polynomial,
    "polynomial_4567": _polynomial_4567,
}


def _piece(one: Laid, table: Table, row: int, tau: Expr) -> Three:
    """f, f', f'' of a piece of a graph: its acceleration integrated twice from where it begins."""
    begins, width, f, slope, start, end = (
        table.var(key.key, row) for key in (q.BEGINS, q.WIDTH, q.REACHED, q.SLOPE, q.BEND, q.NEXT)
    )
    x = tau - begins if one.at else tau
    if one.form == "line":
        rate = None if one.start == one.end else (end - start if one.start else end) / width
        level, from_level = (
            (start if one.start else None),
            ((None, None, None) if rate is None else (rate / 6 * x**3, rate / 2 * x**2, rate * x)),
        )
    else:
        reach = 2 * width / PI  # 1/k of sin kx
        turned = PI * x / (2 * width)
        grows = rising(one)
        low, high = (start, end) if grows else (end, start)
        small = one.start if grows else one.end
        size = high - low if small else high
        level = low if small else None
        from_level = (
            (reach * size * (x - reach * sin(turned)), reach * size * (1 - cos(turned)), size * sin(turned))
            if grows
            else (reach**2 * size * (1 - cos(turned)), reach * size * sin(turned), size * cos(turned))
        )
    return (
        _sum(
            f if one.f else None, slope * x if one.slope else None, level and level / 2 * x**2, from_level[0]
        ),
        _sum(slope if one.slope else None, level and level * x, from_level[1]),
        _sum(level, from_level[2]),
    )


def _sum(*terms: Expr | None) -> Expr:
    """Of the terms that there are."""
    found = [term for term in terms if term is not None]
    return sum(found[1:], start=found[0]) if found else expr(0)


# ---------------------------------------------------------------- sizes


def pitch_base(found: CamFound, book: Book) -> Formula | None:
    """R0 = R + r of a roller."""
    if not found.cam.roller:
        return None
    return book[q.named(found, "cam_pitch_base")].formula(
        book[q.named(found, "cam_base")].var() + book[q.named(found, "cam_roller")].var()
    )


def start(found: CamFound, book: Book) -> Formula | None:
    """The follower's lowest position over the base circle: S0 = √(R0² − e²), or the angle of triangle O, C, B."""
    if found.cam.flat or found.law is None:
        return None
    base = book[q.named(found, "cam_pitch_base" if found.cam.roller else "cam_base")].var()
    if found.slides:
        return book[q.named(found, "cam_start")].formula(
            sqrt(base**2 - book[q.named(found, "cam_offset")].var() ** 2)
        )
    d, arm = book[q.named(found, "cam_apart")].var(), book[q.named(found, "cam_arm")].var()
    return book[q.named(found, "cam_start")].formula(angle_of((d**2 + arm**2 - base**2) / (2 * d * arm)))


def pressure(found: CamFound, book: Book, position: int) -> Formula | None:
    """tan α = (S' − e)/(S0 + S), or [l(ψ' ∓ 1) ± d cos(ψ0 + ψ)]/(d sin(ψ0 + ψ)); None of a flat face."""
    if found.cam.flat or not np.isfinite(found.table.alpha[position]):
        return None
    table = book.tables[q.named(found, "cam_motion", "table")]
    S, slope = (table.var(make(found).key, position) for make in (q.displacement, q.first))
    lowest = book[q.named(found, "cam_start")].var()
    if found.slides:
        tangent = (slope - book[q.named(found, "cam_offset")].var()) / (lowest + S)
    else:
        d, arm = book[q.named(found, "cam_apart")].var(), book[q.named(found, "cam_arm")].var()
        turned = lowest + S
        near = d * cos(turned)
        top = near - arm * (1 - slope) if found.alike else arm * (1 + slope) - near
        tangent = top / (d * sin(turned))
    return table.formula(q.pressure(found).key, position, arctan(tangent))
