"""The sheet that students fill in, filled in: what was written comes back, whatever the rubric asks."""

from __future__ import annotations

import csv
import io

import openpyxl
import pytest
from conftest import solved
from exhaustive import many
from notes import VARIANTS
from told import Told

from tmm_report.commands.grade.sheet import run as write_sheets
from tmm_report.grading.expected import expected
from tmm_report.grading.handed_in.answers import read
from tmm_report.grading.handed_in.template import template, whose_line
from tmm_report.grading.marks import closed, grade
from tmm_report.grading.rubric import Rubric, TableRule, worth
from tmm_report.i18n import Translator
from tmm_report.intake import cells
from tmm_report.languages import LANGUAGES


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
    rows = list(csv.reader(io.StringIO(text), delimiter=";" if ";" in text.splitlines()[1] else ","))
    titles, rows = (rows[:1], rows[1:]) if len(rows[0]) == 1 else ([], rows)
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
    csv.writer(out).writerows([*titles, *rows])
    return out.getvalue().encode()


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("name", ["compressor", "hoist_drive", "eccentric", "scotch_yoke"])
@pytest.mark.parametrize("rubric", many([lambda asked: Rubric(), every]), ids=["usual", "everything"])
def test_files_of_a_template_filled_in_are_full_marks(name, rubric, language):
    results = solved(name)
    asked = expected(results)
    rule = rubric(asked)
    points = worth(rule, asked, results.lever is not None and closed(results))
    tr = Translator(language)
    whose = whose_line({"student": 'Ёлкина-Петрова А. С., "A"; 7', "group": "М-31"}, tr)
    made = template({n: asked[n] for n in asked}, points, ".csv", tr, whose)
    files = [(f"sheet{end}", filled(f"sheet{end}", content, asked)) for end, content in made.items()]
    answers = read(files, "x", asked, (), rule.asks)
    assert not answers.notes
    assert grade(results, answers, rule, asked).points == 100


@pytest.mark.parametrize("suffix", ["", ".xlsx"])
def test_sheets_speak_the_variants_language_and_say_whose_they_are(tmp_path, suffix):
    text = (VARIANTS / "compressor.yaml").read_text("utf-8")
    body = text[text.index("\nmechanism:") : text.index("\ndrive:")]
    for id, language in (("anna", "ru"), ("john", "en")):
        title = f'title: {{student: "Ёлкина {id}", group: М-31, variant: 7}}\nlanguage: {language}\n'
        (tmp_path / f"{id}.yaml").write_text(title + body, "utf-8")
    write_sheets(str(tmp_path), tmp_path / f"sheets{suffix}", None, Told())
    made = (
        [tmp_path / "sheets.xlsx"]
        if suffix
        else [tmp_path / "sheets" / f"{id}.xlsx" for id in ("anna", "john")]
    )
    heads = [("Студент: ", "положение"), ("Student: ", "position")]
    for file, id, (words, head) in zip(made, ("anna", "john"), heads, strict=False):
        for sheet in openpyxl.load_workbook(file):
            first, second = (row[0].value for row in sheet.iter_rows(max_row=2))
            assert first.startswith(words) and sheet.freeze_panes == "A3"
            assert second == head or sheet.title == "values"
            assert ("____" in first) if suffix else (f"Ёлкина {id}" in first and "М-31" in first)
