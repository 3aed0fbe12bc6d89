"""View of a spur pair in motion: its pitch-line velocity, what that allows, velocities of the point of contact."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import Any

from markupsafe import Markup

from tmm_report.chapters.gears.spur.solve.motion import FAST, NARROWEST, SLOW, WIDEST, Motion
from tmm_report.chapters.gears.spur.solve.pair import Found
from tmm_report.quantity.formula import Expr, Formula, Number, Var, sqrt
from tmm_report.quantity.part import Part
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Column, Table, numeric


class MotionView:
    """`part`: the numbers of the stage. Wheels are counted 0 and 1 and named as in the drive."""

    def __init__(self, found: Found, page: Page, part: Part):
        assert found.motion is not None
        self.found, self.page, self.part, self.t = found, page, part, page.t
        self.motion: Motion = found.motion
        self.names = found.given.wheels
        self.row = found.motion.fastest

    @cached_property
    def table(self) -> Any:
        return self.part.table("velocities")

    @property
    def point(self) -> str:
        """Where the profiles slide fastest."""
        return str(self.table["point"].values[self.row])

    def omega(self, i: int) -> Var:
        return self.part[f"omega_{self.names[i]}"].var()

    # ------------------------------------------------------------ the limit of specific sliding

    def speeds(self) -> Markup:
        """Angular velocities of both wheels."""
        return self.page.values(self.omega(i) for i in (0, 1))

    def pitch(self) -> Formula:
        return self.part["v_pitch"].formula(self.omega(0) * self._size("d_w", 0) / 2)

    def _size(self, key: str, i: int) -> Var:
        """A diameter in metres."""
        return self.part.table("wheels").var(key, i)

    @property
    def stated(self) -> bool:
        """Whether the limit is stated and does not follow from the velocity."""
        return self.found.given.sliding_limit is not None

    @property
    def falling(self) -> bool:
        """Whether the velocity lies where the limit falls."""
        return SLOW < self.motion.pitch < FAST

    def limit(self) -> Formula:
        """λ_max between both velocities."""
        fall = Number((WIDEST - NARROWEST) / (FAST - SLOW))
        return self.part["sliding_limit"].formula(
            Number(WIDEST) - fall * (self.part["v_pitch"].var() - Number(SLOW))
        )

    def limit_value(self) -> Markup:
        return self.page.value(self.part["sliding_limit"].var())

    # ------------------------------------------------------------ velocities of the point of contact

    def along(self) -> Formula:
        return self.part["v_along"].formula(self.omega(0) * self._size("d_b", 0) / 2)

    def across(self) -> Iterator[Formula]:
        """Across the line of action where the profiles slide fastest, and the whole velocities there."""
        for i, name in enumerate(self.names):
            rho = self.part.table("points").var(f"rho_{name}", self.row)
            yield self._formula(f"v_tau_{name}", self.omega(i) * rho)
        for name in self.names:
            yield self._formula(f"v_{name}", sqrt(self.part["v_along"].var() ** 2 + self._var(name) ** 2))
        yield self._formula("v_sl", self._var(self.names[0]) - self._var(self.names[1]))

    def _var(self, name: str) -> Var:
        return self.table.var(f"v_tau_{name}", self.row)

    def _formula(self, key: str, expression: Expr, size: bool = False) -> Formula:
        return self.table.formula(key, self.row, expression, size=size)

    def by_distance(self) -> Formula:
        """The same by the distance from the pitch point: (ω1 ± ω2) PK."""
        one, other = (self.omega(i) for i in (0, 1))
        if self.found.given.internal:
            rate = one - other if self.motion.omega[0] > self.motion.omega[1] else other - one
        else:
            rate = one + other
        return self._formula("v_sl", rate * self.part["v_way"].var(), size=True)

    def velocities(self, caption: Any) -> Table:
        points = [
            self.page.word(name, self.table, "point", row)
            for row, name in enumerate(self.table["point"].values)
        ]
        columns = [self.page.column(self.table, column.key) for column in self.table.columns[1:]]
        return numeric(caption, Column(self.t("Point"), points), columns)

    def where(self) -> list[dict[str, Any]]:
        formulas = [self.along(), *self.across(), self.by_distance()]
        return self.page.where(*formulas)
