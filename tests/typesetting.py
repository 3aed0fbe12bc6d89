"""Notes as pdflatex sets them, the log and the PDF; and as Typst and LibreOffice do, the PDF."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest
from notes import absent, note, program
from once import once

from tmm_report.commands.by_typst import NoTypst
from tmm_report.commands.by_typst import typeset as typeset_by_typst
from tmm_report.commands.pdf import bare, write

TIMELESS = {"SOURCE_DATE_EPOCH": "0", "FORCE_SOURCE_DATE": "1"}


@once
def typeset(name: str, language: str) -> tuple[str, bytes]:
    """The log of the last run and the PDF."""
    return set_by_tex(note(name, "tex", language))


def set_by_tex(files: dict[str, bytes], whole: bool = False) -> tuple[str, bytes]:
    """The first run, for page numbers, sees empty drawings unless the note is set as a `whole` twice."""
    latex = program("pdflatex")
    with TemporaryDirectory() as place:
        folder = Path(place)
        command, env = (
            [latex, "-no-shell-escape", "-interaction=nonstopmode", "note.tex"],
            os.environ | TIMELESS,
        )
        for run in (files if whole else bare(files), files):
            write(run, folder)
            subprocess.run(command, cwd=folder, env=env, capture_output=True, timeout=300)
        # the log breaks lines at 79 bytes
        log = (folder / "note.log").read_text(encoding="utf-8", errors="replace")
        return re.sub(r"(?<=[^\n]{79})\n", "", log), (folder / "note.pdf").read_bytes()


@once
def by_typst(name: str, language: str) -> bytes:
    """The PDF."""
    return set_by_typst(note(name, "typst", language)["note.typst"])


AS_WIDE = {"Times New Roman", "Liberation Serif", "Tinos", "Nimbus Roman", "TeX Gyre Termes"}


def stand_in(face: str) -> str:
    """The families of what fontconfig takes for a face."""
    return subprocess.run(["fc-match", "-f", "%{family}", face], capture_output=True, text=True).stdout


def set_by_libreoffice(file: bytes) -> bytes:
    """The PDF of a file of Word, where LibreOffice is installed: it is large, and CI goes without."""
    office = shutil.which("soffice") or shutil.which("libreoffice")
    if office is None:
        pytest.skip("LibreOffice is not installed")
    if not set(stand_in("Times New Roman").split(",")) & AS_WIDE:
        pytest.skip("no face as wide as Times New Roman is installed: lines of the contents would not fit")
    with TemporaryDirectory() as place:
        note = Path(place, "note.docx")
        note.write_bytes(file)
        command = [office, "--headless", f"-env:UserInstallation=file://{place}/own", "--convert-to", "pdf"]
        subprocess.run([*command, "--outdir", place, str(note)], capture_output=True, timeout=600, check=True)
        return note.with_suffix(".pdf").read_bytes()


def set_by_typst(source: bytes) -> bytes:
    """The PDF of Typst's wheel, without which the test is skipped, but never in CI."""
    try:
        return typeset_by_typst(source)
    except NoTypst:
        absent("the wheel typst is not installed")
