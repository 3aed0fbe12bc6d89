"""The page that a student gets back: each of his numbers with its mark, likely causes first, no answers given away.

page = feedback(marked, Translator("ru"))      # one self-contained HTML file
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import groupby
from math import ceil
from typing import Any

import numpy as np
from markupsafe import Markup

from tmm_report.commands.grade.legend import MARKS, Limits, Mark, Says, mark
from tmm_report.course import SECTIONS
from tmm_report.grading.model import HELD, RIGHT, Cause, Digest, Marked, MarkedColumn, Name, Rule
from tmm_report.grading.year.words import attempt_text, override_text, state_text
from tmm_report.i18n import Translator
from tmm_report.problems import N_, shown
from tmm_report.records import dataclass
from tmm_report.report.formats import Html
from tmm_report.report.numbering import Numbering
from tmm_report.report.page import Page, template
from tmm_report.resources import data_root

Array = Any

NOTHING = Markup("")
WIDE, WIDE_WITH_ANSWERS = 7, 6  # columns side by side: what a sheet of A4 holds
LONGEST = 24  # characters of a cell's text
MANY = 12  # so many positions are listed one by one
FEW = 2  # so many columns are named by the sentence of a cause
WRONG = (Rule.OFF, Rule.SIGN)
KEPT_BACK = {
    "scale": N_("all numbers are off by one factor: the scale of the polygon"),
    "variant": N_("these are the numbers of another variant"),
}
"""Causes whose own sentence says what a student must not read: the factor gives the right numbers away, and whose
variant it is concerns the teacher."""


@dataclass(frozen=True)
class Remarks:
    """What the page says of the mark itself: why there is none, and the reasons; that it was set by hand; of which
    attempt it is. `judged`: whether the work was marked."""

    judged: bool = True
    state: Markup = NOTHING
    reasons: tuple[str, ...] = ()
    by_hand: Markup = NOTHING
    mark: str = ""
    attempt: Markup = NOTHING


@dataclass(frozen=True)
class Box:
    """One cell of the page: what the student wrote, its mark, why (left out of what is simply right); `more`: expected
    value and difference."""

    text: str
    mark: Mark
    why: Markup = NOTHING
    carried: str = ""
    more: tuple[str, ...] = ()


@dataclass(frozen=True)
class Head:
    """The head of a column; `points`: "3 / 4", "" where nothing is to be had; `magnitudes`: compared without sign."""

    symbol: Markup
    meaning: Markup
    points: str
    magnitudes: bool = False


@dataclass(frozen=True)
class Grid:
    """As many columns of a table as a page holds: heads, rows of (label, boxes)."""

    heads: list[Head]
    rows: list[tuple[str, list[Box]]]


@dataclass(frozen=True)
class Section:
    """A table of the results: `grids`, and the columns that he left out."""

    title: Markup
    name: str
    by_position: bool
    grids: list[Grid]
    left_out: list[Markup]


@dataclass(frozen=True)
class Mistake:
    """A likely cause: the sentence, columns, sections of the note, points without it."""

    what: Markup
    columns: list[Markup]
    sections: list[Markup]
    would: str = ""


@dataclass(frozen=True)
class Unexplained:
    """Columns of a section of the note with wrong cells that no cause names: symbol, and which cells."""

    section: Markup
    columns: list[tuple[Markup, Markup]]


def feedback(
    marked: Marked,
    tr: Translator,
    digest: Digest | None = None,
    *,
    answers: bool = False,
    limit: Limits = 5.0,
    reading: float = 1.0,
) -> bytes:
    """The page. `digest`: what is kept of the work, where its mark is not simply that of `marked`; of one that was not
    marked, why. `answers`: the right values and differences, too. `limit`, %, of all or by table, and `reading`, mm,
    are the rubric's, for the sentences that say what decided."""
    page = Page(Html(), tr, Numbering())
    says = Says(page, limit, reading)
    remarks = _remarks(digest, page) if digest is not None else Remarks()
    shown_columns = [one for one in marked.columns.values() if remarks.judged and _is_shown(one)]
    puzzling = _without_cause(marked, shown_columns)
    text = template("feedback.html.j2").render(
        {"page": page, "t": page.t},
        marked=marked,
        remarks=remarks,
        title={**dict.fromkeys(("student", "group", "variant", "topic"), ""), **_title(marked)},
        points=_points(marked.points, page),
        worth=_points(marked.worth, page),
        percent=page.num(100 * marked.points / marked.worth, places=0) if marked.worth else "",
        tally=list(_tally(shown_columns, page)),
        causes=[_cause(cause, would, marked, answers, page) for cause, would in _with_points(marked)],
        others=_unexplained(puzzling, page),
        ask=_ask([*puzzling, *shown_columns]),
        sections=list(_sections(shown_columns, says, answers)),
        legend=says.legend(_occurring(shown_columns)),
        notes=[] if remarks.reasons else [problem.text(tr.gettext) for problem in marked.answers.notes],
        answers=answers,
        style=Markup((data_root() / "templates" / "style.css").read_text("utf-8")),
    )
    return text.encode()


