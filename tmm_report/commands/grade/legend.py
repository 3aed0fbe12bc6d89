"""The marks of cells on a student's page: a sign and a colour for every rule, and what each says."""

from __future__ import annotations

from collections.abc import Callable, Collection
from typing import NamedTuple

from markupsafe import Markup

from tmm_report.grading.model import Rule
from tmm_report.problems import N_, shown
from tmm_report.report.page import Page


class Mark(NamedTuple):
    """`kind`: the class that colours it; `sign`: what is read without colours. Both are put on the page as they are."""

    kind: Markup
    sign: Markup


def mark(kind: str, sign: str) -> Mark:
    """A mark of this file's own letters: nothing in it is to be escaped."""
    return Mark(Markup(kind), Markup(sign))


MARKS = {
    Rule.LIMIT: mark("right", "✓"),
    Rule.FLOOR: mark("right", "✓≈"),
    Rule.ZERO: mark("right", "✓0"),
    Rule.EXACT: mark("right", "✓="),
    Rule.CARRIED: mark("carried", "→"),
    Rule.OFF: mark("wrong", "✗"),
    Rule.SIGN: mark("wrong", "✗±"),
    Rule.NO_ANSWER: mark("none", "∅"),
    Rule.NOT_ASKED: mark("unasked", ""),
}

_WHY = {
    Rule.LIMIT: N_("right: the difference is within the limit of %(limit)s %%"),
    Rule.FLOOR: N_("right: the difference is within what can be read off a polygon, %(reading)s mm"),
    Rule.ZERO: N_("right: nothing within what can be read off a polygon"),
    Rule.EXACT: N_("right: a whole number, and the same"),
    Rule.CARRIED: N_("not right, but follows rightly from the own wrong value that is named under it"),
    Rule.OFF: N_("wrong: the difference is beyond the limit and beyond what can be read off a polygon"),
    Rule.SIGN: N_("wrong: the opposite sign"),
    Rule.NO_ANSWER: N_("no answer, or no number"),
    Rule.NOT_ASKED: N_("not asked"),
}
_FROM = N_("not right, but follows rightly from the own wrong value of %(source)s")


Limits = float | Callable[[str], float]
"""The limit of the difference, %: one for all, or by the name of the table."""


class Says:
    """What decided, in sentences of a page; each is made once."""

    def __init__(self, page: Page, limit: Limits, reading: float):
        self.page = page
        self._limit, self._reading = limit, page.num(reading)
        self._made: dict[tuple[Rule, str, str], Markup] = {}

    def limit(self, table: str) -> str:
        return self.page.num(self._limit(table) if callable(self._limit) else self._limit)

    def why(self, rule: Rule, table: str, source: str = "") -> Markup:
        """What decided a cell of a table; `source`: key of the quantity from whose wrong value it follows."""
        key = rule, table, source
        if key not in self._made:
            self._made[key] = self._why(rule, self.limit(table), source)
        return self._made[key]

    def _why(self, rule: Rule, limit: str, source: str = "") -> Markup:
        if rule is Rule.CARRIED and source:
            return self.page.t(_FROM, source=shown(source))
        return self.page.t(_WHY[rule], limit=limit, reading=self._reading)

    def legend(self, occurring: Collection[tuple[Rule, str]]) -> list[tuple[Mark, Markup]]:
        """The marks that stand on the page, by rules and tables in which they occur, each with what it says."""
        rules = {rule for rule, _ in occurring}
        limits = dict.fromkeys(self.limit(table) for _, table in sorted(occurring, key=lambda one: one[1]))
        return [
            (sign, self._why(rule, ", ".join(limits)))
            for rule, sign in MARKS.items()
            if rule in rules and sign.sign
        ]
