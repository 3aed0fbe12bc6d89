"""CSV as spreadsheets and people write it, and as nobody honest does."""

import csv
import os
from pathlib import Path

import pytest
from confined import confined
from hypothesis import given
from hypothesis import strategies as st

from tmm_report.intake.cells import number
from tmm_report.intake.sheets import BYTES, CHARACTERS, COLUMNS, Sheet, read_sheets, stream_csv
from tmm_report.problems import Problem, ProblemError

ATTACKS = Path(__file__).parent / "attacks"


def sheet(content: bytes | str, **limits) -> Sheet:
    data = content.encode() if isinstance(content, str) else content
    (only,) = read_sheets("answers/a.csv", "a.csv", data, **limits)
    return only


def texts(content: bytes | str) -> list[list[str]]:
    made = sheet(content)
    return [list(made.header), *([cell.text for cell in row] for row in made.rows)]


def refusal(content: bytes | str, **limits) -> list[str]:
    with pytest.raises(ProblemError) as caught:
        sheet(content, **limits)
    return [problem.text() for problem in caught.value.problems]


PLAIN = [["k", "v_B, м/с"], ["0", "1,25"], ["1", "-3,5"]]


@pytest.mark.parametrize(
    "content",
    [
        'k,"v_B, м/с"\n0,"1,25"\n1,"-3,5"\n'.encode(),
        "k;v_B, м/с\r\n0;1,25\r\n1;-3,5\r\n".encode(),
        "\ufeffk;v_B, м/с\r\n0;1,25\r\n1;-3,5".encode(),
        "k\tv_B, м/с\n0\t1,25\n1\t-3,5\n".encode("utf-16"),
        "\ufeffk;v_B, м/с\n0;1,25\n1;-3,5\n".encode("utf-16-be"),
        "k;v_B, м/с\r\n0;1,25\r\n1;-3,5\r\n".encode("cp1251"),
        "sep=;\r\nk;v_B, м/с\r\n0;1,25\r\n1;-3,5\r\n".encode(),
        "k;v_B, м/с\r0;1,25\r1;-3,5\r".encode(),
        "\n\n ; \nk ; v_B, м/с ;;\n\n 0;1,25\n;\n1;-3,5;;\n".encode(),
        '"k";"v_B, м/с"\n"0";"1,25"\n"1";"-3,5"\n'.encode(),
    ],
)
def test_one_table_in_many_spellings(content):
    assert texts(content) == PLAIN


def test_cells_know_their_line_and_column():
    made = sheet('k;v\n\n0;"a\nb"\n1;5\n')
    assert [(cell.text, cell.line, cell.column) for row in made.rows for cell in row] == [
        ("0", 3, 1), ("a\nb", 3, 2), ("1", 5, 1), ("5", 5, 2),
    ]  # fmt: skip
    assert (made.name, made.label, made.line) == ("a", "answers/a.csv", 1)
    assert sheet("\nsep=;\n\nk;v\n0;1\n").rows[0][0].line == 5
    assert sheet("\n\nk;v\n0;1\n").line == 3


def test_a_single_column_keeps_its_decimal_commas():
    assert texts("v_B\n1,25\n-3,5\n") == [["v_B"], ["1,25"], ["-3,5"]]


def test_short_rows_are_filled_up():
    assert texts("a;b;c\n1\n1;2\n") == [["a", "b", "c"], ["1", "", ""], ["1", "2", ""]]


def test_an_empty_file_has_no_rows():
    assert (sheet("").header, sheet("").rows) == ((), ())


def test_a_file_from_an_old_windows_is_read_with_a_note():
    made = sheet((ATTACKS / "C02_decimal_comma.csv").read_bytes())
    assert [cell.text for cell in made.rows[0]] == ["Иванов", "1,25", "-3,5"]
    (note,) = made.notes
    assert "it was read as Windows-1251; save the file as UTF-8" in note.text()
    assert sheet("k;v\n").notes == ()


def test_a_unicode_minus_behind_a_mark_and_thin_spaces_are_numbers():
    rows = texts("\ufeffv_B;R_12\n\u22121,25;1\u2009234,5\n")
    assert [number(text) for text in rows[1]] == [-1.25, 1234.5]


