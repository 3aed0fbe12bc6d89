"""The terminal: what the commands say, in the user's language; their mistakes become exit codes."""

from __future__ import annotations

import locale
import os
import sys
import threading
import unicodedata
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from typing import Any

import typer
from typer.core import TyperCommand

from tmm_report import languages
from tmm_report.problems import N_, Message, Problem, ProblemError


def ended(done: bool) -> None:
    if not done:
        raise typer.Exit(1)


@contextmanager
def console_of(lang: str | None) -> Iterator[Console]:
    """The terminal in the language asked for, or in the user's own. A user's mistakes are printed, exit code 2."""
    console = Console(users_language())
    try:
        if lang is not None:
            console.speak(_known(lang))
        yield console
    except ProblemError as error:
        if lang is None and error.language:  # a variant's mistakes are told in its language
            console.speak(error.language)
        for problem in error.problems:
            console.warn(problem)
        raise typer.Exit(2) from None
    except OSError as error:  # a disk that is full, no folder for temporary files
        from tmm_report.commands.talk import outside

        console.warn(outside(error))
        raise typer.Exit(2) from None
    except (MemoryError, RecursionError):
        console.warn(
            Message(N_("not enough memory: this variant is too large; shorten its lists and tables"))
        )
        raise typer.Exit(2) from None
    except KeyboardInterrupt:
        if not console.warned:  # a batch says itself how to go on
            console.warn(Message(N_("stopped")))
        raise typer.Exit(130) from None
    finally:
        console.wipe()


def _known(lang: str) -> str:
    """The value of --lang. Raises ProblemError with the languages there are."""
    try:
        return languages.language(lang).code
    except ProblemError as error:
        raise ProblemError([replace(problem, path=("--lang",)) for problem in error.problems]) from None


def users_language() -> str:
    """The user's language from the environment."""
    names = [os.environ.get(name, "") for name in ("LC_ALL", "LC_MESSAGES", "LANG")]
    return languages.of_locale(next((name for name in names if name), "") or (locale.getlocale()[0] or ""))


class Console:
    """The user's terminal as the `Talk` of a command; what is being done is shown when it takes over a second."""

    def __init__(self, language: str):
        self.language = language
        self._doing, self._shown = Message(""), False
        self.warned = False
        self._timer: threading.Timer | None = None

    def speak(self, language: str) -> None:
        self.language = language

    def stage(self, doing: Message) -> None:
        self._doing = doing
        if self._shown:
            self._show()
        elif self._timer is None and sys.stderr.isatty():
            self._timer = threading.Timer(1.0, self._show)
            self._timer.daemon = True
            self._timer.start()

    def tell(self, line: Message | str) -> None:
        self._print(line if isinstance(line, str) else line.render(self._say), err=False)

    def warn(self, line: Message | Problem | str) -> None:
        self.warned = True
        words = line.text(self._say) if isinstance(line, Problem) else line
        self._print(words.render(self._say) if isinstance(words, Message) else words, err=True)

    def wipe(self) -> None:
        """Take the line of what is being done away."""
        if self._timer is not None:
            self._timer.cancel()
            self._timer = None
        if self._shown:
            typer.echo(f"\r{'':60}\r", nl=False, err=True)
            self._shown = False

    def _say(self, text: str) -> str:
        from tmm_report.i18n import Translator

        return Translator(self.language).gettext(text)

    def _show(self) -> None:
        self._shown = True
        typer.echo(f"\r{self._doing.render(self._say) + '…':60}", nl=False, err=True)

    def _print(self, text: str, err: bool) -> None:
        self.wipe()
        typer.echo(_clean(text), err=err)


def _clean(text: str) -> str:
    """Text for the terminal: no control, format or bidirectional characters, which could forge what is shown."""
    return "".join(
        c if not unicodedata.category(c).startswith("C") else "\N{REPLACEMENT CHARACTER}" for c in text
    )


# ---------------------------------------------------------------- options


class PdfMayStandAlone(TyperCommand):
    """`--pdf` names the program that makes the PDF, or stands alone before what follows it."""

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        return super().parse_args(ctx, _with_program(args))


def _with_program(args: list[str]) -> list[str]:
    named, said = list[str](), iter(args)
    for one in said:
        if named[-1:] == ["--pdf"]:
            if one in ("tex", "typst"):
                named[-1] = f"--pdf={one}"
                continue
            named[-1] = "--pdf=any"
        named.append(one)
    return [*named[:-1], "--pdf=any"] if named[-1:] == ["--pdf"] else named
