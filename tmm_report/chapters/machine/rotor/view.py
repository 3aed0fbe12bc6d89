"""View of masses on a turning shaft balanced."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import Any

import numpy as np
from markupsafe import Markup

from tmm_report.chapters.machine.rotor import quantities as q
from tmm_report.chapters.machine.rotor.draw import Sheet, polygon_picture, scheme
from tmm_report.chapters.machine.rotor.formulas import RotorFormulas
from tmm_report.chapters.machine.rotor.solve import Found
from tmm_report.chapters.machine.rotor.words import KINDS, LIMITED, SHARED
from tmm_report.figures.drawing import Drawing
from tmm_report.problems import N_
from tmm_report.quantity import model
from tmm_report.quantity.formula import Formula
from tmm_report.report.comparison import comparison_table
from tmm_report.report.diagrams import scale_of
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Column, Table, numeric
from tmm_report.report.part import Part


def parts(found: Found, page: Page) -> Iterator[Part]:
    yield Part("machine/rotor", RotorView(found, page))


def picture(found: Found, page: Page) -> Drawing:
    """The shaft at a glance, for a list of many."""
    return scheme(found, page.num)


class RotorView(RotorFormulas):
    def __init__(self, found: Found, page: Page):
        super().__init__(found)
        self.page, self.t = page, page.t

    @property
    def name(self) -> str:
        return self.found.given.name

    def number(self, key: str, unit: str = "", **form: Any) -> Markup:
        return self.page.shown(self.book[f"rotor_{key}"], unit=unit, **form)

    def stated(self, key: str, unit: str = "") -> Markup:
        """symbol = value unit."""
        return self.page.value(self.book[f"rotor_{key}"].var(unit))

    def where(self, formula: Formula) -> list[dict[str, Any]]:
        """A quantity of many masses is explained for the first of them."""
        items = self.page.where(formula)
        return [item | {"id": f"rotor:{item['meaning']}"} for item in items]

    def explained(self, of: model.Table | None, *keys: str) -> list[dict[str, Any]]:
        """Items of a "where" list: columns of a table, or single values, by the ids of `where`."""
        found = [of[key] if of is not None else self.book[f"rotor_{key}"] for key in keys]
        items = [self.page.explained("", one, one.unit) for one in found]
        return [item | {"id": f"rotor:{item['meaning']}"} for item in items]

    def products_of_inertia(self) -> Markup | None:
        """Of the bodies set askew; None where there are none."""
        rows = [k for k, one in enumerate(self.found.given.heavy) if one.couple]
        if not rows:
            return None
        return self.page.values(self.masses.var(key, k) for k in rows for key in ("J_xz", "J_yz"))

    def kind(self) -> Markup:
        return self.t(KINDS[self.found.kind])

    # ------------------------------------------------------------ which balance suffices

    def suffices(self) -> Markup | None:
        """What the textbook's rule says; None where width, diameter or speed are not stated."""
        found = self.found
        if found.ratio is None or found.one_plane is None or not found.given.speed:
            return None
        if found.kind in ("none", "couple"):  # nothing that a single weight could balance
            return None
        ratio, limit = self.stated("ratio"), self.stated("one_plane")
        if found.given.speed <= found.one_plane:
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
        """What one plane of correction leaves; None where it leaves nothing, or there are two."""
        text = N_("In one plane of correction the force is balanced, the moment %(moment)s about it stays.")
        return self.t(text, moment=self.stated("M")) if self.found.couple_stays else None

    # ------------------------------------------------------------ tables

    def given_table(self) -> Table:
        table = self.masses
        keys = ["m", "r", "D", "alpha", "z"]
        return numeric(
            self.t("Unbalances of the rotor"), self._names(table), [self._column(table, key) for key in keys]
        )

    def products(self) -> Table:
        table = self.masses
        keys = ["D", "l", "M", "D_mm", "M_mm"] if self.found.two else ["D", "D_mm"]
        columns = [self._column(table, key) for key in keys]
        return numeric(self.t("Vectors of the polygons"), self._names(table), columns)

    def _names(self, table: model.Table, key: str = "name", head: str = N_("Mass")) -> Column:
        names = [self.page.word(text, table, key, row) for row, text in enumerate(table[key].values)]
        title = self.t(head)
        return Column(title, names)

    def _column(self, table: model.Table, key: str) -> Column:
        return self.page.column(table, key)

    def weights_table(self) -> Table:
        columns = [self._column(self.weights, key) for key in ("z", "D", "alpha", "m", "r", "beta")]
        return numeric(self.t("Balancing weights"), self._names(self.weights, "plane", N_("Plane")), columns)

    def made_table(self) -> Table:
        columns = [self._column(self.weights, key) for key in ("m_made", "r_made", "beta_made")]
        caption = self.t("Balancing weights as they are made")
        return numeric(caption, self._names(self.weights, "plane", N_("Plane")), columns)

    def bearings_table(self) -> Table:
        table = self.book.tables["rotor_bearings"]
        columns = [self._column(table, key) for key in ("z", *self.bearing_keys)]
        caption = self.t("Unbalance and forces in the bearings")
        return numeric(caption, self._names(table, "bearing", N_("Bearing")), columns)

    @property
    def bearing_keys(self) -> list[str]:
        table = self.book.tables["rotor_bearings"]
        keys = ("D_before", "psi", "R_before", "D_made", "R_made", "D_per")
        return [key for key in keys if key in table]

    def comparison(self) -> Table:
        table = self.book.tables["rotor_comparison"]
        named = {quantity.key: quantity for quantity, *_ in q.compared(self.found)}
        caption = self.t("Products of the weights by the polygons and by calculation")
        return comparison_table(self.page, caption, table, named, None)  # type: ignore[arg-type]

    # ------------------------------------------------------------ what is left

    @property
    def rounded(self) -> bool:
        return self.found.given.steps is not None

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
        return self.page.value(self.weights.var(key, row))
