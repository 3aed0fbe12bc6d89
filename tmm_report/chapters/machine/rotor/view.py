"""View of masses on a turning shaft balanced."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import cached_property
from typing import Any

import numpy as np
from markupsafe import Markup

from tmm_report.chapters.machine.rotor import quantities as q
from tmm_report.chapters.machine.rotor.draw import Sheet, polygon_picture, scheme
from tmm_report.chapters.machine.rotor.equations import ROWS
from tmm_report.chapters.machine.rotor.solve import Found
from tmm_report.chapters.machine.rotor.words import KINDS, LIMITED, SHARED
from tmm_report.figures.drawing import Drawing
from tmm_report.problems import N_
from tmm_report.quantity.formula import Formula
from tmm_report.quantity.written import Equation
from tmm_report.report.chapter_view import ChapterView
from tmm_report.report.comparison import comparison_table
from tmm_report.report.diagrams import scale_of
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Column, Table, numeric
from tmm_report.report.part import Part

HEADS = {"masses": N_("Mass"), "corrections": N_("Plane"), "bearings": N_("Bearing")}


def parts(found: Found, page: Page) -> Iterator[Part]:
    yield Part("machine/rotor", RotorView(found, page))


def picture(found: Found, page: Page) -> Drawing:
    """The shaft at a glance, for a list of many."""
    return scheme(found, page.num)


class RotorView(ChapterView):
    def __init__(self, found: Found, page: Page):
        super().__init__(page, found.s, q.tables(found))
        self.found = found

    def where(self, *formulas: Formula | Equation) -> list[dict[str, Any]]:
        """A quantity of many masses is explained for the first of them."""
        return _by_meaning(super().where(*formulas))

    def explained(self, *keys: str) -> list[dict[str, Any]]:
        return _by_meaning(super().explained(*keys))

    def heads(self, name: str, *keys: str) -> list[dict[str, Any]]:
        """What a "where" list says of columns of a table."""
        columns = [self.of(name, key) for key in keys]
        return _by_meaning(self.page.explained("", one, one.unit) for one in columns)

    def rows(self, of: str) -> list[Formula]:
        """Formulas of rows of the tables."""
        return list(ROWS[of](self.found))

    # --- words

    @property
    def skewed(self) -> list[int]:
        return [k for k, one in enumerate(self.found.given.heavy) if one.couple]

    @property
    def turns(self) -> bool:
        """Whether any unbalance has a moment about plane I."""
        return bool(np.max(np.abs(self.found.moments)) > 1e-9 * self.found.size * self.found.length)

    def products_of_inertia(self) -> Markup | None:
        """Of the bodies set askew; None where there are none."""
        if not self.skewed:
            return None
        table = self.table("masses")
        return self.page.values(table.var(key, k) for k in self.skewed for key in ("J_xz", "J_yz"))

    def kind(self) -> Markup:
        return self.t(KINDS[self.found.kind])

    # ------------------------------------------------------------ which balance suffices

    def suffices(self) -> Markup | None:
        """What the textbook's rule says; None where width, diameter or speed are not stated."""
        found = self.found
        if "ratio" not in self.s or not found.given.speed:
            return None
        if found.kind in ("none", "couple"):  # nothing that a single weight could balance
            return None
        ratio, limit = self.sized("ratio"), self.sized("one_plane")
        if found.given.speed <= self.s.number("one_plane"):
            text = N_(
                "By the rule for rigid rotors (IRD) balance in one plane suffices for %(ratio)s up to %(limit)s: this "
                "rotor turns more slowly, as slow shafts, pulleys and flywheels do, and static balance is enough."
            )
        else:
            text = N_(
                "By the rule for rigid rotors (IRD) balance in one plane suffices for %(ratio)s only up to %(limit)s: "
                "this rotor turns faster, and dynamic balance in two planes is needed."
            )
        return self.t(text, ratio=ratio, limit=limit)

    def staying(self) -> Markup | None:
        """What one correction plane leaves; None where it leaves nothing, or there are two."""
        text = N_("In one correction plane the force is balanced, the moment %(moment)s about it stays.")
        return self.t(text, moment=self.sized("M")) if self.found.couple_stays else None

    # ------------------------------------------------------------ tables

    def given_table(self) -> Table:
        return self._named("masses", N_("Unbalances of the rotor"), ("m", "r", "D", "alpha", "z"))

    def products(self) -> Table:
        keys = ("D", "l", "M", "D_mm", "M_mm") if self.found.two else ("D", "D_mm")
        return self._named("masses", N_("Vectors of the polygons"), keys)

    def weights_table(self) -> Table:
        return self._named("corrections", N_("Balancing weights"), ("z", "D", "alpha", "m", "r", "beta"))

    def made_table(self) -> Table:
        caption = N_("Balancing weights as they are made")
        return self._named("corrections", caption, ("m_made", "r_made", "beta_made"))

    def bearings_table(self) -> Table:
        caption = N_("Unbalance and forces in the bearings")
        return self._named("bearings", caption, ("z", *self.bearing_keys))

    def _named(self, name: str, caption: str, keys: Iterable[str]) -> Table:
        """A table whose first column names the rows."""
        table, head = self.table(name), HEADS[name]
        names = [
            self.page.word(text, table, table.columns[0].key, row)
            for row, text in enumerate(table.columns[0].values)
        ]
        return numeric(self.t(caption), Column(self.t(head), names), self.columns(name, keys))

    @property
    def bearing_keys(self) -> list[str]:
        keys = ("D_before", "psi", "R_before", "D_made", "R_made", "D_per")
        return [key for key in keys if key in self.table("bearings")]

    def comparison(self) -> Table:
        named = {quantity.key: quantity for quantity, *_ in q.compared(self.found)}
        caption = self.t("Products of the weights by the polygons and by calculation")
        return comparison_table(self.page, caption, self.table("comparison"), named, None)  # type: ignore[arg-type]

    # ------------------------------------------------------------ what is left

    def in_limits(self) -> Markup | None:
        """Whether both bearings feel no more than is permitted, and why not; None where nothing is stated of it."""
        found, permitted = self.found, self.found.permitted
        if permitted is None:
            return None
        exact, made = (np.all(np.abs(felt) <= permitted * (1 + 1e-9)) for felt in (found.after, found.made))
        which = "made" if made else "exact" if exact else "none"
        return self.t(LIMITED[which])

    def shared(self) -> Markup:
        """How the permissible unbalance is shared by the bearings."""
        where = "overhung" if self.found.overhung else "between"
        return self.t(SHARED[where])

    # ------------------------------------------------------------ pictures

    @cached_property
    def drawing(self) -> Drawing:
        return scheme(self.found, self.page.num, str(self.t("Scheme of the rotor")))

    def scales(self) -> Markup:
        """Of the scheme: along the shaft and of the radii."""
        sheet = Sheet(self.found)
        return self.page.values(
            [scale_of("mu_l", sheet.along, "m/mm"), scale_of("mu_r", sheet.across, "m/mm")]
        )

    @cached_property
    def forces_drawn(self) -> Drawing:
        return polygon_picture(self.found.force, "D", str(self.t("Polygon of the unbalances")))

    @cached_property
    def moments_drawn(self) -> Drawing | None:
        couple = self.found.couple
        return polygon_picture(couple, "M", str(self.t("Polygon of the moments"))) if couple else None

    # ------------------------------------------------------------ conclusions

    def conclusions(self) -> list[Markup]:
        text = N_(
            "The rotor with the unbalance %(before)s kg·m is balanced in plane I by the weight %(first)s at the "
            "distance %(radius)s."
        )
        both = N_(
            "The rotor with the unbalance %(before)s kg·m is balanced by the weights %(first)s at the distance "
            "%(radius)s in plane I and %(second)s at the distance %(other)s in plane II."
        )
        found, stays = self.found, self.staying()
        weight = {"before": self.number("D"), "first": self._of("m", 0), "radius": self._of("r", 0)}
        if found.kind == "none":
            return [self.kind()]
        if found.two:
            return [self.t(both, **weight, second=self._of("m", 1), other=self._of("r", 1))]
        if stays:
            text = N_(
                "The unbalance %(before)s kg·m of the rotor is balanced in plane I by the weight %(first)s at the "
                "distance %(radius)s."
            )
            return [self.t(text, **weight), stays] if found.corrections[0].product else [self.kind(), stays]
        return [self.t(text, **weight)]

    def _of(self, key: str, row: int) -> Markup:
        return self.page.value(self.table("corrections").var(key, row))


def _by_meaning(items: Iterable[dict[str, Any]]) -> list[dict[str, Any]]:
    return [item | {"id": f"rotor:{item['message']}"} for item in items]
