"""Formulas of the wear with their numbers."""

from __future__ import annotations

import numpy as np

from tmm_report.chapters.machine.wear.guide import FACES, SIDES, GuideFound, Surface
from tmm_report.chapters.machine.wear.pivot import PivotFound
from tmm_report.chapters.machine.wear.quantities import CAUSES, guide_book, pivot_book, side_index
from tmm_report.i18n import NP_
from tmm_report.quantity.definition import Definition
from tmm_report.quantity.formula import Expr, Formula, Function, Number, Var, cos, sin
from tmm_report.quantity.symbols import Symbol


class GuideFormulas:
    def __init__(self, found: GuideFound, prefix: str):
        self.found, self.prefix = found, prefix
        self.of = guide_book(found, prefix)
        self.surfaces = self.of.table("surfaces")
        self.profile, self.cycle = self.of.table("profile"), self.of.table("cycle")

    def v(self, key: str, unit: str = "") -> Var:
        return self.of[key].var(unit)

    def f(self, key: str, expression: Expr, unit: str = "") -> Formula:
        return self.of[key].formula(expression, unit)

    def row(self, one: Surface, cause: int) -> int:
        """Of a face and a cause in the table of the surfaces."""
        return 2 * (2 * SIDES.index(one.side) + FACES.index(one.face)) + cause

    def sizes(self) -> list[Formula]:
        return [
            self.f("length", self.v("stroke", "mm") + self.v("slider", "mm"), "mm"),
            self.f("step", self.v("length", "mm") / self.v("parts"), "mm"),
            self.f("ratio", self.v("slider", "mm") / self.v("step", "mm")),
        ]

    def places(self) -> list[Definition]:
        """In symbols: points under the slider, the first of them, and the one under its point k."""
        step, covered, begin = Var("Delta_L", 0.0), Symbol("N", "s"), Symbol("N", "begin")
        return [
            Definition(covered, Var("l_s", 0.0) / step + 1),
            Definition(begin, Var("S", 0.0) / step + 1),
            Definition(Symbol("j"), Var(begin, 0.0) + Var("k", 0.0) - 1),
        ]

    def pressures(self) -> list[Definition]:
        """In symbols: mean pressures of a face under the central reaction, of a half of it under the couple."""
        area = Var("b", 0.0) * Var("l_s", 0.0)
        return [
            Definition(Symbol("p", "R"), Var("R", 0.0) / area),
            Definition(Symbol("p", "M"), 2 * Var(Symbol("F", "M"), 0.0) / area),
        ]

    def couple(self) -> Formula:
        """Where it is greatest."""
        at = int(np.argmax(self.found.couple))
        arm = Number(2.0) / 3 * self.v("slider")
        return self.cycle.formula("F_M", at, abs(self.cycle.var("M", at)) / arm)

    def shares(self) -> list[Definition]:
        """In symbols: places of the points, and the part of a point in the force of its half."""
        k, covered, step = Var("k", 0.0), Var("N_s", 0.0), Var("Delta_L", 0.0)
        place = Definition(Symbol("xi", "k"), (k - (covered + 1) / 2) * step)
        size = abs(Var("xi_k", 0.0))
        part = size / (Var(Symbol("Sigma"), 0.0) * size)
        return [place, Definition(Symbol("F", "k"), Var(Symbol("F", "M"), 0.0) * part)]

    def sums(self) -> list[Definition]:
        """In symbols: the sums of a point, and its wear."""
        path = abs(Var("q_i", 0.0)) * Var(Symbol("Deltaphi"), 0.0)
        central = Var(Symbol("SigmaR", "i"), 0.0) * path / Var("N_s", 0.0)
        turning = Var(Symbol("SigmaF", "k"), 0.0) * path
        parts = [Var(Symbol("c", one), 0.0) * Var(Symbol("W", "", one), 0.0) for one in ("R", "M")]
        return [
            Definition(Symbol("W", "", "R"), central),
            Definition(Symbol("W", "", "M"), turning),
            Definition(Symbol("u"), parts[0] + parts[1]),
        ]

    def coefficient(self) -> list[Formula]:
        """Of the guide's face worn most."""
        return [self._coefficient(self.found.worst_guide, cause) for cause in range(2)]

    def _coefficient(self, one: Surface, cause: int) -> Formula:
        row = self.row(one, cause)
        k = self.surfaces.var("k", row)
        width, step = self.v("width", "mm"), self.v("step", "mm")
        return self.surfaces.formula("c", row, self.v("cycles") * k / (width * step))

    def deepest(self) -> Formula:
        """The wear of the guide's point worn most."""
        one = self.found.worst_guide
        parts = [
            self.surfaces.var("c", self.row(one, cause))
            * self.profile.var(f"work_{CAUSES[cause]}_{one.face}", one.worst)
            for cause in range(2)
        ]
        return self.profile.formula(f"u_{one.face}", one.worst, parts[0] + parts[1], "µm")

    def volumes(self) -> list[Formula]:
        """Of the guide's face worn most, by the law as a whole: k ∫ R|ds| for each cycle."""
        one = self.found.worst_guide
        rows = [self.row(one, cause) for cause in range(2)]
        return [
            self.surfaces.formula("volume", row, self._lost(row), "mm³")
            for row in rows
            if self.surfaces["rubbed"].values[row] > 0
        ]

    def _lost(self, row: int) -> Expr:
        return self.v("cycles") * self.surfaces.var("k", row) * self.surfaces.var("rubbed", row, "kN·m")

    def mass(self) -> Formula:
        return self.f("mass", self.v("density") * self.v("volume"))

    def uneven(self) -> Formula:
        one = self.found.worst_guide
        return self.f("uneven", self.profile.var(f"u_{one.face}", one.worst, "µm") / self.v("even", "µm"))

    def rate(self) -> list[Formula]:
        return [
            self.f("time", self.v("cycles") * self.v("period") / Number(3600.0)),
            self.f("rate", self.v("greatest", "µm") / self.v("time")),
        ]

    def life(self) -> list[Formula]:
        """Without running in the wear is the rate by the time."""
        made = [self.f("life_cycles", 3600 * self.v("life") / self.v("period"))]
        if self.found.given.running_in is None:
            made.insert(0, self.f("life", self.v("limit", "µm") / self.v("rate")))
        return made

    def stages(self) -> Definition:
        """u(t) of running in and steady wear, in symbols."""
        t = Var("t", 0.0)
        fades = Function(NP_("function", "exp"), -(t / Var("tau", 0.0)), np.exp)
        return Definition(Symbol("u"), Var("u_0", 0.0) * (1 - fades) + Var("gamma", 0.0) * t)

    def named(self, one: Surface) -> Symbol:
        return Symbol("u", side_index(one))


