"""A talk that keeps what it is told, for the tests of commands."""

from __future__ import annotations

from functools import partial

from tmm_report.i18n import said
from tmm_report.problems import Problem


class Told:
    """The lines that a command says, in the language that it speaks."""

    def __init__(self):
        self.language, self.lines = "en", []

    def speak(self, language):
        self.language = language

    def stage(self, doing):
        pass

    def tell(self, line):
        say = partial(said, self.language)
        words = line.text(say) if isinstance(line, Problem) else line
        self.lines.append(words if isinstance(words, str) else words.render(say))

    warn = tell
