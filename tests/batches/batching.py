"""What the tests of the batch share: a command that keeps what it says, and variants that differ by their student."""

from __future__ import annotations

import csv
import io
import json
import re
from collections.abc import Iterable, Iterator, Sequence
from contextlib import nullcontext
from pathlib import Path
from typing import Any
from unittest.mock import patch

from notes import VARIANTS

from tmm_report.commands.batch import run as command
from tmm_report.problems import Message, Problem
from tmm_report.running.journal import read
from tmm_report.running.worker import Do

TEXT = (VARIANTS / "crank_rocker.yaml").read_text("utf-8")
_ALL = (VARIANTS / "compressor.yaml").read_text("utf-8")
COMPRESSOR = re.sub(r"(?ms)^(?:drive|flywheel|balancing):.*?(?=^\S)", "", _ALL)
GAP = COMPRESSOR.replace("B: 300 mm, C", "B: 90 mm, C")


class Heard:
    """What the command says."""

    def __init__(self) -> None:
        self.stages: list[str] = []
        self.told: list[str] = []
        self.warned: list[str] = []

    def speak(self, language: str) -> None: ...

    def stage(self, doing: Message) -> None:
        self.stages.append(str(doing))

    def tell(self, line) -> None:
        self.told.append(str(line))

    def warn(self, line) -> None:
        self.warned.append(line.text() if isinstance(line, Problem) else str(line))


def batch(places, output: Path, formats="json", language="en", talk=None, **options) -> bool:
    """In this process; in others where their number is stated."""
    given = ([*map(str, places)], output, formats, language, talk or Heard())
    with nullcontext() if "jobs" in options else patch.object(command, "over", here):
        return command.run(*given, **options)


def here(do: Do, lists: Iterable[Sequence[Any]], **_) -> Iterator[tuple[Any, Any]]:
    """As the pool does it, without processes, each of which takes a second to start."""
    for tasks in lists:
        yield from ((tasks[index], found) for index, found in do(tasks))


def tree(folder: Path) -> dict[str, bytes]:
    files = (file for file in sorted(folder.rglob("*")) if file.is_file())
    return {file.relative_to(folder).as_posix(): file.read_bytes() for file in files}


def statuses(output: Path) -> dict[str, str]:
    return {record["id"]: record["status"] for _, record in read(output / "journal.jsonl")}


def rows(output: Path) -> list[dict[str, str]]:
    return list(csv.DictReader(io.StringIO((output / "summary.csv").read_text("utf-8-sig"))))


def student(name: str, text: str = TEXT) -> str:
    return re.sub(r"(?m)^(\s+student:).*$", lambda found: f"{found[1]} {json.dumps(name)}", text)


def write(folder: Path, **texts: str) -> Path:
    folder.mkdir(exist_ok=True)
    for name, text in texts.items():
        (folder / f"{name}.yaml").write_text(text, encoding="utf-8")
    return folder


def mixed(folder: Path) -> Path:
    """Three good variants, and between them one that cannot be read, one that is too deep, one with a gap."""
    return write(
        folder,
        anna=student("Anna"),
        b_no_link=TEXT.replace("links:", "link:"),
        boris=student("Boris"),
        c_deep="[" * 30_000,
        d_gap=GAP,
        vera=student("Vera"),
    )
