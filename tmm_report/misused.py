"""What typer says of a wrong command line, in the user's language: it asks gettext for a few of its words alone."""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import partial
from typing import Any

from tmm_report.problems import N_

HINT, ERROR = N_("Try '%(a)s' for help."), N_("Error: %(a)s")
TOLD = (  # as typer writes them; the first that fits
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


def said(text: str, say: Callable[[str], str]) -> str:
    """A mistake that typer tells, translated; as it is where it is none of those known."""
    for told in TOLD:
        pattern = re.sub(r"%\\\((\w)\\\)s", r"(?P<\1>.+)", re.escape(told))
        if found := re.fullmatch(pattern, text, re.S):
            return say(told) % found.groupdict()
    return text


def in_language(mistake: Any, say: Callable[[str], str], write: Callable[[str], None]) -> None:
    """Let a mistake of the command line show itself in a language."""
    if type(mistake).__name__ != "NoArgsIsHelpError":  # which is the help itself
        mistake.show = partial(_show, mistake, say, write)


def _show(error: Any, say: Callable[[str], str], write: Callable[[str], None], file: Any = None) -> None:
    if error.ctx is not None:
        usage = error.ctx.get_usage()
        write(usage.replace("Usage:", say("Usage:"), 1))
        write(f"{say(HINT) % {'a': f'{error.ctx.command_path} --help'}}\n")
    write(say(ERROR) % {"a": said(error.format_message(), say)})
