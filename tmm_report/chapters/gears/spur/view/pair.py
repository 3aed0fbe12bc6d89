"""View of a spur stage: what its template prints beside the formulas."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import cached_property
from typing import Any

import numpy as np
from markupsafe import Markup

from tmm_report.chapters.gears.spur.quantities import tables
from tmm_report.chapters.gears.spur.solve.conditions import BY_ASSEMBLY
from tmm_report.chapters.gears.spur.solve.pair import Found
from tmm_report.chapters.gears.spur.steps import stage
from tmm_report.chapters.gears.spur.values import Wheel
from tmm_report.chapters.gears.spur.view.backlash import BacklashView
from tmm_report.chapters.gears.spur.view.cutter import CutterView
from tmm_report.chapters.gears.spur.view.inspection import InspectionView
from tmm_report.chapters.gears.spur.view.motion import MotionView
from tmm_report.chapters.gears.spur.view.quality import QualityView
from tmm_report.chapters.gears.spur.view.short_contact import reasons
from tmm_report.chapters.gears.spur.view.teeth import TeethView
from tmm_report.chapters.gears.spur.words import (
    CONDITIONS,
    RULES,
    UNDERCUT,
    UNDERCUT_BY_RULE,
    UNDERCUT_DEEP,
    UNDERCUT_HOW,
)
from tmm_report.mechanics.gears.limits.condition import Condition
from tmm_report.problems import N_, Message
from tmm_report.quantity.definition import Definition, in_letters, of_all
from tmm_report.quantity.formula import Formula, Inline
from tmm_report.quantity.model import Column, Value
from tmm_report.quantity.symbols import Symbol, math_symbol
from tmm_report.quantity.terms.wheel_words import DIAMETERS, of_wheel
from tmm_report.report.chapter_view import ChapterView
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import DASH, Cell, Table, padded, worded
from tmm_report.report.part import Failed, Part

SIZES = ("z", "x", "x_min", *DIAMETERS, "height", "s", "alpha_a", "s_b", "s_w", "s_a")
OF_BOTH = (
    "d", "d_b", "d_w", "d_f", "d_a", "s", "alpha_a", "s_b", "s_w", "s_a",
    "rho_a", "rho_m", "rho_p", "root_sliding", "tip_sliding",
)  # fmt: skip
ENDS = ("rho_a", "rho_m", "rho_p", "rho_u", "root_sliding", "tip_sliding")
NOT_OF_RINGS = ("x_min", "s_b")
FURTHER = (  # what few want
    "x_min", "height", "alpha_a", "s_b", "rho_m", "rho_p", "rho_u", "root_sliding", "tip_sliding",
)  # fmt: skip
LEAST, MOST = "≥\N{NO-BREAK SPACE}", "≤\N{NO-BREAK SPACE}"  # before a limit, on one line with it


def parts(found: Found, page: Page, label: str) -> Iterator[Part]:
    """Of a stage; `label`: with which its sections, and its names in the results, begin."""
    yield Part("gears/spur", SpurView(found, page, label))


class SpurView(ChapterView):
    """`label` begins the labels of its sections and its names in the results. Wheels are counted 0 and 1 here."""

    def __init__(self, found: Found, page: Page, label: str):
        self.found, self.pair, self.label, self.stage = found, found.pair, label, stage(found, label)
        self.tables = tables(found, label)
        super().__init__(page, self.stage.s, self.tables)
        self.names, self.small, self.helical = found.given.wheels, found.teeth.small, self.stage.helical
        self.wheels, self.sizes, self.judged = (
            self.stage.wheels,
            self.table("wheels"),
            self.table("conditions"),
        )

    # ------------------------------------------------------------ formulas

    def of_wheel(self, i: int, *keys: str) -> list[Formula]:
        """Those of a wheel that it has."""
        return [self.wheels[i].formula(key) for key in keys if self.wheels[i].has_formula(key)]

    def worked(self) -> list[Formula]:
        """Those of `letters` in numbers: of both wheels, or the first of each kind."""
        return self.of_each_kind(self.of_both(*OF_BOTH))

    def of_both(self, *keys: str) -> list[Formula]:
        return [formula for key in keys for i in (0, 1) for formula in self.of_wheel(i, key)]

    def filled(self) -> Formula:
        """The thicknesses on the working circles together: the pitch, where there is no backlash."""
        one, two = self.wheels
        return self.s["p_w"].formula(one.s_w + two.s_w, "mm")

    def count(self, i: int) -> Inline:
        """The number of teeth of a wheel, in running text."""
        z = self.wheels[i].z
        return Inline(z.sign, float(z.number), ref=z.ref)

    @property
    def title(self) -> str:
        return self.found.name

    @property
    def rule(self) -> str:
        """How the shifts were divided (a message id); "" where they were given."""
        shift = self.found.given.shift
        return RULES[shift] if isinstance(shift, str) else ""

    def given_values(self) -> Markup:
        """What the assignment gives, and what it is."""
        stated = self.found.given.centre_distance is not None
        keys = ["u_required", "m", *(["a_w"] if stated else []), "alpha", "beta", "ha", "c"]
        return self.told_of(keys)

    def both_shifts(self) -> Markup:
        return self.page.listed(self.one_shift(i) for i in (0, 1))

    def one_shift(self, i: int) -> Markup:
        return self.page.value(self.wheels[i].x)

    def stated_tip(self, i: int) -> Markup:
        return self.page.value(self.wheels[i].d_a)

    @property
    def needless(self) -> bool:
        """Whether the smaller wheel needs no shift of its own."""
        return self.wheels[self.small].number("x") == 0

    # ------------------------------------------------------------ what symbols mean

    def meant(self, *keys: str) -> list[dict[str, Any]]:
        """Single numbers of the pair for a list of symbols."""
        return [self._meant(key, self.value(key)) for key in keys]

    def meant_of_wheels(self, *keys: str) -> list[dict[str, Any]]:
        """The same of numbers of each wheel: d_i."""
        return [self.explained_of_wheels(self.sizes[key]) for key in keys]

    def explained_of_wheels(self, column: Column) -> dict[str, Any]:
        """A column of the wheels for a list of symbols."""
        return {
            **self._meant(column.key, column),
            "symbol": of_wheel(column.quantity.symbol or math_symbol(column.key), "i"),
        }

    def _meant(self, key: str, of: Value | Column) -> dict[str, Any]:
        return self.page.explained(f"spur:{key}", of, of.quantity.shown)  # angles carry their sign, °

    # ------------------------------------------------------------ tables

    def _shift(self, key: str, i: int) -> Cell:
        return self.page.cell(self.sizes, key, i, places=4)

    def wheels_table(self, caption: Any) -> Table:
        """Numbers of both wheels; each row is a column of the results."""
        whole = self.page.note.stand("spur.further") == "body"
        return self._of_wheels(caption, [key for key in (*SIZES, *ENDS) if whole or key not in FURTHER])

    def further_table(self, caption: Any) -> Table:
        """The rows that the table of the text is without."""
        return self._of_wheels(caption, FURTHER)

    def _of_wheels(self, caption: Any, keys: Iterable[str]) -> Table:
        rows = [
            [
                self._called(key),
                self.page.sym(self._indexed(key, "i")),
                *padded([self._size(key, i) for i in (0, 1)]),
            ]
            for key in keys
            if any(key in wheel for wheel in self.wheels)
        ]
        wheels = [self.t("wheel %(name)s", name=name) for name in self.names]
        return worded(caption, [self.t("Dimension"), self.t("Symbol"), *wheels], rows, (6, 1.5, 2, 2))

    def _called(self, key: str) -> Markup:
        """What a row is, with its unit."""
        column = self.sizes[key]
        self.page.means(self._indexed(key, "i"), column.meaning, column.quantity.shown)
        unit = self.page.unit(column.quantity.printed)
        return self.page.listed([self.page.message(column.meaning), *([unit] if unit else [])])

    def letters(self) -> list[Definition]:
        """The formulas of the numbers of wheel i, k being the other; of unlike wheels those of each."""
        return [one for key in OF_BOTH for one in self._letters(key)]

    def _letters(self, key: str) -> list[Definition]:
        has = [i for i in (0, 1) if self.wheels[i].has_formula(key)]
        if len(has) < 2:
            return [in_letters(self.wheels[i].formula(key), {}) for i in has]
        return of_all([(self.wheels[i].formula(key), self._names_of_both(i)) for i in has], self.page.tr)

    def _names_of_both(self, i: int) -> dict[Symbol, Symbol]:
        return {
            of_wheel(declared, self.names[wheel]): of_wheel(declared, index)
            for wheel, index in ((i, "i"), (1 - i, "k"))
            for key in Wheel.DECLARED
            if (declared := Wheel.DECLARED[key].symbol)
        }

    def _indexed(self, key: str, index: str) -> Symbol:
        return of_wheel(self.sizes[key].quantity.symbol or math_symbol(key), index)

    def _size(self, key: str, i: int) -> Cell | str:
        """A ring has no thickness on its base circle, which lies within its teeth, and no undercut."""
        if key not in self.wheels[i] or (key in NOT_OF_RINGS and self.stage.ring(i)):
            return DASH
        return self._shift(key, i) if key.startswith("x") else self.page.cell(self.sizes, key, i)

    def conditions(self, caption: Any) -> Table:
        """Every condition with its value, limit and what is in hand."""
        rows = [
            [
                self.page.word(self._name(c), self.judged, "condition", row),
                self._found_value(row, c),
                self.page.listed([LEAST if c.least else MOST, self._with_unit("limit", row, c)], ""),
                self._with_unit("margin", row, c),
                self.page.word(self._verdict(c), self.judged, "met", row),
            ]
            for row, c in enumerate(self.found.conditions)
        ]
        t = self.t
        heads = [t("Condition"), t("Value"), t("Limit"), t("Margin"), t("Verdict")]
        return worded(caption, heads, rows, (8, 3.6, 1.8, 1.5, 1.2))

    def _name(self, c: Condition) -> str:
        return Message(CONDITIONS[c.key], {"wheel": c.wheel}).render(self.page.tr.gettext)

    def _verdict(self, c: Condition) -> str:
        if c.key in BY_ASSEMBLY and not c.met:
            return self.page.tr.gettext(N_("only axially"))
        by_rule = N_("met by the rule only") if self.found.met_by_rule(c) else N_("not met")
        return self.page.tr.gettext(N_("met") if c.met else by_rule)

    def _found_value(self, row: int, c: Condition) -> Markup:
        """Letter, value, unit."""
        name = self.page.sym(self.judged["value"].symbol(row))
        if c.key == "sliding":
            name = self.page.listed(["|", name, "|"], "")
        equals = "\N{NO-BREAK SPACE}=\N{NO-BREAK SPACE}"
        return self.page.listed([name, self._with_unit("value", row, c)], equals)

    def _with_unit(self, key: str, row: int, c: Condition) -> Markup:
        return self.page.in_unit(self.page.said(self._measured(key, row, c)), c.unit)

    def _measured(self, key: str, row: int, c: Condition, size: bool = False) -> Cell:
        """A number in the unit of the condition: mm, degrees or none."""
        return self.page.cell(self.judged, key, row, c.unit, size=size, places=3 if c.unit else 4)

    def sliding_table(self, caption: Any) -> Table:
        """Specific sliding at the characteristic points of the line of action."""
        table = self.table("points")
        point, *numbers = table.columns
        rows = [
            [
                self.page.word(name, table, "point", row),
                *(self.page.cell(table, of.key, row) for of in numbers),
            ]
            for row, name in enumerate(point.values)
        ]
        heads = [self.t("Point"), *(self.page.head(of.symbol(), of.quantity.shown) for of in numbers)]
        return worded(caption, heads, rows, (2, 3, 3, 3, 3))

    @cached_property
    def moving(self) -> MotionView | None:
        """At the speed of the drive."""
        return MotionView(self.found, self.page, self.stage) if self.found.motion else None

    @cached_property
    def cutter(self) -> CutterView | None:
        """The pinion cutter that cuts the ring, or both wheels."""
        return CutterView(self) if self.found.cutters else None

    @cached_property
    def inspection(self) -> InspectionView:
        """By what the wheels are measured."""
        return InspectionView(self)

    @cached_property
    def backlash(self) -> BacklashView | None:
        """With teeth thinned and axes apart."""
        return BacklashView(self) if self.found.backlash else None

    @cached_property
    def quality(self) -> QualityView | None:
        """Over the division of the shifts and over the centre distance."""
        return QualityView(self) if self.found.quality else None

    # ------------------------------------------------------------ picture

    @cached_property
    def drawings(self) -> TeethView:
        return TeethView(self.found, self.page, self.label)

    # ------------------------------------------------------------ what is said

    def undercuts(self) -> list[Markup]:
        """What is to be said of each undercut wheel."""
        failed = [(row, c) for row, c in enumerate(self.found.conditions) if not c.met]
        return [self._undercut(row, c) for row, c in failed if c.key == "undercut"]

    def _undercut(self, row: int, c: Condition) -> Markup:
        i = self.names.index(c.wheel)
        deep = self.found.starts[i] > float(self.pair.rho_m[i])
        keys = "rho_l", "rho_m" if deep and self.found.cut_short else "rho_p"
        start, lower = (self.page.cell(self.sizes, key, i) for key in keys)
        values = {
            "wheel": c.wheel,
            "least": self.number("z_rule"),
            "short": self.page.said(self._measured("margin", row, c, size=True)),
            "limit": self.page.said(self._measured("limit", row, c)),
            "start": self.page.said(start),
            "lower": self.page.said(lower),
        }
        said = [
            self.t(UNDERCUT_BY_RULE if self.found.met_by_rule(c) else UNDERCUT, **values),
            self.t(UNDERCUT_DEEP if deep else UNDERCUT_HOW, **values),
            self.t("the undercut takes away a part of the active profile.")
            if deep
            else self.t("the undercut does not reach the active profile."),
        ]
        return self.page.listed(said, " ")

    def failures(self) -> list[Markup]:
        """Conditions that are not met, each with how much is wanting."""
        failed = [(row, c) for row, c in enumerate(self.found.conditions) if c in self.found.failed]
        return [
            self.t("%(condition)s (%(lack)s)", condition=self._name(c), lack=self._lack(row, c))
            for row, c in failed
        ]

    def verdict(self) -> Markup:
        """What the conditions come to; where their table is not in the text, of what they are."""
        if not self.found.failed:
            text = N_("All the conditions of a sound pair are met.")
            if self.page.note.stand("spur.conditions") == "body":
                text = N_("All the conditions are met.")
            return self.t(text)
        if self.found.sound:  # of the undercut the text has spoken
            return self.t("All the other conditions of a sound pair are met.")
        text = N_("Not all the conditions are met: %(list)s.")
        return self.t(text, list=self.page.listed(self.failures(), "; "))

    def reasons(self) -> list[Markup]:
        """Why the contact is shorter than between the tip circles."""
        return reasons(self)

    def stated_shifts(self) -> Markup:
        """What was stated where it is not what was taken."""
        return self.listed(("stated_one", "stated_two"))

    def _lack(self, row: int, c: Condition) -> Markup:
        if not np.isfinite(c.margin):
            return self.t("it has no bound") if c.key == "sliding" else self.t("they cannot pass each other")
        unit = [" ", self.page.unit(c.unit)] if c.unit else []
        lack = self.page.said(self._measured("margin", row, c, size=True))
        return self.t("short by %(lack)s", lack=self.page.listed([lack, *unit], ""))

    def conclusions(self) -> list[Markup]:
        """What failed, first; then what was found."""
        return [*self._failure(), self.page.listed([*self._found(), *self._in_motion()], " ")]

    def _failure(self) -> Iterator[Markup]:
        if self.found.failed:
            text = N_("Not all conditions of the gear pair %(name)s are met: %(list)s.")
            if self.found.sound:
                text = N_(
                    "Not all conditions of the gear pair %(name)s are met exactly: %(list)s; by the rule of the "
                    "course, which is considered sufficient, they are met."
                )
            line = self.t(text, name=self.title, list=self.page.listed(self.failures(), "; "))
            yield line if self.found.sound else Failed(line)

    def _found(self) -> Iterator[Markup]:
        said = self.page.said
        values: dict[str, Any] = {"name": self.title, "eps": self.number("eps")}
        for i in (0, 1):
            values[f"z{i + 1}"] = said(self.page.cell(self.sizes, "z", i))
            values[f"x{i + 1}"] = said(self.page.cell(self.sizes, "x", i))
        text = N_(
            "The gear pair %(name)s has %(z1)s and %(z2)s teeth, the profile shift coefficients %(x1)s and "
            "%(x2)s and the contact ratio %(eps)s."
        )
        yield self.t(text, **values)
        if not self.found.failed:
            yield self.t("All its conditions are met.")

    def _in_motion(self) -> Iterator[Markup]:
        """The largest specific sliding against what its speed allows, and the largest velocity of sliding."""
        if self.moving is None or self.found.beyond:
            return
        rows = [row for row, c in enumerate(self.found.conditions) if c.key == "sliding"]
        row = max(rows, key=lambda k: self.found.conditions[k].value)
        shown = self.page.shown
        text = N_(
            "At the pitch-line velocity %(speed)s m/s its largest specific sliding is %(sliding)s, where %(limit)s is "
            "allowed; the profiles slide at %(velocity)s m/s at most."
        )
        yield self.t(
            text,
            speed=self.number("v_pitch"),
            sliding=shown(self.judged, "value", row),
            limit=shown(self.judged, "limit", row),
            velocity=shown(self.moving.velocities_of, "v_sl", self.moving.row, size=True),
        )
