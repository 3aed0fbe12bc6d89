"""`tmm-report grade --template`: the sheet that students fill in."""

from __future__ import annotations

from pathlib import Path

from tmm_report.backwards import solve
from tmm_report.commands.batch.inputs import Task, inputs
from tmm_report.commands.files import translator, write
from tmm_report.commands.talk import Talk, failure, unwritable, written
from tmm_report.grading import rubric as rubrics
from tmm_report.grading import senses
from tmm_report.grading.expected import expected
from tmm_report.grading.handed_in.template import FORMATS, different, template, whose_line
from tmm_report.grading.marks import closed
from tmm_report.grading.rubric import Rubric
from tmm_report.loading import loads
from tmm_report.problems import N_, Message, ProblemError


def run(
    place: str,
    file: Path,
    language: str | None,
    talk: Talk,
    *,
    rubric: Path | None = None,
    table: Path | None = None,
) -> bool:
    """Write the sheet of the variants at a place: one for all where `file` has a suffix, else one a variant into the
    folder. `language`: of the sheets, that of each variant where it is None. Raises ProblemError."""
    asked = rubrics.load(rubric) if rubric is not None else Rubric()
    suffix = file.suffix.lower()
    if suffix and suffix not in FORMATS:
        raise failure(
            N_("--template: unknown kind %(suffix)s; known: %(known)s"),
            suffix=suffix,
            known=", ".join(FORMATS),
        )
    tasks = inputs([place], table, ["template"]).tasks
    made = {task.id: _of(task, asked, suffix or ".xlsx", language, own=not suffix) for task in tasks}
    files = _named(made, file, suffix, talk)
    folder = file.parent if suffix else file
    try:
        write(folder, files)
    except OSError as error:
        raise unwritable(folder, error) from None
    talk.tell(written(*(folder / name for name in list(files)[:5])))
    return True


def _named(made: dict[str, dict[str, bytes]], file: Path, suffix: str, talk: Talk) -> dict[str, bytes]:
    """File name -> content: of one sheet for all, that of the first variant."""
    if not suffix:
        return {f"{id}{end}": content for id, files in made.items() for end, content in files.items()}
    first = next(iter(made.values()))
    unlike = different({id: b"\0".join(files.values()) for id, files in made.items()})
    if unlike is not None:
        talk.warn(Message(N_("%(what)s; name a folder for a sheet each"), {"what": unlike}))
    return {f"{file.stem}{end}": content for end, content in first.items()}


def _of(task: Task, rubric: Rubric, suffix: str, language: str | None, own: bool) -> dict[str, bytes]:
    """Its files by their endings. `own`: the sheet is this student's alone, and says so."""
    if task.problems:
        raise ProblemError([*task.problems])
    results = solve(loads(task.content, task.label, task.department))
    asked = expected(results)
    tr = translator(results.variant, language)
    title = {key: str(text) for key, text in vars(results.variant.title).items() if text} if own else {}
    worth = rubrics.worth(rubric, asked, closed(results))
    return template(asked, worth, suffix, tr, whose_line(title, tr), senses.lines(results, tr.gettext))
