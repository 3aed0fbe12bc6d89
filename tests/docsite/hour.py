"""The first hour of docs/hour.md, typed: blocks `console`, `diff` (an edit that is saved), `pycon`, in their order."""

from __future__ import annotations

import code
import contextlib
import io
import os
import re
import shlex
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

SECONDS = 240
_WAITS = re.compile(r"Ctrl-C \w+$", re.M)  # the last line of a round
_BLOCK = re.compile(r"^```(console|diff|pycon)\n(.*?)^```$", re.M | re.S)
_PASSING = re.compile(r"^\d+\.\d\d(?= [sс];)|\d(?:[.,]\d)?·10⁻¹\d", re.M)  # seconds, and what rounding leaves


class Hour:
    """A folder in which the page is followed; each block gives the text that the program answers there."""

    def __init__(self, folder: Path, lang: str = "C"):
        self.folder = folder
        self.env = os.environ | {
            "LANG": lang,
            "LC_ALL": lang,
            "PYTHONPATH": os.pathsep.join(sys.path),
            "NO_COLOR": "1",
        }
        self.watch: subprocess.Popen[bytes] | None = None
        self.log, self.read, self.rounds = folder / "log", 0, 0
        self.prompt = code.InteractiveConsole()

    def followed(self, page: str) -> Iterator[tuple[str, str, str]]:
        """(kind, block as it stands, block as it is answered)."""
        try:
            for found in _BLOCK.finditer(page):
                kind, text = found.groups()
                yield kind, timeless(text), timeless(getattr(self, f"_{kind}")(text))
        finally:
            self._end()

    def _console(self, text: str) -> str:
        typed = [line[2:] for line in text.splitlines() if line.startswith("$ ")]
        return "".join(f"$ {line}\n{self._typed(line)}" for line in typed) if typed else self._round()

    def _typed(self, line: str) -> str:
        self._end()
        command = [sys.executable, "-m", "tmm_report", *shlex.split(line)[1:]]
        if "--watch" in command:
            self.rounds = self.read = 0
            with self.log.open("wb") as log:
                self.watch = subprocess.Popen(command, cwd=self.folder, env=self.env, stdout=log, stderr=log)
            return self._round()
        done = subprocess.run(
            command, cwd=self.folder, env=self.env, capture_output=True, text=True, timeout=SECONDS
        )
        return done.stdout + done.stderr

    def _round(self) -> str:
        """What the watch says until it waits again."""
        assert self.watch is not None
        self.rounds += 1
        end = time.monotonic() + SECONDS
        while len(_WAITS.findall(self.log.read_text("utf-8"))) < self.rounds:
            assert time.monotonic() < end and self.watch.poll() is None, self.log.read_text("utf-8")
            time.sleep(0.05)
        said = self.log.read_text("utf-8")
        found, self.read = said[self.read :], len(said)
        return found

    def _diff(self, text: str) -> str:
        lines = text.splitlines()
        place = self.folder / "my.yaml"
        kept = place.read_text("utf-8")
        for old, new in zip(lines[::2], lines[1::2], strict=True):
            assert old[0] == "-" and new[0] == "+" and f"\n{old[1:]}\n" in kept, old
            kept = kept.replace(f"\n{old[1:]}\n", f"\n{new[1:]}\n", 1)
        place.write_text(kept, encoding="utf-8")
        return text

    def _pycon(self, text: str) -> str:
        self._end()
        typed = [line[4:] for line in text.splitlines() if line.startswith(">>> ")]
        said = io.StringIO()
        with (
            contextlib.chdir(self.folder),
            contextlib.redirect_stdout(said),
            contextlib.redirect_stderr(said),
        ):
            for line in typed:
                print(f">>> {line}")
                self.prompt.push(line)
        return said.getvalue()

    def _end(self) -> None:
        if self.watch is not None:
            self.watch.send_signal(signal.SIGINT)
            self.watch.wait(SECONDS)
            self.watch = None


def timeless(text: str) -> str:
    """Without what differs from machine to machine."""
    return _PASSING.sub("…", text)
