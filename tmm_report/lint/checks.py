"""The list of checks of the norm control, each one function of what was made, and the way to run them."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import NamedTuple

from tmm_report.lint import drawings, letters, numbers, order, paper, sheets, units
from tmm_report.lint.made import Made
from tmm_report.problems import N_, Message, Problem

Look = Callable[[Made], Iterator[Problem]]
MOST = 20  # findings of one check that are told: more are one cause


class Check(NamedTuple):
    """`needs`: the files of which it reads any; `cheap`: it is run at the end of every solve, too."""

    look: Look
    needs: tuple[str, ...]
    cheap: bool = True


HTML, TEX, LOG, PDF, RESULTS = "note.html", "note.tex", "note.log", "note.pdf", "results.json"
CHECKS = (
    Check(order.unreferenced, (HTML, TEX)),
    Check(order.late, (HTML, TEX)),
    Check(order.disorder, (HTML, TEX)),
    Check(order.gaps, (HTML, TEX)),
    Check(order.nowhere, (HTML,)),
    Check(units.units, (RESULTS,)),
    Check(numbers.decimal_sign, (HTML, TEX)),
    Check(numbers.noise, (HTML,)),
    Check(numbers.twice, (HTML,)),
    Check(drawings.scales, (HTML,)),
    Check(drawings.on_lettering, (HTML,)),
    Check(drawings.on_lines, (HTML,), cheap=False),
    Check(letters.glyphs, (HTML, TEX, LOG)),
    Check(paper.over_margin, (HTML,)),
    Check(paper.overfull, (LOG,)),
    Check(sheets.empty, (PDF,), cheap=False),
)


class Outcome(NamedTuple):
    """What was found, the first `MOST` of each check, and how many there are in all."""

    told: list[Problem]
    every: int


def look(made: Made, cheap: bool = False) -> Outcome:
    """Run the checks. Raises ProblemError for what cannot be read."""
    told, count = list[Problem](), 0
    for check in CHECKS:
        if check.cheap or not cheap:
            found = [*check.look(made)]
            told += found[:MOST]
            count += len(found)
    return Outcome(told, count)


def unseen(made: Made) -> Iterator[Message]:
    """What could not be looked at, as its file or its program is not there."""
    if HTML not in made.files:
        yield Message(N_("no note.html: numbers, units, drawings and margins are not looked at"))
    elif RESULTS not in made.files:
        yield Message(N_("no results.json: units are not looked at; solve with --format html,tex,json"))
    if TEX in made.files and LOG not in made.files:
        yield Message(N_("no note.log: boxes and letters of the LaTeX are not looked at; solve with --pdf"))
    if sheets.unseen(made):
        yield Message(N_("no pdftoppm (poppler-utils): pages of the PDF are not looked at"))
