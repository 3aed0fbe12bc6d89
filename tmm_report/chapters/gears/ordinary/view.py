"""View of an ordinary stage of a drive: sentences with the formulas under them."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any, NamedTuple

from markupsafe import Markup

from tmm_report.chapters.gears.ordinary.draw import sketch
from tmm_report.chapters.gears.ordinary.solve import Found
from tmm_report.chapters.gears.ordinary.words import CHOSEN, GROUPS, HEADINGS, INTRODUCED
from tmm_report.figures.drawing import Drawing
from tmm_report.problems import N_
from tmm_report.quantity.formula import Formula
from tmm_report.report.chapter_view import ChapterView
from tmm_report.report.page import Page
from tmm_report.report.part import Part

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
        super().__init__(page, found.s)
        self.found, self.label = found, label
        self.one, self.two = found.input, found.output

    @property
    def heading(self) -> Markup:
        return self.t(HEADINGS[self.found.kind], name=self.found.name)

    def introduced(self) -> Markup:
        return self.t(INTRODUCED[self.found.given.variety], one=self.one, two=self.two)

    def given_values(self) -> Markup:
        """What is stated: the numbers that no formula gives."""
        told = [key for key in self.s.DECLARED if key in self.s and not self.s.has_formula(key)]
        left = ("omega1", "T1", *self.found.given.chosen)
        return self.listed(key for key in told if key not in left)

    def groups(self) -> Iterator[Written]:
        chosen = self.found.given.chosen
        for text, keys, taken in GROUPS[self.found.kind]:
            how = [self.t(CHOSEN[chosen[key]], value=self.sized(key)) for key in taken if key in chosen]
            if (formulas := self.formulas(*keys)) or how:
                yield Written(self.t(text), formulas, how)

    def symbols(self) -> list[dict[str, Any]]:
        """Every symbol of the stage with its meaning."""
        return self.explained(*(key for key in self.s.DECLARED if key in self.s))

    def at_work(self) -> Markup:
        """The speed and the torque that the drive gives it."""
        return self.t("At the input of the stage: %(values)s.", values=self.listed(("omega1", "T1")))

    def verdicts(self) -> Iterator[Markup]:
        least = LEAST_WRAP.get(self.found.given.variety)
        if least is not None:
            yield self._wrapped(least)

    def _wrapped(self, least: int) -> Markup:
        """The lesser angle of wrap against the rule."""
        key = "alpha1" if self.s.number("alpha1") <= self.s.number("alpha2") else "alpha2"
        enough = math.degrees(self.s.number(key)) >= least
        text = N_("The pulley that is wrapped less is so by %(wrap)s°, more than the %(least)s° of the rule.")
        if not enough:
            text = N_(
                "The pulley that is wrapped less is so by %(wrap)s°, less than the %(least)s° of the rule: a greater "
                "distance of the centres or a tightener is wanted."
            )
        return self.t(text, wrap=self.number(key, "deg", digits=4), least=least)

    def sketch(self) -> Drawing:
        return sketch(self.found, str(self.heading))

    def conclusions(self) -> list[Markup]:
        return []
