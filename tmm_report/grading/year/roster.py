"""The teacher's list of students: names and numbers for the gradebooks of other programs."""

from __future__ import annotations

from pathlib import Path

from tmm_report.grading.year.gradebook import Roster
from tmm_report.intake import cells, sheets
from tmm_report.problems import N_, Message, ProblemError, mistake
from tmm_report.yamlread import file_label, opened

BYTES = 5 * 2**20
ROWS = 100_000  # of a sheet: a contest has more students than a table has positions
KEYS = ("name", "email", "moodle_id", "canvas_id", "canvas_login", "section")
HEADS = {
    "id": "id",
    "student": "name",
    "студент": "name",
    "фио": "name",
    "группа": "section",
    "група": "section",
    "топ": "section",
    "group": "section",
}


def roster(path: Path) -> Roster:
    """id -> what the list says of the student, from a CSV or XLSX file with a column `id`. Raises ProblemError."""
    label = file_label(path)
    found: dict[str, dict[str, str]] = {}
    for sheet in sheets.read_sheets(label, path.name, opened(path, label, BYTES), rows=ROWS):
        names = [cells.header(head)[0].strip().casefold() for head in sheet.header]
        keys = [HEADS.get(name, name) for name in names]
        if "id" not in keys:
            right = Message(N_("the first row names the columns: id, name, email, moodle_id, canvas_id"))
            raise ProblemError([mistake(N_("%(file)s has no column id"), right=right, file=label)])
        for row in sheet.rows:
            texts = dict(zip(keys, (cell.text.strip() for cell in row), strict=False))
            if id := texts.get("id"):
                found[id] = {key: texts[key] for key in KEYS if texts.get(key)}
    return found
