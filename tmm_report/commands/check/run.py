"""`tmm-report check`: every sample of a folder solved anew and held against what is stored beside it."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from pathlib import Path

from tmm_report import load, solve
from tmm_report.commands.check import junit as xml
from tmm_report.commands.check import numbers, stored, structure
from tmm_report.commands.files import render, write
from tmm_report.commands.talk import Talk, failure, unwritable, written
from tmm_report.i18n import said
from tmm_report.languages import FALLBACK
from tmm_report.problems import N_, Message, Problem, ProblemError, shown
from tmm_report.records import dataclass
from tmm_report.variant.department import is_one

MOST_SAMPLES = 2000
MOST_TOLD = 30  # differences of one sample that the terminal is told; the file of JUnit has more
MOST_KEPT = 500

NOT_STORED = Message(N_("no stored result; --update stores it"))


@dataclass(frozen=True, eq=False)
class Outcome:
    """One sample checked. `numbers`, `structure`: what is different; `made`: its stored file as it would be written
    now, None where that stands already."""

    variant: Path
    numbers: Sequence[Message] = ()
    structure: Sequence[str] = ()
    problems: Sequence[Problem] = ()
    made: bytes | None = None
    language: str = ""
    """Of the variant's mistakes."""

    @property
    def name(self) -> str:
        return shown(self.variant.stem, 200)

    @property
    def differs(self) -> bool:
        return bool(self.numbers or self.structure)


def run(folder: Path, *, update: bool, junit: Path | None, language: str | None, talk: Talk) -> bool:
    """Tell every difference; whether there is none, or with `update` whether all of them could be stored.

    Raises ProblemError where a sample or a stored file cannot be read, after all others were looked at.
    """
    talk.speak(language or FALLBACK)
    say = partial(said, language or FALLBACK)
    variants, lonely = samples(folder)
    outcomes = [_staged(variant, talk) for variant in variants] + [_lonely(path) for path in lonely]
    for outcome in outcomes:
        _tell(outcome, talk, say)
    if junit is not None:
        _write(junit.parent, {junit.name: xml.xml(cases(outcomes, say))})
        talk.tell(written(junit))
    if problems := [problem for outcome in outcomes for problem in outcome.problems]:
        raise ProblemError(problems, next((one.language for one in outcomes if one.language), ""))
    return _update(folder, outcomes, talk) if update else _counted(outcomes, talk)


def samples(folder: Path) -> tuple[list[Path], list[Path]]:
    """The variants of a folder by their names, and the stored files without one. Raises ProblemError."""
    try:
        files = sorted(path for path in folder.iterdir() if path.name.endswith((".yaml", stored.SUFFIX)))
    except OSError as error:
        raise failure("%(folder)s: %(reason)s", folder=shown(folder, 1000), reason=error.strerror) from None
    variants = [path for path in files if path.name.endswith(".yaml") and not is_one(path.name)]
    if not variants:
        raise failure(N_("%(folder)s holds no variants: no files *.yaml"), folder=shown(folder, 1000))
    if len(variants) > MOST_SAMPLES:
        text = N_("%(folder)s holds more than %(count)s variants")
        raise failure(text, folder=shown(folder, 1000), count=MOST_SAMPLES)
    own = {stored.place(variant) for variant in variants}
    return variants, [path for path in files if path.name.endswith(stored.SUFFIX) and path not in own]


def _staged(variant: Path, talk: Talk) -> Outcome:
    talk.stage(Message(N_("solving %(file)s"), {"file": shown(variant.name)}))
    return check(variant)


# ---------------------------------------------------------------- one sample


def check(variant: Path) -> Outcome:
    """A sample held against its stored file."""
    path = stored.place(variant)
    try:
        expected = stored.read(path) if path.is_symlink() or path.exists() else None
        loaded = load(variant)
        language = expected.language if expected is not None else loaded.language
        results = solve(loaded)
        sheets = numbers.sheets(results)
        lines = structure.lines(render(results, "html", language)["note.html"].decode())
    except ProblemError as error:
        return Outcome(variant, problems=error.problems, language=error.language)
    tolerances = expected.tolerances if expected is not None else stored.tolerances_of(sheets)
    made = stored.written(tolerances, language, sheets, lines)
    if expected is None:
        return Outcome(variant, [NOT_STORED], made=made)
    found = numbers.differences(expected.numbers, sheets, tolerances)
    diff = structure.diff(expected.structure, lines)
    messages = [difference.message for difference in found]
    return Outcome(variant, messages, diff, made=made if found or diff else None)


def _lonely(path: Path) -> Outcome:
    variant = path.with_name(path.name.removesuffix(stored.SUFFIX) + ".yaml")
    text = N_("%(file)s has no variant: put %(variant)s back, or remove the stored file")
    values = {"file": shown(path.name, 200), "variant": shown(variant.name, 200)}
    return Outcome(variant, [Message(text, values)])


# ---------------------------------------------------------------- what is said


def _tell(outcome: Outcome, talk: Talk, say: Callable[[str], str]) -> None:
    if outcome.numbers:
        talk.tell(Message(N_("%(sample)s, numbers:"), {"sample": outcome.name}))
        _first([message.render(say) for message in outcome.numbers], talk, say)
    if outcome.structure:
        talk.tell(Message(N_("%(sample)s, structure of the note:"), {"sample": outcome.name}))
        _first(outcome.structure, talk, say)


def _first(lines: Sequence[str], talk: Talk, say: Callable[[str], str]) -> None:
    for line in lines[:MOST_TOLD]:
        talk.tell(f"  {line}")
    if len(lines) > MOST_TOLD:
        more = Message(N_("… and %(count)s more"), {"count": len(lines) - MOST_TOLD})
        talk.tell(f"  {more.render(say)}")


def _counted(outcomes: Sequence[Outcome], talk: Talk) -> bool:
    """Tell how many samples differ and by how much; whether none does."""
    differ = [outcome for outcome in outcomes if outcome.differs]
    values = {
        "samples": len(outcomes),
        "differ": len(differ),
        "numbers": sum(len(outcome.numbers) for outcome in differ),
        "lines": sum(structure.changed(outcome.structure) for outcome in differ),
    }
    text = N_("samples: %(samples)s; different: %(differ)s (numbers: %(numbers)s, lines of notes: %(lines)s)")
    talk.tell(Message(text, values))
    return not differ


def cases(outcomes: Sequence[Outcome], say: Callable[[str], str]) -> list[xml.Case]:
    """Two cases a sample: numbers and structure."""
    found = []
    for one in outcomes:
        broken = [problem.text(say) for problem in one.problems]
        lines = [message.render(say) for message in one.numbers[:MOST_KEPT]]
        found.append(xml.Case(one.name, "numbers", lines, broken))
        found.append(xml.Case(one.name, "structure", one.structure[:MOST_KEPT], broken))
    return found


# ---------------------------------------------------------------- writing


def _update(folder: Path, outcomes: Sequence[Outcome], talk: Talk) -> bool:
    """Store what is different, all of it or nothing; whether nothing is left that differs."""
    files = {stored.place(one.variant).name: one.made for one in outcomes if one.made is not None}
    if files:
        _write(folder, files)
        talk.tell(written(*(folder / name for name in files)))
    elif not any(one.differs for one in outcomes):
        talk.tell(Message(N_("nothing to store: no sample differs")))
    return all(one.made is not None for one in outcomes if one.differs)


def _write(folder: Path, files: Mapping[str, bytes]) -> None:
    try:
        write(folder, files)
    except OSError as error:
        raise unwritable(folder, error) from None
