"""`tmm-report batch`: many variants solved and written up; a run that is stopped goes on where it was."""

from __future__ import annotations

import os
import shutil
from array import array
from collections.abc import Iterable, Iterator, Sequence
from contextlib import closing, suppress
from functools import partial
from pathlib import Path
from typing import Any, TypeVar

from tmm_report.commands.batch import page, record, summary
from tmm_report.commands.batch.inputs import Given, Task, inputs
from tmm_report.commands.batch.progress import Progress
from tmm_report.commands.batch.work import PARTS, Foreign, take_away, work
from tmm_report.commands.solve import chosen
from tmm_report.commands.talk import Talk, failure, unlinked, unwritable, written
from tmm_report.i18n import Translator
from tmm_report.languages import DEFAULT
from tmm_report.problems import N_, Message, Problem
from tmm_report.running.journal import Index, Journal, Record, read, rewrite
from tmm_report.running.pool import Lost, chunked, over

T = TypeVar("T")
JOURNAL = "journal.jsonl"
CHUNK = 32  # variants that a process takes at once, at most
UNCOUNTED = 4  # and of a table, whose end is not known beforehand: thirty rows are to busy every process
SHARE = 8  # lists of variants for each process, at least, so that all end at about one time
MEMORY = 2 << 30  # bytes that a process may ask for
JOBS = 60  # processes: Windows waits for no more at once
TOLD = 20  # variants whose mistakes are told on the terminal


def run(
    places: Sequence[str],
    output: Path,
    formats: str,
    language: str | None,
    talk: Talk,
    *,
    jobs: int | None = None,
    resume: bool = False,
    seconds: float = 60.0,
    cluster: str | None = None,
    table: Path | None = None,
) -> bool:
    """Whether every variant was solved and every check held. Raises ProblemError.

    `jobs`: processes, as many as cores by default. `seconds`: for one variant. `cluster`: the address of a Dask
    scheduler, or "local". `table`: the one place is a template, and each row of the table a variant.
    """
    wanted = sorted(chosen(formats))
    sensible(jobs, seconds)
    given = inputs(places, table, [",".join(wanted), language or ""])
    try:
        _prepare(output, resume)
        do = partial(work, output=output.absolute(), formats=wanted, language=language)
        running = partial(_results, do, jobs=jobs or cores(), seconds=seconds, cluster=cluster)
        with Journal(output / JOURNAL) as journal:
            shutil.rmtree(output / PARTS, ignore_errors=True)  # what a stopped run left half done
            batch = _Batch(given, output, journal, Index(output / JOURNAL), seconds, talk)
            batch.go(running)
        return _finish(output, batch, given.refused, language, talk)
    except BlockingIOError:
        raise failure(N_("another run is writing into %(folder)s"), folder=output) from None
    except OSError as error:
        raise unwritable(output, error) from None


