"""A note in Ukrainian and one in Kazakh in every format: each word of the page comes out of it as it was put in.

Beside the note's own words stand all letters of the languages, upright, slanted and bold. Typst and browsers end lines
within Ukrainian words, by its patterns; none does within Kazakh ones.
"""

from __future__ import annotations

import html
import io
import re
import subprocess
import zipfile
from functools import cache

import pytest
from browser import browser, opened
from exhaustive import many
from notes import program, render, static
from typesetting import set_by_tex, set_by_typst

from tmm_report import sheets, solve
from tmm_report.course import Results
from tmm_report.figures.sheets.cad import dxf
from tmm_report.figures.sheets.strokes import glyph
from tmm_report.i18n import Translator
from tmm_report.loading import loads
from tmm_report.variant import new

CODES = ["kk", "uk"]
LETTERS = "әғқңөұүһі ӘҒҚҢӨҰҮҺІ їєґ ЇЄҐ ёыэъ ЁЫЭЪ iI"
NAME = "Әлімбекұлы І. Ї."
STUDENTS = re.compile(r"(?m)^(  student: ).*$")
CAPTION = re.compile(r"(?s)<figcaption.*?</figcaption>")
WORD = re.compile(r"[^\W\d_]{4,}")
HYPHENS = {"kk": "", "uk": "-\u2010\u00ad"}  # behind which a line ends within a word
in_each = pytest.mark.parametrize("code", CODES)
in_one_or_each = pytest.mark.parametrize("code", many(CODES))


@cache
def results(code: str) -> Results:
    text, students = STUDENTS.subn(rf'\g<1>"{NAME}"', new(code))
    assert students == 1
    return solve(loads(text))


@cache
def page(code: str) -> str:
    return render(results(code), "html")["note.html"].decode()


def words(code: str) -> set[str]:
    """Those of the text: a drawing's words are copied of no PDF as they stand."""
    hidden = r"(?s)<(script|style|svg|math).*?</\1>|[\u2060\u00ad]"
    return set(WORD.findall(html.unescape(re.sub(r"<[^>]*>", " ", re.sub(hidden, "", static(page(code)))))))


def copied(pdf: bytes, layout: str = "-raw") -> str:
    command = [program("pdftotext"), layout, "-", "-"]
    return subprocess.run(command, input=pdf, capture_output=True, check=True).stdout.decode()


def lost(code: str, text: str, wrapped: str = "") -> set[str]:
    """Words of the page that are not in a text, whose lines may end within a word behind a sign of `wrapped`; its rest
    then begins a line, the next one or, where a page ends or a figure stands between, another."""
    text = text.lower()
    joined = re.sub(rf"[{wrapped}]\n", "", text) if wrapped else text

    def broken(word: str) -> bool:
        return bool(wrapped) and any(
            re.search(rf"{word[:k]}[{wrapped}]$", text, re.M) and re.search(rf"^{word[k:]}", text, re.M)
            for k in range(2, len(word) - 1)
        )

    return {word for word in words(code) if word.lower() not in joined and not broken(word.lower())}


def lines_of_letters(text: str) -> int:
    return len(re.findall(rf"(?m)^\s*{LETTERS}\s*$", text))


@pytest.mark.exhaustive
@in_each
def test_latex(code):
    files = render(results(code), "tex")
    lines = rf"\newpage {LETTERS}\par\textit{{{LETTERS}}}\par\textbf{{{LETTERS}}}\par\MakeUppercase{{іїқ}}"
    source = files["note.tex"].decode().replace(r"\end{document}", lines + r"\end{document}")
    text = copied(set_by_tex(files | {"note.tex": source.encode()})[1])
    assert lines_of_letters(text) == 3 and "ІЇҚ" in text and NAME in text
    assert lost(code, text) == set()


@in_one_or_each
def test_typst(code):
    source = render(results(code), "typst")["note.typst"].decode()
    text = copied(set_by_typst(f"{source}\n#pagebreak()\n{LETTERS}\n\n_{LETTERS}_\n\n*{LETTERS}*\n".encode()))
    assert lines_of_letters(text) == 3 and NAME in text
    assert lost(code, text, HYPHENS[code]) == set()


@pytest.mark.exhaustive
@in_each
def test_the_printed_page(code, tmp_path):
    lines = f"<p>{LETTERS}</p><p><i>{LETTERS}</i></p><p><b>{LETTERS}</b></p>"
    with browser(tmp_path) as talk:
        printed = page(code).replace("</main>", f"{lines}</main>", 1).encode()
        text = copied(opened(talk, tmp_path, "letters", printed, True).pdf)
    assert len(re.findall(LETTERS, text)) == 3 and NAME in text
    assert lost(code, text, HYPHENS[code]) == set()


@in_one_or_each
def test_word(code):
    (document,) = render(results(code), "docx").values()
    with zipfile.ZipFile(io.BytesIO(document)) as parts:
        text = html.unescape(re.sub(r"<[^>]*>", "", parts.read("word/document.xml").decode()))
    assert NAME in text and lost(code, text) == set()


@in_one_or_each
def test_sheets(code):
    """Their texts, all letters of which have strokes, are those of the DXF; titles and stamp have the words of the
    language."""
    ezdxf = pytest.importorskip("ezdxf")
    drawn = sheets.composed(results(code), Translator(code))
    runs = [run.text for sheet in drawn for letters in sheet.letters for run in letters.runs]
    unknown = glyph("\N{SNOWMAN}")
    assert not {char for text in runs for char in text if glyph(char) == unknown}
    read = [ezdxf.read(io.StringIO(dxf(sheet).decode())) for sheet in drawn]
    assert [one.dxf.text for each in read for one in each.modelspace().query("TEXT")] == runs
    said = " ".join(runs)
    stamps = {"kk": ("Парақтар", "Масштабы", "Әзірлеген"), "uk": ("Аркушів", "Масштаб", "Розробив")}
    captions = re.sub(r"(?s)<(math|svg).*?</\1>|<[^>]*>", " ", " ".join(CAPTION.findall(static(page(code)))))
    numbered = {"kk": "сурет", "uk": "Рисунок"}[code]
    titles = {word for word in WORD.findall(html.unescape(captions)) if word != numbered}
    assert {word for word in (*stamps[code], *titles) if word not in said} == set()


def test_letters_of_sheets_are_drawn_each_by_its_own_strokes():
    drawn = {char: glyph(char) for char in LETTERS + NAME if char != " "}
    unknown = glyph("\N{SNOWMAN}")
    assert all(strokes and strokes != unknown for strokes in drawn.values())
    for one, other in ("кқ", "нң", "гғ", "уұ", "уү", "оө", "єэ", "гґ", "иі", "іï"):
        assert glyph(one) != glyph(other)
