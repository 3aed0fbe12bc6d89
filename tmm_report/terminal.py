"""The terminal: what the commands say, in the user's language; their mistakes become exit codes."""

from __future__ import annotations

import atexit
import gc
import os
import re
import sys
import threading
import unicodedata
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Any

import typer
from typer.core import TyperCommand, TyperGroup

from tmm_report import languages
from tmm_report.problems import N_, Message, Problem, ProblemError

if TYPE_CHECKING:
    from tmm_report.commands.streams import Careful


def ended(done: bool) -> None:
    if not done:
        raise typer.Exit(1)


@contextmanager
def console_of(lang: str | None, quiet: bool = False) -> Iterator[Console]:
    """The terminal in the language asked for, or in the user's own. A user's mistakes are printed, exit code 2."""
    console = Console(languages.users(), quiet)
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


class Console:
    """The user's terminal as the `Talk` of a command; what is being done is shown when it takes over a second."""

    def __init__(self, language: str, quiet: bool = False):
        """`quiet`: only what is wrong is said."""
        self.language, self.quiet = language, quiet
        self._doing, self._shown = Message(""), False
        self.warned = False
        self._timer: threading.Timer | None = None

    def speak(self, language: str) -> None:
        self.language = language

    def stage(self, doing: Message) -> None:
        self._doing = doing
        if self._shown:
            self._show()
        elif self._timer is None and not self.quiet and sys.stderr.isatty():
            self._timer = threading.Timer(1.0, self._show)
            self._timer.daemon = True
            self._timer.start()

    def tell(self, line: Message | str) -> None:
        if self.quiet:
            return
        if (cells := getattr(line, "cells", None)) and colours():
            self.wipe()
            typer.echo(_painted(cells))
        else:
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
        from tmm_report.i18n import said

        return said(self.language, text)

    def _show(self) -> None:
        self._shown = True
        typer.echo(f"\r{self._doing.render(self._say) + '…':60}", nl=False, err=True)

    def _print(self, text: str, err: bool) -> None:
        self.wipe()
        typer.echo(_clean(text), err=err)


def colours() -> bool:
    """Whether the standard output is a terminal that shows colours, and they are wanted (https://no-color.org)."""
    return sys.stdout.isatty() and not os.environ.get("NO_COLOR") and os.environ.get("TERM") != "dumb"


STYLES: tuple[dict[str, Any], ...] = ({}, {"fg": "cyan"}, {"bold": True}, {"dim": True})
"""Of the cells of a table: what it is, its symbol, its number, its unit."""


def _painted(cells: Sequence[str]) -> str:
    return " ".join(typer.style(_clean(cell), **style) for cell, style in zip(cells, STYLES, strict=True))


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


# ---------------------------------------------------------------- help and the shell


USAGE: type[Exception] = typer.BadParameter.__bases__[0]  # UsageError, for which typer has no name


class Spoken(TyperGroup):
    """The commands: their help, and what is said of mistakes of the command line, in the user's language."""

    def main(self, args: Sequence[str] | None = None, *more: Any, **named: Any) -> Any:
        given = list(sys.argv[1:] if args is None else args)
        _speak(self, languages.users(), "--help" in given or not given)
        return super().main(args, *more, **named)

    def make_context(self, *given: Any, **named: Any) -> Any:
        with self._spoken():
            return super().make_context(*given, **named)

    def invoke(self, ctx: Any) -> Any:
        with self._spoken():
            return super().invoke(ctx)

    @contextmanager
    def _spoken(self) -> Iterator[None]:
        """Mistakes of the command line in the user's language: nothing is loaded for who makes none."""
        try:
            yield
        except USAGE as mistake:
            language = languages.users()
            if not languages.LANGUAGES[language].ids:
                from tmm_report.i18n import said

                _in_language(mistake, partial(said, language), partial(typer.echo, err=True))
            raise


def _speak(group: TyperGroup, language: str, helping: bool) -> None:
    """The words of typer itself come by gettext of the standard library, as those of any program."""
    import gettext

    if languages.LANGUAGES[language].ids:
        gettext.textdomain("messages")
        return
    from tmm_report.i18n import folder, said

    gettext.bindtextdomain("messages", str(folder()))
    gettext.textdomain("messages")
    if not any(os.environ.get(name) for name in ("LANGUAGE", "LC_ALL", "LC_MESSAGES", "LANG")):
        os.environ["LANGUAGE"] = language  # Windows, whose language gettext does not ask for
    if helping:
        say = partial(said, language)
        for command in (group, *group.commands.values()):
            command.context_class = _speaking(command.context_class, say)
            command.help = say(command.help or "")
            for one in command.params:
                if getattr(one, "help", None):
                    one.help = say(one.help)  # type: ignore[attr-defined]


