"""What the journal keeps of a variant: one small record, plain data, from which all summaries are written.

    {"key": …, "id": "ivanov", "status": "done", "numbers": {"H_B": [0.2, "m"]}, "files": {"note.html": 9}}

Mistakes stand in it as message ids with their values, so that they are told in the language of who reads them.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from tmm_report.commands.batch.inputs import Task
from tmm_report.course import LeverFound, Results
from tmm_report.i18n import Translator
from tmm_report.mechanics.lever.cycle import larger
from tmm_report.problems import N_, Message, Problem, in_language
from tmm_report.quantity.text import Amount, Typed
from tmm_report.running.journal import Record

DONE, CHECK, WRONG, LOST = "done", "check", "wrong", "lost"
"""Written; written though a check failed; not solved, as the variant is wrong; without a result."""
STATUSES = (DONE, CHECK, WRONG, LOST)
TITLE = ("student", "group", "variant", "topic")
LEAST = 20  # mistakes kept of a variant: a file may have thousands
Number = tuple[str, float, str]


def failed(
    task: Task, status: str, problems: Iterable[Problem], trace: str = "", language: str = ""
) -> Record:
    """Of a variant without an output. `trace`: of an error that nobody had foreseen; `language`: that it states."""
    more = {"trace": trace, "language": language}
    return _record(task, status, problems) | {name: text for name, text in more.items() if text}


def finished(
    task: Task,
    results: Results,
    warned: Iterable[Problem],
    good: bool,
    files: Mapping[str, bytes],
    tr: Translator,
) -> Record:
    """Of a variant that was solved and written. `warned`: what its checks say; `tr`: of its note."""
    title, lever = results.variant.title, results.lever
    problems = [replace(problem, file=task.label) for problem in warned]
    return _record(task, DONE if good else CHECK, problems) | {
        **{
            name: text
            for name in TITLE
            if (text := " ".join(in_language(getattr(title, name), tr.gettext).split()))
        },
        "language": results.variant.language,
        **({"formula": lever.structure.formula} if lever is not None else {}),
        "numbers": {key: [value, unit] for key, value, unit in _numbers(results) if math.isfinite(value)},
        "files": {name: len(content) for name, content in sorted(files.items())},
    }


def _record(task: Task, status: str, problems: Iterable[Problem]) -> Record:
    """The label is kept where mistakes name it."""
    told = [_as_data(problem) for problem, _ in zip(problems, range(LEAST), strict=False)]
    named = {"label": task.label, "problems": told} if told else {}
    return {"key": task.key, "id": task.id, "status": status, **named}


def _numbers(results: Results) -> Iterator[Number]:
    """The main numbers: key, value, unit."""
    if results.lever is not None:
        yield from _of_lever(results.lever)
    if results.drive is not None:
        yield "drive_u", results.drive.ratio, ""


def _of_lever(lever: LeverFound) -> Iterator[Number]:
    for travel in lever.kinematics.travels:
        slider = travel.output.kind == "slider"
        yield f"H_{travel.output.name}", float(travel.stroke), "m" if slider else "rad"
    forces = lever.kinetostatics
    if forces is not None:
        if forces.bounded:
            yield "M_bal", float(larger(forces.extremes).value), "N·m"
        yield "disagreement", float(max(forces.worst_lever, forces.worst_power)), ""


def holds(record: Record, task: Task, output: Path) -> bool:
    """Whether a record tells all of a task, and its files stand there whole."""
    done = record["key"] == task.key and record.get("status") in (DONE, CHECK, WRONG)
    if not done or record.get("label", task.label) != task.label:
        return False
    folder = output / record["id"]
    try:
        return all((folder / name).stat().st_size == size for name, size in record.get("files", {}).items())
    except OSError:
        return False


# ---------------------------------------------------------------- mistakes as data


def problems(record: Record) -> list[Problem]:
    """The mistakes that a record tells."""
    return [_of_data(data) for data in record.get("problems", ())]


def _as_data(problem: Problem) -> dict[str, Any]:
    place = {"file": problem.file, "line": problem.line, "column": problem.column}
    return {
        "wrong": _plain(problem.wrong),
        **({"right": _plain(problem.right)} if problem.right is not None else {}),
        **({"path": [str(part) for part in problem.path]} if problem.path else {}),
        **({"doubt": True} if problem.doubt else {}),
        **{name: value for name, value in place.items() if value not in (None, "")},
    }


def _plain(value: Any) -> Any:
    """A message as [id, values]; numbers as they are, what stands with units by its parts; all else as text."""
    if isinstance(value, Message):
        return [value.text, {key: _plain(item) for key, item in value.values.items()}]
    if isinstance(value, Amount):
        return {"amount": [value.value, value.digits, value.unit]}
    if isinstance(value, Typed):
        return {"typed": value.written}
    return value if isinstance(value, int | float | str) and not hasattr(value, "__html__") else str(value)


def _of_data(data: Mapping[str, Any]) -> Problem:
    right = data.get("right")
    return Problem(
        _message(data["wrong"]),
        None if right is None else _message(right),
        tuple(data.get("path", ())),
        data.get("file", ""),
        data.get("line"),
        data.get("column"),
        data.get("doubt", False),
    )


def _message(data: Any) -> Message:
    text, values = data
    return Message(text, {k: _value(v) for k, v in values.items()})


def _value(data: Any) -> Any:
    if isinstance(data, dict):
        return Amount(*data["amount"]) if "amount" in data else Typed(data["typed"])
    return _message(data) if isinstance(data, list) else data


WHY = {
    "died": N_("the process that solved it died, twice"),
    "time": N_("not solved within %(seconds)g s"),
    "memory": N_("it asks for more memory than there is"),
    "error": N_("an error of the program: %(error)s"),
    "unwritable": N_("its folder cannot be written: %(reason)s"),
    "foreign": N_("its folder cannot be written: %(place)s is not of the batch"),
}
ELSEWHERE = Message(N_("move it away, or name another folder for the output"))


def why(kind: str, **values: object) -> Message:
    """Why a variant has no result."""
    return Message(WHY[kind], values)
