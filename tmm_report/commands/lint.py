"""`tmm-report lint`: the norm control of a note that was made, in its folder or at the end of a solve."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from tmm_report.commands.talk import Talk
from tmm_report.lint.checks import QUICK, look, unseen
from tmm_report.lint.made import Made
from tmm_report.problems import N_, Message


def run(folder: Path, talk: Talk) -> bool:
    """Tell all that is found in the note of a folder; whether nothing is. Raises ProblemError."""
    made = Made.of(folder)
    found = look(made)
    for problem in found.told:
        talk.warn(problem)
    for message in unseen(made):
        talk.tell(message)
    talk.tell(_counted(found.every))
    return not found.every


def _counted(count: int) -> Message:
    if not count:
        return Message(N_("norm control: nothing to mend"))
    return Message(N_("norm control: to mend: %(count)s"), {"count": count})


def after_solve(files: Mapping[str, bytes], folder: Path, talk: Talk) -> None:
    """The quick checks on what a solve has made: how much there is to mend, and how to see it."""
    found = look(Made(files, folder), QUICK)
    if found.every:
        text = N_("norm control: to mend: %(count)s; to see them: tmm-report lint %(folder)s")
        talk.warn(Message(text, {"count": found.every, "folder": folder}))
    else:
        talk.tell(_counted(0))
