"""View of a spur stage: what its template prints beside the formulas."""

from __future__ import annotations

from functools import cached_property
from typing import Any

import numpy as np
from markupsafe import Markup

from tmm_report.chapters.spur.formulas import SpurFormulas
from tmm_report.chapters.spur.solve import Condition, Found
from tmm_report.chapters.spur.teeth_view import TeethView
from tmm_report.chapters.spur.wheel_words import DIAMETERS, TEETH
from tmm_report.figures.graphs import Curve, Graph, graph
from tmm_report.mechanics import shifts
from tmm_report.problems import N_
from tmm_report.quantity.formula import Var
from tmm_report.quantity.symbols import Symbol
from tmm_report.report.layout import Table, worded
from tmm_report.report.page import Page

CONDITIONS = {
    "undercut": N_("no undercut of the teeth of wheel %(wheel)s"),
    "pointing": N_("no pointing of the teeth of wheel %(wheel)s"),
    "contact": N_("smoothness of the engagement"),
    "interference": N_("no interference at the root of wheel %(wheel)s"),
    "fouling": N_("no overlap of the tips of the ring and the pinion"),
    "sliding": N_("specific sliding at the root of wheel %(wheel)s"),
}
HEIGHT = {"height": "h"}  # symbols that are not the names of the pair's attributes
RULES = {
    "rule": N_(
        "The shift of the smaller wheel is taken by the rule of the course, which excludes undercut approximately:"
    ),
    "limit": N_("The shift of the smaller wheel is the least without undercut by the exact formula:"),
    "equal sliding": N_(
        "The sum of the shifts is divided so that the specific sliding at the roots of both wheels is equal."
    ),
}


