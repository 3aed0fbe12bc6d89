"""Each variant with what was handed in for it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from tmm_report import yamlread
from tmm_report.commands.batch.inputs import Task
from tmm_report.commands.grade.work import Work
from tmm_report.grading.year.gradebook import Roster
from tmm_report.grading.year.overrides import Overrides
from tmm_report.grading.year.whose import folded, number, whose
from tmm_report.intake.sources import Handed, Source, Unread
from tmm_report.problems import N_, Message, Problem, ProblemError, mistake, shown
from tmm_report.records import dataclass

_ONE = Message(N_("keep one of them"))


@dataclass(frozen=True)
class Paired:
    """`roster`: with the numbers of Moodle's own folders, where the list has none. `problems`: to be told at once."""

    works: list[Work]
    roster: Roster
    problems: list[Problem]


def paired(tasks: Sequence[Task], handed: Handed, roster: Roster, by_hand: Overrides) -> Paired:
    """Each variant with what was handed in for it; what belongs to no variant is told."""
    owners = [*(one.owner for one in handed.sources), *(one.owner for one in handed.unread)]
    ids = {task.id for task in tasks}
    known, doubts = whose(owners, ids, roster, lambda: _names(tasks, roster))
    answers: dict[str, list[Source]] = {}
    for source in handed.sources:
        answers.setdefault(known.get(source.owner, ""), []).append(source)
    unread: dict[str, list[Unread]] = {}
    for one in handed.unread:
        unread.setdefault(known.get(one.owner, ""), []).append(one)
    problems = [one.problem for one in handed.refused]
    problems += [*_others(answers.pop("", []), unread.pop("", []), doubts)]
    if handed.typed:
        text = N_("texts typed into Moodle are passed over: %(count)s; numbers are read from files alone")
        problems.append(Problem(Message(text, {"count": handed.typed})))
    lists = {folded(id): about for id, about in roster.items()}
    works = [
        _work(task, answers.get(task.id, []), unread.get(task.id, []), handed, lists, by_hand)
        for task in tasks
    ]
    return Paired(works, _numbered(roster, known), problems)


def _work(
    task: Task,
    answers: list[Source],
    unread: list[Unread],
    handed: Handed,
    roster: Roster,
    by_hand: Overrides,
) -> Work:
    if twice := _twice(answers):
        unread, answers = [*unread, Unread(task.id, twice)], []
    if not answers and not unread:
        unread = handed.refused  # where it might have been
    about = roster.get(folded(task.id), {})
    title = {"student": about.get("name", ""), "group": about.get("section", "")}
    return Work(
        task,
        tuple(answers),
        tuple(unread),
        {key: text for key, text in title.items() if text},
        by_hand.marks.get(task.id) or by_hand.held.get(task.id),
    )


def _twice(answers: Sequence[Source]) -> Problem | None:
    """Whether a work of one name lies in two places: which of them is meant, nobody knows."""
    groups: dict[str, set[str]] = {}
    for source in answers:
        groups.setdefault(folded(source.owner), set()).add(source.group)
    if all(len(some) == 1 for some in groups.values()):
        return None
    names = ", ".join(shown(source.label, 200) for source in answers[:5])
    return mistake(N_("handed in at two places: %(names)s"), right=_ONE, names=names)


def _others(
    answers: Sequence[Source], unread: Sequence[Unread], doubts: Mapping[str, Problem]
) -> Iterator[Problem]:
    """What belongs to no variant, a line for each name: why, where it might."""
    right = Message(N_("a file of answers, or its folder, is named like its variant"))
    told: set[str] = set()
    for source in answers:
        if source.group not in told:
            told.add(source.group)
            stranger = mistake(N_("there is no variant %(name)s"), right=right, name=shown(source.owner))
            yield replace(doubts.get(source.owner, stranger), file=source.label)
    yield from (one.problem for one in unread if not one.other)


def _names(tasks: Sequence[Task], roster: Roster) -> dict[str, str]:
    """The students' names by id: of the list, else of the variants."""
    lists = {folded(id): about.get("name", "") for id, about in roster.items()}
    return {task.id: lists.get(folded(task.id), "") or _titled(task) for task in tasks}


def _titled(task: Task) -> str:
    """The student whom a variant names; of one named by languages the name given first, as everywhere in grading."""
    try:
        data = yamlread.loads(task.content, task.label).data
    except ProblemError:
        return ""
    title = data.get("title") if isinstance(data, dict) else None
    name = title.get("student") if isinstance(title, dict) else None
    if isinstance(name, dict):
        name = next(iter(name.values()), None)
    return name if isinstance(name, str) else ""


def _numbered(roster: Roster, known: Mapping[str, str]) -> Roster:
    """The list with Moodle's numbers, of whom it has none."""
    found = {id: dict(about) for id, about in roster.items()}
    for owner, id in known.items():
        if number(owner):
            found.setdefault(id, {}).setdefault("moodle_id", number(owner))
    return found