def cores() -> int:
    """Processors that this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def sensible(jobs: int | None, seconds: float) -> None:
    """Raises ProblemError."""
    if jobs is not None and jobs < 1:
        raise failure(N_("--jobs: %(jobs)s processes do nothing; 1 at least"), jobs=jobs)
    if not seconds > 0:
        raise failure(N_("--seconds: no variant is solved in %(seconds)g s; more than 0"), seconds=seconds)


def _prepare(output: Path, resume: bool) -> None:
    """Make the folder, or see that it is meant. Raises ProblemError, OSError."""
    output.mkdir(parents=True, exist_ok=True)
    unlinked(output / JOURNAL, output / PARTS)
    if not resume and _begun(output / JOURNAL):
        text = N_("%(folder)s holds a run already; --resume goes on with it, or name another folder")
        raise failure(text, folder=output)


def _begun(journal: Path) -> bool:
    return journal.exists() and journal.stat().st_size > 0


def _results(
    do: Any, tasks: Iterator[Task], count: int | None, *, jobs: int, seconds: float, cluster: str | None
) -> Iterator[tuple[Task, Record | Lost]]:
    """Each task with what was found, in order of completion."""
    jobs = min(jobs, JOBS)
    lists = in_lists(tasks, count, jobs)
    if cluster is None:
        return over(do, lists, jobs=jobs, seconds=seconds, memory=MEMORY)
    from tmm_report.running.cluster import over as over_cluster

    return over_cluster(do, lists, address=cluster, jobs=jobs, seconds=seconds, memory=MEMORY)


def in_lists(tasks: Iterable[T], count: int | None, jobs: int) -> Iterator[list[T]]:
    """The tasks in the lists that processes take; `count`: of them, None where that is not known."""
    return chunked(tasks, UNCOUNTED if count is None else max(1, min(CHUNK, count // (SHARE * jobs))))


class _Batch:
    """One run over its tasks. `order`: where the record of each stands in the journal, by the task's number."""

    def __init__(
        self, given: Given, output: Path, journal: Journal, index: Index, seconds: float, talk: Talk
    ):
        self.given, self.output, self.journal, self.index = given, output, journal, index
        self.seconds, self.talk = seconds, talk
        self.order = array("q")
        self.progress = Progress(talk, given.count)

    def go(self, running: Any) -> None:
        """Do what is not done. Stopped by Ctrl-C, it says how to go on, and passes it on."""
        self.talk.stage(self.progress.line(0.0))  # until the first is done, which takes processes to start
        try:
            with closing(running(self._waiting(), self.given.count)) as results:
                for task, found in results:
                    self._keep(task, self._lost(task, found) if isinstance(found, Lost) else found)
                    self.progress.done()
        except KeyboardInterrupt:
            text = N_("stopped; variants done: %(done)s. --resume goes on from here")
            self.talk.warn(Message(text, {"done": self.progress.ready}))
            raise

    def _waiting(self) -> Iterator[Task]:
        """The tasks that are still to be done, as they are asked for."""
        for task in self.given.tasks:
            self.order.append(-1)
            if task.problems:
                self._take_away(task)
                self._keep(task, record.failed(task, record.WRONG, task.problems))
                self.progress.done()
            elif (place := self._known(task)) is not None:
                self.order[task.number] = place
                self.progress.kept()
            else:
                yield task

    def _known(self, task: Task) -> int | None:
        place = self.index.find(task.key)
        known = place is not None and record.holds(self.journal.at(place), task, self.output)
        return place if known else None

    def _keep(self, task: Task, found: Record) -> None:
        self.order[task.number] = self.journal.add(found)

    def _lost(self, task: Task, lost: Lost) -> Record:
        """What is told of a variant without a result; what an earlier run made of it goes."""
        self._take_away(task)
        error = lost.trace.strip().rpartition("\n")[2]
        why = record.why(lost.reason, seconds=self.seconds, error=error)
        return record.failed(task, record.LOST, [Problem(why, file=task.label)], lost.trace)

    def _take_away(self, task: Task) -> None:
        with suppress(Foreign):
            take_away(self.output, task.id)


# ---------------------------------------------------------------- what came of it


def _finish(
    output: Path, batch: _Batch, refused: Sequence[Problem], language: str | None, talk: Talk
) -> bool:
    """Write the summaries, and tell of them. Raises OSError."""
    journal = output / JOURNAL
    rewrite(journal, batch.order)
    shutil.rmtree(output / PARTS, ignore_errors=True)
    tr = Translator(language or _language(journal))
    talk.speak(tr.language)
    counts = summary.counts(journal)
    files = summary.write(journal, output, tr), page.write(journal, output, counts, refused, tr)
    _tell(journal, counts, refused, files[0], talk)
    talk.tell(written(*files))
    return not refused and sum(counts.values()) == counts[record.DONE]


def _language(journal: Path) -> str:
    """The language of the summaries, and of what is told: that of the first variant that states one."""
    return next((found["language"] for _, found in read(journal) if "language" in found), DEFAULT)


def _tell(journal: Path, counts: dict[str, int], refused: Sequence[Problem], table: Path, talk: Talk) -> None:
    for problem in _first(journal, refused):
        talk.warn(problem)
    bad = sum(counts.values()) - counts[record.DONE] + len(refused)
    if bad > TOLD:
        talk.warn(Message(N_("and %(count)s more: see %(file)s"), {"count": bad - TOLD, "file": table}))
    text = N_(
        "variants: %(all)s; done: %(done)s; with a failed check: %(check)s; not solved: %(wrong)s; "
        "without a result: %(lost)s"
    )
    talk.tell(Message(text, {"all": sum(counts.values()), **counts}))


def _first(journal: Path, refused: Sequence[Problem]) -> Iterator[Problem]:
    """The first mistake of each of the first variants that have one."""
    told = [*refused[:TOLD]]
    yield from told
    for _, found in read(journal):
        if len(told) == TOLD:
            return
        if found["status"] != record.DONE:
            told += record.problems(found)[:1]
            yield from record.problems(found)[:1]