def test_a_formula_is_text():
    rows = texts((ATTACKS / "C01_formula.csv").read_bytes())
    assert rows[1] == ['=HYPERLINK("http://evil","x")', "1.2"]


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (b"student,v_B\n" + b'"' + b"a" * 140_000 + b'",1\n', ["answers/a.csv:2: a cell is longer than 200 char"]),
        (b"student,v_B\niva\x00nov,1\n", ["answers/a.csv:2: a control character is not allowed"]),
        (b"a,b\n1,\x1b[31m\n", ["answers/a.csv:2: a control character"]),
        (b"a;b\n1;2\n1;2;3\n4;5;6;7\n", ["answers/a.csv:3:3: the row has more", "answers/a.csv:4:3: the row has"]),
        (b"a,b\n1,25,2\n", ["answers/a.csv:2:3: the row has more cells than the table's head; a decimal"]),
        (b'a;b\n1;"2\n', ["answers/a.csv:2: the quotes of this line are not balanced"]),
        (b'a;b\n1;2\n3;"2"x\n', ["answers/a.csv:3: the quotes of this line are not balanced"]),
        (b'a;b\n1;"' + b"2\n" * 200, ["answers/a.csv:2: a cell is longer than 200 characters, or its quote"]),
        (b"a;b\n" + b"1;2\n" * 2001, ["answers/a.csv:2002: the table has more than 2000 rows"]),
        (b";".join([b"a"] * 121), ["answers/a.csv:1: the table has more than 120 columns"]),
        (b"a" * (BYTES + 1), ["answers/a.csv: the file is larger than 1024 kB"]),
        ("k;v".encode("utf-16-le"), ["answers/a.csv:1: a control character is not allowed"]),
        (b"\xff\xfek", ["answers/a.csv: the file is in no known encoding; save the file as UTF-8"]),
        (b"a;\x98\n", ["answers/a.csv: the file is in no known encoding"]),
    ],
)  # fmt: skip
def test_what_cannot_be_read_is_told_with_its_line(content, said):
    told = refusal(content)
    assert len(told) == len(said)
    assert all(text.startswith(start) for text, start in zip(told, said, strict=True)), told


def test_at_most_twenty_faulty_rows_are_told():
    assert len(refusal("a;b\n" + "1;2;3\n" * 1000)) == 20


def test_the_limits_themselves_are_allowed():
    made = sheet(";".join(["a" * CHARACTERS] * COLUMNS) + "\n" + "1\n" * 2000)
    assert (len(made.header), len(made.rows)) == (COLUMNS, 2000)


def test_the_limit_of_other_readers_of_csv_stays():
    before = csv.field_size_limit()
    sheet("a;b\n1;2\n")
    refusal("a;b\n" + "x" * 500 + "\n")
    assert csv.field_size_limit() == before


def test_a_long_table_is_read_row_by_row_and_faulty_rows_do_not_stop_it():
    stream = stream_csv("t.csv", b"id;OA, mm\n" + b"1;80\n2;85;x\n3;90\n" * 2000, rows=10_000)
    kinds = [isinstance(row, Problem) for row in stream.rows]
    assert stream.header == ("id", "OA, mm")
    assert (len(kinds), sum(kinds)) == (6000, 2000)


def test_other_kinds_of_file_are_refused():
    with pytest.raises(ProblemError, match=r"a\.xls: the file is none of \*\.csv, \*\.xlsx"):
        read_sheets("a.xls", "a.xls", b"")


@given(st.binary(max_size=300))
def test_any_bytes_are_a_table_or_a_problem(content):
    try:
        made = sheet(content)
    except ProblemError as error:
        assert all(problem.file == "answers/a.csv" for problem in error.problems)
    else:
        assert all(len(row) == len(made.header) for row in made.rows)


HOSTILE = """
for content in (
    b"a,b\\n" + b'"' + b"x" * (2**20 - 10), b"," * 2**20, b"\\n" * 2**20, b'"' * (2**20 - 1), b'""' * 2**19,
    b"a;b\\n" + b";\\n" * 2**19 + b"1", b";".join([b'"a"'] * 2**17), b"sep=;\\n" * 2**17, b"\\r" * 2**20,
):
    try:
        made = sheets.read_sheets("a.csv", "a.csv", content[:2**20])
        print(len(made[0].rows))
    except ProblemError as error:
        print(len(error.problems))
try:
    sheets.read_sheets("a.csv", "a.csv", bytes(150 * 2**20))
except ProblemError as error:
    print(error)
"""


@pytest.mark.exhaustive
def test_hostile_tables_cost_neither_memory_nor_time():
    lines = confined(HOSTILE, memory=350 * 2**20).splitlines()
    assert len(lines) == 10
    assert lines[-1] == "a.csv: the file is larger than 1024 kB"


@pytest.mark.exhaustive
@pytest.mark.skipif(os.name == "nt", reason="measures with resource")
def test_a_long_table_is_not_held():
    program = """
content = b"id;OA\\n" + b"ivanov;80\\n" * 200_000
before = own()
stream = sheets.stream_csv("t.csv", content, rows=200_000)
assert sum(1 for row in stream.rows) == 200_000
print((own() - before) // 2**20 < 20)
"""
    assert confined(program, seconds=15) == "True\n"