def _remarks(digest: Digest, page: Page) -> Remarks:
    state, attempt, override = state_text(digest), attempt_text(digest), digest.override
    reasons = () if digest.state == HELD else digest.failed
    return Remarks(
        digest.judged,
        page.message(state) if state is not None and override is None else NOTHING,
        reasons if override is None else (),
        page.message(override_text(override)) if override is not None else NOTHING,
        _points(digest.mark, page),
        page.message(attempt) if attempt is not None else NOTHING,
    )


def _is_shown(column: MarkedColumn) -> bool:
    """What he answered, and what there were points for."""
    return bool(column.worth.sum() > 0) or column.answered is not None


def _is_left_out(column: MarkedColumn) -> bool:
    return column.answered is None or not bool(np.any(column.answered.given))


def _points(points: float, page: Page) -> str:
    return page.num(points, places=2)


def _occurring(columns: Sequence[MarkedColumn]) -> set[tuple[Rule, str]]:
    """The rules that decided cells of the tables, each with its table."""
    answered = [column for column in columns if not _is_left_out(column)]
    return {(rule, column.asked.table) for column in answered for rule in column.rules}


def _tally(columns: Sequence[MarkedColumn], page: Page) -> Iterator[tuple[Mark, Markup, int]]:
    """Of each kind of mark how many cells have it: of those asked, and of those answered beyond."""
    rules = [
        rule
        for column in columns
        for rule, worth in zip(column.rules, column.worth, strict=True)
        if worth or rule is not Rule.NO_ANSWER
    ]
    kinds: tuple[tuple[str, str, tuple[Rule, ...]], ...] = (
        ("✓", N_("right"), RIGHT),
        ("→", N_("carried forward"), (Rule.CARRIED,)),
        ("✗", N_("wrong"), WRONG),
        ("∅", N_("no answer"), (Rule.NO_ANSWER,)),
    )
    for sign, text, some in kinds:
        if count := sum(rule in some for rule in rules):
            yield mark(MARKS[some[0]].kind, sign), page.t(text), count


# ---------------------------------------------------------------- what went wrong


def _with_points(marked: Marked) -> Iterator[tuple[Cause, float]]:
    would = (*marked.would, *[marked.points] * len(marked.causes))
    return zip(marked.causes, would[: len(marked.causes)], strict=True)


def _cause(cause: Cause, would: float, marked: Marked, answers: bool, page: Page) -> Mistake:
    columns = [marked.columns[name] for name in cause.names if name in marked.columns]
    kept_back = "" if answers else KEPT_BACK.get(cause.kind, "")
    better = would > marked.points + 0.005
    return Mistake(
        page.t(kept_back) if kept_back else page.message(cause.what),
        [_symbol(column, page) for column in columns] if kept_back or len(columns) > FEW else [],
        _titles(columns, page),
        _points(would, page) if better else "",
    )


def _titles(columns: Sequence[MarkedColumn], page: Page) -> list[Markup]:
    """The sections of the note in which the columns are found, each once."""
    names = dict.fromkeys(SECTIONS.get(column.asked.chapter, "") for column in columns)
    return [page.t(name) for name in names if name]


def _without_cause(marked: Marked, columns: Sequence[MarkedColumn]) -> list[MarkedColumn]:
    """Columns with wrong cells that no cause names."""
    named: set[Name] = {name for cause in marked.causes for name in cause.names}
    return [column for column in columns if column.asked.name not in named and _wrong_rows(column)]


def _unexplained(columns: Sequence[MarkedColumn], page: Page) -> list[Unexplained]:
    """The same by sections of the note, in the order in which they first occur."""
    found: dict[str, list[tuple[Markup, Markup]]] = {}
    for column in columns:
        said = _symbol(column, page), _which(column, _wrong_rows(column), page)
        found.setdefault(SECTIONS.get(column.asked.chapter, ""), []).append(said)
    return [Unexplained(page.t(name) if name else NOTHING, some) for name, some in found.items()]


def _wrong_rows(column: MarkedColumn) -> list[str]:
    return [
        label for label, rule in zip(column.asked.rows, column.rules, strict=True) if rule in WRONG
    ]  # fmt: skip


