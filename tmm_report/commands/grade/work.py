"""What is done with some students' works, in a process of its own: variants solved together, answers read and marked,
feedback written."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import lru_cache
from pathlib import Path

from tmm_report.commands.batch.inputs import Task
from tmm_report.commands.batch.work import loaded, solved_together
from tmm_report.commands.files import translator, write
from tmm_report.commands.grade.feedback import feedback
from tmm_report.course import Results, Variant
from tmm_report.grading import others as year
from tmm_report.grading.answers import read
from tmm_report.grading.expected import expected, reversed_reactions
from tmm_report.grading.marks import digest, grade
from tmm_report.grading.model import Answers, Digest, Expected
from tmm_report.grading.rubric import Rubric
from tmm_report.i18n import Translator
from tmm_report.intake.sources import Source
from tmm_report.languages import FALLBACK
from tmm_report.problems import Problem, ProblemError
from tmm_report.records import dataclass

FEEDBACK = "feedback"


@dataclass(frozen=True)
class Work:
    """A variant and what was handed in for it."""

    variant: Task
    answers: tuple[Source, ...]


@dataclass(frozen=True)
class Options:
    """How works are marked. `language`: of the feedback, that of each variant where it is None; `own`: of what the
    teacher reads; `answers`: feedback gives the solution away; `others`: the file of the year's solutions."""

    output: Path
    rubric: Rubric
    language: str | None = None
    own: str = FALLBACK
    answers: bool = False
    others: Path | None = None


def work(works: Sequence[Work], *, options: Options) -> Iterator[tuple[int, Digest]]:
    """The digest of each work, once its feedback is written."""
    found = solved_together([_loaded(one, options.rubric) for one in works])
    for index, (one, solved) in enumerate(zip(works, found, strict=True)):
        yield index, _marked(one, solved, options)


def _loaded(one: Work, rubric: Rubric) -> Variant | ProblemError:
    """The variant of a work. Nothing is drawn in it unless the rubric asks for what is read off drawings: that takes a
    third of solving."""
    variant = loaded(one.variant)
    if isinstance(variant, ProblemError) or variant.lever is None or rubric.asks_of_plans:
        return variant
    positions = replace(variant.lever.positions, plans=(), force_plan=())
    return replace(variant, lever=replace(variant.lever, positions=positions))


def _marked(one: Work, solved: Results | ProblemError, options: Options) -> Digest:
    if isinstance(solved, ProblemError):
        told = options.language or solved.language or options.own
        return failed(one.variant.id, solved.problems, Translator(told))
    try:
        return _handed(one, solved, options)
    except OSError as error:
        return Digest(one.variant.id, failed=(f"{options.output}: {error.strerror}",))


def _handed(one: Work, results: Results, options: Options) -> Digest:
    """Raises OSError where the feedback cannot be written."""
    asked = expected(results)
    answers = _answers(one, results, asked, options.rubric)
    whose = year.load(options.others, asked) if options.others is not None else None
    marked = grade(results, answers, options.rubric, asked, whose)
    tr = _translator(results, options.language)
    page = feedback(
        marked, tr, answers=options.answers, limit=options.rubric.limit_of, reading=options.rubric.reading
    )
    write(options.output / FEEDBACK, {f"{one.variant.id}.html": page})
    found = digest(marked)
    if answers.columns or not answers.notes:
        return found
    return replace(found, failed=_texts(answers.notes, Translator(options.own)))


def _answers(one: Work, results: Results, asked: Expected, rubric: Rubric) -> Answers:
    files: list[tuple[str, bytes]] = []
    unread: list[Problem] = []
    for source in one.answers:
        try:
            files.append((source.label, source.read()))
        except ProblemError as error:
            unread += error.problems
    answers = read(files, one.variant.id, asked, reversed_reactions(results), rubric.asks)
    return replace(answers, notes=(*unread, *answers.notes))


def _translator(results: Results, language: str | None) -> Translator:
    return _tr(translator(results.variant, language))


@lru_cache(maxsize=16)
def _tr(tr: Translator) -> Translator:
    """One of equal ones: what is remembered by it is found sooner."""
    return tr


def failed(id: str, problems: Sequence[Problem], tr: Translator) -> Digest:
    """A work that cannot be marked."""
    return Digest(id, failed=_texts(problems, tr))


def _texts(problems: Sequence[Problem], tr: Translator) -> tuple[str, ...]:
    return tuple(problem.text(tr.gettext) for problem in problems[:5])
