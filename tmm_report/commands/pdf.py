"""note.tex -> PDF by pdflatex where there is one, shut off from the rest of the machine."""

from __future__ import annotations

import os
import shutil
import signal
import subprocess
import tempfile
from collections.abc import Mapping
from pathlib import Path

ROOM = b"\\useasboundingbox"
SECONDS = 120


class NoTex(Exception):
    """There is no pdflatex on this machine."""


class TexFailed(Exception):
    """pdflatex stopped; the text is the end of its log."""


def compiled(files: Mapping[str, bytes]) -> dict[str, bytes]:
    """note.pdf of the files of `render(..., "tex")`, and note.log, which says what did not fit.

    Raises NoTex, TexFailed, or OSError where there is no place.

    A student's text is escaped already; still pdflatex runs in an empty folder, may neither read nor write outside
    it, has no shell, and is stopped with all its children when its time is up.
    """
    program = found()
    with tempfile.TemporaryDirectory() as folder:
        command = [program, "-no-shell-escape", "-interaction=nonstopmode", "-halt-on-error", "note.tex"]
        for run in (bare(files), files):  # the second one fills in the page numbers of the contents
            write(run, Path(folder))
            run_alone(command, folder, TexFailed, SHUT)
        return {name: Path(folder, name).read_bytes() for name in ("note.pdf", "note.log")}


def found() -> str:
    """The path of pdflatex. Raises NoTex."""
    program = shutil.which("pdflatex")
    if program is None:
        raise NoTex
    return program


def bare(files: Mapping[str, bytes]) -> dict[str, bytes]:
    """The files with empty drawings of the same room: pages are the same, and six in seven seconds of a run are spent
    on what is drawn."""
    return {name: _emptied(content) if ROOM in content else content for name, content in files.items()}


def _emptied(drawing: bytes) -> bytes:
    before, _, after = drawing.partition(ROOM)
    return before + ROOM + after.partition(b"\n")[0] + b"\n\\end{tikzpicture}\n"


def write(files: Mapping[str, bytes], folder: Path) -> None:
    for name, content in files.items():
        target = folder / name
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_bytes(content)


SHUT = {"openin_any": "p", "openout_any": "p", "SOURCE_DATE_EPOCH": "0", "FORCE_SOURCE_DATE": "1"}


def run_alone(
    command: list[str], folder: str, failed: type[Exception], env: Mapping[str, str] | None = None
) -> str:
    """Run a program in a folder, with no input, in a group of its own; what it says. Raises `failed` with the end of
    that where it stops or takes too long."""
    process = subprocess.Popen(
        command,
        cwd=folder,
        env={**os.environ, **(env or {})},
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        start_new_session=True,  # its own group, so that its children can be stopped with it; nothing on Windows
    )
    try:
        log, _ = process.communicate(timeout=SECONDS)
    except subprocess.TimeoutExpired:
        _kill(process)
        raise failed(f"{Path(command[0]).name} took more than {SECONDS} s") from None
    said = log.decode("utf-8", "replace")
    if process.returncode:
        raise failed(said[-2000:])
    return said


def _kill(process: subprocess.Popen[bytes]) -> None:
    if os.name == "posix":
        os.killpg(process.pid, signal.SIGKILL)
    else:
        process.kill()
    process.wait()
