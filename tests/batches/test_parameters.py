"""Variants from a template and a table: what is written is what is read, row by row, whatever stands in the cells."""

from __future__ import annotations

import tracemalloc
import unicodedata
from pathlib import Path

import pytest
from conftest import ALL_FILES, examples
from hypothesis import given, settings
from hypothesis import strategies as st
from notes import VARIANTS
from payloads import PAYLOADS
from test_assign import EXAMPLE, OA, assign, parameters, ranges

from tmm_report.assignments.emit import pieces, scalar
from tmm_report.assignments.table import variants_of
from tmm_report.intake.writing import csv_bytes, xlsx_bytes
from tmm_report.loading import loads
from tmm_report.problems import ProblemError
from tmm_report.yamlread import loads as read_yaml

COMPRESSOR = VARIANTS / "compressor.yaml"
LENGTH = "mechanism.links.1.points.A, mm"


def table(folder: Path, *rows: list, suffix: str = "csv") -> Path:
    path = folder / f"table.{suffix}"
    path.write_bytes(csv_bytes(rows, ",") if suffix == "csv" else xlsx_bytes({"table": rows}))
    return path


def titles(template: Path, path: Path) -> list:
    return [loads(content).title for _, _, content in variants_of(template, path)]


def crank(content: bytes) -> float:
    return abs(loads(content).lever.mechanism.links["1"].points["A"])


# --- YAML as it is written


def readable(text: str) -> str:
    """The text as YAML can hold it: composed, without control characters."""
    kept = (
        c
        for c in text
        if c in "\t\n\r\x85" or not (unicodedata.category(c) == "Cc" or c in "\ufeff\ufffe\uffff")
    )
    return unicodedata.normalize("NFC", "".join(kept))


TRAPS = [
    "1e5",
    "1.",
    ".5",
    "12:30",
    "017",
    "0x1",
    "no",
    "~",
    "",
    "null",
    "true",
    "-",
    "- a",
    "a: b",
    "a #b",
    "#",
]
TRAPS += [
    "<<",
    "&a",
    "*a",
    "!!x",
    "---",
    "...",
    "+",
    "-1",
    "-1 mm",
    "{a: b}",
    "[1, 2]",
    "a, b",
    '"',
    "\\",
    " a",
    "a ",
]
texts = st.one_of(
    st.text(st.characters(exclude_categories=("Cs",)), max_size=12).map(readable), st.sampled_from(TRAPS)
)
leaves = st.one_of(
    st.none(),
    st.booleans(),
    st.integers(-(10**30), 10**30),
    st.floats(allow_nan=False, allow_infinity=False),
    texts,
)
trees = st.recursive(
    leaves, lambda c: st.lists(c, max_size=4) | st.dictionaries(texts, c, max_size=4), max_leaves=20
)


@pytest.mark.exhaustive
@settings(max_examples=examples(500))
@given(trees)
def test_data_is_read_as_it_was_written(data):
    assert read_yaml("".join(map(str, pieces(data)))).data == data


@pytest.mark.parametrize("file", ALL_FILES, ids=lambda file: file.stem)
def test_every_ready_variant_is_read_as_it_was_written_its_numbers_to_the_letter(file):
    document = read_yaml(file.read_bytes())
    text = "".join(str(piece) for piece in pieces(document.data, document.raw))
    again = read_yaml(text)
    assert again.data == document.data and list(again.data) == list(document.data)
    numbers = {path for path in document.places if isinstance(_at(document.data, path), int | float)}
    assert {path: again.raw[path] for path in numbers if path} == {
        path: document.raw[path] for path in numbers if path
    }


def _at(data, path):
    for key in path:
        data = data[key]
    return data


@given(texts)
def test_a_single_value_stays_itself_in_braces_and_brackets_too(text):
    written = scalar(text)
    assert "\n" not in written
    assert read_yaml(f"a: {{b: {written}, c: [{written}, {written}]}}").data == {
        "a": {"b": text, "c": [text, text]}
    }


# --- tables made by assign


@pytest.mark.exhaustive
@pytest.mark.parametrize(("name", "language"), [("a.csv", "ru"), ("a.csv", "en"), ("a.xlsx", "ru")])
def test_the_table_gives_the_very_variants_that_were_proven(tmp_path, name, language):
    assign(EXAMPLE, tmp_path / name, 5, folder=tmp_path / "v", language=language)
    made = {id: content for id, _, content in variants_of(EXAMPLE, tmp_path / name)}
    assert made == {file.stem: file.read_bytes() for file in (tmp_path / "v").iterdir()}
    assert len(made) == 5


