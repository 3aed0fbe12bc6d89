"""XLSX as Excel, LibreOffice and Google write it, and as nobody honest does."""

import io
import os
import shutil
import zipfile
from contextlib import suppress
from datetime import datetime
from pathlib import Path

import openpyxl
import pytest
from confined import confined
from exhaustive import many
from hypothesis import given, settings
from hypothesis import strategies as st
from packing import packed
from workbooks import HEAD, MAIN, RELATIONS, cells, inline, parts, strings, workbook

from tmm_report.intake.cells import number
from tmm_report.intake.sheets import Sheet, read_sheets
from tmm_report.problems import ProblemError

ATTACKS = Path(__file__).parent / "attacks"


def sheets(content: bytes, **limits) -> list[Sheet]:
    return read_sheets("a.xlsx", "a.xlsx", content, **limits)


def texts(content: bytes) -> list[list[str]]:
    (only,) = sheets(content)
    return [list(only.header), *([cell.text for cell in row] for row in only.rows)]


def refusal(content: bytes) -> str:
    with pytest.raises(ProblemError) as caught:
        sheets(content)
    return "\n".join(problem.text() for problem in caught.value.problems)


def saved(rows, title="таблица") -> bytes:
    book = openpyxl.Workbook()
    book.active.title = title
    for row in rows:
        book.active.append(row)
    out = io.BytesIO()
    book.save(out)
    return out.getvalue()


def test_a_workbook_of_a_library_is_read():
    rows = [["k", "v_B, м/с"], [0, 1.25], [1, -3.5e-7], [None, "н/д"]]
    (only,) = sheets(saved(rows))
    assert (only.name, only.label, only.header) == ("таблица", "a.xlsx!таблица", ("k", "v_B, м/с"))
    assert [[cell.text for cell in row] for row in only.rows] == [
        ["0", "1.25"],
        ["1", "-3.5e-07"],
        ["", "н/д"],
    ]
    assert (only.rows[1][1].line, only.rows[1][1].column) == (3, 2)


@given(st.lists(st.floats(allow_nan=False, allow_infinity=False), min_size=1, max_size=5))
def test_numbers_keep_all_their_digits(numbers):
    content = workbook(
        cells(inline("v") * len(numbers), "".join(f"<c><v>{value!r}</v></c>" for value in numbers))
    )
    assert [number(text) for text in texts(content)[1]] == numbers


def test_strings_of_the_list_rich_ones_and_how_they_are_said():
    shared = strings(
        "<t>k</t>",
        '<r><t>v</t></r><r><t xml:space="preserve">_B, </t></r><r><t>м/с</t></r>',
        "<t>一</t><rPh><t>ichi</t></rPh>",
    )
    content = workbook(cells('<c t="s"><v>0</v></c><c t="s"><v>1</v></c><c t="s"><v>2</v></c>'), shared)
    assert texts(content) == [["k", "v_B, м/с", "一"]]


def test_a_formula_stands_for_its_stored_value():
    row = '<c><f>1+1</f><v>2</v></c><c><f>A1</f></c><c t="str"><f>B1</f><v>текст</v></c>'
    row += '<c t="b"><v>1</v></c><c t="e"><v>#DIV/0!</v></c>'
    assert texts(workbook(cells(inline("h") * 5, row)))[1] == ["2", "", "текст", "TRUE", "#DIV/0!"]


def test_places_come_from_references_where_there_are_some():
    rows = '<row><c r="B1"><v>1</v></c><c><v>2</v></c></row><row r="5"><c r="C5"><v>3</v></c></row>'
    sheet = f'<worksheet xmlns="{MAIN}"><sheetData>{rows}</sheetData></worksheet>'
    (only,) = sheets(workbook(sheet))
    assert only.header == ("", "1", "2")
    assert [(cell.text, cell.line, cell.column) for cell in only.rows[0] if cell.text] == [("3", 5, 3)]


