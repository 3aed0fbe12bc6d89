"""`tmm-report gallery`: a page with the scheme and main numbers of every variant of a folder, as Markdown and SVG.

page, failed = make(variants(), Path("docs/gallery"), Translator("en"))
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

from tmm_report import load, solve
from tmm_report.commands.files import write
from tmm_report.commands.gallery.page import Entry, page, picture
from tmm_report.commands.talk import Talk, failure, unwritable, written
from tmm_report.i18n import Translator
from tmm_report.problems import N_, Message, Problem, ProblemError
from tmm_report.resources import data_root
from tmm_report.variant.department import is_one

PAGE = "README.md"  # shown by sites that show a folder


def run(folder: Path | None, output: Path, language: str, talk: Talk) -> bool:
    """Write the gallery; whether every variant is right. Raises ProblemError."""
    files = _variants(folder)

    def stage(name: str) -> None:
        talk.stage(Message(N_("solving %(file)s"), {"file": name}))

    try:
        made, failed = make(files, output, Translator(language), stage)
    except OSError as error:
        raise unwritable(output, error) from None
    for problem in (problem for entry in failed for problem in entry.problems):
        talk.warn(problem)
    talk.tell(written(made))
    return not failed


def _variants(folder: Path | None) -> list[Path]:
    """The variants of a folder, of which there is one at least. Raises ProblemError."""
    try:
        files = variants(folder)
    except OSError as error:
        raise failure("%(folder)s: %(reason)s", folder=folder, reason=error.strerror) from None
    if not files:
        raise failure(N_("%(folder)s holds no variants: no files *.yaml"), folder=folder)
    return files


def variants(folder: Path | None = None) -> list[Path]:
    """The variants of a folder, by name; by default the ready ones. Raises OSError."""
    folder = data_root() / "variants" if folder is None else folder
    return sorted(file for file in folder.iterdir() if file.suffix == ".yaml" and not is_one(file.name))


def make(
    files: Sequence[Path], folder: Path, tr: Translator, stage: Callable[[str], None] = lambda name: None
) -> tuple[Path, list[Entry]]:
    """Write the gallery of the files into a folder: its page, and the entries with something wrong in them.

    `stage` is told each file's name as its turn comes. Raises OSError where the folder cannot be written.
    """
    entries: list[Entry] = []
    pictures: dict[str, bytes] = {}
    for file in files:
        stage(file.name)
        entries.append(entry(file))
        pictures |= picture(entries[-1], tr)
    write(folder, {PAGE: page(entries, folder, tr), **pictures})
    return folder / PAGE, [one for one in entries if one.problems]


def entry(file: Path) -> Entry:
    """Solve one file."""
    try:
        results = solve(load(file))
    except ProblemError as error:
        return Entry(file, problems=tuple(error.problems))
    lever = results.lever
    gaps = lever.kinematics.gaps if lever and lever.partial else ()
    path = ("mechanism", "links")
    return Entry(
        file, results, tuple(Problem(gap.text, path=(*path, gap.links[0]), file=str(file)) for gap in gaps)
    )
