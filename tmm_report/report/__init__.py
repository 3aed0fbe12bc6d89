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
from tmm_report.report.formats import Html, Tex
from tmm_report.report.numbering import Numbering
from tmm_report.report.page import Page, template
from tmm_report.report.pictures import Pictures
from tmm_report.report.samples import Samples
from tmm_report.report.tables import Tables
from tmm_report.report.words import Words
from tmm_report.resources import data_root

FORMATS = {"html": Html, "tex": Tex}


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
    numbering = Numbering()
    note, files = _pass(results, fmt, tr, numbering)
    if numbering.missing:
        numbering = Numbering(known=numbering.places)
        note, files = _pass(results, fmt, tr, numbering)
    if numbering.missing:
        raise ValueError(f"the templates refer to what is not in the note: {sorted(numbering.missing)}")
    return {f"note.{fmt}": note.encode(), **files}


def _pass(results: Any, fmt: str, tr: Translator, numbering: Numbering) -> tuple[str, dict[str, bytes]]:
    form = FORMATS[fmt]()
    given = _given(results, Page(form, tr, numbering))
    given["m"] = template(f"macros.{fmt}.j2").make_module(given)
    body = [Markup(template(f"chapters/{name}.j2").render(given)) for name in chapters(results)]
    title = Markup(template("chapters/title.j2").render(given))
    return template(f"report.{fmt}.j2").render(given, title=title, body=body, **_own_files(fmt)), form.files


def _given(results: Any, page: Page) -> dict[str, Any]:
    """What every template sees beside the macros `m`."""
    words = Words(results, page)
    functions = ("t", "math", "sym", "value", "num", "col", "unit", "listed")
    return {
        "r": results,
        "page": page,
        "words": words,
        "tables": Tables(results, page, words),
        "pictures": Pictures(results, page, words),
        "samples": Samples(results),
        **{name: getattr(page, name) for name in functions},
    }


def _own_files(fmt: str) -> dict[str, Markup]:
    """What the HTML carries in itself: its style sheet and the font of its formulas."""
    if fmt != "html":
        return {}
    root = data_root() / "templates"
    font = (root / "fonts" / "STIXTwoMath-subset.woff2").read_bytes()
    return {"style": Markup((root / "style.css").read_text("utf-8")), "font": Markup(b64encode(font).decode())}
