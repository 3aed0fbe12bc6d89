"""Marks as files: what the teacher opens, and what learning platforms take; no text of a student becomes a formula."""

from __future__ import annotations

import csv
import io
import json
from dataclasses import replace

import pytest
from payloads import PAYLOADS

from tmm_report.grading.model import KINDS, Digest, Rule
from tmm_report.grading.year.gradebook import gradebook, gradescope, line
from tmm_report.grading.year.words import cause_text, kind_text
from tmm_report.i18n import Translator

EN, RU = Translator("en"), Translator("ru")


def digest(name: str, student: str, points: float = 7.0, **more) -> Digest:
    """Ten cells: six right, one carried forward, two wrong, one missing."""
    rules = [Rule.LIMIT, Rule.LIMIT, Rule.FLOOR, Rule.ZERO, Rule.EXACT, Rule.LIMIT, Rule.CARRIED]
    rules += [Rule.OFF, Rule.SIGN, Rule.NO_ANSWER, Rule.NOT_ASKED]
    keys = ["v_B"] * 5 + ["a_B"] * 6
    cells = {
        ("rates_table", key, str(k)): (4.75, str(rule))
        for k, (key, rule) in enumerate(zip(keys, rules, strict=True))
    }
    right = dict.fromkeys(cells, 4.4437)
    columns = {("rates_table", "v_B"): (5.0, 5.0), ("rates_table", "a_B"): (points - 5, 5.0)}
    causes = (("sign", "", ("a_B",)),)
    made = Digest(name, student, "М-21", "1", points, 10.0, cells, right, causes, columns=columns)
    return replace(made, **more)


WORKS = [
    digest("petrov", "Петров П. П.", 6.666666),
    digest("ivanov", "Иванов И. И.", causes=(("variant", "petrov", ("a_B", "v_B")),)),
    Digest("broken", "Сидоров С. С.", failed=("sidorov.csv:3: no table in it",)),
]
ROSTER = {
    "ivanov": {"name": "Ivan Ivanov", "email": "ivanov@example.edu", "moodle_id": "4711", "canvas_id": "99"},
}


def rows(content: bytes, delimiter: str = ",") -> list[dict[str, str]]:
    return list(csv.DictReader(io.StringIO(content.decode("utf-8-sig")), delimiter=delimiter))


@pytest.fixture(scope="module")
def files() -> dict[str, bytes]:
    return gradebook(WORKS, EN, ROSTER, "TMM (12345)")


def test_marks_stand_by_id_with_points_counts_and_causes(files):
    broken, ivanov, petrov = rows(files["marks.csv"])
    assert [row["id"] for row in (broken, ivanov, petrov)] == ["broken", "ivanov", "petrov"]
    assert (petrov["points"], petrov["out of"], petrov["%"]) == ("6.67", "10.0", "66.7")
    assert [petrov[head] for head in ("right", "carried forward", "wrong", "no answer")] == [
        "6",
        "1",
        "2",
        "1",
    ]
    assert petrov["likely causes"] == "opposite sign: a_B"
    assert ivanov["likely causes"] == "numbers of the variant of petrov: a_B, v_B"


def test_a_work_that_could_not_be_marked_has_no_points_but_the_reason(files):
    broken = rows(files["marks.csv"])[0]
    assert broken["points"] == "" and broken["likely causes"] == "sidorov.csv:3: no table in it"
    assert [row["Grade"] for row in rows(files["moodle.csv"])] == ["", "7.0", "6.67"]


def test_russian_spreadsheets_get_commas(files):
    russian = gradebook(WORKS, RU)["marks.csv"].decode("utf-8-sig").splitlines()
    assert ";6,67;10,0;66,7;" in russian[3]


def test_the_workbook_holds_marks_and_columns(files):
    from openpyxl import load_workbook

    book = load_workbook(io.BytesIO(files["marks.xlsx"]))
    marks, columns = book.worksheets
    assert [cell.value for cell in marks[3]][:6] == ["ivanov", "Иванов И. И.", "М-21", "1", 7, 10]
    assert [cell.value for cell in columns[1]] == ["id", "student", "rates_table v_B", "rates_table a_B"]
    assert [cell.value for cell in columns[3]][2:] == [100, 20]


def test_moodle_finds_the_participant_and_has_the_columns_that_its_importer_looks_for(files):
    """Without Identifier, Grade and Last modified (grade) the importer refuses the file; it parts cells by commas."""
    ivanov = rows(files["moodle.csv"])[1]
    assert ivanov["Identifier"] == "Participant 4711"
    assert (ivanov["Full name"], ivanov["Email address"], ivanov["ID number"]) == (
        "Ivan Ivanov",
        "ivanov@example.edu",
        "ivanov",
    )
    assert (ivanov["Grade"], ivanov["Maximum Grade"], ivanov["Last modified (grade)"]) == ("7.0", "10.0", "")
    assert ivanov["Feedback comments"].startswith("Right: 6; carried forward: 1; wrong: 2; no answer: 1.")