def _which(column: MarkedColumn, rows: Sequence[str], page: Page) -> Markup:
    if not any(rows):
        return page.t(N_("wrong"))
    listed = ", ".join(shown(row) for row in rows[:MANY]) + (", …" if len(rows) > MANY else "")
    text = N_("wrong, positions: %(rows)s") if column.asked.by_position else N_("wrong, rows: %(rows)s")
    return page.t(text, rows=listed)


def _ask(columns: Sequence[MarkedColumn]) -> str:
    """The command that prints a derivation, of the first number that is wrong; "" where none is."""
    for column in columns:
        if rows := _wrong_rows(column):
            where = f" {rows[0]}" if column.asked.by_position else ""
            return f"tmm-report explain variant.yaml {shown(column.asked.key)}{where}"
    return ""


def _symbol(column: MarkedColumn, page: Page) -> Markup:
    quantity = column.asked.quantity
    return page.sym(quantity.symbol) if quantity.symbol is not None else page.text(quantity.key)


# ---------------------------------------------------------------- tables


def _sections(columns: Sequence[MarkedColumn], says: Says, answers: bool) -> Iterator[Section]:
    """A section for every table; single values of a chapter are a table of one row."""
    page = says.page

    def place(column: MarkedColumn) -> tuple[str, str]:
        return column.asked.table, column.asked.chapter if not column.asked.table else ""

    for (table, _), group in groupby(columns, place):
        some = list(group)
        answered = [column for column in some if not _is_left_out(column)]
        left_out = [_symbol(column, page) for column in some if _is_left_out(column)]
        title = SECTIONS.get(some[0].asked.chapter, "")
        grids = list(_grids(answered, says, answers))
        by_position = some[0].asked.by_position
        yield Section(page.t(title) if title else NOTHING, table, by_position, grids, left_out)


def _grids(columns: Sequence[MarkedColumn], says: Says, answers: bool) -> Iterator[Grid]:
    """Columns of equal rows side by side, as many in each grid as in the next."""
    wide = WIDE_WITH_ANSWERS if answers else WIDE
    for _, group in groupby(columns, lambda column: column.asked.rows):
        same = list(group)
        size = ceil(len(same) / ceil(len(same) / wide))
        for first in range(0, len(same), size):
            yield _grid(same[first : first + size], says, answers)


def _grid(columns: Sequence[MarkedColumn], says: Says, answers: bool) -> Grid:
    boxes = [_boxes(column, says, answers) for column in columns]
    labels = [shown(label) for label in columns[0].asked.rows]
    rows = [(label, list(row)) for label, *row in zip(labels, *boxes, strict=True)]
    return Grid([_head(column, says.page) for column in columns], rows)


def _head(column: MarkedColumn, page: Page) -> Head:
    quantity, worth = column.asked.quantity, float(column.worth.sum())
    unit = page.unit(quantity.unit)
    symbol = _symbol(column, page)
    points = f"{_points(float(column.points.sum()), page)} / {_points(worth, page)}" if worth else ""
    head = page.listed([symbol, unit]) if unit else symbol
    return Head(head, page.message(quantity.meaning), points, column.judged.magnitudes)


def _boxes(column: MarkedColumn, says: Says, answers: bool) -> list[Box]:
    return [_box(column, k, says, answers) for k in range(len(column.rules))]


def _box(column: MarkedColumn, k: int, says: Says, answers: bool) -> Box:
    rule, text = column.rules[k], _text(column, k, says.page)
    if rule is Rule.NOT_ASKED or (rule is Rule.NO_ANSWER and not column.worth[k] and not text):
        return Box(text, MARKS[Rule.NOT_ASKED])
    source = shown(column.carried[k]) if rule is Rule.CARRIED else ""
    more = tuple(_answer(column, k, says.page)) if answers else ()
    reason = says.why(rule, column.asked.table, source) if rule is not Rule.LIMIT else NOTHING
    return Box(text, MARKS[rule], reason, source, more)


def _text(column: MarkedColumn, k: int, page: Page) -> str:
    """The cell as the student wrote it."""
    if column.answered is None or not column.answered.given[k]:
        return ""
    number = float(column.answered.values[k])
    written = shown(column.answered.texts[k], LONGEST)
    return written or (page.num(number) if np.isfinite(number) else "")


def _answer(column: MarkedColumn, k: int, page: Page) -> Iterator[str]:
    """What is expected, and the difference."""
    yield "= " + page.num(float(column.asked.values[k]), scale=column.asked.largest or 1.0)
    delta = float(column.judged.delta[k])
    if np.isfinite(delta):
        yield f"δ = {page.num(delta, places=1)} %"


def _title(marked: Marked) -> dict[str, str]:
    return {key: shown(value, 200) for key, value in marked.title.items()}