def test_what_follows_is_computed_where_its_column_was_taken_out(tmp_path):
    half = "AS2: {key: mechanism.links.2.points.S2, of: OA, times: 1.5}"
    path = ranges(tmp_path, parameters(OA, half))
    without = table(tmp_path, ["student", "OA, mm"], ["Ким", 90])
    _, _, content = next(variants_of(path, without))
    assert abs(loads(content).lever.mechanism.links["2"].points["S2"]) == pytest.approx(0.135)


def test_a_unit_of_the_head_goes_before_that_of_the_ranges(tmp_path):
    path = ranges(tmp_path, parameters(OA))
    metres = table(tmp_path, ["id", "OA, m"], ["a", 0.09])
    assert [crank(content) for _, _, content in variants_of(path, metres)] == pytest.approx([0.09])


# --- tables with dotted heads


@pytest.mark.parametrize("suffix", ["csv", "xlsx"])
def test_a_plain_variant_is_a_template_for_dotted_heads(tmp_path, suffix):
    rows = [
        ["Студент", "группа", "вариант", LENGTH, "mechanism.driver.period", "mechanism.driver.rotation"],
        ["Иванов И. И.", "М-22", 7, 95, "0,06 s", "counter-clockwise"],
        ["Ким А.", "", 8, 85.5, "50 ms", "clockwise"],
    ]
    (one, first_label, first), (_, _, second) = variants_of(COMPRESSOR, table(tmp_path, *rows, suffix=suffix))
    assert one == "Иванов_И._И" and first_label.endswith(":2")
    assert (crank(first), crank(second)) == pytest.approx((0.095, 0.0855))
    ours, theirs = loads(first), loads(second)
    assert ours.lever.mechanism.driver.omega == pytest.approx(2 * 3.141592653589793 / 0.06)
    assert (ours.title.student, ours.title.group, ours.title.variant) == ("Иванов И. И.", "М-22", "7")
    assert (theirs.title.group, theirs.title.variant, theirs.title.teacher) == ("М-21", "8", "Петров П. П.")
    assert not ours.lever.readings and ours.drive is not None


def test_nobody_gets_the_name_that_stands_in_the_template(tmp_path):
    assert titles(COMPRESSOR, table(tmp_path, ["id", LENGTH], ["a", 90]))[0].student == ""


def test_a_row_with_a_mistake_is_told_with_its_line_and_the_others_go_on(tmp_path):
    rows = [
        ["id", LENGTH],
        ["a", 90],
        ["b", "x"],
        ["c", ""],
        ["d", "90,5"],
        ["a", 91],
        ["e", "90", "7"],
    ]
    path = tmp_path / "t.csv"
    path.write_text("\n".join(";".join(map(str, row)) for row in rows), encoding="utf-8")
    made = list(variants_of(COMPRESSOR, path))
    good = {id: crank(content) for id, _, content in made if isinstance(content, bytes)}
    assert good == pytest.approx({"a": 0.09, "d": 0.0905})
    wrong = [
        problem for _, _, content in made if isinstance(content, ProblemError) for problem in content.problems
    ]
    assert {problem.file for problem in wrong} == {str(path)}
    assert [problem.line for problem in wrong] == [3, 4, 6, 7]
    said = "\n".join(problem.text() for problem in wrong)
    assert "x is not a number" in said and "there is no value here" in said
    assert "the id a stands in the table twice" in said and "more cells than the table's head" in said
    assert len({id for id, _, _ in made}) == len(made) == 6


@pytest.mark.parametrize(
    ("head", "said"),
    [
        (["id", "mechanism.links.1.points.B, mm"], "no key B in mechanism.links.1.points"),
        (["id", "mechanism.links.1.points.A, deg"], None),
        (["id", "mechanism.links.1.points, mm"], "is not a single value"),
        (["id", "OA, mm"], "unknown column OA"),
        (["id", "grup"], "unknown column grup; did you mean group?"),
        (["id", LENGTH, "mechanism.links.1.points.A, m"], "two columns say mechanism.links.1.points.A"),
        (["id", "student", "ФИО"], "two columns say student"),
        (["id", "mechanism.links.1.points.A, parrots"], "unknown unit parrots"),
    ],
)
def test_a_mistake_of_the_head_is_told_before_any_row_is_read(tmp_path, head, said):
    path = table(tmp_path, head, ["a", *[90] * (len(head) - 1)])
    if (
        said is None
    ):  # a bare number of the template says no unit: the variant itself is refused when it is loaded
        _, label, content = next(variants_of(COMPRESSOR, path))
        with pytest.raises(ProblemError, match="deg"):
            loads(content, label)
        return
    with pytest.raises(ProblemError) as error:
        variants_of(COMPRESSOR, path)
    assert said in str(error.value) and error.value.problems[0].line == 1


