"""View of the contours written out: of each group its equations, the solution and both derivatives at one position."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from markupsafe import Markup

from tmm_report.chapters.lever.kinematics.contours.equations import Written
from tmm_report.chapters.lever.kinematics.contours.solve import Contours, contours
from tmm_report.chapters.lever.kinematics.contours.solve import tables as contour_tables
from tmm_report.chapters.lever.kinematics.contours.terms import WrittenSystem
from tmm_report.chapters.lever.kinematics.contours.translating import Translating
from tmm_report.chapters.lever.kinematics.solve.positions import Kinematics
from tmm_report.mechanics.lever.assur_groups import Group
from tmm_report.problems import N_
from tmm_report.quantity.formula import Formula, Number, Var, at
from tmm_report.quantity.model import Book
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.terms.kinds import Kinds, Worked
from tmm_report.quantity.written import Equation
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Table, worded
from tmm_report.report.words import group_name

CONVENTIONS = (
    (Symbol("x", "i"), N_("x coordinate of point i"), "m"),
    (Symbol("y", "i"), N_("y coordinate of point i"), "m"),
    (
        Symbol("v", "i", "x"),
        N_("projection of the velocity of point i on the x axis, likewise on the y axis"),
        "m/s",
    ),
    (
        Symbol("a", "i", "x"),
        N_("projection of the acceleration of point i on the x axis, likewise on the y axis"),
        "m/s²",
    ),
    (
        Symbol("gamma"),
        N_(
            "constant angle of a segment or guide with the direction from which the angle of its link is counted"
        ),
        "deg",
    ),
    (Symbol("k", "ij"), N_("coefficients of the differentiated equations of a group"), ""),
    (Symbol("Delta"), N_("determinant of the equations of a group"), ""),
    (Symbol("b", "i"), N_("known parts of the equations of velocities"), "m/s"),
    (Symbol("d", "i"), N_("known parts of the equations of accelerations"), "m/s²"),
)


class ContoursView:
    """`position`: the table position that is written out."""

    def __init__(self, found: Kinematics, position: int, page: Page):
        self.found, self.position, self.page, self.t = found, position, page, page.t
        self.written: Contours = page.once(contours, found, position)
        with np.errstate(invalid="ignore", divide="ignore"):  # positions that do not close are nan
            for formula, _ in self.written.bench.checks:
                _ = formula.value
        self.table = page.once(_tables, found)["contours"]
        self.kinds = Kinds(page.note.every, page.leaves_out)

    def conclusions(self) -> list[Markup]:
        return []

    @property
    def regular(self) -> bool:
        """Whether everything is known at the position."""
        sines = [float(sine[self.position]) for sine in self.found.table.sines.values()]
        return bool(self.written.groups) and bool(np.all(np.array(sines) > 1e-6))

    @property
    def driver(self) -> str:
        return self.found.linkage.mechanism.driver.link

    @property
    def by_law(self) -> bool:
        """Whether the driving link moves by a law, or follows a stroke that does."""
        return self.found.by_law

    def name(self, group: Group) -> str:
        return group_name(group)

    def is_system(self, written: Written | WrittenSystem | Translating) -> bool:
        return isinstance(written, WrittenSystem)

    def translates(self, written: Written | WrittenSystem | Translating) -> bool:
        return isinstance(written, Translating)

    def slotted(self) -> list[Markup]:
        """What is said of links that only translate because a fixed guide leads them."""
        text = N_(
            "Link %(link)s slides along a fixed guide and carries a guide of another link: it only translates. "
            "Its angular velocity and acceleration are zero at every position, and all its points have the same "
            "velocity and the same acceleration."
        )
        return [self.t(text, link=link) for link in self.written.slotted]

    def why(self, written: Translating) -> Markup:
        """Why the first link of a group only translates."""
        if written.rest is not None:
            text = N_(
                "Opposite sides are equal and the loop does not cross itself, so they stay parallel at every "
                "position. Link %(by)s slides along a fixed guide and does not turn, so link %(link)s does not "
                "either: it only translates, and all its points have the velocity and acceleration of %(at)s."
            )
        elif written.by:
            text = N_(
                "Opposite sides are equal and the loop does not cross itself, so they stay parallel at every "
                "position. Link %(by)s does not turn, so link %(link)s does not either: it only translates, and "
                "all its points have the velocity and acceleration of %(at)s."
            )
        else:
            text = N_(
                "Opposite sides are equal and the loop does not cross itself, so they stay parallel at every "
                "position. The side opposite to link %(link)s is fixed, so link %(link)s does not turn: it only "
                "translates, and all its points have the velocity and acceleration of %(at)s."
            )
        return self.t(text, link=written.links[0], by=written.by, at=written.at)

    def where(self, *formulas: Formula | Equation) -> list[dict[str, Any]]:
        """What a "where" list says of the quantities of the formulas."""
        return self.page.where(*formulas, kinds_once=not self.page.note.every)

    def conventions(self, items: Sequence[Mapping[str, Any]]) -> Markup:
        """What the symbols mean, in a sentence."""
        told = [
            self.page.listed(
                [self.page.sym(item["symbol"]), " – ", item["meaning"], *self._unit(item["unit"])], ""
            )
            for item in items
        ]
        return self.page.listed(told, "; ")

    def _unit(self, unit: str) -> tuple[str, ...]:
        return (", ", self.page.unit(unit)) if unit else ()

    def symbols(self) -> list[dict[str, Any]]:
        """The symbols that are alike for all points and groups; of constant angles where there are any."""
        turned = any(key.startswith("gamma_") for key in self.written.bench.constants)
        return [
            {"id": f"contours {symbol}", "symbol": symbol, "meaning": self.t(text), "unit": unit}
            for symbol, text, unit in CONVENTIONS
            if turned or symbol.base != "gamma"
        ]

    def said(self, formulas: Sequence[Formula], part: str = "") -> Worked:
        """Those that say more than that something is nothing, one of each kind in full. `part`: the group's name."""
        return self.kinds(
            (formula for formula in formulas if not isinstance(formula.expression, Number)), part
        )

    # ------------------------------------------------------------ groups above class II

    def values(self, variables: Sequence[Var]) -> Markup:
        """Unknowns with their values at the position."""
        return self.page.values(replace(var, number=at(var.number, self.position)) for var in variables)

    def system(self, caption: Any, written: WrittenSystem) -> Table:
        """The linear equations: a row an equation, a column an unknown, then both right sides."""
        rows = [
            [str(n), *(self.page.cell(self.table, key, self.position) for key in keys)]
            for n, keys in enumerate(written.rows, 1)
        ]
        units = [self.table[key].unit for key in written.rows[0]]
        names = [
            *(self.t("Unknown %(n)s", n=n) for n in range(1, len(written.unknowns) + 1)),
            self.t("Known part b"), self.t("Known part d"),
        ]  # fmt: skip
        heads = [self.t("No."), *(self._head(*head) for head in zip(names, units, strict=True))]
        return worded(caption, heads, rows, (1, *(2 for _ in heads[1:])))

    def _head(self, name: Markup, unit: str) -> Markup:
        return self.page.listed([name, self.page.unit(unit)]) if unit else name


def _tables(found: Kinematics) -> dict[str, Any]:
    return Book.of(contour_tables(found)).tables