def _speaking(context: Any, say: Callable[[str], str]) -> Any:
    """A context of a command whose help has typer's own words in another language, those that it does not ask for."""

    class Formatter(context.formatter_class):  # type: ignore[misc]
        def write_usage(self, prog: str, args: str = "", prefix: str | None = None) -> None:
            super().write_usage(prog, _placeholders(args, say), prefix or f"{say('Usage:')} ")

        def write_dl(self, rows: Sequence[tuple[str, str]], *more: Any, **named: Any) -> None:
            # most are translated already: to look for them again would read all texts of the notes, too
            told = [(_placeholders(name, say), say(text) if text.isascii() else text) for name, text in rows]
            super().write_dl(told, *more, **named)

    return type(context.__name__, (context,), {"formatter_class": Formatter})


def _placeholders(text: str, say: Callable[[str], str]) -> str:
    """What stands for a value in the help: <path> and others."""
    for one in PLACEHOLDERS:
        text = text.replace(one, say(one))
    return text


PLACEHOLDERS = (
    N_("[OPTIONS]"), N_("COMMAND [ARGS]..."), N_("<path>"), N_("<str>"), N_("<list[str]>"), N_("<int>"), N_("<float>"),
)  # fmt: skip
_HINT, _ERROR = N_("Try '%(a)s' for help."), N_("Error: %(a)s")
_TOLD = (  # what typer says of a wrong command line, for which it asks no gettext; the first that fits
    N_("No such option: %(a)s (Possible options: %(b)s)"),
    N_("No such option: %(a)s"),
    N_("Missing argument %(a)s."),
    N_("Missing option %(a)s."),
    N_("Option %(a)s requires an argument."),
    N_("Option %(a)s does not take a value."),
    N_("Got unexpected extra argument(s) (%(a)s)"),
    N_("Invalid value for %(a)s: Input should be a valid integer, unable to parse string as an integer"),
    N_("Invalid value for %(a)s: Input should be a valid number, unable to parse string as a number"),
    N_("Invalid value for %(a)s: %(b)s"),
    N_("%(a)s. Did you mean %(b)s?"),
)


def _retold(text: str, say: Callable[[str], str]) -> str:
    """A mistake that typer tells, translated; as it is where it is none of those known."""
    for told in _TOLD:
        pattern = re.sub(r"%\\\((\w)\\\)s", r"(?P<\1>.+)", re.escape(told))
        if found := re.fullmatch(pattern, text, re.S):
            return say(told) % found.groupdict()
    return text


def _in_language(mistake: Any, say: Callable[[str], str], write: Callable[[str], None]) -> None:
    """Let a mistake of the command line show itself in a language."""
    if type(mistake).__name__ != "NoArgsIsHelpError":  # which is the help itself
        mistake.show = partial(_show, mistake, say, write)


def _show(error: Any, say: Callable[[str], str], write: Callable[[str], None], file: Any = None) -> None:
    if error.ctx is not None:
        usage = _placeholders(error.ctx.get_usage(), say)
        write(usage.replace("Usage:", say("Usage:"), 1))
        write(f"{say(_HINT) % {'a': f'{error.ctx.command_path} --help'}}\n")
    write(say(_ERROR) % {"a": _retold(error.format_message(), say)})


OF_TYPER = (
    N_("Usage:"), N_("Options"), N_("Arguments"), N_("Commands"), N_("Show this message and exit."), N_("required"),
    N_("default: {default}"), N_("Missing command."), N_("No such command {name!r}."),
)  # fmt: skip
"""Words of typer that a user of this program meets."""


def complete() -> None:
    """What a shell asks when the user presses Tab; docs/first_hour.md says how it is switched on."""
    if "_TMM_REPORT_COMPLETE" in os.environ:
        from typer.completion import completion_init

        completion_init()


# ---------------------------------------------------------------- the process


def for_one_command(app: typer.Typer) -> None:
    """What makes a process that runs one command and ends start and end sooner."""
    # What is built lives until the end: looking through it for rings every few hundred objects, and once more on the
    # way out, finds next to nothing and takes a tenth of the time: the note of a usual variant is done before the first
    # look. A batch of hundreds of variants is still collected.
    gc.set_threshold(300_000)
    atexit.register(gc.freeze)
    # Plugins of other packages would be looked for among everything installed, and run on text that nobody has checked.
    os.environ.setdefault("PYDANTIC_DISABLE_PLUGINS", "__all__")
    # The options of the other commands would be read from their signatures, and never be asked for.
    asked = [
        one for one in app.registered_commands if sys.argv[1:2] == [getattr(one.callback, "__name__", "")]
    ]
    app.registered_commands = asked or app.registered_commands


def lost(code: str | int | None, out: Careful) -> str | int | None:
    """The exit code, where what was said may have been lost on the way out."""
    out.flush()
    if out.error is None:
        return code
    from tmm_report.commands.talk import reason

    text = Message(N_("the standard output could not be written: %(reason)s"), {"reason": reason(out.error)})
    Console(languages.users()).warn(text)
    return code or 1
