"""Every formula that the note of a ready variant prints."""

from __future__ import annotations

from functools import cache

from conftest import solved
from markupsafe import Markup

from tmm_report import note
from tmm_report.commands.files import translator
from tmm_report.report import render
from tmm_report.report.formats import Html


class Heard(Html):
    """HTML that keeps every formula it has printed."""

    def __init__(self):
        super().__init__()
        self.items = {}

    def math(self, item, tr, display=False):
        self.items[id(item)] = item
        return super().math(item, tr, display)

    def picture(self, picture, anchor, caption=""):
        return Markup("")


@cache
def formulas_of(name):
    """The formulas, and the translator of the variant's language."""
    results = solved(name)
    tr, heard = translator(results.variant), Heard()

    def parts(page):
        page.form = heard
        return list(note.parts(results, page))

    render(parts, results.variant.title, "html", tr)
    return list(heard.items.values()), tr
