"""The teacher's list of students: as long as a year is, and no longer."""

from __future__ import annotations

import pytest

from tmm_report.assignments import people
from tmm_report.grading.year.roster import ROWS, roster
from tmm_report.intake.writing import csv_bytes, xlsx_bytes
from tmm_report.problems import ProblemError

HEAD = ["id", "student", "email", "moodle_id"]


@pytest.mark.exhaustive
@pytest.mark.parametrize("suffix", ["csv", "xlsx"])
def test_a_department_of_three_thousand_is_read(tmp_path, suffix):
    rows = [HEAD, *([f"s{n}", f"Студент {n}", f"s{n}@x.org", f"{n}"] for n in range(3000))]
    content = csv_bytes(rows, ".") if suffix == "csv" else xlsx_bytes({"list": rows})
    (tmp_path / f"list.{suffix}").write_bytes(content)
    found = roster(tmp_path / f"list.{suffix}")
    assert len(found) == 3000
    assert found["s2999"] == {"name": "Студент 2999", "email": "s2999@x.org", "moodle_id": "2999"}


@pytest.mark.exhaustive
def test_a_list_without_end_is_refused(tmp_path):
    (tmp_path / "list.csv").write_text("id\n" + "s\n" * (ROWS + 1))
    with pytest.raises(ProblemError, match="more than 100000 rows"):
        roster(tmp_path / "list.csv")


def test_a_list_of_two_million_lines_is_not_read_to_its_end(tmp_path, monkeypatch):
    (tmp_path / "list.txt").write_text("a\n" * 2_000_000)
    read = []
    person = people.person
    monkeypatch.setattr(people, "MOST", 100)
    monkeypatch.setattr(people, "person", lambda *given: read.append(1) or person(*given))
    with pytest.raises(ProblemError, match="more than 100 students"):
        people.students(tmp_path / "list.txt")
    assert len(read) == 101
