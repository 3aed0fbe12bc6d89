"""What is done with a list of variants, in a process of its own: read, solved together, rendered, written.

Every variant has its folder, which appears whole: it is made in another place and renamed.
"""

from __future__ import annotations

import os
import re
import shutil
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from pathlib import Path

from tmm_report.commands.batch import record
from tmm_report.commands.batch.inputs import Task
from tmm_report.commands.files import render, translator
from tmm_report.commands.solve import summary
from tmm_report.course import Results, Variant
from tmm_report.loading import loads
from tmm_report.problems import Message, Problem, ProblemError, shown
from tmm_report.running.journal import Record
from tmm_report.stack import solve_each
from tmm_report.variant import failed

PARTS = ".parts"  # where folders are made, beside the finished ones
OURS = re.compile(
    r"results\.json|figures|tables|\.DS_Store|desktop\.ini|Thumbs\.db"
    r"|note\.(html|tex|pdf|aux|log|out|toc|fls|fdb_latexmk|synctex\.gz)"
)
"""What may stand in a variant's folder that is taken away: what is written there, what TeX makes of it, and what
systems leave."""


class Foreign(OSError):
    """Where a variant's folder belongs stands what the batch did not make, named by the text: it is not removed."""


def work(
    tasks: Sequence[Task], *, output: Path, formats: Sequence[str], language: str | None
) -> Iterator[tuple[int, Record]]:
    """The record of each task, once its folder is there."""
    solved = solved_together([loaded(task) for task in tasks])
    for index, (task, found) in enumerate(zip(tasks, solved, strict=True)):
        yield index, _done(task, found, output, formats, language)


def loaded(task: Task) -> Variant | ProblemError:
    """The variant of a task, or its mistakes."""
    if task.problems:
        return ProblemError([*task.problems])
    try:
        return loads(task.content, task.label, task.department)
    except ProblemError as error:
        return error


def solved_together(variants: Sequence[Variant | ProblemError]) -> Iterator[Results | ProblemError]:
    """What is found of each, or its mistakes with their places; those that could not be read keep theirs."""
    solved = solve_each([variant for variant in variants if isinstance(variant, Variant)])
    for variant in variants:
        yield variant if isinstance(variant, ProblemError) else _located(next(solved), variant)


def _located(found: Results | ProblemError, variant: Variant) -> Results | ProblemError:
    return failed(found, variant) if isinstance(found, ProblemError) else found


def _done(
    task: Task, found: Results | ProblemError, output: Path, formats: Sequence[str], language: str | None
) -> Record:
    """Write what was found of a variant; what an earlier text of it gave is taken away where this one gives nothing."""
    try:
        if isinstance(found, ProblemError):
            take_away(output, task.id)
            problems = [_placed(problem, task) for problem in found.problems]
            return record.failed(task, record.WRONG, problems, language=found.language)
        return _written(task, found, output, formats, language)
    except Foreign as error:
        problem = Problem(record.why("foreign", place=shown(error, 120)), record.ELSEWHERE, file=task.label)
        return record.failed(task, record.LOST, [problem])
    except OSError as error:
        reason = record.why("unwritable", reason=error.strerror or type(error).__name__)
        return record.failed(task, record.LOST, [Problem(reason, file=task.label)])


def _placed(problem: Problem, task: Task) -> Problem:
    return replace(problem, line=None, column=None) if task.filled else problem


def _written(
    task: Task, results: Results, output: Path, formats: Sequence[str], language: str | None
) -> Record:
    """Raises OSError."""
    files: dict[str, bytes] = {}
    for fmt in formats:
        files |= render(results, fmt, language)
    heard = _Heard()
    tr = translator(results.variant, language)
    good = summary(results, tr, heard)
    _place(output, task.id, files)
    return record.finished(task, results, heard.warned, good, files, tr)


class _Heard:
    """Keeps what the checks of a variant warn of."""

    def __init__(self) -> None:
        self.warned: list[Problem] = []

    def speak(self, language: str) -> None: ...

    def stage(self, doing: Message) -> None: ...

    def tell(self, line: Message | str) -> None: ...

    def warn(self, line: Message | Problem | str) -> None:
        if isinstance(line, str):
            line = Message("%(what)s", {"what": line})
        self.warned.append(line if isinstance(line, Problem) else Problem(line))


# ---------------------------------------------------------------- folders


def _place(output: Path, id: str, files: Mapping[str, bytes]) -> None:
    """The folder of a variant with these files alone, whole or not at all. Raises OSError."""
    part = output / PARTS / f"{id}-{os.getpid()}"
    _clear(part)
    for name, content in files.items():
        target = part / name
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_bytes(content)
    take_away(output, id)
    os.replace(part, output / id)


def take_away(output: Path, id: str) -> None:
    """Remove the folder of a variant: it goes at once, then its files. Raises OSError, Foreign of what is not ours."""
    _see_ours(output, id)
    old = output / PARTS / f"{id}-{os.getpid()}-old"
    _clear(old)
    old.parent.mkdir(exist_ok=True)
    with suppress(FileNotFoundError):
        os.replace(output / id, old)
        _clear(old)


def _see_ours(output: Path, id: str) -> None:
    """Raises Foreign where the folder is a file or a link, or holds what nobody but its owner can make again."""
    folder = output / id
    if folder.is_symlink() or folder.is_file():
        raise Foreign(id)
    if folder.is_dir():
        for name in sorted(entry.name for entry in os.scandir(folder)):
            if not OURS.fullmatch(name):
                raise Foreign(f"{id}/{name}")


def _clear(path: Path) -> None:
    """Remove a folder, a file or a link, if it is there. Raises OSError."""
    if path.is_symlink() or path.is_file():
        path.unlink()
    elif path.exists():
        shutil.rmtree(path)
