"""The list of checks of the norm control, each one function of what was made, and the way to run them."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import NamedTuple

from tmm_report.lint import drawings, letters, numbers, order, paper, sheets, units
from tmm_report.lint.made import Made
from tmm_report.problems import N_, Message, Problem

Check = Callable[[Made], Iterator[Problem]]
MOST = 20  # findings of one check that are told: more are one cause
QUICK: tuple[Check, ...] = (
    order.unreferenced,
    order.late,
    order.disorder,
    order.gaps,
    order.nowhere,
    units.units,
    numbers.decimal_sign,
    numbers.noise,
    numbers.twice,
    drawings.scales,
    drawings.on_lettering,
    letters.glyphs,
    paper.over_margin,
    paper.overfull,
)
"""Those that are run at the end of every solve, too."""
CHECKS: tuple[Check, ...] = (*QUICK, drawings.on_lines, sheets.empty)


class Outcome(NamedTuple):
    """What was found, the first `MOST` of each check, and how many there are in all."""

    told: list[Problem]
    every: int


def look(made: Made, checks: Iterable[Check] = CHECKS) -> Outcome:
    """Run the checks. Raises ProblemError for what cannot be read."""
    told, count = list[Problem](), 0
    for check in checks:
        found = [*check(made)]
        told += found[:MOST]
        count += len(found)
    return Outcome(told, count)


def unseen(made: Made) -> Iterator[Message]:
    """What could not be looked at, as its file or its program is not there."""
    if "note.html" not in made.files:
        yield Message(N_("no note.html: numbers, units, drawings and margins are not looked at"))
    elif "results.json" not in made.files:
        yield Message(N_("no results.json: units are not looked at; solve with --format html,tex,json"))
    if "note.tex" in made.files and "note.log" not in made.files:
        yield Message(N_("no note.log: boxes and letters of the LaTeX are not looked at; solve with --pdf"))
    if sheets.unseen(made):
        yield Message(N_("no pdftoppm (poppler-utils): pages of the PDF are not looked at"))
