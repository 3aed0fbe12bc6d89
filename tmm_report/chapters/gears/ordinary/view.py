"""View of an ordinary stage of a drive: sentences with the formulas under them."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import cached_property
from typing import Any, NamedTuple

from markupsafe import Markup

from tmm_report.chapters.gears.ordinary.draw import sketch
from tmm_report.chapters.gears.ordinary.given import WormStage
from tmm_report.chapters.gears.ordinary.quantities import tables
from tmm_report.chapters.gears.ordinary.solve import Found
from tmm_report.chapters.gears.ordinary.values import Train, TrainWheel
from tmm_report.chapters.gears.ordinary.words import CHOSEN, GROUPS, HANDED, HEADINGS, INTRODUCED, WAY
from tmm_report.figures.drawing import Drawing
from tmm_report.problems import N_
from tmm_report.quantity.formula import Formula
from tmm_report.report.chapter_view import ChapterView
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Cell, Column, Table, numeric
from tmm_report.report.part import Part

WORK = "omega1", "T1"  # what the drive gives at the input
LEAST_WRAP = {"belt open": 150, "belt crossed": 150, "belt V": 120}  # deg, by the rule of machine parts


def parts(found: Found, page: Page, label: str) -> Iterator[Part]:
    """Of a stage; `label`: with which its sections, and its names in the results, begin."""
    yield Part("gears/ordinary", OrdinaryView(found, page, label))


class Written(NamedTuple):
    """A sentence, the formulas under it, and what is taken by them."""

    text: Markup
    formulas: list[Formula]
    taken: list[Markup]


class OrdinaryView(ChapterView):
    own = True

    def __init__(self, found: Found, page: Page, label: str):
        super().__init__(page, found.s, tables(found, label))
        self.found, self.label = found, label
        self.one, self.two = found.input, found.output

    @property
    def heading(self) -> Markup:
        return self.t(HEADINGS[self.found.kind], name=self.found.name)

    def introduced(self) -> Markup:
        given = self.found.given
        text = self.t(INTRODUCED[given.variety], one=self.one, two=self.two)
        if not isinstance(given, WormStage):
            return text
        lies = self.t(HANDED[f"{given.hand} {given.worm}"])
        return self.page.listed([text, lies, self.t(WAY[given.sense])], " ")

    @cached_property
    def stated(self) -> list[str]:
        """The numbers that no formula gives."""
        told = [key for key in self.s.DECLARED if key in self.s and not self.s.has_formula(key)]
        left = (*WORK, *self.found.given.chosen)
        return [key for key in told if key not in left]

    def given_values(self) -> Markup:
        """What is stated, and what it is."""
        wheels = self.wheels[:-1] if "z2" in self.found.given.chosen else self.wheels
        teeth = [self.page.value(row.z) for row in wheels]
        of_teeth = [self.t("numbers of teeth %(teeth)s", teeth=self.page.listed(teeth))] if teeth else []
        return self.page.listed([*of_teeth, self.told_of(self.stated)], "; ")

    def groups(self) -> Iterator[Written]:
        chosen = self.found.given.chosen
        for text, keys, taken in GROUPS[self.found.kind]:
            how = [self.t(CHOSEN[chosen[key]], value=self._taken(key)) for key in taken if key in chosen]
            if (formulas := self.formulas(*keys)) or how:
                yield Written(self.t(text), formulas, how)

    def _taken(self, key: str) -> Markup:
        """A number that is chosen; the teeth of a train are those of its rows."""
        return self.page.value(self.wheels[-1].z) if key == "z2" and self.wheels else self.sized(key)

    # ------------------------------------------------------------ of a train

    @property
    def wheels(self) -> tuple[TrainWheel, ...]:
        return self.s.rows if isinstance(self.s, Train) else ()

    def of_wheels(self) -> list[Formula]:
        """Distances, then forces mesh by mesh."""
        keys = ("a", "F_t", "F_r", "F_axis")
        return [row.formula(key) for key in keys for row in self.wheels if row.has_formula(key)]

    def wheels_table(self) -> Table:
        table = self.table("train")
        names = [self.page.word(name, table, "wheel", row) for row, name in enumerate(table["wheel"].values)]
        keys = [one.key for one in table.columns if one.key not in ("wheel", "z")]
        teeth = [Cell(f"{row.number('z'):.0f}", table.ref("z", row.row)) for row in self.wheels]
        columns = [
            Column(self.page.head(table["z"].symbol()), teeth),
            *(self.page.column(table, key) for key in keys),
        ]
        return numeric(self.t("Wheels of the train"), Column(self.t("Wheel"), names), columns)

    def of_table(self) -> list[dict[str, Any]]:
        """What the columns of the table are."""
        keys = [one.key for one in self.table("train").columns if one.key != "wheel"]
        return self.columns_explained("train", *keys)

    # ------------------------------------------------------------ what is said beside

    def told(self) -> list[dict[str, Any]]:
        """The symbols of what is stated and of the work, which are called what they are where they stand."""
        return self.explained(*self.stated, *WORK)

    def symbols(self) -> list[dict[str, Any]]:
        """Every other symbol of the stage with its meaning, in the unit of the formulas."""
        left = {*self.stated, *WORK}
        keys = (key for key in self.s.DECLARED if key in self.s and key not in left)
        found = ((f"{self.prefix}{key}", self.value(key)) for key in keys)
        return [self.page.explained(name, of, of.quantity.unit) for name, of in found]

    def at_work(self) -> Markup:
        """The speed and the torque that the drive gives it."""
        return self.t("At the input of the stage: %(values)s.", values=self.told_of(WORK))

    def verdicts(self) -> Iterator[Markup]:
        least = LEAST_WRAP.get(self.found.given.variety)
        if least is not None:
            yield self._wrapped(least)
        if self.found.kind == "worm":
            yield self._held()

    def _held(self) -> Markup:
        """Of a worm: whether its wheel can drive it."""
        text = N_(
            "The lead angle %(gamma)s° is greater than the angle of friction %(phi)s°, so the worm is not "
            "self-locking: a load on the wheel drives it."
        )
        if self.found.locks:
            text = N_(
                "The lead angle %(gamma)s° does not exceed the angle of friction %(phi)s°, so the worm is "
                "self-locking: no load on the wheel drives it."
            )
        return self.t(text, gamma=self.number("gamma"), phi=self.number("phi"))

    def _wrapped(self, least: int) -> Markup:
        """The lesser angle of wrap against the rule."""
        key = "alpha1" if self.s.number("alpha1") <= self.s.number("alpha2") else "alpha2"
        enough = math.degrees(self.s.number(key)) >= least
        text = N_(
            "The smaller angle of wrap is %(wrap)s°, more than the least value %(least)s° of the usual rule."
        )
        if not enough:
            text = N_(
                "The smaller angle of wrap is %(wrap)s°, less than the least value %(least)s° of the usual rule: "
                "a greater centre distance or a tensioner is needed."
            )
        return self.t(text, wrap=self.number(key, "deg"), least=least)

    def sketch(self) -> Drawing:
        return sketch(self.found, str(self.heading), self.page.tr.in_index)

    def conclusions(self) -> list[Markup]:
        return []
