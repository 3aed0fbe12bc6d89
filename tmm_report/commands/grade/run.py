"""`tmm-report grade`: students' own numbers marked, feedback for them, a gradebook and statistics for the teacher."""

from __future__ import annotations

import tempfile
import unicodedata
from collections.abc import Iterable, Iterator, Sequence
from contextlib import closing
from dataclasses import replace
from functools import partial
from pathlib import Path

from tmm_report.commands.batch.inputs import Task, inputs
from tmm_report.commands.batch.progress import Progress
from tmm_report.commands.batch.run import JOBS, MEMORY, cores, in_lists, sensible
from tmm_report.commands.files import write
from tmm_report.commands.grade.statistics_page import statistics_files
from tmm_report.commands.grade.work import Options, Work, work
from tmm_report.commands.talk import Talk, unwritable, written
from tmm_report.grading import others as year
from tmm_report.grading import rubric as rubrics
from tmm_report.grading.gradebook import gradebook
from tmm_report.grading.model import RIGHT, Digest
from tmm_report.grading.roster import roster as read_roster
from tmm_report.grading.statistics import Statistics, lines, statistics
from tmm_report.i18n import Translator
from tmm_report.intake.sources import Source, sources
from tmm_report.problems import N_, Message, Problem, mistake, shown
from tmm_report.running.pool import Lost, over

ANSWERS = (".yaml", ".yml", ".csv", ".xlsx")
DOUBTFUL = 0.6  # of the points: who has less may have had another's variant
OWN = 0.9  # of the numbers right as such: likewise
TOLD = 20  # works whose mistakes are told on the terminal


def run(
    variants: Sequence[str],
    answers: Sequence[str],
    output: Path,
    language: str | None,
    own: str,
    talk: Talk,
    *,
    rubric: Path | None = None,
    roster: Path | None = None,
    table: Path | None = None,
    title: str = "TMM",
    show: bool = False,
    jobs: int | None = None,
    seconds: float = 60.0,
) -> bool:
    """Whether every work could be marked. Raises ProblemError.

    `variants`, `table`: as of a batch. `answers`: files, folders, patterns or archives; a file, or a folder with
    several, belongs to the variant of the same name. `language`: of the feedback, that of each variant where it is
    None; `own`: of what the teacher reads. `show`: the feedback gives the right numbers.
    """
    asked = rubrics.load(rubric) if rubric is not None else rubrics.Rubric()
    names = read_roster(roster) if roster is not None else {}
    sensible(jobs, seconds)
    given = inputs([*variants], table, ["grade"])
    handed, refused = sources(answers, ANSWERS)
    works, strangers = _paired(list(given.tasks), handed)
    _warn(talk, [*given.refused, *refused, *strangers])
    options = Options(output.absolute(), asked, language, own, show)
    try:
        digests = _marked(works, options, jobs or cores(), seconds, talk)
        found = statistics(digests)
        tr = Translator(own)
        write(output, gradebook(digests, tr, names, title) | statistics_files(found, tr))
    except OSError as error:
        raise unwritable(output, error) from None
    if rubric is not None:
        columns = {name for digest in digests for name in digest.columns}
        _warn(talk, rubrics.unknown(rubrics.unmatched(asked, columns), str(rubric)))
    return _told(digests, found, output, talk)


def _paired(tasks: Sequence[Task], handed: Sequence[Source]) -> tuple[list[Work], list[Problem]]:
    """Each variant with what was handed in for it, and the answers that belong to no variant.

    Whose an answer is, its place says, never its text: nobody can hand in for another.
    """
    by_id: dict[str, list[Source]] = {}
    for source in handed:
        by_id.setdefault(_folded(source.group), []).append(source)
    works = [Work(task, tuple(by_id.pop(_folded(task.id), ()))) for task in tasks]
    right = Message(N_("a file of answers, or its folder, is named like its variant"))
    text = N_("there is no variant %(name)s")
    strangers = [
        replace(mistake(text, right=right, name=shown(source.group)), file=source.label)
        for sources_ in by_id.values()
        for source in sources_
    ]
    return works, strangers


def _folded(name: str) -> str:
    """Names that Windows or macOS would take for one are one."""
    return unicodedata.normalize("NFC", unicodedata.normalize("NFC", name).casefold())


# ---------------------------------------------------------------- marking


def _marked(works: Sequence[Work], options: Options, jobs: int, seconds: float, talk: Talk) -> list[Digest]:
    """The works, in the order of the variants. Those that are mostly wrong are looked at a second time, beside the
    solutions of all variants: whose numbers are these?"""
    progress = Progress(talk, len(works))
    found = dict(_results(works, options, jobs, seconds, progress))
    doubtful = [one for one in works if _is_doubtful(found[one.variant.id])]
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, "solutions.npz")
        if doubtful and year.save([found[one.variant.id] for one in works], file):
            again = replace(options, others=file)
            found |= dict(_results(doubtful, again, jobs, seconds, Progress(talk, len(doubtful))))
    return [found[one.variant.id] for one in works]


def _is_doubtful(digest: Digest) -> bool:
    """Whether a work has few points, or owes them to what follows from other numbers: in another's variant all does."""
    rules = [rule for number, rule in digest.cells.values() if number == number]
    right = sum(rule in RIGHT for rule in rules)
    return bool(rules) and (digest.points < DOUBTFUL * digest.worth or right < OWN * len(rules))


def _results(
    works: Sequence[Work], options: Options, jobs: int, seconds: float, progress: Progress
) -> Iterator[tuple[str, Digest]]:
    """Id and digest of each work, in order of completion."""
    jobs = min(jobs, JOBS)
    do, tr = partial(work, options=options), Translator(options.own)
    with closing(
        over(do, in_lists(works, len(works), jobs), jobs=jobs, seconds=seconds, memory=MEMORY)
    ) as results:
        for one, found in results:
            lost = isinstance(found, Lost)
            yield one.variant.id, _lost(one, found, seconds, tr) if lost else found
            progress.done()


def _lost(one: Work, lost: Lost, seconds: float, tr: Translator) -> Digest:
    texts = {
        "time": N_("marking took more than %(seconds)g s"),
        "memory": N_("marking asked for too much memory"),
    }
    text = texts.get(lost.reason, N_("the process that marked it died"))
    files = ", ".join(source.label for source in one.answers) or one.variant.label
    problem = replace(mistake(text, seconds=seconds), file=files)
    return Digest(one.variant.id, failed=(problem.text(tr.gettext),))


# ---------------------------------------------------------------- what is handed out


def _told(digests: Sequence[Digest], found: Statistics, output: Path, talk: Talk) -> bool:
    """Say what came out; whether every work could be marked."""
    for line in lines(found):
        talk.tell(line)
    bad = [digest for digest in digests if digest.failed]
    for digest in bad[:TOLD]:
        talk.warn(digest.failed[0])
    if len(bad) > TOLD:
        talk.warn(Message(N_("and %(count)s more: see marks.csv"), {"count": len(bad) - TOLD}))
    names = (
        "marks.xlsx",
        "marks.csv",
        "moodle.csv",
        "canvas.csv",
        "gradescope/",
        "feedback/",
        "statistics.html",
    )
    talk.tell(written(*(output / name for name in names)))
    return not bad


def _warn(talk: Talk, problems: Iterable[Problem]) -> None:
    for problem in problems:
        talk.warn(problem)
