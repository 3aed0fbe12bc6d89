"""Notes as pdflatex sets them: the log and the PDF."""

from __future__ import annotations

import os
import re
import subprocess
from pathlib import Path
from tempfile import TemporaryDirectory

from notes import note, program
from once import once

TIMELESS = {"SOURCE_DATE_EPOCH": "0", "FORCE_SOURCE_DATE": "1"}


@once
def typeset(name: str, language: str) -> tuple[str, bytes]:
    """The log of the last run and the PDF."""
    return set_by_tex(note(name, "tex", language))


def set_by_tex(files: dict[str, bytes]) -> tuple[str, bytes]:
    latex = program("pdflatex")
    with TemporaryDirectory() as place:
        folder = Path(place)
        for file, content in files.items():
            target = folder / file
            target.parent.mkdir(exist_ok=True)
            target.write_bytes(content)
        command, env = (
            [latex, "-no-shell-escape", "-interaction=nonstopmode", "note.tex"],
            os.environ | TIMELESS,
        )
        for _ in range(2):
            subprocess.run(command, cwd=folder, env=env, capture_output=True, timeout=120)
        # the log breaks lines at 79 bytes
        log = (folder / "note.log").read_text(encoding="utf-8", errors="replace")
        return re.sub(r"(?<=[^\n]{79})\n", "", log), (folder / "note.pdf").read_bytes()