def test_prefixes_strict_namespaces_and_other_encodings():
    row = "<x:row><x:c><x:v>1</x:v></x:c></x:row>"
    prefixed = f'<x:worksheet xmlns:x="{MAIN}"><x:sheetData>{row}</x:sheetData></x:worksheet>'
    strict = cells("<c><v>1</v></c>").replace(MAIN, "http://purl.oclc.org/ooxml/spreadsheetml/main")
    wide = cells("<c><v>1</v></c>").replace("UTF-8", "UTF-16").encode("utf-16")
    for sheet in (prefixed, strict, wide):
        assert texts(workbook(sheet)) == [["1"]]


def test_escapes_are_read_and_control_characters_are_not():
    assert texts(workbook(cells(inline("_x0041_B_x0007_") + inline("_x005F_x0041_")))) == [["AB", "_x0041_"]]


def test_a_number_taken_for_a_date_is_told():
    """A Russian spreadsheet makes 1 May of 1.5: reading its serial number would be nobody's answer."""
    content = saved([["v"], [datetime(2026, 5, 1)], [datetime(2026, 5, 1, 12, 30)], [46143]])
    (only,) = sheets(content)
    assert [row[0].text for row in only.rows] == ["2026-05-01", "2026-05-01 12:30:00", "46143"]
    first, _ = only.notes
    assert first.text().startswith(
        "a.xlsx!таблица:2:1: the spreadsheet holds a date here, 2026-05-01; give the cell"
    )


@pytest.mark.parametrize(
    ("code", "dated"),
    [
        ("dd.mm.yyyy", True),
        ("[h]:mm", True),
        ("0.00", False),
        ("0.0&quot; days&quot;", False),
        ("General", False),
        ("[Red]0", False),
        (r"0\d", False),
    ],
)
def test_dates_are_told_by_the_format(code, dated):
    own = f"<numFmts><numFmt numFmtId='170' formatCode='{code}'/></numFmts>"
    used = "<cellStyleXfs><xf numFmtId='14'/></cellStyleXfs><cellXfs><xf numFmtId='0'/><xf numFmtId='170'/></cellXfs>"
    styles = f"<styleSheet xmlns='{MAIN}'>{own}{used}</styleSheet>"
    (only,) = sheets(workbook(cells(inline("v"), '<c s="1"><v>1.5</v></c>'), styles=styles))
    assert bool(only.notes) == dated


def test_several_sheets_and_empty_ones():
    assert [sheet.name for sheet in sheets(workbook(cells("<c><v>1</v></c>"), names=("a", "b")))] == [
        "a",
        "b",
    ]
    assert sheets(workbook(cells())) == []


@pytest.mark.parametrize("name", ["X01_entity_bomb.xlsx", "X02_xxe.xlsx"])
def test_entities_are_refused(name):
    assert (
        refusal((ATTACKS / name).read_bytes())
        == "a.xlsx: the workbook declares a document type, as no honest one does"
    )


BOMB = '<!DOCTYPE w [<!ENTITY a "1234567890"><!ENTITY b "&a;&a;">]>'


@pytest.mark.parametrize("encoding", ["utf-8", "utf-16", "utf-16-be"])
@pytest.mark.parametrize(
    "part",
    [
        "xl/worksheets/sheet1.xml",
        "xl/sharedStrings.xml",
        "xl/styles.xml",
        "xl/workbook.xml",
        "_rels/.rels",
        "xl/_rels/workbook.xml.rels",
    ],
)
def test_a_document_type_is_refused_in_any_part_and_encoding(part, encoding):
    made = parts(cells(inline("v"), "<c><v>1</v></c>"))
    text = made[part].decode().removeprefix(HEAD)
    made[part] = (
        "\ufeff" * (encoding == "utf-16-be")
        + f'<?xml version="1.0" encoding="{encoding[:6].rstrip("-")}"?>{BOMB}{text}'
    ).encode(encoding)
    assert "declares a document type" in refusal(packed(made))


