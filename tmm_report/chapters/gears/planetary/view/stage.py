"""View of a planetary stage: what its template prints beside the formulas."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import Any

from markupsafe import Markup

from tmm_report.chapters.gears.planetary.draw import front
from tmm_report.chapters.gears.planetary.quantities.stage import one_module
from tmm_report.chapters.gears.planetary.solve.stage import Found
from tmm_report.chapters.gears.planetary.view.tables import PlanetaryTables
from tmm_report.figures.drawing import Drawing
from tmm_report.mechanics.gears.planetary.stage import EXTERNAL
from tmm_report.problems import N_
from tmm_report.quantity.formula import Var
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
        """Wanted ratio, tolerance, module, satellites, efficiency, as they were given."""
        page, of, listed = self.page, self.of, self.page.listed
        counts = [page.shown(of[key]) for key in ("k_least", "k_most")]
        many = listed(counts[: len(self.task.satellites)], "…")
        return listed(
            [
                page.value(of["u_wanted"].var()),
                listed([page.sym(of["tolerance"].symbol), " ≤ ", self.tolerance, " %"], ""),
                *(page.value(m) for m in self._stated()),
                listed([page.sym("k"), " = ", many], ""),
                page.value(of["eta_stopped"].var()),
            ]
        )

    def _stated(self) -> list[Var]:
        """Modules; of helical teeth those of the normal section, and the helix angle."""
        keys = ["m"] if one_module(self.given) else ["m_I", "m_II"]
        if self.given.helix:
            return [*(self.of[f"{key}_n"].var("mm") for key in keys), self.of["beta"].var()]
        return [self.m(row) for row in range(len(keys))]

    @property
    def tolerance(self) -> Markup:
        return self.page.shown(self.of["tolerance"], digits=3)

    def explained(self) -> list[dict[str, Any]]:
        """What the given values are."""
        names = {"u_wanted": "planetary:u", "tolerance": "planetary:Delta"}
        names |= {"k": "planetary:k", "eta_stopped": "planetary:eta" + self.carrier}
        said = {key: self.page.explained(name, self.of[key]) for key, name in names.items()}
        module = self.page.explained("spur:m", self.of["m" if one_module(self.given) else "m_I"], "mm")
        modules = [{**module, "symbol": "m"}]
        if self.given.helix:
            normal = self.page.explained(
                "planetary:mn", self.of["m_n" if one_module(self.given) else "m_I_n"], "mm"
            )
            modules = [{**normal, "symbol": "m_n"}, self.page.explained("spur:beta", self.of["beta"])]
        return [*(said[key] for key in ("u_wanted", "tolerance")), *modules,
                *(said[key] for key in ("k", "eta_stopped"))]  # fmt: skip

    def explained_shift(self) -> list[dict[str, Any]]:
        """What the formulas of profile shift are made of."""
        row, table = self.opened, self.rows
        outside = self.scheme.rows[row] == EXTERNAL
        total = (
            self.t("sum of the shift coefficients of the wheels")
            if outside
            else self.t("difference of the shift coefficients of the ring and the satellite")
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

    # ------------------------------------------------------------ picture

    @cached_property
    def front(self) -> Drawing:
        return front(self.found, self.page.plain(self.t("Planetary stage %(name)s", name=self.title)))

    @property
    def scale(self) -> Markup:
        return self.page.value(self.of["mu_l"].var())

    # ------------------------------------------------------------ what is said

    def chosen_teeth(self) -> Markup:
        """z1 = 20, z2 = 46, z3 = 112, k = 3."""
        chosen = [*(self.z(wheel) for wheel in self.scheme.wheels), self.k]
        return self.page.listed(self.page.value(of) for of in chosen)

    def conclusions(self) -> list[Markup]:
        text = N_(
            "The planetary stage %(name)s has %(teeth)s; the deviation of its ratio is %(deviation)s %%."
        )
        deviation = self.page.shown(self.of["delta_u"], digits=3)
        lines = [self.t(text, name=self.title, teeth=self.chosen_teeth(), deviation=deviation)]
        lines += [self.t("Its efficiency is %(eta)s, its neighbouring satellites are %(gap)s mm apart.",
                         eta=self.page.shown(self.of["eta"], digits=4),
                         gap=self.page.shown(self.of["gap"], unit="mm", digits=4))]  # fmt: skip
        lines += [self.schemes.said()] if self.schemes else []
        locks = self.t("Stage %(name)s locks itself: it cannot be driven from its input.", name=self.title)
        return [*([Failed(locks)] if self.found.motion.locks else []), self.page.listed(lines, " ")]
