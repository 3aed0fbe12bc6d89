"""Frames and title blocks of GOST 2.104 on the pages of a note, measured as the browser, LaTeX, Typst and LibreOffice
print them."""

from __future__ import annotations

import subprocess
from dataclasses import replace
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
import pdf_words
import pytest
from browser import browser, opened
from conftest import solved
from notes import program
from pdf_words import POINT, Page, Word
from typesetting import set_by_libreoffice, set_by_tex, set_by_typst

from tmm_report import render
from tmm_report.chapters.title.given import Signer, Title
from tmm_report.commands.files import for_typst
from tmm_report.figures.drawing import Drawing, Text
from tmm_report.figures.drawing import Path as Lines
from tmm_report.figures.title_block import FIRST, NEXT, Said, first, following
from tmm_report.i18n import Translator
from tmm_report.profiles import shipped, stated
from tmm_report.report.formats import Tex
from tmm_report.report.numbering import Numbering
from tmm_report.report.page import Page as NotePage
from tmm_report.report.paper.frames import ROLES, signers

NAME = "crank_rocker"
FRAMED = stated(
    "gost", {"frames": True, "margins": {"left": "37 mm", "right": "21 mm"}, "text": {"size": 16}}
)
FORMATS = ["html", "typst", *(pytest.param(fmt, marks=pytest.mark.exhaustive) for fmt in ("tex", "docx"))]
DOTS = 10  # a millimetre
CODE = "ТММ.05.12.000 ПЗ"
# GOST 2.104-2006, forms 2 and 2a, mm from the lower left corner of the block: x, y, to x, to y
BLOCKS = {
    "first": [
        (0, 40, 185, 40), (0, 30, 65, 30), (0, 25, 185, 25), (135, 20, 185, 20), (135, 15, 185, 15), (7, 25, 7, 40),
        (17, 0, 17, 40), (40, 0, 40, 40), (55, 0, 55, 40), (65, 0, 65, 40), (135, 0, 135, 25), (150, 15, 150, 25),
        (165, 15, 165, 25), (140, 15, 140, 20), (145, 15, 145, 20),
        *((0, y, 65, y) for y in (5, 10, 15, 20, 35)),
    ],
    "next": [
        (0, 15, 185, 15), (175, 8, 185, 8), (0, 5, 65, 5), (0, 10, 65, 10), (7, 0, 7, 15), (17, 0, 17, 15),
        (40, 0, 40, 15), (55, 0, 55, 15), (65, 0, 65, 15), (175, 0, 175, 15),
    ],
}  # fmt: skip


@cache
def note(fmt: str) -> dict[str, bytes]:
    results = solved(NAME)
    title = replace(results.variant.title, designation=CODE)
    variant = replace(results.variant, profile=FRAMED, title=title)
    results = replace(results, variant=variant)
    if fmt == "typst":
        return {"note.typst": for_typst(results, "ru", "course")}
    return render(results, fmt, "ru", "course")


@cache
def printed(fmt: str) -> bytes:
    if fmt == "tex":
        return set_by_tex(note("tex"), whole=True)[1]
    if fmt == "typst":
        return set_by_typst(note("typst")["note.typst"])
    if fmt == "docx":
        return set_by_libreoffice(note("docx")["note.docx"])
    with TemporaryDirectory(ignore_cleanup_errors=True) as place, browser(Path(place)) as talk:
        return opened(talk, Path(place), "framed", note("html")["note.html"], print_it=True).pdf


@cache
def pages(fmt: str) -> list[Page]:
    """Places from the lower left corner."""
    return [
        Page(wide, tall, [one._replace(above=tall - one.above, below=tall - one.below) for one in words])
        for wide, tall, words in pdf_words.pages(printed(fmt))
    ]


@cache
def ink(fmt: str, number: int) -> np.ndarray:
    """Where a page is dark; rows from below, DOTS a millimetre."""
    with TemporaryDirectory() as folder:
        (Path(folder) / "note.pdf").write_bytes(printed(fmt))
        command = [program("pdftoppm"), "-r", str(25.4 * DOTS), "-gray", "-f", str(number), "-l", str(number)]
        subprocess.run([*command, f"{folder}/note.pdf", f"{folder}/page"], check=True)
        (file,) = Path(folder).glob("page-*.pgm")
        _, size, _, body = file.read_bytes().split(b"\n", 3)
    wide, high = map(int, size.split())
    return np.frombuffer(body, np.uint8).reshape(high, wide)[::-1] < 160


def drawn(dark: np.ndarray, line: tuple[float, float, float, float]) -> bool:
    """Whether there is a straight line from one place to another, mm, within 0.2 mm."""
    x, y, to, up = (DOTS * one for one in line)
    along, across = ((x, to), y) if y == up else ((y, up), x)
    band = dark if y == up else dark.T
    near = band[round(across) - 2 : round(across) + 3, round(along[0]) + 3 : round(along[1]) - 3]
    return bool(near.any(axis=0).mean() > 0.99)


