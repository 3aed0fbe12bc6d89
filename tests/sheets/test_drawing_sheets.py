"""The drawing sheets as they stand on paper: nothing over another, within the frame, lengths, lines and letters."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from dataclasses import replace
from html import unescape
from itertools import combinations
from xml.etree import ElementTree

import numpy as np
import pytest
from conftest import solved
from drawn import (
    EVERY,
    SOME,
    crossed,
    figures_on,
    form_letters,
    ink,
    lines_of,
    pictures_of,
    said,
    sheets_of,
    touching,
)
from exhaustive import many
from notes import drawn as drawn_in_note
from notes import note

from tmm_report import render, sheets
from tmm_report.chapters.title.given import Signer
from tmm_report.commands.files import translator
from tmm_report.figures.drawing import Drawing, Path, Pen, Text, line, svg
from tmm_report.figures.lettering import Symbol
from tmm_report.figures.sheets.block import Block
from tmm_report.figures.sheets.form import Said, form, within
from tmm_report.figures.sheets.sheet import FORMATS, Sheet, placed
from tmm_report.figures.sheets.strokes import Letters, glyph
from tmm_report.i18n import Translator
from tmm_report.problems import ProblemError
from tmm_report.quantity.paper import ROUND
from tmm_report.report.formats import drawing_of
from tmm_report.report.paper.frames import WORDS

SVG = "{http://www.w3.org/2000/svg}"
WORDS_HERE = {word: word for word in (*WORDS, "Масса", "Масштаб", "Формат")}
PER_MM = re.compile(r"= ([\d,]+)[^=]*?/мм")
A1 = next(one for one in FORMATS if one.name == "A1")


def apart(one, other) -> bool:
    return one[2] <= other[0] or other[2] <= one[0] or one[3] <= other[1] or other[3] <= one[1]


def misplaced(sheet: Sheet) -> Iterator[str]:
    """Pictures over others or beyond their field, letters over others or on lines."""
    wide, tall = sheet.format.wide, sheet.format.tall
    inked = [(ink(block), said(block)) for block in sheet.blocks]
    for (one, first), (other, second) in combinations(inked, 2):
        if not apart(one, other):
            yield f"{first} lies over {second}"
    for (left, bottom, right, top), title in inked:  # GOST 2.104: 20 mm at the left, 5 mm at the other sides
        if not (left > 20 and bottom > 5 and right < wide - 5 and top < tall - 5):
            yield f"{title} leaves the frame"
        for corner in ((wide - 5 - 185, 5, wide - 5, 5 + 55), (20, tall - 5 - 14, 20 + 70, tall - 5)):
            if not apart((left, bottom, right, top), corner):
                yield f"{title} lies over the title block"
    for letters in (form_letters(sheet), *(block.letters for block in sheet.blocks)):
        yield from (f"{one} lies on {other}" for one, other in touching(letters))
    for block in sheet.blocks:
        yield from (f"{one} of {said(block)} lies on a line" for one in crossed(block))


def not_to_standard(sheet: Sheet) -> Iterator[str]:
    """Letters that are no strokes or too low, by GOST 2.304; lines that are none of GOST 2.303."""
    if any(isinstance(item, Text) for item in sheet.drawing.items):
        yield "letters of a font"
    if any(run.tall < 3.5 for letters in sheet.letters for run in letters.runs):
        yield "letters lower than 3.5 mm"
    pens = {item.pen for block in sheet.blocks for item in block.items if getattr(item, "pen", None)}
    yield from (f"{pen} is no line" for pen in pens if not drawn_by_the_standard(pen))


def drawn_by_the_standard(pen: Pen) -> bool:
    thin = 0.2 <= pen.width <= 0.3  # from s/3 to s/2
    if pen.colour != "black" or (pen.dash and not thin):
        return False
    if not pen.dash:
        return thin or pen.width == 0.6  # s
    if len(pen.dash) == 2:
        return 2 <= pen.dash[0] <= 8 and 1 <= pen.dash[1] <= 2
    # a dash of 5 to 30 mm, between dashes 3 to 5 mm with one dot, 4 to 6 with two
    between, (low, high) = sum(pen.dash[1:]), {4: (3, 5), 6: (4, 6)}[len(pen.dash)]
    return 5 <= pen.dash[0] <= 30 and low <= between <= high


@pytest.mark.parametrize("name", EVERY)
def test_sheets_hold_each_picture_of_the_note_in_its_place_and_by_the_standards(name):
    """By the lines of the pictures and the strokes of each run of letters: a symbol and its index are two."""
    assert sum(len(sheet.blocks) for sheet in sheets_of(name)) == len(pictures_of(name))
    wrong = [
        f"{one.name}: {text}" for one in sheets_of(name) for text in (*misplaced(one), *not_to_standard(one))
    ]
    assert not wrong, "\n".join(wrong)


def test_letters_that_touch_are_seen():
    one, other = Letters(0j, (Symbol("v", "BA"),), 5.0), Letters(5 - 2j, ("A",), 3.5)
    assert list(touching([one, other])) and not list(touching([one, other.moved(4 + 0j)]))
    assert crossed(Block((line(-1 - 3j, 20 - 3j),), (one,), ()))
    assert not crossed(Block((line(-1 - 6j, 20 - 6j),), (one,), ()))


@pytest.mark.parametrize("name", many(("rotor", "compressor")))
def test_every_picture_of_the_note_is_on_one_sheet(name):
    page = note(name, "html", depth=None)["note.html"].decode()
    assert sum(len(sheet.blocks) for sheet in sheets_of(name)) == page.count("<figure")


def plain(text: str) -> str:
    """Without what only keeps words together, with the dash of the sheets."""
    return unescape(text).replace("\N{WORD JOINER}", "").replace("\N{NO-BREAK SPACE}", " ").replace("—", "–")


@pytest.mark.parametrize("name", SOME)
def test_a_picture_is_called_on_its_sheet_as_under_the_same_drawing_in_the_note(name):
    """But for what is drawn otherwise in the shorter note that the sheets are of."""
    page = note(name, "html")["note.html"].decode()
    captions = {
        anchor: plain(re.sub("<[^>]*>", "", caption))
        for anchor, caption in re.findall(
            r'<figure id="([^"]+)".*?<figcaption>(.*?)</figcaption>', page, re.S
        )
    }
    in_note, found = drawn_in_note(name), 0
    for figure in pictures_of(name):
        items = drawing_of(figure.picture).items
        called = [
            captions[anchor] for anchor, one in in_note.items() if one.items == items and anchor in captions
        ]
        words = plain(next(one for one in figure.title if isinstance(one, str))).rstrip("\N{NULL} ,;")
        assert words and (not called or any(words in caption for caption in called)), (words, called)
        found += bool(called)
    assert found > 0.8 * len(pictures_of(name))


def test_sheets_have_their_chapters_in_the_order_of_the_project():
    kinds = {
        name: [one.name for one in sheets_of(name)] for name in ("compressor", "cam_press", "hoist_drive")
    }
    assert kinds["compressor"] == ["1_kinematics", "2_forces", "3_machine", "4_gears"]
    assert kinds["cam_press"][-1] == "4_cam" and kinds["hoist_drive"] == ["1_gears"]
    titles = {one.name: " ".join(map(said, one.blocks)) for one in sheets_of("compressor")}
    for sheet, words in {
        "1_kinematics": ("План 12 положений", "План скоростей", "План ускорений", "Диаграммы движения"),
        "2_forces": ("План сил", "Схема нагружения", "Рычаг Жуковского", "уравновешивающего момента"),
        "3_machine": ("Маховик", "энергомасс"),
        "4_gears": ("Картина зацепления", "Кинематическая схема зубчатого", "скольжение"),
    }.items():
        assert all(word in titles[sheet] for word in words)


@pytest.mark.parametrize("name", many(("cam_press", "compressor", "shaper_project")))
def test_vectors_on_the_sheet_are_those_of_the_results(name):
    """Of the SVG: the length of a vector, times what its title says of a millimetre, against results.json."""
    tables = json.loads(note(name, "json")["results.json"])["tables"]
    values: dict[str, list[float]] = {}
    for table in (one for key, one in tables.items() if key.startswith("comparison_")):
        rows = (
            {column["key"]: column["values"] for column in table["columns"]} if "columns" in table else table
        )
        for key, value in zip(rows["key"], rows["graph"], strict=True):
            values.setdefault(key, []).append(abs(value))
    seen = 0
    for block in (block for sheet in sheets_of(name) for block in sheet.blocks):
        found = re.search(r"План (?:скоростей|ускорений).*= ([\d,]+) \(м/с", said(block))
        if not found:
            continue
        root, scale = ElementTree.fromstring(svg(Drawing(block.items))), float(found[1].replace(",", "."))
        for group in root.iter(f"{SVG}g"):
            if group.get("data-q") in values:
                start, end = _ends(group)
                own = values[group.get("data-q")]
                assert min(abs(abs(end - start) - value / scale) for value in own) < 0.05
                seen += 1
    assert seen >= 6


def _ends(group) -> tuple[complex, complex]:
    """Of an arrow: its start, and the tip, with which its head begins; y up."""
    shaft, head = (re.findall(r"-?[\d.]+(?:e-?\d+)?", path.get("d")) for path in group.iter(f"{SVG}path"))
    return complex(float(shaft[0]), -float(shaft[1])), complex(float(head[0]), -float(head[1]))


@pytest.mark.parametrize("name", SOME)
def test_pictures_are_as_large_as_in_the_note_or_at_another_round_scale(name):
    """The printed scale and the drawn length go together: of every picture, by all of its lines but those of a grid;
    of a graph by its curves."""
    tr = translator(solved(name).variant)
    for figure, times, block in (one for sheet in sheets_of(name) for one in figures_on(sheet, name)):
        told = [float(text.replace(",", ".")) for text in PER_MM.findall(said(block))]
        noted = [float(text.replace(",", ".")) for text in PER_MM.findall(said(figure.block(1.0, tr)))]
        assert told == pytest.approx([one / times for one in noted])
        if all(one in ROUND for one in map(digits, noted)):
            assert all(one in ROUND for one in map(digits, told))
        if times != 1 and not told:  # not to scale
            assert not re.search(r"\d:\d", said(block))
        if not figure.diagram:
            texts = [item.parts for item in figure.drawing.items if isinstance(item, Text)]
            lettered = [one.parts for one in block.letters]
            assert all(lettered.count(one) >= texts.count(one) for one in texts)
        for old, new in lines_of(figure, block):
            was, now = (
                np.concatenate([np.abs(np.diff(stroke)) for stroke in one.strokes]) for one in (old, new)
            )
            assert np.allclose(now, times * was, atol=1e-6)


def digits(value: float) -> float:
    return float(f"{value:.5e}".partition("e")[0])


@pytest.mark.parametrize("char", "НABЖΩ0")
def test_a_capital_is_as_high_as_it_is_said_to_be(char):
    points = [z for stroke in Letters(0j, (char,), 3.5).path.strokes for z in stroke]
    assert max(z.imag for z in points) - min(z.imag for z in points) == pytest.approx(3.5, abs=0.02)


def test_letters_of_the_languages_are_there():
    box = glyph("\uffff").strokes
    russian = "абвгдеёжзийклмнопрстуфхцчшщъыьэюя"
    for char in (
        russian
        + russian.upper()
        + "іїєґўқңғүұһөә"
        + "αβγδεζηθικλμνξπρστυφχψωΩΔΣ"
        + "0123456789°′·×−–—«»₀₂²³±≤≥→∥"
    ):
        assert glyph(char).strokes != box, char


# GOST 2.104-2006, form 1, mm from the lower left corner of the block: x, y, to x, to y
FORM = {
    (0, 55, 185, 55), (65, 40, 185, 40), (0, 35, 65, 35), (135, 35, 185, 35), (0, 30, 65, 30), (135, 20, 185, 20),
    (65, 15, 185, 15), (0, 0, 185, 0), *((0, y, 65, y) for y in (5, 10, 15, 20, 25, 40, 45, 50)),
    (0, 0, 0, 55), (7, 30, 7, 55), (17, 0, 17, 55),
    (40, 0, 40, 55), (55, 0, 55, 55), (65, 0, 65, 55), (135, 0, 135, 40),
    (140, 20, 140, 35), (145, 20, 145, 35),
    (150, 20, 150, 40), (155, 15, 155, 20), (167, 20, 167, 40), (185, 0, 185, 55),
}  # fmt: skip

LONG = "Очень длинное название " * 40
HOSTILE = (
    "<script>alert(1)</script>]]>&\x00\x1b[31m",
    "%%c^I\\U+0041 {\\fArial;}",
    "\u202e\ud800💥",
    "слово" * 200,
    LONG,
)


def stamped(text: str) -> Said:
    return Said(text, text, text, text, [(text, text)] * 6, text, 1, 9, WORDS_HERE)


def test_the_title_block_has_the_lines_of_form_1():
    lines, _ = form(stamped(""))
    found = {(a.real, a.imag, b.real, b.imag) for item in lines for a, b in item.strokes}
    assert found == FORM


@pytest.mark.parametrize("text", HOSTILE)
def test_no_name_leaves_its_cell(text):
    lines, letters = form(stamped(text))
    lines = [(a, b) for item in lines for a, b in item.strokes]
    for one in letters:
        left, bottom, right, top = one.box
        assert min(run.tall for run in one.runs) >= 3.5
        assert left >= 0 and right <= 185 and bottom >= -0.7 and top <= 55
        for a, b in lines:
            if a.real == b.real and min(a.imag, b.imag) < one.at.imag < max(a.imag, b.imag):
                assert right <= a.real or left >= a.real


@pytest.mark.parametrize("text", ["ТММ.01.12.000", *HOSTILE])
def test_the_designation_stands_on_its_head_in_the_upper_left_corner(text):
    """Graph 26, 70 mm by 14. The other way: the sheet turned, it is what stands upright in a cell of that size."""
    sheet = Sheet("1_x", A1, (), stamped(text))
    corner = complex(20, A1.tall - 5)
    lines = [set(item.strokes[0]) for item in sheet.items if isinstance(item, Path) and item.closed]
    assert {corner, corner + 70, corner + 70 - 14j, corner - 14j} in lines
    on_head = [one for one in sheet.letters if one.turned]
    assert on_head and all(min(run.tall for run in one.runs) >= 3.5 for one in on_head)
    middle = corner + 35 - 7j
    upright = [
        sorted((z.real, z.imag) for stroke in one.path.strokes for z in stroke)
        for one in within((middle.real - 35, middle.imag - 7, 70, 14), text, 7.0)
    ]
    for one, other in zip(on_head, upright, strict=True):
        back = sorted(
            (z.real, z.imag) for stroke in one.path.strokes for z in (2 * middle - w for w in stroke)
        )
        assert np.allclose(back, other, atol=1e-9)
        left, bottom, right, top = one.box
        assert (
            corner.real <= left
            and right <= corner.real + 70
            and bottom >= corner.imag - 14
            and top <= corner.imag + 0.7
        )


@pytest.mark.parametrize("text", HOSTILE)
def test_hostile_names_stay_text(text):
    sheet = Sheet("1_x", A1, (), stamped(text))
    written = svg(sheet.drawing).encode("utf-8", "strict")
    root = ElementTree.fromstring(written)
    assert {element.tag for element in root.iter()} <= {
        SVG + tag for tag in ("svg", "g", "path", "title", "circle")
    }


def figure(drawing: Drawing, *title) -> sheets.Figure:
    return sheets.Figure(drawing, "forces", title)


@pytest.mark.parametrize(
    ("long", "name"), [(900.0, "A0"), (1500.0, "A0x2"), (2300.0, "A0x3"), (30000.0, "A0x3")]
)
def test_what_a1_does_not_hold_has_larger_paper_or_a_ratio(long, name):
    found = list(
        sheets._sheets(
            [figure(Drawing((line(0j, complex(long, 40.0)),)), "План, масштаб 1:1")], Translator("ru")
        )
    )
    assert [size.name for size, _ in found] == [name]
    drawn, title = found[0][1][0], said(found[0][1][0])
    [(start, end)] = drawn.items[0].strokes
    ratio = re.search(r"\(1:(\d+)\)$", title)
    assert (ratio is None) == (long < 2400)
    assert abs(end - start) * float(ratio[1] if ratio else 1) == pytest.approx(abs(complex(long, 40.0)))


def test_what_one_sheet_does_not_hold_goes_on_to_the_next():
    many = [figure(Drawing((line(0j, 300 + 250j),)), f"План {n}") for n in range(9)]
    found = list(sheets._sheets(many, Translator("ru")))
    assert len(found) >= 3 and all(size.name == "A1" for size, _ in found[:-1])
    titles = [said(block) for _, blocks in found for block in blocks]
    assert sorted(titles) == sorted(f"План {n}" for n in range(9))


def test_pictures_share_the_room_of_their_sheet():
    """As much above, between and below them, and to either side."""
    two = [figure(Drawing((line(0j, 100 + 50j),)), f"План {n}, масштаб 1:1") for n in (1, 2)]
    [(size, blocks)] = sheets._sheets(two, Translator("ru"))
    assert size.name == "A4"
    first, second = sorted((block.box for block in blocks), key=lambda box: -box[1])
    rooms = (297 - 5 - 14 - first[3], first[1] - second[3], second[1] - 5 - 55)
    assert rooms == pytest.approx([sum(rooms) / 3] * 3, abs=0.1)
    for left, _, right, _ in (first, second):
        assert left - 20 == pytest.approx(210 - 5 - right, abs=0.1)


def test_a_small_picture_has_small_paper():
    [(size, _)] = sheets._sheets([figure(Drawing((line(0j, 100 + 60j),)), "План")], Translator("ru"))
    assert size.name == "A4"
    assert not placed(size, [figure(Drawing((line(0j, 186 + 10j),)), "План").block(1.0, Translator("ru"))])


def test_what_has_letters_that_meet_grows_first():
    """Only one of two pictures not to scale has room to grow: the other has more letters, all of them clear."""
    rows = [line(4j * n, 100 + 4j * n) for n in range(20)]
    meeting = Drawing((*rows, Text(50 + 34j, ("МНК",), 3.2, 0)))
    crowded = Drawing(
        tuple(Text(complex(x, y), ("7",), 3.2) for x in range(0, 100, 8) for y in range(0, 80, 9))
    )
    [(size, blocks)] = sheets._sheets([figure(crowded, "План"), figure(meeting, "План")], Translator("ru"))
    assert size.name == "A4"
    assert not figure(meeting, "План").block(1.0, Translator("ru")).clear
    assert all(block.clear and not crossed(block) for block in blocks)


def test_a_variant_without_a_picture_is_told_so(monkeypatch):
    monkeypatch.setattr(sheets, "figures", lambda results, tr: [])
    with pytest.raises(ProblemError, match="no picture"):
        render(solved("rotor"), "sheets")


def test_names_of_the_variant_stand_in_the_title_block():
    results = solved("compressor")
    signed = (Signer("Нормоконтроль", "Котов Н. Н."), Signer("Консультант", "Репин К. К."))
    title = replace(
        results.variant.title, designation="ТММ.07.00.000 ПЗ", student="Ильина А. А.", signed=signed
    )
    changed = replace(results, variant=replace(results.variant, title=title))
    for sheet in sheets.composed(changed, translator(results.variant), pictures_of("compressor")):
        assert [role for role, name in sheet.said.people if name] == [
            "Разраб.",
            "Пров.",
            "Консультант",
            "Н. контр.",
        ]
        written = {"".join(map(str, one.parts)) for one in sheet.frame[1]}
        assert {
            "ТММ.07.00.000",
            "Ильина А. А.",
            "Котов Н. Н.",
            "Репин К. К.",
            f"Лист {sheet.said.number}",
        } <= written
        # GOST 2.104: how many there are says the first
        assert ("Листов 4" if sheet.said.number == 1 else "Листов") in written


def test_a_sheet_alone_has_no_number():
    _, letters = form(replace(stamped("Тема"), count=1))
    written = {"".join(map(str, one.parts)) for one in letters}
    assert {"Лист", "Листов 1"} <= written and "Лист 1" not in written


@pytest.mark.parametrize("name", many(("press", "compressor", "shaper_project")))
def test_no_diagram_takes_the_room_of_a_plan(name):
    """Where diagrams have been made larger, no plan of vectors that is as in the note has room to be."""
    tr = translator(solved(name).variant)
    for sheet in sheets_of(name):
        shown = list(figures_on(sheet, name))
        least = [
            figure.block(1.0, tr) if figure.diagram and figure.block(1.0, tr).clear else block
            for figure, _, block in shown
        ]
        for k, (figure, times, _) in enumerate(shown):
            if times == 1 and figure.larger and not figure.diagram:
                large = figure.block(figure.larger[0], tr)
                assert len(placed(sheet.format, [*least[:k], large, *least[k + 1 :]])) < len(shown)


def test_curves_told_apart_by_their_dashes_are_so_on_the_sheet():
    dashes = ((), (1.0, 0.8), (3.0, 1.0), (5.0, 1.0), (2.4, 0.8, 0.5, 0.8), (3.2, 0.8, 0.5, 0.8, 0.5, 0.8))
    drawn = Drawing(tuple(line(0j, 50 + 1j * n, Pen(0.4, dash=dash)) for n, dash in enumerate(dashes)))
    block = figure(drawn, "План").block(1.0, Translator("ru"))
    assert len({item.pen.dash for item in block.items}) == len(dashes)
