"""What the program makes of one text: solved, refused in words, or a finding."""

from __future__ import annotations

import contextlib
import json
import re
import resource
import signal
import time
import traceback
import warnings
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import Any

from tmm_report import render, solve
from tmm_report.commands.solve import summary
from tmm_report.course import doubts
from tmm_report.i18n import Translator
from tmm_report.loading import loads
from tmm_report.problems import Message, Problem, ProblemError

# an example of keys with their values, the same in every language: mass: 2 kg, radius: 30 mm
KEYS = re.compile(r"(?:\w+: (?:-?[\d.,/]+(?: ?[\w*/^%]+)?|\{.*\}|\[.*\])(?:, )?)+")
SECONDS, MEGABYTES = 20.0, 500.0
ROOT = str(Path(__file__).parents[2])


@dataclass(frozen=True)
class Outcome:
    """Of one case: `kind` is solved, refused or the name of an exception; `place`: where it was raised; `words`: texts
    without a translation or with values left out, and what no page should print; `megabytes`: the most of memory that
    the process had; `sound`: whether every check held (exit code 0, else 1);
    `told`: the traceback, or the first reason of a refusal."""

    kind: str
    seconds: float
    megabytes: float
    rendered: bool = False
    place: str = ""
    told: str = ""
    words: tuple[str, ...] = ()
    sound: bool = True

    @property
    def finding(self) -> str:
        """What is wrong, short; empty where nothing is."""
        if self.kind not in ("solved", "refused"):
            return f"{self.kind} {self.place}"
        if self.seconds > SECONDS:
            return "time"
        return "memory" if self.megabytes > MEGABYTES else ""


class TooLong(Exception):
    """The limit of time is over."""


@dataclass(eq=False)
class Said:
    """What a command says, kept (see `commands.talk.Talk`)."""

    lines: list[Message | Problem | str] = field(default_factory=list)
    pages: list[str] = field(default_factory=list)

    def speak(self, language: str) -> None: ...

    def stage(self, doing: Message) -> None: ...

    def tell(self, line: Message | str) -> None:
        self.lines.append(line)

    def warn(self, line: Message | Problem | str) -> None:
        self.lines.append(line)


def tried(text: str, rendered: bool) -> Outcome:
    """Read, solved, written as JSON and, where that is asked for, as a note for paper and for the screen."""
    _forget_peak()
    began, said, kind, place, told, noted, sound = time.process_time(), Said(), "solved", "", "", False, True
    signal.signal(signal.SIGPROF, _stop)
    signal.setitimer(signal.ITIMER_PROF, 1.25 * SECONDS)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            noted, sound = _solved(text, rendered, said)
    except ProblemError as error:
        kind = "refused"
        said.lines += error.problems
        told = next(problem for problem in error.problems if not problem.doubt).wrong.text
    except Exception as error:
        kind, place, told = type(error).__name__, _place(error), traceback.format_exc(limit=-25)
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
    seconds = time.process_time() - began
    words = tuple(sorted({*unsaid(said.lines), *said.pages}))
    return Outcome(kind, seconds, _peak(), noted, place, told, words, sound)


def _stop(*_: Any) -> None:
    raise TooLong


def _solved(text: str, rendered: bool, said: Said) -> tuple[bool, bool]:
    """Whether a note was made, and whether every check held."""
    results = solve(loads(text.encode("utf-8", "surrogatepass"), "v.yaml"))
    said.lines += doubts(results)
    sound = summary(results, Translator("en"), said)
    json.loads(render(results, "json")["results.json"], parse_constant=_refused)
    for form in ("html", "tex") if rendered else ():
        for name, file in render(results, form).items():
            assert not re.search(rb"%\([a-z_]+\)[sdg]|&lt;(?:tmm_report|Markup)", file), (
                "a text without its values"
            )
            if name == f"note.{form}":
                page = file.decode()
                said.pages += odd_words(page) if form == "html" else unbalanced(page)
    return rendered, sound


def odd_words(page: str) -> Iterator[str]:
    """What a program says and no page should: None, nan, inf, null."""
    seen = re.sub(r"<(style|script)\b.*?</\1>|<[^>]*>", " ", page, flags=re.S)
    for found in re.finditer(r"\b(None|nan|NaN|inf|null|undefined)\b", seen):
        around = " ".join(seen[max(0, found.start() - 30) : found.end() + 20].split())
        yield f"on the page: {found[0]} in {around!r}"


def unbalanced(page: str) -> Iterator[str]:
    """Braces and environments of LaTeX that do not close."""
    page = re.sub(r"(?<!\\)((?:\\\\)*)%.*", r"\1", page)
    bare = re.sub(r"\\[\\{}]", "", page)
    if bare.count("{") != bare.count("}"):
        yield f"LaTeX: {bare.count('{')} braces open, {bare.count('}')} close"
    stack: list[str] = []
    for kind, name in re.findall(r"\\(begin|end)\{(\w+\*?)\}", page):
        if kind == "begin":
            stack.append(name)
        elif not stack or stack.pop() != name:
            yield f"LaTeX: \\end{{{name}}} ends nothing"
            return
    if stack:
        yield f"LaTeX: {stack[-1]} does not end"


def _refused(constant: str) -> None:
    raise AssertionError(f"{constant} in results.json")


def _place(error: Exception) -> str:
    """The last line of the program's own that was under way."""
    frames = [f for f in traceback.extract_tb(error.__traceback__) if f.filename.startswith(ROOT)]
    frames = [f for f in frames if "/fuzz/" not in f.filename] or frames
    return f"{frames[-1].filename.removeprefix(ROOT + '/')}:{frames[-1].lineno}" if frames else "?"


# ---------------------------------------------------------------- memory


def _forget_peak() -> None:
    """Let the kernel count the largest memory anew."""
    with contextlib.suppress(OSError):  # else it is that of the process so far
        Path("/proc/self/clear_refs").write_text("5")


def _peak() -> float:
    """MB, of this case where the kernel counts it by itself, else of the process so far."""
    try:
        found = re.search(r"VmHWM:\s+(\d+)", Path("/proc/self/status").read_text())
    except OSError:
        found = None
    kilobytes = int(found[1]) if found else resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return kilobytes / 1024


# ---------------------------------------------------------------- words


@cache
def russian() -> Any:
    return Translator("ru").gettext


def unsaid(lines: list[Message | Problem | str]) -> Iterator[str]:
    """Texts that cannot be printed, have values left out or no words in Russian."""
    for line in lines:
        if isinstance(line, str):
            continue
        shown = line.text(russian()) if isinstance(line, Problem) else line.render(russian())
        if re.search(r"%\([a-z_]+\)", shown) and "%(name)s %s %d" not in shown:
            yield f"values left out: {shown[:200]}"
        wanted = [line] if isinstance(line, Message) else [line.wrong, *([line.right] if line.right else [])]
        for message in (part for one in wanted for part in parts(one)):
            if (
                re.search("[a-z]{3}", re.sub(r"%\(\w+\)", "", message.text))
                and russian()(message.text) == message.text
                and not KEYS.fullmatch(message.text)
            ):
                yield f"no words: {message.text}"


def parts(message: Message) -> Iterator[Message]:
    """A message and those put into it."""
    yield message
    for value in message.values.values():
        if isinstance(value, Message):
            yield from parts(value)
