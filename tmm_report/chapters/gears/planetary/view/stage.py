"""View of a planetary stage: what its template prints beside the formulas."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import Any

from markupsafe import Markup

from tmm_report.chapters.gears.planetary.draw import front
from tmm_report.chapters.gears.planetary.equations import (
    coaxiality,
    deviation,
    efficiency,
    neighbourhood,
    ring_tip,
)
from tmm_report.chapters.gears.planetary.relation import Relation
from tmm_report.chapters.gears.planetary.solve.stage import Found
from tmm_report.chapters.gears.planetary.view.tables import PlanetaryTables
from tmm_report.figures.drawing import Drawing
from tmm_report.mechanics.gears.planetary.stage import EXTERNAL
from tmm_report.problems import N_
from tmm_report.quantity.definition import Definition, in_letters
from tmm_report.quantity.formula import Formula
from tmm_report.quantity.terms.wheel_words import of_wheel
from tmm_report.report.page import Page
from tmm_report.report.part import Failed, Part

SCHEMES = {
    "sun-ring": N_("single-row stage with an external and an internal mesh"),
    "external-external": N_("two-row stage with two external meshes"),
    "external-internal": N_("two-row stage with an external and an internal mesh"),
    "internal-internal": N_("two-row stage with two internal meshes"),
}


def parts(found: Found, page: Page, label: str) -> Iterator[Part]:
    """Of a stage; `label`: with which its sections, and its names in the results, begin."""
    yield Part("gears/planetary", PlanetaryView(found, page, label))


class PlanetaryView(PlanetaryTables):
    @property
    def title(self) -> str:
        return self.found.name

    @property
    def kind(self) -> Markup:
        return self.t(SCHEMES[self.scheme.name])

    @property
    def ways(self) -> dict[str, str]:
        """Names of the input, of the output and of the member held or driven besides."""
        member = self.given.member
        return {
            "input": self.found.input,
            "output": self.found.output,
            "held": member(self.task.held),
        }

    def given_values(self) -> Markup:
        """Wanted ratio, tolerance, module, satellites, efficiency, as they were given, and what they are."""
        page, listed = self.page, self.page.listed
        counts = [self.number(key) for key in ("k_least", "k_most")]
        many = listed(counts[: len(self.task.satellites)], "…")
        allowed = ["|", page.sym(self.value("tolerance").symbol), "| ≤ ", page.in_unit(self.tolerance, "%")]
        return listed(
            [
                self.told_of(["u_wanted"]),
                self.by_noun("tolerance", listed(allowed, "")),
                self.told_of(self._stated()),
                self.by_noun("k", listed([page.sym("k"), " = ", many], "")),
                self.t("efficiency with the carrier stopped %(eta)s", eta=self.sized("eta_stopped")),
            ],
            "; ",
        )

    def _stated(self) -> list[str]:
        """Modules; of helical teeth those of the normal section, and the helix angle."""
        keys = ["m"] if self.given.one_module else ["m_I", "m_II"]
        return [*(f"{key}_n" for key in keys), "beta"] if self.given.helix else keys

    @property
    def tolerance(self) -> Markup:
        return self.number("tolerance", digits=3)

    def meant(self) -> list[dict[str, Any]]:
        """What the given values are."""
        names = {"u_wanted": "planetary:u", "delta_u": "planetary:Delta"}
        names |= {"k": "planetary:k", "eta_stopped": "planetary:eta" + self.carrier}
        said = {key: self.page.explained(name, self.value(key)) for key, name in names.items()}
        one = "m" if self.given.one_module else "m_I"
        module = self.page.explained("spur:m", self.value(one), "mm")
        modules = [{**module, "symbol": "m"}]
        if self.given.helix:
            normal = self.page.explained("planetary:mn", self.value(f"{one}_n"), "mm")
            modules = [{**normal, "symbol": "m_n"}, self.page.explained("spur:beta", self.value("beta"))]
        return [*(said[key] for key in ("u_wanted", "delta_u")), *modules,
                *(said[key] for key in ("k", "eta_stopped"))]  # fmt: skip

    def explained_shift(self) -> list[dict[str, Any]]:
        """What the formulas of profile shift are made of."""
        row, table = self.found.opened[0] if self.found.opened else 0, self.table("rows")
        outside = self.scheme.rows[row] == EXTERNAL
        total = (
            self.t("sum of the profile shift coefficients of the wheels")
            if outside
            else self.t("difference of the profile shift coefficients of the ring and the planet gear")
        )
        return [
            self.page.explained("planetary:a", table["a"], "mm"),
            self.page.explained("planetary:alpha_w", table["alpha_w"]),
            {
                "id": f"planetary:x{self.scheme.rows[row]}",
                "symbol": table["x_sum"].symbol(row),
                "meaning": total,
                "unit": "",
            },
        ]

    # ------------------------------------------------------------ formulas

    def deviation(self) -> Formula:
        return self.value("delta_u").formula(deviation(self.stage), digits=3)

    def efficiency(self) -> Formula:
        row = self.found.motions.index(self.found.motion)
        return self.table("motions").formula("eta", row, efficiency(self.stage))

    def transverse(self) -> list[Formula]:
        """Of helical teeth: modules, profile angle and addendum in the transverse section."""
        keys = ("m", "m_I", "m_II", "alpha", "ha")
        return [self.formula(key, digits=6) for key in keys if self.s.has_formula(key)]

    def opened(self) -> list[Formula]:
        """The operating angle and the sum of shift coefficients of the opened rows; where the coefficients are stated
        their sum is not found."""
        rows, keys = [self.meshes[row] for row in self.found.opened], ("a", "alpha_w", "x_sum")
        return [mesh.formula(key) for mesh in rows for key in keys if mesh.has_formula(key)]

    def working(self) -> Definition:
        """Working diameters of wheels without shift, of which the table has the numbers."""
        row, wheel = self.stage.rows[0], self.wheels[self.scheme.wheels[0]]
        called = {
            of_wheel(sign, wheel): of_wheel(sign, "i")
            for key in ("d_w", "z")
            if (sign := row.declared(key).symbol)
        }
        return in_letters(row.formula("d_w"), called)

    def coaxiality(self) -> Relation:
        return coaxiality(self.stage)

    def ring_tip(self, row: int) -> Relation:
        return ring_tip(self.stage, row)

    def neighbourhood(self) -> Relation:
        return neighbourhood(self.stage)

    # ------------------------------------------------------------ picture

    @cached_property
    def front(self) -> Drawing:
        return front(self.found, self.page.plain(self.t("Planetary stage %(name)s", name=self.title)))

    @property
    def scale(self) -> Markup:
        return self.sized("mu_l")

    # ------------------------------------------------------------ what is said

    def chosen_teeth(self) -> Markup:
        """z1 = 20, z2 = 46, z3 = 112, k = 3."""
        return self.page.values([*(row.z for row in self.stage.rows), self.s.k])

    def conclusions(self) -> list[Markup]:
        text = N_(
            "The planetary stage %(name)s has %(teeth)s; its ratio %(ratio)s deviates from the required one by "
            "%(deviation)s %%."
        )
        if self.page.nothing(self.value("delta_u")):
            text = N_("The planetary stage %(name)s has %(teeth)s; its ratio is %(ratio)s, as required.")
        named = {"name": self.title, "teeth": self.chosen_teeth(), "ratio": self.sized("u")}
        lines = [self.t(text, **named, deviation=self.number("delta_u", digits=3))]
        lines += [self.t("Its efficiency is %(eta)s; the gap between its neighbouring planet gears is %(gap)s mm.",
                         eta=self.number("eta"),
                         gap=self.number("gap", digits=4))]  # fmt: skip
        lines += [self.schemes.said()] if self.schemes else []
        locks = self.t("Stage %(name)s is self-locking: it cannot be driven from its input.", name=self.title)
        return [*([Failed(locks)] if self.found.motion.locks else []), self.page.listed(lines, " ")]
