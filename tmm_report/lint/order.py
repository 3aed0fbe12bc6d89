"""References and numbers: what is not referred to, or too late, or out of order; gaps; what leads to nothing."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import NamedTuple

from tmm_report.lint.made import Made, series
from tmm_report.lint.page import Step
from tmm_report.problems import N_, Message, Problem

REFERRED = ("figure", "table")  # of these the text says where they are


class Text(NamedTuple):
    """The steps of one format: the name of its file, what is called how there, and at which lines."""

    file: str
    steps: Sequence[Step]
    names: Mapping[str, str]
    line: Callable[[str], int | None]

    def found(
        self, made: Made, check: str, anchor: str, wrong: Message, right: Message | None = None
    ) -> Problem:
        return made.found(check, self.file, self.line(anchor), wrong, right)


def _texts(made: Made) -> Iterator[Text]:
    if made.page is not None:
        yield Text("note.html", made.page.steps, made.page.names, made.line)
    if made.source is not None:
        names = {step.anchor: step.name for step in made.source.steps if step.stands}
        yield Text("note.tex", made.source.steps, names, made.source.lines.get)


def _referred(anchor: str) -> bool:
    return anchor.startswith(REFERRED) and series(anchor) is not None


def _of_text(anchor: str) -> bool:
    return _referred(anchor) and "-" not in anchor


def unreferenced(made: Made) -> Iterator[Problem]:
    """Figures and tables that no sentence refers to."""
    for text in _texts(made):
        told = {step.anchor for step in text.steps if not step.stands}
        for step in text.steps:
            if step.stands and _referred(step.anchor) and step.anchor not in told:
                wrong = Message(N_("%(what)s: nothing in the text refers to it"), {"what": step.name})
                right = Message(N_("name it in a sentence before it"))
                yield text.found(made, "unreferenced", step.anchor, wrong, right)


def late(made: Made) -> Iterator[Problem]:
    """Figures and tables that are first referred to after they stand."""
    for text in _texts(made):
        stands, told = dict[str, str](), set[str]()
        for step in text.steps:
            if step.stands and _referred(step.anchor):
                stands.setdefault(step.anchor, step.name)
            elif not step.stands and step.anchor not in told:
                told.add(step.anchor)
                if step.anchor in stands:
                    wrong = Message(
                        N_("%(what)s: the text refers to it only after it"), {"what": stands[step.anchor]}
                    )
                    right = Message(N_("name it in a sentence before it"))
                    yield text.found(made, "late", step.anchor, wrong, right)


def disorder(made: Made) -> Iterator[Problem]:
    """Figures and tables of the text that are first referred to after ones with greater numbers, but before they stand.

    Those of an appendix are numbered as they stand there, wherever the text comes to them."""
    for text in _texts(made):
        most, waiting = dict[str, tuple[int, str]](), {step.anchor for step in text.steps if step.stands}
        for step in text.steps:
            place = series(step.anchor) if not step.stands and _of_text(step.anchor) else None
            new = step.anchor in waiting
            waiting.discard(step.anchor)
            if place is None or not new:
                continue
            row, number = place
            before, other = most.get(row, (0, ""))
            if number > before:
                most[row] = number, step.anchor
                continue
            values = {"what": text.names[step.anchor], "other": text.names[other]}
            wrong = Message(N_("%(what)s is first referred to after %(other)s"), values)
            right = Message(N_("number them in the order in which the text refers to them"))
            yield text.found(made, "disorder", step.anchor, wrong, right)


def gaps(made: Made) -> Iterator[Problem]:
    """Numbers of figures, tables, formulas, sections and appendices that do not follow one another as they stand."""
    for text in _texts(made):
        last = dict[str, int]()
        for step in text.steps:
            place = series(step.anchor) if step.stands else None
            if place is None:
                continue
            row, number = place
            expected = last.get(row, 0) + 1
            last[row] = number
            if number != expected:
                values = {"what": step.name or step.anchor, "number": expected}
                wrong = Message(N_("%(what)s: its number does not follow the previous one"), values)
                right = Message(N_("number %(number)s is expected here"), values)
                yield text.found(made, "gap", step.anchor, wrong, right)


def nowhere(made: Made) -> Iterator[Problem]:
    """References to what the note has not."""
    for file, target, line in (*_lost_in_page(made), *_lost_in_source(made)):
        wrong = Message(N_("a reference leads to %(target)s, which is not in the note"), {"target": target})
        yield made.found("nowhere", file, line, wrong)


def _lost_in_page(made: Made) -> Iterator[tuple[str, str, int | None]]:
    if made.page is not None:
        for target, anchor in made.page.targets.items():
            if target not in made.page.names:
                yield "note.html", target, made.line(anchor)


def _lost_in_source(made: Made) -> Iterator[tuple[str, str, int | None]]:
    """Only what is numbered is read of the LaTeX."""
    if made.source is not None:
        stands = {step.anchor for step in made.source.steps if step.stands}
        for target in dict.fromkeys(step.anchor for step in made.source.steps if not step.stands):
            if series(target) is not None and target not in stands:
                yield "note.tex", target, made.source.lines.get(target)