def test_far_cells_are_passed_over_and_told():
    (only,) = sheets((ATTACKS / "X03_far_cell.xlsx").read_bytes())
    assert (only.header, only.rows) == (("1",), ())
    assert "cells beyond row 2001 or column 120 are not read" in only.notes[0].text()


def test_links_to_the_outside_are_not_followed():
    made = parts(cells("<c><v>1</v></c>"))
    sheet = f'<Relationship Id="rId1" Type="{RELATIONS}/worksheet"'
    for target in ('TargetMode="External" Target="http://evil/sheet.xml"', 'Target="../../../../etc/passwd"'):
        made["xl/_rels/workbook.xml.rels"] = f"<Relationships>{sheet} {target}/></Relationships>".encode()
        assert sheets(packed(made)) == []


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (b"", "a.xlsx: this is not a ZIP archive"),
        (b"\xd0\xcf\x11\xe0" + bytes(600), "a.xlsx: the workbook has a password or an old format; save it as .xlsx"),
        (packed({"a.txt": b"hello"}), "a.xlsx: this is not a workbook"),
        (bytes(5 * 2**20 + 1), "a.xlsx: the file is larger than 5120 kB"),
        (workbook("<worksheet><sheetData>"), "a.xlsx: the workbook is broken: its part xl/worksheets/sheet1.xml"),
        (workbook(cells(inline("a" * 201))), "a.xlsx!S:1:1: a cell is longer than 200 characters"),
        (workbook(cells("<c><v>1</v></c>"), names=("a",) * 61), "a.xlsx: the workbook has more than 60 sheets"),
        (workbook(cells('<c t="s"><v>7</v></c>')), "a.xlsx!S:1:1: the cell stands for a text that the workbook"),
        (packed({**parts(cells()), "../x.xml": b"1"}), "a.xlsx:../x.xml: the name leads out of the archive"),
    ],
)  # fmt: skip
def test_what_cannot_be_read_is_told(content, said):
    assert refusal(content).startswith(said)


def test_more_cells_in_a_row_than_the_head_has_are_told():
    assert "a.xlsx!S:2:2: the row has more cells" in refusal(
        workbook(cells("<c><v>1</v></c>", "<c><v>1</v></c>" * 2))
    )


def test_labels_are_printable():
    (only,) = sheets(workbook(cells("<c><v>1</v></c>"), names=("\u202egnp",)))
    assert "\u202e" not in only.label


READ = """
with open(sys.argv[1], "rb") as stream:
    content = stream.read()
limit("RLIMIT_AS", own() + 150 * 2**20) if sys.platform == "linux" else None
try:
    print([(len(sheet.header), len(sheet.rows)) for sheet in sheets.read_sheets("a.xlsx", "a.xlsx", content)])
except ProblemError as error:
    print(error.problems[0].text())
"""


def padded(text: str, begin: str = "<sheetData>") -> str:
    """With noise that is packed badly, so that the rest may be packed well and the ratio is an honest one."""
    return text.replace(begin, f"<!--{os.urandom(2**18).hex()}-->{begin}", 1)


