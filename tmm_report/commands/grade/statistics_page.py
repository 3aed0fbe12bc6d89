"""Statistics of a year's works for the teacher: a page, and the numbers behind it as CSV.

files = statistics_files(statistics(digests), Translator("ru"))     # {"statistics.html": b"...", ...}
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from markupsafe import Markup

from tmm_report.grading.year.copies import limit
from tmm_report.grading.year.statistics import Share, Statistics, lines
from tmm_report.grading.year.words import kind_text
from tmm_report.i18n import Translator
from tmm_report.intake.writing import csv_bytes
from tmm_report.problems import N_, Message
from tmm_report.report.formats import Html
from tmm_report.report.numbering import Numbering
from tmm_report.report.page import Page, template
from tmm_report.resources import data_root

HARDEST = 15  # columns and cells of the page; the CSV has them all
LISTED = 200  # pairs and works of the page
WIDTH, HEIGHT, GAP = 56.0, 150.0, 4.0  # of a bar of the histogram at its tallest, px

Row = Sequence[str | float | int | None]


class Bar(NamedTuple):
    """A bar of the histogram: its place, and what it says."""

    x: float
    y: float
    height: float
    works: int
    label: str


class Hard(NamedTuple):
    """A row of a table of hard columns or cells."""

    share: Share
    part: str
    causes: str


def statistics_files(found: Statistics, tr: Translator) -> dict[str, bytes]:
    """`statistics.html`, self-contained; `statistics.csv`: every column and cell; `copies.csv`: pairs to look at."""
    form = Page(Html(), tr, Numbering())
    text = template("statistics.html.j2").render(
        {"page": form, "t": form.t},
        found=found,
        bars=bars(found),
        width=WIDTH - GAP,
        size=(WIDTH * 10, HEIGHT + 40),
        base=HEIGHT + 18,
        points=_points(found, form),
        columns=[_hard(share, form) for share in found.columns[:HARDEST] if share.part < 1],
        cells=[_hard(share, form) for share in found.cells[:HARDEST] if share.part < 1],
        causes=[(form.message(kind_text(kind)), count) for kind, count in found.causes],
        copies=[(form.message(copy.text), _chance(copy.cells)) for copy in found.copies[:LISTED]],
        mixed=[form.message(mixed.text) for mixed in found.mixed[:LISTED]],
        said=form.message(lines(found)[0]),
        absent=[form.message(one.text) for one in found.absent[:LISTED]],
        failed=[form.message(one.text) for one in found.failed[:LISTED]],
        by_hand=[form.message(one.text) for one in found.by_hand[:LISTED]],
        cut=_cut(found, form),
        style=Markup((data_root() / "templates" / "style.css").read_text("utf-8")),
    )
    files = {"statistics.html": text.encode(), "statistics.csv": csv_bytes(_shares(found, tr), tr.decimal)}
    return {**files, "copies.csv": csv_bytes(_pairs(found, tr), tr.decimal)}


def bars(found: Statistics) -> list[Bar]:
    """The histogram of the points by tenths of what the work is worth."""
    counts = found.histogram
    tallest = max([1, *counts])
    heights = [HEIGHT * count / tallest for count in counts]
    return [
        Bar(k * WIDTH, round(18 + HEIGHT - height, 1), round(height, 1), count, f"{10 * k}–{10 * k + 10}")
        for k, (count, height) in enumerate(zip(counts, heights, strict=True))
    ]


def _points(found: Statistics, page: Page) -> dict[str, str]:
    """Mean and quartiles in per cent."""
    lower, median, upper = found.quartiles
    named = {"mean": found.mean, "median": median, "lower": lower, "upper": upper}
    return {name: _percent(part, page) for name, part in named.items()}


def _percent(part: float, page: Page) -> str:
    return page.num(100 * part, places=0)


def _hard(share: Share, page: Page) -> Hard:
    causes = [f"{page.message(kind_text(kind)).unescape()} ({count})" for kind, count in share.causes[:3]]
    return Hard(share, _percent(share.part, page), ", ".join(causes))


def _chance(cells: int) -> str:
    return str(int(limit(cells)))


def _cut(found: Statistics, page: Page) -> Markup:
    """That a list of the page ends before its end; where the rest is."""
    if len(found.copies) <= LISTED:
        return Markup("")
    return page.t(N_("The first %(count)s are shown, all are in copies.csv."), count=LISTED)


# ---------------------------------------------------------------- CSV

HEADS = (
    N_("table"),
    N_("key"),
    N_("row"),
    N_("asked"),
    N_("right"),
    N_("carried forward"),
    N_("wrong"),
    N_("no answer"),
    N_("right, per cent"),
    N_("likely causes"),
)
PAIR_HEADS = (
    "id",
    N_("student"),
    N_("variant"),
    N_("has the numbers of"),
    N_("student"),
    N_("variant"),
    N_("same numbers"),
    N_("right for that variant alone"),
    N_("compared"),
    N_("a flag above"),
)


def _shares(found: Statistics, tr: Translator) -> list[Row]:
    """Columns, then cells, each the hardest first."""
    shares = (*found.columns, *found.cells)
    return [[tr.gettext(head) for head in HEADS], *(_row(share, tr) for share in shares)]


def _row(share: Share, tr: Translator) -> Row:
    causes = ", ".join(f"{_said(kind_text(kind), tr)} ({count})" for kind, count in share.causes)
    counts = [share.asked, share.right, share.carried, share.wrong, share.missing]
    return [share.table, share.key, share.row or "", *counts, round(100 * share.part, 1), causes]


def _pairs(found: Statistics, tr: Translator) -> list[Row]:
    """Works that share numbers, the most telling first."""
    rows: list[Row] = [
        [copy.one.id, copy.one.student, copy.one.variant, copy.other.id, copy.other.student, copy.other.variant,
         copy.shared, copy.fits, copy.cells, int(limit(copy.cells))]
        for copy in found.copies
    ]  # fmt: skip
    return [[tr.gettext(head) for head in PAIR_HEADS], *rows]


def _said(message: Message, tr: Translator) -> str:
    return message.render(tr.gettext)