def on_page(
    lines: list[tuple[float, float, float, float]], wide: float
) -> list[tuple[float, float, float, float]]:
    left = wide - 190
    return [(left + x, 5 + y, left + to, 5 + up) for x, y, to, up in lines]


def frame(
    wide: float, tall: float, left: float = 20, above: float = 5
) -> list[tuple[float, float, float, float]]:
    low, right, high = 5, wide - 5, tall - above
    return [
        (left, low, right, low),
        (left, high, right, high),
        (left, low, left, high),
        (right, low, right, high),
    ]


def within(words: list[Word], left: float, below: float, right: float, above: float) -> list[str]:
    return [
        one.text
        for one in words
        if left <= one.left and one.right <= right and below <= one.below and one.above <= above
    ]


@pytest.mark.parametrize("fmt", FORMATS)
def test_each_page_has_its_frame_and_its_form(fmt):
    blank = np.zeros((2970, 2100), bool)
    assert not drawn(blank, (20, 5, 205, 5))
    for number, form in ((1, []), (2, BLOCKS["first"]), (3, BLOCKS["next"]), (5, BLOCKS["next"])):
        dark = ink(fmt, number)
        missing = [line for line in [*frame(210, 297), *on_page(form, 210)] if not drawn(dark, line)]
        assert not missing
    assert not drawn(ink(fmt, 1), (20, 20, 205, 20)) and not drawn(ink(fmt, 3), (20, 45, 205, 45))


@pytest.mark.parametrize("fmt", FORMATS[:-1])
def test_the_numbers_stand_in_the_blocks(fmt):
    found = pages(fmt)
    assert within(found[1][2], 170, 20, 185, 25.5) == ["2"]
    assert within(found[1][2], 185, 20, 205, 25.5) == [str(len(found))]
    assert CODE in " ".join(within(found[1][2], 85, 30, 205, 45))
    standing = [(k, own) for k, (wide, _, own) in enumerate(found, 1) if k > 2 and round(wide) == 210]
    assert len(standing) > 20
    for k, own in standing:
        assert within(own, 195, 4.5, 205, 13) == [str(k)]
        assert " ".join(within(own, 85, 5, 195, 20)) == CODE
    assert len(within(found[2][2], 37, 30, 189, 282)) > 5  # the contents go on under the smaller block
    assert not [one for one in found[0][2] if one.below < 15 or one.above > 285]


@pytest.mark.parametrize("fmt", FORMATS)
def test_the_text_keeps_its_distance_from_frame_and_block(fmt):
    """GOST 2.105, 3.6: 3 mm at the sides, 10 mm above and below."""
    for k, (wide, tall, own) in enumerate(pages(fmt)):
        if round(wide) == 210 and k:
            top = 45 if k == 1 else 20
            text = [one for one in own if one.above > 5 + top]
            assert min(one.left for one in text) >= 23 and max(one.right for one in text) <= 202
            below = 0.3 * FRAMED.text.size * POINT  # what hangs below the last line
            assert (
                min(one.below for one in text) >= top + 10 - below
                and max(one.above for one in text) <= tall - 14.5
            )


def sideways(word: Word) -> bool:
    return len(word.text) > 5 and word.above - word.below > word.right - word.left


def in_the_middle(words: list[Word], left: float, below: float, right: float, above: float) -> list[str]:
    """Of a cell, 0.5 mm above or below at most: LibreOffice tells boxes a third higher than the letters."""
    middle = (below + above) / 2
    inside = (one for one in words if left <= one.left and one.right <= right)
    return [one.text for one in inside if abs((one.below + one.above) / 2 - middle) < 0.5]


@pytest.mark.exhaustive
def test_word_counts_the_sheets_in_the_blocks():
    found = pages("docx")
    assert in_the_middle(found[1][2], 170, 20, 185, 25) == ["2"]
    assert in_the_middle(found[1][2], 185, 20, 205, 25) == [str(len(found))]
    for k, (wide, _, own) in enumerate(found[2:], 3):
        assert in_the_middle(own, wide - 15, 5, wide - 5, 13) == [str(k)]
    assert len(found) > 20 and len(within(found[2][2], 37, 30, 189, 282)) > 5


@pytest.mark.exhaustive
def test_word_lays_a_page_with_its_frame_and_its_form_on_its_side():
    """A page of its own for each figure; larger sheets, too."""
    sizes = {(round(wide), round(tall)): k for k, (wide, tall, _) in enumerate(pages("docx"), 1)}
    assert {(210, 297), (297, 210)} <= set(sizes)
    for (wide, tall), number in sizes.items():
        lines = [*frame(wide, tall), *on_page(BLOCKS["next"], wide)]
        dark = ink("docx", number)
        assert not [line for line in lines if not drawn(dark, line)], (wide, tall)


