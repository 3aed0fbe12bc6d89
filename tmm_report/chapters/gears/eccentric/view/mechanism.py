"""View of the eccentric epicyclic mechanism: what its template prints beside the formulas."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import cached_property
from typing import Literal

import numpy as np
from markupsafe import Markup

from tmm_report.chapters.gears.eccentric import equations
from tmm_report.chapters.gears.eccentric.draw import assembled, close
from tmm_report.chapters.gears.eccentric.solve.mechanism import Found
from tmm_report.chapters.gears.eccentric.solve.satellites import Satellite
from tmm_report.chapters.gears.eccentric.view.further import FurtherView
from tmm_report.chapters.gears.eccentric.view.tables import CONDITIONS, EccentricTables
from tmm_report.figures.drawing import Drawing
from tmm_report.problems import N_
from tmm_report.quantity.definition import Definition
from tmm_report.quantity.formula import Formula
from tmm_report.quantity.written import Equation
from tmm_report.report.page import Page
from tmm_report.report.part import Failed, Part


def parts(found: Found, page: Page) -> Iterator[Part]:
    yield Part("gears/eccentric", EccentricView(found, page))


def picture(found: Found, page: Page) -> Drawing:
    """The mechanism at a glance, for a list of many."""
    return assembled.assembled(found, page.num)


class EccentricView(EccentricTables):
    # ------------------------------------------------------------ words

    @property
    def name(self) -> str | None:
        return self.found.given.name

    def given_values(self) -> Markup:
        return self.told_of(("u_teeth", "e", "m", "alpha", "ha", "c", "delta", "j_n"))

    def wheels(self, satellites: tuple[Satellite, ...]) -> Markup:
        return self.page.listed(s.wheel for s in satellites)

    @property
    def rule_met(self) -> bool:
        return self.found.ring >= self.s.number("ring_rule")

    @property
    def limited(self) -> bool:
        """Whether some number of teeth of the ring suits every satellite."""
        return bool(np.isfinite(self.of("satellites", "z3_least").numbers()).all())

    # ------------------------------------------------------------ formulas

    def general(self) -> Equation:
        return equations.general(self.made)

    def with_numbers(self) -> Equation:
        return equations.with_numbers(self.made)

    def solutions(self) -> list[Definition]:
        return equations.solutions(self.made)

    def teeth(self, wheel: Literal["ring", "middle", "smallest"]) -> Definition:
        """By those of the others, in every set."""
        of = {
            "ring": equations.ring_teeth,
            "middle": equations.middle_teeth,
            "smallest": equations.smallest_teeth,
        }
        return of[wheel](self.made)

    def chosen(self) -> list[Formula]:
        """Teeth of the chosen set from its t."""
        return [self.made.set.formula(key) for key in self.made.set.computed()]

    def of_satellites(self, *keys: str) -> list[Formula]:
        """Of each that mirrors no other; angles of those alone that are off the axis."""
        rows = [self.made.row(s) for s in self.found.upper]
        return self.of_each_kind(row.formula(key) for row in rows for key in keys if row.has_formula(key))

    def ring_limit(self) -> Formula:
        """Least teeth of the ring beside the satellite that asks for most of them."""
        return self.made.row(self.hardest).formula("z3_least")

    def beside(self) -> list[Formula]:
        """Distance and gap of neighbours."""
        return self.of_each_kind(pair.formula(key) for pair in self.made.pairs for key in ("l", "gap"))

    @property
    def hardest(self) -> Satellite:
        """The satellite beside which the ring must have most teeth."""
        return max(self.found.upper, key=lambda s: self.made.row(s).number("z3_least"))

    # ------------------------------------------------------------ the sets

    def sets(self, kind: Literal["residue", "replaced"]) -> Markup | None:
        """Numbers t of the sets in which the middle satellites do not assemble ("residue") or the smallest satellite
        must replace the largest ("replaced"); None where there are none."""
        judged, given = self.found.judged, self.found.given
        rows = judged.loose(given.slack) if kind == "residue" else judged.replaced(given.clearance)
        numbers = self.page.listed(self.page.shown(self.table("family"), "t", int(row)) for row in rows)
        return self.page.listed([self.page.sym("t"), numbers], " = ") if len(rows) else None

    @property
    def residue(self) -> Markup:
        """Of the middle satellite of the chosen set, its size."""
        return self.page.shown(self.table("family"), "residue_4", self.found.row, size=True, digits=4)

    @property
    def full_set(self) -> Markup | None:
        """t, teeth and the free distance of the most compact set that holds all four satellites."""
        row = self.found.judged.full
        if row is None:
            return None
        text = N_("%(t)s (teeth %(teeth)s), where %(gap)s mm are left between planet gears 2 and 4")
        family = self.table("family")
        teeth = [self.page.shown(family, key, row) for key in ("z1", "z2", "z3", "z4")]
        gap = self.page.shown(family, "closed_2_4", row, places=3)
        t = self.page.value(family.var("t", row))
        return self.t(text, t=t, teeth=self.page.listed(teeth), gap=gap)

    @cached_property
    def further(self) -> FurtherView:
        return FurtherView(self.found, self.page)

    # ------------------------------------------------------------ pictures

    def _text(self, value: float) -> str:
        return self.page.num(value, 5)

    @cached_property
    def drawing(self) -> Drawing:
        return assembled.assembled(self.found, self._text, str(self.t("The mechanism assembled")))

    @cached_property
    def close(self) -> Drawing:
        title = N_("Meshes and neighbours enlarged") if self.close_shows_neighbours else N_("Meshes enlarged")
        return close.close(self.found, self._text, str(self.t(title)))

    @property
    def close_shows_neighbours(self) -> bool:
        """Whether the close view shows neighbours besides the meshes."""
        return self.found.narrowest is not None

    def scale(self, which: Literal["drawing", "close"]) -> Markup:
        """A drawing's scale as it is written on it: 1:2, 4:1."""
        scale = self.found.scale if which == "drawing" else self.found.close_scale
        if scale >= 1:
            return self.page.listed([self.number(f"{which}_enlargement"), "1"], ":")
        return self.page.listed(["1", self.number(f"{which}_reduction")], ":")

    # ------------------------------------------------------------ conclusions

    def conclusions(self) -> list[Markup]:
        """What failed, first; then what was found."""
        lines = []
        if self.found.failed:
            text = N_("Not all conditions of the eccentric epicyclic mechanism are met: %(conditions)s.")
            lines.append(Failed(self.t(text, conditions=self.page.listed(self.failed(), "; "))))
        return [*lines, self.page.listed(self._told(), " ")]

    def _told(self) -> Iterator[Markup]:
        text = N_(
            "The eccentric epicyclic mechanism has the teeth %(teeth)s and, with the axes stopped, the ratio "
            "%(ratio)s; number of its planet gears: %(count)s."
        )
        teeth = self.page.listed(self._all_teeth())
        yield self.t(text, teeth=teeth, ratio=self.number("u"), count=self.number("satellites"))
        if self.found.neighbours:
            nearest = min(self.found.near, key=lambda pair: pair.gap)
            row = self.found.near.index(nearest)
            gap = self.page.shown(self.table("neighbours"), "gap", row, digits=4)
            yield self.t(
                "Its neighbouring planet gears are %(gap)s mm apart at the narrowest place.", gap=gap
            )
        if self.found.nearby:
            text = N_("Within %(tolerance)s %% of the ratio there are %(count)s sets of teeth.")
            yield self.t(text, tolerance=self.number("tolerance", digits=3), count=self.number("near_sets"))
        if self.knows("saved_share"):
            text = N_(
                "The smallest planet gear in place of the largest saves %(saving)s, %(share)s %% of its mass."
            )
            yield self.t(
                text, saving=self.further.mass_of("saving"), share=self.number("saved_share", digits=3)
            )

    def failed(self) -> list[Markup]:
        return [self.t(CONDITIONS[c.key], wheel=c.wheel) for c in self.found.failed]

    def _all_teeth(self) -> Iterable[Markup]:
        named = [self.s.z1, *(self.made.row(s).z for s in self.found.upper), self.s.z3]
        return (self.page.value(z, digits=9) for z in named)
