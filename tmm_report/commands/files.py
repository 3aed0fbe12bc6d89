"""From results to files in a folder: each format asked for, written whole or not at all."""

from __future__ import annotations

import errno
import os
from collections.abc import Mapping
from contextlib import suppress
from hashlib import sha256
from pathlib import Path, PurePosixPath

from tmm_report.commands.talk import failure, unlinked
from tmm_report.course import Depth, Results, Variant
from tmm_report.i18n import Translator
from tmm_report.problems import N_

FORMATS = ("html", "tex", "json", "csv", "png", "dxf", "sheets", "docx")
PICTURED = 26  # positions of plans and force plans whose pictures are made: 13 of each


def translator(variant: Variant, language: str | None = None) -> Translator:
    """The note's language and decimal sign; another language than the variant's brings its own decimal sign."""
    if language is None or language == variant.language:
        return Translator(variant.language, variant.decimal_sign, variant.words)
    return Translator(language)


def render(
    results: Results, fmt: str, language: str | None = None, depth: Depth | None = None
) -> dict[str, bytes]:
    """File name -> content in one of FORMATS. What only one format needs is imported only for it."""
    tr = translator(results.variant, language)
    if fmt == "json":
        from tmm_report.results import as_json

        return {"results.json": as_json(results, tr)}
    if fmt == "csv":
        from tmm_report.results import as_csv

        return {f"tables/{name}": content for name, content in as_csv(results, tr).items()}
    if fmt == "dxf":
        from tmm_report.results import as_dxf

        return as_dxf(results)
    if fmt == "sheets":
        from tmm_report.sheets import render as draw_sheets

        return draw_sheets(results, tr)
    if fmt not in FORMATS:
        raise ValueError(f"format {fmt!r} is none of {', '.join(FORMATS)}")
    if fmt == "png":
        _see_few(results)
    from tmm_report.note import render as make_note

    return make_note(results, fmt, tr, depth)


def for_typst(results: Results, language: str | None = None, depth: Depth | None = None) -> bytes:
    """The note as Typst reads it. Not written beside the others: only the PDF is made of it."""
    from tmm_report.note import render as make_note

    return make_note(results, "typst", translator(results.variant, language), depth)["note.typst"]


def _see_few(results: Results) -> None:
    """A picture takes longer than its drawing in a note. Raises ProblemError."""
    lever = results.lever
    if lever is None:
        return
    plans = len(lever.plans.drawn) + (len(lever.force_plans.drawn) if lever.force_plans else 0)
    if plans > PICTURED:
        text = N_("--format png: polygons in %(count)s positions give too many pictures; at most %(limit)s")
        raise failure(text, count=plans, limit=PICTURED)


def combinations(results: Results, language: str | None = None) -> dict[str, bytes]:
    """All that was judged in a search and why most was rejected, as text: the combinations of teeth of a stage."""
    from tmm_report.results import listings

    found = listings(results, translator(results.variant, language).gettext)
    return {f"tables/{name}.txt": b"\n".join([*map(str.encode, lines), b""]) for name, lines in found}


def write(folder: Path, files: Mapping[str, bytes]) -> list[Path]:
    """Write files into a folder, each whole or not at all; other files there are left alone.

    Everything is first written beside the old files and renamed at the end, so that a full disk leaves the folder as
    it was; what a run that was stopped left beside them goes. No folder under it may be a link, and a file that is one
    is replaced, not followed. A note is put by `whole.put`. Raises OSError.
    """
    waiting: list[tuple[Path, Path]] = []
    try:
        for name, content in files.items():
            target = folder / name
            unlinked(*_between(folder, name))
            target.parent.mkdir(parents=True, exist_ok=True)
            waiting.append((_beside(target), target))
            _written(waiting[-1][0], content)
        while waiting:
            os.replace(*waiting[0])
            waiting.pop(0)
    finally:
        for temporary, _ in waiting:
            with suppress(OSError):
                os.unlink(temporary)
    return [folder / name for name in files]


def _between(folder: Path, name: str) -> list[Path]:
    """The folders in which a file stands, under the folder of the output."""
    return [folder / parent for parent in PurePosixPath(name).parents if parent.name]


def move(staged: Path, folder: Path) -> None:
    """Give the files of a folder within `folder`, all made by now, their places in it. Raises OSError."""
    names = sorted(path.relative_to(staged).as_posix() for path in staged.rglob("*") if path.is_file())
    for name in names:  # before the first is moved
        unlinked(*_between(folder, name))
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        if (folder / name).is_dir():
            raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR), str(folder / name))
    for name in names:
        os.replace(staged / name, folder / name)


def _beside(target: Path) -> Path:
    """Where a file is made: always the same place, so that the next run does away with what is left there."""
    return target.with_name(f".{sha256(os.fsencode(target.name)).hexdigest()[:16]}.part")


def _written(place: Path, content: bytes) -> None:
    """A new file, even where somebody put a link."""
    with suppress(FileNotFoundError):
        os.unlink(place)
    with place.open("xb") as stream:
        stream.write(content)
