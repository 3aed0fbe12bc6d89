"""What was made: the files of a note, read as a stranger's, and where in them something stands."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from functools import cached_property
from pathlib import Path

from tmm_report.lint import page, source
from tmm_report.lint.known import Known
from tmm_report.problems import N_, Message, Problem, ProblemError, mistake, shown
from tmm_report.yamlread import file_label, opened

LIMITS = {  # bytes
    "note.html": 20_000_000,
    "note.tex": 10_000_000,
    "note.log": 10_000_000,
    "note.pdf": 100_000_000,
    "note-print.pdf": 100_000_000,
    "results.json": 20_000_000,
}
NOTES = ("note.html", "note.tex")
PDFS = ("note.pdf", "note-print.pdf")  # as LaTeX and as the browser set it


class Made:
    """The files of a note by their names, those that are there; `folder`: where they stand, for messages and for
    programs that read a file themselves."""

    def __init__(self, files: Mapping[str, bytes], folder: Path):
        self.files, self.folder = files, folder

    @classmethod
    def of(cls, folder: Path) -> Made:
        """The note in a folder. Raises ProblemError for a folder without one, or files that are none of a note's."""
        if not folder.is_dir():
            raise ProblemError([mistake(N_("%(folder)s is not a folder"), folder=file_label(folder))])
        files = {
            name: opened(folder / name, file_label(folder / name), limit)
            for name, limit in LIMITS.items()
            if (folder / name).exists() or (folder / name).is_symlink()
        }
        if not files.keys() & {*NOTES}:
            right = Message(N_("name the folder that `tmm-report solve` wrote"))
            text = N_("there is neither note.html nor note.tex in %(folder)s")
            raise ProblemError([mistake(text, (), right, folder=file_label(folder))])
        made = cls(files, folder)
        made.page, made.source, made.known  # noqa: B018 - what cannot be read is told before anything else
        return made

    @cached_property
    def html(self) -> str | None:
        return self._text("note.html")

    @cached_property
    def tex(self) -> str | None:
        return self._text("note.tex")

    @cached_property
    def log(self) -> str | None:
        return self._text("note.log")

    def _text(self, name: str) -> str | None:
        return self.files[name].decode("utf-8", "replace") if name in self.files else None

    @cached_property
    def page(self) -> page.Page | None:
        """What the HTML says. Raises ProblemError."""
        if self.html is None:
            return None
        try:
            return page.read(self.html)
        except page.Unread as error:
            right = Message(N_("make the note anew"))
            text = N_("this is not a note written by this program: %(reason)s")
            wrong = Message(text, {"reason": error.reason})
            raise ProblemError([Problem(wrong, right, (), self._label("note.html"), error.line)]) from None

    @cached_property
    def source(self) -> source.Source | None:
        """What the LaTeX says."""
        return None if self.tex is None else source.read(self.tex)

    @cached_property
    def known(self) -> Known | None:
        """What results.json says. Raises ProblemError."""
        if "results.json" not in self.files:
            return None
        try:
            return Known.of(json.loads(self.files["results.json"]))
        except (ValueError, LookupError, TypeError, RecursionError):
            wrong = Message(N_("this is not a results.json of this program"))
            right = Message(N_("make it anew: solve with --format html,tex,json"))
            raise ProblemError([Problem(wrong, right, (), self._label("results.json"))]) from None

    def _label(self, name: str) -> str:
        return file_label(self.folder / name)

    # --- where something stands ---

    def found(
        self, check: str, name: str, line: int | None, wrong: Message, right: Message | None = None
    ) -> Problem:
        """What a check has found, at a line of a file; what the note says in it is a stranger's text."""
        told = {key: shown(one, 80) if isinstance(one, str) else one for key, one in wrong.values.items()}
        return Problem(Message(wrong.text, told), right, (check,), self._label(name), line)

    def line(self, anchor: str) -> int | None:
        """The line of the HTML at which an anchor stands."""
        return self._lines.get(anchor)

    @cached_property
    def _lines(self) -> Mapping[str, int]:
        """Of every anchor of the HTML, found once: there may be as many findings as anchors."""
        found, line, at = dict[str, int](), 1, 0
        for one in re.finditer(r' id="([^"]*)"', self.html or ""):
            line, at = line + (self.html or "").count("\n", at, one.start()), one.start()
            found.setdefault(one[1], line)
        return found


def line_at(text: str, at: int) -> int:
    return 1 + text.count("\n", 0, at)


NUMBERED = re.compile(r"(figure|table|formula|section|appendix)(?:-(appendix|drawings))?([\d.]+)")


def series(anchor: str) -> tuple[str, int] | None:
    """In which row of numbers an anchor stands, and its number there: "formula3.12" is the twelfth of "formula3"."""
    match = NUMBERED.fullmatch(anchor)
    if match is None:
        return None
    *before, last = match[3].split(".")
    return (f"{match[1]}-{match[2] or ''}{'.'.join(before)}", int(last)) if last.isdecimal() else None
