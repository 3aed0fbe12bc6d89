"""The numbers of the wear: of every guide its surfaces, the profiles of its wear and how the slider stands; of every
pivot its members and the wear of their sectors."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from tmm_report.chapters.machine.wear import steps
from tmm_report.chapters.machine.wear.guide import CAUSES, FACES, GuideFound, Surface
from tmm_report.chapters.machine.wear.pivot import PivotFound
from tmm_report.chapters.machine.wear.solve import Found
from tmm_report.chapters.machine.wear.steps import HOUR
from tmm_report.chapters.machine.wear.values import (
    K_SIZE,
    UPRIGHT,
    Cycle,
    Depths,
    Members,
    Profile,
    Sectors,
    Sole,
    Stages,
    Surfaces,
)
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Table, Value, text_column
from tmm_report.quantity.sheet import Q
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.tabulated import tabulated

Array = Any
SHORT = {"force": "R", "couple": "M"}
POINTS = 61  # moments of the diagram of the greatest wear against the time


@tabulated
def tables(found: Found) -> Iterator[Table]:
    for guide in found.guides:
        yield from guide_tables(guide)
    for pivot in found.pivots:
        yield from pivot_tables(pivot)


@tabulated
def values(found: Found) -> Iterator[Value]:
    for guide in found.guides:
        yield from guide.s.values()
    for pivot in found.pivots:
        yield from pivot.s.values()


def _indexed(of: Q, indices: Sequence[str], numbers: Sequence[float]) -> Column:
    """A column whose rows have indices of their own before that of its letter."""
    sign = of.quantity.sign
    signs = [Symbol(sign.base, ",".join(filter(None, (index, sign.sub)))) for index in indices]
    return Column(of.quantity, [float(x) for x in numbers], signs)


# --- guides


@tabulated
def guide_tables(found: GuideFound) -> Iterator[Table]:
    of = {"name": found.given.guide}
    for key, text, columns in (
        (
            "surfaces",
            N_("faces of guide %(name)s and of its slider: pressures, coefficients, wear"),
            _surfaces,
        ),
        ("profile", N_("wear along guide %(name)s"), _profile),
        ("sole", N_("wear along the slider of guide %(name)s"), _sole),
        ("cycle", N_("slider on guide %(name)s over the cycle"), _cycle),
        ("stages", N_("greatest wear of guide %(name)s against the time"), _stages),
    ):
        yield Table(f"{found.s.PREFIX}{key}", Message(text, of), tuple(columns(found)))


def _surfaces(found: GuideFound) -> Iterator[Column]:
    """A row for each face and each cause."""
    rows = [(one, cause) for one in found.surfaces for cause in range(2)]
    yield text_column("side", Message(N_("member")), [one.side for one, _ in rows])
    yield text_column("face", Message(N_("face")), [one.face for one, _ in rows])
    yield text_column("cause", Message(N_("central reaction or its moment")), [CAUSES[n] for _, n in rows])
    index = [f"{one.symbol.sub},{SHORT[CAUSES[cause]]}" for one, cause in rows]
    for of, numbers in (
        (Surfaces.pressure, [one.pressure[n] for one, n in rows]),
        (Surfaces.k, [K_SIZE * one.k[n] for one, n in rows]),
        (Surfaces.c, [1e6 * one.c[n] for one, n in rows]),
        (Surfaces.work, [one.work[n].max() for one, n in rows]),
        (Surfaces.rubbed, [one.work[n].sum() for one, n in rows]),
        (Surfaces.depth, [one.parts[n].max() for one, n in rows]),
        (Surfaces.volume, [_volume(found, one, n) for one, n in rows]),
    ):
        yield _indexed(of, index, numbers)


def _volume(found: GuideFound, one: Surface, cause: int) -> float:
    return float(one.parts[cause].sum()) * found.given.width * found.grid.step


def _profile(found: GuideFound) -> Iterator[Column]:
    yield Profile.point.column(np.arange(len(found.grid.x)) + 1)
    yield Profile.x.column(found.grid.x)
    yield from _depths(found, "guide")
    yield Profile.resistance.column(found.resistance)
    yield Profile.even.column(np.where(np.isfinite(found.resistance), found.even, 0.0))


def _sole(found: GuideFound) -> Iterator[Column]:
    yield Sole.point.column(np.arange(found.grid.covered) + 1)
    yield Sole.xi.column(found.grid.xi)
    yield from _depths(found, "slider")


def _depths(found: GuideFound, side: str) -> Iterator[Column]:
    """Of both faces: sums, wear without skew, and with it."""
    for face in FACES:
        one, word = found.surface(side, face), Message(found.faced(face))
        number = one.symbol.sub
        for letter, of, lines in (("W", "work", one.work), ("u", "u", one.parts)):
            for cause, line in zip(CAUSES, lines, strict=True):
                key, symbol = f"{of}_{cause}", Symbol(letter, number, SHORT[cause])
                yield Depths.DECLARED[key].called(symbol, f"{key}_{face}", face=word).column(line)
        yield steps.depth(one, word).column(one.depth)


def _cycle(found: GuideFound) -> Iterator[Column]:
    """At every position over which it is summed."""
    shift, tilt = found.settled
    start = found.grid.start + 1
    s = Cycle({"R": UPRIGHT} if found.upright else {})
    for key, numbers in (
        ("phi", found.turned), ("S", found.travel), ("start", start), ("q", found.analogue), ("R", found.force),
        ("M", found.moment), ("h", found.arm), ("F_M", found.couple), ("shift", shift), ("tilt", tilt),
    ):  # fmt: skip
        yield s.quantity(key).column(numbers)


def _stages(found: GuideFound) -> Iterator[Column]:
    time = np.linspace(0.0, max(found.time, found.life or 0.0), POINTS)
    yield Stages.t.column(time / HOUR)
    yield Stages.u.column(found.worn(time))


# --- pivots


@tabulated
def pivot_tables(found: PivotFound) -> Iterator[Table]:
    of, prefix = {"name": found.given.pivot}, found.s.PREFIX
    text = N_("journal and bushing of pivot %(name)s")
    yield Table(f"{prefix}members", Message(text, of), tuple(_members(found)))
    text = N_("wear along the circumference of pivot %(name)s")
    yield Table(f"{prefix}sectors", Message(text, of), tuple(_sectors(found)))


def _members(found: PivotFound) -> Iterator[Column]:
    rows, density = found.members, found.given.density
    yield text_column("member", Message(N_("member")), [one.name for one in rows])
    yield text_column("link", Message(N_("link")), [one.link for one in rows])
    yield _indexed(Members.k, "12", [K_SIZE * one.k for one in rows])
    yield _indexed(Members.path, "12", [1e-6 * one.path.max() for one in rows])
    yield _indexed(Members.depth, "12", [one.greatest for one in rows])
    yield _indexed(Members.angle, "12", [found.centres[one.worst] for one in rows])
    yield _indexed(Members.volume, "12", [found.volume(one) for one in rows])
    if density is not None:
        yield _indexed(Members.mass, "12", [density * found.volume(one) for one in rows])


def _sectors(found: PivotFound) -> Iterator[Column]:
    yield Sectors.alpha.column(found.centres)
    for number, one in zip("12", found.members, strict=True):
        word = Message(MEMBER_WORDS[one.name])
        path = Sectors.path.called(Symbol("w", number), f"path_{one.name}", member=word)
        yield path.column(1e-6 * one.path)
        yield Sectors.u.called(Symbol("u", number), f"u_{one.name}", member=word).column(one.depth)


MEMBER_WORDS = {"journal": N_("journal"), "bushing": N_("bushing")}
