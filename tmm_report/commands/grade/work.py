"""What is done with some students' works, in a process of its own: variants solved together, answers read and marked,
feedback written."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import field, replace
from functools import lru_cache
from pathlib import Path

from tmm_report.commands.batch.inputs import Task
from tmm_report.commands.batch.work import loaded, solved_together
from tmm_report.commands.files import translator, write
from tmm_report.commands.grade.feedback import feedback
from tmm_report.course import Results, Variant
from tmm_report.grading.expected import expected, reversed_reactions
from tmm_report.grading.handed_in.answers import read
from tmm_report.grading.handed_in.attempts import attempts
from tmm_report.grading.marks import digest, grade
from tmm_report.grading.model import ABSENT, HELD, UNREAD, Answers, Digest, Expected, Marked, Override
from tmm_report.grading.rubric import Rubric
from tmm_report.grading.year import others as year
from tmm_report.i18n import Translator
from tmm_report.intake.sources import Source, Unread
from tmm_report.languages import FALLBACK
from tmm_report.problems import N_, Problem, ProblemError, mistake
from tmm_report.records import dataclass

FEEDBACK = "feedback"


@dataclass(frozen=True)
class Work:
    """A variant and what was handed in for it. `unread`: what of it could not be taken. `about`: what the teacher's
    list says of the student. `override`: his mark set by hand, or what is wrong with it."""

    variant: Task
    answers: tuple[Source, ...]
    unread: tuple[Unread, ...] = ()
    about: Mapping[str, str] = field(default_factory=dict)
    override: Override | Problem | None = None


@dataclass(frozen=True)
class Options:
    """How works are marked. `output`: where feedback is made. `language`: of the feedback, that of each variant where
    it is None; `own`: of what the teacher reads; `answers`: feedback gives the solution away; `others`: the file of the
    year's solutions."""

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
    try:
        if isinstance(solved, ProblemError):
            told = options.language or solved.language or options.own
            return unsolved(one, solved.problems, options, Translator(told))
        return _handed(one, solved, options)
    except OSError as error:
        return Digest(one.variant.id, unwritten=error.strerror or str(error))


@dataclass(frozen=True, eq=False)
class _Try:
    """An attempt as it was read. `unread`: its files that could not be."""

    answers: Answers
    unread: tuple[Problem, ...]


def _handed(one: Work, results: Results, options: Options) -> Digest:
    """Raises OSError where the feedback cannot be written."""
    asked, rubric = expected(results), options.rubric
    tries = [
        _read([one.answers[place] for place in places], one, results, asked, rubric)
        for places in attempts([source.within or source.name for source in one.answers])
    ]
    tr = _translator(results, options.language)
    if not any(some.answers.columns for some in tries):
        return _without(one, results, asked, tries, options, tr)
    whose = year.load(options.others, asked) if options.others is not None else None
    counted, marked = _counted(tries, lambda some: grade(results, some.answers, rubric, asked, whose), rubric)
    missed = [*(unread.problem for unread in one.unread if not unread.other), *tries[counted].unread]
    found = replace(
        digest(_named(marked, one)),
        attempt=counted + 1,
        attempts=len(tries),
        missed=_texts(missed, Translator(options.own)),
    )
    return _given(one, found, _named(marked, one), options, tr)


def _counted(tries: Sequence[_Try], marks: Callable[[_Try], Marked], rubric: Rubric) -> tuple[int, Marked]:
    """Which attempt counts, and its marks: the last in which anything can be read, or the best of these."""
    good = [index for index, some in enumerate(tries) if some.answers.columns]
    if rubric.attempts == "last":
        return good[-1], marks(tries[good[-1]])
    return max(((index, marks(tries[index])) for index in good), key=lambda pair: (pair[1].points, pair[0]))


def _without(
    one: Work, results: Results, asked: Expected, tries: Sequence[_Try], options: Options, tr: Translator
) -> Digest:
    """A work in which there is no answer: nothing was handed in, or it could not be read. What would have been right is
    kept: others may have its numbers."""
    found = digest(_named(grade(results, Answers(one.variant.id, {}), options.rubric, asked), one))
    reasons = [
        *(unread.problem for unread in one.unread),
        *(note for some in tries for note in some.answers.notes),
    ]
    blank = all(unread.empty for unread in one.unread) and len(reasons) == len(one.unread)
    if not reasons and tries:
        reasons = [replace(mistake(N_("no cell is filled in")), file=one.answers[0].label)]
    return _given(
        one,
        replace(found, cells={}, columns={}, points=0.0, causes=(), state=ABSENT if blank else UNREAD),
        nothing(one, tr, dict(vars(results.variant.title)), found.worth),
        options,
        tr,
        reasons,
    )


def _given(
    one: Work,
    found: Digest,
    marked: Marked,
    options: Options,
    tr: Translator,
    reasons: Sequence[Problem] = (),
) -> Digest:
    """The digest with the mark set by hand, once its page is written. Raises OSError."""
    if isinstance(one.override, Override):
        found = replace(found, override=one.override)
    elif one.override is not None:
        found, reasons = replace(found, state=HELD), [one.override]
    page = feedback(
        marked, tr, replace(found, failed=_texts(reasons, tr)),
        answers=options.answers, limit=options.rubric.limit_of, reading=options.rubric.reading,
    )  # fmt: skip
    write(options.output, {f"{FEEDBACK}/{one.variant.id}.html": page})
    return replace(found, failed=_texts(reasons, Translator(options.own)))


def _named(marked: Marked, one: Work) -> Marked:
    """With what the list says of the student, where the variant says nothing."""
    return replace(marked, title={**one.about, **marked.title})


def nothing(one: Work, tr: Translator, title: Mapping[str, object], worth: float) -> Marked:
    """A work of which nothing is known but whose it is."""
    said = {key: str(text) for key, text in title.items() if text}
    empty = Answers(one.variant.id, {})
    return Marked(one.variant.id, {**one.about, **said}, tr.language, empty, {}, (), (), 0.0, worth)


def _read(files: Sequence[Source], one: Work, results: Results, asked: Expected, rubric: Rubric) -> _Try:
    contents: list[tuple[str, bytes]] = []
    unread: list[Problem] = []
    for source in files:
        try:
            contents.append((source.label, source.read()))
        except ProblemError as error:
            unread += error.problems
    lost = tuple(unread)
    answers = read(contents, one.variant.id, asked, reversed_reactions(results), rubric.asks, unread)
    return _Try(replace(answers, notes=(*lost, *answers.notes)), tuple(unread))


def _translator(results: Results, language: str | None) -> Translator:
    return _tr(translator(results.variant, language))


@lru_cache(maxsize=16)
def _tr(tr: Translator) -> Translator:
    """One of equal ones: what is remembered by it is found sooner."""
    return tr


def unsolved(one: Work, problems: Sequence[Problem], options: Options, tr: Translator) -> Digest:
    """A work that cannot be marked, through no fault of what was handed in. Raises OSError."""
    about, worth = one.about, options.rubric.points
    found = Digest(one.variant.id, about.get("student", ""), about.get("group", ""), worth=worth)
    found = replace(found, failed=_texts(problems, Translator(options.own)))
    return _given(one, found, nothing(one, tr, {}, worth), options, tr, problems)


def _texts(problems: Sequence[Problem], tr: Translator) -> tuple[str, ...]:
    return tuple(problem.text(tr.gettext) for problem in problems[:5])
