"""Results -> note: the chapters' templates rendered in one format and one language.

    files = render(solve(variant), "html", Translator("ru"))     # {"note.html": b"..."}

The numbers of sections, formulas, tables and figures are resolved here; a second pass is made only where a
template refers to something that comes later.
"""

from __future__ import annotations

from base64 import b64encode
from typing import Any, Literal

from markupsafe import Markup

from tmm_report.i18n import Translator
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


def chapters(results: Any) -> list[str]:
    """Names of the templates of the chapters that were solved, in the order of the note."""
    names = ["given", "structure", "kinematics", "plans"]
    if results.kinetostatics is not None:
        names.append("kinetostatics")
    if results.friction is not None:
        names.append("friction")
    return [*names, "conclusions", "references"]


def render(results: Any, fmt: Literal["html", "tex"], tr: Translator) -> dict[str, bytes]:
    """File name -> content: "note.html" alone, or "note.tex" with the figures it reads."""
    form, pictures = FORMATS[fmt](), Pictures(results, tr)
    page = Page(form, tr, Numbering())
    note = _pass(results, page, pictures)
    if page.numbering.missing:
        page = Page(form, tr, Numbering(known=page.numbering.places))
        note = _pass(results, page, pictures)
    if page.numbering.missing:
        raise ValueError(f"the templates refer to what is not in the note: {sorted(page.numbering.missing)}")
    return {f"note.{fmt}": note.encode(), **form.files}


def _pass(results: Any, page: Page, pictures: Pictures) -> str:
    """The note with the numbers that are known by now."""
    given, fmt = _given(results, page, pictures), page.form.name
    given["m"] = template(f"macros.{fmt}.j2").make_module(given)
    body = [Markup(template(f"chapters/{name}.j2").render(given)) for name in chapters(results)]
    title = Markup(template("chapters/title.j2").render(given))
    return template(f"report.{fmt}.j2").render(given, title=title, body=body, **_own_files(fmt))


def _given(results: Any, page: Page, pictures: Pictures) -> dict[str, Any]:
    """What every template sees beside the macros `m`."""
    words = Words(results, page)
    functions = ("t", "math", "sym", "value", "num", "unit", "listed")
    return {
        "r": results,
        "page": page,
        "words": words,
        "tables": Tables(results, page, words),
        "forces": ForceTables(results, page, words),
        "special": SpecialTables(results, page, words),
        "pictures": pictures,
        "samples": Samples(results),
        **{name: getattr(page, name) for name in functions},
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
