"""Results -> note: the chapters' templates rendered in one format and one language.

    files = render(parts, title, "html", Translator("ru"))     # {"note.html": b"..."}

The templates are rendered once: what they refer to before it comes is marked, and numbered at the end.
"""

from __future__ import annotations

import re
from base64 import b64encode
from collections.abc import Callable, Iterable, Mapping, Sequence
from datetime import date
from typing import TYPE_CHECKING, Any

from markupsafe import Markup

from tmm_report.i18n import Translator
from tmm_report.problems import Message
from tmm_report.profiles import Profile
from tmm_report.report.formats import Html, Png, Tex
from tmm_report.report.heard import Heard
from tmm_report.report.numbering import Numbering
from tmm_report.report.page import Page, template
from tmm_report.report.paper.punctuation import joined
from tmm_report.report.part import WHOLE, Failed, Note, Part, Title
from tmm_report.resources import data_root

if TYPE_CHECKING:
    from tmm_report.report.formats import Format
    from tmm_report.report.own import Own
    from tmm_report.report.paper.frames import Frames


def _typst() -> Format:
    from tmm_report.report.formats.typst import Typst  # few notes are made by it

    return Typst()


def _docx() -> Format:
    from tmm_report.report.formats.docx import Docx

    return Docx()


FORMATS: dict[str, Callable[[], Format]] = {
    "html": lambda: Html(breaking=True),
    "tex": Tex,
    "png": Png,
    "typst": _typst,
    "docx": _docx,
}


def render(
    make: Callable[[Page], Sequence[Part]],
    title: Title,
    fmt: str,
    tr: Translator,
    undone: Sequence[Message] = (),
    note: Note = WHOLE,
    profile: Profile | None = None,
    assignment: object = None,
    template_of: tuple[bytes, str] | None = None,
    living: Callable[[str, Page], str] | None = None,
) -> dict[str, bytes]:
    """File name -> content: "note.html", "note.docx" or "note.typst" alone, "note.tex" with the figures it reads, or
    the figures as pictures.

    `undone`: what was asked and is not in the note; the conclusions begin with it. `note`: how much it says;
    `profile`: how it looks on paper; `assignment`: its sheet, as its template knows it;
    `template_of`: a department's own template and the name of its file; `living`: puts into a page of HTML what moves
    it on the screen.
    """
    page = Page(FORMATS[fmt](), tr, Numbering(), note, profile)
    if living is not None and fmt == "html":
        page.aside = Heard()
    parts = make(page)
    given = {**_given(title, page), "assignment": assignment}
    own = _own(template_of) if template_of else None
    text = _written(given, parts, page, undone, own)
    if living is not None and fmt == "html":
        text = living(text, page)
    if fmt == "docx":
        return {"note.docx": _packed(text, given, page)}
    return page.form.files if fmt == "png" else {f"note.{fmt}": text.encode(), **page.form.files}


def _packed(text: str, given: Mapping[str, Any], page: Page) -> bytes:
    from tmm_report.report.formats.docx import Docx
    from tmm_report.report.word.package import packed

    assert isinstance(page.form, Docx)
    return packed(text, page.form, given, _date(given))


def written(
    parts: Iterable[Part], title: Title, page: Page, before: Callable[[Part], None] = lambda part: None
) -> None:
    """Print the chapters for what the page's format keeps of them; `before`: called with each part."""
    given = _given(title, page)
    given = {**given, "m": template(f"macros.{page.form.name}.j2").make_module(dict(given))}
    for part in list(parts):
        before(part)
        template(f"chapters/{part.template}.j2").render(given, view=part.view)


def _own(template_of: tuple[bytes, str]) -> Own:
    from tmm_report.report.own import Own  # most departments have none

    return Own(*template_of)


