"""Results -> note: the chapters' templates rendered in one format and one language.

    files = render(solve(variant), "html", Translator("ru"))     # {"note.html": b"..."}

The templates are rendered once: what they refer to before it comes is marked, and numbered at the end.
"""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Mapping, Sequence
from typing import Any, Literal, NamedTuple

from markupsafe import Markup

from tmm_report.i18n import Translator
from tmm_report.report import gears
from tmm_report.report.force_tables import ForceTables
from tmm_report.report.formats import Html, Tex
from tmm_report.report.numbering import Numbering
from tmm_report.report.page import Page, template
from tmm_report.report.pictures import Pictures
from tmm_report.report.samples import Samples
from tmm_report.report.special_tables import SpecialTables
from tmm_report.report.tables import Tables
from tmm_report.report.words import Words
from tmm_report.resources import data_root

FORMATS: dict[str, type[Html] | type[Tex]] = {"html": Html, "tex": Tex}


class Chapter(NamedTuple):
    """A template and what it sees beside what every template sees."""

    template: str
    given: Mapping[str, Any] = {}


def chapters(results: Any, page: Page) -> list[Chapter]:
    """The chapters that were solved, in the order of the note."""
    found = []
    if results.has_mechanism:
        found += [Chapter(name) for name in ("given", "structure", "kinematics", "plans")]
        found += [Chapter(name) for name in ("kinetostatics", "friction") if getattr(results, name)]
    views = gears.chapters(results, page)
    found += [Chapter(name, {"view": view}) for name, view in views]
    return [
        *found,
        Chapter("conclusions", {"gear_conclusions": gears.conclusions(views)}),
        Chapter("references"),
    ]


def render(results: Any, fmt: Literal["html", "tex"], tr: Translator) -> dict[str, bytes]:
    """File name -> content: "note.html" alone, or "note.tex" with the figures it reads."""
    page = Page(FORMATS[fmt](), tr, Numbering())
    note = _written(_given(results, page), chapters(results, page), page)
    return {f"note.{fmt}": note.encode(), **page.form.files}


def _written(given: Mapping[str, Any], parts: Sequence[Chapter], page: Page) -> str:
    fmt = page.form.name
    given = {**given, "m": template(f"macros.{fmt}.j2").make_module(dict(given))}
    body = [
        Markup(template(f"chapters/{chapter.template}.j2").render(given, **chapter.given))
        for chapter in parts
    ]
    title = Markup(template("chapters/title.j2").render(given))
    note = template(f"report.{fmt}.j2").render(given, title=title, body=body, **_own_files(fmt))
    return page.numbering.resolved(note)


def _given(results: Any, page: Page) -> dict[str, Any]:
    """What every template sees beside the macros `m`."""
    functions = ("t", "math", "sym", "value", "num", "unit", "listed")
    lever = _lever(results, page) if results.has_mechanism else {}
    return {"r": results, "page": page, **lever, **{name: getattr(page, name) for name in functions}}


def _lever(results: Any, page: Page) -> dict[str, Any]:
    """What the templates of the lever mechanism's chapters see."""
    words = Words(results, page)
    return {
        "words": words,
        "tables": Tables(results, page, words),
        "forces": ForceTables(results, page, words),
        "special": SpecialTables(results, page, words),
        "pictures": Pictures(results, page.tr),
        "samples": Samples(results),
    }


def _own_files(fmt: str) -> dict[str, Markup]:
    """What the HTML carries in itself: its style sheet and the font of its formulas."""
    if fmt != "html":
        return {}
    root = data_root() / "templates"
    font = (root / "fonts" / "STIXTwoMath-subset.woff2").read_bytes()
    return {
        "style": Markup((root / "style.css").read_text("utf-8")),
        "font": Markup(b64encode(font).decode()),
    }
