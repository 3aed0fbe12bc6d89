"""The note as one file for word processors: its parts, packed by the standard library.

A library (python-docx) is not needed for a dozen of parts; it would stamp the clock into them, and nothing of it knows
formulas. Source: ECMA-376, parts 1 and 2.
"""

from __future__ import annotations

from collections.abc import Mapping
from datetime import date
from io import BytesIO
from typing import TYPE_CHECKING, Any
from xml.etree.ElementTree import tostring
from zipfile import ZIP_DEFLATED, ZipFile, ZipInfo

from markupsafe import Markup

from tmm_report.report.page import template
from tmm_report.report.word.frames import framed, headers
from tmm_report.report.word.sections import Setup
from tmm_report.report.word.tree import finished

if TYPE_CHECKING:
    from tmm_report.report.formats.docx import Docx

PARTS = (
    ("[Content_Types].xml", "types"), ("_rels/.rels", "rels"), ("docProps/core.xml", "core"),
    ("word/styles.xml", "styles"), ("word/numbering.xml", "numbering"), ("word/settings.xml", "settings"),
    ("word/header.xml", "header"), ("word/footer.xml", "footer"), ("word/titleheader.xml", "titleheader"),
    ("word/titlefooter.xml", "titlefooter"), ("word/_rels/document.xml.rels", "document.rels"),
)  # fmt: skip


def packed(text: str, form: Docx, given: Mapping[str, Any], stated: date) -> bytes:
    """The file of what the templates wrote; the same bytes of the same text. `stated`: the date of the document."""
    page = given["page"]
    setup = Setup(page.profile)
    document = finished(text, setup)
    heads, feet = headers(setup)
    more = {
        **given,
        "form": form,
        "p": page.profile,
        "date": stated,
        "proofed": page.tr.proofed,
        "headers": heads,
        "footers": feet,
        "foot": Markup("".join(tostring(one, encoding="unicode") for one in setup.foot)),
    }
    parts = {name: template(f"word/{source}.xml.j2").render(more).strip().encode() for name, source in PARTS}
    if page.profile.frames:
        parts |= framed(given["title"], page, setup)
    return _zipped({**parts, "word/document.xml": document, **form.files})


def _zipped(parts: Mapping[str, bytes]) -> bytes:
    """An archive without clock and machine in it."""
    stream = BytesIO()
    with ZipFile(stream, "w") as archive:
        for name, content in parts.items():
            entry = ZipInfo(name, (1980, 1, 1, 0, 0, 0))
            entry.compress_type, entry.create_system, entry.external_attr = ZIP_DEFLATED, 0, 0
            archive.writestr(entry, content)
    return stream.getvalue()
