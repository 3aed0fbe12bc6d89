"""From results to files in a folder: each format asked for, written whole or not at all."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path

from tmm_report.course import Results, Variant
from tmm_report.i18n import Translator

FORMATS = ("html", "tex", "json", "csv", "png")


def translator(variant: Variant, language: str | None = None) -> Translator:
    """The note's language and decimal sign; another language than the variant's brings its own decimal sign."""
    if language is None or language == variant.language:
        return Translator(variant.language, variant.decimal_sign)
    return Translator(language)


def render(results: Results, fmt: str, language: str | None = None) -> dict[str, bytes]:
    """File name -> content in one of FORMATS. What only one format needs is imported only for it."""
    tr = translator(results.variant, language)
    if fmt == "json":
        from tmm_report.results import as_json

        return {"results.json": as_json(results, tr)}
    if fmt == "csv":
        from tmm_report.results import as_csv

        return {f"tables/{name}": content for name, content in as_csv(results, tr).items()}
    if fmt not in FORMATS:
        raise ValueError(f"format {fmt!r} is none of {', '.join(FORMATS)}")
    from tmm_report.note import render as make_note

    return make_note(results, fmt, tr)


def combinations(results: Results, language: str | None = None) -> dict[str, bytes]:
    """All that was judged in a search and why most was rejected, as text: the combinations of teeth of a stage."""
    from tmm_report.results import listings

    found = listings(results, translator(results.variant, language).gettext)
    return {f"tables/{name}.txt": ("\n".join(lines) + "\n").encode() for name, lines in found}


def write(folder: Path, files: Mapping[str, bytes]) -> list[Path]:
    """Write files into a folder, each whole or not at all; other files there are left alone.

    Everything is first written to temporary files beside the old ones and renamed at the end, so that a full disk
    or an interruption leaves the folder as it was. Raises OSError.
    """
    waiting: list[tuple[str, Path]] = []
    try:
        for name, content in files.items():
            target = folder / name
            target.parent.mkdir(parents=True, exist_ok=True)
            handle, temporary = tempfile.mkstemp(dir=target.parent, prefix=".", suffix=".part")
            waiting.append((temporary, target))
            with os.fdopen(handle, "wb") as stream:
                stream.write(content)
        while waiting:
            temporary, target = waiting[0]
            os.chmod(temporary, 0o666 & ~_umask())
            os.replace(temporary, target)
            waiting.pop(0)
    finally:
        for temporary, _ in waiting:
            with suppress(OSError):
                os.unlink(temporary)
    return [folder / name for name in files]


def _umask() -> int:
    """The process's file mode mask: temporary files are private, the finished ones are ordinary."""
    mask = os.umask(0)
    os.umask(mask)
    return mask
