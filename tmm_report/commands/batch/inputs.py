"""What a batch is given, as tasks: files, folders, globs and archives of variants, or a template with a table."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from pathlib import Path, PurePosixPath
from typing import TYPE_CHECKING

from tmm_report import __version__
from tmm_report.commands.talk import failure
from tmm_report.problems import N_, Problem, ProblemError
from tmm_report.records import dataclass
from tmm_report.running.journal import digest
from tmm_report.variant.department import Department, beside, is_one

if TYPE_CHECKING:
    from tmm_report.intake.sources import Source

SUFFIXES = (".yaml", ".yml")
OWN = re.compile(r"_*(index(-\d+)?\.html|summary\.csv|journal\.jsonl)", re.I)
"""Files of the batch itself: a variant's folder is never named like one."""


@dataclass(frozen=True)
class Task:
    """One variant: `number` in the order of the input, its folder, how messages name it, its text, its key in the
    journal. `problems`: why there is no text of it. `filled`: the text is a template that was filled in, so that lines
    and columns of it are nobody's. `department`: what stands beside it for all variants."""

    number: int
    id: str
    label: str
    content: bytes
    key: str
    problems: tuple[Problem, ...] = ()
    filled: bool = False
    department: Department | None = None


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
        yield replace(
            task, key=digest(*options, task.id, task.content, told, _text(task)), id=_folder(task.id)
        )


def _text(task: Task) -> bytes:
    return task.department.told if task.department else b""


def _folder(id: str) -> str:
    """The name of a variant's folder: its id, or one that is nobody else's where the batch itself writes that."""
    return f"_{id}" if OWN.fullmatch(id) else id


# ---------------------------------------------------------------- files


def _from_places(places: Sequence[str]) -> Given:
    from tmm_report.intake.sources import sources

    found, refused = sources(places, SUFFIXES)
    stated = {_place(source): source for source in found if is_one(PurePosixPath(source.name).name)}
    found = [source for source in found if source not in stated.values()]
    if not found:
        raise ProblemError(
            refused or failure(N_("there is no variant beside the department's file")).problems
        )

    def department(source: Source) -> Department | None:
        if source.member is None:
            return beside(Path(source.place, source.name))
        own = stated.get(_place(source))
        return Department(own.read(), own.label) if own else None

    def read(number: int, source: Source) -> Task:
        try:
            content = source.read()
            return Task(number, source.id, source.label, content, "", department=department(source))
        except ProblemError as error:
            return Task(number, source.id, source.label, b"", "", tuple(error.problems))

    return Given((read(*one) for one in enumerate(found)), len(found), tuple(refused))


def _place(source: Source) -> tuple[str, str]:
    """The folder of a file, within an archive, too."""
    if source.member is None:
        return "", str(Path(source.place, source.name).parent)
    return source.place, str(PurePosixPath(source.name).parent)


# ---------------------------------------------------------------- a template and a table


def _from_table(places: Sequence[str], table: Path) -> Given:
    from tmm_report.assignments.table import Made, variants_of

    if len(places) != 1:
        raise failure(N_("--table fills in one template; %(count)s are named"), count=len(places))

    def read(number: int, made: Made) -> Task:
        id, label, content = made
        if isinstance(content, ProblemError):
            return Task(number, id, label, b"", "", tuple(content.problems))
        return Task(number, id, label, content, "", filled=True, department=department)

    department = beside(places[0])
    rows = variants_of(Path(places[0]), table)
    return Given((read(*one) for one in enumerate(rows)), None)
