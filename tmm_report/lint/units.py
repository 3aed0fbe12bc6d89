"""Units: of a column by its head, of a result behind it."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache
from xml.etree.ElementTree import Element

from tmm_report.lint.known import Known
from tmm_report.lint.made import Made
from tmm_report.lint.numbers import read
from tmm_report.lint.page import Number, Page, heads, rows, said
from tmm_report.problems import N_, Message, Problem
from tmm_report.quantity.text import unit_text

WITHOUT = ("", "1", "rad")  # what may be printed without its unit: a plain number, an angle in radians

EQUAL = ("=", "≈")


def units(made: Made) -> Iterator[Problem]:
    """Columns whose head names no unit, and formulas whose result has none, where the results know one."""
    if made.page is None or made.known is None:
        return
    marked = {number.node: number for number in made.page.numbers}
    yield from _columns(made, made.page, made.known, marked)
    yield from _formulas(made, made.page, made.known, marked)


def _columns(made: Made, page: Page, known: Known, marked: dict[Element, Number]) -> Iterator[Problem]:
    for anchor, table in page.tables:
        names = [said(node) for node in heads(table)]
        told = set[int]()
        for cells in rows(table):
            for column, cell in enumerate(cells):
                unit = _wanted(cell, known, marked, page.language)
                if not unit or column in told or column >= len(names):
                    continue
                around = [names[column], said(cell), *(said(one) for one in cells if one not in marked)]
                if not any(_names(text, unit) for text in around):
                    told.add(column)
                    values = {"what": page.name(anchor), "head": names[column], "unit": unit}
                    wrong = Message(N_("%(what)s, column “%(head)s”: no unit"), values)
                    yield made.found(
                        "unit",
                        "note.html",
                        made.line(anchor),
                        wrong,
                        Message(N_("it is in %(unit)s"), values),
                    )


def _formulas(made: Made, page: Page, known: Known, marked: dict[Element, Number]) -> Iterator[Problem]:
    for anchor, last in _results(page):
        if unit := _wanted(last, known, marked, page.language):
            values = {"what": page.name(anchor), "text": marked[last].text, "unit": unit}
            wrong = Message(N_("%(what)s: the result %(text)s has no unit"), values)
            yield made.found(
                "unit", "note.html", made.line(anchor), wrong, Message(N_("it is in %(unit)s"), values)
            )


def _results(page: Page) -> Iterator[tuple[str, Element]]:
    """Numbers that end a formula behind a sign of equality: its pieces stand side by side."""
    anchor = ""
    for node in page.root.iter():
        anchor = node.get("id") or anchor
        for k, one in enumerate(node):
            if one.tag == "math" and len(one) > 1 and one[-2].text in EQUAL:
                goes_on = k + 1 < len(node) and node[k + 1].tag in ("wbr", "br", "math")
                if not goes_on or (one.tail or "").strip():
                    yield anchor, one[-1]


def _wanted(node: Element, known: Known, marked: dict[Element, Number], language: str) -> str:
    """The unit that must stand by a number as it is printed, "" where none must."""
    number = marked.get(node)
    if number is None or read(number.text) is None:
        return ""
    unit = known.unit(number)
    return "" if unit is None or unit in WITHOUT else unit_text(unit, language)


def _names(text: str, unit: str) -> bool:
    return bool(_unit(unit).search(text))


@cache
def _unit(unit: str) -> re.Pattern[str]:
    return re.compile(rf"(?<![^\W\d_]){re.escape(unit)}(?![^\W\d_])")
