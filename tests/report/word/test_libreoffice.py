"""The file as LibreOffice opens and prints it: what it says, where its contents lead, on which paper."""

from __future__ import annotations

import re
import subprocess
from collections import Counter
from functools import cache

import pytest
from docx_read import W, document_of, style_of, text_of
from notes import note, program, static
from typesetting import set_by_libreoffice

pytestmark = pytest.mark.exhaustive  # it takes its half minute


@cache
def printed(name: str, language: str) -> tuple[str, ...]:
    """The pages of the PDF as text."""
    pdf = set_by_libreoffice(note(name, "docx", language)["note.docx"])
    text = subprocess.run(
        [program("pdftotext"), "-layout", "-", "-"], input=pdf, capture_output=True, check=True
    )
    info = subprocess.run([program("pdfinfo"), "-l", "999", "-"], input=pdf, capture_output=True, check=True)
    return (info.stdout.decode(), *text.stdout.decode().split("\f")[:-1])


NOTES = [("compressor", "ru"), ("crank_rocker", "en")]


@pytest.mark.parametrize(("name", "language"), NOTES)
def test_it_prints_the_words_of_the_other_note(name, language):
    html = (
        static(note(name, "html", language)["note.html"].decode())
        .partition("<main>")[2]
        .partition("</main>")[0]
    )
    html = re.sub(r"<(svg|math).*?</\1>", " ", html, flags=re.S)
    plain = re.sub(r"<[^>]+>", " ", html).replace("\u2060", "").replace("\xa0", " ")
    wanted = Counter(re.findall(r"[^\W\d_]{5,}", plain.lower()))
    found = Counter(re.findall(r"[^\W\d_]{5,}", " ".join(printed(name, language)[1:]).lower()))
    missing = wanted - found
    assert len(wanted) > 100 and sum(missing.values()) <= 0.02 * sum(wanted.values()), missing


@pytest.mark.parametrize(("name", "language"), NOTES)
def test_its_contents_say_on_which_page_a_heading_stands(name, language):
    _, *pages = printed(name, language)
    lines = re.findall(r"^ *(\S.*?)\.{4,} ?(\d+)$", "\n".join(pages[1:3]), re.M)
    root = document_of(note(name, "docx", language)["note.docx"])
    heads = [
        one
        for one in root.iter(f"{W}p")
        if style_of(one) in ("Heading1", "Heading2", "Structural", "Appendix")
    ]
    assert len(lines) == len(heads)
    for (_, page), head in zip(lines, heads, strict=True):
        said = packed(text_of(head))[:40]
        assert said in packed(pages[int(page) - 1]), (said, page)


def packed(text: str) -> str:
    return "".join(text.lower().split())


@pytest.mark.parametrize(("name", "language"), NOTES)
def test_its_fields_are_those_that_stand_there(name, language):
    """LibreOffice reckons them anew: formulas have the numbers of the note."""
    _, *pages = printed(name, language)
    html = note(name, "html", language)["note.html"].decode()
    wanted = re.findall(r'<div class="number">\((.*?)\)</div>', html)
    found = re.findall(r"\(((?:\d+|[А-ЯA-Z])\.\d+)\)$", "\n".join(pages), re.M)
    assert len(wanted) > 3 and Counter(wanted) == Counter(found)


@pytest.mark.parametrize(("name", "language"), NOTES)
def test_its_references_say_where(name, language):
    """Words of figures and tables with their numbers, as often as in HTML."""
    html = (
        static(note(name, "html", language)["note.html"].decode())
        .partition("<main>")[2]
        .partition("</main>")[0]
    )
    plain = re.sub(r"<[^>]+>", "", re.sub(r"<(svg|math).*?</\1>", " ", html, flags=re.S)).replace("\xa0", " ")
    said = r"(?:рисун|таблиц|figure|table)\w*\s+([А-ЯA-Z\d.]*\d)"
    wanted = Counter(re.findall(said, plain.lower(), re.I))
    found = Counter(re.findall(said, " ".join(" ".join(printed(name, language)[1:]).split()).lower(), re.I))
    missing = wanted - found  # the number of a page may stand between
    assert sum(wanted.values()) > 10 and sum(missing.values()) <= 0.02 * sum(wanted.values()), missing


def test_no_formula_lacks_a_term():
    """What LibreOffice cannot read it shows by a question mark upside down."""
    for name, language in NOTES:
        assert "¿" not in "".join(printed(name, language))


def test_sheets_are_printed_on_their_paper():
    info = printed("compressor", "ru")[0]
    sizes = Counter(re.findall(r"size: +([\d.]+) x ([\d.]+)", info))
    assert any(float(wide) > 1190 for wide, _ in sizes) and any(
        float(wide) > float(tall) for wide, tall in sizes
    )