@pytest.mark.parametrize("fmt", FORMATS[:-1])
def test_a_page_with_a_figure_sideways_has_its_frame_and_its_form(fmt):
    number = next(k for k, page in enumerate(pages(fmt), 1) if any(map(sideways, page[2])))
    dark = ink(fmt, number)
    assert not [line for line in [*frame(210, 297), *on_page(BLOCKS["next"], 210)] if not drawn(dark, line)]


def test_the_margins_grow_to_what_a_frame_needs():
    plain = stated("gost", {"frames": True}).margins
    assert (plain.left, plain.right, plain.top, plain.bottom) == (30, 15, 20, 30)
    small = stated(
        "plain", {"frames": True, "margins": dict.fromkeys(("left", "right", "top", "bottom"), "1 mm")}
    )
    assert (small.margins.left, small.margins.right, small.margins.top, small.margins.bottom) == (
        23,
        8,
        15,
        30,
    )
    assert (
        not shipped().frames and "top-left-corner" not in render(solved(NAME), "html")["note.html"].decode()
    )


ALL = ("Drawn by", "Checked by", "Tech. check", "", "Std. check", "Approved by")


@pytest.mark.parametrize(
    ("code", "role", "row"),
    [
        ("ru", "Нормоконтроль", 4), ("ru", "Н. контр.", 4), ("ru", "Нормоконтролёр", 4), ("ru", "Зав. кафедрой", 5),
        ("ru", "Заведующий кафедрой", 5), ("ru", "Утвердил", 5), ("ru", "Техконтроль", 2), ("ru", "Т. контр.", 2),
        ("uk", "Нормоконтроль", 4), ("uk", "Завідувач кафедри", 5), ("uk", "Затвердив", 5), ("en", "Std. check", 4),
        ("kk", "Норма бақылау", 4), ("kk", "Кафедра меңгерушісі", 5), ("kk", "Бекіткен", 5), ("kk", "Т. бақылау", 2),
        ("en", "Head of the department", 5), ("en", "Approved by", 5), ("en", "Tech. check", 2), ("ru", "Рецензент", 3),
        ("en", "Head of laboratory", 3), ("ru", "Начальник бюро", 3), ("ru", "Технолог", 3), ("ru", "Проверил", 3),
    ],
)  # fmt: skip
def test_who_signs_has_the_row_of_the_role(code, role, row):
    """One of no row of the form, or of one that is taken, has the free row, by the role as it is stated."""
    page = NotePage(Tex(), Translator(code), Numbering())
    found = signers(Title(student="А", teacher="Б", signed=(Signer(role, "В"),)), page, ALL)
    names = ["А", "Б", "", "", "", ""]
    names[row] = "В"
    assert [name for _, name in found] == names
    assert found[3][0] == (role if row == 3 else "") and found[4][0] == page.tr.gettext("Std. check")


def test_of_several_who_sign_each_has_a_row_of_its_own():
    page = NotePage(Tex(), Translator("ru"), Numbering())
    many = [("Утв.", "Г"), ("Зав. кафедрой", "Д"), ("Рецензент", "Е"), ("Проверил", "Ж")]
    found = signers(Title(student="А", signed=tuple(Signer(*one) for one in many)), page, ROLES)
    assert [name for _, name in found] == ["А", "Ж", "Д", "", "Г"] and found[2][0] == "Зав. кафедрой"


LONG = "Проектирование и исследование механизмов поперечно-строгального станка с вращающейся кулисой " * 4
WORDS = {word: word for word in ("Изм.", "Лист", "№ докум.", "Подп.", "Дата", "Лит.", "Листов")}
CELLS = [(65, 25, 185, 40), (65, 0, 135, 25), (135, 0, 185, 15), (0, 0, 17, 25), (17, 0, 40, 25)]


@pytest.mark.parametrize("text", ["", "ПЗ", LONG, "W" * 300, "\\input{x}%</svg>$", "\u202e" + "Ж" * 50])
def test_what_is_written_stays_in_its_cell(text):
    said = Said(text, text, text, [(text, text)] * 5, WORDS)
    for block, form in ((first(said), FIRST), (following(said), NEXT)):
        assert block.box == (0, 0, 185, form.tall)
        for one in texts(block):
            left, low, right, high = one.box
            lines = [
                line
                for line in corners(block)
                if crosses(line, left + 0.1, low + 0.4, right - 0.1, high - 0.4)
            ]
            assert not lines, (one, lines)
    if len(text) > 200:
        assert any(one.parts[0].endswith("…") for one in texts(first(said)))


def texts(block: Drawing) -> list[Text]:
    return [item for item in block.items if isinstance(item, Text)]


def corners(block: Drawing) -> list[tuple[complex, ...]]:
    return [stroke for item in block.items if isinstance(item, Lines) for stroke in item.strokes]


def crosses(line: tuple[complex, ...], left: float, low: float, right: float, high: float) -> bool:
    (x, to), (y, up) = sorted(z.real for z in line), sorted(z.imag for z in line)
    return x < right and to > left and y < high and up > low
