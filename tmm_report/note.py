"""The explanatory note: the views of the chapters that were solved, in the order of the course."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import partial, reduce
from types import ModuleType
from typing import Any

from tmm_report.course import (
    BEFORE,
    INITIAL_DATA,
    LEVER,
    SECTIONS,
    Depth,
    Results,
    chapters,
    doubts,
    left_out,
    room,
)
from tmm_report.figures.drawing import Drawing
from tmm_report.i18n import Translator
from tmm_report.problems import N_, Message
from tmm_report.report import render as render_parts
from tmm_report.report.doubts import Doubts
from tmm_report.report.formats import Html
from tmm_report.report.page import Page
from tmm_report.report.part import Inner, Part

Found = (
    Any  # the record of a lever mechanism, or the Found of another chapter: what the chapter's own view takes
)


def render(results: Results, fmt: str, tr: Translator, depth: Depth | None = None) -> dict[str, bytes]:
    """File name -> content: "note.html" alone, "note.tex" with the figures it reads, or the figures as pictures.

    `depth`: of the note, that of the variant unless it is stated."""
    title, note = results.variant.title, results.variant.note
    if depth is not None:
        note = replace(note, depth=depth)
    return render_parts(
        lambda page: list(parts(results, page)),
        title,
        fmt,
        tr,
        tuple(_undone(results)),
        note,
        results.variant.profile,
        results.variant.assignment,
        results.variant.template,
        partial(_living, results),
    )


def _living(results: Results, text: str, page: Page) -> str:
    from tmm_report.living import added  # for the screen alone

    assert isinstance(page.form, Html)
    return added(text, results, page, page.form.pictures)


def _undone(results: Results) -> Iterator[Message]:
    """What the variant asks and the note has not; of a variant without a lever mechanism, what looks odd in it."""
    if blocks := left_out(results):
        text = N_(
            "The mechanism does not close over the whole cycle; these parts of the project are therefore left out: "
            "%(blocks)s."
        )
        titles = (Message(N_("“%(title)s”"), {"title": Message(SECTIONS[name])}) for name in blocks)
        yield Message(text, {"blocks": reduce(_listed, titles)})
    for problem in doubts(results) if results.lever is None else ():  # else they stand under the initial data
        yield Message(N_("To be checked: %(what)s."), {"what": problem.said})


def _listed(these: Message, one: Message) -> Message:
    return Message("%(these)s, %(one)s", {"these": these, "one": one})


def parts(results: Results, page: Page) -> Iterator[Part]:
    """The parts of the note. What chapters say of their own data stands behind the initial data."""
    views = [(room(name, "view"), found) for name, found in _solved(results)]
    waiting = iter(views)
    for view, found in waiting:
        yield from _of_chapter(view, found, waiting, page)
        if view is room(INITIAL_DATA, "view"):
            for other, its in views:
                yield from other.given_parts(its, page) if hasattr(other, "given_parts") else ()
            if found_odd := doubts(results):
                yield Part("doubts", Doubts(found_odd, page))


def picture(results: Results, page: Page) -> Drawing:
    """What shows the whole at a glance: the picture of the first chapter that has one."""
    solved = sorted(_solved(results), key=lambda one: one[0] in BEFORE)
    views = ((room(name, "view"), found) for name, found in solved)
    return next(view.picture(found, page) for view, found in views if hasattr(view, "picture"))


def _solved(results: Results) -> Iterator[tuple[str, Found]]:
    found_first = dict(chapters(results))
    before = [name for name in BEFORE if name in found_first]
    yield from ((name, found_first[name]) for name in before)
    if results.lever is not None:
        yield INITIAL_DATA, results.lever
    for name, found in found_first.items():
        if name in before:
            continue
        yield name, results.lever if name in LEVER else found


def _of_chapter(
    view: ModuleType, found: Found, waiting: Iterator[tuple[ModuleType, Found]], page: Page
) -> Iterator[Part]:
    for part in view.parts(found, page):
        match part:
            case Part():
                yield part
            case Inner(chapter, inside, label):
                yield from room(chapter, "view").parts(inside, page, label)
            case _:  # NEXT_CHAPTER
                if (inner := next(waiting, None)) is not None:
                    yield from _of_chapter(*inner, waiting, page)