def test_canvas_knows_the_row_of_points_and_the_student(files):
    table = list(csv.reader(io.StringIO(files["canvas.csv"].decode("utf-8-sig"))))
    assert table[0] == ["Student", "ID", "SIS User ID", "SIS Login ID", "Section", "TMM (12345)"]
    assert table[1] == ["    Points Possible", "", "", "", "", "10.0"]
    assert table[3] == ["Ivan Ivanov", "99", "ivanov", "ivanov@example.edu", "М-21", "7.0"]
    assert table[2][-1] == ""


def test_a_student_called_points_possible_does_not_change_what_the_work_is_worth():
    works = [*WORKS, digest("z", "  Points Possible, Jr.")]
    table = list(csv.reader(io.StringIO(gradebook(works, EN)["canvas.csv"].decode("utf-8-sig"))))
    assert sum("Points Possible" in row[0] for row in table) == 1
    assert table[-1][0] == "z"


def test_gradescope_gets_a_test_for_every_column_and_its_score(files):
    document = json.loads(files["gradescope/petrov/results.json"])
    assert document["score"] == 6.67
    speeds, rates = document["tests"]
    assert (speeds["name"], speeds["score"], speeds["max_score"], speeds["status"]) == (
        "v_B (rates_table)",
        5.0,
        5.0,
        "passed",
    )
    assert (rates["score"], rates["status"]) == (1.67, "failed")
    assert "opposite sign" in rates["output"]
    assert {test["visibility"] for test in document["tests"]} == {"visible"}


def test_gradescope_does_without_the_points_of_columns():
    document = json.loads(gradescope(line(digest("a", "A", columns={})), EN))
    assert document["score"] == 7.0 and all("score" not in test for test in document["tests"])


def test_what_students_read_gives_no_number_away_and_names_nobody_else(files):
    """Neither the solution nor the student's number, nor whose variant it was."""
    for name in ("moodle.csv", "canvas.csv", "gradescope/ivanov/results.json"):
        text = files[name].decode()
        assert "4.44" not in text and "4.75" not in text
    assert b"petrov" not in files["gradescope/ivanov/results.json"]
    assert "petrov" not in rows(files["moodle.csv"])[1]["Feedback comments"]


def test_same_works_same_bytes_in_whatever_order(files):
    again = gradebook(reversed(WORKS), EN, ROSTER, "TMM (12345)")
    assert again == files and list(again) == list(files)


def test_hostile_names_become_neither_formulas_nor_markup():
    works = [
        digest(f"s{k:02}", payload, causes=(("sign", "", (payload,)),))
        for k, payload in enumerate(PAYLOADS.values())
    ]
    formulas = ["=1+1", "+1", "-1", "@SUM(A1)", "\t=1", "\r=1", "＝1"]
    works += [digest(f"f{k}", text, group=text, variant=text) for k, text in enumerate(formulas)]
    made = gradebook(works, EN, title="=cmd|' /C calc'!A0")
    for name in ("marks.csv", "moodle.csv", "canvas.csv"):
        for row in csv.reader(io.StringIO(made[name].decode("utf-8-sig"), newline="")):
            for cell in row:
                assert cell.lstrip()[:1] not in ("=", "+", "-", "@", "＝") or not cell.strip(), (name, cell)
    for row in rows(made["moodle.csv"]):
        assert "<" not in row["Feedback comments"] and ">" not in row["Feedback comments"]
    from openpyxl import load_workbook

    for sheet in load_workbook(io.BytesIO(made["marks.xlsx"])):
        assert not any(cell.data_type == "f" for row in sheet.iter_rows() for cell in row)


def test_every_kind_of_mistake_has_words():
    words = {kind: str(kind_text(kind)) for kind in KINDS}
    assert len(set(words.values())) == len(KINDS)
    assert all(word not in KINDS for word in words.values())


def test_of_many_columns_the_first_are_named():
    keys = tuple(f"v_{k}" for k in range(50))
    assert str(cause_text(("sign", "", keys))) == "opposite sign: v_0, v_1, v_2, v_3, v_4, v_5, …"


def test_an_empty_class_has_its_heads(files):
    empty = gradebook([], EN)
    assert rows(empty["marks.csv"]) == [] and set(empty) == {
        "marks.csv",
        "marks.xlsx",
        "moodle.csv",
        "canvas.csv",
    }