class PivotFormulas:
    def __init__(self, found: PivotFound, prefix: str):
        self.found, self.prefix = found, prefix
        self.of = pivot_book(found, prefix)
        self.members = self.of.table("members")

    def v(self, key: str, unit: str = "") -> Var:
        return self.of[key].var(unit)

    def sums(self) -> list[Definition]:
        """In symbols: the sum of a sector and its wear."""
        path = abs(Var("omega_i", 0.0)) * Var("r", 0.0) * Var(Symbol("Deltat"), 0.0)
        whole = Definition(Symbol("w"), Var(Symbol("Sigmap", "i"), 0.0) * path)
        return [whole, Definition(Symbol("u"), Var("N_c", 0.0) * Var("k", 0.0) * Var("w", 0.0))]

    def spread(self) -> Formula:
        alpha = self.v("arc")
        if self.found.given.law == "uniform":
            return self.of["spread"].formula(alpha / sin(alpha))
        return self.of["spread"].formula(2 * sin(alpha) / (alpha + sin(alpha) * cos(alpha)))

    def depths(self) -> list[Formula]:
        return [
            self.members.formula("depth", row, self._rubbed(row) * self.members.var("path", row), "µm")
            for row in range(2)
        ]

    def volumes(self) -> list[Formula]:
        whole = self.v("spread") * self.v("rubbed", "kN·m")
        return [self.members.formula("volume", row, self._rubbed(row) * whole, "mm³") for row in range(2)]

    def _rubbed(self, row: int) -> Expr:
        return self.v("cycles") * self.members.var("k", row)

    def life(self) -> Formula:
        return self.of["life_cycles"].formula(self.v("limit") / self.v("greatest") * self.v("cycles"))