def _written(
    given: Mapping[str, Any],
    parts: Sequence[Part],
    page: Page,
    undone: Sequence[Message],
    own: Own | None = None,
) -> str:
    fmt = page.form.name
    given = {**given, "m": template(f"macros.{fmt}.j2").make_module(dict(given))}

    def chapter(name: str, **more: Any) -> Markup:
        def ours() -> Markup:
            return Markup(template(f"chapters/{name}.j2").render(given, **more))

        # a block of a department may be without a heading of ours, before which figures that wait stand
        return page.form.due() + own.written(name, given, ours) if own and own.states(name) else ours()

    body = [chapter(part.template, view=part.view) for part in parts]
    left_out, concluded = list(map(page.message, undone)), _conclusions(parts)
    body += [chapter("conclusions", lines=[*left_out, *concluded])]
    if sources := page.cited.order("".join(body)):
        body.append(chapter("references", names=sources))
    drawings = page.numbering.close(page.tr.letters)
    if page.numbering.appendices:
        body.append(chapter("appendices", drawings=drawings))
    # what stands in front tells of what the note has
    page.numbering.begin_front()
    failed = [*left_out, *(line for line in concluded if isinstance(line, Failed))]
    listed = [chapter("symbols")] if page.note.listed else []
    body = [*listed, chapter("introduction", failed=failed), *body]
    page.numbering.end_front()
    head = chapter("title") + (chapter("assignment") if given["assignment"] else "")
    frames = _frames(given["title"], page) if page.profile.frames else None
    text = template(f"report.{fmt}.j2").render(
        given, head=head, body=body, frames=frames, **_own_files(given, page)
    )
    text = page.numbering.resolved(text, page.note.whole and own is None)
    text = page.cited.resolved(text)
    return joined(text, fmt, page.called("where"), page.called("here"), page.profile.dash_sign)


def _frames(title: Title, page: Page) -> Frames:
    from tmm_report.report.paper.frames import Frames  # few notes have them

    return Frames(title, page)


def _conclusions(parts: Sequence[Part]) -> list[Markup]:
    """What the chapters say in the conclusions, each view once and in one paragraph; what failed comes first."""
    views = dict.fromkeys(part.view for part in parts if part.concludes)
    said = [list(view.conclusions()) for view in views]
    failed = [line for lines in said for line in lines if isinstance(line, Failed)]
    sound = ([line for line in lines if not isinstance(line, Failed)] for lines in said)
    return [*failed, *(Markup(" ").join(lines) for lines in sound if lines)]


def _given(title: Title, page: Page) -> dict[str, Any]:
    """What every template sees beside the macros `m`."""
    functions = ("t", "count", "math", "sym", "value", "num", "unit", "listed")
    return {"title": title, "page": page, **{name: getattr(page, name) for name in functions}}


FACES = (
    ("Note Serif", "", "NoteSerif-Regular"),
    ("Note Serif", "font-weight: bold; ", "NoteSerif-Bold"),
    ("Note Serif", "font-style: italic; ", "NoteSerif-Italic"),
    ("Note Math", "", "STIXTwoMath-subset"),
)


def _date(given: Mapping[str, Any]) -> date:
    """Of the document: that of the assignment."""
    from tmm_report.report.dates import dated

    title, sheet = given["title"], given["assignment"]
    texts = [sheet.issued, sheet.due] if sheet else []
    return dated(*map(given["page"].name, [*texts, title.year]))


def _own_files(given: Mapping[str, Any], page: Page) -> dict[str, Any]:
    """What the HTML carries in itself: its style sheet and the faces of its text and formulas, with which it is the
    same on every machine; what a PDF must have: a date, that of the assignment."""
    if page.form.name == "typst":
        return {"date": _date(given)}
    if page.form.name != "html":
        return {}
    root = data_root() / "templates"
    faces = [
        {
            "family": family,
            "style": style,
            "data": Markup(b64encode((root / "fonts" / f"{file}.woff2").read_bytes()).decode()),
        }
        for family, style, file in FACES
    ]
    text = (root / "style.css").read_text("utf-8")
    style = re.sub(r"/\*.*?\*/|\s*([{};])\s*|(?<=[:,])\s+", r"\1", text, flags=re.S)
    return {"style": Markup(style), "faces": faces}
