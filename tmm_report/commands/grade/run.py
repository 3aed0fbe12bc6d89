"""`tmm-report grade`: students' own numbers marked, feedback for them, a gradebook and statistics for the teacher."""

from __future__ import annotations

import shutil
import tempfile
from collections.abc import Iterable, Iterator, Sequence
from contextlib import closing, contextmanager
from dataclasses import replace
from functools import partial
from pathlib import Path

from tmm_report.commands.batch.inputs import inputs
from tmm_report.commands.batch.progress import Progress
from tmm_report.commands.batch.run import JOBS, MEMORY, cores, in_lists, sensible
from tmm_report.commands.files import move, write
from tmm_report.commands.grade.pairing import paired
from tmm_report.commands.grade.statistics_page import statistics_files
from tmm_report.commands.grade.work import Options, Work, unsolved, work
from tmm_report.commands.talk import UNWRITABLE, Talk, failure, unlinked, unwritable, written
from tmm_report.commands.whole import alone
from tmm_report.grading import rubric as rubrics
from tmm_report.grading.model import RIGHT, Digest
from tmm_report.grading.year import others as year
from tmm_report.grading.year.gradebook import gradebook
from tmm_report.grading.year.overrides import FILE as OVERRIDES
from tmm_report.grading.year.overrides import overrides
from tmm_report.grading.year.roster import roster as read_roster
from tmm_report.grading.year.statistics import Statistics, lines, statistics
from tmm_report.grading.year.words import state_text
from tmm_report.i18n import Translator
from tmm_report.intake.sources import handed
from tmm_report.problems import N_, Message, Problem, mistake, shown
from tmm_report.running.pool import Lost, over

PART = ".tmm-report.part"  # where all is made
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
    tasks = list(given.tasks)
    by_hand = overrides(output / OVERRIDES, [task.id for task in tasks], asked.points)
    found = paired(tasks, handed(answers, ANSWERS), names, by_hand)
    _warn(talk, [*given.refused, *by_hand.problems, *found.problems])
    tr = Translator(own)
    try:
        output.mkdir(parents=True, exist_ok=True)
        with alone(output), _made(output) as part:
            options = Options(part.absolute(), asked, language, own, show)
            digests = _marked(found.works, options, jobs or cores(), seconds, talk)
            _see_written(digests, output)
            about = statistics(digests)
            write(part, gradebook(digests, tr, found.roster, title) | statistics_files(about, tr))
            move(part, output)
    except OSError as error:
        raise unwritable(output, error) from None
    if rubric is not None:
        columns = {name for digest in digests for name in digest.columns}
        _warn(talk, rubrics.unknown(rubrics.unmatched(asked, columns), str(rubric)))
    return _told(digests, about, output, talk) and not by_hand.problems


@contextmanager
def _made(output: Path) -> Iterator[Path]:
    """A folder in the output in which all is made before it takes its place: whatever happens, the old files stand as
    they were or the new ones do. Raises OSError."""
    part = output / PART
    unlinked(part)
    shutil.rmtree(part, ignore_errors=True)  # what a stopped run left
    part.mkdir()
    try:
        yield part
    finally:
        shutil.rmtree(part, ignore_errors=True)


def _see_written(digests: Iterable[Digest], output: Path) -> None:
    """See that every work's feedback was written. Raises ProblemError."""
    for digest in digests:
        if digest.unwritten:
            raise failure(UNWRITABLE, folder=output, reason=shown(digest.unwritten, 300))


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
    do = partial(work, options=options)
    with closing(
        over(do, in_lists(works, len(works), jobs), jobs=jobs, seconds=seconds, memory=MEMORY)
    ) as results:
        for one, found in results:
            lost = isinstance(found, Lost)
            yield one.variant.id, _lost(one, found, seconds, options) if lost else found
            progress.done()


def _lost(one: Work, lost: Lost, seconds: float, options: Options) -> Digest:
    """Raises OSError."""
    texts = {
        "time": N_("marking took more than %(seconds)g s"),
        "memory": N_("marking asked for too much memory"),
    }
    text = texts.get(lost.reason, N_("the process that marked it died"))
    files = ", ".join(source.label for source in one.answers) or one.variant.label
    problem = replace(mistake(text, seconds=seconds), file=files)
    return unsolved(one, [problem], options, Translator(options.language or options.own))


# ---------------------------------------------------------------- what is handed out


def _told(digests: Sequence[Digest], found: Statistics, output: Path, talk: Talk) -> bool:
    """Say what came out; whether every work could be marked."""
    for line in lines(found):
        talk.tell(line)
    bad = [digest for digest in digests if not digest.marked or digest.missed]
    for digest in bad[:TOLD]:
        talk.warn(_why(digest))
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


def _why(digest: Digest) -> Message | str:
    """Why a work has no mark, or a part of it could not be."""
    reason = (*digest.failed, *digest.missed, "")[0]
    if not digest.state:
        return reason
    state = state_text(digest)
    return Message("%(id)s: %(state)s: %(why)s" if reason else "%(id)s: %(state)s", {
        "id": shown(digest.id), "state": state, "why": reason,
    })  # fmt: skip


def _warn(talk: Talk, problems: Iterable[Problem]) -> None:
    for problem in problems:
        talk.warn(problem)
