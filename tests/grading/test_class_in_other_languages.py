"""A class whose variants are in Ukrainian, and one in Kazakh: sheets, feedback and statistics speak the language."""

from __future__ import annotations

import csv
import html
import io
import re
import sys
from pathlib import Path

import pytest
from exhaustive import many
from typer.testing import CliRunner

from tmm_report.cli import app
from tmm_report.course import solve
from tmm_report.grading.expected import expected
from tmm_report.languages import LANGUAGES
from tmm_report.loading import load
from tmm_report.variant import new

sys.path.insert(0, str(Path(__file__).parents[1] / "languages"))
from test_no_foreign_words import known

HONEST, MILLIMETRES, ABSENT = "st01", "st02", "st03"
WORD = re.compile(r"[A-Za-z\u0400-\u052f]{4,}")
OVERRIDES = {"uk": "id;бали;підстава\n", "kk": "id;ұпай;себебі\n"}
TYPED = {"explain", "усно"}  # a command, and the teacher's own word


def run(*arguments: object) -> str:
    done = CliRunner().invoke(app, [str(one) for one in arguments], catch_exceptions=False)
    assert done.exit_code in (0, 1), done.output
    return done.output


def filled(sheet: str, code: str, variant: Path, factor: float) -> str:
    """The sheet with the numbers of the variant; displacements times a factor."""
    asked = {one.key: one for one in expected(solve(load(variant))).values() if one.table.endswith("_table")}
    about, head, *rows = sheet.lstrip("\ufeff").splitlines()
    keys = [cell.partition(",")[0] for cell in head.split(";")[1:]]
    lines = [
        ";".join(
            [row.partition(";")[0]]
            + [
                f"{asked[key].values[k] * (factor if key == 'S_B' else 1):.6g}".replace(".", ",")
                for key in keys
            ]
        )
        for k, row in enumerate(rows)
    ]
    return "\n".join([about, head, *lines])


@pytest.mark.parametrize("code", many(["uk", "kk"]))
def test_a_class_is_graded_in_its_language(code, tmp_path):
    handout, answers, marks = (tmp_path / name for name in ("handout", "answers", "marks"))
    for folder in (handout, answers, marks):
        folder.mkdir()
    for k, id in enumerate((HONEST, MILLIMETRES, ABSENT)):
        (handout / f"{id}.yaml").write_text(new(code).replace("80 mm", f"{80 + k} mm"), "utf-8")
    run("grade", handout, "--template", tmp_path / "sheet.csv")
    sheet = (tmp_path / "sheet.csv").read_text("utf-8")
    for id, factor in ((HONEST, 1), (MILLIMETRES, 1000)):
        (answers / f"{id}.csv").write_text(filled(sheet, code, handout / f"{id}.yaml", factor), "utf-8")
    (marks / "overrides.csv").write_text(f"{OVERRIDES[code]}{ABSENT};70;усно\n", "utf-8")
    run("grade", handout, answers, "-o", marks, "--lang", code)

    table = list(csv.reader(io.StringIO((marks / "marks.csv").read_text("utf-8-sig")), delimiter=";"))
    by_id = {row[0]: row for row in table}
    assert by_id[HONEST][6] == "100,0" and by_id[ABSENT][4] == "70,0" and "усно" in by_id[ABSENT][-1]
    assert 50 < float(by_id[MILLIMETRES][6].replace(",", ".")) < 100

    said = "".join(page.read_text("utf-8-sig") for page in sorted(marks.rglob("*.html")))
    assert len(list(marks.rglob("*.html"))) >= 4 and f'lang="{code}"' in said
    bare = html.unescape(re.sub(r"(?s)<(script|style|svg|math).*?</\1>|<[^>]*>", " ", said))
    own = {word.lower() for word in known(code)} | {word.lower() for word in WORD.findall(new(code))}
    strange = {word for word in WORD.findall(bare) if word.lower() not in own}
    tables = {
        part
        for one in expected(solve(load(handout / f"{HONEST}.yaml"))).values()
        for part in one.table.split("_")
    }
    assert strange - TYPED - tables == set()
    letters = set(LANGUAGES[code].alphabet)
    assert not set(re.findall("[\u0400-\u052f]", " ".join(map(" ".join, table)).lower())) - letters
