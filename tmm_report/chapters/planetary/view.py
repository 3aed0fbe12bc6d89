"""View of a planetary stage: what its template prints beside the formulas."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property
from typing import Any

import numpy as np
from markupsafe import Markup

from tmm_report.chapters.planetary.formulas import PlanetaryFormulas
from tmm_report.chapters.planetary.limits import REASONS
from tmm_report.chapters.planetary.solve import Found, Motion
from tmm_report.figures.drawing import Drawing
from tmm_report.figures.planetary import front, scale
from tmm_report.i18n import NP_
from tmm_report.mechanics import planetary as p
from tmm_report.mechanics.planetary_search import LEAST_CONTACT, multiples
from tmm_report.problems import N_
from tmm_report.quantity.gear_terms import HA
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.wheel_words import DIAMETERS
from tmm_report.report.layout import Table, worded
from tmm_report.report.page import Page

SHOWN = 10  # solutions in the table, besides the chosen one

SCHEMES = {
    "sun-ring": N_("single-row stage with an external and an internal mesh"),
    "external-external": N_("two-row stage with two external meshes"),
    "external-internal": N_("two-row stage with an external and an internal mesh"),
    "internal-internal": N_("two-row stage with two internal meshes"),
}
INPUT = Symbol("omega", NP_("index", "in"))


class PlanetaryView(PlanetaryFormulas):
    def __init__(self, found: Found, page: Page, label: str):
        super().__init__(found)
        self.page, self.label = page, label
        self.t, self.num = page.t, page.num

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
        task, value = self.task, self.page.value
        counts = task.satellites
        many = str(counts[0]) if len(counts) == 1 else f"{counts[0]}…{counts[-1]}"
        modules = [self.m(0)] if self.one_module else [self.m(0), self.m(1)]
        return self.page.listed(
            [
                value("u", task.ratio),
                self.page.listed(
                    [self.page.sym("Delta_u"), " ≤ ", self.num(100 * task.tolerance, 3), " %"], ""
                ),
                *(value(m.sign, m.number, "mm") for m in modules),
                self.page.listed([self.page.sym("k"), " = ", many], ""),
                value(Symbol("eta", self.carrier), self.given.efficiency),
            ]
        )

    # ------------------------------------------------------------ the search

    def rejected(self, caption: Any) -> Table:
        """How many candidates were rejected, by the first condition that fails."""
        found = self.found.candidates
        counts = [(reason, found.count(reason)) for reason in REASONS]
        rows = [[self.t(REASONS[reason]), str(count)] for reason, count in counts if count]
        rows.append([self.t("in all"), str(len(found.reasons))])
        return worded(caption, [self.t("Reason"), self.t("Combinations")], rows, (4, 1))

    @cached_property
    def places(self) -> list[int]:
        """Places in the ranking that the table of solutions shows: the first, and the chosen one."""
        best = list(range(min(SHOWN, len(self.found.ranking))))
        chosen = self.found.chosen
        return best if chosen is None or chosen in best else [*best, chosen]

    def solutions(self, caption: Any) -> Table:
        """The best of the solutions, the chosen one marked."""
        wheels = self.scheme.wheels
        rows = [self._solution(place, wheels) for place in self.places]
        heads = [
            self.t("No."),
            *(self.page.sym(Symbol("z", self.wheels[wheel])) for wheel in wheels),
            self.page.sym("k"),
            self.page.sym("u"),
            self.page.listed([self.page.sym("Delta_u"), "%"]),
            self.page.listed([self.page.sym("D"), self.page.unit("mm")]),
            self.t("Remark"),
        ]
        return worded(caption, heads, rows, (1, *[1] * len(wheels), 0.8, 1.4, 1.2, 1.4, 3.4))

    def _solution(self, place: int, wheels: Sequence[int]) -> list[Any]:
        found, index = self.found.candidates, self.found.ranking[place]
        z, k = found.teeth[:, index], int(found.satellites[index])
        ratio = float(p.stage_ratio(p.basic_ratio(self.scheme, z), self.task.input, self.task.output))
        size = float(p.sizes(self.scheme, self.task.modules, self.task.rack, z).overall)
        miss = 100 * (ratio / self.task.ratio - 1)
        return [
            str(place + 1),
            *(str(int(z[wheel])) for wheel in wheels),
            str(k),
            self.num(ratio),
            self.num(miss, places=2),
            self.num(1e3 * size),
            self.page.listed(self._remarks(place, z, k)),
        ]

    def _remarks(self, place: int, z: Any, k: int) -> Iterator[Markup]:
        if place == self.found.chosen:
            yield self.t("chosen")
        if p.coaxiality_gap(self.scheme, self.task.modules, z) > 1e-9:
            yield self.t("with shift")
        if multiples(z, k):
            yield self.t("multiple of k")

    # ------------------------------------------------------------ conditions and sizes

    def conditions(self, caption: Any) -> Table:
        """Every condition of the chosen teeth: the value, the limit, what is in hand."""
        rows = [[self.t(text, **names), *cells] for text, names, *cells in self._conditions()]
        heads = [self.t("Condition"), self.t("Value"), self.t("Limit"), self.t("In hand")]
        return worded(caption, heads, rows, (5, 3, 2.4, 2))

    def _conditions(self) -> Iterator[tuple[Any, ...]]:
        task, found = self.task, self.found
        miss, allowed = 100 * abs(found.deviation), 100 * task.tolerance
        yield N_("ratio"), {}, *self._least("Delta_u", miss, allowed, " %", 2, above=False)
        shifts = self.sizes.shifts
        for wheel in self._outside:
            least = float(p.least_teeth(task.rack, shifts[wheel]))
            name = Symbol("z", self.wheels[wheel])
            yield (
                N_("no undercut of the teeth of wheel %(wheel)s"), {"wheel": self.wheels[wheel]},
                *self._least(name, found.teeth[wheel], least, "", 2),
            )  # fmt: skip
        for row, margins in found.interference:
            tips = float(np.degrees(margins.tips))
            names = {"wheel": self.wheels[p.ROWS[row][0]]}
            yield (
                N_("no overlap of the tips in the mesh with ring %(wheel)s"), names,
                *self._least(Symbol("Delta", "φ"), tips, 0.0, "°", 3),
            )  # fmt: skip
        for row in (0, 1):
            ratio = float(p.contact_ratio(self.scheme, self.sizes, found.teeth, row))
            pair = (self.wheels[0], self.wheels[1]) if row == 0 else (self.wheels[2], self.wheels[3])
            yield (
                N_("contact ratio of the pair %(pair)s"), {"pair": "-".join(pair)},
                *self._least(Symbol("epsilon", "alpha"), ratio, LEAST_CONTACT, "", 3),
            )  # fmt: skip
        gap = [self.page.listed([self.num(1e3 * found.gap, places=2), self.page.unit("mm")], " ")] * 2
        yield N_("gap between neighbouring satellites"), {}, gap[0], "> 0", gap[1]

    @property
    def _outside(self) -> list[int]:
        """Wheels with external teeth, the crown of a single row once."""
        wheels = [k for k, kind in enumerate(p.kinds(self.scheme)) if kind == p.EXTERNAL]
        return [k for k in wheels if k != 2 or not self.scheme.single]

    def _least(
        self, symbol: Symbol | str, value: float, limit: float, unit: str, places: int, above: bool = True
    ) -> list[Any]:
        sign, hand = ("≥ ", value - limit) if above else ("≤ ", limit - value)
        shown = self.page.sym(symbol)
        return [
            self.page.listed([shown, " = ", self.num(value, places=places), unit], ""),
            sign + self.num(limit, places=places) + unit,
            self.num(hand, places=places) + unit,
        ]

    def dimensions(self, caption: Any) -> Table:
        """Diameters of all wheels and crowns, mm, and their shift coefficients."""
        wheels = self.scheme.wheels
        rows = [
            [
                self.t(text),
                self.page.listed([self.page.sym(key), self.page.unit("mm")]),
                *(self._diameter(key, wheel) for wheel in wheels),
            ]
            for key, text in DIAMETERS.items()
        ]
        if self.found.shifted:
            cells = [self.num(float(self.sizes.shifts[wheel]), places=4) for wheel in wheels]
            rows.insert(0, [self.t("shift coefficient"), self.page.sym("x"), *cells])
        heads = [
            self.t("Dimension"),
            self.t("Symbol"),
            *(self.t("wheel %(name)s", name=self.wheels[wheel]) for wheel in wheels),
        ]
        return worded(caption, heads, rows, (4, 2, *[2] * len(wheels)))

    def _diameter(self, key: str, wheel: int) -> str:
        """mm; the satellite of a single row with shift rolls on another circle in each mesh."""
        diameters = 1e3 * self.sizes.diameters[key]
        both = key == "d_w" and wheel == 1 and self.scheme.single and self.found.shifted
        return "; ".join(self.num(float(diameters[i])) for i in ((1, 2) if both else (wheel,)))

    # ------------------------------------------------------------ motion

    def motions(self, caption: Any) -> Table:
        """Speeds of all members to the input's, ratio and efficiency, whichever is held; the third is the output."""
        rows = [self._motion(motion) for motion in self.found.motions]
        names = (self.one, self.crowns[0], self.three, self.carrier)
        heads = [
            self.t("Held"),
            self.t("Input"),
            *(self._relative(name) for name in names),
            self.page.sym("u"),
            self.page.sym("eta"),
            self.t("Power flow"),
        ]
        return worded(caption, heads, rows, (0.8, 0.8, 1.4, 1.4, 1.4, 1.4, 1.4, 1.2, 1.2))

    def _relative(self, name: str) -> Markup:
        return self.page.listed([self.page.sym(Symbol("omega", name)), self.page.sym(INPUT)], "/")

    def _motion(self, motion: Motion) -> list[Any]:
        name = self.given.member
        speeds = (motion.speed["wheel1"], motion.satellite, motion.speed["wheel3"], motion.speed["carrier"])
        way = (self.one, self.three) if motion.exponent > 0 else (self.three, self.one)
        return [
            *(name(member) for member in (motion.held, motion.input)),
            *(self.num(speed, 4) for speed in speeds),
            self.num(motion.ratio, 4),
            self.t("locks") if motion.locks else self.num(motion.efficiency, places=4),
            "→".join(way),
        ]

    @property
    def sense(self) -> tuple[str, str]:
        """Which central wheel drives which in the stopped-carrier frame, as the stage runs in the drive."""
        return (self.one, self.three) if self.found.motion.exponent > 0 else (self.three, self.one)

    # ------------------------------------------------------------ picture

    @cached_property
    def front(self) -> Drawing:
        return front(self.found, self.t("Planetary stage %(name)s", name=self.title))

    @property
    def scale(self) -> Markup:
        return self.page.value("mu_l", scale(self.found), "m/mm")

    # ------------------------------------------------------------ what is said

    @property
    def eta_symbol(self) -> Symbol:
        return Symbol("eta", self.carrier)

    @property
    def ha_symbol(self) -> Symbol:
        return HA

    @property
    def rounded_least(self) -> str:
        return str(int(p.least_teeth(self.task.rack, 0.0)))

    def chosen_teeth(self) -> Markup:
        """z1 = 20, z2 = 46, z3 = 112, k = 3."""
        wheels = self.scheme.wheels
        chosen = [self.page.value(self.z(wheel).sign, self.z(wheel).number) for wheel in wheels]
        return self.page.listed([*chosen, self.page.value("k", self.found.satellites)])

    def conclusions(self) -> list[Markup]:
        text = N_(
            "The planetary stage %(name)s has %(teeth)s; the deviation of its ratio is %(deviation)s %%."
        )
        deviation = self.num(100 * self.found.deviation, 3)
        return [self.t(text, name=self.title, teeth=self.chosen_teeth(), deviation=deviation)]
