"""View of a spur pair in motion: its pitch-line velocity, what that allows, velocities of the point of contact."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from markupsafe import Markup

from tmm_report.chapters.gears.spur.quantities import tables
from tmm_report.chapters.gears.spur.solve.motion import Motion
from tmm_report.chapters.gears.spur.solve.pair import Found
from tmm_report.chapters.gears.spur.steps import Stage
from tmm_report.chapters.gears.spur.values import Values
from tmm_report.quantity.formula import Expr, Formula, sqrt
from tmm_report.report.chapter_view import ChapterView
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Column, Table, numeric


class MotionView(ChapterView):
    """Wheels are counted 0 and 1 and named as in the drive."""

    s: Values

    def __init__(self, found: Found, page: Page, of: Stage):
        assert found.motion is not None
        super().__init__(page, of.s, tables(found, of.prefix))
        self.found, self.names = found, found.given.wheels
        self.motion: Motion = found.motion
        self.velocities_of, self.row = self.table("velocities"), found.motion.fastest

    @property
    def point(self) -> str:
        """Where the profiles slide fastest."""
        return str(self.velocities_of["point"].values[self.row])

    # ------------------------------------------------------------ the limit of specific sliding

    def speeds(self) -> Markup:
        """Angular velocities of both wheels."""
        return self.listed(("omega_one", "omega_two"))

    @property
    def stated(self) -> bool:
        """Whether the limit is stated and does not follow from the velocity."""
        return self.found.given.sliding_limit is not None

    # ------------------------------------------------------------ velocities of the point of contact

    def across(self) -> Iterator[Formula]:
        """Across the line of action where the profiles slide fastest, and the whole velocities there."""
        omega = self.s.omega_one, self.s.omega_two
        for name, turns in zip(self.names, omega, strict=True):
            rho = self.table("points").var(f"rho_{name}", self.row)
            yield self._formula(f"v_tau_{name}", turns * rho)
        one, other = (self.velocities_of.var(f"v_tau_{name}", self.row) for name in self.names)
        for name, own in zip(self.names, (one, other), strict=True):
            yield self._formula(f"v_{name}", sqrt(self.s.v_along**2 + own**2))
        yield self._formula("v_sl", one - other)

    def _formula(self, key: str, expression: Expr, size: bool = False) -> Formula:
        return self.velocities_of.formula(key, self.row, expression, size=size)

    def by_distance(self) -> Formula:
        """The same by the distance from the pitch point: (ω1 ± ω2) PK."""
        one, other = self.s.omega_one, self.s.omega_two
        if self.found.given.internal:
            rate = one - other if self.motion.omega[0] > self.motion.omega[1] else other - one
        else:
            rate = one + other
        return self._formula("v_sl", rate * self.s.v_way, size=True)

    def velocities(self, caption: Any) -> Table:
        table = self.velocities_of
        points = [self.page.word(name, table, "point", row) for row, name in enumerate(table["point"].values)]
        columns = self.columns("velocities", leave=("point",))
        return numeric(caption, Column(self.t("Point"), points), columns)

    def meant(self) -> list[dict[str, Any]]:
        return self.where(self.formula("v_along"), *self.across(), self.by_distance())
