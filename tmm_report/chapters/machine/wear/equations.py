"""Formulas of rows of the tables, and what is defined in symbols: of the numbers themselves, so that a definition is
evaluated as any formula is."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmm_report.chapters.machine.wear.guide import CAUSES, FACES, SIDES, GuideFound, Surface
from tmm_report.chapters.machine.wear.pivot import Member, PivotFound
from tmm_report.chapters.machine.wear.values import K_SIZE
from tmm_report.i18n import NP_
from tmm_report.mechanics.pairs import wear
from tmm_report.quantity.definition import Definition
from tmm_report.quantity.formula import Expr, Formula, Function, Number, Page, Piece, Value, Var
from tmm_report.quantity.model import Table
from tmm_report.quantity.symbols import Symbol
from tmm_report.records import dataclass


@dataclass(frozen=True, eq=False)
class Summed(Expr):
    """The sum of an expression over its values, printed as it is: its first letter begins with Σ."""

    body: Expr

    def evaluate(self, digits: int | None = None) -> Value:
        return np.sum(self.body.evaluate(digits))

    def piece(self, page: Page) -> Piece:
        return self.body.piece(page)

    def terms(self, page: Page) -> Iterator[str]:
        return self.body.terms(page)


# --- a guide and its slider


def places(found: GuideFound) -> list[Definition]:
    """Points under the slider, the first of them (P, 1), and the one under its point k (P, N_s), before rounding."""
    s, grid = found.s, found.grid
    begin = Var("N_begin", grid.start[:, None] + 1)
    k = Var("k", np.arange(grid.covered) + 1)
    return [
        Definition(s.covered.sign, s.slider / s.step + 1),
        Definition(begin.sign, Var("S", 1e3 * found.travel[:, None], "mm") / s.step + 1),
        Definition(Symbol("j"), begin + k - 1),
    ]


def pressures(found: GuideFound) -> list[Definition]:
    """Mean pressures of a face under the central reaction, of a half of it under the couple, MPa, (P,)."""
    area = found.s.width * found.s.slider
    return [
        Definition(Symbol("p", "R"), Var("R", np.abs(found.force), "N") / area),
        Definition(Symbol("p", "M"), 2 * Var("F_M", found.couple, "N") / area),
    ]


def couple(found: GuideFound, cycle: Table) -> Formula:
    """Where it is greatest."""
    at = found.skewest
    arm = Number(2.0) / 3 * found.s["slider"].var()
    return cycle.formula("F_M", at, abs(cycle.var("M", at)) / arm)


def shares(found: GuideFound) -> list[Definition]:
    """Places of the points of a half, mm, and the part of each in its greatest force, N."""
    s, ahead = found.s, found.grid.xi > 0
    k = Var("k", np.arange(found.grid.covered)[ahead] + 1)
    size = abs(Var("xi_k", 1e3 * found.grid.xi[ahead], "mm"))
    part = size / Summed(Var(Symbol("Sigma"), 1.0) * size)
    return [
        Definition(Symbol("xi", "k"), (k - (s.covered + 1) / 2) * s.step),
        Definition(Symbol("F", "k"), Var("F_M", float(found.couple[found.skewest]), "N") * part),
    ]


def sums(found: GuideFound) -> list[Definition]:
    """The sums of the guide's point worn most, N·m, and its wear, µm; over the positions (P,)."""
    one = found.worst_guide
    force, turning = found.pressing(one.face, one.worst)
    path = abs(Var("q_i", found.analogue, "m")) * Var(Symbol("Deltaphi"), found.step)
    central = Var(Symbol("SigmaR", "i"), force, "N") * path / found.s.covered
    parts = [
        Var(Symbol("c", letter), 1e6 * one.c[cause])
        * Var(Symbol("W", "", letter), one.work[cause][one.worst])
        for cause, letter in enumerate("RM")
    ]
    return [
        Definition(Symbol("W", "", "R"), Summed(central)),
        Definition(Symbol("W", "", "M"), Summed(Var(Symbol("SigmaF", "k"), turning, "N") * path)),
        Definition(Symbol("u"), parts[0] + parts[1]),
    ]


def _row(one: Surface, cause: int) -> int:
    """Of a face and a cause in the table of the surfaces."""
    return 2 * (2 * SIDES.index(one.side) + FACES.index(one.face)) + cause


def coefficients(found: GuideFound, surfaces: Table) -> list[Formula]:
    """Of the guide's face worn most."""
    s, rows = found.s, [_row(found.worst_guide, cause) for cause in range(2)]
    return [
        surfaces.formula("c", row, s.cycles * surfaces.var("k", row) / (s.width * s.step)) for row in rows
    ]


def deepest(found: GuideFound, surfaces: Table, profile: Table) -> Formula:
    """The wear of the guide's point worn most."""
    one = found.worst_guide
    parts = [
        surfaces.var("c", _row(one, n)) * profile.var(f"work_{cause}_{one.face}", one.worst)
        for n, cause in enumerate(CAUSES)
    ]
    return profile.formula(f"u_{one.face}", one.worst, parts[0] + parts[1], "µm")


def volumes(found: GuideFound, surfaces: Table) -> list[Formula]:
    """Of the guide's face worn most, by the law as a whole: k ∫ R|ds| for each cycle."""
    rows = [_row(found.worst_guide, cause) for cause in range(2)]
    return [
        surfaces.formula(
            "volume",
            row,
            found.s.cycles * surfaces.var("k", row) * surfaces.var("rubbed", row, "kN·m"),
            "mm³",
        )
        for row in rows
        if surfaces["rubbed"].values[row] > 0
    ]


def stages(found: GuideFound, table: Table) -> Definition:
    """u(t) of running in and steady wear, µm, at the times of the table."""
    s, t = found.s, Var("t", table["t"].numbers(), "h")
    fades = Function(NP_("function", "exp"), -(t / s.constant), np.exp)
    return Definition(Symbol("u"), s.run_in * (1 - fades) + s.rate * t)


# --- a pivot


def sectors(found: PivotFound) -> list[Definition]:
    """The sum of the sector worn most, MPa·m, and its wear, µm; over the positions (P,)."""
    one = found.worst
    pressed = 1e-6 * _pressure(found, one)
    step = Var(Symbol("Deltat"), found.period / len(found.force), "s")
    path = abs(Var("omega_i", found.rate, "rad/s")) * Var("r", found.radius, "m") * step
    summed = Var("w", 1e-6 * float(one.path[one.worst]), "MPa·m")
    return [
        Definition(summed.sign, Summed(Var(Symbol("Sigmap", "i"), pressed, "MPa") * path)),
        Definition(Symbol("u"), found.s.cycles * Var("k", K_SIZE * one.k) * summed),
    ]


def _pressure(found: PivotFound, of: Member) -> np.ndarray:
    """On the sector worn most, Pa, (P,)."""
    given = found.given
    return wear.pressures(
        given.half_arc, given.law, found.radius, given.width, found.force, of.centre, given.sectors
    )[:, of.worst]


def depths(found: PivotFound, members: Table) -> list[Formula]:
    return [
        members.formula("depth", row, _rubbed(found, members, row) * members.var("path", row), "µm")
        for row in range(2)
    ]


def pivot_volumes(found: PivotFound, members: Table) -> list[Formula]:
    whole = found.s.spread * found.s.rubbed
    return [members.formula("volume", row, _rubbed(found, members, row) * whole, "mm³") for row in range(2)]


def _rubbed(found: PivotFound, members: Table, row: int) -> Expr:
    return found.s.cycles * members.var("k", row)
