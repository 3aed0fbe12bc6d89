"""`index.html`: what came of every variant, with links to the notes; a thousand to a page."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from itertools import islice
from pathlib import Path
from typing import Any
from urllib.parse import quote

from markupsafe import Markup

from tmm_report.commands.batch.record import CHECK, DONE, LOST, WRONG, problems
from tmm_report.commands.files import write as write_files
from tmm_report.i18n import Translator
from tmm_report.problems import N_, Problem, shown
from tmm_report.quantity.symbols import math_symbol
from tmm_report.report.formats import Html
from tmm_report.report.numbering import Numbering
from tmm_report.report.page import Page, template
from tmm_report.resources import data_root
from tmm_report.running.journal import Record, read
from tmm_report.running.pool import chunked

ROWS = 1000  # of a page
BAD = 20  # variants with something wrong that the first page names above all
LONG = 160  # characters of a message
FIRST = ("note.html", "note.tex", "results.json")  # of its files, that which a link opens
STATUS = {DONE: N_("done"), CHECK: N_("a check failed"), WRONG: N_("not solved"), LOST: N_("no result")}


def write(
    journal: Path, output: Path, counts: Mapping[str, int], refused: Sequence[Problem], tr: Translator
) -> Path:
    """Raises OSError."""
    pages = max(1, -(-sum(counts.values()) // ROWS))
    form = Page(Html(), tr, Numbering())
    given = {
        "page": form,
        "t": form.t,
        "style": Markup((data_root() / "templates" / "style.css").read_text("utf-8")),
        "counts": [(form.t(STATUS[status]), count, status) for status, count in counts.items() if count],
        "refused": [_said(problem, tr) for problem in refused[:BAD]],
        "more_refused": max(0, len(refused) - BAD),
        "names": [_name(number) for number in range(pages)],
    }
    bad = (record for _, record in read(journal) if record["status"] != DONE)
    first = [_row(0, record, form) for record in islice(bad, BAD)]
    rows = (_row(number, record, form) for number, (_, record) in enumerate(read(journal), 1))
    for number, block in enumerate(chunked(rows, ROWS) if sum(counts.values()) else [[]]):
        text = template("batch.html.j2").render(given, rows=block, number=number, bad=[] if number else first)
        write_files(output, {_name(number): text.encode("utf-8", "replace")})
    _remove_after(output, pages)
    return output / _name(0)


def _name(number: int) -> str:
    return f"index-{number + 1}.html" if number else "index.html"


def _remove_after(output: Path, pages: int) -> None:
    """Pages of an earlier run that had more."""
    while (old := output / _name(pages)).is_file():
        old.unlink()
        pages += 1


def _row(number: int, record: Record, form: Page) -> dict[str, Any]:
    """A variant as the page prints it."""
    told = problems(record)
    numbers = record.get("numbers", {})
    return {
        "number": number,
        "id": record["id"],
        "status": record["status"],
        "said": form.t(STATUS[record["status"]]),
        "link": _link(record),
        **{name: shown(record.get(name, ""), 80) for name in ("student", "group", "variant", "formula")},
        "moment": form.num(numbers["M_bal"][0], 4) if "M_bal" in numbers else "",
        "others": form.listed(_others(numbers, form), "; "),
        "message": _said(replace(told[0], file=""), form.tr) if told else "",
        "more": max(0, len(told) - 1),
    }


def _others(numbers: Mapping[str, Any], form: Page) -> Iterable[Markup]:
    """Strokes and the drive's ratio: symbol = number unit."""
    for key, (value, unit) in numbers.items():
        if key.startswith("H_") or key == "drive_u":
            name = form.sym(math_symbol("u" if key == "drive_u" else key))
            said = f" = {form.num(value, 4)}" + (f" {form.unit(unit)}" if unit else "")
            yield name + form.text(said)


def _link(record: Record) -> str:
    """The way to the file that shows most; none where nothing was written."""
    files = record.get("files", {})
    if not files:
        return ""
    name = next((name for name in FIRST if name in files), "")
    return quote(f"{record['id']}/{name}")


def _said(problem: Problem, tr: Translator) -> str:
    return shown(problem.text(tr.gettext), LONG)
