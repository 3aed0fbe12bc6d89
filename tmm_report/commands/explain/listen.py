"""What a note says, gathered while it is written.

heard = listen(lambda page: list(note.parts(results, page)), title, Translator("ru"))
heard.formulas[0]      # the formula itself, its number and the section in which it stands
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from tmm_report.i18n import Translator
from tmm_report.report import render
from tmm_report.report.heard import Counted, Heard, Listener
from tmm_report.report.page import Page
from tmm_report.report.part import Part, Title


def listen(make: Callable[[Page], Sequence[Part]], title: Title, tr: Translator) -> Heard:
    """What the note of these parts says. No picture is drawn."""
    heard = Heard()

    def parts(page: Page) -> Sequence[Part]:
        page.numbering = Counted()
        page.form = Listener(page.numbering, heard)
        return make(page)

    render(parts, title, "html", tr)
    return heard