BOMBS = {
    "a row of cells": (lambda: parts(padded(cells("<c/>" * 4_000_000))), "too many cells"),
    "rows": (lambda: parts(padded(cells(*["<c/>"] * 600_000))), "[]"),
    "a row of numbers": (lambda: parts(padded(cells("<c><v>1</v></c>" * 450_000))), "[(120, 0)]"),
    "strings": (lambda: parts(cells(), padded(strings(*[""] * 1_200_000), "<si>")), "[]"),
    "a long text": (lambda: parts(cells(inline("a" * 15_000_000))), "packed more than 100 times"),
    "a long text with noise": (lambda: parts(padded(cells(inline("a" * 900_000)))), "longer than 200 characters"),
    "elements in elements": (lambda: parts(padded("<a>" * 2_500_000 + "<sheetData>")), "too many cells"),
    "attributes": (lambda: parts(padded(cells(f"<c {' '.join(f'a{n}=_' for n in range(400_000))}/>"))), "broken"),
    "parts": (lambda: {**parts(cells()), **{f"xl/{n}.xml": b"" for n in range(25_000)}}, "more than 20000 files"),
    "large parts": (lambda: {**parts(cells()), **{f"xl/{n}.bin": bytes(9 * 2**20) for n in range(8)}}, "100 times"),
    "large together": (
        lambda: {**parts(cells()), **{f"xl/{n}.bin": os.urandom(2**14) * 90 for n in range(15)}}, "larger than 20 MB",
    ),
    "quoted attributes": (
        lambda: parts(cells("<c" + "".join(f' a{n:x}=">"' for n in range(1_500_000)) + "/>")), "is broken",
    ),
    "spaces in numbers": (
        lambda: parts(padded(cells(*[f"<c><v>{' ' * 198}x</v></c>" * 119] * 700))), "(119, 699)",
    ),
    "short rows": (
        lambda: parts(
            cells("".join(map(inline, map(str, range(120)))), *["<c><v>1</v></c>"] * 2000), names=tuple("abcdefghij"),
        ), "too many cells",
    ),
    "one large sheet many times": (
        lambda: parts(
            padded("<worksheet>" + f"<x>{' ' * 900_000}</x>" * 19 + "</worksheet>", "<worksheet>"), names=("S",) * 60,
        ), "again and again",
    ),
    "brackets in formats": (
        lambda: parts(
            cells(),
            styles=padded(f'<styleSheet xmlns="{MAIN}">'
            + "".join(f'<numFmt numFmtId="{n}" formatCode="{"[" * 200}"/>' for n in range(75_000))
            + "</styleSheet>", "<numFmt"),
        ), "[]",
    ),
}  # fmt: skip


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", many(BOMBS))
def test_bombs_cost_neither_memory_nor_time(name, tmp_path):
    make, said = BOMBS[name]
    (tmp_path / "bomb.xlsx").write_bytes(packed(make()))
    assert said in confined(READ, tmp_path / "bomb.xlsx")


class Long(io.RawIOBase):
    """A sheet of 1 GB that is never held."""

    def __init__(self) -> None:
        self.left = 2**30

    def readable(self) -> bool:
        return True

    def readinto(self, buffer) -> int:
        size = min(len(buffer), self.left)
        buffer[:size] = (b"<row><c><v>1</v></c></row>" * (size // 26 + 1))[:size]
        self.left -= size
        return size


@pytest.mark.exhaustive
def test_a_sheet_of_a_gigabyte_is_refused_by_what_it_says_of_itself(tmp_path):
    with zipfile.ZipFile(tmp_path / "long.xlsx", "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in parts("").items():
            if name != "xl/worksheets/sheet1.xml":
                archive.writestr(name, content)
        with archive.open("xl/worksheets/sheet1.xml", "w", force_zip64=True) as target:
            shutil.copyfileobj(Long(), target, 2**20)
    assert (tmp_path / "long.xlsx").stat().st_size < 5 * 2**20
    said = confined(READ, tmp_path / "long.xlsx")
    assert said == "a.xlsx:xl/worksheets/sheet1.xml: the file is larger than 20480 kB\n"


@pytest.mark.exhaustive
@settings(max_examples=150, deadline=None)
@given(st.data())
def test_a_damaged_workbook_is_a_problem_and_never_a_trace(data):
    """Bytes of any part are changed, and packed again rightly, so that the damage reaches the reader of XML."""
    made = parts(cells(inline("v") * 2, '<c s="1"><v>1.5</v></c><c t="s"><v>0</v></c>'), strings("<t>x</t>"))
    name = data.draw(st.sampled_from(sorted(made)))
    part = bytearray(made[name])
    for _ in range(data.draw(st.integers(1, 3))):
        part[data.draw(st.integers(0, len(part) - 1))] = data.draw(st.integers(0, 255))
    with suppress(ProblemError):
        sheets(packed({**made, name: bytes(part)}, zipfile.ZIP_STORED))
