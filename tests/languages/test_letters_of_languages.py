"""Letters of Russian, Ukrainian and Kazakh in every PDF of a note: upright, slanted and bold, copied as they are."""

from __future__ import annotations

import io
import re
import subprocess
import zipfile
from pathlib import Path

import pytest
from browser import browser, opened
from notes import program, render
from typesetting import set_by_tex, set_by_typst

from tmm_report import solve
from tmm_report.figures.sheets.strokes import glyph
from tmm_report.loading import loads
from tmm_report.variant import new

LETTERS = "әғқңөұүһі ӘҒҚҢӨҰҮҺІ їєґ ЇЄҐ ёыэъ ЁЫЭЪ iI"
NAME = "Әлімбекұлы І. Ї."


def text_of(pdf: bytes, place: Path) -> str:
    (place / "note.pdf").write_bytes(pdf)
    done = subprocess.run(
        [program("pdftotext"), "-layout", place / "note.pdf", "-"], capture_output=True, check=True
    )
    return done.stdout.decode()


@pytest.fixture(scope="module")
def results():
    return solve(loads(new("ru").replace("Иванов И. И.", NAME)))


def seen(text: str) -> int:
    return len(re.findall(rf"(?m)^\s*{LETTERS}\s*$", text))


@pytest.mark.exhaustive
def test_letters_of_latex(results, tmp_path):
    files = render(results, "tex")
    lines = rf"\newpage {LETTERS}\par\textit{{{LETTERS}}}\par\textbf{{{LETTERS}}}\par\MakeUppercase{{іїқ}}"
    source = files["note.tex"].decode().replace(r"\end{document}", lines + r"\end{document}")
    _, pdf = set_by_tex(files | {"note.tex": source.encode()})
    text = text_of(pdf, tmp_path)
    assert seen(text) == 3 and "ІЇҚ" in text and NAME in text


def test_letters_of_typst(results, tmp_path):
    source = render(results, "typst")["note.typst"].decode()
    pdf = set_by_typst(f"{source}\n#pagebreak()\n{LETTERS}\n\n_{LETTERS}_\n\n*{LETTERS}*\n".encode())
    text = text_of(pdf, tmp_path)
    assert seen(text) == 3 and NAME in text


@pytest.mark.exhaustive
def test_letters_of_the_printed_page(results, tmp_path):
    page = render(results, "html")["note.html"].decode()
    lines = f"<p>{LETTERS}</p><p><i>{LETTERS}</i></p><p><b>{LETTERS}</b></p>"
    with browser(tmp_path) as talk:
        pdf = opened(
            talk, tmp_path, "letters", page.replace("</main>", f"{lines}</main>", 1).encode(), True
        ).pdf
    text = text_of(pdf, tmp_path)
    assert len(re.findall(LETTERS, text)) == 3 and NAME in text


def test_letters_of_sheets_are_drawn_each_by_its_own_strokes():
    drawn = {char: glyph(char) for char in LETTERS + NAME if char != " "}
    unknown = glyph("\N{SNOWMAN}")
    assert all(strokes and strokes != unknown for strokes in drawn.values())
    for one, other in ("кқ", "нң", "гғ", "уұ", "уү", "оө", "єэ", "гґ", "иі", "іï"):
        assert glyph(one) != glyph(other)


def test_letters_of_word(results):
    (document,) = render(results, "docx").values()
    with zipfile.ZipFile(io.BytesIO(document)) as parts:
        assert NAME in parts.read("word/document.xml").decode()
