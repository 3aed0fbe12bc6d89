"""`tmm-report methods`: every method on one variant, timed, its errors against 40 digits, the cheapest named."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path

from tmm_report import load
from tmm_report.backwards import solve
from tmm_report.commands.files import translator
from tmm_report.commands.methods import data
from tmm_report.commands.methods.measured import All, measured
from tmm_report.commands.methods.page import cheapest_of, lines, of_auto, page
from tmm_report.commands.solve import tell_changed
from tmm_report.commands.talk import Talk, failure, unwritable, written
from tmm_report.commands.whole import put
from tmm_report.course import Results, Variant
from tmm_report.i18n import Translator
from tmm_report.mechanics.rivals.choice import ACCURACY
from tmm_report.mechanics.rivals.counts import Counted
from tmm_report.problems import N_, Message, Problem, ProblemError
from tmm_report.quantity.text import number
from tmm_report.quantity.units import WrongValue, parse
from tmm_report.report.words import method_name
from tmm_report.variant import locate

LOW, HIGH = 1e-15, 0.5  # of an accuracy
MAKE: Mapping[str, Callable[[All, Results, Translator], dict[str, bytes]]] = {
    "html": page,
    "json": lambda found, _, tr: data.as_json(found, tr),
    "csv": lambda found, _, tr: data.as_csv(found),
}


def run(
    variant: Path,
    folder: Path | None,
    accuracy: str | None,
    formats: str,
    language: str | None,
    talk: Talk,
    *,
    quick: bool = False,
) -> bool:
    """Compare, tell and write; always true. Raises ProblemError."""
    wanted, stated = _formats(formats), _accuracy(accuracy)
    loaded = load(variant)
    tr = translator(loaded, language)
    talk.speak(tr.language)
    _uniform(loaded)
    results = _solved(loaded)
    own = stated if stated is not None or loaded.lever is None else loaded.lever.accuracy
    talk.stage(Message(N_("measuring the methods")))
    found = measured(results, ACCURACY if own is None else own, own is not None, quick)
    if not found.families:
        raise ProblemError(
            [locate(Problem(Message(N_("the variant has nothing that several methods find"))), loaded)]
        )
    _tell(found, tr, talk)
    folder = folder or Path(f"{variant.stem}-methods")
    files = {name: text for one in wanted for name, text in MAKE[one](found, results, tr).items()}
    try:
        changed = put(folder, files)
    except OSError as error:
        raise unwritable(folder, error) from None
    talk.tell(written(*(folder / name for name in files)))
    tell_changed(folder, changed, talk)
    return True


def _uniform(variant: Variant) -> None:
    """The methods are compared of a uniformly turning driving link. Raises ProblemError for another."""
    if variant.lever is not None and variant.lever.mechanism.driver.law is not None:
        told = {"key": "tmm-report methods"}
        wrong = Message(
            N_("%(key)s reckons with a uniformly turning driving link, and a law is stated"), told
        )
        right = Message(N_("a variant whose driver has a speed, for the same lengths"))
        raise ProblemError([locate(Problem(wrong, right, ("mechanism", "driver")), variant)])


def _solved(variant: Variant) -> Results:
    """By the closed form and without the note's own comparison."""
    if variant.lever is not None:
        variant = replace(variant, lever=replace(variant.lever, way=None, methods=None))
    try:
        return solve(variant)
    except ProblemError as error:
        raise ProblemError([locate(problem, variant) for problem in error.problems]) from None


def _formats(text: str) -> list[str]:
    wanted = list(dict.fromkeys(part.strip().lower() for part in text.split(",") if part.strip()))
    unknown = [part for part in wanted if part not in MAKE]
    if unknown or not wanted:
        wrong = N_("--format: unknown %(words)s; known: %(known)s")
        raise failure(wrong, words=", ".join(unknown) or "''", known=", ".join(MAKE))
    return wanted


def _accuracy(text: str | None) -> float | None:
    """The value of --accuracy. Raises ProblemError."""
    if text is None:
        return None
    try:
        value = parse(text, "number")
    except WrongValue as error:
        raise ProblemError([Problem(error.wrong, error.right, ("--accuracy",))]) from None
    if not LOW <= value <= HIGH:
        wrong = Message(N_("%(value)s is out of range"), {"value": text[:40]})
        raise ProblemError(
            [Problem(wrong, Message(N_("a relative error from 1e-15 to 0.5")), ("--accuracy",))]
        )
    return value


def _tell(found: All, tr: Translator, talk: Talk) -> None:
    """The tables, what is refused, and what follows."""
    for family in found.families:
        talk.tell(Message(family.title))
        for line in lines(family, tr):
            talk.tell(line)
        for method, why in family.refused:
            talk.tell(
                Message(N_("refused: %(method)s: %(why)s"), {"method": method_name(method, tr), "why": why})
            )
        talk.tell(cheapest_of(family, tr))
        if family is found.motion and (auto := of_auto(found, tr)):
            talk.tell(auto)
    if found.counted is not None:
        _tell_counts(found.counted, tr, talk)


def _tell_counts(counted: Counted, tr: Translator, talk: Talk) -> None:
    values = {"count": counted.recommended, "accuracy": number(counted.accuracy, 2, tr.decimal, scale=0)}
    if counted.recommended is None:
        text = N_("No table of up to 100 positions gives extremes and integrals within %(accuracy)s.")
    else:
        text = N_("From %(count)s positions on a table gives extremes and integrals within %(accuracy)s.")
    talk.tell(Message(text, values))