class SpurView(SpurFormulas):
    def __init__(self, found: Found, page: Page, label: str):
        super().__init__(found)
        self.page, self.label = page, label
        self.t, self.num = page.t, page.num

    @property
    def title(self) -> str:
        return self.found.name

    @property
    def rule(self) -> str:
        """How the shifts were divided (a message id); "" where they were given."""
        shift = self.found.given.shift
        return RULES[shift] if isinstance(shift, str) else ""

    def given_values(self) -> Markup:
        """What the assignment gives, in one line."""
        given = self.found.given
        distance = [self.a_w] if given.centre_distance is not None else []
        helix = [self.beta] if self.helical else []
        ratio = Var(Symbol("u", "".join(self.names)), given.ratio)
        items = [ratio, self.m, *distance, self.alpha, *helix, self.ha, self.c]
        values = [self.page.value(var.sign, float(var.number), var.unit) for var in items]
        return self.page.listed([self.page.listed(values), "."], "")

    def both_shifts(self) -> Markup:
        return self.page.listed(
            [self.page.value(var.sign, float(var.number)) for var in (self.x(0), self.x(1))]
        )

    def one_shift(self, i: int) -> Markup:
        return self.page.value(self.x(i).sign, float(self.x(i).number))

    def mm_text(self, metres: Any, digits: int = 5) -> str:
        return self.num(1e3 * float(metres), digits)

    # ------------------------------------------------------------ tables

    def shifts_table(self, caption: Any) -> Table:
        """The least shifts by the course's rule and exactly, beside those taken."""
        rows = []
        for i, name in enumerate(self.names):
            ring = self._ring(i)
            rows.append(
                [
                    name,
                    str(self.found.teeth.z[i]),
                    "—" if ring else self._shift(self.found.rule_shifts[i]),
                    "—" if ring else self._shift(float(self.pair.x_min[i])),
                    self._shift(float(self.x(i).number)),
                ]
            )
        heads = [
            self.t("Wheel"),
            self.page.sym("z"),
            self.t("least shift by the rule"),
            self.t("exact least shift"),
            self.t("shift taken"),
        ]
        return worded(caption, heads, rows, (1, 1, 2, 2, 2))

    def _shift(self, x: float) -> str:
        return self.num(x, places=4)

    def dimensions_table(self, caption: Any) -> Table:
        """Dimensions of both wheels."""
        cells = [
            [self.t(text), self.page.listed([self.page.sym(HEIGHT.get(key, key)), self.page.unit("mm")])]
            + [self.mm_text(value) for value in getattr(self.pair, key)]
            for key, text in (DIAMETERS | TEETH).items()
        ]
        heads = [self.t("Dimension"), self.t("Symbol"), *self._wheels()]
        return worded(caption, heads, cells, (4, 2, 2, 2))

    def _wheels(self) -> list[Markup]:
        return [self.t("wheel %(name)s", name=name) for name in self.names]

    def conditions(self, caption: Any) -> Table:
        """Every condition with its value, limit and what is in hand."""
        rows = [
            [
                self.t(CONDITIONS[c.key], wheel=c.wheel),
                self._quantity(c),
                self._measure(c.value, c),
                self.page.listed(["≥ " if c.least else "≤ ", self._measure(c.limit, c)], ""),
                self._measure(c.margin, c),
                self._verdict(c),
            ]
            for c in self.found.conditions
        ]
        t = self.t
        heads = [t("Condition"), t("Quantity"), t("Value"), t("Limit"), t("In hand"), t("Verdict")]
        return worded(caption, heads, rows, (4, 2, 2, 3, 2, 2.4))

    def _verdict(self, c: Condition) -> Markup:
        if c.met:
            return self.t("met")
        return self.t("met by the rule only") if self._by_rule(c) else self.t("not met")

    def _by_rule(self, c: Condition) -> bool:
        """Whether a wheel that is undercut, exactly, is not by the rule of the course."""
        return c.key == "undercut" and c.value >= self.found.rule_shifts[self.names.index(c.wheel)] - 1e-9

    def _quantity(self, c: Condition) -> Markup:
        symbols = {
            "undercut": Symbol("x", c.wheel),
            "pointing": Symbol("s", ("na" if self.helical else "a") + c.wheel),
            "contact": Symbol("epsilon", "alpha"),
            "interference": Symbol("rho", "p" + c.wheel),
            "fouling": Symbol("Delta", "phi"),
            "sliding": Symbol("lambda", "p" + c.wheel),
        }
        name = self.page.sym(symbols[c.key])
        if c.key == "sliding":
            name = self.page.listed(["|", name, "|"], "")
        return self.page.listed([name, self.page.unit(c.unit)]) if c.unit else name

    def _measure(self, value: float, c: Condition) -> str:
        """A number in the unit of the condition: mm, degrees or none."""
        factor = {"mm": 1e3, "deg": 180 / np.pi, "": 1.0}[c.unit]
        return self.num(factor * value, places=4 if not c.unit else 3)

    def sliding_table(self, caption: Any) -> Table:
        """Specific sliding at the characteristic points of the line of action."""
        rows = []
        for point, rho in self.found.points.items():
            at = self.pair.sliding(rho)
            second = float(self.pair.line) - rho if not self.internal else self._mate(rho)
            rows.append(
                [
                    point,
                    self.mm_text(rho),
                    self.mm_text(second),
                    self.num(float(at.first), scale=1.0),
                    self.num(float(at.second), scale=1.0),
                ]
            )
        heads = [
            self.t("Point"),
            *(self._headed("rho", name, "mm") for name in self.names),
            *(self._headed("lambda", name) for name in self.names),
        ]
        return worded(caption, heads, rows, (2, 3, 3, 3, 3))

    def _mate(self, rho: float) -> float:
        """The other radius of curvature of an internal pair."""
        line = float(self.pair.line)
        return rho + line if self.small == 0 else rho - line

    def _headed(self, base: str, sub: str, unit: str = "") -> Markup:
        symbol = self.page.sym(Symbol(base, sub))
        return self.page.listed([symbol, self.page.unit(unit)]) if unit else symbol

    # ------------------------------------------------------------ picture

    @cached_property
    def drawings(self) -> TeethView:
        return TeethView(self.found, self.page, self.label)

    @cached_property
    def sliding_graph(self) -> Graph:
        """Specific sliding of both wheels over the active part of the line of action, from the driving wheel's N1."""
        at = self.found.sliding()
        order = np.argsort(at.rho)
        x, ends = 1e3 * at.rho[order], (0, -1)
        curves = [
            Curve(y[order], f"λ{name}", extremes=[(float(x[k]), float(y[order][k])) for k in ends])
            for y, name in zip((at.first, at.second), self.names, strict=True)
        ]
        label, step = f"ρ{self.names[0]}, {self.page.unit('mm')}", _step(float(x[-1] - x[0]))
        return graph(curves, x, label, ["λ"], step=step, comma=self.page.tr.decimal == ",", join=False)

    # ------------------------------------------------------------ what is said

    def undercuts(self) -> list[Markup]:
        """What is to be said of each undercut wheel."""
        return [
            self._undercut(self.names.index(c.wheel), c) for c in self.found.failed if c.key == "undercut"
        ]

    def _undercut(self, i: int, c: Condition) -> Markup:
        start, lower = self.found.involute_starts[i], float(self.pair.rho_p[i])
        values = {
            "wheel": c.wheel,
            "least": str(int(shifts.rule_teeth(self.pair.rack))),
            "short": self._shift(-c.margin),
            "limit": self._shift(c.limit),
            "start": self.num(1e3 * start, places=3),
            "lower": self.num(1e3 * lower, places=3),
        }
        said = [
            self.t(
                N_("The shift of wheel %(wheel)s satisfies the rule (%(least)s − z)/%(least)s but is"),
                **values,
            )
            if self._by_rule(c)
            else self.t(N_("The shift of wheel %(wheel)s is"), **values),
            self.t(
                N_(
                    "%(short)s less than the exact limit %(limit)s, so the tooth is undercut: its involute begins at "
                    "the radius of curvature %(start)s mm, its active profile at %(lower)s mm;"
                ),
                **values,
            ),
            self.t("the undercut does not reach the active profile.")
            if start <= lower
            else self.t("the undercut takes away a part of the active profile."),
        ]
        return self.page.listed(said, " ")

    def failures(self) -> list[Markup]:
        """Conditions that are not met, each with how much is wanting."""
        return [
            self.page.listed([self.t(CONDITIONS[c.key], wheel=c.wheel), self._lack(c)], ": ")
            for c in self.found.failed
        ]

    def _lack(self, c: Condition) -> Markup:
        if not np.isfinite(c.margin):
            return self.t("it has no bound") if c.key == "sliding" else self.t("they cannot pass each other")
        unit = [" ", self.page.unit(c.unit)] if c.unit else []
        return self.t("%(lack)s is wanting", lack=self.page.listed([self._measure(-c.margin, c), *unit], ""))

    def conclusions(self) -> list[Markup]:
        values = {
            "name": self.title,
            "z1": self.found.teeth.z[0],
            "z2": self.found.teeth.z[1],
            "x1": self._shift(float(self.pair.x1)),
            "x2": self._shift(float(self.pair.x2)),
            "eps": self.num(float(self.pair.eps), 4),
        }
        said = [
            self.t(
                N_(
                    "The gear pair %(name)s has %(z1)s and %(z2)s teeth, the shifts %(x1)s and %(x2)s and the contact "
                    "ratio %(eps)s."
                ),
                **values,
            )
        ]
        if self.found.failed:
            said.append(
                self.t(
                    "Not all its conditions are met: %(list)s.", list=self.page.listed(self.failures(), "; ")
                )
            )
        else:
            said.append(self.t("All its conditions are met."))
        return [self.page.listed(said, " ")]


def _step(length: float) -> float:
    """A round step of about eight ticks."""
    power = 10 ** np.floor(np.log10(length / 8))
    return float(min(n * power for n in (1, 2, 5, 10) if n * power >= length / 8))
