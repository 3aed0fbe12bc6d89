"""The guide's own numbers handed in as a student's answers, in three formats: all within 5 %, full marks.

ERRATA, beside those of compressor_printed.yaml: table 3 prints a_B at position 10 with the wrong sign, and a student
who copies it is told so.
"""

from __future__ import annotations

from pathlib import Path

import pytest
import yaml
from conftest import solved

from tmm_report.grading import rubric
from tmm_report.grading.expected import expected, reversed_reactions
from tmm_report.grading.handed_in.answers import read
from tmm_report.grading.marks import grade
from tmm_report.grading.model import RIGHT, Rule
from tmm_report.intake.writing import csv_bytes, xlsx_bytes

PRINTED = yaml.load(Path(__file__).with_name("compressor_printed.yaml").read_text("utf-8"), yaml.BaseLoader)
FORCES = {"R24": "R_24", "R54": "R_54", "R05": "R_05", "R12": "R_12", "R32": "R_32", "R03": "R_03"}


def by_position() -> dict[int, dict[str, str]]:
    """Plan values of positions 6 and 7 as the guide writes them, VA, aBA_n, w2; at 7 also loads, reactions, moment."""
    found = {int(k): dict(row) for k, row in PRINTED["plan_velocities"].items()}
    for k, row in PRINTED["plan_accelerations"].items():
        found[int(k)] |= row
    forces = PRINTED["kinetostatics_position_7"]
    found[7] |= {ours: forces["plan_reactions_N"][theirs] for theirs, ours in FORCES.items()}
    found[7] |= {key: forces["given"][key] for key in ("G4", "G5", "G2", "G3", "FI4", "FI5", "FI2", "FI3")}
    found[7]["M_bal"] = forces["plan_balancing_moment_Nm"]
    return found


def as_yaml(rows: dict[int, dict[str, str]]) -> dict[str, bytes]:
    return {"g.yaml": yaml.safe_dump({str(k): row for k, row in rows.items()}).encode()}


def as_rows(rows: dict[int, dict[str, str]], numbers: bool) -> list[list[object]]:
    keys = list(dict.fromkeys(key for row in rows.values() for key in row))
    as_cell = float if numbers else lambda text: text.replace(".", ",")
    return [
        ["position", *keys],
        *([k, *(as_cell(row[key]) if key in row else None for key in keys)] for k, row in rows.items()),
    ]


FORMATS = {
    "yaml": as_yaml,
    "csv": lambda rows: {"g.csv": csv_bytes(as_rows(rows, numbers=False), ",")},
    "xlsx": lambda rows: {"g.xlsx": xlsx_bytes({"plans": as_rows(rows, numbers=True)})},
}


@pytest.fixture(scope="module")
def asked():
    return expected(solved("compressor"))


def marked(files: dict[str, bytes], asked, text: str):
    results = solved("compressor")
    answers = read([*files.items()], "guide", asked, reversed_reactions(results))
    assert not answers.notes, [note.text() for note in answers.notes]
    return grade(results, answers, rubric.loads(text), asked)


@pytest.mark.parametrize("fmt", FORMATS)
def test_the_plan_values_are_full_marks(fmt, asked):
    rows = by_position()
    columns = set(marked(FORMATS[fmt](rows), asked, "{}").answers.columns)
    tables = {table: sorted(key for other, key in columns if other == table) for table, _ in columns}
    every = marked(FORMATS[fmt](rows), asked, "{}")
    cells = [(name, k, column.rules[k]) for name, column in every.columns.items() if column.answered
             for k in column.answered.given.nonzero()[0]]  # fmt: skip
    assert len(cells) == sum(map(len, rows.values())) == 22 * 2 + 15
    assert not [cell for cell in cells if cell[2] not in RIGHT]
    assert not every.causes
    # the course's formula alone, too, but for what is nothing
    deltas = [abs(column.judged.delta[k]) for column in every.columns.values() if column.answered
              for k in column.answered.given.nonzero()[0] if column.rules[k] is Rule.LIMIT]  # fmt: skip
    assert len(deltas) >= 50 and max(deltas) < 5
    velocities = ", ".join(key for key in tables["rates_table"])
    found = marked(
        FORMATS[fmt](rows), asked, f"positions: [6, 7]\ntables: {{rates_table: {{columns: [{velocities}]}}}}"
    )
    assert found.points == found.worth == 100


def test_table_3_is_right_but_for_its_misprint(asked):
    columns = PRINTED["table3"]["columns"]
    keys = {"a_B": "A_B", "a_D": "A_D"}
    rows = [["position", *(keys.get(key, key) for key in columns[1:])], *PRINTED["table3"]["rows"]]
    found = marked({"g.csv": csv_bytes(rows, ".")}, asked, "tables: {outputs_table: 1}")
    wrong = [
        (name[1], k) for name, column in found.columns.items() for k, rule in enumerate(column.rules)
        if column.worth[k] > 0 and rule not in RIGHT
    ]  # fmt: skip
    assert wrong == [("A_B", 10)]
    assert found.columns["outputs_table", "A_B"].rules[10] is Rule.SIGN
    assert found.points == pytest.approx(100 * (1 - 1 / 72), abs=0.01)
