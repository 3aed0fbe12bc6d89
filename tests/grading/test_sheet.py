"""The sheet that students fill in, filled in: what was written comes back, whatever the rubric asks."""

from __future__ import annotations

import csv
import io

import pytest
from conftest import solved

from tmm_report.grading.answers import read
from tmm_report.grading.expected import expected
from tmm_report.grading.marks import closed, grade
from tmm_report.grading.rubric import Rubric, TableRule, worth
from tmm_report.grading.template import template
from tmm_report.i18n import Translator
from tmm_report.intake import cells


def every(asked) -> Rubric:
    """All numbers that can be asked."""
    tables = {table for table, _ in asked if table}
    return Rubric(
        tables={t: TableRule(columns={key: 1.0 for of, key in asked if of == t}) for t in tables},
        values={key: 1.0 for table, key in asked if not table},
    )


def filled(name: str, content: bytes, asked) -> bytes:
    """A file of the template with the right numbers in it."""
    text = content.decode("utf-8-sig")
    rows = list(csv.reader(io.StringIO(text), delimiter=";" if ";" in text.partition("\n")[0] else ","))
    heads = [cells.header(head)[0] for head in rows[0]]
    table = name.removesuffix(".csv").partition("-")[2]
    for row in rows[1:]:
        for column in range(1, 2 if table == "values" else len(heads)):
            key = row[0] if table == "values" else heads[column]
            ones = [
                one
                for one in asked.values()
                if one.key == key and (one.table == table.replace("values", "") if table else one.by_position)
            ]
            if ones:
                k = ones[0].rows.index("" if table == "values" else row[0])
                row[column] = repr(float(ones[0].values[k])).replace("nan", "")
    out = io.StringIO()
    csv.writer(out).writerows(rows)
    return out.getvalue().encode()


@pytest.mark.parametrize("name", ["compressor", "hoist_drive", "eccentric", "scotch_yoke"])
@pytest.mark.parametrize("rubric", [lambda asked: Rubric(), every], ids=["usual", "everything"])
def test_files_of_a_template_filled_in_are_full_marks(name, rubric):
    results = solved(name)
    asked = expected(results)
    rule = rubric(asked)
    points = worth(rule, asked, results.lever is not None and closed(results))
    made = template({n: asked[n] for n in asked}, points, ".csv", Translator("en"))
    files = [(f"sheet{end}", filled(f"sheet{end}", content, asked)) for end, content in made.items()]
    answers = read(files, "x", asked, (), rule.asks)
    assert not answers.notes
    assert grade(results, answers, rule, asked).points == 100