def test_all_mistakes_of_the_head_of_a_drawn_table_are_told_at_once(tmp_path):
    with pytest.raises(ProblemError) as error:
        variants_of(EXAMPLE, table(tmp_path, ["id", "OA, deg", "ABB, mm", "CD"], ["a", 1, 2, 3]))
    said = str(error.value)
    assert "deg is an angle" in said and "did you mean AB?" in said
    assert "there is no column T" in said and "no column AC" not in said


# --- hostile cells


def quoted_back(text: str) -> str:
    """What a title page makes of a text: one line. A spreadsheet's guard within it stays."""
    return " ".join(text.split())


@pytest.mark.parametrize("suffix", ["csv", "xlsx"])
@pytest.mark.parametrize("payload", PAYLOADS.values(), ids=PAYLOADS)
def test_a_payload_is_a_name_and_nothing_else(tmp_path, payload, suffix):
    path = table(tmp_path, ["student", LENGTH], [payload, 90], suffix=suffix)
    ((id, _, content),) = variants_of(COMPRESSOR, path)
    data = read_yaml(content).data
    whole = read_yaml(COMPRESSOR.read_bytes()).data
    assert data["title"].pop("student") == quoted_back(payload)
    assert data["title"].keys() == whole["title"].keys() - {"student"} and data.keys() == whole.keys() - {
        "readings"
    }
    assert "/" not in id and "\\" not in id and ".." not in id[:2]


STRUCTURE = [
    "x\nmechanism: {}",
    "x\r\n  admin: 1",
    "a: b",
    "- a",
    "{a: 1}",
    "[1]",
    "*a",
    "&a x",
    "!!python/object x",
]
STRUCTURE += [
    '"',
    "'",
    "\\",
    "# x",
    "%YAML 1.1",
    "--- x",
    "? x",
    "| x",
    "> x",
    "@x",
    "`x",
    "x: \u2028 y: 1",
    "x\u0085y: 1",
]


@pytest.mark.exhaustive
@settings(max_examples=examples(60))
@given(st.sampled_from(STRUCTURE) | texts.filter(str.strip))
def test_a_name_is_never_structure(tmp_path_factory, name):
    folder = tmp_path_factory.mktemp("names")
    path = table(folder, ["id", "student", LENGTH], ["a", name, 90], suffix="xlsx")
    ((_, _, content),) = variants_of(COMPRESSOR, path)
    data = read_yaml(content).data
    plain = read_yaml(
        next(variants_of(COMPRESSOR, table(folder, ["id", "student", LENGTH], ["a", "X", 90])))[2]
    ).data
    assert isinstance(data["title"].pop("student"), str | int | float | bool | None)
    plain["title"].pop("student")
    assert data == plain


@pytest.mark.parametrize("id", ["../../x", "/etc/x", "..", "C:\\x", "CON", ".x", "-rf", "a\nb", "x" * 190])
def test_an_id_is_a_name_of_a_folder(tmp_path, id):
    ((made, _, _),) = variants_of(COMPRESSOR, table(tmp_path, ["id", LENGTH], [id, 90], suffix="xlsx"))
    assert 0 < len(made) <= 60 and not set(made) & set('/\\:\n"<>|?*') and made[0] not in ".-"
    assert made.upper() != "CON"


def test_a_word_from_the_table_is_text_and_no_other_value(tmp_path):
    rows = [["id", "mechanism.driver.rotation"], ["a", "{angle: 1}"], ["b", "[1, 2]"], ["c", "clockwise # x"]]
    for _, label, content in variants_of(COMPRESSOR, table(tmp_path, *rows)):
        assert isinstance(read_yaml(content).data["mechanism"]["driver"]["rotation"], str)
        with pytest.raises(ProblemError):
            loads(content, label)


# --- long tables


@pytest.mark.exhaustive
def test_a_long_table_is_never_held_as_variants(tmp_path):
    rows = 3000
    path = table(tmp_path, ["id", LENGTH], *([f"s{n}", 80 + n % 40] for n in range(rows)))
    tracemalloc.start()
    made = variants_of(COMPRESSOR, path)
    count = sum(isinstance(content, bytes) for _, _, content in made)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert count == rows
    assert peak < 3 * 2**20  # the variants themselves are 6 MB
