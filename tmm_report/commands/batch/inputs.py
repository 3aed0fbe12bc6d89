"""What a batch is given, as tasks: files, folders, globs and archives of variants, or a template with a table."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from pathlib import Path

from tmm_report import __version__
from tmm_report.commands.talk import failure
from tmm_report.problems import N_, Problem, ProblemError
from tmm_report.records import dataclass
from tmm_report.running.journal import digest

SUFFIXES = (".yaml", ".yml")
OWN = re.compile(r"_*(index(-\d+)?\.html|summary\.csv|journal\.jsonl)", re.I)
"""Files of the batch itself: a variant's folder is never named like one."""


@dataclass(frozen=True)
class Task:
    """One variant: `number` in the order of the input, its folder, how messages name it, its text, its key in the
    journal. `problems`: why there is no text of it. `filled`: the text is a template that was filled in, so that lines
    and columns of it are nobody's."""

    number: int
    id: str
    label: str
    content: bytes
    key: str
    problems: tuple[Problem, ...] = ()
    filled: bool = False


@dataclass(frozen=True)
class Given:
    """`tasks`: as they are asked for; `count`: of them, None where that is not known; `refused`: places and files that
    are no variants."""

    tasks: Iterator[Task]
    count: int | None
    refused: tuple[Problem, ...] = ()


def inputs(places: Sequence[str], table: Path | None, options: Sequence[str]) -> Given:
    """The tasks of a command line; `options` are what else the output depends on. Raises ProblemError."""
    given = _from_places(places) if table is None else _from_table(places, table)
    return replace(given, tasks=_keyed(given.tasks, (__version__, *options)))


def _keyed(tasks: Iterable[Task], options: Sequence[str]) -> Iterator[Task]:
    """With the key of each; the id is in it, as two variants may be alike."""
    for task in tasks:
        told = "\n".join(problem.text() for problem in task.problems)
        yield replace(task, key=digest(*options, task.id, task.content, told), id=_folder(task.id))


def _folder(id: str) -> str:
    """The name of a variant's folder: its id, or one that is nobody else's where the batch itself writes that."""
    return f"_{id}" if OWN.fullmatch(id) else id


# ---------------------------------------------------------------- files


def _from_places(places: Sequence[str]) -> Given:
    from tmm_report.intake.sources import Source, sources

    found, refused = sources(places, SUFFIXES)
    if not found:
        raise ProblemError(refused)

    def read(number: int, source: Source) -> Task:
        try:
            return Task(number, source.id, source.label, source.read(), "")
        except ProblemError as error:
            return Task(number, source.id, source.label, b"", "", tuple(error.problems))

    return Given((read(*one) for one in enumerate(found)), len(found), tuple(refused))


# ---------------------------------------------------------------- a template and a table


def _from_table(places: Sequence[str], table: Path) -> Given:
    from tmm_report.assignments.table import Made, variants_of

    if len(places) != 1:
        raise failure(N_("--table fills in one template; %(count)s are named"), count=len(places))

    def read(number: int, made: Made) -> Task:
        id, label, content = made
        if isinstance(content, ProblemError):
            return Task(number, id, label, b"", "", tuple(content.problems))
        return Task(number, id, label, content, "", filled=True)

    rows = variants_of(Path(places[0]), table)
    return Given((read(*one) for one in enumerate(rows)), None)
