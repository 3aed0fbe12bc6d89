"""How numbers come about for which the page has no formula: the sentence of their chapter's ways, as `explain` has."""

from __future__ import annotations

from collections.abc import Container, Iterator
from functools import cache
from typing import Any, NamedTuple

from tmm_report.course import INITIAL_DATA, Results, chapters, room
from tmm_report.problems import Message
from tmm_report.quantity.model import Column, Table
from tmm_report.quantity.ways import Way, by_kind
from tmm_report.report.page import Page


def told(results: Results, page: Page, shown: Container[str]) -> dict[str, Any]:
    """`ways`, `meanings`: name of a number, "key" or, where tables differ in it, "table.key" -> the place of its text
    among `texts`; of the keys `shown` on the page."""
    texts: dict[str, int] = {}
    found: dict[str, dict[str, int]] = {"ways": {}, "meanings": {}}
    for table, key, way, meaning in _every(results, shown):
        for kind, text in (("ways", page.tr.gettext(way) if way else ""), ("meanings", _said(meaning, page))):
            if text:
                number = texts.setdefault(text, len(texts))
                if found[kind].setdefault(key, number) != number:
                    found[kind][f"{table}.{key}"] = number
    return {"texts": list(texts), **found}


def _said(meaning: Message, page: Page) -> str:
    return meaning.render(page.tr.gettext)


def _every(results: Results, shown: Container[str]) -> Iterator[tuple[str, str, str, Message]]:
    """Table, key, way and meaning."""
    for chapter, found in _rooms(results):
        quantities = room(chapter, "quantities")
        for table in quantities.tables(found):
            if not table.name.endswith("_diagram"):  # no cell of the page is of these
                for column in table.columns:
                    if column.key in shown:
                        yield table.name, column.key, _way(chapter, table, column), column.meaning
        for value in quantities.values(found):
            if value.key in shown:
                yield "", value.key, _own(chapter, value.key), value.meaning


def _way(chapter: str, table: Table, column: Column) -> str:
    if own := _own(chapter, f"{table.name}.{column.key}"):
        return own
    kind = by_kind(table, column, column.key)
    return kind.text if kind is not None else ""


@cache
def _own(chapter: str, name: str) -> str:
    """The sentence of a chapter's way to a number, "" where it has none."""
    whole, starred = _telling(chapter)
    table = name.partition(".")[0]
    every = (*whole.get(name, ()), *starred.get(table, ()), *starred.get("*", ()))
    found = [one for one in every if one.fits(name)]
    return min(found, key=lambda one: one.order).way.text if found else ""


class _Named(NamedTuple):
    """A way by one of its names, of which `parts` stand between the stars: the way's own patterns are dear to make."""

    order: int
    parts: list[str]
    way: Way

    def fits(self, name: str) -> bool:
        start, *rest = self.parts
        if not rest:
            return True
        if not (name.startswith(start) and name.endswith(rest[-1])):
            return False
        if len(rest) > 1:
            return self.way.fits(name) is not None
        return (
            len(name) >= len(start) + len(rest[0]) and "." not in name[len(start) : len(name) - len(rest[0])]
        )


@cache
def _telling(chapter: str) -> tuple[dict[str, list[_Named]], dict[str, list[_Named]]]:
    """The ways that say something: by whole names, and, of those with stars, by their table, "*"
    where a star stands in it."""
    whole: dict[str, list[_Named]] = {}
    starred: dict[str, list[_Named]] = {}
    for order, way in enumerate(room(chapter, "ways").WAYS):
        for key in way.keys.split() if way.text else ():
            parts, table = key.split("*"), key.partition(".")[0]
            home = whole if len(parts) == 1 else starred
            at = key if len(parts) == 1 else "*" if "*" in table else table
            home.setdefault(at, []).append(_Named(order, parts, way))
    return whole, starred


def _rooms(results: Results) -> Iterator[tuple[str, Any]]:
    if results.lever is not None:
        yield INITIAL_DATA, results.lever
    yield from chapters(results)
